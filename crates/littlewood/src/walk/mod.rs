//! The transitions between modes: the consistent motion at a state, the event that ends it, and the
//! outcome of the motion.

pub(crate) mod automaton;
pub(crate) mod candidates;
pub(crate) mod exact;
pub(crate) mod follow;
pub(crate) mod origin;
pub(crate) mod outcome;
pub(crate) mod proofs;
pub(crate) mod resisted;
pub(crate) mod sequence;
pub(crate) mod slip;
pub(crate) mod solver;

pub(crate) use self::automaton::{Cause, Event, Transition};
pub(crate) use self::candidates::{Arrival, Candidates, NextMotion};
pub(crate) use self::exact::Exact;
pub(crate) use self::follow::{WalkSettings, walk};
pub(crate) use self::origin::{Origin, RelativeStart};
pub(crate) use self::outcome::{Outcome, OutcomeKind};
pub(crate) use self::proofs::{Proofs, SharedProofData, is_same};
pub(crate) use self::resisted::{Held, ResistedMotion, StateDifference, next_motion_near};
pub(crate) use self::sequence::PhaseSequence;
pub(crate) use self::slip::LastSlip;
pub(crate) use self::solver::{
    PhaseDetail, PhaseEnd, PhaseRecord, PhaseResult, Recorder, Solution, Solver,
};
