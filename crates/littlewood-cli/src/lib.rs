//! The command line of Littlewood's hoop as a library: the program `littlewood`, the Python package, which brings the same
//! program, and the generator of its manual call it. A module for each command.

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

use std::ffi::OsString;

use clap::{CommandFactory, Parser};

use crate::args::{Cli, Command, join_negative_numbers};

/// Exit code of bad input.
const BAD_INPUT: u8 = 2;

/// Runs the program with these arguments, the first of which is its name, and returns its exit code. Signals that ask it to end
/// end the process.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = match Cli::try_parse_from(join_negative_numbers(arguments.into_iter())) {
        Ok(cli) => cli,
        Err(message) => {
            // `--help` and `--version` arrive here too. A closed pipe (EPIPE) is ignored.
            let _ = message.print();
            return if message.use_stderr() { BAD_INPUT } else { 0 };
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
        Ok(()) => 0,
        Err(error) => {
            error.print();
            error.exit_code()
        }
    }
}

/// The command line as it is defined: commands, flags and their help, from which completions and manual pages are made.
#[must_use]
pub fn command() -> clap::Command {
    Cli::command()
}
