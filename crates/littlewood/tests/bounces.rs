//! Flights, bounces and their end: against numbers of 25 digits from
//! `evidence/reference/bounces.py`, and by their invariants on random hoops.
#![allow(clippy::panic)] // a failed expectation

use crate::common::flight::{check_flights, check_landings};
use crate::common::{heavy_hoop, heavy_motion, instants, moderate_hoop, start};
use littlewood::cases::find_case;
use littlewood::impact::{BouncingOrbit, Impact, NoSettling};
use littlewood::modes::PhaseSolution;
use littlewood::theory::{BodyClass, EDGES};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, Restitution, RestitutionLaw,
    SlipDirection, Start, State, Trajectory,
};
use littlewood_random::Draw;
use proptest::prelude::*;
use serde_json::Value;

const BOUNCES: &str = include_str!("../../../evidence/reference/bounces.json");

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list: Vec<f64> = value
        .as_array()
        .expect("a list")
        .iter()
        .map(number)
        .collect();
    list.try_into().expect("as many numbers")
}

fn data(key: &str) -> Vec<Value> {
    let data: Value = serde_json::from_str(BOUNCES).expect("evidence/reference/bounces.json");
    data[key].as_array().expect("a list").clone()
}

fn thrown(value: &Value) -> Start {
    let [theta, theta_rate, slip, gap_rate] = numbers(value);
    Start::at(theta, theta_rate)
        .with_slip(slip)
        .with_gap_rate(gap_rate)
}

#[track_caller]
fn close(what: &str, ours: f64, theirs: &Value, tolerance: f64) {
    let theirs = number(theirs);
    assert!(
        (ours - theirs).abs() <= tolerance,
        "{what}: {ours:e} is not {theirs:e}, tolerance {tolerance:e}"
    );
}

#[test]
fn flights_land_where_the_general_solution_does() {
    for flight in data("flights") {
        let [mass_ratio, offset, inertia] = numbers(&flight["hoop"]);
        let hoop = Hoop::new(
            HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia),
        )
        .expect("a valid hoop");
        let start = thrown(&flight["start"]);
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let Outcome::Landing { state, gap_rate } = motion.outcome() else {
            panic!("{:?}", motion.outcome())
        };
        let expected = &flight["landing"];
        let time = number(&expected["time"]);
        // A short flight is known to its own digits, and where the gap closes slowly its end to
        // their quotient.
        let slow = (1.0 + start.gap_rate) / number(&expected["gap_rate"]).abs().max(1e-300);
        let digits = 4e-15 * time * (1.0 + start.theta_rate.abs()) * slow.clamp(1.0, 1e3);
        let of_angle = 4e-16 * (1.0 + state.theta.abs());
        let what = format!("{:?} {start:?}", hoop.parameters());
        close(
            &format!("{what} time"),
            state.time,
            &expected["time"],
            digits,
        );
        close(
            &format!("{what} theta"),
            state.theta,
            &expected["theta"],
            digits * start.theta_rate.abs() + of_angle,
        );
        close(
            &format!("{what} slip"),
            state.slip,
            &expected["slip"],
            10.0 * (digits + of_angle) * (1.0 + start.theta_rate * start.theta_rate),
        );
        close(
            &format!("{what} gap rate"),
            gap_rate,
            &expected["gap_rate"],
            4.0 * digits * (1.0 + start.theta_rate * start.theta_rate),
        );
    }
}

fn bouncing(record: &Value) -> (Hoop, Start) {
    let [mass_ratio, offset, inertia, mu_s, mu_k] = numbers(&record["hoop"]);
    let law = record["law"]
        .as_str()
        .expect("a law")
        .parse()
        .expect("a law");
    let hoop = HoopParameters::thin(mass_ratio)
        .with_offset(offset)
        .with_inertia(inertia)
        .with_friction(mu_s, mu_k)
        .with_restitution(number(&record["restitution"]), law);
    (
        Hoop::new(hoop).expect("a valid hoop"),
        thrown(&record["start"]),
    )
}

#[test]
fn bounces_settle_where_brute_force_at_80_digits_does() {
    for record in data("bounces") {
        let (hoop, start) = bouncing(&record);
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let settles = motion
            .transitions()
            .iter()
            .find(|it| it.cause == Cause::Settle);
        let end = settles.unwrap_or_else(|| panic!("settles: {record}")).after;
        let expected = &record["end"];
        let what = record.to_string();
        let size = start.theta_rate.abs().max(1.0);
        close(&what, end.time, &expected["time"], 1e-12 / size);
        close(&what, end.theta, &expected["theta"], 1e-12);
        close(&what, end.theta_rate, &expected["theta_rate"], 1e-12 * size);
        close(&what, end.slip, &expected["slip"], 1e-12 * size);
        assert_eq!(
            end.slip == 0.0,
            record["sticks"].as_bool().expect("a flag"),
            "{what}"
        );
    }
}

/// Numbers of the notes on Figure 3 with e = 0.5, from brute force at 40 digits.
#[test]
fn figure_3_settles_and_rolls() {
    let motion = find_case("figure-3-bounces")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let settled = motion.transitions().last().expect("settles");
    assert_eq!(
        (settled.cause, settled.from, settled.to),
        (Cause::Settle, Some(Mode::Flight), Some(Mode::Rolling))
    );
    assert!((settled.after.time - 6.924_682_083_018_514).abs() < 1e-12);
    assert!((settled.after.theta - 15.456_846_136_060_914).abs() < 1e-12);
    assert!((settled.after.theta_rate - 2.200_410_542_903_205).abs() < 1e-12);
    assert_eq!(settled.after.slip, 0.0);
    let rolls = motion.phases().last().expect("rolls").first();
    assert!((rolls.normal - 6.515_077_719).abs() < 1e-9);
    assert!((rolls.friction.abs() / rolls.normal - 0.073_26).abs() < 5e-6);
    let restitution = motion.hoop().restitution().expect("has restitution");
    let settling = motion
        .hoop()
        .settling(&settled.after, 1e-12, restitution)
        .expect("settles");
    assert!((settling.ratio - 0.492_024_505_882_643).abs() < 1e-12);
}

/// Wherever the sum of the bounces takes over, it leads to the same state but for the square of the
/// time it covers.
#[test]
fn the_end_does_not_depend_on_where_the_sum_takes_over() {
    // The light hoops' motions have no derivatives of order one.
    for record in data("bounces")
        .into_iter()
        .filter(|record| number(&record["hoop"][2]) > 1e-3)
    {
        let (hoop, start) = bouncing(&record);
        let restitution = hoop.restitution().expect("has restitution");
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let expected = &record["end"];
        let end = ["time", "theta", "theta_rate", "slip"].map(|key| number(&expected[key]));
        let mut seen = 0;
        for transition in motion
            .transitions()
            .iter()
            .filter(|it| it.cause == Cause::Landing)
        {
            let from = transition.after;
            let left = end[0] - from.time;
            if !(1e-7..1e-3).contains(&left) {
                continue;
            }
            let opening = transition.impact.expect("an impact").after.gap_rate;
            let settling = hoop.settling(&from, opening, restitution).expect("settles");
            let theta = from.theta + from.theta_rate * settling.duration;
            let found = [
                from.time + settling.duration,
                theta,
                settling.impact.after.theta_rate,
                settling.impact.after.slip,
            ];
            for (ours, theirs) in found.into_iter().zip(end) {
                // The second derivatives of these motions are of order one, but for the light
                // hoop's.
                let bound = 1e-12 + 100.0 * left * left;
                assert!(
                    (ours - theirs).abs() < bound,
                    "{record}: {left:e} before the end {ours} is not {theirs}"
                );
            }
            seen += 1;
        }
        assert!(seen > 3, "{record}");
    }
}

/// A bounce is as short as the plane presses hard, by W ≤ 1 + h θ′².
#[test]
fn short_bounces_settle_at_once_where_the_hoop_presses_hard() {
    let parameters = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let hoop =
        Hoop::new(parameters.with_restitution(0.5, RestitutionLaw::Energetic)).expect("heavy");
    let start = Start::at(core::f64::consts::PI, 30.0).with_gap_rate(2.5e-7);
    let motion = hoop
        .simulate(start, Limits::default().with_transitions(1))
        .expect("a valid start");
    assert_eq!(motion.transitions()[0].cause, Cause::Settle);
}

fn restitution() -> impl Strategy<Value = Restitution> {
    let coefficient = prop_oneof![2 => Just(0.0), 4 => 0.0..=1.0_f64, 1 => Just(1.0), 1 => 0.0..1e-9_f64, 1 => 0.95..=1.0_f64];
    (
        coefficient,
        prop::sample::select(RestitutionLaw::ALL.to_vec()),
    )
        .prop_map(|(e, law)| Restitution::new(e, law).expect("between 0 and 1"))
}

/// Starts at rest against the plane, and thrown from it, fast and hardly.
fn throw() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 2 => 0.0..3.0_f64, 1 => (-12.0..0.0_f64).prop_map(|exponent| libm::pow(10.0, exponent))]
}

/// No rolling resistance, a little, and much.
fn resistance() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(0.0), 2 => 0.0..1.0_f64, 1 => (-9.0..1.0_f64).prop_map(libm::exp10)]
}

fn bouncing_motion() -> impl Strategy<Value = (Hoop, Start)> {
    (heavy_motion(), restitution(), throw(), resistance()).prop_map(
        |((hoop, start), restitution, gap_rate, chi)| {
            let parameters = hoop.parameters().with_rolling_resistance(chi);
            let hoop = Hoop::new(parameters).expect("a valid hoop");
            (
                hoop.with_restitution(restitution).expect("heavy"),
                start.with_gap_rate(gap_rate),
            )
        },
    )
}

fn follow(hoop: &Hoop, start: Start) -> Trajectory {
    let limits = Limits::until(start.time + 20.0).with_transitions(80);
    hoop.simulate(start, limits).expect("a valid start")
}

/// The largest energies that come up in a motion, for rounding errors to be measured by.
fn size(motion: &Trajectory) -> f64 {
    let start = motion.start();
    let rate = motion
        .transitions()
        .iter()
        .flat_map(|it| [it.before, it.after])
        .chain([start])
        .fold(0.0_f64, |size, state| {
            size.max(state.theta_rate.abs()).max(state.slip.abs())
        });
    1.0 + motion.hoop().mass() * (1.0 + 4.0 * rate * rate)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(800))]

    #[test]
    fn motions_go_on_from_each_impact_with_what_it_leaves((hoop, start) in bouncing_motion()) {
        let motion = follow(&hoop, start);
        let kind = motion.outcome().kind();
        prop_assert!(kind != OutcomeKind::Landing && kind != OutcomeKind::Singular);
        let size = size(&motion);
        for it in motion.transitions() {
            let its = (BodyClass::Heavy, it.from, it.cause, it.to);
            let is_edge = EDGES.iter().any(|edge| (edge.body, edge.from, edge.cause, edge.to) == its);
            prop_assert!(is_edge, "{it:?} is no edge");
        }
        for (index, phase) in motion.phases().iter().enumerate() {
            let Some(event) = motion.end_of(phase) else {
                prop_assert_eq!(index + 1, motion.phases().len());
                continue;
            };
            prop_assert_eq!(Some(phase.mode()), event.from);
            prop_assert_eq!(phase.end(), Some(event.before));
            let Some(next) = motion.phases().get(index + 1) else { continue };
            prop_assert_eq!(next.start().time, event.after.time);
            if let Some(impact) = event.impact {
                prop_assert_eq!(next.start(), event.after);
                prop_assert_eq!(event.after.slip, impact.after.slip);
                prop_assert_eq!(event.after.theta_rate, impact.after.theta_rate);
                // θ, x and the time do not jump.
                prop_assert_eq!(
                    (event.after.theta, event.after.x, event.after.time),
                    (event.before.theta, event.before.x, event.before.time)
                );
                prop_assert!(impact.after.gap_rate >= 0.0 && impact.impulse.normal >= 0.0);
                let lost = phase.last().expect("an end").energy - next.first().energy;
                prop_assert!(
                    (lost - impact.energy_lost()).abs() <= 1e-11 * size,
                    "{} {lost} {}", event.cause, impact.energy_lost()
                );
                if hoop.restitution().expect("has it").law() != RestitutionLaw::Newton {
                    prop_assert!(impact.energy_lost() >= -1e-13 * size, "{impact:?}");
                }
            }
        }
    }

    #[test]
    fn flights_are_above_the_plane_and_end_at_it((hoop, start) in bouncing_motion()) {
        let motion = follow(&hoop, start);
        check_landings(&motion);
        check_flights(&motion);
        for phase in motion.phases() {
            let PhaseSolution::Flight(flight) = phase.solution() else { continue };
            let duration = flight.duration();
            let (at, height) = flight.apex();
            prop_assert!((0.0..=duration).contains(&at) && height >= 0.0);
        }
    }

    #[test]
    fn a_landing_is_where_it_is_without_restitution((hoop, start) in heavy_motion(), restitution in restitution()) {
        let plain = follow(&hoop, start);
        let bouncing = follow(&hoop.with_restitution(restitution).expect("heavy"), start);
        for (ours, theirs) in plain.transitions().iter().zip(bouncing.transitions()) {
            prop_assert_eq!((ours.before, ours.from, ours.cause), (theirs.before, theirs.from, match theirs.cause {
                Cause::Jam => Cause::Singularity,
                cause => cause,
            }));
            if theirs.impact.is_some() {
                break;
            }
            prop_assert_eq!((ours.to, ours.direction), (theirs.to, theirs.direction));
        }
    }

    #[test]
    fn the_jump_of_a_summary_is_the_first_flight((hoop, start) in bouncing_motion()) {
        let motion = follow(&hoop, start);
        let summary = motion.summary();
        let flight = motion.phases().iter().find(|phase| phase.mode() == Mode::Flight);
        let lift_off = flight.map_or(f64::NAN, |flight| flight.start().time);
        prop_assert!(summary.lift_off_time == lift_off || (lift_off.is_nan() && summary.lift_off_time.is_nan()));
        let landed = flight.filter(|flight| motion.end_of(flight).is_some_and(|end| end.cause == Cause::Landing));
        let Some((flight, end)) = landed.and_then(|flight| Some((flight, flight.end()?))) else {
            // Later flights, behind bounces that have settled, are no first jump either; where none
            // lands there is none.
            prop_assert!(summary.landings > 0 || summary.jump_length.is_nan());
            return Ok(());
        };
        prop_assert_eq!(summary.jump_length, (end.x - flight.start().x).abs());
        let highest = instants(flight.duration(), 400).map(|elapsed| flight.sample(elapsed).gap).fold(0.0, f64::max);
        // The gap bends by no more than 1 + h θ′².
        let (rate, step) = (flight.start().theta_rate, flight.duration() / 400.0);
        let missed = (1.0 + hoop.h() * rate * rate) * step * step;
        let rounding = 1e-13 * (1.0 + flight.duration() * flight.duration());
        prop_assert!(summary.jump_height >= highest - rounding, "{} {highest}", summary.jump_height);
        prop_assert!(summary.jump_height <= highest + missed + rounding, "{} {highest}", summary.jump_height);
    }

    #[test]
    fn the_summary_of_bounces_has_the_numbers_of_the_motion((hoop, start) in bouncing_motion()) {
        let motion = follow(&hoop, start);
        let summary = motion.summary();
        let landings = motion.transitions().iter().filter(|it| it.cause == Cause::Landing).count();
        prop_assert_eq!(u32::try_from(landings), Ok(summary.landings));
        let impacts: f64 = motion.transitions().iter().filter_map(|it| it.impact).map(|it| it.energy_lost()).sum();
        prop_assert_eq!(impacts + 0.0, summary.impact_energy_lost);
        let last_flight = motion.phases().iter().rposition(|phase| phase.mode() == Mode::Flight);
        match last_flight.map(|index| motion.end_of(&motion.phases()[index])) {
            Some(Some(end)) if end.impact.is_some() && end.to != Some(Mode::Flight) => {
                prop_assert_eq!(summary.settle_time, end.time());
            }
            Some(Some(_) | None) | None => prop_assert!(summary.settle_time.is_nan()),
        }
    }
}

/// Two symmetric flights a turn, without slip, for ever: the numbers at φ = 2.2 from the three
/// equations at 40 digits.
#[test]
fn the_motion_that_bounces_for_ever_has_the_numbers_of_its_equations() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("a valid hoop");
    let orbit = BouncingOrbit::new(&hoop, 2.2).expect("bounces");
    assert!((orbit.top_rate - 1.239_306_550_206_238_1).abs() < 1e-15);
    assert!((orbit.bottom_rate - 1.969_158_481_963_356).abs() < 1e-15);
    assert!((orbit.gap_rate - 1.274_198_847_857_927_4).abs() < 1e-15);
    let case = find_case("bounces-forever").expect("a case");
    let start = case.setup.start;
    assert_eq!(
        (orbit.start().theta, orbit.start().slip),
        (start.theta, start.slip)
    );
    assert!((orbit.start().theta_rate - start.theta_rate).abs() < 1e-15);
    assert!((orbit.start().gap_rate - start.gap_rate).abs() < 1e-15);
    let hoop = Hoop::new(case.setup.hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(case.setup.start, Limits::until(1000.0))
        .expect("a valid start");
    assert_eq!(motion.outcome().kind(), OutcomeKind::TimeLimit);
    for (index, landing) in motion.transitions().iter().enumerate() {
        assert_eq!(
            (landing.cause, landing.to),
            (Cause::Landing, Some(Mode::Flight))
        );
        assert!(landing.before.slip.abs() < 1e-11, "{landing:?}");
        let impact = landing.impact.expect("an impact");
        assert!(
            impact.energy_lost().abs() < 1e-11
                && (impact.after.gap_rate - orbit.gap_rate).abs() < 1e-11
        );
        let turns = 0.5 * (index as f64 + 1.0 - (index % 2) as f64);
        let half = if index % 2 == 0 {
            2.0 * orbit.angle / orbit.top_rate - 0.5 * orbit.period()
        } else {
            0.0
        };
        let expected = turns * orbit.period()
            + half
            + if index % 2 == 0 {
                0.0
            } else {
                0.5 * orbit.period()
            };
        assert!(
            (landing.time() - expected).abs() < 1e-9,
            "{index}: {} {expected}",
            landing.time()
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// The gap of both flights, from the parabola of the mass centre, is open at every instant but
    /// their ends.
    #[test]
    fn motions_that_bounce_for_ever_are_above_the_plane(hoop in moderate_hoop(), angle in 0.05..3.1_f64) {
        let Some(orbit) = BouncingOrbit::new(&hoop, angle) else { return Ok(()) };
        for (rate, half, middle) in
            [(orbit.top_rate, angle, 0.0), (orbit.bottom_rate, std::f64::consts::PI - angle, std::f64::consts::PI)]
        {
            for i in 0..50 {
                let (end, at) = (half / rate, half / rate * f64::from(i) / 50.0);
                let rim = |time: f64| hoop.h() * libm::cos(middle + rate * time);
                let gap = 0.5 * (end * end - at * at) + rim(end) - rim(at);
                prop_assert!(gap > 0.0, "{gap} at {at} of {end}: {orbit:?}");
            }
        }
    }

    #[test]
    fn motions_that_bounce_for_ever_come_back(hoop in moderate_hoop(), angle in 0.05..3.1_f64) {
        let Some(orbit) = BouncingOrbit::new(&hoop, angle) else { return Ok(()) };
        // Rough enough for the impacts to stick.
        let (mu_s, parameters) = (orbit.friction + 0.1, hoop.parameters());
        let parameters =
            parameters.with_friction(mu_s, mu_s).with_restitution(1.0, RestitutionLaw::Energetic);
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let limits = Limits::default().with_transitions(2);
        let motion = hoop.simulate(orbit.start(), limits).expect("a valid start");
        let [top, bottom] = motion.transitions() else { panic!("two flights: {:?}", motion.transitions()) };
        let size = 1.0 + orbit.bottom_rate + orbit.period();
        let near = |a: f64, b: f64| (a - b).abs() < 1e-10 * size * size;
        prop_assert!(near(top.after.theta, orbit.angle) && near(top.after.theta_rate, orbit.bottom_rate), "{top:?} {orbit:?}");
        prop_assert!(near(bottom.after.theta, std::f64::consts::TAU - orbit.angle), "{bottom:?} {orbit:?}");
        prop_assert!(near(bottom.after.theta_rate, orbit.top_rate) && near(bottom.time(), orbit.period()));
        for impact in [top.impact, bottom.impact].into_iter().flatten() {
            prop_assert!(near(impact.before.slip, 0.0) && near(impact.energy_lost(), 0.0));
            prop_assert!(near(impact.after.gap_rate, orbit.gap_rate));
        }
    }

    /// No reverse chatter: the drift of the slip in flight is against sign B, where k1 = C + μk |B|
    /// exceeds k2.
    #[test]
    fn bounces_shrink_by_the_coefficient_of_restitution_at_least(
        hoop in heavy_hoop(), start in start(), restitution in restitution(), v in 1e-12..1e-3_f64, still in any::<bool>(),
    ) {
        let state = State::from(if still { start.with_slip(0.0) } else { start });
        match hoop.settling(&state, v, restitution) {
            Ok(settling) => {
                prop_assert!(settling.ratio <= restitution.coefficient() * (1.0 + 1e-12) && settling.ratio < 1.0);
                prop_assert!(settling.duration > 0.0 && settling.impact.impulse.normal > 0.0);
                // The velocities answer to the sum of the impulses as to one impulse: u′ − u = A
                // J + B P, w′ − w = B J + C P.
                let Impact { before, after, impulse, .. } = settling.impact;
                let compliance = hoop.compliance(state.theta).expect("heavy");
                let (j, p) = (impulse.friction, impulse.normal);
                for (change, size, answer) in [
                    (after.slip - before.slip, after.slip.abs() + before.slip.abs(), [compliance.a * j, compliance.b * p]),
                    (after.gap_rate - before.gap_rate, before.gap_rate.abs(), [compliance.b * j, compliance.c * p]),
                ] {
                    let size = size + answer[0].abs() + answer[1].abs();
                    prop_assert!((change - answer[0] - answer[1]).abs() <= 1e-9 * size, "{:?} {:?}", settling, compliance);
                }
            }
            Err(NoSettling::Grows { ratio }) => {
                prop_assert!(restitution.coefficient() > 1.0 - 1e-12 && ratio > 1.0 - 1e-12);
            }
            Err(NoSettling::Unsettled { .. }) => prop_assert!(restitution.coefficient() > 0.98, "{:?}", restitution),
            Err(other) => prop_assert!(matches!(other, NoSettling::LeavesPlane { .. }), "{other}"),
        }
    }

    /// Where bounces stick, from k1, k2 and the slip that each flight adds: e = 1 settles where
    /// they differ, by the energetic law and by Poisson's, and so does a motion thrown by so little
    /// that the sum is short. By Newton's law nothing shrinks.
    #[test]
    fn with_restitution_1_friction_makes_bounces_settle(
        hoop in moderate_hoop(), theta in -3.1..3.1_f64, rate in -2.0..2.0_f64,
    ) {
        let compliance = hoop.compliance(theta).expect("heavy");
        let (a, b, c) = (compliance.a, compliance.b, compliance.c);
        let u = rate * rate;
        let (force, drift) = (1.0 - hoop.h() * libm::cos(theta) * u, -hoop.h() * libm::sin(theta) * u);
        prop_assume!(force > 1e-3 && b.abs() < 0.99 * hoop.mu_s() * a);
        // Slip before each impact and the impulse that ends it, for the rate 1.
        let slip = 2.0 * drift / force;
        let (k1, k2) = (c - hoop.mu_k() * slip.signum() * b, c - b * b / a);
        let slowing = hoop.mu_k() * a - slip.signum() * b;
        let spent = slip.abs() / slowing;
        prop_assume!(slowing > 0.0 && k1 * spent < 1.99);
        let state = State::from(Start::at(theta, rate));
        for law in RestitutionLaw::ALL {
            let ratio = match law {
                RestitutionLaw::Energetic => (1.0 - (k1 - k2) * spent * (2.0 - k1 * spent)).sqrt(),
                RestitutionLaw::Poisson => 1.0 - (k1 - k2) * spent.min(2.0 / k1 - spent),
                RestitutionLaw::Newton => 1.0,
            };
            for e in [1.0, 1.0 - 1e-12] {
                let restitution = Restitution::new(e, law).expect("a coefficient");
                let found = hoop.settling(&state, 1e-9, restitution);
                if ratio < 1.0 - 1e-9 {
                    let settling = found.expect("settles");
                    prop_assert!((settling.ratio - ratio).abs() < 1e-11, "{law} {} {ratio}", settling.ratio);
                    let thrown = 1e-9 * (1e-10 / settling.duration);
                    let bouncing = hoop.with_restitution(restitution).expect("heavy");
                    let motion = bouncing.simulate(Start::at(theta, rate).with_gap_rate(thrown), Limits::default().with_transitions(1));
                    let motion = motion.expect("a valid start");
                    prop_assert_eq!(motion.transitions()[0].cause, Cause::Settle);
                    prop_assert!((motion.transitions()[0].time() - 1e-10).abs() < 1e-13);
                } else if e == 1.0 && law == RestitutionLaw::Newton {
                    prop_assert!(matches!(found, Err(NoSettling::Grows { .. })), "{found:?}");
                }
            }
        }
    }

    /// Without friction, by Newton's law, and while they slip, bounces give back all that they
    /// take.
    #[test]
    fn bounces_without_loss_go_on_to_the_limit(
        hoop in moderate_hoop(), theta in -3.1..3.1_f64, rate in -2.0..2.0_f64, slip in -1.0..1.0_f64, exponent in -14.0..0.0_f64,
        law in prop::sample::select(RestitutionLaw::ALL.to_vec()), smooth in any::<bool>(),
    ) {
        let restitution = Restitution::new(1.0, law).expect("a coefficient");
        let parameters = hoop.parameters();
        let smooth = smooth || law != RestitutionLaw::Newton;
        let hoop = if smooth {
            Hoop::new(parameters.with_friction(0.0, 0.0)).expect("the hoop")
        } else {
            hoop
        };
        let hoop = hoop.with_restitution(restitution).expect("heavy");
        let start = Start::at(theta, rate).with_slip(slip).with_gap_rate(libm::pow(10.0, exponent));
        let motion = hoop.simulate(start, Limits::default().with_transitions(300)).expect("a valid start");
        prop_assert_eq!(motion.outcome().kind(), OutcomeKind::TransitionLimit, "{:?}", motion.outcome());
        prop_assert!(motion.transitions().iter().all(|it| it.cause == Cause::Landing));
    }

    #[test]
    fn bounces_that_are_each_as_fast_as_the_last_do_not_settle(hoop in heavy_hoop(), start in start(), v in 1e-9..1e-3_f64) {
        let state = State::from(start.with_slip(0.0));
        let elastic = Restitution::new(1.0, RestitutionLaw::Newton).expect("a coefficient");
        prop_assert!(hoop.settling(&state, v, elastic).is_err());
        let closed = hoop.settling(&state, 0.0, elastic);
        prop_assert_eq!(closed, Err(NoSettling::Closed { gap_rate: 0.0 }));
    }
}

/// The first phase that is longer than bounces at these rates.
fn first_lasting(motion: &Trajectory) -> Option<(Mode, Option<SlipDirection>, f64)> {
    let phase = motion.phases().iter().find(|it| it.duration() > 1e-12)?;
    let end = phase.end().map_or(f64::INFINITY, |end| end.theta);
    Some((phase.mode(), phase.direction(), end))
}

/// Bounces of a hoop that is thrown by next to nothing depend on the ratio of their velocities
/// only: they settle, or grow, as do those at 1e-100. Below the least normal number, those that do
/// not settle say that they underflow.
#[test]
fn bounces_settle_or_grow_whatever_their_size() {
    let (mut grow, mut settle, mut underflow) = (0, 0, 0);
    for case in 0..600 {
        let mut draw = Draw::of_case(51, 0, case);
        let mu_s = draw.of_any_size([-2.0, 1.0]);
        let share = if draw.comes(0.5) { 1.0 } else { draw.share() };
        let coefficient = draw.one_of(&[0.0, 0.3, 0.5, 0.9, 1.0]);
        let mut often_zero = |range| {
            if draw.comes(0.5) {
                0.0
            } else {
                draw.between(range)
            }
        };
        let [slope, rate, slip] = [[-1.0, 1.0], [-3.0, 3.0], [-1.0, 1.0]].map(&mut often_zero);
        let hoop = HoopParameters::thin(draw.of_any_size([-3.0, 3.0]))
            .with_offset(draw.between([0.05, 1.0]))
            .with_friction(mu_s, mu_s * share)
            .with_slope(slope)
            .with_restitution(coefficient, draw.one_of(RestitutionLaw::ALL.as_slice()));
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let start = Start::at(draw.between([-3.1, 3.1]), rate).with_slip(slip);
        let thrown = |gap_rate: f64| {
            let limits = Limits::until(20.0).with_transitions(4000);
            let motion = hoop.simulate(start.with_gap_rate(gap_rate), limits);
            motion.expect("a valid start")
        };
        let expected = thrown(1e-100);
        for gap_rate in [1e-200, 1e-300, 1e-320, 5e-324] {
            let motion = thrown(gap_rate);
            let settles =
                matches!(motion.transitions(), [first, ..] if first.cause == Cause::Settle);
            let kind = motion.outcome().kind();
            if gap_rate.is_subnormal() && kind == OutcomeKind::Unresolved {
                assert!(!settles && motion.outcome().state().time < 1e-300);
                underflow += 1;
                continue;
            }
            match (first_lasting(&expected), first_lasting(&motion)) {
                (Some(theirs), Some(ours)) => {
                    let near = ours.2 == theirs.2 || (ours.2 - theirs.2).abs() < 1e-6;
                    assert!(
                        near && (ours.0, ours.1) == (theirs.0, theirs.1),
                        "{hoop:?} {start:?} {gap_rate:e}: {ours:?} {theirs:?}"
                    );
                    settle += usize::from(settles);
                    grow += usize::from(!settles);
                }
                // As fast as each other, or not yet grown.
                (_, None) => assert_eq!(kind, OutcomeKind::TransitionLimit, "{hoop:?} {start:?}"),
                (None, Some(ours)) => panic!("{hoop:?} {start:?} {gap_rate:e}: {ours:?}"),
            }
        }
    }
    assert!(
        grow > 20 && settle > 1000 && underflow > 20,
        "{grow} {settle} {underflow}"
    );
}

/// Velocities of all sizes, in powers of two: all numbers but those that underflow are the same.
/// Bounces at a fixed angle, one by one: what they sum up to, and their last gap rate.
struct OneByOne {
    duration: f64,
    after: [f64; 2],
    impulse: [f64; 2],
    works: [f64; 3],
    /// Whether the rotation has ended in a bounce.
    stops: bool,
    gap_rate: f64,
    ratio: f64,
}

impl OneByOne {
    fn follow(hoop: &Hoop, start: &State, opening: f64, e: Restitution) -> Option<Self> {
        let (sin, cos) = libm::sincos(start.theta);
        let u = start.theta_rate * start.theta_rate;
        let weight = libm::cos(hoop.slope()) - hoop.h() * cos * u;
        let drift = -hoop.h() * sin * u - libm::sin(hoop.slope());
        let mut sum = Self {
            duration: 0.0,
            after: [start.theta_rate, start.slip],
            impulse: [0.0; 2],
            works: [0.0; 3],
            stops: false,
            gap_rate: opening,
            ratio: 0.0,
        };
        for _ in 0..100_000 {
            let flight = 2.0 * sum.gap_rate / weight;
            let [theta_rate, slip] = sum.after;
            let state = State {
                theta_rate,
                slip: slip + drift * flight,
                ..*start
            };
            let found = hoop.impact(&state, -sum.gap_rate, e).ok()?;
            sum.duration += flight;
            sum.after = [found.after.theta_rate, found.after.slip];
            sum.impulse[0] += found.impulse.normal;
            sum.impulse[1] += found.impulse.friction;
            sum.works[0] += found.normal_work;
            sum.works[1] += found.friction_work;
            sum.works[2] += found.resistance_work;
            sum.stops |= theta_rate != 0.0 && theta_rate * found.after.theta_rate <= 0.0;
            sum.ratio = found.after.gap_rate / sum.gap_rate;
            sum.gap_rate = found.after.gap_rate;
            if sum.gap_rate < 1e-22 * opening {
                break;
            }
        }
        Some(sum)
    }
}

/// With rolling resistance, on slopes, too; the rotation fast, as slow as the bounces, or none.
#[test]
fn bounces_with_rolling_resistance_sum_up_as_one_by_one() {
    let (mut settled, mut grown) = ([0; 3], 0);
    for number in 0..6_000 {
        let mut draw = Draw::of_case(54, 2, number);
        let mu_s = draw.between([0.0, 1.5]);
        let steep = draw.between([-0.8, 0.8]);
        let slope = draw.one_of(&[0.0, steep]);
        let chi = draw.of_any_size([-2.0, 0.3]);
        let parameters = HoopParameters::thin(draw.between([0.2, 3.0]))
            .with_offset(draw.between([0.2, 1.0]))
            .with_inertia(draw.between([0.2, 3.0]))
            .with_friction(mu_s, mu_s * draw.share())
            .with_rolling_resistance(chi)
            .with_slope(slope);
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let opening = 1e-9;
        let mut velocity = || {
            let slow = opening * draw.between([-3.0, 3.0]);
            let fast = draw.between([-1.0, 1.0]);
            draw.one_of(&[0.0, slow, slow, fast])
        };
        let [rate, slip] = [velocity(), velocity()];
        let state = State::from(Start::at(draw.between([-3.1, 3.1]), rate).with_slip(slip));
        let law = draw.one_of(RestitutionLaw::ALL.as_slice());
        let e = Restitution::new(draw.between([0.0, 0.95]), law).expect("a coefficient");
        let Some(one_by_one) = OneByOne::follow(&hoop, &state, opening, e) else {
            continue;
        };
        match hoop.settling(&state, opening, e) {
            Ok(settling) => {
                assert!(
                    one_by_one.gap_rate < 1e-15 * opening,
                    "{state:?} {hoop:?} {e:?}"
                );
                let Impact {
                    after,
                    impulse,
                    normal_work,
                    friction_work,
                    resistance_work,
                    ..
                } = settling.impact;
                let small = opening * (1.0 + one_by_one.duration / opening);
                let speed = small + rate.abs() + slip.abs();
                for (ours, theirs, size) in [
                    (settling.duration, one_by_one.duration, small),
                    (
                        after.theta_rate,
                        one_by_one.after[0],
                        small + 1e-3 * rate.abs(),
                    ),
                    (after.slip, one_by_one.after[1], small + 1e-3 * slip.abs()),
                    (impulse.normal, one_by_one.impulse[0], small),
                    (impulse.friction, one_by_one.impulse[1], small),
                    (normal_work, one_by_one.works[0], small * small),
                    (friction_work, one_by_one.works[1], small * speed),
                    (resistance_work, one_by_one.works[2], small * speed),
                ] {
                    assert!(
                        (ours - theirs).abs() <= 1e-10 * size,
                        "{ours:e} {theirs:e} {size:e}\n{settling:?}\n{state:?} {hoop:?} {e:?}"
                    );
                }
                let kind = match (one_by_one.stops, rate == 0.0) {
                    (true, _) => 0,
                    (false, true) => 1,
                    (false, false) => 2,
                };
                settled[kind] += 1;
            }
            Err(NoSettling::Grows { ratio }) => {
                assert!(one_by_one.ratio > 1.0 - 1e-12, "{state:?} {hoop:?} {e:?}");
                assert!((ratio - one_by_one.ratio).abs() < 1e-9 * ratio, "{ratio}");
                grown += 1;
            }
            Err(error) => panic!("{error} {state:?} {hoop:?} {e:?}"),
        }
    }
    assert!(
        settled.iter().all(|count| *count > 300) && grown > 0,
        "{settled:?} {grown}"
    );
}

#[test]
fn the_sum_of_bounces_is_the_same_in_all_units_of_velocity() {
    for case in 0..2_000 {
        let mut draw = Draw::of_case(51, 1, case);
        let (hoop, start) = draw.in_contact();
        let e = draw.share();
        let law = draw.one_of(RestitutionLaw::ALL.as_slice());
        let restitution = Restitution::new(e, law).expect("a coefficient");
        let theta = start.theta;
        // In units of the least number, too.
        let slip = draw.one_of(&[0.0, 0.0, -1.0, 1.0, 2.0]);
        // The rate of the angle determines the forces.
        let settling = |unit: f64| {
            let state = State::from(Start::at(theta, 0.0).with_slip(slip * unit));
            hoop.settling(&state, unit, restitution)
        };
        let Ok(ours) = settling(1.0) else { continue };
        for exponent in [-1074, -1022, -700, -400, -200, 200] {
            let unit = libm::scalbn(1.0, exponent);
            let theirs = settling(unit).expect("settles");
            assert_eq!(ours.ratio.to_bits(), theirs.ratio.to_bits());
            let after = theirs.impact.after;
            for (ours, theirs) in [
                (ours.duration, theirs.duration),
                (ours.impact.after.slip, after.slip),
                (ours.impact.after.theta_rate, after.theta_rate),
                (ours.impact.impulse.normal, theirs.impact.impulse.normal),
                (ours.impact.impulse.friction, theirs.impact.impulse.friction),
            ] {
                let difference = (ours * unit - theirs).abs();
                assert!(
                    difference <= f64::from_bits(1),
                    "{exponent} {ours} {theirs:e}"
                );
            }
            assert_eq!(after.slip == 0.0, ours.impact.after.slip == 0.0);
        }
    }
}
