//! `littlewood cases`: lists the named cases.

use crate::args::{CasesArgs, ShortFormat};
use crate::error::Error;
use crate::output::Output;
use crate::report;

/// Width of the terminal, clamped to 60 to 100 columns; 100 without a terminal.
fn width() -> usize {
    terminal_size::terminal_size().map_or(100, |(width, _)| usize::from(width.0).clamp(60, 100))
}

pub(crate) fn run(args: &CasesArgs) -> Result<(), Error> {
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => report::table::cases().write(writer, colour, Some(width())),
        ShortFormat::Json => report::json::cases(writer),
    })
}
