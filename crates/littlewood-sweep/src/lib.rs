//! Sweeps and maps of the loaded hoop: many motions at once, from a grid or a list to arrays, files
//! and pictures.
//!
//! A [`Grid`] is a base [`Setup`](littlewood::tables::Setup), a hoop with a start, and any number
//! of [`Axis`]es that vary its quantities. [`Workers`] compute points on all cores into
//! [`Columns`], one vector for each
//! [`SummaryColumn`](littlewood::tables::SummaryColumn); the result does not depend on the number of threads.
//!
//! ```
//! use littlewood::tables::{Class, Quantity, Setup};
//! use littlewood::{HoopParameters, Limits, Start};
//! use littlewood_sweep::{Axis, Grid, Workers};
//!
//! let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
//! let theta = Axis::new(Quantity::Theta, -3.0, 3.0, 13)?;
//! let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 17)?;
//! let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), vec![theta, rate])?;
//! let columns = Workers::new(None)?.compute(grid.points(0..grid.len()), Limits::until(50.0))?;
//! let at_once = columns.summaries().filter(|summary| Class::of(summary) == Class::LeavesAtOnce).count();
//! assert_eq!((columns.len(), at_once), (221, 52));
//! # Ok::<(), littlewood_sweep::SweepError>(())
//! ```
//!
//! Larger runs go to disk chunk by chunk: [`sweep_grid`] and [`sweep_list`] write any of a Zarr v3
//! store that xarray opens as a data set, a Parquet file, and a folder of Parquet files
//! ([`Target`]). Memory stays flat. A run that was stopped can be resumed ([`Options::resume`]);
//! its files then equal, byte for byte, those of a run that was not. Nothing that exists is
//! overwritten. [`Picture`] draws a grid with two axes or a store of one.
//!
//! The features `zarr` and `parquet`, both on by default, bring the formats; without one its
//! targets are refused.
//!
//! All quantities are dimensionless, as in the core.

#![cfg_attr(
    not(any(feature = "parquet", feature = "zarr")),
    allow(
        unused,
        reason = "without a format of files nothing calls what keeps them"
    )
)]

mod attributes;
mod axis;
mod chunk;
mod columns;
mod compute;
mod description;
mod destination;
mod disk;
mod error;
mod file;
mod getters;
mod grid;
mod options;
#[cfg(feature = "parquet")]
mod parquet;
mod picture;
mod regions;
mod run;
mod setup;
mod source;
mod starts;
mod store;
mod sweep;
mod tally;
mod watch;
#[cfg(feature = "zarr")]
mod zarr;

pub use attributes::of_derivative;
pub use axis::{Axis, AxisError, Spacing, Varies};
pub use chunk::{Chunk, Chunks};
pub use columns::{Column, ColumnValues, Columns};
pub use compute::{Halt, MOST_THREADS, Points, Refused, ThreadsError, Workers};
pub use description::{ForeignVersion, STORE_FORMAT};
pub use destination::Target;
pub use disk::{Disk, FileSystem, UNFINISHED};
pub use error::SweepError;
pub use file::{open_file, read_file};
pub use grid::Grid;
pub use options::{CHUNK_POINTS, MOST_CHUNK_POINTS, MOST_CHUNKS, Options, Progress};
pub use picture::{Picture, PictureError, PictureSize, Shade};
pub use regions::{Ask, Boundary, FOR_A_POINT, Lattice, MIXED, Place, Region, Regions};
pub use run::Report;
pub use starts::{ListError, StartList};
pub use store::StoreError;
pub use sweep::{ChunkView, sweep_grid, sweep_list};
pub use tally::Tally;
#[cfg(feature = "zarr")]
pub use zarr::ZarrStore;
