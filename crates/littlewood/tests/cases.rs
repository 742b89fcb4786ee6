//! Each named case does what its title says, and together they take every edge of the automaton.
#![allow(clippy::disallowed_methods, clippy::panic, clippy::excessive_precision)] // expected values may come from the platform's mathematics

use std::collections::BTreeSet;

use littlewood::cases::{CASES, find_case};
use littlewood::modes::Recurrence;
use littlewood::theory::{Body, BodyClass, EDGES, RollingType, StartRegion};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Restitution, RestitutionLaw, Start,
    Trajectory,
};

fn case(name: &str) -> Trajectory {
    find_case(name)
        .unwrap_or_else(|| panic!("no case {name}"))
        .simulate()
        .expect("a valid case")
}

fn modes(motion: &Trajectory) -> Vec<Mode> {
    motion
        .phases()
        .iter()
        .map(littlewood::Phase::mode)
        .collect()
}

fn causes(motion: &Trajectory) -> Vec<Cause> {
    motion
        .transitions()
        .iter()
        .map(|transition| transition.cause)
        .collect()
}

use Mode::{Flight, Gliding, Rest, Rolling, Skidding, Sliding};

#[test]
fn figure_3_slides_rolls_slides_and_jumps() {
    let motion = case("figure-3");
    assert_eq!(modes(&motion), [Sliding, Rolling, Sliding, Flight]);
    assert_eq!(
        causes(&motion),
        [Cause::Stick, Cause::Slip, Cause::LiftOff, Cause::Landing]
    );
    // "the jump in the motion of the centre of mass is to the left"
    let flight = &motion.phases()[3];
    assert!(flight.last().expect("lands").mass_centre.x < flight.first().mass_centre.x);
    let littlewood::modes::PhaseSolution::Flight(exact) = flight.solution() else {
        panic!("flies")
    };
    // Largest gap of the 40-digit run, at a resolution of 1e-3 in time: 0.63112604… at 3.16467….
    let (time, height) = exact.apex();
    assert!((flight.start().time + time - 3.164_670_213_819_437).abs() < 1e-3);
    assert!((height - 0.631_126_040_142_515).abs() < 1e-6);
}

#[test]
fn the_jumps_of_section_2f() {
    let motion = case("slip-then-jump");
    assert_eq!(modes(&motion), [Rolling, Sliding, Flight]);
    let motion = case("slide-then-jump");
    assert_eq!(modes(&motion), [Sliding, Flight]);
    let motion = case("footnote-3");
    assert_eq!(modes(&motion), [Flight]);
}

#[test]
fn rolling_persists_for_all_time() {
    let motion = case("figure-2-libration");
    assert_eq!(modes(&motion), [Rolling]);
    let Outcome::RollsForever {
        recurrence:
            Recurrence::Libration {
                theta_min,
                theta_max,
                ..
            },
        ..
    } = motion.outcome()
    else {
        panic!("{:?}", motion.outcome())
    };
    assert!((theta_min - 2.5).abs() < 1e-15);
    assert!(
        (theta_max + theta_min - std::f64::consts::TAU).abs() < 1e-15,
        "about the stable equilibrium"
    );

    let motion = case("rolls-forever");
    assert_eq!(modes(&motion), [Rolling]);
    let rotates = matches!(
        motion.outcome(),
        Outcome::RollsForever {
            recurrence: Recurrence::Rotation { .. },
            ..
        }
    );
    assert!(rotates, "{:?}", motion.outcome());
    // The proof, checked by brute force over two turns.
    let Outcome::RollsForever {
        recurrence: Recurrence::Rotation { period },
        ..
    } = motion.outcome()
    else {
        return;
    };
    let demand = (0..=20_000).map(|i| {
        let sample = motion.at(period * f64::from(i) / 10_000.0).expect("rolls");
        sample.friction.abs() / sample.normal
    });
    let largest = demand.fold(0.0, f64::max);
    assert!(largest < 0.5 && largest > 0.1, "{largest}");
}

#[test]
fn rolling_and_sliding_alternate_without_a_jump() {
    let motion = case("stick-slip-no-jump");
    let modes = modes(&motion);
    assert!(modes.len() >= 5, "several alternations");
    assert!(
        modes
            .iter()
            .enumerate()
            .all(|(i, mode)| *mode == if i % 2 == 0 { Rolling } else { Sliding })
    );
    assert!(matches!(motion.outcome(), Outcome::RollsForever { .. }));
}

#[test]
fn the_band_slides_at_once() {
    let named = find_case("sliding-band").expect("a case");
    let hoop = Hoop::new(named.setup.hoop).expect("a valid hoop");
    let found = hoop.classify(named.setup.start).expect("a valid start");
    assert_eq!(found.region, StartRegion::SlidingBand);
    assert!(found.rolling_forces.normal < 0.0);
    assert_eq!(modes(&case("sliding-band"))[0], Sliding);
}

#[test]
fn types_one_two_three() {
    for (name, kind, cause) in [
        ("type-1", RollingType::I, Cause::NormalForceZero),
        ("type-2", RollingType::II, Cause::NormalForceZero),
        ("type-3", RollingType::III, Cause::Slip),
        ("figure-7", RollingType::III, Cause::Slip),
    ] {
        let named = find_case(name).expect("a case");
        let hoop = Hoop::new(named.setup.hoop).expect("a valid hoop");
        let found = hoop.classify(named.setup.start).expect("a valid start");
        assert_eq!(
            (found.region, found.rolling_type),
            (StartRegion::Rolling, Some(kind)),
            "{name}"
        );
        let motion = case(name);
        assert_eq!(modes(&motion)[..2], [Rolling, Gliding], "{name}");
        let slip = motion.transitions()[0];
        assert_eq!(slip.cause, cause, "{name}");
        let (theta, rate) = (slip.before.theta, slip.before.theta_rate);
        let friction_angle = 2.0 * 0.5_f64.atan();
        match kind {
            RollingType::I => {
                assert!((rate.abs() - 1.0).abs() < 1e-15 && theta.abs() < friction_angle - 0.1);
            }
            RollingType::II => {
                assert!(
                    (rate.abs() - 1.0).abs() < 1e-15
                        && (theta.abs() - friction_angle).abs() < 1e-15
                );
            }
            RollingType::III => {
                assert!(rate.abs() < 0.9 && (theta.abs() - friction_angle).abs() < 1e-15);
            }
        }
        assert_eq!(
            motion.outcome().kind().name(),
            "particle_at_plane",
            "{name}"
        );
    }
}

#[test]
fn a_glide_sticks_inside_the_rolling_region() {
    let motion = case("glide-to-roll");
    assert_eq!(modes(&motion)[..3], [Gliding, Rolling, Gliding]);
    assert_eq!(causes(&motion)[..2], [Cause::Stick, Cause::Slip]);
    let stick = motion.transitions()[0].before;
    assert!(stick.theta.abs() < 2.0 * 0.5_f64.atan() && stick.theta_rate.abs() < 1.0);
}

#[test]
fn painleve_is_an_outcome_of_its_own() {
    let motion = case("painleve");
    let Outcome::Inconsistent { candidates, .. } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert_eq!(candidates.count(), 0);
    assert!(candidates.contact > 0.0 && candidates.solvability[1] < 0.0);
    assert!(motion.phases().is_empty());

    // With resistance also where nothing slips; without it the same hoop rolls.
    let motion = case("painleve-resisted");
    let Outcome::Inconsistent { candidates, .. } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert_eq!(candidates.count(), 0);
    assert!(candidates.rolling_forces.normal > 0.0 && candidates.contact > 0.0);
    assert!(candidates.solvability.iter().all(|p| *p < 0.0));
    assert!(motion.phases().is_empty());
    let setup = find_case("painleve-resisted").expect("a case").setup;
    let parameters = setup.hoop.with_rolling_resistance(0.0);
    let unresisted = Hoop::new(parameters).expect("a valid hoop");
    let motion = unresisted.simulate(setup.start, Limits::default());
    assert_eq!(modes(&motion.expect("a valid start"))[0], Rolling);
}

#[test]
fn motions_go_on_after_the_landing() {
    let motion = case("figure-3-bounces");
    assert_eq!(
        modes(&motion)[..5],
        [Sliding, Rolling, Sliding, Flight, Flight]
    );
    assert_eq!(
        (
            modes(&motion).last(),
            motion.transitions().last().map(|it| it.cause)
        ),
        (Some(&Rolling), Some(Cause::Settle))
    );
    assert!(matches!(motion.outcome(), Outcome::RollsForever { .. }));

    let motion = case("lands-and-rolls");
    assert_eq!(modes(&motion), [Sliding, Flight, Rolling]);
    assert!(matches!(motion.outcome(), Outcome::RollsForever { .. }));

    let motion = case("two-hops");
    assert_eq!(
        modes(&motion),
        [
            Sliding, Rolling, Sliding, Flight, Rolling, Sliding, Flight, Rolling
        ]
    );

    let motion = case("jam");
    let jam = motion.transitions().first().expect("jams");
    assert_eq!(
        (jam.cause, jam.from, jam.to, jam.time()),
        (Cause::Jam, None, Some(Rolling), 0.0)
    );
    assert!(
        (jam.after.theta_rate + 1.0).abs() < 1e-14,
        "the rate of the closed form, −1"
    );
    assert_eq!(
        motion.end_of(&motion.phases()[0]).map(|it| it.cause),
        Some(Cause::Slip)
    );

    let motion = case("ramp-bounces");
    assert_eq!(modes(&motion).first(), Some(&Flight));
    assert_eq!(
        motion.transitions().last().map(|it| it.cause),
        Some(Cause::Settle)
    );
    assert!(motion.summary().landings > 20 && motion.summary().end.x > 20.0);
    let Outcome::RollsForever { recurrence, .. } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    assert!(matches!(recurrence, Recurrence::Libration { .. }));

    let motion = case("bounces-forever");
    assert!(modes(&motion).iter().all(|mode| *mode == Flight));
    assert!(matches!(motion.outcome(), Outcome::TransitionLimit { .. }));
    assert!(
        motion
            .transitions()
            .iter()
            .all(|it| it.before.slip.abs() < 1e-9)
    );
}

#[test]
fn a_loaded_disc_climbs_and_a_ramp_makes_it_jump() {
    for (name, climbs) in [("uphill-disc", true), ("ramp-libration", false)] {
        let motion = case(name);
        assert_eq!(modes(&motion), [Rolling], "{name}");
        let Outcome::RollsForever {
            recurrence: Recurrence::Libration { period, .. },
            ..
        } = motion.outcome()
        else {
            panic!("{:?}", motion.outcome())
        };
        let farthest = motion.at(0.5 * period).expect("an instant").state;
        assert!(farthest.theta_rate.abs() < 1e-7, "{name}: {farthest:?}");
        assert_eq!(
            farthest.x > 1.0,
            climbs,
            "{name}: the plane rises to the right"
        );
    }
    let motion = case("ramp-jump");
    assert_eq!(modes(&motion), [Rolling, Sliding, Rolling, Sliding, Flight]);
    // How far the rim slips before it leaves, by Runge and Kutta: 0.0033 R in 0.19 √(R/g).
    let slide = &motion.phases()[3];
    let (first, last) = (slide.first().state, slide.last().expect("lifts off").state);
    let slipped = (last.x + last.theta) - (first.x + first.theta);
    assert!(
        (slide.duration() - 0.19).abs() < 0.005 && (slipped - 0.0033).abs() < 0.0001,
        "{slipped}"
    );
}

/// A named motion that rests, and its events by `evidence/reference/resistance`: 42 digits.
struct Stopped {
    name: &'static str,
    first: Mode,
    half_swings: usize,
    /// Cause, τ, θ and x.
    events: &'static [(Cause, f64, f64, f64)],
}

#[rustfmt::skip]
const STOPPED: [Stopped; 4] = [
    Stopped { name: "libration-rests", first: Rolling, half_swings: 3, events: &[
        (Cause::TurningPoint, 4.698_036_634_357_337, 3.568_401_947_822_790, -1.068_401_947_822_790),
        (Cause::TurningPoint, 9.245_781_887_640_576, 2.920_392_124_381_650, -0.420_392_124_381_650),
        (Cause::TurningPoint, 13.717_685_881_608_999, 3.161_729_300_114_043, -0.661_729_300_114_043),
    ] },
    Stopped { name: "rests-on-far-side", first: Rolling, half_swings: 1, events: &[
        (Cause::TurningPoint, 7.518_439_374_824_437, 4.905_770_807_773_497, -5.405_770_807_773_497),
        (Cause::TurningPoint, 18.338_181_813_002_127, 3.348_195_045_935_370, -3.848_195_045_935_370),
    ] },
    Stopped { name: "disc-rests-on-ramp", first: Rolling, half_swings: 0, events: &[
        (Cause::TurningPoint, 8.341_441_475_246_614, -4.170_720_737_623_307, 4.170_720_737_623_307),
    ] },
    Stopped { name: "skid", first: Skidding, half_swings: 2, events: &[
        (Cause::Stick, 1.666_666_666_666_667, 1.216_25, 0.416_666_666_666_667),
        (Cause::TurningPoint, 9.273_748_402_143_036, 4.035_951_564_529_660, -2.403_034_897_862_993),
        (Cause::TurningPoint, 14.997_017_141_701_967, 2.967_901_558_165_440, -1.334_984_891_498_776),
    ] },
];

#[test]
fn rolling_resistance_stops_the_hoop() {
    for expected in STOPPED {
        let (name, motion) = (expected.name, case(expected.name));
        assert_eq!(modes(&motion)[0], expected.first, "{name}");
        assert_eq!(modes(&motion).last(), Some(&Rest), "{name}");
        assert_eq!(motion.transitions().len(), expected.events.len(), "{name}");
        for (found, &(cause, time, theta, x)) in motion.transitions().iter().zip(expected.events) {
            assert_eq!(found.cause, cause, "{name}");
            let numbers = [found.time(), found.after.theta, found.after.x];
            for (found, wanted) in numbers.into_iter().zip([time, theta, x]) {
                assert!(
                    (found - wanted).abs() < 1e-13 * wanted.abs(),
                    "{name}: {found}"
                );
            }
        }
        let Outcome::Rests { half_swings, .. } = motion.outcome() else {
            panic!("{name}: {:?}", motion.outcome())
        };
        assert_eq!(half_swings, expected.half_swings, "{name}");
        // All start at τ = 0.
        let end = motion.transitions().last().expect("a stop").time();
        assert_eq!(motion.rest_shown_until(), Some(end + 0.1 * end), "{name}");
    }
    assert_eq!(case("figure-2-libration").rest_shown_until(), None);
    let hoop = Hoop::new(find_case("libration-rests").expect("a case").setup.hoop);
    let mut start = Start::at(3.1, 0.0);
    start.time = 2.0;
    let stays = hoop.and_then(|hoop| hoop.simulate(start, Limits::default()));
    let stays = stays.expect("a valid start");
    assert_eq!(stays.rest_shown_until(), Some(12.0));

    // The disc in closed form: θ″ = m (g_t − ς χ g_n)/(Î + m), with m = 2, Î = ½ and ς = −1.
    let disc = case("disc-rests-on-ramp");
    let (sin, cos) = 0.05_f64.sin_cos();
    let time = 2.5 / (2.0 * (sin + 0.1 * cos));
    assert!((disc.transitions()[0].time() - time).abs() < 1e-14 * time);
}

#[test]
fn cases_have_names_that_differ_and_valid_parameters() {
    let names: BTreeSet<_> = CASES.iter().map(|case| case.name).collect();
    assert_eq!(names.len(), CASES.len());
    for case in CASES {
        assert!(!case.title.is_empty() && !case.source.is_empty());
        assert!(case.simulate().is_ok(), "{}", case.name);
    }
    assert!(find_case("figure-1").is_none());
}

/// Starts that take the edges which no named case takes.
fn other_motions() -> Vec<Trajectory> {
    let hoop = |mass_ratio, offset, inertia, mu_s, mu_k| {
        Hoop::new(
            HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_k),
        )
        .expect("a valid hoop")
    };
    let inside = hoop(0.0, 0.6, 0.0, 0.3, 0.2);
    let thin = hoop(1.0, 1.0, 1.0, 0.5, 0.4);
    let rim = hoop(0.0, 1.0, 0.0, 0.5, 0.4);
    // Wedged: rolling needs N > 0 where w < 0, until friction gives way.
    let steep = HoopParameters::thin(0.3)
        .with_offset(0.9)
        .with_friction(2.0, 1.0)
        .with_slope(-1.4);
    let steep = Hoop::new(steep).expect("a valid hoop");
    [
        (steep, Start::at(2.3, 0.0)),
        (thin, Start::at(0.8, -2.2).with_slip(0.4)),
        (thin, Start::at(-2.0, 2.2).with_slip(-0.3)),
        (thin, Start::at(-0.7735579900798988, 1.4271356783919602)),
        (inside, Start::at(1.0, 1.0).with_slip(0.5)),
        (rim, Start::at(1.0, -2.5).with_slip(0.5)),
    ]
    .into_iter()
    .map(|(hoop, start)| {
        hoop.simulate(start, Limits::until(40.0))
            .expect("a valid start")
    })
    .chain(jams())
    .chain(resisted())
    .collect()
}

/// Motions with rolling resistance, on the level and on slopes: m̂1, ℓ̂, Îzz, μs, μk, χ, α, θ,
/// θ′ and η′.
#[rustfmt::skip]
const RESISTED: [[f64; 10]; 20] = [
    [1.0, 0.6, 0.5, 0.4, 0.3, 0.1, 0.0, 2.0, 1.5, -0.5],
    [1.0, 0.6, 0.5, 0.4, 0.3, 0.3, 0.0, 3.0, 0.0, 0.5],
    [1.0, 0.6, 0.5, 0.05, 0.04, 0.02, 0.0, 1.0, 0.5, 0.0],
    // To slide, and to skid, out of a turning point of rolling on a slope.
    [0.3878, 0.2, 0.3761, 0.433, 0.4081, 0.1932, 1.1773, -2.1098, 0.0, 0.3355],
    [0.00587, 0.8517, 0.00233, 0.3173, 0.3173, 0.4128, 0.41, -2.4, -0.53, 0.0],
    [8.7e-4, 0.8357, 4.2e-4, 0.1417, 0.1125, 0.0952, 0.7564, -2.13, 0.0, 1.45],
    [2.88, 0.478, 1.6, 0.0495, 0.0406, 0.019, -0.5248, -2.998, 0.0, -1.164],
    [0.0346, 0.4249, 0.00125, 1.6177, 0.5067, 0.1038, 0.7685, 2.369, 0.0, 0.3994],
    // Nothing is consistent where the slip of a light hoop begins, or ends.
    [7.56e-4, 0.679, 5.96e-4, 0.765, 0.443, 0.2583, 0.0, 1.2327, 0.0, 0.0],
    [1.453e-3, 1.0, 7.2e-4, 2.627, 1.3794, 0.4241, 0.0, -1.3367, 0.036, 0.0197],
    // Massless.
    [0.0, 0.615, 0.0, 1.137, 1.005, 0.348, 0.0, 2.703, -0.885, 0.068],
    [0.0, 0.225, 0.0, 0.056, 0.037, 1.957, 0.0, -0.059, 0.704, -1.177],
    [0.0, 0.967, 0.0, 0.357, 0.357, 0.0117, 0.0, -1.057, 0.173, -0.778],
    [0.0, 0.765, 0.0, 2.693, 2.693, 0.0329, 0.0, 2.374, 1.02, -0.92],
    [0.0, 0.711, 0.0, 0.263, 0.263, 0.333, 0.0, -2.605, 0.0, -0.72],
    // To glide, and to skid, out of a turning point and of a skid on a slope.
    [0.0, 0.1352, 0.0, 0.0743, 0.0406, 0.0624, -1.1446, 0.7542, 1.3612, 0.0],
    [0.0, 0.4527, 0.0, 0.1407, 0.1407, 0.5783, -1.0111, 1.3611, 0.0, -0.6971],
    [0.0, 1.0, 0.0, 1.4764, 1.4764, 1.5674, -0.8931, -2.0399, 0.0, -0.3582],
    [0.0, 0.3773, 0.0, 0.2585, 0.037, 1.0376, 0.6062, 0.2336, -1.171, 0.0],
    // The slip ends where pressing would close the gap.
    [0.0, 1.0, 0.0, 2.0768, 0.7813, 2.3256, 0.0, 1.5247, 2.554, 0.1874],
];

/// With impacts, and the rate at which the gap opens and e.
#[rustfmt::skip]
const RESISTED_IMPACTS: [[f64; 12]; 6] = [
    // Bounces settle into rest and into a skid, and a landing leads to each.
    [0.873, 0.489, 0.32223, 0.418, 0.234, 0.736, 0.0, 1.998, 0.439, 0.53, 1.77, 0.3],
    [0.898, 0.428, 0.86794, 0.14, 0.14, 0.814, 0.0, -2.201, -0.274, -0.46, 0.224, 0.4],
    [1.01, 0.288, 0.6812, 1.34, 1.34, 0.366, 0.0, 2.977, 0.214, 0.184, 1.499, 0.0],
    [0.898, 0.428, 0.86794, 0.14, 0.14, 0.814, 0.0, -2.201, -0.274, -0.46, 0.224, 0.0],
    // Jams into rest and into a skid.
    [0.0234, 0.9, 0.01023, 2.179, 2.179, 0.652, 0.0, -3.026, -1.37, 0.0, 0.0, 0.0],
    [0.0634, 0.33, 0.01927, 1.443, 1.443, 3.13, 0.0, -1.799, -1.282, 0.0, 0.0, 0.0],
];

fn resisted() -> impl Iterator<Item = Trajectory> {
    let setup = |[
        mass_ratio,
        offset,
        inertia,
        mu_s,
        mu_k,
        chi,
        slope,
        theta,
        rate,
        slip,
    ]: [f64; 10]| {
        let parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k)
            .with_rolling_resistance(chi)
            .with_slope(slope);
        (parameters, Start::at(theta, rate).with_slip(slip))
    };
    let impacts = RESISTED_IMPACTS.map(|[in_contact @ .., gap_rate, e]| {
        let (parameters, start) = setup(in_contact);
        let parameters = parameters.with_restitution(e, RestitutionLaw::Energetic);
        (parameters, start.with_gap_rate(gap_rate))
    });
    let contacts = RESISTED.map(setup);
    contacts
        .into_iter()
        .chain(impacts)
        .map(|(parameters, start)| {
            let hoop = Hoop::new(parameters).expect("a valid hoop");
            let limits = Limits::until(40.0);
            hoop.simulate(start, limits).expect("a valid start")
        })
}

/// Light hoops on rough planes, at P ≤ 0 from the start and later, with and without restitution.
fn jams() -> Vec<Trajectory> {
    let plastic = Restitution::new(0.0, RestitutionLaw::Energetic).expect("a coefficient");
    let runs_into_it = (0.2, 1.0, Start::at(1.6, -2.06).with_slip(1.08));
    let with_e = [
        (0.06, 1.0, Start::at(1.4, -1.98).with_slip(1.79)),
        (0.31, 1.4, Start::at(1.46, -2.59).with_slip(1.0)),
        runs_into_it,
        (0.02, 0.84, Start::at(2.0, -1.59).with_slip(1.6)),
    ];
    let hoop = |mass: f64, mu: f64| {
        Hoop::new(HoopParameters::thin(mass).with_friction(mu, mu)).expect("a valid hoop")
    };
    let limits = Limits::until(5.0);
    let mut motions: Vec<Trajectory> = with_e
        .into_iter()
        .map(|(mass, mu, start)| {
            hoop(mass, mu)
                .with_restitution(plastic)
                .expect("heavy")
                .simulate(start, limits)
        })
        .map(|motion| motion.expect("a valid start"))
        .collect();
    let light = HoopParameters::thin(0.0)
        .with_offset(0.1)
        .with_inertia(1e-5)
        .with_friction(0.02, 0.02);
    let light = Hoop::new(light)
        .and_then(|hoop| hoop.with_restitution(plastic))
        .expect("a valid hoop");
    motions.push(
        light
            .simulate(Start::at(2.4, -3.9).with_slip(0.1), limits)
            .expect("a valid start"),
    );
    // Without friction, from a rate at which η″ and η′ vanish together but for the last digits.
    let smooth = HoopParameters::thin(2.805_174_719_718_886_3).with_offset(0.999_999_999_618_712_1);
    let grazes = Start::at(-1.677_452_557_099_741, 1.000_000_000_010_5);
    motions.push(
        Hoop::new(smooth)
            .expect("a valid hoop")
            .simulate(grazes, limits)
            .expect("a valid start"),
    );
    let (mass, mu, start) = runs_into_it;
    motions.push(
        hoop(mass, mu)
            .simulate(start, limits)
            .expect("a valid start"),
    );
    let settles_sliding = hoop(1.0, 0.05)
        .with_restitution(Restitution::new(0.3, RestitutionLaw::Newton).expect("a coefficient"));
    let thrown = Start::at(2.0, 0.9).with_slip(1.5).with_gap_rate(0.02);
    motions.push(
        settles_sliding
            .expect("heavy")
            .simulate(thrown, limits)
            .expect("a valid start"),
    );
    motions
}

#[test]
fn the_table_of_edges_is_the_automaton() {
    let mut taken = BTreeSet::new();
    let cases = CASES
        .iter()
        .map(|case| case.simulate().expect("a valid case"));
    for motion in cases.chain(other_motions()) {
        let class = match motion.hoop().body() {
            Body::Heavy(_) => BodyClass::Heavy,
            Body::Massless(_) => BodyClass::Massless,
        };
        for transition in motion.transitions() {
            let its = (class, transition.from, transition.cause, transition.to);
            let edge = EDGES
                .iter()
                .position(|edge| (edge.body, edge.from, edge.cause, edge.to) == its);
            taken.insert(edge.unwrap_or_else(|| panic!("{transition:?} is no edge")));
        }
    }
    let missing: Vec<_> = (0..EDGES.len())
        .filter(|i| !taken.contains(i))
        .map(|i| EDGES[i])
        .collect();
    assert!(missing.is_empty(), "never taken: {missing:#?}");
}
