//! Stores are the same whether a run was interrupted or not.

use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};

use littlewood::tables::Class;
use littlewood_sweep::{
    Chunk, Columns, Options, Progress, StoreError, SweepError, Tally, Target, sweep_grid,
};

use crate::store::runs::{each_kind, interrupted, limits, options};
use crate::support::{SmallDisk, assert_same_tree, mixed, parts, tree, workers};

#[test]
fn a_run_that_is_stopped_and_resumed_leaves_the_same_bytes() {
    each_kind(|name, run, place| {
        let whole = place.join("whole");
        let report = run(&whole, &options(name)).unwrap();
        assert!(
            report.complete && report.computed == report.points,
            "{name}: {report:?}"
        );
        for stop in [0, 1, report.points / 3, 2 * report.points / 3] {
            let path = place.join(format!("stopped-{stop}"));
            let first = interrupted(name, run, &path, stop, false);
            assert!(
                !first.complete && first.computed < first.points,
                "{name}: {first:?}"
            );
            // Stopped a second time, and then left to run.
            let second = interrupted(name, run, &path, first.computed + 1, true);
            assert_eq!(second.reused, first.computed, "{name}");
            let last = run(
                &path,
                &Options {
                    resume: true,
                    ..options(name)
                },
            )
            .unwrap();
            assert!(last.complete, "{name}: {last:?}");
            assert_eq!(
                (last.reused + last.computed, last.damaged_chunks),
                (report.points, 0),
                "{name}"
            );
            assert_same_tree(&whole, &path);
        }
    });
}

#[test]
fn a_kill_at_any_byte_is_survived() {
    each_kind(|name, run, place| {
        let whole = place.join("whole");
        run(&whole, &options(name)).unwrap();
        let bytes: usize = tree(&whole).values().map(Vec::len).sum();
        for i in 0..12 {
            let path = place.join(format!("killed-{i}"));
            let disk = SmallDisk::new(bytes * i / 12);
            let error = run(
                &path,
                &Options {
                    disk: &disk,
                    ..options(name)
                },
            )
            .unwrap_err();
            assert!(
                matches!(error, SweepError::Store(StoreError::Unwritable { .. })),
                "{name}: {error}"
            );
            // What is said to be there is there.
            let SweepError::Store(StoreError::Unwritable { finished, .. }) = error else {
                unreachable!()
            };
            assert_eq!(
                error.to_string().contains("stay"),
                finished > 0,
                "{name}: {error}"
            );
            let report = run(
                &path,
                &Options {
                    resume: true,
                    ..options(name)
                },
            )
            .unwrap();
            assert!(report.complete, "{name}");
            assert_eq!(report.reused, finished, "{name}");
            assert_same_tree(&whole, &path);
        }
    });
}

#[test]
fn the_number_of_threads_does_not_change_a_byte() {
    let folder = tempfile::tempdir().unwrap();
    for threads in [1, 3] {
        let path = folder.path().join(threads.to_string());
        sweep_grid(
            &mixed(),
            limits(),
            &[Target::Zarr(&path)],
            None,
            &workers(threads),
            &options("zarr"),
        )
        .unwrap();
    }
    assert_same_tree(&folder.path().join("1"), &folder.path().join("3"));
}

#[test]
fn one_run_fills_several_targets_and_shows_every_chunk() {
    let folder = tempfile::tempdir().unwrap();
    let (zarr, file) = (
        folder.path().join("a.zarr"),
        folder.path().join("a.parquet"),
    );
    let (alone_zarr, alone_file) = (
        folder.path().join("b.zarr"),
        folder.path().join("b.parquet"),
    );
    sweep_grid(
        &mixed(),
        limits(),
        &[Target::Zarr(&alone_zarr)],
        None,
        &workers(2),
        &options("zarr"),
    )
    .unwrap();
    let alone = sweep_grid(
        &mixed(),
        limits(),
        &[Target::Parquet(&alone_file)],
        None,
        &workers(2),
        &options("grid file"),
    )
    .unwrap();
    let targets = [Target::Zarr(&zarr), Target::Parquet(&file)];
    let run = |options: &Options<'_>| {
        let mut seen = Tally::default();
        let mut view = |chunk: &Chunk, columns: &Columns| {
            assert_eq!(chunk.len(), columns.len());
            seen += Tally::of_columns(columns);
        };
        let report = sweep_grid(
            &mixed(),
            limits(),
            &targets,
            Some(&mut view),
            &workers(2),
            options,
        )
        .unwrap();
        (report, seen)
    };
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| cancel.store(progress.done >= 300, Ordering::Relaxed);
    let (report, seen) = run(&Options {
        cancel: Some(&cancel),
        progress: Some(&watch),
        ..options("zarr")
    });
    assert!(!report.complete && report.computed > 0);
    assert_eq!(
        report.tally.of(Class::NotComputed),
        report.points - report.computed
    );
    assert_eq!(seen.total(), report.computed);
    // Only one of them has lost a chunk: it is computed for that one.
    let lost = tree(&zarr)
        .into_keys()
        .find(|path| path.starts_with("energy/c"))
        .unwrap();
    fs::remove_file(zarr.join(lost)).unwrap();
    let resume = Options {
        resume: true,
        ..options("zarr")
    };
    let (report, seen) = run(&resume);
    assert!(
        report.complete && report.damaged_chunks == 1 && report.reused > 0,
        "{report:?}"
    );
    assert_eq!((seen, report.tally), (alone.tally, alone.tally));
    assert_same_tree(&alone_zarr, &zarr);
    assert_same_tree(&alone_file, &file);
    // All is there, and is shown and counted all the same.
    let (report, seen) = run(&resume);
    assert_eq!(
        (report.computed, seen, report.tally),
        (0, alone.tally, alone.tally)
    );
}

#[test]
fn what_others_put_among_the_parts_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.parquet");
    let run = |resume| {
        sweep_grid(
            &mixed(),
            limits(),
            &[Target::Parquet(&path)],
            None,
            &workers(1),
            &Options {
                resume,
                ..options("grid file")
            },
        )
    };
    interrupted(
        "grid file",
        &|_, options| {
            sweep_grid(
                &mixed(),
                limits(),
                &[Target::Parquet(&path)],
                None,
                &workers(1),
                options,
            )
        },
        &path,
        100,
        false,
    );
    let letter = parts(&path).join("letter.txt");
    fs::write(&letter, "dear").unwrap();
    assert!(run(true).unwrap().complete);
    assert_eq!(tree(&path).len(), 2);
    assert_eq!(fs::read_to_string(letter).unwrap(), "dear");
}
