//! The plane of rolling.

use core::f64::consts::{FRAC_PI_2, TAU};

use littlewood::tables::Setup;
use littlewood::{HoopParameters, Start};
use littlewood_web::Plane;

use crate::support::problem_of;

/// (3.8) of the paper.
#[test]
fn the_forces_of_littlewoods_hoop_are_those_of_the_paper() {
    let hoop = HoopParameters::thin(0.0).with_friction(0.5, 0.4);
    let problem = problem_of(&Setup::new(hoop, Start::default()), None);
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
