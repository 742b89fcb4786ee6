//! Slides without kinetic friction: what they conserve says where they come to rest.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::common::{engines, heavy_hoop, start};
use littlewood::modes::Recurrence;
use littlewood::theory::Body;
use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, Start, State};
use littlewood_random::Draw;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A light rim that slips where the plane hardly presses on it: η″ = 7.6e-6 there, and next to the
/// bottom θ′ = 316. The slide is back where the cosine is that of the slip, after ∫ dθ/θ′ with (Î +
/// sin² θ) θ′² + 2 cos θ conserved.
#[test]
fn a_slide_comes_back_to_the_limit_of_static_friction_to_the_last_digits() {
    let inertia = 4.016_141_798_276_294e-5;
    let hoop = HoopParameters::thin(0.0)
        .with_inertia(inertia)
        .with_friction(0.932_698_395_276_155_5, 0.0);
    let start = Start::at(0.874_754_659_037_452_8, -0.999_997_695_583_698_6);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    let [slip, stick, ..] = motion.transitions() else {
        unreachable!("slips and sticks")
    };
    assert_eq!((slip.cause, stick.cause), (Cause::Slip, Cause::Stick));
    let (from, to) = (slip.before, stick.before);
    assert_eq!(from.theta_rate.to_bits(), to.theta_rate.to_bits());
    assert!(
        (to.theta - (-TAU - from.theta)).abs() < 2e-15,
        "{from:?} {to:?}"
    );

    let inertia_at = |theta: f64| inertia + theta.sin() * theta.sin();
    let energy =
        inertia_at(from.theta) * from.theta_rate * from.theta_rate + 2.0 * from.theta.cos();
    let slowness = |theta: f64| (inertia_at(theta) / (energy - 2.0 * theta.cos())).sqrt();
    // Three nodes of Gauss in each of the intervals, which are short beside the √Î that the
    // particle is wide at the bottom.
    let intervals = 100_000;
    let width = (from.theta - to.theta) / f64::from(intervals);
    let node = 0.6_f64.sqrt() * 0.5 * width;
    let time = (0..intervals).map(|i| {
        let middle = to.theta + (f64::from(i) + 0.5) * width;
        let outer = slowness(middle - node) + slowness(middle + node);
        width * (8.0 * slowness(middle) + 5.0 * outer) / 18.0
    });
    let time: f64 = time.sum();
    assert!(
        (to.time - from.time - time).abs() < 1e-12,
        "{} {time}",
        to.time - from.time
    );
}

/// A time after the turning point on the other side of the bottom. The angle and the rate are those
/// of ∫ dθ/θ′ with 30 digits.
#[test]
fn a_slide_is_known_behind_a_turning_point() {
    let hoop = HoopParameters::thin(4.279_724_030_550_52)
        .with_friction(0.0, 0.0)
        .with_slope(-0.497_437_103_729_231_67);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let start = Start::at(-0.301_803_837_171_314_4, 0.0);
    let motion = hoop
        .simulate(start, Limits::until(20.0))
        .expect("a valid start");
    let end = motion.summary().end;
    let (theta, rate) = (-5.475_480_700_992_735, 0.298_825_653_936_029_36);
    assert!(
        (end.theta - theta).abs() < 16.0 * f64::EPSILON * theta.abs(),
        "{end:?}"
    );
    assert!(
        (end.theta_rate - rate).abs() < 16.0 * f64::EPSILON,
        "{end:?}"
    );
}

/// Without any friction η′ is largest at the bottom, where η″ vanishes and rounding tells its sign:
/// it falls behind, through zero, and rises again.
#[test]
fn a_slip_that_is_least_behind_the_bottom_reverses_there() {
    for (parameters, start) in [
        (
            (0.3898249596442731, 0.625816556663549, 0.9829678029722646),
            Start::at(3.1275630799138234, 1.0108601929191154),
        ),
        (
            (0.45171548271284234, 0.1831611642720496, 2.0965598990629726),
            Start::at(2.9295501038949743, 0.8085111428199605),
        ),
    ] {
        let (mass_ratio, offset, inertia) = parameters;
        let hoop = Hoop::new(
            HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia),
        )
        .expect("a valid hoop");
        let limits = Limits::until(40.0);
        let motion = hoop.simulate(start, limits).expect("a valid start");
        // As far behind the bottom as the start lies before it.
        let reversal = motion.transitions()[0].before;
        assert!(
            (reversal.theta - (TAU - start.theta)).abs() < 1e-15,
            "{reversal:?}"
        );
        let motion = motion.summary();
        for engine in engines(&hoop) {
            let summary = engine.summary(start, limits).expect("a valid start");
            assert_eq!(
                (summary.outcome, summary.transitions),
                (motion.outcome, motion.transitions)
            );
            assert_eq!(summary.sequence, motion.sequence);
        }
    }
}

/// Where two events coincide, nearly so, or rounding tells whether there is one, the engine has
/// those of the simulation.
#[test]
fn events_next_to_each_other_are_those_of_the_simulation() {
    for ((mass_ratio, offset, inertia), mu_s, start) in [
        // Reversals on both sides of the top, between which η′ is 1e-8 at most.
        (
            (4.372817375665149, 1.0, 4.372817375665149),
            0.0,
            Start::at(-0.04593282989113888, 1.0000332327815302),
        ),
        // Four reversals in each swing next to rest: η″ vanishes at the bottom.
        (
            (0.0, 1.0, 0.007990986052657375),
            0.0,
            Start::at(3.143057151581997, -1.5851283930325464e-10).with_slip(-9.32561307848522e-10),
        ),
        // η′ vanishes just before contact ends.
        (
            (0.6473575987037725, 1.0, 2.9814626484506657),
            0.05804798124769521,
            Start::at(0.14438839155729766, 1.29022482694846),
        ),
        // From rest at the top, but for the last digits.
        (
            (0.00013329973752259944, 1.0, 0.00013329973752259944),
            0.7053774550982219,
            Start::at(-7.317250194140809e-13, 0.0).with_slip(-0.5117406304074912),
        ),
        // At the bottom, but for the last digits.
        (
            (2.3033600534883227, 0.6142959219089895, 2.3033600534883227),
            0.13324164524684426,
            Start::at(std::f64::consts::PI, 0.0).with_slip(1.6424124366843662),
        ),
    ] {
        let parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, 0.0);
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        for limits in [Limits::until(20.0), Limits::default()] {
            let motion = hoop
                .simulate(start, limits)
                .expect("a valid start")
                .summary();
            for engine in engines(&hoop) {
                let summary = engine.summary(start, limits).expect("a valid start");
                assert_eq!(
                    (summary.outcome, summary.transitions, summary.sequence),
                    (motion.outcome, motion.transitions, motion.sequence),
                    "{start:?}"
                );
            }
        }
    }
}

/// Where η′ vanishes twice within 0.002 the second zero has its digits, too: as far behind the
/// bottom as the third lies before it, by symmetry, and the same by all solvers.
#[test]
fn reversals_next_to_each_other_have_their_digits() {
    let parameters = HoopParameters::thin(0.7938587574375968)
        .with_offset(0.2784689571620236)
        .with_inertia(0.43868262089929744);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let start = Start::at(-2.6703065502307917, -2.4013239599419345);
    let motion = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    let [first, second, third, ..] = motion.transitions() else {
        unreachable!("three reversals")
    };
    let [first, second, third] = [first, second, third].map(|reversal| reversal.before);
    assert!((first.theta - start.theta).abs() < 0.002, "{first:?}");
    assert!(
        (first.theta + second.theta + TAU).abs() < 2e-15,
        "{first:?} {second:?}"
    );
    assert!((start.theta + third.theta + TAU).abs() < 2e-15, "{third:?}");
    let (before, behind) = (first.time, third.time - second.time);
    assert!((before - behind).abs() < 1e-15, "{before} {behind}");
    for engine in engines(&hoop) {
        let end = engine
            .summary(start, Limits::default().with_transitions(1))
            .expect("a valid start")
            .end;
        assert!(
            (end.theta - first.theta).abs() < 1e-15 && (end.time - first.time).abs() < 1e-15,
            "{end:?}"
        );
    }
}

/// From η′ = 0 just behind the top a hoop without friction comes to η′ = 0 just before and just
/// behind it in each turn: a pair of reversals, at these angles to the last digit and 2 θ₀/θ′
/// apart.
#[test]
fn pairs_of_reversals_next_to_the_top_are_found_in_each_turn() {
    let hoop = Hoop::equal_masses(0.0, 0.0).expect("a valid hoop");
    for theta in [1e-3_f64, 1e-4, 1e-5, 1e-6, 1e-7] {
        let start = Start::at(theta, 0.7);
        let motion = hoop
            .simulate(start, Limits::until(20.0))
            .expect("a valid start");
        let is_next_to_top =
            |state: &State| (state.theta - TAU * (state.theta / TAU).round()).abs() < 0.01;
        let reversals: Vec<State> = motion
            .transitions()
            .iter()
            .map(|reversal| reversal.before)
            .filter(is_next_to_top)
            .collect();
        // Three turns of 5.73.
        assert_eq!(reversals.len(), 6, "{theta}");
        for (pair, turns) in reversals.chunks(2).zip(1..) {
            let top = TAU * f64::from(turns);
            let digit = f64::EPSILON * top;
            assert!(
                (pair[0].theta - (top - theta)).abs() <= digit,
                "{theta}: {pair:?}"
            );
            assert!(
                (pair[1].theta - (top + theta)).abs() <= digit,
                "{theta}: {pair:?}"
            );
            let apart = 2.0 * theta / 0.7;
            assert!(
                (pair[1].time - pair[0].time - apart).abs() < 1e-14 + theta * apart,
                "{theta}: {pair:?}"
            );
        }
    }
}

/// η′ after a time, by Newton–Euler alone: horizontal momentum, and θ″ of a smooth contact, in steps
/// of Runge and Kutta.
fn slip_of_a_smooth_contact(hoop: &Hoop, start: Start, time: f64) -> f64 {
    let Body::Heavy(body) = hoop.body() else {
        unreachable!("heavy")
    };
    let (m, h, own) = (hoop.mass(), hoop.h(), body.inertia);
    let (normal, along) = (hoop.slope().cos(), hoop.slope().sin());
    // N of ȳ″ = −h (cos θ θ′² + sin θ θ″) and Î θ″ = N h sin θ.
    let of = |[theta, rate]: [f64; 2]| {
        let (sin, cos) = theta.sin_cos();
        let force = m * (normal - h * cos * rate * rate) / (1.0 + m * h * h * sin * sin / own);
        [rate, force * h * sin / own]
    };
    let steps = 2_000;
    let step = time / f64::from(steps);
    let mut now = [start.theta, start.theta_rate];
    let plus = |a: [f64; 2], b: [f64; 2], by: f64| [a[0] + by * b[0], a[1] + by * b[1]];
    for _ in 0..steps {
        let k1 = of(now);
        let k2 = of(plus(now, k1, 0.5 * step));
        let k3 = of(plus(now, k2, 0.5 * step));
        let k4 = of(plus(now, k3, step));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            now = plus(now, k, weight * step / 6.0);
        }
    }
    // x̄′ = η′ − θ′ (1 + h cos θ) only falls by the pull of a slope.
    let lever = |theta: f64| 1.0 + h * theta.cos();
    now[1] * lever(now[0]) - start.theta_rate * lever(start.theta) - along * time
}

/// A start at which η″ = 0 without friction on a plane at a slope.
fn vanishing_start(hoop: &Hoop, theta: f64, forth: bool) -> Option<Start> {
    let Body::Heavy(body) = hoop.body() else {
        return None;
    };
    let (m, h, own) = (hoop.mass(), hoop.h(), body.inertia);
    let ((sin, cos), slope) = (theta.sin_cos(), hoop.slope());
    let inertia = own + m * h * h * sin * sin;
    // η″ J = h s [m (1 + hc) cos α − u (m h c + m h² + Î)] − J sin α.
    let push = m * h * sin * (1.0 + h * cos) * slope.cos() - inertia * slope.sin();
    let u = push / (h * sin * (m * h * cos + m * h * h + own));
    // Until the end of the test: the cosine changes by less than its time times the rate.
    let is_pressed = u > 0.01 && h * u * (cos + 0.02 * u.sqrt()) < 0.95 * slope.cos();
    is_pressed.then(|| Start::at(theta, if forth { u.sqrt() } else { -u.sqrt() }))
}

fn follows_newton_and_euler(hoop: &Hoop, start: Start) -> Result<(), TestCaseError> {
    let time = 0.02;
    let expected = slip_of_a_smooth_contact(hoop, start, time);
    // Where η‴ vanishes, too, the next order may come first.
    let early = slip_of_a_smooth_contact(hoop, start, 0.5 * time);
    prop_assume!(expected.abs() > 1e-8 && (early / expected - 0.25).abs() < 0.1);
    let motion = hoop
        .simulate(start, Limits::until(time))
        .expect("a valid start");
    let modes: Vec<_> = motion
        .phases()
        .iter()
        .map(|it| (it.mode(), it.direction()))
        .collect();
    let direction = littlewood::SlipDirection::of_sign(expected);
    prop_assert_eq!(
        modes,
        [(Mode::Sliding, direction)],
        "{:?} {:?}",
        hoop,
        start
    );
    let end = motion.outcome().state();
    prop_assert_eq!(motion.outcome(), Outcome::TimeLimit { state: end });
    prop_assert_eq!(end.time, time);
    prop_assert!(
        (end.slip - expected).abs() < 1e-12,
        "{} {expected}",
        end.slip
    );
    for engine in engines(hoop) {
        let found = engine
            .summary(start, Limits::until(time))
            .expect("a valid start");
        prop_assert_eq!(found.outcome, OutcomeKind::TimeLimit);
        prop_assert!((found.end.slip - end.slip).abs() < 1e-12);
    }
    Ok(())
}

/// The starts of a map of the hoop of figure 3 at θ′ = ±1, where η″ vanishes at every angle; η′ at
/// τ = 0.1 and 1 of the first from two programs that share no code with this one.
#[test]
fn the_first_derivative_that_does_not_vanish_decides_how_a_slide_begins() {
    let hoop = Hoop::new(
        HoopParameters::thin(1.0)
            .with_offset(1.0)
            .with_inertia(1.0)
            .with_friction(0.0, 0.0),
    );
    let hoop = hoop.expect("a valid hoop");
    for eighth in [-7, -6, -5, -3, -2, -1, 1, 2, 3, 5, 6, 7] {
        for rate in [-1.0, 1.0] {
            let start = Start::at(f64::from(eighth) * TAU / 16.0, rate);
            if let Err(reason) = follows_newton_and_euler(&hoop, start) {
                assert!(
                    matches!(reason, TestCaseError::Reject(_)),
                    "{start:?}: {reason}"
                );
            }
        }
    }
    for (time, slip) in [(0.1, -0.001_319_3), (1.0, -0.012_599_9)] {
        let motion = hoop
            .simulate(Start::at(0.375 * TAU, 1.0), Limits::until(time))
            .expect("a valid start");
        let end = motion.outcome().state();
        assert!((end.slip - slip).abs() < 5e-8, "{end:?}");
        assert_eq!(motion.phases().len(), 1);
    }
    // θ, θ′, η′ at τ = 1, and η′ soon after the start: the momentum of an integration of θ″ of a
    // smooth contact with 30 digits. At the top and the bottom η″, η‴ and η⁗ vanish.
    for (eighth, rate, slip, early) in [
        (0, 1.0, -0.057_574_210_740_12, -1.0),
        (0, -1.0, 0.057_574_210_740_12, 1.0),
        (8, 1.0, -0.050_464_769_912_43, -1.0),
        (-8, -1.0, 0.050_464_769_912_43, 1.0),
        (1, -1.0, 0.002_712_179_710_177, 1.0),
        (-2, 1.0, -0.029_949_874_857_37, -1.0),
        (4, 1.0, -0.170_860_414_825_0, -1.0),
        (-5, 1.0, -0.226_490_495_735_7, -1.0),
        (6, -1.0, 0.187_643_664_194_8, 1.0),
        (-7, -1.0, 0.004_477_683_457_874, 1.0),
    ] {
        let start = Start::at(f64::from(eighth) * TAU / 16.0, rate);
        let motion = hoop
            .simulate(start, Limits::until(1.0))
            .expect("a valid start");
        let first = &motion.phases()[0];
        assert_eq!(first.mode(), Mode::Sliding, "{start:?}");
        assert_eq!(
            first.direction(),
            littlewood::SlipDirection::of_sign(early),
            "{start:?}"
        );
        let end = motion.outcome().state();
        assert!(
            end.time == 1.0 && (end.slip - slip).abs() < 1e-13,
            "{start:?} {end:?}"
        );
        for engine in engines(&hoop) {
            let found = engine
                .summary(start, Limits::until(1.0))
                .expect("a valid start");
            assert!((found.end.slip - slip).abs() < 1e-13, "{found:?}");
        }
    }
    let motion = hoop
        .simulate(Start::at(0.375 * TAU, 1.0), Limits::default())
        .expect("a valid start");
    let Outcome::RepeatsForever { period, .. } = motion.outcome() else {
        unreachable!("repeats for ever: {:?}", motion.outcome())
    };
    // J u + 2 m h c is constant, with J = 3/2 + s²/2 and m h = 1: from the bottom, with sin ½(θ − π)
    // = sin ½a sin ψ, all terms of ∫ dθ/θ′ are smooth, and periodic in ψ.
    let energy = 1.75 - 2.0_f64.sqrt();
    let k2 = 0.25 * (energy + 2.0);
    let nodes = 200;
    let quarter: f64 = (0..nodes)
        .map(|i| {
            let psi = (f64::from(i) + 0.5) * TAU / 4.0 / f64::from(nodes);
            let half = k2 * psi.sin() * psi.sin();
            let square = 4.0 * half * (1.0 - half);
            ((1.5 + 0.5 * square) / (1.0 - half)).sqrt()
        })
        .sum();
    let expected = 4.0 * quarter * TAU / 4.0 / f64::from(nodes);
    assert!((period - expected).abs() < 1e-6, "{period} {expected}");
    // Where the cosine is that of the start the slip only touches zero.
    for transition in motion.transitions() {
        assert_eq!(transition.cause, Cause::Graze, "{:?}", transition.before);
        // 2π and two sums round by half a digit each.
        let theta = transition.before.theta;
        let away = theta.cos() - (0.375 * TAU).cos();
        assert!(away.abs() <= 1.5 * f64::EPSILON * theta.abs(), "{theta}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// A slide without an event in a whole period, a turn or the way from the first turning point
    /// to the third, lasts for ever, which is known as soon as that has passed.
    #[test]
    fn a_slide_is_known_to_last_for_ever_once_a_period_has_passed(
        hoop in heavy_hoop(),
        start in start(),
        part in 0.01..0.99_f64,
        later in 0.0..30.0_f64,
    ) {
        let hoop = Hoop::new(hoop.parameters().with_friction(0.0, 0.0)).expect("without friction");
        let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
        let Outcome::SlidesForever { since, recurrence } = motion.outcome() else { return Ok(()) };
        let (Some(period), true) = (recurrence.period(), since.time == 0.0 && motion.transitions().is_empty()) else {
            return Ok(());
        };
        // Next to an equilibrium, or the separatrix, a period is ill-conditioned.
        prop_assume!(period < 30.0 && start.theta_rate.abs() > 1e-3);
        // From the start of a rotation on; a libration comes to its first turning point within half
        // a period.
        let known = if matches!(recurrence, Recurrence::Rotation { .. }) { period } else { 1.5 * period };
        let [before, behind] = [part * period, known + period * (1e-6 + part * later)];
        for (until, expected) in [(before, OutcomeKind::TimeLimit), (behind, OutcomeKind::SlidesForever)] {
            let limits = Limits::until(until);
            let simulated = hoop.simulate(start, limits).expect("a valid start");
            prop_assert_eq!(simulated.outcome().kind(), expected);
            let end = simulated.summary().end;
            for engine in engines(&hoop) {
                let summary = engine.summary(start, limits).expect("a valid start");
                prop_assert_eq!(summary.outcome, expected);
                let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * (1.0 + b.abs());
                prop_assert!(near(summary.end.time, end.time) && near(summary.end.slip, end.slip), "{:?} {end:?}", summary.end);
                prop_assert!(
                    near(summary.end.theta, end.theta) && near(summary.end.theta_rate, end.theta_rate) && near(summary.end.x, end.x),
                    "{:?} {end:?}", summary.end
                );
            }
        }
    }

    #[test]
    fn a_start_where_the_slip_acceleration_vanishes_slides_as_newton_and_euler_say(
        (mass_ratio, inertia) in prop_oneof![(0.1..5.0_f64).prop_map(|m1| (m1, m1)), (0.0..5.0_f64, 0.05..3.0_f64)],
        offset in prop_oneof![0.1..1.0_f64, Just(1.0)],
        slope in prop_oneof![Just(0.0), -1.0..1.0_f64],
        theta in -3.1..3.1_f64,
        forth in any::<bool>(),
    ) {
        let hoop = HoopParameters::thin(mass_ratio).with_offset(offset).with_inertia(inertia);
        let hoop = Hoop::new(hoop.with_friction(0.0, 0.0).with_slope(slope)).unwrap();
        if let Some(start) = vanishing_start(&hoop, theta, forth) {
            follows_newton_and_euler(&hoop, start)?;
        }
    }

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

/// Without kinetic friction Î u + m h² s² u + 2 m h c is constant, on a slope, too, so that w at the
/// top is the same number in each turn. A hoop that only touches w = 0 there stays on the plane; a
/// part in 1e9 decides.
#[test]
fn an_orbit_that_touches_the_limit_of_contact_at_the_top_stays_on_the_plane() {
    let (mut turns, mut lifts) = (0, 0);
    for case in 0..400 {
        let mut draw = Draw::of_case(51, 0, case);
        let parameters = HoopParameters::thin(draw.between([0.0, 3.0]))
            .with_offset(draw.between([0.1, 1.0]))
            .with_inertia(draw.one_of(&[1e-3, draw.clone().between([0.05, 3.0])]))
            .with_slope(draw.one_of(&[0.0, draw.clone().between([-1.0, 1.0])]));
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let Body::Heavy(body) = hoop.body() else {
            unreachable!("heavy")
        };
        let (m, h, own) = (body.mass, body.h, body.inertia);
        let theta = draw.one_of(&[0.0, draw.clone().between([-3.1, 3.1])]);
        let (sin, cos) = theta.sin_cos();
        let energy = own / h + 2.0 * m * h * (1.0 - cos);
        let u = hoop.slope().cos() * energy / (own + m * h * h * sin * sin);
        let rate = draw.one_of(&[-1.0, 1.0]) * u.sqrt();
        // From rest at the top the slip touches zero in each turn, and rounding tells whether.
        let slip = draw.one_of(&[0.0, draw.clone().between([-2.0, 2.0])]);
        let slip = if theta == 0.0 { 0.5 } else { slip };
        for part in [-1e-9, 0.0, 1e-9] {
            let start = Start::at(theta, rate * (1.0 + part)).with_slip(slip);
            let limits = Limits::until(60.0).with_transitions(300);
            let motion = hoop.simulate(start, limits).expect("a valid start");
            let end = motion.outcome();
            let lift_off = motion
                .transitions()
                .iter()
                .find(|it| it.cause == Cause::LiftOff);
            let leaves = motion.phases()[0].mode() == Mode::Flight;
            if part > 0.0 {
                let behind = lift_off.map_or(0.0, |it| it.before.theta - theta);
                assert!(lift_off.is_some() || leaves, "{hoop:?} {start:?}");
                assert!(behind.abs() <= TAU, "{hoop:?} {start:?}");
                lifts += 1;
            } else {
                assert!(!leaves && lift_off.is_none(), "{hoop:?} {start:?}");
                turns += (end.state().theta / TAU).abs() as u32;
            }
            let exact = motion.summary();
            for engine in engines(&hoop) {
                let found = engine.summary(start, limits).expect("a valid start");
                assert_eq!(
                    (found.outcome, found.transitions, found.sequence),
                    (exact.outcome, exact.transitions, exact.sequence),
                    "{hoop:?} {start:?}"
                );
            }
        }
    }
    assert!(turns > 2_000 && lifts == 400, "{turns} {lifts}");
}

/// From η′ = 0 and w = 0 at the top η′ is even in θ, with static friction, too, since N = F = 0
/// there: at the top it does not reverse.
#[test]
fn a_slip_from_the_top_at_the_rate_of_lift_off_does_not_reverse_there() {
    for mu_s in [0.0, 0.3] {
        let parameters = HoopParameters::thin(0.0)
            .with_offset(0.5)
            .with_inertia(1e-3)
            .with_friction(mu_s, 0.0);
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let start = Start::at(0.0, std::f64::consts::SQRT_2);
        let motion = hoop
            .simulate(start, Limits::until(50.0))
            .expect("a valid start");
        assert!(motion.transitions().len() > 20, "{motion:?}");
        for event in motion.transitions() {
            let turns = event.before.theta / TAU;
            let is_at_top = (turns - turns.round()).abs() < 1e-3;
            let expected = if is_at_top {
                Cause::Graze
            } else {
                Cause::Reversal
            };
            assert_eq!(event.cause, expected, "{event:?}");
        }
    }
}
