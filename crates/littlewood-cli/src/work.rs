//! What the commands that follow many motions share: the base point, the threads, the options of a run.

use std::sync::atomic::AtomicBool;

use littlewood::{Limits, Quantity};
use littlewood_sweep::{Axis, Coordinate, Grid, Options, Point, Progress, Workers};

use crate::args::{BaseArgs, RunArgs, WorkArgs};
use crate::error::Error;
use crate::problem::Problem;
use crate::scenario::Scenario;
use crate::values::{Given, Origin};

/// The point that the others are taken from, and the limits. `varied` are the quantities that need no value, because
/// an axis or a list has them; `fixed` stand above all flags.
///
/// # Errors
/// As [`Problem::resolve`].
pub(crate) fn base(
    args: &BaseArgs,
    run: &RunArgs,
    varied: impl IntoIterator<Item = Coordinate>,
    fixed: Vec<Given>,
) -> Result<(Point, Limits), Error> {
    let problem = args.to_problem();
    let scenario = problem.scenario.as_deref().map(Scenario::read).transpose()?;
    let mut given = run.given();
    given.extend(fixed);
    given.extend(varied.into_iter().map(|coordinate| of_flag(coordinate.quantity(), stand_in(coordinate))));
    let problem = Problem::resolve(&problem, given, run.max_transitions, scenario)?;
    Ok((Point { hoop: problem.hoop.parameters(), start: problem.start }, problem.limits))
}

/// A number as if it had been typed.
pub(crate) const fn of_flag(quantity: Quantity, value: f64) -> Given {
    Given { quantity, value, origin: Origin::Flag }
}

/// A value that goes with all others (1e9 is the largest friction that a hoop may have), until the axis or the list puts its own in its place.
const fn stand_in(coordinate: Coordinate) -> f64 {
    match coordinate {
        Coordinate::MassRatio | Coordinate::Inertia => 1.0,
        Coordinate::Offset => 0.5,
        Coordinate::MuS => 1e9,
        Coordinate::Theta | Coordinate::ThetaRate | Coordinate::Slip | Coordinate::MuK => 0.0,
    }
}

/// A grid over a case, a scenario or flags.
///
/// # Errors
/// As [`base`] and [`Grid::new`].
pub(crate) fn grid(args: &BaseArgs, run: &RunArgs, axes: Vec<Axis>) -> Result<(Grid, Limits), Error> {
    let (base, limits) = base(args, run, axes.iter().map(Axis::coordinate), Vec::new())?;
    Ok((Grid::new(base, axes)?, limits))
}

/// The threads that were asked for.
///
/// # Errors
/// If the system has none to give.
pub(crate) fn workers(args: &WorkArgs) -> Result<Workers, Error> {
    Ok(Workers::new(args.threads)?)
}

/// The options of a run.
pub(crate) fn options<'a>(
    args: &WorkArgs,
    resume: bool,
    cancel: &'a AtomicBool,
    progress: &'a (dyn Fn(Progress) + Sync),
) -> Options<'a> {
    Options {
        resume,
        chunk_points: args.chunk,
        cancel: Some(cancel),
        progress: Some(progress),
        ..Options::default()
    }
}
