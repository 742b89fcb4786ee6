//! The tests of the style: one program, a module for each subject.

mod colours;
mod stated_once;
mod ticks;
