//! Problems from setups, whatever the order in which numbers cross the boundary.

use littlewood::si::SiSetup;
use littlewood::tables::{Quantity, Setup};
use littlewood_web::{Problem, dimensionless_quantities, si_quantities};

/// The numbers of a setup as the page gives them.
pub(crate) fn numbers(setup: &Setup) -> Vec<f64> {
    let value = |quantity: Quantity| setup.get(quantity).unwrap();
    dimensionless_quantities().map(value).collect()
}

/// The numbers of a setup in SI units as the page gives them.
pub(crate) fn si_numbers(setup: &SiSetup) -> Vec<f64> {
    let value = |quantity: Quantity| setup.get(quantity).unwrap();
    si_quantities().map(value).collect()
}

/// A problem without dimension.
pub(crate) fn problem_of(setup: &Setup, until: Option<f64>) -> Problem {
    let restitution = setup.hoop.restitution;
    let law = setup.hoop.restitution_law.map(|law| law.name().to_owned());
    Problem::dimensionless(&numbers(setup), restitution, law, until).unwrap()
}
