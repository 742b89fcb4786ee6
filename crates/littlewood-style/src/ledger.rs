//! Where the energy of the start has gone.

use littlewood::{Hoop, Mode, Sample, Trajectory};

use crate::energy::EnergyPart;

/// The energy at the start by what it has become, over m2 g R; the potential energy is counted from
/// its least value, on a slope from that where the motion begins, below which it may fall. The
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

impl EnergyParts {
    /// A part.
    pub const fn part(&self, part: EnergyPart) -> f64 {
        match part {
            EnergyPart::Kinetic => self.kinetic,
            EnergyPart::Potential => self.potential,
            EnergyPart::Friction => self.friction,
            EnergyPart::Impacts => self.impacts,
        }
    }
}

/// The losses of a motion up to each of its phases.
#[derive(Clone, Debug)]
pub struct Ledger {
    hoop: Hoop,
    /// Where the motion begins along the plane.
    x: f64,
    start: f64,
    /// Time at the start of each phase, its energy then, and what had been lost to friction and in
    /// impacts.
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
    pub fn new(trajectory: &Trajectory) -> Option<Self> {
        let hoop = *trajectory.hoop();
        let (mut friction, mut impacts) = (0.0, 0.0);
        // A jam at the start ends no phase.
        if let Some(first) = trajectory
            .transitions()
            .first()
            .filter(|first| first.from.is_none())
        {
            impacts += first.impact.map_or(0.0, |impact| impact.energy_lost());
        }
        let first = trajectory.phases().first()?.first();
        let x = first.state.x;
        let start = first.energy + impacts + reference(&hoop, x);
        let mut phases = Vec::with_capacity(trajectory.phases().len());
        for phase in trajectory.phases() {
            phases.push(Entry {
                time: phase.start().time,
                energy: phase.first().energy,
                friction,
                impacts,
            });
            friction += phase.energy_lost();
            let impact = trajectory
                .end_of(phase)
                .and_then(|transition| transition.impact);
            impacts += impact.map_or(0.0, |impact| impact.energy_lost());
        }
        Some(Self {
            hoop,
            x,
            start,
            phases,
        })
    }

    /// The parts at an instant: of the phase before a transition, or of the one after it.
    pub fn parts(&self, sample: &Sample, is_before: bool) -> Option<EnergyParts> {
        let time = sample.state.time;
        let after = self.phases.partition_point(|entry| {
            if is_before {
                entry.time < time
            } else {
                entry.time <= time
            }
        });
        let entry = self.phases.get(after.max(1) - 1)?;
        let gap = if sample.gap.is_finite() {
            sample.gap
        } else {
            0.0
        };
        let (sin, cos) = libm::sincos(sample.state.theta);
        let (along, across) = libm::sincos(self.hoop.slope());
        let hoop = &self.hoop;
        let risen = hoop.mass() * along * (sample.state.x - self.x - hoop.h() * sin);
        let potential = across * (hoop.offset() * (1.0 + cos) + hoop.mass() * gap) + risen;
        let slides = match sample.mode {
            Mode::Sliding => (entry.energy - sample.energy).max(0.0),
            Mode::Rolling | Mode::Gliding | Mode::Flight => 0.0,
        };
        let (friction, impacts) = (entry.friction + slides, entry.impacts);
        // Where a particle of a massless hoop meets the plane its rate is infinite, but not its
        // energy.
        let kinetic = Some(sample.energy + reference(hoop, self.x) - potential)
            .filter(|kinetic| kinetic.is_finite())
            .unwrap_or(self.start - potential - friction - impacts);
        Some(EnergyParts {
            kinetic,
            potential,
            friction,
            impacts,
            start: self.start,
        })
    }
}

/// By how much the potential energy of a ledger exceeds that of a sample.
fn reference(hoop: &Hoop, x: f64) -> f64 {
    let (along, across) = libm::sincos(hoop.slope());
    across * hoop.offset() - hoop.mass() * along * x
}
