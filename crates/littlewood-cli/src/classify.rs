//! `littlewood classify`: says where a start lies and what begins there.

use crate::args::{ClassifyArgs, ShortFormat};
use crate::error::Error;
use crate::output::Output;
use crate::problem::Problem;
use crate::report;
use crate::request::Request;

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Error> {
    let problem = Problem::resolve(Request::new(&args.problem, None)?)?;
    let found = problem.classify()?;
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => report::table::classification(&problem, &found).write(writer, colour, None),
        ShortFormat::Json => report::json::classification(writer, &problem.subject(), &problem.hoop, &found),
    })
}
