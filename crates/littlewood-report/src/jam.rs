//! The jam by which a start goes on where no motion is consistent.

use littlewood::impact::Impact;
use littlewood::theory::Classification;
use littlewood::{Hoop, Start, State};

/// The impact with which a motion begins at a start that has been classified, if no motion is consistent there and the hoop
/// has a coefficient of restitution.
pub fn jam_of(hoop: &Hoop, start: Start, found: &Classification) -> Option<Impact> {
    found.candidates.filter(|candidates| candidates.count() == 0)?;
    hoop.jam(&State::from(start))
}
