//! The tests of the command line: one program, a module for each subject.

#[cfg(feature = "film")]
mod animate;
#[cfg(feature = "sweep")]
mod classify;
mod features;
#[cfg(feature = "figures")]
mod figures;
#[cfg(all(
    feature = "sweep",
    feature = "figures",
    feature = "film",
    feature = "lab"
))]
mod fuzz;
mod impact;
mod input;
#[cfg(all(
    feature = "sweep",
    feature = "figures",
    feature = "film",
    feature = "lab"
))]
mod interrupt;
#[cfg(feature = "lab")]
mod lab;
#[cfg(feature = "sweep")]
mod map;
#[cfg(all(
    feature = "sweep",
    feature = "figures",
    feature = "film",
    feature = "lab"
))]
mod output;
mod page;
mod plane;
#[cfg(feature = "figures")]
mod poster;
#[cfg(feature = "sweep")]
mod restitution;
mod scenario;
mod si;
mod simulate;
#[cfg(all(
    feature = "sweep",
    feature = "figures",
    feature = "film",
    feature = "lab"
))]
mod snapshots;
#[cfg_attr(
    not(all(
        feature = "sweep",
        feature = "figures",
        feature = "film",
        feature = "lab"
    )),
    allow(dead_code, reason = "without a feature some of it has nobody to help")
)]
mod support;
mod threshold;
