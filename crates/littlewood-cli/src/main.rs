//! The program `littlewood`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(littlewood_cli::run(std::env::args_os()))
}
