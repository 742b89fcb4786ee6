//! Flights, bounces and their end: against numbers of 25 digits from `reference/bounces.py`, and by their invariants on random
//! hoops.
#![allow(clippy::panic)] // a failed expectation

mod common;

use common::{heavy_hoop, moderate_hoop, start};
use littlewood::{
    BouncingOrbit, Cause, Engine, Hoop, HoopParameters, Limits, Mode, NoSettling, Outcome, OutcomeKind,
    PhaseSolution, Restitution, RestitutionLaw, Start, State, Trajectory, find_case,
};
use proptest::prelude::*;
use serde_json::Value;

const BOUNCES: &str = include_str!("../../../reference/bounces.json");

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list: Vec<f64> = value.as_array().expect("a list").iter().map(number).collect();
    list.try_into().expect("as many numbers")
}

fn data(key: &str) -> Vec<Value> {
    let data: Value = serde_json::from_str(BOUNCES).expect("reference/bounces.json");
    data[key].as_array().expect("a list").clone()
}

fn thrown(value: &Value) -> Start {
    let [theta, theta_rate, slip, gap_rate] = numbers(value);
    Start::at(theta, theta_rate).with_slip(slip).with_gap_rate(gap_rate)
}

#[track_caller]
fn close(what: &str, ours: f64, theirs: &Value, tolerance: f64) {
    let theirs = number(theirs);
    assert!((ours - theirs).abs() <= tolerance, "{what}: {ours:e} is not {theirs:e}, tolerance {tolerance:e}");
}

#[test]
fn flights_land_where_the_general_solution_does() {
    for flight in data("flights") {
        let [mass_ratio, offset, inertia] = numbers(&flight["hoop"]);
        let hoop = Hoop::new(HoopParameters::new(mass_ratio, offset, inertia)).expect("a valid hoop");
        let start = thrown(&flight["start"]);
        let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
        let Outcome::Landing { state, gap_rate } = motion.outcome() else { panic!("{:?}", motion.outcome()) };
        let expected = &flight["landing"];
        let time = number(&expected["time"]);
        // A short flight is known to its own digits, and where the gap closes slowly its end to their quotient.
        let slow = (1.0 + start.gap_rate) / number(&expected["gap_rate"]).abs().max(1e-300);
        let digits = 4e-15 * time * (1.0 + start.theta_rate.abs()) * slow.clamp(1.0, 1e3);
        let of_angle = 4e-16 * (1.0 + state.theta.abs());
        let what = format!("{:?} {start:?}", hoop.parameters());
        close(&format!("{what} time"), state.time, &expected["time"], digits);
        close(
            &format!("{what} theta"),
            state.theta,
            &expected["theta"],
            digits * start.theta_rate.abs() + of_angle,
        );
        close(&format!("{what} slip"), state.slip, &expected["slip"], 10.0 * (digits + of_angle) * (1.0 + start.theta_rate.powi(2)));
        close(
            &format!("{what} gap rate"),
            gap_rate,
            &expected["gap_rate"],
            4.0 * digits * (1.0 + start.theta_rate.powi(2)),
        );
    }
}

fn bouncing(record: &Value) -> (Hoop, Start) {
    let [mass_ratio, offset, inertia, mu_s, mu_k] = numbers(&record["hoop"]);
    let law = record["law"].as_str().expect("a law").parse().expect("a law");
    let hoop = HoopParameters::new(mass_ratio, offset, inertia)
        .with_friction(mu_s, mu_k)
        .with_restitution(number(&record["restitution"]), law);
    (Hoop::new(hoop).expect("a valid hoop"), thrown(&record["start"]))
}

#[test]
fn bounces_settle_where_brute_force_at_80_digits_does() {
    for record in data("bounces") {
        let (hoop, start) = bouncing(&record);
        let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
        let settles = motion.transitions().iter().find(|it| it.cause == Cause::Settle);
        let end = settles.unwrap_or_else(|| panic!("settles: {record}")).after;
        let expected = &record["end"];
        let what = record.to_string();
        close(&what, end.time, &expected["time"], 1e-12);
        close(&what, end.theta, &expected["theta"], 1e-12);
        close(&what, end.theta_rate, &expected["theta_rate"], 1e-12);
        close(&what, end.slip, &expected["slip"], 1e-12);
        assert_eq!(end.slip == 0.0, record["sticks"].as_bool().expect("a flag"), "{what}");
    }
}

/// Numbers of the notes on Figure 3 with e = 0.5, from brute force at 40 digits.
#[test]
fn figure_3_settles_and_rolls() {
    let motion = find_case("figure-3-bounces").expect("a case").simulate().expect("a valid case");
    let settled = motion.transitions().last().expect("settles");
    assert_eq!((settled.cause, settled.from, settled.to), (Cause::Settle, Some(Mode::Flight), Some(Mode::Rolling)));
    assert!((settled.after.time - 6.924_682_083_018_514).abs() < 1e-12);
    assert!((settled.after.theta - 15.456_846_136_060_914).abs() < 1e-12);
    assert!((settled.after.theta_rate - 2.200_410_542_903_205).abs() < 1e-12);
    assert_eq!(settled.after.slip, 0.0);
    let rolls = motion.phases().last().expect("rolls").first();
    assert!((rolls.normal - 6.515_077_719).abs() < 1e-9);
    assert!((rolls.friction.abs() / rolls.normal - 0.073_26).abs() < 5e-6);
    let restitution = motion.hoop().restitution().expect("has restitution");
    let settling = motion.hoop().settling(&settled.after, 1e-12, restitution).expect("settles");
    assert!((settling.ratio - 0.492_024_505_882_643).abs() < 1e-12);
}

/// Wherever the sum of the bounces takes over, it leads to the same state but for the square of the time it covers.
#[test]
fn the_end_does_not_depend_on_where_the_sum_takes_over() {
    for record in data("bounces") {
        let (hoop, start) = bouncing(&record);
        let restitution = hoop.restitution().expect("has restitution");
        let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
        let expected = &record["end"];
        let end = ["time", "theta", "theta_rate", "slip"].map(|key| number(&expected[key]));
        let mut seen = 0;
        for transition in motion.transitions().iter().filter(|it| it.cause == Cause::Landing) {
            let from = transition.after;
            let left = end[0] - from.time;
            if !(1e-7..1e-3).contains(&left) {
                continue;
            }
            let opening = transition.impact.expect("an impact").after.gap_rate;
            let settling = hoop.settling(&from, opening, restitution).expect("settles");
            let theta = from.theta + from.theta_rate * settling.duration;
            let found = [from.time + settling.duration, theta, settling.impact.after.theta_rate, settling.impact.after.slip];
            for (ours, theirs) in found.into_iter().zip(end) {
                // The second derivatives of these motions are of order one, but for the light hoop's.
                let bound = 1e-12 + 100.0 * left * left;
                assert!((ours - theirs).abs() < bound, "{record}: {left:e} before the end {ours} is not {theirs}");
            }
            seen += 1;
        }
        assert!(seen > 3, "{record}");
    }
}
