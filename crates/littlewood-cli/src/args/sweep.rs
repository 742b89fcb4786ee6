//! What `map` and `sweep` take.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

use littlewood::tables::{DerivativeColumn, Quantity};
use littlewood_sweep::{CHUNK_POINTS, MOST_CHUNK_POINTS};

use super::{ProblemArgs, RunArgs, ShortFormat, number};
use crate::axis::{TypedAxis, parse_axis, si_quantities};

/// The promise of runs of many starts, for the help of `map` and `sweep`.
const INTERPOLATED: &str = "\
For a hoop with 256 or more starts, long chains of slips are interpolated \
(`EngineBuilder::interpolate_slips` of the library): the map from one slip to the next is computed \
at nodes, checked halfway between them and not proved elsewhere, so that a phase, and with it an \
outcome, could be missed. The tests search for such a motion and have found none. `simulate` \
solves every slip.";

/// What `littlewood map --help` says.
pub(super) fn map() -> String {
    let names = |quantities: Vec<Quantity>, between: &str| {
        let mut names: Vec<&str> = quantities.into_iter().map(Quantity::name).collect();
        let last = names.pop().unwrap_or_default();
        format!("{} {between} {last}", names.join(", "))
    };
    format!(
        "\
Simulate a 2-D grid of starts and record the outcome of each.

An axis is NAME=FROM:TO:COUNT, evenly spaced with both ends included, or NAME=FROM:TO:COUNT:log, \
logarithmically spaced. NAME is one of {}, or mu for static and kinetic friction together; FROM \
and TO may be written with pi (-pi, pi/2, 2pi). With --particle-mass-kg and --radius-m it may also \
be {}; results stay dimensionless. Quantities without an axis come from the case, the scenario or \
the flags, as in `simulate`; x and time start at 0 unless a scenario gives them.

--out takes a picture (.png, or as vectors .svg and, with the feature `figures`, .pdf), a text \
(.csv), a Zarr v3 store (.zarr) or a Parquet file (.parquet); repeat it for several. Each motion \
is simulated once. Zarr and Parquet need the feature `sweep`. A text has at most 1,048,576 starts. \
With more than 16,777,216 starts .parquet is a folder of files, which readers open as one table.

Results are written chunk by chunk. Ctrl-C keeps finished chunks, and --resume continues from \
them: a store can be read at any time, a table is in NAME.parquet.parts until it is complete, and \
an incomplete picture is NAME.partial.png (a text NAME.partial.csv). A picture or a text alone \
cannot be resumed.

{INTERPOLATED}",
        names(Quantity::AXES.to_vec(), "and"),
        names(si_quantities().collect(), "or"),
    )
}

pub(super) const MAP_EXAMPLES: &str = "\
Examples:
  littlewood map figure-3 --x theta=-pi:pi:1000 --y theta_rate=-4:4:1000 --out plane.zarr \\
      --out plane.png
  littlewood map figure-3 --x theta=-pi:pi:500 --y mu_s=0.4:2:500 --shade jump_length \\
      --out jumps.png
  littlewood map figure-3 --x theta=-pi:pi:500 --y theta_rate=-4:4:500 --shade sequence --curves \\
      --out phases.png
  littlewood map figure-3 --x theta_rate=0:3:300 --y mu=0.01:2:300:log --shade energy_lost \\
      --out lost.png
  littlewood map figure-3 --x theta=-pi:pi:300 --y theta_rate=-4:4:300 --width-mm 84 \\
      --out outcomes.pdf
  littlewood map figure-3 --x theta=-pi:pi:150 --y theta_rate=-4:4:150 --shade end_x_by_mu_k \\
      --out sensitivity.png
  littlewood map --scenario hoop.toml --x theta=-pi:pi:500 \\
      --y theta_rate_rad_per_s=0:20:500 --out hoop.png";

/// What `littlewood sweep --help` says.
#[cfg(feature = "sweep")]
pub(super) fn sweep() -> String {
    format!(
        "\
Simulate a grid of starts with any number of axes (see `littlewood map --help`), the last varying \
fastest, or a list of starts.

A list is a CSV file with a header; its columns have the names of axes, or are x and time; other \
quantities come from the case, the scenario or the flags. --out takes a Parquet file (.parquet), \
or for a grid a Zarr v3 store (.zarr); the rows of a table are in the order of the list. With more \
than 16,777,216 starts .parquet is a folder of files, which readers open as one table. Ctrl-C \
keeps finished chunks, and --resume continues from them; until a table is complete it is in \
NAME.parquet.parts.

{INTERPOLATED}"
    )
}

#[cfg(feature = "sweep")]
pub(super) const SWEEP_EXAMPLES: &str = "\
Examples:
  littlewood sweep figure-3 --axis mu_s=0.4:1:7 --axis theta=-pi:pi:100 \\
      --axis theta_rate=-4:4:100 --out grid.zarr
  littlewood sweep figure-3 --starts starts.csv --out motions.parquet";

/// Arguments of `littlewood map`.
#[derive(Debug, Args)]
pub(crate) struct MapArgs {
    /// Axis to the right
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis)]
    pub(crate) x: TypedAxis,
    /// Axis upwards
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis)]
    pub(crate) y: TypedAxis,
    #[command(flatten)]
    pub(crate) base: ProblemArgs<false>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    #[command(flatten)]
    pub(crate) work: WorkArgs,
    #[command(flatten)]
    pub(crate) store: StoreArgs,
    /// Column shown by colour: outcome, sequence, energy_lost, a column such as transitions,
    /// landings (hops), lift_off_time or jump_length, or the size of a derivative such as
    /// end_x_by_mu_k
    #[arg(
        long,
        value_name = "COLUMN",
        default_value = "outcome",
        help_heading = "Output"
    )]
    pub(crate) shade: String,
    /// Draw the curves f (|F| = mu_s N in rolling), n (N = 0 in rolling) and the lift-off curve
    /// over a map of theta and theta_rate
    #[arg(long, help_heading = "Output")]
    pub(crate) curves: bool,
    /// Printed width in millimetres, such as 84 for a column and 178 for a page; a PNG then has 300
    /// pixels to the inch [default: the layout for a screen]
    #[arg(long, value_name = "MM", value_parser = number, help_heading = "Output")]
    pub(crate) width_mm: Option<f64>,
    /// Size of a PNG in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1500x1000", value_parser = size,
          conflicts_with = "width_mm", help_heading = "Output")]
    pub(crate) size: (u32, u32),
}

/// Arguments of `littlewood sweep`.
#[cfg(feature = "sweep")]
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// An axis of the grid; give one or more, the slowest first
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = parse_axis,
          required_unless_present = "starts", conflicts_with = "starts")]
    pub(crate) axis: Vec<TypedAxis>,
    /// A list of starts, .csv
    #[arg(long, value_name = "FILE")]
    pub(crate) starts: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) base: ProblemArgs<false>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    #[command(flatten)]
    pub(crate) work: WorkArgs,
    #[command(flatten)]
    pub(crate) store: StoreArgs,
}

/// How to share the work.
#[derive(Debug, Args)]
#[command(next_help_heading = "Work")]
pub(crate) struct WorkArgs {
    /// Number of threads, at most 1024; the result does not depend on it [default: all cores]
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<NonZeroUsize>,
    /// Starts in a chunk, at most 1048576
    #[arg(long, value_name = "N", default_value_t = CHUNK_POINTS,
          value_parser = chunk)]
    pub(crate) chunk: usize,
}

/// Where results go.
#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct StoreArgs {
    /// Output file (repeatable); the extension chooses the format
    #[arg(long, value_name = "PATH", required = true)]
    pub(crate) out: Vec<PathBuf>,
    /// Derivatives of columns with respect to quantities of the hoop or the start, separated by
    /// commas, such as jump_length_by_mu_k,end_x_by_theta. A derivative that does not exist is
    /// empty in a text, null in a table and NaN in a store
    #[arg(long, value_name = "COLUMN_by_QUANTITY", value_delimiter = ',')]
    pub(crate) derivatives: Vec<DerivativeColumn>,
    /// Resume an interrupted run; parameters must match
    #[arg(long)]
    pub(crate) resume: bool,
    /// Format of the summary
    #[arg(long, value_enum, default_value_t = ShortFormat::Table)]
    pub(crate) format: ShortFormat,
}

/// A size in pixels, as `1500x1000`.
pub(crate) fn size(text: &str) -> Result<(u32, u32), String> {
    let parse = |side: &str| side.parse().ok();
    text.split_once('x')
        .and_then(|(width, height)| Some((parse(width)?, parse(height)?)))
        .ok_or_else(|| "a size is WIDTHxHEIGHT in pixels, such as 1500x1000".to_owned())
}

/// A number of points of a chunk.
fn chunk(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count @ 1..=MOST_CHUNK_POINTS) => Ok(count),
        _ => Err(format!("a chunk has 1 to {MOST_CHUNK_POINTS} starts")),
    }
}
