//! What is drawn has every size, and differs.

use std::collections::BTreeSet;

use littlewood::tables::Quantity;
use littlewood_random::Draw;

/// Each decade of a quantity with a bound comes, the largest and the smallest, and no number beyond
/// the bound.
#[test]
fn every_size_is_drawn() {
    for (quantity, top) in [
        (Quantity::Theta, 9),
        (Quantity::ThetaRate, 6),
        (Quantity::Slip, 6),
        (Quantity::Inertia, 9),
        (Quantity::MassRatio, 9),
    ] {
        let mut draw = Draw::of_case(1, 0, u64::from(quantity.code()));
        let mut decades = BTreeSet::new();
        for _ in 0..20_000 {
            let value = draw.allowed(quantity);
            assert!(quantity.check(value).is_ok(), "{quantity} {value}");
            if value != 0.0 {
                decades.insert(libm::floor(libm::log10(value.abs())) as i32);
            }
        }
        assert!(
            (-12..=top).all(|decade| decades.contains(&decade)),
            "{quantity}: {decades:?}"
        );
    }
}

/// Most differ, though bounds and ties are drawn again and again.
#[test]
fn motions_differ() {
    let drawn: BTreeSet<String> = (0..1000)
        .map(|number| {
            let (hoop, start) = Draw::of_case(7, 1, number).heavy_motion();
            format!("{hoop:?} {start:?}")
        })
        .collect();
    assert!(drawn.len() > 990, "{}", drawn.len());
}
