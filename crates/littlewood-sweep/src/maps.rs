//! Pictures of whole grids, computed for them, and of stores.

use littlewood::Limits;

use crate::chunk::Chunk;
use crate::columns::Columns;
use crate::compute::Workers;
use crate::error::SweepError;
use crate::grid::Grid;
use crate::options::Options;
use crate::picture::{Picture, PictureSize, Shade};
use crate::sweep::sweep_grid;
#[cfg(feature = "zarr")]
use crate::zarr::ZarrStore;

impl Picture {
    /// Computes a grid and draws it, boundaries as curves; nothing is kept but the picture. A cancelled picture is white
    /// where it is not computed.
    ///
    /// # Errors
    /// As [`Picture::new`] and [`Workers::compute`].
    pub fn of_grid(
        grid: &Grid,
        limits: Limits,
        shade: Shade,
        size: PictureSize,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, SweepError> {
        let mut picture = Self::new(grid, limits, shade, size)?;
        let mut add = |chunk: &Chunk, columns: &Columns| picture.add(chunk, columns);
        sweep_grid(grid, limits, &[], Some(&mut add), workers, options)?;
        picture.follow(limits, workers, options)?;
        Ok(picture)
    }

    /// Draws a store as it is, without the motions between its points.
    ///
    /// # Errors
    /// As [`Picture::new`]; a chunk that cannot be read.
    #[cfg(feature = "zarr")]
    pub fn of_store(store: &ZarrStore, shade: Shade, size: PictureSize) -> Result<Self, SweepError> {
        let mut picture = Self::new(store.grid(), store.limits(), shade, size)?;
        for number in 0..store.chunks().count() {
            if let Some(columns) = store.columns(number)? {
                picture.add(&store.chunks().chunk(number), &columns);
            }
        }
        Ok(picture)
    }
}
