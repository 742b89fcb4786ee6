//! `littlewood threshold`: finds the value of a quantity at which the outcome changes.

use littlewood::Hoop;
use littlewood::tables::{Quantity, Setup};
use littlewood::thresholds::{ClassAt, SearchRange, Searched, Threshold};
use serde_json::{Value, json};

use crate::args::{ThresholdArgs, ThresholdOf};
use crate::error::Error;
use crate::output::print;
use crate::problem::Problem;
use crate::report;
use crate::request::Request;

pub(crate) fn run(args: &ThresholdArgs) -> Result<(), Error> {
    let problem = Problem::resolve(Request::new(&args.problem, Some(&args.run))?)?;
    let quantity = args.of.quantity;
    let mut setup = Setup::new(problem.hoop.parameters(), problem.start);
    let range = range(&args.of, setup.get(quantity))?;
    setup.set(quantity, range.near);
    Hoop::new(setup.hoop)
        .and_then(|hoop| hoop.classify(setup.start))
        .map_err(|error| Error::Value { error })?;
    let found = range.of_motion(&setup, quantity, problem.limits);
    print(
        args.format,
        None,
        || report::table::threshold(&problem, quantity, found),
        |writer| report::json::write(writer, &document(&problem, quantity, found)),
    )
}

/// Where to search: in the range that was typed, else in the usual one of the quantity.
fn range(of: &ThresholdOf, value: Option<f64>) -> Result<SearchRange, Error> {
    match of.ends {
        Some([first, last]) => {
            SearchRange::between(of.quantity, first, last).map_err(|error| Error::Value { error })
        }
        None => Ok(SearchRange::usual(of.quantity, value)),
    }
}

fn document(problem: &Problem, quantity: Quantity, found: Result<Threshold, Searched>) -> Value {
    let side = |ClassAt { value, class }: ClassAt| json!({"value": value, "class": class.name()});
    let threshold = found.ok().map(|found| {
        json!({
            "below": side(found.below),
            "above": side(found.above),
            "unresolved_between": found.has_unresolved_between,
        })
    });
    let searched = found
        .err()
        .map(|searched| json!({"from": searched.from, "to": searched.to, "step": searched.step}));
    json!({
        "case": problem.case.map(|case| case.name),
        "quantity": quantity.name(),
        "threshold": threshold,
        "searched": searched,
    })
}
