//! CSV: one row for each transition, or for each sample.

use std::io::{self, Write};

use csv::{ErrorKind, Writer, WriterBuilder};
use littlewood::{Phase, Trajectory};

use crate::record::{Fields, Value, edge, edge_of, sample, si_sample, si_state, state};
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
    let mut writer = WriterBuilder::new().has_headers(false).from_writer(writer);
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
    let first = trajectory.phases().first();
    let mut rows = vec![(
        trajectory.start(),
        edge(None, first.map(Phase::mode), first.and_then(Phase::direction), START),
    )];
    rows.extend(trajectory.transitions().iter().map(|transition| (transition.after, edge_of(transition))));
    let outcome = trajectory.outcome();
    if outcome.kind().last_event().is_none() {
        let last = trajectory.phases().last().map(Phase::mode);
        rows.push((outcome.state(), edge(last, None, None, outcome.kind().name())));
    }
    let mut rows = rows.into_iter().map(|(at, edge)| {
        let row = state(&at).followed_by(edge);
        match subject.units {
            Some(units) => row.followed_by(si_state(units, &at)),
            None => row,
        }
    });
    write_rows(writer, &mut rows).map(drop)
}

fn samples<W: Write>(
    writer: &mut Writer<W>,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    sampling: Sampling,
) -> csv::Result<()> {
    let mut names = Events::new(trajectory);
    let mut rows = trajectory.sample_evenly(sampling.count, sampling.until).map(|instant| {
        let event = [("event", Value::Word(Some(names.at(instant.state.time))))];
        let row = sample(&instant).followed_by(event.into_iter().collect());
        match subject.units {
            Some(units) => row.followed_by(si_sample(units, &instant)),
            None => row,
        }
    });
    if write_rows(writer, &mut rows)? {
        return Ok(());
    }
    // Nothing moves from here, so there is no instant to sample: the event rows say what was found.
    drop(rows);
    events(writer, subject, trajectory)
}

/// A line with the names, and one for each row: whether there was any.
fn write_rows<W: Write>(
    writer: &mut Writer<W>,
    rows: &mut impl Iterator<Item = Fields>,
) -> csv::Result<bool> {
    let mut any = false;
    for row in rows {
        if !any {
            writer.write_record(row.names())?;
            any = true;
        }
        writer.serialize(row.values().collect::<Vec<_>>())?;
    }
    Ok(any)
}

/// What stands for an event in the first row.
const START: &str = "start";

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
            return START;
        }
        match self.trajectory.transitions().get(self.next) {
            Some(transition) if transition.time() == time => {
                self.next += 1;
                transition.cause.name()
            }
            Some(_) | None => "",
        }
    }
}

fn into_io(error: csv::Error) -> io::Error {
    match error.into_kind() {
        ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
