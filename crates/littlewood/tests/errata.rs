//! The corrections to the paper, each with the printed form failing where the corrected one holds.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics
#![allow(clippy::panic)] // a failed expectation

use std::f64::consts::{FRAC_PI_2, PI};

use littlewood::cases::find_case;
use littlewood::modes::{PhaseSolution, RollingOrbit};
use littlewood::theory::{Body, GlidingIntegrals, Massless, PhasePlane, SlidingLaw, closed_form};
use littlewood::{Hoop, HoopParameters, Limits, Mode, RotationDirection, SlipDirection, Start};

fn massless(offset: f64) -> Massless {
    let hoop = Hoop::new(HoopParameters::thin(0.0).with_offset(offset)).expect("a massless hoop");
    let Body::Massless(body) = hoop.body() else {
        panic!("has no inertia")
    };
    body
}

fn rim() -> Massless {
    massless(1.0)
}

#[test]
fn figure_5_has_half_of_the_slip_angle() {
    let angle = closed_form::slip_angle(&rim(), 0.5).expect("a rim particle slips at some angle");
    assert!((angle.to_degrees() - 53.130_102_354_155_98).abs() < 1e-12);
    // (3.9): μs = tan(θ_s/2). The caption's 26.5651° does not satisfy it; it is θ_s/2.
    assert!(((angle / 2.0).tan() - 0.5).abs() < 1e-15);
    assert!(((26.5651_f64.to_radians() / 2.0).tan() - 0.5).abs() > 0.2);
    assert!((angle.to_degrees() / 2.0 - 26.5651).abs() < 1e-4);
    // For a particle inside the rim: ℓ̂ sin θ = μ (1 + ℓ̂ cos θ) (footnote 7).
    let angle = closed_form::slip_angle(&massless(0.7), 0.5).expect("slips");
    assert!((0.7 * angle.sin() / (1.0 + 0.7 * angle.cos()) - 0.5).abs() < 1e-15);
    assert_eq!(closed_form::slip_angle(&massless(0.3), 0.5), None);
}

/// θ(τ) of (3.1) by the library's orbit, which another test holds against the equation of motion.
fn rolled(theta: f64, rate: f64, elapsed: f64) -> f64 {
    let hoop = Hoop::littlewood(1e9, 0.0).expect("a hoop that does not slip");
    RollingOrbit::new(&hoop, theta, rate)
        .expect("no resistance")
        .position(elapsed)
        .0
}

/// (3.1) by classical Runge–Kutta steps: independent of any closed form.
fn integrated(theta: f64, rate: f64, elapsed: f64) -> f64 {
    let acceleration = |t: f64, w: f64| (1.0 + w * w) * t.sin() / (2.0 * (1.0 + t.cos()));
    let steps = 4000;
    let dt = elapsed / f64::from(steps);
    let (mut t, mut w) = (theta, rate);
    for _ in 0..steps {
        let (k1, l1) = (w, acceleration(t, w));
        let (k2, l2) = (
            w + dt / 2.0 * l1,
            acceleration(t + dt / 2.0 * k1, w + dt / 2.0 * l1),
        );
        let (k3, l3) = (
            w + dt / 2.0 * l2,
            acceleration(t + dt / 2.0 * k2, w + dt / 2.0 * l2),
        );
        let (k4, l4) = (w + dt * l3, acceleration(t + dt * k3, w + dt * l3));
        t += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        w += dt / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    t
}

#[test]
fn alpha_of_3_4_holds_for_either_sign_of_the_rate() {
    let printed_alpha = |theta: f64, rate: f64| {
        let e = closed_form::rolling_energy(theta, rate);
        (theta / 2.0).sin() + ((e - theta.cos()) / 2.0).sqrt()
    };
    // (3.3) with exponents ±(τ − τ0)/2.
    let angle = |alpha: f64, theta: f64, rate: f64, t: f64| {
        let e = closed_form::rolling_energy(theta, rate);
        2.0 * (alpha / 2.0 * (t / 2.0).exp() - (e - 1.0) / (4.0 * alpha) * (-t / 2.0).exp()).asin()
    };
    for (theta, rate) in [
        (0.4, 0.3),
        (0.4, -0.3),
        (-0.5, 0.2),
        (-0.5, -0.6),
        (1.0, -0.1),
    ] {
        let t = 0.8;
        let truth = integrated(theta, rate, t);
        let right = closed_form::alpha(theta, rate);
        assert!((angle(right, theta, rate, t) - truth).abs() < 1e-12);
        assert!((rolled(theta, rate, t) - truth).abs() < 1e-12);
        let found =
            closed_form::rolling_angle(&Start::at(theta, rate), t).expect("not at the plane yet");
        assert!((found - truth).abs() < 1e-12);
        let printed = angle(printed_alpha(theta, rate), theta, rate, t);
        assert_eq!(
            (printed - truth).abs() < 1e-12,
            rate >= 0.0,
            "printed form at θ′ = {rate}: {printed} {truth}"
        );
    }
}

#[test]
fn the_closed_form_does_not_divide_by_alpha_on_the_stable_manifold() {
    let theta = 0.6;
    let rate = closed_form::stable_manifold_rate(theta);
    assert!(closed_form::alpha(theta, rate).abs() < 1e-16);
    // (3.7): sin(θ/2) = sin(θ0/2) e^(−Δτ/2); printed with τ − τ0/2, which is wrong unless τ0 = 0.
    for t in [0.5, 2.0, 6.0] {
        let sine = closed_form::rolling_half_sine(&Start::at(theta, rate), t);
        assert!((sine - (theta / 2.0).sin() * (-t / 2.0).exp()).abs() < 1e-15);
    }
    let (start, now) = (1.0_f64, 3.0_f64);
    let printed = (theta / 2.0).sin() * (-(now - start / 2.0)).exp();
    let right = closed_form::rolling_half_sine(&Start::at(theta, rate), now - start);
    assert!(((integrated(theta, rate, now - start) / 2.0).sin() - right).abs() < 1e-12);
    assert!((printed - right).abs() > 0.01);
    assert_eq!(closed_form::rolling_time_to_plane(0.0, 0.0), None);
    let unstable = closed_form::unstable_manifold_rate(theta);
    let time = closed_form::rolling_time_to_plane(theta, unstable).expect("leaves the equilibrium");
    assert!((time + 2.0 * (theta / 2.0).sin().ln()).abs() < 1e-15);
}

#[test]
fn the_first_integral_of_gliding_is_not_the_printed_one() {
    let motion = find_case("figure-7")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let glide = &motion.phases()[1];
    assert_eq!(glide.mode(), Mode::Gliding);
    let (first, last) = (
        glide.first().state,
        glide.sample(0.9 * glide.duration()).state,
    );
    let right = |s: littlewood::State| GlidingIntegrals::at(&rim(), &s).w;
    let printed =
        |s: littlewood::State| 0.5 * s.theta.sin() * s.theta_rate * s.theta_rate - s.theta;
    assert!((right(first) - right(last)).abs() < 1e-14);
    assert!((printed(first) - printed(last)).abs() > 0.01);
}

#[test]
fn slip_through_zero_is_located_and_not_stopped_at_a_threshold() {
    // §2(c) stops when η′ < 1e-9. Figure 3 starts from η′ = 0 and its slide returns to 0 exactly.
    let motion = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let slide = &motion.phases()[0];
    assert_eq!(slide.first().state.slip, 0.0);
    assert_eq!(slide.last().expect("an end").state.slip, 0.0);
    let just_before = slide.sample(slide.duration() * (1.0 - 1e-12)).state.slip;
    assert!(just_before < 0.0 && just_before > -1e-9);
}

#[test]
fn a_negative_normal_force_of_rolling_is_no_lift_off() {
    // §2(a): "N vanishes immediately". In the band between n and 1 = h cos θ θ′² the body slides
    // with N > 0.
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let plane = PhasePlane::new(&hoop);
    for theta in [-1.0, -0.7, 0.4, 0.9] {
        let (n, lift) = (
            plane.normal_force_rate(theta).expect("the curve n"),
            plane.lift_off_rate(theta).expect("the lift-off curve"),
        );
        assert!(n < lift);
        let rate = 0.5 * (n + lift);
        assert!(plane.forces(theta, rate).normal < 0.0);
        let motion = hoop
            .simulate(Start::at(theta, rate), Limits::default())
            .expect("a valid start");
        let first = motion.phases()[0].first();
        assert_eq!(first.mode, Mode::Sliding);
        assert!(first.normal > 0.0);
        let direction = first.direction.expect("slips");
        let law =
            SlidingLaw::new(&hoop, direction, RotationDirection::Positive).expect("a heavy hoop");
        assert!(direction.sign() * law.accelerations(theta, rate).slip > 0.0);
        // Only the other side of the lift-off curve leaves at once.
        let above = hoop
            .simulate(Start::at(theta, 1.0001 * lift), Limits::default())
            .expect("a valid start");
        assert_eq!(above.phases()[0].mode(), Mode::Flight);
    }
}

#[test]
fn the_massless_glide_is_not_always_a_limit_of_small_inertia() {
    // A start at rest on the slip boundary with s σ > 0 and tan|θ/2| < μk glides in the paper;
    // hoops of small inertia that slip there have no motion with N > 0.
    let hoop = Hoop::littlewood(1.0, 0.9).expect("Littlewood's hoop");
    let start = Start::at(0.5, 0.2).with_slip(0.5);
    let glide = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    assert_eq!(glide.phases()[0].mode(), Mode::Gliding);
    assert!(glide.phases()[0].is_outside_small_inertia_limit());
    let light = HoopParameters::thin(0.0)
        .with_inertia(1e-6)
        .with_friction(1.0, 0.9);
    let light = Hoop::new(light).expect("a light hoop");
    let slide = light
        .simulate(start, Limits::default())
        .expect("a valid start");
    assert_eq!(slide.outcome().kind().name(), "inconsistent");
    // On the other side the light hoop follows the glide.
    let start = Start::at(0.5, 0.2).with_slip(-0.5);
    let glide = hoop
        .simulate(start, Limits::until(0.5))
        .expect("a valid start");
    assert!(!glide.phases()[0].is_outside_small_inertia_limit());
    let slide = light
        .simulate(start, Limits::until(0.5))
        .expect("a valid start");
    let (a, b) = (glide.outcome().state(), slide.outcome().state());
    assert!(
        (a.theta - b.theta).abs() < 1e-4 && (a.slip - b.slip).abs() < 1e-4,
        "{a:?} {b:?}"
    );
}

#[test]
fn littlewoods_closed_forms_agree_with_each_other() {
    // From the top: slip and unloading times, and where they happen.
    let rate = 0.5;
    assert!((closed_form::slip_time_from_top(rate, 0.5) - 5.0_f64.ln()).abs() < 1e-15);
    let unloading = closed_form::unloading_time_from_top(0.9);
    let angle =
        closed_form::rolling_angle(&Start::at(0.0, 0.9), unloading).expect("before the plane");
    assert!((angle.cos() - 0.81).abs() < 1e-14);
    assert!(
        (closed_form::gliding_time_to_plane(0.6_f64.acos(), 0.75) - (89.0_f64.sqrt() - 3.0) / 5.0)
            .abs()
            < 1e-15
    );
    // The parabola of (3.19) is at the plane at the time of (3.20), whether it begins upwards or
    // downwards.
    for (theta, rate) in [
        (0.9, 0.7),
        (0.9, -0.7),
        (-2.0, 1.5),
        (-2.0, -1.5),
        (0.0, 2.0),
    ] {
        let time = closed_form::gliding_time_to_plane(theta, rate);
        assert!(
            time > 0.0
                && closed_form::gliding_path(&Start::at(theta, rate).with_slip(0.3), time)
                    .1
                    .abs()
                    < 1e-14,
            "{theta} {rate}"
        );
    }
    // N and F of (3.8) are those of (2.12).
    let plane = PhasePlane::new(&Hoop::littlewood(0.5, 0.4).expect("Littlewood's hoop"));
    for (theta, rate) in [(0.3, 0.4), (-1.2, 0.7), (2.0, -0.3)] {
        let forces = plane.forces(theta, rate);
        assert!((forces.normal - closed_form::rolling_normal(theta, rate)).abs() < 1e-15);
        assert!((forces.friction - closed_form::rolling_friction(theta, rate)).abs() < 1e-15);
        assert_eq!(
            plane.in_rolling_region(theta, rate),
            closed_form::in_rolling_region(&Start::at(theta, rate), 0.5),
        );
    }
    // The parabola of (3.19) is where the simulated particle is.
    let motion = find_case("figure-7")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let glide = &motion.phases()[1];
    let PhaseSolution::Gliding(_) = glide.solution() else {
        panic!("glides")
    };
    let first = glide.first();
    for part in [0.1, 0.5, 0.9] {
        let t = part * glide.duration();
        let (x, y) =
            closed_form::gliding_path(&Start::at(first.state.theta, first.state.theta_rate), t);
        let particle = glide.sample(t).particle;
        assert!((particle.x - first.particle.x - x).abs() < 1e-14);
        assert!((particle.y - y).abs() < 1e-14);
    }
}

#[test]
fn the_equilibria_of_figure_2_are_stable_at_the_bottom_and_unstable_at_the_top() {
    use littlewood::theory::Stability;
    let plane = PhasePlane::new(&Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2"));
    let [top, bottom] = plane.equilibria()[..] else {
        panic!("two equilibria")
    };
    assert_eq!((top.theta, bottom.theta), (0.0, PI));
    // D(0) = 6, D(π) = 2 for this hoop.
    assert_eq!(
        top.stability,
        Stability::Unstable {
            exponent: (1.0_f64 / 6.0).sqrt()
        }
    );
    assert_eq!(
        bottom.stability,
        Stability::Stable {
            frequency: 0.5_f64.sqrt()
        }
    );
    assert!((plane.separatrix_rate(PI) - 2.0_f64.sqrt()).abs() < 1e-15);
    assert!(
        plane
            .slip_rate(FRAC_PI_2, SlipDirection::Positive)
            .is_none()
            || plane
                .slip_rate(FRAC_PI_2, SlipDirection::Negative)
                .is_none()
    );
}
