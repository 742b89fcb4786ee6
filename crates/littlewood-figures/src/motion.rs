//! A motion as series: one piece for each phase of a mode.

use core::f64::consts::TAU;

use littlewood::tables::Dimension;
use littlewood::{Hoop, Mode, OutcomeKind, Phase, Sample, Trajectory, Transition};
use littlewood_draw::{Entries, Layer, Mark, Piece, Series, Stroke};
use littlewood_style::width::BOLD;

use crate::columns::{THETA, TIME, X, Y};
use crate::wording::Wording;

/// Instants of a phase.
const INSTANTS: u32 = 160;

/// Instants of a motion with impacts, and of the shortest of its phases: there may be thousands.
const INSTANTS_IN_ALL: f64 = 960.0;
const FEWEST_INSTANTS: u32 = 2;

/// Most transitions that are shown of a motion that was stopped at a number of them.
const TRANSITIONS: usize = 12;

/// Phases that cannot be told apart beside each other, how many transitions are then shown of a
/// motion that does not end in an event, and instants of all that are shown.
const CROWD: usize = 64;
const SHOWN: usize = 24;
const INSTANTS_OF_A_CROWD: f64 = 6_000.0;

/// The instants of a phase at which its rate is finite, evenly spaced; one that lasts for ever is
/// cut at `until`.
pub(crate) fn instants(motion: &Trajectory, phase: &Phase, until: f64) -> Vec<Sample> {
    let mut samples = all_instants(motion, phase, until);
    samples.retain(|sample| sample.state.theta_rate.is_finite());
    samples
}

/// The instants of a phase, its last one among them.
pub(crate) fn all_instants(motion: &Trajectory, phase: &Phase, until: f64) -> Vec<Sample> {
    let duration = f64::min(phase.duration(), until - phase.start().time);
    if duration <= 0.0 {
        return Vec::new();
    }
    let share = duration / (until - motion.start().time);
    let of_all = |all: f64| (libm::ceil(all * share) as u32).clamp(FEWEST_INSTANTS, INSTANTS);
    let intervals = if motion.hoop().restitution().is_some() {
        of_all(INSTANTS_IN_ALL)
    } else if motion.phases().len() > CROWD {
        of_all(INSTANTS_OF_A_CROWD)
    } else {
        INSTANTS
    };
    (0..=intervals)
        .map(|i| phase.sample(duration * f64::from(i) / f64::from(intervals)))
        .collect()
}

/// Where the figures of a motion stop: at its end; where it has none, or was stopped, a few turns
/// after the last phase has begun. A motion that goes on after its landings has more to show before
/// its last phase, of which a turn is enough.
pub(crate) fn horizon(motion: &Trajectory) -> f64 {
    let (end, goes_on) = (motion.end_time(), motion.hoop().restitution().is_some());
    let Some(last) = motion.phases().last() else {
        return end;
    };
    if let Some(time) = if goes_on {
        bouncing(motion)
    } else {
        crowded(motion)
    } {
        return time;
    }
    if end.is_finite() && motion.outcome().is_final() {
        return end;
    }
    let rate = last.start().theta_rate.abs();
    let turns = if goes_on {
        TAU / f64::max(rate, 1.0)
    } else {
        14.0 / f64::max(rate, 14.0 / 12.0)
    };
    f64::min(end, last.start().time + turns)
}

/// Until when a motion is shown that bounces until it is stopped: its first flights.
fn bouncing(motion: &Trajectory) -> Option<f64> {
    let is_stopped = motion.outcome().kind() == OutcomeKind::TransitionLimit;
    motion
        .transitions()
        .get(TRANSITIONS)
        .filter(|_| is_stopped)
        .map(Transition::time)
}

/// Until when a motion of very many transitions is shown that ends in none.
fn crowded(motion: &Trajectory) -> Option<f64> {
    let transitions = motion.transitions();
    let is_event = transitions.last().is_some_and(|last| last.to.is_none());
    (transitions.len() > CROWD && !is_event).then(|| transitions[SHOWN].time())
}

/// What a figure notes of a motion of which only the beginning is shown.
pub(crate) fn remark(motion: &Trajectory, say: Wording) -> Option<String> {
    let until = horizon(motion);
    let all = motion.transitions().len();
    let shown = motion
        .transitions()
        .iter()
        .filter(|transition| transition.time() <= until)
        .count();
    if shown == all {
        return None;
    }
    let at = say.value(until, Dimension::Time);
    Some(format!(
        "Shown is the beginning, to {} = {at}, with {shown} of {all} transitions.",
        say.time()
    ))
}

/// The modes of a motion, each with the series of its phases.
pub(crate) fn by_mode(
    motion: &Trajectory,
    prefix: &str,
    columns: &[&'static str],
    row: &dyn Fn(&Sample) -> Vec<f64>,
) -> Vec<(Mode, Series)> {
    let until = horizon(motion);
    Mode::ALL
        .into_iter()
        .filter_map(|mode| {
            let pieces: Vec<Piece> = motion
                .phases()
                .iter()
                .filter(|phase| phase.mode() == mode)
                .map(|phase| instants(motion, phase, until).iter().map(row).collect())
                .collect();
            (!pieces.is_empty()).then(|| {
                (
                    mode,
                    Series::new(format!("{prefix}{mode}"), columns, pieces),
                )
            })
        })
        .collect()
}

/// Adds the end of a motion, if its rate has no bound there: a glide that ends at the plane. Its
/// line then says that it has no greatest rate.
pub(crate) fn add_unbounded_end(
    motion: &Trajectory,
    modes: &mut [(Mode, Series)],
    row: &dyn Fn(&Sample) -> Vec<f64>,
) {
    let Some(phase) = motion.phases().last() else {
        return;
    };
    let samples = all_instants(motion, phase, horizon(motion));
    let end = samples
        .last()
        .filter(|end| end.state.theta_rate.is_infinite());
    let own = modes.iter_mut().find(|(mode, _)| *mode == phase.mode());
    if let (Some(end), Some((_, series))) = (end, own)
        && let Some(piece) = series.pieces.last_mut()
    {
        piece.push(row(end));
    }
}

/// Lines of modes, so wide.
pub(crate) fn lines(modes: Vec<(Mode, Series)>, width: f64) -> impl Iterator<Item = Layer> {
    modes
        .into_iter()
        .map(move |(mode, series)| series.drawn(Stroke::of_mode(mode).wide(width)))
}

/// What they mean.
pub(crate) fn entries(modes: &[(Mode, Series)], words: impl Fn(Mode) -> String) -> Entries {
    modes
        .iter()
        .map(|(mode, _)| (Stroke::of_mode(*mode).wide(BOLD).into(), words(*mode)))
        .collect()
}

/// The hoop at some instants.
pub(crate) fn hoops<'a>(
    hoop: &Hoop,
    samples: impl Iterator<Item = &'a Sample>,
    name: impl Into<String>,
    rim: Stroke,
) -> Layer {
    let row = |sample: &Sample| {
        vec![
            sample.state.time,
            sample.centre.x,
            sample.centre.y,
            sample.state.theta,
        ]
    };
    let mark = Mark::Hoop {
        offset: hoop.offset(),
        h: hoop.h(),
        radius: 1.0,
        rim,
    };
    Series::of_rows(name, &[TIME, X, Y, THETA], samples.map(row).collect()).drawn(mark)
}

/// Arrows of time, those that are seen: from a place on each phase that is shown, by its row, to
/// one a little later.
pub(crate) fn arrows(
    motion: &Trajectory,
    share: f64,
    columns: &[&'static str],
    row: &dyn Fn(&Sample) -> Vec<f64>,
    is_seen: impl Fn(Mode, &[Vec<f64>]) -> bool,
) -> impl Iterator<Item = Layer> {
    let until = horizon(motion);
    motion.phases().iter().filter_map(move |phase| {
        let (mode, duration) = (
            phase.mode(),
            f64::min(phase.duration(), until - phase.start().time),
        );
        let at = |share: f64| row(&phase.sample(share * duration));
        let rows = (duration > 0.0).then(|| vec![at(share), at(share + SOON)])?;
        let is_drawn = rows.iter().flatten().all(|value| value.is_finite()) && is_seen(mode, &rows);
        let arrow = || Series::new("arrow of time", columns, vec![rows]);
        is_drawn.then(|| arrow().drawn(Mark::Head(Stroke::of_mode(mode).colour)))
    })
}

/// How much of a phase passes along an arrow.
const SOON: f64 = 0.03;

/// What differs by less than this part of it is equal: its digits are those of rounding.
pub(crate) const NOISE: f64 = 1e-9;

/// The lowest and the highest of some values, a share of the span added on either side.
pub(crate) fn bounds(values: impl IntoIterator<Item = f64>, share: f64) -> [f64; 2] {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values.into_iter().filter(|value| value.is_finite()) {
        low = low.min(value);
        high = high.max(value);
    }
    if low > high {
        return [-1.0, 1.0];
    }
    let size = f64::max(low.abs(), high.abs());
    let pad = if high - low > NOISE * size {
        share * (high - low)
    } else {
        f64::max(0.5 * share, 1e-3 * size)
    };
    [low - pad, high + pad]
}
