//! The quantities of a setup, a hoop with a start, as sweeps name them.

use littlewood::{Quantity, Setup};

/// All quantities of a setup, in the order of tables: what a motion depends on, then where and when it starts.
pub(crate) fn quantities() -> impl Iterator<Item = Quantity> {
    Quantity::AXES.into_iter().chain(places())
}

/// The quantities of a start that no motion depends on: where and when it is.
pub(crate) fn places() -> impl Iterator<Item = Quantity> {
    Quantity::START.into_iter().filter(|quantity| !Quantity::AXES.contains(quantity))
}

/// The value of one of [`quantities`].
pub(crate) fn value(setup: &Setup, quantity: Quantity) -> f64 {
    let [value] = setup.values([quantity]);
    value
}

/// The bits of the parameters of the hoop.
pub(crate) type HoopBits = [u64; Quantity::HOOP.len()];

/// The bits of the parameters of the hoop: setups that agree in them share one engine.
pub(crate) fn hoop_bits(setup: &Setup) -> HoopBits {
    setup.values(Quantity::HOOP).map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_of_a_hoop_and_a_start_is_there_once() {
        let listed: Vec<Quantity> = quantities().collect();
        for quantity in Quantity::HOOP.into_iter().chain(Quantity::START) {
            assert_eq!(listed.iter().filter(|&&other| other == quantity).count(), 1, "{quantity}");
        }
        assert_eq!(listed.len(), Quantity::HOOP.len() + Quantity::START.len());
        assert_eq!(listed[..Quantity::AXES.len()], Quantity::AXES);
    }
}
