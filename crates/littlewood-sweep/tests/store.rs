//! Stores: the same whether interrupted or not, never overwritten, readable at all times.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests stand outside of test functions")]

mod support;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use littlewood::Limits;
use littlewood_sweep::{
    Chunk, Class, Columns, Grid, Options, Progress, Report, StartList, StoreError, SweepError, Tally, Target,
    Workers, ZarrStore, grid_to_parquet, grid_to_zarr, list_to_parquet, sweep_grid, sweep_list,
};
use support::{SmallDisk, assert_same_tree, figure_2, map, mixed, parts, tree, workers};

type Run<'a> = dyn Fn(&Path, &Options<'_>) -> Result<Report, SweepError> + 'a;

fn limits() -> Limits {
    Limits::until(20.0)
}

/// Runs each of the kinds of results, of about a dozen chunks.
fn each_kind(test: impl Fn(&str, &Run<'_>, &Path)) {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("starts.csv");
    let rows: Vec<String> =
        (0..120).map(|i| format!("{},{}", 0.05 * f64::from(i), 0.5 + 0.02 * f64::from(i))).collect();
    fs::write(&csv, format!("theta,theta_rate\n{}\n", rows.join("\n"))).unwrap();
    let list = StartList::open(&csv, figure_2()).unwrap();
    let workers = workers(2);
    let zarr = |path: &Path, options: &Options<'_>| grid_to_zarr(&mixed(), limits(), path, &workers, options);
    let folder_of_grid = |path: &Path, options: &Options<'_>| {
        sweep_grid(&mixed(), limits(), &[Target::ParquetFolder(path)], None, &workers, options)
    };
    let folder_of_list = |path: &Path, options: &Options<'_>| {
        sweep_list(&list, limits(), &[Target::ParquetFolder(path)], &workers, options)
    };
    let grid_file =
        |path: &Path, options: &Options<'_>| grid_to_parquet(&mixed(), limits(), path, &workers, options);
    let list_file =
        |path: &Path, options: &Options<'_>| list_to_parquet(&list, limits(), path, &workers, options);
    let kinds: [(&str, &Run<'_>); 5] = [
        ("zarr", &zarr),
        ("folder", &folder_of_grid),
        ("list", &folder_of_list),
        ("grid file", &grid_file),
        ("list file", &list_file),
    ];
    for (name, run) in kinds {
        let place = folder.path().join(name);
        fs::create_dir(&place).unwrap();
        test(name, run, &place);
    }
}

fn options(name: &str) -> Options<'static> {
    Options { chunk_points: if name.contains("list") { 10 } else { 77 }, ..Options::default() }
}

/// Where the chunks are of a run that is not complete.
fn store_of(name: &str, path: &Path) -> PathBuf {
    if name.ends_with("file") { parts(path) } else { path.to_owned() }
}

/// Runs until so many points are written, then cancels.
fn interrupted(name: &str, run: &Run<'_>, path: &Path, points: u64, resume: bool) -> Report {
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| {
        if progress.done >= points {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let options = Options { cancel: Some(&cancel), progress: Some(&watch), resume, ..options(name) };
    run(path, &options).unwrap()
}

#[test]
fn a_run_that_is_stopped_and_resumed_leaves_the_same_bytes() {
    each_kind(|name, run, place| {
        let whole = place.join("whole");
        let report = run(&whole, &options(name)).unwrap();
        assert!(report.complete && report.computed == report.points, "{name}: {report:?}");
        for stop in [0, 1, report.points / 3, 2 * report.points / 3] {
            let path = place.join(format!("stopped-{stop}"));
            let first = interrupted(name, run, &path, stop, false);
            assert!(!first.complete && first.computed < first.points, "{name}: {first:?}");
            // Stopped a second time, and then left to run.
            let second = interrupted(name, run, &path, first.computed + 1, true);
            assert_eq!(second.reused, first.computed, "{name}");
            let last = run(&path, &Options { resume: true, ..options(name) }).unwrap();
            assert!(last.complete, "{name}: {last:?}");
            assert_eq!((last.reused + last.computed, last.damaged_chunks), (report.points, 0), "{name}");
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
            let error = run(&path, &Options { disk: &disk, ..options(name) }).unwrap_err();
            assert!(matches!(error, SweepError::Store(StoreError::Unwritable { .. })), "{name}: {error}");
            // What is said to be there is there.
            let SweepError::Store(StoreError::Unwritable { finished, .. }) = error else { unreachable!() };
            assert_eq!(error.to_string().contains("stay"), finished > 0, "{name}: {error}");
            let report = run(&path, &Options { resume: true, ..options(name) }).unwrap();
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
        grid_to_zarr(&mixed(), limits(), &path, &workers(threads), &options("zarr")).unwrap();
    }
    assert_same_tree(&folder.path().join("1"), &folder.path().join("3"));
}

#[test]
fn what_is_there_is_not_overwritten() {
    each_kind(|name, run, place| {
        let store = place.join("store");
        interrupted(name, run, &store, 1, false);
        let before = tree(&store);
        let error = run(&store, &options(name)).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::Exists { complete: false, .. })),
            "{name}: {error}"
        );
        run(&store, &Options { resume: true, ..options(name) }).unwrap();
        let error = run(&store, &options(name)).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::Exists { complete: true, .. })),
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
                let error = run(path, &Options { resume, ..options(name) }).unwrap_err();
                assert!(matches!(error, SweepError::Store(StoreError::NotAStore { .. })), "{name}: {error}");
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
        grid_to_zarr(grid, limits, &path, workers, options)
    };
    let resume = Options { resume: true, ..options("zarr") };
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
    assert_eq!(differences(start(&zero, limits(), &resume, &workers)), ["fixed.slip: 0.0 there, -0.0 here"]);
    let small = Options { chunk_points: 7, ..resume };
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
        let resume = Options { resume: true, ..Options::default() };
        let result = list_to_parquet(&list, limits(), &path, &workers(1), &resume);
        assert_eq!(result.is_ok(), same, "{result:?}");
    }
}

#[test]
fn damaged_chunks_are_found_and_computed_again() {
    each_kind(|name, run, place| {
        if name.ends_with("file") {
            return;
        }
        let (whole, path) = (place.join("whole"), place.join("damaged"));
        run(&whole, &options(name)).unwrap();
        let is_chunk = |path: &&std::path::PathBuf| {
            let text = path.to_string_lossy();
            text.starts_with("energy/c") || text.starts_with("part-")
        };
        for (complete, harm) in [true, false].into_iter().flat_map(|c| [0, 1, 2, 3].map(|h| (c, h))) {
            if complete {
                run(&path, &options(name)).unwrap();
            } else {
                interrupted(name, run, &path, 5 * 77, false);
            }
            let chunks: Vec<_> = tree(&path).into_keys().filter(|path| is_chunk(&path)).collect();
            let victim = path.join(&chunks[1]);
            let mut bytes = fs::read(&victim).unwrap();
            match harm {
                0 => bytes.truncate(bytes.len() / 2),
                1 => bytes.clear(),
                2 => {
                    let middle = bytes.len() / 2;
                    bytes[middle] ^= 0x10;
                }
                _ => fs::remove_file(&victim).unwrap(),
            }
            if harm < 3 {
                fs::write(&victim, bytes).unwrap();
            }
            let report = run(&path, &Options { resume: true, ..options(name) }).unwrap();
            assert_eq!((report.damaged_chunks, report.complete), (1, true), "{name}, {harm}, {complete}");
            assert_same_tree(&whole, &path);
            fs::remove_dir_all(&path).unwrap();
        }
    });
}

#[test]
fn a_damaged_manifest_or_header_is_an_error() {
    each_kind(|name, run, place| {
        let path = place.join("store");
        interrupted(name, run, &path, 5 * if name.contains("list") { 10 } else { 77 }, false);
        let path = store_of(name, &path);
        let (manifest, header) = match name {
            "zarr" => ("outcome/_chunks.txt", "zarr.json"),
            _ => ("_chunks.txt", "_run.json"),
        };
        let target = place.join("store");
        let resume = Options { resume: true, ..options(name) };
        let text = fs::read_to_string(path.join(manifest)).unwrap();
        fs::write(path.join(manifest), text.replacen("\n1 ", "\none ", 1)).unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::DamagedManifest { line: 3, .. })),
            "{name}: {error}"
        );
        fs::write(path.join(manifest), text).unwrap();

        let text = fs::read_to_string(path.join(header)).unwrap();
        fs::write(path.join(header), &text[..text.len() / 2]).unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(matches!(error, SweepError::Store(StoreError::DamagedMetadata { .. })), "{name}: {error}");
        fs::write(path.join(header), "{}").unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(matches!(error, SweepError::Store(StoreError::NotAStore { .. })), "{name}: {error}");
    });
}

#[test]
fn a_partial_zarr_store_is_readable_and_says_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.zarr");
    let grid = map(40);
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| cancel.store(progress.done >= 400, Ordering::Relaxed);
    let options =
        Options { chunk_points: 200, cancel: Some(&cancel), progress: Some(&watch), ..Options::default() };
    let report = grid_to_zarr(&grid, limits(), &path, &workers(1), &options).unwrap();
    let store = ZarrStore::open(&path).unwrap();
    assert!(!store.is_complete());
    assert_eq!((store.grid(), store.limits()), (&grid, limits()));
    let broken: BTreeSet<usize> = store.broken_chunks().unwrap().into_iter().collect();
    let mut there = 0;
    for number in 0..store.chunks().count() {
        let columns = store.columns(number).unwrap();
        assert_eq!(columns.is_none(), broken.contains(&number));
        if let Some(columns) = columns {
            let expected = workers(1).compute(store.chunks().chunk(number).points(&grid), limits()).unwrap();
            assert_eq!(columns.sequence, expected.sequence);
            assert_eq!(columns.outcome, expected.outcome);
            for (a, b) in columns.reals.iter().flatten().zip(expected.reals.iter().flatten()) {
                assert_eq!(a.to_bits(), b.to_bits());
            }
            there += columns.len() as u64;
        }
    }
    assert_eq!(there, report.computed);
    assert!(0 < there && there < 1600);
}

#[test]
fn an_unwritable_folder_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    // A path through a file: no one, not even root, can write there.
    let path = file.join("map.zarr");
    let error = grid_to_zarr(&map(3), limits(), &path, &workers(1), &Options::default()).unwrap_err();
    assert!(error.to_string().contains("file"), "{error}");
    assert!(!error.to_string().contains("stay"), "{error}");
    assert!(matches!(error, SweepError::Store(StoreError::Unwritable { finished: 0, .. })));
}

#[test]
fn one_run_fills_several_targets_and_shows_every_chunk() {
    let folder = tempfile::tempdir().unwrap();
    let (zarr, file) = (folder.path().join("a.zarr"), folder.path().join("a.parquet"));
    let (alone_zarr, alone_file) = (folder.path().join("b.zarr"), folder.path().join("b.parquet"));
    grid_to_zarr(&mixed(), limits(), &alone_zarr, &workers(2), &options("zarr")).unwrap();
    let alone = grid_to_parquet(&mixed(), limits(), &alone_file, &workers(2), &options("grid file")).unwrap();
    let targets = [Target::Zarr(&zarr), Target::Parquet(&file)];
    let run = |options: &Options<'_>| {
        let mut seen = Tally::default();
        let mut view = |chunk: &Chunk, columns: &Columns| {
            assert_eq!(chunk.len(), columns.len());
            seen += Tally::of_columns(columns);
        };
        let report = sweep_grid(&mixed(), limits(), &targets, Some(&mut view), &workers(2), options).unwrap();
        (report, seen)
    };
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| cancel.store(progress.done >= 300, Ordering::Relaxed);
    let (report, seen) = run(&Options { cancel: Some(&cancel), progress: Some(&watch), ..options("zarr") });
    assert!(!report.complete && report.computed > 0);
    assert_eq!(report.tally.of(Class::NotComputed), report.points - report.computed);
    assert_eq!(seen.total(), report.computed);
    // Only one of them has lost a chunk: it is computed for that one.
    let lost = tree(&zarr).into_keys().find(|path| path.starts_with("energy/c")).unwrap();
    fs::remove_file(zarr.join(lost)).unwrap();
    let resume = Options { resume: true, ..options("zarr") };
    let (report, seen) = run(&resume);
    assert!(report.complete && report.damaged_chunks == 1 && report.reused > 0, "{report:?}");
    assert_eq!((seen, report.tally), (alone.tally, alone.tally));
    assert_same_tree(&alone_zarr, &zarr);
    assert_same_tree(&alone_file, &file);
    // All is there, and is shown and counted all the same.
    let (report, seen) = run(&resume);
    assert_eq!((report.computed, seen, report.tally), (0, alone.tally, alone.tally));
}

#[test]
fn a_target_that_is_refused_keeps_the_others_from_being_begun() {
    let folder = tempfile::tempdir().unwrap();
    let (zarr, file) = (folder.path().join("a.zarr"), folder.path().join("a.parquet"));
    fs::write(&file, "a file").unwrap();
    let targets = [Target::Zarr(&zarr), Target::Parquet(&file)];
    let error = sweep_grid(&mixed(), limits(), &targets, None, &workers(1), &Options::default()).unwrap_err();
    assert!(matches!(error, SweepError::Store(StoreError::NotAStore { .. })), "{error}");
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
        let held = fs::OpenOptions::new().append(true).open(store_of(name, &path).join(lock)).unwrap();
        held.lock().unwrap();
        let resume = Options { resume: true, ..options(name) };
        let error = run(&path, &resume).unwrap_err();
        assert!(matches!(error, SweepError::Store(StoreError::Locked { .. })), "{name}: {error}");
        assert_eq!(tree(&path), before);
        drop(held);
        assert!(run(&path, &resume).unwrap().complete, "{name}");
        assert_same_tree(&whole, &path);
    });
}

#[test]
fn what_others_put_among_the_parts_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.parquet");
    let run = |resume| {
        grid_to_parquet(&mixed(), limits(), &path, &workers(1), &Options { resume, ..options("grid file") })
    };
    interrupted(
        "grid file",
        &|_, options| grid_to_parquet(&mixed(), limits(), &path, &workers(1), options),
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
