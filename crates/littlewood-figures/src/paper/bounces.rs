//! The bounces of a motion: the gap against time, and how the rates of the gap shrink from one to
//! the next.

use littlewood::impact::Impact;
use littlewood::modes::PhaseSolution;
use littlewood::tables::{Dimension, SampleColumn};
use littlewood::{Cause, Mode, Phase, Trajectory, Transition};
use littlewood_draw::{
    Content, Entries, Figure, IMPULSE, INK, Label, Layer, Mark, Panel, Piece, PlotAxis, SMALL,
    SOFT, Scale, Series, Sheet, Stroke, short,
};
use littlewood_style::Dash;
use littlewood_style::width::CURVE;

use crate::columns::{LOG_GAP_RATE, TIME};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;
use crate::motion::{bounds, horizon, instants};
use crate::timeline::VERTICAL;
use crate::wording::Wording;

const NAME: &str = "bounces";
const GAP: &str = SampleColumn::Gap.name();
const NUMBER: &str = "landing";
const RATE: &str = SampleColumn::GapRate.name();
/// Fewest landings and decades that the axes show.
const FEWEST: f64 = 3.0;
const DECADES: f64 = 1.0;
/// Landings that are shown by smaller marks.
const MANY: usize = 60;

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
    let flights = || {
        motion
            .phases()
            .iter()
            .filter(|phase| phase.mode() == Mode::Flight)
    };
    let from = flights().next()?.start().time;
    let to = flights()
        .map(Phase::end_time)
        .fold(from, f64::max)
        .min(until);
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
            .and_then(|(state, restitution)| {
                motion.hoop().settling(&state, opening, restitution).ok()
            });
        found.extend(settling.map(|settling| Settled {
            transition,
            landings,
            ratio: settling.ratio,
        }));
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
fn gap_panel(
    motion: &Trajectory,
    range: [f64; 2],
    settled: &[Settled<'_>],
    say: Wording,
) -> Content {
    let until = range[1];
    let pieces: Vec<Piece> = motion
        .phases()
        .iter()
        .filter(|phase| is_flight(phase))
        .map(|phase| {
            instants(motion, phase, until)
                .iter()
                .map(|sample| vec![sample.state.time, sample.gap])
                .collect()
        })
        .collect();
    let gap = Series::new(GAP, &[TIME, GAP], pieces);
    let highest = bounds(gap.rows().map(|row| row[1]), 0.0)[1].max(f64::MIN_POSITIVE);
    let y = say.axis(GAP, "gap", [0.0, 1.12 * highest]);
    let mut layers: Vec<Layer> = Vec::new();
    let mut labels = Vec::new();
    for end in settled.iter().filter(|end| end.transition.time() <= until) {
        let at = end.transition.time();
        let vertical = y.range.map(|value| vec![at, value]).to_vec();
        layers.push(
            Series::of_rows(end.transition.cause.label(), &[TIME, GAP], vertical).drawn(VERTICAL),
        );
        let time = say.value(at, Dimension::Time);
        let text = format!("{}, {} = {time}", end.transition.cause.label(), say.time());
        let label = Label::new(text, &[at, y.range[1]]).sized(SMALL);
        let is_early = at < range[0] + 0.25 * (range[1] - range[0]);
        labels.push(if is_early {
            label.shifted(7.0, 14.0).left()
        } else {
            label.shifted(-7.0, 14.0).right()
        });
    }
    layers.push(gap.drawn(Stroke::of_mode(Mode::Flight).dashed(Dash::Solid).wide(2.0)));
    let dots = landings(motion)
        .iter()
        .map(|(at, _)| vec![*at, 0.0])
        .collect();
    layers.push(Series::of_rows("landing", &[TIME, GAP], dots).drawn(Mark::Dot(IMPULSE, 3.0)));
    Content {
        name: "gap",
        x: say.clock(range),
        y,
        layers,
        labels,
    }
}

/// The rates of the gap before and after each landing.
fn rate_panel(
    landings: &[(f64, Impact)],
    settled: &[Settled<'_>],
    say: Wording,
) -> (Content, Entries) {
    let columns = [NUMBER, LOG_GAP_RATE, RATE];
    let row = |(i, rate): (usize, f64)| {
        (rate != 0.0).then(|| vec![(i + 1) as f64, libm::log10(rate.abs()), rate])
    };
    let side = |rate: fn(&Impact) -> f64| -> Piece {
        landings
            .iter()
            .map(|(_, impact)| rate(impact))
            .enumerate()
            .filter_map(row)
            .collect()
    };
    let (before, after) = (
        side(|impact| impact.before.gap_rate),
        side(|impact| impact.after.gap_rate),
    );
    let x_range = [0.0, FEWEST.max(landings.len() as f64 + 1.0)];
    let [low, high] = bounds(before.iter().chain(&after).map(|row| row[1]), 0.0);
    let widen = (0.5 * (DECADES - (high - low))).max(0.0);
    let (low, high) = (low - widen, high + widen);
    let y_range = [low - 0.08 * (high - low), high + 0.1 * (high - low)];
    let mut layers = Vec::new();
    let mut labels = Vec::new();
    for end in settled
        .iter()
        .filter(|end| end.ratio > 0.0 && end.landings > 1)
    {
        let (last, slope) = (end.landings as f64, libm::log10(end.ratio));
        let Some(at) = before.iter().find(|row| row[0] == last).map(|row| row[1]) else {
            continue;
        };
        let from = (last - (y_range[1] - at) / -slope).max(x_range[0]);
        let line = [from, last]
            .map(|number| vec![number, at + slope * (number - last)])
            .to_vec();
        layers.push(
            Series::of_rows("limit", &columns[..2], line)
                .drawn(Stroke::solid(SOFT, CURVE).dashed(Dash::Dashed)),
        );
        let text = format!(
            "in the end each *e*_{{eff}} = {} times the one before",
            short(end.ratio)
        );
        if labels.iter().any(|label: &Label| label.text == text) {
            continue;
        }
        let down = 16.0 + 17.0 * labels.len() as f64;
        let label = Label::new(text, &[x_range[1], y_range[1]]);
        labels.push(
            label
                .shifted(-10.0, down)
                .right()
                .sized(SMALL)
                .coloured(SOFT),
        );
    }
    let size = if landings.len() > MANY { 0.5 } else { 1.0 };
    let marks = [Mark::Dot(INK, 2.4 * size), Mark::Ring(IMPULSE, 4.4 * size)];
    layers.push(Series::of_rows("after the impact", &columns, after).drawn(marks[1]));
    layers.push(Series::of_rows("before the impact", &columns, before).drawn(marks[0]));
    let title = say.title(SampleColumn::GapRate.long_name(), Dimension::Velocity);
    let x = PlotAxis {
        scale: Scale::Whole,
        ..say.axis(NUMBER, "number of the landing", x_range)
    };
    let y = PlotAxis {
        title,
        scale: Scale::Decades,
        ..say.axis(LOG_GAP_RATE, "", y_range)
    };
    let keys = ["before the impact, closing", "after the impact, opening"];
    let keys = keys
        .into_iter()
        .zip(marks)
        .map(|(text, mark)| (mark, text.to_owned()))
        .collect();
    (
        Content {
            name: "rates",
            x,
            y,
            layers,
            labels,
        },
        keys,
    )
}

fn in_words(settled: &[Settled<'_>], landings: usize, say: Wording) -> String {
    match settled {
        [] if landings == 1 => "There is one landing.".to_owned(),
        [] => format!("{landings} landings, which do not accumulate."),
        [end, ..] => format!(
            "After {} landings the remaining ones, infinitely many, last less than 10^{{−7}} and are summed. The hoop {} at \
             {} = {}.",
            end.landings,
            end.transition.cause.label(),
            say.time(),
            say.value(end.transition.time(), Dimension::Time)
        ),
    }
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.heavy(NAME)?;
    if input.hoop.restitution().is_none() {
        return Err(FigureError::NeedsRestitution { figure: NAME });
    }
    let motion = input.motion(NAME)?;
    let found = landings(&motion);
    let Some(range) = span(&motion).filter(|_| !found.is_empty()) else {
        return Err(FigureError::NoImpact {
            figure: NAME,
            outcome: motion.outcome().kind(),
        });
    };
    let settled = settled(&motion, input);
    let say = input.wording();
    let sheet = input.sheet(640.0)?;
    let [left, inner] = sheet.span();
    let mut bottom = 10.0 + sheet.height(250.0);
    let frame = [left, 10.0, inner, bottom - 10.0];
    let mut panels = vec![Sheet::panel(
        frame,
        gap_panel(&motion, range, &settled, say),
    )];
    let bounces = found.iter().any(|(_, impact)| impact.after.gap_rate > 0.0);
    if bounces {
        let (content, entries) = rate_panel(&found, &settled, say);
        let (keys, room) = sheet.keys(entries, bottom + 8.0);
        let top = bottom + 14.0 + room;
        bottom = top + sheet.height(270.0);
        panels.push(Panel {
            keys,
            ..Sheet::panel([left, top, inner, bottom - top], content)
        });
    }
    let below = if bounces {
        " Below: the rate of the gap just before and just after each landing."
    } else {
        " No landing rebounds."
    };
    Ok(sheet.figure(
        NAME,
        "The bounces of a motion",
        format!(
            "The gap under the rim against time; dots: landings.{below} {} {}.",
            in_words(&settled, found.len(), say),
            input.in_words()
        ),
        bottom + 6.0,
        panels,
    ))
}
