//! The direction of slip as a number.

use littlewood::Direction;

/// σ as a number; 0 where there is no slip.
pub(crate) fn sign(direction: Option<Direction>) -> i8 {
    match direction {
        Some(Direction::Negative) => -1,
        Some(Direction::Positive) => 1,
        None => 0,
    }
}
