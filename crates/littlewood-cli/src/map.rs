//! `littlewood map`: a plane of two quantities.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use littlewood::Limits;
use littlewood_draw::Figure;
use littlewood_sweep::{
    Chunk, ChunkView, Columns, Grid, Picture, PictureSize, Progress, Shade, Workers, sweep_grid,
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
    if args.store.resume && targets.is_empty() {
        refuse_to_resume(&kinds)?;
    }
    let picture = picture(args, &grid, limits, shade)?.with_units(units);
    let mut outputs = Outputs::open(&kinds, &grid, picture, args.width_mm)?;

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
    let is_viewed = !outputs.files.is_empty();
    let mut add = |chunk: &Chunk, columns: &Columns| outputs.add(chunk, columns);
    let view = is_viewed.then_some(&mut add as &mut ChunkView<'_>);
    let mut report = sweep_grid(&grid, limits, &targets, view, &workers, &options)?;
    // That of the starts, which the rate counts; those along the boundaries are not among them.
    let time = began.elapsed();
    if report.complete && outputs.have_picture() {
        report.complete = outputs.picture.follow(&workers, &options)?;
    }
    drop(bar);

    let written = if report.complete {
        let written = outputs.finish()?;
        remove_partial(&kinds);
        written
    } else if report.computed + report.reused > 0 {
        outputs.partial()?
    } else {
        Vec::new()
    };
    let kept = work::kept(&targets, &report, written);
    Run {
        report,
        time,
        threads: workers.threads(),
        kept,
    }
    .finish(args.store.format)
}

fn picture(args: &MapArgs, grid: &Grid, limits: Limits, shade: Shade) -> Result<Picture, Error> {
    let (width, height) = args.size;
    let mut picture = Picture::new(grid, limits, shade, PictureSize { width, height })?;
    if args.curves {
        picture = picture.with_curves()?;
    }
    Ok(picture)
}

/// Refuses `--resume` if an earlier run cannot have left results.
fn refuse_to_resume(kinds: &[(Kind, &Path)]) -> Result<(), Error> {
    let Some((_, path)) = kinds.first() else {
        return Ok(());
    };
    Err(Error::Out {
        path: path.to_path_buf(),
        reason: "nothing to resume: a picture or a text alone does not store its results"
            .to_owned(),
        hint: "leave out --resume; with a second --out NAME.zarr a picture can be resumed"
            .to_owned(),
    })
}

/// The outputs that are written at the end of a run: pictures and a text.
struct Outputs<'a> {
    /// Opened before the work begins, so that a wrong path is known at once.
    files: Vec<OpenOutput<'a>>,
    picture: Picture,
    /// The rows of the text, if there is one.
    plane: Option<Plane<'a>>,
    width_mm: Option<f64>,
}

struct OpenOutput<'a> {
    kind: Kind,
    path: &'a Path,
    output: Output,
}

impl<'a> Outputs<'a> {
    fn open(
        kinds: &[(Kind, &'a Path)],
        grid: &'a Grid,
        picture: Picture,
        width_mm: Option<f64>,
    ) -> Result<Self, Error> {
        let mut files = Vec::new();
        let mut plane = None;
        for &(kind, path) in kinds {
            if !kind.is_written_at_the_end() {
                continue;
            }
            if !kind.is_picture() && plane.is_none() {
                plane = Some(Plane::new(grid, path)?);
            }
            let output = Output::open(Some(path))?;
            files.push(OpenOutput { kind, path, output });
        }
        let is_drawn = width_mm.is_some() || files.iter().any(|file| file.kind.is_drawing());
        Ok(Self {
            files,
            picture: if is_drawn {
                picture.in_vectors()
            } else {
                picture
            },
            plane,
            width_mm,
        })
    }

    fn have_picture(&self) -> bool {
        self.files.iter().any(|file| file.kind.is_picture())
    }

    fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        if self.have_picture() {
            self.picture.add(chunk, columns);
        }
        if let Some(plane) = &mut self.plane {
            plane.add(chunk, columns);
        }
    }

    /// Writes everything, and returns the paths.
    fn finish(mut self) -> Result<Vec<PathBuf>, Error> {
        let mut written = Vec::new();
        for file in std::mem::take(&mut self.files) {
            self.write(file.kind, file.output)?;
            written.push(file.path.to_path_buf());
        }
        Ok(written)
    }

    /// Writes what there is under other names, since what is not complete does not take the place
    /// of what may be; returns these names.
    fn partial(mut self) -> Result<Vec<PathBuf>, Error> {
        let mut written = Vec::new();
        for file in std::mem::take(&mut self.files) {
            let path = partial(file.path);
            self.write(file.kind, Output::open(Some(&path))?)?;
            written.push(path);
        }
        Ok(written)
    }

    fn write(&self, kind: Kind, output: Output) -> Result<(), Error> {
        let bytes = match (kind, &self.plane) {
            (Kind::Csv, Some(plane)) => return output.write(|writer| plane.csv(writer)),
            (Kind::Svg, _) => self.figure()?.svg().into_bytes(),
            #[cfg(feature = "figures")]
            (Kind::Pdf, _) => self.figure()?.pdf(),
            // Such a file is refused before.
            #[cfg(not(feature = "figures"))]
            (Kind::Pdf, _) => return Ok(()),
            (Kind::Picture, _) => self.png()?,
            // There is a plane where a text is wanted; the others are written chunk by chunk.
            (Kind::Csv, None) | (Kind::Zarr | Kind::Parquet, _) => return Ok(()),
        };
        output.write(|writer| writer.write_all(&bytes))
    }

    fn figure(&self) -> Result<Figure, Error> {
        self.picture.figure(self.width_mm).map_err(Error::Drawing)
    }

    fn png(&self) -> Result<Vec<u8>, Error> {
        let png = match self.width_mm {
            Some(_) => self.figure()?.png(PRINT_SCALE),
            None => self.picture.png(),
        };
        png.map_err(Error::Drawing)
    }
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
