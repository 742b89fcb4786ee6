//! Transitions.

use littlewood::derivatives::Derivatives;
use littlewood::impact::Impact;
use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension, SampleColumn};
use littlewood::{Digits, Direction, Mode, Transition};
use serde::Serialize;

use super::derivatives::{DerivativesRecord, of_transition};
use super::digits::object;
use super::fields::{Fields, Value};
use super::impact::ImpactRecord;
use super::instant::{si_state, state};

/// What changes at a transition: the mode that ends, the mode that begins and its σ, and the event.
pub(crate) fn edge(
    from: Option<Mode>,
    to: Option<Mode>,
    direction: Option<Direction>,
    cause: Option<&'static str>,
) -> Fields {
    [("from", from.into()), ("to", to.into()), ("direction", direction.into()), ("cause", Value::Word(cause))]
        .into_iter()
        .collect()
}

/// The edge that a transition takes.
pub(crate) fn edge_of(transition: &Transition) -> Fields {
    edge(transition.from, transition.to, transition.direction, Some(transition.cause.name()))
}

/// A transition. The state is that just after it; where the velocities jump, the impact has those before.
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
            (SampleColumn::ThetaRate.name(), Detail::Real(impact.after.theta_rate, Dimension::AngularRate)),
            (SampleColumn::Slip.name(), Detail::Real(impact.after.slip, Dimension::Velocity)),
        ];
        Self {
            plain: JumpRecord { after: Fields::of_details(after), impact: Some(ImpactRecord::new(impact)) },
            si: units.map(|units| JumpRecord {
                after: Fields::of_si_details(units, after),
                impact: Some(ImpactRecord::in_si(units, impact)),
            }),
            digits: None,
            derivatives: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use littlewood::cases::find_case;
    use littlewood::{Hoop, RestitutionLaw};

    use super::*;

    #[test]
    fn only_a_jump_of_the_velocities_has_an_impact() -> Result<(), Box<dyn std::error::Error>> {
        let case = find_case("figure-3").ok_or("a named case")?;
        let landing = *case.simulate()?.transitions().last().ok_or("the landing")?;
        let text = serde_json::to_value(TransitionRecord::new(&landing, None, None, None))?;
        assert_eq!(text.get("impact"), None);
        assert_eq!(text["slip"], landing.before.slip);

        let hoop = Hoop::new(case.setup.hoop.with_restitution(0.5, RestitutionLaw::Energetic))?;
        let motion = hoop.simulate(case.setup.start, littlewood::Limits::default())?;
        let landing = motion.transitions().iter().find(|it| it.impact.is_some()).ok_or("a landing")?;
        let text = serde_json::to_value(TransitionRecord::new(landing, None, None, None))?;
        assert_eq!(text["slip"].as_f64(), Some(0.0));
        assert_eq!(text["to"], "flight");
        let impact = &text["impact"];
        assert_eq!(impact["case"], "sticks_in_restitution");
        let near = |name: &str, expected: f64| {
            let value = impact[name].as_f64().unwrap_or(f64::NAN);
            assert!((value - expected).abs() < 1e-12, "{name}: {value}");
        };
        near("gap_rate", 0.978_517_419_970_790_8);
        near("energy_lost", 3.362_443_419_227_28);
        assert_eq!(impact["before"]["slip"].as_f64(), Some(landing.before.slip));
        assert_eq!(impact["before"]["theta_rate"].as_f64(), Some(landing.before.theta_rate));
        assert!(
            (impact["before"]["gap_rate"].as_f64().unwrap_or(0.0) + 1.913_012_569_038_374_7).abs() < 1e-12
        );
        Ok(())
    }
}
