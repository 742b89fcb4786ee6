//! The command line of Littlewood's hoop as a library: the program `littlewood`, the Python
//! package, which brings the same program, and the generator of its manual call it. A module for
//! each command.

#[cfg(feature = "film")]
mod animate;
mod args;
mod axis;
mod cases;
mod classify;
mod error;
#[cfg(feature = "figures")]
mod figures;
mod interrupt;
#[cfg(feature = "lab")]
mod lab;
mod map;
mod nearest;
mod output;
mod plane;
#[cfg(feature = "figures")]
mod poster;
mod problem;
mod progress;
mod report;
mod request;
mod scenario;
mod simulate;
mod store;
#[cfg(feature = "sweep")]
mod sweep;
mod threshold;
mod unfinished;
mod values;
mod work;

use std::ffi::OsString;

use clap::{CommandFactory, Parser};

use crate::args::{Cli, Command, join_negative_numbers};

const BAD_INPUT: u8 = 2;

const FAILURE: u8 = 1;

/// Runs the program with these arguments, the first of which is its name, and returns its exit
/// code. Signals that ask it to end end the process.
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
        Command::Threshold(args) => threshold::run(&args),
        Command::Cases(args) => cases::run(&args),
        Command::Map(args) => map::run(&args),
        #[cfg(feature = "sweep")]
        Command::Sweep(args) => sweep::run(&args),
        #[cfg(feature = "lab")]
        Command::Lab(args) => lab::run(&args),
        #[cfg(feature = "film")]
        Command::Animate(args) => animate::run(*args),
        #[cfg(feature = "figures")]
        Command::Figures(args) => figures::run(&args),
        #[cfg(feature = "figures")]
        Command::Poster(args) => poster::run(&args),
        #[cfg(not(feature = "sweep"))]
        Command::Sweep(_) => Err(not_built("sweep", "sweep")),
        #[cfg(not(feature = "lab"))]
        Command::Lab(_) => Err(not_built("lab", "lab")),
        #[cfg(not(feature = "film"))]
        Command::Animate(_) => Err(not_built("animate", "film")),
        #[cfg(not(feature = "figures"))]
        Command::Figures(_) => Err(not_built("figures", "figures")),
        #[cfg(not(feature = "figures"))]
        Command::Poster(_) => Err(not_built("poster", "figures")),
        Command::Fit(_) => Err(error::Error::InPackage { command: "fit" }),
        Command::Score(_) => Err(error::Error::InPackage { command: "score" }),
        Command::Certify(_) => Err(error::Error::InPackage { command: "certify" }),
        Command::Atlas(_) => Err(error::Error::AtlasRemoved),
    };
    match result {
        Ok(()) => 0,
        Err(error) => {
            error.print();
            error.exit_code()
        }
    }
}

#[cfg(not(all(
    feature = "sweep",
    feature = "figures",
    feature = "film",
    feature = "lab"
)))]
fn not_built(command: &str, feature: &'static str) -> error::Error {
    error::Error::NotBuilt {
        what: format!("`littlewood {command}`"),
        feature,
    }
}

/// The command line as it is defined: commands, flags and their help, from which completions and
/// manual pages are made.
pub fn command() -> clap::Command {
    Cli::command()
}
