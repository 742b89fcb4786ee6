//! The map of a grid with two axes.

use core::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};

use littlewood::Limits;
use littlewood::si::Units;
use littlewood::tables::{Class, PhaseSequence, Quantity, SummaryColumn, SummaryValue};

use super::cells::{Cell, cell, class_of, of_class, place};
use super::error::PictureError;
use super::shade::Shade;
use crate::axis::{Axis, Varies};
use crate::chunk::Chunk;
use crate::columns::Columns;
use crate::compute::Workers;
use crate::error::SweepError;
use crate::grid::Grid;
use crate::options::Options;
use crate::regions::{Lattice, MIXED, Regions};
use crate::sweep::sweep_grid;
use crate::tally::Tally;
#[cfg(feature = "zarr")]
use crate::zarr::ZarrStore;

/// Size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureSize {
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

impl Default for PictureSize {
    fn default() -> Self {
        Self {
            width: 1500,
            height: 1000,
        }
    }
}

/// Smallest and largest side of a picture.
const SIDES: [u32; 2] = [300, 10_000];

/// Above all sequences that fit, and below the classes.
pub(super) const OTHERS: u64 = u64::MAX - 0x1ff;

/// A map of a grid with two axes: the first runs to the right, the second upwards.
///
/// It holds a value for each pixel, not for each point: a grid that is finer than the picture is
/// thinned, and its size does not matter. The shares in the legend are those of all points.
#[derive(Clone, Debug)]
pub struct Picture {
    pub(super) grid: Grid,
    pub(super) limits: Limits,
    pub(super) shade: Shade,
    pub(super) size: PictureSize,
    /// Units of what is printed; none where it is dimensionless.
    pub(super) units: Option<Units>,
    pub(super) has_curves: bool,
    pub(super) is_in_vectors: bool,
    /// Cells to the right and upwards.
    pub(super) counts: [usize; 2],
    pub(super) cells: Vec<Cell>,
    /// The regions of one colour, once their boundaries have been followed.
    pub(super) regions: Regions,
    /// Whether motions took too long to locate their boundaries closely.
    pub(super) is_cut: bool,
    tally: Tally,
    /// Points of each sequence, for a map of sequences.
    pub(super) sequences: HashMap<u64, u64>,
    /// The sequences, each with its mirror image behind it, in the order of their numbers of
    /// points, then of their codes.
    pub(super) ranking: Vec<u64>,
    ranks: HashMap<u64, (usize, bool)>,
}

impl Picture {
    /// An empty picture of a grid.
    ///
    /// # Errors
    /// If the grid has not two axes, the column is not one of numbers, the grid does not compute
    /// the derivative, or the picture is too small or too large.
    pub fn new(
        grid: &Grid,
        limits: Limits,
        shade: Shade,
        size: PictureSize,
    ) -> Result<Self, PictureError> {
        let [x, y] = grid.axes() else {
            return Err(PictureError::NotTwoAxes {
                found: grid.axes().len(),
            });
        };
        let [least, most] = SIDES;
        if [size.width, size.height]
            .iter()
            .any(|side| !(least..=most).contains(side))
        {
            return Err(PictureError::Size {
                width: size.width,
                height: size.height,
                least,
                most,
            });
        }
        if let Shade::Column(column) = shade
            && !SummaryColumn::numbers().any(|other| other == column)
        {
            return Err(PictureError::NoNumber { column });
        }
        if let Shade::Derivative(column) = shade
            && !grid.derivatives().contains(&column)
        {
            return Err(PictureError::NotComputed { column });
        }
        let counts = [
            x.count().min(size.width as usize),
            y.count().min(size.height as usize),
        ];
        Ok(Self {
            grid: grid.clone(),
            limits,
            shade,
            size,
            units: None,
            has_curves: false,
            is_in_vectors: false,
            counts,
            cells: vec![Cell::NOT_COMPUTED; counts[0] * counts[1]],
            regions: Regions {
                regions: Vec::new(),
                boundaries: Vec::new(),
            },
            is_cut: false,
            tally: Tally::default(),
            sequences: HashMap::new(),
            ranking: Vec::new(),
            ranks: HashMap::new(),
        })
    }

    /// Computes a grid and draws it, boundaries as curves; nothing is kept but the picture. A
    /// cancelled picture is white where it is not computed.
    ///
    /// # Errors
    /// As [`Picture::new`] and [`Workers::compute`].
    pub fn of_grid(
        grid: &Grid,
        limits: Limits,
        shade: Shade,
        size: PictureSize,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, SweepError> {
        let mut picture = Self::new(grid, limits, shade, size)?;
        let mut add = |chunk: &Chunk, columns: &Columns| picture.add(chunk, columns);
        sweep_grid(grid, limits, &[], Some(&mut add), workers, options)?;
        picture.follow(workers, options)?;
        Ok(picture)
    }

    /// Draws a store as it is, without the motions between its points.
    ///
    /// # Errors
    /// As [`Picture::new`]; a chunk that cannot be read.
    #[cfg(feature = "zarr")]
    pub fn of_store(
        store: &ZarrStore,
        shade: Shade,
        size: PictureSize,
    ) -> Result<Self, SweepError> {
        let mut picture = Self::new(store.grid(), store.limits(), shade, size)?;
        for number in 0..store.chunks().count() {
            if let Some(columns) = store.columns(number)? {
                picture.add(&store.chunks().chunk(number), &columns);
            }
        }
        Ok(picture)
    }

    /// With numbers in SI units.
    #[must_use]
    pub const fn with_units(mut self, units: Option<Units>) -> Self {
        self.units = units;
        self
    }

    /// With the curves f and n of rolling (2.13, 2.14) and that of lift-off (2.18).
    ///
    /// # Errors
    /// Unless the map is one of θ and θ′ of a single hoop without slip, whose curves they are.
    pub fn with_curves(mut self) -> Result<Self, PictureError> {
        self.check_curves()?;
        self.has_curves = true;
        Ok(self)
    }

    /// For a drawing in vectors, in which boundaries are located as closely as they can be.
    #[must_use]
    pub const fn in_vectors(mut self) -> Self {
        self.is_in_vectors = true;
        self
    }

    /// Adds the results of a chunk of the grid.
    pub fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        let axes = [self.grid.axes()[0].count(), self.grid.axes()[1].count()];
        let sequences = columns.column(SummaryColumn::Sequence);
        for ((i, indices), &class) in chunk.indices().enumerate().zip(columns.classes()) {
            self.tally.add(class, 1);
            let mut key = of_class(class);
            if self.shade == Shade::Sequence
                && let SummaryValue::U64(bits) = sequences.get(i)
            {
                key = self.key_at(PhaseSequence::from_bits(bits), class);
                *self.sequences.entry(key).or_default() += 1;
            }
            let [Some(x), Some(y)] = [0, 1].map(|k| cell(indices[k], axes[k], self.counts[k]))
            else {
                continue;
            };
            let point = || self.grid.point_at(&indices);
            let number = self.shade.number(point, columns, i);
            self.cells[y * self.counts[0] + x] = Cell { key, number };
        }
        if self.shade == Shade::Sequence {
            self.rank_sequences();
        }
    }

    fn rank_sequences(&mut self) {
        let mut pairs: BTreeMap<u64, Vec<(Reverse<u64>, u64)>> = BTreeMap::new();
        for (&key, &count) in self
            .sequences
            .iter()
            .filter(|(key, _)| class_of(**key).is_none())
        {
            let mirrored = PhaseSequence::from_bits(key).mirrored().bits();
            pairs
                .entry(key.min(mirrored))
                .or_default()
                .push((Reverse(count), key));
        }
        let mut pairs: Vec<_> = pairs.into_values().collect();
        pairs.iter_mut().for_each(|pair| pair.sort_unstable());
        pairs.sort_by_key(|pair| {
            (
                Reverse(pair.iter().map(|(count, _)| count.0).sum::<u64>()),
                pair[0].1,
            )
        });
        self.ranking = pairs.iter().flatten().map(|(_, key)| *key).collect();
        let ranks = pairs.iter().enumerate().flat_map(|(rank, pair)| {
            pair.iter()
                .enumerate()
                .map(move |(i, (_, key))| (*key, (rank, i > 0)))
        });
        self.ranks = ranks.collect();
    }

    /// The key by which a point gets its colour.
    pub(super) fn key_at(&self, sequence: PhaseSequence, class: Class) -> u64 {
        match self.shade {
            Shade::Sequence => key_of_sequence(sequence.bits(), class),
            Shade::Class | Shade::EnergyLost | Shade::Column(_) | Shade::Derivative(_) => {
                of_class(class)
            }
        }
    }

    /// The rank of a sequence and its mirror image, and whether it is the less frequent one.
    pub(super) fn rank(&self, key: u64) -> (usize, bool) {
        self.ranks.get(&key).copied().unwrap_or((usize::MAX, false))
    }

    /// What cells of one colour have in common.
    pub(super) fn key_of(&self, key: u64) -> u64 {
        let is_other = self.shade == Shade::Sequence
            && class_of(key).is_none()
            && self.rank(key).0 >= littlewood_style::RANKS;
        if is_other { OTHERS } else { key }
    }

    /// The points that have a cell, with what their colours have in common, or what is mixed.
    pub(super) fn lattice(&self) -> Lattice {
        let places = [0, 1].map(|k| {
            let count = self.grid.axes()[k].count();
            let places = (0..self.counts[k]).map(|j| place(j, count, self.counts[k]));
            places
                .map(|i| i as f64 / (count - 1).max(1) as f64)
                .collect()
        });
        let keys = self
            .cells
            .iter()
            .map(|cell| self.key_of(cell.key))
            .collect();
        let mut lattice = Lattice { places, keys };
        lattice.mix();
        lattice
    }

    /// The part of the map in which colours change more finely than is drawn.
    pub(super) fn mixed(&self) -> f64 {
        let mut regions = self.regions.regions.iter();
        let of_region = regions.find(|region| region.key == MIXED);
        if !self.regions.regions.is_empty() {
            return of_region.map_or(0.0, |region| region.area);
        }
        let keys = self.lattice().keys;
        let mixed = keys.iter().filter(|key| **key == MIXED).count();
        mixed as f64 / keys.len() as f64
    }

    /// Number of points of a class.
    pub fn count(&self, class: Class) -> u64 {
        let missing = if class == Class::NotComputed {
            self.grid.len() - self.tally.total()
        } else {
            0
        };
        self.tally.of(class) + missing
    }

    /// Whether motions go on after a landing, some of them at least.
    pub(super) fn goes_on(&self) -> bool {
        let varies = |axis: &Axis| axis.varies() == Varies::One(Quantity::Restitution);
        self.grid.base().hoop.restitution.is_some() || self.grid.axes().iter().any(varies)
    }

    /// Whether every point of the grid has been added.
    pub fn is_complete(&self) -> bool {
        self.count(Class::NotComputed) == 0
    }
}

fn key_of_sequence(bits: u64, class: Class) -> u64 {
    match class {
        Class::Invalid | Class::NotComputed => of_class(class),
        _ => bits,
    }
}
