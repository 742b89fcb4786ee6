//! The path behind the body: the latest part of it, sampled more finely than the frames.

use std::collections::VecDeque;

use littlewood::{Mode, Phase, Sample, Trajectory};

use crate::schedule::Schedule;

/// Instants of the trail for a frame.
const FINENESS: u64 = 4;

/// Most instants that are kept.
const MOST: usize = 8192;

/// The trail up to an instant.
#[derive(Debug)]
pub(crate) struct Trail {
    steps: VecDeque<Sample>,
    /// Number of the next grid instant and of the phase that it is in.
    next: u64,
    phase: usize,
}

impl Trail {
    pub(crate) const fn new() -> Self {
        Self {
            steps: VecDeque::new(),
            next: 0,
            phase: 0,
        }
    }

    /// Extends the trail to a time.
    pub(crate) fn extend(&mut self, trajectory: &Trajectory, schedule: &Schedule, until: f64) {
        loop {
            let time = schedule.start + self.next as f64 * (schedule.step / FINENESS as f64);
            let phases = trajectory.phases();
            let phase = phases
                .get(self.phase)
                .filter(|phase| trajectory.end_of(phase).is_some());
            let change = phase.map(Phase::end_time);
            match change {
                Some(change) if change <= time && change <= until => {
                    let before = phase.and_then(Phase::last);
                    let after = phases.get(self.phase + 1).map(Phase::first);
                    before
                        .into_iter()
                        .chain(after)
                        .for_each(|sample| self.push(sample));
                    self.phase += 1;
                }
                _ if time <= until => {
                    trajectory
                        .at(time)
                        .into_iter()
                        .for_each(|sample| self.push(sample));
                    self.next += 1;
                }
                _ => return,
            }
        }
    }

    fn push(&mut self, step: Sample) {
        if self.steps.len() == MOST {
            self.steps.pop_front();
        }
        self.steps.push_back(step);
    }

    /// Pieces in one mode each, in order; a piece begins where the one before it ends.
    pub(crate) fn pieces(&self, last: Sample) -> Vec<(Mode, Vec<Sample>)> {
        let mut pieces: Vec<(Mode, Vec<Sample>)> = Vec::new();
        for step in self.steps.iter().copied().chain([last]) {
            match pieces.last_mut() {
                Some((mode, piece)) if *mode == step.mode => piece.push(step),
                _ => pieces.push((step.mode, vec![step])),
            }
        }
        pieces
    }
}
