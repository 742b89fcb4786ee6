//! The tests of the films: one program, a module for each subject.

mod files;
mod impacts;
mod scene;
mod timing;

use littlewood::Trajectory;
use littlewood::cases::CASES;

/// The named motions that have something to film: some starts have no motion at all.
fn filmed() -> impl Iterator<Item = (&'static str, Trajectory)> {
    CASES
        .iter()
        .map(|case| (case.name, case.simulate().expect("a valid case")))
        .filter(|(_, motion)| !motion.phases().is_empty())
}
