//! The tests of the drawings: one program, a module for each subject.

mod labels;
mod texts;
