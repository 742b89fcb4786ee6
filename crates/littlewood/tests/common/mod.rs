//! Random hoops and starts, with a preference for what is nearly degenerate.
#![allow(dead_code)] // each test file uses a part

pub(crate) mod dd;
pub(crate) mod flight;
pub(crate) mod newton;

use std::f64::consts::PI;

use littlewood::theory::{Body, PhasePlane};
use littlewood::{Engine, Hoop, HoopParameters, Limits, Start, Trajectory};
use littlewood_random::{BOUNDARIES, Draw, boundary_rate};
use proptest::prelude::*;

/// A factor from 1e-9 to 10, uniform in its logarithm.
fn scale() -> impl Strategy<Value = f64> {
    (-9.0..1.0_f64).prop_map(|exponent| libm::pow(10.0, exponent))
}

fn friction() -> impl Strategy<Value = (f64, f64)> {
    prop_oneof![
        4 => (0.0..1.5_f64, 0.0..=1.0_f64).prop_map(|(mu_s, part)| (mu_s, mu_s * part)),
        2 => (0.0..1.5_f64).prop_map(|mu| (mu, mu)),
        1 => (0.0..1.0_f64).prop_map(|mu_s| (mu_s, 0.0)),
        1 => Just((0.0, 0.0)),
        1 => (0.0..1e-6_f64).prop_map(|mu| (mu, mu)),
    ]
}

fn offset() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(1.0), 3 => 0.05..1.0_f64, 1 => 0.0..1e-6_f64, 1 => (1.0 - 1e-9)..1.0_f64]
}

/// The engine for many starts of a hoop, the same with interpolated slips, and that for one.
pub(crate) fn engines(hoop: &Hoop) -> [Engine; 3] {
    [
        Engine::new(hoop),
        Engine::builder(hoop).interpolate_slips().build(),
        Engine::builder(hoop).expected_starts(1).build(),
    ]
}

/// Heavy hoops, down to tiny inertia.
pub(crate) fn heavy_hoop() -> impl Strategy<Value = Hoop> {
    let masses = prop_oneof![
        3 => (0.1..5.0_f64).prop_map(|m1| (m1, m1)),
        2 => (0.0..5.0_f64, 0.01..3.0_f64),
        1 => scale().prop_map(|m1| (m1, m1)),
        1 => scale().prop_map(|inertia| (0.0, inertia)),
    ];
    (masses, offset(), friction()).prop_filter_map(
        "a body that can move",
        |((mass_ratio, inertia), offset, (mu_s, mu_k))| {
            let hoop = Hoop::new(
                HoopParameters::thin(mass_ratio)
                    .with_offset(offset)
                    .with_inertia(inertia)
                    .with_friction(mu_s, mu_k),
            )
            .ok()?;
            matches!(hoop.body(), Body::Heavy(_)).then_some(hoop)
        },
    )
}

/// Heavy hoops of moderate proportions, on which rounding errors stay small.
pub(crate) fn moderate_hoop() -> impl Strategy<Value = Hoop> {
    (
        0.2..4.0_f64,
        0.1..=1.0_f64,
        0.2..4.0_f64,
        0.05..0.7_f64,
        0.0..=1.0_f64,
    )
        .prop_filter_map(
            "a body that can move",
            |(mass_ratio, offset, inertia, mu_s, part)| {
                Hoop::new(
                    HoopParameters::thin(mass_ratio)
                        .with_offset(offset)
                        .with_inertia(inertia)
                        .with_friction(mu_s, mu_s * part),
                )
                .ok()
            },
        )
}

/// Massless hoops, the particle on the rim, inside, or inside by as little as a double may be.
pub(crate) fn massless_hoop() -> impl Strategy<Value = Hoop> {
    let beside_rim = (-16.0..-1.0_f64).prop_map(|power| 1.0 - libm::exp10(power));
    let offset = prop_oneof![2 => Just(1.0), 1 => 0.05..1.0_f64, 1 => beside_rim];
    (offset, friction()).prop_filter_map("a massless hoop", |(offset, (mu_s, mu_k))| {
        Hoop::new(
            HoopParameters::thin(0.0)
                .with_offset(offset)
                .with_friction(mu_s, mu_k),
        )
        .ok()
    })
}

fn angle() -> impl Strategy<Value = f64> {
    let near = prop_oneof![Just(0.0), -1e-6..1e-6_f64, -1e-12..1e-12_f64];
    prop_oneof![
        6 => -PI..PI,
        1 => -30.0..30.0_f64,
        2 => (near, prop::sample::select(vec![0.0, PI, -PI, PI / 2.0])).prop_map(|(d, at)| at + d),
    ]
}

fn rate() -> impl Strategy<Value = f64> {
    prop_oneof![6 => -4.0..4.0_f64, 1 => Just(0.0), 1 => -1e-6..1e-6_f64]
}

fn slip() -> impl Strategy<Value = f64> {
    prop_oneof![4 => Just(0.0), 4 => -2.0..2.0_f64, 1 => -1e-9..1e-9_f64]
}

/// Starts anywhere.
pub(crate) fn start() -> impl Strategy<Value = Start> {
    (angle(), rate(), slip()).prop_map(|(theta, rate, slip)| Start::at(theta, rate).with_slip(slip))
}

/// The same, and starts with the rates and slips of any size that is accepted.
pub(crate) fn slow_or_fast_start() -> impl Strategy<Value = Start> {
    let fast = (angle(), signed_power(0.0..6.0), signed_power(-6.0..6.0))
        .prop_map(|(theta, rate, slip)| Start::at(theta, rate).with_slip(slip));
    prop_oneof![2 => start(), 1 => fast]
}

/// A hoop with a start that lies on a boundary of its phase plane, to the last digit or nearly so.
pub(crate) fn boundary_start() -> impl Strategy<Value = (Hoop, Start)> {
    let nudge = prop_oneof![2 => Just(0.0), 1 => -1e-15..1e-15_f64, 1 => -1e-9..1e-9_f64];
    (heavy_hoop(), -PI..PI, any::<bool>(), 0..BOUNDARIES, nudge).prop_filter_map(
        "a boundary over this angle",
        |(hoop, theta, backwards, which, nudge)| {
            let rate = boundary_rate(&PhasePlane::new(&hoop), theta, which)?;
            let rate = (if backwards { -rate } else { rate }) * (1.0 + nudge);
            (rate.abs() < 1e6).then(|| (hoop, Start::at(theta, rate)))
        },
    )
}

/// A heavy hoop and a start.
pub(crate) fn heavy_motion() -> impl Strategy<Value = (Hoop, Start)> {
    prop_oneof![3 => (heavy_hoop(), start()), 1 => boundary_start()]
}

/// A heavy hoop and a start over the whole accepted range, at time and position 0.
pub(crate) fn whole_range() -> impl Strategy<Value = (Hoop, Start)> {
    any::<u64>()
        .prop_map(|seed| {
            let (hoop, start) = Draw::of_case(seed, 0, 0).heavy_motion();
            (hoop, start.with_time(0.0).with_x(0.0))
        })
        .no_shrink()
}

/// A hoop whose rotation the plane resists and a start, over the whole accepted range, level or on
/// a slope, at time and position 0.
pub(crate) fn whole_range_resisted() -> impl Strategy<Value = (Hoop, Start)> {
    any::<u64>()
        .prop_map(|seed| {
            let mut draw = Draw::of_case(seed, 0, 0);
            let (hoop, start) = draw.motion();
            let hoop = if draw.comes(0.3) {
                draw.on_slope(&hoop)
            } else {
                hoop
            };
            (draw.resisted(&hoop), start.with_time(0.0).with_x(0.0))
        })
        .no_shrink()
}

/// A power of ten, of either sign.
fn signed_power(powers: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    (powers, any::<bool>()).prop_map(|(power, up)| {
        if up {
            libm::exp10(power)
        } else {
            -libm::exp10(power)
        }
    })
}

/// Slopes of both signs, down to 1e-12.
pub(crate) fn slope() -> impl Strategy<Value = f64> {
    prop_oneof![2 => -1.5..1.5_f64, 1 => signed_power(-12.0..-1.0)]
}

/// The same, and slopes that differ from the vertical by so little.
pub(crate) fn any_slope() -> impl Strategy<Value = f64> {
    let nearly_vertical =
        signed_power(-12.0..-1.0).prop_map(|left| left.signum() * (PI / 2.0 - left.abs()));
    prop_oneof![6 => slope(), 1 => nearly_vertical]
}

/// The hoop on a slope.
pub(crate) fn tilted(hoop: &Hoop, slope: f64) -> Hoop {
    Hoop::new(hoop.parameters().with_slope(slope)).expect("a slope")
}

/// Few transitions and a short time are enough for a law that must hold at every instant.
pub(crate) fn simulate(hoop: &Hoop, start: Start) -> Trajectory {
    let limits = Limits::default()
        .with_until(Some(start.time + 20.0))
        .with_transitions(60);
    hoop.simulate(start, limits).expect("a valid start")
}

/// Instants of each phase: the ends, and `count` in between.
pub(crate) fn instants(duration: f64, count: u32) -> impl Iterator<Item = f64> {
    let duration = if duration.is_finite() { duration } else { 20.0 };
    (0..=count + 1).map(move |i| duration * f64::from(i) / f64::from(count + 1))
}

/// Pseudo-random starts that do not depend on a library: a linear congruence.
pub(crate) fn random_starts(count: usize) -> impl Iterator<Item = Start> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut uniform = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..count).map(move |i| {
        let start = Start::at(PI * (2.0 * uniform() - 1.0), 8.0 * uniform() - 4.0);
        if i % 2 == 0 {
            start
        } else {
            start.with_slip(4.0 * uniform() - 2.0)
        }
    })
}

/// Fails with the first of what is wrong, beside what was seen.
pub(crate) fn none_differ(wrong: &[String], seen: &str) {
    println!("{seen}; {} differ", wrong.len());
    let first = &wrong[..wrong.len().min(5)];
    assert!(
        wrong.is_empty(),
        "{seen}; {} differ: {first:#?}",
        wrong.len()
    );
}
