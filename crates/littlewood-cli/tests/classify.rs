//! `littlewood classify` and `littlewood cases`.

use crate::support::{assert_close, json, number, text};
use littlewood::cases::{CASES, find_case};
use serde_json::Value;

#[test]
fn figure_3_starts_beyond_the_static_friction() {
    let document = json(&["classify", "figure-3"]);
    assert_eq!(document["region"], "beyond_friction");
    assert_eq!(document["start"]["mode"], "sliding");
    assert_eq!(document["start"]["direction"], -1);
    // (2.12) at θ = π/2, θ′ = 2 with D = 4 and K = 20: N = 12/16, F = 24/16.
    assert_close(number(&document["rolling_normal"]), 0.75, 1e-15);
    assert_close(number(&document["rolling_friction"]), 1.5, 1e-15);
    assert_close(number(&document["friction_demand"]), 2.0, 1e-15);
    assert_close(number(&document["contact"]), 1.0, 1e-15);
    assert_close(number(&document["energy"]), 8.0, 1e-15);
    assert_eq!(document["rolling_end"], Value::Null);
    let page = text(&["classify", "figure-3"]);
    assert!(
        page.contains("Begins   sliding ←") && page.contains("|F|/N = 2, μₛ = 0.5"),
        "{page}"
    );
}

/// The hoop of Figure 3 has m = 2 and h = 1/2 (docs/theory/rolling-resistance.md).
#[test]
fn with_rolling_resistance_a_start_may_rest_or_skid() {
    let flags = |flags: &'static str| {
        let command = "classify figure-3 --theta-rate 0 --rolling-resistance".split(' ');
        command.chain(flags.split(' ')).collect::<Vec<_>>()
    };
    // h sin 3.1 < χ.
    let document = json(&flags("0.1 --theta 3.1"));
    assert_eq!(document["region"], "band_of_rest");
    assert_eq!(document["start"]["mode"], "rest");
    assert_eq!(document["rolling_normal"], 2.0);
    assert_eq!(document["rolling_friction"], 0.0);
    assert_eq!(document["rolling_end"], Value::Null);
    let page = text(&flags("0.1 --theta 3.1"));
    assert!(
        page.contains("Begins   rest") && page.contains("Rest     needs N = 2 m₂g, F = 0"),
        "{page}"
    );
    // |h sin θ − μk (1 + h cos θ)| = 0.006.
    let page = text(&flags("0.1 --theta 1.2 --slip 0.5"));
    assert!(page.contains("Begins   skidding →"), "{page}");
    // χ = h sin θ, but for rounding.
    let border = flags("0.25 --theta 2.6179938779914944");
    let document = json(&border);
    assert_eq!(document["region"], "unresolved");
    assert_eq!(document["undecided"]["compared"], "held_angle");
    let page = text(&border);
    assert!(
        page.contains("it depends on χ − |M|/N, which is "),
        "{page}"
    );
}

#[test]
fn littlewoods_hoop_has_a_type_and_an_end_of_rolling() {
    let flags =
        "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 0 --theta-rate";
    let classify =
        |rate: &str| json(&[vec!["classify"], flags.split(' ').collect(), vec![rate]].concat());
    let document = classify("0.5");
    assert_eq!(document["region"], "rolling_region");
    assert_eq!(document["rolling_type"], "III");
    let end = &document["rolling_end"];
    assert_eq!(end["cause"], "slip");
    assert_close(number(&end["elapsed"]), 1.609_437_912_434_100_3, 1e-14);
    assert_close(number(&end["theta"]), 0.927_295_218_001_612_2, 1e-14);
    assert_close(number(&end["theta_rate"]), 0.75, 1e-14);
    // Faster, N vanishes first: cos θ = θ0′² at arccosh(1/θ0′²).
    let document = classify("0.9");
    assert_eq!(document["rolling_type"], "I");
    assert_eq!(document["rolling_end"]["cause"], "normal_force_zero");
    assert_close(number(&document["rolling_end"]["theta_rate"]), 1.0, 1e-14);
    // N < 0 from the start.
    let fast = json(&[
        "classify",
        "figure-7",
        "--theta",
        "0.3",
        "--theta-rate",
        "1.5",
    ]);
    assert_eq!(fast["region"], "gliding");
    assert_eq!(fast["rolling_type"], Value::Null);
}

#[test]
fn regions_of_the_heavy_hoop() {
    let classify = |theta: &str, rate: &str| {
        json(&[
            "classify",
            "figure-3",
            "--theta",
            theta,
            "--theta-rate",
            rate,
        ])
    };
    let rest = classify("0", "0");
    assert_eq!(rest["region"], "rolling_region");
    assert_eq!(rest["rolls_forever"]["recurrence"], "rest");
    // Footnote 3.
    let jump = classify("0", "4");
    assert_eq!(jump["region"], "loss_of_contact");
    assert_eq!(jump["start"]["mode"], "flight");
    assert_eq!(jump["friction_demand"], Value::Null);
    // N_roll ≤ 0 and yet 1 − h c u > 0.
    let band = classify("-0.7", "1.6");
    assert_eq!(band["region"], "sliding_band");
    assert!(number(&band["rolling_normal"]) <= 0.0 && number(&band["contact"]) > 0.0);
    let slip = json(&["classify", "figure-3", "--slip", "-0.1"]);
    assert_eq!(slip["region"], "slipping");
    assert_eq!(slip["start"]["direction"], -1);
}

#[test]
fn every_case_is_listed_and_begins_as_classify_says() {
    let list = json(&["cases"]);
    let list = list.as_array().unwrap();
    assert_eq!(list.len(), CASES.len());
    let page = text(&["cases"]);
    for entry in list {
        let name = entry["name"].as_str().unwrap();
        let case = find_case(name).unwrap();
        assert_eq!(entry["title"], case.title);
        assert_eq!(entry["start"]["theta"], case.setup.start.theta);
        assert_eq!(entry["hoop"]["mu_s"], case.setup.hoop.mu_s);
        assert!(page.contains(name));
        let motion = json(&["simulate", name]);
        let start = json(&["classify", name]);
        assert_eq!(start["start"]["mode"], motion["start"]["mode"], "{name}");
        let words = text(&["classify", name]);
        assert!(
            words.contains("Region   ") && words.lines().all(|line| line.chars().count() <= 100),
            "{words}"
        );
    }
    assert!(
        page.lines().all(|line| line.chars().count() <= 100),
        "{page}"
    );
}

/// The hoop of the study of reverse chatter, at rest on the plane.
#[test]
fn a_rest_that_is_not_the_only_motion_says_so() {
    let flags = "--mass-ratio 0.3 --offset 1 --inertia 0.3 --mu-s 1.5 --mu-k 1.5 --slope-deg 40 --theta -1.5 --theta-rate 0";
    let bouncing = "--restitution 0.8 --restitution-law poisson";
    let arguments: Vec<&str> = ["classify"].into_iter().chain(flags.split(' ')).collect();
    assert_eq!(
        json(&arguments).get("reverse_chatter"),
        None,
        "without restitution"
    );
    let arguments = [arguments, bouncing.split(' ').collect()].concat();
    let document = json(&arguments);
    assert_eq!(document["region"], "rolling_region");
    // e (1 + 2 |B| tan α/A), with B/A = m h s (1 + h c)/(Î + m (1 + h c)²), m = 1.3, h = 1/1.3, Î =
    // 0.3 + 0.3/1.3.
    let (sin, cos) = libm::sincos(1.5);
    let lever = 1.0 + cos / 1.3;
    let stick = sin * lever / (0.3 + 0.3 / 1.3 + 1.3 * lever * lever);
    let ratio = 0.8 * (1.0 + 2.0 * stick * libm::tan(40.0_f64.to_radians()));
    assert_close(number(&document["reverse_chatter"]), ratio, 1e-14);
    let page = text(&arguments);
    assert!(
        page.contains("is not the only motion: bounces can grow out of it"),
        "{page}"
    );
}

/// The numbers are those of its certificate, enclosed in balls: w = −0.014447911582621, N =
/// 0.13957888871596, F = −0.08262196486997. μk belongs to neither motion.
#[test]
fn a_wedged_start_is_ambiguous_in_words_and_numbers() {
    let flags = "--mass-ratio=0.2 --offset=1 --inertia=0.1 --mu-s=1 --slope=-1.1 --theta=0.5 --theta-rate=-0.8";
    for mu_k in ["--mu-k=0.35", "--mu-k=0.9"] {
        let with = |command| -> Vec<&str> {
            [command, mu_k]
                .into_iter()
                .chain(flags.split(' '))
                .collect()
        };
        let document = json(&with("classify"));
        assert_eq!(document["region"], "ambiguous");
        let weight = libm::cos(1.1);
        assert_close(
            number(&document["contact"]),
            -0.014_447_911_582_621 / weight,
            1e-13,
        );
        assert_close(
            number(&document["rolling_normal"]),
            0.139_578_888_715_96,
            1e-13,
        );
        assert_close(
            number(&document["rolling_friction"]),
            -0.082_621_964_869_97,
            1e-12,
        );
        let page = text(&with("classify"));
        for words in [
            "rolling, or flight",
            "|F|/N = 0.591937",
            "1 − h cos θ θ′²/cos α = −0.0318519",
        ] {
            assert!(page.contains(words), "{words}: {page}");
        }
        let page = text(&with("simulate"));
        assert!(page.contains("rolling, flight"), "{page}");
        assert_eq!(json(&with("simulate"))["outcome"]["kind"], "ambiguous");
    }
}
