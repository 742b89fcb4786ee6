//! `littlewood atlas`: the sequences of phases that occur on a grid, for one hoop or a list of hoops.

use core::f64::consts::PI;
use std::path::Path;

use littlewood::tables::{Quantity, Setup};
use littlewood_sweep::{Atlas, Grid, Progress, StartList, Workers};

use crate::args::{AtlasArgs, ShortFormat};
use crate::axis::TypedAxis;
use crate::error::Error;
use crate::interrupt;
use crate::list;
use crate::output::Output;
use crate::progress::{Bar, Count};
use crate::report::atlas::{self, OfHoop, Page};
use crate::values::Given;
use crate::work::{self, Varied};

pub(crate) fn run(args: &AtlasArgs) -> Result<(), Error> {
    let axes = if args.axis.is_empty() { default_axes(args.first_turn) } else { args.axis.clone() };
    let mut varied = Varied::by(&axes);
    if args.first_turn {
        // It follows mu_s, whatever was given.
        varied.fixed.push(Given::by_flag(Quantity::MuK, 0.0));
        if args.base.setup.given.iter().all(|given| given.quantity != Quantity::Theta) {
            varied.fixed.push(Given::by_flag(Quantity::Theta, 0.0));
        }
    }
    let listed = match &args.hoops {
        Some(path) => list::hoop_columns(path, &axes, args.first_turn)?,
        None => Vec::new(),
    };
    varied.quantities.extend(&listed);
    let base = work::base(&args.base, &args.run, varied)?;
    let axes = work::resolve(&axes, &base)?;
    let hoops = match &args.hoops {
        Some(path) => read_hoops(path, base.setup)?,
        None => vec![(None, base.setup)],
    };
    let mut grids = Vec::new();
    for (line, setup) in hoops {
        let grid = Grid::new(setup, axes.clone()).map_err(|source| match (&args.hoops, line) {
            (Some(path), Some(line)) => Error::Hoop { path: path.clone(), line, source: Box::new(source) },
            _ => source.into(),
        })?;
        grids.push((line, grid));
    }

    let workers = Workers::new(args.work.threads)?;
    let cancel = interrupt::asked();
    let bar = Bar::new();
    let total: u64 = grids.iter().map(|(_, grid)| grid.len()).sum();
    let mut whole = Atlas::default();
    let mut of_hoops = Vec::new();
    for (line, grid) in &grids {
        let before = whole.points;
        let show = |progress: Progress| {
            bar.show(work::STARTS, Count { done: before + progress.followed, total });
        };
        let options = work::options(&args.work, false, cancel, &show);
        let atlas = if args.first_turn {
            Atlas::of_first_turns(grid, &workers, &options)?
        } else {
            Atlas::of_motions(grid, base.limits, &workers, &options)?
        };
        whole.absorb(atlas.clone());
        of_hoops.push(OfHoop { line: *line, setup: *grid.base(), atlas });
        if whole.points < whole.total {
            break;
        }
    }
    drop(bar);
    let points = whole.points;
    let shown =
        axes.iter().flat_map(|axis| axis.varies().quantities()).chain(listed.iter().copied()).collect();
    let hoops = if args.hoops.is_some() { of_hoops } else { Vec::new() };
    let page = Page { atlas: whole, total, shown, listed, hoops };
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => atlas::table(&page).write(writer, colour, None),
        ShortFormat::Json => atlas::json(writer, &page),
    })?;
    if points < total {
        let hint =
            "an atlas is not resumed; what stands above is of the starts that were followed".to_owned();
        return Err(Error::Interrupted { done: points, total, hint });
    }
    Ok(())
}

/// The hoops of a list, each with its line.
fn read_hoops(path: &Path, base: Setup) -> Result<Vec<(Option<u64>, Setup)>, Error> {
    let hoops =
        StartList::open(path, base)?.points()?.map(|row| row.map(|(line, setup)| (Some(line), setup)));
    Ok(hoops.collect::<Result<_, _>>()?)
}

fn default_axes(first_turn: bool) -> Vec<TypedAxis> {
    if first_turn {
        vec![
            TypedAxis::plain(Quantity::ThetaRate, 0.01, 2.0, 200),
            TypedAxis::plain(Quantity::MuS, 0.01, 2.0, 200),
        ]
    } else {
        vec![
            TypedAxis::plain(Quantity::Theta, -PI, PI, 200),
            TypedAxis::plain(Quantity::ThetaRate, -4.0, 4.0, 200),
        ]
    }
}
