//! Lists of starts, read from CSV a chunk at a time.

mod error;
mod list;
mod rows;

pub use error::ListError;
pub use list::StartList;
pub(crate) use rows::Rows;
