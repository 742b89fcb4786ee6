//! Ticks are round, and as many as there is room for.

use core::f64::consts::PI;

use littlewood_style::ticks::{Tick, angular, logarithmic, round};

fn labels(ticks: &[Tick]) -> Vec<&str> {
    ticks.iter().map(|tick| tick.label.as_str()).collect()
}

#[test]
fn angles_have_multiples_of_pi() {
    let ticks = angular(-PI, PI, 6);
    assert_eq!(labels(&ticks), ["−π", "−π/2", "0", "π/2", "π"]);
    assert_eq!(ticks[4].value, PI);
    assert_eq!(
        labels(&angular(0.0, 4.0 * PI, 6)),
        ["0", "π", "2π", "3π", "4π"]
    );
    assert_eq!(
        labels(&angular(0.0, PI, 4)),
        ["0", "π/4", "π/2", "3π/4", "π"]
    );
    assert_eq!(
        labels(&angular(0.0, 0.2, 4)),
        ["0.00", "0.05", "0.10", "0.15", "0.20"]
    );
}

#[test]
fn logarithmic_axes_have_decades() {
    assert_eq!(
        labels(&logarithmic(0.01, 1.0, 8)),
        ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1"]
    );
    assert_eq!(
        labels(&logarithmic(1e-3, 1.0, 7)),
        ["0.001", "0.003", "0.01", "0.03", "0.1", "0.3", "1"]
    );
    assert_eq!(
        labels(&logarithmic(1e-7, 1e6, 6)),
        ["10⁻⁶", "0.001", "1", "1000", "10⁶"]
    );
    assert_eq!(
        labels(&logarithmic(2.0, 3.0, 6)),
        ["2.0", "2.2", "2.4", "2.6", "2.8", "3.0"]
    );
    assert_eq!(logarithmic(0.01, 1.0, 8)[0].value, 0.01);
}

#[test]
fn an_axis_of_no_width_has_no_ticks() {
    assert!(round(0.0, 0.0, 5).is_empty());
    assert!(round(0.0, 5e-324, 5).is_empty());
    assert!(round(0.0, f64::INFINITY, 5).is_empty());
    assert!(!round(0.0, 1e-300, 5).is_empty());
}

#[test]
fn numbers_are_round() {
    assert_eq!(labels(&round(-4.01, 4.01, 6)), ["−4", "−2", "0", "2", "4"]);
    assert_eq!(
        labels(&round(0.0, 1.0, 5)),
        ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
    );
    assert_eq!(
        labels(&round(0.0, 1.0, 4)),
        ["0.00", "0.25", "0.50", "0.75", "1.00"]
    );
    assert_eq!(
        labels(&round(0.0, 3e7, 3)),
        ["0.0e0", "1.0e7", "2.0e7", "3.0e7"]
    );
}

#[test]
fn ticks_that_differ_have_labels_that_differ() {
    for (a, b) in [
        (1_234_567.0, 1_234_571.0),
        (1.337_012_3, 1.337_012_7),
        (2e-6, 2.001e-6),
        (-5e9, 7e9),
        (1.0, 1.0 + 1e-12),
    ] {
        let ticks = round(a, b, 5);
        let mut found = labels(&ticks);
        assert!(found.len() > 1, "{found:?}");
        for (tick, label) in ticks.iter().zip(&found) {
            let read: f64 = label.replace('−', "-").parse().unwrap();
            assert!((read - tick.value).abs() < 0.01 * (b - a), "{label}");
        }
        found.dedup();
        assert_eq!(found.len(), ticks.len(), "{found:?}");
    }
}
