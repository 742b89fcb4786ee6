//! The instants of a motion that tables and files show.

use littlewood::{Mode, Phase, Sample, Trajectory, Transition};

use crate::Sampling;

/// An instant of a motion, with what happens there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant {
    /// What is known of it. Accelerations and forces are NaN where no motion is consistent.
    pub sample: Sample,
    /// The mode; none where no motion is consistent, just before a jam.
    pub mode: Option<Mode>,
    /// The event, `start` at first, or the outcome where there is no motion. A transition is named
    /// at the last instant of the phase that it ends; a jam that ends none, at the first of the
    /// phase that begins.
    pub event: Option<&'static str>,
}

impl Instant {
    fn of(sample: Sample, event: Option<&'static str>) -> Self {
        Self {
            sample,
            mode: Some(sample.mode),
            event,
        }
    }
}

/// What stands for an event at the first instant.
pub(crate) const START: &str = "start";

/// Evenly spaced instants of a motion, and every transition between them twice: just before it and
/// just after. A motion that ends where it begins, because none is consistent, has its start alone.
pub fn instants(trajectory: &Trajectory, sampling: Sampling) -> impl Iterator<Item = Instant> + '_ {
    Instants {
        trajectory,
        samples: trajectory.sample_evenly(sampling.count, sampling.until),
        phase: 0,
        has_begun: false,
        transition: 0,
        held: trajectory.only_instant().map(|sample| {
            let event = Some(trajectory.outcome().kind().name());
            Instant {
                sample,
                mode: None,
                event,
            }
        }),
    }
}

struct Instants<'a, I> {
    trajectory: &'a Trajectory,
    samples: I,
    /// Index of the phase that the next sample is of.
    phase: usize,
    /// Whether its first instant has passed.
    has_begun: bool,
    /// Index of the next transition.
    transition: usize,
    /// An instant that comes after one that is no sample.
    held: Option<Instant>,
}

impl<I: Iterator<Item = Sample>> Iterator for Instants<'_, I> {
    type Item = Instant;

    fn next(&mut self) -> Option<Instant> {
        if let Some(held) = self.held.take() {
            return Some(held);
        }
        let sample = self.samples.next()?;
        Some(if self.has_begun {
            Instant::of(sample, self.ends(&sample))
        } else {
            self.begins(sample)
        })
    }
}

impl<'a, I> Instants<'a, I> {
    /// The first instant of a phase, or that before the jam that leads to it.
    fn begins(&mut self, sample: Sample) -> Instant {
        self.has_begun = true;
        let start = (self.phase == 0).then_some(START);
        let jam = self
            .trajectory
            .transitions()
            .get(self.transition)
            .filter(|next| next.from.is_none());
        let instant = match jam {
            None => Instant::of(sample, start),
            Some(jam) => {
                self.transition += 1;
                self.held = Some(Instant::of(sample, Some(jam.cause.name())));
                Instant {
                    sample: before(jam, sample),
                    mode: None,
                    event: start,
                }
            }
        };
        // Of a first phase that has no length there is one instant only.
        if self.phase == 0 && self.current().is_some_and(|phase| phase.duration() <= 0.0) {
            self.ends(&sample);
        }
        instant
    }

    /// The event, if this is the last instant of the phase.
    fn ends(&mut self, sample: &Sample) -> Option<&'static str> {
        let phase = self
            .current()
            .filter(|phase| phase.end() == Some(sample.state))?;
        if self.phase + 1 < self.trajectory.phases().len() {
            self.phase += 1;
            self.has_begun = false;
        }
        let event = self.trajectory.end_of(phase)?;
        self.transition += 1;
        Some(event.cause.name())
    }

    fn current(&self) -> Option<&'a Phase> {
        self.trajectory.phases().get(self.phase)
    }
}

/// The instant before a jam from a state where no motion is consistent, given the one after it: the
/// hoop has not moved.
fn before(jam: &Transition, after: Sample) -> Sample {
    let mut sample = after;
    sample.state = jam.before;
    sample.direction = None;
    (sample.theta_acceleration, sample.slip_acceleration) = (f64::NAN, f64::NAN);
    (sample.normal, sample.friction, sample.couple) = (f64::NAN, f64::NAN, f64::NAN);
    sample.gap_rate = 0.0;
    sample.energy += jam.impact.map_or(0.0, |impact| impact.energy_lost());
    sample
}
