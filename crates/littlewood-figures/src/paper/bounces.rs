//! The bounces of a motion: the gap against time, and how the rates of the gap shrink from one to the next.

use littlewood::{Cause, Impact, Mode, Phase, PhaseSolution, SampleColumn, Trajectory, Transition};
use littlewood_style::Dash;
use littlewood_style::ticks::Tick;
use littlewood_style::width::{CURVE, FINE};

use crate::axes::{plain, time};
use crate::columns::TIME;
use crate::error::FigureError;
use crate::figure::{Figure, Key, Label, Layer, Mark, Panel, PlotAxis, Series, View};
use crate::impacts;
use crate::input::FigureInput;
use crate::motion::{bounds, horizon, instants};
use crate::style::{FAINT, IMPULSE, INK, SMALL, SOFT, Stroke};
use crate::words::{hoop_in_words, marked, short, start_in_words};

const NAME: &str = "bounces";
const GAP: &str = SampleColumn::Gap.name();
const NUMBER: &str = "landing";
const RATE: &str = SampleColumn::GapRate.name();
/// The column along the axis of the rates, which is logarithmic.
const LOGARITHM: &str = "log10_gap_rate";
const WIDTH: f64 = 640.0;
const INNER: f64 = WIDTH - 26.0;
/// Fewest landings and decades that the axes show.
const FEWEST: f64 = 3.0;
const DECADES: f64 = 1.0;
/// Landings that are shown by smaller marks.
const MANY: usize = 60;
/// Most ticks of the decades.
const TICKS: usize = 8;

/// An end of bouncing: after which landing, and by which ratio the rates shrink in the end.
struct Settled<'a> {
    transition: &'a Transition,
    landings: usize,
    ratio: f64,
}

/// A flight that is drawn: those by which a hoop settles have no height.
fn is_flight(phase: &Phase) -> bool {
    matches!(phase.solution(), PhaseSolution::Flight(flight) if !flight.settles())
}

/// From the first flight to where it settles, or as far as figures of a motion go.
fn span(motion: &Trajectory) -> Option<[f64; 2]> {
    let until = horizon(motion);
    let flights = || motion.phases().iter().filter(|phase| phase.mode() == Mode::Flight);
    let from = flights().next()?.start().time;
    let to = flights().map(Phase::end_time).fold(from, f64::max).min(until);
    let room = 0.04 * (to - from);
    Some([from - room, to + room])
}

fn settled<'a>(motion: &'a Trajectory, input: &FigureInput) -> Vec<Settled<'a>> {
    let mut found = Vec::new();
    let mut landings = 0;
    let mut opening = input.start.gap_rate;
    for (transition, impact) in impacts::all(motion) {
        if transition.cause != Cause::Settle {
            landings += usize::from(transition.cause == Cause::Landing);
            opening = impact.after.gap_rate;
            continue;
        }
        let start = motion
            .phases()
            .iter()
            .find(|phase| phase.end_time() == transition.time() && phase.mode() == Mode::Flight)
            .map(Phase::start);
        let settling = start
            .zip(motion.hoop().restitution())
            .and_then(|(state, restitution)| motion.hoop().settling(&state, opening, restitution).ok());
        found.extend(settling.map(|settling| Settled { transition, landings, ratio: settling.ratio }));
    }
    found
}

/// Landings one by one, in order.
fn landings(motion: &Trajectory) -> Vec<(f64, Impact)> {
    let until = horizon(motion);
    impacts::single(motion)
        .filter(|(transition, _)| transition.cause == Cause::Landing && transition.time() <= until)
        .map(|(transition, impact)| (transition.time(), impact))
        .collect()
}

/// The gap against time.
fn gap_panel(motion: &Trajectory, range: [f64; 2], settled: &[Settled<'_>]) -> Panel {
    let until = range[1];
    let pieces: Vec<Vec<Vec<f64>>> = motion
        .phases()
        .iter()
        .filter(|phase| is_flight(phase))
        .map(|phase| {
            instants(motion, phase, until).iter().map(|sample| vec![sample.state.time, sample.gap]).collect()
        })
        .collect();
    let gap = Series::new(GAP, &[TIME, GAP], pieces);
    let highest = bounds(gap.rows().map(|row| row[1]), 0.0)[1].max(f64::MIN_POSITIVE);
    let y = plain(GAP, "gap/*R*", [0.0, 1.12 * highest]);
    let mut layers: Vec<Layer> = Vec::new();
    let mut labels = Vec::new();
    for end in settled.iter().filter(|end| end.transition.time() <= until) {
        let at = end.transition.time();
        let vertical = y.range.map(|value| vec![at, value]).to_vec();
        layers.push(
            Series::of_rows(end.transition.cause.label(), &[TIME, GAP], vertical)
                .drawn(Mark::Line(Stroke::solid(FAINT, FINE).dashed(Dash::Dashed))),
        );
        let text = format!("{}, *τ* = {}", end.transition.cause.label(), short(at));
        let label = Label::new(text, &[at, y.range[1]]).sized(SMALL);
        let is_early = at < range[0] + 0.25 * (range[1] - range[0]);
        labels.push(if is_early {
            label.shifted(7.0, 14.0).left()
        } else {
            label.shifted(-7.0, 14.0).right()
        });
    }
    layers.push(gap.drawn(Mark::Line(Stroke::of_mode(Mode::Flight).dashed(Dash::Solid).wide(2.0))));
    let dots = landings(motion).iter().map(|(at, _)| vec![*at, 0.0]).collect();
    layers.push(Series::of_rows("landing", &[TIME, GAP], dots).drawn(Mark::Dot(IMPULSE, 3.0)));
    Panel {
        name: "gap",
        frame: [6.0, 10.0, INNER, 250.0],
        view: View::Plane { x: time(range), y, axes: true },
        layers,
        labels,
        keys: Vec::new(),
    }
}

/// Powers of ten; within few of them their double and five times as much, too.
fn decades([from, to]: [f64; 2]) -> Vec<Tick> {
    let (first, last) = (libm::ceil(from) as i32, libm::floor(to) as i32);
    if last - first < 2 {
        return (first - 1..=last)
            .flat_map(|power| [1.0, 2.0, 5.0].map(|factor| factor * libm::pow(10.0, f64::from(power))))
            .map(|rate| Tick { value: libm::log10(rate), label: short(rate) })
            .filter(|tick| (from..=to).contains(&tick.value))
            .collect();
    }
    let each = (last - first).max(0) as usize / TICKS + 1;
    (first..=last)
        .rev()
        .step_by(each)
        .map(|power| {
            let label = format!("10^{{{}}}", littlewood_style::ticks::minus(&power.to_string()));
            Tick { value: f64::from(power), label }
        })
        .collect()
}

/// The rates of the gap before and after each landing.
fn rate_panel(landings: &[(f64, Impact)], settled: &[Settled<'_>]) -> Panel {
    let columns = [NUMBER, LOGARITHM, RATE];
    let row =
        |(i, rate): (usize, f64)| (rate != 0.0).then(|| vec![(i + 1) as f64, libm::log10(rate.abs()), rate]);
    let side = |rate: fn(&Impact) -> f64| -> Vec<Vec<f64>> {
        landings.iter().map(|(_, impact)| rate(impact)).enumerate().filter_map(row).collect()
    };
    let (before, after) = (side(|impact| impact.before.gap_rate), side(|impact| impact.after.gap_rate));
    let x_range = [0.0, FEWEST.max(landings.len() as f64 + 1.0)];
    let [low, high] = bounds(before.iter().chain(&after).map(|row| row[1]), 0.0);
    let widen = (0.5 * (DECADES - (high - low))).max(0.0);
    let (low, high) = (low - widen, high + widen);
    let y_range = [low - 0.08 * (high - low), high + 0.1 * (high - low)];
    let mut layers = Vec::new();
    let mut labels = Vec::new();
    for end in settled.iter().filter(|end| end.ratio > 0.0 && end.landings > 1) {
        let (last, slope) = (end.landings as f64, libm::log10(end.ratio));
        let Some(at) = before.iter().find(|row| row[0] == last).map(|row| row[1]) else { continue };
        let from = (last - (y_range[1] - at) / -slope).max(x_range[0]);
        let line = [from, last].map(|number| vec![number, at + slope * (number - last)]).to_vec();
        layers.push(
            Series::of_rows("limit", &columns[..2], line)
                .drawn(Mark::Line(Stroke::solid(SOFT, CURVE).dashed(Dash::Dashed))),
        );
        let text = format!("in the end each *e*_{{eff}} = {} times the one before", short(end.ratio));
        if labels.iter().any(|label: &Label| label.text == text) {
            continue;
        }
        let down = 16.0 + 17.0 * labels.len() as f64;
        let label = Label::new(text, &[x_range[1], y_range[1]]);
        labels.push(label.shifted(-10.0, down).right().sized(SMALL).coloured(SOFT));
    }
    let size = if landings.len() > MANY { 0.5 } else { 1.0 };
    let marks = [Mark::Dot(INK, 2.4 * size), Mark::Ring(IMPULSE, 4.4 * size)];
    layers.push(Series::of_rows("after the impact", &columns, after).drawn(marks[1]));
    layers.push(Series::of_rows("before the impact", &columns, before).drawn(marks[0]));
    let title = format!("rate of the gap/({})", marked(littlewood::Dimension::Velocity.scale_sign()));
    let whole = littlewood_style::ticks::round(x_range[0], x_range[1], (x_range[1] as usize).min(TICKS));
    let x = PlotAxis { ticks: whole, ..plain(NUMBER, "number of the landing", x_range) };
    let y = PlotAxis { ticks: decades(y_range), ..plain(LOGARITHM, &title, y_range) };
    let keys = ["before the impact, closing", "after the impact, opening"]
        .into_iter()
        .zip(marks)
        .enumerate()
        .map(|(i, (text, mark))| Key { mark, text: text.to_owned(), at: [70.0 + 220.0 * i as f64, 278.0] })
        .collect();
    Panel {
        name: "rates",
        frame: [6.0, 294.0, INNER, 270.0],
        view: View::Plane { x, y, axes: true },
        layers,
        labels,
        keys,
    }
}

fn in_words(settled: &[Settled<'_>], landings: usize) -> String {
    match settled {
        [] if landings == 1 => "There is one landing.".to_owned(),
        [] => format!("There are {landings} landings, and they do not accumulate."),
        [end, ..] => format!(
            "After {} landings those that remain, without number, take less than 10^{{−7}}; they are completed as one. The \
             hoop {} at *τ* = {}.",
            end.landings,
            end.transition.cause.label(),
            short(end.transition.time())
        ),
    }
}

/// Gap against time, with the accumulation.
pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    if input.is_massless() {
        return Err(FigureError::NeedsInertia { figure: NAME });
    }
    if input.hoop.restitution().is_none() {
        return Err(FigureError::NeedsRestitution { figure: NAME });
    }
    let motion = input.motion(NAME)?;
    let found = landings(&motion);
    let Some(range) = span(&motion).filter(|_| !found.is_empty()) else {
        return Err(FigureError::NoImpact { figure: NAME, outcome: motion.outcome().kind() });
    };
    let settled = settled(&motion, input);
    let mut panels = vec![gap_panel(&motion, range, &settled)];
    let bounces = found.iter().any(|(_, impact)| impact.after.gap_rate > 0.0);
    if bounces {
        panels.push(rate_panel(&found, &settled));
    }
    let below = if bounces {
        " Below: the rate of the gap just before and just after each landing."
    } else {
        " No landing rebounds."
    };
    Ok(Figure {
        name: NAME,
        title: "The bounces of a motion".to_owned(),
        caption: format!(
            "The gap under the rim against time; dots: landings.{below} {} {}; {}.",
            in_words(&settled, found.len()),
            hoop_in_words(&input.hoop),
            start_in_words(&input.hoop, &input.start)
        ),
        width: WIDTH,
        height: if bounces { 570.0 } else { 266.0 },
        panels,
    })
}
