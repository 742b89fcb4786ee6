//! Stores of another version of the format, or of sequences, are refused and left as they are.

use std::fs;
use std::path::Path;

use littlewood::tables::{PhaseSequence, SummaryColumn};
use littlewood_sweep::{
    ForeignVersion, Options, Report, STORE_FORMAT, StoreError, SweepError, Target, ZarrStore,
    sweep_grid,
};
use serde_json::{Value, json};

use crate::store::runs::{each_kind, interrupted, options, store_of};
use crate::support::table::write_table;
use crate::support::{assert_same_tree, mixed, tree, workers};

/// The version that a run is refused for.
fn refused(result: Result<Report, SweepError>) -> ForeignVersion {
    match result.unwrap_err() {
        SweepError::Store(error @ StoreError::OtherFormat { .. }) => {
            let text = error.to_string();
            let StoreError::OtherFormat { version, .. } = error else {
                unreachable!()
            };
            let (found, needed) = (version.found.to_string(), version.needed.to_string());
            assert!(text.contains(&found) && text.contains(&needed), "{text}");
            assert!(
                text.contains("left as it is") && text.contains("choose another name"),
                "{text}"
            );
            version
        }
        error => panic!("{error}"),
    }
}

/// Changes the attributes in which a store describes itself. Those of a group of Zarr have the run
/// as text.
fn edit(header: &Path, edit: impl Fn(&mut Value)) {
    let mut json: Value = serde_json::from_slice(&fs::read(header).unwrap()).unwrap();
    match json.get_mut("attributes") {
        Some(attributes) => {
            attributes["run"] = serde_json::from_str(attributes["run"].as_str().unwrap()).unwrap();
            edit(attributes);
            attributes["run"] = attributes["run"].to_string().into();
        }
        None => edit(&mut json),
    }
    fs::write(header, serde_json::to_vec_pretty(&json).unwrap()).unwrap();
}

fn remove(value: &mut Value, key: &str) {
    value.as_object_mut().unwrap().remove(key).unwrap();
}

/// A store has the columns of its version. Who adds one raises `STORE_FORMAT`, and writes both here.
#[test]
fn the_format_is_that_of_the_columns() {
    let columns = SummaryColumn::ALL.map(SummaryColumn::name).join(" ");
    let of_version_6 = "outcome sequence transitions painleve end_time end_theta end_theta_rate \
        end_slip end_x energy first_slip_time lift_off_time jump_length jump_height landings \
        impact_energy_lost settle_time half_swings";
    assert_eq!((STORE_FORMAT, columns.as_str()), (6, of_version_6));
}

#[test]
fn a_store_of_another_version_is_refused_with_both_versions() {
    type Edit = fn(&mut Value);
    let edits: [(Edit, u64, u32); 5] = [
        (|header| header["format"] = json!(1), 1, STORE_FORMAT),
        (|header| remove(header, "format"), 1, STORE_FORMAT),
        (
            |header| header["format"] = json!(STORE_FORMAT + 1),
            u64::from(STORE_FORMAT) + 1,
            STORE_FORMAT,
        ),
        (
            |header| remove(&mut header["run"], "format"),
            1,
            STORE_FORMAT,
        ),
        (
            |header| header["run"]["sequence_version"] = json!(1),
            1,
            PhaseSequence::VERSION,
        ),
    ];
    each_kind(|name, run, place| {
        let (whole, path) = (place.join("whole"), place.join("store"));
        run(&whole, &options(name)).unwrap();
        interrupted(name, run, &path, 20, false);
        let header = store_of(name, &path).join(if name == "zarr" {
            "zarr.json"
        } else {
            "_run.json"
        });
        let written = fs::read(&header).unwrap();
        for (change, found, needed) in edits {
            edit(&header, change);
            let before = tree(&path);
            for resume in [false, true] {
                let version = refused(run(
                    &path,
                    &Options {
                        resume,
                        ..options(name)
                    },
                ));
                assert_eq!((version.found, version.needed), (found, needed), "{name}");
                assert_eq!(version.program.as_deref(), Some(env!("CARGO_PKG_VERSION")));
            }
            if name == "zarr" {
                let error = ZarrStore::open(&path).unwrap_err();
                assert!(matches!(error, StoreError::OtherFormat { .. }), "{error}");
            }
            assert_eq!(tree(&path), before);
            fs::write(&header, &written).unwrap();
        }
        assert!(
            run(
                &path,
                &Options {
                    resume: true,
                    ..options(name)
                }
            )
            .unwrap()
            .complete
        );
        assert_same_tree(&whole, &path);
    });
}

/// Up to version 4 the run was an attribute with parts.
#[test]
fn a_zarr_store_of_version_4_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plane.zarr");
    let run = |options: &Options<'_>| {
        sweep_grid(
            &mixed(),
            littlewood::Limits::until(1.0),
            &[Target::Zarr(&path)],
            None,
            &workers(1),
            options,
        )
    };
    run(&options("zarr")).unwrap();
    let header = path.join("zarr.json");
    let mut json: Value = serde_json::from_slice(&fs::read(&header).unwrap()).unwrap();
    let attributes = &mut json["attributes"];
    attributes["format"] = json!(4);
    attributes["run"] = serde_json::from_str(attributes["run"].as_str().unwrap()).unwrap();
    attributes["run"]["format"] = json!(4);
    fs::write(&header, serde_json::to_vec_pretty(&json).unwrap()).unwrap();
    let before = tree(&path);
    let version = refused(run(&Options {
        resume: true,
        ..options("zarr")
    }));
    assert_eq!((version.found, version.needed), (4, STORE_FORMAT));
    assert_eq!(tree(&path), before);
}

#[test]
fn a_file_of_the_first_version_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("table.parquet");
    // What the footer of a file of version 1 said of its run: no format.
    let run = json!({ "version": "0.1.0", "points": "grid" }).to_string();
    write_table(&path, "littlewood_run", run);
    let before = fs::read(&path).unwrap();
    let resume = Options {
        resume: true,
        ..options("grid file")
    };
    let version = refused(sweep_grid(
        &mixed(),
        littlewood::Limits::until(1.0),
        &[Target::Parquet(&path)],
        None,
        &workers(1),
        &resume,
    ));
    assert_eq!((version.found, version.needed), (1, STORE_FORMAT));
    assert_eq!(fs::read(&path).unwrap(), before);
}
