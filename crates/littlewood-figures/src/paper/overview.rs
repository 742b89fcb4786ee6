//! All quantities of a motion against time, on one sheet.

use littlewood::tables::SampleColumn;
use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Entries, Figure, Layer, Mark, Panel, Piece, PlotAxis, ROOM, SOFT, Scale, Series,
    Sheet, Stroke, marked,
};

use super::histories::{NORMAL_WEIGHT, normal_weight, weight_name};
use crate::columns::{TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{all_instants, horizon, remark};
use crate::spikes::{SPIKE, Spikes};
use crate::timeline::{CLOSE, bare, level, names, transitions, zero};
use crate::wording::Wording;
use littlewood_style::Dash;
use littlewood_style::width::FINE;

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

/// A curve that is as long as its axis, from some instants of all phases.
struct History {
    by_mode: Vec<(Mode, Series)>,
    range: [f64; 2],
}

/// Whether its axis has a zero in any case.
const fn has_zero(column: SampleColumn) -> bool {
    matches!(
        column,
        SampleColumn::Slip | SampleColumn::Gap | SampleColumn::Normal | SampleColumn::Friction
    )
}

/// The instants of each phase that is shown.
type Samples = [(Mode, Vec<Sample>)];

impl History {
    fn new(samples: &Samples, column: SampleColumn, name: &'static str, others: &[f64]) -> Self {
        let value = |sample: &Sample| column.of(sample).number();
        let mut by_mode: Vec<(Mode, Vec<Piece>)> = Vec::new();
        let mut values: Vec<f64> = others.to_vec();
        values.extend(Some(0.0).filter(|_| has_zero(column)));
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
        let range = span(&values);
        let by_mode = by_mode
            .into_iter()
            .map(|(mode, pieces)| (mode, Series::new(mode.name(), &[TIME, name], pieces)))
            .collect();
        Self { by_mode, range }
    }
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
    let pieces = samples.iter().map(|(_, samples)| {
        samples
            .iter()
            .map(|sample| vec![sample.state.time, place.of(sample).number()])
            .filter(|row| row[1].is_finite())
            .collect()
    });
    Some(Series::new("mass centre", &[TIME, name], pieces.collect()))
}

/// Name of the column in tables, which those of a point share.
const fn column_name(column: SampleColumn) -> &'static str {
    match column {
        SampleColumn::X => X,
        SampleColumn::CentreY => Y,
        _ => column.name(),
    }
}

fn axis_of(column: SampleColumn, name: &'static str, range: [f64; 2], say: Wording) -> PlotAxis {
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
fn panel(
    (motion, samples): (&Trajectory, &Samples),
    column: SampleColumn,
    times: [f64; 2],
    say: Wording,
) -> (Content, Vec<Mode>) {
    let name = column_name(column);
    // It is the geometric centre of a hoop that is balanced.
    let beside = of_mass_centre(samples, column, name).filter(|_| motion.hoop().h() > 0.0);
    let mut others: Vec<f64> = beside
        .iter()
        .flat_map(|series| series.rows().map(|row| row[1]))
        .collect();
    let weight = Some(normal_weight(motion.hoop())).filter(|_| column == SampleColumn::Normal);
    others.extend(weight);
    let History { by_mode, range } = History::new(samples, column, name, &others);
    let axis = axis_of(column, name, range, say);
    let mut layers: Vec<Layer> = vec![transitions(motion, &axis, name)];
    if range[0] < 0.0 && range[1] > 0.0 {
        layers.push(zero(times, name));
    }
    let mut labels = Vec::new();
    if let Some(weight) = weight {
        let stroke = Stroke::solid(SOFT, FINE).dashed(Dash::Dotted);
        layers.push(level(times, NORMAL_WEIGHT, name, weight, stroke));
        let normal: Vec<&Series> = by_mode.iter().map(|(_, series)| series).collect();
        labels.push(weight_name(motion.hoop(), &normal, times, range));
    }
    layers.extend(beside.map(|series| series.drawn(OF_MASS_CENTRE)));
    let modes = by_mode.iter().map(|(mode, _)| *mode).collect();
    for (mode, series) in by_mode {
        // The end of a phase may be out of sight.
        layers.push(series.drawn(Stroke::of_mode(mode)).marked_beyond());
    }
    (
        Content {
            name,
            x: bare(say, times),
            y: axis,
            layers,
            labels,
        },
        modes,
    )
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let times = [motion.start().time, horizon(&motion)];
    let say = input.wording();
    let phases = motion.phases().iter();
    let samples: Vec<(Mode, Vec<Sample>)> = phases
        .map(|phase| (phase.mode(), all_instants(&motion, phase, times[1])))
        .collect();
    let sheet = input.sheet(WIDTH)?;
    let [left, inner] = sheet.span();

    let mut modes: Vec<Mode> = Vec::new();
    let mut contents: Vec<Content> = Vec::new();
    for column in ROWS {
        let (content, own) = panel((&motion, &samples), column, times, say);
        modes.extend(own);
        contents.push(content);
    }
    let mut entries: Entries = Mode::ALL
        .into_iter()
        .filter(|mode| modes.contains(mode))
        .map(|mode| (Mark::Line(Stroke::of_mode(mode)), mode.to_string()))
        .collect();
    if hoop.h() > 0.0 {
        entries.push((Mark::Line(OF_MASS_CENTRE), "mass centre *X̄*".to_owned()));
    }
    let impulses = Spikes::new(&motion).panel(&motion, times, say);
    if impulses.is_some() {
        entries.push((Mark::Line(SPIKE), "impulse".to_owned()));
    }
    contents.extend(impulses);
    let (keys, room) = sheet.keys(entries, 6.0);
    let over = names(&motion, contents[0].y.range[1], inner - ROOM[0]);
    let unnamed = over.note();
    contents[0].labels.extend(over.labels);
    if let Some(last) = contents.last_mut() {
        last.x = say.clock(times);
    }
    let top = room + 42.0 + over.height;
    let step = f64::max(
        LEAST,
        libm::round(TALL * sheet.width / contents.len() as f64),
    );
    let height = step + ROOM[1] - CLOSE;
    let count = contents.len() as f64;
    let mut panels: Vec<Panel> = contents
        .into_iter()
        .zip(0_u8..)
        .map(|(content, i)| Sheet::panel([left, top + step * f64::from(i), inner, height], content))
        .collect();
    panels[0].keys = keys;
    let caption = format!(
        "Angle *θ* and its rate, slip velocity *η*′, position (*x*, *y*) of the geometric centre *C* and of the mass centre \
         *X̄*, gap under the rim, normal force *N* and friction force *F* against time; dashed verticals: transitions. {}.",
        input.in_words()
    );
    let bottom = top + step * (count - 1.0) + height + 6.0;
    let figure = sheet.figure(NAME, "A motion on one sheet", caption, bottom, panels);
    Ok(figure.noted(unnamed).noted(remark(&motion, say)))
}
