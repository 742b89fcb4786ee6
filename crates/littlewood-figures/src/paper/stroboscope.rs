//! A motion as a stroboscope shows it: the hoop at instants that are equally far apart, with the
//! forces of the plane.

use littlewood::tables::Dimension;
use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Entries, FAINT, FRICTION_FORCE, Figure, INK, Label, Layer, Mark, NORMAL_FORCE, Panel,
    Piece, ROOM, SMALL, Series, Sheet, Stroke, tilted,
};

use super::paths::{axes, beneath, camera, extent, ground};
use crate::columns::{FRICTION, NORMAL, TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{bounds, hoops, horizon};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, FINE};

const NAME: &str = "stroboscope";
/// Width of the picture in pixels.
const WIDTH: f64 = 760.0;
/// Radii from hoop to hoop on the average, and how many hoops there are at least and at most.
const APART: f64 = 0.9;
const HOOPS: [f64; 2] = [5.0, 12.0];
/// Radii that the centre goes at most, without turning back: of a longer motion the beginning is
/// shown.
const FARTHEST: f64 = 12.0;
/// Radii that it goes at least before it turns back.
const LEAST_WAY: f64 = 0.5;
/// Instants of the path of the particle.
const INSTANTS: usize = 400;
/// Length of the longest arrow in radii.
const LONGEST: f64 = 1.5;
/// Arrows that are shorter than this are not seen.
const SHORTEST: f64 = 0.03;
/// An arrow as long as its head, in pixels.
const HEAD: f64 = 10.0;

/// Up to when a motion is shown.
fn end_of(motion: &Trajectory) -> f64 {
    let until = horizon(motion);
    let samples: Vec<Sample> = motion.sample_evenly(INSTANTS, until).collect();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut direction = 0.0;
    for sample in samples {
        low = low.min(sample.centre.x);
        high = high.max(sample.centre.x);
        let turns_back = direction * sample.state.theta_rate < 0.0;
        if high - low > FARTHEST || (turns_back && high - low > LEAST_WAY) {
            return sample.state.time;
        }
        if sample.state.theta_rate != 0.0 {
            direction = sample.state.theta_rate.signum();
        }
    }
    until
}

/// Arrows of a force at the point of contact, from each place so far.
fn arrows(
    (name, column): (&'static str, &'static str),
    samples: &[Sample],
    (colour, unit): (Stroke, f64),
    part: impl Fn(&Sample) -> ([f64; 2], f64),
) -> Vec<Layer> {
    let columns = [TIME, X, Y, column];
    let pieces: Vec<(f64, Piece)> = samples
        .iter()
        .map(|sample| (sample, part(sample)))
        .map(|(sample, ([dx, dy], force))| {
            let from = [sample.centre.x, 0.0];
            let ends = [from, [from[0] + dx, from[1] + dy]];
            (
                libm::hypot(dx, dy),
                ends.map(|[x, y]| vec![sample.state.time, x, y, force])
                    .to_vec(),
            )
        })
        .filter(|(length, _)| *length > SHORTEST)
        .collect();
    let (long, short): (Vec<_>, Vec<_>) = pieces
        .into_iter()
        .partition(|(length, _)| length * unit > HEAD);
    let series = |pieces: Vec<(f64, Piece)>| {
        Series::new(
            name,
            &columns,
            pieces.into_iter().map(|(_, rows)| rows).collect(),
        )
    };
    // A head would be longer than a short one.
    let layers = [(long, Mark::Arrow(colour)), (short, Mark::Line(colour))];
    layers
        .into_iter()
        .filter(|(pieces, _)| !pieces.is_empty())
        .map(|(pieces, mark)| series(pieces).drawn(mark))
        .collect()
}

/// A force that is as long as a radius: a whole multiple of a power of ten.
fn force_of_a_radius(largest: f64) -> f64 {
    let wanted = largest / LONGEST;
    let decade = libm::pow(10.0, libm::floor(libm::log10(wanted)));
    libm::ceil(wanted / decade) * decade
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let (from, until) = (motion.start().time, end_of(&motion));
    let path: Vec<Sample> = motion.sample_evenly(INSTANTS, until).collect();
    let slope = hoop.slope();
    let [left, right, low, top] = extent(&path, slope);
    let [first, last] = bounds(path.iter().map(|sample| sample.centre.x), 0.0);
    let count = libm::round((last - first) / APART + 1.0).clamp(HOOPS[0], HOOPS[1]) as usize;
    let step = (until - from) / (count - 1) as f64;
    let times = (0..count).map(|i| {
        if i + 1 == count {
            until
        } else {
            from + step * i as f64
        }
    });
    let samples: Vec<Sample> = times
        .into_iter()
        .filter_map(|time| motion.at(time))
        .collect();

    let sheet = input.sheet(WIDTH)?;
    let [edge, inner] = sheet.span();
    // As wide as the arrows need, and not much higher than wide.
    let beside = f64::max(
        1.0 + LONGEST * 0.6,
        0.5 * (0.9 * (top - low + 1.6) - (right - left)),
    );
    let x = [left - beside, right + beside];
    let unit = (inner - ROOM[0]) / (x[1] - x[0]);
    let y = [low - 34.0 / unit, top + 1.65];
    let mut layers = ground(x, y, sheet.width, slope);
    let particle = path
        .iter()
        .map(|sample| vec![sample.state.time, sample.particle.x, sample.particle.y]);
    let particle: Piece = particle
        .filter(|row| row.iter().all(|value| value.is_finite()))
        .collect();
    let trace = Mark::Line(Stroke::solid(FAINT, FINE));
    layers.push(Series::of_rows("particle", &[TIME, X, Y], particle).drawn(trace));
    let mut keys: Entries = Vec::new();
    for mode in Mode::ALL {
        let mut own = samples
            .iter()
            .filter(|sample| sample.mode == mode)
            .peekable();
        if own.peek().is_some() {
            let rim = Stroke::of_mode(mode).wide(1.0);
            keys.push((Mark::Line(rim), mode.to_string()));
            layers.push(hoops(hoop, own, format!("hoop, {mode}"), rim));
        }
    }
    let largest = samples
        .iter()
        .map(|sample| sample.normal.max(sample.friction.abs()))
        .fold(0.0, f64::max);
    let say = input.wording();
    let mut bar_label = None;
    let mut scale = " The plane exerts no force.".to_owned();
    if largest > 0.0 {
        let force = force_of_a_radius(largest);
        let strokes = [
            Stroke::solid(NORMAL_FORCE, BOLD),
            Stroke::solid(FRICTION_FORCE, BOLD).dashed(Dash::Short),
        ];
        let normal = arrows(
            ("normal force at", NORMAL),
            &samples,
            (strokes[0], unit),
            |sample| ([0.0, sample.normal / force], sample.normal),
        );
        let friction = arrows(
            ("friction force at", FRICTION),
            &samples,
            (strokes[1], unit),
            |sample| ([sample.friction / force, 0.0], sample.friction),
        );
        for (arrows, stroke, letter) in [(normal, strokes[0], "*N*"), (friction, strokes[1], "*F*")]
        {
            // One may be too short to be seen.
            keys.extend((!arrows.is_empty()).then(|| (Mark::Line(stroke), letter.to_owned())));
            layers.extend(arrows);
        }
        scale =
            " Arrows at the point of contact: normal force *N* and friction force *F*.".to_owned();
        // As long as a radius, where a camera has its right upper corner.
        let ends =
            [x[1] - 1.2, x[1] - 0.2].map(|right| tilted(-slope, [right, y[1] - 0.25]).to_vec());
        let bar = Series::of_rows("scale of forces", &[X, Y], ends.to_vec());
        layers.push(bar.drawn(Stroke::solid(INK, BOLD)));
        let [right, up] = tilted(-slope, [x[1] - 1.2, y[1] - 0.25]);
        let label = Label::new(say.quantity(force, Dimension::Force), &[right, up])
            .right()
            .shifted(-6.0, 0.0);
        bar_label = Some(label.sized(SMALL));
    }
    let labels = [samples.first(), samples.last()]
        .into_iter()
        .flatten()
        .map(|sample| {
            let time = format!(
                "{} = {}",
                say.time(),
                say.value(sample.state.time, Dimension::Time)
            );
            beneath(time, sample.centre.x, 22.0, slope)
        });
    let labels = labels.chain(bar_label).collect();
    let caption = format!(
        "The hoop at {count} instants, {} apart.{scale}{} Grey: path of the particle. {}.",
        say.quantity(step, Dimension::Time),
        camera(slope),
        input.in_words()
    );
    let is_short = until < horizon(&motion);
    let cut = is_short.then(|| {
        let at = say.value(until, Dimension::Time);
        format!(
            "Shown is the beginning of the motion, to {} = {at}.",
            say.time()
        )
    });
    let height = (inner - ROOM[0]) * (y[1] - y[0]) / (x[1] - x[0]) + ROOM[1];
    let [x, y] = axes(say, x, y, slope);
    let content = Content {
        name: "plane of motion",
        x,
        y,
        layers,
        labels,
    };
    let (keys, room) = sheet.keys(keys, 6.0);
    let top = 14.0 + room;
    let panel = Panel {
        keys,
        ..Sheet::tilted([edge, top, inner, height], content, slope)
    };
    let bottom = top + height + 6.0;
    let figure = sheet.figure(
        NAME,
        "The hoop in equal times",
        caption,
        bottom,
        vec![panel],
    );
    Ok(figure.noted(cut))
}
