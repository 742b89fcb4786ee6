//! The tests of the core: one program, a module for each subject.

mod bounces;
mod bounded;
mod cases;
mod certified;
mod classification;
mod coincidences;
mod common;
mod counts;
mod degenerate;
mod digits;
mod documentation;
mod engine;
mod equations;
mod errata;
mod extremes;
mod flights;
mod frictionless;
mod impact;
mod invariants;
mod jam;
mod origins;
mod proofs;
mod reference;
mod serde;
mod symmetry;
mod vocabulary;
