//! The tests of the style: one program, a module for each subject.

mod colours;
mod energy;
mod stated_once;
mod ticks;
