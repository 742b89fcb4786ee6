//! Tables as Parquet: one file, or a folder with one file a chunk, which Parquet readers take as
//! one table.
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
//! In the folder, finished chunks can be read at any time, a run that was stopped is resumed
//! without copying, and no footer grows with the table. pandas, pyarrow, Polars and Spark read it
//! by its name (names that begin with `_` are not data to them); `DuckDB` reads
//! `list.parquet/*.parquet`. One file is easier to pass on: its row groups are the chunks, copied
//! from a folder `list.parquet.parts` that is removed when the file is there.

mod column;
mod file;
mod read;
mod table;

pub(crate) use file::OneFile;
pub(crate) use table::Table;
