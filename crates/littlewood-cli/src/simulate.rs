//! `littlewood simulate`: follows a motion and reports it.

use std::path::{Path, PathBuf};

use littlewood::Trajectory;
use littlewood::derivatives::{Derivatives, differentiable};
use littlewood::tables::Quantity;
use littlewood_report::Subject;
use littlewood_report::page::Look;

use crate::args::{Format, Names, SimulateArgs};
use crate::error::Error;
use crate::output::Output;
use crate::problem::Problem;
use crate::report::{self, Sampling};
use crate::request::Request;
use crate::scenario::Scenario;

/// Samples of a table at most: all its rows are in memory, 2.5 kB each, since they make the widths
/// of its columns.
const MOST_ROWS: u64 = 100_000;

/// What is to be written, and where: by flags, else by the scenario.
struct Wanted {
    samples: Option<u64>,
    out: Option<PathBuf>,
    format: Format,
}

impl Wanted {
    fn new(args: &SimulateArgs, scenario: Option<&Scenario>) -> Result<Self, Error> {
        let run = scenario.map(|scenario| &scenario.run);
        let samples = args.samples.or_else(|| run?.samples);
        let out = args.out.clone().or_else(|| scenario?.out());
        let format = match args.format.or_else(|| run?.format) {
            Some(format) => format,
            None => format_of(out.as_deref())?,
        };
        if format == Format::Table
            && let Some(count) = samples.filter(|&count| count > MOST_ROWS)
        {
            return Err(Error::LongTable {
                count,
                most: MOST_ROWS,
            });
        }
        Ok(Self {
            samples,
            out,
            format,
        })
    }
}

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Error> {
    let problem = Problem::resolve(Request::new(&args.problem, Some(&args.run))?)?;
    let Wanted {
        samples,
        out,
        format,
    } = Wanted::new(args, problem.scenario())?;
    let output = Output::open(out.as_deref())?;
    let trajectory = problem.simulate()?;
    let sampling = samples
        .map(|count| Sampling::of(&trajectory, usize::try_from(count).unwrap_or(usize::MAX)));
    let digits = if args.digits {
        Some(problem.digits()?)
    } else {
        None
    };
    let derivatives = derivatives(&args.derivatives, &trajectory)?;
    let uncertainty = if args.uncertainty.is_empty() {
        None
    } else {
        Some(problem.uncertainty(&trajectory, args.uncertainty.clone())?)
    };
    let subject = Subject {
        digits: digits.as_deref(),
        derivatives: derivatives.as_ref(),
        uncertainty: uncertainty.as_ref(),
        ..problem.subject()
    };
    let look = Look {
        sampling,
        all: args.all_bounces,
        advice: None,
    };
    let colour = output.has_colour();
    output.write(|writer| match format {
        Format::Table => {
            report::table::motion(&problem, &subject, &trajectory, look).write(writer, colour, None)
        }
        Format::Json => report::json::motion(writer, &subject, &trajectory, sampling),
        Format::Csv => report::csv::motion(writer, &subject, &trajectory, sampling),
    })
}

/// The derivatives with respect to the named quantities, or to all that the motion has.
fn derivatives(names: &[Names], trajectory: &Trajectory) -> Result<Option<Derivatives>, Error> {
    if names.is_empty() {
        return Ok(None);
    }
    let bounces = trajectory.hoop().restitution().is_some();
    let named = names.iter().flat_map(|names| match names {
        Names::All => Vec::from_iter(differentiable(bounces)),
        Names::One(quantity) => vec![*quantity],
    });
    let mut quantities: Vec<Quantity> = Vec::new();
    for quantity in named {
        if !quantities.contains(&quantity) {
            quantities.push(quantity);
        }
    }
    trajectory
        .derivatives(&quantities)
        .map(Some)
        .map_err(Error::NotDifferentiable)
}

/// What the ending says; a name without one is a table.
fn format_of(out: Option<&Path>) -> Result<Format, Error> {
    let Some(path) = out else {
        return Ok(Format::Table);
    };
    let ending = path
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        None | Some("txt") => Ok(Format::Table),
        Some("json") => Ok(Format::Json),
        Some("csv") => Ok(Format::Csv),
        Some(_) => Err(Error::Out {
            path: path.to_owned(),
            reason: "the ending does not say what it is to be".to_owned(),
            hint: "names end in .txt, .csv or .json, unless --format says what it is".to_owned(),
        }),
    }
}
