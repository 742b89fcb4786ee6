//! Painlevé's jam: where a slide runs into P = 0 with slip left, and how the motion goes on by an
//! impact without a collision.
#![allow(clippy::panic)] // a failed expectation

use crate::common::start;
use littlewood::impact::ImpactCase;
use littlewood::theory::{Body, SlidingLaw};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, Restitution, RestitutionLaw,
    RotationDirection, Start, Trajectory,
};
use littlewood_random::Draw;
use proptest::prelude::*;
use serde_json::Value;

const JAMS: &str = include_str!("../../../evidence/reference/jams.json");

fn hoop(mass: f64, mu_k: f64) -> Hoop {
    Hoop::new(HoopParameters::thin(mass).with_friction(0.5, mu_k)).expect("a valid hoop")
}

fn limits() -> Limits {
    Limits::until(5.0).with_transitions(40)
}

/// λ = 2 Î cos θ/(sin θ P′), mirrored so that the slip is positive: near the root of P, 1 − h cos θ
/// θ′² ~ x^λ and N ~ x^(λ − 1).
fn exponent(hoop: &Hoop, theta: f64, slip: f64) -> f64 {
    let Body::Heavy(body) = hoop.body() else {
        panic!("heavy")
    };
    let theta = theta * slip.signum();
    let (sin, cos) = libm::sincos(theta);
    let doubled = cos * cos - sin * sin;
    let slope =
        body.mass * body.h * (2.0 * body.h * sin * cos - hoop.mu_k() * (cos + body.h * doubled));
    2.0 * body.inertia * cos / (sin * slope)
}

/// A slide that runs into P = 0, in the middle of an open set of such.
fn runs_into_it() -> (f64, f64, Start) {
    (0.05, 0.42, Start::at(0.69, -0.95).with_slip(0.92))
}

fn last_slide(motion: &Trajectory) -> &littlewood::Phase {
    let slide = motion
        .phases()
        .iter()
        .rfind(|phase| phase.mode() == Mode::Sliding);
    slide.expect("a slide")
}

#[test]
fn an_open_set_of_slides_runs_into_it() {
    let (mass, mu_k, start) = runs_into_it();
    let mut state = 0x1234_5678_9ABC_DEF1_u64;
    let mut uniform = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for _ in 0..500 {
        let hoop = hoop(mass + 2e-3 * uniform(), mu_k + 2e-3 * uniform());
        let near = Start::at(
            start.theta + 2e-3 * uniform(),
            start.theta_rate + 2e-3 * uniform(),
        )
        .with_slip(start.slip + 2e-3 * uniform());
        let motion = hoop.simulate(near, limits()).expect("a valid start");
        let Outcome::Singular { state, .. } = motion.outcome() else {
            panic!("{near:?} {:?}", motion.outcome())
        };
        let lambda = exponent(&hoop, state.theta, state.slip);
        assert!(lambda > 0.0 && lambda < 1.0, "{lambda}");
        assert!(state.slip > 0.1, "{state:?}");
    }
}

/// N grows as x^(λ − 1), and 1 − h cos θ θ′² falls as x^λ.
#[test]
fn forces_grow_with_the_exponent_of_the_root() {
    let (mass, mu_k, start) = runs_into_it();
    let hoop = hoop(mass, mu_k);
    let motion = hoop.simulate(start, limits()).expect("a valid start");
    let end = motion.outcome().state();
    let lambda = exponent(&hoop, end.theta, end.slip);
    let slide = last_slide(&motion);
    let h = hoop.h();
    // Times at which the slide is this far from the root.
    let at = |distance: f64| {
        let (mut low, mut high) = (0.0, slide.duration());
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let far = (slide.sample(middle).state.theta - end.theta).abs() > distance;
            if far { low = middle } else { high = middle }
        }
        let sample = slide.sample(low);
        let (theta, rate) = (sample.state.theta, sample.state.theta_rate);
        (
            (theta - end.theta).abs(),
            sample.normal,
            1.0 - h * libm::cos(theta) * rate * rate,
        )
    };
    let (near, far) = (at(1e-9), at(1e-8));
    let slope = |a: f64, b: f64| libm::log(a / b) / libm::log(near.0 / far.0);
    // The next term of 1 − h cos θ θ′² is x, x^(1 − λ) in relation to the first: 1e-4 here.
    assert!(
        (slope(near.1, far.1) - (lambda - 1.0)).abs() < 1e-3,
        "{} {lambda}",
        slope(near.1, far.1)
    );
    assert!(
        (slope(near.2, far.2) - lambda).abs() < 1e-3,
        "{} {lambda}",
        slope(near.2, far.2)
    );
}

/// With k1 = 0 the slip ends at the impulse P1 = |u| |B|/(A C − B²), θ′ jumps by −P1/(m h sin θ),
/// and only Poisson's law lets the gap open, at k2 e P1.
#[test]
fn the_slide_goes_on_by_a_jam() {
    let (mass, mu_k, start) = runs_into_it();
    for law in RestitutionLaw::ALL {
        let e = 0.6;
        let hoop = hoop(mass, mu_k)
            .with_restitution(Restitution::new(e, law).expect("a coefficient"))
            .expect("heavy");
        let motion = hoop.simulate(start, limits()).expect("a valid start");
        let jam = motion
            .transitions()
            .iter()
            .find(|it| it.cause == Cause::Jam)
            .expect("jams");
        assert_eq!(
            (jam.from, jam.to),
            (Some(Mode::Sliding), Some(Mode::Flight))
        );
        let impact = jam.impact.expect("an impact");
        assert_eq!(
            (impact.case, impact.after.slip, jam.after.slip),
            (ImpactCase::Jams, 0.0, 0.0)
        );
        let Body::Heavy(body) = hoop.body() else {
            panic!("heavy")
        };
        let (sin, cos) = libm::sincos(jam.before.theta);
        let (arm, lever) = (body.h * sin, 1.0 + body.h * cos);
        let a = 1.0 / body.mass + lever * lever / body.inertia;
        let b = arm * lever / body.inertia;
        let denominator = body.inertia + body.mass * (arm * arm + lever * lever);
        let determinant = denominator / (body.mass * body.mass * body.inertia);
        let ends = jam.before.slip.abs() * b.abs() / determinant;
        let after_compression = jam.before.theta_rate - ends / (body.mass * arm);
        let k2 = determinant / a;
        let (opening, more) = if law == RestitutionLaw::Poisson {
            (k2 * e * ends, e * ends)
        } else {
            (0.0, 0.0)
        };
        assert!(
            (impact.after.gap_rate - opening).abs() < 1e-7,
            "{law}: {impact:?}"
        );
        assert!((impact.impulse.normal - ends - more).abs() < 1e-7);
        let rate = after_compression + more * arm / (body.mass * a * body.inertia);
        assert!(
            (jam.after.theta_rate - rate).abs() < 1e-7,
            "{} {rate}",
            jam.after.theta_rate
        );
    }
}

/// Where D_χ < 0 a hoop that sticks stops dead: P = m |h sin θ θ′|, J = m (1 + h cos θ) θ′, and the
/// energy of the rotation is lost (eq. dead-stop).
#[test]
fn a_hoop_that_sticks_stops_dead() {
    let mut seen = 0;
    for number in 0..4_000 {
        let mut draw = Draw::of_case(54, 1, number);
        let mass = draw.between([0.01, 0.3]);
        let parameters = HoopParameters::thin(mass)
            .with_friction(9.0, draw.between([0.0, 9.0]))
            .with_rolling_resistance(draw.between([1.0, 5.0]));
        let law = draw.one_of(RestitutionLaw::ALL.as_slice());
        let hoop = Hoop::new(parameters.with_restitution(0.0, law)).expect("a valid hoop");
        let Body::Heavy(body) = hoop.body() else {
            panic!("heavy")
        };
        let (theta, rate) = (draw.between([2.0, 3.1]), draw.between([0.1, 2.0]));
        let (sin, cos) = libm::sincos(theta);
        let (arm, lever) = (body.h * sin, 1.0 + body.h * cos);
        let about = body.inertia + body.mass * lever * lever;
        let (chi, sign) = (hoop.rolling_resistance(), draw.one_of(&[-1.0, 1.0]));
        let sticks = body.mass * lever * (chi - arm) <= 8.9 * about;
        let jam = hoop.jam(
            &Start::at(sign * theta, sign * rate)
                .check()
                .expect("a start"),
        );
        if about + body.mass * arm * (arm - chi) > -1e-3 || !sticks {
            continue;
        }
        let jam = jam.expect("jams");
        assert_eq!((jam.case, jam.after.theta_rate), (ImpactCase::Jams, 0.0));
        assert_eq!((jam.after.slip, jam.after.gap_rate), (0.0, 0.0));
        let lost = 0.5 * (about + body.mass * arm * arm) * rate * rate;
        for (ours, theirs) in [
            (jam.impulse.normal, body.mass * arm * rate),
            (jam.impulse.friction, sign * body.mass * lever * rate),
            (jam.energy_lost(), lost),
        ] {
            assert!((ours - theirs).abs() < 1e-13, "{ours} {theirs} {jam:?}");
        }
        seen += 1;
    }
    assert!(seen > 500, "{seen}");
}

/// The command of the notes: next to P = 0 the slip has already ended, closer than doubles resolve.
#[test]
fn a_slip_that_ends_before_sticks() {
    let parameters = HoopParameters::thin(0.0)
        .with_inertia(1e-3)
        .with_friction(0.5, 0.5);
    let hoop = Hoop::new(parameters.with_restitution(0.0, RestitutionLaw::Energetic))
        .expect("a valid hoop");
    let start = Start::at(1.2, -0.9).with_slip(0.5);
    let motion = hoop
        .simulate(start, Limits::default().with_transitions(1))
        .expect("a valid start");
    let [stick] = motion.transitions() else {
        panic!("{:?}", motion.transitions())
    };
    assert_eq!(
        (stick.from, stick.cause, stick.to),
        (Some(Mode::Sliding), Cause::Stick, Some(Mode::Rolling))
    );
}

/// Jams, ends of the slip and lift-offs next to P = 0, at 1e-1 to 1e-30 from it, and with slips
/// that are 1e-11 of themselves from that which is just spent, against an integration with 80
/// digits of `evidence/reference/jams.py`.
#[test]
fn slides_end_next_to_p_0_as_at_80_digits() {
    let data: Value = serde_json::from_str(JAMS).expect("evidence/reference/jams.json");
    let number = |value: &Value| {
        value
            .as_f64()
            .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
    };
    let mut seen = [0; 4];
    for record in data["jams"].as_array().expect("a list") {
        let [mass, offset, inertia] = [0, 1, 2].map(|at| number(&record["hoop"][at]));
        let [theta, theta_rate, slip] = [0, 1, 2].map(|at| number(&record["start"][at]));
        let mu = number(&record["mu"]);
        let hoop = Hoop::new(
            HoopParameters::thin(mass)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu, mu),
        )
        .expect("a valid hoop");
        for mirror in [1.0, -1.0] {
            let start = Start::at(mirror * theta, mirror * theta_rate).with_slip(mirror * slip);
            let motion = hoop
                .simulate(start, Limits::default().with_transitions(1))
                .expect("a valid start");
            let [first, ..] = motion.transitions() else {
                panic!("{record} {:?}", motion.outcome())
            };
            let kind = match first.cause {
                Cause::Singularity => "jam",
                Cause::Stick | Cause::Reversal => "stick",
                Cause::LiftOff => "lift_off",
                other => panic!("{record} {other}"),
            };
            assert_eq!(kind, record["end"].as_str().expect("a word"), "{record}");
            let end = first.before;
            // A last digit of the start, where it has the most effect: the rate at the end of a
            // slide that comes from far and slowly.
            let size = 1.0 + end.theta_rate.abs();
            for (what, ours, tolerance) in [
                ("time", end.time, 1e-12),
                ("theta", mirror * end.theta, 1e-12),
                ("theta_rate", mirror * end.theta_rate, 1e-12 * size * size),
                ("slip", mirror * end.slip, 1e-12 * size),
            ] {
                let theirs = number(&record[what]);
                assert!(
                    (ours - theirs).abs() <= tolerance,
                    "{record} {what}: {ours} is not {theirs}"
                );
            }
            let resolved = record["distance"]
                .as_str()
                .is_some_and(|it| it.parse::<f64>().expect("a number") > 1e-15);
            seen[match kind {
                "jam" => 0,
                "lift_off" => 1,
                _ if resolved => 2,
                _ => 3,
            }] += 1;
        }
    }
    assert!(seen.iter().all(|number| *number > 5), "{seen:?}");
}

fn rough() -> impl Strategy<Value = Hoop> {
    (0.01..0.4_f64, 0.4..1.5_f64, 0.0..=1.0_f64).prop_map(|(mass, mu, part)| {
        Hoop::new(HoopParameters::thin(mass).with_friction(mu, mu * part)).expect("a valid hoop")
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// λ > 1 lifts off first, and λ < 0 stops slipping first, if only by less than doubles resolve.
    #[test]
    fn slides_run_into_it_only_where_the_exponent_allows(hoop in rough(), start in start()) {
        let motion = hoop.simulate(start, limits()).expect("a valid start");
        if let Outcome::Singular { state, .. } = motion.outcome() {
            let lambda = exponent(&hoop, state.theta, state.slip);
            prop_assert!(lambda < 1.0 && lambda > 0.0, "{lambda}");
        }
    }

    /// P < 0 with slip, and the plane holds the rim: no motion is consistent, and with restitution
    /// the slip ends at once.
    #[test]
    fn inconsistent_starts_jam(hoop in rough(), start in start(), e in 0.0..=1.0_f64) {
        let start = if start.slip == 0.0 { start.with_slip(0.7) } else { start };
        let plain = hoop.simulate(start, limits()).expect("a valid start");
        let restitution = Restitution::new(e, RestitutionLaw::Energetic).expect("a coefficient");
        let motion = hoop.with_restitution(restitution).expect("heavy").simulate(start, limits()).expect("a valid start");
        let direction = littlewood::SlipDirection::of_sign(start.slip).expect("slips");
        let law = SlidingLaw::new(&hoop, direction, RotationDirection::Positive).expect("heavy");
        let (p, w) = (law.painleve(start.theta), law.contact(start.theta, start.theta_rate));
        if p < 0.0 && w > 0.0 {
            prop_assert!(plain.phases().is_empty() && plain.outcome().kind() == OutcomeKind::Inconsistent);
            let jam = motion.transitions().first().expect("jams");
            prop_assert_eq!((jam.cause, jam.from, jam.time()), (Cause::Jam, None, start.time));
            prop_assert_eq!((jam.before.slip, jam.after.slip), (start.slip, 0.0));
            prop_assert!(jam.impact.expect("an impact").energy_lost() >= 0.0);
        } else if p < 0.0 && w < 0.0 {
            // Indeterminate: flight and sliding are both consistent.
            prop_assert_eq!(motion.outcome().kind(), OutcomeKind::Ambiguous);
            prop_assert!(motion.transitions().is_empty());
        }
    }
}
