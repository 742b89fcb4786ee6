//! The conditions of the events that end phases.

use crate::math::number::{Dual, Number};
use crate::mechanics::contact;
use crate::model::{Heavy, RotationDirection, State};
use crate::walk::Cause;

use super::flow::{Motion, PhaseInstant, Plane};
use super::{Derivative, NoDerivative};

/// The rounding of a condition of some tens of operations, relative to the size of its terms.
pub(super) const GRAZING: f64 = 64.0 * f64::EPSILON;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event {
    /// μs N − |F| = 0 of rolling.
    Slip,
    /// N = 0 of rolling.
    Unloaded,
    /// η′ = 0.
    Rest,
    /// θ′ = 0.
    TurningPoint,
    /// 1 − h cos θ θ′² = 0.
    LiftOff,
    /// The gap closes.
    Landing,
}

impl Event {
    pub(super) fn of(cause: Cause, end: &State) -> Derivative<Self> {
        match cause {
            Cause::Slip => Ok(Self::Slip),
            Cause::NormalForceZero => Ok(Self::Unloaded),
            Cause::Stick | Cause::Reversal => Ok(Self::Rest),
            Cause::TurningPoint => Ok(Self::TurningPoint),
            // A slide that stops where the normal force vanishes.
            Cause::LiftOff if end.slip == 0.0 => Ok(Self::Rest),
            Cause::LiftOff => Ok(Self::LiftOff),
            Cause::Landing => Ok(Self::Landing),
            Cause::Graze => Err(NoDerivative::Grazing),
            Cause::ParticleAtPlane
            | Cause::ParticleAtBottom
            | Cause::ParticleAtTop
            | Cause::Singularity
            | Cause::Settle
            | Cause::Jam => Err(NoDerivative::Singular),
        }
    }

    /// The quantity that vanishes at the event.
    pub(super) fn condition<T: Number>(
        self,
        plane: &Plane<T>,
        motion: &Motion<T>,
        instant: &PhaseInstant<T>,
    ) -> T {
        let PhaseInstant { point: at, elapsed } = instant;
        let angle = at.theta.angle();
        let u = at.rate * at.rate;
        let forces = || {
            let rotation = match motion {
                Motion::Rolls(Some(rotation)) => Some(*rotation),
                Motion::Rolls(None)
                | Motion::Slides(..)
                | Motion::Skids(_)
                | Motion::Rests
                | Motion::Glides
                | Motion::Flies(_) => RotationDirection::of_sign(at.rate.value()),
            };
            plane.rolling(rotation).forces(angle, u)
        };
        match (self, motion) {
            (Self::Slip, _) => plane.friction.mu_s * forces().normal - forces().friction.abs(),
            (Self::Unloaded, _) => forces().normal,
            (Self::Landing, Motion::Flies(flight)) => plane.gap(flight, T::constant(*elapsed)).0,
            (Self::Rest | Self::Landing, _) => at.slip,
            (Self::TurningPoint, _) => at.rate,
            (Self::LiftOff, _) => contact(1.0, plane.body.h, angle.cos * u),
        }
    }

    /// The size of the terms of the condition.
    pub(super) fn size(
        self,
        plane: &Plane<Dual>,
        motion: &Motion<Dual>,
        instant: &PhaseInstant<Dual>,
    ) -> f64 {
        let PhaseInstant { point: at, elapsed } = *instant;
        let Heavy { mass, h, .. } = plane.body;
        let rate = at.rate.value.abs();
        let weight = 1.0 + h.value * rate * rate;
        match (self, motion) {
            (Self::Landing, Motion::Flies(flight)) => {
                let turned = (flight.point.rate.value * elapsed).abs();
                elapsed * flight.gap_rate.value + h.value * turned * turned * turned.min(1.0)
            }
            (Self::Slip, _) => (1.0 + plane.friction.mu_s.value) * mass.value * weight,
            (Self::Unloaded, _) => mass.value * weight,
            (Self::Rest | Self::Landing, _) => {
                (1.0 + h.value) * rate + plane.friction.mu_k.value * elapsed
            }
            (Self::LiftOff, _) => weight,
            (Self::TurningPoint, _) => rate + elapsed,
        }
    }
}
