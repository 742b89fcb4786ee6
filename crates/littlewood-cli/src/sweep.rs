//! `littlewood sweep`: a grid with any number of axes, or a list of starts.

use std::path::Path;
use std::time::Instant;

use littlewood::tables::Quantity;
use littlewood_sweep::{
    Options, Progress, Report, StartList, SweepError, Target, Workers, sweep_grid, sweep_list,
};

use crate::args::SweepArgs;
use crate::error::Error;
use crate::interrupt;
use crate::progress::Bar;
use crate::report::sweep::Run;
use crate::store::{self, Kind};
use crate::work::{self, Base, Varied};

pub(crate) fn run(args: &SweepArgs) -> Result<(), Error> {
    match &args.starts {
        Some(starts) => follow_list(args, starts),
        None => follow_grid(args),
    }
}

fn follow_grid(args: &SweepArgs) -> Result<(), Error> {
    let kinds = store::kinds(&args.store.out, &[Kind::Zarr, Kind::Parquet])?;
    let (grid, Base { limits, .. }) =
        work::grid(&args.base, &args.run, &args.axis, &args.store.derivatives)?;
    follow(args, grid.len(), &kinds, |targets, workers, options| {
        sweep_grid(&grid, limits, targets, None, workers, options)
    })
}

fn follow_list(args: &SweepArgs, starts: &Path) -> Result<(), Error> {
    let kinds = store::kinds(&args.store.out, &[Kind::Parquet])?;
    // What the list has no column for is needed from elsewhere, so the columns have to be known
    // first.
    let quantities = StartList::open(starts, work::STAND_IN)?.columns().to_vec();
    let base = work::base(
        &args.base,
        &args.run,
        Varied {
            quantities,
            ..Varied::default()
        },
    )?;
    let list = StartList::open(starts, base.setup)?;
    let bounces =
        list.columns().contains(&Quantity::Restitution) || base.setup.hoop.restitution.is_some();
    let derivatives = work::derivatives(&args.store.derivatives, bounces)?;
    let list = list.with_derivatives(derivatives);
    follow(args, list.rows(), &kinds, |targets, workers, options| {
        sweep_list(&list, base.limits, targets, workers, options)
    })
}

fn follow(
    args: &SweepArgs,
    starts: u64,
    kinds: &[(Kind, &Path)],
    sweep: impl FnOnce(&[Target<'_>], &Workers, &Options<'_>) -> Result<Report, SweepError>,
) -> Result<(), Error> {
    let targets: Vec<_> = kinds
        .iter()
        .filter_map(|(kind, path)| kind.target(path, starts))
        .collect();
    let workers = Workers::new(args.work.threads)?;
    let cancel = interrupt::asked();
    let bar = Bar::new();
    let show = |progress: Progress| bar.show(work::STARTS, work::count(progress));
    let options = work::options(&args.work, args.store.resume, cancel, &show);
    let began = Instant::now();
    let report = sweep(&targets, &workers, &options)?;
    let time = began.elapsed();
    drop(bar);
    let kept = work::kept(&targets, &report, Vec::new());
    Run {
        report,
        time,
        threads: workers.threads(),
        kept,
    }
    .finish(args.store.format)
}
