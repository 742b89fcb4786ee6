//! Lists of starts from CSV.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

use crate::support;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::table::Table;
use crate::support::{figure_2, workers};
use littlewood::Limits;
use littlewood::tables::{Quantity, Setup};
use littlewood_sweep::{ListError, Options, StartList, SweepError, Target, sweep_list};
use parquet::record::Field;

fn csv(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("starts.csv");
    fs::write(&path, text).unwrap();
    path
}

fn message(text: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = csv(folder.path(), text);
    let message = StartList::open(&path, figure_2()).unwrap_err().to_string();
    message.replace(&format!("{}", path.display()), "starts.csv")
}

#[test]
fn a_csv_list_is_read_and_the_rest_comes_from_the_base() {
    let folder = tempfile::tempdir().unwrap();
    let path = csv(
        folder.path(),
        "\u{feff}theta, \"mu_k\"\r\n0.5,0.25\r\n\r\n-1e-3 , \"0\"",
    );
    let list = StartList::open(&path, figure_2()).unwrap();
    assert_eq!(
        (list.rows(), list.columns()),
        (2, &[Quantity::Theta, Quantity::MuK][..])
    );
    let points: Vec<(u64, Setup)> = list.points().unwrap().map(Result::unwrap).collect();
    let mut first = figure_2();
    (first.start.theta, first.hoop.mu_k) = (0.5, 0.25);
    let mut second = figure_2();
    (second.start.theta, second.hoop.mu_k) = (-1e-3, 0.0);
    assert_eq!(
        points.iter().map(|(_, point)| *point).collect::<Vec<_>>(),
        [first, second]
    );
    assert_eq!((points[0].0, points[1].0), (2, 4));
}

#[test]
fn mistakes_in_csv_are_named_with_line_and_column() {
    assert_eq!(
        message("theta,slip\n1,0\n2,zero\n"),
        "starts.csv, line 3, column slip: \"zero\" is not a finite number"
    );
    assert_eq!(
        message("theta\n1\nNaN\n"),
        "starts.csv, line 3, column theta: \"NaN\" is not a finite number"
    );
    assert_eq!(
        message("theta\n1\n\"\"\n"),
        "starts.csv, line 3, column theta: \"\" is not a finite number"
    );
    assert_eq!(
        message("theta,offset\n1,0.5\n1,1.5\n"),
        "starts.csv, line 3, column offset: offset = 1.5 must not exceed 1"
    );
    assert_eq!(
        message("theta,theta_rate\n1,2\n1\n"),
        "starts.csv, line 3: 1 cells where the header has 2"
    );
    assert_eq!(
        message("theta,omega\n1,2\n"),
        "starts.csv: there is no quantity \"omega\"; columns are theta, theta_rate, slip, gap_rate, mass_ratio, \
         offset, inertia, mu_s, mu_k, rolling_resistance, slope, restitution, x, time"
    );
    assert_eq!(
        message("theta\r\n\r\n1\r\nx\r\n"),
        "starts.csv, line 4, column theta: \"x\" is not a finite number"
    );
    assert!(message(&"1".repeat(100_000)).contains("line 1: longer than"));
    assert_eq!(
        message("theta,theta\n1,2\n"),
        "starts.csv: column theta is there twice"
    );
    assert_eq!(message("theta\n"), "starts.csv: no starts in it");
    assert_eq!(message(""), "starts.csv: no starts in it");
    let missing = StartList::open(Path::new("/nowhere/starts.csv"), figure_2()).unwrap_err();
    assert!(matches!(missing, ListError::Unreadable { .. }), "{missing}");
    for name in ["starts.txt", "starts.parquet", "csv"] {
        let other = StartList::open(Path::new(name), figure_2()).unwrap_err();
        assert!(matches!(other, ListError::UnknownFormat { .. }), "{other}");
    }
}

#[test]
fn a_fixed_value_without_meaning_is_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut base = figure_2();
    base.start.slip = f64::NAN;
    let path = csv(folder.path(), "theta\n1\n");
    let error = StartList::open(&path, base).unwrap_err();
    assert!(matches!(error, ListError::Fixed { .. }), "{error}");
}

#[test]
fn the_table_has_the_starts_and_their_motions_in_order() {
    let folder = tempfile::tempdir().unwrap();
    // Figure 3; footnote 3 of the paper, which lifts off at once; parameters that contradict each
    // other.
    let path = csv(
        folder.path(),
        "theta,theta_rate,mu_k\n1.5707963267948966,2,0.4\n0,4,0.4\n0,1,0.6\n3.1,0.1,0.5\n",
    );
    let list = StartList::open(&path, figure_2()).unwrap();
    let out = folder.path().join("out.parquet");
    let options = Options {
        chunk_points: 3,
        ..Options::default()
    };
    sweep_list(
        &list,
        Limits::default(),
        &[Target::ParquetFolder(&out)],
        &workers(1),
        &options,
    )
    .unwrap();
    let tables =
        ["part-00000.parquet", "part-00001.parquet"].map(|part| Table::read(&out.join(part)));
    for table in &tables {
        assert_eq!(table.groups, 1);
        let run: serde_json::Value = serde_json::from_str(table.entry("littlewood_run")).unwrap();
        assert_eq!(run["base"]["mu_s"], 0.5);
    }
    let rows: Vec<(f64, String, String)> = tables
        .iter()
        .flat_map(|table| {
            let words = table
                .words("outcome")
                .into_iter()
                .zip(table.words("sequence"));
            let rows = table.reals("theta").into_iter().zip(words);
            rows.map(|(theta, (outcome, sequence))| (theta, outcome, sequence))
        })
        .collect();
    let told: Vec<(f64, &str, &str)> = rows
        .iter()
        .map(|(theta, outcome, sequence)| (*theta, outcome.as_str(), sequence.as_str()))
        .collect();
    assert_eq!(
        told,
        [
            (std::f64::consts::FRAC_PI_2, "landing", "-R+F"),
            (0.0, "landing", "F"),
            (0.0, "invalid", ""),
            (3.1, "rolls_forever", "R"),
        ]
    );
    assert!((tables[0].reals("lift_off_time")[0] - 1.518_670_213_819_437).abs() < 1e-13);
    // - is 2, R is 1, + is 3, F is 7: four bits each, the first lowest.
    assert_eq!(tables[0].column("sequence_code")[0], &Field::ULong(0x7312));
    assert_eq!(tables[1].column("lift_off_time")[0], &Field::Null);
}

#[test]
fn a_file_that_changes_after_it_was_opened_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = csv(folder.path(), "theta\n1\n2\n3\n");
    let list = StartList::open(&path, figure_2()).unwrap();
    fs::write(&path, "theta\n1\n").unwrap();
    let out = folder.path().join("out.parquet");
    let error = sweep_list(
        &list,
        Limits::until(1.0),
        &[Target::Parquet(&out)],
        &workers(1),
        &Options::default(),
    )
    .unwrap_err();
    assert!(
        matches!(error, SweepError::List(ListError::Changed { .. })),
        "{error}"
    );
}

#[test]
fn one_file_has_the_rows_of_all_chunks_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let rows: Vec<String> = (0..95)
        .map(|i| format!("{},{}", 0.1 * f64::from(i), i % 7))
        .collect();
    let path = csv(
        folder.path(),
        &format!("theta,theta_rate\n{}\n", rows.join("\n")),
    );
    let list = StartList::open(&path, figure_2()).unwrap();
    let out = folder.path().join("out.parquet");
    let options = Options {
        chunk_points: 20,
        ..Options::default()
    };
    sweep_list(
        &list,
        Limits::until(5.0),
        &[Target::Parquet(&out)],
        &workers(2),
        &options,
    )
    .unwrap();
    let whole = Table::read(&out);
    let expected: Vec<f64> = (0..95)
        .map(|i| format!("{}", 0.1 * f64::from(i)).parse().unwrap())
        .collect();
    assert_eq!(whole.reals("theta"), expected);
    assert_eq!(whole.groups, 5);
    assert!(!support::parts(&out).exists());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn a_list_may_say_where_and_when_its_starts_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = csv(
        folder.path(),
        "time,theta,theta_rate,x\n0,1.5707963267948966,2,0\n3,1.5707963267948966,2,-5\n",
    );
    let list = StartList::open(&path, figure_2()).unwrap();
    let out = folder.path().join("out.parquet");
    sweep_list(
        &list,
        Limits::until(50.0),
        &[Target::Parquet(&out)],
        &workers(1),
        &Options::default(),
    )
    .unwrap();
    let whole = Table::read(&out);
    let column = |name: &str| whole.reals(name);
    assert_eq!(
        (column("time"), column("x")),
        (vec![0.0, 3.0], vec![0.0, -5.0])
    );
    let (lift_off, end) = (column("lift_off_time"), column("end_x"));
    assert!(
        (lift_off[1] - lift_off[0] - 3.0).abs() < 1e-13 && (end[1] - end[0] + 5.0).abs() < 1e-13
    );
    let far = message("theta,x\n1,2e9\n");
    assert!(
        far.starts_with("starts.csv, line 2, column x: x = 2000000000") && far.contains("1e9"),
        "{far}"
    );
    // It begins after its end.
    let path = csv(folder.path(), "theta,time\n1,0\n1,60\n");
    let list = StartList::open(&path, figure_2()).unwrap();
    let out = folder.path().join("late.parquet");
    let error = sweep_list(
        &list,
        Limits::until(50.0),
        &[Target::Parquet(&out)],
        &workers(1),
        &Options::default(),
    )
    .unwrap_err();
    assert!(
        matches!(
            error,
            SweepError::List(ListError::BadValue {
                line: 3,
                column: Quantity::Time,
                ..
            })
        ),
        "{error}"
    );
}

#[test]
fn a_list_does_not_fit_a_grid() {
    let folder = tempfile::tempdir().unwrap();
    let list = StartList::open(&csv(folder.path(), "theta\n1\n"), figure_2()).unwrap();
    let out = folder.path().join("out.zarr");
    let error = sweep_list(
        &list,
        Limits::default(),
        &[Target::Zarr(&out)],
        &workers(1),
        &Options::default(),
    )
    .unwrap_err();
    assert!(matches!(error, SweepError::ListAsZarr { .. }), "{error}");
    assert!(!out.exists());
}

/// A pipe would wait for who writes into it, and a device need not end.
#[test]
#[cfg(unix)]
fn a_list_is_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe.csv");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    let device = folder.path().join("device.csv");
    std::os::unix::fs::symlink("/dev/zero", &device).unwrap();
    for path in [pipe, device] {
        let error = StartList::open(&path, figure_2()).unwrap_err();
        assert!(matches!(error, ListError::Unreadable { .. }), "{error}");
        assert!(
            error
                .to_string()
                .ends_with("it is a pipe or a device, not a file"),
            "{error}"
        );
    }
}
