//! Links of the page.

use littlewood::RestitutionLaw;
use littlewood::tables::Quantity;
use littlewood_report::link::{self, Link, VIEW};
use serde_json::{Map, Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::given;

/// What a link says, as JSON: the problem, the instant, the view, and what could not be read.
/// `shown` is the link of what the page shows. A number that is missing is null.
#[wasm_bindgen(js_name = readLink)]
pub fn read_link(fragment: &str, shown: &str) -> String {
    let read = Link::read(fragment, shown);
    let Link { problem, at, view } = read.link;
    let limit = if problem.is_si {
        Quantity::UntilS
    } else {
        Quantity::Until
    };
    let values: Map<String, Value> = problem
        .values
        .iter()
        .map(|(quantity, value)| (quantity.name().to_owned(), json!(value)))
        .collect();
    let view: Map<String, Value> = VIEW
        .iter()
        .zip(view)
        .map(|((key, ..), says)| ((*key).to_owned(), json!(says)))
        .collect();
    let errors: Vec<Value> = read
        .refusals
        .iter()
        .map(|it| json!({ "field": it.key, "given": it.text, "message": it.reason }))
        .collect();
    json!({
        "system": if problem.is_si { "si" } else { "dimensionless" },
        "values": values,
        (Quantity::Restitution.name()): problem.get(Quantity::Restitution),
        "law": problem.law.map(RestitutionLaw::name),
        "until": problem.get(limit),
        "at": at,
        "view": view,
        "errors": errors,
    })
    .to_string()
}

/// The link of a problem that has been checked: its numbers in the order of `problem`, what may be
/// left out, the instant, and what each key of the view says.
#[wasm_bindgen(js_name = writeLink)]
pub fn write_link(
    is_si: bool,
    numbers: &[f64],
    restitution: Option<f64>,
    law: Option<String>,
    until: Option<f64>,
    at: Option<f64>,
    view: Vec<String>,
) -> String {
    let law = law.and_then(|law| law.parse().ok());
    let problem = given(is_si, numbers, restitution, law, until);
    let mut link = Link {
        at,
        ..Link::of(problem)
    };
    for ((says, given), (_, choices, _)) in link.view.iter_mut().zip(view).zip(VIEW) {
        *says = choices
            .iter()
            .find(|choice| **choice == given)
            .copied()
            .unwrap_or(says);
    }
    link.to_string()
}

/// A number as people and programs write it; none for anything else.
#[wasm_bindgen(js_name = readNumber)]
pub fn read_number(text: &str) -> Option<f64> {
    link::read_number(text)
}
