//! The bands of a line: intervals whose motions go alike.

use littlewood::tables::PhaseSequence;
use littlewood::{Limits, ParameterError, Summary};

use super::Place;
use super::cell::{Span, crossed};
use crate::compute::Workers;
use crate::grid::Grid;

/// An interval of a line in which all motions are of one kind and begin with the same phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The kind.
    pub kind: u16,
    /// The first phases.
    pub phases: PhaseSequence,
    /// Whether more phases follow.
    pub has_more: bool,
    /// From where to where, in fractions of the line.
    pub range: [f64; 2],
}

/// Phases by which motions are told apart, and the bits of them in a sequence.
const PHASES: u32 = 8;
const BITS: u32 = PHASES * PhaseSequence::BITS;

impl Band {
    /// Phases that a band knows of.
    pub const PHASES: usize = PHASES as usize;

    /// The bands of a grid with one axis, from its first value to its last, by the first phases and
    /// by kinds of the summaries of its motions, each of which is followed to the limits. Where
    /// neighbours on the grid differ, the boundary between them is found by bisection, to this part
    /// of the line; a band between two of them can be missed. `told` is told of the motions that
    /// have been followed. The result does not depend on the number of threads.
    ///
    /// ```
    /// use littlewood::tables::{Class, Quantity, Setup};
    /// use littlewood::{HoopParameters, Limits, Start, Summary};
    /// use littlewood_sweep::{Axis, Band, Grid, Workers};
    ///
    /// let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    /// let rate = Axis::new(Quantity::ThetaRate, 0.1, 2.0, 40)?;
    /// let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.1)), vec![rate])?;
    /// let class = |summary: &Summary| Class::of(summary).code().into();
    /// let bands = Band::along(&grid, &class, Limits::default(), 1e-12, &Workers::new(None)?, &mut |_| {})?;
    /// let last = bands.last().expect("a band");
    /// assert_eq!(last.kind, u16::from(Class::LeavesAtOnce.code()));
    /// // h cos θ θ′² = 1 with h = 1/2, on the way from 0.1 to 2.
    /// assert!((last.range[0] - (2.0_f64.sqrt() - 0.1) / 1.9).abs() < 1e-11);
    /// # Ok::<(), littlewood_sweep::SweepError>(())
    /// ```
    ///
    /// # Errors
    /// The first value that has no physical meaning by itself.
    ///
    /// # Panics
    /// If the grid has not one axis of two points or more.
    pub fn along(
        grid: &Grid,
        kind: &dyn Fn(&Summary) -> u16,
        limits: Limits,
        width: f64,
        workers: &Workers,
        told: &mut dyn FnMut(u64),
    ) -> Result<Vec<Self>, ParameterError> {
        assert!(
            grid.axes().len() == 1,
            "a line has one axis, not {}",
            grid.axes().len()
        );
        let last = grid.axes()[0].count() - 1;
        assert!(last > 0, "a line has two points or more");
        let key = |summary: &Summary| key_of(kind(summary), summary.sequence);
        let mut ask = workers.keys_of_places(grid, limits, key, told);
        let places: Vec<Place> = (0..=last).map(|i| [i as f64 / last as f64, 0.0]).collect();
        let keys = ask(&places)?.unwrap_or_default();
        let spans: Vec<Span> = places
            .windows(2)
            .zip(keys.windows(2))
            .map(|(places, keys)| Span {
                ends: [places[0], places[1]],
                keys: [keys[0], keys[1]],
            })
            .collect();
        let sides = crossed(&spans, &mut Vec::new(), width, &mut ask)?;
        let mut bands = vec![band_of(keys[0])];
        for crossing in sides.into_iter().flat_map(|side| side.crossings) {
            if let Some(band) = bands.last_mut() {
                band.range[1] = crossing.at;
            }
            bands.push(Self {
                range: [crossing.at, 1.0],
                ..band_of(crossing.keys[1])
            });
        }
        Ok(bands)
    }
}

/// The phases lowest, then whether more follow, then the kind.
fn key_of(kind: u16, sequence: PhaseSequence) -> u64 {
    let shown = sequence.bits() & ((1 << BITS) - 1);
    let has_more = sequence.is_truncated() || sequence.len() > PHASES;
    shown | u64::from(has_more) << BITS | u64::from(kind) << (BITS + 1)
}

fn band_of(key: u64) -> Band {
    Band {
        kind: (key >> (BITS + 1)) as u16,
        phases: PhaseSequence::from_bits(key & ((1 << BITS) - 1)),
        has_more: key >> BITS & 1 == 1,
        range: [0.0, 1.0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_comes_back_from_its_key() {
        let long = PhaseSequence::from_bits(0x1_2131_2131);
        for kind in [0, 12, 0x1234, u16::MAX] {
            let band = band_of(key_of(kind, long));
            assert_eq!((band.kind, band.has_more), (kind, true));
            assert_eq!(band.phases.to_string(), long.to_string()[..8]);
            let short = PhaseSequence::from_bits(0x7312);
            let band = band_of(key_of(kind, short));
            assert_eq!((band.phases, band.has_more), (short, false));
        }
    }
}
