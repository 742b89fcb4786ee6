//! `littlewood classify`: says where a start lies and what begins there.

use crate::args::ClassifyArgs;
use crate::error::Error;
use crate::output::print;
use crate::problem::Problem;
use crate::report;
use crate::request::Request;

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Error> {
    let problem = Problem::resolve(Request::new(&args.problem, None)?)?;
    let found = problem.classify()?;
    print(
        args.format,
        None,
        || report::table::classification(&problem, &found),
        |writer| report::json::classification(writer, &problem.subject(), &problem.hoop, &found),
    )
}
