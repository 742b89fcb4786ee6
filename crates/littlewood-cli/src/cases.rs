//! `littlewood cases`: lists the named cases.

use crate::args::{CasesArgs, ShortFormat};
use crate::error::Error;
use crate::output::Output;
use crate::report;

/// Runs the command.
///
/// # Errors
/// A failure to write.
pub(crate) fn run(args: &CasesArgs) -> Result<(), Error> {
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match args.format {
        ShortFormat::Table => report::table::cases(writer, colour),
        ShortFormat::Json => report::json::cases(writer),
    })
}
