//! Runs of each kind of results, and runs that are interrupted.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use littlewood::Limits;
use littlewood_sweep::{
    Options, Progress, Report, StartList, SweepError, Target, sweep_grid, sweep_list,
};

use crate::support::{figure_2, mixed, parts, workers};

/// A run of one kind, into a path.
pub(crate) type Run<'a> = dyn Fn(&Path, &Options<'_>) -> Result<Report, SweepError> + 'a;

pub(crate) fn limits() -> Limits {
    Limits::until(20.0)
}

/// Runs each of the kinds of results, of about a dozen chunks.
pub(crate) fn each_kind(test: impl Fn(&str, &Run<'_>, &Path)) {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("starts.csv");
    let rows: Vec<String> = (0..120)
        .map(|i| format!("{},{}", 0.05 * f64::from(i), 0.5 + 0.02 * f64::from(i)))
        .collect();
    fs::write(&csv, format!("theta,theta_rate\n{}\n", rows.join("\n"))).unwrap();
    let list = StartList::open(&csv, figure_2()).unwrap();
    let workers = workers(2);
    let zarr = |path: &Path, options: &Options<'_>| {
        sweep_grid(
            &mixed(),
            limits(),
            &[Target::Zarr(path)],
            None,
            &workers,
            options,
        )
    };
    let folder_of_grid = |path: &Path, options: &Options<'_>| {
        sweep_grid(
            &mixed(),
            limits(),
            &[Target::ParquetFolder(path)],
            None,
            &workers,
            options,
        )
    };
    let folder_of_list = |path: &Path, options: &Options<'_>| {
        sweep_list(
            &list,
            limits(),
            &[Target::ParquetFolder(path)],
            &workers,
            options,
        )
    };
    let grid_file = |path: &Path, options: &Options<'_>| {
        sweep_grid(
            &mixed(),
            limits(),
            &[Target::Parquet(path)],
            None,
            &workers,
            options,
        )
    };
    let list_file = |path: &Path, options: &Options<'_>| {
        sweep_list(&list, limits(), &[Target::Parquet(path)], &workers, options)
    };
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

pub(crate) fn options(name: &str) -> Options<'static> {
    Options {
        chunk_points: if name.contains("list") { 10 } else { 77 },
        ..Options::default()
    }
}

/// Where the chunks are of a run that is not complete.
pub(crate) fn store_of(name: &str, path: &Path) -> PathBuf {
    if name.ends_with("file") {
        parts(path)
    } else {
        path.to_owned()
    }
}

/// Runs until so many points are written, then cancels.
pub(crate) fn interrupted(
    name: &str,
    run: &Run<'_>,
    path: &Path,
    points: u64,
    resume: bool,
) -> Report {
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| {
        if progress.done >= points {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let options = Options {
        cancel: Some(&cancel),
        progress: Some(&watch),
        resume,
        ..options(name)
    };
    run(path, &options).unwrap()
}
