//! Where the energy of the start is at a time.

use littlewood::{Phase, Sample, Trajectory};
use littlewood_style::EnergyPart;

/// Shares of the energy, over m2 g R, which add up to that of the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Energies {
    /// Kinetic.
    pub(crate) kinetic: f64,
    /// Potential, above that of a hoop at the plane with its particle at the bottom.
    pub(crate) potential: f64,
    /// Lost to friction in sliding.
    pub(crate) friction: f64,
    /// Lost in impacts; negative where Newton's law has gained some.
    pub(crate) impacts: f64,
}

impl Energies {
    /// One of the parts.
    pub(crate) const fn part(&self, part: EnergyPart) -> f64 {
        match part {
            EnergyPart::Kinetic => self.kinetic,
            EnergyPart::Potential => self.potential,
            EnergyPart::Friction => self.friction,
            EnergyPart::Impacts => self.impacts,
        }
    }

    /// At the instant `time`, after a transition there; none outside the motion.
    pub(crate) fn at(trajectory: &Trajectory, time: f64) -> Option<Self> {
        let sample = trajectory.at(time)?;
        let phases = trajectory.phases();
        let index = phases.partition_point(|phase| phase.start().time <= time).checked_sub(1)?;
        let phase = phases.get(index)?;
        let hoop = trajectory.hoop();
        let potential = hoop.offset() * (1.0 + libm::cos(sample.state.theta)) + hoop.mass() * sample.gap;
        Some(Self {
            kinetic: sample.energy + hoop.offset() - potential,
            potential,
            friction: phases[..index].iter().map(Phase::energy_lost).sum::<f64>()
                + lost_so_far(phase, &sample),
            impacts: impacts_before(trajectory, phase),
        })
    }
}

/// Lost to friction since a phase began.
fn lost_so_far(phase: &Phase, sample: &Sample) -> f64 {
    // Rounding in a phase that loses nothing is no loss.
    if phase.energy_lost() == 0.0 && phase.end().is_some() {
        return 0.0;
    }
    match phase.direction() {
        Some(_) => phase.first().energy - sample.energy,
        None => 0.0,
    }
}

/// Lost in impacts before a phase began.
fn impacts_before(trajectory: &Trajectory, phase: &Phase) -> f64 {
    let own_end = trajectory.end_of(phase);
    trajectory
        .transitions()
        .iter()
        .take_while(|transition| own_end.is_none_or(|end| !core::ptr::eq(*transition, end)))
        .filter(|transition| transition.time() <= phase.start().time)
        .filter_map(|transition| transition.impact)
        .map(|impact| impact.energy_lost())
        .sum()
}

#[cfg(test)]
mod tests {
    use littlewood::cases::CASES;
    use littlewood::{Hoop, Limits, Mode, RestitutionLaw};

    use super::*;

    fn sum(energies: &Energies) -> f64 {
        energies.kinetic + energies.potential + energies.friction + energies.impacts
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
                let motion = Hoop::new(parameters).unwrap().simulate(case.setup.start, limits).unwrap();
                let Some(first) = motion.phases().first() else { continue };
                let jammed = motion.transitions().iter().filter(|it| it.from.is_none());
                let lost: f64 = jammed.filter_map(|it| it.impact).map(|impact| impact.energy_lost()).sum();
                let total = first.first().energy + case.setup.hoop.offset + lost;
                let end = motion.end_time().min(20.0);
                for i in 0..=200 {
                    let time = case.setup.start.time + (end - case.setup.start.time) * f64::from(i) / 200.0;
                    let Some(energies) = Energies::at(&motion, time) else { continue };
                    // Where a glide ends its rate is infinite.
                    if energies.kinetic.is_finite() {
                        assert!(
                            (sum(&energies) - total).abs() < 1e-12 * (1.0 + total),
                            "{} at {time}",
                            case.name
                        );
                        assert!(
                            energies.potential >= 0.0 && energies.kinetic >= -1e-12,
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
        let motion = littlewood::cases::find_case("figure-3-bounces").unwrap().simulate().unwrap();
        let landing = 3.847_395_556_686_894;
        let before = Energies::at(&motion, landing - 1e-9).unwrap();
        let after = Energies::at(&motion, landing + 1e-9).unwrap();
        assert_eq!(before.impacts, 0.0);
        assert!((after.impacts - 3.362_443_419_227_28).abs() < 1e-12);
        assert!(before.friction > 0.0 && after.friction == before.friction);
        assert_eq!(motion.at(landing + 1e-9).unwrap().mode, Mode::Flight);
    }
}
