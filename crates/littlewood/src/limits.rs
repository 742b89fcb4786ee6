//! Limits of a simulation.

use crate::error::{ParameterError, within};
use crate::proof::Proof;
use crate::quantity::{Bound, Quantity};
use crate::state::Start;

/// When to stop a motion that has not come to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Limits {
    /// Time τ at which to stop, if any. A motion that is proved to roll for ever is reported as such in any case.
    pub until: Option<f64>,
    /// Largest number of transitions. Light hoops on nearly smooth planes need it, whose friction takes off next to no energy,
    /// and e = 1, where bounces that slip, or on a plane without friction, do not end.
    pub transitions: usize,
    /// Which proofs end a motion that is not followed to a time limit.
    pub proof: Proof,
}

impl Default for Limits {
    fn default() -> Self {
        Self { until: None, transitions: 10_000, proof: Proof::default() }
    }
}

impl Limits {
    pub(crate) fn check(&self, start: &Start) -> Result<(), ParameterError> {
        if let Some(until) = self.until {
            Quantity::Until.check(until)?;
            within(Quantity::Until, until, Bound::AtLeast(Quantity::Time, start.time))?;
        }
        Ok(())
    }

    /// The proofs that end a motion: none where the states up to a time limit are wanted.
    pub(crate) const fn proof(&self) -> Proof {
        if self.until.is_some() { Proof::None } else { self.proof }
    }

    /// Stops at the time τ.
    #[must_use]
    pub fn until(time: f64) -> Self {
        Self::default().with_until(Some(time))
    }

    /// The same limits with a time limit, or without one.
    #[must_use]
    pub const fn with_until(self, until: Option<f64>) -> Self {
        Self { until, ..self }
    }

    /// The same limits with a largest number of transitions.
    #[must_use]
    pub const fn with_transitions(self, transitions: usize) -> Self {
        Self { transitions, ..self }
    }

    /// The same limits, ending a motion by these proofs.
    #[must_use]
    pub const fn with_proof(self, proof: Proof) -> Self {
        Self { proof, ..self }
    }
}
