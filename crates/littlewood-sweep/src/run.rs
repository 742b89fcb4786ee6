//! Running a sweep: chunk after chunk is computed and written atomically; a run that was stopped is
//! resumed.

use std::sync::Arc;

use littlewood::Limits;
use littlewood::tables::{Class, Setup};
use rayon::prelude::*;

use crate::columns::Columns;
use crate::compute::{Halt, Points, Refused, Workers};
use crate::destination::{Destination, OpenDestination};
use crate::error::SweepError;
use crate::options::Options;
use crate::source::Source;
use crate::store::{StoreError, StoreFile, WrittenChunk};
use crate::tally::Tally;
use crate::watch::Ledger;

/// Chunks that are computed while those before them are written.
const BATCH: usize = 2;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Report {
    /// All points.
    pub points: u64,
    /// Points that this run has computed.
    pub computed: u64,
    /// Points that an earlier run had computed.
    pub reused: u64,
    /// Chunks of an earlier run that were damaged or missing, and are computed again.
    pub damaged_chunks: usize,
    /// Whether all chunks are there. If not, the run was cancelled.
    pub complete: bool,
    /// Points of each class, including those of an earlier run.
    pub tally: Tally,
}

/// Is called with the number and the results of every chunk, in no particular order.
pub(crate) type View<'a> = &'a mut dyn FnMut(usize, &Columns);

/// A chunk that is computed, and encoded for each destination that lacks it.
struct FinishedChunk {
    written: WrittenChunk,
    /// One entry a destination; none for a destination that has the chunk.
    files: Vec<Option<Vec<StoreFile>>>,
}

/// Computes the chunks that any of the destinations lacks, once for all of them.
pub(crate) fn run(
    source: &mut dyn Source,
    destinations: &[Destination],
    mut view: Option<View<'_>>,
    limits: Limits,
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    let (mut run, missing) = Run::open(source, destinations, &mut view, workers, options)?;
    let (total, starts_of_a_hoop) = (source.total(), source.starts_of_a_hoop());
    let derivatives = source.derivatives().to_vec();
    let mut batches = missing.chunks(BATCH);
    let mut finished: Vec<FinishedChunk> = Vec::new();
    loop {
        // While one batch is written the next is computed. A cancelled run writes the chunks that
        // it has computed.
        let cancelled = run.ledger.watch().is_cancelled();
        let batch = if cancelled {
            &[][..]
        } else {
            batches.next().unwrap_or_default()
        };
        if batch.is_empty() && finished.is_empty() {
            break;
        }
        let (inputs, source_error) = match run.inputs(source, batch) {
            Ok(inputs) => (inputs, None),
            Err(error) => (Vec::new(), Some(error)),
        };
        let ledger = Arc::clone(&run.ledger);
        let (written, computed) = workers.install(|| {
            rayon::join(
                || run.write(&finished),
                || {
                    inputs
                        .into_par_iter()
                        .map(|input| {
                            let points = Points {
                                count: input.points.len(),
                                at: &|index| input.points[index],
                                share_hoop: starts_of_a_hoop == Some(total),
                                derivatives: &derivatives,
                            };
                            let watch = ledger.watch();
                            let found =
                                workers.follow_points(points, starts_of_a_hoop, limits, &watch);
                            encode(input, found, destinations)
                        })
                        .collect::<Vec<_>>()
                },
            )
        });
        written?;
        if let Some(error) = source_error {
            return Err(error);
        }
        finished = finished_chunks(computed, source, &mut view)?;
    }
    Ok(run.complete()?)
}

/// The chunks of a batch that are computed, after they were shown; those that were cancelled are
/// left out.
fn finished_chunks(
    computed: Vec<Result<(FinishedChunk, Columns), Failure>>,
    source: &dyn Source,
    view: &mut Option<View<'_>>,
) -> Result<Vec<FinishedChunk>, SweepError> {
    let mut finished = Vec::new();
    for chunk in computed {
        let (chunk, columns) = match chunk {
            Ok(chunk) => chunk,
            Err(Failure::Cancelled) => continue,
            Err(Failure::Point { chunk, refused }) => {
                return Err(source.refused(chunk, refused));
            }
            Err(Failure::Store(error)) => return Err(error.into()),
        };
        if let Some(view) = view {
            view(chunk.written.number, &columns);
        }
        finished.push(chunk);
    }
    Ok(finished)
}

struct Run<'a> {
    destinations: Vec<OpenDestination<'a>>,
    ledger: Arc<Ledger<'a>>,
    tally: Tally,
}

impl<'a> Run<'a> {
    /// Opens the destinations, shows the chunks that all of them have, and returns the numbers of
    /// the others.
    fn open(
        source: &dyn Source,
        destinations: &'a [Destination],
        view: &mut Option<View<'_>>,
        workers: &Workers,
        options: &'a Options<'a>,
    ) -> Result<(Self, Vec<usize>), SweepError> {
        // Nothing is written anywhere before all are known to be good.
        for destination in destinations {
            destination.inspect(options.resume)?;
        }
        let destinations = destinations
            .iter()
            .map(|destination| destination.open(source.count(), options, workers))
            .collect::<Result<Vec<OpenDestination<'_>>, StoreError>>()?;
        let has = |number: &usize| {
            !destinations.is_empty()
                && destinations
                    .iter()
                    .all(|destination| destination.has(*number))
        };
        let (known, missing): (Vec<usize>, Vec<usize>) = (0..source.count()).partition(has);
        if let (Some(view), Some(destination)) = (view, destinations.first()) {
            for &number in &known {
                view(number, &destination.read(number)?);
            }
        }
        // A file that is complete knows all its points, but not which are in which chunk; a store
        // beside it does.
        let tally = destinations
            .iter()
            .find_map(|destination| destination.tally(&known))
            .unwrap_or_default();
        let reused: u64 = known.iter().map(|&number| source.points_of(number)).sum();
        let ledger = Arc::new(Ledger::new(options, reused, source.total()));
        ledger.report();
        Ok((
            Self {
                destinations,
                ledger,
                tally,
            },
            missing,
        ))
    }

    /// The points of some chunks, and which destinations lack them.
    fn inputs(&self, source: &mut dyn Source, batch: &[usize]) -> Result<Vec<Input>, SweepError> {
        batch
            .iter()
            .map(|&number| {
                let lacking = self
                    .destinations
                    .iter()
                    .map(|destination| !destination.has(number))
                    .collect();
                Ok(Input {
                    number,
                    points: source.points(number)?,
                    lacking,
                })
            })
            .collect()
    }

    fn write(&mut self, finished: &[FinishedChunk]) -> Result<(), StoreError> {
        for chunk in finished {
            for (destination, files) in self.destinations.iter_mut().zip(&chunk.files) {
                if let Some(files) = files {
                    destination
                        .add(chunk.written, files)
                        .map_err(|error| error.with_finished(self.ledger.progress().done))?;
                }
            }
            self.tally += chunk.written.tally;
            self.ledger.finish(chunk.written.tally.total());
        }
        Ok(())
    }

    /// Completes the destinations if all chunks are there.
    fn complete(self) -> Result<Report, StoreError> {
        let Self {
            destinations,
            ledger,
            mut tally,
        } = self;
        let progress = ledger.progress();
        let complete = progress.done == progress.total;
        let damaged_chunks = destinations
            .iter()
            .map(OpenDestination::damaged_chunks)
            .sum();
        if complete {
            for destination in destinations {
                destination
                    .complete(tally)
                    .map_err(|error| error.with_finished(progress.done))?;
            }
        }
        tally.add(Class::NotComputed, progress.total - progress.done);
        let computed = progress.done - progress.reused;
        let reused = progress.reused;
        Ok(Report {
            points: progress.total,
            computed,
            reused,
            damaged_chunks,
            complete,
            tally,
        })
    }
}

struct Input {
    number: usize,
    points: Vec<Setup>,
    /// Which destinations lack it.
    lacking: Vec<bool>,
}

enum Failure {
    Point { chunk: usize, refused: Refused },
    Store(StoreError),
    Cancelled,
}

fn encode(
    Input {
        number,
        points,
        lacking,
    }: Input,
    found: Result<Columns, Halt>,
    destinations: &[Destination],
) -> Result<(FinishedChunk, Columns), Failure> {
    let columns = found.map_err(|halt| match halt {
        Halt::Refused(refused) => Failure::Point {
            chunk: number,
            refused,
        },
        Halt::Cancelled => Failure::Cancelled,
    })?;
    let files = destinations
        .iter()
        .zip(lacking)
        .map(|(destination, lacking)| {
            lacking
                .then(|| destination.format().encode(number, &points, &columns))
                .transpose()
        })
        .collect::<Result<_, _>>()
        .map_err(Failure::Store)?;
    let tally = Tally::of_columns(&columns);
    Ok((
        FinishedChunk {
            written: WrittenChunk { number, tally },
            files,
        },
        columns,
    ))
}
