//! The command line of Littlewood's hoop: a module for each command.

mod animate;
mod args;
mod atlas;
mod axis;
mod cases;
mod classify;
mod error;
mod figures;
mod interrupt;
mod lab;
mod list;
mod map;
mod nearest;
mod output;
mod problem;
mod progress;
mod report;
mod request;
mod scenario;
mod simulate;
mod store;
mod sweep;
mod unfinished;
mod values;
mod work;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Cli, Command, join_negative_numbers};

fn main() -> ExitCode {
    let cli = match Cli::try_parse_from(join_negative_numbers(std::env::args_os())) {
        Ok(cli) => cli,
        Err(message) => {
            // `--help` and `--version` arrive here too. A closed pipe (EPIPE) is ignored.
            let _ = message.print();
            return if message.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS };
        }
    };
    interrupt::install();
    let result = match cli.command {
        Command::Simulate(args) => simulate::run(&args),
        Command::Classify(args) => classify::run(&args),
        Command::Cases(args) => cases::run(&args),
        Command::Map(args) => map::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Atlas(args) => atlas::run(&args),
        Command::Lab(args) => lab::run(&args),
        Command::Animate(args) => animate::run(*args),
        Command::Figures(args) => figures::run(&args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error.print();
            error.exit_code()
        }
    }
}
