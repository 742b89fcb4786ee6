//! The engine against the simulation: the same outcome and sequence for every start, times to
//! rounding, as `promise.rs` compares them.

#![allow(clippy::panic)] // a failed comparison
#![allow(clippy::disallowed_methods)] // starts may come from the platform's mathematics

use std::f64::consts::PI;

use crate::common::{
    any_slope, engines, heavy_hoop, heavy_motion, massless_hoop, moderate_hoop, random_starts,
    slope, start, tilted, whole_range,
};
use crate::promise::{
    agree, agree_to, agree_within, check, codes, compare, is_resolved, tolerance,
};
use littlewood::tables::{PhaseSequence, Quantity};
use littlewood::{
    Cause, Engine, Hoop, HoopParameters, Limits, OutcomeKind, Restitution, RestitutionLaw, Start,
    Summary,
};
use littlewood_random::Draw;
use proptest::prelude::*;

#[test]
fn the_figure_2_plane_has_the_outcomes_of_the_simulation() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let engine = Engine::new(&hoop);
    assert!(engine.is_prepared());
    for start in random_starts(40_000) {
        let ours = engine
            .summary(start, Limits::until(50.0))
            .expect("a valid start");
        let theirs = hoop
            .simulate(start, Limits::until(50.0))
            .expect("a valid start")
            .summary();
        if let Err(difference) = check(&ours, &theirs, tolerance(&theirs)) {
            panic!("{start:?}\n{difference}");
        }
    }
}

#[test]
fn the_figure_2_plane_has_the_bounces_of_the_simulation() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for (e, law) in [
        (0.0, RestitutionLaw::Energetic),
        (0.5, RestitutionLaw::Energetic),
        (0.3, RestitutionLaw::Poisson),
    ] {
        let hoop = hoop
            .with_restitution(Restitution::new(e, law).expect("a coefficient"))
            .expect("heavy");
        for (engine, count) in [
            (Engine::new(&hoop), 1_500),
            (Engine::builder(&hoop).expected_starts(1).build(), 500),
        ] {
            assert_eq!(engine.is_prepared(), count == 1_500);
            let starts: Vec<Start> = random_starts(count).collect();
            let mut other = 0;
            for start in &starts {
                let limits = Limits::until(30.0);
                let ours = engine.summary(*start, limits).expect("a valid start");
                let motion = hoop.simulate(*start, limits).expect("a valid start");
                // Bounces amplify rounding, so that some motions have no sequence in double
                // precision.
                other += usize::from(codes(&ours) != codes(&motion.summary()));
                if let Err(difference) = compare(&ours, &motion, limits, tolerance(&ours), true) {
                    panic!("e = {e}: {start:?}\n{difference}");
                }
            }
            assert!(
                other * 50 < starts.len(),
                "e = {e}: {other} of {}",
                starts.len()
            );
        }
    }
}

#[test]
fn counts_of_the_figure_2_plane() {
    // As in tests/counts.rs, where their origin is told.
    let engine = Engine::new(&Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2"));
    let (mut at_once, mut later, mut in_contact) = (0, 0, 0);
    for i in 0..200 {
        for j in 0..200 {
            let start = Start::at(
                -PI + 2.0 * PI * f64::from(j) / 199.0,
                -4.0 + 8.0 * f64::from(i) / 199.0,
            );
            let summary = engine
                .summary(start, Limits::until(50.0))
                .expect("a valid start");
            match (summary.lift_off_time.is_nan(), summary.lift_off_time == 0.0) {
                (true, _) => in_contact += 1,
                (false, true) => at_once += 1,
                (false, false) => later += 1,
            }
        }
    }
    assert_eq!((at_once, later, in_contact), (9_784, 12_690, 17_526));
}

#[test]
fn figure_3_has_the_times_of_the_40_digit_table() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for engine in engines(&hoop) {
        let summary = engine
            .summary(Start::at(PI / 2.0, 2.0), Limits::default())
            .expect("a valid start");
        assert_eq!(summary.sequence.to_string(), "-R+F");
        assert!((summary.first_slip_time - 0.973_223_074_772_405_4).abs() < 1e-14);
        assert!((summary.lift_off_time - 1.518_670_213_819_437).abs() < 1e-14);
        assert!((summary.end.time - 3.847_395_556_686_894).abs() < 1e-14);
    }
}

#[test]
fn bodies_that_cannot_be_prepared_are_simulated() {
    let parameters = [
        HoopParameters::thin(0.0).with_friction(0.5, 0.4),
        HoopParameters::thin(1.0)
            .with_offset(0.0)
            .with_inertia(0.5)
            .with_friction(0.5, 0.4),
    ];
    for parameters in parameters {
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let engine = Engine::new(&hoop);
        assert!(!engine.is_prepared() && engine.is_exact());
        let start = Start::at(0.3, 0.4).with_slip(0.2);
        let ours = engine
            .summary(start, Limits::until(20.0))
            .expect("a valid start");
        let theirs = hoop
            .simulate(start, Limits::until(20.0))
            .expect("a valid start")
            .summary();
        assert_eq!(check(&ours, &theirs, 0.0), Ok(()));
    }
}

/// Random hoops and starts, with coefficients of every size, and often at rest or next to where the
/// hoop begins to turn.
#[test]
fn rolling_resistance_has_the_motions_of_the_simulation() {
    for number in 0..3_000 {
        let (hoop, start) = Draw::of_case(31, 0, number).resisted_in_contact();
        if is_resolved(&start) {
            agree(&hoop, &[start]).unwrap_or_else(|difference| panic!("{number}: {difference}"));
        }
    }
}

/// The hoop of the paper, with coefficients from where it swings a thousand times to where it rests
/// anywhere.
#[test]
fn the_figure_2_plane_with_rolling_resistance_has_the_motions_of_the_simulation() {
    let figure_2 = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let starts: Vec<Start> = random_starts(200).collect();
    for exponent in -16..=2 {
        let chi = libm::pow(10.0, 0.25 * f64::from(exponent));
        let parameters = figure_2.parameters().with_rolling_resistance(chi);
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        agree(&hoop, &starts).unwrap_or_else(|difference| panic!("{chi}: {difference}"));
    }
}

/// A start that is left to the simulation has the same answer and takes far longer: only a count
/// shows how many there are.
#[test]
fn little_rolling_resistance_is_left_to_the_simulation() {
    let figure_2 = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for chi in [0.01, 0.05, 0.2] {
        let parameters = figure_2.parameters().with_rolling_resistance(chi);
        let engine = Engine::new(&Hoop::new(parameters).expect("a valid hoop"));
        assert!(engine.is_prepared() && !engine.is_exact());
        for start in random_starts(2_000) {
            engine
                .summary(start, Limits::until(50.0))
                .expect("a valid start");
        }
        let left: u64 = engine.fallbacks().map(|(_, count)| count).sum();
        assert!(left < 20, "{chi}: {left}");
    }
}

/// On the whole accepted range of hoops and starts.
#[test]
fn any_hoop_with_rolling_resistance_has_the_motions_of_the_simulation() {
    let limits = |start: &Start| Limits::until(start.time + 10.0).with_transitions(30);
    for number in 0..1_000 {
        let mut draw = Draw::of_case(32, 4, number);
        let (hoop, start) = draw.heavy_motion();
        let hoop = draw.resisted(&hoop);
        if is_resolved(&start) {
            agree_to(limits, &hoop, &[start])
                .unwrap_or_else(|difference| panic!("{number}: {difference}"));
        }
    }
}

#[test]
fn many_starts_have_the_summaries_of_each() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for engine in engines(&hoop) {
        let starts: Vec<Start> = random_starts(100).collect();
        let summaries = engine.summaries(starts.iter().copied(), Limits::default());
        let summaries: Vec<Summary> = summaries.collect::<Result<_, _>>().expect("valid starts");
        assert_eq!(summaries.len(), starts.len());
        for (start, many) in starts.into_iter().zip(summaries) {
            let one = engine
                .summary(start, Limits::default())
                .expect("a valid start");
            assert_eq!(check(&many, &one, 0.0), Ok(()));
        }
        let refused = engine.summaries([Start::default(), Start::at(0.0, 1e7)], Limits::default());
        let refused = refused
            .collect::<Result<Vec<_>, _>>()
            .expect_err("too fast");
        assert_eq!(
            (refused.index, refused.error.quantity()),
            (1, Quantity::ThetaRate)
        );
        assert_eq!(refused.to_string(), format!("start 1: {}", refused.error));
    }
}

#[test]
fn bad_starts_and_limits_are_refused_as_by_the_simulation() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let engine = Engine::new(&hoop);
    for (start, limits) in [
        (Start::at(f64::NAN, 0.0), Limits::default()),
        (Start::at(0.0, 1e7), Limits::default()),
        (Start::at(0.0, 1.0).with_time(2.0), Limits::until(1.0)),
        (Start::at(0.0, 1.0), Limits::until(f64::NAN)),
    ] {
        let ours = engine.summary(start, limits).expect_err("must be refused");
        let theirs = hoop.simulate(start, limits).expect_err("must be refused");
        assert_eq!(ours.to_string(), theirs.to_string());
    }
}

#[test]
fn a_sequence_of_phases_keeps_its_length_in_64_bits() {
    use littlewood::{Mode, SlipDirection};
    let mut sequence = PhaseSequence::default();
    assert!(sequence.is_empty());
    for i in 0..25_u32 {
        sequence.push(
            Mode::Sliding,
            Some(if i % 2 == 0 {
                SlipDirection::Positive
            } else {
                SlipDirection::Negative
            }),
        );
        assert_eq!(sequence.len(), (i + 1).min(PhaseSequence::CAPACITY));
        assert_eq!(sequence.is_truncated(), i >= PhaseSequence::CAPACITY);
    }
    assert_eq!(sequence.to_string(), format!("{}…", "+-".repeat(7) + "+"));
    assert_eq!(PhaseSequence::from_bits(sequence.bits()), sequence);
    for outcome in OutcomeKind::ALL {
        assert_eq!(OutcomeKind::try_from(outcome.code()), Ok(outcome));
        assert_eq!(outcome.name().parse(), Ok(outcome));
    }
}

/// Rates, angles and slips of every size that is accepted, without restitution and with it: a row
/// of a list has the summary of the simulation, however long the list is, and so whether there are
/// tables or not.
#[test]
fn the_whole_accepted_range_has_the_outcomes_of_the_simulation() {
    let figure_2 = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let bounces = Restitution::new(0.5, RestitutionLaw::Energetic).expect("a coefficient");
    let bouncing = figure_2.with_restitution(bounces).expect("heavy");
    let limits = |_: &Start| Limits::default().with_transitions(60);
    let mut draw = Draw::of_case(32, 2, 0);
    for hoop in [figure_2, bouncing] {
        let starts: Vec<Start> = (0..3_000)
            .map(|_| {
                let mut signed = |powers: [f64; 2]| {
                    let size = draw.of_any_size(powers);
                    if draw.comes(0.5) { -size } else { size }
                };
                let start = Start::at(signed([-3.0, 9.0]), signed([-3.0, 6.0]));
                let slip = signed([-3.0, 6.0]);
                if draw.comes(0.5) {
                    start.with_slip(slip)
                } else {
                    start
                }
            })
            .collect();
        agree_to(limits, &hoop, &starts).unwrap_or_else(|difference| panic!("{difference}"));
    }
    for number in 0..2_000 {
        let (hoop, start) = Draw::of_case(32, 3, number).heavy_motion();
        if is_resolved(&start) {
            agree_to(limits, &hoop, &[start])
                .unwrap_or_else(|difference| panic!("{number}: {difference}"));
        }
    }
}

/// An angle of five million turns, and a rate at which 1 − h cos θ θ′² is known to 1e-4 only: a
/// lift-off is no slide.
#[test]
fn a_lift_off_is_not_followed_by_a_slide_that_rounding_makes() {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for (start, sequence, transitions) in [
        (
            Start::at(31_568_288.730_131_123, 1.850_239_055_064_361_3),
            None,
            4,
        ),
        (
            Start::at(-1.875_962_099_565_172_2, -262_167.054_687_522_5),
            Some("+R-F"),
            4,
        ),
        (
            Start::at(-2.293_191_047_483_457_4, -835_327.110_467_008_5),
            Some("+R-F"),
            4,
        ),
    ] {
        for engine in engines(&hoop) {
            let summary = engine
                .summary(start, Limits::default())
                .expect("a valid start");
            assert_eq!(
                (summary.outcome, summary.transitions),
                (OutcomeKind::Landing, transitions),
                "{start:?}"
            );
            if let Some(sequence) = sequence {
                assert_eq!(summary.sequence.to_string(), sequence);
            }
        }
    }
}

/// Next to P = 0 a fast slide changes within 1e-13, where powers of the time overflow.
#[test]
fn a_slide_of_huge_friction_sticks_before_its_series_overflow() {
    let hoop = HoopParameters::thin(1.036_161_741_010_089_8)
        .with_offset(0.324_490_197_616_359_2)
        .with_friction(1e9, 9.76e8)
        .with_slope(-0.753_307_552_346_465_5);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let start = Start::at(-3.126_493_965_512_413, 1e-300).with_slip(1e6);
    agree(&hoop, &[start]).unwrap_or_else(|difference| panic!("{difference}"));
    let motion = hoop.simulate(start, Limits::default().with_transitions(1));
    let motion = motion.expect("a valid start");
    assert_eq!(motion.transitions()[0].cause, Cause::Stick);
}

/// A slide of thirty turns adds up the rounding of θ, but not of its sine and cosine.
#[test]
fn a_jump_out_of_a_slide_over_many_turns_has_the_length_of_the_simulation() {
    let hoop = HoopParameters::thin(2.681_111_627_639_557)
        .with_inertia(2.906_948_568_515_596)
        .with_offset(0.321_518_095_155_202_3)
        .with_friction(0.208_400_877_069_873_04, 0.015_704_053_006_507_98)
        .with_slope(0.190_380_574_999_718_03);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let start = Start::at(2.789_187_302_707_429_4, -0.001);
    agree_within(100.0, &hoop, &[start]).unwrap_or_else(|difference| panic!("{difference}"));
}

/// Regimes of all kinds, with their starts over the whole plane.
#[test]
fn every_regime_has_the_outcomes_of_the_simulation() {
    let regimes = [
        (
            "P ≤ 0 at some angles",
            HoopParameters::thin(0.2)
                .with_inertia(0.1)
                .with_friction(1.5, 1.4),
        ),
        (
            "P ≤ 0 and equal coefficients",
            HoopParameters::thin(1.0 / 3.0).with_friction(1.0, 1.0),
        ),
        (
            "equal coefficients",
            HoopParameters::thin(1.0).with_friction(0.5, 0.5),
        ),
        (
            "nearly equal coefficients",
            HoopParameters::thin(1.0).with_friction(0.5, 0.4999),
        ),
        (
            "coefficients that differ a little",
            HoopParameters::thin(1.0).with_friction(0.5, 0.499),
        ),
        (
            "slips next to turning points",
            HoopParameters::thin(2.0)
                .with_inertia(0.5)
                .with_friction(0.2, 0.1999),
        ),
        (
            "no kinetic friction",
            HoopParameters::thin(1.0).with_friction(0.5, 0.0),
        ),
        (
            "no friction",
            HoopParameters::thin(1.0).with_friction(0.0, 0.0),
        ),
        (
            "little friction",
            HoopParameters::thin(1.0).with_friction(2e-3, 1e-3),
        ),
        (
            "some friction",
            HoopParameters::thin(1.0).with_friction(0.05, 0.04),
        ),
        ("thin", HoopParameters::thin(0.05).with_friction(0.5, 0.4)),
        (
            "light",
            HoopParameters::thin(0.0)
                .with_inertia(1e-2)
                .with_friction(0.5, 0.4),
        ),
        (
            "light with equal coefficients",
            HoopParameters::thin(0.0)
                .with_inertia(1e-2)
                .with_friction(0.5, 0.5),
        ),
        (
            "very light",
            HoopParameters::thin(0.0)
                .with_inertia(1e-5)
                .with_friction(0.5, 0.4),
        ),
        (
            "nearly balanced",
            HoopParameters::thin(1.0)
                .with_offset(0.01)
                .with_friction(0.5, 0.4),
        ),
        (
            "the hoop of Figure 2",
            HoopParameters::thin(1.0).with_friction(0.5, 0.4),
        ),
    ];
    for (name, parameters) in regimes {
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let starts: Vec<Start> = random_starts(300).collect();
        if let Err(difference) = agree(&hoop, &starts) {
            panic!("{name}: {difference}");
        }
    }
}

/// The same on slopes, on which a hoop may roll down, swing, or slide down for ever.
#[test]
fn regimes_on_slopes_have_the_outcomes_of_the_simulation() {
    let bounces = Restitution::new(0.5, RestitutionLaw::Energetic).expect("a coefficient");
    let regimes = [
        HoopParameters::thin(1.0).with_friction(0.5, 0.4),
        HoopParameters::thin(1.0).with_friction(0.5, 0.5),
        HoopParameters::thin(1.0).with_friction(0.5, 0.0),
        HoopParameters::thin(1.0).with_friction(0.0, 0.0),
        HoopParameters::thin(1.0).with_friction(0.05, 0.04),
        HoopParameters::thin(0.2)
            .with_inertia(0.1)
            .with_friction(1.5, 1.4),
        HoopParameters::thin(0.0)
            .with_inertia(1e-2)
            .with_friction(0.5, 0.4),
        HoopParameters::thin(1.0)
            .with_offset(0.05)
            .with_friction(0.5, 0.4),
    ];
    for (number, parameters) in regimes.into_iter().enumerate() {
        for (slope, e) in [
            (1e-9, false),
            (0.05, false),
            (-0.1, true),
            (0.5, true),
            (-1.2, false),
        ] {
            let hoop = Hoop::new(parameters.with_slope(slope)).expect("a valid hoop");
            let hoop = if e {
                hoop.with_restitution(bounces).expect("heavy")
            } else {
                hoop
            };
            let starts: Vec<Start> = random_starts(150).collect();
            let limits =
                |_: &Start| Limits::until(if e { 5.0 } else { 30.0 }).with_transitions(300);
            if let Err(difference) = agree_to(limits, &hoop, &starts) {
                panic!("{number}, {slope}: {difference}");
            }
        }
    }
}

/// A hoop on a plane of little friction, on which a slide lasts for many periods and is reversed
/// many times, and starts of such slides: anywhere, close to the separatrix, close to the bottom,
/// and on the limit of static friction there.
fn little_friction() -> impl Strategy<Value = (Hoop, Vec<Start>)> {
    let part = prop_oneof![Just(1.0), 0.3..1.0_f64, (1.0 - 1e-6)..1.0_f64];
    let hoop = (
        0.0..2.0_f64,
        0.1..=1.0_f64,
        0.1..2.0_f64,
        -4.5..-1.0_f64,
        part,
    )
        .prop_map(|(mass, offset, inertia, exponent, part)| {
            let mu = libm::pow(10.0, exponent);
            Hoop::new(
                HoopParameters::thin(mass)
                    .with_offset(offset)
                    .with_inertia(inertia)
                    .with_friction(mu, mu * part),
            )
            .expect("a valid hoop")
        });
    let slip = prop_oneof![2 => Just(0.0), 3 => -4.0..4.0_f64, 1 => -1e-3..1e-3_f64];
    let small = (-4.0..0.0_f64, prop::bool::ANY)
        .prop_map(|(exponent, plus)| libm::pow(10.0, exponent) * if plus { 1.0 } else { -1.0 });
    let place = (0..4_u8, -PI..PI, -4.0..4.0_f64, small.clone(), small);
    let starts = prop::collection::vec((place, slip), 6);
    (hoop, starts).prop_map(|(hoop, starts)| {
        let h = hoop.h();
        let inertia = hoop.body().inertia_about_mass_centre();
        // θ′ at the bottom on the separatrix of slides without friction.
        let separatrix = 2.0 * (hoop.offset() / inertia).sqrt();
        let start = |((kind, theta, rate, first, second), slip): (
            (u8, f64, f64, f64, f64),
            f64,
        )| match kind {
            0 => Start::at(theta, rate).with_slip(slip),
            1 => Start::at(PI, separatrix * (1.0 + 0.1 * first)).with_slip(slip),
            2 => Start::at(PI + 0.3 * first, 0.3 * second).with_slip(slip),
            // There |F| = μs N near the bottom, about.
            _ => {
                let limit = hoop.mu_s() * (inertia + hoop.mass() * (1.0 - h) * (1.0 - h));
                let theta = limit / (hoop.mass() * h * (1.0 - h)).max(1e-3);
                Start::at(PI - theta.min(1.0) * (1.0 + 0.1 * first), 0.1 * second)
            }
        };
        (hoop, starts.into_iter().map(start).collect())
    })
}

/// A hoop without an equilibrium on its slope goes downhill, however slowly it starts.
#[test]
fn rates_whose_squares_underflow_roll_downhill() {
    let parameters = HoopParameters::thin(1.2573956572474367)
        .with_offset(0.1362667187929199)
        .with_inertia(0.2)
        .with_friction(0.05, 0.0)
        .with_slope(0.32079658659971394);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let from_rest = hoop.simulate(Start::at(1.5707963267957452, 0.0), Limits::until(30.0));
    let from_rest = from_rest.expect("a valid start").summary();
    for power in 100..=323 {
        for rate in [
            1.287_312_555_418_065 * libm::exp10(-f64::from(power)),
            -1.287_312_555_418_065 * libm::exp10(-f64::from(power)),
        ] {
            let start = Start::at(1.5707963267957452, rate);
            let summary = Engine::new(&hoop).summary(start, Limits::until(30.0));
            let summary = summary.expect("a valid start");
            assert_eq!(summary.outcome, from_rest.outcome, "{rate:e}");
            assert_eq!(summary.sequence, from_rest.sequence, "{rate:e}");
            assert!(
                (summary.end.time - from_rest.end.time).abs() < 1e-12,
                "{rate:e}"
            );
        }
    }
}

#[test]
fn a_hoop_whose_motion_amplifies_rounding_has_no_tables() {
    let parameters = HoopParameters::thin(1.773_133_977_533_948_6e-9)
        .with_friction(4.548_147_209_245_034_4e-8, 4.548_147_209_245_034_4e-8);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let start = Start::at(1.436_435_801_570_961_3e-8, 7.332_570_607_245_862e-7)
        .with_slip(0.612_359_007_087_091_5);
    assert!(!Engine::new(&hoop).is_prepared());
    if let Err(difference) = agree(&hoop, &[start]) {
        panic!("{difference}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_moderate_hoop_has_the_outcomes_of_the_simulation(
        hoop in moderate_hoop(), starts in prop::collection::vec(start(), 20),
    ) {
        agree(&hoop, &starts)?;
    }

    #[test]
    #[ignore = "thorough"]
    fn any_heavy_hoop_has_the_outcomes_of_the_simulation(
        (hoop, first) in heavy_motion(), starts in prop::collection::vec(start(), 3),
    ) {
        agree(&hoop, &starts)?;
        agree(&hoop, &[first])?;
    }

    #[test]
    fn any_motion_of_the_whole_range_is_that_of_the_simulation((hoop, start) in whole_range()) {
        prop_assume!(is_resolved(&start));
        agree(&hoop, &[start])?;
    }

    #[test]
    #[ignore = "thorough"]
    fn any_moderate_hoop_on_a_slope_has_the_outcomes_of_the_simulation(
        hoop in moderate_hoop(), slope in any_slope(), starts in prop::collection::vec(start(), 20),
    ) {
        agree(&tilted(&hoop, slope), &starts)?;
    }

    #[test]
    #[ignore = "thorough"]
    fn any_heavy_hoop_on_a_slope_has_the_outcomes_of_the_simulation(
        (hoop, first) in heavy_motion(), slope in any_slope(), starts in prop::collection::vec(start(), 3),
    ) {
        let hoop = tilted(&hoop, slope);
        agree(&hoop, &starts)?;
        agree(&hoop, &[first])?;
    }

    #[test]
    fn any_motion_of_the_whole_range_on_a_slope_is_that_of_the_simulation(
        (hoop, start) in whole_range(), slope in any_slope(),
    ) {
        prop_assume!(is_resolved(&start));
        agree(&tilted(&hoop, slope), &[start])?;
    }

    /// Next to rest at the bottom, or where friction holds the particle in a slide: two turning
    /// points close to each other, between which u is smaller than the last digits of its terms.
    #[test]
    #[ignore = "thorough"]
    fn motions_next_to_rest_are_those_of_the_simulation(
        hoop in heavy_hoop(), small in prop::collection::vec((0.0..10.0_f64, 0.0..10.0_f64, -10.0..0.3_f64, 0..16_u8), 8),
    ) {
        let has = |bits: u8, bit: u8| bits & bit != 0;
        let signed = |bits: u8, bit: u8, size: f64| if has(bits, bit) { size } else { -size };
        let starts: Vec<Start> = small
            .into_iter()
            .map(|(angle, rate, slip, bits)| {
                // q = h sin θ − μk σ (1 + h cos θ) vanishes there.
                let friction = signed(bits, 4, hoop.mu_k());
                let held = PI + friction.atan() - (friction / (hoop.h() * friction.hypot(1.0))).asin();
                let rest = if has(bits, 8) && held.is_finite() { held } else { PI };
                let start = Start::at(rest + signed(bits, 1, 10.0_f64.powf(-angle)), signed(bits, 2, 10.0_f64.powf(-rate)));
                start.with_slip(signed(bits, 4, 10.0_f64.powf(slip)))
            })
            .collect();
        agree(&hoop, &starts)?;
    }

    /// Whether a turning point is ahead is told by θ′, also where its square underflows: an endless
    /// slide is known for one from the third on.
    #[test]
    fn slides_next_to_turning_points_have_the_outcomes_of_the_simulation(
        hoop in moderate_hoop(), slope in prop_oneof![1 => Just(0.0), 3 => slope()],
        starts in prop::collection::vec((start(), -324.0..-3.0_f64, any::<bool>()), 6),
        until in 0.5..2.5_f64,
    ) {
        let starts: Vec<Start> = starts
            .into_iter()
            .map(|(start, power, up)| {
                // Rounds to the least double.
                let rate = libm::exp10(power).max(5e-324);
                Start::at(start.theta, if up { rate } else { -rate }).with_slip(start.slip)
            })
            .collect();
        agree_within(libm::exp10(until), &tilted(&hoop, slope), &starts)?;
    }

    /// Without friction a motion either lifts off or is proved to repeat itself.
    #[test]
    fn a_hoop_without_friction_has_the_outcomes_of_the_simulation(
        (hoop, first) in heavy_motion(), starts in prop::collection::vec(start(), 10),
    ) {
        let smooth = hoop.parameters().with_friction(0.0, 0.0);
        let hoop = Hoop::new(smooth).expect("a valid hoop");
        let engine = Engine::new(&hoop);
        for start in starts.into_iter().chain([first]) {
            let ours = engine.summary(start, Limits::default()).expect("a valid start");
            let motion = hoop.simulate(start, Limits::default()).expect("a valid start");
            if let Err(difference) = compare(&ours, &motion, Limits::default(), tolerance(&ours), true) {
                return Err(TestCaseError::fail(format!("{hoop:?}\n{start:?}\n{difference}")));
            }
        }
    }

    #[test]
    fn a_massless_hoop_has_the_summary_of_its_simulation(hoop in massless_hoop(), start in start()) {
        let limits = Limits::default().with_until(Some(20.0)).with_transitions(50);
        let ours = Engine::new(&hoop).summary(start, limits).unwrap();
        prop_assert_eq!(check(&ours, &hoop.simulate(start, limits).unwrap().summary(), 0.0), Ok(()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Slides over many periods, whole periods of which are passed at once, cut by a limit of time
    /// or not; and slides out of the limit of static friction next to turning points.
    #[test]
    #[ignore = "thorough"]
    fn little_friction_has_the_outcomes_of_the_simulation(
        (hoop, starts) in little_friction(), until in -1.0..3.0_f64,
    ) {
        agree_within(libm::pow(10.0, until), &hoop, &starts)?;
        agree_within(1e4, &hoop, &starts)?;
    }
}

/// Whatever is left to the simulation has the same answer, only later, which no test of answers
/// would notice.
#[test]
fn little_is_left_to_the_simulation() {
    let figure_2 = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let painleve = HoopParameters::thin(0.2)
        .with_inertia(0.1)
        .with_friction(1.5, 1.4);
    let painleve = Hoop::new(painleve).expect("a valid hoop");
    let sloping = tilted(&figure_2, 0.3);
    // The first phases of motions.
    let limits = Limits::default().with_transitions(1);
    for (hoop, many, few) in [
        (figure_2, 1000, 100),
        (painleve, 100, 100),
        (sloping, 100, 100),
    ] {
        for (engine, least) in [
            (Engine::new(&hoop), many),
            (Engine::builder(&hoop).expected_starts(1).build(), few),
        ] {
            let (mut all, steps) = (0, 60);
            for (i, j) in
                (0..steps).flat_map(|i| (0..steps).map(move |j| (f64::from(i), f64::from(j))))
            {
                let part = |k: f64| (2.0 * k + 1.0) / f64::from(steps) - 1.0;
                for slip in [-0.5, 0.0, 0.5] {
                    let start = Start::at(PI * part(i), 3.0 * part(j)).with_slip(slip);
                    engine.summary(start, limits).expect("a valid start");
                    all += 1;
                }
            }
            let fallbacks = Vec::from_iter(engine.fallbacks());
            let left: u64 = fallbacks.iter().map(|(_, count)| count).sum();
            assert!(least * left < all, "of {all}: {fallbacks:?}");
        }
    }
}
