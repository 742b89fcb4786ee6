//! The tests of the sweeps: one program, a module for each subject.

#![cfg(all(feature = "parquet", feature = "zarr"))]

mod compute;
mod derivatives;
mod list;
mod picture;
mod regions;
mod restitution;
mod store;
mod support;
mod zarr;
