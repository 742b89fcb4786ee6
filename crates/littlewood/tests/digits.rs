//! The digits that are said to be trusted, against the motions of
//! `evidence/reference/digits-usual.json`, `digits-heavy.json` and `digits-hard.json`, followed
//! with 60 digits, and those with rolling resistance of `resistance.json`, with 30.
#![allow(clippy::panic)] // a failed expectation

use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, HoopParameters, Limits, Start, State};
use serde_json::Value;

const USUAL: &str = include_str!("../../../evidence/reference/digits-usual.json");
const HEAVY: &str = include_str!("../../../evidence/reference/digits-heavy.json");
const HARD: &str = include_str!("../../../evidence/reference/digits-hard.json");
const RESISTED: &str = include_str!("../../../evidence/reference/resistance.json");

/// Claims of some motions.
#[derive(Default)]
struct Claims {
    numbers: usize,
    /// Whole digits that a number has, less those that were claimed: less than two, and more.
    close: usize,
    far: usize,
    wrong: Vec<String>,
}

impl Claims {
    fn add(&mut self, name: &str, value: f64, truth: f64, claimed: u8) {
        if claimed == 0 || truth.is_infinite() {
            return;
        }
        // At rest the exact slip is a root, known to so many digits.
        let truth = if truth.abs() < 1e-40 { 0.0 } else { truth };
        let error = (value - truth).abs();
        self.numbers += 1;
        // The exact number is rounded here.
        let allowed = libm::exp10(-f64::from(claimed)) * truth.abs();
        if error > allowed + 0.5 * f64::EPSILON * truth.abs() {
            self.wrong
                .push(format!("{name}: {value} for {truth}, {claimed} digits"));
        }
        let true_digits = if error == 0.0 {
            15.0
        } else {
            (-libm::log10(error / truth.abs())).floor().min(15.0)
        };
        if true_digits - f64::from(claimed) < 2.0 {
            self.close += 1;
        } else {
            self.far += 1;
        }
    }
}

/// The hoop and the start of a motion.
fn problem(motion: &Value) -> (Hoop, Start) {
    let mut setup = Setup::new(HoopParameters::thin(1.0), Start::at(0.0, 0.0));
    for (group, quantities) in [("hoop", &Quantity::HOOP[..]), ("start", &Quantity::START)] {
        for quantity in quantities {
            if let Some(value) = motion[group][quantity.name()].as_f64() {
                setup.set(*quantity, value);
            }
        }
    }
    setup.hoop.restitution_law = motion["hoop"]["restitution_law"]
        .as_str()
        .map(|law| law.parse().expect("a law"));
    (Hoop::new(setup.hoop).expect("a valid hoop"), setup.start)
}

fn claims(text: &str) -> Claims {
    let motions: Value = serde_json::from_str(text).expect("motions");
    let mut claims = Claims::default();
    for (place, motion) in motions.as_array().expect("a list").iter().enumerate() {
        let (hoop, start) = problem(motion);
        let limits = Limits::default().with_transitions(100);
        let ours = hoop.simulate(start, limits).expect("a valid start");
        let digits = hoop.digits(start, limits).expect("a valid start");
        assert_eq!(digits.len(), ours.transitions().len());
        let events = motion["events"].as_array().expect("a list");
        for (index, (theirs, (ours, digits))) in events
            .iter()
            .zip(ours.transitions().iter().zip(digits))
            .enumerate()
        {
            let Some(digits) = digits.filter(|_| ours.cause.name() != "settle") else {
                break;
            };
            // What follows a rest with which the exact motion ends is not known.
            let is_last = index + 1 == events.len() && theirs[0] == "stick";
            assert!(
                is_last || theirs[0] == ours.cause.name(),
                "{place} {index}: {theirs} {ours:?}"
            );
            let State {
                time,
                theta,
                theta_rate,
                slip,
                x,
            } = ours.before;
            let claimed = [
                digits.time,
                digits.theta,
                digits.theta_rate,
                digits.slip,
                digits.x,
            ];
            let numbers = [time, theta, theta_rate, slip, x].into_iter().zip(claimed);
            for ((value, claimed), truth) in numbers.zip(&theirs.as_array().expect("a list")[1..]) {
                let truth = truth.as_str().expect("a number").parse().expect("a number");
                claims.add(&format!("{place} {index}"), value, truth, claimed);
            }
        }
    }
    claims
}

/// Claims of the motions with rolling resistance, and how many transitions have none.
fn claims_with_resistance() -> (Claims, usize) {
    let data: Value = serde_json::from_str(RESISTED).expect("motions");
    let (mut claims, mut silent) = (Claims::default(), 0);
    for (place, motion) in data["motions"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        let mut problem_of = motion.clone();
        let law = &motion["law"];
        problem_of["hoop"]["restitution_law"] = law.clone();
        if !law.is_null() {
            problem_of["hoop"]["restitution"] = motion["restitution"].clone();
        }
        let (hoop, start) = problem(&problem_of);
        let theirs = motion["transitions"].as_array().expect("a list");
        let limits = Limits::until(motion["until"].as_f64().expect("a number"))
            .with_transitions(theirs.len().max(1));
        let ours = hoop.simulate(start, limits).expect("a valid start");
        let digits = hoop.digits(start, limits).expect("a valid start");
        for (index, (theirs, (ours, digits))) in theirs
            .iter()
            .zip(ours.transitions().iter().zip(digits))
            .enumerate()
        {
            // Slow bounces are not listed there, and no bounces that are summed.
            let cause = theirs["cause"].as_str().expect("a cause");
            let cause = if cause == "turning" {
                "turning_point"
            } else {
                cause
            };
            if cause == "settle" || ours.cause.name() != cause {
                assert!(!law.is_null(), "{place} {index}: {ours:?} {theirs}");
                break;
            }
            let Some(digits) = digits else {
                silent += 1;
                continue;
            };
            for (name, value, claimed) in [
                ("time", ours.before.time, digits.time),
                ("theta", ours.before.theta, digits.theta),
                ("theta_rate", ours.before.theta_rate, digits.theta_rate),
                ("slip", ours.before.slip, digits.slip),
                ("x", ours.before.x, digits.x),
            ] {
                let truth = theirs[name].as_str().expect("a number");
                let truth = truth.parse().expect("a number");
                let named = format!("{} {place} {index} {name}", motion["family"]);
                claims.add(&named, value, truth, claimed);
            }
        }
    }
    (claims, silent)
}

#[test]
fn no_more_digits_are_claimed_than_there_are_with_rolling_resistance() {
    let (claims, silent) = claims_with_resistance();
    let Claims {
        numbers,
        close,
        far,
        wrong,
    } = claims;
    println!(
        "{numbers} numbers, {close} have less than two digits more than claimed, {far} more; {silent} transitions have none"
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(
        numbers > 1500 && far as f64 <= 0.5 * numbers as f64,
        "{far} of {numbers}"
    );
    assert!(silent < 20, "{silent}");
}

#[test]
fn no_more_digits_are_claimed_than_there_are() {
    for (name, text, least, most_far) in [
        ("usual", USUAL, 500, 0.3),
        ("heavy", HEAVY, 500, 0.5),
        ("hard", HARD, 100, 0.5),
    ] {
        let Claims {
            numbers,
            close,
            far,
            wrong,
        } = claims(text);
        println!(
            "{name}: {numbers} numbers, {close} have less than two digits more than claimed, {far} more"
        );
        assert!(wrong.is_empty(), "{name}: {wrong:#?}");
        assert!(
            numbers > least && far as f64 <= most_far * numbers as f64,
            "{name}: {far} of {numbers}"
        );
    }
}
