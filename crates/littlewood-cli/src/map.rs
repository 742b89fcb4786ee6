//! `littlewood map`: a plane of two quantities.

use std::time::Instant;

use littlewood_sweep::{
    Class, Picture, Real, Shade, Size, Workers, ZarrStore, grid_to_parquet, grid_to_zarr,
};

use crate::args::MapArgs;
use crate::error::Error;
use crate::interrupt;
use crate::output::Output;
use crate::progress::Bar;
use crate::report::sweep::{self, Summary};
use crate::store::{self, Counts, Kind};
use crate::work;

/// Runs the command.
///
/// # Errors
/// Bad input, a failure to write, or Ctrl-C.
pub(crate) fn run(args: &MapArgs) -> Result<(), Error> {
    let shade = shade_of(&args.shade)?;
    let size = Size { width: args.size.0, height: args.size.1 };
    let mut targets = Vec::new();
    for path in &args.store.out {
        targets.push((store::kind_of(path, &[Kind::Zarr, Kind::Parquet, Kind::Picture])?, path));
    }
    // Pictures come last, so that they can be drawn from a store.
    targets.sort_by_key(|(kind, _)| *kind == Kind::Picture);
    let (grid, limits) = work::grid(&args.base, &args.run, vec![args.x, args.y])?;
    if targets.iter().any(|(kind, _)| *kind == Kind::Picture) {
        Picture::new(&grid, limits, shade, size)?;
    }
    let mut files = Vec::new();
    for (kind, path) in &targets {
        files.push(if *kind == Kind::Picture { Some(Output::open(Some(path))?) } else { None });
    }
    let workers: Workers = work::workers(&args.work)?;
    let cancel = interrupt::listen();
    let mut summary = Summary::new(grid.len(), &args.store.out, workers.threads());
    let mut zarr = None;
    for ((kind, path), file) in targets.into_iter().zip(files) {
        let bar = Bar::new();
        let show = |progress| bar.show(progress);
        let options = work::options(&args.work, args.store.resume, cancel, &show);
        let began = Instant::now();
        match kind {
            Kind::Zarr => {
                summary.add(&grid_to_zarr(&grid, limits, path, &workers, &options)?, began.elapsed());
                summary.counts = store::count(path)?;
                zarr = Some(path);
            }
            Kind::Parquet => {
                summary.add(&grid_to_parquet(&grid, limits, path, &workers, &options)?, began.elapsed());
            }
            Kind::Picture => {
                let picture = match zarr {
                    Some(store) => Picture::of_store(&ZarrStore::open(store)?, shade, size)?,
                    None => {
                        let picture = Picture::of_grid(&grid, limits, shade, size, &workers, &options)?;
                        summary.add_points(grid.len() - picture.count(Class::NotComputed), began.elapsed());
                        picture
                    }
                };
                summary.counts = counts_of(&picture);
                let png = picture.png()?;
                if let Some(file) = file {
                    file.write(|writer| writer.write_all(&png))?;
                }
            }
        }
        drop(bar);
    }
    sweep::finish(&summary, args.store.format)
}

fn counts_of(picture: &Picture) -> Counts {
    Class::ALL
        .into_iter()
        .map(|class| (class, picture.count(class)))
        .filter(|(_, count)| *count > 0)
        .collect()
}

fn shade_of(name: &str) -> Result<Shade, Error> {
    if name == "outcome" {
        return Ok(Shade::Class);
    }
    Real::find(&name.replace('-', "_")).map(Shade::Column).ok_or_else(|| Error::UnknownShade {
        name: name.to_owned(),
        known: format!("outcome, {}", Real::ALL.map(Real::name).join(", ")),
    })
}
