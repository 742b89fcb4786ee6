//! Slides without kinetic friction: what they conserve says where they come to rest.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::common::{heavy_hoop, start};
use littlewood::{Body, Cause, Hoop, HoopParameters, Limits, Mode, Start, State};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A light rim that slips where the plane hardly presses on it: η″ = 7.6e-6 there, and next to the bottom θ′ = 316. The slide is back where the cosine
/// is that of the slip, after ∫ dθ/θ′ with (Î + sin² θ) θ′² + 2 cos θ conserved.
#[test]
fn a_slide_comes_back_to_the_limit_of_static_friction_to_the_last_digits() {
    let inertia = 4.016_141_798_276_294e-5;
    let hoop = HoopParameters::new(0.0, 1.0, inertia).with_friction(0.932_698_395_276_155_5, 0.0);
    let start = Start::at(0.874_754_659_037_452_8, -0.999_997_695_583_698_6);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
    let [slip, stick, ..] = motion.transitions() else { unreachable!("slips and sticks") };
    assert_eq!((slip.cause, stick.cause), (Cause::Slip, Cause::Stick));
    let (from, to) = (slip.before, stick.before);
    assert_eq!(from.theta_rate.to_bits(), to.theta_rate.to_bits());
    assert!((to.theta - (-TAU - from.theta)).abs() < 2e-15, "{from:?} {to:?}");

    let inertia_at = |theta: f64| inertia + theta.sin() * theta.sin();
    let energy = inertia_at(from.theta) * from.theta_rate * from.theta_rate + 2.0 * from.theta.cos();
    let slowness = |theta: f64| (inertia_at(theta) / (energy - 2.0 * theta.cos())).sqrt();
    // Three nodes of Gauss in each of the intervals, which are short beside the √Î that the particle is wide at the bottom.
    let intervals = 100_000;
    let width = (from.theta - to.theta) / f64::from(intervals);
    let node = 0.6_f64.sqrt() * 0.5 * width;
    let time = (0..intervals).map(|i| {
        let middle = to.theta + (f64::from(i) + 0.5) * width;
        let outer = slowness(middle - node) + slowness(middle + node);
        width * (8.0 * slowness(middle) + 5.0 * outer) / 18.0
    });
    let time: f64 = time.sum();
    assert!((to.time - from.time - time).abs() < 1e-12, "{} {time}", to.time - from.time);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_slide_comes_to_rest_where_energy_and_momentum_say(hoop in heavy_hoop(), start in start()) {
        let hoop = Hoop::new(hoop.parameters().with_friction(hoop.mu_s(), 0.0)).expect("without kinetic friction");
        let Body::Heavy(body) = hoop.body() else { unreachable!("a heavy hoop") };
        let motion = hoop.simulate(start.with_slip(0.0), Limits::default().with_transitions(40)).expect("a valid start");
        let mut slip = None;
        for (phase, transition) in motion.phases().iter().zip(motion.transitions()) {
            let now = transition.before;
            if phase.mode() == Mode::Rolling && transition.cause == Cause::Slip {
                slip = Some(now);
            }
            let (Mode::Sliding, Some(slip), 0.0) = (phase.mode(), slip, now.slip) else {
                continue;
            };
            let energy = |state: &State| {
                let arm = body.h * state.theta.sin();
                (body.inertia + body.mass * arm * arm) * state.theta_rate * state.theta_rate + 2.0 * body.offset * state.theta.cos()
            };
            if (energy(&slip) - 2.0 * body.offset).abs() < 1e-9 {
                continue; // next to the separatrix the slide as it is followed does not tell where it is
            }
            // A change of an angle or a rate by its last digit changes them so much.
            let digit = f64::EPSILON * (1.0 + now.theta.abs() + slip.theta.abs());
            let rate = 1.0 + now.theta_rate.abs() + slip.theta_rate.abs();
            let momentum = |state: &State| state.theta_rate * (1.0 + body.h * state.theta.cos());
            let (before, after) = (momentum(&slip), momentum(&now));
            prop_assert!((before - after).abs() < 4.0 * digit * rate, "{before} {after}");
            let (before, after) = (energy(&slip), energy(&now));
            let size = (body.inertia + body.mass) * rate * rate;
            prop_assert!((before - after).abs() < 8.0 * digit * size, "{before} {after}");
        }
    }
}
