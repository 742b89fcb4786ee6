//! `littlewood map`: a plane of two quantities.

use std::iter;
use std::path::{Path, PathBuf};
use std::time::Instant;

use littlewood::SummaryColumn;
use littlewood_sweep::{Chunk, Columns, Picture, PictureSize, Progress, Shade, sweep_grid};

use crate::args::MapArgs;
use crate::error::Error;
use crate::interrupt;
use crate::nearest;
use crate::output::Output;
use crate::progress::Bar;
use crate::report::sweep::{self, Run};
use crate::store::{self, Kind};
use crate::work;

/// Runs the command.
///
/// # Errors
/// Bad input, a failure to write, or Ctrl-C.
pub(crate) fn run(args: &MapArgs) -> Result<(), Error> {
    let shade = shade_of(&args.shade)?;
    let size = PictureSize { width: args.size.0, height: args.size.1 };
    let kinds = store::kinds(&args.store.out, &[Kind::Zarr, Kind::Parquet, Kind::Picture])?;
    let (grid, limits) = work::grid(&args.base, &args.run, &[args.x, args.y])?;
    let targets: Vec<_> = kinds.iter().filter_map(|(kind, path)| kind.target(path, grid.len())).collect();
    let drawn: Vec<&Path> =
        kinds.iter().filter(|(kind, _)| *kind == Kind::Picture).map(|(_, path)| *path).collect();
    if let ([], [path, ..], true) = (&targets[..], &drawn[..], args.store.resume) {
        return Err(Error::Out {
            path: path.to_path_buf(),
            reason: "there is nothing to resume: a picture alone does not keep what it is drawn from"
                .to_owned(),
            hint: "leave out --resume; with a second --out NAME.zarr a picture can be resumed".to_owned(),
        });
    }
    let mut picture = Picture::new(&grid, limits, shade, size)?;
    let files = drawn.iter().map(|path| Output::open(Some(path))).collect::<Result<Vec<_>, Error>>()?;
    let workers = work::workers(&args.work)?;
    let cancel = interrupt::asked();
    let bar = Bar::new();
    let show = |progress: Progress| bar.show(work::STARTS, work::count(progress));
    let options = work::options(&args.work, args.store.resume, cancel, &show);
    let began = Instant::now();
    let report = if drawn.is_empty() {
        sweep_grid(&grid, limits, &targets, None, &workers, &options)?
    } else {
        let mut add = |chunk: &Chunk, columns: &Columns| picture.add(chunk, columns);
        sweep_grid(&grid, limits, &targets, Some(&mut add), &workers, &options)?
    };
    let time = began.elapsed();
    drop(bar);

    let mut pictures = Vec::new();
    if report.complete {
        for (file, path) in files.into_iter().zip(&drawn) {
            let png = picture.png()?;
            file.write(|writer| writer.write_all(&png))?;
            pictures.push(path.to_path_buf());
        }
    } else if report.computed + report.reused > 0 {
        // A picture that is not complete does not take the place of one that may be.
        drop(files);
        for path in &drawn {
            let path = partial(path);
            let png = picture.png()?;
            Output::open(Some(&path))?.write(|writer| writer.write_all(&png))?;
            pictures.push(path);
        }
    }
    let kept = work::kept(&targets, &report, pictures);
    sweep::finish(&Run::new(&report, time, workers.threads(), kept), args.store.format)
}

/// Where a picture goes that is not complete: `map.partial.png`.
fn partial(path: &Path) -> PathBuf {
    path.with_extension("partial.png")
}

fn shade_of(name: &str) -> Result<Shade, Error> {
    let plain = name.replace('-', "_");
    if plain == SummaryColumn::Outcome.name() {
        return Ok(Shade::Class);
    }
    let known = || SummaryColumn::numbers().map(SummaryColumn::name);
    SummaryColumn::numbers().find(|column| column.name() == plain).map(Shade::Column).ok_or_else(|| {
        let all: Vec<&str> = iter::once(SummaryColumn::Outcome.name()).chain(known()).collect();
        Error::UnknownShade {
            name: name.to_owned(),
            hint: nearest::hint(name, known(), &format!("the columns are {}", all.join(", "))),
        }
    })
}
