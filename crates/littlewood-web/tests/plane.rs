//! The plane of rolling.

use core::f64::consts::{FRAC_PI_2, TAU};

use littlewood_web::{Plane, Problem};

/// (3.8) of the paper.
#[test]
fn the_forces_of_littlewoods_hoop_are_those_of_the_paper() {
    // m1/m2, ℓ/R, Izz, μs, μk, α, θ, θ′, η′, gap′, x, τ.
    let numbers = [0.0, 1.0, 0.0, 0.5, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let problem = Problem::dimensionless(&numbers, None, None, None).unwrap();
    let plane = Plane::new(&problem, -1.0, 3.0, 2.0);
    // The square of cos θ/2, and cos θ/2 sin θ/2.
    let places = [
        (0.0, 1.0, 0.0),
        (FRAC_PI_2, 0.5, 0.5),
        (-FRAC_PI_2, 0.5, -0.5),
        (TAU / 3.0, 0.25, 0.1875_f64.sqrt()),
    ];
    for ((theta, square, product), rate) in places.into_iter().zip([0.2, 0.9, -1.2, 1.4]) {
        let expected = [square * (1.0 - rate * rate), (rate * rate - 1.0) * product];
        for (computed, expected) in plane.forces(theta, rate).into_iter().zip(expected) {
            assert!(
                (computed - expected).abs() < 1e-14,
                "{theta} {rate}: {computed} {expected}"
            );
        }
    }
}
