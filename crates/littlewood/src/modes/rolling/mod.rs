//! Rolling (§2a, §3a): η′ = 0, held by static friction.
//!
//! θ′², θ″, N and F are functions of θ alone on an orbit, D(θ) (θ′² + 1) = K
//! (docs/theory/rolling.md). [`orbit`] gives the time as an elliptic integral, and [`boundary`] the
//! angle at which rolling ends as a root of a polynomial.

mod boundary;
mod grazing;
mod half_angle;
mod incline;
mod margin_series;
mod orbit;
mod recurrence;
mod rim;
mod start_limit;

pub use boundary::{RollingEnd, RollingLimit};
pub(crate) use boundary::{Stiction, margin_forms};
pub use grazing::GrazingOrbit;
pub(crate) use grazing::Levels;
pub(crate) use half_angle::{HalfAngleOrbit, OrbitEnergy, OrbitPass, ReducedAngle};
pub(crate) use margin_series::MarginSeries;
pub use orbit::RollingOrbit;
pub use recurrence::{Recurrence, RecurrenceKind};
pub(crate) use start_limit::{MasslessLimit, static_friction_holds};

use crate::mechanics::{Accelerations, Clearance, RollingLaw};
use crate::model::{Hoop, Mode, State};
use crate::modes::{Instant, Sample};

/// A phase of rolling: an orbit and the state at its start.
#[derive(Clone, Copy, Debug)]
pub struct Rolling {
    law: RollingLaw,
    orbit: RollingOrbit,
    start: State,
}

impl Rolling {
    pub(crate) fn new(hoop: &Hoop, start: State) -> Self {
        let start = State { slip: 0.0, ..start };
        Self {
            law: RollingLaw::of(hoop),
            orbit: RollingOrbit::of(hoop, start.theta, start.theta_rate),
            start,
        }
    }

    /// The orbit in the (θ, θ′) plane.
    pub const fn orbit(&self) -> &RollingOrbit {
        &self.orbit
    }

    /// State after the time `elapsed` since the phase began. The cost does not depend on `elapsed`.
    pub fn state(&self, elapsed: f64) -> State {
        if elapsed == 0.0 {
            return self.start;
        }
        let (theta, theta_rate) = self.orbit.position(elapsed);
        self.state_at(theta, theta_rate, elapsed)
    }

    /// Adds the position from the rolling constraint x + θ = const.
    pub(crate) fn state_at(&self, theta: f64, theta_rate: f64, elapsed: f64) -> State {
        State {
            time: self.start.time + elapsed,
            theta,
            theta_rate,
            slip: 0.0,
            x: self.start.x - (theta - self.start.theta),
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let instant = Instant {
            mode: Mode::Rolling,
            direction: None,
            accelerations: Accelerations {
                theta: self.law.theta_acceleration(state.theta, state.theta_rate),
                slip: 0.0,
            },
            forces: self.law.forces(state.theta, state.theta_rate),
            couple: 0.0,
            clearance: Clearance::NONE,
        };
        instant.sample(hoop, state)
    }
}
