//! The motions that the paper shows or speaks of, by name.

use core::f64::consts::FRAC_PI_2;

use crate::error::ParameterError;
use crate::hoop::{Hoop, HoopParameters};
use crate::simulate::Limits;
use crate::state::Start;
use crate::trajectory::Trajectory;

/// A motion of the paper: a hoop and a start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedCase {
    /// Name, as the command line takes it.
    pub name: &'static str,
    /// What the motion does.
    pub title: &'static str,
    /// Where the paper has it.
    pub source: &'static str,
    /// Hoop.
    pub hoop: HoopParameters,
    /// Start.
    pub start: Start,
}

impl NamedCase {
    /// The motion to its final outcome.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn simulate(&self) -> Result<Trajectory, ParameterError> {
        Hoop::new(self.hoop)?.simulate(self.start, Limits::default())
    }
}

/// The case of this name.
#[must_use]
pub fn find_case(name: &str) -> Option<&'static NamedCase> {
    CASES.iter().find(|case| case.name == name)
}

const fn thin_hoop(mu_s: f64, mu_k: f64) -> HoopParameters {
    HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s, mu_k }
}

const fn littlewood_hoop(mu_s: f64, mu_k: f64) -> HoopParameters {
    HoopParameters { mass_ratio: 0.0, offset: 1.0, inertia: 0.0, mu_s, mu_k }
}

/// All cases.
pub const CASES: &[NamedCase] = &[
    NamedCase {
        name: "figure-3",
        title: "slides, rolls, slides, then jumps",
        source: "Figure 3",
        hoop: thin_hoop(0.5, 0.4),
        start: Start::at(FRAC_PI_2, 2.0),
    },
];
