//! The tests of the reports: one program, a module for each subject.

mod impact;
mod link;
mod sentence;
