//! Transitions.

use littlewood::{Direction, Impact, Mode, SampleColumn, Transition, Units};
use serde::Serialize;

use super::fields::{Fields, Value};
use super::instant::{si_state, state};

/// What changes at a transition: the mode that ends, the mode that begins and its σ, and the event.
pub(crate) fn edge(
    from: Option<Mode>,
    to: Option<Mode>,
    direction: Option<Direction>,
    cause: &'static str,
) -> Fields {
    [
        ("from", from.into()),
        ("to", to.into()),
        ("direction", direction.into()),
        ("cause", Value::Word(Some(cause))),
    ]
    .into_iter()
    .collect()
}

/// The edge that a transition takes.
pub(crate) fn edge_of(transition: &Transition) -> Fields {
    edge(transition.from, transition.to, transition.direction, transition.cause.name())
}

/// A transition. The state is that just after it; where the velocities jump, the impact has those before.
#[derive(Debug, Serialize)]
pub(crate) struct TransitionRecord {
    #[serde(flatten)]
    state: Fields,
    #[serde(flatten)]
    edge: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    impact: Option<ImpactRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<Fields>,
}

/// An impact: its case, the impulse of the plane, the energy lost, the velocities before, and the rate of the gap after.
#[derive(Debug, Serialize)]
struct ImpactRecord {
    case: &'static str,
    normal_impulse: f64,
    friction_impulse: f64,
    energy_lost: f64,
    before: Fields,
    gap_rate: f64,
}

impl ImpactRecord {
    fn new(impact: &Impact) -> Self {
        let before = [
            (SampleColumn::ThetaRate, impact.before.theta_rate),
            (SampleColumn::Slip, impact.before.slip),
            (SampleColumn::GapRate, impact.before.gap_rate),
        ];
        Self {
            case: impact.case.name(),
            normal_impulse: impact.impulse.normal,
            friction_impulse: impact.impulse.friction,
            energy_lost: impact.energy_lost(),
            before: before.into_iter().map(|(column, value)| (column.name(), Value::Real(value))).collect(),
            gap_rate: impact.after.gap_rate,
        }
    }
}

impl TransitionRecord {
    pub(crate) fn new(transition: &Transition, units: Option<&Units>) -> Self {
        Self {
            state: state(&transition.after),
            edge: edge_of(transition),
            impact: transition.impact.as_ref().map(ImpactRecord::new),
            si: units.map(|units| si_state(units, &transition.after)),
        }
    }
}

#[cfg(test)]
mod tests {
    use littlewood::{Hoop, RestitutionLaw, find_case};

    use super::*;

    #[test]
    fn only_a_jump_of_the_velocities_has_an_impact() -> Result<(), Box<dyn std::error::Error>> {
        let case = find_case("figure-3").ok_or("a named case")?;
        let landing = *case.simulate()?.transitions().last().ok_or("the landing")?;
        let text = serde_json::to_value(TransitionRecord::new(&landing, None))?;
        assert_eq!(text.get("impact"), None);
        assert_eq!(text["slip"], landing.before.slip);

        let hoop = Hoop::new(case.setup.hoop.with_restitution(0.5, RestitutionLaw::Energetic))?;
        let motion = hoop.simulate(case.setup.start, littlewood::Limits::default())?;
        let landing = motion.transitions().iter().find(|it| it.impact.is_some()).ok_or("a landing")?;
        let text = serde_json::to_value(TransitionRecord::new(landing, None))?;
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
