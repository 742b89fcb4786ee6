//! `littlewood atlas`: the sequences of phases that occur on a grid.

use core::f64::consts::PI;

use littlewood::Quantity;
use littlewood_sweep::{Atlas, Axis, Coordinate, Grid};

use crate::args::{AtlasArgs, ShortFormat};
use crate::error::Error;
use crate::interrupt;
use crate::output::Output;
use crate::progress::Bar;
use crate::report::sweep;
use crate::work;

/// Runs the command.
///
/// # Errors
/// Bad input, a failure to write, or Ctrl-C.
pub(crate) fn run(args: &AtlasArgs) -> Result<(), Error> {
    let axes = if args.axis.is_empty() { default_axes(args.first_turn)? } else { args.axis.clone() };
    let varied: Vec<Coordinate> = axes.iter().map(Axis::coordinate).collect();
    let mut fixed = Vec::new();
    if args.first_turn {
        // It follows mu_s, whatever was given.
        fixed.push(work::of_flag(Quantity::MuK, 0.0));
        if args.base.to_problem().given().iter().all(|given| given.quantity != Quantity::Theta) {
            fixed.push(work::of_flag(Quantity::Theta, 0.0));
        }
    }
    let (base, limits) = work::base(&args.base, &args.run, varied, fixed)?;
    let grid = Grid::new(base, axes)?;
    let workers = work::workers(&args.work)?;
    let cancel = interrupt::listen();
    let bar = Bar::new();
    let show = |progress| bar.show(progress);
    let options = work::options(&args.work, false, cancel, &show);
    let atlas = if args.first_turn {
        Atlas::of_first_turns(&grid, &workers, &options)?
    } else {
        Atlas::of_motions(&grid, limits, &workers, &options)?
    };
    drop(bar);
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => sweep::atlas_table(writer, &grid, &atlas, colour),
        ShortFormat::Json => sweep::atlas_json(writer, &grid, &atlas),
    })?;
    if atlas.points < grid.len() {
        let hint =
            "an atlas is not resumed; what stands above is of the starts that were followed".to_owned();
        return Err(Error::Interrupted { done: atlas.points, total: grid.len(), hint });
    }
    Ok(())
}

fn default_axes(first_turn: bool) -> Result<Vec<Axis>, Error> {
    let [a, b] = if first_turn {
        [Axis::new(Coordinate::ThetaRate, 0.01, 2.0, 200), Axis::new(Coordinate::MuS, 0.01, 2.0, 200)]
    } else {
        [Axis::new(Coordinate::Theta, -PI, PI, 200), Axis::new(Coordinate::ThetaRate, -4.0, 4.0, 200)]
    };
    Ok(vec![a?, b?])
}
