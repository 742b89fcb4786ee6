//! Sweeps and maps of the loaded hoop: many motions at once, from a grid or a list to arrays, files and pictures.
//!
//! A [`Grid`] is a fixed [`Point`] (a hoop and a start) and any number of [`Axis`]es that vary its coordinates.
//! [`Workers`] compute points on all cores into [`Columns`], one vector a quantity; the result does not depend on the
//! number of threads.
//!
//! ```
//! use littlewood::{HoopParameters, Limits, Start};
//! use littlewood_sweep::{Axis, Class, Coordinate, Grid, Point, Workers};
//!
//! let hoop = HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s: 0.5, mu_k: 0.4 };
//! let theta = Axis::new(Coordinate::Theta, -3.0, 3.0, 13)?;
//! let rate = Axis::new(Coordinate::ThetaRate, -4.0, 4.0, 17)?;
//! let grid = Grid::new(Point { hoop, start: Start::at(0.0, 0.0) }, vec![theta, rate])?;
//! let columns = Workers::new(None)?.compute(grid.points(0..grid.len()), Limits::until(50.0))?;
//! let at_once = columns.rows().filter(|row| Class::of(row) == Class::LeavesAtOnce).count();
//! assert_eq!((columns.len(), at_once), (221, 52));
//! # Ok::<(), littlewood_sweep::SweepError>(())
//! ```
//!
//! Larger runs go to disk chunk by chunk: [`sweep_grid`] and [`sweep_list`] write any of a Zarr v3 store that xarray opens
//! as a data set, a Parquet file, and a folder of Parquet files ([`Target`]). Memory stays flat; a run that was stopped
//! goes on ([`Options::resume`]) to files that equal, byte for byte, those of a run that was not; nothing that is there
//! is overwritten. [`Picture`] draws a grid with two axes or a store of one, [`Atlas`] lists the sequences of phases that
//! occur.
//!
//! All quantities are dimensionless, as in the core.

mod atlas;
mod axis;
mod chunk;
mod columns;
mod compute;
mod description;
mod destination;
mod disk;
mod error;
mod first_turn;
mod grid;
mod manifest;
pub mod outcome;
mod parquet;
mod picture;
mod point;
mod run;
mod starts;
mod store;
mod sweep;
mod tally;
mod zarr;

pub use atlas::{Atlas, Entry};
pub use axis::{Axis, Coordinate};
pub use chunk::{Chunk, Chunks};
pub use columns::{Columns, Real, Row};
pub use compute::Workers;
pub use destination::Target;
pub use disk::{Disk, FileSystem};
pub use error::{AxisError, ListError, PictureError, StoreError, SweepError};
pub use first_turn::{FirstTurn, Stop};
pub use grid::Grid;
pub use outcome::Class;
pub use picture::{Picture, Shade, Size};
pub use point::Point;
pub use run::{CHUNK_POINTS, Options, Progress, Report};
pub use starts::StartList;
pub use sweep::{ChunkView, grid_to_parquet, grid_to_zarr, list_to_parquet, sweep_grid, sweep_list};
pub use tally::Tally;
pub use zarr::ZarrStore;
