//! Counts that must not drift: outcomes of a whole plane of starts, and the work that a motion
//! takes.
#![allow(clippy::panic)] // a failed expectation

use std::f64::consts::PI;

use littlewood::cases::find_case;
use littlewood::modes::PhaseSolution;
use littlewood::{Hoop, Limits, Mode, OutcomeKind, Start};

/// Starts (θ, θ′) of the Figure 2 hoop on a 200 × 200 grid over [−π, π] × [−4, 4], ends included,
/// to τ = 50. The counts were obtained with a Taylor integrator and with fixed-step Runge–Kutta,
/// both event-driven, which agree.
#[test]
fn outcomes_of_the_figure_2_plane() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let (mut at_once, mut later, mut in_contact) = (0, 0, 0);
    for i in 0..200 {
        for j in 0..200 {
            let start = Start::at(
                -PI + 2.0 * PI * f64::from(j) / 199.0,
                -4.0 + 8.0 * f64::from(i) / 199.0,
            );
            let motion = hoop
                .simulate(start, Limits::until(50.0))
                .expect("a valid start");
            match motion
                .phases()
                .iter()
                .position(|phase| phase.mode() == Mode::Flight)
            {
                Some(0) => at_once += 1,
                Some(_) => later += 1,
                None => in_contact += 1,
            }
        }
    }
    assert_eq!((at_once, later, in_contact), (9_784, 12_690, 17_526));
}

/// In the band between N_roll = 0 and lift-off the hoop slides: 2,264 of those starts.
#[test]
fn the_sliding_band_of_the_figure_2_plane() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let mut band = 0;
    for i in 0..200 {
        for j in 0..200 {
            let start = Start::at(
                -PI + 2.0 * PI * f64::from(j) / 199.0,
                -4.0 + 8.0 * f64::from(i) / 199.0,
            );
            let found = hoop.classify(start).expect("a valid start");
            if found.rolling_forces.normal <= 0.0 && found.contact > 0.0 {
                assert_eq!(found.mode, Some(Mode::Sliding));
                band += 1;
            }
        }
    }
    assert_eq!(band, 2_264);
}

#[test]
fn a_slide_takes_few_steps() {
    let motion = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let steps: Vec<usize> = motion
        .phases()
        .iter()
        .filter_map(|phase| match phase.solution() {
            PhaseSolution::Sliding(slide) => Some(slide.steps()),
            _ => None,
        })
        .collect();
    assert_eq!(steps, FIGURE_3_STEPS);
}

/// Taylor steps of the two slides of Figure 3.
const FIGURE_3_STEPS: [usize; 2] = [6, 5];

#[test]
fn a_rolling_state_after_a_million_periods_is_that_of_the_first() {
    // The state at τ = 10⁶ agrees with the state whole periods earlier.
    let motion = find_case("rolls-forever")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let summary = motion.summary();
    assert_eq!(summary.outcome, OutcomeKind::RollsForever);
    assert_eq!(motion.phases().len(), 1);
    let littlewood::Outcome::RollsForever {
        recurrence: littlewood::modes::Recurrence::Rotation { period },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    let turns = (1e6 / period).floor();
    let (early, late) = (
        motion.at(1.0).expect("rolls").state,
        motion.at(1.0 + turns * period).expect("rolls").state,
    );
    assert!((late.theta - early.theta - turns * 2.0 * PI).abs() < 1e-8);
    assert!((late.theta_rate - early.theta_rate).abs() < 1e-9);
}
