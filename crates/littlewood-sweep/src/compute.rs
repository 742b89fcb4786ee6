//! Points in, columns out: on all cores, and the same whatever their number.

use core::num::NonZeroUsize;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use littlewood::{Engine, Hoop, HoopParameters, Limits, ParameterError, Start};
use rayon::prelude::*;

use crate::columns::{Columns, Row};
use crate::error::SweepError;
use crate::grid::is_relation;
use crate::point::Point;

/// Points that one task computes: long enough to pay for the task, short enough to share a chunk among many cores.
const TASK: usize = 512;

/// Hoops whose engines are kept for the next call.
const KEPT: usize = 8;

/// The threads of a sweep, and the engines that they have prepared last.
#[derive(Debug)]
pub struct Workers {
    pool: rayon::ThreadPool,
    engines: Mutex<Vec<Prepared>>,
}

/// The engine of a hoop; none for parameters that are no hoop because of a relation between them.
#[derive(Clone, Debug)]
struct Prepared {
    bits: [u64; 5],
    engine: Option<Arc<Engine>>,
}

impl Prepared {
    fn new(point: &Point, starts: usize) -> Result<Self, ParameterError> {
        let prepare = if starts >= Engine::REPAYS { Engine::new } else { Engine::unprepared };
        let engine = match Hoop::new(point.hoop) {
            Ok(hoop) => Some(Arc::new(prepare(&hoop))),
            Err(error) if is_relation(&error) => None,
            Err(error) => return Err(error),
        };
        Ok(Self { bits: point.hoop_bits(), engine })
    }
}

/// The rows of a hoop, task by task, each with the place of its point; and its engine, if it is kept.
type Group = (Option<Prepared>, Vec<Vec<(u32, Row)>>);

/// A point that was refused, by its place among the points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Refused {
    pub(crate) index: usize,
    pub(crate) error: ParameterError,
}

impl Workers {
    /// Starts this many threads; all cores if none is given.
    ///
    /// # Errors
    /// If the operating system has no threads to give.
    pub fn new(threads: Option<NonZeroUsize>) -> Result<Self, SweepError> {
        let threads = threads.map_or(0, NonZeroUsize::get);
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| SweepError::Threads { threads, reason: error.to_string() })?;
        Ok(Self { pool, engines: Mutex::new(Vec::new()) })
    }

    /// Number of threads.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Runs something on these threads.
    pub(crate) fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// Computes points, one row a point in their order. The result does not depend on the number of threads.
    ///
    /// Points that share their hoop share its engine, wherever they stand; a hoop with few points is simulated without
    /// tables, with the same outcomes and times that agree to rounding. Where the parameters of a hoop contradict
    /// each other (μk > μs, or a point mass at the centre) the row has the outcome [`crate::outcome::INVALID`].
    ///
    /// ```
    /// use littlewood::{HoopParameters, Limits, Start};
    /// use littlewood_sweep::{Point, Real, Workers};
    ///
    /// let hoop = HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s: 0.5, mu_k: 0.4 };
    /// let starts = (1..=3).map(|i| Point { hoop, start: Start::at(0.0, f64::from(i)) });
    /// let columns = Workers::new(None)?.compute(starts, Limits::default())?;
    /// assert_eq!(columns.real(Real::LiftOffTime)[1], 0.0); // at θ' = 2 > √2 it leaves the plane at once
    /// # Ok::<(), littlewood_sweep::SweepError>(())
    /// ```
    ///
    /// # Errors
    /// The first value, in the order of the points, that has no physical meaning by itself.
    pub fn compute(
        &self,
        points: impl IntoIterator<Item = Point>,
        limits: Limits,
    ) -> Result<Columns, SweepError> {
        let points: Vec<Point> = points.into_iter().collect();
        self.compute_points(&points, limits).map_err(|refused| refused.error.into())
    }

    /// Computes starts of one hoop, as [`Workers::compute`] does.
    ///
    /// # Errors
    /// As [`Workers::compute`].
    pub fn compute_starts(
        &self,
        hoop: HoopParameters,
        starts: &[Start],
        limits: Limits,
    ) -> Result<Columns, SweepError> {
        self.compute(starts.iter().map(|&start| Point { hoop, start }), limits)
    }

    pub(crate) fn compute_points(&self, points: &[Point], limits: Limits) -> Result<Columns, Refused> {
        let groups = group_by_hoop(points);
        let known = std::mem::take(&mut *self.engines.lock().unwrap_or_else(PoisonError::into_inner));
        let keep = groups.len() <= KEPT;
        let results: Vec<Group> = self
            .install(|| {
                groups
                    .par_iter()
                    .map(|indices| {
                        let first = &points[indices[0] as usize];
                        let bits = first.hoop_bits();
                        // What was prepared earlier must not change the digits of a hoop with few points.
                        let repays = indices.len() >= Engine::REPAYS;
                        let prepared = match known.iter().find(|prepared| repays && prepared.bits == bits) {
                            Some(prepared) => prepared.clone(),
                            None => Prepared::new(first, indices.len())
                                .map_err(|error| Refused { index: indices[0] as usize, error })?,
                        };
                        let rows = indices
                            .par_chunks(TASK)
                            .map(|task| compute_task(points, task, prepared.engine.as_deref(), limits))
                            .collect::<Vec<_>>();
                        // Errors are sifted here, in order: `collect` into a Result would return any of them.
                        let rows = rows.into_iter().collect::<Result<Vec<_>, _>>()?;
                        Ok(((keep && repays).then_some(prepared), rows))
                    })
                    .collect::<Vec<Result<_, Refused>>>()
            })
            .into_iter()
            .fold(Ok(Vec::new()), first_refused)?;

        let mut columns = Columns::blank(points.len());
        let mut engines = Vec::new();
        for (prepared, tasks) in results {
            engines.extend(prepared);
            for (index, row) in tasks.into_iter().flatten() {
                columns.set(index as usize, &row);
            }
        }
        *self.engines.lock().unwrap_or_else(PoisonError::into_inner) = engines;
        Ok(columns)
    }
}

/// Gathers results; of several errors the one of the first point is kept.
fn first_refused<T>(so_far: Result<Vec<T>, Refused>, next: Result<T, Refused>) -> Result<Vec<T>, Refused> {
    match (so_far, next) {
        (Ok(mut all), Ok(one)) => {
            all.push(one);
            Ok(all)
        }
        (Err(a), Err(b)) => Err(if b.index < a.index { b } else { a }),
        (Err(error), Ok(_)) | (Ok(_), Err(error)) => Err(error),
    }
}

fn compute_task(
    points: &[Point],
    indices: &[u32],
    engine: Option<&Engine>,
    limits: Limits,
) -> Result<Vec<(u32, Row)>, Refused> {
    let row = |index: u32| {
        let Some(engine) = engine else { return Ok((index, Row::INVALID)) };
        match engine.summary(points[index as usize].start, limits) {
            Ok(summary) => Ok((index, Row::from(&summary))),
            Err(error) => Err(Refused { index: index as usize, error }),
        }
    };
    indices.iter().map(|&index| row(index)).collect()
}

/// The places of the points of each hoop, hoops in the order in which they first occur.
///
/// # Panics
/// For more than 2³² points.
fn group_by_hoop(points: &[Point]) -> Vec<Vec<u32>> {
    assert!(u32::try_from(points.len()).is_ok(), "at most 2^32 points at once; compute them in chunks");
    let mut groups: Vec<Vec<u32>> = Vec::new();
    let mut place: HashMap<[u64; 5], usize> = HashMap::new();
    let mut last: Option<([u64; 5], usize)> = None;
    for (index, point) in (0_u32..).zip(points) {
        let bits = point.hoop_bits();
        let group = match last {
            Some((same, group)) if same == bits => group,
            _ => *place.entry(bits).or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            }),
        };
        last = Some((bits, group));
        groups[group].push(index);
    }
    groups
}
