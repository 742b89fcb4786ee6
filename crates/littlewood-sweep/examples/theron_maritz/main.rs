//! The sequences of phases of the first turn, in the set-up of Theron and Maritz: from the top,
//! rolling, μs = μk, over eccentricity, friction and angular velocity. `docs/atlas.md` has its
//! counts.
//!
//! ```sh
//! cargo run --release -p littlewood-sweep --example theron_maritz -- 40 shift 1 0.02
//! ```
//!
//! takes 40 values of each of the three, μ from 0.02, then refines the grid, once, around the
//! rarest sequences. `shift` is a hoop with g = R = m1 = Izz = 1 and a particle of mass 3 at any
//! distance from the centre, `rim` a thin hoop with a particle of any mass on its rim. The angular
//! velocity goes up to the one at which the hoop leaves the plane at once.

mod atlas;
mod first_turn;

use std::collections::BTreeSet;

use littlewood::tables::{Quantity, Setup};
use littlewood::{HoopParameters, Start};
use littlewood_sweep::{Axis, Grid, SweepError};

use crate::atlas::{Atlas, Entry};

/// A way to make a hoop of each eccentricity γ, the distance of the mass centre from the centre in
/// radii.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    Shift,
    Rim,
}

impl Family {
    const fn most(self) -> f64 {
        match self {
            Self::Shift => 0.75,
            Self::Rim => 0.999,
        }
    }

    fn hoop(self, gamma: f64) -> HoopParameters {
        let (mass_ratio, offset) = match self {
            Self::Shift => (1.0 / 3.0, (gamma / 0.75).min(1.0)),
            Self::Rim => (1.0 / gamma - 1.0, 1.0),
        };
        HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_friction(1.0, 0.0)
    }
}

/// A box of γ, μ and θ′√γ, the last from 0 (at rest) to 1 (off the plane at once), in so many steps
/// each.
#[derive(Clone, Copy)]
struct Box3 {
    low: [f64; 3],
    high: [f64; 3],
    count: usize,
}

impl Box3 {
    fn atlas(&self, family: Family) -> Result<Atlas, SweepError> {
        let Self { low, high, count } = *self;
        let mut atlas = Atlas::default();
        let gammas = Axis::new(Quantity::Offset, low[0], high[0], count)?;
        for gamma in gammas.values() {
            let root = libm::sqrt(gamma);
            let axes = vec![
                Axis::new(Quantity::MuS, low[1], high[1], count)?,
                Axis::new(Quantity::ThetaRate, low[2] / root, high[2] / root, count)?,
            ];
            let grid = Grid::new(Setup::new(family.hoop(gamma), Start::at(0.0, 0.0)), axes)?;
            atlas.absorb(Atlas::of_first_turns(&grid)?);
        }
        Ok(atlas)
    }

    /// One and a half steps to either side of a point, in steps three tenths as long.
    fn around(&self, family: Family, point: &Setup) -> Self {
        let h = point.hoop.offset / (1.0 + point.hoop.mass_ratio);
        let centre = [h, point.hoop.mu_s, point.start.theta_rate * libm::sqrt(h)];
        let least = [0.001, 0.0005, 0.0005];
        let most = [family.most(), 3.0, 0.9999];
        let step = |k: usize| 1.5 * (self.high[k] - self.low[k]) / (self.count - 1) as f64;
        Self {
            low: core::array::from_fn(|k| (centre[k] - step(k)).max(least[k])),
            high: core::array::from_fn(|k| (centre[k] + step(k)).min(most[k])),
            count: 11,
        }
    }
}

/// How many kinds there are if some are not told apart.
fn kinds(entries: &[Entry], directions: bool, lift_off: bool, stops: bool) -> usize {
    let kind = |entry: &Entry| {
        let mut text = entry.kind.sequence.to_string();
        if !directions {
            text = text.replace(['+', '-'], "S");
        }
        if !lift_off && text.len() > 1 {
            text = text.trim_end_matches('F').to_owned();
        }
        let stop = if stops { entry.kind.stop.name() } else { "" };
        format!("{text} {stop}")
    };
    entries.iter().map(kind).collect::<BTreeSet<_>>().len()
}

fn say(what: &str, atlas: &Atlas) {
    let mut numbers = Vec::new();
    for stops in [false, true] {
        for lift_off in [true, false] {
            for directions in [true, false] {
                numbers.push(kinds(&atlas.entries, directions, lift_off, stops).to_string());
            }
        }
    }
    println!("{what}: {} starts; {}", atlas.points, numbers.join(" "));
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count: usize = std::env::args()
        .nth(1)
        .map_or(Ok(40), |count| count.parse())?;
    let family = match std::env::args().nth(2).as_deref() {
        Some("rim") => Family::Rim,
        _ => Family::Shift,
    };
    let levels: u32 = std::env::args()
        .nth(3)
        .map_or(Ok(0), |levels| levels.parse())?;
    let least_mu: f64 = std::env::args().nth(4).map_or(Ok(0.005), |mu| mu.parse())?;
    let all = Box3 {
        low: [0.01, least_mu, 0.01],
        high: [family.most(), 2.0, 0.999],
        count,
    };
    println!(
        "kinds: all  no directions  no lift-off  neither; then the same four with stops told apart"
    );
    let mut atlas = all.atlas(family)?;
    say("grid", &atlas);
    let mut boxes: Vec<(Box3, Vec<Entry>)> = vec![(all, atlas.entries.clone())];
    for level in 1..=levels {
        let mut next = Vec::new();
        for (outer, entries) in &boxes {
            for entry in entries.iter().filter(|entry| entry.count <= 40) {
                let inner = outer.around(family, &entry.example);
                let found = inner.atlas(family)?;
                let is_new = |entry: &&Entry| !atlas.has(entry.kind);
                let new: Vec<Entry> = found.entries.iter().filter(is_new).copied().collect();
                atlas.absorb(found);
                if !new.is_empty() {
                    next.push((inner, new));
                }
            }
        }
        say(&format!("refinement {level}"), &atlas);
        boxes = next;
    }
    for entry in &atlas.entries {
        let Setup { hoop, start } = entry.example;
        println!(
            "{:>9}  {:<22} {:<10}  gamma {:.5}  mu {:.5}  rate {:.5}",
            entry.count,
            entry.kind.sequence,
            entry.kind.stop.name(),
            hoop.offset / (1.0 + hoop.mass_ratio),
            hoop.mu_s,
            start.theta_rate,
        );
    }
    Ok(())
}
