//! Next to the ends of what numbers tell: slides and flights that last for very long, friction and
//! inertia that are next to none.
#![allow(clippy::panic)] // a failed expectation

use std::f64::consts::FRAC_PI_2;

use crate::common::instants;
use crate::on_limits::Contact;
use littlewood::derivatives::differentiable;
use littlewood::modes::{Margin, Recurrence, SlideLimit, Undecided};
use littlewood::theory::{Body, Heavy};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, ParameterError, Proof,
    RestitutionLaw, SlipDirection, Start, Transition,
};
use littlewood_random::Draw;

/// A balanced hoop slips for 1.2345/(μk (1 + m/Î)), however long that is.
#[test]
fn the_slide_of_a_balanced_hoop_is_in_closed_form() {
    let (mass_ratio, inertia, mu_k) = (0.156, 0.1765, 3e-13);
    let hoop = HoopParameters::thin(mass_ratio)
        .with_offset(0.0)
        .with_inertia(inertia)
        .with_friction(1e-12, mu_k);
    let start = Start::at(2.81, 1.0).with_slip(1.2345);
    let motion = Hoop::new(hoop)
        .expect("a valid hoop")
        .simulate(start, Limits::default())
        .expect("a valid start");
    let stick = motion.transitions().first().expect("sticks");
    let time = 1.2345 / (mu_k * (1.0 + (1.0 + mass_ratio) / inertia));
    assert_eq!((stick.cause, stick.to), (Cause::Stick, Some(Mode::Rolling)));
    assert!(
        (stick.time() / time - 1.0).abs() < 1e-14,
        "{} {time}",
        stick.time()
    );
    let rate = 1.0 - mu_k * (1.0 + mass_ratio) / inertia * time;
    assert!((stick.before.theta_rate - rate).abs() < 1e-14 && stick.before.slip == 0.0);

    let smooth = Hoop::new(HoopParameters::thin(1.0).with_offset(0.0)).expect("a valid hoop");
    let motion = smooth
        .simulate(Start::at(0.5, 1e-9).with_slip(0.25), Limits::default())
        .expect("a valid start");
    let Outcome::SlidesForever {
        recurrence: Recurrence::Rotation { period },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!((period * 1e-9 / std::f64::consts::TAU - 1.0).abs() < 1e-6);
}

/// A slip of 1e6 at μ = 1e9 ends within 1e-33: the hoop then rolls with the slip as its rate.
#[test]
fn a_fast_slip_of_a_hoop_of_next_to_no_inertia_ends_at_once() {
    let (inertia, mu) = (1e-30, 1e9);
    let hoop = HoopParameters::thin(0.0)
        .with_offset(0.0)
        .with_inertia(inertia)
        .with_friction(mu, mu);
    let start = Start::at(2.905_841_460_448_034, 0.015_5).with_slip(-1e6);
    let motion = Hoop::new(hoop)
        .expect("a valid hoop")
        .simulate(start, Limits::default())
        .expect("a valid start");
    let stick = motion.transitions().first().expect("sticks");
    let time = 1e6 / (mu * (1.0 + 1.0 / inertia));
    assert_eq!((stick.cause, stick.to), (Cause::Stick, Some(Mode::Rolling)));
    assert!(
        (stick.time() / time - 1.0).abs() < 1e-14,
        "{} {time}",
        stick.time()
    );
    assert!(
        (stick.before.theta_rate / (1e6 + 0.015_5) - 1.0).abs() < 1e-14
            && stick.before.theta == start.theta
    );
}

/// A heavy rim on a plane of next to no friction would slip for 4.4e12 time units, through 3e12
/// turns: the angle at their end would be known to no digit. The slip loses μk in each time unit.
#[test]
fn a_slide_without_end_in_sight_says_how_much_is_left() {
    let mu_k = 3e-13;
    let hoop = HoopParameters::thin(0.2387)
        .with_offset(0.001)
        .with_inertia(1e9)
        .with_friction(1e-6, mu_k);
    let start = Start::at(-5.16, 4.59).with_slip(1.33);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let known = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    assert!(
        matches!(known.outcome(), Outcome::StaysInContact { .. }),
        "{:?}",
        known.outcome()
    );
    let motion = hoop
        .simulate(start, Limits::default().with_proof(Proof::None))
        .expect("a valid start");
    let Outcome::StepLimit {
        state,
        limit: SlideLimit::One { steps, time_left },
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!(steps < 1_000 && !motion.outcome().is_final());
    assert!(state.theta > 6e9, "{state:?}");
    let expected = state.slip / mu_k;
    assert!(
        (time_left / expected - 1.0).abs() < 0.05,
        "{time_left} {expected}"
    );
}

/// With ℓ = 0 and P = Î the slip loses μk (1 + m/Î) in each time unit. With the least coefficients
/// that are numbers it takes longer than motions are followed, and than the largest number says.
#[test]
fn a_balanced_hoop_slips_for_longer_than_motions_are_followed() {
    let (mass, inertia, slip) = (4.0, 4.234, 0.4725);
    for exponent in 10..=324 {
        for digits in [1.0, 2.5, 5.0, 9.0] {
            let mu: f64 = format!("{digits}e-{exponent}").parse().expect("a number");
            if mu == 0.0 {
                continue;
            }
            let hoop = HoopParameters::thin(mass - 1.0)
                .with_offset(0.0)
                .with_inertia(inertia)
                .with_friction(mu, mu);
            let hoop = Hoop::new(hoop).expect("a valid hoop");
            let start = Start::at(0.465, -0.0852).with_slip(-slip);
            let follow = |limits: Limits| hoop.simulate(start, limits).expect("a valid start");
            let rest = slip / (1.0 + mass / inertia) / mu;
            let motion = follow(Limits::default());
            let rounding = 1e-12 + 2.0 * f64::from_bits(1) / mu;
            if rest <= 1e150 {
                assert!(
                    matches!(motion.outcome(), Outcome::RollsForever { .. }),
                    "{:?}",
                    motion.outcome()
                );
                let stick = motion.transitions()[0];
                assert!(
                    (stick.before.time / rest - 1.0).abs() < rounding,
                    "{mu} {}",
                    stick.before.time
                );
            } else {
                assert!(
                    matches!(motion.outcome(), Outcome::StaysInContact { .. }),
                    "{:?}",
                    motion.outcome()
                );
                let unproved = follow(Limits::default().with_proof(Proof::None));
                let Outcome::StepLimit {
                    limit: SlideLimit::One { time_left, .. },
                    ..
                } = unproved.outcome()
                else {
                    panic!("{:?}", unproved.outcome())
                };
                assert!(
                    rest > f64::MAX / 4.0 || (time_left / rest - 1.0).abs() < rounding,
                    "{mu} {time_left} {rest}"
                );
            }
            let cut = follow(Limits::until(1e6));
            let Outcome::TimeLimit { state } = cut.outcome() else {
                panic!("{:?}", cut.outcome())
            };
            let lost = 1e6 * mu * (1.0 + mass / inertia);
            assert!((state.slip + slip - lost).abs() < 1e-15, "{state:?}");
        }
    }
}

#[test]
fn a_hoop_that_is_all_but_massless_is_refused() {
    for (mass_ratio, offset, inertia) in [
        (0.0, 1.0, 5e-324),
        (1e-61, 1.0, 0.0),
        (3.0, 1e-31, 0.0),
        (0.0, 0.0, 1e-150),
    ] {
        let error = Hoop::new(
            HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia),
        )
        .expect_err("too light");
        assert!(
            matches!(error, ParameterError::NearlyMassless { .. }),
            "{error}"
        );
        assert!(
            error
                .to_string()
                .contains("must be 0, or not less than 1e-60 m2 R^2"),
            "{error}"
        );
    }
    assert!(Hoop::new(HoopParameters::thin(0.0).with_inertia(1e-60)).is_ok());
}

/// A massless hoop with the particle next to its centre turns as 1/√ℓ̂, and its derivatives are as
/// large as 1/ℓ̂²: down to the least offset all are numbers, and below it a hoop is refused.
#[test]
fn massless_hoops_of_any_offset_leave_no_number_that_is_none() {
    let quantities = Vec::from_iter(differentiable(false));
    let mut refused = 0;
    for number in 0..150 {
        let mut draw = Draw::of_case(19, 0, number);
        let decades = if draw.comes(0.2) { -323.3 } else { -60.0 };
        let offset = draw.of_any_size([decades, 0.0]);
        let mu_s = draw.between([0.0, 1.5]);
        let resistance = match draw.below(3) {
            0 => 0.0,
            1 => offset * draw.between([0.0, 2.0]),
            _ => draw.between([0.0, 1.0]),
        };
        let hoop = Hoop::new(
            HoopParameters::thin(0.0)
                .with_offset(offset)
                .with_friction(mu_s, mu_s * draw.share())
                .with_slope(draw.one_of(&[0.0, 0.3, -1.2]))
                .with_rolling_resistance(resistance),
        );
        let hoop = match hoop {
            Ok(hoop) => hoop,
            Err(error) => {
                let ParameterError::NearlyCentred { offset } = error else {
                    panic!("{error}")
                };
                assert!(offset < 1e-60 && error.to_string().contains("less than 1e-60"));
                refused += 1;
                continue;
            }
        };
        let fall = offset.sqrt().recip().min(1e6);
        let rate = draw.one_of(&[0.0, 1.0, -fall, 0.4 * fall]) * draw.share();
        let slip = draw.one_of(&[0.0, -rate, 1.0]) * draw.share();
        let start = Start::at(draw.between([-3.1, 3.1]), rate).with_slip(slip);
        let limits = Limits::until(20.0).with_transitions(6);
        let motion = hoop.simulate(start, limits).expect("a valid start");
        let samples = motion
            .phases()
            .iter()
            .flat_map(|phase| instants(phase.duration(), 10).map(|elapsed| phase.sample(elapsed)));
        let derivatives = motion.derivatives(&quantities).expect("quantities");
        let seen = format!(
            "{:?} {:?} {:?} {:?} {:?} {:?}",
            hoop.classify(start).expect("a valid start"),
            motion.outcome(),
            motion.transitions(),
            Vec::from_iter(samples),
            derivatives.transitions(),
            derivatives.outcome(),
        );
        assert!(!seen.contains("NaN"), "{hoop:?} {start:?}: {seen}");
        let digits = hoop.digits(start, limits).expect("a valid start");
        assert_eq!(digits.len(), motion.transitions().len());
    }
    assert!(refused > 10, "{refused}");
}

/// Where the slip of a massless hoop ends so near to the bottom that the last digit of the angle is
/// as large as the distance of the particle from the contact point, the energy D θ′²/2 beyond has no
/// digit: it rose by a factor of five. That distance is 1 − ℓ̂ times one over the sine of the direction
/// of the velocity, and on the rim twice the ratio of its components.
#[test]
fn a_particle_that_passes_the_contact_point_ends_what_doubles_resolve() {
    let beside_rim = (1.0_f64.next_down(), 1.3213);
    let fast = Start::at(-1.2377, -1e6).with_slip(1.518);
    let falling = Start::at(-FRAC_PI_2, -1.0).with_slip((-1.0_f64).next_up());
    for ((offset, mu), start) in [(beside_rim, fast), ((1.0, 0.5), falling)] {
        let hoop = HoopParameters::thin(0.0)
            .with_offset(offset)
            .with_friction(mu, mu);
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        let Outcome::Unresolved {
            state,
            undecided:
                Undecided::Rounding {
                    margin: Margin::ContactDistance,
                    value,
                    bound,
                },
        } = motion.outcome()
        else {
            panic!("{:?}", motion.outcome())
        };
        assert!(value <= bound && bound < 2e-15, "{value} {bound}");
        let (glide, summary) = (motion.phases().last().expect("a glide"), motion.summary());
        assert!(state.slip == 0.0 && summary.energy.is_nan());
        assert_eq!(
            glide.last().map(|end| end.energy),
            Some(glide.first().energy)
        );
    }
}

/// With μs = 1e9 rolling gives way where N is 1e-19, so that rounding tells the wrong side of the
/// cone: the slide against the friction force is taken all the same. Times from a program of 60
/// digits (`evidence/reference/follower`).
#[test]
fn a_slip_at_huge_friction_goes_against_the_friction_force() {
    let light = 3.093_124_034_665_051_7e-11;
    let hoop = HoopParameters::thin(light)
        .with_offset(0.543_016_490_341_794_7)
        .with_friction(1e9, 0.859_974_024_855_756_8);
    let start = Start::at(-2.057_134_228_173_551_6, -2.610_392_130_121_690_4);
    let motion = Hoop::new(hoop)
        .expect("a valid hoop")
        .simulate(start, Limits::default())
        .expect("a valid start");
    let times: Vec<f64> = motion.transitions().iter().map(Transition::time).collect();
    let expected = [
        0.696_080_599_271_222,
        1.337_471_157_519_41,
        3.117_341_302_583_801_7,
    ];
    assert_eq!(times.len(), 3, "{:?}", motion.outcome());
    for (ours, theirs) in times.iter().zip(expected) {
        assert!((ours - theirs).abs() < 1e-9, "{times:?}");
    }
}

/// Next to P = 0 the series of a slide overflow one after another: those of the angle may be
/// numbers and that of the normal force none. The slip ends there (60 digits,
/// `evidence/reference/follower`).
#[test]
fn a_slide_towards_unbounded_forces_does_not_lift_off() {
    let hoop = HoopParameters::thin(0.002_893_206_777_576_306_5)
        .with_offset(4.983_671_045_778_125e-6)
        .with_inertia(1e-30)
        .with_friction(1e-6, 9.999_999_999_999_997e-7);
    let start = Start::at(2e-16, 3.595_144_166_216_662);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::until(0.2))
        .expect("a valid start");
    let expected = [
        (Cause::Slip, 0.056_359_463_235_719_39),
        (Cause::Stick, 0.061_317_605_848_191_19),
        (Cause::Slip, 0.169_616_068_418_884_76),
        (Cause::Stick, 0.170_377_317_231_451_65),
    ];
    // The last step of a slide, 3e-15 long, turns the hoop by up to 2e-12, at each of two slides.
    for (transition, (cause, time)) in motion.transitions().iter().zip(expected) {
        assert_eq!(transition.cause, cause, "{transition:?}");
        assert!((transition.time() - time).abs() < 4e-12, "{transition:?}");
    }
}

/// Next to P = 0 a slide ends after its last series.
#[test]
fn the_last_instants_of_a_slide_towards_unbounded_forces_are_on_the_way_to_its_end() {
    let hoop = HoopParameters::thin(0.0)
        .with_offset(0.590_566_639_439_473_9)
        .with_inertia(8.416_271_943_867_209e-9)
        .with_friction(0.008_184_622_966_435_321, 0.006_516_614_498_938_9);
    let start = Start::at(-2.405_726_591_963_814_4, -2.687_662_308_034_211_5);
    let start = start.with_slip(0.115_748_295_499_117_21);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::until(0.2))
        .expect("a valid start");
    let slide = &motion.phases()[1];
    let end = slide.end().expect("it sticks");
    let (mut elapsed, mut instants) = (slide.duration(), 0);
    while elapsed > slide.duration() * (1.0 - 1e-13) {
        let now = slide.sample(elapsed).state;
        assert!((now.theta - end.theta).abs() < 1e-10, "{now:?} {end:?}");
        (elapsed, instants) = (elapsed.next_down(), instants + 1);
    }
    assert!(instants > 100);
}

/// A slide of a thousand turns, then thirty of a turn or less, and a jump that grazes the plane: no
/// step rounds the angle to the last digit of all its turns (60 digits,
/// `evidence/reference/follower`).
#[test]
fn slides_after_many_turns_keep_the_digits_of_an_angle_in_its_turn() {
    let mu = 6.250_645_073_604_898e-5;
    let hoop = HoopParameters::thin(0.617_872_786_973_064_6)
        .with_offset(0.167_019_704_614_548_82)
        .with_inertia(0.673_281_490_214_766_7)
        .with_friction(mu, mu);
    let start = Start::at(-1.232_125_792_187_205_7, 2.832_120_411_003_164)
        .with_slip(-0.629_170_491_372_690_3);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::default())
        .expect("a valid start")
        .summary();
    assert_eq!(
        (motion.outcome, motion.transitions),
        (OutcomeKind::Landing, 33)
    );
    // A time of 2,000 is rounded by up to 2.3e-13 at each transition.
    assert!(
        (motion.lift_off_time - 2_105.506_863_120_022_4).abs() < 33.0 * 2.3e-13,
        "{motion:?}"
    );
    assert!(
        (motion.end.theta_rate - 3.112_389_793_941_420_6).abs() < 5e-14,
        "{motion:?}"
    );
    assert!(
        (motion.jump_length - 0.028_799_516_892_151_345).abs() < 1e-11,
        "{motion:?}"
    );
}

/// A hoop with so much inertia is hardly accelerated by friction: it would slide for 1e9 turns to its
/// lift-off, and the times of the few that there is time for are not rounded by those of all.
/// Newton's and Euler's equations follow it in small steps.
#[test]
fn a_slide_that_is_hardly_accelerated_keeps_the_digits_of_its_first_turns() {
    for (inertia, slope) in [(1e9, 0.37), (1e9, 0.0), (1e7, -0.1)] {
        let hoop = HoopParameters::thin(0.0)
            .with_offset(1e-3)
            .with_inertia(inertia)
            .with_friction(0.4, 0.2)
            .with_slope(slope);
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let start = Start::at(-0.1, 5.8).with_slip(-50.0);
        let motion = hoop
            .simulate(start, Limits::until(20.0))
            .expect("a valid start");
        let slide = &motion.phases()[0];
        assert_eq!(slide.mode(), Mode::Sliding);
        let contact = Contact::Slides(SlipDirection::Negative, hoop.mu_k());
        for time in [1.0, 2.5, 3.3, 12.5, 20.0] {
            let [theta, ..] = contact.after(&hoop, &start, (time, 4_000));
            let found = slide.sample(time).state.theta;
            assert!(
                (found - theta).abs() < 1e-11,
                "{inertia:e} {slope} {time}: {found} {theta}"
            );
        }
    }
}

/// At the top a light hoop has 1e-5 of the energy that it has at the bottom, and its slip all but
/// vanishes there: events that rounding of the energy would make (60 digits,
/// `evidence/reference/follower`).
#[test]
fn a_light_hoop_without_friction_has_its_rate_at_the_top_to_the_last_digits() {
    let hoop = HoopParameters::thin(0.0).with_inertia(0.000_112_281_813_254_295_91);
    let start = Start::at(0.0, -0.822_255_722_075_246_2).with_slip(-1.903_046_044_822_691e-10);
    let hoop = Hoop::new(hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::until(20.0))
        .expect("a valid start");
    let expected = [
        (1.141_266_053_249_229_8, -1.210_765_548_115_670_7),
        (2.865_336_167_261_339, -5.072_419_759_063_916),
        (5.147_868_273_759_799, -7.493_950_855_295_258),
        (6.871_938_387_771_908, -11.355_605_066_243_502),
        (9.154_470_494_270_368, -13.777_136_162_474_844),
        (10.878_540_608_282_477, -17.638_790_373_423_09),
        (13.161_072_714_780_937, -20.060_321_469_654_43),
        (14.885_142_828_793_046, -23.921_975_680_602_675),
        (17.167_674_935_291_506, -26.343_506_776_834_017),
        (18.891_745_049_303_615, -30.205_160_987_782_26),
    ];
    assert_eq!(motion.transitions().len(), expected.len());
    for (transition, (time, theta)) in motion.transitions().iter().zip(expected) {
        assert_eq!(transition.cause, Cause::Reversal);
        // ε (1 + |θ|) of each of the slides before, over Î where the hoop is slow.
        assert!((transition.time() - time).abs() < 1e-11, "{transition:?}");
        assert!(
            (transition.before.theta - theta).abs() < 1e-12,
            "{transition:?}"
        );
    }
}

/// The lighter a hoop, the faster an impact turns it, up to rates at which it would start nowhere,
/// and beyond all numbers.
#[test]
fn impacts_of_hoops_of_next_to_no_inertia_leave_no_state_that_is_no_number() {
    let start = Start::at(0.919_013_702_214_027, -3.713_109_040_932_079_3)
        .with_slip(-0.892_122_598_492_862);
    let mut unresolved = 0;
    for inertia in [1e-60, 1e-40, 1e-20, 1e-10, 1e-5] {
        for law in RestitutionLaw::ALL {
            let parameters = HoopParameters::thin(inertia)
                .with_friction(1.010_253_938_896_41, 0.0)
                .with_restitution(1.0, law);
            let hoop = Hoop::new(parameters).expect("a valid hoop");
            let motion = hoop
                .simulate(start, Limits::default())
                .expect("a valid start");
            let numbers = |all: &[f64]| all.iter().all(|x| x.is_finite());
            for transition in motion.transitions() {
                let before = transition.before;
                assert!(
                    numbers(&[before.theta_rate, before.slip]),
                    "{inertia} {law:?} {transition:?}"
                );
                if let Some(impact) = &transition.impact {
                    let after = impact.after;
                    assert!(
                        numbers(&[after.theta_rate, after.slip, after.gap_rate]),
                        "{inertia} {law:?} {impact:?}"
                    );
                }
            }
            if let Outcome::Unresolved { state, undecided } = motion.outcome() {
                let [value, bound] = undecided.compared();
                assert!(value.is_nan() || value.abs() > bound, "{undecided:?}");
                assert!(
                    numbers(&[state.theta_rate, state.slip]),
                    "{inertia} {law:?} {state:?}"
                );
                unresolved += 1;
            }
        }
    }
    assert!(unresolved > 0);
}

/// A flight of 3e9 turns ends at an angle whose sine no double resolves: there the impact is not
/// guessed.
#[test]
fn an_impact_at_an_angle_that_is_not_resolved_is_none() {
    let parameters = HoopParameters::thin(0.121_466_028_205_290_8)
        .with_inertia(1.856_379_095_494_365_7)
        .with_friction(1e-8, 5e-9)
        .with_restitution(0.56, RestitutionLaw::Energetic);
    let start = Start::at(32.2, 121_093.0).with_slip(0.0038);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let motion = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    let Outcome::Unresolved { state, undecided } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert!(state.theta > 1e9);
    assert_eq!(undecided.names().0, "theta");
    let [value, bound] = undecided.compared();
    assert!(
        (value - state.theta).abs() < 40.0 && bound == 1e9,
        "{undecided:?}"
    );
    let landing = motion.transitions().last().expect("lands");
    assert_eq!(
        (landing.cause, landing.to, landing.impact),
        (Cause::Landing, None, None)
    );
}

/// Without friction the momentum η′ − θ′(1 + h c) and the energy D θ′²/2 + m h c, D = Î + m h² s²,
/// are those of the start however many periods have passed. Far from the start the angle is rounded
/// by more than a turn, so its cosine is taken from the momentum.
#[test]
fn a_slide_for_ever_stays_on_its_orbit_when_its_angle_has_no_digits_left() {
    let parameters = HoopParameters::thin(1.0)
        .with_offset(0.5)
        .with_inertia(1.0)
        .with_friction(0.0, 0.0);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let Body::Heavy(Heavy {
        mass, h, inertia, ..
    }) = hoop.body()
    else {
        panic!("it has inertia")
    };
    let energy = |rate: f64, cos: f64| {
        0.5 * (inertia + mass * h * h * (1.0 - cos * cos)) * rate * rate + mass * h * cos
    };
    let momentum = -h * libm::cos(1.0);
    let start = Start::at(1.0, 1.0).with_slip(1.0);
    for until in [1e3, 1e9, 1e15, 1e18, 1e40, 1e150] {
        let motion = hoop
            .simulate(start, Limits::until(until))
            .expect("a valid start");
        let state = motion.at(until).expect("within the motion").state;
        let cos = ((state.slip - momentum) / state.theta_rate - 1.0) / h;
        assert!(cos.abs() < 1.0 + 1e-12, "{until} {state:?}");
        let drift = energy(state.theta_rate, cos) - energy(1.0, libm::cos(1.0));
        assert!(drift.abs() < 1e-12, "{until} {drift}");
        // The mass centre moves steadily, h at most from the centre.
        assert!(
            (state.x - momentum * until).abs() < 2.0 * h + 1e-14 * until,
            "{until} {}",
            state.x
        );
    }
    let error = hoop
        .simulate(start, Limits::until(1e151))
        .expect_err("refused");
    assert!(error.to_string().contains("1e150"), "{error}");
}

/// A massless hoop glides with w = ½ ℓ² sin²θ θ′² + ℓ cos θ (3.18, corrected), however small ℓ is.
#[test]
fn a_glide_with_next_to_no_lever_conserves_the_energy_of_the_particle() {
    for offset in [1e-9_f64, 1e-30, 1e-59, 1e-60] {
        let parameters = HoopParameters::thin(0.0)
            .with_inertia(0.0)
            .with_offset(offset);
        let hoop = Hoop::new(parameters.with_friction(0.4, 0.3)).expect("a valid hoop");
        let start = Start::at(1.0, 0.0).with_slip(1e-9);
        let limits = Limits::default().with_transitions(1);
        let motion = hoop.simulate(start, limits).expect("a valid start");
        // At its end, the bottom, θ′ is infinite.
        let last = motion.transitions().first().expect("an event").time();
        let state = motion.at(0.5 * last).expect("within the glide").state;
        let rise = (state.theta_rate * offset.sqrt()) * libm::sin(state.theta);
        let w = 0.5 * rise * rise * offset + offset * libm::cos(state.theta);
        assert!(
            (w / offset - libm::cos(1.0)).abs() < 1e-12,
            "{offset} {state:?}"
        );
    }
}

/// The particle of a massless hoop is 7e-33 above the plane, which the angle does not tell from
/// none.
#[test]
fn a_massless_hoop_whose_particle_is_at_the_plane_but_for_rounding_is_unresolved() {
    let hoop = Hoop::littlewood(1e9, 1e9).expect("a valid hoop");
    let start = Start::at(-3.0 * std::f64::consts::PI, 4e-11);
    let motion = hoop
        .simulate(start, Limits::default())
        .expect("a valid start");
    let Outcome::Unresolved { undecided, .. } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert_eq!(undecided.names().0, "theta_rate");
    assert!(motion.transitions().is_empty());
}

/// A motion is at its time limit, and nowhere else, where its outcome is that: whatever else stops
/// it, as a step below the resolution of the time, has another name.
#[test]
fn a_motion_that_ends_at_the_time_limit_is_there() {
    let mut limited = 0;
    for number in 0..3_000 {
        let mut draw = Draw::of_case(17, 0, number);
        let (hoop, start) = draw.motion();
        let until = start.time + draw.of_any_size([-6.0, 1.0]);
        let Ok(motion) = hoop.simulate(start, Limits::until(until)) else {
            continue;
        };
        if let Outcome::TimeLimit { state } = motion.outcome() {
            limited += 1;
            assert_eq!(state.time, until, "{hoop:?} {start:?}");
        }
    }
    assert!(limited > 1_000, "{limited}");
}
