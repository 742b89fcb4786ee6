//! The plane has no left or right, and conservative motions no direction of time.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use crate::common::{heavy_motion, massless_hoop, moderate_hoop, simulate, start};
use littlewood::modes::RollingOrbit;
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Restitution, RestitutionLaw, Start, State,
    Trajectory,
};
use proptest::prelude::*;

/// (θ, θ′, η′, x) → −(θ, θ′, η′, x).
pub(crate) fn mirrored(start: Start) -> Start {
    Start::at(-start.theta, -start.theta_rate)
        .with_slip(-start.slip)
        .with_x(-start.x)
        .with_time(start.time)
}

fn bits(state: &State, sign: f64) -> [u64; 5] {
    // Adding zero makes −0 and 0 the same.
    [
        state.time,
        sign * state.theta,
        sign * state.theta_rate,
        sign * state.slip,
        sign * state.x,
    ]
    .map(|value| (value + 0.0).to_bits())
}

pub(crate) fn check_mirror(a: &Trajectory, b: &Trajectory) -> Result<(), TestCaseError> {
    prop_assert_eq!(a.outcome().kind(), b.outcome().kind());
    prop_assert_eq!(
        bits(&a.outcome().state(), 1.0),
        bits(&b.outcome().state(), -1.0)
    );
    prop_assert_eq!(a.transitions().len(), b.transitions().len());
    for (ours, theirs) in a.transitions().iter().zip(b.transitions()) {
        prop_assert_eq!(bits(&ours.before, 1.0), bits(&theirs.before, -1.0));
        prop_assert_eq!(bits(&ours.after, 1.0), bits(&theirs.after, -1.0));
        prop_assert_eq!(
            (ours.cause, ours.from, ours.to),
            (theirs.cause, theirs.from, theirs.to)
        );
        prop_assert_eq!(
            ours.direction,
            theirs.direction.map(littlewood::SlipDirection::reversed)
        );
    }
    for (ours, theirs) in a.phases().iter().zip(b.phases()) {
        for part in [0.25, 0.5, 0.75] {
            let elapsed = ours.duration().min(10.0) * part;
            let (ours, theirs) = (ours.sample(elapsed), theirs.sample(elapsed));
            prop_assert_eq!(bits(&ours.state, 1.0), bits(&theirs.state, -1.0));
            prop_assert_eq!(ours.normal.to_bits(), theirs.normal.to_bits());
            prop_assert_eq!(
                (ours.friction + 0.0).to_bits(),
                (0.0 - theirs.friction).to_bits()
            );
            prop_assert_eq!(ours.gap.to_bits(), theirs.gap.to_bits());
        }
    }
    Ok(())
}

/// Two events at once, and a turning point that is known to rounding: a slip without friction begins
/// and ends with the same sign of θ′, and with a huge μs both limits of friction are at N = 0.
#[test]
fn what_rounding_leaves_open_is_mirrored() {
    let light = HoopParameters::thin(0.0)
        .with_offset(0.611_534_604_103_437_6)
        .with_inertia(8.908_575_775_035_093e-8);
    let resting = Start::at(-15.916_562_038_271_069, -1e-30);
    let rough = HoopParameters::thin(1e-16)
        .with_offset(0.25)
        .with_inertia(6.903_704_552_283_125e-11)
        .with_friction(1e9, 0.0)
        .with_rolling_resistance(2.848_459_282_651_698_3e-12);
    let sliding = Start::at(-1.721_146_047_769_684_7, 1.240_480_058_651_624_3)
        .with_slip(-4_514.524_561_789_932);
    for (parameters, start) in [(light, resting), (rough, sliding)] {
        let hoop = Hoop::new(parameters).expect("a hoop");
        let motion = simulate(&hoop, start);
        check_mirror(&motion, &simulate(&hoop, mirrored(start))).expect("the mirror image");
        if start == resting {
            let reversal = motion.transitions()[0];
            assert_eq!(
                (reversal.cause, reversal.before.theta_rate),
                (Cause::Reversal, -1e-30)
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn a_mirrored_start_gives_the_mirrored_motion_bit_for_bit((hoop, start) in heavy_motion()) {
        // At η′ = θ′ = 0 on a vertical nothing chooses a side.
        prop_assume!(start.theta_rate != 0.0 || start.slip != 0.0 || start.theta != 0.0);
        check_mirror(&simulate(&hoop, start), &simulate(&hoop, mirrored(start)))?;
    }

    #[test]
    fn a_mirrored_bouncing_motion_is_the_mirrored_motion(
        (hoop, start) in heavy_motion(), e in 0.0..=1.0_f64, law in prop::sample::select(RestitutionLaw::ALL.to_vec()),
        gap_rate in prop_oneof![Just(0.0), 0.0..2.0_f64],
    ) {
        prop_assume!(start.theta_rate != 0.0 || start.slip != 0.0 || start.theta != 0.0);
        let hoop = hoop.with_restitution(Restitution::new(e, law).expect("a coefficient")).expect("heavy");
        let start = start.with_gap_rate(gap_rate);
        check_mirror(&simulate(&hoop, start), &simulate(&hoop, mirrored(start).with_gap_rate(gap_rate)))?;
    }

    #[test]
    fn a_mirrored_massless_start_gives_the_mirrored_motion(hoop in massless_hoop(), start in start()) {
        check_mirror(&simulate(&hoop, start), &simulate(&hoop, mirrored(start)))?;
    }

    #[test]
    fn rolling_back_in_time_returns_to_the_start(hoop in moderate_hoop(), start in start(), elapsed in 0.0..10.0_f64) {
        let (theta, rate) = RollingOrbit::new(&hoop, start.theta, start.theta_rate).expect("no resistance").position(elapsed);
        let (back, back_rate) = RollingOrbit::new(&hoop, theta, -rate).expect("no resistance").position(elapsed);
        // Near the saddle errors grow like e^τ/…: the exponent is at most 1 for these hoops.
        let allowed = 1e-13 * elapsed.exp() * (1.0 + start.theta.abs());
        prop_assert!((back - start.theta).abs() < allowed, "{back} {}", start.theta);
        prop_assert!((back_rate + start.theta_rate).abs() < allowed, "{back_rate} {}", start.theta_rate);
    }

    #[test]
    fn a_slide_without_friction_returns_to_its_start_in_time(hoop in moderate_hoop(), start in start(), slip in 0.01..2.0_f64, elapsed in 0.05..2.0_f64) {
        let smooth = Hoop::new(hoop.parameters().with_friction(0.0, 0.0)).unwrap();
        let start = start.with_slip(slip.copysign(start.slip));
        let forth = smooth.simulate(start, Limits::until(elapsed)).unwrap();
        let slides = forth.phases().len() == 1 && forth.phases()[0].mode() == Mode::Sliding;
        prop_assume!(slides && matches!(forth.outcome(), Outcome::TimeLimit { .. }));
        let end = forth.outcome().state();
        let back = Start::at(end.theta, -end.theta_rate).with_slip(-end.slip);
        let back = smooth.simulate(back, Limits::until(elapsed)).unwrap().phases()[0].end().unwrap();
        prop_assert!((back.theta - start.theta).abs() < 1e-11 * (1.0 + start.theta.abs()));
        prop_assert!((back.theta_rate + start.theta_rate).abs() < 1e-11);
        prop_assert!((back.slip + start.slip).abs() < 1e-11);
    }
}
