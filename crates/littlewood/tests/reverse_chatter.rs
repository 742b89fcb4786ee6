//! Reverse chatter: bounces that grow out of rolling on a slope.

use crate::common::heavy_hoop;
use littlewood::impact::NoSettling;
use littlewood::theory::{PhasePlane, StartRegion, Window};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Restitution, RestitutionLaw, RotationDirection,
    Start, State,
};
use proptest::prelude::*;
use serde_json::Value;

const CASES: &str = include_str!("../../../evidence/reference/reverse_chatter.json");

fn law() -> impl Strategy<Value = RestitutionLaw> {
    prop_oneof![
        Just(RestitutionLaw::Energetic),
        Just(RestitutionLaw::Poisson)
    ]
}

/// Rough hoops that bounce on a slope, and a place with the particle uphill of the contact, next to
/// an angle with reverse chatter or not.
fn bouncing() -> impl Strategy<Value = (Hoop, f64)> {
    let body = (0.02..4.0_f64, 0.3..=1.0_f64, 0.05..=1.0_f64);
    let contact = (0.3..3.0_f64, 0.5..=1.0_f64, 0.3..=1.0_f64, law());
    (body, contact, 0.05..1.4_f64, 0.02..3.1_f64, any::<bool>()).prop_filter_map(
        "a body that can move",
        |((mass, offset, part), (mu_s, share, e, law), slope, angle, left)| {
            let side = if left { 1.0 } else { -1.0 };
            let parameters = HoopParameters::thin(mass)
                .with_offset(offset)
                .with_inertia(part * mass)
                .with_friction(mu_s, share * mu_s)
                .with_restitution(e, law)
                .with_slope(side * slope);
            Some((Hoop::new(parameters).ok()?, -side * angle))
        },
    )
}

/// The same with a rate at which bounces grow.
fn growing() -> impl Strategy<Value = (Hoop, f64, f64)> {
    (bouncing(), 0.0..=1.0_f64, any::<bool>()).prop_filter_map(
        "reverse chatter",
        |((hoop, theta), part, back)| {
            let [low, high] =
                PhasePlane::new(&hoop).reverse_chatter_rates(theta, RotationDirection::Positive)?;
            let rate = low + (0.01 + 0.98 * part) * (high - low);
            Some((hoop, theta, if back { -rate } else { rate }))
        },
    )
}

/// The same with rolling resistance.
fn resisted() -> impl Strategy<Value = (Hoop, f64)> {
    (bouncing(), -3.0..0.5_f64).prop_filter_map("a valid hoop", |((hoop, theta), power)| {
        let chi = libm::exp10(power);
        let parameters = hoop.parameters().with_rolling_resistance(chi);
        Some((Hoop::new(parameters).ok()?, theta))
    })
}

/// The last ratio of bounces that are followed one by one, in units of the gap rate of each.
fn followed_ratio(hoop: &Hoop, theta: f64, rate: f64) -> Option<f64> {
    let [drift, weight, ..] = coefficients(hoop, theta, rate);
    let (mut state, mut ratio) = (State::from(Start::at(theta, 0.0)), 1.0);
    for _ in 0..5_000 {
        if rate != 0.0 {
            // No bounce ends the rotation.
            state.theta_rate = 1e100_f64.copysign(rate);
        }
        state.slip += 2.0 * drift / weight;
        let found = hoop.impact(&state, -1.0, restitution(hoop)).ok()?;
        ratio = found.after.gap_rate;
        state.slip = found.after.slip / ratio;
        state.theta_rate = found.after.theta_rate / ratio;
    }
    Some(ratio)
}

fn restitution(hoop: &Hoop) -> Restitution {
    hoop.restitution().expect("it bounces")
}

/// a, w, and A, B, C.
fn coefficients(hoop: &Hoop, theta: f64, rate: f64) -> [f64; 5] {
    let compliance = hoop.compliance(theta).expect("heavy");
    let ((sin, cos), u) = (libm::sincos(theta), rate * rate);
    let drift = -hoop.h() * sin * u - libm::sin(hoop.slope());
    let weight = libm::cos(hoop.slope()) - hoop.h() * cos * u;
    [drift, weight, compliance.a, compliance.b, compliance.c]
}

/// k1, k2, and p = 2 |a|/(w M).
fn slopes(hoop: &Hoop, theta: f64, rate: f64) -> [f64; 3] {
    let [drift, weight, a, b, c] = coefficients(hoop, theta, rate);
    let braking = hoop.mu_k() * a - b.abs();
    [
        c - hoop.mu_k() * b.abs(),
        c - b * b / a,
        2.0 * drift.abs() / (weight * braking),
    ]
}

/// Rounding error of the ratio of bounces: of p by the differences a, w and M, and of k1, which
/// divides in restitution.
fn rounding(hoop: &Hoop, theta: f64, rate: f64) -> f64 {
    let [drift, weight, a, b, c] = coefficients(hoop, theta, rate);
    let [k1, _, p] = slopes(hoop, theta, rate);
    let braking = hoop.mu_k() * a - b.abs();
    let terms = 1.0 + hoop.h() * rate * rate;
    let lost = hoop.mu_k() * a / braking.abs() + terms / drift.abs() + terms / weight.abs();
    let divided = if k1 * p > 1.0 { c / k1 } else { 1.0 };
    let answer = 1.0 + c * p.abs();
    8.0 * f64::EPSILON * lost * divided * answer * answer
}

/// The hoop of the survey that found reverse chatter by iterating impacts, with e = 0.3.
#[test]
fn a_light_rough_hoop_at_rest_has_the_ratios_of_iterated_impacts() {
    for (law, expected) in [
        (RestitutionLaw::Energetic, 2.618),
        (RestitutionLaw::Poisson, 3.289),
    ] {
        let parameters = HoopParameters::thin(0.021_320_530_682_849_247)
            .with_inertia(0.012_907_260_955_769_374)
            .with_friction(2.964_963_614_835_537, 2.619_274_255_498_373_4)
            .with_slope(-1.258_663_577_718_904_6)
            .with_restitution(0.3, law);
        let hoop = Hoop::new(parameters).expect("a hoop");
        let found = hoop
            .classify(Start::at(2.236_442_455_033_82, 0.0))
            .expect("a start");
        assert!(
            (found.reverse_chatter.expect("grows") - expected).abs() < 5e-4,
            "{found:?}"
        );
        assert_eq!(found.mode, Some(Mode::Rolling));
        let newton = Restitution::new(0.3, RestitutionLaw::Newton).expect("e");
        let plane = PhasePlane::new(&hoop.with_restitution(newton).expect("heavy"));
        assert_eq!(plane.reverse_chatter(2.236_442_455_033_82, 0.0), None);
    }
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

/// Ratios, and motions of many bounces, from bounces followed one by one with 150 digits.
#[test]
fn bounces_out_of_rolling_are_those_followed_with_150_digits() {
    let data: Value = serde_json::from_str(CASES).expect("evidence/reference/reverse_chatter.json");
    let mut grown = 0;
    for case in data["cases"].as_array().expect("cases") {
        let [mass_ratio, offset, inertia, mu_s, mu_k, slope] =
            [0, 1, 2, 3, 4, 5].map(|i| number(&case["hoop"][i]));
        let parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k)
            .with_slope(slope)
            .with_restitution(
                number(&case["restitution"]),
                case["law"].as_str().expect("a law").parse().expect("a law"),
            );
        let hoop = Hoop::new(parameters).expect("a hoop");
        let [theta, rate] = [0, 1].map(|i| number(&case["start"][i]));
        let start = Start::at(theta, rate);
        let found = hoop.classify(start).expect("a start");
        assert_eq!(found.mode, Some(Mode::Rolling), "{case}");
        let ratio = number(&case["ratio"]);
        let rounding = rounding(&hoop, theta, rate);
        if ratio < 1.0 {
            let settling = hoop
                .settling(&State::from(start), 1e-9, restitution(&hoop))
                .expect("settles");
            assert!(
                found.reverse_chatter.is_none() && (settling.ratio - ratio).abs() < rounding,
                "{case} {settling:?}"
            );
            continue;
        }
        grown += 1;
        assert!(
            (found.reverse_chatter.expect("grows") - ratio).abs() < rounding * ratio,
            "{case} {found:?}"
        );
        // From the rate 2^-20. An error of a bounce, of the order of the rounding of 1 + θ′, grows
        // with the bounces after it.
        let rates: Vec<f64> = case["rates"]
            .as_array()
            .expect("rates")
            .iter()
            .map(number)
            .collect();
        let limits = Limits::default().with_transitions(rates.len());
        let motion = hoop
            .simulate(start.with_gap_rate(libm::exp2(-20.0)), limits)
            .expect("a start");
        let error = |rate: f64| rounding * rate / libm::exp2(-20.0) * (1.0 + 1.0 / (ratio - 1.0));
        assert_eq!(motion.transitions().len(), rates.len(), "{case}");
        for (transition, expected) in motion.transitions().iter().zip(&rates) {
            let rate = transition.impact.expect("a bounce").after.gap_rate;
            assert!(
                (rate - expected).abs() < error(*expected),
                "{case}: {rate} {expected}"
            );
        }
        let last = rates.last().copied().unwrap_or_default();
        let (end, seen) = (
            &case["end"],
            motion.transitions().last().expect("a bounce").after,
        );
        for (key, ours) in [
            ("time", seen.time),
            ("theta", seen.theta),
            ("theta_rate", seen.theta_rate),
            ("x", seen.x),
            ("slip", seen.slip),
        ] {
            assert!(
                (ours - number(&end[key])).abs() < error(last),
                "{key} {ours} {case}"
            );
        }
    }
    assert_eq!(grown, 12);
}

/// The curves of the phase plane are where the ratio is 1.
#[test]
fn the_curves_are_where_the_ratio_is_1() {
    let parameters = HoopParameters::thin(0.3)
        .with_friction(1.5, 1.5)
        .with_slope(0.7);
    let hoop =
        Hoop::new(parameters.with_restitution(0.8, RestitutionLaw::Energetic)).expect("a hoop");
    let plane = PhasePlane::new(&hoop);
    let mut seen = 0;
    for [theta, rate] in plane
        .reverse_chatter_curve(&Window {
            x: [-3.2, 3.2],
            y: [-2.0, 2.0],
        })
        .concat()
    {
        let [low, high] = plane
            .reverse_chatter_rates(theta, RotationDirection::Positive)
            .expect("a point of a curve");
        let edge = rate.abs();
        assert!(edge == low || edge == high);
        if high - low > 1e-3 && edge > 1e-3 {
            let [below, above] =
                [-1e-6, 1e-6].map(|by| plane.reverse_chatter(theta, edge + by).is_some());
            assert_eq!(
                [below, above],
                [edge == high, edge == low],
                "{theta} {edge}"
            );
            seen += 1;
        }
    }
    assert!(seen > 50, "{seen}");
}

proptest! {
    /// a B = −h² sin² θ θ′² (1 + h cos θ)/Î ≤ 0.
    #[test]
    fn a_level_plane_has_none(
        hoop in heavy_hoop(), e in 0.0..=1.0_f64, law in law(), theta in -4.0..4.0_f64, rate in -3.0..3.0_f64,
    ) {
        let hoop = hoop.with_restitution(Restitution::new(e, law).expect("e")).expect("heavy");
        let plane = PhasePlane::new(&hoop);
        prop_assert_eq!(plane.reverse_chatter(theta, rate), None);
        prop_assert_eq!(plane.reverse_chatter_rates(theta, RotationDirection::Positive), None);
    }

    /// The ratio is the closed form; contact holds, at a friction force inside the cone of μk.
    #[test]
    fn bounces_grow_by_the_closed_form_where_contact_holds((hoop, theta, rate) in growing()) {
        let ratio = PhasePlane::new(&hoop).reverse_chatter(theta, rate).expect("inside");
        let [drift, weight, a, b, _] = coefficients(&hoop, theta, rate);
        let [k1, k2, p] = slopes(&hoop, theta, rate);
        let (e, law) = (restitution(&hoop).coefficient(), restitution(&hoop).law());
        let expected = match (law, k1 * p <= 1.0) {
            (RestitutionLaw::Energetic, true) => e * (1.0 + (k2 - k1) * p * (2.0 - k1 * p)).sqrt(),
            (RestitutionLaw::Energetic, false) => {
                let before = k1 * p - 1.0;
                ((e * e * k2 - (k2 - k1) * before * before) / k1).sqrt()
            }
            (_, true) => e * (1.0 + (k2 - k1) * p),
            (_, false) => (1.0 + e) * k2 / k1 - 1.0 - (k2 - k1) * p,
        };
        let rounding = rounding(&hoop, theta, rate);
        prop_assert!((ratio - expected).abs() < rounding * ratio, "{ratio} {expected} {rounding:e}");
        prop_assert!(ratio <= e * (1.0 + 2.0 * (drift * b).abs() / (a * weight)) * (1.0 + rounding));
        prop_assert!(drift * b > 0.0 && k1 * p < 2.0);

        let found = hoop.classify(Start::at(theta, rate)).expect("a start");
        prop_assert_eq!(found.region, StartRegion::Rolling);
        prop_assert_eq!(found.reverse_chatter, Some(ratio));
        let forces = found.rolling_forces;
        prop_assert!(forces.friction.abs() < hoop.mu_k() * forces.normal);
    }

    /// The ratio exceeds 1 between the rates, and nowhere else.
    #[test]
    fn bounces_grow_between_two_rates((hoop, theta) in bouncing(), rate in 0.0..3.0_f64) {
        let plane = PhasePlane::new(&hoop);
        let range = plane.reverse_chatter_rates(theta, RotationDirection::Positive);
        prop_assume!(range.is_none_or(|ends| ends.iter().all(|end| (rate - end).abs() > 1e-9)));
        let inside = range.is_some_and(|[low, high]| low < rate && rate < high);
        prop_assert_eq!(plane.reverse_chatter(theta, rate).is_some(), inside, "{:?}", range);
    }

    /// A bounce out of rolling, however small, grows by the ratio where it exceeds 1, in the
    /// simulation of the whole motion.
    #[test]
    fn inside_the_region_a_bounce_grows_out_of_it(
        (hoop, theta, rate) in growing(), small in prop_oneof![-12.0..-10.0_f64, -307.0..-10.0_f64],
    ) {
        let ratio = PhasePlane::new(&hoop).reverse_chatter(theta, rate).expect("inside");
        // Where the ratio depends little on θ and θ′, which change by the order of the gap rate.
        prop_assume!(ratio > 1.02 && ratio < 3.0 && rounding(&hoop, theta, rate) < 1e-12);
        let thrown = libm::exp10(small);
        let start = Start::at(theta, rate).with_gap_rate(thrown);
        let motion = hoop.simulate(start, Limits::default().with_transitions(8)).expect("a start");
        let mut last = thrown;
        for transition in motion.transitions() {
            prop_assert_eq!((transition.cause, transition.to), (Cause::Landing, Some(Mode::Flight)));
            let next = transition.impact.expect("a landing").after.gap_rate;
            prop_assert!((next / last - ratio).abs() < 1e-2 * (ratio - 1.0), "{} {ratio}", next / last);
            last = next;
        }
        prop_assert!(last > thrown * libm::pow(0.99 * (ratio - 1.0) + 1.0, 8.0));
    }

    /// Elsewhere it settles at once, and the hoop rolls.
    #[test]
    fn outside_the_region_a_bounce_settles((hoop, theta) in bouncing(), rate in -2.0..2.0_f64) {
        let state = State::from(Start::at(theta, rate));
        let found = hoop.classify(Start::at(theta, rate)).expect("a start");
        prop_assume!(found.mode == Some(Mode::Rolling));
        match hoop.settling(&state, 1e-12, restitution(&hoop)) {
            Ok(settling) => {
                prop_assert_eq!(found.reverse_chatter, None);
                prop_assume!(settling.ratio < 0.99 && settling.impact.after.slip == 0.0);
                // All bounces take 2 v/(W (1 − k)). W changes by about as much, and the sum by that over
                // W (1 − k): the throw is so slow that both stay below the sum's error.
                let closing = found.contact * (1.0 - settling.ratio);
                let thrown = 1e-10 * closing * closing;
                let start = Start::at(theta, rate).with_gap_rate(thrown);
                let motion = hoop.simulate(start, Limits::default().with_transitions(1)).expect("a start");
                let first = motion.transitions()[0];
                prop_assert_eq!(first.cause, Cause::Settle);
            }
            Err(NoSettling::Grows { ratio }) if ratio > 1.0 + 1e-15 => {
                let rounding = rounding(&hoop, theta, rate);
                let ours = found.reverse_chatter.unwrap_or(1.0);
                prop_assert!((ours - ratio).abs() < rounding * ratio, "{ours} {ratio} {rounding:e}");
            }
            Err(error) => prop_assert!(restitution(&hoop).coefficient() > 0.98, "{}", error),
        }
    }

    /// With rolling resistance, out of rolling and out of rest.
    #[test]
    fn with_rolling_resistance_bounces_grow_as_one_by_one(
        (hoop, theta) in resisted(), rate in prop_oneof![2 => -2.0..2.0_f64, 1 => Just(0.0)],
    ) {
        let plane = PhasePlane::new(&hoop);
        let found = plane.reverse_chatter(theta, rate);
        let [_, weight, ..] = coefficients(&hoop, theta, rate);
        prop_assume!(weight > 1e-3);
        let Some(followed) = followed_ratio(&hoop, theta, rate) else {
            return Ok(());
        };
        prop_assume!((followed - 1.0).abs() > 1e-6);
        match found {
            Some(ratio) => prop_assert!((ratio - followed).abs() < 1e-9 * ratio, "{ratio} {followed}"),
            None => prop_assert!(followed.is_nan() || followed <= 1.0 || followed > 1e9, "{followed}"),
        }
        if let Some(rotation) = RotationDirection::of_sign(rate) {
            let range = plane.reverse_chatter_rates(theta, rotation);
            prop_assume!(range.is_none_or(|ends| ends.iter().all(|end| (rate.abs() - end).abs() > 1e-6)));
            let inside = range.is_some_and(|[low, high]| low < rate.abs() && rate.abs() < high);
            prop_assert_eq!(found.is_some(), inside, "{:?} {:?} {}", range, found, followed);
        }
    }
}
