//! The tests of the module of the page: one program, a module for each subject.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests stand outside of test functions"
)]

mod generated;
mod map;
mod moves;
mod plane;
mod prediction;
mod problem;
mod routh;
mod support;
