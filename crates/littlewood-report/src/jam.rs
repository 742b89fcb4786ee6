//! The jam by which a start goes on where no motion is consistent.

use littlewood::{Classification, Hoop, Impact, ImpactCase, Start, State};

/// The impact with which a motion begins at a start that has been classified, if no motion is consistent there and the hoop
/// has a coefficient of restitution.
#[must_use]
pub fn jam_of(hoop: &Hoop, start: Start, found: &Classification) -> Option<Impact> {
    found.candidates.filter(|candidates| candidates.count() == 0)?;
    let impact = hoop.impact(&State::from(start), 0.0, hoop.restitution()?).ok()?;
    (impact.case == ImpactCase::Jams).then_some(impact)
}
