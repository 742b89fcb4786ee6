//! The command line as it is typed. What it means, together with a case and a scenario file, is decided in
//! [`crate::problem`].

use std::ffi::{OsStr, OsString};
use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use littlewood::Quantity;
use littlewood_sweep::Axis;

use crate::axis::parse_axis;
use crate::values::{Given, Origin};

/// Littlewood's hoop: the exact motion of a loaded hoop that rolls, slides, glides and jumps.
///
/// A hoop (or disc) of mass m1 and radius R carries a particle of mass m2 at the distance l from its centre and moves
/// on a rough horizontal plane. Every slip, stick, lift-off and landing is located to the last digits. Equation
/// numbers refer to Bronars and O'Reilly, Proc. R. Soc. A 475, 2019.
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
  littlewood map figure-3 --x theta=-pi:pi:1000 --y theta_rate=-4:4:1000 --out map.png";

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Follow a motion to its end: phases, transitions, outcome
    #[command(long_about = SIMULATE, after_help = SIMULATE_EXAMPLES)]
    Simulate(Box<SimulateArgs>),
    /// Say in which region a start lies and what begins there, without following the motion
    #[command(long_about = CLASSIFY, after_help = CLASSIFY_EXAMPLES)]
    Classify(Box<ClassifyArgs>),
    /// List the named cases: the motions that the paper shows or speaks of
    Cases(CasesArgs),
    /// Follow the starts of a plane of two quantities: a picture, or a store for xarray or a data frame
    #[command(long_about = MAP, after_help = MAP_EXAMPLES)]
    Map(Box<MapArgs>),
    /// Follow the starts of a grid with any number of axes, or of a list
    #[command(long_about = SWEEP, after_help = SWEEP_EXAMPLES)]
    Sweep(Box<SweepArgs>),
    /// Count the sequences of phases that occur on a grid of starts, with an example of each
    #[command(long_about = ATLAS, after_help = ATLAS_EXAMPLES)]
    Atlas(Box<AtlasArgs>),
    /// Draw the figures of the paper, and more, of its hoops or of any other
    #[command(long_about = FIGURES, after_help = FIGURES_EXAMPLES)]
    Figures(Box<FiguresArgs>),
}

const FIGURES: &str = "\
Draw the figures of the paper, and more, of its hoops or of any other.

Every figure is computed from the library's results. It is made of its own case (figure-3 for a hoop with inertia, \
figure-7 for the massless one) unless --case, --scenario or flags ask for another hoop or start. Without names all \
figures are drawn that the hoop has; figures 4 to 7 show the massless hoop.

Each figure is written as SVG, PNG, CSV (the data drawn) and TXT (the caption) into --out. Nothing is written unless \
all can be drawn; a file is replaced only once it is complete.";

const FIGURES_EXAMPLES: &str = "\
Examples:
  littlewood figures --out figures
  littlewood figures figure-3b outcomes --out figures --format svg,csv
  littlewood figures --mass-ratio 2 --inertia 2 --mu-s 0.7 --out heavier
  littlewood figures figure-2b --out print --format png --scale 6.25";

const MAP: &str = "\
Follow the starts of a plane of two quantities, and keep what becomes of each.

An axis is NAME=FROM:TO:COUNT, both ends included; NAME is one of theta, theta_rate, slip, mass_ratio, offset, inertia, \
mu_s and mu_k, and FROM and TO may be written with pi (-pi, pi/2, 2pi). What no axis varies comes from the case, the \
scenario or the flags, as in `simulate`; x and time start at 0 unless a scenario says otherwise.

--out takes a Zarr v3 store (.zarr), a folder of Parquet files (.parquet) or a picture (.png), once for each that is \
wanted. Stores are written chunk by chunk. Ctrl-C leaves what is finished, with exit code 130, and --resume goes on \
from there.";

const MAP_EXAMPLES: &str = "\
Examples:
  littlewood map figure-3 --x theta=-pi:pi:1000 --y theta_rate=-4:4:1000 --out plane.zarr --out plane.png
  littlewood map figure-3 --x theta=-pi:pi:500 --y mu_s=0.4:2:500 --out jumps.png --shade jump_length";

const SWEEP: &str = "\
Follow the starts of a grid with any number of axes (see `littlewood map --help`), the last running fastest, or of a \
list.

A list is a CSV file with a header, or a Parquet file; its columns are named as axes are, and what has no column comes \
from the case, the scenario or the flags. --out takes a folder of Parquet files (.parquet), or for a grid a Zarr v3 \
store (.zarr).";

const SWEEP_EXAMPLES: &str = "\
Examples:
  littlewood sweep figure-3 --axis mu_s=0.4:1:7 --axis theta=-pi:pi:100 --axis theta_rate=-4:4:100 --out grid.zarr
  littlewood sweep figure-3 --starts starts.csv --out starts.parquet";

const ATLAS: &str = "\
Count the sequences of phases that occur on a grid of starts, with an example of each.

R is rolling, + and - sliding, g, n and G gliding, F flight. Without --axis the grid is theta=-pi:pi:200 and \
theta_rate=-4:4:200. With --first-turn a motion is followed as Theron and Maritz do (2008): from the top, with mu_k = \
mu_s, to one revolution, to the instant when theta' changes sign, or to lift-off; the grid is then theta_rate=0.01:2:200 \
and mu_s=0.01:2:200.";

const ATLAS_EXAMPLES: &str = "\
Examples:
  littlewood atlas figure-3
  littlewood atlas figure-3 --first-turn --axis theta_rate=0.01:2:400 --axis mu_s=0.01:2:400 --format json";

const SIMULATE: &str = "\
Follow a motion to its end: phases, transitions, outcome.

The motion is a named case, or parameters, or a scenario file; flags override the values of both. Five numbers define \
the hoop (2.9), and theta and theta' the start; slip, x and time are 0 unless given. Without --until the motion is \
followed to a final outcome: a landing, rolling for ever, or a state beyond which the model has no unique motion. \
Each of these is a result, with exit code 0. Bad input has exit code 2, a failure to write 1.";

const SIMULATE_EXAMPLES: &str = "\
Examples:
  littlewood simulate figure-3
  littlewood simulate figure-3 --theta-rate -2 --until 3
  littlewood simulate --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 \\
      --theta 1.5707963267948966 --theta-rate 2 --format json
  littlewood simulate --si --disc-mass-kg 0.4 --particle-mass-kg 0.14 --radius-m 0.45 \\
      --offset-m 0.45 --inertia-kg-m2 0.081 --mu-s 0.5 --mu-k 0.4 \\
      --theta 1.2 --theta-rate-rad-per-s 6
  littlewood simulate --scenario hoop.toml --samples 500 --out hoop.csv";

const CLASSIFY: &str = "\
Say in which region a start lies and what begins there, without following the motion.

The regions are those of (2.14) and (3.10); for Littlewood's massless hoop the type I, II or III of its rolling motion \
(section 3a) is given too. Takes the hoop and the start as `simulate` does.";

const CLASSIFY_EXAMPLES: &str = "\
Examples:
  littlewood classify figure-3
  littlewood classify figure-3 --theta -.7 --theta-rate 1.6 --format json";

/// Arguments of `littlewood simulate`.
#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Output format [default: by the ending of --out, else table]
    #[arg(long, value_enum, help_heading = "Output")]
    pub(crate) format: Option<Format>,
    /// Add N instants, evenly spaced in time, and every transition between them. A motion without an end is sampled
    /// for two periods of its last phase (10 units of time if that has no period), or to --until
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(2..=10_000_000),
          help_heading = "Output")]
    pub(crate) samples: Option<u64>,
    /// Write to this file; it is replaced only once everything has been written
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) out: Option<PathBuf>,
}

/// Arguments of `littlewood classify`.
#[derive(Debug, Args)]
pub(crate) struct ClassifyArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs,
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

/// Arguments of `littlewood map`.
#[derive(Debug, Args)]
pub(crate) struct MapArgs {
    /// Axis to the right
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis)]
    pub(crate) x: Axis,
    /// Axis upwards
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis)]
    pub(crate) y: Axis,
    #[command(flatten)]
    pub(crate) base: BaseArgs,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    #[command(flatten)]
    pub(crate) work: WorkArgs,
    #[command(flatten)]
    pub(crate) store: StoreArgs,
    /// What the colours of a picture show: outcome, or a column such as lift_off_time or jump_length
    #[arg(long, value_name = "COLUMN", default_value = "outcome", help_heading = "Output")]
    pub(crate) shade: String,
    /// Size of a picture in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1500x1000", value_parser = size,
          help_heading = "Output")]
    pub(crate) size: (u32, u32),
}

/// Arguments of `littlewood sweep`.
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// An axis of the grid; give one or more, the slowest first
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis,
          required_unless_present = "starts", conflicts_with = "starts")]
    pub(crate) axis: Vec<Axis>,
    /// A list of starts, .csv or .parquet
    #[arg(long, value_name = "FILE")]
    pub(crate) starts: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) base: BaseArgs,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    #[command(flatten)]
    pub(crate) work: WorkArgs,
    #[command(flatten)]
    pub(crate) store: StoreArgs,
}

/// Arguments of `littlewood atlas`.
#[derive(Debug, Args)]
pub(crate) struct AtlasArgs {
    /// An axis of the grid; give one or more
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis)]
    pub(crate) axis: Vec<Axis>,
    /// Follow each motion for its first turn, with mu_k = mu_s, from the top unless --theta or an axis says otherwise
    #[arg(long, conflicts_with_all = ["until", "until_s", "max_transitions"])]
    pub(crate) first_turn: bool,
    #[command(flatten)]
    pub(crate) base: BaseArgs,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    #[command(flatten)]
    pub(crate) work: WorkArgs,
    /// Format of what is printed
    #[arg(long, value_enum, default_value_t = ShortFormat::Table, help_heading = "Output")]
    pub(crate) format: ShortFormat,
}

/// Arguments of `littlewood figures`.
#[derive(Debug, Args)]
pub(crate) struct FiguresArgs {
    /// Figures to draw, see --list [default: all that the hoop has]
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<String>,
    /// List the figures: name, the case each is made of, what it shows
    #[arg(long, exclusive = true)]
    pub(crate) list: bool,
    /// Named case to take instead of each figure's own, see `littlewood cases`
    #[arg(long, value_name = "CASE", conflicts_with = "scenario")]
    case: Option<String>,
    /// Scenario file (TOML): case, [hoop], [start], [run], or [si.hoop] and [si.start]
    #[arg(long, value_name = "FILE")]
    scenario: Option<PathBuf>,
    #[command(flatten)]
    hoop: HoopArgs,
    #[command(flatten)]
    start: StartArgs,
    #[command(flatten)]
    si: SiArgs,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Folder for the files; it is made if it is not there
    #[arg(long, value_name = "DIR", required_unless_present = "list", help_heading = "Output")]
    pub(crate) out: Option<PathBuf>,
    /// Formats, with commas between them
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        default_values = ["svg", "png", "csv", "txt"],
        help_heading = "Output"
    )]
    pub(crate) format: Vec<FigureFormat>,
    /// Pixels of a PNG to one of the drawing (1/96 inch): 3.125 makes 300 dpi, 6.25 makes 600
    #[arg(long, value_name = "FACTOR", value_parser = number, default_value_t = 2.0, help_heading = "Output")]
    pub(crate) scale: f64,
}

impl FiguresArgs {
    /// The same as `simulate` has it, with a case if none is asked for.
    pub(crate) fn to_problem(&self, case: &str) -> ProblemArgs {
        let case = match (&self.case, &self.scenario) {
            (Some(case), _) => Some(case.clone()),
            (None, Some(_)) => None,
            (None, None) => Some(case.to_owned()),
        };
        ProblemArgs {
            case,
            scenario: self.scenario.clone(),
            hoop: self.hoop.clone(),
            start: self.start.clone(),
            place: PlaceArgs::default(),
            si: self.si.clone(),
        }
    }
}

/// A format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FigureFormat {
    /// Drawing
    Svg,
    /// Picture of that drawing
    Png,
    /// Data that it shows
    Csv,
    /// Caption
    Txt,
}

/// How to share the work.
#[derive(Debug, Args)]
#[command(next_help_heading = "Work")]
pub(crate) struct WorkArgs {
    /// Number of threads; the result does not depend on it [default: all cores]
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<NonZeroUsize>,
    /// Starts of a chunk, at most
    #[arg(long, value_name = "N", default_value_t = littlewood_sweep::CHUNK_POINTS,
          value_parser = chunk)]
    pub(crate) chunk: usize,
}

/// Where results go.
#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct StoreArgs {
    /// Where to; the ending says what it is
    #[arg(long, value_name = "PATH", required = true)]
    pub(crate) out: Vec<PathBuf>,
    /// Go on with a store that was not finished; that of other parameters is refused
    #[arg(long)]
    pub(crate) resume: bool,
    /// Format of the summary
    #[arg(long, value_enum, default_value_t = ShortFormat::Table)]
    pub(crate) format: ShortFormat,
}

/// How to print a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
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

/// A hoop and a start, in whatever way they are given.
#[derive(Debug, Args)]
pub(crate) struct ProblemArgs {
    /// Named case, see `littlewood cases`
    #[arg(value_name = "CASE", conflicts_with = "scenario")]
    pub(crate) case: Option<String>,
    /// Scenario file (TOML): case, [hoop], [start], [run], or [si.hoop] and [si.start]
    #[arg(long, value_name = "FILE")]
    pub(crate) scenario: Option<PathBuf>,
    #[command(flatten)]
    hoop: HoopArgs,
    #[command(flatten)]
    start: StartArgs,
    #[command(flatten)]
    place: PlaceArgs,
    #[command(flatten)]
    pub(crate) si: SiArgs,
}

/// A hoop and a start as a sweep takes them: `--x` is free for an axis.
#[derive(Clone, Debug, Args)]
pub(crate) struct BaseArgs {
    /// Named case, see `littlewood cases`
    #[arg(value_name = "CASE", conflicts_with = "scenario")]
    case: Option<String>,
    /// Scenario file (TOML): case, [hoop], [start], [run], or [si.hoop] and [si.start]
    #[arg(long, value_name = "FILE")]
    scenario: Option<PathBuf>,
    #[command(flatten)]
    hoop: HoopArgs,
    #[command(flatten)]
    start: StartArgs,
    #[command(flatten)]
    si: SiArgs,
}

impl BaseArgs {
    /// The same as `simulate` has it.
    pub(crate) fn to_problem(&self) -> ProblemArgs {
        let Self { case, scenario, hoop, start, si } = self.clone();
        ProblemArgs { case, scenario, hoop, start, place: PlaceArgs::default(), si }
    }
}

impl ProblemArgs {
    /// The numbers of the hoop and the start that were typed.
    pub(crate) fn given(&self) -> Vec<Given> {
        let Self { hoop, start, place, si, .. } = self;
        flags([
            (Quantity::MassRatio, hoop.mass_ratio),
            (Quantity::Offset, hoop.offset),
            (Quantity::Inertia, hoop.inertia),
            (Quantity::MuS, hoop.mu_s),
            (Quantity::MuK, hoop.mu_k),
            (Quantity::Theta, start.theta),
            (Quantity::ThetaRate, start.theta_rate),
            (Quantity::Slip, start.slip),
            (Quantity::X, place.x),
            (Quantity::Time, place.time),
            (Quantity::DiscMassKg, si.disc_mass_kg),
            (Quantity::ParticleMassKg, si.particle_mass_kg),
            (Quantity::RadiusM, si.radius_m),
            (Quantity::OffsetM, si.offset_m),
            (Quantity::InertiaKgM2, si.inertia_kg_m2),
            (Quantity::GravityMPerS2, si.gravity_m_per_s2),
            (Quantity::ThetaRateRadPerS, si.theta_rate_rad_per_s),
            (Quantity::SlipMPerS, si.slip_m_per_s),
            (Quantity::XM, si.x_m),
            (Quantity::TimeS, si.time_s),
        ])
    }
}

/// The hoop, without dimensions (2.9).
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Hoop (dimensionless, 2.9)")]
struct HoopArgs {
    /// Mass of the disc over that of the particle, m1/m2 >= 0
    #[arg(long, value_name = "RATIO", value_parser = number)]
    mass_ratio: Option<f64>,
    /// Distance of the particle from the centre, l/R, 0 to 1
    #[arg(long, value_name = "RATIO", value_parser = number)]
    offset: Option<f64>,
    /// Moment of inertia of the disc about its centre, Izz/(m2 R^2) >= 0; 0 together with --mass-ratio 0 is
    /// Littlewood's massless hoop
    #[arg(long, value_name = "RATIO", value_parser = number)]
    inertia: Option<f64>,
    /// Coefficient of static friction (2.13), with SI parameters too
    #[arg(long, value_name = "MU", value_parser = number)]
    mu_s: Option<f64>,
    /// Coefficient of kinetic friction (2.15), from 0 to that of static friction, with SI parameters too
    #[arg(long, value_name = "MU", value_parser = number)]
    mu_k: Option<f64>,
}

/// The start, without dimensions (2.9).
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Start (dimensionless, 2.9)")]
struct StartArgs {
    /// Angle theta of the particle from the upward vertical, counterclockwise, with SI parameters too
    #[arg(long, visible_alias = "theta-rad", value_name = "RAD", value_parser = number)]
    theta: Option<f64>,
    /// Rate theta' in sqrt(g/R) rad
    #[arg(long, value_name = "RATE", value_parser = number)]
    theta_rate: Option<f64>,
    /// Slip velocity eta' of the contact point (2.7) in sqrt(g R) [default: 0]
    #[arg(long, value_name = "VELOCITY", value_parser = number)]
    slip: Option<f64>,
}

/// Where and when the start is, which no motion depends on.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Start (dimensionless, 2.9)")]
struct PlaceArgs {
    /// Horizontal position of the centre in R [default: 0]
    #[arg(long, value_name = "LENGTH", value_parser = number)]
    x: Option<f64>,
    /// Time of the start, tau, in sqrt(R/g) [default: 0]
    #[arg(long, value_name = "TIME", value_parser = number)]
    time: Option<f64>,
}

/// Hoop and start in SI units.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "SI units (instead of the dimensionless flags)")]
pub(crate) struct SiArgs {
    /// Take and show SI units; any of the flags below implies it. With a named case, --particle-mass-kg and
    /// --radius-m say how large it is
    #[arg(long)]
    pub(crate) si: bool,
    /// Mass m1 of the disc or hoop, kg
    #[arg(long, value_name = "KG", value_parser = number)]
    disc_mass_kg: Option<f64>,
    /// Mass m2 of the particle, kg
    #[arg(long, value_name = "KG", value_parser = number)]
    particle_mass_kg: Option<f64>,
    /// Outer radius R, m
    #[arg(long, value_name = "M", value_parser = number)]
    radius_m: Option<f64>,
    /// Distance l of the particle from the centre, m, 0 to R
    #[arg(long, value_name = "M", value_parser = number)]
    offset_m: Option<f64>,
    /// Moment of inertia Izz of the disc about its centre, kg m^2
    #[arg(long, value_name = "KG_M2", value_parser = number)]
    inertia_kg_m2: Option<f64>,
    /// Gravitational acceleration g, m/s^2 [default: 9.80665]
    #[arg(long, value_name = "M_PER_S2", value_parser = number)]
    gravity_m_per_s2: Option<f64>,
    /// Rate d theta/dt, rad/s
    #[arg(long, value_name = "RAD_PER_S", value_parser = number)]
    theta_rate_rad_per_s: Option<f64>,
    /// Slip velocity of the contact point, m/s [default: 0]
    #[arg(long, value_name = "M_PER_S", value_parser = number)]
    slip_m_per_s: Option<f64>,
    /// Horizontal position of the centre, m [default: 0]
    #[arg(long, value_name = "M", value_parser = number)]
    x_m: Option<f64>,
    /// Time of the start, s [default: 0]
    #[arg(long, value_name = "S", value_parser = number)]
    time_s: Option<f64>,
}

/// When to stop.
#[derive(Debug, Args)]
#[command(next_help_heading = "Limits")]
pub(crate) struct RunArgs {
    /// Stop at this time tau, in sqrt(R/g) [default: run to a final outcome]
    #[arg(long, value_name = "TIME", value_parser = number)]
    until: Option<f64>,
    /// Stop at this time in SI units, s
    #[arg(long, value_name = "S", value_parser = number)]
    until_s: Option<f64>,
    /// Stop after this many transitions. Only equal coefficients of friction can need it: there slips may shrink
    /// without end [default: 10000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) max_transitions: Option<u64>,
}

impl RunArgs {
    /// The time limit that was typed.
    pub(crate) fn given(&self) -> Vec<Given> {
        flags([(Quantity::Until, self.until), (Quantity::UntilS, self.until_s)])
    }
}

fn flags<const N: usize>(pairs: [(Quantity, Option<f64>); N]) -> Vec<Given> {
    pairs
        .into_iter()
        .filter_map(|(quantity, value)| value.map(|value| Given { quantity, value, origin: Origin::Flag }))
        .collect()
}

/// A number after a flag.
fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "this is not a number".to_owned())
}

/// A size in pixels, as `1500x1000`.
fn size(text: &str) -> Result<(u32, u32), String> {
    let parse = |side: &str| side.parse().ok();
    text.split_once('x')
        .and_then(|(width, height)| Some((parse(width)?, parse(height)?)))
        .ok_or_else(|| "a size is WIDTHxHEIGHT in pixels, such as 1500x1000".to_owned())
}

/// A number of points of a chunk.
fn chunk(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count @ 1..=16_777_216) => Ok(count),
        _ => Err("a chunk has 1 to 16777216 starts".to_owned()),
    }
}

/// Joins a flag and the negative number after it, `--slip -.5` to `--slip=-.5`.
///
/// The parser could be told to take whatever follows a flag, but then it takes the next flag too when the number is
/// missing; and what it holds to be a negative number does not include `-.5`.
pub(crate) fn join_negative_numbers(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut joined: Vec<OsString> = Vec::new();
    for argument in arguments {
        let is_negative =
            argument.to_str().is_some_and(|text| text.starts_with('-') && text.parse::<f64>().is_ok());
        match joined.last_mut().filter(|last| is_negative && is_open_flag(last)) {
            Some(flag) => {
                flag.push("=");
                flag.push(argument);
            }
            None => joined.push(argument),
        }
    }
    joined
}

/// Whether the argument is a flag without a value of its own.
fn is_open_flag(argument: &OsStr) -> bool {
    argument.to_str().is_some_and(|text| text.len() > 2 && text.starts_with("--") && !text.contains('='))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_of_the_command_line_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn only_negative_numbers_are_joined_to_flags() {
        let joined =
            |text: &str| join_negative_numbers(text.split(' ').map(OsString::from)).join(OsStr::new(" "));
        assert_eq!(joined("--slip -.5 --x -1e-3"), "--slip=-.5 --x=-1e-3");
        assert_eq!(joined("--x -inf --theta -0"), "--x=-inf --theta=-0");
        assert_eq!(joined("--theta --slip 2"), "--theta --slip 2");
        assert_eq!(joined("--x=-1 -2 -- -3"), "--x=-1 -2 -- -3");
    }
}
