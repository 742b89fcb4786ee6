//! `littlewood simulate`: the numbers and names that other programs rely on, and the page that a
//! person reads.

use crate::support;
use crate::support::csv::Csv;
use crate::support::{
    FIGURE_3, FIGURE_3_EVENTS, FIGURE_3_LANDING, assert_close, complaint, json, littlewood, number,
    text,
};
use littlewood::cases::CASES;
use littlewood::{Cause, Mode, Phase};
use predicates::prelude::*;
use serde_json::Value;

const STATE: [&str; 5] = ["time", "theta", "theta_rate", "slip", "x"];

fn keys(value: &Value) -> Vec<&str> {
    value
        .as_object()
        .expect("an object")
        .keys()
        .map(String::as_str)
        .collect()
}

#[test]
fn the_command_of_the_readme_prints_one_object_with_the_fixed_names() {
    let command = "simulate --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 \
                   --theta 1.5707963267948966 --theta-rate 2 --slip 0 --until 30 --format json";
    let document: Value =
        serde_json::from_str(&text(&command.split_whitespace().collect::<Vec<_>>())).unwrap();
    let sorted = |names: &[&str]| {
        let mut names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        names.sort();
        names
    };
    assert_eq!(
        sorted(&keys(&document)),
        sorted(&[
            "hoop",
            "start",
            "transitions",
            "outcome",
            "phases",
            "energy_lost"
        ])
    );
    assert_eq!(
        sorted(&keys(&document["hoop"])),
        sorted(&["mass_ratio", "offset", "inertia", "mu_s", "mu_k"])
    );
    assert_eq!(
        sorted(&keys(&document["start"])),
        sorted(&[&STATE[..], &["mode", "direction"]].concat())
    );
    let transitions = document["transitions"].as_array().unwrap();
    assert_eq!(transitions.len(), 4);
    for transition in transitions {
        let names = [&STATE[..], &["from", "to", "direction", "cause"]].concat();
        assert_eq!(sorted(&keys(transition)), sorted(&names));
        assert!(STATE.iter().all(|name| transition[name].is_f64()));
        assert!(transition["direction"].is_i64());
    }
    assert_eq!(
        sorted(&keys(&document["outcome"])),
        sorted(&[&STATE[..], &["kind", "gap_rate"]].concat())
    );
    assert_eq!(document["hoop"]["mu_k"], 0.4);
    assert_eq!(document["start"]["theta"], core::f64::consts::FRAC_PI_2);
    assert_eq!(document["start"]["mode"], "sliding");
    assert_eq!(document["start"]["direction"], -1);
}

#[test]
fn figure_3_has_its_four_phases_and_times() {
    let by_name = json(&["simulate", "figure-3"]);
    let by_numbers = json(&[&["simulate"], &FIGURE_3[..]].concat());
    for document in [&by_name, &by_numbers] {
        let phases: Vec<(&str, i64)> = document["phases"]
            .as_array()
            .unwrap()
            .iter()
            .map(|phase| {
                (
                    phase["mode"].as_str().unwrap(),
                    phase["direction"].as_i64().unwrap(),
                )
            })
            .collect();
        assert_eq!(
            phases,
            [
                ("sliding", -1),
                ("rolling", 0),
                ("sliding", 1),
                ("flight", 0)
            ]
        );

        let transitions = document["transitions"].as_array().unwrap();
        let edges: Vec<[&Value; 4]> = transitions
            .iter()
            .map(|it| [&it["from"], &it["to"], &it["direction"], &it["cause"]])
            .collect();
        let expected = serde_json::json!([
            ["sliding", "rolling", 0, "stick"],
            ["rolling", "sliding", 1, "slip"],
            ["sliding", "flight", 0, "lift_off"],
            ["flight", null, 0, "landing"],
        ]);
        assert_eq!(serde_json::json!(edges), expected);
        for (transition, expected) in transitions.iter().zip(FIGURE_3_EVENTS) {
            for (name, expected) in STATE.iter().zip(expected) {
                assert_close(number(&transition[name]), expected, 1e-12);
            }
        }
        let outcome = &document["outcome"];
        assert_eq!(outcome["kind"], "landing");
        assert_close(number(&outcome["time"]), FIGURE_3_LANDING[0], 1e-12);
        assert_close(number(&outcome["theta"]), FIGURE_3_LANDING[1], 1e-12);
        assert!(number(&outcome["gap_rate"]) < 0.0);
        assert_eq!(outcome["time"], transitions[3]["time"]);
    }
    assert_eq!(by_name["case"], "figure-3");
    assert_eq!(by_numbers["case"], Value::Null);
}

#[test]
fn the_energy_lost_is_that_between_the_start_and_the_lift_off() {
    let document = json(&["simulate", "figure-3"]);
    // (2.8) with m = 2, h = 1/2 and the moment of inertia 3/2 about the mass centre, at the
    // reference lift-off.
    let [_, theta, rate, slip, _] = FIGURE_3_EVENTS[2];
    let (sin, cos) = libm::sincos(theta);
    let vx = slip - (1.0 + 0.5 * cos) * rate;
    let vy = -0.5 * sin * rate;
    let at_lift_off = vx * vx + vy * vy + 0.75 * rate * rate + cos;
    // Rolling at θ = π/2: E = D θ′²/2 with D = 4.
    let at_start = 8.0;
    assert_close(
        number(&document["energy_lost"]),
        at_start - at_lift_off,
        1e-12,
    );
    let phases = document["phases"].as_array().unwrap();
    assert_close(number(&phases[0]["energy_start"]), at_start, 1e-15);
    assert_close(number(&phases[3]["energy_start"]), at_lift_off, 1e-12);
    assert_eq!(phases[1]["energy_lost"], 0.0);
    assert!(number(&phases[0]["energy_lost"]) > 0.0 && number(&phases[2]["energy_lost"]) > 0.0);
}

/// In a skid ½ m η′² is lost to friction, and all else in rolling (docs/theory/rolling-resistance.md).
#[test]
fn a_hoop_that_rests_tells_what_each_kind_of_friction_took() {
    let flags = "simulate --mass-ratio 1 --offset 0.6 --inertia 0.5 --mu-s 0.4 --mu-k 0.3 \
                 --rolling-resistance 0.1 --theta 1.21625 --theta-rate 0 --slip 0.5";
    let flags: Vec<&str> = flags.split_whitespace().collect();
    let document = json(&flags);
    let outcome = &document["outcome"];
    assert_eq!(
        (&outcome["kind"], &outcome["half_swings"]),
        (&Value::from("rests"), &Value::from(2))
    );
    assert_close(number(&outcome["time"]), 14.997_017_142, 1e-9);
    let [lost, to_resistance] =
        ["energy_lost", "rolling_resistance_energy_lost"].map(|name| number(&document[name]));
    assert_close(lost - to_resistance, 0.25, 1e-13);
    let page = text(&flags);
    assert!(
        page.contains("m₂gR lost to rolling resistance, 0.25 m₂gR lost in sliding"),
        "{page}"
    );
    assert!(page.contains("skidding →"), "{page}");
}

#[test]
fn negative_numbers_are_taken_after_a_space_and_after_an_equals_sign() {
    let hoop = &FIGURE_3[..10];
    let theta = "-1.5707963267948966";
    let spaced = [
        &["simulate"],
        hoop,
        &["--theta", theta, "--theta-rate", "-2", "--slip", "-0"],
    ]
    .concat();
    let equals = [
        "--theta=-1.5707963267948966",
        "--theta-rate=-2",
        "--slip=-0",
    ];
    let equals = [&["simulate"], hoop, &equals].concat();
    let mirrored = json(&spaced);
    assert_eq!(mirrored, json(&equals));
    // The mirror image of Figure 3.
    let transitions = mirrored["transitions"].as_array().unwrap();
    assert_eq!(transitions.len(), 4);
    for (transition, [time, theta, rate, slip, x]) in transitions.iter().zip(FIGURE_3_EVENTS) {
        assert_close(number(&transition["time"]), time, 1e-12);
        for (name, expected) in [
            ("theta", -theta),
            ("theta_rate", -rate),
            ("slip", -slip),
            ("x", -x),
        ] {
            assert_close(number(&transition[name]), expected, 1e-12);
        }
    }
    let odd = [
        "simulate", "figure-3", "--theta", "-1e-3", "--slip", "-.5", "--x", "-7", "--time", "-1",
        "--until", "-.5",
    ];
    let odd = json(&odd);
    assert_eq!(odd["start"]["theta"], -1e-3);
    assert_eq!(odd["start"]["slip"], -0.5);
    assert_eq!(odd["start"]["x"], -7.0);
    assert_eq!(odd["start"]["time"], -1.0);
    assert_eq!(odd["outcome"]["time"], -0.5);
}

#[test]
fn flags_override_the_values_of_a_case() {
    let document = json(&["simulate", "figure-3", "--mu-k", "0.5", "--x", "2"]);
    assert_eq!(document["case"], "figure-3");
    assert_eq!(document["hoop"]["mu_s"], 0.5);
    assert_eq!(document["hoop"]["mu_k"], 0.5);
    assert_eq!(document["start"]["x"], 2.0);
    assert_eq!(document["start"]["theta_rate"], 2.0);
    let page = text(&["simulate", "figure-3", "--mu-k", "0.5"]);
    assert!(page.starts_with("figure-3 with another mu_k\n"), "{page}");
}

#[test]
fn every_case_is_printed_as_the_library_has_it() {
    for case in CASES {
        let motion = case.simulate().unwrap();
        let document = json(&["simulate", case.name]);
        assert_eq!(document["case"], case.name);
        let modes: Vec<&str> = document["phases"]
            .as_array()
            .unwrap()
            .iter()
            .map(|it| it["mode"].as_str().unwrap())
            .collect();
        assert_eq!(
            modes,
            motion
                .phases()
                .iter()
                .map(|it| it.mode().name())
                .collect::<Vec<_>>()
        );
        let transitions = document["transitions"].as_array().unwrap();
        assert_eq!(transitions.len(), motion.transitions().len());
        for (printed, transition) in transitions.iter().zip(motion.transitions()) {
            // Every digit is there: the number that is read back is the same, bit for bit.
            for (name, value) in STATE.iter().zip(transition.after.numbers()) {
                let expected = value.is_finite().then(|| value.to_bits());
                assert_eq!(
                    printed[name].as_f64().map(f64::to_bits),
                    expected,
                    "{} {name}",
                    case.name
                );
            }
            assert_eq!(printed["cause"], transition.cause.name());
            assert_eq!(
                printed["from"].as_str(),
                transition.from.map(littlewood::Mode::name)
            );
            assert_eq!(printed["to"].as_str(), transition.to.map(Mode::name));
        }
        assert_eq!(document["outcome"]["kind"], motion.outcome().kind().name());
        let limit = document["phases"]
            .as_array()
            .unwrap()
            .iter()
            .map(|it| !it["small_inertia_limit"].as_bool().unwrap());
        let expected = motion
            .phases()
            .iter()
            .map(Phase::is_outside_small_inertia_limit);
        assert!(limit.eq(expected));
    }
}

#[test]
fn a_start_that_leaves_the_plane_at_once_has_start_mode_flight() {
    // Footnote 3 of the paper: (θ, θ′) = (0, 4).
    let document = json(&["simulate", "figure-3", "--theta", "0", "--theta-rate", "4"]);
    assert_eq!(document["start"]["mode"], "flight");
    assert_eq!(document["start"]["direction"], 0);
    assert_eq!(document["phases"][0]["mode"], "flight");
    assert_eq!(document["transitions"][0]["cause"], "landing");
}

#[test]
fn rolling_for_ever_gives_the_period() {
    // A small oscillation about the bottom has the period 2π √(D(π)/ℓ) with D(π) = 2.
    let document = json(&[
        "simulate",
        "figure-3",
        "--theta",
        "3.1414926535897933",
        "--theta-rate",
        "0",
    ]);
    let outcome = &document["outcome"];
    assert_eq!(outcome["kind"], "rolls_forever");
    assert_eq!(outcome["recurrence"], "libration");
    assert_close(
        number(&outcome["period"]),
        2.0 * core::f64::consts::PI * 2.0_f64.sqrt(),
        1e-8,
    );
    assert_close(
        number(&outcome["theta_min"]),
        core::f64::consts::PI - 1e-4,
        1e-14,
    );
    assert_close(
        number(&outcome["theta_max"]),
        core::f64::consts::PI + 1e-4,
        1e-14,
    );
    assert_eq!(document["phases"][0]["duration"], Value::Null);

    let rest = json(&["simulate", "figure-3", "--theta", "0", "--theta-rate", "0"]);
    assert_eq!(rest["outcome"]["recurrence"], "rest");
    assert_eq!(rest["outcome"].get("period"), None);
    // A disc whose mass centre is its centre turns at a constant rate: a turn takes 2π/θ′.
    let disc = [
        "simulate",
        "--mass-ratio",
        "1",
        "--offset",
        "0",
        "--inertia",
        "0.5",
        "--mu-s",
        "0.2",
        "--mu-k",
        "0.1",
    ];
    let disc = json(&[&disc[..], &["--theta", "0", "--theta-rate", "-4"]].concat());
    assert_eq!(disc["outcome"]["recurrence"], "rotation");
    assert_close(
        number(&disc["outcome"]["period"]),
        core::f64::consts::FRAC_PI_2,
        1e-14,
    );
}

#[test]
fn the_massless_hoop_of_figure_7_ends_with_the_particle_at_the_plane() {
    let flags =
        "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 0 --theta-rate 0.5";
    let document = json(&[vec!["simulate"], flags.split(' ').collect()].concat());
    let transitions = document["transitions"].as_array().unwrap();
    // τ_s = ln 5, and gliding lasts (√89 − 3)/5.
    let slip = 1.609_437_912_434_100_3;
    assert_eq!(transitions[0]["cause"], "slip");
    assert_eq!(transitions[0]["to"], "gliding");
    assert_close(number(&transitions[0]["time"]), slip, 1e-14);
    assert_close(number(&transitions[0]["theta_rate"]), 0.75, 1e-14);
    let outcome = &document["outcome"];
    assert_eq!(outcome["kind"], "particle_at_plane");
    assert_close(
        number(&outcome["time"]),
        slip + (89.0_f64.sqrt() - 3.0) / 5.0,
        1e-14,
    );
    // An unbounded rate is no number of JSON.
    assert_eq!(outcome["theta_rate"], Value::Null);
}

#[test]
fn no_consistent_motion_is_a_result_and_says_what_was_found() {
    // A thin hoop with m1 = m2/3 on a rough plane: P < 0 for the only direction in question
    // (Painlevé).
    let third = (1.0_f64 / 3.0).to_string();
    let (theta, sin, cos) = (0.7, 0.644_217_687_237_691_1, 0.764_842_187_284_488_4);
    let hoop = [
        "simulate",
        "--mass-ratio",
        &third,
        "--offset",
        "1",
        "--inertia",
        &third,
        "--mu-s",
        "1",
        "--mu-k",
        "1",
    ];
    let start = ["--theta", "0.7", "--theta-rate", "0.5", "--slip", "1"];
    let document = json(&[&hoop[..], &start].concat());
    assert_eq!(document["start"]["theta"], theta);
    assert_eq!(document["start"]["mode"], Value::Null);
    assert_eq!(document["start"]["direction"], 0);
    assert_eq!(document["transitions"], serde_json::json!([]));
    let outcome = &document["outcome"];
    assert_eq!(outcome["kind"], "inconsistent");
    assert_eq!(outcome["consistent"], serde_json::json!([]));
    // P = I + m h sin θ (h sin θ − σ μk (1 + h cos θ)) with I = 7/12, h = 3/4, m h = 1.
    let solvability = |sigma: f64| 7.0 / 12.0 + sin * (0.75 * sin - sigma * (1.0 + 0.75 * cos));
    assert_close(
        number(&outcome["solvability_positive"]),
        solvability(1.0),
        1e-14,
    );
    assert_close(
        number(&outcome["solvability_negative"]),
        solvability(-1.0),
        1e-14,
    );
    assert_close(number(&outcome["contact"]), 1.0 - 0.75 * cos * 0.25, 1e-14);
    let page = text(&[&hoop[..], &start].concat());
    assert!(page.contains("Rigid bodies have no answer here"), "{page}");
    // In CSV too the reader learns what happened, with and without samples.
    for samples in [&[][..], &["--samples", "5"]] {
        let rows = text(&[&hoop[..], &start, &["--format", "csv"], samples].concat());
        assert!(
            rows.lines().last().unwrap().ends_with(",inconsistent"),
            "{rows}"
        );
    }
}

#[test]
fn limits_stop_the_motion_where_they_say() {
    let document = json(&["simulate", "figure-3", "--until", "1.25"]);
    assert_eq!(document["outcome"]["kind"], "time_limit");
    assert_eq!(document["outcome"]["time"], 1.25);
    assert_eq!(document["transitions"].as_array().unwrap().len(), 2);
    assert_eq!(document["phases"].as_array().unwrap().len(), 3);
    let document = json(&["simulate", "figure-3", "--max-transitions", "2"]);
    assert_eq!(document["outcome"]["kind"], "transition_limit");
    assert_eq!(document["outcome"]["transitions"], 2);
    assert_close(
        number(&document["outcome"]["time"]),
        FIGURE_3_EVENTS[1][0],
        1e-12,
    );
    // The first slide is as long as the chord from (0, π/2) to the stick; weight 1 + ln(1 + m/Î)
    // with m = 2, Î = 1.5.
    let [time, theta] = [
        FIGURE_3_EVENTS[0][0],
        FIGURE_3_EVENTS[0][1] - std::f64::consts::FRAC_PI_2,
    ];
    let length = libm::hypot(time, theta) * (1.0 + libm::log1p(2.0 / 1.5));
    assert!(length > 2.0 && length < 3.0, "{length}");
    let outcome =
        |slides: &str| json(&["simulate", "figure-3", "--max-slides", slides])["outcome"].clone();
    assert_eq!(
        (&outcome("2")["kind"], &outcome("3")["kind"]),
        (&"step_limit".into(), &"step_limit".into())
    );
    assert_close(number(&outcome("2")["time"]), FIGURE_3_EVENTS[0][0], 1e-12);
    assert_close(number(&outcome("3")["time"]), FIGURE_3_EVENTS[2][0], 1e-12);
    assert_eq!(outcome("30000")["kind"], "landing");
}

/// Figure 2's hoop with one coefficient of friction, from a start that rotates.
const ONE_COEFFICIENT: [&str; 10] = [
    "simulate",
    "figure-3",
    "--mu-s",
    "0.5",
    "--mu-k",
    "0.5",
    "--theta",
    "3",
    "--theta-rate",
    "2.36",
];

#[test]
fn a_motion_that_slips_for_ever_ends_by_a_proof_and_says_towards_what() {
    let document = json(&ONE_COEFFICIENT);
    let outcome = &document["outcome"];
    assert_eq!(outcome["kind"], "slips_forever");
    // reference/grazing.json
    assert_close(
        number(&outcome["grazing_energy"]),
        4.390_439_266_391_853,
        1e-13,
    );
    assert_close(
        number(&outcome["grazing_theta"]),
        1.628_570_503_598_365,
        1e-12,
    );
    assert_eq!(outcome["recurrence"], "rotation");
    let table = text(&ONE_COEFFICIENT);
    let words = table.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("Slips for ever") && words.contains("grazes the static limit at θ = ±1.6"),
        "{table}"
    );
}

#[test]
fn the_proofs_that_end_a_motion_can_be_chosen() {
    let with = |proof: &'static str| {
        json(
            &[
                &ONE_COEFFICIENT[..],
                &["--proof", proof, "--max-transitions", "60"],
            ]
            .concat(),
        )
    };
    assert_eq!(with("none")["outcome"]["kind"], "transition_limit");
    assert_eq!(with("endless")["outcome"]["kind"], "slips_forever");
    let slow = [
        "simulate",
        "figure-3",
        "--theta",
        "2.5",
        "--theta-rate",
        "0.1",
    ];
    let known = json(&[&slow[..], &["--proof", "contact"]].concat());
    assert_eq!(
        (&known["outcome"]["kind"], &known["outcome"]["time"]),
        (&"stays_in_contact".into(), &0.0.into())
    );
    assert_eq!(json(&slow)["outcome"]["kind"], "rolls_forever");
    let message = complaint(&["simulate", "figure-3", "--proof", "perhaps"], 2);
    assert!(
        message.contains("perhaps") && message.contains("contact"),
        "{message}"
    );
}

#[test]
fn samples_are_even_with_every_transition_twice_and_obey_the_laws() {
    let document = json(&["simulate", "figure-3", "--samples", "11", "--until", "3.5"]);
    assert_eq!(document["sampled_until"], 3.5);
    let samples = document["samples"].as_array().unwrap();
    // Eleven instants, and three transitions that appear before and after.
    assert_eq!(samples.len(), 11 + 2 * 3);
    let times: Vec<f64> = samples
        .iter()
        .map(|sample| number(&sample["time"]))
        .collect();
    assert!(times.is_sorted());
    for i in 0..=10 {
        let time = 0.35 * f64::from(i);
        assert!(
            times
                .iter()
                .any(|sampled| (sampled - time).abs() < 1e-15 * 4.0),
            "{time} is missing"
        );
    }
    for [time, ..] in FIGURE_3_EVENTS {
        assert_eq!(
            times
                .iter()
                .filter(|sampled| (*sampled - time).abs() < 1e-12)
                .count(),
            2
        );
    }
    let energies: Vec<f64> = samples
        .iter()
        .map(|sample| number(&sample["energy"]))
        .collect();
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-13));
    for sample in samples {
        let value = |name: &str| number(&sample[name]);
        let (theta, x) = (value("theta"), value("x"));
        let sin = libm::sin(theta);
        assert_close(value("particle_x"), x - sin, 1e-13);
        assert_close(value("mass_centre_x"), x - 0.5 * sin, 1e-13);
        assert_close(value("centre_y"), 1.0 + value("gap"), 1e-15);
        match sample["mode"].as_str().unwrap() {
            // Coulomb: F = −μk N σ.
            "sliding" => {
                let direction = sample["direction"].as_f64().unwrap();
                assert_close(value("friction"), -0.4 * direction * value("normal"), 1e-14);
            }
            "rolling" => assert!(value("friction").abs() <= 0.5 * value("normal") * (1.0 + 1e-12)),
            "flight" => assert!(value("normal") == 0.0 && value("gap") >= 0.0),
            other => panic!("{other} does not occur here"),
        }
    }
}

#[test]
fn a_motion_without_an_end_is_sampled_for_two_periods() {
    let document = json(&[
        "simulate",
        "figure-3",
        "--theta",
        "2.5",
        "--theta-rate",
        "0",
        "--samples",
        "5",
    ]);
    let period = number(&document["outcome"]["period"]);
    assert_close(number(&document["sampled_until"]), 2.0 * period, 1e-15);
    let samples = document["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 5);
    // A libration that starts at rest: there, on the other side, there, …
    for (index, sample) in samples.iter().enumerate() {
        let other_side = 2.0 * core::f64::consts::PI - 2.5;
        assert_close(
            number(&sample["theta"]),
            if index % 2 == 0 { 2.5 } else { other_side },
            1e-12,
        );
    }
}

#[test]
fn csv_has_a_row_for_the_start_and_for_each_transition() {
    let text = text(&["simulate", "figure-3", "--format", "csv"]);
    let table = Csv::read(&text);
    assert_eq!(
        table.columns,
        [
            "time",
            "theta",
            "theta_rate",
            "slip",
            "x",
            "from",
            "to",
            "direction",
            "cause"
        ]
    );
    assert_eq!(
        table.column("cause"),
        ["start", "stick", "slip", "lift_off", "landing"]
    );
    assert_eq!(table.rows[0]["from"], "");
    assert_eq!(table.rows[4]["to"], "");
    for (number, expected) in FIGURE_3_EVENTS.into_iter().enumerate() {
        let names = ["time", "theta", "theta_rate", "slip", "x"];
        for (name, expected) in names.into_iter().zip(expected) {
            assert_close(table.number(1 + number, name), expected, 1e-12);
        }
    }
    let last = support::text(&["simulate", "rolls-forever", "--format", "csv"]);
    assert!(
        last.lines()
            .last()
            .unwrap()
            .ends_with("rolling,,0,rolls_forever"),
        "{last}"
    );
}

#[test]
fn csv_samples_name_the_events() {
    for case in CASES
        .iter()
        .filter(|case| !case.simulate().unwrap().phases().is_empty())
    {
        let motion = case.simulate().unwrap();
        let text = text(&["simulate", case.name, "--format", "csv", "--samples", "20"]);
        let table = Csv::read(&text);
        assert_eq!(table.columns.last().unwrap(), "event");
        let mut events = table.column("event");
        events.retain(|event| !event.is_empty());
        let causes = motion
            .transitions()
            .iter()
            .map(|transition| Cause::name(transition.cause));
        assert_eq!(
            events,
            core::iter::once("start").chain(causes).collect::<Vec<_>>(),
            "{}",
            case.name
        );
        for (name, field) in table.rows.iter().flatten() {
            assert!(
                ["mode", "event"].contains(&name.as_str()) || field.parse::<f64>().is_ok(),
                "{name}: {field}"
            );
        }
    }
}

#[test]
fn the_page_shows_the_phases_of_figure_3_at_a_glance() {
    let page = text(&["simulate", "figure-3"]);
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[0][..5], ["1", "sliding", "←", "0", "0.56411"]);
    assert_eq!(rows[1][..4], ["2", "rolling", "0.56411", "0.40912"]);
    assert_eq!(rows[2][..5], ["3", "sliding", "→", "0.97322", "0.54545"]);
    assert_eq!(rows[3][..4], ["4", "flight", "1.51867", "2.32873"]);
    let ends: Vec<&str> = rows.iter().map(|row| row[row.len() - 1]).collect();
    assert_eq!(ends, ["stick", "slip", "lift-off", "landing"]);
    assert!(page.contains("         τ = 3.8474  θ = 9.89117"), "{page}");
    assert!(
        page.lines().all(|line| line.chars().count() <= 80),
        "{page}"
    );
    assert!(
        !page.contains('\u{1b}'),
        "no colour where there is no terminal"
    );
}

#[test]
fn the_page_of_every_case_fits_and_says_how_it_ends() {
    for case in CASES {
        let page = text(&["simulate", case.name]);
        assert!(
            page.lines().all(|line| line.chars().count() <= 100),
            "{page}"
        );
        assert!(page.contains("Outcome  "));
        assert!(page.starts_with(&format!("{}: {}", case.name, case.title)));
        let footnote = case
            .simulate()
            .unwrap()
            .phases()
            .iter()
            .any(Phase::is_outside_small_inertia_limit);
        assert_eq!(page.contains("\n* gliding as the paper has it"), footnote);
    }
}

#[test]
fn glides_outside_the_limit_of_small_inertia_are_marked() {
    // s σ > 0 and tan(θ/2) < μk: no limit of sliding motions. Littlewood's hoop beyond its
    // friction, with slip.
    let flags = "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 0.5 --theta-rate 0.2 --slip 0.5";
    let arguments = [vec!["simulate"], flags.split(' ').collect()].concat();
    assert_eq!(json(&arguments)["phases"][0]["small_inertia_limit"], false);
    let page = text(&arguments);
    assert!(
        page.contains("gliding →*") && page.contains("\n* gliding as the paper has it"),
        "{page}"
    );
}

#[test]
fn a_long_motion_is_shortened_on_the_page_only() {
    // Equal coefficients: slips shrink without end towards the orbit that grazes the static limit.
    let start: Vec<&str> =
        "simulate stick-slip-no-jump --mu-k 0.5 --max-transitions 100 --proof none"
            .split(' ')
            .collect();
    let document = json(&start);
    assert_eq!(document["transitions"].as_array().unwrap().len(), 100);
    let page = text(&start);
    assert!(page.contains("… 60 more"), "{page}");
    assert_eq!(
        page.lines()
            .filter(|line| line.contains("rolling") || line.contains("sliding"))
            .count(),
        40
    );
}

#[test]
fn help_and_version_are_no_errors() {
    littlewood()
        .arg("--version")
        .assert()
        .success()
        .stdout(predicate::str::starts_with("littlewood 0."));
    for command in ["simulate", "classify", "cases"] {
        littlewood()
            .args([command, "--help"])
            .assert()
            .success()
            .stdout(predicate::str::contains("Usage:"));
    }
    let help = text(&["simulate", "--help"]);
    for part in [
        "Examples:",
        "sqrt(R/g)",
        "(2.13)",
        "--theta-rate-rad-per-s",
        "[default: 9.80665]",
    ] {
        assert!(help.contains(part), "{part} is not in\n{help}");
    }
}

#[test]
fn digits_say_what_the_start_determines() {
    let digits = |arguments: &[&str]| json(&[&["simulate"], arguments, &["--digits"]].concat());
    let document = digits(&["figure-3"]);
    for transition in document["transitions"].as_array().unwrap() {
        let found = &transition["digits"];
        assert!(
            STATE
                .iter()
                .all(|name| (13..=15).contains(&found[name].as_u64().unwrap())),
            "{found}"
        );
    }
    assert_eq!(
        json(&["simulate", "figure-3"])["transitions"][0].get("digits"),
        None
    );

    // Beside Type II: the time between slip and reversal is 3e-8, and the slip at the plane has all
    // its digits.
    let near = "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5283159453317953 --mu-k 0.5283159453317953 \
                --theta 0.10426763454642875 --theta-rate 0.7535483562309895";
    let document = digits(&near.split_whitespace().collect::<Vec<_>>());
    assert!(
        document["transitions"][1]["digits"]["time"]
            .as_u64()
            .unwrap()
            >= 13
    );

    // θ′ and μs to the last digit on Type II: which gives way first is not decided.
    let tie = "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 0 --theta-rate 0.7745966692414834";
    let tie: Vec<&str> = tie.split_whitespace().collect();
    assert!(digits(&tie)["transitions"][0]["digits"].is_null());
    let page = text(&[&["simulate"], &tie[..], &["--digits"]].concat());
    assert!(
        page.contains("not decided by the last digits of the start"),
        "{page}"
    );

    let text = text(&["simulate", "figure-3", "--format", "csv", "--digits"]);
    let table = Csv::read(&text);
    let column = table.column("theta_digits");
    assert_eq!(column[0], "");
    assert!(
        column[1..]
            .iter()
            .all(|digits| digits.parse::<u8>().unwrap() >= 13),
        "{column:?}"
    );
}

#[test]
fn a_motion_that_ends_where_it_begins_has_its_start_as_a_sample() {
    // No motion is consistent at the start (Painlevé): where the hoop is and how it moves is known,
    // forces are not.
    let motion = json(&["simulate", "painleve", "--samples", "300"]);
    let samples = motion["samples"].as_array().expect("samples");
    assert_eq!(samples.len(), 1, "{samples:?}");
    let sample = &samples[0];
    for name in ["time", "theta", "theta_rate", "slip", "x"] {
        assert_eq!(sample[name], motion["start"][name], "{name}");
    }
    for name in [
        "mode",
        "normal",
        "friction",
        "couple",
        "theta_acceleration",
        "slip_acceleration",
    ] {
        assert_eq!(sample[name], serde_json::Value::Null, "{name}");
    }
    let csv = text(&[
        "simulate",
        "painleve",
        "--samples",
        "300",
        "--format",
        "csv",
    ]);
    let other = text(&["simulate", "figure-3", "--samples", "2", "--format", "csv"]);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 2, "{csv}");
    // The columns are those of the samples of any motion.
    assert_eq!(Some(lines[0]), other.lines().next());
    assert!(
        lines[1].starts_with("0.0,,0,0.7,0.5,1.0,0.0,") && lines[1].ends_with(",inconsistent"),
        "{csv}"
    );
}

#[test]
fn the_only_sample_has_the_energy_of_the_start() {
    let [start, hoop] = ["start", "hoop"].map(|part| json(&["simulate", "painleve"])[part].clone());
    let sample = json(&["simulate", "painleve", "--samples", "2"])["samples"][0].clone();
    let (mass, offset) = (1.0 + number(&hoop["mass_ratio"]), number(&hoop["offset"]));
    let [theta, rate, slip] = ["theta", "theta_rate", "slip"].map(|name| number(&start[name]));
    let h = offset / mass;
    // About the geometric centre the body has the moment of inertia of the disc and that of the
    // particle.
    let about_mass_centre = number(&hoop["inertia"]) + offset * offset - mass * h * h;
    let (vx, vy) = (
        slip - (1.0 + h * libm::cos(theta)) * rate,
        -h * libm::sin(theta) * rate,
    );
    let energy = 0.5 * (mass * (vx * vx + vy * vy) + about_mass_centre * rate * rate)
        + offset * libm::cos(theta);
    assert_close(number(&sample["energy"]), energy, 1e-14);
}

#[test]
fn a_table_is_not_longer_than_memory() {
    let message = complaint(&["simulate", "figure-3", "--samples", "100001"], 2);
    assert!(
        message.contains("100001 samples: a table has at most 100000"),
        "{message}"
    );
    assert!(message.contains("hint: give --format csv"), "{message}");
}

#[test]
fn numbers_in_messages_have_no_more_digits_than_a_double() {
    for (value, shown) in [
        ("1e300", "1e300"),
        ("-1e300", "-1e300"),
        ("1000000000000000", "1e15"),
        ("999999999999999", "999999999999999"),
        ("12345678.25", "12345678.25"),
    ] {
        let message = complaint(&["simulate", "figure-3", "--theta-rate", value], 2);
        assert!(
            message.contains(&format!("theta_rate = {shown} sqrt(g/R) must lie between")),
            "{message}"
        );
    }
    let message = complaint(&["simulate", "figure-3", "--mu-s", "-1e-300"], 2);
    assert!(message.contains("mu_s = -1e-300 must"), "{message}");
}

#[test]
#[allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics
fn derivatives_have_the_numbers_of_closed_forms_and_their_reasons() {
    // From the top Littlewood's hoop rolls with sin(θ/2) = θ0′ sinh(τ/2) (3.5), so that along the
    // slip ½ cos(θ/2) δθ = sinh(τ/2) δθ0′ + ½ θ0′ cosh(τ/2) δτ.
    let flags =
        "--mass-ratio 0 --offset 1 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 0 --theta-rate 0.5";
    let flags: Vec<&str> = flags.split(' ').collect();
    let document = json(
        &[
            &["simulate"],
            &flags[..],
            &["--derivatives", "theta_rate,x,inertia"],
        ]
        .concat(),
    );
    let slip = &document["transitions"][0];
    let of = |quantity: &str, name: &str| number(&slip["derivatives"][quantity][name]);
    let (time, theta) = (number(&slip["time"]), number(&slip["theta"]));
    assert_close((0.5 * theta).sin(), 0.5 * (0.5 * time).sinh(), 1e-14);
    let left = 0.5 * (0.5 * theta).cos() * of("theta_rate", "theta");
    let right = (0.5 * time).sinh() + 0.25 * (0.5 * time).cosh() * of("theta_rate", "time");
    assert_close(left, right, 1e-12);
    assert_close(of("x", "x"), 1.0, 0.0);
    assert_eq!(slip["derivatives"]["inertia"]["reason"], "one_sided");
    assert_eq!(
        document["outcome"]["derivatives"]["theta_rate"]["reason"],
        "singular"
    );

    // A libration has the derivatives of its period and of its ends.
    let document = json(&["simulate", "libration", "--derivatives", "theta"]);
    let found = &document["outcome"]["derivatives"]["theta"];
    let turns = ["theta_min", "theta_max"].map(|name| number(&found[name]));
    assert_close(turns[0].abs(), 1.0, 1e-12);
    assert_close(turns[0] + turns[1], 0.0, 1e-12);

    let all = [
        "simulate",
        "figure-3",
        "--restitution",
        "0.5",
        "--derivatives",
        "mu_k,all",
    ];
    assert_eq!(
        json(&all)["transitions"][3]["derivatives"]
            .as_object()
            .unwrap()
            .len(),
        14
    );
    let written = text(&[&all[..], &["--format", "json"]].concat());
    let [friction, angle] =
        ["\"mu_k\": {", "\"theta\": {"].map(|name| written.matches(name).count());
    assert_eq!(
        friction, angle,
        "a quantity that is named twice has one record"
    );
    let table = text(&[
        "simulate",
        "figure-3",
        "--format",
        "csv",
        "--derivatives",
        "mu-k",
    ]);
    assert!(
        table
            .lines()
            .next()
            .unwrap()
            .ends_with("d_slip_d_mu_k,d_x_d_mu_k"),
        "{table}"
    );
    let page = text(&["simulate", "figure-3", "--derivatives", "slip,mu_k"]);
    assert!(
        page.contains("one sided: on the two sides of this value the motion begins differently"),
        "{page}"
    );

    let error = complaint(&["simulate", "figure-3", "--derivatives", "muk"], 2);
    assert!(
        error.contains("named 'muk'") && error.contains("did you mean 'mu_k'"),
        "{error}"
    );
    let error = complaint(&["simulate", "figure-3", "--derivatives", "restitution"], 2);
    assert!(
        error.contains("with respect to restitution") && error.contains("give --restitution"),
        "{error}"
    );
}

#[test]
fn errors_of_the_given_numbers_become_those_of_the_events() {
    let document = json(&[
        "simulate",
        "figure-3",
        "--uncertainty",
        "mu_k=0.02,theta=0.5deg",
    ]);
    let found = &document["uncertainty"];
    assert_close(
        number(&found["given"]["theta"]),
        0.5_f64.to_radians(),
        1e-16,
    );
    assert_eq!(
        (found["motions"].as_u64(), found["alike"].as_u64()),
        (Some(10_000), Some(10_000))
    );
    let derivatives = json(&["simulate", "figure-3", "--derivatives", "mu_k,theta"]);
    for (index, spread) in found["transitions"].as_array().unwrap().iter().enumerate() {
        for name in STATE {
            let of = |quantity: &str| {
                number(&derivatives["transitions"][index]["derivatives"][quantity][name])
            };
            let (friction, angle) = (of("mu_k") * 0.02, of("theta") * 0.5_f64.to_radians());
            let [first, sample] = ["first_order", "sample"].map(|kind| number(&spread[kind][name]));
            assert_close(first, (friction * friction + angle * angle).sqrt(), 1e-12);
            // The standard error of a sample of 10,000, and what is beyond the first order.
            assert!(
                (sample - first).abs() <= 0.03 * first,
                "{index} {name}: {first} {sample}"
            );
        }
    }
    let page = text(&["simulate", "figure-3", "--uncertainty", "theta_rate=0.3"]);
    for part in [
        "of the motions have had other transitions",
        "the errors are too large for the first order",
    ] {
        assert!(page.contains(part), "{page}");
    }
    // A start without slip has no derivative with respect to it.
    let page = text(&["simulate", "figure-3", "--uncertainty", "slip=0.01"]);
    assert!(
        page.contains("without a derivative there is no first order"),
        "{page}"
    );
    let error = complaint(&["simulate", "figure-3", "--uncertainty", "mu_k=2deg"], 2);
    assert!(
        error.contains("mu_k is no angle") && error.contains("theta=0.5deg"),
        "{error}"
    );
    for bad in [
        "mu_k",
        "mu_k=-1",
        "mu_k=nan",
        "muk=1",
        "restitution=0.1",
        "mu_k=0.1,mu-k=0.2",
    ] {
        let error = complaint(&["simulate", "figure-3", "--uncertainty", bad], 2);
        assert!(error.contains("hint:"), "{bad}: {error}");
    }
}
