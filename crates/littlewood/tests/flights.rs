//! Flights over the whole range of starts: against numbers of 25 digits from
//! `evidence/reference/flights.py`, and by the heights of the rim at twice the digits of a double.

use std::f64::consts::TAU;

use crate::common::flight::{TakeOff, check_flights, check_landings};
use littlewood::modes::PhaseSolution;
use littlewood::tables::Quantity;
use littlewood::{Cause, Engine, Hoop, HoopParameters, Limits, Start};
use littlewood_random::Draw;
use serde_json::Value;

/// Seed of the motions that are drawn.
const SEED: u64 = 25;

const FLIGHTS: &str = include_str!("../../../evidence/reference/flights.json");

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

/// Each by the simulation and by the engine. A lift-off is reached by a slide without friction from
/// a little before it, in which the rate does not change: θ″ vanishes with the normal force.
#[test]
fn landings_over_the_whole_range_are_those_of_the_parabola() {
    let data: Value = serde_json::from_str(FLIGHTS).expect("evidence/reference/flights.json");
    let flights = data["flights"].as_array().expect("a list");
    for flight in flights {
        let h = number(&flight["h"]);
        let [theta, rate, gap_rate] = [0, 1, 2].map(|k| number(&flight["start"][k]));
        let (time, slope) = (
            number(&flight["landing"]["time"]),
            number(&flight["landing"]["gap_rate"]),
        );
        let hoop = Hoop::new(HoopParameters::thin(0.0).with_offset(h).with_inertia(1.0))
            .expect("a valid hoop");
        let lifts_off = flight["kind"] == "lift_off";
        let start = if lifts_off {
            let before = 1e-9 + 8.0 * f64::EPSILON * theta.abs();
            Start::at(theta - before.copysign(rate), rate).with_slip(1.0)
        } else {
            Start::at(theta, rate).with_gap_rate(gap_rate)
        };
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let Some(phase) = motion.phases().last() else {
            unreachable!("it moves")
        };
        let PhaseSolution::Flight(flies) = phase.solution() else {
            unreachable!("it lands: {flight}")
        };
        assert_eq!(
            motion.transitions().len(),
            if lifts_off { 2 } else { 1 },
            "{flight}"
        );
        let followed = flies.state(0.0).theta;
        let (_, rounding) = TakeOff {
            h,
            state: phase.start(),
            gap_rate,
            lifts_off,
            followed,
        }
        .gap(time);
        let tolerance = rounding / slope.abs();
        let error = (flies.duration() - time).abs();
        assert!(
            error <= tolerance,
            "{flight}: {} is off by {error:e} > {tolerance:e}",
            flies.duration()
        );

        let engine = Engine::new(&hoop)
            .summary(start, Limits::default())
            .expect("a valid start");
        let error = (engine.end.time - engine.lift_off_time - time).abs();
        let tolerance = tolerance + 2.0 * f64::EPSILON * engine.end.time;
        assert!(
            error <= tolerance,
            "{flight}: the engine is off by {error:e} > {tolerance:e}"
        );
    }
}

/// A fast hoop lifts off next to θ = −π/2 of a turn, however far out, where cos θ does not resolve
/// 1 = h cos θ θ′². Its mass centre rises at h θ′, and falls back to that height after 2 h θ′.
#[test]
fn a_fast_hoop_that_has_turned_long_comes_down() {
    let light = Hoop::equal_masses(0.5, 0.4).expect("a valid hoop");
    let heavy = HoopParameters::thin(4.258_053_794_098_504e-8).with_inertia(70_006_042.823_695_11);
    let heavy = Hoop::new(heavy.with_friction(0.857_365_504_918_691, 0.0)).expect("a valid hoop");
    let turned = |turns: f64, rate: f64| {
        Start::at(turns * TAU - 1.7_f64.copysign(rate), rate).with_slip(1.0)
    };
    for (hoop, start) in [
        (
            light,
            Start::at(-1.637_594_326_404_023_1, -22_378.004_500_668_045),
        ),
        (light, turned(0.0, 3e5)),
        (light, turned(0.0, -9e5)),
        (heavy, turned(64e6, 294_707.411)),
        (heavy, turned(-64e6, -294_707.411)),
        (heavy, turned(1e8, 9e5)),
        (heavy, turned(-3.0, -9e5)),
    ] {
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let [.., lift_off, landing] = motion.transitions() else {
            unreachable!("lands")
        };
        assert_eq!(
            (lift_off.cause, landing.cause),
            (Cause::LiftOff, Cause::Landing)
        );
        let rate = lift_off.before.theta_rate.abs();
        // The rim may be 2 h higher or lower at the end, at the rate h θ′ of the fall.
        let (up, time) = (2.0 * hoop.h() * rate, landing.time() - lift_off.time());
        assert!((time - up).abs() < 4.0 / rate, "{time} {up}: {start:?}");
        assert_eq!(check_landings(&motion), 1);
    }
}

/// Each landing at the plane, each instant above it; energy and horizontal momentum from the
/// numbers of the sample.
#[test]
fn flights_keep_their_laws_over_the_whole_range() {
    let (mut flights, mut landings) = (0, 0);
    for case in 0..3000 {
        let mut draw = Draw::of_case(SEED, 0, case);
        let (hoop, start) = draw.heavy_motion();
        let start = if draw.comes(0.5) {
            start.with_gap_rate(draw.allowed(Quantity::GapRate))
        } else {
            start
        };
        let motion = hoop
            .simulate(start, Limits::default().with_transitions(12))
            .expect("a valid start");
        landings += check_landings(&motion);
        flights += check_flights(&motion);
    }
    assert!(flights > 1000 && landings > 1000, "{flights} {landings}");
}
