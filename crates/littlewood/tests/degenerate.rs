//! Starts on a boundary, at rest, on a vertical, without offset, friction or (nearly) inertia; and
//! bad parameters.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use std::f64::consts::{FRAC_PI_2, PI};

use crate::common::newton::Sizes;
use crate::common::{boundary_start, engines, heavy_hoop, simulate};
use littlewood::modes::{PhaseSolution, Recurrence};
use littlewood::tables::{Bound, Quantity, Setup};
use littlewood::theory::{PhasePlane, RollingLaw, StartRegion};
use littlewood::{
    Cause, Engine, Hoop, HoopParameters, Limits, Mode, Outcome, ParameterError, SlipDirection,
    Start, Trajectory,
};
use proptest::prelude::*;
use serde_json::Value;

fn hoop(mass_ratio: f64, offset: f64, inertia: f64, mu_s: f64, mu_k: f64) -> Hoop {
    Hoop::new(
        HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k),
    )
    .expect("a valid hoop")
}

fn run(hoop: &Hoop, start: Start) -> Trajectory {
    hoop.simulate(start, Limits::until(100.0))
        .expect("a valid start")
}

/// Without kinetic friction a slide comes back to as much friction as rolling would ask for where
/// it began: if that was too much by hardly more than rounding, it is too much by as little there,
/// and static friction never holds.
#[test]
fn a_start_hardly_beyond_the_limit_slips_wherever_it_comes_back() {
    let hoops = [
        hoop(1.0, 1.0, 1.0, 0.5, 0.0),
        hoop(2.9, 1.0, 2.9, 0.8, 0.0),
        hoop(0.2, 0.7, 0.1, 0.3, 0.0),
    ];
    let mut seen = 0;
    for hoop in &hoops {
        let law = RollingLaw::new(hoop);
        let engines = engines(hoop);
        for rate in [0.3, 0.9, 1.3, 1.9] {
            let excess = |theta: f64| {
                let forces = law.forces(theta, rate);
                forces.friction.abs() - hoop.mu_s() * forces.normal
            };
            let angles = (0..200).map(|k| -PI + PI * f64::from(k) / 100.0);
            for (low, high) in angles.map(|angle| (angle, angle + PI / 100.0)) {
                if excess(low) > 0.0 || excess(high) < 0.0 {
                    continue;
                }
                let (mut holds, mut slips) = (low, high);
                while holds.next_up() < slips {
                    let middle = 0.5 * (holds + slips);
                    if excess(middle) > 0.0 {
                        slips = middle;
                    } else {
                        holds = middle;
                    }
                }
                let limits = Limits::until(20.0).with_transitions(40);
                let begins = |theta: f64| {
                    let motion = hoop
                        .simulate(Start::at(theta, rate), limits)
                        .expect("a start");
                    (motion.phases()[0].mode() == Mode::Sliding).then_some((theta, motion))
                };
                // Nearer, within the rounding of the terms of |F| − μs N over its slope, a start is
                // on the limit, and static friction holds where the hoop comes back.
                let slope = (excess(slips + 1e-6) - excess(holds - 1e-6)) / 2e-6;
                let rounding = Sizes::of(hoop, &Start::at(slips, rate)).friction_excess() / slope;
                let (theta, motion) = begins(slips + rounding).expect("a slip");
                for event in motion.transitions() {
                    let angle = libm::remainder(event.before.theta, 2.0 * PI);
                    let miss = (angle.abs() - theta.abs()).abs();
                    // η′ may vanish at another angle, too, where friction does hold, or the hoop
                    // lifts off.
                    if miss > 1e-6 {
                        break;
                    }
                    assert!(
                        matches!(event.cause, Cause::Reversal | Cause::Graze),
                        "{theta} {rate} {event:?}"
                    );
                    assert!(
                        miss < 1e-13 * (1.0 + event.before.theta.abs()),
                        "{theta} {rate} {event:?}"
                    );
                    seen += 1;
                }
                for engine in &engines {
                    let summary = engine
                        .summary(Start::at(theta, rate), limits)
                        .expect("a start");
                    assert_eq!(
                        summary.sequence,
                        motion.summary().sequence,
                        "{theta} {rate}"
                    );
                }
            }
        }
    }
    assert!(seen > 50, "{seen}");
}

#[test]
fn a_homogeneous_disc_slides_at_constant_deceleration_and_then_rolls() {
    // ℓ = 0, Î = 1/2, m = 2: η″ = −μk σ (1 + m/Î) per unit g, since θ″ = −μk σ m/Î and x″ = −μk σ.
    let disc = hoop(1.0, 0.0, 0.5, 0.4, 0.25);
    let motion = run(&disc, Start::at(0.3, 0.0).with_slip(1.0));
    assert_eq!(motion.phases().len(), 2);
    let stick = motion.transitions()[0];
    assert_eq!((stick.cause, stick.to), (Cause::Stick, Some(Mode::Rolling)));
    assert!((stick.before.time - 1.0 / (0.25 * 5.0)).abs() < 1e-15);
    assert!((stick.before.theta_rate + 0.25 * 4.0 * 0.8).abs() < 1e-15);
    let Outcome::RollsForever {
        recurrence: Recurrence::Rotation { period },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!(
        (period - 2.0 * PI / 0.8).abs() < 1e-14,
        "constant speed: {period}"
    );
    // At rest anywhere it stays at rest.
    let motion = run(&disc, Start::at(1.0, 0.0));
    assert!(matches!(
        motion.outcome(),
        Outcome::RollsForever {
            recurrence: Recurrence::Rest,
            ..
        }
    ));
    assert_eq!(motion.at(50.0).expect("at rest").state.theta, 1.0);
}

#[test]
fn without_friction_a_disc_slides_for_ever() {
    let disc = hoop(1.0, 0.0, 0.5, 0.0, 0.0);
    let motion = disc
        .simulate(Start::at(0.0, 1.0).with_slip(0.5), Limits::default())
        .expect("a valid start");
    let Outcome::SlidesForever {
        recurrence: Recurrence::Rotation { period },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!((period - 2.0 * PI).abs() < 1e-14);
    let later = motion.at(1e4).expect("slides for ever").state;
    assert!((later.theta - 1e4).abs() < 1e-9 && (later.slip - 0.5).abs() < 1e-14);
    assert!((later.x + 0.5 * 1e4).abs() < 1e-9);
}

#[test]
fn without_friction_a_loaded_hoop_slides_periodically() {
    let smooth = hoop(1.0, 1.0, 1.0, 0.0, 0.0);
    let motion = smooth
        .simulate(Start::at(2.5, 0.0).with_slip(3.0), Limits::default())
        .expect("a valid start");
    let Outcome::SlidesForever {
        recurrence:
            Recurrence::Libration {
                period,
                theta_min,
                theta_max,
            },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!((theta_min - 2.5).abs() < 1e-14 && (theta_min + theta_max - 2.0 * PI).abs() < 1e-13);
    // Energy of the vertical and rotary motion is conserved; the phase repeats.
    for time in [0.7, 3.0, 5.5] {
        let (a, b) = (
            motion.at(time).expect("slides"),
            motion.at(time + 1000.0 * period).expect("slides"),
        );
        assert!((a.state.theta - b.state.theta).abs() < 1e-10);
        assert!((a.state.slip - b.state.slip).abs() < 1e-10);
        assert!((a.energy - b.energy).abs() < 1e-12);
    }
}

#[test]
fn equilibria_stay_where_they_are() {
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    for (theta, hoop) in [
        (0.0, thin),
        (PI, thin),
        (-PI, thin),
        (0.0, hoop(0.0, 1.0, 0.0, 0.5, 0.4)),
        (PI, hoop(0.0, 0.5, 0.0, 0.5, 0.4)),
    ] {
        let motion = hoop
            .simulate(Start::at(theta, 0.0), Limits::default())
            .expect("a valid start");
        let rests = matches!(
            motion.outcome(),
            Outcome::RollsForever {
                recurrence: Recurrence::Rest,
                ..
            }
        );
        assert!(rests, "{theta}: {:?}", motion.outcome());
    }
}

#[test]
fn the_separatrix_takes_for_ever() {
    // Exactly: Littlewood's hoop with a + b = sin(θ/2) + θ′ cos(θ/2) = 0 in doubles.
    let rim = hoop(0.0, 1.0, 0.0, 10.0, 0.4);
    let theta = FRAC_PI_2;
    let rate = -(0.5 * theta).sin() / (0.5 * theta).cos();
    let motion = rim
        .simulate(Start::at(theta, rate), Limits::default())
        .expect("a valid start");
    match motion.outcome() {
        Outcome::RollsForever {
            recurrence: Recurrence::Asymptotic { theta },
            ..
        } => assert_eq!(theta, 0.0),
        // One ulp beside it the hoop turns back, or passes, after about 2 ln(1/ε).
        _ => assert!(motion.transitions()[0].before.time > 60.0),
    }
    // A heavy hoop an ulp from the separatrix: long, and finite.
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let rate = PhasePlane::new(&thin).separatrix_rate(0.3);
    let motion = run(&thin, Start::at(0.3, -rate));
    assert_eq!(motion.phases()[0].mode(), Mode::Rolling);
}

#[test]
fn frictionless_planes_still_have_a_direction_of_slip() {
    // θ > 0 at rest: gravity turns the hoop, the contact point moves with σ = −sign F, F = −μN →
    // the sign of −F_roll.
    let smooth = hoop(1.0, 1.0, 1.0, 0.0, 0.0);
    for theta in [0.5, -0.5, 2.0] {
        let first = run(&smooth, Start::at(theta, 0.0)).phases()[0].clone();
        assert_eq!(first.mode(), Mode::Sliding);
        let needed = PhasePlane::new(&smooth).forces(theta, 0.0).friction;
        assert_eq!(
            first.direction(),
            SlipDirection::of_sign(-needed),
            "{theta}"
        );
    }
}

#[test]
fn equal_coefficients_slip_with_a_vanishing_acceleration() {
    // μs = μk: at the slip η″ = 0 and η‴ decides. The slip still begins, in the direction against
    // the friction force.
    let thin = hoop(1.0, 1.0, 1.0, 0.4, 0.4);
    let motion = run(&thin, Start::at(FRAC_PI_2, 2.0));
    let slip = motion.transitions()[1];
    assert_eq!(
        (slip.cause, slip.direction),
        (Cause::Slip, Some(SlipDirection::Positive))
    );
    let slide = &motion.phases()[2];
    assert!(slide.first().slip_acceleration.abs() < 1e-14);
    assert!(slide.duration() > 0.5);
    assert!(slide.sample(1e-4).state.slip > 0.0);
}

#[test]
fn a_start_on_the_slip_boundary_goes_where_the_orbit_goes() {
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let plane = PhasePlane::new(&thin);
    let mut seen = [false; 2];
    for i in 0..200 {
        let theta = -PI + 2.0 * PI * f64::from(i) / 199.0;
        for direction in [SlipDirection::Negative, SlipDirection::Positive] {
            let Some(rate) = plane.slip_rate(theta, direction) else {
                continue;
            };
            for rate in [rate, -rate] {
                let motion = simulate(&thin, Start::at(theta, rate));
                let phase = &motion.phases()[0];
                match phase.mode() {
                    // Into 𝓡: the body rolls, for a time that is no rounding error, unless the
                    // orbit leaves at once.
                    Mode::Rolling => seen[0] |= phase.duration() > 1e-3,
                    Mode::Sliding => {
                        seen[1] = true;
                        assert_eq!(
                            phase.direction(),
                            Some(direction),
                            "θ = {theta}, θ′ = {rate}"
                        );
                    }
                    Mode::Flight | Mode::Gliding | Mode::Rest | Mode::Skidding => {
                        panic!("θ = {theta}, θ′ = {rate}: {:?}", phase.mode())
                    }
                }
            }
        }
    }
    assert_eq!(seen, [true, true]);
}

#[test]
fn the_lift_off_curve_is_decided_by_the_next_derivative() {
    // h = 1/2, θ = ±π/3, θ′ = 2: h cos θ θ′² = 1 up to rounding of the cosine; θ = 0, θ′ = √2:
    // exactly 1 − 2ε.
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    // s θ′ < 0: falls through zero, flies (or slides for an instant and lifts off).
    let motion = run(&thin, Start::at(-PI / 3.0, 2.0));
    assert_eq!(
        motion.phases().last().map(littlewood::Phase::mode),
        Some(Mode::Flight)
    );
    assert!(motion.phases().last().expect("flies").start().time < 1e-7);
    // At the top with θ′² = 1/h to the last digit the body stays in contact: w″ = h cos θ θ′⁴ > 0.
    let quarter = hoop(3.0, 1.0, 1.0, 0.5, 0.4);
    let start = Start::at(0.0, 2.0);
    assert_eq!(1.0 - quarter.h() * 4.0, 0.0);
    let found = quarter.classify(start).expect("a valid start");
    assert_ne!(found.region, StartRegion::LossOfContact);
    let motion = run(&quarter, start);
    assert_eq!(motion.phases()[0].mode(), Mode::Sliding);
    assert!(motion.phases()[0].duration() > 1e-3);
}

#[test]
fn a_start_one_digit_off_the_lift_off_curve_stays_close_to_the_plane() {
    // While 1 − h cos θ θ′² grows, a hoop that starts with the last digits of it below zero lands
    // at once.
    let hoop = hoop(0.1, 1.0, 0.1, 0.3, 0.2);
    let engine = Engine::new(&hoop);
    for k in 0..200 {
        let theta = 0.05 + 0.007 * f64::from(k);
        let boundary = 1.0 / (hoop.h() * theta.cos()).sqrt();
        for digits in -3..=3_i32 {
            let rate = boundary * (1.0 + f64::from(digits) * f64::EPSILON);
            let start = Start::at(-theta, -rate);
            let motion = run(&hoop, start);
            if let Some(PhaseSolution::Flight(flight)) =
                motion.phases().first().map(littlewood::Phase::solution)
            {
                // gap = b φ²/2 − h sin θ0 φ³/6 + …: lands at φ = 3 b/(h sin θ0).
                assert!(
                    flight.duration() < 1e-12 / theta,
                    "{start:?}: {}",
                    flight.duration()
                );
            }
            let summary = engine
                .summary(start, Limits::until(100.0))
                .expect("a valid start");
            assert_eq!(summary.sequence, motion.summary().sequence, "{start:?}");
        }
    }
}

#[test]
fn a_particle_at_the_plane_at_once() {
    let rim = hoop(0.0, 1.0, 0.0, 0.5, 0.4);
    for theta in [PI, -PI] {
        let motion = run(&rim, Start::at(theta, 0.5).with_slip(0.1));
        assert_eq!(motion.outcome().kind().name(), "particle_at_plane");
        assert!(motion.outcome().state().time < 1e-15);
    }
}

#[test]
fn a_massless_hoop_at_the_top_glides_only_at_the_rate_of_free_fall() {
    let rim = hoop(0.0, 1.0, 0.0, 0.5, 0.4);
    // θ′² = 1/ℓ̂: N = 0, the particle falls over the top.
    let motion = run(&rim, Start::at(0.0, 1.0));
    assert_eq!(motion.phases()[0].mode(), Mode::Gliding);
    assert_eq!(motion.outcome().kind().name(), "particle_at_plane");
    assert!(
        (motion.outcome().state().time - 2.0).abs() < 1e-15,
        "free fall through 2R"
    );
    // Faster, it would leave the plane, with a rotation that nothing determines; with slip, it
    // cannot slide either.
    for start in [Start::at(0.0, 1.5), Start::at(0.0, 0.5).with_slip(0.2)] {
        assert_eq!(run(&rim, start).outcome().kind().name(), "inconsistent");
    }
}

#[test]
fn an_upward_particle_reaches_the_top_of_the_massless_hoop() {
    let rim = hoop(0.0, 1.0, 0.0, 0.5, 0.4);
    let motion = run(&rim, Start::at(1.0, -2.5).with_slip(0.5));
    let Outcome::ParticleAtTop { state } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert_eq!(state.theta, 0.0);
    assert!(state.theta_rate.is_infinite());
    // ȳ = 1 + cos θ0 + V0 τ − τ²/2 = 2.
    let rise = 2.5 * 1.0_f64.sin();
    assert!(
        (1.0_f64.cos() + rise * state.time - 0.5 * state.time * state.time - 1.0).abs() < 1e-14
    );
}

#[test]
fn the_number_of_transitions_is_a_limit_that_is_told() {
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let limits = Limits::default().with_until(None).with_transitions(2);
    let motion = thin
        .simulate(Start::at(FRAC_PI_2, 2.0), limits)
        .expect("a valid start");
    let Outcome::TransitionLimit {
        state,
        transitions: 2,
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert_eq!(state, motion.transitions()[1].before);
    assert!(!motion.outcome().is_final());
}

#[test]
fn a_time_limit_ends_on_time_in_every_mode() {
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let start = Start::at(FRAC_PI_2, 2.0).with_time(1.0);
    for (until, mode) in [
        (1.2, Mode::Sliding),
        (1.7, Mode::Rolling),
        (2.2, Mode::Sliding),
        (3.0, Mode::Flight),
    ] {
        let motion = thin
            .simulate(start, Limits::until(until))
            .expect("a valid start");
        let Outcome::TimeLimit { state } = motion.outcome() else {
            panic!("{:?}", motion.outcome())
        };
        assert_eq!(state.time, until);
        assert_eq!(
            motion.phases().last().map(littlewood::Phase::mode),
            Some(mode)
        );
        assert_eq!(motion.at(until).expect("the end").state, state);
        assert_eq!(motion.at(until + 1e-9), None);
    }
    let at_once = thin
        .simulate(start, Limits::until(1.0))
        .expect("a valid start");
    assert_eq!(at_once.end_time(), 1.0);
}

#[test]
fn even_samples_contain_every_transition_twice() {
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let motion = thin
        .simulate(Start::at(FRAC_PI_2, 2.0), Limits::default())
        .expect("a valid start");
    let samples: Vec<_> = motion.sample_evenly(11, f64::INFINITY).collect();
    assert_eq!(samples.len(), 11 + 2 * 3);
    assert!(
        samples
            .windows(2)
            .all(|pair| pair[0].state.time <= pair[1].state.time)
    );
    for transition in &motion.transitions()[..3] {
        let at: Vec<_> = samples
            .iter()
            .filter(|sample| sample.state.time == transition.before.time)
            .collect();
        let [before, after] = at[..] else {
            panic!("two instants at a transition")
        };
        assert_eq!(
            (Some(before.mode), Some(after.mode)),
            (transition.from, transition.to)
        );
    }
    assert_eq!(
        samples.last().map(|sample| sample.state),
        Some(motion.outcome().state())
    );
}

#[test]
fn bad_parameters_are_refused_by_name_value_and_bound() {
    let good = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let with = |quantity, value| {
        let mut setup = Setup::new(good, Start::default());
        setup.set(quantity, value);
        setup.hoop
    };
    let refused = |parameters: HoopParameters| Hoop::new(parameters).expect_err("must be refused");
    let nan = f64::NAN;
    for (parameters, quantity) in [
        (with(Quantity::MassRatio, nan), Quantity::MassRatio),
        (with(Quantity::Offset, f64::INFINITY), Quantity::Offset),
        (with(Quantity::Inertia, nan), Quantity::Inertia),
        (with(Quantity::MuS, nan), Quantity::MuS),
        (with(Quantity::MuK, f64::NEG_INFINITY), Quantity::MuK),
    ] {
        let error = refused(parameters);
        let ParameterError::OutOfBounds {
            quantity: found,
            bound: Bound::Finite,
            ..
        } = error
        else {
            panic!("{error}")
        };
        assert_eq!(found, quantity);
    }
    for (parameters, message) in [
        (
            with(Quantity::MassRatio, -1.0),
            "mass_ratio = -1 must not be negative",
        ),
        (
            with(Quantity::Offset, 1.5),
            "offset = 1.5 must not exceed 1",
        ),
        (
            with(Quantity::Offset, -0.1),
            "offset = -0.1 must not be negative",
        ),
        (
            with(Quantity::Inertia, -2.0),
            "inertia = -2 must not be negative",
        ),
        (
            with(Quantity::MuK, 0.6),
            "mu_k = 0.6 must not exceed mu_s = 0.5",
        ),
        (
            good.with_friction(-0.5, -0.6),
            "mu_s = -0.5 must not be negative",
        ),
    ] {
        let error = refused(parameters);
        assert_eq!(error.to_string(), message);
        assert!(!error.hint().is_empty());
    }
    for mass_ratio in [0.0, 2.0] {
        let error = refused(
            HoopParameters::thin(mass_ratio)
                .with_offset(0.0)
                .with_inertia(0.0)
                .with_friction(0.5, 0.4),
        );
        assert_eq!(error, ParameterError::NoMotion { mass_ratio });
    }
    let hoop = Hoop::new(good).expect("a valid hoop");
    assert!(
        hoop.simulate(Start::at(nan, 0.0), Limits::default())
            .is_err()
    );
    assert!(
        hoop.simulate(Start::at(0.0, 1e200), Limits::default())
            .is_err()
    );
    let early = hoop
        .simulate(Start::at(0.0, 0.5).with_time(2.0), Limits::until(1.0))
        .expect_err("before the start");
    assert_eq!(
        early.to_string(),
        "until = 1 sqrt(R/g) must not be less than time = 2 sqrt(R/g)"
    );
}

#[test]
fn a_vanishing_inertia_approaches_the_massless_hoop() {
    // Rolling and gliding from (0, ½): the slip time and the time at the plane of the closed form.
    let mut errors = Vec::new();
    for inertia in [1e-4, 1e-6, 1e-8] {
        let light = hoop(0.0, 1.0, inertia, 0.5, 0.25);
        let motion = run(&light, Start::at(0.0, 0.5));
        assert_eq!(motion.transitions()[0].cause, Cause::Slip);
        errors.push((motion.transitions()[0].before.time - 5.0_f64.ln()).abs());
    }
    assert!(
        errors[0] < 1e-3 && errors[1] < 1e-5 && errors[2] < 1e-7,
        "{errors:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_start_on_a_boundary_has_one_motion_or_says_why((hoop, start) in boundary_start()) {
        let motion = simulate(&hoop, start);
        match motion.outcome() {
            Outcome::Inconsistent { candidates, .. } => prop_assert_eq!(candidates.count(), 0),
            Outcome::Ambiguous { candidates, .. } => prop_assert!(candidates.count() > 1),
            _ => prop_assert!(!motion.phases().is_empty()),
        }
    }

    /// P > 0 for either direction everywhere means that nothing is ever inconsistent or ambiguous.
    #[test]
    fn without_painleve_there_is_always_one_motion(hoop in heavy_hoop(), theta in -4.0..4.0_f64, rate in -4.0..4.0_f64, slip in -1.0..1.0_f64) {
        let worst = |theta: f64| {
            let littlewood::theory::Body::Heavy(body) = hoop.body() else { unreachable!() };
            let lever = hoop.mu_s().max(hoop.mu_k());
            let (s, c) = (theta.sin(), theta.cos());
            body.inertia + body.mass * body.h * (body.h * s * s - lever * s.abs() * (1.0 + body.h * c))
        };
        prop_assume!((0..=400).all(|i| worst(PI * f64::from(i) / 400.0) > 1e-3));
        for slip in [0.0, slip] {
            let motion = simulate(&hoop, Start::at(theta, rate).with_slip(slip));
            prop_assert!(!matches!(
                motion.outcome(),
                Outcome::Inconsistent { .. } | Outcome::Ambiguous { .. } | Outcome::Singular { .. }
            ), "{:?}", motion.outcome());
        }
    }
}

#[test]
fn reversals_without_friction_end_in_a_period() {
    // At rest on the side: gravity swings the hoop, the contact point goes back and forth with it.
    let smooth = hoop(1.0, 1.0, 1.0, 0.0, 0.0);
    let motion = smooth
        .simulate(Start::at(3.0, 0.0), Limits::default())
        .expect("a valid start");
    let Outcome::SlidesForever {
        recurrence:
            Recurrence::Libration {
                period,
                theta_min,
                theta_max,
            },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!((theta_min - 3.0).abs() < 1e-12 && (theta_max + theta_min - 2.0 * PI).abs() < 1e-12);
    // Small oscillations about the bottom: θ″ = −(m h/Î) δ, as the centre only moves up and down.
    let linear = 2.0 * PI / (2.0 * 0.5 / 1.5_f64).sqrt();
    assert!((period - linear).abs() < 0.01 * linear, "{period} {linear}");
    assert_eq!(motion.energy_lost(), 0.0);
    // With a time limit it goes on to it.
    assert_eq!(
        smooth
            .simulate(Start::at(3.0, 0.0), Limits::until(50.0))
            .expect("a valid start")
            .end_time(),
        50.0
    );
}

/// Without friction, from the rate of the lift-off over the top: at the mirror image of the start
/// η′ and the normal force vanish together. What leads into flight is a lift-off, whichever rounds
/// to come first.
#[test]
fn a_slip_that_ends_where_the_hoop_lifts_off_is_a_lift_off() {
    let hoop = HoopParameters::thin(0.858_335_096_611_543_2).with_offset(0.413_766_977_366_253_6);
    let start = Start::at(0.674_975_923_504_364, 2.398_478_851_386_528_3);
    let motion = Hoop::new(hoop)
        .expect("a valid hoop")
        .simulate(start, Limits::default())
        .expect("a valid start");
    let flies = motion
        .transitions()
        .iter()
        .find(|it| it.to == Some(Mode::Flight))
        .expect("flies");
    assert_eq!(
        (flies.cause, flies.from),
        (Cause::LiftOff, Some(Mode::Sliding))
    );
    assert!((flies.before.theta - (std::f64::consts::TAU - start.theta)).abs() < 1e-7);
    assert!(flies.before.slip.abs() < 1e-7);
}

/// Next to Type II the glide begins with η″ = 1.5e-8, and its slip is 2e-16 at most before it
/// reverses. The times have been computed with 45 digits by an independent program.
#[test]
fn a_reversal_just_after_a_slip_next_to_type_ii_is_not_missed() {
    let mu = 0.528_315_945_331_795_3;
    let motion = run(
        &hoop(0.0, 1.0, 0.0, mu, mu),
        Start::at(0.104_267_634_546_428_75, 0.753_548_356_230_989_5),
    );
    let found = Vec::from_iter(
        motion
            .transitions()
            .iter()
            .map(|it| (it.cause, it.to, it.direction)),
    );
    assert_eq!(
        found,
        [
            (
                Cause::Slip,
                Some(Mode::Gliding),
                Some(SlipDirection::Positive)
            ),
            (
                Cause::Reversal,
                Some(Mode::Gliding),
                Some(SlipDirection::Negative)
            ),
            (Cause::ParticleAtPlane, None, None),
        ]
    );
    for (transition, time) in motion.transitions().iter().zip([
        1.036_895_971_622_241,
        1.036_896_000_955_513,
        2.162_636_097_892_943,
    ]) {
        assert!(
            (transition.time() - time).abs() < 1e-15,
            "{} {time}",
            transition.time()
        );
    }
}

/// The double next to π lies on the side θ < π, on which the particle falls through 1e-32.
#[test]
fn a_particle_that_is_all_but_at_the_plane_ends_on_its_own_side() {
    let rim = hoop(0.0, 1.0, 0.0, 0.5, 0.4);
    for turns in [-3.0, 0.0, 1.0, 7.0] {
        for side in [PI, -PI] {
            let theta = 2.0 * PI * turns + side;
            let motion = run(&rim, Start::at(theta, 0.0).with_slip(1.0));
            let Outcome::ParticleAtPlane { state } = motion.outcome() else {
                panic!("{:?}", motion.outcome())
            };
            assert!(
                (state.theta - theta).abs() < 1e-14,
                "{theta} {}",
                state.theta
            );
            assert!(state.time < 1e-14 && state.slip == 1.0);
        }
    }
}

/// x̄ = x̄0 + v Δτ, and at θ = π the centre is above the particle. The number has 45 digits behind
/// it.
#[test]
fn the_centre_is_above_the_particle_at_the_end_of_a_glide() {
    let motion = run(&hoop(0.0, 1.0, 0.0, 3.0, 0.4), Start::at(0.0, 0.5));
    let state = motion.outcome().state();
    assert!(
        (state.x + 3.393_616_639_732_249).abs() < 1e-15,
        "{}",
        state.x
    );
    assert_eq!(state.theta, PI);
}

const GLIDES: &str = include_str!("../../../evidence/reference/glides.json");

/// Glides from numbers as small as they come: at the first rest of their slip, at the top or at the
/// bottom. With an angle of 1e-323 the slip comes to rest in 1e-323, and the hoop rolls on.
#[test]
fn glides_from_tiny_numbers_are_those_of_420_digits() {
    let data: Value = serde_json::from_str(GLIDES).expect("evidence/reference/glides.json");
    let glides = data["glides"].as_array().expect("a list");
    let mut wrong = Vec::new();
    for glide in glides {
        let number = |value: &Value| {
            value
                .as_f64()
                .or_else(|| value.as_str()?.parse().ok())
                .expect("a number")
        };
        let [offset, mu_s, slope] = [0, 1, 2].map(|i| number(&glide["hoop"][i]));
        let [theta, rate, slip] = [0, 1, 2].map(|i| number(&glide["start"][i]));
        let hoop = HoopParameters::thin(0.0)
            .with_offset(offset)
            .with_friction(mu_s, mu_s)
            .with_slope(slope);
        let hoop = Hoop::new(hoop).expect("a hoop");
        let start = Start::at(theta, rate).with_slip(slip);
        let motion = hoop
            .simulate(start, Limits::until(100.0).with_transitions(2))
            .expect("a start");
        let (phase, event) = (&motion.phases()[0], &motion.transitions()[0]);
        let end = event.before;
        let cause = match event.cause {
            Cause::Stick | Cause::Reversal | Cause::Graze => "rest",
            Cause::ParticleAtTop => "top",
            Cause::ParticleAtPlane | Cause::ParticleAtBottom => "bottom",
            _ => "another",
        };
        // A part of the number, and of the smallest doubles their last digit.
        let near = |ours: f64, theirs: f64, size: f64| {
            (ours - theirs).abs() <= 1e-10 * size.max(theirs.abs()) + f64::from_bits(4)
        };
        // Times and angles are as small as the start: the top has no scale.
        let scale = if end.theta.abs() < 1e-40 {
            0.0
        } else {
            1e-3 * offset.sqrt()
        };
        let is_same = phase.direction().map(SlipDirection::sign)
            == Some(number(&glide["direction"]))
            && glide["cause"] == cause
            && near(
                end.time,
                number(&glide["time"]),
                scale + 1e-3 * end.theta.abs(),
            )
            && (cause != "rest"
                || near(end.theta, number(&glide["theta"]), scale)
                    && (end.theta_rate.abs() > 1e9
                        || near(end.theta_rate, number(&glide["theta_rate"]), 1.0))
                    && glide["rolls"]
                        .as_bool()
                        .is_none_or(|rolls| rolls == (event.to == Some(Mode::Rolling))));
        if !is_same {
            wrong.push(format!("{glide}: {:?} {event:?}", phase.direction()));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {}: {:#?}",
        wrong.len(),
        glides.len(),
        &wrong[..wrong.len().min(8)]
    );
}

/// A particle that comes to the top with no velocity left, while the slip comes to rest: it falls
/// over the top, with ℓ̂ θ′² = 1.
#[test]
fn a_particle_that_just_reaches_the_top_falls_over_it() {
    let mut seen = 0;
    for case in 0..2_000 {
        let mut draw = littlewood_random::Draw::of_case(49, 0, case);
        let (offset, theta) = (draw.between([0.4, 1.0]), draw.between([0.1, 2.9]));
        let hoop = hoop(0.0, offset, 0.0, 0.5, 0.4);
        let half = libm::cos(0.5 * theta);
        let above_bottom = 2.0 * offset * half * half;
        let rate = -(2.0 / above_bottom).sqrt();
        if above_bottom * (rate * rate) != 2.0 {
            continue;
        }
        seen += 1;
        let start = Start::at(theta, rate).with_slip(rate * ((1.0 - offset) + above_bottom));
        let motion = run(&hoop, start);
        let top = motion.transitions()[0];
        // Rounding may let it roll for an instant.
        assert!(
            top.before.theta == 0.0 && top.to.is_some(),
            "{start:?} {top:?}"
        );
        let square = offset * top.before.theta_rate * top.before.theta_rate;
        assert!((square - 1.0).abs() < 1e-15, "{top:?}");
        assert!(
            motion.outcome().state().theta < 0.0,
            "{:?}",
            motion.outcome()
        );
    }
    assert!(seen > 100, "{seen}");
}
