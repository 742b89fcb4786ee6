//! Starts beside the curves on which two events coincide, against the motions of
//! `evidence/reference/coincidences.json`: an integration of the balances of momentum with 40
//! digits. Every number has a unit there, estimated in the same digits: what it changes by where
//! the numbers of the start, and the states between, change by an ulp.
#![allow(clippy::panic)]

use littlewood::{Hoop, HoopParameters, Limits, Mode, Phase, Proof, SlipDirection, Start, State};
use serde_json::Value;

const REFERENCE: &str = include_str!("../../../evidence/reference/coincidences.json");

/// Errors of the library, in units. `largest` in the file is the most of all starts that are
/// compared there.
const UNITS: f64 = 64.0;

/// A number written as one, or as a word.
pub(crate) fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

pub(crate) fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list = Vec::from_iter(value.as_array().expect("a list").iter().map(number));
    list.try_into().expect("so many numbers")
}

struct Motion {
    name: String,
    hoop: Hoop,
    start: Start,
    limits: Limits,
    reference: Value,
}

fn motions() -> Vec<Motion> {
    let data: Value =
        serde_json::from_str(REFERENCE).expect("evidence/reference/coincidences.json");
    let kept = data["kept"].as_array().expect("a list of motions");
    Vec::from_iter(kept.iter().map(|reference| {
        let [mass_ratio, offset, inertia, mu_s, mu_k] = numbers(&reference["hoop"]);
        let [theta, theta_rate, slip, gap_rate] = numbers(&reference["start"]);
        Motion {
            name: format!("{} {}", reference["family"], reference["index"]),
            hoop: Hoop::new(
                HoopParameters::thin(mass_ratio)
                    .with_offset(offset)
                    .with_inertia(inertia)
                    .with_friction(mu_s, mu_k),
            )
            .expect("a valid hoop"),
            start: Start::at(theta, theta_rate)
                .with_slip(slip)
                .with_gap_rate(gap_rate),
            limits: Limits::until(number(&reference["until"])).with_proof(Proof::None),
            reference: reference.clone(),
        }
    }))
}

pub(crate) fn of_state(state: &State) -> [(&'static str, f64); 5] {
    let State {
        time,
        theta,
        theta_rate,
        slip,
        x,
    } = *state;
    [
        ("time", time),
        ("theta", theta),
        ("theta_rate", theta_rate),
        ("slip", slip),
        ("x", x),
    ]
}

#[test]
fn events_that_all_but_coincide_are_those_of_40_digits() {
    let motions = motions();
    assert!(motions.len() >= 250);
    for Motion {
        name,
        hoop,
        start,
        limits,
        reference,
    } in motions
    {
        let motion = hoop.simulate(start, limits).expect("a valid start");
        let first = motion.phases().first().expect("a phase");
        assert_eq!(reference["first"][0], first.mode().name(), "{name}");
        let code = |direction: Option<SlipDirection>| i64::from(SlipDirection::code(direction));
        assert_eq!(
            reference["first"][1].as_i64(),
            Some(code(Phase::direction(first))),
            "{name}"
        );

        let theirs = reference["transitions"]
            .as_array()
            .expect("a list of transitions");
        let has_more = reference["outcome"] == "more";
        assert!(
            motion.transitions().len() == theirs.len() || has_more,
            "{name}: {:?}",
            motion.transitions()
        );
        for (ours, theirs) in motion.transitions().iter().zip(theirs) {
            assert_eq!(theirs["cause"], ours.cause.name(), "{name}");
            assert_eq!(theirs["to"], ours.to.map_or("none", Mode::name), "{name}");
            assert_eq!(
                theirs["direction"].as_i64(),
                Some(code(ours.direction)),
                "{name}"
            );
            for (key, value) in of_state(&ours.before) {
                let [exact, unit] = numbers(&theirs[key]);
                let error = if value == exact {
                    0.0
                } else {
                    (value - exact).abs()
                };
                assert!(
                    error <= UNITS * unit,
                    "{name} {} {key}: {value} {exact} {}",
                    ours.cause,
                    error / unit
                );
            }
        }
    }
}

#[test]
fn the_digits_that_are_said_to_be_trusted_can_be() {
    let (mut all, mut few) = (0, 0);
    for Motion {
        name,
        hoop,
        start,
        limits,
        reference,
    } in motions()
    {
        let motion = hoop.simulate(start, limits).expect("a valid start");
        let digits = hoop.digits(start, limits).expect("a valid start");
        assert_eq!(digits.len(), motion.transitions().len(), "{name}");
        let theirs = reference["transitions"]
            .as_array()
            .expect("a list of transitions");
        for ((ours, theirs), digits) in motion.transitions().iter().zip(theirs).zip(digits) {
            let Some(digits) = digits else { continue };
            let trusted = [
                digits.time,
                digits.theta,
                digits.theta_rate,
                digits.slip,
                digits.x,
            ];
            for ((key, value), trusted) in of_state(&ours.before).into_iter().zip(trusted) {
                let [exact, _] = numbers::<2>(&theirs[key]);
                // At a rest the reference has a root to 40 digits where the library has 0.
                let exact = if exact.abs() < 1e-35 { 0.0 } else { exact };
                let error = if value == exact {
                    0.0
                } else {
                    (value - exact).abs()
                };
                let within = libm::pow(10.0, -f64::from(trusted)) * exact.abs();
                // The exact number is rounded here.
                let rounded = 0.5 * f64::EPSILON * exact.abs();
                assert!(
                    error <= within + rounded,
                    "{name} {key}: {value} {exact}, {trusted} digits"
                );
                all += 1;
                few += u32::from(trusted < 12);
            }
        }
    }
    // The estimate does not refuse to say anything.
    assert!(all > 2000 && few * 4 < all, "{all} {few}");
}
