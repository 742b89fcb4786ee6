//! What the commands that follow many motions share: the base point, the threads, the options of a
//! run.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use littlewood::derivatives::{NotDifferentiable, differentiable};
use littlewood::si::Units;
use littlewood::tables::{DerivativeColumn, Quantity, Setup};
use littlewood::{HoopParameters, Limits, RestitutionLaw, Start};
use littlewood_sweep::{Axis, AxisError, Grid, Options, Progress, Report, Target};

use crate::args::{ProblemArgs, RunArgs, WorkArgs};
use crate::axis::TypedAxis;
use crate::error::Error;
use crate::problem::Problem;
use crate::progress::Count;
use crate::request::{Overrides, Request};
use crate::unfinished::ListedDisk;
use crate::values::Given;

/// A setup whose numbers go with all values of any one of them, for what an axis or a list puts its
/// own value in place of. 1e9 is the largest coefficient of friction that a hoop may have.
pub(crate) const STAND_IN: Setup = Setup::new(
    HoopParameters::thin(1.0)
        .with_offset(0.5)
        .with_friction(1e9, 0.0)
        .with_restitution(0.0, RestitutionLaw::Energetic),
    Start::at(0.0, 0.0),
);

/// The setup that the others are taken from, and the limits.
#[derive(Debug)]
pub(crate) struct Base {
    pub(crate) setup: Setup,
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
}

impl Varied {
    /// Quantities that the axes vary.
    pub(crate) fn by(axes: &[TypedAxis]) -> Self {
        Self {
            quantities: axes.iter().flat_map(TypedAxis::quantities).collect(),
            si: axes.iter().any(TypedAxis::is_si),
        }
    }
}

pub(crate) fn base(
    args: &ProblemArgs<false>,
    run: &RunArgs,
    varied: Varied,
) -> Result<Base, Error> {
    let stand_ins = varied
        .quantities
        .into_iter()
        .filter_map(|quantity| Some(Given::by_flag(quantity, STAND_IN.get(quantity)?)));
    let request = Request {
        overrides: Overrides {
            given: stand_ins.collect(),
            si: varied.si,
        },
        ..Request::new(args, Some(run))?
    };
    let problem = Problem::resolve(request)?;
    let setup = Setup::new(problem.hoop.parameters(), problem.start);
    Ok(Base {
        setup,
        limits: problem.limits,
        units: problem.units,
    })
}

/// A grid over a case, a scenario or flags.
pub(crate) fn grid(
    args: &ProblemArgs<false>,
    run: &RunArgs,
    axes: &[TypedAxis],
    wanted: &[DerivativeColumn],
) -> Result<(Grid, Base), Error> {
    let base = base(args, run, Varied::by(axes))?;
    let grid = Grid::new(base.setup, resolve(axes, &base)?)?;
    let bounces =
        grid.axis(Quantity::Restitution).is_some() || base.setup.hoop.restitution.is_some();
    let derivatives = derivatives(wanted, bounces)?;
    Ok((grid.with_derivatives(derivatives), base))
}

/// Derivatives, each once. One by the restitution of motions that have none is refused.
pub(crate) fn derivatives(
    wanted: &[DerivativeColumn],
    bounces: bool,
) -> Result<Vec<DerivativeColumn>, Error> {
    let mut derivatives = Vec::new();
    for column in wanted {
        let quantity = column.quantity;
        if !differentiable(bounces).any(|known| known == quantity) {
            return Err(Error::NotDifferentiable(NotDifferentiable { quantity }));
        }
        if !derivatives.contains(column) {
            derivatives.push(*column);
        }
    }
    Ok(derivatives)
}

pub(crate) fn resolve(axes: &[TypedAxis], base: &Base) -> Result<Vec<Axis>, Error> {
    let axes = axes.iter().map(|axis| axis.resolve(base.units.as_ref()));
    Ok(axes.collect::<Result<_, AxisError>>()?)
}

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
        disk: &ListedDisk,
    }
}

/// What a bar counts.
pub(crate) const STARTS: &str = "starts";

/// How far a run is; what an earlier run has done is there before it.
pub(crate) const fn count(progress: Progress) -> Count {
    Count {
        done: progress.followed,
        total: progress.total,
    }
}

/// Files of a run that can be read, and resumed if it is not complete.
pub(crate) fn kept(
    targets: &[Target<'_>],
    report: &Report,
    pictures: Vec<PathBuf>,
) -> Vec<PathBuf> {
    targets
        .iter()
        .map(|target| target.readable(report.complete))
        .chain(pictures)
        .collect()
}
