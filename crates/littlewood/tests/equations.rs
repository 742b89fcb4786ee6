//! The equations of the paper, as printed, against those the library evaluates; and every solution
//! against its equation of motion by finite differences.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::common::{heavy_hoop, heavy_motion, instants, massless_hoop, simulate, start};
use littlewood::modes::{PhaseSolution, RollingOrbit};
use littlewood::theory::{
    Body, ContactForces, PhasePlane, RollingLaw, SlidingLaw, Window, gliding_accelerations,
};
use littlewood::{Hoop, HoopParameters, RotationDirection, SlipDirection, Start};
use proptest::prelude::*;

fn inertia(hoop: &Hoop) -> f64 {
    hoop.body().inertia_about_mass_centre()
}

proptest! {
    /// (2.8) of the disc and of the particle apart, each with its own velocity.
    #[test]
    fn the_energy_of_a_start_is_that_of_its_two_bodies(hoop in heavy_hoop(), start in start(), gap_rate in prop_oneof![Just(0.0), 0.0..3.0_f64]) {
        let start = start.with_gap_rate(gap_rate);
        let HoopParameters { mass_ratio, offset, inertia, .. } = hoop.parameters();
        let (sin, cos) = libm::sincos(start.theta);
        let disc = (start.slip - start.theta_rate, gap_rate);
        let particle = (disc.0 - offset * cos * start.theta_rate, disc.1 - offset * sin * start.theta_rate);
        let square = |(x, y): (f64, f64)| x * x + y * y;
        let terms = [
            0.5 * mass_ratio * square(disc), 0.5 * inertia * start.theta_rate * start.theta_rate,
            0.5 * square(particle), offset * cos,
        ];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let expected: f64 = terms.iter().sum();
        let found = hoop.energy_of(&start);
        prop_assert!((found - expected).abs() < 1e-13 * (1.0 + size), "{found} {expected}");
    }

    /// (2.11), (2.12) term by term.
    #[test]
    fn rolling_is_that_of_2_11_and_2_12(hoop in heavy_hoop(), start in start()) {
        let (m, h, l) = (hoop.mass(), hoop.h(), hoop.offset());
        let (s, c, w) = (start.theta.sin(), start.theta.cos(), start.theta_rate);
        let f = (m * h * s * w * w + l * s) / (inertia(&hoop) + m * (1.0 + h * h + 2.0 * h * c));
        let normal = m - l * (s * f + c * w * w);
        let friction = -m * (1.0 + h * c) * f + l * s * w * w;
        let law = RollingLaw::new(&hoop);
        let forces = law.forces(start.theta, w);
        // For a light hoop D cancels near the bottom in the printed form.
        let size = 1e-14 * (1.0 + w * w) * (m + l * m / law.denominator(start.theta));
        prop_assert!((law.theta_acceleration(start.theta, w) - f).abs() < 10.0 * size * (1.0 + 1.0 / law.denominator(start.theta)));
        prop_assert!((forces.normal - normal).abs() < 10.0 * size * (1.0 + 1.0 / law.denominator(start.theta)));
        prop_assert!((forces.friction - friction).abs() < 10.0 * size * (1.0 + 1.0 / law.denominator(start.theta)));
    }

    /// The matrix equation (2.16), (2.17), multiplied out: M (η″, θ″) + … = ….
    #[test]
    fn sliding_satisfies_2_16_and_2_17(hoop in heavy_hoop(), start in start(), positive in any::<bool>()) {
        let direction = if positive { SlipDirection::Positive } else { SlipDirection::Negative };
        let law = SlidingLaw::new(&hoop, direction, RotationDirection::Positive).expect("a heavy hoop");
        prop_assume!(law.painleve(start.theta).abs() > 1e-9);
        let found = law.accelerations(start.theta, start.theta_rate);
        let (m, h, l, sign) = (hoop.mass(), hoop.h(), hoop.offset(), direction.sign());
        let (s, c, w) = (start.theta.sin(), start.theta.cos(), start.theta_rate);
        let matrix = [
            [m, -m * (1.0 + h * c) - hoop.mu_k() * l * s * sign],
            [-m * (1.0 + h * c), inertia(&hoop) + m * (1.0 + h * h + 2.0 * h * c)],
        ];
        let inertial = [m * h * s * w * w, -m * h * s * w * w];
        let right = [-hoop.mu_k() * (m - l * c * w * w) * sign, l * s];
        for row in 0..2 {
            let terms = [matrix[row][0] * found.slip, matrix[row][1] * found.theta, inertial[row], -right[row]];
            // The entries of M are sums that cancel near the bottom.
            let size = terms.iter().map(|term| term.abs()).sum::<f64>() + 4.0 * m * found.theta.abs();
            let residual: f64 = terms.iter().sum();
            prop_assert!(residual.abs() <= 1e-13 * (size + m * w * w), "row {row}: {residual:e} of {size:e}");
        }
        // (2.18): N from the accelerations, and (2.15).
        let forces = law.forces(start.theta, w);
        let normal = m - l * (s * found.theta + c * w * w);
        prop_assert!((forces.normal - normal).abs() < 1e-13 * (m + l * (found.theta.abs() + w * w)));
        prop_assert_eq!(forces.friction, -hoop.mu_k() * sign * forces.normal);
    }

    /// (3.17), extended to ℓ̂ ≤ 1 by footnote 7: vertical free fall, and horizontal momentum.
    #[test]
    fn gliding_satisfies_3_17(hoop in massless_hoop(), theta in 0.01..3.1_f64, w in -3.0..3.0_f64) {
        let Body::Massless(body) = hoop.body() else { unreachable!() };
        let (s, c, l) = (theta.sin(), theta.cos(), body.offset);
        let (theta_acceleration, slip_acceleration) = gliding_accelerations(&body, theta, w);
        let size = (1.0 + w * w) / (l * s);
        prop_assert!((l * (s * theta_acceleration + c * w * w) - 1.0).abs() < 1e-14 * (1.0 + w * w));
        let momentum = slip_acceleration - (1.0 + l * c) * theta_acceleration + l * s * w * w;
        prop_assert!(momentum.abs() < 1e-14 * size);
        if l == 1.0 {
            let printed = (1.0 - w * w) * s / (1.0 - c);
            // 1 − cos θ cancels near the top in the printed form.
            prop_assert!((slip_acceleration - printed).abs() < 1e-14 * size / (1.0 - c));
        }
    }

    /// Item 1 of the algebraic structure: on an orbit u + 1 = K/D and the forces are those of
    /// (2.12).
    #[test]
    fn an_orbit_is_algebraic(hoop in heavy_hoop(), start in start(), elapsed in 0.0..30.0_f64) {
        let law = RollingLaw::new(&hoop);
        let orbit = RollingOrbit::new(&hoop, start.theta, start.theta_rate).expect("no resistance");
        let (theta, rate) = orbit.position(elapsed);
        let k = |theta: f64, rate: f64| law.denominator(theta) * (1.0 + rate * rate);
        let (before, after) = (k(start.theta, start.theta_rate), k(theta, rate));
        // θ is known to an ulp, and K = D (1 + u) to what that makes of D.
        let resolution = 4.0 * f64::EPSILON * theta.abs() * hoop.offset() * (1.0 + rate * rate);
        prop_assert!((before - after).abs() < 1e-13 * (before + hoop.offset()) + resolution, "{before} {after}");
    }

    /// Every solution satisfies its differential equation: finite differences of the state along
    /// each phase.
    #[test]
    fn solutions_satisfy_their_equations((hoop, start) in heavy_motion()) {
        check_derivatives(&hoop, start)?;
    }

    #[test]
    fn massless_solutions_satisfy_their_equations(hoop in massless_hoop(), start in start()) {
        check_derivatives(&hoop, start)?;
    }

    /// Points on the boundary curves satisfy their equations (2.13), (2.14).
    #[test]
    fn boundary_curves_are_where_they_say(hoop in heavy_hoop(), theta in -3.1..3.1_f64, positive in any::<bool>()) {
        let plane = PhasePlane::new(&hoop);
        if let Some(rate) = plane.normal_force_rate(theta) {
            let size = hoop.mass() + hoop.offset() * (1.0 + rate * rate) * (1.0 + 1.0 / RollingLaw::new(&hoop).denominator(theta));
            prop_assert!(plane.forces(theta, rate).normal.abs() < 1e-13 * size);
        }
        let direction = if positive { SlipDirection::Positive } else { SlipDirection::Negative };
        if let Some(rate) = plane.slip_rate(theta, direction) {
            let forces = plane.forces(theta, rate);
            let size = hoop.mass() + hoop.offset() * (1.0 + rate * rate) * (1.0 + 1.0 / RollingLaw::new(&hoop).denominator(theta));
            prop_assert!((forces.friction + direction.sign() * hoop.mu_s() * forces.normal).abs() < 1e-12 * size * size);
        }
        if let Some(rate) = plane.lift_off_rate(theta) {
            prop_assert!((hoop.h() * theta.cos() * rate * rate - 1.0).abs() < 1e-14);
        }
        let rate = plane.separatrix_rate(theta);
        let law = RollingLaw::new(&hoop);
        prop_assert!((law.energy(theta, rate) - hoop.offset()).abs() < 1e-14 * (1.0 + hoop.offset()));
    }
}

fn check_derivatives(hoop: &Hoop, start: Start) -> Result<(), TestCaseError> {
    let motion = simulate(hoop, start);
    for phase in motion.phases() {
        let duration = phase.duration().min(20.0);
        let step = 1e-5 * duration.min(1.0);
        if step < 1e-9 {
            continue;
        }
        for elapsed in instants(duration, 5) {
            if elapsed < step || elapsed + step > duration {
                continue;
            }
            let (before, now, after) = (
                phase.sample(elapsed - step),
                phase.sample(elapsed),
                phase.sample(elapsed + step),
            );
            // Third derivatives, where the solution changes too fast for this step, make the
            // difference useless.
            let change = |a: &littlewood::Sample, b: &littlewood::Sample| {
                (a.theta_acceleration - b.theta_acceleration).abs()
                    + (a.slip_acceleration - b.slip_acceleration).abs()
            };
            let curvature = change(&before, &now) + change(&now, &after);
            let size = 1.0
                + before.theta_acceleration.abs()
                + now.slip_acceleration.abs()
                + now.state.theta_rate.abs();
            if curvature >= 1e-3 * size {
                continue;
            }
            // The truncation error of a central difference is a third of how far the middle lies
            // off the chord.
            let bend = |f: fn(&littlewood::Sample) -> f64| {
                (f(&now) - 0.5 * (f(&before) + f(&after))).abs()
            };
            let truncation = bend(|s| s.theta_acceleration) + bend(|s| s.slip_acceleration);
            let tolerance = truncation
                + 1e-6 * size
                + 1e-14 / step * (1.0 + now.state.theta.abs() + now.state.x.abs());
            let slope = |f: fn(&littlewood::Sample) -> f64| (f(&after) - f(&before)) / (2.0 * step);
            let pairs = [
                ("θ′", slope(|s| s.state.theta), now.state.theta_rate),
                ("θ″", slope(|s| s.state.theta_rate), now.theta_acceleration),
                ("η″", slope(|s| s.state.slip), now.slip_acceleration),
                (
                    "x′",
                    slope(|s| s.state.x),
                    now.state.slip - now.state.theta_rate,
                ),
                ("gap′", slope(|s| s.gap), now.gap_rate),
            ];
            for (name, difference, value) in pairs {
                prop_assert!(
                    (difference - value).abs() < tolerance,
                    "{name} in {}: {difference} {value} at {elapsed} of {duration} {now:?}",
                    phase.mode()
                );
            }
        }
        if let PhaseSolution::Rolling(_) = phase.solution() {
            prop_assert_eq!(phase.first().slip_acceleration, 0.0);
        }
    }
    Ok(())
}

#[test]
fn without_a_normal_force_no_friction_is_enough() {
    let demand = |normal, friction| ContactForces { normal, friction }.demand();
    assert_eq!((demand(2.0, -1.0), demand(-1.0, 1.0)), (0.5, f64::INFINITY));
    assert_eq!(
        (demand(0.0, 1.0), demand(0.0, 0.0)),
        (f64::INFINITY, f64::INFINITY)
    );
}

const WINDOW: Window = Window {
    x: [-2.0, 2.0],
    y: [-1.0, 1.0],
};

#[test]
fn a_curve_is_cut_where_it_leaves() {
    let pieces = WINDOW.pieces([-2.0, 2.0], 100, &|s| Some([s, s * s]));
    let [piece] = &pieces[..] else {
        unreachable!("{pieces:?}")
    };
    assert_eq!(
        (piece[0], piece[piece.len() - 1]),
        ([-1.0, 1.0], [1.0, 1.0])
    );
    assert!(piece.iter().all(|[x, y]| *y == x * x));
}

#[test]
fn chords_are_close() {
    let pieces = WINDOW.pieces([0.0, std::f64::consts::TAU], 40, &|s| {
        Some([s.cos(), s.sin()])
    });
    let [piece] = &pieces[..] else {
        unreachable!("{pieces:?}")
    };
    for pair in piece.windows(2) {
        let (x, y) = (
            0.5 * (pair[0][0] + pair[1][0]),
            0.5 * (pair[0][1] + pair[1][1]),
        );
        assert!((x * x + y * y).sqrt() > 1.0 - 2e-3);
    }
}
