//! The plane at a slope.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use std::f64::consts::FRAC_PI_2;

use crate::classification;
use crate::common::{heavy_hoop, instants, massless_hoop, simulate, slope, start, tilted};
use crate::invariants::{check_minima, check_phase, check_transitions, size};
use crate::symmetry::{check_mirror, mirrored};
use littlewood::cases::CASES;
use littlewood::impact::BouncingOrbit;
use littlewood::modes::{GrazingOrbit, Recurrence, RollingOrbit};
use littlewood::tables::{Bound, Quantity};
use littlewood::theory::{Equilibrium, PhasePlane, RollingLaw, Stability};
use littlewood::{
    Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, ParameterError, Phase, Restitution,
    RestitutionLaw, Sample, Start, Trajectory,
};
use littlewood_random::Draw;
use proptest::prelude::*;

/// Whether the forces and accelerations of an instant satisfy Newton's and Euler's equations of the
/// two bodies together.
fn check_balances(hoop: &Hoop, now: &Sample) -> Result<(), TestCaseError> {
    let (sin, cos) = libm::sincos(now.state.theta);
    let (m, h, u) = (
        hoop.mass(),
        hoop.h(),
        now.state.theta_rate * now.state.theta_rate,
    );
    let (along, down) = libm::sincos(hoop.slope());
    let inertia = hoop.body().inertia_about_mass_centre();
    let spin = now.theta_acceleration;
    // In a glide θ″ is the quotient of a difference by h sin θ, and η″ another.
    let terms = if now.mode == Mode::Gliding {
        (1.0 + u) / (h * sin).abs()
    } else {
        spin.abs()
    };
    let x = now.slip_acceleration - spin - h * (cos * spin - sin * u);
    let rounding = 1e-13 * size(hoop, now) * (1.0 + terms * (1.0 + inertia) * m + now.normal.abs());
    let momentum = m * x - now.friction + m * along;
    prop_assert!(
        momentum.abs() < rounding,
        "along the plane: {momentum:e} {now:?}"
    );
    if now.mode != Mode::Flight {
        let lift = -h * (sin * spin + cos * u);
        let normal = m * lift - now.normal + m * down;
        prop_assert!(
            normal.abs() < rounding,
            "normal to the plane: {normal:e} {now:?}"
        );
    }
    let moment = inertia * spin - h * sin * now.normal - (1.0 + h * cos) * now.friction;
    prop_assert!(
        moment.abs() < rounding,
        "about the mass centre: {moment:e} {now:?}"
    );
    Ok(())
}

/// The energy of an orbit is kept.
fn check_energy(hoop: &Hoop, start: Start, elapsed: f64) -> Result<(), TestCaseError> {
    let orbit = RollingOrbit::new(hoop, start.theta, start.theta_rate).expect("no resistance");
    let (theta, rate) = orbit.position(elapsed);
    let law = RollingLaw::new(hoop);
    let [energy, later] = [(start.theta, start.theta_rate), (theta, rate)]
        .map(|(theta, rate)| law.energy(theta, rate));
    let kinetic = law.denominator(theta) * rate * rate;
    let terms =
        1.0 + energy.abs() + kinetic + hoop.mass() * (theta.abs() + start.theta.abs() + 1.0);
    prop_assert!((later - energy).abs() < 1e-12 * terms, "{energy} {later}");
    Ok(())
}

fn check_motion(motion: &Trajectory) -> Result<(), TestCaseError> {
    let hoop = motion.hoop();
    let mut since = None;
    for phase in motion.phases() {
        let first = *since.get_or_insert_with(|| phase.first());
        check_phase(hoop, phase, &first)?;
        check_minima(hoop, phase)?;
        for elapsed in instants(phase.duration(), 8) {
            let now = phase.sample(elapsed);
            if now.state.theta_rate.is_finite() && now.normal.is_finite() {
                check_balances(hoop, &now)?;
            }
            if phase.mode() == Mode::Flight {
                let bound = 1e-12 * size(hoop, &phase.first()) * (1.0 + elapsed * elapsed);
                prop_assert!(
                    (now.energy - phase.first().energy).abs() < bound,
                    "energy in flight"
                );
            }
        }
        if phase.mode() != Mode::Sliding {
            since = None;
        }
    }
    check_transitions(hoop, motion)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    #[ignore = "thorough"]
    fn heavy_hoops_keep_their_laws(hoop in heavy_hoop(), slope in slope(), start in start()) {
        check_motion(&simulate(&tilted(&hoop, slope), start))?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn massless_hoops_keep_their_laws(hoop in massless_hoop(), slope in slope(), start in start()) {
        check_motion(&simulate(&tilted(&hoop, slope), start))?;
    }

    #[test]
    fn the_mirror_image_of_a_motion_is_that_on_the_mirrored_slope(
        hoop in prop_oneof![heavy_hoop(), massless_hoop()], slope in slope(), start in start(),
    ) {
        let motion = simulate(&tilted(&hoop, slope), start);
        check_mirror(&motion, &simulate(&tilted(&hoop, -slope), mirrored(start)))?;
    }

    #[test]
    fn a_start_is_classified_as_its_motion_begins(
        hoop in prop_oneof![heavy_hoop(), massless_hoop()], slope in slope(), start in start(),
    ) {
        classification::check(&tilted(&hoop, slope), start)?;
    }

    #[test]
    fn an_orbit_keeps_its_energy(
        hoop in heavy_hoop(), slope in slope(), start in start(), elapsed in 0.0..10.0_f64,
    ) {
        let hoop = tilted(&hoop, slope);
        check_energy(&hoop, start, elapsed)?;
    }

    #[test]
    fn an_orbit_on_hardly_a_slope_is_that_on_a_level_plane(
        hoop in heavy_hoop(), slope in hardly_a_slope(), start in start(), elapsed in 0.0..20.0_f64,
    ) {
        let hoop = tilted(&hoop, slope);
        check_energy(&hoop, start, elapsed)?;
        let level = tilted(&hoop, 0.0);
        let law = RollingLaw::new(&level);
        let kinetic = law.denominator(start.theta) * start.theta_rate * start.theta_rate;
        // A slower one may be next to the separatrix, which it leaves by its last digit.
        prop_assume!(kinetic > 16.0 * level.mass() * level.h());
        let [(theta, rate), (level_theta, level_rate)] = [&hoop, &level].map(|hoop| {
            let orbit = RollingOrbit::new(hoop, start.theta, start.theta_rate);
            orbit.expect("no resistance").position(elapsed)
        });
        // Of the time 1e-12 is lost, times the rate.
        let bound = 1e-12 * (1.0 + elapsed) * (1.0 + rate.abs().max(level_rate.abs()));
        let apart = (theta - level_theta).abs();
        prop_assert!(apart < bound * (1.0 + theta.abs()), "{theta} {level_theta}");
    }
}

/// Slopes down to the least number, with which no digit of a motion differs from a level one.
fn hardly_a_slope() -> impl Strategy<Value = f64> {
    let size = (-1074.0..-1000.0_f64).prop_map(libm::exp2);
    (size, any::<bool>()).prop_map(|(size, is_left)| if is_left { -size } else { size })
}

/// Its turning point uphill is farther than any number of turns.
#[test]
fn a_hoop_that_rolls_up_hardly_a_slope_has_an_angle_at_the_limit_of_time() {
    for offset in [0.259_729_405_803_304_45, 0.0] {
        let parameters = HoopParameters::thin(0.0)
            .with_offset(offset)
            .with_inertia(2.853_251_856_163_824_5)
            .with_friction(39.6, 39.6);
        let start = Start::at(FRAC_PI_2, 0.653_148_690_009_414_2);
        let end = |slope: f64| {
            let hoop = Hoop::new(parameters.with_slope(slope)).expect("a hoop");
            let motion = hoop.simulate(start, Limits::until(20.0)).expect("a start");
            motion.summary().end
        };
        let level = end(0.0);
        for slope in [5e-324, 1e-310, 1e-300] {
            for slope in [slope, -slope] {
                let theta = end(slope).theta;
                let apart = (theta - level.theta).abs();
                assert!(apart < 1e-12, "{slope:e}: {theta} {}", level.theta);
            }
        }
    }
}

#[test]
fn a_motion_tends_to_that_on_a_level_plane() {
    for case in CASES
        .iter()
        .filter(|case| case.setup.hoop.restitution.is_none())
    {
        let level = Hoop::new(case.setup.hoop.with_slope(0.0)).expect("a hoop");
        let hoop = tilted(&level, 1e-12);
        let level = level
            .simulate(case.setup.start, Limits::default())
            .expect("a start");
        let limits = Limits::default().with_transitions(level.transitions().len().max(1));
        let sloped = hoop.simulate(case.setup.start, limits).expect("a start");
        for (ours, theirs) in sloped.transitions().iter().zip(level.transitions()).take(6) {
            assert_eq!(ours.cause, theirs.cause, "{}", case.name);
            for (ours, theirs) in ours
                .before
                .numbers()
                .into_iter()
                .zip(theirs.before.numbers())
            {
                let apart = (ours - theirs).abs();
                assert!(
                    apart < 1e-9 * (1.0 + theirs.abs()) || ours == theirs,
                    "{}: {apart:e}",
                    case.name
                );
            }
        }
        assert_eq!(
            sloped.phases().first().map(Phase::mode),
            level.phases().first().map(Phase::mode)
        );
    }
}

#[test]
fn a_balanced_hoop_is_accelerated_evenly() {
    let balanced = HoopParameters::thin(1.0)
        .with_offset(0.0)
        .with_friction(0.5, 0.4);
    // Without slip where tan α ≤ μs (1 + m/Î): m = 2, Î = 1.
    for (slope, rolls) in [(0.9, true), (-0.9, true), (1.1, false), (-1.1, false)] {
        let hoop = Hoop::new(balanced.with_slope(slope)).expect("a hoop");
        let motion = hoop
            .simulate(Start::at(0.3, 0.0), Limits::default())
            .expect("a start");
        let (recurrence, expected) = match motion.outcome() {
            Outcome::RollsForever { recurrence, .. } => (recurrence, -2.0 * slope.sin() / 3.0),
            Outcome::SlidesForever { recurrence, .. } => {
                (recurrence, -slope.sin() + 0.4 * slope.cos().copysign(slope))
            }
            other => panic!("{other:?}"),
        };
        assert_eq!(motion.outcome().kind() == OutcomeKind::RollsForever, rolls);
        let Recurrence::Downhill { acceleration } = recurrence else {
            panic!("{recurrence:?}")
        };
        assert!(
            (acceleration - expected).abs() < 1e-15,
            "{acceleration} {expected}"
        );
        let x = motion.at(7.0).expect("an instant").state.x;
        assert!((x - 24.5 * expected).abs() < 1e-13, "{x}");
    }
}

#[test]
fn a_hoop_stays_where_it_is_in_equilibrium_if_friction_holds_it() {
    let parameters = HoopParameters::thin(1.0).with_slope(0.4);
    let stable = PhasePlane::new(&Hoop::new(parameters).expect("a hoop"))
        .equilibria()
        .into_iter()
        .find(|it| matches!(it.stability, Stability::Stable { .. }))
        .map(|Equilibrium { theta, .. }| theta)
        .expect("sin α < h");
    // sin(θ + α) = −sin α/h
    assert!(((stable + 0.4).sin() + 0.4_f64.sin() / 0.5).abs() < 1e-15);
    for (mu, holds) in [(0.43, true), (0.42, false)] {
        let hoop = Hoop::new(parameters.with_friction(mu, mu)).expect("a hoop");
        let motion = hoop
            .simulate(
                Start::at(stable, 0.0),
                Limits::default().with_transitions(1),
            )
            .expect("a start");
        assert_eq!(
            motion.phases()[0].mode() == Mode::Rolling,
            holds,
            "tan 0.4 = 0.4228 and {mu}"
        );
        assert_eq!(motion.outcome().kind() == OutcomeKind::RollsForever, holds);
    }
}

/// The units of the results have g = 1, those of the solvers g cos α = 1: 0.36 at this slope.
#[test]
fn facts_of_phases_and_bounces_are_in_the_units_of_the_results() {
    let parameters = HoopParameters::thin(1.0)
        .with_friction(0.5, 0.4)
        .with_slope(1.2);
    let thrown = Start::at(0.4, 1.0).with_gap_rate(0.5);
    let motion = Hoop::new(parameters)
        .expect("a hoop")
        .simulate(thrown, Limits::default())
        .expect("a start");
    let flight = &motion.phases()[0];
    assert_eq!(flight.take_off_rate(), 0.5);
    let (elapsed, height) = flight.apex().expect("a flight");
    let highest = flight.sample(elapsed);
    assert!(
        highest.gap_rate.abs() < 1e-14 && (highest.gap - height).abs() < 1e-14,
        "{highest:?}"
    );

    let rocking = Hoop::new(parameters.with_friction(9.0, 9.0).with_slope(0.2)).expect("a hoop");
    let motion = rocking
        .simulate(Start::at(2.0, 0.0), Limits::default())
        .expect("a start");
    assert_eq!(
        motion.phases()[0].recurrence(),
        motion.outcome().recurrence()
    );

    // A balanced hoop bounces like a ball: 2 v/(cos α (1 − e)).
    let ball = Hoop::new(parameters.with_offset(0.0)).expect("a hoop");
    let law = Restitution::new(0.5, RestitutionLaw::Energetic).expect("a coefficient");
    let settling = ball
        .settling(&Start::at(0.0, 0.0).check().expect("a start"), 1e-9, law)
        .expect("settles");
    assert!(
        (settling.duration * 1.2_f64.cos() - 4e-9).abs() < 1e-23,
        "{settling:?}"
    );
    // What holds on a level plane alone says nothing on a slope.
    assert_eq!(rocking.lift_off_energy(), None);
    assert!(!rocking.never_lifts_off(&Start::at(2.0, 0.0).check().expect("a start")));
    assert!(
        BouncingOrbit::new(&rocking, 1.0).is_none() && GrazingOrbit::below(&rocking, 9.0).is_none()
    );
}

#[test]
fn a_slope_is_less_than_a_right_angle() {
    let with = |slope| Hoop::new(HoopParameters::thin(1.0).with_slope(slope));
    for slope in [FRAC_PI_2, -FRAC_PI_2, 1.7, 30.0, f64::INFINITY, f64::NAN] {
        let error = with(slope).expect_err("too steep");
        assert!(
            matches!(
                error,
                ParameterError::OutOfBounds {
                    quantity: Quantity::Slope,
                    ..
                }
            ),
            "{error}"
        );
        assert!(
            error.hint().contains("radians") || !slope.is_finite(),
            "{}",
            error.hint()
        );
    }
    let Err(ParameterError::OutOfBounds { bound, .. }) = with(2.0) else {
        panic!("too steep")
    };
    assert_eq!(bound, Bound::MagnitudeBelow(FRAC_PI_2));
    assert!(with(FRAC_PI_2.next_down()).is_ok());
}

/// Hoops and starts of the whole range, on slopes up to the vertical: each motion comes back, with
/// numbers in order.
#[test]
fn motions_of_the_whole_range_come_back() {
    let mut outcomes = std::collections::BTreeMap::new();
    for case in 0..1500 {
        let mut draw = Draw::of_case(35, 0, case);
        let (hoop, start) = draw.motion();
        let hoop = draw.on_slope(&hoop);
        let until = Some(start.time + 50.0);
        let limits = Limits::default().with_transitions(40).with_until(until);
        let motion = hoop.simulate(start, limits).expect("a start");
        let mut time = start.time;
        for transition in motion.transitions() {
            assert!(transition.time() >= time, "{case}: {transition:?}");
            time = transition.time();
            assert!(
                transition.before.x.is_finite() && transition.before.theta.is_finite(),
                "{case}"
            );
        }
        for phase in motion.phases() {
            for elapsed in instants(phase.duration().min(50.0), 3) {
                let state = phase.sample(elapsed).state;
                assert!(
                    !state.theta.is_nan() && !state.theta_rate.is_nan() && !state.x.is_nan(),
                    "{case}: {phase:?}"
                );
            }
        }
        *outcomes.entry(motion.outcome().kind().name()).or_insert(0) += 1;
    }
    assert!(
        outcomes.len() > 6 && outcomes["landing"] > 100,
        "{outcomes:?}"
    );
}

/// A hoop that begins to roll uphill, however slowly, turns back: energies on the way to its turning
/// point underflow. The motion differs from that from rest by some θ′, which is no digit.
#[test]
fn a_hoop_that_rolls_uphill_by_next_to_nothing_turns_back() {
    let hoop = HoopParameters::thin(2.25)
        .with_friction(1.5, 1.0)
        .with_slope(-0.9);
    let hoop = Hoop::new(hoop).expect("a hoop");
    let limits = Limits::until(3.0);
    for theta in [0.0, 1.0, -2.0] {
        let end = |rate: f64| {
            let motion = hoop.simulate(Start::at(theta, rate), limits);
            motion.expect("a valid start").summary().end
        };
        let from_rest = end(0.0);
        assert!(from_rest.theta < theta - 1.0);
        for power in 130..=323 {
            let theta = end(libm::exp10(-f64::from(power))).theta;
            let error = (theta - from_rest.theta).abs();
            assert!(error < 1e-13, "1e-{power}: {theta} {}", from_rest.theta);
        }
    }
}
