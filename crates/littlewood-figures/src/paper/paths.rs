//! Figures 3(b) and 7(b): where the centre, the mass centre or the particle go, with the hoop at
//! each transition.

use littlewood::tables::Dimension;
use littlewood::{Cause, Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Entries, Figure, HATCH, INK, Label, Layer, Mark, Panel, PlotAxis, ROOM, SMALL, SOFT,
    Scale, Series, Sheet, Stroke, short, tilted, width,
};

use crate::columns::{TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{arrows, bounds, by_mode, entries, hoops, horizon, lines, remark};
use crate::wording::Wording;
use littlewood_style::width::{BOLD, FINE};

/// Arrows of time stand where the motion goes this part of the picture.
const LEAST_STEP: f64 = 0.0015;
const COLUMNS: [&str; 3] = [TIME, X, Y];
/// Most hoops of a picture.
const HOOPS: usize = 8;
/// Width of the picture in pixels.
const WIDTH: f64 = 760.0;
/// Most rows of names under the hoops, and their distance.
const ROWS: usize = 4;
const ROW: f64 = 17.0;

/// Distance of the hoops of two bounces, at least.
const APART: f64 = 1.2;

/// The instants at which the hoop is drawn, each with its name: the start and the transitions, the
/// first and the last where there are too many; of bounces those that are apart, the farther the
/// more there are.
fn instants(motion: &Trajectory) -> Vec<(String, Sample)> {
    let mut found = transitions(motion, APART);
    if found.len() > HOOPS {
        let [left, right] = bounds(found.iter().map(|(_, sample)| sample.centre.x), 0.0);
        found = transitions(motion, APART.max((right - left) / (HOOPS - 2) as f64));
    }
    if found.len() > HOOPS {
        let last = found.split_off(found.len() - 1);
        found.truncate(HOOPS - 1);
        found.extend(last);
    }
    found
}

/// The start and the transitions; of bounces those that are so far from the others.
fn transitions(motion: &Trajectory, apart: f64) -> Vec<(String, Sample)> {
    let until = horizon(motion);
    let mut found: Vec<(String, Sample)> = Vec::new();
    let jam = motion
        .transitions()
        .first()
        .filter(|transition| transition.from.is_none());
    let start = jam.map_or_else(
        || "start".to_owned(),
        |jam| format!("start, {}", jam.cause.label()),
    );
    found.extend(motion.phases().first().map(|phase| (start, phase.first())));
    for phase in motion.phases() {
        let Some((transition, sample)) = motion.end_of(phase).zip(phase.last()) else {
            continue;
        };
        let is_close =
            |(_, other): &(String, Sample)| (other.centre.x - sample.centre.x).abs() < apart;
        if transition.time() <= until && !(transition.is_bounce() && found.iter().any(is_close)) {
            found.push((transition.cause.label().to_owned(), sample));
        }
    }
    found
}

/// The plane from side to side of a picture of this width; on a slope from end to end.
pub(super) fn ground(x: [f64; 2], y: [f64; 2], width: f64, slope: f64) -> Vec<Layer> {
    let depth = 8.0 * (x[1] - x[0]) / width;
    let x = if slope == 0.0 {
        x
    } else {
        let corners = x
            .into_iter()
            .flat_map(|x| y.map(|y| tilted(-slope, [x, y])[0]));
        bounds(corners, 0.0)
    };
    let below = [[x[0], 0.0], [x[1], 0.0], [x[1], -depth], [x[0], -depth]];
    vec![
        Series::of_rows("ground", &[X, Y], below.map(Vec::from).to_vec()).drawn(Mark::Hatch(HATCH)),
        Series::of_rows("ground", &[X, Y], vec![vec![x[0], 0.0], vec![x[1], 0.0]])
            .drawn(Stroke::solid(INK, 1.4)),
    ]
}

/// The axes: on a level plane its coordinates, on a slope those of a level camera.
pub(super) fn axes(say: Wording, x: [f64; 2], y: [f64; 2], slope: f64) -> [PlotAxis; 2] {
    if slope != 0.0 {
        return [say.axis(X, "horizontal", x), say.axis(Y, "height", y)];
    }
    [
        say.axis(X, "*x*", x),
        PlotAxis {
            scale: Scale::NotNegative,
            ..say.axis(Y, "*y*", y)
        },
    ]
}

/// What a caption says of the axes of a picture on a slope.
pub(super) fn camera(slope: f64) -> &'static str {
    if slope == 0.0 {
        ""
    } else {
        " The camera is level, the plane rises by *α*."
    }
}

/// A text so far below a place of the plane; on a slope at the side where the plane rises.
pub(super) fn beneath(text: String, x: f64, down: f64, slope: f64) -> Label {
    let label = Label::new(text, &[x, 0.0]).sized(SMALL);
    match slope {
        0.0 => label.shifted(0.0, down),
        _ if slope > 0.0 => label.left().shifted(8.0, down - 8.0),
        _ => label.right().shifted(-8.0, down - 8.0),
    }
}

/// Left, right, lower and upper end of a motion and of the plane beneath it, as a level camera sees
/// the centre of the hoop.
pub(super) fn extent(samples: &[Sample], slope: f64) -> [f64; 4] {
    let seen = |height: fn(&Sample) -> f64| {
        samples
            .iter()
            .map(move |sample| tilted(slope, [sample.centre.x, height(sample)]))
    };
    let centres = || seen(|sample| sample.centre.y);
    let [left, right] = bounds(centres().map(|[x, _]| x), 0.0);
    let [_, top] = bounds(centres().map(|[_, y]| y), 0.0);
    let low = centres()
        .map(|[_, y]| y - 1.0)
        .chain(seen(|_| 0.0).map(|[_, y]| y))
        .fold(f64::INFINITY, f64::min);
    [left, right, low, top]
}

/// What a picture shows: the hoops, their labels, the ground.
struct Picture {
    sheet: Sheet,
    say: Wording,
    slope: f64,
    x: [f64; 2],
    y: [f64; 2],
    layers: Vec<Layer>,
    labels: Vec<Label>,
    /// How many have a hoop.
    transitions: usize,
}

impl Picture {
    fn new(motion: &Trajectory, input: &FigureInput) -> Result<Self, FigureError> {
        let (sheet, say) = (input.sheet(WIDTH)?, input.wording());
        let [_, inner] = sheet.span();
        let until = horizon(motion);
        let samples: Vec<Sample> = motion.sample_evenly(400, until).collect();
        let slope = motion.hoop().slope();
        let [left, right, low, top] = extent(&samples, slope);
        // A long motion is small: the names of the hoops at its ends need more than a hoop of room.
        let goes_on = motion.hoop().restitution().is_some();
        let mut beside = if goes_on {
            f64::max(1.2, 0.06 * (right - left))
        } else {
            1.2
        };
        if slope != 0.0 {
            // Names stand beside the plane.
            beside = beside.max(0.15 * (right - left));
        }
        // The picture is not much higher than wide.
        beside = beside.max(0.5 * (0.9 * (top + 2.3 - low) - (right - left)));
        let x = [left - beside, right + beside];
        let instants = instants(motion);
        let shown = instants.iter().map(|(_, sample)| sample);
        let hoops = hoops(motion.hoop(), shown, "hoop", Stroke::solid(SOFT, 1.2));
        // Names under the hoops, on a slope where the plane rises; one that is close to another
        // stands further down.
        let unit = (inner - ROOM[0]) / (x[1] - x[0]);
        let mut labels: Vec<Label> = Vec::new();
        let mut taken: Vec<(f64, usize, f64)> = Vec::new();
        for (name, sample) in &instants {
            let at = sample.centre.x;
            let time = say.value(sample.state.time, Dimension::Time);
            let text = format!("{name}, {} = {time}", say.time());
            let half = 0.5 * width(&text, SMALL) + 5.0;
            let apart = |x: f64| (x - at).abs() * unit * libm::cos(slope);
            let is_free = |row: &usize| {
                taken
                    .iter()
                    .all(|(x, r, h)| r != row || apart(*x) > half + h)
            };
            let row = (0..ROWS).find(is_free).unwrap_or(ROWS - 1);
            taken.push((at, row, half));
            labels.push(beneath(text, at, 21.0 + ROW * row as f64, slope));
        }
        let rows = 1 + taken.iter().map(|(_, row, _)| *row).max().unwrap_or(0);
        let y = [low - (18.0 + ROW * rows as f64) / unit, top + 1.15];
        let layers = ground(x, y, sheet.width, slope)
            .into_iter()
            .chain([hoops])
            .collect();
        let transitions = instants.len().saturating_sub(1);
        Ok(Self {
            sheet,
            say,
            slope,
            x,
            y,
            layers,
            labels,
            transitions,
        })
    }

    fn figure(self, name: &'static str, title: &str, caption: String, entries: Entries) -> Figure {
        let Self {
            sheet,
            say,
            slope,
            x,
            y,
            layers,
            labels,
            ..
        } = self;
        let [left, inner] = sheet.span();
        // One scale for both axes.
        let height = (inner - ROOM[0]) * (y[1] - y[0]) / (x[1] - x[0]) + ROOM[1];
        let [x, y] = axes(say, x, y, slope);
        let content = Content {
            name: "plane of motion",
            x,
            y,
            layers,
            labels,
        };
        let (keys, room) = sheet.keys(entries, 6.0);
        let top = 14.0 + room;
        let panel = Panel {
            keys,
            ..Sheet::tilted([left, top, inner, height], content, slope)
        };
        sheet.figure(name, title, caption, top + height + 6.0, vec![panel])
    }
}

/// Figure 3(b).
pub(crate) fn centres(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-3b";
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let say = input.wording();
    let mut picture = Picture::new(&motion, input)?;
    let all = motion
        .transitions()
        .iter()
        .filter(|transition| transition.from.is_some())
        .count();
    let hoops = if picture.transitions == all {
        "each transition".to_owned()
    } else {
        format!("{} of {all} transitions", picture.transitions)
    };
    let rows = |sample: &Sample| {
        vec![
            sample.state.time,
            sample.mass_centre.x,
            sample.mass_centre.y,
        ]
    };
    let of_centre = by_mode(&motion, "centre, ", &COLUMNS, &|sample| {
        vec![sample.state.time, sample.centre.x, sample.centre.y]
    });
    let of_mass_centre = by_mode(&motion, "mass centre, ", &COLUMNS, &rows);
    let mut keys = entries(&of_centre, |mode| mode.to_string());
    keys.push((
        Mark::Line(Stroke::solid(INK, BOLD)),
        "thick: mass centre *X̄*".to_owned(),
    ));
    keys.push((
        Mark::Line(Stroke::solid(INK, FINE)),
        "thin: centre *C*".to_owned(),
    ));
    picture.layers.extend(lines(of_centre, 1.2));
    picture.layers.extend(lines(of_mass_centre, BOLD));
    let across = picture.x[1] - picture.x[0];
    picture
        .layers
        .extend(arrows(&motion, 0.5, &COLUMNS, &rows, |_, rows| {
            libm::hypot(rows[1][1] - rows[0][1], rows[1][2] - rows[0][2]) > LEAST_STEP * across
        }));
    let flight = motion
        .phases()
        .iter()
        .any(|phase| !phase.mode().touches_plane());
    let caption = format!(
        "Paths of the geometric centre *C* and of the mass centre *X̄*, with the hoop at the start and at {hoops}. Black dot: particle; ring: mass centre; arrows: time.{}{} {}.{}",
        if flight {
            " In flight the mass centre follows a parabola."
        } else {
            ""
        },
        camera(hoop.slope()),
        input.in_words(),
        if input.units.is_some() {
            ""
        } else {
            " *m*_{2} = *R* = *g* = 1."
        }
    );
    let title = "Figure 3(b): paths of the centre and of the mass centre";
    let figure = picture.figure(NAME, title, caption, keys);
    Ok(figure.noted(remark(&motion, say)))
}

/// Figure 7(b).
pub(crate) fn particle(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-7b";
    input.littlewood(NAME)?;
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let say = input.wording();
    let mut picture = Picture::new(&motion, input)?;
    let paths = by_mode(&motion, "", &COLUMNS, &|sample| {
        vec![sample.state.time, sample.particle.x, sample.particle.y]
    });
    let keys = entries(&paths, |mode| match mode {
        Mode::Rolling => format!("{mode}: a cycloid"),
        Mode::Gliding => format!("{mode}: a parabola"),
        Mode::Sliding | Mode::Flight => mode.to_string(),
    });
    picture.layers.extend(lines(paths, BOLD));
    let reaches = motion
        .transitions()
        .iter()
        .any(|transition| transition.cause == Cause::ParticleAtPlane);
    let caption = format!(
        "Path of the particle *m*_{{2}}: on a cycloid while the massless hoop rolls, on a parabola while it glides, \
         *N* = 0.{}{} *μ*_{{s}} = {}; {}.",
        if reaches {
            " At the end the particle reaches the plane, *θ* = ±π."
        } else {
            ""
        },
        camera(hoop.slope()),
        short(hoop.mu_s()),
        say.start(hoop, &input.start)
    );
    Ok(picture.figure(NAME, "Figure 7(b): path of the particle", caption, keys))
}
