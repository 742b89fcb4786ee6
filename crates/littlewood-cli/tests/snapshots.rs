//! What the program prints for people, as transcripts: help, errors, tables.
//!
//! ```sh
//! LITTLEWOOD_WRITE=1 cargo test -p littlewood-cli --all-features snapshots::
//! ```
//! writes them anew. Numbers are tested elsewhere; here a change of words or of layout has to be
//! seen and meant.

use std::fs;
use std::path::PathBuf;

use crate::support::littlewood;

/// Each command with all its flags.
const HELP: [&str; 11] = [
    "--help",
    "simulate --help",
    "classify --help",
    "threshold --help",
    "cases --help",
    "map --help",
    "sweep --help",
    "figures --help",
    "poster --help",
    "animate --help",
    "lab --help",
];

/// Bad input of each kind.
const ERRORS: [&str; 23] = [
    "simulat figure-3",
    "simulate",
    "simulate figure-33",
    "simulate figure-3 --mu",
    "simulate figure-3 --mu-s",
    "simulate figure-3 --mu-s few",
    "simulate figure-3 --mu-s -1",
    "simulate figure-3 --mu-k 0.6",
    "simulate figure-3 --offset 1.5",
    "simulate figure-3 --theta inf",
    "simulate figure-3 --until -1",
    "simulate figure-3 --samples 1",
    "simulate figure-3 --format xml",
    "simulate figure-3 --restitution 1.5",
    "simulate figure-3 --disc-mass-kg 1",
    "simulate figure-7 --restitution 0.5",
    "simulate --mass-ratio 1",
    "simulate --scenario missing.toml",
    "figures figure-9 --out missing",
    "map figure-3 --x theta=0:1:10 --y theta=0:1:10 --out map.png",
    "map figure-3 --x theta=0:1 --y theta_rate=0:1:10 --out map.png",
    "sweep figure-3 --axis colour=0:1:10 --out out.zarr",
    "atlas figure-3",
];

/// The tables that people read.
const TABLES: [&str; 10] = [
    "cases",
    "classify figure-3",
    "classify figure-7",
    "threshold figure-3 --of theta_rate",
    "simulate figure-3",
    "simulate figure-3 --digits",
    "simulate figure-3 --restitution 0.5",
    "simulate figure-7",
    "simulate jam",
    "simulate --si --disc-mass-kg 0.4 --particle-mass-kg 0.14 --radius-m 0.45 --offset-m 0.45 --inertia-kg-m2 0.081 \
     --mu-s 0.5 --mu-k 0.4 --theta 1.2 --theta-rate-rad-per-s 6",
];

/// What these commands print, each after the command itself.
fn transcript(commands: &[&str]) -> String {
    let mut text = String::new();
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().collect();
        let run = littlewood()
            .args(&words)
            .env("COLUMNS", "100")
            .output()
            .expect("the program runs");
        text.push_str(&format!("$ littlewood {}\n", words.join(" ")));
        for stream in [run.stdout, run.stderr] {
            text.push_str(&String::from_utf8(stream).expect("UTF-8"));
        }
        let code = run.status.code().expect("it ends by itself");
        text.push_str(&if code == 0 {
            "\n".to_owned()
        } else {
            format!("exit code {code}\n\n")
        });
    }
    // What differs between systems: the ending of the program, and the system's own words.
    text.replace("littlewood.exe", "littlewood").replace(
        "The system cannot find the file specified. (os error 2)",
        "No such file or directory (os error 2)",
    )
}

#[track_caller]
fn compare(name: &str, commands: &[&str]) {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "tests", "snapshots", name]
        .iter()
        .collect();
    let found = transcript(commands);
    if std::env::var_os("LITTLEWOOD_WRITE").is_some() {
        fs::write(&path, &found).expect("the folder of snapshots");
    }
    let kept = fs::read_to_string(&path).expect("a snapshot");
    for (line, (kept, found)) in (1..).zip(kept.lines().zip(found.lines())) {
        assert_eq!(
            found, kept,
            "{name}, line {line}; is it meant to change? See the head of this file"
        );
    }
    assert_eq!(found, kept, "{name} has another length");
}

#[test]
fn help() {
    compare("help.txt", &HELP);
}

#[test]
fn errors() {
    compare("errors.txt", &ERRORS);
}

#[test]
fn tables() {
    compare("tables.txt", &TABLES);
}
