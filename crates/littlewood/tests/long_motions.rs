//! The engine against the simulation in motions of many phases, periods and turns, which it passes at
//! once: chains of slips, periods without friction, and the limits that end them.

#![allow(clippy::panic)] // a failed comparison

use std::f64::consts::TAU;

use crate::common::{engines, random_starts, start};
use crate::promise::{agree, agree_to, check, codes, compare, tolerance};
use littlewood::many::Fallback;
use littlewood::modes::SlideLimit;
use littlewood::{Engine, Hoop, HoopParameters, Limits, Outcome, OutcomeKind, Proof, Start};
use proptest::prelude::*;

/// The walk counts the length of slides, whoever solves them, and chains of slips count theirs.
#[test]
fn limits_of_slides_are_reached_at_the_same_transition_by_all() {
    let start = Start::at(-0.377_337_068_499_461_6, 1.255_452_380_525_089_2);
    let mut reached = 0;
    for (hoop, start, slides) in [
        (Hoop::equal_masses(0.05, 1e-5), start, [1, 10, 100, 1_000]),
        (
            Hoop::equal_masses(0.05, 0.049),
            Start::at(-3.0, -2.5),
            [1, 5, 20, 60],
        ),
        (
            Hoop::equal_masses(0.5, 0.499),
            Start::at(-3.0, -2.5),
            [1, 3, 10, 20],
        ),
    ] {
        let hoop = hoop.expect("a hoop like that of Figure 2");
        let engines = engines(&hoop);
        for slides in slides {
            let limits = Limits::default()
                .with_slides(slides)
                .with_proof(Proof::None);
            let motion = hoop.simulate(start, limits).expect("a valid start");
            let theirs = motion.summary();
            if let Outcome::StepLimit { limit, .. } = motion.outcome() {
                assert_eq!(limit, SlideLimit::All { slides });
                reached += 1;
            }
            for engine in &engines {
                let ours = engine.summary(start, limits).expect("a valid start");
                assert_eq!(codes(&ours), codes(&theirs), "{slides}");
            }
        }
    }
    assert!(reached >= 9, "{reached}");
    let hoop = Hoop::equal_masses(0.05, 1e-5).expect("a hoop like that of Figure 2");
    let theirs = hoop
        .simulate(start, Limits::default())
        .expect("a valid start")
        .summary();
    for engine in engines(&hoop) {
        let ours = engine
            .summary(start, Limits::default())
            .expect("a valid start");
        assert_eq!(codes(&ours), codes(&theirs));
    }
}

/// A slide is endless from its third turning point on, here one period of 19.7 after the first. One
/// is ahead at once where θ′ is uphill, however small it is, and θ′² or its product with a later θ′
/// underflows. From rest, and downhill, the limit of time comes first.
#[test]
fn a_turning_point_next_to_the_start_is_counted_by_all() {
    let hoop = HoopParameters::thin(0.173_674_061_633_978_2)
        .with_offset(0.610_362_856_055_145_8)
        .with_inertia(1.0)
        .with_friction(0.211_000_311_017_209_5, 0.037_000_904_249_021_055)
        .with_slope(1.237_833_750_185_040_5);
    let hoop = Hoop::new(hoop).expect("a hoop");
    let limits = Limits::until(20.0);
    let least = f64::from_bits(1);
    for size in [0.0, least, 1e-300, 1e-160, 1e-20, 1e-10] {
        for rate in [size, -size] {
            let start = Start::at(4.992_112_780_877_53, rate).with_slip(-1.932_609_513_395_843_9);
            let expected = if rate > 0.0 {
                OutcomeKind::SlidesForever
            } else {
                OutcomeKind::TimeLimit
            };
            let motion = hoop.simulate(start, limits).expect("a valid start");
            assert_eq!(motion.summary().outcome, expected, "{rate:e}");
            for engine in engines(&hoop) {
                let ours = engine.summary(start, limits).expect("a valid start");
                assert_eq!(codes(&ours), codes(&motion.summary()), "{rate:e}");
            }
        }
    }
}

/// Motions on a smooth plane are periodic. The engine skips whole periods, and still stops at the
/// same limit of time, transitions or slides as the simulation.
#[test]
fn periods_on_a_smooth_plane_end_at_the_limits_of_the_simulation() {
    for (mass_ratio, inertia) in [(1.0, 1.0), (0.3, 0.1), (3.0, 0.5)] {
        let hoop = HoopParameters::thin(mass_ratio)
            .with_inertia(inertia)
            .with_friction(0.0, 0.0);
        let hoop = Hoop::new(hoop).expect("a hoop");
        let starts: Vec<Start> = random_starts(120)
            .map(|start| start.with_slip(0.1 * start.slip))
            .collect();
        let limits = |start: &Start| {
            // Some of each kind.
            let limits = Limits::until(150.0 + 30.0 * start.theta);
            limits
                .with_transitions(30 + (15.0 * start.theta_rate.abs()) as usize)
                .with_slides(250 + (200.0 * start.theta_rate.abs()) as usize)
        };
        let mut ends = [0; 3];
        for start in &starts {
            let motion = hoop.simulate(*start, limits(start)).expect("a valid start");
            match motion.outcome() {
                Outcome::TimeLimit { .. } => ends[0] += 1,
                Outcome::TransitionLimit { .. } => ends[1] += 1,
                Outcome::StepLimit { .. } => ends[2] += 1,
                _ => {}
            }
        }
        assert!(ends.iter().all(|count| *count > 2), "{ends:?}");
        agree_to(limits, &hoop, &starts).expect("the same motions");
    }
}

/// Where θ is known to a few parts of 10¹⁰ motions are computed, too, up to `MAX_ANGLE`.
#[test]
fn angles_of_some_million_radians_have_the_outcomes_of_the_simulation() {
    let thin = HoopParameters::thin(1.0);
    for hoop in [
        thin.with_friction(0.5, 0.4),
        thin.with_friction(1e-2, 1e-3),
        thin.with_friction(0.0, 0.0),
        thin.with_friction(0.5, 0.4).with_slope(0.01),
        thin.with_friction(0.5, 0.4).with_slope(-0.3),
        HoopParameters::thin(0.05).with_friction(0.3, 0.25),
        HoopParameters::thin(0.2)
            .with_inertia(0.1)
            .with_friction(1.5, 1.4),
    ] {
        let hoop = Hoop::new(hoop).expect("a hoop");
        let starts: Vec<Start> = random_starts(60)
            .map(|start| {
                let theta = start.theta + 2.2e6_f64.copysign(start.theta_rate);
                Start::at(theta, start.theta_rate).with_slip(start.slip)
            })
            .collect();
        agree(&hoop, &starts).expect("the same motions");
        let engine = Engine::new(&hoop);
        for start in starts {
            engine
                .summary(start, Limits::until(20.0))
                .expect("a valid start");
        }
        let far = engine
            .fallbacks()
            .find(|(reason, _)| *reason == Fallback::Far);
        assert_eq!(far.map(|(_, count)| count), Some(0));
    }
}

/// A hoop that swings for hundreds of slips: light, with μk below μs or as large, or with μk a
/// little below μs, or with P ≤ 0 at some angles.
fn swinging_hoop() -> impl Strategy<Value = Hoop> {
    let part = prop_oneof![0.3_f64..0.95, Just(1.0)];
    let light = (-2.5_f64..-0.5, 0.0_f64..0.2, 0.1_f64..1.2, part).prop_map(
        |(inertia, mass, mu_s, part)| {
            HoopParameters::thin(mass)
                .with_inertia(libm::pow(10.0, inertia))
                .with_friction(mu_s, part * mu_s)
        },
    );
    // With little friction a motion slips next to its turning points.
    let alike = (
        0.0_f64..2.0,
        0.1_f64..1.0,
        0.1_f64..2.0,
        -1.5_f64..0.0,
        -4.5_f64..-1.0,
    )
        .prop_map(|(mass, offset, inertia, friction, less)| {
            let mu_s = libm::pow(10.0, friction);
            HoopParameters::thin(mass)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_s * (1.0 - libm::pow(10.0, less)))
        });
    prop_oneof![light, alike].prop_map(|parameters| Hoop::new(parameters).expect("a valid hoop"))
}

/// Whole chains of slips, to their ends: the sums over thousands of phases, not one of which is
/// followed.
#[test]
fn chains_of_slips_are_those_of_the_simulation() {
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 32,
        max_shrink_iters: 0,
        ..ProptestConfig::default()
    });
    let longest = std::cell::Cell::new(0);
    let checked = runner.run(
        &(swinging_hoop(), prop::collection::vec(start(), 30)),
        |(hoop, starts)| {
            let (engine, direct) = (
                Engine::builder(&hoop).interpolate_slips().build(),
                Engine::builder(&hoop).expected_starts(1).build(),
            );
            for limits in [
                Limits::default().with_transitions(3_000),
                Limits::until(60.0),
            ] {
                for start in &starts {
                    let limits = limits.with_until(limits.until.map(|until| start.time + until));
                    let theirs = direct.summary(*start, limits).expect("a valid start");
                    if theirs.transitions < 20 {
                        continue;
                    }
                    let ours = engine.summary(*start, limits).expect("a valid start");
                    longest.set(longest.get().max(theirs.transitions));
                    let checked = check(&ours, &theirs, tolerance(&theirs)).or_else(|_| {
                        let motion = hoop.simulate(*start, limits).expect("a valid start");
                        compare(&ours, &motion, limits, tolerance(&theirs), false)
                    });
                    if let Err(difference) = checked {
                        return Err(TestCaseError::fail(format!(
                            "{hoop:?}\n{start:?} {limits:?}\n{difference}"
                        )));
                    }
                }
            }
            Ok(())
        },
    );
    if let Err(difference) = checked {
        panic!("{difference}");
    }
    assert!(longest.get() > 1_000, "{}", longest.get());
}

/// The same on gentle slopes, which hoops that go over the top slip down.
#[test]
fn chains_of_slips_down_slopes_are_those_of_the_simulation() {
    let mut longest = 0;
    for slope in [0.015, -0.01, 0.004, -0.001] {
        for (mu_s, mu_k) in [(0.5, 0.4), (0.5, 0.5), (0.3, 0.29)] {
            let hoop = HoopParameters::thin(1.0)
                .with_friction(mu_s, mu_k)
                .with_slope(slope);
            let hoop = Hoop::new(hoop).expect("a valid hoop");
            let (engine, direct) = (
                Engine::builder(&hoop).interpolate_slips().build(),
                Engine::builder(&hoop).expected_starts(1).build(),
            );
            assert!(engine.interpolates_slips() && !Engine::new(&hoop).interpolates_slips());
            let limits = Limits::default().with_transitions(1_000);
            for start in random_starts(60) {
                let theirs = direct.summary(start, limits).expect("a valid start");
                if theirs.transitions < 20 {
                    continue;
                }
                let ours = engine.summary(start, limits).expect("a valid start");
                longest = longest.max(theirs.transitions);
                let checked = check(&ours, &theirs, tolerance(&theirs)).or_else(|_| {
                    let motion = hoop.simulate(start, limits).expect("a valid start");
                    compare(&ours, &motion, limits, tolerance(&theirs), false)
                });
                if let Err(difference) = checked {
                    panic!("{hoop:?}\n{start:?} {limits:?}\n{difference}");
                }
            }
        }
    }
    assert_eq!(longest, 1_000);
}

/// The double at a multiple of 2π may lie to either side of it.
#[test]
fn motions_from_the_top_have_their_whole_turns() {
    // They roll, and slip on the way down.
    let hoop = Hoop::equal_masses(0.2, 0.1).expect("a hoop like that of Figure 2");
    let limits = Limits::default().with_transitions(2);
    for engine in engines(&hoop) {
        for turns in -9..=9 {
            let top = f64::from(turns) * TAU;
            for (theta, rate) in [top.next_down(), top, top.next_up()]
                .into_iter()
                .zip([0.9, -0.9, 0.9])
            {
                for start in [Start::at(theta, rate), Start::at(theta, -rate)] {
                    let ours = engine.summary(start, limits).expect("a valid start");
                    let theirs = hoop
                        .simulate(start, limits)
                        .expect("a valid start")
                        .summary();
                    assert_eq!(theirs.transitions, 2);
                    assert_eq!(check(&ours, &theirs, 1e-13), Ok(()));
                }
            }
        }
    }
}
