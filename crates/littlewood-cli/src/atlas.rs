//! `littlewood atlas`: the sequences of phases that occur on a grid, for one hoop or a list of
//! hoops.

use core::f64::consts::PI;
use std::path::Path;

use littlewood::tables::{Quantity, Setup};
use littlewood_sweep::{Atlas, Grid, Progress, StartList, Workers};

use crate::args::AtlasArgs;
use crate::axis::TypedAxis;
use crate::error::Error;
use crate::interrupt;
use crate::output::print;
use crate::progress::{Bar, Count};
use crate::report::atlas::{self, OfHoop, Page};
use crate::values::Given;
use crate::work::{self, Varied};

pub(crate) fn run(args: &AtlasArgs) -> Result<(), Error> {
    let axes = if args.axis.is_empty() {
        default_axes(args.first_turn)
    } else {
        args.axis.clone()
    };
    let mut varied = Varied::by(&axes);
    if args.first_turn {
        // It follows mu_s, whatever was given.
        varied.fixed.push(Given::by_flag(Quantity::MuK, 0.0));
        if args
            .base
            .setup
            .given
            .iter()
            .all(|given| given.quantity != Quantity::Theta)
        {
            varied.fixed.push(Given::by_flag(Quantity::Theta, 0.0));
        }
    }
    let listed = match &args.hoops {
        Some(path) => hoop_columns(path, &axes, args.first_turn)?,
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
            (Some(path), Some(line)) => Error::Hoop {
                path: path.clone(),
                line,
                source: Box::new(source),
            },
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
            bar.show(
                work::STARTS,
                Count {
                    done: before + progress.followed,
                    total,
                },
            );
        };
        let options = work::options(&args.work, false, cancel, &show);
        let atlas = if args.first_turn {
            Atlas::of_first_turns(grid, &workers, &options)?
        } else {
            Atlas::of_motions(grid, base.limits, &workers, &options)?
        };
        whole.absorb(atlas.clone());
        of_hoops.push(OfHoop {
            line: *line,
            setup: *grid.base(),
            atlas,
        });
        if whole.points < whole.total {
            break;
        }
    }
    drop(bar);
    let points = whole.points;
    let shown = axes
        .iter()
        .flat_map(|axis| axis.varies().quantities())
        .chain(listed.iter().copied())
        .collect();
    let hoops = if args.hoops.is_some() {
        of_hoops
    } else {
        Vec::new()
    };
    let page = Page {
        atlas: whole,
        total,
        shown,
        listed,
        hoops,
    };
    print(
        args.format,
        None,
        || atlas::table(&page),
        |writer| atlas::json(writer, &page),
    )?;
    if points < total {
        let hint = "an atlas is not resumed; what stands above is of the starts that were followed"
            .to_owned();
        return Err(Error::Interrupted {
            done: points,
            total,
            hint,
        });
    }
    Ok(())
}

/// The columns of a list of hoops, all of them of the hoop and none on an axis, too.
fn hoop_columns(path: &Path, axes: &[TypedAxis], first_turn: bool) -> Result<Vec<Quantity>, Error> {
    let bad = |column: Quantity, reason: &str| Error::HoopColumn {
        path: path.to_owned(),
        column,
        reason: reason.to_owned(),
    };
    let list = StartList::open(path, work::STAND_IN)?;
    let columns = list.columns().iter().copied();
    columns
        .map(|column| {
            if !Quantity::HOOP.contains(&column) {
                Err(bad(column, "is of the start, not of the hoop"))
            } else if axes
                .iter()
                .any(|axis| axis.quantities().any(|varied| varied == column))
            {
                Err(bad(column, "is an axis, too"))
            } else if first_turn && column == Quantity::MuK {
                Err(bad(column, "follows mu_s with --first-turn"))
            } else {
                Ok(column)
            }
        })
        .collect()
}

/// The hoops of a list, each with its line.
fn read_hoops(path: &Path, base: Setup) -> Result<Vec<(Option<u64>, Setup)>, Error> {
    let hoops = StartList::open(path, base)?
        .points()?
        .map(|row| row.map(|(line, setup)| (Some(line), setup)));
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
