//! The derivatives of the numbers of a summary.

use crate::math::number::{Dual, Number, WIDTH};
use crate::model::Mode;
use crate::modes::PhaseSolution;
use crate::motion::columns::{DerivativeColumn, SummaryColumn, SummaryValue};
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{Cause, Transition};

use super::flow::FlightStart;
use super::tangents::{Begun, EventJump, Instant, Tangents};
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

/// Whether a number is that of the end of the motion.
pub(super) const fn is_of_end(column: SummaryColumn) -> bool {
    matches!(
        column,
        SummaryColumn::EndTime
            | SummaryColumn::EndTheta
            | SummaryColumn::EndThetaRate
            | SummaryColumn::EndSlip
            | SummaryColumn::EndX
            | SummaryColumn::Energy
    )
}

/// A motion whose phases are passed: its events, and its end.
pub(super) struct PassedMotion<'a> {
    pub(super) walk: &'a Tangents<'a>,
    /// The event of each transition, up to one without a derivative.
    pub(super) events: &'a [Option<EventJump>],
    pub(super) end: Derivative<Instant>,
}

impl PassedMotion<'_> {
    /// The numbers of [`SummaryColumn::reals`].
    pub(super) fn numbers(&self) -> Vec<Derivative<Dual>> {
        let summary = self.walk.motion.summary();
        SummaryColumn::reals()
            .map(|column| {
                let is_absent =
                    matches!(column.of(&summary), SummaryValue::F64(value) if value.is_nan());
                if is_absent {
                    Ok(absent())
                } else {
                    self.number(column)
                }
            })
            .collect()
    }

    fn number(&self, column: SummaryColumn) -> Derivative<Dual> {
        let walk = self.walk;
        match column {
            SummaryColumn::EndTime => self.end_number(0),
            SummaryColumn::EndTheta => self.end_number(1),
            SummaryColumn::EndThetaRate => self.end_number(2),
            SummaryColumn::EndSlip => self.end_number(3),
            SummaryColumn::EndX => self.end_number(4),
            SummaryColumn::Energy => self.energy(),
            SummaryColumn::FirstSlipTime => {
                Ok(walk.time(&self.event(self.first(Cause::Slip))?.before))
            }
            SummaryColumn::LiftOffTime => {
                let mut phases = walk.motion.phases.iter();
                let flight = phases.position(|phase| phase.mode() == Mode::Flight);
                Ok(walk.time(&self.begun(flight)?.at))
            }
            SummaryColumn::JumpLength => {
                let landing = self.event(self.first(Cause::Landing))?;
                Ok((landing.before.point.x - self.begun(self.jump())?.at.point.x).abs())
            }
            SummaryColumn::JumpHeight => self.jump_height(),
            SummaryColumn::ImpactEnergyLost => {
                let lost = (0..walk.motion.transitions.len())
                    .map(|number| Ok(-self.event(Some(number))?.work));
                let sum = lost.reduce(|sum, lost| Ok(sum? + lost?));
                Ok(walk.difference(sum.unwrap_or(Ok(Dual::constant(0.0)))?))
            }
            SummaryColumn::SettleTime => {
                // The last impact after which the hoop does not fly.
                let settles = |transition: &Transition| {
                    transition.impact.is_some()
                        && transition.from == Some(Mode::Flight)
                        && transition.to != Some(Mode::Flight)
                };
                let last = walk.motion.transitions.iter().rposition(settles);
                Ok(walk.time(&self.event(last)?.before))
            }
            SummaryColumn::Outcome
            | SummaryColumn::Sequence
            | SummaryColumn::Transitions
            | SummaryColumn::Painleve
            | SummaryColumn::Landings
            | SummaryColumn::HalfSwings => Ok(absent()),
        }
    }

    /// Why a number has no derivative whose event was not passed.
    fn missing(&self) -> NoDerivative {
        self.end.err().unwrap_or(NoDerivative::Singular)
    }

    /// The event of a transition.
    fn event(&self, number: Option<usize>) -> Derivative<EventJump> {
        number
            .and_then(|number| self.events[number])
            .ok_or_else(|| self.missing())
    }

    /// The start of a phase.
    fn begun(&self, number: Option<usize>) -> Derivative<&Begun> {
        number
            .and_then(|number| self.walk.begun.get(number))
            .ok_or_else(|| self.missing())
    }

    /// The first transition with a cause.
    fn first(&self, cause: Cause) -> Option<usize> {
        let mut transitions = self.walk.motion.transitions.iter();
        transitions.position(|transition| transition.cause == cause)
    }

    /// The flight that ends in the first landing.
    fn jump(&self) -> Option<usize> {
        let landing = self.first(Cause::Landing)?;
        let mut phases = self.walk.motion.phases.iter();
        phases.position(|phase| phase.ended_by == Some(landing))
    }

    fn end_number(&self, place: usize) -> Derivative<Dual> {
        Ok(self.walk.numbers(&self.end?)[place])
    }

    fn energy(&self) -> Derivative<Dual> {
        let Trajectory {
            transitions,
            phases,
            ..
        } = self.walk.motion;
        let is_landed = |phase: &Phase| {
            phase
                .ended_by
                .is_some_and(|number| transitions[number].impact.is_some())
        };
        let flies = phases
            .last()
            .is_some_and(|phase| phase.mode() == Mode::Flight && !is_landed(phase));
        if flies {
            // The energy of a flight is that of its start.
            let start = self.begun(phases.len().checked_sub(1))?;
            Ok(self.walk.energy(&start.at.point, start.gap_rate))
        } else {
            Ok(self.walk.energy(&self.end?.point, self.walk.gap_rate))
        }
    }

    fn jump_height(&self) -> Derivative<Dual> {
        let number = self.jump();
        let begun = self.begun(number)?;
        let solution = number.map(|number| &self.walk.motion.phases[number].solution);
        let Some(PhaseSolution::Flight(flight)) = solution else {
            return Err(self.missing());
        };
        let start = FlightStart {
            point: begun.at.point,
            gap_rate: begun.gap_rate,
            lifts_off: flight.lifts_off(),
        };
        // At the highest point the gap has no rate: the derivative of the height is that at a fixed
        // time.
        let (time, _) = flight.apex();
        let (height, _) = self.walk.plane.gap(&start, Dual::constant(time));
        Ok(height)
    }
}

const fn absent() -> Dual {
    Dual {
        value: f64::NAN,
        parts: [f64::NAN; WIDTH],
    }
}
