//! Arguments of `littlewood poster`.

use std::path::PathBuf;

use clap::Args;

use super::{ProblemArgs, RunArgs, number};

pub(super) const POSTER: &str = "\
Draw an A3 poster of a hoop: large the hoop at equal intervals of time with its forces, beside it \
the map of outcomes and the phase portrait, below its body, forces, energy and laws of motion.

The motion is given as in `simulate`. A figure that does not apply to the hoop is replaced by \
another, or by the reason. The extension of --out chooses the format: .pdf, .svg or .png.

With --chart it is a wall chart of the paper, A2: its figures and its main results.";

pub(super) const POSTER_EXAMPLES: &str = "\
Examples:
  littlewood poster figure-3 --out poster.pdf
  littlewood poster figure-7 --out massless.png --scale 3
  littlewood poster --chart --out chart.pdf
  littlewood poster --mass-ratio 2 --offset 0.8 --inertia 2 --mu-s 0.7 --mu-k 0.5 --theta 1 \\
      --theta-rate 2 --out mine.svg";

/// Arguments of `littlewood poster`.
#[derive(Debug, Args)]
pub(crate) struct PosterArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// The figures of the paper and its main results on one page (A2), instead of one hoop
    #[arg(long, help_heading = "Output")]
    pub(crate) chart: bool,
    /// Poster, .pdf, .svg or .png; an existing file is replaced once the drawing is complete
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) out: PathBuf,
    /// Pixels of a PNG for 1/96 inch of the poster: 2 gives 192 dpi
    #[arg(
        long,
        value_name = "FACTOR",
        value_parser = number,
        default_value_t = 2.0,
        help_heading = "Output"
    )]
    pub(crate) scale: f64,
}
