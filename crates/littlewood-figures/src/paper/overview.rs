//! All quantities of a motion against time, on one sheet.

use littlewood::tables::SampleColumn;
use littlewood::{Mode, Sample};
use littlewood_draw::{
    Content, Entries, Figure, Mark, Piece, PlotAxis, ROOM, Range, SOFT, Scale, Series, Stroke,
    marked,
};
use littlewood_style::width::FINE;

use super::histories::{normal_weight, weight_level};
use crate::columns::{TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Modes, Shown, finite_rows};
use crate::spikes::{SPIKE, Spikes};
use crate::timeline::{CLOSE, Timeline, zero_of};
use crate::wording::Wording;

const NAME: &str = "sheet";
const WIDTH: f64 = 640.0;
/// Height of all panels to the width of the sheet: with what stands above them the proportion of
/// A4.
const TALL: f64 = 1.27;
/// Least height of a panel, with which the titles of the axes do not meet.
const LEAST: f64 = 96.0;

/// The quantities, from top to bottom.
const ROWS: [SampleColumn; 8] = [
    SampleColumn::Theta,
    SampleColumn::ThetaRate,
    SampleColumn::Slip,
    SampleColumn::X,
    SampleColumn::CentreY,
    SampleColumn::Gap,
    SampleColumn::Normal,
    SampleColumn::Friction,
];

/// The mass centre, beside the geometric centre.
const OF_MASS_CENTRE: Stroke = Stroke::solid(SOFT, FINE);

/// What a rate that grows without bound at the end of a phase has been in the first part of it, its
/// axis shows.
const BOUNDED: f64 = 0.85;

/// Part of a value, or of one, that is rounding.
const NOISE: f64 = 1e-6;

/// The instants of each phase that is shown.
type Samples = [(Mode, Vec<Sample>)];

/// A curve that is as long as its axis, from some instants of all phases.
struct History {
    modes: Modes,
    range: [f64; 2],
}

impl History {
    fn new(samples: &Samples, column: SampleColumn, name: &'static str, others: &[f64]) -> Self {
        let value = |sample: &Sample| column.of(sample).number();
        let mut by_mode: Vec<(Mode, Vec<Piece>)> = Vec::new();
        let mut values: Vec<f64> = others.to_vec();
        for (mode, samples) in samples {
            let is_bounded = samples.iter().all(|sample| value(sample).is_finite());
            let shown = if is_bounded {
                samples.len()
            } else {
                (BOUNDED * samples.len() as f64) as usize
            };
            values.extend(samples.iter().take(shown).map(value));
            let rows: Piece = samples
                .iter()
                .map(|sample| vec![sample.state.time, value(sample)])
                .filter(|row| !row[1].is_nan())
                .collect();
            match by_mode.iter_mut().find(|(known, _)| known == mode) {
                Some((_, pieces)) => pieces.push(rows),
                None => by_mode.push((*mode, vec![rows])),
            }
        }
        let zero = zero_of(values.iter().copied()).filter(|_| has_zero(column));
        values.extend(zero);
        let series = |(mode, pieces): (Mode, Vec<Piece>)| {
            (mode, Series::new(mode.name(), &[TIME, name], pieces))
        };
        Self {
            modes: Modes(by_mode.into_iter().map(series).collect()),
            range: span(&values),
        }
    }
}

/// Whether its axis has a zero in any case.
const fn has_zero(column: SampleColumn) -> bool {
    matches!(
        column,
        SampleColumn::Slip | SampleColumn::Gap | SampleColumn::Normal | SampleColumn::Friction
    )
}

/// The axis of some values; one that changes by rounding alone has one all the same.
fn span(values: &[f64]) -> [f64; 2] {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = (
        finite().fold(f64::INFINITY, f64::min),
        finite().fold(f64::NEG_INFINITY, f64::max),
    );
    let size = f64::max(low.abs(), high.abs());
    if low > high {
        return [-1.0, 1.0];
    }
    let pad = if high - low > NOISE * size.max(1.0) {
        0.1 * (high - low)
    } else {
        0.5 * size.max(1.0)
    };
    [low - pad, high + pad]
}

/// The mass centre against time.
fn of_mass_centre(samples: &Samples, column: SampleColumn, name: &'static str) -> Option<Series> {
    let place = match column {
        SampleColumn::X => SampleColumn::MassCentreX,
        SampleColumn::CentreY => SampleColumn::MassCentreY,
        _ => return None,
    };
    let row = |sample: &Sample| [sample.state.time, place.of(sample).number()];
    let pieces = samples
        .iter()
        .map(|(_, samples)| finite_rows(samples.iter().map(row)));
    Some(Series::new("mass centre", &[TIME, name], pieces))
}

/// Name of the column in tables, which those of a point share.
const fn column_name(column: SampleColumn) -> &'static str {
    match column {
        SampleColumn::X => X,
        SampleColumn::CentreY => Y,
        _ => column.name(),
    }
}

fn axis_of(column: SampleColumn, range: Range, say: Wording) -> PlotAxis {
    let name = column_name(column);
    match column {
        SampleColumn::Theta => say.angle(range),
        // The name of the gap is a word.
        SampleColumn::Gap => PlotAxis {
            scale: Scale::NotNegative,
            ..say.axis(name, column.sign(), range)
        },
        _ => say.axis(name, &marked(column.sign()), range),
    }
}

/// A panel, with the modes that are in it.
fn panel(motion: &Shown, samples: &Samples, column: SampleColumn) -> (Content, Vec<Mode>) {
    let name = column_name(column);
    // It is the geometric centre of a hoop that is balanced.
    let beside = of_mass_centre(samples, column, name).filter(|_| motion.hoop().h() > 0.0);
    let mut others: Vec<f64> = beside
        .iter()
        .flat_map(|series| series.rows().map(|row| row[1]))
        .collect();
    let is_normal = column == SampleColumn::Normal;
    others.extend(is_normal.then(|| normal_weight(motion.hoop())));
    let History { modes, range } = History::new(samples, column, name, &others);
    let axis = axis_of(column, range.into(), motion.say);
    let mut layers = vec![motion.verticals(&axis, name)];
    if range[0] < 0.0 && range[1] > 0.0 {
        layers.push(motion.zero(name));
    }
    let mut labels = Vec::new();
    if is_normal {
        let normal: Vec<&Series> = modes.0.iter().map(|(_, series)| series).collect();
        let (level, label) = weight_level(motion, &normal, &axis, FINE);
        layers.push(level);
        labels.push(label);
    }
    layers.extend(beside.map(|series| series.drawn(OF_MASS_CENTRE)));
    let shown = modes.0.iter().map(|(mode, _)| *mode).collect();
    for (mode, series) in modes.0 {
        // The end of a phase may be out of sight.
        layers.push(series.drawn(Stroke::of_mode(mode)).marked_beyond());
    }
    (motion.panel(name, axis, layers, labels), shown)
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion(NAME)?;
    let phases = motion.phases().iter();
    let samples: Vec<(Mode, Vec<Sample>)> = phases
        .map(|phase| (phase.mode(), motion.all_instants(phase)))
        .collect();
    let (mut contents, modes): (Vec<Content>, Vec<Vec<Mode>>) = ROWS
        .into_iter()
        .map(|column| panel(&motion, &samples, column))
        .unzip();
    let is_shown = |mode: &Mode| modes.iter().flatten().any(|own| own == mode);
    let shown = Mode::ALL.into_iter().filter(is_shown);
    let mut keys: Entries = shown
        .map(|mode| (Mark::Line(Stroke::of_mode(mode)), mode.to_string()))
        .collect();
    if motion.hoop().h() > 0.0 {
        keys.push((Mark::Line(OF_MASS_CENTRE), "mass centre *X̄*".to_owned()));
    }
    let impulses = Spikes::new(&motion).panel(&motion);
    if impulses.is_some() {
        keys.push((Mark::Line(SPIKE), "impulse".to_owned()));
    }
    contents.extend(impulses);
    let caption = format!(
        "Angle *θ* and its rate, slip velocity *η*′, position (*x*, *y*) of the geometric centre *C* and of the mass centre \
         *X̄*, gap under the rim, normal force *N* and friction force *F* against time; dashed verticals: transitions. {}.",
        input.in_words()
    );
    let sheet = input.sheet(WIDTH)?;
    let step = libm::round(TALL * sheet.width / contents.len() as f64).max(LEAST);
    let timeline = Timeline {
        name: NAME,
        title: "A motion on one sheet",
        caption,
        keys,
        contents,
        height: &|_| step + ROOM[1] - CLOSE,
    };
    Ok(motion.figure(&sheet, timeline))
}
