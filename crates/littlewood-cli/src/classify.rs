//! `littlewood classify`: says where a start lies and what begins there.

use crate::args::{ClassifyArgs, ShortFormat};
use crate::error::Error;
use crate::output::Output;
use crate::problem::{Above, Problem};
use crate::report;
use crate::scenario::Scenario;

/// Runs the command.
///
/// # Errors
/// Bad input, or a failure to write.
pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Error> {
    let scenario = args.problem.scenario.as_deref().map(Scenario::read).transpose()?;
    let problem = Problem::resolve(&args.problem, Vec::new(), Above::default(), None, scenario)?;
    let found = problem.classify()?;
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => report::table::classification(writer, &problem, &found, colour),
        ShortFormat::Json => report::json::classification(writer, &problem.subject(), &problem.hoop, &found),
    })
}
