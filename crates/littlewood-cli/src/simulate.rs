//! `littlewood simulate`: follows a motion and reports it.

use std::path::Path;

use littlewood_report::Subject;

use crate::args::{Format, SimulateArgs};
use crate::error::Error;
use crate::output::Output;
use crate::problem::Problem;
use crate::report::table::Look;
use crate::report::{self, Sampling};
use crate::request::Request;
use crate::scenario::Scenario;

/// Runs the command.
///
/// # Errors
/// Bad input, or a failure to write.
pub(crate) fn run(args: &SimulateArgs) -> Result<(), Error> {
    let problem = Problem::resolve(Request::new(&args.problem, Some(&args.run))?)?;
    let scenario = problem.scenario();
    let samples = args.samples.or_else(|| scenario.and_then(Scenario::samples));
    let out = args.out.clone().or_else(|| scenario.and_then(Scenario::out));
    let format = args
        .format
        .or_else(|| scenario.and_then(Scenario::format))
        .unwrap_or_else(|| format_of(out.as_deref()));

    let output = Output::open(out.as_deref())?;
    let trajectory = problem.simulate()?;
    let sampling =
        samples.map(|count| Sampling::of(&trajectory, usize::try_from(count).unwrap_or(usize::MAX)));
    let digits = if args.digits { Some(problem.digits()?) } else { None };
    let subject = Subject { digits: digits.as_deref(), ..problem.subject() };
    let look = Look {
        sampling,
        digits: digits.as_deref(),
        all_bounces: args.all_bounces,
        colour: output.has_colour(),
    };
    output.write(|writer| match format {
        Format::Table => report::table::motion(writer, &problem, &trajectory, look),
        Format::Json => report::json::motion(writer, &subject, &trajectory, sampling),
        Format::Csv => report::csv::motion(writer, &subject, &trajectory, sampling),
    })
}

fn format_of(out: Option<&Path>) -> Format {
    match out.and_then(Path::extension).and_then(|ending| ending.to_str()) {
        Some("json") => Format::Json,
        Some("csv") => Format::Csv,
        _ => Format::Table,
    }
}
