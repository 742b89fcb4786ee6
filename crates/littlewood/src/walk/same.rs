//! When two numbers of a conservative motion are the same but for rounding.

use core::f64::consts::TAU;

/// What rounding may have moved a number by, relative to one plus its size.
const ROUNDING: f64 = 1e-9;

/// Whether two rates are the same.
pub(crate) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * (1.0 + a.abs())
}

/// Whether two angles, of which the first may be the larger by many turns, are the same direction.
pub(crate) fn is_same_direction(a: f64, b: f64) -> bool {
    let turns = ((a - b) / TAU).round();
    (a - b - turns * TAU).abs() <= ROUNDING * (1.0 + a.abs())
}
