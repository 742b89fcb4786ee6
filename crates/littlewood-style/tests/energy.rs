//! The parts of the energy add up to that of the start.

use littlewood::cases::CASES;
use littlewood::{Hoop, Limits, Mode, RestitutionLaw, Trajectory};
use littlewood_style::{EnergyParts, Ledger};

fn sum(energies: &EnergyParts) -> f64 {
    energies.kinetic + energies.potential + energies.friction + energies.impacts
}

fn at(motion: &Trajectory, time: f64) -> Option<EnergyParts> {
    Ledger::new(motion)?.parts(&motion.at(time)?, false)
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
            let slope = motion.hoop().slope();
            assert_eq!(case.setup.start.x, 0.0, "{}", case.name);
            let total = first.first().energy + case.setup.hoop.offset * libm::cos(slope) + lost;
            let end = motion.end_time().min(20.0);
            for i in 0..=200 {
                let time =
                    case.setup.start.time + (end - case.setup.start.time) * f64::from(i) / 200.0;
                let Some(energies) = at(&motion, time) else {
                    continue;
                };
                // Where a glide ends its rate is infinite.
                if energies.kinetic.is_finite() {
                    assert!(
                        (sum(&energies) - total).abs() < 1e-12 * (1.0 + total),
                        "{} at {time}",
                        case.name
                    );
                    assert!(
                        (energies.potential >= 0.0 || slope != 0.0) && energies.kinetic >= -1e-12,
                        "{} at {time}",
                        case.name
                    );
                }
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
