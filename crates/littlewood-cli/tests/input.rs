//! Bad input: the value, its bound and a hint on the standard error, and exit code 2.

use crate::support::{FIGURE_3, complaint, littlewood, text};
use littlewood::RestitutionLaw;
use littlewood::tables::{Group, Quantity};

/// The message for Figure 3 with these flags on top.
fn refused(flags: &[&str]) -> String {
    let message = complaint(&[&["simulate", "figure-3"], flags].concat(), 2);
    assert!(message.starts_with("error: "), "{message}");
    message
}

#[test]
fn a_value_out_of_bounds_is_named_with_its_bound_and_a_hint() {
    let massless = ["--mass-ratio", "0", "--inertia", "0"];
    let massless_impact = [&massless[..], &["--restitution", "0.5"]].concat();
    let massless_flight = [&massless[..], &["--gap-rate", "0.5"]].concat();
    let cases: [(&[&str], &str, &str); 27] = [
        (
            &["--restitution", "1.5"],
            "restitution = 1.5 must not exceed 1",
            "one that gives everything back",
        ),
        (
            &["--restitution", "-0.1"],
            "restitution = -0.1 must not be negative",
            "0 is an impact without rebound",
        ),
        (
            &["--rolling-resistance", "-1"],
            "rolling_resistance = -1 must not be negative",
            "0 is a hoop that rolls for ever",
        ),
        (
            &["--restitution", "nan"],
            "restitution = NaN must be a finite number",
            "not numbers to start from",
        ),
        (
            &["--restitution", "inf"],
            "restitution = inf must be a finite number",
            "not numbers to start from",
        ),
        (
            &["--restitution-law", "newton"],
            "restitution_law = newton without restitution",
            "give the coefficient too, 0 to 1, or leave out the law",
        ),
        (
            &massless_impact,
            "restitution = 0.5 of a massless hoop (mass_ratio = 0, inertia = 0): an impulse would accelerate its rim",
            "give the hoop a mass or a moment of inertia",
        ),
        (
            &massless_flight,
            "gap_rate = 0.5 of a massless hoop",
            "give the hoop a mass or a moment of inertia",
        ),
        (
            &["--gap-rate", "-1"],
            "gap_rate = -1 sqrt(g R) must not be negative",
            "the rim starts at the plane",
        ),
        (
            &["--gap-rate", "nan"],
            "gap_rate = NaN sqrt(g R) must be a finite number",
            "not numbers to start from",
        ),
        (
            &["--gap-rate", "1e7"],
            "gap_rate = 10000000 sqrt(g R) must not exceed 1e6",
            "no longer resolves",
        ),
        (
            &["--mass-ratio", "2e9"],
            "mass_ratio = 2000000000 must not exceed 1e9",
            "no longer resolves",
        ),
        (
            &["--theta", "-2e9"],
            "theta = -2000000000 rad must lie between -1e9 and 1e9",
            "no longer resolves",
        ),
        (
            &["--mu-k", "0.6"],
            "mu_k = 0.6 must not exceed mu_s = 0.5",
            "0 <= mu_k <= mu_s",
        ),
        (
            &["--mu-s", "-0.1"],
            "mu_s = -0.1 must not be negative",
            "0 <= mu_k <= mu_s",
        ),
        (
            &["--mu-k=-1e-9"],
            "mu_k = -1e-9 must not be negative",
            "0 <= mu_k <= mu_s",
        ),
        (
            &["--offset", "1.5"],
            "offset = 1.5 must not exceed 1",
            "0 <= offset <= radius",
        ),
        (
            &["--offset", "-1"],
            "offset = -1 must not be negative",
            "0 <= offset <= radius",
        ),
        (
            &["--inertia", "-1"],
            "inertia = -1 must not be negative",
            "Izz = m1 R^2",
        ),
        (
            &["--mass-ratio", "-2"],
            "mass_ratio = -2 must not be negative",
            "massless hoop has mass 0",
        ),
        (
            &["--mass-ratio", "inf"],
            "mass_ratio = inf must be a finite number",
            "not numbers to start from",
        ),
        (
            &["--theta", "NaN"],
            "theta = NaN rad must be a finite number",
            "not numbers to start from",
        ),
        (
            &["--theta-rate", "-inf"],
            "theta_rate = -inf",
            "not numbers to start from",
        ),
        (
            &["--slip", "inf"],
            "slip = inf",
            "not numbers to start from",
        ),
        (
            &["--until", "nan"],
            "until = NaN",
            "not numbers to start from",
        ),
        (
            &["--time", "2", "--until", "1"],
            "until = 1 sqrt(R/g) must not be less than time = 2",
            "time limit is absolute",
        ),
        (
            &["--mass-ratio", "0", "--offset", "0", "--inertia", "0"],
            "offset = 0 and moment of inertia = 0",
            "move the particle off the centre",
        ),
    ];
    for (flags, message, hint) in cases {
        let found = refused(flags);
        assert!(found.contains(message), "{message} is not in\n{found}");
        let (_, found_hint) = found.split_once("\nhint: ").expect("there is a hint");
        assert!(found_hint.contains(hint), "{hint} is not in\n{found}");
    }
}

#[test]
fn classify_refuses_the_same_values() {
    let message = complaint(&["classify", "figure-3", "--offset", "1.5"], 2);
    assert!(
        message.contains("offset = 1.5 must not exceed 1"),
        "{message}"
    );
    let message = complaint(&["classify", "figure-3", "--restitution", "2"], 2);
    assert!(
        message.contains("restitution = 2 must not exceed 1"),
        "{message}"
    );
    let message = complaint(&["classify", "figure-3", "--restitution-law", "poisson"], 2);
    assert!(
        message.contains("restitution_law = poisson without restitution"),
        "{message}"
    );
    let message = complaint(&["classify", "figure-3", "--theta", "inf"], 2);
    assert!(
        message.contains("theta = inf rad must be a finite number"),
        "{message}"
    );
}

#[test]
fn what_is_no_number_is_refused() {
    for (flags, part) in [
        (&["--theta", "ninety"][..], "'ninety' for '--theta <RAD>'"),
        (&["--theta=1.5.2"], "'1.5.2'"),
        (&["--theta", ""], "''"),
        (
            &["--theta", "--slip", "2"],
            "a value is required for '--theta <RAD>'",
        ),
        (&["--theta"], "a value is required"),
        (&["--samples", "1"], "'1' for '--samples <N>'"),
        (&["--samples", "-5"], "-5"),
        (&["--max-transitions", "0"], "'0'"),
        (&["--max-slides", "0"], "'0'"),
        (&["--format", "xml"], "possible values"),
        (
            &["--restitution", "0.5", "--restitution-law", "stronge"],
            "energetic, poisson, newton",
        ),
        (
            &["--restitution-law"],
            "a value is required for '--restitution-law <LAW>'",
        ),
    ] {
        let message = refused(flags);
        assert!(message.contains(part), "{part} is not in\n{message}");
    }
}

#[test]
fn an_unknown_flag_or_command_is_refused() {
    assert!(refused(&["--mass-ration", "1"]).contains("--mass-ratio"));
    assert!(complaint(&["simulat"], 2).contains("simulate"));
    complaint(&["simulate", "figure-3", "figure-3"], 2);
    littlewood().assert().code(2);
}

#[test]
fn every_missing_value_is_named() {
    for missing in (0..FIGURE_3.len()).step_by(2) {
        let mut flags = FIGURE_3.to_vec();
        flags.drain(missing..missing + 2);
        let message = complaint(&[&["simulate"], &flags[..]].concat(), 2);
        let flag = FIGURE_3[missing];
        let name = flag.trim_start_matches('-').replace('-', "_");
        assert!(
            message.starts_with(&format!("error: missing: {name}\n")),
            "{message}"
        );
        assert!(
            message.contains(&format!("hint: give {flag}, or start from a case")),
            "{message}"
        );
    }
    let message = complaint(&["simulate", "--si"], 2);
    for name in [
        "disc_mass_kg",
        "particle_mass_kg",
        "radius_m",
        "theta_rate_rad_per_s",
    ] {
        assert!(message.contains(name), "{message}");
    }
}

#[test]
fn an_unknown_case_brings_the_nearest_names() {
    for typed in ["figure3", "Figure 3", "figure_3", "figur-3"] {
        let message = complaint(&["simulate", typed], 2);
        assert!(
            message.contains(&format!("there is no case named '{typed}'")),
            "{message}"
        );
        assert!(message.contains("did you mean 'figure-3'"), "{message}");
    }
    let message = complaint(&["classify", "zzzzzz"], 2);
    assert!(
        message.contains("hint: `littlewood cases` lists the names"),
        "{message}"
    );
}

#[test]
fn the_two_systems_of_units_do_not_mix() {
    let message = refused(&["--theta-rate", "2", "--radius-m", "0.5"]);
    assert!(
        message.contains("--theta-rate is dimensionless and --radius-m is in SI units"),
        "{message}"
    );
    assert!(
        message.contains("hint: in SI units --theta-rate is --theta-rate-rad-per-s"),
        "{message}"
    );
    let message = refused(&["--si", "--until", "3"]);
    assert!(
        message.contains("--until is dimensionless and --si is in SI units"),
        "{message}"
    );
}

#[test]
fn a_wrong_si_value_is_named_in_its_unit() {
    let size = ["--si", "--radius-m", "0.5", "--particle-mass-kg", "0.2"];
    for (flags, part) in [
        (
            &["--offset-m", "0.6"][..],
            "offset_m = 0.6 m must not exceed radius_m = 0.5 m",
        ),
        (
            &["--disc-mass-kg", "-1"],
            "disc_mass_kg = -1 kg must not be negative",
        ),
        (
            &["--inertia-kg-m2", "-1"],
            "inertia_kg_m2 = -1 kg m^2 must not be negative",
        ),
        (
            &["--gravity-m-per-s2", "0"],
            "gravity_m_per_s2 = 0 m/s^2 must be greater than 0",
        ),
        (
            &["--theta-rate-rad-per-s", "nan"],
            "theta_rate_rad_per_s = NaN rad/s must be a finite number",
        ),
        (
            &["--time-s", "3", "--until-s", "2"],
            "until_s = 2 s must not be less than time_s = 3 s",
        ),
        (
            &["--until-s", "inf"],
            "until_s = inf s must be a finite number",
        ),
        (
            &["--gap-rate-m-per-s", "-1"],
            "gap_rate_m_per_s = -1 m/s must not be negative",
        ),
        (
            &["--restitution", "nan"],
            "restitution = NaN must be a finite number",
        ),
        (
            &["--restitution-law", "newton"],
            "restitution_law = newton without restitution",
        ),
    ] {
        let message = refused(&[&size, flags].concat());
        assert!(message.contains(part), "{part} is not in\n{message}");
    }
    let message = refused(&["--radius-m", "0", "--particle-mass-kg", "1"]);
    assert!(
        message.contains("radius_m = 0 m must be greater than 0"),
        "{message}"
    );
}

#[test]
fn every_quantity_has_a_flag_with_its_help_and_default() {
    let help = text(&["simulate", "--help"]);
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let help = words(&help);
    for quantity in Quantity::ALL {
        let row = quantity.row();
        let flag = format!("--{} <", quantity.name().replace('_', "-"));
        let (_, text) = help
            .split_once(&flag)
            .unwrap_or_else(|| panic!("{flag} is not in\n{help}"));
        let default = row
            .presence
            .default_value()
            .map(|default| format!(" [default: {default}]"))
            .unwrap_or_default();
        let (_, text) = text.split_once("> ").expect("the name of a value ends");
        assert!(
            text.starts_with(&words(&format!("{}{default}", row.help))),
            "{flag}: {text}"
        );
    }
    assert!(help.contains("[alias: --theta-rad]"), "{help}");
    // Every command that takes a hoop takes the law of its impacts.
    for command in [
        "simulate", "classify", "map", "sweep", "figures", "poster", "animate",
    ] {
        let help = text(&[command, "--help"]);
        assert!(
            help.contains("--restitution <RATIO>") && help.contains("--restitution-law <LAW>"),
            "{help}"
        );
        for law in RestitutionLaw::NAMES {
            assert!(help.contains(law), "{law} is not in\n{help}");
        }
    }
    // The axes of a map have the names of x; where and when a motion starts changes nothing else.
    let map = text(&["map", "--help"]);
    for quantity in Quantity::ALL {
        let flag = format!("  --{} <", quantity.name().replace('_', "-"));
        let is_there = quantity.group() != Group::Place || quantity.is_si();
        assert_eq!(
            map.contains(&flag),
            is_there || quantity == Quantity::X,
            "{flag}"
        );
    }
}
