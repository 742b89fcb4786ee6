//! `littlewood map` into texts.

use std::fs;

use tempfile::TempDir;

use crate::support::csv::Csv;
use crate::support::{FIGURE_3_EVENTS, FIGURE_3_LANDING, assert_close, complaint, text};

/// The starts of Figure 3 and beside it.
const AXES: [&str; 4] = ["--x", "theta=0:pi:3", "--y", "theta_rate=1:2:2"];

fn written(name: &str) -> String {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join(name);
    let out = path.to_str().expect("UTF-8");
    text(&[&["map", "figure-3"], &AXES[..], &["--out", out]].concat());
    fs::read_to_string(&path).expect("a text")
}

#[test]
fn csv_has_a_row_for_each_start() {
    let text = written("plane.csv");
    let table = Csv::read(&text);
    assert_eq!(
        table.columns[..4],
        ["theta", "theta_rate", "outcome", "sequence"]
    );
    assert_eq!(table.rows.len(), 6);
    let cell = |row: usize, name: &str| table.rows[row][name].as_str();
    let real = |row: usize, name: &str| table.number(row, name);
    // θ = π/2, θ′ = 2 is the motion of Figure 3.
    assert_eq!(
        (real(3, "theta"), real(3, "theta_rate")),
        (std::f64::consts::FRAC_PI_2, 2.0)
    );
    assert_eq!(
        (cell(3, "outcome"), cell(3, "sequence")),
        ("landing", "-R+F")
    );
    assert_close(real(3, "lift_off_time"), FIGURE_3_EVENTS[2][0], 1e-12);
    assert_close(real(3, "end_time"), FIGURE_3_LANDING[0], 1e-12);
    // At the bottom the hoop rolls for ever, and never lifts off.
    assert_eq!(
        (cell(4, "outcome"), cell(4, "lift_off_time")),
        ("rolls_forever", "")
    );
}

#[test]
fn a_text_is_not_written_where_it_would_be_too_long() {
    let axes = ["--x", "theta=0:1:1025", "--y", "theta_rate=0:1:1024"];
    let message = complaint(
        &[&["map", "figure-3", "--out", "plane.csv"], &axes[..]].concat(),
        2,
    );
    assert!(
        message.contains("1049600 starts are too many for a text, which may have 1048576"),
        "{message}"
    );
    assert!(
        message.contains("hint: give fewer points, or a name that ends in .parquet"),
        "{message}"
    );
}
