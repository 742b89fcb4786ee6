//! `littlewood atlas`.

use std::fs;

use crate::support::{complaint, json, number, text};

#[test]
fn an_atlas_counts_every_point_once() {
    let total = |found: &serde_json::Value| {
        let sequences = found["sequences"].as_array().expect("sequences");
        sequences
            .iter()
            .map(|entry| number(&entry["count"]))
            .sum::<f64>()
            + number(&found["invalid"])
    };
    let axes = ["--axis", "theta=-pi:pi:40", "--axis", "theta_rate=-4:4:30"];
    let found = json(&[&["atlas", "figure-3"], &axes[..]].concat());
    assert_eq!((total(&found), number(&found["points"])), (1200.0, 1200.0));
    let turns = [
        "--first-turn",
        "--axis",
        "theta_rate=0.1:2:20",
        "--axis",
        "mu_s=0.1:2:20",
    ];
    let found = json(&[&["atlas", "figure-3"], &turns[..]].concat());
    assert_eq!(total(&found), 400.0);
    let first = &found["sequences"][0];
    assert!(first["stop"].is_string());
    assert_eq!(first["example"]["theta"], 0.0);
    assert_eq!(first["example"]["mu_s"], first["example"]["mu_k"]);
    assert!(text(&[&["atlas", "figure-3"], &axes[..]].concat()).contains("on 1,200 starts"));
}

#[test]
fn an_atlas_of_a_list_of_hoops_is_that_of_each() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let hoops = folder.path().join("hoops.csv");
    let hoops = hoops.to_str().expect("a path");
    fs::write(hoops, "mass_ratio,inertia\n1,1\n0.25,0.25\n").expect("written");
    let axes = [
        "--axis",
        "theta=-pi:pi:20",
        "--axis",
        "theta_rate=-4:4:15",
        "--until",
        "20",
    ];
    let whole = json(&[&["atlas", "figure-3", "--hoops", hoops], &axes[..]].concat());
    assert_eq!(
        (number(&whole["points"]), number(&whole["total"])),
        (600.0, 600.0)
    );
    let parts = whole["hoops"].as_array().expect("hoops");
    let mut counts = std::collections::BTreeMap::<String, f64>::new();
    for (part, mass) in parts.iter().zip(["1", "0.25"]) {
        let alone = json(
            &[
                &["atlas", "figure-3", "--mass-ratio", mass, "--inertia", mass],
                &axes[..],
            ]
            .concat(),
        );
        assert_eq!(part["sequences"], alone["sequences"]);
        for entry in alone["sequences"].as_array().expect("sequences") {
            *counts.entry(entry["sequence"].to_string()).or_default() += number(&entry["count"]);
        }
    }
    assert_eq!(parts.len(), 2);
    assert_eq!(
        (&parts[1]["line"], &parts[1]["hoop"]["mass_ratio"]),
        (&3.into(), &0.25.into())
    );
    for entry in whole["sequences"].as_array().expect("sequences") {
        assert_eq!(
            counts[&entry["sequence"].to_string()],
            number(&entry["count"])
        );
    }
    assert_eq!(
        whole["sequences"].as_array().map(Vec::len),
        Some(counts.len())
    );
    assert_eq!(whole["kinds"]["sequences"], counts.len());
    assert!(
        text(&[&["atlas", "figure-3", "--hoops", hoops], &axes[..]].concat())
            .contains("of 2 hoops")
    );
}

#[test]
fn a_list_that_is_not_of_hoops_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let hoops = folder.path().join("hoops.csv");
    let hoops = hoops.to_str().expect("a path");
    let refused = |content: &str, more: &[&str]| {
        fs::write(hoops, content).expect("written");
        complaint(
            &[
                &[
                    "atlas",
                    "figure-3",
                    "--hoops",
                    hoops,
                    "--axis",
                    "theta=-1:1:5",
                ],
                more,
            ]
            .concat(),
            2,
        )
    };
    assert!(refused("theta_rate\n1\n", &[]).contains("theta_rate is of the start"));
    assert!(refused("mu_s\n1\n", &["--axis", "mu_s=0.5:1:5"]).contains("mu_s is an axis"));
    assert!(refused("mu_k\n0.2\n", &["--first-turn"]).contains("mu_k follows mu_s"));
    let message = refused("mu_s\n0.5\n0.3\n", &[]);
    assert!(
        message.contains("line 3") && message.contains("hint:"),
        "{message}"
    );
    assert!(refused("mu_s\n-1\n", &[]).contains("line 2"));
}
