//! Landings that derivatives predict.

use littlewood::Trajectory;
use littlewood::cases::find_case;
use littlewood::derivatives::NoDerivative;
use littlewood::tables::Setup;
use littlewood::{Hoop, HoopParameters, Limits, Start};
use littlewood_web::Prediction;

use crate::support::problem_of;

/// Parts of a path.
const PARTS: usize = 32;

/// Figure 3 with another kinetic friction and slip.
fn setup_of(mu_k: f64, slip: f64) -> Setup {
    let mut setup = find_case("figure-3").unwrap().setup;
    (setup.hoop.mu_k, setup.start.slip) = (mu_k, slip);
    setup
}

fn motion_of(setup: Setup) -> Trajectory {
    Hoop::new(setup.hoop)
        .unwrap()
        .simulate(setup.start, Limits::default())
        .unwrap()
}

#[test]
fn the_flight_of_a_stone_is_predicted_exactly() {
    // Without an offset the landing is at τ = 2 gap′, and linear in the rate; the mass centre rises
    // by gap′²/2.
    let thrown = |gap_rate| {
        let hoop = HoopParameters::thin(1.0)
            .with_offset(0.0)
            .with_friction(0.5, 0.4);
        let start = Start::at(0.25, 1.5).with_slip(0.5).with_gap_rate(gap_rate);
        problem_of(&Setup::new(hoop, start), None)
    };
    let prediction = Prediction::of_landing(&thrown(1.0), 0).unwrap();
    let ghost = prediction.of(&thrown(1.5));
    let [time, theta, ..] = ghost.landing()[..] else {
        panic!("{ghost:?}")
    };
    assert!(
        (time - 3.0).abs() <= 8.0 * f64::EPSILON * 3.0
            && (theta - 4.75).abs() <= 8.0 * f64::EPSILON * 4.75
    );
    let top = ghost
        .path()
        .chunks(2)
        .map(|point| point[1])
        .fold(0.0, f64::max);
    assert!(
        (top - (1.0 + 0.5 * 1.5 * 1.5)).abs() < 16.0 * f64::EPSILON * 2.0,
        "{top}"
    );
}

#[test]
fn what_a_prediction_misses_is_of_second_order() {
    let landing = 3;
    let prediction =
        Prediction::of_landing(&problem_of(&setup_of(0.4, 0.0), None), landing).unwrap();
    let missed = |change: f64| {
        let exact = setup_of(0.4 + change, 0.0);
        prediction.of(&problem_of(&exact, None)).landing()[0]
            - motion_of(exact).transitions()[landing].time()
    };
    // Of an even change the even orders are left: a second difference, quartered by halves but for
    // the fourth order.
    let even = |change: f64| missed(change) + missed(-change);
    let ratio = even(2e-3) / even(1e-3);
    assert!((ratio - 4.0).abs() < 1e-2, "{ratio}");
    // Without the term of first order it would be halved: what is odd is of third order.
    let odd = |change: f64| missed(change) - missed(-change);
    let ratio = odd(2e-2) / odd(1e-2);
    assert!((ratio - 8.0).abs() < 0.5, "{ratio}");
}

#[test]
fn only_landings_are_predicted_and_what_has_no_derivative_has_a_reason() {
    let problem = problem_of(&setup_of(0.4, 0.0), None);
    let of_landing = |transition| Prediction::of_landing(&problem, transition);
    assert!(of_landing(2).is_none() && of_landing(9).is_none());
    let ghost = of_landing(3)
        .unwrap()
        .of(&problem_of(&setup_of(0.4, 0.1), None));
    assert_eq!(
        ghost.reason().as_deref(),
        Some(NoDerivative::OneSided.label())
    );
    assert!(ghost.landing().is_empty() && ghost.path().is_empty());
}

#[test]
fn the_path_is_that_of_the_motion_where_nothing_changes() {
    let same = problem_of(&setup_of(0.4, 0.0), None);
    let motion = motion_of(setup_of(0.4, 0.0));
    let path = Prediction::of_landing(&same, 3).unwrap().of(&same).path();
    let [from, to] = [2, 3].map(|index| motion.transitions()[index].time());
    for (number, point) in path.chunks(2).enumerate() {
        let sample = motion
            .at(from + (to - from) * number as f64 / PARTS as f64)
            .unwrap();
        let away = libm::hypot(
            point[0] - sample.mass_centre.x,
            point[1] - sample.mass_centre.y,
        );
        assert!(away < 1e-12, "{number}: {away}");
    }
}
