//! Lists of starts, read from CSV or Parquet a chunk at a time.

mod csv;
mod error;
mod header;
mod list;
#[cfg(feature = "parquet")]
mod parquet;
mod rows;

pub use error::ListError;
pub use list::StartList;
pub(crate) use rows::Rows;
