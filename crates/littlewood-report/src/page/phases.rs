//! The table of the phases of a motion, with its impacts.

use littlewood::modes::PhaseSolution;
use littlewood::tables::{Dimension, Quantity};
use littlewood::{Cause, Mode, OutcomeKind, Phase, State, Trajectory, Transition};

use super::parts::{Part, parts};
use crate::ShownImpact;
use crate::number::column;
use crate::scale::Scale;
use crate::sheet::{Row, Table};

/// Parts shown at most; of longer motions the first and the last ones.
const FIRST_PARTS: usize = 30;
const LAST_PARTS: usize = 10;

/// The columns of numbers.
const NUMBERS: [usize; 7] = [0, 2, 3, 4, 5, 6, 7];

/// The table; with `all` nothing is folded or left out.
pub(super) fn phases(trajectory: &Trajectory, scale: Scale<'_>, all: bool) -> Table {
    let of_state = |quantity: Quantity| scale.heading(scale.sign(quantity), quantity.dimension());
    let header = [
        "#".to_owned(),
        "motion".to_owned(),
        scale.heading(
            &format!("from {}", scale.sign(Quantity::Time)),
            Dimension::Time,
        ),
        scale.heading("duration", Dimension::Time),
        of_state(Quantity::Theta),
        of_state(Quantity::ThetaRate),
        of_state(Quantity::Slip),
        scale.heading("lost", Dimension::Energy),
        "ends by".to_owned(),
    ];
    let parts = parts(trajectory, !all);
    let hidden = if all {
        0..0
    } else {
        FIRST_PARTS..parts.len().saturating_sub(LAST_PARTS)
    };
    let table = Rows { trajectory, scale };
    let mut rows = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        if !hidden.contains(&index) {
            rows.extend(table.of(part));
        } else if index == hidden.start {
            let more: usize = parts
                .get(hidden.clone())
                .unwrap_or_default()
                .iter()
                .map(Part::phases)
                .sum();
            let cells = vec!["…".to_owned(), format!("… {more} more")];
            rows.push(Row {
                folds: Some(more),
                ..cells.into()
            });
        }
    }
    Table {
        head: header.to_vec(),
        rows,
        numbers: NUMBERS.to_vec(),
    }
}

/// The mode of a phase, the direction of slip, and the mark of the footnote.
fn motion_of(phase: &Phase) -> String {
    if matches!(phase.solution(), PhaseSolution::Flight(flight) if flight.settles()) {
        return "bounces".to_owned();
    }
    let mark = if phase.is_outside_small_inertia_limit() {
        "*"
    } else {
        ""
    };
    format!("{}{mark}", phase.mode().with_arrow(phase.direction()))
}

struct Rows<'a> {
    trajectory: &'a Trajectory,
    scale: Scale<'a>,
}

impl Rows<'_> {
    /// The rows of a part of the motion.
    fn of(&self, part: &Part<'_>) -> Vec<Row> {
        match part {
            Part::Jam(jam) => self.impact(0, jam).into_iter().collect(),
            Part::Phase(index, phase) => {
                let end = self.trajectory.end_of(phase);
                // The impacts of bounces that settle are all in one row.
                let settles = end.is_some_and(|end| end.cause == Cause::Settle);
                let impacts = end
                    .filter(|_| settles)
                    .map_or(0.0, |end| self.lost(*index, end));
                let row = self.row(Line {
                    mode: Some(phase.mode()),
                    number: (index + 1).to_string(),
                    motion: motion_of(phase),
                    state: phase.start(),
                    duration: Some(phase.duration()),
                    lost: phase.energy_lost() + impacts,
                    ends_by: self.ends_by(phase),
                    folds: None,
                });
                let impact = end
                    .filter(|_| !settles)
                    .and_then(|end| self.impact(*index, end));
                [row].into_iter().chain(impact).collect()
            }
            Part::Bounces(range) => {
                let phases = self
                    .trajectory
                    .phases()
                    .get(range.clone())
                    .unwrap_or_default();
                let (Some(first), Some(last)) = (phases.first(), phases.last()) else {
                    return Vec::new();
                };
                let impacts = range
                    .clone()
                    .zip(phases)
                    .filter_map(|(index, phase)| Some((index, self.trajectory.end_of(phase)?)));
                vec![self.row(Line {
                    mode: Some(first.mode()),
                    number: format!("{}…", range.start + 1),
                    motion: format!("{} bounces", range.len()),
                    state: first.start(),
                    duration: Some(last.end_time() - first.start().time),
                    lost: impacts.map(|(index, end)| self.lost(index, end)).sum(),
                    ends_by: self.ends_by(last),
                    folds: Some(range.len()),
                })]
            }
        }
    }

    fn ends_by(&self, phase: &Phase) -> &'static str {
        let outcome = self.trajectory.outcome().kind();
        match (self.trajectory.end_of(phase), outcome.is_forever()) {
            (Some(transition), _) => transition.cause.label(),
            // Only the last phase ends without an event: one without end at the time limit, if
            // any, and others where the outcome stops the motion.
            (None, true) if phase.end().is_none() => "never",
            (None, true) => OutcomeKind::TimeLimit.label(),
            (None, false) => outcome.label(),
        }
    }

    /// The impact that ends phase `index`, before which there are no more transitions than phases
    /// and a jam.
    fn shown(&self, index: usize, transition: &Transition) -> Option<ShownImpact> {
        ShownImpact::of(self.trajectory.hoop(), index + 1, transition)
    }

    /// Energy that the impact at the end of phase `index` has lost.
    fn lost(&self, index: usize, transition: &Transition) -> f64 {
        self.shown(index, transition)
            .map_or(0.0, |impact| impact.energy_lost)
    }

    /// An impact, with the state before it: that after it is in the next row.
    fn impact(&self, index: usize, transition: &Transition) -> Option<Row> {
        let shown = self.shown(index, transition)?;
        let impact = transition.impact?;
        let name = if transition.cause == Cause::Jam {
            "jam"
        } else {
            "impact"
        };
        Some(self.row(Line {
            mode: None,
            number: String::new(),
            motion: name.to_owned(),
            state: State {
                slip: shown.before.slip,
                ..transition.before
            },
            duration: None,
            lost: shown.energy_lost,
            ends_by: impact.case.label(),
            folds: None,
        }))
    }

    fn row(&self, line: Line) -> Row {
        let cell = |dimension, value| column(self.scale.value(dimension, value));
        let state = line.state;
        let duration = line.duration.map(|it| cell(Dimension::Time, it));
        let cells = vec![
            line.number,
            line.motion,
            cell(Dimension::Time, state.time),
            duration.unwrap_or_default(),
            column(state.theta),
            cell(Dimension::AngularRate, state.theta_rate),
            cell(Dimension::Velocity, state.slip),
            cell(Dimension::Energy, line.lost),
            line.ends_by.to_owned(),
        ];
        Row {
            mode: line.mode,
            time: Some(state.time),
            folds: line.folds,
            cells,
        }
    }
}

/// What a row says.
struct Line {
    mode: Option<Mode>,
    number: String,
    motion: String,
    state: State,
    /// None of an impact.
    duration: Option<f64>,
    lost: f64,
    ends_by: &'static str,
    /// Phases that it stands for together.
    folds: Option<usize>,
}
