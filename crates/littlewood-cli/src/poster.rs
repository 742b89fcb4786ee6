//! `littlewood poster`: the story of a hoop on a page, or the paper.

use littlewood_figures::{FigureInput, chart, check_scale, poster};

use crate::args::PosterArgs;
use crate::error::Error;
use crate::output::{Output, by_ending};
use crate::problem::Problem;
use crate::progress::{Bar, Count};
use crate::request::Request;
use crate::work::STARTS;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Svg,
    Pdf,
    Png,
}

/// Runs the command.
pub(crate) fn run(args: &PosterArgs) -> Result<(), Error> {
    let kind = by_ending(
        &args.out,
        "the poster",
        &[("pdf", Kind::Pdf), ("svg", Kind::Svg), ("png", Kind::Png)],
    )?;
    check_scale(args.scale).map_err(Error::Drawing)?;
    let request = Request::new(&args.problem, Some(&args.run))?;
    let input = if args.chart {
        if request.is_about_a_motion() {
            return Err(Error::ChartOfAHoop);
        }
        None
    } else {
        let problem = Problem::resolve(request)?;
        let input = FigureInput::new(problem.hoop, problem.start, problem.limits);
        Some(FigureInput {
            units: problem.units,
            ..input
        })
    };
    let output = Output::open(Some(&args.out))?;
    let bar = Bar::new();
    let mut watch = |done, total| bar.show(STARTS, Count { done, total });
    let page = match input {
        Some(input) => poster(&input, &mut watch),
        None => chart(&mut watch),
    };
    let page = page.map_err(Error::of_figure)?;
    let bytes = match kind {
        Kind::Svg => page.svg().into_bytes(),
        Kind::Pdf => page.pdf(),
        Kind::Png => page.png(args.scale).map_err(Error::Drawing)?,
    };
    drop(bar);
    output.write(|writer| writer.write_all(&bytes))
}
