//! What a report is about, apart from the motion itself.

use littlewood::cases::NamedCase;
use littlewood::derivatives::Derivatives;
use littlewood::si::Units;
use littlewood::{Digits, Start};

use crate::Uncertainty;

/// What was asked for: the case, the start, and whether results are wanted in SI units too.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The case that the problem starts from, if any.
    pub case: Option<&'static NamedCase>,
    /// The start as it was given.
    pub start: Start,
    /// Units, if results are wanted in SI units too.
    pub units: Option<&'a Units>,
    /// How many digits of each transition can be trusted, if that is wanted.
    pub digits: Option<&'a [Option<Digits>]>,
    /// The derivatives of the motion, if they are wanted.
    pub derivatives: Option<&'a Derivatives>,
    /// The standard errors of the motion, if those of its numbers are given.
    pub uncertainty: Option<&'a Uncertainty>,
}

impl Subject<'_> {
    /// A start alone, without dimension.
    #[must_use]
    pub const fn of_start(start: Start) -> Self {
        Self {
            case: None,
            start,
            units: None,
            digits: None,
            derivatives: None,
            uncertainty: None,
        }
    }

    /// A named case without dimension.
    #[must_use]
    pub const fn of_case(case: &'static NamedCase) -> Self {
        Self {
            case: Some(case),
            ..Self::of_start(case.setup.start)
        }
    }
}
