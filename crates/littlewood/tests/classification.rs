//! What `classify` says begins is what the simulation begins with.

use std::f64::consts::PI;

use crate::common::{heavy_motion, massless_hoop, start};
use littlewood::theory::{RollingType, SlidingLaw, StartRegion, closed_form};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, Proof, RotationDirection,
    Sample, SlipDirection, Start,
};
use littlewood_random::Draw;
use proptest::prelude::*;

/// Compares what is said of a start with the first phase of its motion.
pub(crate) fn check(hoop: &Hoop, start: Start) -> Result<(), TestCaseError> {
    let said = hoop.classify(start).expect("a valid start");
    let limits = Limits::default()
        .with_transitions(1)
        .with_proof(Proof::None);
    let motion = hoop.simulate(start, limits).expect("a valid start");
    let Some(first) = motion.phases().first() else {
        prop_assert_eq!(said.mode, None);
        let (region, undecided) = match motion.outcome() {
            Outcome::Inconsistent { .. } => (StartRegion::Inconsistent, None),
            Outcome::Ambiguous { .. } => (StartRegion::Ambiguous, None),
            Outcome::Unresolved { undecided, .. } => (StartRegion::Unresolved, Some(undecided)),
            other => return Err(TestCaseError::fail(format!("no phase, but {other:?}"))),
        };
        prop_assert_eq!(said.region, region);
        prop_assert_eq!(said.candidates, motion.outcome().candidates());
        if let Some(candidates) = said.candidates {
            prop_assert_eq!(candidates.rolling_forces, said.rolling_forces);
        }
        prop_assert_eq!(said.undecided, undecided);
        return Ok(());
    };
    prop_assert_eq!(said.undecided, None);
    prop_assert_eq!(said.mode, Some(first.mode()));
    prop_assert!(said.candidates.is_none());
    if said.direction.is_some() || first.mode() != Mode::Gliding {
        prop_assert_eq!(said.direction, first.direction());
    }
    let rests = first.mode() == Mode::Rest;
    prop_assert_eq!(said.region == StartRegion::BandOfRest, rests);
    prop_assert_eq!(motion.outcome().kind() == OutcomeKind::Rests, rests);
    let is_resisted = hoop.rolling_resistance() > 0.0;
    if is_resisted && matches!(first.mode(), Mode::Rolling | Mode::Rest) {
        let Sample {
            normal, friction, ..
        } = first.first();
        let forces = said.rolling_forces;
        prop_assert_eq!((forces.normal, forces.friction), (normal, friction));
    }
    if first.mode() == Mode::Rolling {
        prop_assert_eq!(said.region, StartRegion::Rolling);
    }
    if first.mode() == Mode::Rolling && !is_resisted {
        match said.rolling_end {
            Some(end) => {
                let last = first.end().expect("an end");
                prop_assert_eq!(last.time, start.time + end.elapsed);
                prop_assert_eq!((last.theta, last.theta_rate), (end.theta, end.theta_rate));
                prop_assert!(said.recurrence.is_none());
            }
            None => {
                prop_assert_eq!(first.end(), None);
                prop_assert_eq!(said.recurrence, motion.outcome().recurrence());
            }
        }
    } else {
        prop_assert_eq!(
            (said.rolling_end, said.recurrence, said.rolling_type),
            (None, None, None)
        );
    }
    Ok(())
}

/// Which border of 𝓡 (3.10) a rolling motion reaches first: (3.1) integrated by Runge and Kutta's
/// method in steps that are short beside the distance of the starts below from any border of types.
fn integrated_type(mu_s: f64, theta: f64, rate: f64) -> RollingType {
    let slope = |[theta, rate]: [f64; 2]| {
        let turn = (1.0 + rate * rate) * libm::sin(theta) / (2.0 * (1.0 + libm::cos(theta)));
        [rate, turn]
    };
    let moved =
        |at: [f64; 2], by: [f64; 2], step: f64| [at[0] + step * by[0], at[1] + step * by[1]];
    let theta_s = 2.0 * libm::atan(mu_s);
    let mut at = [theta, rate];
    let step = 1e-4;
    loop {
        let a = slope(at);
        let b = slope(moved(at, a, 0.5 * step));
        let c = slope(moved(at, b, 0.5 * step));
        let d = slope(moved(at, c, step));
        let mean = [0, 1].map(|k| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0);
        at = moved(at, mean, step);
        if at[1].abs() >= 1.0 {
            return RollingType::I;
        }
        if at[0].abs() >= theta_s {
            return RollingType::III;
        }
    }
}

/// The types by their energies, by the end of rolling, by the simulated motion and by (3.1): for
/// little friction, for much, and on both sides of μs = 1, where the energy of Type II is that of
/// the equilibrium.
#[test]
fn the_type_of_a_motion_is_what_ends_it_for_every_friction() {
    let frictions = [
        0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0, 1.01, 1.1, 1.5, 2.0, 3.0, 5.0, 10.0,
    ];
    for mu_s in frictions {
        let hoop = Hoop::littlewood(mu_s, 0.5 * mu_s).expect("a hoop");
        let theta_s = 2.0 * libm::atan(mu_s);
        let two = RollingType::energy_of_ii(mu_s);
        let corner = closed_form::rolling_energy(theta_s, 1.0);
        assert!((two - corner).abs() < 1e-15 * (1.0 + theta_s), "{mu_s}");
        assert_eq!(RollingType::of_energy(two, mu_s), Some(RollingType::II));
        for i in -7..=7 {
            for j in -7..=7 {
                let (theta, rate) = (0.137 * f64::from(i) * theta_s, 0.137 * f64::from(j));
                let energy = closed_form::rolling_energy(theta, rate);
                // What is next to a border takes long, or is decided by the steps.
                if (energy - two).abs() < 2e-3 || (energy - 1.0).abs() < 2e-3 {
                    continue;
                }
                let expected = Some(integrated_type(mu_s, theta, rate));
                let start = Start::at(theta, rate);
                let said = hoop.classify(start).expect("a start");
                let motion = hoop.simulate(start, Limits::default()).expect("a motion");
                let simulated = match motion.transitions()[0].cause {
                    Cause::NormalForceZero => Some(RollingType::I),
                    Cause::Slip => Some(RollingType::III),
                    _ => None,
                };
                let found = [
                    RollingType::of_energy(energy, mu_s),
                    said.rolling_type,
                    simulated,
                ];
                assert_eq!(found, [expected; 3], "{theta}, {rate} with {mu_s}");
            }
        }
        // On the stable manifold it has no end: it comes to the top.
        let rate = closed_form::stable_manifold_rate(0.0);
        assert_eq!(
            hoop.classify(Start::at(0.0, rate))
                .expect("a start")
                .rolling_type,
            None
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_heavy_hoop_begins_as_it_is_classified((hoop, start) in heavy_motion()) {
        check(&hoop, start)?;
    }

    #[test]
    fn a_massless_hoop_begins_as_it_is_classified(
        hoop in massless_hoop(), start in start(), resistance in 1e-6..1.5_f64,
    ) {
        check(&hoop, start)?;
        let parameters = hoop.parameters().with_rolling_resistance(resistance);
        let resisted = Hoop::new(parameters).expect("a valid hoop");
        check(&resisted, start)?;
        check(&resisted, Start::at(start.theta, 0.0).with_slip(start.slip))?;
    }

    /// A massless rim with the particle on it: F/N = tan θ/2 (3.9), and N has the sign of 1 − θ′².
    #[test]
    fn littlewoods_hoop_rolls_at_rates_below_1_where_friction_suffices(
        mu in 0.01..3.0_f64, theta in -3.1..3.1_f64, rate in -2.0..2.0_f64,
    ) {
        let margins = [mu - libm::tan(0.5 * theta).abs(), 1.0 - rate.abs()];
        prop_assume!(margins.iter().all(|margin| margin.abs() > 1e-9));
        let hoop = Hoop::littlewood(mu, 0.5 * mu).expect("a valid hoop");
        let rolls = hoop.classify(Start::at(theta, rate)).expect("a valid start").mode == Some(Mode::Rolling);
        prop_assert_eq!(rolls, margins.iter().all(|margin| *margin > 0.0));
    }

    #[test]
    fn a_thrown_hoop_flies((hoop, start) in heavy_motion(), gap_rate in 1e-9..2.0_f64) {
        check(&hoop, start.with_gap_rate(gap_rate))?;
    }
}

/// Starts of all regions, on their borders, too.
#[test]
fn a_hoop_with_rolling_resistance_begins_as_it_is_classified() {
    let mut found = [0; StartRegion::ALL.len()];
    for case in 0..10_000 {
        let (hoop, start) = Draw::of_case(61, 0, case).resisted_in_contact();
        if hoop.rolling_resistance() > 0.0 {
            check(&hoop, start)
                .unwrap_or_else(|error| panic!("{error}: {case}, {hoop:?} {start:?}"));
            let said = hoop.classify(start).expect("a valid start");
            found[usize::from(said.region.code())] += 1;
        }
    }
    assert!(found.iter().all(|count| *count > 0), "{found:?}");
}

/// At rest on a level plane: |h sin θ| ≤ χ, whatever the friction; else the hoop rolls or slips. On a
/// slope friction has to hold, too: |tan α| ≤ μs.
#[test]
fn the_band_of_rest_is_where_couple_and_friction_hold() {
    let parameters = HoopParameters::thin(1.0)
        .with_friction(0.2, 0.1)
        .with_rolling_resistance(0.1);
    let region = |parameters: HoopParameters, theta: f64, rate: f64| {
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        hoop.classify(Start::at(theta, rate))
            .expect("a valid start")
            .region
    };
    // h = 1/2: sin θ = χ/h at 0.20135…
    let edge = libm::asin(0.2);
    for theta in [0.0, 0.99 * edge, PI - 0.99 * edge, PI, PI + 0.99 * edge] {
        assert_eq!(
            region(parameters, theta, 0.0),
            StartRegion::BandOfRest,
            "{theta}"
        );
        assert_eq!(
            region(parameters, theta, 1e-9),
            StartRegion::Rolling,
            "{theta}"
        );
    }
    for theta in [1.01 * edge, PI - 1.01 * edge] {
        assert_eq!(
            region(parameters, theta, 0.0),
            StartRegion::Rolling,
            "{theta}"
        );
    }
    // h sin θ = −d tan α: the weight is above the contact.
    let balanced = |slope: f64| {
        let pull = libm::tan(slope);
        PI + libm::asin(2.0 * pull / (1.0 + pull * pull).sqrt()) - libm::atan(pull)
    };
    for (slope, expected) in [
        (0.9 * libm::atan(0.2), StartRegion::BandOfRest),
        (1.1 * libm::atan(0.2), StartRegion::BeyondFriction),
    ] {
        let theta = balanced(slope);
        assert_eq!(
            region(parameters.with_slope(slope), theta, 0.0),
            expected,
            "{slope}"
        );
    }
}

/// N = Î m w/P with w = 0 falling: the hoop leaves the plane, and no slide is consistent where P >
/// 0. Where P < 0 the normal force of a slide increases, as at w < 0, where both are consistent.
#[test]
fn a_slide_that_is_unloaded_to_the_bit_is_a_candidate_only_where_p_is_negative() {
    let parameters = HoopParameters::thin(3.0)
        .with_inertia(0.2)
        .with_friction(3.0, 3.0);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let mut found = [0; 2];
    for k in 1..40 {
        let theta = -0.01 * f64::from(k);
        let cos = libm::cos(theta);
        let about = (4.0 / cos).sqrt();
        let rates =
            (-20..=20_i64).map(|ulps| f64::from_bits(about.to_bits().wrapping_add_signed(ulps)));
        // h = 1/4: w = 1 − h cos θ θ′² vanishes to the bit.
        for rate in rates.filter(|rate| cos * (rate * rate) == 4.0) {
            for slip in [-0.5, 0.5] {
                let said = hoop
                    .classify(Start::at(theta, rate).with_slip(slip))
                    .expect("a valid start");
                let direction = SlipDirection::of_sign(slip).expect("slips");
                let law =
                    SlidingLaw::new(&hoop, direction, RotationDirection::Positive).expect("heavy");
                let (mode, region) = if law.painleve(theta) > 0.0 {
                    (Some(Mode::Flight), StartRegion::LossOfContact)
                } else {
                    (None, StartRegion::Ambiguous)
                };
                assert_eq!(
                    (said.mode, said.region),
                    (mode, region),
                    "{theta} {rate} {slip}"
                );
                found[usize::from(mode.is_none())] += 1;
            }
        }
    }
    assert!(found[0] > 20 && found[1] > 2, "{found:?}");
}
