//! `littlewood map`: a plane of two quantities.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use littlewood_sweep::{
    Chunk, Columns, Picture, PictureSize, Progress, Shade, Workers, sweep_grid,
};

use crate::args::MapArgs;
use crate::error::Error;
use crate::interrupt;
use crate::nearest;
use crate::output::{Output, place_of};
use crate::plane::Plane;
use crate::progress::Bar;
use crate::report::sweep::Run;
use crate::store::{self, Kind};
use crate::work::{self, Base};

pub(crate) fn run(args: &MapArgs) -> Result<(), Error> {
    let shade = shade_of(&args.shade)?;
    let size = PictureSize {
        width: args.size.0,
        height: args.size.1,
    };
    let kinds = store::kinds(&args.store.out, &Kind::OF_A_MAP)?;
    check_width(args.width_mm, &kinds)?;
    let mut derivatives = args.store.derivatives.clone();
    if let Shade::Derivative(column) = shade {
        derivatives.push(column);
    }
    let (grid, Base { limits, units, .. }) =
        work::grid(&args.base, &args.run, &[args.x, args.y], &derivatives)?;
    let targets: Vec<_> = kinds
        .iter()
        .filter_map(|(kind, path)| kind.target(path, grid.len()))
        .collect();
    let at_the_end: Vec<(Kind, &Path)> = kinds
        .iter()
        .copied()
        .filter(|(kind, _)| kind.is_written_at_the_end())
        .collect();
    if let ([], [(_, path), ..], true) = (&targets[..], &at_the_end[..], args.store.resume) {
        return Err(Error::Out {
            path: path.to_path_buf(),
            reason: "nothing to resume: a picture or a text alone does not store its results"
                .to_owned(),
            hint: "leave out --resume; with a second --out NAME.zarr a picture can be resumed"
                .to_owned(),
        });
    }
    let mut picture = Picture::new(&grid, limits, shade, size)?.with_units(units);
    if args.curves {
        picture = picture.with_curves()?;
    }
    if args.contours {
        picture = picture.with_contours()?;
    }
    if args.width_mm.is_some() || at_the_end.iter().any(|(kind, _)| kind.is_drawing()) {
        picture = picture.in_vectors();
    }
    let mut plane = match at_the_end.iter().find(|(kind, _)| !kind.is_picture()) {
        Some((_, path)) => Some(Plane::new(&grid, path)?),
        None => None,
    };
    let files = at_the_end
        .iter()
        .map(|(_, path)| Output::open(Some(path)))
        .collect::<Result<Vec<_>, Error>>()?;
    let workers = Workers::new(args.work.threads)?;
    let cancel = interrupt::asked();
    let bar = Bar::new();
    let show = |progress: Progress| {
        let unit = match progress.total {
            0 => BOUNDARIES,
            _ => work::STARTS,
        };
        bar.show(unit, work::count(progress));
    };
    let options = work::options(&args.work, args.store.resume, cancel, &show);
    let began = Instant::now();
    let mut report = if at_the_end.is_empty() {
        sweep_grid(&grid, limits, &targets, None, &workers, &options)?
    } else {
        let mut add = |chunk: &Chunk, columns: &Columns| {
            picture.add(chunk, columns);
            if let Some(plane) = &mut plane {
                plane.add(chunk, columns);
            }
        };
        sweep_grid(&grid, limits, &targets, Some(&mut add), &workers, &options)?
    };
    let has_picture = at_the_end.iter().any(|(kind, _)| kind.is_picture());
    if report.complete && has_picture {
        report.complete = picture.follow(limits, &workers, &options)?;
    }
    let time = began.elapsed();
    drop(bar);

    let write = |kind: Kind, file: Output| {
        let bytes = match (kind, &plane) {
            (Kind::Csv, Some(plane)) => return file.write(|writer| plane.csv(writer)),
            (Kind::Svg, _) => picture
                .figure(args.width_mm)
                .map_err(Error::Drawing)?
                .svg()
                .into_bytes(),
            #[cfg(feature = "figures")]
            (Kind::Pdf, _) => picture.figure(args.width_mm).map_err(Error::Drawing)?.pdf(),
            // Such a file is refused before.
            #[cfg(not(feature = "figures"))]
            (Kind::Pdf, _) => return Ok(()),
            (Kind::Picture, _) => match args.width_mm {
                Some(mm) => picture
                    .figure(Some(mm))
                    .and_then(|figure| figure.png(PRINT_SCALE)),
                None => picture.png(),
            }
            .map_err(Error::Drawing)?,
            // There is a plane where a text is wanted; the others are written chunk by chunk.
            (Kind::Csv, None) | (Kind::Zarr | Kind::Parquet, _) => return Ok(()),
        };
        file.write(|writer| writer.write_all(&bytes))
    };
    let mut written = Vec::new();
    if report.complete {
        for (file, (kind, path)) in files.into_iter().zip(&at_the_end) {
            write(*kind, file)?;
            written.push(path.to_path_buf());
        }
        remove_partial(&kinds);
    } else if report.computed + report.reused > 0 {
        // What is not complete does not take the place of what may be.
        drop(files);
        for (kind, path) in &at_the_end {
            let path = partial(path);
            write(*kind, Output::open(Some(&path))?)?;
            written.push(path);
        }
    }
    let kept = work::kept(&targets, &report, written);
    Run {
        report,
        time,
        threads: workers.threads(),
        kept,
    }
    .finish(args.store.format)
}

/// What a bar counts while boundaries are followed, which takes as many starts as it takes.
const BOUNDARIES: &str = "starts along the boundaries";

/// Pixels to 1/96 inch of a PNG with a width in print: 300 to the inch.
const PRINT_SCALE: f64 = 3.125;

/// Refuses a width in print that no file has, or that nothing is printed in.
fn check_width(width_mm: Option<f64>, kinds: &[(Kind, &Path)]) -> Result<(), Error> {
    let Some(mm) = width_mm else { return Ok(()) };
    if let (false, Some((_, path))) = (
        kinds.iter().any(|(kind, _)| kind.is_picture()),
        kinds.first(),
    ) {
        return Err(Error::Out {
            path: path.to_path_buf(),
            reason: "--width-mm is the width of a picture".to_owned(),
            hint: "leave out --width-mm, or give --out NAME.svg, NAME.pdf or NAME.png".to_owned(),
        });
    }
    littlewood_draw::check_width(mm).map_err(Error::Drawing)
}

/// Where a picture goes that is not complete: `map.partial.png`.
fn partial(path: &Path) -> PathBuf {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    path.with_extension(format!("partial.{ending}"))
}

/// Removes what an earlier run has left that was stopped, unless that is an output itself. What
/// cannot be removed stays.
fn remove_partial(kinds: &[(Kind, &Path)]) {
    let outputs: Vec<PathBuf> = kinds.iter().map(|(_, path)| place_of(path)).collect();
    for (_, path) in kinds
        .iter()
        .filter(|(kind, _)| kind.is_written_at_the_end())
    {
        let partial = partial(path);
        if !outputs.contains(&place_of(&partial)) {
            let _ = fs::remove_file(partial);
        }
    }
}

fn shade_of(name: &str) -> Result<Shade, Error> {
    let plain = name.replace('-', "_");
    let derivative = || plain.parse().ok().map(Shade::Derivative);
    Shade::all()
        .find(|shade| shade.name() == plain)
        .or_else(derivative)
        .ok_or_else(|| {
            let all: Vec<_> = Shade::all().map(Shade::name).collect();
            let known = || all.iter().map(AsRef::as_ref);
            let columns = Vec::from_iter(known()).join(", ");
            let columns =
                format!("the columns are {columns}, and derivatives such as end_x_by_mu_k");
            Error::UnknownShade {
                name: name.to_owned(),
                hint: nearest::hint(name, known(), &columns),
            }
        })
}
