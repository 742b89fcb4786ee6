//! The parts of the energy add up to that of the start.
#![allow(clippy::panic)] // a failed expectation

use crate::common::instants;
use crate::invariants::{LAW_ROUNDING, size};
use littlewood::cases::CASES;
use littlewood::energy::{EnergyLedger, EnergyParts};
use littlewood::tables::Setup;
use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, RestitutionLaw, Start, Trajectory};
use littlewood_random::jam_after_a_stick;
use proptest::prelude::*;

fn sum(energies: &EnergyParts) -> f64 {
    let EnergyParts {
        kinetic,
        potential,
        friction,
        rolling_resistance,
        impacts,
        ..
    } = energies;
    kinetic + potential + friction + rolling_resistance + impacts
}

fn at(motion: &Trajectory, time: f64) -> Option<EnergyParts> {
    EnergyLedger::new(motion)?.parts(&motion.at(time)?)
}

#[test]
fn the_shares_add_up_to_the_energy_of_the_start() {
    for case in CASES {
        for law in [None, Some(RestitutionLaw::Newton)] {
            let mut parameters = case.setup.hoop;
            if let (Some(law), true) = (law, parameters.restitution.is_some()) {
                parameters.restitution_law = Some(law);
            }
            let limits = Limits::until(case.setup.start.time + 20.0).with_transitions(100);
            let motion = Hoop::new(parameters)
                .unwrap()
                .simulate(case.setup.start, limits)
                .unwrap();
            let Some(first) = motion.phases().first() else {
                continue;
            };
            let jammed = motion.transitions().iter().filter(|it| it.from.is_none());
            let lost: f64 = jammed
                .filter_map(|it| it.impact)
                .map(|impact| impact.energy_lost())
                .sum();
            let total = first.first().energy + lost;
            let end = motion.end_time().min(20.0);
            for i in 0..=200 {
                let time =
                    case.setup.start.time + (end - case.setup.start.time) * f64::from(i) / 200.0;
                let Some(energies) = at(&motion, time) else {
                    continue;
                };
                assert!(
                    (sum(&energies) - total).abs() < 1e-12 * (1.0 + total),
                    "{} at {time}",
                    case.name
                );
                assert!(energies.kinetic >= 0.0, "{} at {time}", case.name);
            }
        }
    }
}

#[test]
fn figure_3_loses_in_its_first_impact_what_the_notes_say() {
    let motion = littlewood::cases::find_case("figure-3-bounces")
        .unwrap()
        .simulate()
        .unwrap();
    let landing = 3.847_395_556_686_894;
    let before = at(&motion, landing - 1e-9).unwrap();
    let after = at(&motion, landing + 1e-9).unwrap();
    assert_eq!(before.impacts, 0.0);
    assert!((after.impacts - 3.362_443_419_227_28).abs() < 1e-12);
    assert!(before.friction > 0.0 && after.friction == before.friction);
    assert_eq!(motion.at(landing + 1e-9).unwrap().mode, Mode::Flight);
}

/// U of (2.8) is ℓ cos θ, from −1 with the particle below C of Figure 3 to 1 above it: the energy of
/// its start, at θ = π/2 with θ′ = 2 and D = 4, is 8.
#[test]
fn the_energy_has_the_zero_of_the_paper() {
    let case = littlewood::cases::find_case("figure-3-bounces").unwrap();
    let motion = case.simulate().unwrap();
    let first = at(&motion, 0.0).unwrap();
    assert_eq!((first.potential, first.kinetic), (0.0, 8.0));
    assert_eq!(first.start, motion.phases()[0].first().energy);
    let samples: Vec<_> = motion.sample_evenly(2000, 6.0).collect();
    let [low, high] = EnergyLedger::new(&motion).unwrap().scale(&samples);
    assert!((-1.0..-0.999).contains(&low), "{low}");
    assert_eq!(high, 8.0);
}

/// A slip that sticks where pressing closes the gap: the jam between the two ends no phase.
#[test]
fn a_jam_to_which_a_stick_leads_takes_energy() {
    let Setup { hoop, start } = jam_after_a_stick();
    let motion = Hoop::new(hoop)
        .unwrap()
        .simulate(start, Limits::until(20.0))
        .unwrap();
    let [.., stick, jam] = motion.transitions() else {
        panic!("{:?}", motion.transitions())
    };
    assert_eq!((stick.cause, stick.to), (Cause::Stick, None));
    assert_eq!((jam.cause, jam.to), (Cause::Jam, Some(Mode::Rest)));
    check_ledger(&motion).expect("a ledger that adds up");
    let parts = at(&motion, 20.0).expect("an instant of the motion");
    assert_eq!(parts.impacts, motion.impact_energy_lost());
}

/// With so large a χ the last digit of the angle moves the normal force of a slide, and so what
/// rolling resistance takes.
#[test]
fn rolling_resistance_takes_no_more_than_a_slide_loses() {
    let hoop = HoopParameters::thin(2.941_994_950_376_756_6)
        .with_inertia(1.064_112_037_521_648_4e-3)
        .with_friction(0.4, 0.4)
        .with_rolling_resistance(1e9)
        .with_slope(-1.581_399_767_137_878_7e-9);
    let start = Start::at(std::f64::consts::PI.next_down(), -8.313_570_432_352_596e-2);
    let motion = Hoop::new(hoop)
        .unwrap()
        .simulate(start, Limits::until(20.0))
        .unwrap();
    let ledger = EnergyLedger::new(&motion).unwrap();
    for phase in motion.phases() {
        for elapsed in instants(phase.duration(), 20) {
            let parts = ledger.parts(&phase.sample(elapsed)).unwrap();
            assert!((sum(&parts) - parts.start).abs() < 1e-14, "{parts:?}");
        }
    }
}

/// Uphill by x the mass has risen by x sin α: on an incline U is m (y cos α + x sin α) of the mass
/// centre, y from the height of C in contact.
#[test]
fn on_a_slope_what_rises_gains() {
    let case = littlewood::cases::find_case("ramp-bounces").unwrap();
    let motion = case.simulate().unwrap();
    let (sin, cos) = libm::sincos(case.setup.hoop.slope);
    for sample in motion.sample_evenly(300, 10.0) {
        let wanted = 2.0 * (cos * (sample.mass_centre.y - 1.0) + sin * sample.mass_centre.x);
        let parts = EnergyLedger::new(&motion).unwrap().parts(&sample).unwrap();
        assert!((parts.potential - wanted).abs() < 1e-13, "{parts:?}");
    }
}

/// The parts add up at every instant, and what is lost only grows: within the rounding of the
/// energies of which they are differences. Kinetic friction multiplies the rounding of forces.
pub(crate) fn check_ledger(motion: &Trajectory) -> Result<(), TestCaseError> {
    let Some(ledger) = EnergyLedger::new(motion) else {
        return Ok(());
    };
    let (hoop, phases) = (motion.hoop(), motion.phases());
    let mut before: Option<EnergyParts> = None;
    let mut largest = 0.0_f64;
    for (index, phase) in phases.iter().enumerate() {
        // The parts at an event are those after it.
        for elapsed in instants(phase.duration(), 20).take(21) {
            let sample = phase.sample(elapsed);
            let Some(parts) = ledger.parts(&sample) else {
                continue;
            };
            largest = largest.max(size(hoop, &sample));
            let rounding = LAW_ROUNDING * largest * (1.0 + hoop.mu_k()) * (1.0 + index as f64);
            let missing = sum(&parts) - parts.start;
            prop_assert!(
                missing.abs() <= rounding && parts.kinetic >= -rounding,
                "{missing}, not {rounding}: {parts:?} {sample:?}"
            );
            let grows = before.is_none_or(|before| {
                parts.friction - before.friction >= -rounding
                    && parts.rolling_resistance - before.rolling_resistance >= -rounding
            });
            prop_assert!(grows, "{before:?} {parts:?} {sample:?}");
            before = Some(parts);
        }
    }
    Ok(())
}
