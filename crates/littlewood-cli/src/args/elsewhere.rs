//! Arguments of a command that is not in this program, whatever they are.

use std::ffi::OsString;

use clap::Args;

/// Arguments that nobody reads.
#[derive(Debug, Args)]
pub(crate) struct ElsewhereArgs {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _arguments: Vec<OsString>,
}
