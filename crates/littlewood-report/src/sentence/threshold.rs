//! The value of a quantity at which the outcome of a motion changes, in words.

use littlewood::tables::{Number, Quantity};
use littlewood::thresholds::{Searched, Threshold};

use crate::number::brief;

/// What is on either side of a threshold, with all digits.
pub fn threshold(quantity: Quantity, found: &Threshold) -> Vec<String> {
    let Threshold {
        below,
        above,
        has_unresolved_between,
    } = found;
    let at = |value: f64| {
        let digits = Number(value).to_string().replace('-', "−");
        format!("{} = {digits}", quantity.sign())
    };
    let begins = format!("From {} on: {}.", at(above.value), above.class.label());
    if *has_unresolved_between {
        let ends = format!("Up to {}: {}.", at(below.value), below.class.label());
        return vec![ends, begins, "Between them rounding decides.".to_owned()];
    }
    vec![
        format!("Below {}: {}.", at(above.value), below.class.label()),
        format!("From there on: {}.", above.class.label()),
    ]
}

/// How far there is no threshold.
pub fn no_threshold(quantity: Quantity, searched: &Searched) -> String {
    format!(
        "It does not change with {} from {} to {}, in steps of {}.",
        quantity.sign(),
        brief(searched.from),
        brief(searched.to),
        brief(searched.step)
    )
}
