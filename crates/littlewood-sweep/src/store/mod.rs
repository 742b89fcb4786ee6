//! Stores on disk: a folder with a header, a list of finished chunks, and their files.

mod error;
mod format;
mod manifest;
mod open;
mod writer;

pub use error::StoreError;
pub(crate) use format::{Format, Header, Names, StoreFile};
pub(crate) use open::broken_chunks;
pub(crate) use writer::{Store, WrittenChunk};
