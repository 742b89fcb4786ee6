//! Grids as Zarr v3: a group with an array for each column, dimensions named and labelled.
//!
//! ```text
//! map.zarr/
//!   zarr.json            group: parameters, status, and the metadata of all arrays (consolidated)
//!   theta/  theta_rate/  coordinates, one array an axis
//!   outcome/  sequence/  …  one array a column, its chunks in c/
//!   outcome/_chunks.txt  finished chunks with their checksums and counts
//!   outcome/_lock        empty; locked while a run writes
//! ```
//!
//! `xarray.open_zarr` opens the group as a data set with coordinates, units and long names
//! (CF-1.11). Chunks that are not computed yet read as the columns of
//! [`Summary::NOT_COMPUTED`](littlewood::Summary::NOT_COMPUTED).

mod array;
mod layout;
mod reader;

pub(crate) use layout::Layout;
pub use reader::ZarrStore;
