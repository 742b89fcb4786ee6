//! Which sequences of phases occur on a grid, how often, and where for example.

use std::collections::HashMap;

use littlewood::tables::{PhaseSequence, Setup};
use littlewood::{Hoop, Limits, OutcomeKind, ParameterError};
use rayon::prelude::*;

use crate::chunk::{Chunk, Chunks};
use crate::compute::{Halt, Workers};
use crate::first_turn::{FirstTurn, Stop};
use crate::grid::Grid;
use crate::options::Options;
use crate::watch::{Ledger, Watch};

/// A sequence of phases that occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtlasEntry {
    /// The sequence. Those with more phases than fit are told apart by the phases that fit.
    pub sequence: PhaseSequence,
    /// What stopped the first turn; none in an atlas of whole motions.
    pub stop: Option<Stop>,
    /// Number of points of the grid that have it.
    pub count: u64,
    /// The first of them.
    pub example: Setup,
    /// The number of that point ([`Grid::point`]); in an atlas of several grids the points of later
    /// grids are numbered after those of earlier ones.
    pub number: u64,
}

/// The sequence of a point, and what stops it; none for a point whose parameters contradict each
/// other.
type Found = Option<(PhaseSequence, Option<Stop>)>;

/// All sequences of phases of one or more grids, the most frequent first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Atlas {
    /// The sequences.
    pub entries: Vec<AtlasEntry>,
    /// Points that were computed; fewer than the grid has if the atlas was cancelled.
    pub points: u64,
    /// Points whose parameters contradict each other; they have no sequence.
    pub invalid: u64,
    /// Points of the grids.
    pub total: u64,
}

impl Atlas {
    /// Whole motions, to their end or to a limit.
    ///
    /// # Errors
    /// As [`Workers::compute`].
    pub fn of_motions(
        grid: &Grid,
        limits: Limits,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, ParameterError> {
        Self::collect(grid, options, |chunk, watch| {
            let points: Vec<Setup> = chunk.points(grid).collect();
            let columns = match workers.compute_points(
                (&points, &[]),
                Some(grid.starts_of_a_hoop()),
                limits,
                watch,
            ) {
                Ok(columns) => columns,
                Err(Halt::Refused(refused)) => return Err(refused.error),
                Err(Halt::Cancelled) => return Ok(None),
            };
            let sequences = columns.summaries().map(|summary| {
                (summary.outcome != OutcomeKind::Invalid).then_some((summary.sequence, None))
            });
            Ok(Some(sequences.collect()))
        })
    }

    /// First turns with μs = μk, as in Theron and Maritz: μk is that of μs, whatever the grid says.
    ///
    /// # Errors
    /// A value without physical meaning.
    pub fn of_first_turns(
        grid: &Grid,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, ParameterError> {
        Self::collect(grid, options, |chunk, watch| {
            let points: Vec<Setup> = chunk.points(grid).map(with_one_friction).collect();
            let turns: Vec<Result<_, ParameterError>> = workers.install(|| {
                points
                    .par_iter()
                    .map(|point| {
                        let mut watch = watch.clone();
                        if watch.is_cancelled() {
                            return Ok(None);
                        }
                        watch.count();
                        match Hoop::new(point.hoop) {
                            Ok(hoop) => FirstTurn::new(&hoop, point.start)
                                .map(|turn| Some((turn.sequence, Some(turn.stop)))),
                            Err(error) if error.is_contradiction() => Ok(None),
                            Err(error) => Err(error),
                        }
                    })
                    .collect()
            });
            if watch.is_cancelled() {
                return Ok(None);
            }
            // In order: a parallel `collect` into a Result would return any of several errors.
            turns.into_iter().collect::<Result<_, _>>().map(Some)
        })
        .map(|mut atlas| {
            for entry in &mut atlas.entries {
                entry.example = with_one_friction(entry.example);
            }
            atlas
        })
    }

    fn collect(
        grid: &Grid,
        options: &Options<'_>,
        mut sequences: impl FnMut(&Chunk, &Watch<'_>) -> Result<Option<Vec<Found>>, ParameterError>,
    ) -> Result<Self, ParameterError> {
        let chunks = Chunks::new(grid, options.chunk_points);
        let shape = grid.shape();
        let mut found: HashMap<(PhaseSequence, Option<Stop>), (u64, u64)> = HashMap::new();
        let (mut points, mut invalid) = (0, 0);
        let ledger = Ledger::new(options, 0, grid.len());
        for chunk in (0..chunks.count()).map(|number| chunks.chunk(number)) {
            let Some(sequences) = sequences(&chunk, &ledger.watch())? else {
                break;
            };
            for (indices, sequence) in chunk.indices().zip(sequences) {
                points += 1;
                let Some(key) = sequence else {
                    invalid += 1;
                    continue;
                };
                let number = indices
                    .iter()
                    .zip(&shape)
                    .fold(0, |number, (&i, &count)| number * count as u64 + i as u64);
                let (count, first) = found.entry(key).or_insert((0, number));
                *count += 1;
                *first = number.min(*first);
            }
            ledger.finish(chunk.len() as u64);
        }
        let entries = found
            .into_iter()
            .map(|((sequence, stop), (count, number))| AtlasEntry {
                sequence,
                stop,
                count,
                example: grid.point(number),
                number,
            })
            .collect();
        let mut atlas = Self {
            entries,
            points,
            invalid,
            total: grid.len(),
        };
        atlas.sort();
        Ok(atlas)
    }

    /// Adds the atlas of another grid, whose points are numbered after those that are there.
    ///
    /// ```
    /// use littlewood::tables::{Quantity, Setup};
    /// use littlewood::{HoopParameters, Limits, Start};
    /// use littlewood_sweep::{Atlas, Axis, Grid, Options, Workers};
    ///
    /// let mut atlas = Atlas::default();
    /// for mu_s in [0.5, 1.0] {
    ///     let hoop = HoopParameters::thin(1.0).with_friction(mu_s, 0.4);
    ///     let rate = Axis::new(Quantity::ThetaRate, 0.1, 1.4, 20)?;
    ///     let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), vec![rate])?;
    ///     let workers = Workers::new(None)?;
    ///     atlas.absorb(Atlas::of_motions(&grid, Limits::until(20.0), &workers, &Options::default())?);
    /// }
    /// assert_eq!((atlas.points, atlas.entries.iter().map(|entry| entry.count).sum::<u64>()), (40, 40));
    /// # Ok::<(), littlewood_sweep::SweepError>(())
    /// ```
    pub fn absorb(&mut self, other: Self) {
        let before = self.total;
        for entry in other.entries {
            match self
                .entries
                .iter_mut()
                .find(|known| (known.sequence, known.stop) == (entry.sequence, entry.stop))
            {
                Some(known) => known.count += entry.count,
                None => self.entries.push(AtlasEntry {
                    number: before + entry.number,
                    ..entry
                }),
            }
        }
        self.points += other.points;
        self.invalid += other.invalid;
        self.total += other.total;
        self.sort();
    }

    fn sort(&mut self) {
        self.entries
            .sort_by_key(|entry| (core::cmp::Reverse(entry.count), entry.number, entry.stop));
    }
}

fn with_one_friction(mut point: Setup) -> Setup {
    point.hoop.mu_k = point.hoop.mu_s;
    point
}
