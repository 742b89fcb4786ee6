//! What is there is refused and left as it is.

use std::fs;

use littlewood::Limits;
use littlewood_sweep::{
    Grid, Options, Report, StartList, StoreError, SweepError, Target, Workers, sweep_grid,
    sweep_list,
};

use crate::store::runs::{each_kind, interrupted, limits, options, store_of};
use crate::support::{assert_same_tree, figure_2, map, mixed, tree, workers};

#[test]
fn what_is_there_is_not_overwritten() {
    each_kind(|name, run, place| {
        let store = place.join("store");
        interrupted(name, run, &store, 1, false);
        let before = tree(&store);
        let error = run(&store, &options(name)).unwrap_err();
        assert!(
            matches!(
                error,
                SweepError::Store(StoreError::Exists {
                    complete: false,
                    ..
                })
            ),
            "{name}: {error}"
        );
        run(
            &store,
            &Options {
                resume: true,
                ..options(name)
            },
        )
        .unwrap();
        let error = run(&store, &options(name)).unwrap_err();
        assert!(
            matches!(
                error,
                SweepError::Store(StoreError::Exists { complete: true, .. })
            ),
            "{name}: {error}"
        );
        assert_ne!(before, tree(&store));

        let file = place.join("file");
        fs::write(&file, "a file").unwrap();
        let folder = place.join("folder");
        fs::create_dir(&folder).unwrap();
        fs::write(folder.join("letter.txt"), "dear").unwrap();
        for path in [&file, &folder] {
            for resume in [false, true] {
                let error = run(
                    path,
                    &Options {
                        resume,
                        ..options(name)
                    },
                )
                .unwrap_err();
                assert!(
                    matches!(error, SweepError::Store(StoreError::NotAStore { .. })),
                    "{name}: {error}"
                );
            }
        }
        assert_eq!(fs::read_to_string(file).unwrap(), "a file");
        assert_eq!(tree(&folder).len(), 1);
        // An empty folder is nobody's.
        let empty = place.join("empty");
        fs::create_dir(store_of(name, &empty)).unwrap();
        assert!(run(&empty, &options(name)).unwrap().complete);
    });
}

#[test]
fn a_store_of_other_parameters_is_refused_and_the_difference_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("store");
    let workers = workers(1);
    let start = |grid: &Grid, limits: Limits, options: &Options<'_>, workers: &Workers| {
        sweep_grid(grid, limits, &[Target::Zarr(&path)], None, workers, options)
    };
    let resume = Options {
        resume: true,
        ..options("zarr")
    };
    start(&mixed(), limits(), &resume, &workers).unwrap();
    let before = tree(&path);
    let mut base = *mixed().base();
    base.hoop.inertia = 0.75;
    let other = Grid::new(base, mixed().axes().to_vec()).unwrap();
    let differences = |result: Result<Report, SweepError>| match result.unwrap_err() {
        SweepError::Store(StoreError::OtherParameters { differences, .. }) => differences,
        error => panic!("{error}"),
    };
    assert_eq!(
        differences(start(&other, limits(), &resume, &workers)),
        ["fixed.inertia: 1.0 there, 0.75 here"]
    );
    assert_eq!(
        differences(start(&mixed(), Limits::default(), &resume, &workers)),
        ["limits.until: 20.0 there, null here"]
    );
    let mut zero = *mixed().base();
    zero.start.slip = -0.0;
    let zero = Grid::new(zero, mixed().axes().to_vec()).unwrap();
    assert_eq!(
        differences(start(&zero, limits(), &resume, &workers)),
        ["fixed.slip: 0.0 there, -0.0 here"]
    );
    let small = Options {
        chunk_points: 7,
        ..resume
    };
    assert!(!differences(start(&mixed(), limits(), &small, &workers)).is_empty());
    assert_eq!(tree(&path), before);
}

#[test]
fn a_list_with_other_content_is_another_run() {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("starts.csv");
    let path = folder.path().join("store");
    for (content, same) in [("theta\n0.5\n", true), ("theta\n0.6\n", false)] {
        fs::write(&csv, content).unwrap();
        let list = StartList::open(&csv, figure_2()).unwrap();
        let resume = Options {
            resume: true,
            ..Options::default()
        };
        let result = sweep_list(
            &list,
            limits(),
            &[Target::Parquet(&path)],
            &workers(1),
            &resume,
        );
        assert_eq!(result.is_ok(), same, "{result:?}");
    }
}

#[test]
fn an_unwritable_folder_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    // A path through a file: no one, not even root, can write there.
    let path = file.join("map.zarr");
    let error = sweep_grid(
        &map(3),
        limits(),
        &[Target::Zarr(&path)],
        None,
        &workers(1),
        &Options::default(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("file"), "{error}");
    assert!(!error.to_string().contains("stay"), "{error}");
    assert!(matches!(
        error,
        SweepError::Store(StoreError::Unwritable { finished: 0, .. })
    ));
}

#[test]
fn a_target_that_is_refused_keeps_the_others_from_being_begun() {
    let folder = tempfile::tempdir().unwrap();
    let (zarr, file) = (
        folder.path().join("a.zarr"),
        folder.path().join("a.parquet"),
    );
    fs::write(&file, "a file").unwrap();
    let targets = [Target::Zarr(&zarr), Target::Parquet(&file)];
    let error = sweep_grid(
        &mixed(),
        limits(),
        &targets,
        None,
        &workers(1),
        &Options::default(),
    )
    .unwrap_err();
    assert!(
        matches!(error, SweepError::Store(StoreError::NotAStore { .. })),
        "{error}"
    );
    assert!(!zarr.exists());
}

#[test]
fn two_runs_do_not_write_to_one_store() {
    each_kind(|name, run, place| {
        let (whole, path) = (place.join("whole"), place.join("store"));
        run(&whole, &options(name)).unwrap();
        interrupted(name, run, &path, 20, false);
        let before = tree(&path);
        let lock = match name {
            "zarr" => "outcome/_lock",
            _ => "_lock",
        };
        let held = fs::OpenOptions::new()
            .append(true)
            .open(store_of(name, &path).join(lock))
            .unwrap();
        held.lock().unwrap();
        let resume = Options {
            resume: true,
            ..options(name)
        };
        let error = run(&path, &resume).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::Locked { .. })),
            "{name}: {error}"
        );
        assert_eq!(tree(&path), before);
        drop(held);
        assert!(run(&path, &resume).unwrap().complete, "{name}");
        assert_same_tree(&whole, &path);
    });
}
