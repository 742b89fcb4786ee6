//! `littlewood map` and `sweep` of hoops with restitution.

#![allow(
    clippy::excessive_precision,
    reason = "the reference has more digits than a double"
)]

use std::fs;

use crate::support::table::Table;
use crate::support::{FIGURE_3_LANDING, assert_close, complaint, json, number, text};
use tempfile::TempDir;

/// Energy lost in the first landing of Figure 3, e = 0 and e = 0.5, from the notes.
const LOST: [f64; 2] = [4.275_729_468_652_908_31, 3.362_443_419_227_28];

fn folder() -> (TempDir, impl Fn(&str) -> String) {
    let folder = TempDir::new().expect("a temporary folder");
    let root = folder.path().to_owned();
    (folder, move |name: &str| {
        root.join(name).to_string_lossy().into_owned()
    })
}

#[test]
fn restitution_is_an_axis() {
    let (_folder, path) = folder();
    let out = path("grid.parquet");
    text(&[
        "sweep",
        "figure-3",
        "--axis",
        "restitution=0:0.5:2",
        "--until",
        "4",
        "--out",
        &out,
    ]);
    let table = Table::read(&out);
    assert_eq!(table.reals("restitution"), [0.0, 0.5]);
    assert_eq!(table.counts("landings"), [1, 1]);
    for (found, expected) in table.reals("impact_energy_lost").into_iter().zip(LOST) {
        assert_close(found, expected, 1e-12);
    }
    // Without a rebound the rim stays at the plane from the landing on; with one it is in the air
    // at τ = 4.
    let since = table.reals("settle_time");
    assert_close(since[0], FIGURE_3_LANDING[0], 1e-12);
    assert!(since[1].is_nan());
}

#[test]
fn the_law_is_that_of_the_whole_sweep() {
    let (_folder, path) = folder();
    let lost = ["energetic", "poisson", "newton"].map(|law| {
        let out = path(&format!("{law}.parquet"));
        let flags = [
            "sweep",
            "figure-3",
            "--axis",
            "restitution=0.5:1:2",
            "--until",
            "4",
            "--out",
            &out,
        ];
        text(&[&flags[..], &["--restitution-law", law]].concat());
        let lost = Table::read(&out).reals("impact_energy_lost")[0];
        let flags = [
            "simulate",
            "figure-3",
            "--restitution",
            "0.5",
            "--until",
            "4",
            "--restitution-law",
            law,
        ];
        assert_close(lost, number(&json(&flags)["impact_energy_lost"]), 1e-12);
        lost
    });
    assert_close(lost[0], LOST[1], 1e-12);
    assert!(lost[2] > lost[0], "the law of velocities leaves less here");
}

#[test]
fn a_list_may_have_columns_for_restitution_and_the_rate_of_the_gap() {
    let (_folder, path) = folder();
    let (starts, out) = (path("starts.csv"), path("motions.parquet"));
    let quarter_turn = "1.5707963267948966";
    fs::write(
        &starts,
        format!("theta,theta_rate,gap_rate,restitution\n{quarter_turn},2,0,0.5\n{quarter_turn},2,0.25,0.5\n"),
    )
    .expect("written");
    let found = json(&["sweep", "figure-3", "--starts", &starts, "--out", &out]);
    assert_eq!(found["counts"]["lifts_off_later"], 1);
    assert_eq!(found["counts"]["leaves_at_once"], 1);
    let table = Table::read(&out);
    assert_close(
        table.reals("settle_time")[0],
        6.924_682_083_018_513_65,
        1e-12,
    );
    let thrown = json(&[
        "simulate",
        "figure-3",
        "--restitution",
        "0.5",
        "--gap-rate",
        "0.25",
    ]);
    assert_close(
        table.reals("impact_energy_lost")[1],
        number(&thrown["impact_energy_lost"]),
        1e-13,
    );
    for (cell, said) in [
        ("1.5", "must not exceed 1"),
        ("nan", "not a finite number"),
        ("", "restitution"),
    ] {
        let text = format!("theta,theta_rate,restitution\n0,1,0\n0,2,{cell}\n");
        fs::write(&starts, text).expect("written");
        let message = complaint(
            &[
                "sweep",
                "figure-3",
                "--starts",
                &starts,
                "--out",
                &path("other.parquet"),
            ],
            2,
        );
        assert!(
            message.contains("line 3") && message.contains(said) && message.contains("hint:"),
            "{message}"
        );
    }
}

#[test]
fn the_rate_of_the_gap_is_an_axis_also_in_metres_per_second() {
    let (_folder, path) = folder();
    let run = |name: &str, axis: &str, more: &[&str]| {
        let out = path(name);
        let flags = [
            "sweep",
            "figure-3",
            "--restitution",
            "0.5",
            "--axis",
            axis,
            "--out",
            &out,
        ];
        text(&[&flags[..], more].concat());
        Table::read(&out).reals("settle_time")
    };
    let plain = run("plain.parquet", "gap_rate=0:1:3", &[]);
    assert_close(plain[0], 6.924_682_083_018_513_65, 1e-12);
    // The unit of velocity is √(gR) = 2 m/s.
    let size = [
        "--particle-mass-kg",
        "1",
        "--radius-m",
        "0.5",
        "--gravity-m-per-s2",
        "8",
    ];
    assert_eq!(run("si.parquet", "gap_rate_m_per_s=0:2:3", &size), plain);
}

#[test]
fn axes_and_laws_that_have_no_meaning_are_refused() {
    let (folder, path) = folder();
    let out = path("plane.zarr");
    let refused = |flags: &[&str]| {
        let message = complaint(
            &[&["map"], flags, &["--y", "theta=0:1:3", "--out", &out]].concat(),
            2,
        );
        assert!(message.contains("hint:"), "{message}");
        message
    };
    assert!(
        refused(&["figure-3", "--x", "restitution=0:1.5:3"])
            .contains("restitution = 1.5 must not exceed 1")
    );
    assert!(refused(&["figure-3", "--x", "gap_rate=-1:1:3"]).contains("gap_rate = -1"));
    assert!(refused(&["figure-7", "--x", "restitution=0:1:3"]).contains("of a massless hoop"));
    let law = [
        "figure-3",
        "--x",
        "slip=0:1:3",
        "--restitution-law",
        "newton",
    ];
    assert!(refused(&law).contains("restitution_law = newton without restitution"));
    assert!(
        fs::read_dir(folder.path())
            .expect("a folder")
            .next()
            .is_none()
    );
}
