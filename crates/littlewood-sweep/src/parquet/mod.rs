//! Tables as Parquet: one file, or a folder with one file a chunk, which Parquet readers take as one table.
//!
//! ```text
//! list.parquet/
//!   _run.json            parameters and status
//!   _chunks.txt          finished chunks with their checksums and counts
//!   _lock                empty; locked while a run writes
//!   part-00000.parquet   rows of the first chunk, as one row group
//!   part-00001.parquet   …
//! ```
//!
//! In the folder what is finished can be read at any moment, a run that was stopped goes on without copying, and no
//! footer grows with the table. pandas, pyarrow, Polars and Spark read it by its name (names that begin with `_` are not
//! data to them); `DuckDB` reads `list.parquet/*.parquet`. One file is easier to pass on: its row groups are the chunks,
//! copied from a folder `list.parquet.parts` that is removed when the file is there.

mod file;
mod read;
mod table;

pub(crate) use file::OneFile;
pub(crate) use table::Table;

use littlewood::Quantity;

use crate::description::Description;
use crate::starts::StartList;

/// The table of a grid. The rows stand chunk by chunk (see [`crate::Chunks`]); each has its coordinates with it.
pub(crate) fn table_of_grid(description: &Description, chunks: usize) -> Table {
    Table::new(description.clone(), chunks, Vec::new())
}

/// The table of a list, one row a start in the order of the list.
pub(crate) fn table_of_list(description: &Description, chunks: usize, list: &StartList) -> Table {
    let places = [Quantity::X, Quantity::Time].into_iter().filter(|place| list.columns().contains(place));
    Table::new(description.clone(), chunks, places.collect())
}
