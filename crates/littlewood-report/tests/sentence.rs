//! What the sentences say, against numbers worked out by hand from the equations of the paper.

use littlewood::cases::{CASES, find_case};
use littlewood::si::SiParameters;
use littlewood::{Hoop, HoopParameters, Limits, Mode, Start};
use littlewood_report::scale::Scale;
use littlewood_report::sentence;

const PLAIN: Scale<'_> = Scale::new(None);

#[test]
fn figure_3_begins_with_too_little_friction() {
    // At θ = π/2, θ′ = 2: D = 4, f_R = 5/4, N = 2 − 5/4 = 3/4, F = 4 − 2·5/4 = 3/2 (2.11, 2.12), so
    // |F|/N = 2.
    let motion = find_case("figure-3").unwrap().simulate().unwrap();
    assert_eq!(
        sentence::start(&motion, PLAIN),
        "Slips: rolling would have needed a friction coefficient of 2; there is 0.5."
    );
    let told: Vec<String> = (0..4)
        .map(|i| sentence::transition(&motion, i, PLAIN).unwrap())
        .collect();
    for (text, begin) in told.iter().zip([
        "Sticks and rolls",
        "Slips: it needs more friction than the ground has (μₛ = 0.5).",
        "Jumps. The ground no longer pushes (N = 0), and the mass centre still rises at ",
        "Lands",
    ]) {
        assert!(text.starts_with(begin), "{text}");
    }
    // The mass centre rises at −h sin θ θ′ = 0.865 (2.7), from the state at the lift-off to 18
    // digits.
    let rise = -0.5 * libm::sin(5.236_735_770_878_168) * 1.998_705_937_114_139_9;
    assert!(
        told[2].contains(&format!("rises at {rise:.3} √(gR)")),
        "{}",
        told[2]
    );
    assert_eq!(sentence::transition(&motion, 4, PLAIN), None);
    assert_eq!(sentence::outcome(&motion, PLAIN), told[3]);
}

#[test]
fn lengths_and_times_have_the_units_that_are_asked_for() {
    let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
    let motion = hoop
        .simulate(Start::at(0.0, 4.0), Limits::default())
        .unwrap();
    let units = SiParameters {
        particle_mass_kg: 0.14,
        radius_m: 0.45,
        ..SiParameters::default()
    }
    .units()
    .unwrap();
    let plain = sentence::outcome(&motion, PLAIN);
    let si = sentence::outcome(&motion, Scale::new(Some(&units)));
    assert!(
        plain.contains(" R to the left after ") && plain.contains(" √(R/g) in the air"),
        "{plain}"
    );
    assert!(
        si.contains(" m to the left after ") && si.contains(" s in the air"),
        "{si}"
    );
}

#[test]
fn what_a_start_says_is_what_the_equations_say_there() {
    let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
    let first = |theta, rate| {
        sentence::start(
            &hoop
                .simulate(Start::at(theta, rate), Limits::default())
                .unwrap(),
            PLAIN,
        )
    };
    assert_eq!(
        first(core::f64::consts::PI, 0.0),
        "Rolls: static friction holds the contact point."
    );
    // At θ = 0 it is left at once if h θ′² > 1, θ′ > √2.
    assert_eq!(
        first(0.0, 1.5),
        "Leaves at once: only a pull from the ground could hold it down, h cos θ θ′² > 1."
    );
    let told = |name: &str| sentence::start(&find_case(name).unwrap().simulate().unwrap(), PLAIN);
    assert_eq!(
        told("sliding-band"),
        "Slips: to roll, the ground would have to pull it down, and it can only push."
    );
    assert!(
        told("painleve").starts_with("Rigid bodies have no answer here (Painlevé's paradox): ")
    );
    let massless = find_case("figure-7").unwrap().simulate().unwrap();
    assert_eq!(
        sentence::outcome(&massless, PLAIN),
        "The particle reaches the ground; the model ends here. A rim without mass cannot be struck."
    );
}

/// Of Figure 2, m = 2, h = 1/2, D = 4 + 2 cos θ: θ″ = sin θ (1 + θ′²)/D (2.11), N = 2 − sin θ θ″ −
/// cos θ θ′², F = sin θ θ′² − (2 + cos θ) θ″ (2.12).
#[test]
fn the_friction_that_is_needed_is_that_of_the_instant() {
    let mut told = Vec::new();
    for name in ["rolls-forever", "figure-3", "stick-slip-no-jump"] {
        let motion = find_case(name).unwrap().simulate().unwrap();
        for sample in motion.sample_evenly(60, motion.end_time().min(8.0)) {
            let text = sentence::friction(motion.hoop(), &sample);
            assert_eq!(text.is_some(), sample.mode == Mode::Rolling, "{name}");
            let Some(text) = text else { continue };
            let (theta, rate) = (sample.state.theta, sample.state.theta_rate);
            let (sin, cos) = libm::sincos(theta);
            let acceleration = sin * (1.0 + rate * rate) / (4.0 + 2.0 * cos);
            let normal = 2.0 - sin * acceleration - cos * rate * rate;
            let friction = sin * rate * rate - (2.0 + cos) * acceleration;
            let needed = friction.abs() / normal;
            if needed < 1e-12 {
                assert_eq!(text, "Rolling needs no friction here.");
                continue;
            }
            let number = text
                .strip_prefix("Rolling needs |F|/N = ")
                .and_then(|rest| rest.strip_suffix(" here; μₛ = 0.5."))
                .unwrap_or_else(|| panic!("{text}"));
            let number: f64 = number.replace('−', "-").parse().unwrap();
            assert!(
                (number - needed).abs() <= 0.00501 * needed + 1e-13,
                "{text}, and it is {needed}"
            );
            told.push(text);
        }
    }
    told.sort();
    told.dedup();
    assert!(told.len() > 60, "{}", told.len());
}

#[test]
fn a_slip_that_is_rounding_is_none() {
    // Bounces that never slip: before each impact the contact point is at rest, up to rounding.
    let motion = find_case("bounces-forever").unwrap().simulate().unwrap();
    let impacts = motion
        .transitions()
        .iter()
        .filter(|event| event.impact.is_some())
        .count();
    assert!(impacts > 10);
    for index in 0..motion.transitions().len() {
        let text = sentence::transition(&motion, index, PLAIN).unwrap();
        assert!(!text.contains("slips"), "{index}: {text}");
    }
}

/// The skid of docs/theory/rolling-resistance.md, and the disc that slips by its own resistance: it
/// needs |F|/N = χ m/(Î + m) to roll.
#[test]
fn a_hoop_that_rests_says_what_holds_it() {
    let hoop = |offset: f64, [mu_s, mu_k, chi]: [f64; 3]| {
        let parameters = HoopParameters::thin(1.0)
            .with_offset(offset)
            .with_inertia(0.5)
            .with_friction(mu_s, mu_k)
            .with_rolling_resistance(chi);
        Hoop::new(parameters).unwrap()
    };
    let skid = hoop(0.6, [0.4, 0.3, 0.1])
        .simulate(Start::at(1.21625, 0.0).with_slip(0.5), Limits::default())
        .unwrap();
    let told = (0..3).map(|i| sentence::transition(&skid, i, PLAIN).unwrap());
    let told: Vec<String> = [sentence::start(&skid, PLAIN)]
        .into_iter()
        .chain(told)
        .chain([sentence::outcome(&skid, PLAIN)])
        .collect();
    assert_eq!(
        told,
        [
            "Skids to the right: it slips, and rolling resistance holds it against its weight.",
            "Sticks and rolls: the slip has died away, and static friction holds the contact point.",
            "Turns back: it has stopped, and its weight outdoes the rolling resistance.",
            "Comes to rest: it has stopped, and rolling resistance holds it against its weight.",
            "Rests for ever, after 2 half swings: rolling resistance holds it against its weight.",
        ]
    );
    let disc = hoop(0.0, [0.2, 0.2, 0.3])
        .simulate(Start::at(0.0, 1.0), Limits::default())
        .unwrap();
    assert_eq!(
        sentence::start(&disc, PLAIN),
        "Slips: rolling would have needed a friction coefficient of 0.24; there is 0.2."
    );
    // It is not slip that goes on.
    let swings = hoop(1.0, [0.5, 0.4, 1e-6])
        .simulate(Start::at(2.5, 0.0), Limits::default().with_transitions(10))
        .unwrap();
    assert_eq!(
        sentence::outcome(&swings, PLAIN),
        "Stopped after 10 transitions: it swings on, less each time."
    );
}

#[test]
fn every_case_has_a_sentence_for_each_of_its_events() {
    for case in CASES {
        let motion = case.simulate().unwrap();
        let told =
            (0..motion.transitions().len()).filter_map(|i| sentence::transition(&motion, i, PLAIN));
        let all = [
            sentence::start(&motion, PLAIN),
            sentence::outcome(&motion, PLAIN),
        ];
        for text in all.into_iter().chain(told) {
            assert!(
                text.ends_with('.') && text.chars().next().is_some_and(char::is_uppercase),
                "{}: {text}",
                case.name
            );
            assert!(
                !text.contains("NaN") && !text.contains('_'),
                "{}: {text}",
                case.name
            );
        }
    }
}
