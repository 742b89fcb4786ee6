//! The phases of a motion as a table shows them: one by one, or as many bounces together.

use core::ops::Range;

use littlewood::{Mode, Phase, Trajectory, Transition};

/// Flights of a sequence of bounces that are shown one by one.
const FIRST_FLIGHTS: usize = 4;

/// Flights that are worth a row together.
const LEAST_TOGETHER: usize = 3;

/// A part of a motion.
#[derive(Clone, Debug)]
pub(super) enum Part<'a> {
    /// A jam from a state where no motion is consistent.
    Jam(&'a Transition),
    /// A phase, by its index.
    Phase(usize, &'a Phase),
    /// Flights from one landing to the next, by their indices.
    Bounces(Range<usize>),
}

impl Part<'_> {
    /// Number of phases.
    pub(super) fn phases(&self) -> usize {
        match self {
            Self::Jam(_) => 0,
            Self::Phase(..) => 1,
            Self::Bounces(range) => range.len(),
        }
    }
}

/// The parts of a motion in order; without `fold` every flight is one.
pub(super) fn parts(trajectory: &Trajectory, fold: bool) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut transitions = trajectory.transitions().iter().peekable();
    let mut together = 0..0;
    for (index, phase) in trajectory.phases().iter().enumerate() {
        parts.extend(
            transitions
                .next_if(|next| next.from.is_none())
                .map(Part::Jam),
        );
        if trajectory.end_of(phase).is_some() {
            transitions.next();
        }
        if fold && index >= together.end && phase.mode() == Mode::Flight {
            let run = index..end_of_bounces(trajectory, index);
            if run.len() >= FIRST_FLIGHTS + LEAST_TOGETHER {
                together = index + FIRST_FLIGHTS..run.end;
            }
        }
        if index == together.start && !together.is_empty() {
            parts.push(Part::Bounces(together.clone()));
        } else if !together.contains(&index) {
            parts.push(Part::Phase(index, phase));
        }
    }
    parts.extend(transitions.map(Part::Jam));
    parts
}

/// Where the flights end that begin with a phase and follow one another.
fn end_of_bounces(trajectory: &Trajectory, first: usize) -> usize {
    let phases = trajectory.phases().get(first..).unwrap_or_default();
    let is_bounce = |phase: &&Phase| trajectory.end_of(phase).is_some_and(Transition::is_bounce);
    let bounces = phases.iter().take_while(is_bounce);
    (first + bounces.count() + 1).min(trajectory.phases().len())
}
