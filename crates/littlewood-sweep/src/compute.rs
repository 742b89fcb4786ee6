//! Computes points on all cores; the results do not depend on how many there are.

use core::num::NonZeroUsize;
use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use littlewood::tables::{DerivativeColumn, Setup};
use littlewood::{Engine, Hoop, Limits, ParameterError, Summary};
use rayon::prelude::*;
use thiserror::Error;

use crate::columns::Columns;
use crate::grid::Grid;
use crate::options::Options;
use crate::regions::Place;
use crate::setup::{HoopBits, hoop_bits};
use crate::watch::{Ledger, Watch};

/// Points that one task computes: enough to outweigh its overhead, few enough to share a chunk
/// among many cores.
const TASK: usize = 512;
/// Points of a task at least, and tasks for each thread where there are few points.
const FEWEST: usize = 16;
const TASKS: usize = 4;

/// Hoops whose engines are kept for the next call.
const KEPT: usize = 8;

/// Threads that can be asked for: more than any machine has cores, and few enough that all of them
/// start in a moment.
pub const MOST_THREADS: usize = 1024;

/// Threads could not be started.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum ThreadsError {
    #[error("{threads} threads: at most {MOST_THREADS} can be asked for")]
    TooMany { threads: usize },
    /// The operating system has not as many; 0 stands for as many as there are cores.
    #[error("cannot start {threads} threads: {reason}")]
    NotStarted { threads: usize, reason: String },
}

/// The threads of a sweep, and the engines that they have prepared last.
#[derive(Debug)]
pub struct Workers {
    pool: rayon::ThreadPool,
    engines: Mutex<Vec<Prepared>>,
}

/// The engine of a hoop; none for parameters that contradict each other.
#[derive(Clone, Debug)]
struct Prepared {
    bits: HoopBits,
    engine: Option<Arc<Engine>>,
}

/// The places of the points of a hoop.
type Group = Vec<u32>;

/// The results of a task: points at some places.
struct Task<'a> {
    places: Cow<'a, [u32]>,
    columns: Columns,
}

/// The tasks of some hoops, and the engines that are kept.
type Done<'a> = (Vec<Prepared>, Vec<Task<'a>>);

/// Points that are made where they are followed.
#[derive(Clone, Copy)]
#[expect(missing_debug_implementations, reason = "a function makes them")]
pub struct Points<'a> {
    /// How many there are.
    pub count: usize,
    /// The point at a place below [`Points::count`].
    pub at: &'a (dyn Fn(usize) -> Setup + Sync),
    /// Whether all of them are known to have the same hoop.
    pub share_hoop: bool,
    /// The derivatives that are asked for: each point is then simulated, too.
    pub derivatives: &'a [DerivativeColumn],
}

/// What all tasks have in common.
struct Job<'a> {
    points: Points<'a>,
    starts_of_a_hoop: Option<u64>,
    limits: Limits,
    watch: &'a Watch<'a>,
    /// Engines that were prepared earlier.
    known: Vec<Prepared>,
    /// Whether engines for many starts are kept.
    keep: bool,
    /// Tasks among which the points of a hoop are shared.
    share: usize,
}

/// A point that was refused, by its place among the points.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// Its place.
    pub index: usize,
    /// Why.
    pub error: ParameterError,
}

/// Why points were not computed.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// One of them was refused.
    Refused(Refused),
    /// The run was cancelled.
    Cancelled,
}

impl Workers {
    /// Starts this many threads; as many as there are cores if no number is given.
    ///
    /// # Errors
    /// More than [`MOST_THREADS`], or more than the operating system can start.
    pub fn new(threads: Option<NonZeroUsize>) -> Result<Self, ThreadsError> {
        let threads = threads.map_or(0, NonZeroUsize::get);
        if threads > MOST_THREADS {
            return Err(ThreadsError::TooMany { threads });
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| ThreadsError::NotStarted {
                threads,
                reason: error.to_string(),
            })?;
        Ok(Self {
            pool,
            engines: Mutex::new(Vec::new()),
        })
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    pub(crate) fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// Computes points, in their order. The result does not depend on the number of threads.
    ///
    /// Points that share their hoop share its engine, wherever they stand; a hoop with few points
    /// has one for few starts. Results of engines for many starts and for few agree to rounding.
    /// Where the parameters of a hoop contradict each other (μk > μs, or a point mass at the
    /// centre) the outcome is
    /// [`OutcomeKind::Invalid`](littlewood::OutcomeKind::Invalid).
    ///
    /// ```
    /// use littlewood::tables::{Setup, SummaryColumn};
    /// use littlewood::{HoopParameters, Limits, Start};
    /// use littlewood_sweep::Workers;
    ///
    /// let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    /// let points = (1..=3).map(|i| Setup::new(hoop, Start::at(0.0, f64::from(i))));
    /// let columns = Workers::new(None)?.compute(points, Limits::default())?;
    /// let lift_off = columns.reals(SummaryColumn::LiftOffTime).expect("a column of real numbers");
    /// assert_eq!(lift_off[1], 0.0); // at θ' = 2 > √2 it leaves the plane at once
    /// # Ok::<(), littlewood_sweep::SweepError>(())
    /// ```
    ///
    /// # Errors
    /// The first value, in the order of the points, that has no physical meaning by itself.
    pub fn compute(
        &self,
        points: impl IntoIterator<Item = Setup>,
        limits: Limits,
    ) -> Result<Columns, ParameterError> {
        let points: Vec<Setup> = points.into_iter().collect();
        self.compute_all(&points, None, limits)
    }

    /// As [`Workers::compute`], of a run in which each hoop has so many starts, where that is
    /// known.
    fn compute_all(
        &self,
        points: &[Setup],
        starts_of_a_hoop: Option<u64>,
        limits: Limits,
    ) -> Result<Columns, ParameterError> {
        let of_slice = Points {
            count: points.len(),
            at: &|index| points[index],
            share_hoop: false,
            derivatives: &[],
        };
        match self.follow_points(of_slice, starts_of_a_hoop, limits, &Watch::NONE) {
            Err(Halt::Refused(refused)) => Err(refused.error),
            // Nobody can cancel it.
            Err(Halt::Cancelled) => Ok(Columns::not_computed(points.len(), &[])),
            Ok(columns) => Ok(columns),
        }
    }

    /// What finds the keys of places of a grid by their summaries; `told` is told of the motions
    /// that it has followed.
    pub(crate) fn keys_of_places(
        &self,
        grid: &Grid,
        limits: Limits,
        key: impl Fn(&Summary) -> u64,
        told: &mut dyn FnMut(u64),
    ) -> impl FnMut(&[Place]) -> Result<Option<Vec<u64>>, ParameterError> {
        let mut followed = 0;
        move |places| {
            let points: Vec<_> = places
                .iter()
                .map(|&place| grid.point_between(place))
                .collect();
            let columns = self.compute_all(&points, Some(grid.starts_of_a_hoop()), limits)?;
            followed += places.len() as u64;
            told(followed);
            Ok(Some(
                columns.summaries().map(|summary| key(&summary)).collect(),
            ))
        }
    }

    /// Computes points as [`Workers::compute`] does, where it is told how far it is and may be
    /// cancelled: of
    /// [`Options`] it takes `cancel` and `progress`. `starts_of_a_hoop` is how many starts each hoop has in all calls.
    ///
    /// # Errors
    /// The first value, in the order of the points, that has no physical meaning by itself; a
    /// cancelled run.
    pub fn follow(
        &self,
        points: Points<'_>,
        starts_of_a_hoop: Option<u64>,
        limits: Limits,
        options: &Options<'_>,
    ) -> Result<Columns, Halt> {
        let ledger = Ledger::new(options, 0, points.count as u64);
        self.follow_points(points, starts_of_a_hoop, limits, &ledger.watch())
    }

    /// Computes points of a run in which each hoop has so many starts, or, where that is not known,
    /// as many as here.
    pub(crate) fn follow_points(
        &self,
        points: Points<'_>,
        starts_of_a_hoop: Option<u64>,
        limits: Limits,
        watch: &Watch<'_>,
    ) -> Result<Columns, Halt> {
        let groups = group_by_hoop(points, watch)?;
        let job = Job {
            points,
            starts_of_a_hoop,
            limits,
            watch,
            known: std::mem::take(
                &mut *self.engines.lock().unwrap_or_else(PoisonError::into_inner),
            ),
            keep: groups.len() <= KEPT,
            share: TASKS * self.threads(),
        };
        let batches = batches(&groups, job.points_of_a_task(points.count));
        let results: Vec<Done<'_>> = self
            .install(|| {
                batches
                    .par_iter()
                    .map(|batch| job.batch(batch))
                    .collect::<Vec<Result<_, Halt>>>()
            })
            .into_iter()
            .fold(Ok(Vec::new()), first_halt)?;

        let mut columns = Columns::not_computed(points.count, points.derivatives);
        let mut engines = Vec::new();
        for (prepared, tasks) in results {
            engines.extend(prepared);
            for Task {
                places,
                columns: results,
            } in tasks
            {
                columns.spread(places.iter().map(|&place| place as usize), &results);
            }
        }
        // Of two hoops that are asked for in turn neither is prepared again.
        for known in job.known {
            if engines.len() < KEPT && engines.iter().all(|other| other.bits != known.bits) {
                engines.push(known);
            }
        }
        *self.engines.lock().unwrap_or_else(PoisonError::into_inner) = engines;
        Ok(columns)
    }
}

/// Gathers results; of several refusals the one of the first point is kept.
fn first_halt<T>(so_far: Result<Vec<T>, Halt>, next: Result<T, Halt>) -> Result<Vec<T>, Halt> {
    match (so_far, next) {
        (Ok(mut all), Ok(one)) => {
            all.push(one);
            Ok(all)
        }
        (Err(Halt::Refused(a)), Err(Halt::Refused(b))) => {
            Err(Halt::Refused(if b.index < a.index { b } else { a }))
        }
        (Err(Halt::Cancelled), _) | (_, Err(Halt::Cancelled)) => Err(Halt::Cancelled),
        (Err(error), Ok(_)) | (Ok(_), Err(error)) => Err(error),
    }
}

impl Job<'_> {
    /// Points of a task where there are so many to share.
    fn points_of_a_task(&self, points: usize) -> usize {
        (points / self.share).clamp(FEWEST, TASK)
    }

    /// One hoop by many tasks, or several with few points by one.
    fn batch<'a>(&self, groups: &'a [Group]) -> Result<Done<'a>, Halt> {
        let mut kept = Vec::new();
        let mut prepared = |group: &Group| {
            if self.watch.is_cancelled() {
                return Err(Halt::Cancelled);
            }
            let (prepared, is_kept) = self.prepared(group)?;
            if is_kept {
                kept.push(prepared.clone());
            }
            Ok(prepared.engine)
        };
        let tasks = match groups {
            [group] => {
                let engine = prepared(group)?;
                let tasks = group
                    .par_chunks(self.points_of_a_task(group.len()))
                    .map(|places| {
                        let mut columns =
                            Columns::not_computed(places.len(), self.points.derivatives);
                        let watch = &mut self.watch.clone();
                        self.compute(engine.as_deref(), places, &mut columns, 0, watch)?;
                        Ok(Task {
                            places: Cow::Borrowed(places),
                            columns,
                        })
                    })
                    .collect::<Vec<_>>();
                // In order: a parallel `collect` into a Result would return any of several errors.
                tasks.into_iter().collect::<Result<_, _>>()?
            }
            _ => {
                let places = groups.concat();
                let mut columns = Columns::not_computed(places.len(), self.points.derivatives);
                let watch = &mut self.watch.clone();
                let mut first = 0;
                for group in groups {
                    let engine = prepared(group)?;
                    self.compute(engine.as_deref(), group, &mut columns, first, watch)?;
                    first += group.len();
                }
                vec![Task {
                    places: Cow::Owned(places),
                    columns,
                }]
            }
        };
        Ok((kept, tasks))
    }

    /// The engine of the hoop of a group, and whether it is kept.
    fn prepared(&self, group: &Group) -> Result<(Prepared, bool), Halt> {
        let index = group[0] as usize;
        let point = &(self.points.at)(index);
        let builder = match Hoop::new(point.hoop) {
            Ok(hoop) => {
                let starts = self.starts_of_a_hoop.unwrap_or(group.len() as u64);
                Some(
                    Engine::builder(&hoop)
                        .expected_starts(starts)
                        .interpolate_slips(),
                )
            }
            Err(error) if error.is_contradiction() => None,
            Err(error) => return Err(Halt::Refused(Refused { index, error })),
        };
        // What was prepared earlier must not change the digits of a hoop with few points.
        let prepares = builder.is_some_and(|builder| builder.prepares());
        let bits = hoop_bits(point);
        let prepared = match self
            .known
            .iter()
            .find(|known| prepares && known.bits == bits)
        {
            Some(prepared) => prepared.clone(),
            None => Prepared {
                bits,
                engine: builder.map(|builder| Arc::new(builder.build())),
            },
        };
        Ok((prepared, self.keep && prepares))
    }

    /// The derivatives of a point; none of a hoop that cannot be.
    fn derivatives(&self, index: usize) -> Vec<f64> {
        let Setup { hoop, start, .. } = (self.points.at)(index);
        let motion = Hoop::new(hoop)
            .ok()
            .and_then(|hoop| hoop.simulate(start, self.limits).ok());
        let found =
            motion.and_then(|motion| motion.summary_derivatives(self.points.derivatives).ok());
        found.unwrap_or_default()
    }

    /// Sets the results of the points at some places, in the columns from the place `first` on.
    fn compute(
        &self,
        engine: Option<&Engine>,
        places: &[u32],
        columns: &mut Columns,
        first: usize,
        watch: &mut Watch<'_>,
    ) -> Result<(), Halt> {
        for (i, &place) in (first..).zip(places) {
            if watch.is_cancelled() {
                return Err(Halt::Cancelled);
            }
            let index = place as usize;
            let summary = match engine
                .map(|engine| engine.summary((self.points.at)(index).start, self.limits))
            {
                None => Summary::INVALID,
                Some(Err(error)) if error.is_contradiction() => Summary::INVALID,
                Some(summary) => {
                    summary.map_err(|error| Halt::Refused(Refused { index, error }))?
                }
            };
            columns.set(i, &summary);
            if !self.points.derivatives.is_empty() {
                columns.set_derivatives(i, &self.derivatives(index));
            }
            watch.count();
        }
        Ok(())
    }
}

/// Hoops in their order, several together while they have no more than this many points.
fn batches(groups: &[Group], points: usize) -> Vec<&[Group]> {
    let mut batches = Vec::new();
    let (mut begin, mut sum) = (0, 0);
    for (i, group) in groups.iter().enumerate() {
        if i > begin && sum + group.len() > points {
            batches.push(&groups[begin..i]);
            (begin, sum) = (i, 0);
        }
        sum += group.len();
    }
    if begin < groups.len() {
        batches.push(&groups[begin..]);
    }
    batches
}

/// The places of the points of each hoop, hoops in the order in which they first occur.
///
/// # Panics
/// For more than 2³² points.
fn group_by_hoop(points: Points<'_>, watch: &Watch<'_>) -> Result<Vec<Group>, Halt> {
    let count =
        u32::try_from(points.count).expect("at most 2^32 points at once; compute them in chunks");
    if points.share_hoop && count > 0 {
        return Ok(vec![(0..count).collect()]);
    }
    let mut groups: Vec<Group> = Vec::new();
    let mut place: HashMap<HoopBits, usize> = HashMap::new();
    let mut last: Option<(HoopBits, usize)> = None;
    for index in 0..count {
        if watch.is_cancelled() {
            return Err(Halt::Cancelled);
        }
        let bits = hoop_bits(&(points.at)(index as usize));
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
    Ok(groups)
}
