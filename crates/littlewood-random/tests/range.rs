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

/// Coefficients of rolling resistance of each size come, none at all and the bound; and hoops at
/// rest and in a skid at an edge, where what turns them equals what resists.
#[test]
fn resistance_is_drawn_at_every_size_and_at_the_edges() {
    let mut decades = BTreeSet::new();
    let (mut at_edge, mut seen) = ([0; 2], [false; 2]);
    for number in 0..20_000 {
        let (hoop, start) = Draw::of_case(3, 2, number).resisted_in_contact();
        let chi = hoop.rolling_resistance();
        if chi == 0.0 {
            seen[0] = true;
            continue;
        }
        seen[1] |= Quantity::RollingResistance.check(chi.next_up()).is_err();
        decades.insert(libm::floor(libm::log10(chi)) as i32);
        if start.theta_rate == 0.0 && start.gap_rate == 0.0 {
            let (sin, cos) = libm::sincos(start.theta);
            let (arm, lever) = (hoop.h() * sin, 1.0 + hoop.h() * cos);
            let pull = if start.slip == 0.0 {
                libm::tan(hoop.slope())
            } else {
                -hoop.mu_k().copysign(start.slip)
            };
            let turns = (arm + lever * pull).abs();
            if (turns - chi).abs() < 1e-8 * (arm.abs() + lever * pull.abs()) {
                at_edge[usize::from(start.slip != 0.0)] += 1;
            }
        }
    }
    assert!(
        (-12..=8).all(|decade| decades.contains(&decade)),
        "{decades:?}"
    );
    assert_eq!(seen, [true; 2]);
    assert!(at_edge.iter().all(|count| *count > 100), "{at_edge:?}");
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
