//! `littlewood poster`: the story of a hoop on a page.

use std::ffi::OsStr;
use std::path::Path;

use littlewood_figures::{FigureInput, check_scale, poster};

use crate::args::PosterArgs;
use crate::error::Error;
use crate::output::Output;
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
    let kind = kind_of(&args.out)?;
    check_scale(args.scale).map_err(Error::Drawing)?;
    let problem = Problem::resolve(Request::new(&args.problem, Some(&args.run))?)?;
    let input = FigureInput::new(problem.hoop, problem.start, problem.limits);
    let output = Output::open(Some(&args.out))?;
    let bar = Bar::new();
    let mut watch = |done, total| bar.show(STARTS, Count { done, total });
    let page = poster(&input, &mut watch).map_err(Error::of_figure)?;
    let bytes = match kind {
        Kind::Svg => page.svg().into_bytes(),
        Kind::Pdf => page.pdf(),
        Kind::Png => page.png(args.scale).map_err(Error::Drawing)?,
    };
    drop(bar);
    output.write(|writer| writer.write_all(&bytes))
}

fn kind_of(out: &Path) -> Result<Kind, Error> {
    let ending = out
        .extension()
        .and_then(OsStr::to_str)
        .map(str::to_lowercase);
    match ending.as_deref() {
        Some("svg") => Ok(Kind::Svg),
        Some("pdf") => Ok(Kind::Pdf),
        Some("png") => Ok(Kind::Png),
        _ => Err(Error::Out {
            path: out.to_owned(),
            reason: "its ending does not say what the poster is to be".to_owned(),
            hint: "the endings are .pdf, .svg and .png".to_owned(),
        }),
    }
}
