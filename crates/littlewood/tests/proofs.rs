//! What is proved about endless motions, against the motions themselves, followed without proofs.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::common;
use std::f64::consts::PI;

use littlewood::modes::GrazingOrbit;
use littlewood::theory::{RollingLaw, SlidingLaw};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Proof, RotationDirection, SlipDirection,
    Start, State, Trajectory,
};
use proptest::prelude::*;
use serde_json::Value;

/// Hoops of moderate proportions with one coefficient of friction.
fn equal_friction() -> impl Strategy<Value = Hoop> {
    let masses = prop_oneof![
        (0.1..4.0_f64).prop_map(|m1| (m1, m1)),
        (0.0..4.0_f64, 0.2..3.0_f64)
    ];
    (masses, prop_oneof![Just(1.0), 0.1..1.0_f64], 0.02..1.2_f64).prop_filter_map(
        "a body that can move",
        |((mass_ratio, inertia), offset, mu)| {
            Hoop::new(
                HoopParameters::thin(mass_ratio)
                    .with_offset(offset)
                    .with_inertia(inertia)
                    .with_friction(mu, mu),
            )
            .ok()
        },
    )
}

fn energy(hoop: &Hoop, state: &State) -> f64 {
    RollingLaw::new(hoop).energy(state.theta, state.theta_rate)
}

fn follow(hoop: &Hoop, state: State, transitions: usize) -> Trajectory {
    hoop.simulate(
        Start::from(state),
        Limits::default()
            .with_transitions(transitions)
            .with_proof(Proof::None),
    )
    .expect("a start")
}

/// Whether rounding does not take a motion past a bound that it is short of by this part: twice
/// over is it amplified by (Î/m)^(−1/2) where a light particle passes the bottom.
fn stays_below(hoop: &Hoop, margin: f64) -> bool {
    margin * hoop.body().inertia_about_mass_centre() > 1e-12 * hoop.mass()
}

/// Largest |F| − μs N over an orbit, sampled densely.
fn largest_excess(hoop: &Hoop, energy: f64) -> f64 {
    let law = RollingLaw::new(hoop);
    let mut largest = f64::NEG_INFINITY;
    let mut look = |theta: f64, u: f64| {
        let forces = law.forces(theta, u.sqrt());
        largest = largest.max(forces.friction.abs() - hoop.mu_s() * forces.normal);
    };
    for step in 0..=20_000 {
        let theta = PI * f64::from(step) / 20_000.0;
        let u = 2.0 * (energy - hoop.offset() * theta.cos()) / law.denominator(theta);
        if u >= 0.0 {
            look(theta, u);
        }
    }
    let turning = energy / hoop.offset();
    if turning.abs() < 1.0 {
        look(turning.acos(), 0.0);
    }
    largest
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_grazing_orbit_is_where_the_limit_begins_to_be_exceeded(hoop in equal_friction(), above in 0.0..3.0_f64, librates in any::<bool>()) {
        let from = if librates { hoop.offset() * (1.0 - 1e-9) } else { hoop.offset() * (1.0 + 1e-9) + above };
        let Some(orbit) = GrazingOrbit::below(&hoop, from) else { return Ok(()) };
        let size = 1e-6 * (1.0 + orbit.energy.abs());
        prop_assert!(largest_excess(&hoop, orbit.energy - size) < 0.0, "{orbit:?}");
        prop_assert!(largest_excess(&hoop, orbit.energy + size) > 0.0, "{orbit:?}");
        let forces = RollingLaw::new(&hoop).forces(orbit.theta, orbit.theta_rate);
        prop_assert!((forces.demand() - hoop.mu_s()).abs() < 1e-9, "{orbit:?}");
    }

    #[test]
    fn a_slip_near_the_grazing_orbit_loses_what_its_law_says(hoop in equal_friction(), librates in any::<bool>()) {
        let from = if librates { hoop.offset() * (1.0 - 1e-9) } else { 1e3 };
        let Some(orbit) = GrazingOrbit::below(&hoop, from) else { return Ok(()) };
        // So near that a slip takes 1e-5 of the distance; terms of higher order are of the size of
        // its square root.
        let distance = 1e-5 / orbit.loss;
        prop_assume!(distance < 1e-4 && distance > 1e-8);
        let law = RollingLaw::new(&hoop);
        let rate = (2.0 * (orbit.energy + distance + hoop.offset()) / law.denominator(PI)).sqrt();
        let motion = follow(&hoop, State { time: 0.0, theta: PI, theta_rate: rate, slip: 0.0, x: 0.0 }, 2);
        let [slip, stick] = motion.transitions() else { return Err(TestCaseError::fail(format!("{orbit:?}"))) };
        prop_assert_eq!((slip.cause, stick.cause), (Cause::Slip, Cause::Stick));
        let lost = energy(&hoop, &slip.before) - energy(&hoop, &stick.before);
        let expected = orbit.loss * distance * distance;
        prop_assert!((lost / expected - 1.0).abs() < 0.03, "{} of {}: {orbit:?}", lost, expected);
    }

    #[test]
    fn a_motion_that_slips_for_ever_goes_on_slipping(hoop in equal_friction(), theta in -PI..PI, rate in -3.0..3.0_f64) {
        let motion = hoop.simulate(Start::at(theta, rate), Limits::default()).expect("a start");
        let Outcome::SlipsForever { state, orbit, .. } = motion.outcome() else { return Ok(()) };
        let further = follow(&hoop, state, 400);
        let is_limit = matches!(further.outcome(), Outcome::TransitionLimit { .. });
        prop_assert!(is_limit, "{:?}", further.outcome());
        // Slips before and behind the vertical differ; those of one kind shrink.
        let mut last = energy(&hoop, &state);
        let mut losses: Vec<f64> = Vec::new();
        for pair in further.transitions().chunks_exact(2) {
            prop_assert_eq!((pair[0].cause, pair[1].cause), (Cause::Slip, Cause::Stick));
            let now = energy(&hoop, &pair[1].before);
            let lost = last - now;
            prop_assert!(now > orbit.energy, "{} {orbit:?}", now);
            let like = losses.len().checked_sub(2).map_or(f64::INFINITY, |earlier| losses[earlier]);
            // Two losses are the differences of four energies, of states with a rate and an angle,
            // of many turns, that are known to some units in the last place.
            let State { theta, theta_rate, .. } = pair[1].before;
            let slope = hoop.offset() * (1.0 + theta_rate * theta_rate);
            let rounding = 4.0 * 4.0 * f64::EPSILON * (last.abs() + slope * theta.abs());
            prop_assert!(lost > 0.0 && lost <= like * (1.0 + 1e-9) + rounding, "{lost} {like} {orbit:?}");
            losses.push(lost);
            last = now;
        }
    }

    #[test]
    fn a_motion_that_repeats_itself_does(
        hoop in common::moderate_hoop(), theta in -PI..PI, rate in -3.0..3.0_f64, slip in prop_oneof![Just(0.0), -2.0..2.0_f64],
    ) {
        let hoop = Hoop::new(hoop.parameters().with_friction(hoop.mu_s(), 0.0)).expect("without kinetic friction");
        let motion = hoop.simulate(Start::at(theta, rate).with_slip(slip), Limits::default()).expect("a start");
        prop_assert!(motion.outcome().is_final(), "{:?}", motion.outcome());
        let Outcome::RepeatsForever { since, period, theta_gained, transitions } = motion.outcome() else { return Ok(()) };
        let turns = theta_gained / (2.0 * PI);
        prop_assert!((turns - turns.round()).abs() < 1e-8);
        let further = follow(&hoop, motion.start(), motion.transitions().len() + 2 * transitions);
        for (n, later) in further.transitions().iter().skip(motion.transitions().len()).enumerate() {
            let earlier = &further.transitions()[motion.transitions().len() + n - transitions];
            prop_assert_eq!((earlier.cause, earlier.direction), (later.cause, later.direction));
            prop_assert!((later.time() - earlier.time() - period).abs() < 1e-8 * (1.0 + period));
            prop_assert!((later.before.theta - earlier.before.theta - theta_gained).abs() < 1e-8);
            prop_assert!((later.before.theta_rate - earlier.before.theta_rate).abs() < 1e-8);
        }
        prop_assert!(since.time >= 0.0);
    }

    #[test]
    fn a_hoop_of_little_energy_never_lifts_off(
        hoop in common::heavy_hoop(), theta in -PI..PI, rate in -2.0..2.0_f64, slip in prop_oneof![Just(0.0), -1.0..1.0_f64],
    ) {
        let start = State { time: 0.0, theta, theta_rate: rate, slip, x: 0.0 };
        prop_assume!(hoop.never_lifts_off(&start));
        let motion = follow(&hoop, start, 60);
        prop_assert!(motion.phases().iter().all(|phase| phase.mode() != Mode::Flight));
        let asked = Limits::default().with_proof(Proof::Contact);
        let known = hoop.simulate(Start::from(start), asked).expect("a start");
        prop_assert_eq!(known.outcome(), Outcome::StaysInContact { state: start });
    }

    /// Also next to the bounds of the proof, for as long as the motion is followed.
    #[test]
    fn a_hoop_that_turns_too_slowly_never_lifts_off(
        (hoop, is_moderate) in prop_oneof![
            common::moderate_hoop().prop_map(|hoop| (hoop, true)),
            common::heavy_hoop().prop_map(|hoop| (hoop, false)),
        ],
        theta in -PI..PI,
        turns in prop_oneof![0.3..1.2_f64, (3.0..12.0_f64).prop_map(|digits| 1.0 - 10f64.powf(-digits))],
        moves in prop_oneof![0.0..2.0_f64, (3.0..11.0_f64).prop_map(|digits| 1.0 - 10f64.powf(-digits))],
        (ahead, along) in (any::<bool>(), any::<bool>()),
    ) {
        let sign = |positive: bool| if positive { 1.0 } else { -1.0 };
        let (m, h, needed) = (hoop.mass(), hoop.h(), 2.0 * hoop.lift_off_energy().expect("a heavy hoop"));
        let inertia = hoop.body().inertia_about_mass_centre();
        let spin = |theta: f64| inertia + m * (h * theta.sin()).powi(2);
        let height = |theta: f64| 2.0 * hoop.offset() * theta.cos();
        let least = (0..=20_000)
            .map(|k| PI * f64::from(k) / 20_000.0)
            .map(|theta| (1.0 + h * theta.cos()) * ((needed - height(theta)) / spin(theta)).sqrt())
            .fold(f64::INFINITY, f64::min);
        // Of what a lift-off needs this start has a part of the one kind of energy, and of the
        // rest.
        let level = turns * needed;
        prop_assume!(level > height(theta));
        let rate = sign(ahead) * ((level - height(theta)) / spin(theta)).sqrt();
        let velocity = sign(along) * ((moves * m * least * least + needed - level).max(0.0) / m).sqrt();
        let start = State { time: 0.0, theta, theta_rate: rate, slip: velocity + rate * (1.0 + h * theta.cos()), x: 0.0 };
        let well_posed = (0..1000).map(|k| PI * f64::from(k) / 500.0).all(|theta| {
            let q = h * theta.sin() - hoop.mu_k() * (1.0 + h * theta.cos());
            inertia + m * h * theta.sin() * q > 1e-3
        });
        let is_proved = hoop.never_lifts_off(&start);
        if is_moderate {
            prop_assert!(is_proved || turns > 1.0 - 1e-9 || moves > 1.0 - 1e-6 || !well_posed);
            prop_assert!(!is_proved || turns < 1.0);
        }
        prop_assume!(is_proved && stays_below(&hoop, 1.0 - turns) && Start::from(start).check().is_ok());
        let motion = follow(&hoop, start, 120);
        for phase in motion.phases() {
            prop_assert!(phase.mode() != Mode::Flight);
        }
        for event in motion.transitions() {
            let State { theta, theta_rate, .. } = event.before;
            prop_assert!(spin(theta) * theta_rate * theta_rate + height(theta) < needed * (1.0 + 1e-9));
        }
    }

    /// The greatest velocity of the mass centre against the rotation for which there is a proof,
    /// found by halving: the motion from there.
    #[test]
    fn a_slip_that_little_friction_takes_up_lifts_no_hoop(
        (hoop, little) in (prop_oneof![common::moderate_hoop(), common::heavy_hoop()], 1.5..5.0_f64),
        theta in -PI..PI,
        turns in prop_oneof![0.3..1.0_f64, (2.0..9.0_f64).prop_map(|digits| 1.0 - 10f64.powf(-digits))],
        ahead in any::<bool>(),
    ) {
        let friction = [hoop.mu_s(), hoop.mu_k()].map(|mu| mu * 10f64.powf(-little));
        let hoop = Hoop::new(hoop.parameters().with_friction(friction[0], friction[1])).expect("less friction");
        let (m, h, needed) = (hoop.mass(), hoop.h(), 2.0 * hoop.lift_off_energy().expect("a heavy hoop"));
        let spin = hoop.body().inertia_about_mass_centre() + m * (h * theta.sin()).powi(2);
        let level = turns * needed - 2.0 * hoop.offset() * theta.cos();
        prop_assume!(level > 0.0);
        let sign = if ahead { 1.0 } else { -1.0 };
        let rate = sign * (level / spin).sqrt();
        let with = |velocity: f64| {
            let slip = rate * (1.0 + h * theta.cos()) - sign * velocity;
            State { time: 0.0, theta, theta_rate: rate, slip, x: 0.0 }
        };
        prop_assume!(hoop.never_lifts_off(&with(0.0)));
        let (mut least, mut most) = (0.0, 1e3);
        for _ in 0..50 {
            let middle = 0.5 * (least + most);
            if hoop.never_lifts_off(&with(middle)) { least = middle } else { most = middle }
        }
        prop_assume!(stays_below(&hoop, 1.0 - turns) && Start::from(with(least)).check().is_ok());
        let motion = follow(&hoop, with(least), 120);
        prop_assert!(motion.phases().iter().all(|phase| phase.mode() != Mode::Flight));
    }

    #[test]
    fn the_question_who_jumps_has_the_same_answer_by_proof(
        hoop in common::moderate_hoop(), theta in -PI..PI, rate in -4.0..4.0_f64,
    ) {
        let start = Start::at(theta, rate);
        let whole = hoop.simulate(start, Limits::default()).expect("a start").summary();
        let asked = hoop.simulate(start, Limits::default().with_proof(Proof::Contact)).expect("a start").summary();
        prop_assert_eq!(whole.lift_off_time.to_bits(), asked.lift_off_time.to_bits());
    }
}

/// A hoop that turns too slowly for a lift-off is turned faster where it slips fast, and lifts off.
#[test]
fn a_fast_slip_may_lift_a_hoop_that_turns_slowly() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("Figure 2's hoop");
    let start = State {
        time: 0.0,
        theta: 3.0,
        theta_rate: 2.0,
        slip: -8.0,
        x: 0.0,
    };
    assert!(!hoop.never_lifts_off(&start));
    let motion = follow(&hoop, start, 10);
    assert!(
        motion
            .phases()
            .iter()
            .any(|phase| phase.mode() == Mode::Flight),
        "{:?}",
        motion.outcome()
    );
    // With the same θ and θ′, and a horizontal velocity of the mass centre of 1.
    let slower = State {
        slip: 2.0 * (1.0 + 0.5 * start.theta.cos()) - 1.0,
        ..start
    };
    assert!(hoop.never_lifts_off(&slower));
    // At the bottom (1 − h)² (C + 2 ℓ̂)/Î is 7/6 with C = 2 E_lift = 5, and less nowhere: the
    // energy may be (5 + 2 · 7/6)/2.
    let turning = (1.5 + 0.5 * start.theta.sin().powi(2)) * 4.0 + 2.0 * start.theta.cos();
    for (part, is_proved) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
        let velocity = (0.5 * (5.0 + 2.0 * 7.0 / 6.0 - turning)).sqrt() * part;
        let start = State {
            slip: 2.0 * (1.0 + 0.5 * start.theta.cos()) - velocity,
            ..start
        };
        assert_eq!(hoop.never_lifts_off(&start), is_proved, "{part}");
    }
}

/// The less friction, the more a hoop may slip that still turns too slowly. A quadrature of the
/// work of friction over a turn with a sum of 20,000 terms, in another language, has these greatest
/// values of C and of the energy for m1/m2, ℓ/R, Izz, μs and μk. The proof bounds the quadrature by
/// cells: it is a little weaker, and never stronger. For these hoops it proves more than the bound
/// at an instant does.
#[test]
fn the_greatest_energies_without_a_lift_off_are_those_of_a_quadrature() {
    for ([mass_ratio, offset, izz, mu_s, mu_k], turning, greatest) in [
        ([1.0, 1.0, 1.0, 1e-3, 1e-3], 4.970_699_9, 4.048_715_3),
        ([1.0, 1.0, 1.0, 1e-2, 1e-2], 4.706_995_3, 3.847_526_4),
        ([1.0, 1.0, 0.5, 1e-3, 1e-3], 3.970_765_8, 3.743_582_7),
        ([0.3, 0.7, 0.05, 1e-3, 8e-4], 1.683_034_9, 3.110_601_2),
        ([1.0, 0.9, 1.0, 1e-3, 5e-4], 4.892_283_7, 4.038_014_3),
        ([0.05, 1.0, 0.1, 1e-4, 1e-4], 2.154_356_2, 1.200_149_1),
        ([1.0, 0.9, 0.5, 1e-6, 9e-7], 3.811_081_1, 3.971_940_5),
    ] {
        let parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(izz);
        let hoop = Hoop::new(parameters.with_friction(mu_s, mu_k)).expect("a hoop");
        let inertia = hoop.body().inertia_about_mass_centre();
        let needed = 2.0 * hoop.lift_off_energy().expect("a heavy hoop");
        let at = |growth: f64| needed - growth * (needed - turning);
        let cases = [
            (1.1, 0.97, true),
            (1.1, 1.0001, false),
            (0.999, 0.97, false),
        ];
        for (turning, energy, is_proved) in
            cases.map(|(growth, part, is)| (at(growth), part * greatest, is))
        {
            // At the bottom.
            let rate = ((turning + 2.0 * offset) / inertia).sqrt();
            let velocity = ((2.0 * energy - turning) / hoop.mass()).sqrt();
            let slip = (1.0 - hoop.h()) * rate - velocity;
            let start = State {
                time: 0.0,
                theta: PI,
                theta_rate: rate,
                slip,
                x: 0.0,
            };
            assert_eq!(
                hoop.never_lifts_off(&start),
                is_proved,
                "{parameters:?} {turning} {energy}"
            );
        }
    }
}

#[test]
fn the_least_energy_of_a_lift_off_is_reached_at_the_top() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("Figure 2's hoop");
    let needed = hoop.lift_off_energy().expect("a heavy hoop");
    // Past the top by a little, a little faster than 1/√h, the mass centre at rest but for its
    // fall.
    let (theta, rate) = (1e-4_f64, -(2.0_f64.sqrt() + 1e-7));
    let slip = rate * (1.0 + 0.5 * theta.cos());
    let motion = hoop
        .simulate(Start::at(theta, rate).with_slip(slip), Limits::default())
        .expect("a start");
    assert_eq!(motion.phases()[0].mode(), Mode::Flight);
    let has = 0.5 * (2.0 * (0.5 * theta.sin() * rate).powi(2) + 1.5 * rate * rate) + theta.cos();
    assert!(has > needed && has < needed + 1e-6, "{has} {needed}");
}

#[test]
fn grazing_orbits_are_those_of_a_search_with_40_digits() {
    let orbits: Value =
        serde_json::from_str(include_str!("../../../evidence/reference/grazing.json"))
            .expect("the reference");
    let number = |value: &Value| {
        value
            .as_f64()
            .or_else(|| value.as_str()?.parse().ok())
            .expect("a number")
    };
    for expected in orbits["orbits"].as_array().expect("orbits") {
        let get = |name: &str| number(&expected["hoop"][name]);
        let parameters = HoopParameters::thin(get("mass_ratio"))
            .with_offset(get("offset"))
            .with_inertia(get("inertia"));
        let hoop = Hoop::new(parameters.with_friction(get("mu_s"), get("mu_k"))).expect("a hoop");
        let orbit =
            GrazingOrbit::below(&hoop, number(&expected["below"])).expect("a grazing orbit");
        for (name, ours) in [
            ("energy", orbit.energy),
            ("theta", orbit.theta),
            ("theta_rate", orbit.theta_rate),
        ] {
            let theirs = number(&expected[name]);
            assert!(
                (ours - theirs).abs() < 1e-13 * (1.0 + theirs.abs()),
                "{name} of {orbit:?}: {theirs}"
            );
        }
    }
}

/// Slips at one angle nearly cease, and before they do those at another begin: the motion passes
/// between, in thousands of slips.
#[test]
fn a_motion_passes_where_one_family_of_slips_nearly_ends_before_the_next_begins() {
    let mu = 0.129_598_662_207_357_86;
    let hoop = Hoop::equal_masses(mu, mu).expect("Figure 2's hoop");
    let excess = |k: i32| largest_excess(&hoop, 1.4 + 0.01 * f64::from(k));
    let least = (0..=100).map(excess).fold(f64::INFINITY, f64::min);
    // Every orbit slips, and those between hardly do.
    assert!(
        least > 0.0 && least < 0.1 * excess(0) && least < 0.1 * excess(100),
        "{least}"
    );

    let start = Start::at(PI / 2.0, -1.4);
    let motion = |limits: Limits| hoop.simulate(start, limits).expect("a start");
    let stopped = motion(Limits::default().with_transitions(10_000));
    let Outcome::StaysInContact { state } = stopped.outcome() else {
        panic!("{:?}", stopped.outcome())
    };
    let whole = motion(Limits::default().with_transitions(11_000));
    let Outcome::SlipsForever { orbit, .. } = whole.outcome() else {
        panic!("{:?}", whole.outcome())
    };
    assert!(energy(&hoop, &state) > 1.8 && orbit.energy < -0.8);
    let between = whole
        .transitions()
        .iter()
        .filter(|one| (1.8..2.2).contains(&energy(&hoop, &one.after)))
        .count();
    assert!(between > 9_000, "{between}");
}

/// At rest E = ℓ̂ cos θ: no lift-off is proved as far up as P > 0 in both directions of slip, and
/// not beyond.
#[test]
fn rest_is_proved_to_last_up_to_the_first_zero_of_p() {
    let (mut with, mut without) = (0, 0);
    for h in [0.05, 0.3, 0.7, 1.0] {
        for mu in [0.1, 0.8, 3.0] {
            // About the least with which P > 0 everywhere.
            let bound = 0.25 * mu * mu * (1.0 + h) * (1.0 + h);
            for part in [0.05, 0.3, 0.6, 0.9, 1.0 + 1e-6, 2.0] {
                let parameters = HoopParameters::thin(0.0)
                    .with_offset(h)
                    .with_inertia(bound * part);
                let hoop = Hoop::new(parameters.with_friction(mu, mu)).expect("a valid hoop");
                let laws = [SlipDirection::Negative, SlipDirection::Positive].map(|direction| {
                    SlidingLaw::new(&hoop, direction, RotationDirection::Positive).expect("heavy")
                });
                let first = (0..=20_000)
                    .map(|k| PI * (1.0 - f64::from(k) / 20_000.0))
                    .find(|theta| laws.iter().any(|law| law.painleve(*theta) <= 0.0));
                let is_proved =
                    |cos: f64| hoop.never_lifts_off(&State::from(Start::at(libm::acos(cos), 0.0)));
                if let Some(cos) = first.map(libm::cos) {
                    with += 1;
                    assert!(is_proved((cos - 1e-3).max(-1.0)), "{h} {mu} {part}");
                    assert!(!is_proved((cos + 1e-3).min(1.0)), "{h} {mu} {part}");
                } else {
                    without += 1;
                    assert!(is_proved(1.0), "{h} {mu} {part}");
                }
            }
        }
    }
    assert!(with > 20 && without > 20, "{with} {without}");
}
