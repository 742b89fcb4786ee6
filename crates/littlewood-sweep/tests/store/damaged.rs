//! Damaged and partial stores.

use std::collections::BTreeSet;
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};

use littlewood_sweep::{Options, Progress, StoreError, SweepError, Target, ZarrStore, sweep_grid};

use crate::store::runs::{each_kind, interrupted, limits, options, store_of};
use crate::support::{assert_same_tree, bits, map, tree, workers};

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
        for (complete, harm) in [true, false]
            .into_iter()
            .flat_map(|c| [0, 1, 2, 3].map(|h| (c, h)))
        {
            if complete {
                run(&path, &options(name)).unwrap();
            } else {
                interrupted(name, run, &path, 5 * 77, false);
            }
            let chunks: Vec<_> = tree(&path)
                .into_keys()
                .filter(|path| is_chunk(&path))
                .collect();
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
            let report = run(
                &path,
                &Options {
                    resume: true,
                    ..options(name)
                },
            )
            .unwrap();
            assert_eq!(
                (report.damaged_chunks, report.complete),
                (1, true),
                "{name}, {harm}, {complete}"
            );
            assert_same_tree(&whole, &path);
            fs::remove_dir_all(&path).unwrap();
        }
    });
}

#[test]
fn a_damaged_manifest_or_header_is_an_error() {
    each_kind(|name, run, place| {
        let path = place.join("store");
        interrupted(
            name,
            run,
            &path,
            5 * if name.contains("list") { 10 } else { 77 },
            false,
        );
        let path = store_of(name, &path);
        let (manifest, header) = match name {
            "zarr" => ("outcome/_chunks.txt", "zarr.json"),
            _ => ("_chunks.txt", "_run.json"),
        };
        let target = place.join("store");
        let resume = Options {
            resume: true,
            ..options(name)
        };
        let text = fs::read_to_string(path.join(manifest)).unwrap();
        fs::write(path.join(manifest), text.replacen("\n1 ", "\none ", 1)).unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(
            matches!(
                error,
                SweepError::Store(StoreError::DamagedManifest { line: 3, .. })
            ),
            "{name}: {error}"
        );
        fs::write(path.join(manifest), text).unwrap();

        let text = fs::read_to_string(path.join(header)).unwrap();
        fs::write(path.join(header), &text[..text.len() / 2]).unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::DamagedMetadata { .. })),
            "{name}: {error}"
        );
        fs::write(path.join(header), "{}").unwrap();
        let error = run(&target, &resume).unwrap_err();
        assert!(
            matches!(error, SweepError::Store(StoreError::NotAStore { .. })),
            "{name}: {error}"
        );
    });
}

#[test]
fn a_partial_zarr_store_is_readable_and_says_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.zarr");
    let grid = map(40);
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| cancel.store(progress.done >= 400, Ordering::Relaxed);
    let options = Options {
        chunk_points: 200,
        cancel: Some(&cancel),
        progress: Some(&watch),
        ..Options::default()
    };
    let report = sweep_grid(
        &grid,
        limits(),
        &[Target::Zarr(&path)],
        None,
        &workers(1),
        &options,
    )
    .unwrap();
    let store = ZarrStore::open(&path).unwrap();
    assert!(!store.is_complete());
    assert_eq!((store.grid(), store.limits()), (&grid, limits()));
    let broken: BTreeSet<usize> = store.broken_chunks().unwrap().into_iter().collect();
    // Chunks are smaller than what pays for tables, the whole grid is not: the same bits.
    let whole = bits(
        &workers(1)
            .compute(grid.points(0..grid.len()), limits())
            .unwrap(),
    );
    let mut there = 0;
    for number in 0..store.chunks().count() {
        let columns = store.columns(number).unwrap();
        assert_eq!(columns.is_none(), broken.contains(&number));
        if let Some(columns) = columns {
            let rows: Vec<usize> = store
                .chunks()
                .chunk(number)
                .indices()
                .map(|place| 40 * place[0] + place[1])
                .collect();
            let expected: Vec<Vec<u64>> = whole
                .iter()
                .map(|column| rows.iter().map(|&row| column[row]).collect())
                .collect();
            assert_eq!(bits(&columns), expected);
            there += columns.len() as u64;
        }
    }
    assert_eq!(there, report.computed);
    assert!(0 < there && there < 1600);
}
