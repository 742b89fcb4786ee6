//! CSV: one row for each transition, or for each sample.

use std::io::{self, Write};

use csv::{ErrorKind, Writer, WriterBuilder};
use littlewood::impact::Impact;
use littlewood::{Cause, Outcome, OutcomeKind, Phase, State, Trajectory};

use crate::instants::{START, instants};
use crate::record::{
    Fields, Value, derivative_columns, digit_columns, edge, edge_of, jump, opening, sample,
    si_jump, si_sample, si_state, state,
};
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
    // Without impacts every row has the state of its instant, and the gap does not open but by
    // itself.
    let may_jump = trajectory.hoop().restitution().is_some() || subject.start.gap_rate != 0.0;
    let rows = rows(subject, trajectory).into_iter().map(|row| {
        let Row {
            state: at,
            edge,
            gap_rate,
            side,
            impact,
            transition,
        } = row;
        let mut fields = state(&at).followed_by(edge);
        if let Some(digits) = subject.digits {
            fields.extend(digit_columns(transition.and_then(|it| digits.get(it))));
        }
        if let Some(derivatives) = subject.derivatives {
            fields.extend(derivative_columns(derivatives, transition));
        }
        if may_jump {
            fields.extend(jump(gap_rate, side, impact));
        }
        if let Some(units) = subject.units {
            fields.extend(si_state(units, &at));
            if may_jump {
                fields.extend(si_jump(units, gap_rate, impact));
            }
        }
        fields
    });
    write_rows(writer, rows)
}

struct Row<'a> {
    state: State,
    edge: Fields,
    gap_rate: f64,
    /// Of which side of a jump the state is.
    side: Option<&'static str>,
    /// The impact, behind it.
    impact: Option<&'a Impact>,
    /// The number of the transition, if it is one.
    transition: Option<usize>,
}

impl Row<'_> {
    const fn smooth(state: State, gap_rate: f64, edge: Fields, transition: Option<usize>) -> Self {
        Self {
            state,
            edge,
            gap_rate,
            side: None,
            impact: None,
            transition,
        }
    }
}

fn rows<'a>(subject: &Subject<'_>, trajectory: &'a Trajectory) -> Vec<Row<'a>> {
    let (mode, direction) = opening(trajectory);
    let start = edge(None, mode, direction, Some(START));
    let mut rows = vec![Row::smooth(
        trajectory.start(),
        subject.start.gap_rate,
        start,
        None,
    )];
    let outcome = trajectory.outcome();
    for (index, transition) in trajectory.transitions().iter().enumerate() {
        let Some(impact) = &transition.impact else {
            let gap_rate = match (transition.cause, outcome) {
                (Cause::Landing, Outcome::Landing { gap_rate, .. }) => gap_rate,
                _ => 0.0,
            };
            let edge = edge_of(transition);
            rows.push(Row::smooth(transition.after, gap_rate, edge, Some(index)));
            continue;
        };
        rows.push(Row {
            state: transition.before,
            edge: edge(transition.from, None, None, None),
            gap_rate: impact.before.gap_rate,
            side: Some("before"),
            impact: None,
            transition: Some(index),
        });
        rows.push(Row {
            state: transition.after,
            edge: edge_of(transition),
            gap_rate: impact.after.gap_rate,
            side: Some("after"),
            impact: Some(impact),
            transition: Some(index),
        });
    }
    if outcome.kind().last_event().is_none() {
        let last = trajectory.phases().last().map(Phase::mode);
        let edge = edge(last, None, None, Some(outcome.kind().name()));
        let gap_rate = gap_rate_at_limit(trajectory);
        rows.push(Row::smooth(outcome.state(), gap_rate, edge, None));
    }
    rows
}

/// Rate of the gap where a limit has stopped a motion; zero where it ends otherwise.
fn gap_rate_at_limit(trajectory: &Trajectory) -> f64 {
    let by_time = || Some(trajectory.phases().last()?.last()?.gap_rate);
    let by_count = || Some(trajectory.transitions().last()?.impact?.after.gap_rate);
    let rate = match trajectory.outcome().kind() {
        OutcomeKind::TimeLimit => by_time(),
        OutcomeKind::TransitionLimit => by_count(),
        OutcomeKind::Landing
        | OutcomeKind::RollsForever
        | OutcomeKind::SlidesForever
        | OutcomeKind::SlipsForever
        | OutcomeKind::RepeatsForever
        | OutcomeKind::StaysInContact
        | OutcomeKind::Rests
        | OutcomeKind::ParticleAtPlane
        | OutcomeKind::ParticleAtBottom
        | OutcomeKind::ParticleAtTop
        | OutcomeKind::Inconsistent
        | OutcomeKind::Ambiguous
        | OutcomeKind::Singular
        | OutcomeKind::StepLimit
        | OutcomeKind::Unresolved
        | OutcomeKind::NotComputed
        | OutcomeKind::Invalid => None,
    };
    rate.unwrap_or(0.0)
}

fn samples<W: Write>(
    writer: &mut Writer<W>,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    sampling: Sampling,
) -> csv::Result<()> {
    let rows = instants(trajectory, sampling).map(|instant| {
        let event = Value::Word(Some(instant.event.unwrap_or_default()));
        let row = sample(&instant).followed_by(Fields::from_iter([("event", event)]));
        match subject.units {
            Some(units) => row.followed_by(si_sample(units, &instant)),
            None => row,
        }
    });
    write_rows(writer, rows)
}

/// A line with the names, and one for each row.
fn write_rows<W: Write>(
    writer: &mut Writer<W>,
    rows: impl Iterator<Item = Fields>,
) -> csv::Result<()> {
    for (index, row) in rows.enumerate() {
        if index == 0 {
            writer.write_record(row.names())?;
        }
        writer.serialize(row.values().collect::<Vec<_>>())?;
    }
    Ok(())
}

fn into_io(error: csv::Error) -> io::Error {
    match error.into_kind() {
        ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
