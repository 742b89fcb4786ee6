//! Figures 3(b) and 7(b): where the centre, the mass centre or the particle go, with the hoop at
//! each transition.

use littlewood::tables::Dimension;
use littlewood::{Cause, Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Entries, Figure, HATCH, INK, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, Point,
    ROOM, Range, SMALL, SOFT, Scale, Series, Sheet, Stroke, seen, short, tilted, width,
};
use littlewood_style::width::{BOLD, FINE};

use crate::columns::{TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds, hoops};
use crate::wording::Wording;

/// Arrows of time stand where the motion goes this part of the picture.
const LEAST_STEP: f64 = 0.0015;
const COLUMNS: [&str; 3] = [TIME, X, Y];
/// Most hoops of a picture.
const HOOPS: usize = 8;
/// Width of the picture in pixels.
pub(super) const WIDTH: f64 = 760.0;
/// Most rows of names under the hoops, and their distance.
const ROWS: usize = 5;
pub(super) const ROW: f64 = 17.0;

/// Distance of the hoops of two bounces, at least, and of those of two swings where there are many.
const APART: f64 = 1.2;
const WIDER: f64 = 1.25;

/// An instant at which the hoop is drawn, with its name.
pub(super) struct Instant {
    name: String,
    pub(super) sample: Sample,
}

/// The start and the transitions, the first and the last where there are too many; of bounces those
/// that are apart, the farther the more there are.
pub(super) fn instants(motion: &Shown) -> Vec<Instant> {
    let mut found = transitions(motion, APART);
    if found.len() > HOOPS {
        let [left, right] = bounds(found.iter().map(|it| it.sample.centre.x), 0.0);
        let apart = f64::max(WIDER, (right - left) / (HOOPS - 2) as f64);
        found = transitions(motion, apart);
    }
    if found.len() > HOOPS {
        let last = found.split_off(found.len() - 1);
        found.truncate(HOOPS - 1);
        found.extend(last);
    }
    found
}

/// The start and the transitions; of bounces those that are so far from the others.
fn transitions(motion: &Shown, apart: f64) -> Vec<Instant> {
    let first = motion.transitions().first();
    let jam = first.filter(|transition| transition.from.is_none());
    let start = jam.map_or_else(
        || "start".to_owned(),
        |jam| format!("start, {}", jam.cause.label()),
    );
    let start = motion.phases().first().map(|phase| Instant {
        name: start,
        sample: phase.first(),
    });
    let mut found = Vec::from_iter(start);
    for phase in motion.phases() {
        let Some((transition, sample)) = motion.end_of(phase).zip(phase.last()) else {
            continue;
        };
        let is_close = |other: &Instant| (other.sample.centre.x - sample.centre.x).abs() < apart;
        // Many swings are in one place, too.
        let is_swing = apart > APART && transition.cause == Cause::TurningPoint;
        let is_hidden = (transition.is_bounce() || is_swing) && found.iter().any(is_close);
        if transition.time() <= motion.until && !is_hidden {
            let name = transition.cause.label().to_owned();
            found.push(Instant { name, sample });
        }
    }
    found
}

/// A text so far below a place of the plane; on a slope at the side where the plane rises.
pub(super) fn beneath(text: String, x: f64, down: f64, slope: f64) -> Label {
    let label = Label::new(text, &[x, 0.0]).sized(SMALL);
    match slope {
        0.0 => label.shifted(0.0, down),
        _ if slope > 0.0 => label.left().shifted(8.0, down - 8.0).led(),
        _ => label.right().shifted(-8.0, down - 8.0).led(),
    }
}

/// A motion and the plane beneath it, as a level camera sees the centre of the hoop.
pub(super) struct Extent {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) low: f64,
    pub(super) top: f64,
}

impl Extent {
    pub(super) fn of(samples: &[Sample], slope: f64) -> Self {
        let seen = |height: fn(&Sample) -> f64| {
            samples
                .iter()
                .map(move |sample| tilted(slope, Point::new(sample.centre.x, height(sample))))
        };
        let centres = || seen(|sample| sample.centre.y);
        let [left, right] = bounds(centres().map(|centre| centre.x), 0.0);
        let [_, top] = bounds(centres().map(|centre| centre.y), 0.0);
        let low = centres()
            .map(|centre| centre.y - 1.0)
            .chain(seen(|_| 0.0).map(|contact| contact.y))
            .fold(f64::INFINITY, f64::min);
        Self {
            left,
            right,
            low,
            top,
        }
    }
}

/// A picture of the plane with what moves on it.
pub(super) struct Picture {
    pub(super) sheet: Sheet,
    pub(super) say: Wording,
    pub(super) slope: f64,
    pub(super) x: [f64; 2],
    pub(super) y: [f64; 2],
    pub(super) layers: Vec<Layer>,
    pub(super) labels: Vec<Label>,
}

impl Picture {
    /// Pixels of a radius in a picture of this range.
    pub(super) fn unit(sheet: &Sheet, x: Range) -> f64 {
        let [_, inner] = sheet.span();
        (inner - ROOM[0]) / x.length()
    }

    /// The plane from side to side of the picture, below all else; on a slope from end to end.
    pub(super) fn ground(&self) -> [Layer; 2] {
        let Self { x, y, slope, .. } = *self;
        let depth = 8.0 * (x[1] - x[0]) / self.sheet.width;
        let [left, right] = if slope == 0.0 {
            x
        } else {
            let corners = x
                .into_iter()
                .flat_map(|x| y.map(|y| tilted(-slope, Point { x, y }).x));
            bounds(corners, 0.0)
        };
        let line = [[left, 0.0], [right, 0.0]];
        let below = line.into_iter().chain([[right, -depth], [left, -depth]]);
        [
            Series::of_rows("ground", &[X, Y], below).drawn(Mark::Hatch(HATCH)),
            Series::of_rows("ground", &[X, Y], line).drawn(Stroke::solid(INK, 1.4)),
        ]
    }

    /// The axes: on a level plane its coordinates, on a slope those of a level camera.
    fn axes(&self) -> [PlotAxis; 2] {
        let Self { x, y, say, .. } = *self;
        if self.slope != 0.0 {
            return [
                say.axis(X, "horizontal", x.into()),
                say.axis(Y, "height", y.into()),
            ];
        }
        let y = PlotAxis {
            scale: Scale::NotNegative,
            ..say.axis(Y, "*y*", y.into())
        };
        [say.axis(X, "*x*", x.into()), y]
    }

    /// What a caption says of the axes of a picture on a slope.
    pub(super) fn camera(&self) -> &'static str {
        if self.slope == 0.0 {
            ""
        } else {
            " The camera is level, the plane rises by *α*."
        }
    }

    /// The figure, with one scale for both axes, and keys of marks and of widths.
    pub(super) fn figure(
        self,
        name: &'static str,
        title: &str,
        caption: String,
        entries: Entries,
        widths: Entries,
    ) -> Figure {
        let [x, y] = self.axes();
        let [left, inner] = self.sheet.span();
        let height =
            (inner - ROOM[0]) * (self.y[1] - self.y[0]) / (self.x[1] - self.x[0]) + ROOM[1];
        let content = Content {
            name: "plane of motion",
            x,
            y,
            layers: self.layers,
            labels: self.labels,
        };
        let mut keys = seen(entries, core::slice::from_ref(&content), self.slope);
        keys.extend(widths);
        let (keys, room) = self.sheet.keys(keys, 6.0);
        let top = 14.0 + room;
        let panel = Panel {
            keys,
            ..Sheet::tilted(
                PanelFrame {
                    left,
                    top,
                    width: inner,
                    height,
                },
                content,
                self.slope,
            )
        };
        self.sheet
            .figure(name, title, caption, top + height + 6.0, vec![panel])
    }
}

/// From side to side of a motion, with room for the names of the hoops at its ends.
fn across(motion: &Trajectory, extent: &Extent) -> [f64; 2] {
    let Extent {
        left,
        right,
        low,
        top,
    } = *extent;
    // A long motion is small, and names need more than a hoop of room.
    let mut beside = 1.2;
    if motion.hoop().restitution().is_some() {
        beside = f64::max(beside, 0.06 * (right - left));
    }
    if motion.hoop().slope() != 0.0 {
        // Names stand beside the plane.
        beside = beside.max(0.15 * (right - left));
    }
    // The picture is not much higher than wide.
    beside = beside.max(0.5 * (0.9 * (top + 2.3 - low) - (right - left)));
    [left - beside, right + beside]
}

/// Names under hoops, on a slope where the plane rises, one that is close to another further down;
/// and in how many rows.
pub(super) fn names(
    instants: &[Instant],
    say: Wording,
    slope: f64,
    unit: f64,
) -> (Vec<Label>, usize) {
    let mut labels: Vec<Label> = Vec::new();
    let mut taken: Vec<(f64, usize, f64)> = Vec::new();
    for Instant { name, sample } in instants {
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
    (labels, rows)
}

/// The hoop at the start and at the transitions, and how many of these there are.
fn with_hoops(motion: &Shown, input: &FigureInput) -> Result<(Picture, usize), FigureError> {
    let (sheet, say, slope) = (input.sheet(WIDTH)?, motion.say, motion.hoop().slope());
    let samples: Vec<Sample> = motion.sample_evenly(400, motion.until).collect();
    let extent = Extent::of(&samples, slope);
    let x = across(motion, &extent);
    let unit = Picture::unit(&sheet, x.into());
    let instants = instants(motion);
    let (labels, rows) = names(&instants, say, slope, unit);
    let y = [
        extent.low - (18.0 + ROW * rows as f64) / unit,
        extent.top + 1.15,
    ];
    let mut picture = Picture {
        sheet,
        say,
        slope,
        x,
        y,
        layers: Vec::new(),
        labels,
    };
    picture.layers.extend(picture.ground());
    let shown = instants.iter().map(|instant| &instant.sample);
    let rim = Stroke::solid(SOFT, 1.2);
    picture
        .layers
        .push(hoops(motion.hoop(), shown, "hoop", rim));
    Ok((picture, instants.len().saturating_sub(1)))
}

/// Figure 3(b).
pub(crate) fn centres(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-3b";
    let motion = input.motion(NAME)?;
    let (mut picture, transitions) = with_hoops(&motion, input)?;
    let all = motion.transitions().iter();
    let all = all.filter(|transition| transition.from.is_some()).count();
    let hoops = if transitions == all {
        "each transition".to_owned()
    } else {
        format!("{transitions} of {all} transitions")
    };
    let of_mass_centre = |sample: &Sample| {
        let centre = sample.mass_centre;
        [sample.state.time, centre.x, centre.y]
    };
    let centres = motion.by_mode("centre, ", &COLUMNS, |sample| {
        [sample.state.time, sample.centre.x, sample.centre.y]
    });
    let mass_centres = motion.by_mode("mass centre, ", &COLUMNS, of_mass_centre);
    let keys = centres.entries(|mode| mode.to_string());
    let line = |width| Mark::Line(Stroke::solid(INK, width));
    let widths = vec![
        (line(BOLD), "thick: mass centre *X̄*".to_owned()),
        (line(FINE), "thin: centre *C*".to_owned()),
    ];
    picture.layers.extend(centres.lines(1.2));
    picture.layers.extend(mass_centres.lines(BOLD));
    let least = LEAST_STEP * (picture.x[1] - picture.x[0]);
    let is_seen =
        |_, [from, to]: &[[f64; 3]; 2]| libm::hypot(to[1] - from[1], to[2] - from[2]) > least;
    let arrows = motion.arrows(0.5, &COLUMNS, of_mass_centre, is_seen);
    picture.layers.extend(arrows);
    let flies = motion.phases().iter().any(|it| !it.mode().touches_plane());
    let caption = format!(
        "Paths of the geometric centre *C* and of the mass centre *X̄*, with the hoop at the start and at {hoops}. Black dot: particle; ring: mass centre; arrows: time.{}{} {}.{}",
        if flies {
            " In flight the mass centre follows a parabola."
        } else {
            ""
        },
        picture.camera(),
        input.in_words(),
        if input.units.is_some() {
            ""
        } else {
            " *m*_{2} = *R* = *g* = 1."
        }
    );
    let title = "Figure 3(b): paths of the centre and of the mass centre";
    let figure = picture.figure(NAME, title, caption, keys, widths);
    Ok(figure.noted(motion.remark()))
}

/// Figure 7(b).
pub(crate) fn particle(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-7b";
    input.littlewood(NAME)?;
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let (mut picture, _) = with_hoops(&motion, input)?;
    let paths = motion.by_mode("", &COLUMNS, |sample| {
        [sample.state.time, sample.particle.x, sample.particle.y]
    });
    let keys = paths.entries(|mode| match mode {
        Mode::Rolling => format!("{mode}: a cycloid"),
        Mode::Gliding => format!("{mode}: a parabola"),
        Mode::Sliding | Mode::Flight | Mode::Rest | Mode::Skidding => mode.to_string(),
    });
    picture.layers.extend(paths.lines(BOLD));
    let mut transitions = motion.transitions().iter();
    let caption = format!(
        "Path of the particle *m*_{{2}}: on a cycloid while the massless hoop rolls, on a parabola while it glides, \
         *N* = 0.{}{} *μ*_{{s}} = {}; {}.",
        if transitions.any(|it| it.cause == Cause::ParticleAtPlane) {
            " At the end the particle reaches the plane, *θ* = ±π."
        } else {
            ""
        },
        picture.camera(),
        short(hoop.mu_s()),
        motion.say.start(hoop, &input.start)
    );
    let title = "Figure 7(b): path of the particle";
    Ok(picture.figure(NAME, title, caption, keys, Vec::new()))
}
