//! Arguments of a command that is not in this program, whatever they are.

#![cfg(not(all(feature = "sweep", feature = "figures", feature = "film", feature = "lab")))]

use std::ffi::OsString;

use clap::Args;

/// Arguments that nobody reads.
#[derive(Debug, Args)]
pub(crate) struct NotBuiltArgs {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _arguments: Vec<OsString>,
}
