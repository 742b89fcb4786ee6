//! The jump out of a slide, which is the same for all hoops: the angle by which the hoop turns in
//! the air, and that at which the gap is largest, are functions of the angle of the lift-off alone
//! (docs/theory/jumps.md).

use std::sync::LazyLock;

use crate::ablation::{Part, is_on};
use crate::math::trig::{Angle, without_turns};
use crate::model::{Heavy, State};
use crate::modes::flight::sine_follows_from_rate;
use crate::modes::{Flight, FlightExtent, TakeOff};

use super::error_bound::is_out_of_range;
use super::interpolant::{Basis, Interpolant, Tolerance};

/// From this angle on the time in the air jumps up: C/S has a point of inflection there, where tan
/// φ/2 = φ/2.
const SINGULAR_ANGLE: f64 = 1.351_816_804_319_27;

/// Lift-offs farther from the top are solved one by one.
const MAX_LIFT_OFF_ANGLE: f64 = 1.34;

/// Nearer to the top, too, since the ratios that are interpolated end there.
const MIN_LIFT_OFF_ANGLE: f64 = 1e-6;

/// Width of a piece in units of its distance from the singular angle.
const RELATIVE_PIECE_WIDTH: f64 = 0.2;

/// Angles of the landing and of the largest gap, over the angle from the top at the lift-off, in
/// pieces.
static JUMPS: LazyLock<Option<Vec<Interpolant<2>>>> = LazyLock::new(|| {
    // Any body will do: the inertia and the mass do not matter, and h is a factor.
    let body = Heavy {
        mass: 1.0,
        h: 1.0,
        offset: 1.0,
        inertia: 1.0,
        tilt: -0.0,
    };
    let basis = Basis::new();
    let mut pieces = Vec::new();
    let mut left = 0.0;
    while left < MAX_LIFT_OFF_ANGLE {
        let right = left + RELATIVE_PIECE_WIDTH * (SINGULAR_ANGLE - left);
        let values = basis.nodes(left, right).map(|angle| {
            let (sin, cos) = libm::sincos(angle);
            let theta_rate = 1.0 / (body.h * cos).sqrt();
            let start = State {
                time: 0.0,
                theta: -angle,
                theta_rate,
                slip: 0.0,
                x: 0.0,
            };
            let lift_off = Angle { sin: -sin, cos };
            let extent = Flight::at_angle(&body, start, TakeOff::Grazing, lift_off).extent();
            [extent.landing, extent.apex].map(|phi| phi / angle)
        });
        pieces.push(basis.through(left, right, &values, &[Tolerance::ROUNDING; 2])?);
        left = right;
    }
    Some(pieces)
});

/// Angles of the landing and of the largest gap of the jump out of a slide, from the angle of the
/// lift-off in the direction of rotation, its sine and cosine, and what rounding has left of h cos
/// θ θ′² − 1. None where it has to be solved.
pub(super) fn extent(theta: f64, lift_off: Angle, opening: f64) -> Option<FlightExtent> {
    if is_out_of_range(theta) || !is_on(Part::Jumps) {
        return None;
    }
    let angle = -without_turns(theta);
    let sine_is_better = sine_follows_from_rate(theta, lift_off);
    from_table(if sine_is_better {
        angle - opening * lift_off.cos / lift_off.sin
    } else {
        angle
    })
}

fn from_table(angle: f64) -> Option<FlightExtent> {
    if !(MIN_LIFT_OFF_ANGLE..MAX_LIFT_OFF_ANGLE).contains(&angle) {
        return None;
    }
    let pieces = JUMPS.as_ref()?;
    let index = pieces.partition_point(|piece| piece.right < angle);
    let [landing, apex] = pieces.get(index)?.at(angle).map(|ratio| ratio * angle);
    Some(FlightExtent { landing, apex })
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    /// −tan θ0 from the angle of the landing, and from that of the largest gap.
    fn slopes(landing: f64, apex: f64) -> (f64, f64) {
        let versine = 2.0 * libm::sin(0.5 * landing) * libm::sin(0.5 * landing);
        let closed = (0.5 * landing * landing - versine) / (landing - libm::sin(landing));
        let half = libm::sin(0.5 * apex);
        (closed, (apex - libm::sin(apex)) / (2.0 * half * half))
    }

    #[test]
    fn the_angles_solve_the_equations_of_the_gap() {
        for k in 1..268 {
            let angle = 0.005 * f64::from(k);
            let FlightExtent { landing, apex } = from_table(angle).expect("within the table");
            let (closed, highest) = slopes(landing, apex);
            let slope = libm::tan(angle);
            // The subtraction φ − sin φ keeps ε/φ² of its digits.
            let tolerance = 4e-16 * (8.0 + 60.0 / (apex * apex));
            assert!(
                (closed / slope - 1.0).abs() < tolerance,
                "{angle}: {closed} {slope}"
            );
            assert!(
                (highest / slope - 1.0).abs() < tolerance,
                "{angle}: {highest} {slope}"
            );
        }
        let FlightExtent { landing, apex } = from_table(2e-6).expect("within the table");
        assert!((landing / 8e-6 - 1.0).abs() < 1e-11 && (apex / 6e-6 - 1.0).abs() < 1e-11);
    }

    /// Far from the first turn, too, the turns are taken off to the last digits. Lift-offs at other
    /// angles are solved.
    #[test]
    fn angles_of_any_turn_are_those_of_the_solved_flight() {
        let body = Heavy {
            mass: 1.0,
            h: 0.5,
            offset: 0.5,
            inertia: 1.0,
            tilt: -0.0,
        };
        let of = |theta: f64| {
            let direction = Angle::of(theta);
            let theta_rate = 1.0 / (body.h * direction.cos).sqrt();
            let opening = body.h * direction.cos * (theta_rate * theta_rate) - 1.0;
            let start = State {
                time: 0.0,
                theta,
                theta_rate,
                slip: 0.0,
                x: 0.0,
            };
            let flight = Flight::at_angle(&body, start, TakeOff::Grazing, direction);
            (extent(theta, direction, opening), flight.extent())
        };
        for turns in [-350_000.0, -40.0, -1.0, 0.0, 1.0, 100.0, 350_000.0] {
            for angle in [1e-3, 0.1, 0.7, 1.2, 1.33] {
                let (ours, solved) = of(TAU * turns - angle);
                let ours = ours.expect("within the table");
                // What is left of h cos θ θ′² − 1 is known to ε, and moves the angle by that over tan θ.
                let tolerance = 1e-12 + 4.0 * f64::EPSILON / (angle * angle);
                for (a, b) in [(ours.landing, solved.landing), (ours.apex, solved.apex)] {
                    assert!((a / b - 1.0).abs() < tolerance, "{turns} {angle}: {a} {b}");
                }
            }
        }
        for theta in [
            TAU * 360_000.0 - 0.7,
            -TAU * 360_000.0 - 0.7,
            -1.3401,
            -1e-7,
        ] {
            assert!(of(theta).0.is_none(), "{theta}");
        }
        assert!(
            [-0.5, f64::NAN]
                .into_iter()
                .all(|it| from_table(it).is_none())
        );
    }
}
