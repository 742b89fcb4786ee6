//! `littlewood cases`: lists the named cases.

use crate::args::CasesArgs;
use crate::error::Error;
use crate::output::print;
use crate::report;

/// Width of the terminal, clamped to 60 to 100 columns; 100 without a terminal.
fn width() -> usize {
    terminal_size::terminal_size().map_or(100, |(width, _)| usize::from(width.0).clamp(60, 100))
}

pub(crate) fn run(args: &CasesArgs) -> Result<(), Error> {
    print(args.format, Some(width()), report::table::cases, |writer| {
        report::json::cases(writer)
    })
}
