//! Scenario files: what they say, what flags change, and what is wrong with them.

use std::fs;
use std::path::PathBuf;

use crate::support::{FIGURE_3_EVENTS, assert_close, complaint, example, json, number, text};
use littlewood::tables::Quantity;
use tempfile::TempDir;

/// A scenario file in a folder of its own.
fn scenario(content: &str) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a folder for the test");
    let path = folder.path().join("hoop.toml");
    fs::write(&path, content).expect("a file for the test");
    (folder, path)
}

/// The message for a scenario that is refused.
fn refused(content: &str) -> String {
    let (_folder, path) = scenario(content);
    complaint(
        &[
            "simulate",
            "--scenario",
            path.to_str().expect("a path in UTF-8"),
        ],
        2,
    )
}

#[test]
fn every_example_runs() {
    let mut count = 0;
    for entry in fs::read_dir(example("")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let path = path.to_str().unwrap();
        assert!(!text(&["simulate", "--scenario", path]).is_empty());
        text(&["classify", "--scenario", path]);
        count += 1;
    }
    assert!(count >= 3);
}

#[test]
fn a_scenario_with_integers_and_numbers_is_figure_3() {
    let document = json(&["simulate", "--scenario", &example("figure-3.toml")]);
    assert_eq!(document["phases"].as_array().unwrap().len(), 4);
    for (transition, expected) in document["transitions"]
        .as_array()
        .unwrap()
        .iter()
        .zip(FIGURE_3_EVENTS)
    {
        assert_close(number(&transition["time"]), expected[0], 1e-12);
    }
}

#[test]
fn flags_override_a_scenario_and_a_scenario_its_case() {
    let path = example("pushed.toml");
    let document = json(&[
        "simulate",
        "--scenario",
        &path,
        "--slip",
        "0.5",
        "--until",
        "0.1",
    ]);
    assert_eq!(document["case"], "figure-3");
    assert_eq!(document["hoop"]["mu_k"], 0.4);
    assert_eq!(document["start"]["theta"], 3.0);
    assert_eq!(document["start"]["x"], 2.0);
    assert_eq!(document["start"]["slip"], 0.5);
    assert_eq!(document["start"]["direction"], 1);
    assert_eq!(document["outcome"]["time"], 0.1);
    // The file asks for nine samples in CSV; --format json changes the format only.
    assert!(document["samples"].as_array().unwrap().len() >= 9);
    let rows = text(&["simulate", "--scenario", &path]);
    assert!(rows.starts_with("time,mode,direction,theta"), "{rows}");
}

#[test]
fn a_scenario_names_its_output_file_from_its_own_folder() {
    let (folder, path) = scenario("case = \"figure-3\"\n[run]\nout = \"motion.json\"\n");
    assert_eq!(
        text(&["simulate", "--scenario", path.to_str().unwrap()]),
        ""
    );
    let written = fs::read_to_string(folder.path().join("motion.json")).unwrap();
    let document: serde_json::Value = serde_json::from_str(&written).unwrap();
    assert_eq!(document["outcome"]["kind"], "landing");
}

#[test]
fn dimensionless_flags_change_a_scenario_in_si_units() {
    let document = json(&[
        "simulate",
        "--scenario",
        &example("hula-hoop.toml"),
        "--theta-rate",
        "2",
        "--until",
        "1",
    ]);
    assert_eq!(document["start"]["theta_rate"], 2.0);
    assert!(number(&document["outcome"]["time"]) <= 1.0);
    let unit = (0.45_f64 / 9.81).sqrt();
    assert_close(
        number(&document["start"]["si"]["theta_rate_rad_per_s"]),
        2.0 / unit,
        1e-14,
    );
}

#[test]
fn broken_toml_is_shown_where_it_breaks() {
    let message = refused("case = \"figure-3\"\n[start]\ntheta = = 2\n");
    assert!(message.contains("hoop.toml:3:9"), "{message}");
    assert!(message.contains("theta = = 2"), "{message}");
    assert!(message.contains("hint: "), "{message}");
}

#[test]
fn an_unknown_key_is_shown_with_those_that_exist() {
    let message = refused("case = \"figure-3\"\n\n[hoop]\nmu = 0.5\n");
    assert!(
        message.contains("there is no key 'mu' in [hoop]"),
        "{message}"
    );
    assert!(
        message.contains("did you mean 'mu_s' or 'mu_k'?"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:4:1"), "{message}");
    assert!(refused("[hop]\n").contains("did you mean 'hoop'?"));
    assert!(refused("[si.start]\ntheta = 1.0\n").contains("did you mean 'theta_rad'"));
    assert!(refused("[run]\nsample = 5\n").contains("did you mean 'samples'"));
    assert!(refused("[si]\nstart.time = 5\n").contains("did you mean 'time_s'"));
}

#[test]
fn every_quantity_is_a_key_of_its_table() {
    let numbers = |quantities: &[Quantity]| {
        let line = |quantity: &Quantity| format!("{quantity} = 0.5\n");
        quantities.iter().map(line).collect::<String>()
    };
    let plain = format!(
        "[hoop]\n{}[start]\n{}",
        numbers(&Quantity::HOOP),
        numbers(&Quantity::START)
    );
    let (_folder, path) = scenario(&plain);
    let document = json(&["classify", "--scenario", path.to_str().unwrap()]);
    for (table, quantities) in [("hoop", &Quantity::HOOP[..]), ("start", &Quantity::START)] {
        for quantity in quantities {
            assert_eq!(document[table][quantity.name()], 0.5, "{quantity}");
        }
    }
    let in_si = numbers(&Quantity::SI_START).replace("theta =", "theta_rad =");
    let hoop_in_si = numbers(&Quantity::SI_HOOP).replace("slope =", "slope_rad =");
    let si = format!("[si.hoop]\n{hoop_in_si}[si.start]\n{in_si}");
    let (_folder, path) = scenario(&si);
    let document = json(&["classify", "--scenario", path.to_str().unwrap()]);
    for quantity in Quantity::SI_HOOP {
        assert_close(number(&document["si"]["hoop"][quantity.name()]), 0.5, 1e-15);
    }
    let names = [
        "theta_rad",
        "theta_rate_rad_per_s",
        "slip_m_per_s",
        "gap_rate_m_per_s",
        "x_m",
        "time_s",
    ];
    for name in names {
        assert_close(number(&document["start"]["si"][name]), 0.5, 1e-15);
    }
}

/// A run in JSON as the scenario that gives it again.
fn scenario_of(document: &serde_json::Value, run: &str) -> String {
    let table = |name: &str| {
        let fields = document[name].as_object().expect("an object").iter();
        let fields = fields.filter(|(key, _)| !["mode", "direction", "si"].contains(&key.as_str()));
        let lines: String = fields
            .map(|(key, value)| format!("{key} = {value}\n"))
            .collect();
        format!("[{name}]\n{lines}")
    };
    format!("{}{}[run]\n{run}\n", table("hoop"), table("start"))
}

#[test]
fn a_motion_with_impacts_comes_back_from_its_json() {
    for (case, law) in [
        ("figure-3-bounces", "poisson"),
        ("figure-3-bounces", "energetic"),
        ("jam", "energetic"),
        ("bounces-forever", "newton"),
    ] {
        let mut document = json(&["simulate", case, "--restitution-law", law, "--until", "12"]);
        document.as_object_mut().unwrap().remove("case");
        let (_folder, path) = scenario(&scenario_of(&document, "until = 12"));
        assert_eq!(
            json(&["simulate", "--scenario", path.to_str().unwrap()]),
            document,
            "{case}, {law}"
        );
    }
}

#[test]
fn the_law_of_restitution_is_a_key_of_both_hoops() {
    let run = |content: &str, flags: &[&str]| {
        let (_folder, path) = scenario(content);
        let document = json(&[&["simulate", "--scenario", path.to_str().unwrap()], flags].concat());
        document["hoop"]["restitution_law"].clone()
    };
    let plain = "case = \"figure-3\"\n[hoop]\nrestitution = 0.5\nrestitution_law = \"poisson\"\n";
    assert_eq!(run(plain, &[]), "poisson");
    assert_eq!(run(plain, &["--restitution-law", "newton"]), "newton");
    let si =
        "case = \"figure-3\"\n[si.hoop]\nradius_m = 1\nparticle_mass_kg = 1\nrestitution = 0.5\n";
    assert_eq!(run(si, &[]), "energetic");
    assert_eq!(
        run(&format!("{si}restitution_law = \"newton\"\n"), &[]),
        "newton"
    );
    // A coefficient and its law may come from different places.
    let law = "case = \"figure-3\"\n[hoop]\nrestitution_law = \"poisson\"\n";
    assert_eq!(run(law, &["--restitution", "0.2"]), "poisson");
    assert_eq!(
        run(
            "case = \"figure-3-bounces\"\n[hoop]\nrestitution_law = \"newton\"\n",
            &[]
        ),
        "newton"
    );
}

#[test]
fn a_law_that_is_wrong_is_shown_with_its_place() {
    let message = refused("case = \"figure-3\"\n[hoop]\nrestitution_law = \"newton\"\n");
    assert!(
        message.contains("restitution_law = newton without restitution"),
        "{message}"
    );
    assert!(
        message.contains("hoop.toml:3:19") && message.contains("give the coefficient too"),
        "{message}"
    );
    let message =
        refused("case = \"figure-3\"\n[hoop]\nrestitution = 0.5\nrestitution_law = \"newtons\"\n");
    assert!(
        message.contains("there is no law of restitution 'newtons'"),
        "{message}"
    );
    assert!(
        message.contains("did you mean 'newton'") && message.contains("hoop.toml:4:19"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[hoop]\nrestitution = 0.5\nrestitution_law = 1\n");
    assert!(
        message.contains("restitution_law is not a string"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[si.hoop]\nrestitution_law = \"newton\"\n");
    assert!(
        message.contains("missing: particle_mass_kg, radius_m"),
        "{message}"
    );
    let size = "radius_m = 1\nparticle_mass_kg = 1\n";
    let message = refused(&format!(
        "case = \"figure-3\"\n[si.hoop]\n{size}restitution_law = \"newton\"\n"
    ));
    assert!(
        message.contains("newton without restitution") && message.contains("hoop.toml:5:19"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[hoop]\nrestitution = 1.25\n");
    assert!(
        message.contains("restitution = 1.25 must not exceed 1"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:3:15"), "{message}");
    let message = refused("case = \"figure-3\"\n[hoop]\nrestitution = nan\n");
    assert!(
        message.contains("restitution = NaN must be a finite number"),
        "{message}"
    );
    let message = refused("case = \"figure-7\"\n[hoop]\nrestitution = 0.5\n");
    assert!(
        message.contains("of a massless hoop") && message.contains("hoop.toml:3:15"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[start]\ngap_rate = -0.5\n");
    assert!(
        message.contains("gap_rate = -0.5 sqrt(g R) must not be negative"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[hoop]\nrestitution_lav = \"newton\"\n");
    assert!(
        message.contains("did you mean 'restitution_law'"),
        "{message}"
    );
}

#[test]
fn a_value_out_of_bounds_is_shown_with_its_place() {
    let message = refused("case = \"figure-3\"\n[hoop]\nmu_k = 0.75\n");
    assert!(
        message.contains("mu_k = 0.75 must not exceed mu_s = 0.5"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:3:8"), "{message}");
    assert!(
        message.contains("kinetic friction is never stronger"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[start]\ntheta = nan\n");
    assert!(
        message.contains("theta = NaN rad must be a finite number"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:3:9"), "{message}");
    let message = refused("case = \"figure-3\"\n[start]\ntime = 5\n[run]\nuntil = 4\n");
    assert!(
        message.contains("until = 4 sqrt(R/g) must not be less than time = 5"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:5:9"), "{message}");
    let message = refused(
        "case = \"figure-3\"\n[si.hoop]\nradius_m = 0.5\nparticle_mass_kg = 1\noffset_m = 2\n",
    );
    assert!(
        message.contains("offset_m = 2 m must not exceed radius_m = 0.5 m"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:5:12"), "{message}");
}

#[test]
fn other_mistakes_in_a_scenario_are_shown_too() {
    let message = refused("case = \"figure-33\"\n");
    assert!(
        message.contains("there is no case named 'figure-33'"),
        "{message}"
    );
    assert!(message.contains("did you mean 'figure-3'"), "{message}");
    assert!(message.contains("hoop.toml:1:8"), "{message}");
    let message = refused("case = \"figure-3\"\n[start]\ntheta = \"1.5\"\n");
    assert!(message.contains("hoop.toml:3:9"), "{message}");
    assert!(
        message.contains("theta is not a number, but of the type string"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\nhoop = 3\n");
    assert!(
        message.contains("hoop is not a table") && message.contains("hoop.toml:2:8"),
        "{message}"
    );
    let message = refused("case = \"figure-3\"\n[run]\nformat = \"xml\"\n");
    assert!(
        message.contains("there is no format 'xml'") && message.contains("table, json, csv"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:3:10"), "{message}");
    let message = refused("[start]\ntheta_rate = 2\n[si.hoop]\nradius_m = 1\n");
    assert!(
        message.contains("theta_rate is dimensionless and radius_m is in SI units"),
        "{message}"
    );
    assert!(message.contains("theta_rate_rad_per_s"), "{message}");
    let message = refused("case = \"figure-3\"\n[run]\nsamples = 1\n");
    assert!(
        message.contains("samples = 1 is not between 2 and 10000000"),
        "{message}"
    );
    for key in ["max_transitions", "max_slides"] {
        let message = refused(&format!("case = \"figure-3\"\n[run]\n{key} = 0\n"));
        assert!(message.contains(&format!("{key} = 0")), "{message}");
    }
    let message = refused("case = \"figure-3\"\n[run]\nproof = \"endles\"\n");
    assert!(
        message.contains("there is no proof 'endles'") && message.contains("endless"),
        "{message}"
    );
    assert!(message.contains("hoop.toml:3:9"), "{message}");
    let message = refused("[hoop]\nmass_ratio = 1\n");
    assert!(message.contains("missing: offset, inertia"), "{message}");
}

#[test]
fn a_scenario_that_cannot_be_read_is_refused() {
    let folder = TempDir::new().unwrap();
    let nowhere = folder.path().join("nowhere.toml");
    let message = complaint(&["simulate", "--scenario", nowhere.to_str().unwrap()], 2);
    assert!(
        message.contains("cannot read the scenario") && message.contains("nowhere.toml"),
        "{message}"
    );
    complaint(
        &["simulate", "--scenario", folder.path().to_str().unwrap()],
        2,
    );
    let binary = folder.path().join("binary.toml");
    fs::write(&binary, [0xff, 0xfe, 0x00]).unwrap();
    complaint(&["classify", "--scenario", binary.to_str().unwrap()], 2);
    complaint(
        &[
            "simulate",
            "figure-3",
            "--scenario",
            &example("figure-3.toml"),
        ],
        2,
    );
}

/// What does not end, or keeps whoever opens it waiting, is refused before it is read.
#[test]
#[cfg(unix)]
fn a_scenario_that_never_ends_is_refused() {
    let (folder, path) = scenario("case = \"figure-3\"\n");
    let fifo = folder.path().join("pipe.toml");
    let made = std::process::Command::new("mkfifo").arg(&fifo).status();
    assert!(made.expect("mkfifo").success());
    for (path, reason) in [
        (PathBuf::from("/dev/zero"), "it is a pipe or a device"),
        (fifo, "it is a pipe or a device"),
        (folder.path().to_owned(), "it is a folder"),
    ] {
        let path = path.to_str().expect("a path in UTF-8");
        for command in ["simulate", "classify", "animate"] {
            let mut arguments = vec![command, "--scenario", path];
            if command == "animate" {
                arguments.extend(["--out", "film.gif"]);
            }
            let message = complaint(&arguments, 2);
            assert!(
                message.contains(&format!("cannot read the scenario {path}: {reason}")),
                "{message}"
            );
            assert!(message.contains("hint: --scenario takes the path of a TOML file"));
        }
    }
    // A huge file, which takes no room on the disk.
    let file = fs::OpenOptions::new().write(true).open(&path).unwrap();
    file.set_len(1 << 40).unwrap();
    let message = complaint(&["simulate", "--scenario", path.to_str().unwrap()], 2);
    assert!(
        message.contains("it has more than 1048576 bytes"),
        "{message}"
    );
}

#[test]
fn a_scenario_that_is_no_text_is_refused_with_its_place() {
    let (_folder, path) = scenario("");
    fs::write(&path, b"# \xff").unwrap();
    let message = complaint(&["simulate", "--scenario", path.to_str().unwrap()], 2);
    assert!(message.contains("byte 2 is not UTF-8"), "{message}");
}
