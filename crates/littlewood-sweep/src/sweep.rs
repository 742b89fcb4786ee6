//! Whole runs: a grid or a list, computed into files.

use littlewood::Limits;

use crate::chunk::{Chunk, Chunks};
use crate::columns::Columns;
use crate::compute::Workers;
use crate::description::Description;
use crate::destination::{Destination, Target};
use crate::error::SweepError;
use crate::grid::Grid;
use crate::options::{MOST_CHUNK_POINTS, MOST_CHUNKS, Options};
#[cfg(feature = "parquet")]
use crate::parquet::Table;
use crate::run::{Report, View, run};
use crate::source::{GridSource, ListSource, Source as _};
use crate::starts::StartList;
#[cfg(feature = "zarr")]
use crate::zarr::Layout;

/// Is called with the results of each chunk of a grid.
pub type ChunkView<'a> = dyn FnMut(&Chunk, &Columns) + 'a;

/// Computes a grid into any number of stores and files at once. Each point is computed at most
/// once.
///
/// Memory stays flat: a few chunks are held, whatever the size of the grid. Every file is written
/// atomically. A run that was cancelled or killed is resumed with [`Options::resume`]; its files
/// are then the same, byte for byte, as those of a run that was not. `view` is called with the
/// results of every chunk, including those of an earlier run.
///
/// # Errors
/// A target that is there already, unless it is resumed; one of other parameters or of another
/// version of the format, which is left as it is; one that another process is writing to; a disk
/// that is full; a limit without meaning; more chunks than [`MOST_CHUNKS`].
pub fn sweep_grid(
    grid: &Grid,
    limits: Limits,
    targets: &[Target<'_>],
    view: Option<&mut ChunkView<'_>>,
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    let chunks = Chunks::new(grid, options.chunk_points);
    check_chunks(grid.len(), options.chunk_points, chunks.count())?;
    let description = Description::of_grid(grid, limits, chunks.shape());
    #[cfg(feature = "parquet")]
    let table = || Table::of_grid(&description, chunks.count(), grid);
    let destinations = targets
        .iter()
        .map(|target| match target {
            #[cfg(feature = "zarr")]
            Target::Zarr(path) => {
                check_axes(grid)?;
                Ok(Destination::store(
                    path,
                    Layout::new(grid, chunks.clone(), description.clone()),
                ))
            }
            #[cfg(feature = "parquet")]
            Target::Parquet(path) => Ok(Destination::file(path, table())),
            #[cfg(feature = "parquet")]
            Target::ParquetFolder(path) => Ok(Destination::store(path, table())),
            #[cfg(not(all(feature = "parquet", feature = "zarr")))]
            other => Err(not_built(other)),
        })
        .collect::<Result<Vec<_>, SweepError>>()?;
    let mut source = GridSource {
        grid,
        chunks: chunks.clone(),
    };
    let mut view =
        view.map(|view| |number: usize, columns: &Columns| view(&chunks.chunk(number), columns));
    let view = view.as_mut().map(|view| view as View<'_>);
    run(&mut source, &destinations, view, limits, workers, options)
}

/// Computes a list of starts into any number of Parquet targets at once, one row a start in the
/// order of the list.
///
/// # Errors
/// As [`sweep_grid`]; a row whose values have no physical meaning; a Zarr target, which has no
/// place for a list.
pub fn sweep_list(
    list: &StartList,
    limits: Limits,
    targets: &[Target<'_>],
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    let chunk = options.chunk_points.clamp(1, MOST_CHUNK_POINTS);
    let description = Description::of_list(list, limits, chunk);
    let mut source = ListSource::new(list, chunk);
    check_chunks(source.total(), chunk, source.count())?;
    #[cfg(feature = "parquet")]
    let table = || Table::of_list(&description, source.count(), list);
    let destinations = targets
        .iter()
        .map(|target| match target {
            Target::Zarr(path) => Err(SweepError::ListAsZarr {
                path: (*path).to_owned(),
            }),
            #[cfg(feature = "parquet")]
            Target::Parquet(path) => Ok(Destination::file(path, table())),
            #[cfg(feature = "parquet")]
            Target::ParquetFolder(path) => Ok(Destination::store(path, table())),
            #[cfg(not(feature = "parquet"))]
            other => Err(not_built(other)),
        })
        .collect::<Result<Vec<_>, SweepError>>()?;
    run(&mut source, &destinations, None, limits, workers, options)
}

/// Refuses a run whose chunks cannot all be kept track of, before anything is written or allocated
/// for them.
const fn check_chunks(points: u64, chunk: usize, chunks: usize) -> Result<(), SweepError> {
    if chunks > MOST_CHUNKS {
        Err(SweepError::TooManyChunks {
            points,
            chunk,
            chunks,
        })
    } else {
        Ok(())
    }
}

/// Refuses a grid whose coordinates are too many for a Zarr store.
#[cfg(feature = "zarr")]
fn check_axes(grid: &Grid) -> Result<(), SweepError> {
    match grid
        .axes()
        .iter()
        .find(|axis| axis.count() > Layout::MOST_COORDINATES)
    {
        Some(axis) => {
            let (axis, count) = (axis.varies(), axis.count());
            Err(SweepError::LongAxis {
                axis,
                count,
                most: Layout::MOST_COORDINATES,
            })
        }
        None => Ok(()),
    }
}

#[cfg(not(all(feature = "parquet", feature = "zarr")))]
fn not_built(target: &Target<'_>) -> SweepError {
    let (path, feature) = match target {
        Target::Zarr(path) => (path, "zarr"),
        Target::Parquet(path) | Target::ParquetFolder(path) => (path, "parquet"),
    };
    SweepError::NotBuilt {
        path: path.to_path_buf(),
        feature,
    }
}
