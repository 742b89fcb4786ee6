//! A motion as a stroboscope shows it: the hoop at instants that are equally far apart, with the
//! forces of the plane.

use littlewood::tables::Dimension;
use littlewood::{Mode, Sample};
use littlewood_draw::{
    Entries, FAINT, FRICTION_FORCE, Figure, INK, Label, Layer, Mark, NORMAL_FORCE, Point, SMALL,
    Series, Stroke, TRANSITION, tilted,
};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, CURVE, FINE};

use super::paths::{Extent, Instant, Picture, ROW, WIDTH, beneath, instants as instants_of, names};
use crate::columns::{FRICTION, NORMAL, TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds, finite_rows, hoops};
use crate::wording::Wording;

const NAME: &str = "stroboscope";
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
/// Height of the row of the scale of forces above the hoops, in pixels.
const OF_SCALE: f64 = 22.0;
/// An arrow as long as its head, in pixels, of a line of the usual width.
const HEAD: f64 = 10.0;

/// How it is drawn.
struct Look {
    /// Widths of lines.
    rim: f64,
    force: f64,
    path: f64,
    /// How many times as wide as high it is at least, about.
    flat: f64,
    /// Whether the transitions are marked on the plane, with their names.
    has_transitions: bool,
}

const PLAIN: Look = Look {
    rim: 1.0,
    force: BOLD,
    path: FINE,
    flat: 0.9,
    has_transitions: false,
};

/// As it is seen from afar.
const BOLDER: Look = Look {
    rim: 2.6,
    force: 4.2,
    path: CURVE,
    flat: 2.6,
    has_transitions: true,
};

/// Up to when a motion is shown.
fn end_of(motion: &Shown) -> f64 {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut direction = 0.0;
    for sample in motion.sample_evenly(INSTANTS, motion.until) {
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
    motion.until
}

/// A force at the point of contact.
struct Force {
    /// Name of its arrows, its column, its letter in the key.
    series: &'static str,
    column: &'static str,
    letter: &'static str,
    stroke: Stroke,
    of: fn(&Sample) -> f64,
    /// Whether it is upright.
    is_normal: bool,
}

const FORCES: [Force; 2] = [
    Force {
        series: "normal force at",
        column: NORMAL,
        letter: "*N*",
        stroke: Stroke::solid(NORMAL_FORCE, BOLD),
        of: |sample| sample.normal,
        is_normal: true,
    },
    Force {
        series: "friction force at",
        column: FRICTION,
        letter: "*F*",
        stroke: Stroke::solid(FRICTION_FORCE, BOLD).dashed(Dash::Short),
        of: |sample| sample.friction,
        is_normal: false,
    },
];

impl Force {
    /// Its arrows, a radius long where it is so large, a radius so many pixels; one that is shorter
    /// than a head has none.
    fn arrows(
        &self,
        samples: &[Sample],
        force_of_a_radius: f64,
        unit: f64,
        look: &Look,
    ) -> Vec<Layer> {
        let length = |sample: &Sample| (self.of)(sample) / force_of_a_radius;
        let arrow = |sample: &Sample| {
            let (time, x, force) = (sample.state.time, sample.centre.x, (self.of)(sample));
            let (dx, dy) = if self.is_normal {
                (0.0, length(sample))
            } else {
                (length(sample), 0.0)
            };
            [[time, x, 0.0, force], [time, x + dx, dy, force]]
        };
        let seen = samples
            .iter()
            .filter(|sample| length(sample).abs() > SHORTEST);
        let stroke = self.stroke.wide(look.force);
        let head = HEAD * look.force / BOLD;
        let (long, short): (Vec<&Sample>, Vec<&Sample>) =
            seen.partition(|sample| length(sample).abs() * unit > head);
        let marks = [Mark::Arrow(stroke), Mark::Line(stroke)];
        let columns = [TIME, X, Y, self.column];
        [long, short]
            .into_iter()
            .zip(marks)
            .filter(|(samples, _)| !samples.is_empty())
            .map(|(own, mark)| {
                Series::new(self.series, &columns, own.into_iter().map(arrow)).drawn(mark)
            })
            .collect()
    }
}

/// A force that is as long as a radius: a whole multiple of a power of ten.
fn force_of_a_radius(largest: f64) -> f64 {
    let wanted = largest / LONGEST;
    let decade = libm::pow(10.0, libm::floor(libm::log10(wanted)));
    libm::ceil(wanted / decade) * decade
}

/// The force of the scale: that of a radius, or in SI units, in which this is not round, one below
/// it that is.
fn force_of_scale(of_radius: f64, say: Wording) -> f64 {
    let Some(units) = say.units else {
        return of_radius;
    };
    let unit = units.unit(Dimension::Force);
    let most = of_radius * unit;
    let decade = libm::pow(10.0, libm::floor(libm::log10(most)));
    libm::floor(most / decade) * decade / unit
}

/// The instants, and the time from one to the next.
fn instants(motion: &Shown, path: &[Sample], until: f64) -> (Vec<Sample>, f64) {
    let from = motion.start().time;
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
    let samples = times
        .into_iter()
        .filter_map(|time| motion.at(time))
        .collect();
    (samples, step)
}

/// Adds the forces and their scale, with their keys; whether there are any.
fn add_forces(picture: &mut Picture, samples: &[Sample], keys: &mut Entries, look: &Look) -> bool {
    let largest = samples
        .iter()
        .map(|sample| sample.normal.max(sample.friction.abs()))
        .fold(0.0, f64::max);
    if largest <= 0.0 {
        return false;
    }
    let radius = force_of_a_radius(largest);
    let unit = Picture::unit(&picture.sheet, picture.x.into());
    for force in FORCES {
        let arrows = force.arrows(samples, radius, unit, look);
        // One may be too short to be seen.
        if !arrows.is_empty() {
            let stroke = force.stroke.wide(look.force);
            keys.push((Mark::Line(stroke), force.letter.to_owned()));
        }
        picture.layers.extend(arrows);
    }
    let scale = force_of_scale(radius, picture.say);
    // Where a camera has its right upper corner.
    let (right, up) = (
        picture.x[1],
        picture.y[1] - f64::max(0.25, 0.5 * OF_SCALE / unit),
    );
    let ends = [right - 0.2 - scale / radius, right - 0.2]
        .map(|right| tilted(-picture.slope, Point::new(right, up)));
    let bar = Series::of_rows("scale of forces", &[X, Y], ends);
    picture.layers.push(bar.drawn(Stroke::solid(INK, BOLD)));
    let text = picture.say.quantity(scale, Dimension::Force);
    let label = Label::new(text, &ends[0].row()).right().shifted(-6.0, 0.0);
    picture.labels.push(label.sized(SMALL));
    true
}

/// The picture, with the times of its first and its last hoop, or the names of its transitions.
fn picture(
    motion: &Shown,
    input: &FigureInput,
    path: &[Sample],
    samples: &[Sample],
    look: &Look,
) -> Result<Picture, FigureError> {
    let (sheet, say, slope) = (input.sheet(WIDTH)?, motion.say, motion.hoop().slope());
    let Extent {
        left,
        right,
        low,
        top,
    } = Extent::of(path, slope);
    // As wide as the arrows need, and not too high.
    let beside = f64::max(
        1.0 + LONGEST * 0.6,
        0.5 * (look.flat * (top - low + 1.6) - (right - left)),
    );
    let x = [left - beside, right + beside];
    let unit = Picture::unit(&sheet, x.into());
    let mut transitions = None;
    let (labels, rows) = if look.has_transitions {
        let instants = instants_of(motion);
        let at = instants.iter().skip(1);
        let at = at.map(|Instant { sample, .. }| [sample.state.time, sample.centre.x, 0.0]);
        let series = Series::of_rows("transition", &[TIME, X, Y], at);
        transitions = Some(series.drawn(TRANSITION));
        names(&instants, say, slope, unit)
    } else {
        let ends = [samples.first(), samples.last()].into_iter().flatten();
        let label = |sample: &Sample| {
            let time = say.value(sample.state.time, Dimension::Time);
            let text = format!("{} = {time}", say.time());
            beneath(text, sample.centre.x, 22.0, slope)
        };
        (ends.map(label).collect(), 1)
    };
    let mut picture = Picture {
        sheet,
        say,
        slope,
        x,
        y: [
            low - (17.0 + ROW * rows as f64) / unit,
            top + f64::max(1.65, 1.0 + OF_SCALE / unit),
        ],
        layers: Vec::new(),
        labels,
    };
    picture.layers.extend(picture.ground());
    let particle = path
        .iter()
        .map(|it| [it.state.time, it.particle.x, it.particle.y]);
    let particle = Series::of_rows("particle", &[TIME, X, Y], finite_rows(particle));
    picture
        .layers
        .push(particle.drawn(Stroke::solid(FAINT, look.path)));
    picture.layers.extend(transitions);
    Ok(picture)
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    of_look(input, &PLAIN)
}

/// The same in bold lines, with the names of its transitions.
pub(crate) fn bolder(input: &FigureInput) -> Result<Figure, FigureError> {
    of_look(input, &BOLDER)
}

fn of_look(input: &FigureInput, look: &Look) -> Result<Figure, FigureError> {
    let motion = input.motion(NAME)?;
    let (hoop, say) = (motion.hoop(), motion.say);
    let until = end_of(&motion);
    let path: Vec<Sample> = motion.sample_evenly(INSTANTS, until).collect();
    let (samples, step) = instants(&motion, &path, until);
    let mut picture = picture(&motion.up_to(until), input, &path, &samples, look)?;
    let mut keys: Entries = Vec::new();
    for mode in Mode::ALL {
        let mut own = samples.iter().filter(|it| it.mode == mode).peekable();
        if own.peek().is_some() {
            let rim = Stroke::of_mode(mode).wide(look.rim);
            keys.push((Mark::Line(rim), mode.to_string()));
            picture
                .layers
                .push(hoops(hoop, own, format!("hoop, {mode}"), rim));
        }
    }
    let forces = if add_forces(&mut picture, &samples, &mut keys, look) {
        " Arrows at the point of contact: normal force *N* and friction force *F*."
    } else {
        " The plane exerts no force."
    };
    let caption = format!(
        "The hoop at {} instants, {} apart.{forces}{} Grey: path of the particle. {}.",
        samples.len(),
        say.quantity(step, Dimension::Time),
        picture.camera(),
        input.in_words()
    );
    let cut = (until < motion.until).then(|| {
        let at = say.value(until, Dimension::Time);
        let time = say.time();
        format!("Shown is the beginning of the motion, to {time} = {at}.")
    });
    let figure = picture.figure(NAME, "The hoop in equal times", caption, keys, Vec::new());
    Ok(figure.noted(cut))
}
