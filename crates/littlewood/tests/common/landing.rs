//! The gap at a landing, from the printed start of the flight alone.

use littlewood::{Cause, Hoop, PhaseSolution, State, Trajectory};

use super::dd::Dd;

/// Height of the rim over the plane so long after the start of a flight, by a parabola and a cosine added up as they stand, and how
/// far it may be from zero at a landing.
///
/// The terms of the gap are rounded, each a few times; beyond a radian the whole terms, below what is left of them at the start.
/// The time is known to its last digits. Where sliding has lifted off, 1 = h cos θ0 θ′² holds to the last digits of θ0 and θ′.
pub(crate) fn gap(h: f64, start: &State, gap_rate: f64, time: f64) -> (f64, f64) {
    let (h_, rate_, time_) = (Dd::from(h), Dd::from(start.theta_rate), Dd::from(time));
    let angle = Dd::from(start.theta).without_turns();
    let ((sin0, cos0), (sin1, cos1)) = (angle.sincos(), (angle + rate_ * time_).sincos());
    let rise = Dd::from(gap_rate) - h_ * sin0 * rate_;
    let gap = rise * time_ - Dd::from(0.5) * time_ * time_ + h_ * (cos0 - cos1);
    let slope = rise.high - time + (h_ * sin1 * rate_).high;

    let (sin, cos) = (sin0.high.abs(), cos0.high.abs());
    let turned = (start.theta_rate * time).abs();
    let (even, odd) = if turned < 1.0 {
        (turned * turned * turned * turned / 24.0, turned * turned * turned / 6.0)
    } else {
        (2.0, 1.0 + turned)
    };
    // h cos θ0 θ′² − 1, the acceleration at the start, is a difference.
    let bend = if turned < 1.0 { h * cos * start.theta_rate * start.theta_rate } else { 0.0 };
    let terms = gap_rate * time + 0.5 * (1.0 + bend) * time * time + h * (cos * even + sin * odd);
    let lift_off = if gap_rate == 0.0 {
        let (versine, odd) = (0.5 * (turned * turned).min(4.0), odd);
        let by_angle = h * (cos * odd + sin * versine) * (1.0 + start.theta.abs());
        by_angle + h * turned * (cos * turned.min(1.0) + sin * versine)
    } else {
        0.0
    };
    // What sums of two doubles leave, of terms that cancel.
    let rest = 16.0 * f64::EPSILON * (gap_rate * time + time * time + h * (2.0 + turned));
    (gap.high, 4.0 * f64::EPSILON * (terms + lift_off + time * slope.abs() + rest))
}

/// Asserts that the rim is at the plane at each landing of a motion: how many there are.
#[track_caller]
pub(crate) fn check_landings(hoop: &Hoop, motion: &Trajectory) -> usize {
    let mut landings = 0;
    for phase in motion.phases() {
        let PhaseSolution::Flight(flight) = phase.solution() else { continue };
        if motion.end_of(phase).is_some_and(|end| end.cause == Cause::Landing) {
            let (gap, rounding) = gap(hoop.h(), &phase.start(), flight.take_off_rate(), flight.duration());
            assert!(gap.abs() <= rounding, "gap {gap:e} where {rounding:e} is rounding, at a landing: {phase:?}");
            landings += 1;
        }
    }
    landings
}
