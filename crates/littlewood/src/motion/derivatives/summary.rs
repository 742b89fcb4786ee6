//! The derivatives of the numbers of a summary.

use crate::math::number::{Dual, Number};
use crate::model::Mode;
use crate::modes::PhaseSolution;
use crate::motion::columns::{DerivativeColumn, SummaryColumn, SummaryValue};
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{Cause, Transition};

use super::tangents::{Instant, Passed, Tangents};
use super::{Derivative, NoDerivative, NotDifferentiable};

impl Trajectory {
    /// Derivatives of numbers of the summary; NaN where one does not exist, or the number is
    /// absent.
    ///
    /// # Errors
    /// As [`Trajectory::derivatives`].
    pub fn summary_derivatives(
        &self,
        columns: &[DerivativeColumn],
    ) -> Result<Vec<f64>, NotDifferentiable> {
        let mut quantities: Vec<_> = columns.iter().map(|column| column.quantity).collect();
        quantities.sort_unstable();
        quantities.dedup();
        let derivatives = self.derivatives(&quantities)?;
        let value = |column: &DerivativeColumn| {
            let row = SummaryColumn::reals().position(|number| number == column.number)?;
            let place = quantities.binary_search(&column.quantity).ok()?;
            derivatives.summary()[row][place].ok()
        };
        Ok(columns
            .iter()
            .map(|column| value(column).unwrap_or(f64::NAN))
            .collect())
    }
}

/// The numbers of [`SummaryColumn::reals`], of a motion with these events and this end.
pub(super) fn of<const K: usize>(
    walk: &Tangents<'_, K>,
    passed: &[Option<Passed<K>>],
    end: Derivative<Instant<K>>,
) -> Vec<Derivative<Dual<K>>> {
    let summary = walk.motion.summary();
    SummaryColumn::reals()
        .map(|column| {
            let is_absent =
                matches!(column.of(&summary), SummaryValue::F64(value) if value.is_nan());
            if is_absent {
                Ok(absent())
            } else {
                number(walk, passed, end, column)
            }
        })
        .collect()
}

const fn absent<const K: usize>() -> Dual<K> {
    Dual {
        value: f64::NAN,
        parts: [f64::NAN; K],
    }
}

fn number<const K: usize>(
    walk: &Tangents<'_, K>,
    passed: &[Option<Passed<K>>],
    end: Derivative<Instant<K>>,
    column: SummaryColumn,
) -> Derivative<Dual<K>> {
    let Trajectory {
        transitions,
        phases,
        ..
    } = walk.motion;
    let missing = end.err().unwrap_or(NoDerivative::Singular);
    let event = |number: Option<usize>| number.and_then(|number| passed[number]).ok_or(missing);
    let begun = |number: Option<usize>| {
        number
            .and_then(|number| walk.begun.get(number))
            .ok_or(missing)
    };
    let first = |cause| {
        transitions
            .iter()
            .position(|transition| transition.cause == cause)
    };
    let end_number = |place: usize| Ok(walk.numbers(&end?)[place]);
    // The flight that ends in the first landing.
    let landing = first(Cause::Landing);
    let jump = || {
        phases
            .iter()
            .position(|phase| landing.is_some() && phase.ended_by == landing)
    };
    match column {
        SummaryColumn::EndTime => end_number(0),
        SummaryColumn::EndTheta => end_number(1),
        SummaryColumn::EndThetaRate => end_number(2),
        SummaryColumn::EndSlip => end_number(3),
        SummaryColumn::EndX => end_number(4),
        SummaryColumn::Energy => {
            let is_landed = |phase: &&Phase| {
                phase
                    .ended_by
                    .is_some_and(|number| transitions[number].impact.is_some())
            };
            let flight = phases
                .last()
                .filter(|phase| phase.mode() == Mode::Flight && !is_landed(phase));
            if flight.is_some() {
                // The energy of a flight is that of its start.
                let start = begun(phases.len().checked_sub(1))?;
                Ok(walk.energy(&start.at.point, start.gap_rate))
            } else {
                Ok(walk.energy(&end?.point, walk.gap_rate))
            }
        }
        SummaryColumn::FirstSlipTime => Ok(walk.time(&event(first(Cause::Slip))?.before)),
        SummaryColumn::LiftOffTime => {
            Ok(walk.time(&begun(phases.iter().position(|phase| phase.mode() == Mode::Flight))?.at))
        }
        SummaryColumn::JumpLength => {
            Ok((event(landing)?.before.point.x - begun(jump())?.at.point.x).abs())
        }
        SummaryColumn::JumpHeight => {
            let number = jump();
            let (from, solution) = (
                begun(number)?,
                number.map(|number| &phases[number].solution),
            );
            let Some(PhaseSolution::Flight(flight)) = solution else {
                return Err(missing);
            };
            let (at, _) = flight.apex();
            // At the highest point the gap has no rate: the derivative of the height is that at a
            // fixed time.
            Ok(walk
                .plane
                .gap(
                    (&from.at.point, from.gap_rate, flight.lifts_off()),
                    Dual::constant(at),
                )
                .0)
        }
        SummaryColumn::ImpactEnergyLost => {
            let lost = (0..transitions.len()).map(|number| Ok(-event(Some(number))?.work));
            let sum = lost.reduce(|sum, lost| Ok(sum? + lost?));
            Ok(walk.difference(sum.unwrap_or(Ok(Dual::constant(0.0)))?))
        }
        SummaryColumn::SettleTime => {
            let lands = |transition: &Transition| {
                let modes = (
                    transition.from == Some(Mode::Flight),
                    transition.to == Some(Mode::Flight),
                );
                transition.impact.is_some() && modes == (true, false)
            };
            Ok(walk.time(&event(transitions.iter().rposition(lands))?.before))
        }
        SummaryColumn::Outcome
        | SummaryColumn::Sequence
        | SummaryColumn::Transitions
        | SummaryColumn::Painleve
        | SummaryColumn::Landings => Ok(absent()),
    }
}
