//! The digits that are said to be trusted, against the motions of
//! `evidence/reference/digits-usual.json`, `digits-heavy.json` and `digits-hard.json`, followed
//! with 60 digits.
#![allow(clippy::panic)] // a failed expectation

use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, HoopParameters, Limits, Start, State};
use serde_json::Value;

const USUAL: &str = include_str!("../../../evidence/reference/digits-usual.json");
const HEAVY: &str = include_str!("../../../evidence/reference/digits-heavy.json");
const HARD: &str = include_str!("../../../evidence/reference/digits-hard.json");

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
