//! The tests of the drawings: one program, a module for each subject.

mod files;
mod labels;
mod texts;
