//! Why a phase, or all up to a doubt, is left to the simulation.

use core::sync::atomic::{AtomicU64, Ordering};

use crate::model::named;

named! {
    /// Why the engine leaves a phase, or all up to a doubt, to the solvers of
    /// [`crate::Hoop::simulate`].
    pub enum Fallback, "reason of doubt" {
        /// The normal force next to zero at the end of a piece of a slide.
        Contact = 0, "contact";
        /// The slip velocity next to zero at the end of a piece, or where it is least.
        Slip = 1, "slip";
        /// The sign of the slip acceleration is not known on a piece.
        SlipShape = 2, "slip_shape";
        /// The slip velocity vanishes so slowly that the first integral does not tell when.
        SlowStop = 3, "slow_stop";
        /// Turning points of a slide next to each other, or next to the top.
        TurningPoint = 4, "turning_point";
        /// P next to zero (3.5).
        Pole = 5, "pole";
        /// An orbit next to the separatrix.
        Separatrix = 6, "near_separatrix";
        /// Rolling next to the limit of static friction where it begins.
        FrictionLimit = 7, "friction_limit";
        /// Rolling that slips next to a standstill, or from rest.
        Standstill = 8, "standstill";
        /// A phase of too many turns.
        TooLong = 9, "too_long";
        /// An angle of so many turns that its last digits are lost.
        Far = 10, "far";
        /// A normal force in which the terms cancel.
        Cancelled = 11, "cancelled";
        /// All phases before a decision by a number that is smaller than the drift of the state.
        Drift = 12, "drift";
    }
}

#[derive(Debug, Default)]
pub(super) struct FallbackCounts([AtomicU64; Fallback::ALL.len()]);

impl FallbackCounts {
    pub(super) fn add(&self, doubt: Fallback) {
        self.0[doubt as usize].fetch_add(1, Ordering::Relaxed);
    }

    pub(super) fn counts(&self) -> impl Iterator<Item = (Fallback, u64)> {
        Fallback::ALL
            .into_iter()
            .map(|doubt| (doubt, self.0[doubt as usize].load(Ordering::Relaxed)))
    }
}

impl Clone for FallbackCounts {
    fn clone(&self) -> Self {
        Self(core::array::from_fn(|i| {
            AtomicU64::new(self.0[i].load(Ordering::Relaxed))
        }))
    }
}
