//! Names of the columns of tables and axes: those of the core.

use littlewood::{Quantity, SampleColumn};

pub(crate) const TIME: &str = SampleColumn::Time.name();
pub(crate) const THETA: &str = SampleColumn::Theta.name();
pub(crate) const THETA_RATE: &str = SampleColumn::ThetaRate.name();
pub(crate) const SLIP: &str = SampleColumn::Slip.name();
pub(crate) const X: &str = SampleColumn::X.name();
pub(crate) const NORMAL: &str = SampleColumn::Normal.name();
pub(crate) const FRICTION: &str = SampleColumn::Friction.name();
pub(crate) const ENERGY: &str = SampleColumn::Energy.name();
pub(crate) const MU_S: &str = Quantity::MuS.name();
pub(crate) const MU_K: &str = Quantity::MuK.name();

/// Impulses of an impact, as records of motions name them.
pub(crate) const NORMAL_IMPULSE: &str = "normal_impulse";
pub(crate) const FRICTION_IMPULSE: &str = "friction_impulse";

/// Columns of a curve in the plane (θ, θ′).
pub(crate) const PLANE: [&str; 2] = [THETA, THETA_RATE];
