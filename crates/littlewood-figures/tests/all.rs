//! The tests of the figures: one program, a module for each subject.

mod beyond;
mod catalogue;
mod checker;
mod facts;
mod fates;
mod files;
mod gallery;
mod grey;
mod impacts;
mod labels;
mod maps;
mod motions;
mod plane;
mod poster;
mod print;
mod random;
mod resisted;
mod seen;
mod si;
mod support;
