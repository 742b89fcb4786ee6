//! What comes after the landing: impacts, bounces, settling and jams, as programs read them.

#![allow(
    clippy::excessive_precision,
    reason = "the reference has more digits than a double"
)]

use crate::support;
use crate::support::csv::Csv;
use crate::support::{FIGURE_3_LANDING, assert_close, json, number, text};
use serde_json::Value;

/// The velocities just before the first landing of Figure 3, from a computation of its own with 40
/// digits.
const SLIP: f64 = -0.785_244_687_128_996_169;
const GAP_RATE: f64 = -1.913_012_569_038_374_656;

/// The compliances A, B, C there.
const A: f64 = 0.704_169_493_845_475_073;
const B: f64 = -0.082_949_346_429_552_6;
const C: f64 = 0.533_700_402_266_253_778;

/// Kinetic friction of Figure 3.
const MU_K: f64 = 0.4;

/// Figure 3 with a coefficient of restitution and these flags.
fn bounce(restitution: &str, more: &[&str]) -> Value {
    json(
        &[
            &["simulate", "figure-3", "--restitution", restitution],
            more,
        ]
        .concat(),
    )
}

fn transitions(document: &Value) -> &[Value] {
    document["transitions"].as_array().expect("a list")
}

fn first_landing(document: &Value) -> &Value {
    transitions(document)
        .iter()
        .find(|it| it["cause"] == "landing")
        .expect("lands")
}

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value
        .as_object()
        .expect("an object")
        .keys()
        .map(String::as_str)
        .collect();
    keys.sort_unstable();
    keys
}

#[track_caller]
fn assert_keys(value: &Value, expected: &[&str]) {
    let mut expected = expected.to_vec();
    expected.sort_unstable();
    assert_eq!(keys(value), expected);
}

#[test]
fn without_rebound_figure_3_slides_on() {
    let document = bounce("0", &[]);
    let landing = first_landing(&document);
    assert_eq!(landing["from"], "flight");
    assert_eq!(landing["to"], "sliding");
    assert_eq!(landing["direction"], -1);
    assert_close(number(&landing["time"]), FIGURE_3_LANDING[0], 1e-12);
    assert_close(number(&landing["theta"]), FIGURE_3_LANDING[1], 1e-12);
    assert_close(
        number(&landing["theta_rate"]),
        1.989_854_986_135_947_259,
        1e-12,
    );
    assert_close(number(&landing["slip"]), -0.025_733_797_279_415_870, 1e-12);
    let impact = &landing["impact"];
    assert_eq!(impact["case"], "slides");
    assert_eq!(impact["gap_rate"], 0.0);
    assert_close(
        number(&impact["energy_lost"]),
        4.275_729_468_652_908_31,
        1e-12,
    );
}

#[test]
fn with_rebound_it_sticks_and_flies_again() {
    let document = bounce("0.5", &[]);
    let landing = first_landing(&document);
    assert_eq!(landing["to"], "flight");
    assert_eq!(landing["direction"], 0);
    assert_close(
        number(&landing["theta_rate"]),
        1.803_947_379_026_181_191,
        1e-12,
    );
    assert_eq!(landing["slip"], 0.0);
    let impact = &landing["impact"];
    assert_eq!(impact["case"], "sticks_in_restitution");
    assert_close(
        number(&impact["gap_rate"]),
        0.978_517_419_970_790_811,
        1e-12,
    );
    assert_close(number(&impact["energy_lost"]), 3.362_443_419_227_28, 1e-12);
    assert_close(number(&impact["before"]["slip"]), SLIP, 1e-12);
    assert_close(number(&impact["before"]["gap_rate"]), GAP_RATE, 1e-12);
    let lift_off = &transitions(&document)[2];
    assert_eq!(
        impact["before"]["theta_rate"], lift_off["theta_rate"],
        "flight keeps the rate"
    );
}

#[test]
fn the_three_laws_give_their_impulses() {
    // The case of slip that ends in restitution, σ = −1, then sticking, as the notes have it.
    let (e, closing) = (0.5, -GAP_RATE);
    let k1 = C + MU_K * B;
    let k2 = (A * C - B * B) / A;
    let first = -SLIP / (MU_K * A + B);
    let w1 = GAP_RATE + k1 * first;
    assert!(0.0 < w1 && w1 < e * closing);
    let w_energetic = (w1 * w1 + k2 / k1 * (e * e * closing * closing - w1 * w1)).sqrt();
    for (law, normal) in [
        ("energetic", first + (w_energetic - w1) / k2),
        ("poisson", (1.0 + e) * closing / k1),
        ("newton", first + (e * closing - w1) / k2),
    ] {
        let document = bounce("0.5", &["--restitution-law", law, "--until", "4"]);
        assert_eq!(document["hoop"]["restitution_law"], law);
        let impact = &first_landing(&document)["impact"];
        let friction = MU_K * first - B / A * (normal - first);
        let opening = w1 + k2 * (normal - first);
        // The slip velocity is zero after it.
        let lost = -0.5 * (friction * SLIP + normal * (GAP_RATE + opening));
        assert_close(number(&impact["normal_impulse"]), normal, 1e-12);
        assert_close(number(&impact["friction_impulse"]), friction, 1e-12);
        assert_close(number(&impact["gap_rate"]), opening, 1e-12);
        assert_close(number(&impact["energy_lost"]), lost, 1e-12);
    }
}

#[test]
fn bounces_settle_in_one_transition() {
    let document = bounce("0.5", &[]);
    let last = transitions(&document).last().expect("transitions");
    assert_eq!(
        [&last["cause"], &last["from"], &last["to"]],
        [
            &Value::from("settle"),
            &Value::from("flight"),
            &Value::from("rolling")
        ]
    );
    assert_close(number(&last["time"]), 6.924_682_083_018_513_65, 1e-12);
    assert_close(number(&last["theta"]), 15.456_846_136_060_913_9, 1e-12);
    assert_close(number(&last["theta_rate"]), 2.200_410_542_903_204_75, 1e-12);
    assert_eq!(last["slip"], 0.0);
    assert_eq!(last["impact"]["gap_rate"], 0.0);
    assert_eq!(
        transitions(&document)
            .iter()
            .filter(|it| it["cause"] == "settle")
            .count(),
        1
    );
    assert_eq!(document["outcome"]["kind"], "rolls_forever");
    // All that is lost is lost in sliding or in impacts.
    let sum = |list: &Value, of: fn(&Value) -> &Value| -> f64 {
        list.as_array()
            .expect("a list")
            .iter()
            .map(|it| of(it).as_f64().unwrap_or(0.0))
            .sum()
    };
    let impacts = sum(&document["transitions"], |it| &it["impact"]["energy_lost"]);
    let slides = sum(&document["phases"], |it| &it["energy_lost"]);
    assert_close(number(&document["impact_energy_lost"]), impacts, 1e-13);
    assert_close(number(&document["energy_lost"]), impacts + slides, 1e-13);
    let phases = document["phases"].as_array().expect("phases");
    let rolls = number(&phases.last().expect("rolls")["energy_start"]);
    assert_close(number(&document["energy_lost"]), 8.0 - rolls, 1e-12);
}

#[test]
fn a_start_without_a_consistent_motion_jams() {
    let document = json(&["simulate", "jam"]);
    let start = &document["start"];
    assert_eq!(start["mode"], Value::Null);
    assert_eq!(start["direction"], 0);
    assert_eq!(start["slip"], 1.0);
    let jam = &transitions(&document)[0];
    assert_eq!(jam["cause"], "jam");
    assert_eq!(jam["from"], Value::Null);
    assert_eq!(jam["to"], "rolling");
    assert_eq!(jam["time"], start["time"]);
    assert_close(number(&jam["theta_rate"]), -1.0, 1e-14);
    assert_eq!(jam["slip"], 0.0);
    assert_eq!(jam["impact"]["case"], "jams");
    assert_eq!(
        jam["impact"]["before"],
        serde_json::json!({ "theta_rate": -0.5, "slip": 1.0, "gap_rate": 0.0 })
    );
    // Without restitution it ends there, as before.
    let flags = "simulate --mass-ratio 0.125 --offset 1 --inertia 0.125 --mu-s 0.75 --mu-k 0.75 \
                 --theta 0.5 --theta-rate -0.5 --slip 1";
    let ends = json(&flags.split_whitespace().collect::<Vec<_>>());
    assert_eq!(ends["outcome"]["kind"], "inconsistent");
    assert_close(
        number(&ends["outcome"]["solvability_positive"]),
        -0.199_638_284_830_513,
        1e-14,
    );
    // The start is classified in the same way.
    let classified = json(&["classify", "jam"]);
    assert_eq!(classified["region"], "inconsistent");
    assert_eq!(classified["start"]["mode"], Value::Null);
    assert_close(number(&classified["jam"]["theta_rate"]), -1.0, 1e-14);
    assert_eq!(classified["jam"]["impact"], jam["impact"]);
    assert!(
        text(&["classify", "jam"]).contains("jams: an impact without a collision leaves θ′ = −1")
    );
    assert_eq!(json(&["classify", "painleve"]).get("jam"), None);
    assert_eq!(json(&["classify", "figure-3-bounces"]).get("jam"), None);
}

#[test]
fn a_jam_rebounds_by_its_law() {
    // The row of the notes with w0 = 0 for the hoop of the case: m = 9/8, h = 8/9, I = 1/8 + 1/9,
    // σ = +1, u0 = 1.
    let (mass, h, inertia) = (1.125, 8.0 / 9.0, 1.0 / 8.0 + 1.0 / 9.0);
    let (sin, cos) = libm::sincos(0.5);
    let (arm, lever) = (h * sin, 1.0 + h * cos);
    let a = 1.0 / mass + lever * lever / inertia;
    let b = arm * lever / inertia;
    let c = 1.0 / mass + arm * arm / inertia;
    let (mu_k, e) = (0.75, 0.5);
    let k1 = c - mu_k * b;
    let k2 = (a * c - b * b) / a;
    let first = 1.0 / (mu_k * a - b);
    let w1 = k1 * first;
    assert!(w1 < 0.0);
    let compression = first - w1 / k2;
    let work = -0.5 * w1 * first + 0.5 * w1 * w1 / k2;
    for (law, opening) in [
        ("energetic", e * (2.0 * work * k2).sqrt()),
        ("poisson", e * compression * k2),
        ("newton", 0.0),
    ] {
        let flags = [
            "simulate",
            "jam",
            "--restitution",
            "0.5",
            "--restitution-law",
            law,
            "--until",
            "0.1",
        ];
        let document = json(&flags);
        let jam = &transitions(&document)[0];
        let normal = compression + opening / k2;
        let friction = -mu_k * first - b / a * (normal - first);
        assert_close(number(&jam["impact"]["gap_rate"]), opening, 1e-13);
        assert_close(number(&jam["impact"]["normal_impulse"]), normal, 1e-13);
        assert_close(number(&jam["impact"]["friction_impulse"]), friction, 1e-13);
        assert_close(
            number(&jam["theta_rate"]),
            -0.5 + (lever * friction + arm * normal) / inertia,
            1e-13,
        );
        assert_eq!(jam["to"], if opening > 0.0 { "flight" } else { "rolling" });
    }
}

#[test]
fn the_keys_are_those_of_the_contract() {
    let document = bounce("0.5", &[]);
    let state = ["time", "theta", "theta_rate", "slip", "x"];
    assert_keys(
        &document,
        &[
            "case",
            "hoop",
            "start",
            "transitions",
            "outcome",
            "phases",
            "energy_lost",
            "impact_energy_lost",
        ],
    );
    let hoop = ["mass_ratio", "offset", "inertia", "mu_s", "mu_k"];
    assert_keys(
        &document["hoop"],
        &[&hoop[..], &["restitution", "restitution_law"]].concat(),
    );
    assert_eq!(document["hoop"]["restitution"], 0.5);
    assert_eq!(
        document["hoop"]["restitution_law"], "energetic",
        "told though it was not given"
    );
    assert_keys(
        &document["start"],
        &[&state[..], &["mode", "direction"]].concat(),
    );
    let edge = ["from", "to", "direction", "cause"];
    for transition in transitions(&document) {
        let jumps = ["landing", "settle"].contains(&transition["cause"].as_str().expect("a cause"));
        let impact: &[&str] = if jumps { &["impact"] } else { &[] };
        assert_keys(transition, &[&state[..], &edge, impact].concat());
        if jumps {
            assert_keys(
                &transition["impact"],
                &[
                    "case",
                    "normal_impulse",
                    "friction_impulse",
                    "energy_lost",
                    "before",
                    "gap_rate",
                ],
            );
            assert_keys(
                &transition["impact"]["before"],
                &["theta_rate", "slip", "gap_rate"],
            );
        }
    }
    let plain = json(&["simulate", "figure-3"]);
    assert_keys(&plain["hoop"], &hoop);
    assert_eq!(plain.get("impact_energy_lost"), None);
    assert!(
        transitions(&plain)
            .iter()
            .all(|it| it.get("impact").is_none())
    );
    // A hoop that is thrown tells its rate.
    let thrown = json(&["simulate", "figure-3", "--gap-rate", "0.25"]);
    assert_keys(
        &thrown["start"],
        &[&state[..], &["gap_rate", "mode", "direction"]].concat(),
    );
    assert_eq!(thrown["start"]["gap_rate"], 0.25);
    assert_eq!(thrown["start"]["mode"], "flight");
    assert_eq!(
        json(&["classify", "figure-3", "--gap-rate", "0.25"])["start"],
        thrown["start"]
    );
    assert_eq!(json(&["simulate", "figure-3", "--gap-rate", "0"]), plain);
}

#[test]
fn the_cases_list_their_restitution() {
    let list = json(&["cases"]);
    let find = |name: &str| {
        let list = list.as_array().expect("a list");
        list.iter()
            .find(|case| case["name"] == name)
            .unwrap_or_else(|| panic!("{name} is missing"))
    };
    for (name, restitution) in [
        ("figure-3-bounces", 0.5),
        ("lands-and-rolls", 0.0),
        ("two-hops", 0.0),
        ("jam", 0.0),
        ("bounces-forever", 1.0),
    ] {
        assert_eq!(find(name)["hoop"]["restitution"], restitution);
        assert_eq!(find(name)["hoop"]["restitution_law"], "energetic");
    }
    assert!(number(&find("bounces-forever")["start"]["gap_rate"]) > 1.0);
    assert_eq!(find("figure-3")["hoop"].get("restitution"), None);
    assert_eq!(find("figure-3")["start"].get("gap_rate"), None);
}

#[test]
fn bounces_without_loss_never_end() {
    let document = json(&["simulate", "bounces-forever", "--until", "40"]);
    assert_eq!(document["outcome"]["kind"], "time_limit");
    let landings = transitions(&document);
    assert!(
        landings
            .iter()
            .all(|it| it["cause"] == "landing" && it["to"] == "flight")
    );
    // Two flights a turn, each as the one before the last.
    for pair in landings.windows(3) {
        assert_close(
            number(&pair[2]["theta"]) - number(&pair[0]["theta"]),
            core::f64::consts::TAU,
            1e-11,
        );
        assert_close(
            number(&pair[2]["theta_rate"]),
            number(&pair[0]["theta_rate"]),
            1e-11,
        );
    }
    assert!(number(&document["energy_lost"]).abs() < 1e-12);
    let limit = json(&["simulate", "bounces-forever", "--max-transitions", "12"]);
    assert_eq!(limit["outcome"]["kind"], "transition_limit");
}

#[test]
fn si_twins_have_the_unit_in_their_names() {
    // m2 = 2 kg, R = 1 m, g = 4 m/s²: time ½ s, velocity 2 m/s, impulse 4 N s, energy 8 J.
    let size = [
        "--particle-mass-kg",
        "2",
        "--radius-m",
        "1",
        "--gravity-m-per-s2",
        "4",
    ];
    let document = bounce("0.5", &size);
    let landing = first_landing(&document);
    let (plain, si) = (&landing["impact"], &landing["si"]["impact"]);
    assert_keys(
        si,
        &[
            "normal_impulse_n_s",
            "friction_impulse_n_s",
            "energy_lost_j",
            "before",
            "gap_rate_m_per_s",
        ],
    );
    let twins = |plain: &Value, si: &Value, names: &[(&str, &str, f64)]| {
        for (name, si_name, unit) in names {
            assert_close(number(&si[*si_name]), unit * number(&plain[*name]), 1e-15);
        }
    };
    twins(
        plain,
        si,
        &[
            ("normal_impulse", "normal_impulse_n_s", 4.0),
            ("friction_impulse", "friction_impulse_n_s", 4.0),
            ("energy_lost", "energy_lost_j", 8.0),
            ("gap_rate", "gap_rate_m_per_s", 2.0),
        ],
    );
    twins(
        &plain["before"],
        &si["before"],
        &[
            ("theta_rate", "theta_rate_rad_per_s", 2.0),
            ("slip", "slip_m_per_s", 2.0),
            ("gap_rate", "gap_rate_m_per_s", 2.0),
        ],
    );
    twins(
        &document,
        &document["si"],
        &[("impact_energy_lost", "impact_energy_lost_j", 8.0)],
    );
    assert_eq!(document["si"]["hoop"]["restitution"], 0.5);
    assert_eq!(document["si"]["hoop"]["restitution_law"], "energetic");
    // A rate in metres per second, with its twin.
    let thrown = bounce("0.5", &[&size[..], &["--gap-rate-m-per-s", "1"]].concat());
    assert_eq!(thrown["start"]["gap_rate"], 0.5);
    assert_eq!(thrown["start"]["si"]["gap_rate_m_per_s"], 1.0);
    let plain = bounce("0.5", &["--gap-rate", "0.5"]);
    for (one, other) in transitions(&thrown).iter().zip(transitions(&plain)) {
        assert_eq!(
            [&one["time"], &one["impact"]],
            [&other["time"], &other["impact"]]
        );
    }
    let jam = json(&[&["classify", "jam"], &size[..]].concat());
    assert_close(
        number(&jam["jam"]["si"]["theta_rate_rad_per_s"]),
        -2.0,
        1e-14,
    );
    assert_eq!(jam["jam"]["si"]["impact"]["before"]["slip_m_per_s"], 2.0);
}

/// The rows of CSV by the names of their columns.
fn rows(arguments: &[&str]) -> Vec<std::collections::BTreeMap<String, String>> {
    Csv::read(&text(&[arguments, &["--format", "csv"]].concat())).rows
}

#[test]
fn event_rows_have_both_sides_of_each_jump() {
    for case in ["figure-3-bounces", "two-hops", "jam"] {
        let document = json(&["simulate", case]);
        let rows = rows(&["simulate", case]);
        // A start, each transition, an outcome; and a row more for each impact.
        let impacts: Vec<&Value> = transitions(&document)
            .iter()
            .filter(|it| it.get("impact").is_some())
            .collect();
        assert_eq!(
            rows.len(),
            2 + transitions(&document).len() + impacts.len(),
            "{case}"
        );
        let value = |text: &str| text.parse::<f64>().expect("a number");
        let mut seen = impacts.into_iter();
        for pair in rows.windows(2) {
            let [before, after] = pair else {
                unreachable!("two rows")
            };
            if before["side"] != "before" {
                assert_eq!(before["impact"].is_empty(), before["side"] != "after");
                continue;
            }
            let event = seen.next().expect("an impact");
            assert_eq!(after["side"], "after");
            assert_eq!(before["cause"], "", "the event is counted once, behind it");
            assert_eq!(after["cause"], event["cause"].as_str().expect("a cause"));
            assert_eq!(before["from"], event["from"].as_str().unwrap_or_default());
            assert_eq!(after["to"], event["to"].as_str().unwrap_or_default());
            for name in ["time", "theta", "x"] {
                assert_eq!(
                    before[name], after[name],
                    "the hoop does not move in an impact"
                );
            }
            let impact = &event["impact"];
            for name in ["theta_rate", "slip"] {
                // The sum of bounces that settle has its rates at a fixed angle.
                assert_close(value(&before[name]), number(&impact["before"][name]), 1e-13);
                assert_eq!(value(&after[name]), number(&event[name]));
            }
            assert_eq!(
                value(&before["gap_rate"]),
                number(&impact["before"]["gap_rate"])
            );
            assert_eq!(value(&after["gap_rate"]), number(&impact["gap_rate"]));
            assert_eq!(after["impact"], impact["case"].as_str().expect("a case"));
            for name in ["normal_impulse", "friction_impulse", "energy_lost"] {
                assert_eq!(before[name], "");
                assert_eq!(value(&after[name]), number(&impact[name]));
            }
        }
        assert_eq!(seen.next(), None, "{case}");
    }
}

#[test]
fn event_rows_tell_the_rate_of_the_gap_where_a_limit_stops_the_motion() {
    // Figure 3 flies from its lift-off on; the mass centre falls with unit acceleration and the
    // rate is that of (2.7).
    let rows = rows(&[
        "simulate",
        "figure-3",
        "--restitution",
        "0.5",
        "--until",
        "2.5",
    ]);
    let [_, theta, rate, _, _] = support::FIGURE_3_EVENTS[2];
    let elapsed = 2.5 - support::FIGURE_3_EVENTS[2][0];
    let falls = -0.5 * libm::sin(theta) * rate - elapsed;
    let expected = falls + 0.5 * libm::sin(theta + rate * elapsed) * rate;
    let last = rows.last().expect("rows");
    assert_eq!(last["cause"], "time_limit");
    assert_close(last["gap_rate"].parse().expect("a number"), expected, 1e-12);
    // One that is thrown, and lands without restitution.
    let thrown = self::rows(&["simulate", "figure-3", "--gap-rate", "0.25"]);
    assert_eq!(thrown[0]["gap_rate"], "0.25");
    let landing = json(&["simulate", "figure-3", "--gap-rate", "0.25"]);
    let closing = thrown.last().expect("rows")["gap_rate"]
        .parse::<f64>()
        .expect("a number");
    assert_eq!(closing, number(&landing["outcome"]["gap_rate"]));
}

#[test]
fn samples_have_both_sides_of_each_jump() {
    for (case, until) in [("figure-3-bounces", "8"), ("two-hops", "9"), ("jam", "8")] {
        let document = json(&["simulate", case, "--until", until, "--samples", "40"]);
        let samples = document["samples"].as_array().expect("samples");
        let rows = rows(&["simulate", case, "--until", until, "--samples", "40"]);
        assert_eq!(rows.len(), samples.len());
        for event in transitions(&document)
            .iter()
            .filter(|it| it.get("impact").is_some())
        {
            let at: Vec<&Value> = samples
                .iter()
                .filter(|it| it["time"] == event["time"])
                .collect();
            // Very short bounces may share a time with their neighbours.
            let place = at.windows(2).position(|pair| {
                let before = number(&event["impact"]["before"]["slip"]);
                (number(&pair[0]["slip"]) - before).abs() < 1e-13
                    && pair[1]["slip"] == event["slip"]
            });
            let [before, after] = place.map(|i| [at[i], at[i + 1]]).expect("both sides");
            assert_eq!(
                before["theta_rate"],
                event["impact"]["before"]["theta_rate"]
            );
            assert_eq!(after["theta_rate"], event["theta_rate"]);
            assert_eq!(before["mode"], event["from"]);
            assert_eq!(after["mode"], event["to"]);
            // The flight of bounces that settle leaves out their rates, up to 1e-7.
            let is_short = number(&event["impact"]["before"]["gap_rate"]).abs() < 1e-6;
            let tolerance = if event["cause"] != "jam" && is_short {
                1e-7
            } else {
                1e-12
            };
            let lost = number(&before["energy"]) - number(&after["energy"]);
            assert_close(lost, number(&event["impact"]["energy_lost"]), tolerance);
        }
        let causes: Vec<&str> = transitions(&document)
            .iter()
            .filter_map(|it| it["cause"].as_str())
            .collect();
        let events: Vec<&str> = rows
            .iter()
            .map(|row| row["event"].as_str())
            .filter(|event| !event.is_empty())
            .collect();
        assert_eq!(events, [&["start"], &causes[..]].concat(), "{case}");
    }
    // Just before a jam from the start nothing is known of forces, but of the state.
    let jam = json(&["simulate", "jam", "--samples", "3"]);
    let first = &jam["samples"][0];
    assert_eq!(
        (&first["mode"], &first["normal"]),
        (&Value::Null, &Value::Null)
    );
    assert_eq!(
        (number(&first["theta_rate"]), number(&first["slip"])),
        (-0.5, 1.0)
    );
    // (2.8) there: m = 9/8, h = 8/9, moment of inertia 1/8 + 1/9 about the mass centre.
    let (sin, cos) = libm::sincos(0.5);
    let (h, rate) = (8.0 / 9.0, -0.5);
    let (vx, vy) = (1.0 - (1.0 + h * cos) * rate, -h * sin * rate);
    let kinetic = 0.5 * (1.125 * (vx * vx + vy * vy) + (1.0 / 8.0 + 1.0 / 9.0) * rate * rate);
    assert_close(number(&first["energy"]), kinetic + cos, 1e-13);
}
