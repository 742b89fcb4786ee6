//! Transitions.

use littlewood::{Direction, Impulse, Mode, SampleColumn, State, Transition, Units};
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
    edge(Some(transition.from), transition.to, transition.direction, transition.cause.name())
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

/// The impulse of the plane, and the velocities before it.
#[derive(Debug, Serialize)]
struct ImpactRecord {
    normal_impulse: f64,
    friction_impulse: f64,
    before: Fields,
}

impl ImpactRecord {
    fn new(impulse: Impulse, before: &State) -> Self {
        let velocities = State::COLUMNS
            .into_iter()
            .zip(before.numbers())
            .filter(|(column, _)| matches!(column, SampleColumn::ThetaRate | SampleColumn::Slip));
        Self {
            normal_impulse: impulse.normal,
            friction_impulse: impulse.friction,
            before: velocities.map(|(column, value)| (column.name(), Value::Real(value))).collect(),
        }
    }
}

impl TransitionRecord {
    pub(crate) fn new(transition: &Transition, units: Option<&Units>) -> Self {
        Self {
            state: state(&transition.after),
            edge: edge_of(transition),
            impact: transition.impulse.map(|impulse| ImpactRecord::new(impulse, &transition.before)),
            si: units.map(|units| si_state(units, &transition.after)),
        }
    }
}

#[cfg(test)]
mod tests {
    use littlewood::find_case;

    use super::*;

    #[test]
    fn only_a_jump_of_the_velocities_has_an_impact() -> Result<(), Box<dyn std::error::Error>> {
        let case = find_case("figure-3").ok_or("a named case")?;
        let motion = case.simulate()?;
        let mut landing = *motion.transitions().last().ok_or("the landing")?;
        let text = serde_json::to_value(TransitionRecord::new(&landing, None))?;
        assert_eq!(text.get("impact"), None);
        assert_eq!(text["slip"], landing.before.slip);

        landing.impulse = Some(Impulse { normal: 1.5, friction: -0.5 });
        landing.after.slip = 0.25;
        landing.after.theta_rate = -0.75;
        let text = serde_json::to_value(TransitionRecord::new(&landing, None))?;
        assert_eq!((text["slip"].as_f64(), text["theta_rate"].as_f64()), (Some(0.25), Some(-0.75)));
        let impact = &text["impact"];
        assert_eq!(impact["normal_impulse"].as_f64(), Some(1.5));
        assert_eq!(impact["friction_impulse"].as_f64(), Some(-0.5));
        assert_eq!(impact["before"]["slip"].as_f64(), Some(landing.before.slip));
        assert_eq!(impact["before"]["theta_rate"].as_f64(), Some(landing.before.theta_rate));
        Ok(())
    }
}
