//! Every motion of `evidence/truth/certificates`, whose numbers are enclosed by balls of 30 digits:
//! the same events, and each number of each event within the bound of its family.
#![allow(clippy::panic)] // a failed expectation

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use littlewood::si::{SiSetup, SiState, Units};
use littlewood::tables::{Quantity, Setup};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, RestitutionLaw, Start, State,
    Trajectory, Transition,
};
use serde_json::Value;

/// How many units in the last place of its size, or of 1 if it is smaller, a number may be off: the
/// power of two above twice the largest error of the family when this test was written, since
/// another rounding of the same steps moves the largest by such a factor. Motions amplify rounding.
/// Those of `near-tie` divide it by the distance, 1e-7 to 1e-9, between two events; the longest of
/// `landing` and `paper` graze; those of `long-rolling` turn for a thousand time units.
fn bound(family: &str) -> f64 {
    match family {
        "massless" => 4.0,
        "ramp-rolling" | "thrown" => 8.0,
        "ramp-sliding" | "rests-landing" => 16.0,
        "jam" | "leaves-at-once" | "rests-massless" | "rests-rolling" | "rests-sliding"
        | "settles-sticking" => 32.0,
        "elastic" | "ramp-rests" | "rests-elastic" | "rests-si" | "reversal-chain"
        | "settles-sliding" => 64.0,
        "elastic-settling" | "lift-off" | "ramp-jump" | "ramp-settles" => 128.0,
        "engines" | "si" | "slide-roll-slip" => 512.0,
        "long-rolling" => 4096.0,
        "paper" => 8192.0,
        "landing" => 65_536.0,
        "near-tie" => 134_217_728.0,
        other => panic!("a family without a bound: {other}"),
    }
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

/// The motion of a case by the library, and its units if it is given in SI.
fn motion(case: &Value) -> (Trajectory, Option<Units>) {
    let start = |name: &str| case["start"].get(name).map_or(0.0, number);
    let hoop = |quantity: Quantity| {
        let given = case["hoop"].get(quantity.name()).map(number);
        given.or(quantity.row().presence.default_value())
    };
    let restitution_law: Option<RestitutionLaw> = case["hoop"]
        .get("restitution_law")
        .and_then(Value::as_str)
        .map(|law| law.parse().expect("a law"));
    let until = case["until"].as_f64();
    match case["units"].as_str() {
        Some("si") => {
            let parameters = SiSetup::from_values(hoop, restitution_law).hoop;
            let (hoop, units) = parameters.to_hoop().expect("a valid hoop");
            let si = SiState {
                time_s: 0.0,
                theta_rad: start("theta"),
                theta_rate_rad_per_s: start("theta_rate"),
                slip_m_per_s: start("slip"),
                gap_rate_m_per_s: start("gap_rate"),
                x_m: 0.0,
            };
            let start = units.start(&si).expect("a valid start");
            let until = until.map(|until| units.until(until, &start).expect("a valid limit"));
            let limits = Limits::default().with_until(until);
            (
                hoop.simulate(start, limits).expect("a valid start"),
                Some(units),
            )
        }
        Some("dimensionless") => {
            let mut setup = Setup::new(HoopParameters::default(), Start::default());
            for quantity in Quantity::HOOP {
                if let Some(value) = hoop(quantity) {
                    setup.set(quantity, value);
                }
            }
            setup.hoop.restitution_law = restitution_law;
            let start = Start::at(start("theta"), start("theta_rate"))
                .with_slip(start("slip"))
                .with_gap_rate(start("gap_rate"));
            let hoop = Hoop::new(setup.hoop).expect("a valid hoop");
            (
                hoop.simulate(start, Limits::default().with_until(until))
                    .expect("a valid start"),
                None,
            )
        }
        other => panic!("units {other:?}"),
    }
}

/// Largest error of the numbers of a state, in units in the last place.
fn error(truth: &Value, state: &State, units: Option<&Units>) -> f64 {
    let State {
        time,
        theta,
        theta_rate,
        slip,
        x,
        ..
    } = *state;
    let numbers = units.map_or([time, theta, theta_rate, slip, x], |units| {
        let si = units.state(state);
        [
            si.time_s,
            si.theta_rad,
            si.theta_rate_rad_per_s,
            si.slip_m_per_s,
            si.x_m,
        ]
    });
    ["time", "theta", "theta_rate", "slip", "x"]
        .into_iter()
        .zip(numbers)
        // A rate is missing where it is infinite.
        .filter_map(|(name, ours)| Some((number(truth.get(name)?.get(0)?), ours)))
        .map(|(truth, ours)| (ours - truth).abs() / (f64::EPSILON * truth.abs().max(1.0)))
        .fold(0.0, f64::max)
}

/// The transition of each certified event; or what differs.
fn pairs<'a>(
    events: &[Value],
    transitions: &'a [Transition],
) -> Result<Vec<&'a Transition>, String> {
    let mut rest = transitions.iter().peekable();
    let mut found = Vec::new();
    for (place, event) in events.iter().enumerate() {
        if event["cause"] == "settle" {
            // The library follows more bounces one by one before it sums the others.
            let bounces = |next: &&Transition| {
                next.cause == Cause::Landing && next.to.is_some_and(|to| to.name() == "flight")
            };
            while rest.next_if(bounces).is_some() {}
        }
        let ours = rest
            .next()
            .ok_or_else(|| format!("no event {place}, {}", event["cause"]))?;
        let to = ours.to.map(Mode::name);
        if event["cause"] != ours.cause.name() || event["to"].as_str() != to {
            return Err(format!(
                "event {place}, {} to {}, is {} to {to:?}",
                event["cause"], event["to"], ours.cause
            ));
        }
        found.push(ours);
    }
    rest.next().map_or(Ok(found), |more| {
        Err(format!(
            "one more event, {} at {}",
            more.cause, more.before.time
        ))
    })
}

#[test]
fn every_certified_motion_is_that_of_the_library() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../evidence/truth/certificates");
    let mut families: BTreeMap<String, (u32, f64)> = BTreeMap::new();
    let mut wrong = Vec::new();
    for entry in fs::read_dir(folder).expect("the certificates") {
        let text = fs::read_to_string(entry.expect("a file").path()).expect("a certificate");
        let certificate: Value = serde_json::from_str(&text).expect("a certificate");
        if certificate["certified"] != true {
            continue;
        }
        let case = &certificate["case"];
        let (name, family) = (&case["name"], case["family"].as_str().expect("a family"));
        let (motion, units) = motion(case);
        let events = certificate["events"].as_array().expect("events");
        let ours = match pairs(events, motion.transitions()) {
            Ok(ours) => ours,
            Err(difference) => {
                wrong.push(format!("{name}: {difference}"));
                continue;
            }
        };
        let end = &certificate["end"];
        let outcome = motion.outcome();
        let last = if end["kind"] == OutcomeKind::TimeLimit.name() {
            // The library may have proved that the motion never ends, and goes on.
            motion
                .at(number(&end["state"]["time"][0]) / units.map_or(1.0, |units| units.time_s))
                .map(|sample| sample.state)
        } else {
            (end["kind"] == outcome.kind().name()).then(|| outcome.state())
        };
        if let Outcome::Rests { half_swings, .. } = outcome
            && end["half_swings"] != half_swings
        {
            wrong.push(format!(
                "{name} rests after {half_swings} half swings, not {}",
                end["half_swings"]
            ));
        }
        let Some(last) = last else {
            wrong.push(format!(
                "{name} ends by {}, not {}",
                outcome.kind(),
                end["kind"]
            ));
            continue;
        };
        let errors = events
            .iter()
            .zip(&ours)
            .map(|(event, ours)| error(&event["state"], &ours.after, units.as_ref()));
        let at_end = end
            .get("state")
            .map_or(0.0, |state| error(state, &last, units.as_ref()));
        let largest = errors.fold(at_end, f64::max);
        if largest > bound(family) {
            wrong.push(format!(
                "{name} is off by {largest:.1} units in the last place"
            ));
        }
        let of_family = families.entry(family.to_owned()).or_default();
        *of_family = (of_family.0 + 1, of_family.1.max(largest));
    }
    println!(
        "certified motions and the largest error of a number in units in the last place: {families:?}"
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(
        families.values().map(|(count, _)| count).sum::<u32>() >= 540,
        "{families:?}"
    );
}
