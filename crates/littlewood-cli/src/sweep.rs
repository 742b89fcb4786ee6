//! `littlewood sweep`: a grid with any number of axes, or a list of starts.

use std::path::Path;
use std::time::Instant;

use littlewood::{HoopParameters, Start};
use littlewood_sweep::{Point, StartList, grid_to_parquet, grid_to_zarr, list_to_parquet};

use crate::args::SweepArgs;
use crate::error::Error;
use crate::interrupt;
use crate::progress::Bar;
use crate::report::sweep::{self, Summary};
use crate::store::{self, Kind};
use crate::work;

/// Runs the command.
///
/// # Errors
/// Bad input, a failure to write, or Ctrl-C.
pub(crate) fn run(args: &SweepArgs) -> Result<(), Error> {
    let allowed: &[Kind] =
        if args.starts.is_some() { &[Kind::Parquet] } else { &[Kind::Zarr, Kind::Parquet] };
    let kinds = args
        .store
        .out
        .iter()
        .map(|path| Ok((store::kind_of(path, allowed)?, path.as_path())))
        .collect::<Result<Vec<_>, Error>>()?;
    match &args.starts {
        Some(starts) => follow_list(args, starts, &kinds),
        None => follow_grid(args, &kinds),
    }
}

fn follow_grid(args: &SweepArgs, targets: &[(Kind, &Path)]) -> Result<(), Error> {
    let (grid, limits) = work::grid(&args.base, &args.run, args.axis.clone())?;
    let workers = work::workers(&args.work)?;
    let cancel = interrupt::listen();
    let mut summary = Summary::new(grid.len(), &args.store.out, workers.threads());
    for (kind, path) in targets {
        let bar = Bar::new();
        let show = |progress| bar.show(progress);
        let options = work::options(&args.work, args.store.resume, cancel, &show);
        let began = Instant::now();
        if *kind == Kind::Zarr {
            summary.add(&grid_to_zarr(&grid, limits, path, &workers, &options)?, began.elapsed());
            summary.counts = store::count(path)?;
        } else {
            summary.add(&grid_to_parquet(&grid, limits, path, &workers, &options)?, began.elapsed());
        }
    }
    sweep::finish(&summary, args.store.format)
}

fn follow_list(args: &SweepArgs, starts: &Path, targets: &[(Kind, &Path)]) -> Result<(), Error> {
    // What the list has no column for is needed from elsewhere, so the columns have to be known first.
    let columns = StartList::open(starts, STAND_IN)?.columns().to_vec();
    let (base, limits) = work::base(&args.base, &args.run, columns, Vec::new())?;
    let list = StartList::open(starts, base)?;
    let workers = work::workers(&args.work)?;
    let cancel = interrupt::listen();
    let mut summary = Summary::new(list.rows(), &args.store.out, workers.threads());
    for (_, path) in targets {
        let bar = Bar::new();
        let show = |progress| bar.show(progress);
        let options = work::options(&args.work, args.store.resume, cancel, &show);
        let began = Instant::now();
        summary.add(&list_to_parquet(&list, limits, path, &workers, &options)?, began.elapsed());
    }
    sweep::finish(&summary, args.store.format)
}

/// A point that is good for finding out which columns there are.
const STAND_IN: Point = Point {
    hoop: HoopParameters { mass_ratio: 1.0, offset: 0.5, inertia: 1.0, mu_s: 1.0, mu_k: 0.0 },
    start: Start { time: 0.0, theta: 0.0, theta_rate: 0.0, slip: 0.0, x: 0.0 },
};
