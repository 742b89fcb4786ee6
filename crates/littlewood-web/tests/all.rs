//! The tests of the module of the page: one program, a module for each subject.

mod generated;
mod moves;
mod plane;
mod prediction;
mod problem;
mod routh;
