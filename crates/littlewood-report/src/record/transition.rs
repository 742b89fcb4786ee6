//! Transitions.

use littlewood::derivatives::Derivatives;
use littlewood::impact::Impact;
use littlewood::si::Units;
use littlewood::tables::SampleColumn;
use littlewood::{Digits, Mode, SlipDirection, State, Transition};
use serde::Serialize;

use super::derivatives::{DerivativesRecord, of_transition};
use super::fields::{Fields, Value};
use super::impact::{ImpactRecord, number};
use super::instant::{si_state, state};

/// What changes at a transition: the mode that ends, the mode that begins and its σ, and the event.
pub(crate) fn edge(
    from: Option<Mode>,
    to: Option<Mode>,
    direction: Option<SlipDirection>,
    cause: Option<&'static str>,
) -> Fields {
    Fields::from_iter([
        ("from", from.into()),
        ("to", to.into()),
        ("direction", direction.into()),
        ("cause", Value::Word(cause)),
    ])
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
            number(SampleColumn::ThetaRate, impact.after.theta_rate),
            number(SampleColumn::Slip, impact.after.slip),
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

/// The digits of the numbers of a state, in the order of [`State::COLUMNS`].
pub(crate) fn digits_of(digits: &Digits) -> [u8; 5] {
    [
        digits.time,
        digits.theta,
        digits.theta_rate,
        digits.slip,
        digits.x,
    ]
}

/// How many digits can be trusted, each under the name of its number.
fn object(digits: &Digits) -> Fields {
    let columns = State::COLUMNS.into_iter().zip(digits_of(digits));
    columns
        .map(|(column, digits)| (column.name(), Value::Count(digits.into())))
        .collect()
}

/// The same as columns: empty where there is no transition, 0 where the start does not decide what
/// happens.
pub(crate) fn digit_columns(digits: Option<&Option<Digits>>) -> Fields {
    let counts = digits.map(|digits| digits.as_ref().map_or([0; 5], digits_of));
    let columns = State::COLUMNS.into_iter().enumerate();
    columns
        .map(|(n, column)| {
            let value = counts.map_or(Value::Word(None), |it| Value::Count(it[n].into()));
            (format!("{}_digits", column.name()), value)
        })
        .collect()
}
