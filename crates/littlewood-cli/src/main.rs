//! The command line of Littlewood's hoop: `littlewood simulate`, `classify` and `cases`.

mod args;
mod cases;
mod classify;
mod error;
mod output;
mod problem;
mod report;
mod scenario;
mod simulate;
mod values;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Cli, Command, join_negative_numbers};

fn main() -> ExitCode {
    let cli = match Cli::try_parse_from(join_negative_numbers(std::env::args_os())) {
        Ok(cli) => cli,
        Err(message) => {
            // `--help` and `--version` arrive here too. A reader that has left is no reason to complain.
            let _ = message.print();
            return if message.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS };
        }
    };
    let result = match cli.command {
        Command::Simulate(args) => simulate::run(&args),
        Command::Classify(args) => classify::run(&args),
        Command::Cases(args) => cases::run(&args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error.print();
            error.exit_code()
        }
    }
}
