//! `littlewood threshold`.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::support::{complaint, json, number, text};
use serde_json::Value;

/// The numbers below and above a threshold, and the classes there.
fn threshold(arguments: &[&str]) -> ([f64; 2], [String; 2]) {
    let document = json(&[&["threshold"], arguments].concat());
    let sides = ["below", "above"].map(|side| document["threshold"][side].clone());
    let class = |side: &Value| side["class"].as_str().expect("a class").to_owned();
    (
        [number(&sides[0]["value"]), number(&sides[1]["value"])],
        [class(&sides[0]), class(&sides[1])],
    )
}

/// At the top h θ′² = 1 with h = 1/2: beyond it the hoop leaves the plane.
#[test]
fn the_least_rate_at_which_a_hoop_leaves_the_top_is_in_closed_form() {
    let top = ["figure-3", "--theta", "0", "--theta-rate", "1.4"];
    for of in ["theta_rate", "theta-rate=1.41:2", "theta_rate=1.41:pi/2"] {
        let ([below, above], classes) = threshold(&[&top[..], &["--of", of]].concat());
        assert_eq!(classes, ["lifts_off_later", "leaves_at_once"], "{of}");
        assert_eq!(above, below.next_up(), "{of}");
        // 1 − h θ′² is known to some units of its last digit, of 1; its slope in θ′ is √2.
        assert!(
            (above - 2_f64.sqrt()).abs() < 16.0 * f64::EPSILON,
            "{above}"
        );
    }
}

/// A disc rests up to tan α = χ, and rolls from there on. Between the two rounding decides.
#[test]
fn the_least_slope_at_which_a_disc_rolls_is_in_closed_form() {
    let disc =
        "--mass-ratio 1 --offset 0 --inertia 0.5 --mu-s 0.5 --mu-k 0.4 --theta 0 --theta-rate 0";
    for resistance in ["0.1", "0.01", "0.3"] {
        let flags = disc.split(' ').chain(["--rolling-resistance", resistance]);
        let flags: Vec<&str> = flags.chain(["--of", "slope=0:1"]).collect();
        let ([below, above], classes) = threshold(&flags);
        assert_eq!(classes, ["rests", "rolls_forever"], "{resistance}");
        let expected = resistance.parse::<f64>().expect("a number").atan();
        assert!(
            below <= expected
                && expected <= above
                && above - below < 32.0 * f64::EPSILON * expected,
            "{below} {expected} {above}"
        );
    }
    let flags: Vec<&str> = disc
        .split(' ')
        .chain(["--rolling-resistance", "0.1"])
        .collect();
    // Downhill the other way, from a range that is searched from its larger end.
    let down = threshold(&[&flags[..], &["--of", "slope=0:-1"]].concat());
    assert_eq!(down.1, ["rolls_forever", "rests"]);
    let page = text(&[&["threshold"], &flags[..], &["--of", "slope"]].concat());
    assert!(
        page.contains("Outcome  Up to α = 0.0996686524911")
            && page.contains("Between them rounding decides."),
        "{page}"
    );
}

/// μs is never below μk, and no more of it changes a motion that lifts off.
#[test]
fn without_a_threshold_it_says_how_far_it_has_looked() {
    let page = text(&["threshold", "figure-3", "--of", "mu_s"]);
    assert!(
        page.contains(
            "Outcome  It does not change with μₛ from 0.4025 to 1.5, in steps of 0.0075."
        ),
        "{page}"
    );
    let document = json(&["threshold", "figure-3", "--of", "mu_s"]);
    assert_eq!(document["threshold"], Value::Null);
    assert_eq!(number(&document["searched"]["to"]), 1.5);
}

#[test]
fn bad_input_is_named() {
    for (of, message) in [
        ("mu", "there is no quantity of a hoop or a start named 'mu'"),
        ("mu_s=0.4", "a range is NAME=FROM:TO"),
        ("mu_s=0.4:few", "'few' is not a number"),
        ("mu_s=-1:1", "mu_s = -1 must not be negative"),
        ("mu_s=0.5:inf", "mu_s = inf must be a finite number"),
        ("mu_s=0:1", "mu_k = 0.4 must not exceed mu_s = 0"),
    ] {
        let found = complaint(&["threshold", "figure-3", "--of", of], 2);
        assert!(found.contains(message), "{of}: {found}");
    }
}
