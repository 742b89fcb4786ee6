//! Where the energy of the start has gone.

use littlewood::{Hoop, Mode, Sample, Trajectory};

/// The energy at the start by what it has become, over m2 g R; the potential energy is counted from its least value. The
/// parts add up to the energy at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyParts {
    /// Kinetic.
    pub kinetic: f64,
    /// Potential.
    pub potential: f64,
    /// Lost to friction in sliding.
    pub friction: f64,
    /// Lost in impacts; negative where Newton's law has gained more.
    pub impacts: f64,
    /// At the start.
    pub start: f64,
}

/// The losses of a motion up to each of its phases.
#[derive(Clone, Debug)]
pub(crate) struct Ledger {
    hoop: Hoop,
    start: f64,
    /// Time at the start of each phase, its energy then, and what had been lost to friction and in impacts.
    phases: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    time: f64,
    energy: f64,
    friction: f64,
    impacts: f64,
}

impl Ledger {
    /// None for a motion that does not begin.
    pub(crate) fn new(trajectory: &Trajectory) -> Option<Self> {
        let hoop = *trajectory.hoop();
        let (mut friction, mut impacts) = (0.0, 0.0);
        // A jam at the start ends no phase.
        if let Some(first) = trajectory.transitions().first().filter(|first| first.from.is_none()) {
            impacts += first.impact.map_or(0.0, |impact| impact.energy_lost());
        }
        let start = trajectory.phases().first()?.first().energy + impacts + hoop.offset();
        let mut phases = Vec::with_capacity(trajectory.phases().len());
        for phase in trajectory.phases() {
            phases.push(Entry { time: phase.start().time, energy: phase.first().energy, friction, impacts });
            friction += phase.energy_lost();
            let impact = trajectory.end_of(phase).and_then(|transition| transition.impact);
            impacts += impact.map_or(0.0, |impact| impact.energy_lost());
        }
        Some(Self { hoop, start, phases })
    }

    /// The parts at an instant: of the phase before a transition, or of the one after it.
    pub(crate) fn parts(&self, sample: &Sample, is_before: bool) -> Option<EnergyParts> {
        let time = sample.state.time;
        let after = self
            .phases
            .partition_point(|entry| if is_before { entry.time < time } else { entry.time <= time });
        let entry = self.phases.get(after.max(1) - 1)?;
        let gap = if sample.gap.is_finite() { sample.gap } else { 0.0 };
        let potential = self.hoop.offset() * (1.0 + libm::cos(sample.state.theta)) + self.hoop.mass() * gap;
        let slides = match sample.mode {
            Mode::Sliding => (entry.energy - sample.energy).max(0.0),
            Mode::Rolling | Mode::Gliding | Mode::Flight => 0.0,
        };
        let (friction, impacts) = (entry.friction + slides, entry.impacts);
        // Where a particle of a massless hoop meets the plane its rate is infinite, but not its energy.
        let kinetic = Some(sample.energy + self.hoop.offset() - potential)
            .filter(|kinetic| kinetic.is_finite())
            .unwrap_or(self.start - potential - friction - impacts);
        Some(EnergyParts { kinetic, potential, friction, impacts, start: self.start })
    }
}
