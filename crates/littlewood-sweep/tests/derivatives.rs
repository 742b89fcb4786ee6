//! Derivatives as columns of a sweep.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests stand outside of test functions"
)]

use std::fs;

use crate::support::zarr::Array;
use crate::support::{map, workers};
use littlewood::tables::DerivativeColumn;
use littlewood::{Hoop, Limits};
use littlewood_sweep::{Grid, Options, SweepError, Target, ZarrStore, sweep_grid};

const NAMES: [&str; 4] = [
    "jump_length_by_mu_k",
    "end_x_by_theta_rate",
    "lift_off_time_by_offset",
    "energy_by_slope",
];

fn columns() -> Vec<DerivativeColumn> {
    NAMES.iter().map(|name| name.parse().unwrap()).collect()
}

fn grid() -> Grid {
    map(7).with_derivatives(columns())
}

/// As bits, in which what has no derivative is equal to itself.
fn bits(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
    values.into_iter().map(f64::to_bits).collect()
}

#[test]
fn derivatives_are_those_of_the_motions_whatever_is_stored_and_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let [zarr, table] = ["map.zarr", "map.parquet"].map(|name| folder.path().join(name));
    let (grid, limits) = (grid(), Limits::until(30.0));
    let targets = [Target::Zarr(&zarr), Target::Parquet(&table)];
    let options = Options {
        chunk_points: 10,
        ..Options::default()
    };
    sweep_grid(&grid, limits, &targets, None, &workers(2), &options).unwrap();
    let motions: Vec<Vec<f64>> = grid
        .points(0..grid.len())
        .map(|point| {
            let motion = Hoop::new(point.hoop)
                .unwrap()
                .simulate(point.start, limits)
                .unwrap();
            motion.summary_derivatives(&columns()).unwrap()
        })
        .collect();
    for (place, name) in NAMES.into_iter().enumerate() {
        let expected = bits(motions.iter().map(|row| row[place]));
        assert!(
            motions
                .iter()
                .any(|row| row[place].is_finite() && row[place] != 0.0),
            "{name}"
        );
        assert_eq!(bits(Array::open(&zarr, name).reals()), expected, "{name}");
    }
    // What is read back is what was written, by this library, too.
    let store = ZarrStore::open(&zarr).unwrap();
    assert_eq!(store.grid(), &grid);
    let first = store.columns(0).unwrap().unwrap();
    let chunk = store.chunks().chunk(0);
    let of_chunk = |place: usize| {
        let points = chunk.points(&grid).map(|point| {
            let motion = Hoop::new(point.hoop)
                .unwrap()
                .simulate(point.start, limits)
                .unwrap();
            motion.summary_derivatives(&columns()).unwrap()[place]
        });
        bits(points)
    };
    for (place, column) in columns().into_iter().enumerate() {
        assert_eq!(
            bits(first.derivative(column).unwrap().iter().copied()),
            of_chunk(place)
        );
    }
    let again = Options {
        resume: true,
        ..options
    };
    let mut seen = 0;
    let mut view =
        |_: &littlewood_sweep::Chunk, columns: &littlewood_sweep::Columns| seen += columns.len();
    let one = [Target::Parquet(&table)];
    let report = sweep_grid(&grid, limits, &one, Some(&mut view), &workers(1), &again).unwrap();
    assert_eq!((report.computed, seen), (0, 49));
}

#[test]
fn a_store_with_other_derivatives_is_not_resumed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.zarr");
    let limits = Limits::until(5.0);
    sweep_grid(
        &grid(),
        limits,
        &[Target::Zarr(&path)],
        None,
        &workers(1),
        &Options::default(),
    )
    .unwrap();
    let before = fs::read(path.join("zarr.json")).unwrap();
    let resume = Options {
        resume: true,
        ..Options::default()
    };
    let other = sweep_grid(
        &map(7),
        limits,
        &[Target::Zarr(&path)],
        None,
        &workers(1),
        &resume,
    );
    let message = other
        .map_err(|error: SweepError| error.to_string())
        .unwrap_err();
    assert!(message.contains("derivatives"), "{message}");
    assert_eq!(fs::read(path.join("zarr.json")).unwrap(), before);
}
