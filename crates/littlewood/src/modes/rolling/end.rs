//! How rolling ends, and whether it can begin.

use crate::model::mode::Direction;

use super::boundary::RollingLimit;

/// The end of rolling: where and when static friction or the normal force gives way.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RollingEnd {
    /// Time since the orbit was entered.
    pub elapsed: f64,
    /// Angle.
    pub theta: f64,
    /// Rate.
    pub theta_rate: f64,
    /// What gives way.
    pub limit: RollingLimit,
}

/// Whether static friction can sustain rolling at a state with η′ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Hold {
    /// Rolling holds, now and for some time.
    Holds,
    /// The friction demand exceeds μs N by `excess` ≥ 0; zero on the boundary, when the orbit leaves 𝓡.
    Slips { direction: Direction, excess: f64 },
    /// N would have to be negative, or vanishes and would become so.
    NoNormalForce,
}

/// A limit seen in the frame of the body instead of the direction of motion.
pub(super) fn turned(limit: RollingLimit, travel: f64) -> RollingLimit {
    match limit {
        RollingLimit::Friction(direction) if travel < 0.0 => RollingLimit::Friction(direction.reversed()),
        other => other,
    }
}
