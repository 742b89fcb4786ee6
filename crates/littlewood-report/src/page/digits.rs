//! How many digits of each transition can be trusted.

use littlewood::tables::{Dimension, Quantity};
use littlewood::{Digits, State, Trajectory};

use crate::record::digits_of;
use crate::scale::Scale;

/// Digits from which on an estimate needs no word.
const MOST_DIGITS: u8 = 13;

/// Lines at most.
const MOST_LINES: usize = 12;

/// Transitions of which some number has lost digits, at most so many, and the first that the start
/// does not decide.
pub(super) fn trusted(
    trajectory: &Trajectory,
    digits: &[Option<Digits>],
    scale: Scale<'_>,
) -> Vec<String> {
    let decided = digits.iter().take_while(|at| at.is_some()).count();
    let all = decided == digits.len();
    let at = |index: usize| {
        trajectory
            .transitions()
            .get(index)
            .map_or_else(String::new, |it| {
                let time = scale.show(Dimension::Time, it.time());
                format!(
                    "{} at {} = {time}",
                    it.cause.label(),
                    scale.sign(Quantity::Time)
                )
            })
    };
    let poor = digits.iter().enumerate().filter_map(|(index, digits)| {
        let digits = digits.filter(|digits| digits.least() < MOST_DIGITS)?;
        let numbers = State::COLUMNS.into_iter().zip(digits_of(&digits));
        let numbers: Vec<String> = numbers
            .map(|(column, digits)| format!("{} {digits}", scale.column_sign(column)))
            .collect();
        Some(format!("{}: {}", at(index), numbers.join("  ")))
    });
    let mut lines = Vec::from_iter(poor);
    let hidden = lines.len().saturating_sub(MOST_LINES);
    lines.truncate(MOST_LINES);
    if hidden > 0 {
        lines.push(format!("… {hidden} more"));
    }
    if lines.is_empty() && decided > 0 {
        lines.push(format!(
            "at least {MOST_DIGITS} of every number of {decided} transitions"
        ));
    }
    if !all {
        lines.push(format!(
            "not decided by the last digits of the start from here on: {}",
            at(decided)
        ));
    }
    lines
}
