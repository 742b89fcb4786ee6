//! Transitions.

use littlewood::derivatives::Derivatives;
use littlewood::impact::Impact;
use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension, SampleColumn};
use littlewood::{Digits, Mode, SlipDirection, Transition};
use serde::Serialize;

use super::derivatives::{DerivativesRecord, of_transition};
use super::fields::{Fields, Value};
use super::impact::ImpactRecord;
use super::instant::{si_state, state};

/// What changes at a transition: the mode that ends, the mode that begins and its σ, and the event.
pub(crate) fn edge(
    from: Option<Mode>,
    to: Option<Mode>,
    direction: Option<SlipDirection>,
    cause: Option<&'static str>,
) -> Fields {
    [
        ("from", from.into()),
        ("to", to.into()),
        ("direction", direction.into()),
        ("cause", Value::Word(cause)),
    ]
    .into_iter()
    .collect()
}

/// The edge that a transition takes.
pub(crate) fn edge_of(transition: &Transition) -> Fields {
    edge(
        transition.from,
        transition.to,
        transition.direction,
        Some(transition.cause.name()),
    )
}

/// A transition. The state is that just after it; where the velocities jump, the impact has those
/// before.
#[derive(Debug, Serialize)]
pub(crate) struct TransitionRecord {
    #[serde(flatten)]
    plain: JumpRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<JumpRecord>,
    /// `null` where the start does not decide what happens.
    #[serde(skip_serializing_if = "Option::is_none")]
    digits: Option<Option<Fields>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    derivatives: Option<DerivativesRecord>,
}

/// What is known just after an impact, and the impact, if there is one; in one system of units.
#[derive(Debug, Serialize)]
struct JumpRecord {
    #[serde(flatten)]
    after: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    impact: Option<ImpactRecord>,
}

impl TransitionRecord {
    pub(crate) fn new(
        transition: &Transition,
        units: Option<&Units>,
        digits: Option<&Option<Digits>>,
        derivatives: Option<(&Derivatives, usize)>,
    ) -> Self {
        let impact = transition.impact.as_ref();
        let after = &transition.after;
        Self {
            plain: JumpRecord {
                after: state(after).followed_by(edge_of(transition)),
                impact: impact.map(ImpactRecord::new),
            },
            si: units.map(|units| JumpRecord {
                after: si_state(units, after),
                impact: impact.map(|impact| ImpactRecord::in_si(units, impact)),
            }),
            digits: digits.map(|digits| digits.as_ref().map(object)),
            derivatives: derivatives.and_then(|(all, index)| of_transition(all, index)),
        }
    }

    /// The jam that follows a start, of which the rest is told elsewhere.
    pub(crate) fn of_jam(impact: &Impact, units: Option<&Units>) -> Self {
        let after = [
            (
                SampleColumn::ThetaRate.name(),
                Detail::Real(impact.after.theta_rate, Dimension::AngularRate),
            ),
            (
                SampleColumn::Slip.name(),
                Detail::Real(impact.after.slip, Dimension::Velocity),
            ),
        ];
        Self {
            plain: JumpRecord {
                after: Fields::of_details(after),
                impact: Some(ImpactRecord::new(impact)),
            },
            si: units.map(|units| JumpRecord {
                after: Fields::of_si_details(units, after),
                impact: Some(ImpactRecord::in_si(units, impact)),
            }),
            digits: None,
            derivatives: None,
        }
    }
}

/// The estimates with the numbers that they belong to; none where the start does not decide what
/// happens.
fn named(digits: Option<&Digits>) -> [(SampleColumn, Option<u8>); 5] {
    [
        (SampleColumn::Time, digits.map(|digits| digits.time)),
        (SampleColumn::Theta, digits.map(|digits| digits.theta)),
        (
            SampleColumn::ThetaRate,
            digits.map(|digits| digits.theta_rate),
        ),
        (SampleColumn::Slip, digits.map(|digits| digits.slip)),
        (SampleColumn::X, digits.map(|digits| digits.x)),
    ]
}

/// How many digits can be trusted, each under the name of its number.
fn object(digits: &Digits) -> Fields {
    named(Some(digits))
        .into_iter()
        .map(|(column, digits)| {
            (
                column.name(),
                Value::Count(usize::from(digits.unwrap_or(0))),
            )
        })
        .collect()
}

/// The same as columns; empty where there is no transition.
pub(crate) fn digit_columns(digits: Option<&Option<Digits>>) -> Fields {
    named(digits.and_then(Option::as_ref))
        .into_iter()
        .map(|(column, estimate)| {
            let count = estimate.unwrap_or(0);
            let value = digits.map_or(Value::Word(None), |_| Value::Count(usize::from(count)));
            (format!("{}_digits", column.name()), value)
        })
        .collect()
}
