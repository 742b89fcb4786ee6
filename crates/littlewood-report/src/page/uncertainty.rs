//! The standard errors of each transition and of the outcome.

use littlewood::{State, Trajectory};

use crate::number::brief;
use crate::sheet::Sheet;
use crate::{Spread, Uncertainty};

/// Relative difference of the two standard errors from which on the first order is doubted: that of
/// a sample of 10,000 is .7 %.
const DOUBT: f64 = 0.1;

/// Adds a table with two rows for each transition and for the outcome, and what to doubt.
pub(super) fn uncertainty(sheet: &mut Sheet, trajectory: &Trajectory, uncertainty: &Uncertainty) {
    let outcome = trajectory.outcome().kind();
    let events = trajectory.transitions().iter().enumerate();
    let events = events.map(|(index, it)| [(index + 1).to_string(), it.cause.label().to_owned()]);
    let end = outcome
        .last_event()
        .is_none()
        .then(|| [String::new(), outcome.label().to_owned()]);
    let (mut rows, mut doubts): (Vec<Vec<String>>, _) = (Vec::new(), Vec::new());
    for ([number, event], spread) in events.chain(end).zip(&uncertainty.spreads) {
        let named = if number.is_empty() {
            event.clone()
        } else {
            format!("#{number}")
        };
        doubts.extend(doubt(&named, spread, uncertainty.motions));
        let mut add = |place: [String; 2], kind: &str, errors: Option<State>| {
            let numbers = errors.map_or([const { String::new() }; 5], |state| {
                state.numbers().map(brief)
            });
            rows.push(
                place
                    .into_iter()
                    .chain([kind.to_owned()])
                    .chain(numbers)
                    .collect(),
            );
        };
        add([number, event], "first order", spread.first_order);
        add([String::new(), String::new()], "sample", spread.sample);
    }
    super::states(sheet, "errors", '±', rows);
    let Uncertainty { motions, alike, .. } = *uncertainty;
    sheet.note(&format!(
        "standard errors by derivatives, and in a sample of {motions} motions, of which {alike} are alike"
    ));
    for doubt in doubts {
        sheet.note(&doubt);
    }
}

/// What speaks against the first order.
fn doubt(named: &str, spread: &Spread, motions: usize) -> Vec<String> {
    let mut doubts = Vec::new();
    if spread.motions < motions {
        let others = 100.0 * (motions - spread.motions) as f64 / motions as f64;
        doubts.push(format!(
            "warning: {named}: {} % of the motions have had other transitions",
            brief(others)
        ));
    }
    let Some(first_order) = spread.first_order else {
        doubts.push(format!(
            "warning: {named}: without a derivative there is no first order"
        ));
        return doubts;
    };
    let Some(sample) = spread.sample else {
        return doubts;
    };
    let mut pairs = first_order.numbers().into_iter().zip(sample.numbers());
    if pairs.any(|(first, sample)| (first - sample).abs() > DOUBT * first.max(sample)) {
        doubts.push(format!(
            "warning: {named}: the errors are too large for the first order"
        ));
    }
    doubts
}
