//! What the commands that follow many motions share: the base point, the threads, the options of a run.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use littlewood::{Limits, Quantity, Units};
use littlewood_sweep::{Axis, AxisError, Grid, Options, Point, Progress, Report, Target, Workers};

use crate::args::{BaseArgs, RunArgs, WorkArgs};
use crate::axis::TypedAxis;
use crate::error::Error;
use crate::problem::{Above, Problem};
use crate::scenario::Scenario;
use crate::values::{Given, Origin};

/// The point that the others are taken from, and the limits.
#[derive(Debug)]
pub(crate) struct Base {
    pub(crate) point: Point,
    pub(crate) limits: Limits,
    /// Units, if anything was given in SI units.
    pub(crate) units: Option<Units>,
}

/// Quantities that need no value from elsewhere.
#[derive(Debug, Default)]
pub(crate) struct Varied {
    /// Those that an axis or a list has.
    pub(crate) quantities: Vec<Quantity>,
    /// Whether an axis of them is in SI units.
    pub(crate) si: bool,
    /// Numbers that stand above all flags.
    pub(crate) fixed: Vec<Given>,
}

impl Varied {
    /// What axes vary.
    pub(crate) fn by(axes: &[TypedAxis]) -> Self {
        Self {
            quantities: axes.iter().map(|axis| axis.coordinate().quantity()).collect(),
            si: axes.iter().any(TypedAxis::is_si),
            fixed: Vec::new(),
        }
    }
}

/// Finds the base of a sweep.
///
/// # Errors
/// As [`Problem::resolve`].
pub(crate) fn base(args: &BaseArgs, run: &RunArgs, varied: Varied) -> Result<Base, Error> {
    let problem = args.to_problem();
    let scenario = problem.scenario.as_deref().map(Scenario::read).transpose()?;
    let Varied { quantities, si, fixed } = varied;
    let stand_ins = quantities.into_iter().map(|quantity| of_flag(quantity, stand_in(quantity)));
    let above = Above { given: fixed.into_iter().chain(stand_ins).collect(), si };
    let problem = Problem::resolve(&problem, run.given(), above, run.max_transitions, scenario)?;
    let point = Point { hoop: problem.hoop.parameters(), start: problem.start };
    Ok(Base { point, limits: problem.limits, units: problem.units })
}

/// A number as if it had been typed.
pub(crate) const fn of_flag(quantity: Quantity, value: f64) -> Given {
    Given { quantity, value, origin: Origin::Flag }
}

/// A value that goes with all others (1e9 is the largest friction that a hoop may have), until the axis or the list puts
/// its own in its place.
const fn stand_in(quantity: Quantity) -> f64 {
    match quantity {
        Quantity::MassRatio | Quantity::Inertia => 1.0,
        Quantity::Offset => 0.5,
        Quantity::MuS => 1e9,
        _ => 0.0,
    }
}

/// A grid over a case, a scenario or flags.
///
/// # Errors
/// As [`base`] and [`Grid::new`].
pub(crate) fn grid(args: &BaseArgs, run: &RunArgs, axes: &[TypedAxis]) -> Result<(Grid, Limits), Error> {
    let base = base(args, run, Varied::by(axes))?;
    Ok((Grid::new(base.point, resolve(axes, &base)?)?, base.limits))
}

/// Axes without dimension.
///
/// # Errors
/// As [`Axis::new`].
pub(crate) fn resolve(axes: &[TypedAxis], base: &Base) -> Result<Vec<Axis>, Error> {
    let axes = axes.iter().map(|axis| axis.resolve(base.units.as_ref()));
    Ok(axes.collect::<Result<_, AxisError>>()?)
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

/// What a run has left behind: what can be read, and resumed if it is not complete.
pub(crate) fn kept(targets: &[Target<'_>], report: &Report, pictures: Vec<PathBuf>) -> Vec<PathBuf> {
    let stores = targets.iter().map(|target| match target {
        Target::Parquet(path) if !report.complete => with_ending(path, ".parts"),
        Target::Zarr(path) | Target::Parquet(path) | Target::ParquetFolder(path) => path.to_path_buf(),
    });
    stores.chain(pictures).collect()
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}
