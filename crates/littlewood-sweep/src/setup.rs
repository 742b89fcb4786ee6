//! The quantities of a setup, a hoop with a start, as sweeps name them.

use littlewood::RestitutionLaw;
use littlewood::tables::{Group, Quantity, Setup};

/// All quantities of a setup, in the order of tables: what a motion depends on, then where and when
/// it starts.
pub(crate) fn quantities() -> impl Iterator<Item = Quantity> {
    Quantity::AXES.into_iter().chain(places())
}

/// The quantities of a start that no motion depends on: where and when it is.
pub(crate) fn places() -> impl Iterator<Item = Quantity> {
    Quantity::START
        .into_iter()
        .filter(|quantity| !Quantity::AXES.contains(quantity))
}

/// Those of [`quantities`] that a setup gives a value; of the hoop none that goes without saying.
pub(crate) fn given(setup: &Setup) -> impl Iterator<Item = (Quantity, f64)> {
    let is_listed = |(quantity, value): &(Quantity, f64)| {
        quantity.group() != Group::Hoop || !quantity.goes_without_saying(*value)
    };
    quantities()
        .filter_map(|quantity| Some((quantity, setup.get(quantity)?)))
        .filter(is_listed)
}

/// The law of restitution of a hoop, under the name that descriptions use.
pub(crate) const RESTITUTION_LAW: &str = "restitution_law";

/// What defines a hoop: the bits of its parameters, and the law of restitution.
pub(crate) type HoopBits = ([u64; Quantity::HOOP.len()], Option<RestitutionLaw>);

/// The bits of the parameters of the hoop: setups that agree in them share one engine.
pub(crate) fn hoop_bits(setup: &Setup) -> HoopBits {
    (
        setup.values(Quantity::HOOP).map(f64::to_bits),
        setup.hoop.restitution_law,
    )
}
