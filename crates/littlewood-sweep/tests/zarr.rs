//! Zarr stores, read by the library and not by the code that has written them.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

use std::fs;

use crate::support::zarr::Array;
use crate::support::{map, mixed, reals, workers};
use littlewood::tables::{PhaseSequence, SummaryColumn};
use littlewood::{Limits, Summary};
use littlewood_sweep::{ColumnValues, Options, STORE_FORMAT, Target, sweep_grid};
use serde_json::Value;

#[test]
fn the_arrays_hold_what_was_computed_with_names_and_units() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.zarr");
    let (grid, limits) = (mixed(), Limits::until(20.0));
    // Chunks that do not divide the grid, along an axis that is not the slowest.
    let options = Options {
        chunk_points: 100,
        ..Options::default()
    };
    sweep_grid(
        &grid,
        limits,
        &[Target::Zarr(&path)],
        None,
        &workers(2),
        &options,
    )
    .unwrap();
    let columns = workers(1)
        .compute(grid.points(0..grid.len()), limits)
        .unwrap();

    let open = |name: &str| Array::open(&path, name);
    let names = ["mu_s", "theta", "mu_k", "theta_rate"];
    for (i, name) in names.into_iter().enumerate() {
        let array = open(name);
        assert_eq!(array.reals(), grid.axes()[i].values().collect::<Vec<_>>());
        assert_eq!(array.dimensions(), [name]);
    }
    let lift_off = open("lift_off_time");
    assert_eq!(lift_off.shape(), [4, 7, 3, 11]);
    assert_eq!(lift_off.dimensions(), names);
    assert_eq!(lift_off.metadata["fill_value"], "NaN");
    assert_eq!(lift_off.attributes()["units"], "1");
    assert_eq!(lift_off.attributes()["scale"], "sqrt(R/g)");
    assert_eq!(open("theta").attributes()["units"], "rad");
    let expected = reals(&columns, SummaryColumn::LiftOffTime);
    assert_eq!(
        lift_off
            .reals()
            .iter()
            .map(|x| x.to_bits())
            .collect::<Vec<_>>(),
        expected.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    );
    let sequence = open("sequence");
    let values = sequence
        .values("uint64")
        .into_iter()
        .map(u64::from_le_bytes)
        .collect();
    assert_eq!(
        &ColumnValues::U64(values),
        columns.column(SummaryColumn::Sequence)
    );
    assert_eq!(sequence.attributes()["version"], PhaseSequence::VERSION);
    let legend = sequence.attributes()["legend"].as_str().unwrap();
    let legend: Value = serde_json::from_str(legend).unwrap();
    assert_eq!(legend["7"], "F: flight");
    let outcome = open("outcome");
    let values = outcome
        .values("uint8")
        .into_iter()
        .map(u8::from_le_bytes)
        .collect();
    assert_eq!(
        &ColumnValues::U8(values),
        columns.column(SummaryColumn::Outcome)
    );
    assert_eq!(
        outcome.metadata["fill_value"],
        Summary::NOT_COMPUTED.outcome.code()
    );
    let flags = outcome.attributes()["flag_values"]
        .as_array()
        .unwrap()
        .len();
    assert_eq!(
        outcome.attributes()["flag_meanings"]
            .as_str()
            .unwrap()
            .split(' ')
            .count(),
        flags
    );
}

#[test]
fn the_group_says_what_was_run_and_holds_the_metadata_of_its_arrays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.zarr");
    sweep_grid(
        &map(5),
        Limits::until(1.0),
        &[Target::Zarr(&path)],
        None,
        &workers(1),
        &Options::default(),
    )
    .unwrap();
    let text = fs::read_to_string(path.join("zarr.json")).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        (&json["zarr_format"], &json["node_type"]),
        (&3.into(), &"group".into())
    );
    let attributes = &json["attributes"];
    assert_eq!(attributes["status"], "complete");
    assert_eq!(attributes["Conventions"], "CF-1.11");
    let run: Value = serde_json::from_str(attributes["run"].as_str().unwrap()).unwrap();
    assert_eq!(
        (&attributes["format"], &run["format"]),
        (&STORE_FORMAT.into(), &STORE_FORMAT.into())
    );
    assert_eq!(run["sequence_version"], PhaseSequence::VERSION);
    assert_eq!(run["fixed"]["mu_k"], 0.4);
    assert_eq!(run["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(run["axes"][1]["count"], 5);
    let consolidated = json["consolidated_metadata"]["metadata"]
        .as_object()
        .unwrap();
    assert_eq!(consolidated.len(), 2 + SummaryColumn::ALL.len());
    for (name, metadata) in consolidated {
        let own: Value =
            serde_json::from_slice(&fs::read(path.join(name).join("zarr.json")).unwrap()).unwrap();
        assert_eq!(&own, metadata, "{name}");
        assert!(own["dimension_names"].is_array(), "{name}");
    }
}
