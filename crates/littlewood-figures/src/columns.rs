//! Names of the columns of tables and axes: those of the core.

use std::borrow::Cow;

use littlewood::tables::{Dimension, Quantity, SampleColumn};

pub(crate) const TIME: &str = SampleColumn::Time.name();
pub(crate) const THETA: &str = SampleColumn::Theta.name();
pub(crate) const THETA_RATE: &str = SampleColumn::ThetaRate.name();
pub(crate) const SLIP: &str = SampleColumn::Slip.name();
pub(crate) const X: &str = SampleColumn::X.name();
pub(crate) const NORMAL: &str = SampleColumn::Normal.name();
pub(crate) const FRICTION: &str = SampleColumn::Friction.name();
pub(crate) const COUPLE: &str = SampleColumn::Couple.name();
pub(crate) const ENERGY: &str = SampleColumn::Energy.name();
pub(crate) const MU_S: &str = Quantity::MuS.name();
pub(crate) const MU_K: &str = Quantity::MuK.name();

/// Impulses of an impact, as records of motions name them.
pub(crate) const NORMAL_IMPULSE: &str = "normal_impulse";
pub(crate) const FRICTION_IMPULSE: &str = "friction_impulse";

/// Either of them against time.
pub(crate) const IMPULSE: &str = "impulse";

/// Columns of a curve in the plane (θ, θ′).
pub(crate) const PLANE: [&str; 2] = [THETA, THETA_RATE];
/// Those of an orbit, which has an energy.
pub(crate) const ORBIT: [&str; 3] = [THETA, THETA_RATE, ENERGY];

/// The coordinates of a point, which may be that of the centre, the mass centre or the particle.
pub(crate) const Y: &str = "y";
/// An energy, less what it was at the start.
pub(crate) const ENERGY_CHANGE: &str = "energy_change";
/// What a motion has lost.
pub(crate) const LOST: &str = "energy_lost";
/// |F|/N.
pub(crate) const DEMAND: &str = "demand";
/// The constant of gliding, an energy of the particle.
pub(crate) const W: &str = "w";
/// The logarithm of a rate of the gap.
pub(crate) const LOG_GAP_RATE: &str = "log10_gap_rate";

/// Dimension of the numbers of a column; a ratio, if they are counts or codes.
pub(crate) fn dimension(column: &str) -> Dimension {
    let own = match column {
        Y => Some(Dimension::Length),
        W | LOST | ENERGY_CHANGE => Some(Dimension::Energy),
        IMPULSE | NORMAL_IMPULSE | FRICTION_IMPULSE => Some(Dimension::Impulse),
        _ => None,
    };
    let of_sample = || column.parse().ok().and_then(SampleColumn::dimension);
    let of_quantity = || column.parse().ok().map(Quantity::dimension);
    own.or_else(of_sample)
        .or_else(of_quantity)
        .unwrap_or(Dimension::Ratio)
}

/// Name of a column in SI units.
pub(crate) fn si_name(column: &str) -> Cow<'static, str> {
    if let Some(twin) = column.parse().ok().and_then(Quantity::si_twin) {
        return Cow::Borrowed(twin.name());
    }
    Cow::Owned(format!("{column}{}", dimension(column).si_suffix()))
}
