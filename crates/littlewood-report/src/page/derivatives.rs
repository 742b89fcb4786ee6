//! The derivatives of each transition and of the outcome.

use littlewood::derivatives::{Derivatives, NoDerivative};
use littlewood::{State, Trajectory};

use crate::number::brief;
use crate::sheet::Sheet;

/// Adds a table with a row for each transition and quantity, and the reasons for those that do not
/// exist.
pub(super) fn derivatives(sheet: &mut Sheet, trajectory: &Trajectory, derivatives: &Derivatives) {
    let mut reasons: Vec<NoDerivative> = Vec::new();
    let mut rows: Vec<Vec<String>> = Vec::new();
    let quantities = || derivatives.quantities().iter();
    let mut add = |place: [String; 2], each: Vec<Result<State, NoDerivative>>| {
        for (quantity, derivative) in quantities().zip(each) {
            let numbers = match derivative {
                Ok(state) => state.numbers().map(brief),
                Err(reason) => {
                    if !reasons.contains(&reason) {
                        reasons.push(reason);
                    }
                    let mut cells = [const { String::new() }; 5];
                    cells[0] = reason.name().replace('_', " ");
                    cells
                }
            };
            let [number, event] = place.clone();
            rows.push(
                [number, event, quantity.sign().to_owned()]
                    .into_iter()
                    .chain(numbers)
                    .collect(),
            );
        }
    };
    for (index, transition) in trajectory.transitions().iter().enumerate() {
        let each = &derivatives.transitions()[index];
        let each = each
            .iter()
            .map(|derivative| derivative.map(|numbers| numbers.after))
            .collect();
        add(
            [(index + 1).to_string(), transition.cause.label().to_owned()],
            each,
        );
    }
    if trajectory.outcome().kind().last_event().is_none() {
        let each = derivatives
            .outcome()
            .iter()
            .map(|derivative| derivative.map(|numbers| numbers.state));
        add(
            [
                String::new(),
                trajectory.outcome().kind().label().to_owned(),
            ],
            each.collect(),
        );
    }
    super::states(sheet, "per", '∂', rows);
    sheet.note("derivatives of the time of each event, and of the state after it, along the event");
    for reason in reasons {
        sheet.note(&format!(
            "{}: {}",
            reason.name().replace('_', " "),
            reason.label()
        ));
    }
}
