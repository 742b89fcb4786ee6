//! CSV: one row for each transition, or for each sample.

use std::io::{self, Write};

use csv::{ErrorKind, Writer};
use littlewood::{Cause, Mode, Outcome, Phase, State, Trajectory};
use serde::Serialize;

use crate::record::{EdgeRecord, SampleRecord, SiSampleRecord, SiStateRecord, StateRecord, sign};
use crate::{Sampling, Subject};

/// A motion. In SI units the columns in SI units follow the dimensionless ones.
///
/// # Errors
/// A failure to write.
pub fn motion(
    writer: impl Write,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    sampling: Option<Sampling>,
) -> io::Result<()> {
    let mut writer = Writer::from_writer(writer);
    match sampling {
        Some(sampling) => samples(&mut writer, subject, trajectory, sampling),
        None => events(&mut writer, subject, trajectory),
    }
    .map_err(into_io)?;
    writer.flush()
}

/// The start, the transitions, and the outcome where that is no event.
fn events<W: Write>(
    writer: &mut Writer<W>,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
) -> csv::Result<()> {
    let mut row = |state: State, edge: EdgeRecord| match subject.units {
        Some(units) => writer.serialize((StateRecord::from(state), edge, SiStateRecord::new(units, &state))),
        None => writer.serialize((StateRecord::from(state), edge)),
    };
    let first = trajectory.phases().first();
    row(
        trajectory.start(),
        EdgeRecord {
            from: None,
            to: first.map(|phase| phase.mode().name()),
            direction: sign(first.and_then(Phase::direction)),
            cause: "start",
        },
    )?;
    for transition in trajectory.transitions() {
        row(transition.state, transition.into())?;
    }
    let outcome = trajectory.outcome();
    if is_event(&outcome) {
        return Ok(());
    }
    let last = trajectory.phases().last().map(Phase::mode);
    row(
        outcome.state(),
        EdgeRecord { from: last.map(Mode::name), to: None, direction: 0, cause: outcome.kind() },
    )
}

/// Whether the outcome is the last transition.
const fn is_event(outcome: &Outcome) -> bool {
    matches!(
        outcome,
        Outcome::Landing { .. }
            | Outcome::ParticleAtPlane { .. }
            | Outcome::ParticleAtBottom { .. }
            | Outcome::ParticleAtTop { .. }
            | Outcome::Singular { .. }
    )
}

#[derive(Serialize)]
struct EventRecord {
    event: &'static str,
}

fn samples<W: Write>(
    writer: &mut Writer<W>,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    sampling: Sampling,
) -> csv::Result<()> {
    let mut names = Events::new(trajectory);
    let hoop = trajectory.hoop();
    let mut any = false;
    for sample in trajectory.sample_evenly(sampling.count, sampling.until) {
        let record = SampleRecord::new(hoop, &sample);
        let event = EventRecord { event: names.at(record.time) };
        match subject.units {
            Some(units) => writer.serialize((record, event, SiSampleRecord::new(units, hoop, &sample)))?,
            None => writer.serialize((record, event))?,
        }
        any = true;
    }
    if any {
        return Ok(());
    }
    // Nothing moves from here, so there is no instant to sample: the event rows say what was found.
    events(writer, subject, trajectory)
}

/// Names the events in the order of the samples. A transition appears as the last instant of the phase that ends,
/// where it is named, and as the first of the phase that begins.
struct Events<'a> {
    trajectory: &'a Trajectory,
    next: usize,
    started: bool,
}

impl<'a> Events<'a> {
    const fn new(trajectory: &'a Trajectory) -> Self {
        Self { trajectory, next: 0, started: false }
    }

    fn at(&mut self, time: f64) -> &'static str {
        if !self.started {
            self.started = true;
            return "start";
        }
        match self.trajectory.transitions().get(self.next) {
            Some(transition) if transition.state.time == time => {
                self.next += 1;
                Cause::name(transition.cause)
            }
            _ => "",
        }
    }
}

fn into_io(error: csv::Error) -> io::Error {
    match error.into_kind() {
        ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
