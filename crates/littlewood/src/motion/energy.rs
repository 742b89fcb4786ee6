//! Where the energy of the start has gone.

use crate::modes::Sample;
use crate::motion::trajectory::Trajectory;

/// The energy at the start by what it has become, over m2 g R. The parts add up to it; one that is
/// less than its own rounding is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyParts {
    /// Kinetic.
    pub kinetic: f64,
    /// Potential, U of (2.8): negative with the particle below C.
    pub potential: f64,
    /// Lost to friction in slip.
    pub friction: f64,
    /// Lost to rolling resistance.
    pub rolling_resistance: f64,
    /// Lost in impacts; negative where Newton's law has gained more.
    pub impacts: f64,
    /// At the start.
    pub start: f64,
}

/// The losses of a motion up to each of its phases.
#[derive(Clone, Debug)]
pub struct EnergyLedger<'a> {
    trajectory: &'a Trajectory,
    start: f64,
    phases: Vec<Entry>,
}

/// The start of a phase: its time and energy, and what had been lost before.
#[derive(Clone, Copy, Debug)]
struct Entry {
    time: f64,
    energy: f64,
    lost: Losses,
}

#[derive(Clone, Copy, Debug, Default)]
struct Losses {
    friction: f64,
    rolling_resistance: f64,
    impacts: f64,
}

impl Losses {
    /// Adds what a phase has lost, with the part that rolling resistance took.
    const fn add(&mut self, lost: f64, rolling_resistance: f64) {
        self.friction += (lost - rolling_resistance).max(0.0);
        self.rolling_resistance += rolling_resistance;
    }
}

impl<'a> EnergyLedger<'a> {
    /// None for a motion that does not begin.
    pub fn new(trajectory: &'a Trajectory) -> Option<Self> {
        let phases = trajectory.phases();
        let mut lost = Losses::default();
        let mut start = None;
        let mut entries = Vec::with_capacity(phases.len());
        for (index, phase) in phases.iter().enumerate() {
            for transition in trajectory.leading_to(index) {
                lost.impacts += transition.impact.map_or(0.0, |impact| impact.energy_lost());
            }
            let energy = phase.first().energy;
            start = start.or(Some(energy + lost.impacts));
            entries.push(Entry {
                time: phase.start().time,
                energy,
                lost,
            });
            lost.add(phase.energy_lost(), phase.rolling_resistance_energy_lost());
        }
        let start = start?;
        Some(Self {
            trajectory,
            start,
            phases: entries,
        })
    }

    /// The parts at an instant: at a transition of the phase after it.
    pub fn parts(&self, sample: &Sample) -> Option<EnergyParts> {
        let hoop = self.trajectory.hoop();
        let time = sample.state.time;
        let after = self.phases.partition_point(|entry| entry.time <= time);
        let place = after.max(1) - 1;
        let (entry, phase) = (
            self.phases.get(place)?,
            self.trajectory.phases().get(place)?,
        );
        let potential = sample.potential_energy(hoop);
        let mut lost = entry.lost;
        if phase.loses_energy() {
            let in_phase = (entry.energy - sample.energy).max(0.0);
            lost.add(in_phase, phase.share_of_resistance(time, in_phase));
        }
        let Losses {
            friction,
            rolling_resistance,
            impacts,
        } = lost;
        // A part is a sum of energies, and so is each of what it is the difference of; what is lost
        // adds one for each phase and each impact before.
        let size = self.start.abs()
            + hoop.offset()
            + potential.abs()
            + friction
            + rolling_resistance
            + impacts.abs();
        let rounding = 4.0 * f64::EPSILON * size;
        let seen = |value: f64, count: usize| {
            if value.abs() > count as f64 * rounding {
                value
            } else {
                0.0
            }
        };
        Some(EnergyParts {
            kinetic: seen(sample.energy - potential, 1),
            potential: seen(potential, 1),
            friction: seen(friction, 2 * place + 1),
            rolling_resistance: seen(rolling_resistance, 2 * place + 1),
            impacts: seen(impacts, 2 * place + 1),
            start: self.start,
        })
    }

    /// The scale of energies on which the parts of these samples have room one upon the other:
    /// from the least potential energy, up to that of the start and what a law of impact has
    /// gained. An energy stands on it at the same place as a part that ends there.
    pub fn scale<'s>(&self, samples: impl IntoIterator<Item = &'s Sample>) -> [f64; 2] {
        samples
            .into_iter()
            .filter_map(|sample| self.parts(sample))
            .fold([self.start; 2], |[low, high], parts| {
                let gained = (-parts.impacts).max(0.0);
                [low.min(parts.potential), high.max(self.start + gained)]
            })
    }
}
