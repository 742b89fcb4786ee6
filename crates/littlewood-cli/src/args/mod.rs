//! The command line as it is typed. [`crate::problem`] combines it with a case and a scenario file.

#[cfg(feature = "film")]
mod animate;
mod elsewhere;
mod errors;
#[cfg(feature = "figures")]
mod figures;
#[cfg(feature = "lab")]
mod lab;
mod negative;
#[cfg(feature = "figures")]
mod poster;
mod problem;
mod quantity;
mod sweep;
mod threshold;

#[cfg(feature = "film")]
pub(crate) use animate::AnimateArgs;
pub(crate) use elsewhere::ElsewhereArgs;
#[cfg(not(feature = "film"))]
pub(crate) use elsewhere::ElsewhereArgs as AnimateArgs;
#[cfg(not(feature = "lab"))]
pub(crate) use elsewhere::ElsewhereArgs as LabArgs;
#[cfg(not(feature = "sweep"))]
pub(crate) use elsewhere::ElsewhereArgs as SweepArgs;
#[cfg(not(feature = "figures"))]
pub(crate) use elsewhere::{ElsewhereArgs as FiguresArgs, ElsewhereArgs as PosterArgs};
pub(crate) use errors::Names;
#[cfg(feature = "figures")]
pub(crate) use figures::{FigureFormat, FiguresArgs};
#[cfg(feature = "lab")]
pub(crate) use lab::LabArgs;
pub(crate) use negative::join_negative_numbers;
#[cfg(feature = "figures")]
pub(crate) use poster::PosterArgs;
pub(crate) use problem::{MAX_SLIDES, MAX_TRANSITIONS, ProblemArgs, RunArgs, number};
#[cfg(feature = "sweep")]
pub(crate) use sweep::SweepArgs;
#[cfg(feature = "film")]
pub(crate) use sweep::size;
pub(crate) use sweep::{MapArgs, WorkArgs};
pub(crate) use threshold::{ThresholdArgs, ThresholdOf};

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use littlewood::tables::Quantity;
use littlewood_report::Sampling;

/// Littlewood's hoop: the exact motion of a loaded hoop that rolls, slides, glides and jumps.
///
/// A hoop (or disc) of mass m1 and radius R carries a particle of mass m2 at the distance l from
/// its centre and moves on a rough plane, horizontal or sloping. Each slip, stick, lift-off and
/// landing is located to machine precision. Equation numbers refer to Bronars and O'Reilly, Proc.
/// R. Soc. A 475, 2019.
#[derive(Debug, Parser)]
#[command(name = "littlewood", version, arg_required_else_help = true, after_help = EXAMPLES)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  littlewood simulate figure-3
  littlewood simulate figure-3 --mu-k 0.3 --format json
  littlewood cases
  littlewood classify figure-7
  littlewood map figure-3 --x theta=-pi:pi:1000 --y theta_rate=-4:4:1000 --out map.png

An output file needs an existing folder.

Exit codes: 0 for every result; 1 for failures of the system, such as a full disk; 2 for bad \
input, such as an output that cannot be written; 130 after Ctrl-C or a signal such as SIGTERM, \
which removes unfinished files (a second signal exits at once).";

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Simulate a motion to its end: phases, transitions, outcome
    #[command(long_about = SIMULATE, after_help = SIMULATE_EXAMPLES)]
    Simulate(Box<SimulateArgs>),
    /// Classify a start: its region and the motion that begins there, without simulating it
    #[command(long_about = CLASSIFY, after_help = CLASSIFY_EXAMPLES)]
    Classify(Box<ClassifyArgs>),
    /// Find the value of a quantity at which the outcome of a motion changes, to the last digit
    #[command(long_about = threshold::THRESHOLD, after_help = threshold::THRESHOLD_EXAMPLES)]
    Threshold(Box<ThresholdArgs>),
    /// List the named cases: motions that the paper shows or discusses
    Cases(CasesArgs),
    /// Simulate a 2-D grid of starts: a picture, or a store for xarray or data frames
    #[command(long_about = sweep::map(), after_help = sweep::MAP_EXAMPLES)]
    Map(Box<MapArgs>),
    /// Simulate a grid of starts with any number of axes, or a list
    #[cfg_attr(
        feature = "sweep",
        command(long_about = sweep::sweep(), after_help = sweep::SWEEP_EXAMPLES)
    )]
    #[cfg_attr(not(feature = "sweep"), doc = "(requires the feature `sweep`)")]
    Sweep(Box<SweepArgs>),
    /// Draw the figures of the paper and others, for any hoop
    #[cfg_attr(
        feature = "figures",
        command(long_about = figures::FIGURES, after_help = figures::FIGURES_EXAMPLES)
    )]
    #[cfg_attr(not(feature = "figures"), doc = "(requires the feature `figures`)")]
    Figures(Box<FiguresArgs>),
    /// Draw a poster of a hoop, its motion and its laws
    #[cfg_attr(
        feature = "figures",
        command(long_about = poster::POSTER, after_help = poster::POSTER_EXAMPLES)
    )]
    #[cfg_attr(not(feature = "figures"), doc = "(requires the feature `figures`)")]
    Poster(Box<PosterArgs>),
    /// Make a film of a motion: GIF, MP4 or WebM
    #[cfg_attr(
        feature = "film",
        command(long_about = animate::ANIMATE, after_help = animate::ANIMATE_EXAMPLES)
    )]
    #[cfg_attr(not(feature = "film"), doc = "(requires the feature `film`)")]
    Animate(Box<AnimateArgs>),
    /// Open the laboratory in the browser: drag a start and watch the hoop
    #[cfg_attr(feature = "lab", command(long_about = lab::LAB))]
    #[cfg_attr(not(feature = "lab"), doc = "(requires the feature `lab`)")]
    Lab(LabArgs),
    /// Measure friction, inertia and restitution from a film or a track (in the Python package)
    Fit(ElsewhereArgs),
    /// Score a solver against the exact motion (in the Python package)
    Score(ElsewhereArgs),
    /// Certify a motion by ball arithmetic, with a proof that no event is missed (in the Python
    /// package)
    Certify(ElsewhereArgs),
    /// Removed: `map --shade sequence` shows the sequences of phases
    #[command(hide = true)]
    Atlas(ElsewhereArgs),
}

const SIMULATE: &str = "\
Simulate a motion to its end: phases, transitions, outcome.

The motion is given by a named case, a scenario file or flags; flags override the others. Without \
a case or a scenario, give the mass ratio, the offset, the inertia and the two coefficients of \
friction of the hoop (2.9), and theta and theta' of the start; everything else has a default.

Without --until the motion is simulated to its outcome: a landing, an endless motion, a state \
beyond which the model has no unique motion, or a limit such as --max-transitions. Each of these \
is a result, not a failure.

With --restitution the motion continues after a landing: each impact is solved exactly, with \
friction, by the law of --restitution-law, and infinitely many bounces in a finite time are \
summed. Where no motion is consistent (Painleve), the hoop then jams. With --restitution 1 bounces \
lose energy to friction only and may never end: give --until. A massless hoop cannot have \
--restitution: its rim has no inertia.";

const SIMULATE_EXAMPLES: &str = "\
Examples:
  littlewood simulate figure-3
  littlewood simulate figure-3 --theta-rate -2 --until 3
  littlewood simulate figure-3 --restitution 0.5 --restitution-law poisson
  littlewood simulate --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 \\
      --theta 1.5707963267948966 --theta-rate 2 --format json
  littlewood simulate --si --disc-mass-kg 0.4 --particle-mass-kg 0.14 --radius-m 0.45 \\
      --offset-m 0.45 --inertia-kg-m2 0.081 --mu-s 0.5 --mu-k 0.4 \\
      --theta 1.2 --theta-rate-rad-per-s 6
  littlewood simulate --scenario hoop.toml --samples 500 --out hoop.csv";

const CLASSIFY: &str = "\
Classify a start: its region and the motion that begins there, without simulating it.

The regions are those of (2.14) and (3.10); for Littlewood's massless hoop the output includes the \
type I, II or III of its rolling motion (section 3a). Takes the hoop and the start as `simulate` \
does.";

const CLASSIFY_EXAMPLES: &str = "\
Examples:
  littlewood classify figure-3
  littlewood classify figure-3 --theta -.7 --theta-rate 1.6 --format json";

/// Numbers of samples that can be asked for.
pub(crate) const SAMPLES: RangeInclusive<u64> = Sampling::COUNTS;

/// Arguments of `littlewood simulate`.
#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Output format [default: by the extension of --out, .txt, .csv or .json, else table]
    #[arg(long, value_enum, help_heading = "Output")]
    pub(crate) format: Option<Format>,
    /// Sample N instants, evenly spaced in time, and every transition. An endless motion is sampled
    /// to --until, or for two periods of its last phase (10 units of time if it has no period), one
    /// that rests for a tenth longer than it moved; a motion that ends at its start has one sample
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u64).range(SAMPLES),
        help_heading = "Output"
    )]
    pub(crate) samples: Option<u64>,
    /// Print a row for every bounce and phase; by default bounces share a row and long motions are
    /// shortened
    #[arg(long, help_heading = "Output")]
    pub(crate) all_bounces: bool,
    /// Estimate how many digits of each transition are correct, from neighbouring starts and
    /// perturbed rounding
    #[arg(long, help_heading = "Output")]
    pub(crate) digits: bool,
    /// Print the dimensionless derivatives of each transition and of the outcome with respect to
    /// these quantities of the hoop and the start, separated by commas, such as mu_k,theta_rate, or
    /// all
    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        value_parser = errors::parse_names,
        help_heading = "Output"
    )]
    pub(crate) derivatives: Vec<Names>,
    /// Standard errors of quantities of the hoop and the start, such as mu_k=0.02,theta=0.5deg.
    /// Prints those of each transition and of the outcome, dimensionless, to first order and from a
    /// sample of 10,000 motions, with a warning where the two differ (table and JSON only)
    #[arg(
        long,
        value_name = "NAME=ERROR",
        value_delimiter = ',',
        value_parser = errors::parse_error,
        help_heading = "Output"
    )]
    pub(crate) uncertainty: Vec<(Quantity, f64)>,
    /// Output file; an existing file is replaced once the output is complete
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) out: Option<PathBuf>,
}

/// Arguments of `littlewood classify`.
#[derive(Debug, Args)]
pub(crate) struct ClassifyArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    /// Output format
    #[arg(long, value_enum, default_value_t = ShortFormat::Table, help_heading = "Output")]
    pub(crate) format: ShortFormat,
}

/// Arguments of `littlewood cases`.
#[derive(Debug, Args)]
pub(crate) struct CasesArgs {
    /// Output format
    #[arg(long, value_enum, default_value_t = ShortFormat::Table)]
    pub(crate) format: ShortFormat,
}

/// How to print a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For a person
    Table,
    /// One object, numbers with all digits
    Json,
    /// One row for each transition, or for each sample
    Csv,
}

/// How to print a list of facts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ShortFormat {
    /// For a person
    Table,
    /// Numbers with all digits
    Json,
}

#[cfg(test)]
mod tests {
    use super::Cli;
    use clap::CommandFactory;

    #[test]
    fn the_definition_of_the_command_line_is_sound() {
        Cli::command().debug_assert();
    }
}
