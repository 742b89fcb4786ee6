//! The tests of the films: one program, a module for each subject.

mod files;
mod impacts;
mod scene;
mod timing;
