//! The bounces of a motion: the gap against time, and how the rates of the gap shrink from one to
//! the next.

use littlewood::impact::Impact;
use littlewood::modes::PhaseSolution;
use littlewood::tables::{Dimension, SampleColumn};
use littlewood::{Cause, Mode, Phase, Transition};
use littlewood_draw::{
    Content, Entries, Figure, IMPULSE, INK, Label, Layer, Mark, Panel, PanelFrame, Piece, PlotAxis,
    Range, SMALL, SOFT, Scale, Series, Sheet, Stroke, short,
};
use littlewood_style::Dash;
use littlewood_style::width::CURVE;

use crate::columns::{LOG_GAP_RATE, TIME};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds};
use crate::timeline::VERTICAL;
use crate::wording::Wording;

const NAME: &str = "bounces";
const GAP: &str = SampleColumn::Gap.name();
const NUMBER: &str = "landing";
const RATE: &str = SampleColumn::GapRate.name();
const RATES: [&str; 3] = [NUMBER, LOG_GAP_RATE, RATE];
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

/// A landing with an impact, and its time.
struct Landing {
    time: f64,
    impact: Impact,
}

/// From the first flight to where it settles, or as far as figures of a motion go.
fn span(motion: &Shown) -> Option<[f64; 2]> {
    let phases = || motion.phases().iter();
    let mut flights = phases().filter(|phase| phase.mode() == Mode::Flight);
    let first = flights.next()?;
    let from = first.start().time;
    let ends = core::iter::once(first).chain(flights).map(Phase::end_time);
    let to = ends.fold(from, f64::max).min(motion.until);
    let room = 0.04 * (to - from);
    Some([from - room, to + room])
}

fn settled<'a>(motion: &'a Shown, input: &FigureInput) -> Vec<Settled<'a>> {
    let mut found = Vec::new();
    let mut landings = 0;
    let mut opening = input.start.gap_rate;
    for (transition, impact) in impacts::all(motion) {
        if transition.cause != Cause::Settle {
            landings += usize::from(transition.cause == Cause::Landing);
            opening = impact.after.gap_rate;
            continue;
        }
        let ends = |it: &&Phase| it.end_time() == transition.time() && it.mode() == Mode::Flight;
        let start = motion.phases().iter().find(ends).map(Phase::start);
        let settling = start
            .zip(motion.hoop().restitution())
            .and_then(|(state, it)| motion.hoop().settling(&state, opening, it).ok());
        found.extend(settling.map(|settling| Settled {
            transition,
            landings,
            ratio: settling.ratio,
        }));
    }
    found
}

/// Landings one by one, in order.
fn landings(motion: &Shown) -> Vec<Landing> {
    impacts::single(motion)
        .filter(|(it, _)| it.cause == Cause::Landing && it.time() <= motion.until)
        .map(|(transition, impact)| Landing {
            time: transition.time(),
            impact,
        })
        .collect()
}

/// The gap against time, from the first of two times to the second.
fn gap_panel(
    motion: &Shown,
    range: Range,
    landings: &[Landing],
    settled: &[Settled<'_>],
) -> Content {
    let say = motion.say;
    let shown = motion.up_to(range.to);
    // Those by which a hoop settles have no height.
    let is_flight = |phase: &&Phase| matches!(phase.solution(), PhaseSolution::Flight(flight) if !flight.settles());
    let pieces = motion.phases().iter().filter(is_flight).map(|phase| {
        let samples = shown.instants(phase).into_iter();
        samples.map(|sample| [sample.state.time, sample.gap])
    });
    let gap = Series::new(GAP, &[TIME, GAP], pieces);
    let highest = bounds(gap.rows().map(|row| row[1]), 0.0)[1].max(f64::MIN_POSITIVE);
    let y = say.axis(GAP, "gap", [0.0, 1.12 * highest].into());
    let mut layers: Vec<Layer> = Vec::new();
    let mut labels = Vec::new();
    for end in settled {
        let (at, name) = (end.transition.time(), end.transition.cause.label());
        if at > range.to {
            continue;
        }
        let vertical = y.range.ends().map(|value| [at, value]);
        layers.push(Series::of_rows(name, &[TIME, GAP], vertical).drawn(VERTICAL));
        let time = say.value(at, Dimension::Time);
        let text = format!("{name}, {} = {time}", say.time());
        let label = Label::new(text, &[at, y.range.to]).sized(SMALL);
        let is_early = at < range.from + 0.25 * range.length();
        labels.push(if is_early {
            label.shifted(7.0, 14.0).left()
        } else {
            label.shifted(-7.0, 14.0).right()
        });
    }
    layers.push(gap.drawn(Stroke::of_mode(Mode::Flight).dashed(Dash::Solid).wide(2.0)));
    let dots = landings.iter().map(|landing| [landing.time, 0.0]);
    layers.push(Series::of_rows("landing", &[TIME, GAP], dots).drawn(Mark::Dot(IMPULSE, 3.0)));
    Content {
        name: "gap",
        x: say.clock(range),
        y,
        layers,
        labels,
    }
}

/// The rates just before each landing, or just after, that are not zero.
fn rates(landings: &[Landing], rate: fn(&Impact) -> f64) -> Piece {
    let rates = landings.iter().map(|landing| rate(&landing.impact));
    let row = |(i, rate): (usize, f64)| vec![(i + 1) as f64, libm::log10(rate.abs()), rate];
    let rates = rates.enumerate().filter(|(_, rate)| *rate != 0.0);
    rates.map(row).collect()
}

/// The lines along which rates shrink in the end, and the ratio of each in words.
fn limits(
    before: &Piece,
    settled: &[Settled<'_>],
    left: f64,
    corner: &[f64; 2],
) -> (Vec<Layer>, Vec<Label>) {
    let (mut layers, mut labels): (Vec<Layer>, Vec<Label>) = Default::default();
    let shrinks = |end: &&Settled<'_>| end.ratio > 0.0 && end.landings > 1;
    for end in settled.iter().filter(shrinks) {
        let (last, slope) = (end.landings as f64, libm::log10(end.ratio));
        let Some(at) = before.iter().find(|row| row[0] == last).map(|row| row[1]) else {
            continue;
        };
        let from = (last - (corner[1] - at) / -slope).max(left);
        let line = [from, last].map(|number| [number, at + slope * (number - last)]);
        layers.push(
            Series::of_rows("limit", &RATES[..2], line)
                .drawn(Stroke::solid(SOFT, CURVE).dashed(Dash::Dashed)),
        );
        let ratio = short(end.ratio);
        let text = format!("in the end each *e*_{{eff}} = {ratio} times the one before");
        if labels.iter().any(|label| label.text == text) {
            continue;
        }
        let down = 16.0 + 17.0 * labels.len() as f64;
        let label = Label::new(text, corner).shifted(-10.0, down).right();
        labels.push(label.sized(SMALL).coloured(SOFT));
    }
    (layers, labels)
}

/// The rates of the gap before and after each landing.
fn rate_panel(landings: &[Landing], settled: &[Settled<'_>], say: Wording) -> (Content, Entries) {
    let before = rates(landings, |impact| impact.before.gap_rate);
    let after = rates(landings, |impact| impact.after.gap_rate);
    let x_range = [0.0, FEWEST.max(landings.len() as f64 + 1.0)];
    let [low, high] = bounds(before.iter().chain(&after).map(|row| row[1]), 0.0);
    let widen = (0.5 * (DECADES - (high - low))).max(0.0);
    let (low, high) = (low - widen, high + widen);
    let y_range = [low - 0.08 * (high - low), high + 0.1 * (high - low)];
    let corner = [x_range[1], y_range[1]];
    let (mut layers, labels) = limits(&before, settled, x_range[0], &corner);
    let size = if landings.len() > MANY { 0.5 } else { 1.0 };
    let [dot, ring] = [Mark::Dot(INK, 2.4 * size), Mark::Ring(IMPULSE, 4.4 * size)];
    layers.push(Series::of_rows("after the impact", &RATES, after).drawn(ring));
    layers.push(Series::of_rows("before the impact", &RATES, before).drawn(dot));
    let keys = vec![
        (dot, "before the impact, closing".to_owned()),
        (ring, "after the impact, opening".to_owned()),
    ];
    let content = Content {
        name: "rates",
        x: PlotAxis {
            scale: Scale::Whole,
            ..say.axis(NUMBER, "number of the landing", x_range.into())
        },
        y: PlotAxis {
            title: say.title(SampleColumn::GapRate.long_name(), Dimension::Velocity),
            scale: Scale::Decades,
            ..say.axis(LOG_GAP_RATE, "", y_range.into())
        },
        layers,
        labels,
    };
    (content, keys)
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
    let sheet = input.sheet(640.0)?;
    let [left, inner] = sheet.span();
    let mut bottom = 10.0 + sheet.height(250.0);
    let frame = PanelFrame {
        left,
        top: 10.0,
        width: inner,
        height: bottom - 10.0,
    };
    let gap = gap_panel(&motion, range.into(), &found, &settled);
    let mut panels = vec![Sheet::panel(frame, gap)];
    let rebounds = |landing: &Landing| landing.impact.after.gap_rate > 0.0;
    let below = if found.iter().any(rebounds) {
        let (content, entries) = rate_panel(&found, &settled, motion.say);
        let (keys, room) = sheet.keys(entries, bottom + 8.0);
        let top = bottom + 14.0 + room;
        bottom = top + sheet.height(270.0);
        panels.push(Panel {
            keys,
            ..Sheet::panel(
                PanelFrame {
                    left,
                    top,
                    width: inner,
                    height: bottom - top,
                },
                content,
            )
        });
        " Below: the rate of the gap just before and just after each landing."
    } else {
        " No landing rebounds."
    };
    let caption = format!(
        "The gap under the rim against time; dots: landings.{below} {} {}.",
        in_words(&settled, found.len(), motion.say),
        input.in_words()
    );
    let title = "The bounces of a motion";
    Ok(sheet.figure(NAME, title, caption, bottom + 6.0, panels))
}
