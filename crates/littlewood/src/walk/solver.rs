//! What the loop over phases asks of a [`Solver`], and gives to a [`Recorder`].

use crate::mechanics::{Impact, Settling};
use crate::model::{Heavy, Hoop, Massless, Mode, SlipDirection, State, weight_of_slides};
use crate::modes::{Entry, GlideEntry, TakeOff};
use crate::walk::{Arrival, Cause, Event, NextMotion, Outcome, PhaseSequence, ResistedMotion};

/// Solves phases of motion, each from its start to the event that ends it, or to the time limit.
///
/// [`walk`](super::walk) calls [`Solver::next_motion`] at a point, and then the one method that
/// solves the selected phase from the same point. The loop alone names the cause of an event,
/// applies impacts and keeps the limits of transitions and slides; so two solvers can differ only
/// in the phases that they solve, and in the mode that they select.
///
/// A method that solves a phase promises that
/// - it ends at the first event after its start: `entry`, `take_off` and `on_limit` say which guards
///   vanish at the start, where they are no event;
/// - η′ is exactly 0 in rolling, and where a slide or a glide comes to rest;
/// - the end is not after [`Solver::until`]; a phase without an earlier event ends the motion, with
///   the state at that time;
/// - the result depends on the point and on the phases solved before it, not on the recorder.
///
/// All states are relative to the origin of the motion ([`Origin`](super::Origin)).
pub(crate) trait Solver {
    /// A state with the quantities that the solver derives from it.
    type Point;
    /// What a recorder may keep of a solved phase.
    type Solution: Solution;
    /// The outcome of a motion.
    type Outcome: From<Outcome>;

    /// Whether periods of a motion that repeats itself are skipped up to a time limit.
    const SKIPS_PERIODS: bool = false;

    fn hoop(&self) -> &Hoop;
    /// What a unit of the length of a slide counts.
    fn slide_weight(&self) -> f64 {
        weight_of_slides(self.hoop())
    }
    /// The time limit of the motion, or infinity.
    fn until(&self) -> f64;
    fn point(&self, state: State) -> Self::Point;
    /// The state of a point, as it was given to [`Solver::point`] or computed at the end of a phase.
    fn state(point: &Self::Point) -> &State;
    /// Selects the motion that begins at a point in contact. `arrival` decides where a guard
    /// vanishes, since the sign of its rounded value does not.
    fn next_motion(&self, point: &Self::Point, arrival: Arrival) -> NextMotion;
    /// `on_limit` if |F| = μs N at the start and static friction holds after it.
    fn roll(&self, point: &Self::Point, on_limit: bool) -> PhaseResult<Self>;
    /// `may_lift_off` unless energy excludes it, also where w = 0 by rounding.
    fn slide(
        &self,
        point: &Self::Point,
        body: &Heavy,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
    ) -> PhaseResult<Self>;
    /// A flight up to the next landing of the rim; the loop computes the impact.
    fn fly(&self, point: &Self::Point, body: &Heavy, take_off: TakeOff) -> PhaseResult<Self>;
    /// Infinitely many bounces, up to the time at which they accumulate.
    fn settle(&self, point: &Self::Point, body: &Heavy, settling: &Settling) -> PhaseResult<Self>;
    fn glide(&self, point: &Self::Point, body: &Massless, entry: GlideEntry) -> PhaseResult<Self>;
    /// A phase in contact with rolling resistance, after this number of half swings.
    fn resisted(
        &self,
        point: &Self::Point,
        body: &Heavy,
        motion: ResistedMotion,
        half_swings: usize,
    ) -> PhaseResult<Self>;
    /// The point at a state behind whole periods that are skipped. None if they must be solved.
    fn skip_to(&self, _end: State) -> Option<Self::Point> {
        None
    }
    /// Skips links of a chain of slips: from a slip out of rolling to a later one, within `budget`,
    /// if none of them provably leads to a grazing orbit. None if the phases must be solved one by
    /// one, which is always right.
    fn skip_links(
        &self,
        _slip: &Self::Point,
        _direction: SlipDirection,
        _budget: &SkipBudget<'_>,
    ) -> Option<SkippedLinks<Self::Point>> {
        None
    }
}

/// Limits of the links that may be skipped.
pub(crate) struct SkipBudget<'a> {
    pub(crate) transitions: u32,
    /// Cost of slides, as in [`Limits::slides`](crate::Limits::slides).
    pub(crate) slide_cost: f64,
    /// Whether to record the phases, at most as many as a sequence holds.
    pub(crate) record_phases: bool,
    /// If proofs examine each state: whether a state leaves the outcome open. Once decided, the
    /// outcome is decided in all later states.
    pub(crate) open: Option<&'a dyn Fn(&State) -> bool>,
}

/// Skipped links, from a slip out of rolling to a later one.
pub(crate) struct SkippedLinks<P> {
    /// Where the later slip begins, and its direction.
    pub(crate) point: P,
    pub(crate) direction: SlipDirection,
    pub(crate) transitions: u32,
    pub(crate) slide_cost: f64,
    pub(crate) phases: PhaseSequence,
}

/// What is kept of a solved phase.
pub(crate) trait Solution {
    /// The rate of the gap at the start of a flight; none of another phase.
    fn take_off_rate(&self) -> Option<f64>;
    /// The largest gap of a flight. Asked for only until one has landed.
    fn height(&self) -> f64;
    /// The range of the angle of a slide, where it is kept.
    fn theta_range(&self) -> Option<(f64, f64)> {
        None
    }
}

/// A solved phase.
pub(crate) struct PhaseResult<T: Solver + ?Sized> {
    pub(crate) solution: T::Solution,
    /// Direction of slip; for a glide from η′ = 0 it follows from the solution.
    pub(crate) direction: Option<SlipDirection>,
    pub(crate) end: PhaseEnd<T::Point, T::Outcome>,
}

/// How a phase ended.
pub(crate) enum PhaseEnd<P, O> {
    /// η′ = 0. The motion that follows tells a stick, a graze, a reversal and a lift-off apart.
    Rest { point: P, arrival: Arrival },
    /// Another event after which the motion continues without an impact.
    Event {
        point: P,
        cause: Cause,
        arrival: Arrival,
    },
    /// The landing of the rim.
    Landing { state: State, gap_rate: f64 },
    /// The end of infinitely many bounces.
    Settled {
        state: State,
        settling: Box<Settling>,
    },
    /// P = 0 in a slide, with the computed value of P.
    Singular { state: State, solvability: f64 },
    /// The end of the motion: `event` is its last transition, `end` the state at the end of the
    /// phase, if any.
    Motion {
        event: Option<(Cause, State)>,
        end: Option<State>,
        outcome: O,
    },
}

impl<P, O> PhaseEnd<P, O> {
    pub(crate) fn state(&self, of: impl Fn(&P) -> &State) -> Option<State> {
        match self {
            Self::Rest { point, .. } | Self::Event { point, .. } => Some(*of(point)),
            Self::Landing { state, .. }
            | Self::Settled { state, .. }
            | Self::Singular { state, .. } => Some(*state),
            Self::Motion { end, .. } => *end,
        }
    }
}

/// Records a motion, phase by phase.
///
/// Each phase is followed by the transition that ends it, if there is one. A transition to a glide
/// comes after the glide is solved, since its direction of slip follows from the solution.
pub(crate) trait Recorder<S> {
    fn phase(&mut self, phase: PhaseRecord, solution: S);
    /// Records an event, with its impact and the direction of slip of the motion that begins. It
    /// ends the last phase if its `from` is a mode.
    fn transition(
        &mut self,
        event: &Event,
        impact: Option<&Impact>,
        direction: Option<SlipDirection>,
    );
    /// Links are skipped only if no solutions are needed.
    fn detail(&self) -> PhaseDetail {
        PhaseDetail::Solutions
    }
    /// Number of half swings with rolling resistance so far, where they are counted.
    fn half_swings(&self) -> usize {
        0
    }
    /// Records skipped links: the number of transitions, and the phases at the current detail.
    fn links(&mut self, _transitions: u32, _phases: PhaseSequence) {}
}

/// What a recorder needs to know of each phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PhaseDetail {
    Solutions,
    /// Modes and directions of slip.
    Modes,
    /// The number of transitions only.
    Number,
}

/// A phase as passed to a recorder; `end` is `None` if the phase never ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhaseRecord {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<SlipDirection>,
    pub(crate) start: State,
    pub(crate) end: Option<State>,
}

impl PhaseRecord {
    /// Whether the hoop rolls from a turning point: to the next one it is a half swing.
    pub(crate) fn swings(&self) -> bool {
        self.mode == Mode::Rolling && self.start.theta_rate == 0.0
    }
}
