//! A motion as series: one piece for each phase of a mode.

use core::f64::consts::TAU;
use core::ops::Deref;

use littlewood::tables::Dimension;
use littlewood::{Hoop, Mode, OutcomeKind, Phase, Sample, Trajectory, Transition};
use littlewood_draw::{Entries, HoopShape, Layer, Mark, Piece, Series, Stroke, short};
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

/// Fewest instants by which a curve that changes within a turn is seen.
const INSTANTS_OF_A_TURN: f64 = 6.0;

/// How much of a phase passes along an arrow of time.
const SOON: f64 = 0.03;

/// What differs by less than this part of it is equal: its digits are those of rounding.
pub(crate) const NOISE: f64 = 1e-9;

/// A motion as far as figures show it.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    motion: Trajectory,
    /// When they stop.
    pub(crate) until: f64,
    pub(crate) say: Wording,
}

impl Deref for Shown {
    type Target = Trajectory;

    fn deref(&self) -> &Trajectory {
        &self.motion
    }
}

impl Shown {
    pub(crate) fn new(motion: Trajectory, say: Wording) -> Self {
        let until = horizon(&motion);
        Self { motion, until, say }
    }

    /// The same, stopped at another time.
    pub(crate) fn up_to(&self, until: f64) -> Self {
        Self {
            until,
            ..self.clone()
        }
    }

    /// From the start to where figures stop.
    pub(crate) fn times(&self) -> [f64; 2] {
        [self.start().time, self.until]
    }

    /// Whether it continues after a landing.
    pub(crate) fn goes_on(&self) -> bool {
        self.hoop().restitution().is_some()
    }

    /// The transitions that are shown.
    pub(crate) fn passed(&self) -> impl Iterator<Item = &Transition> {
        let transitions = self.transitions().iter();
        transitions.filter(|transition| transition.time() <= self.until)
    }

    /// The instants of a phase at which its rate is finite, evenly spaced.
    pub(crate) fn instants(&self, phase: &Phase) -> Vec<Sample> {
        let mut samples = self.all_instants(phase);
        samples.retain(|sample| sample.state.theta_rate.is_finite());
        samples
    }

    /// The instants of a phase, its last one among them.
    pub(crate) fn all_instants(&self, phase: &Phase) -> Vec<Sample> {
        let duration = f64::min(phase.duration(), self.until - phase.start().time);
        if duration <= 0.0 {
            return Vec::new();
        }
        let share = duration / (self.until - self.start().time);
        let of_all = |all: f64| (libm::ceil(all * share) as u32).clamp(FEWEST_INSTANTS, INSTANTS);
        let intervals = if self.goes_on() {
            of_all(INSTANTS_IN_ALL)
        } else if self.phases().len() > CROWD {
            of_all(INSTANTS_OF_A_CROWD)
        } else {
            INSTANTS
        };
        (0..=intervals)
            .map(|i| phase.sample(duration * f64::from(i) / f64::from(intervals)))
            .collect()
    }

    /// What a figure notes of a motion of which only the beginning is shown.
    pub(crate) fn remark(&self) -> Option<String> {
        let (all, shown) = (self.transitions().len(), self.passed().count());
        let at = self.say.value(self.until, Dimension::Time);
        let time = self.say.time();
        let end = self
            .phases()
            .last()
            .map(|phase| (phase.mode(), phase.start().time));
        let rests = match end {
            Some((Mode::Rest, since)) => {
                format!(
                    " The hoop rests at {time} = {}.",
                    self.say.value(since, Dimension::Time)
                )
            }
            _ => String::new(),
        };
        (shown < all).then(|| {
            format!("Shown is the beginning, to {time} = {at}, with {shown} of {all} transitions.{rests}")
        })
    }

    /// What a figure notes of a motion whose turns are finer than its instants.
    pub(crate) fn finer(&self) -> Option<String> {
        let turns = self.phases().iter().filter_map(|phase| {
            let samples = self.instants(phase);
            let [from, to] = [samples.first()?, samples.last()?].map(|it| it.state.theta);
            let turns = ((to - from) / TAU).abs();
            (turns * INSTANTS_OF_A_TURN > samples.len() as f64).then_some(turns)
        });
        let turns = turns.fold(0.0, f64::max);
        (turns > 0.0).then(|| {
            let turns = short(libm::floor(turns));
            format!(
                "What changes within a turn is finer than drawn: up to {turns} turns in one phase."
            )
        })
    }

    /// The modes of a motion, each with the series of its phases.
    pub(crate) fn by_mode<const N: usize>(
        &self,
        prefix: &str,
        columns: &[&'static str; N],
        row: impl Fn(&Sample) -> [f64; N],
    ) -> Modes {
        let of_mode = |mode: Mode| {
            let phases = self
                .phases()
                .iter()
                .filter(|phase| phase.mode() == mode && phase.start().time <= self.until);
            let pieces: Vec<Vec<[f64; N]>> = phases
                .map(|phase| self.instants(phase).iter().map(&row).collect())
                .collect();
            let series = || Series::new(format!("{prefix}{mode}"), columns, pieces.clone());
            (!pieces.is_empty()).then(|| (mode, series()))
        };
        Modes(Mode::ALL.into_iter().filter_map(of_mode).collect())
    }

    /// Arrows of time, those that are seen: from a place on each phase that is shown, by its row,
    /// to one a little later.
    pub(crate) fn arrows<const N: usize>(
        &self,
        share: f64,
        columns: &[&'static str; N],
        row: impl Fn(&Sample) -> [f64; N],
        is_seen: impl Fn(Mode, &[[f64; N]; 2]) -> bool,
    ) -> impl Iterator<Item = Layer> {
        self.phases().iter().filter_map(move |phase| {
            let mode = phase.mode();
            let duration = f64::min(phase.duration(), self.until - phase.start().time);
            let at = |share: f64| row(&phase.sample(share * duration));
            let rows = (duration > 0.0).then(|| [at(share), at(share + SOON)])?;
            let is_drawn =
                rows.iter().flatten().all(|value| value.is_finite()) && is_seen(mode, &rows);
            let arrow = || Series::of_rows("arrow of time", columns, rows);
            is_drawn.then(|| arrow().drawn(Mark::Head(Stroke::of_mode(mode).colour)))
        })
    }
}

/// The modes of a motion, each with the series of its phases.
#[derive(Clone, Debug)]
pub(crate) struct Modes(pub(crate) Vec<(Mode, Series)>);

impl Modes {
    /// All rows.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.0.iter().flat_map(|(_, series)| series.rows())
    }

    /// Adds the end of a motion, if its rate has no bound there: a glide that ends at the plane.
    /// Its line then says that it has no greatest rate.
    pub(crate) fn add_unbounded_end<const N: usize>(
        &mut self,
        motion: &Shown,
        row: impl Fn(&Sample) -> [f64; N],
    ) {
        let Some(phase) = motion.phases().last() else {
            return;
        };
        let samples = motion.all_instants(phase);
        let end = samples
            .last()
            .filter(|end| end.state.theta_rate.is_infinite());
        let own = self.0.iter_mut().find(|(mode, _)| *mode == phase.mode());
        if let (Some(end), Some((_, series))) = (end, own)
            && let Some(piece) = series.pieces.last_mut()
        {
            piece.push(row(end).to_vec());
        }
    }

    /// Lines, so wide.
    pub(crate) fn lines(self, width: f64) -> impl Iterator<Item = Layer> {
        let line =
            move |(mode, series): (Mode, Series)| series.drawn(Stroke::of_mode(mode).wide(width));
        self.0.into_iter().map(line)
    }

    /// What they mean.
    pub(crate) fn entries(&self, words: impl Fn(Mode) -> String) -> Entries {
        let modes = self.0.iter().map(|(mode, _)| *mode);
        modes
            .map(|mode| (Stroke::of_mode(mode).wide(BOLD).into(), words(mode)))
            .collect()
    }
}

/// Where the figures of a motion stop: at its end; where it has none, or was stopped, a few turns
/// after the last phase has begun, or a while after it has come to rest. A motion that goes on after its landings has more to show before
/// its last phase, of which a turn is enough.
fn horizon(motion: &Trajectory) -> f64 {
    let (end, goes_on) = (motion.end_time(), motion.hoop().restitution().is_some());
    let Some(last) = motion.phases().last() else {
        return end;
    };
    let cut = if goes_on {
        bouncing(motion)
    } else {
        crowded(motion)
    };
    if let Some(time) = cut {
        return time;
    }
    if let Some(until) = motion.rest_shown_until() {
        return f64::min(end, until);
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
    let last = motion.transitions().get(TRANSITIONS);
    last.filter(|_| is_stopped).map(Transition::time)
}

/// Until when a motion of very many transitions is shown that ends in none.
fn crowded(motion: &Trajectory) -> Option<f64> {
    let transitions = motion.transitions();
    let is_event = transitions.last().is_some_and(|last| last.to.is_none());
    (transitions.len() > CROWD && !is_event).then(|| transitions[SHOWN].time())
}

/// The hoop at some instants.
pub(crate) fn hoops<'a>(
    hoop: &Hoop,
    samples: impl Iterator<Item = &'a Sample>,
    name: impl Into<String>,
    rim: Stroke,
) -> Layer {
    let row = |Sample { state, centre, .. }: &Sample| [state.time, centre.x, centre.y, state.theta];
    let mark = Mark::Hoop(HoopShape {
        offset: hoop.offset(),
        h: hoop.h(),
        radius: 1.0,
        rim,
    });
    Series::of_rows(name, &[TIME, X, Y, THETA], samples.map(row)).drawn(mark)
}

/// The rows of some samples that are finite.
pub(crate) fn finite_rows<const N: usize>(rows: impl Iterator<Item = [f64; N]>) -> Piece {
    rows.filter(|row| row.iter().all(|value| value.is_finite()))
        .map(Vec::from)
        .collect()
}

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
