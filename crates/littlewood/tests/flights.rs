//! Flights over the whole range of starts: against numbers of 25 digits from `reference/flights.py`, and by the heights of the
//! rim at twice the digits of a double.

use crate::common::landing::{check_landings, gap};
use littlewood::{
    Cause, Engine, Hoop, HoopParameters, Limits, Mode, Outcome, PhaseSolution, RestitutionLaw, Start,
};
use proptest::prelude::*;
use serde_json::Value;

const FLIGHTS: &str = include_str!("../../../reference/flights.json");

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

/// Each by the simulation and by the engine. A lift-off is reached by a slide without friction from a little before it, in which
/// the rate does not change: θ″ vanishes with the normal force.
#[test]
fn landings_over_the_whole_range_are_those_of_the_parabola() {
    let data: Value = serde_json::from_str(FLIGHTS).expect("reference/flights.json");
    let flights = data["flights"].as_array().expect("a list");
    for flight in flights {
        let h = number(&flight["h"]);
        let [theta, rate, gap_rate] = [0, 1, 2].map(|k| number(&flight["start"][k]));
        let (time, slope) = (number(&flight["landing"]["time"]), number(&flight["landing"]["gap_rate"]));
        let hoop = Hoop::new(HoopParameters::new(0.0, h, 1.0)).expect("a valid hoop");
        let lifts_off = flight["kind"] == "lift_off";
        let start = if lifts_off {
            let before = 1e-9 + 8.0 * f64::EPSILON * theta.abs();
            Start::at(theta - before.copysign(rate), rate).with_slip(1.0)
        } else {
            Start::at(theta, rate).with_gap_rate(gap_rate)
        };
        let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
        let Some(phase) = motion.phases().last() else { unreachable!("it moves") };
        let PhaseSolution::Flight(flies) = phase.solution() else { unreachable!("it lands: {flight}") };
        assert_eq!(motion.transitions().len(), if lifts_off { 2 } else { 1 }, "{flight}");
        let (_, rounding) = gap(h, &phase.start(), gap_rate, time);
        let tolerance = rounding / slope.abs();
        let error = (flies.duration() - time).abs();
        assert!(error <= tolerance, "{flight}: {} is off by {error:e} > {tolerance:e}", flies.duration());

        let engine = Engine::new(&hoop).summary(start, Limits::default()).expect("a valid start");
        let error = (engine.end.time - engine.lift_off_time - time).abs();
        let tolerance = tolerance + 2.0 * f64::EPSILON * engine.end.time;
        assert!(error <= tolerance, "{flight}: the engine is off by {error:e} > {tolerance:e}");
    }
}

/// The particle nearly over the centre, at θ = −π/2: the mass centre rises at h θ′, and falls back to that height after 2 h θ′.
#[test]
fn a_lift_off_at_a_right_angle_lasts_as_long_as_the_mass_centre_is_up() {
    let hoop = Hoop::figure_2(0.5, 0.4).expect("a valid hoop");
    for (theta, rate) in [(-1.637_594_326_404_023_1, -22_378.004_500_668_045), (-1.6, 3e5), (1.65, -9e5)] {
        let motion = hoop.simulate(Start::at(theta, rate), Limits::default()).expect("a valid start");
        let lift_off = motion.transitions().iter().find(|it| it.cause == Cause::LiftOff).expect("lifts off");
        let rate = lift_off.before.theta_rate;
        let Outcome::Landing { state, .. } = motion.outcome() else { unreachable!("lands") };
        // From −π/2 to where it lifts off it is 1/(h θ′²), and as much at the other end, where the rim is in the same place but for
        // turns: 2 h at the most, at the rate h θ′ of the fall.
        let up = 2.0 * hoop.h() * rate.abs();
        let time = state.time - lift_off.before.time;
        assert!((time - up).abs() < 4.0 / rate.abs(), "{time} {up}");
        assert_eq!(check_landings(&hoop, &motion), 1);
    }
}

/// A number of either sign, uniform in its logarithm.
fn signed(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    (exponents, any::<bool>()).prop_map(|(exponent, is_negative)| {
        let size = libm::exp10(exponent);
        if is_negative { -size } else { size }
    })
}

fn hoop() -> impl Strategy<Value = Hoop> {
    let offset = prop_oneof![Just(1.0), 0.05..1.0_f64, (-9.0..0.0_f64).prop_map(libm::exp10)];
    let friction = prop_oneof![Just((0.0, 0.0)), (0.0..1.5_f64, 0.0..=1.0_f64).prop_map(|(s, part)| (s, s * part))];
    let restitution = (0.0..=1.0_f64, prop::sample::select(RestitutionLaw::ALL.to_vec()));
    (0.0..3.0_f64, offset, 0.05..3.0_f64, friction, proptest::option::of(restitution)).prop_map(
        |(mass_ratio, offset, inertia, (mu_s, mu_k), restitution)| {
            let hoop = HoopParameters::new(mass_ratio, offset, inertia).with_friction(mu_s, mu_k);
            let hoop = restitution.map_or(hoop, |(e, law)| hoop.with_restitution(e, law));
            Hoop::new(hoop).expect("a valid hoop")
        },
    )
}

fn start() -> impl Strategy<Value = Start> {
    let theta = prop_oneof![3 => -3.2..3.2_f64, 1 => signed(0.0..9.0)];
    let rate = prop_oneof![1 => -4.0..4.0_f64, 3 => signed(-6.0..6.0)];
    let slip = prop_oneof![Just(0.0), signed(-6.0..6.0)];
    let gap_rate = prop_oneof![1 => Just(0.0), 1 => (-12.0..6.0_f64).prop_map(libm::exp10)];
    (theta, rate, slip, gap_rate)
        .prop_map(|(theta, rate, slip, v)| Start::at(theta, rate).with_slip(slip).with_gap_rate(v))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// Each landing at the plane, each instant above it; energy and horizontal momentum from the numbers of the sample.
    #[test]
    fn flights_keep_their_laws_over_the_whole_range(hoop in hoop(), start in start()) {
        let limits = Limits::default().with_transitions(12);
        let motion = hoop.simulate(start, limits).expect("a valid start");
        check_landings(&hoop, &motion);
        for phase in motion.phases() {
            let PhaseSolution::Flight(flight) = phase.solution() else { continue };
            let (first, duration, v) = (phase.first(), flight.duration(), flight.take_off_rate());
            let (at, height) = flight.apex();
            for part in 0..=32 {
                let elapsed = duration * f64::from(part) / 32.0;
                let now = flight.state(elapsed);
                let (h, rate) = (hoop.h(), now.theta_rate);
                let (there, slope) = flight.gap(elapsed);
                let (exact, rounding) = gap(h, &phase.start(), v, elapsed);
                if !flight.settles() {
                    prop_assert!((there - exact).abs() <= rounding, "{there:e} {exact:e} {rounding:e} at {elapsed}: {first:?}");
                    prop_assert!(there >= -rounding && there <= height + rounding, "{there} of {height} at {at}");
                }
                let (sin, cos) = libm::sincos(now.theta);
                let [vx, vy] = [now.slip - (1.0 + h * cos) * rate, slope - h * sin * rate];
                let (x, y) = flight.mass_centre_velocity(elapsed);
                // The last digit of an angle moves the rim.
                let digit = f64::EPSILON * (2.0 + now.theta.abs() + first.state.theta.abs());
                let size = now.slip.abs() + (1.0 + h) * rate.abs();
                prop_assert!((vx - x).abs() <= 4.0 * f64::EPSILON * size, "{vx} {x}");
                let size = v + elapsed + h * rate.abs();
                prop_assert!((vy - y).abs() <= 8.0 * f64::EPSILON * size + digit * h * rate.abs(), "{vy} {y}");
                if flight.settles() {
                    continue;
                }
                let (m, spin) = (hoop.mass(), hoop.body().inertia_about_mass_centre() * rate * rate);
                let energy = 0.5 * (m * (vx * vx + vy * vy) + spin) + hoop.offset() * cos + m * there;
                let error = m * (digit * h * (1.0 + rate.abs() * (vy.abs() + digit * h * rate.abs())) + rounding);
                let size = m * ((now.slip.abs() + (1.0 + h) * rate.abs()) * vx.abs() + (v + elapsed + h * rate.abs()) * vy.abs() + h)
                    + spin + m * there;
                prop_assert!((energy - first.energy).abs() <= 16.0 * f64::EPSILON * size + error, "{energy} {first:?}");
                prop_assert_eq!(phase.sample(0.5 * duration).energy, first.energy);
            }
        }
        for event in motion.transitions() {
            prop_assert!(event.from != Some(Mode::Flight) || event.cause != Cause::Landing || event.before.time.is_finite());
        }
    }
}
