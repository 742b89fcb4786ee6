//! Stores: the same whether interrupted or not, never overwritten, readable at all times.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

mod damaged;
mod refused;
mod resume;
mod runs;
mod versions;
