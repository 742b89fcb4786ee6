//! Arguments of a command that is not in this program, whatever they are.

use std::ffi::OsString;

use clap::Args;

/// Arguments that nobody reads.
#[derive(Debug, Args)]
#[command(disable_help_flag = true)]
pub(crate) struct ElsewhereArgs {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _arguments: Vec<OsString>,
}
