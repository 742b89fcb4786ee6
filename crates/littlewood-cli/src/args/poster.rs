//! Arguments of `littlewood poster`.

use std::path::PathBuf;

use clap::Args;

use super::{ProblemArgs, RunArgs, number};

pub(super) const POSTER: &str = "\
Draw an A3 poster of a hoop: a map of the outcomes of its starts, its body, path, phase portrait, \
forces, energy and laws of motion.

The motion is given as in `simulate`. A figure that does not apply to the hoop is replaced by \
another, or by the reason. The extension of --out chooses the format: .pdf, .svg or .png.";

pub(super) const POSTER_EXAMPLES: &str = "\
Examples:
  littlewood poster figure-3 --out poster.pdf
  littlewood poster figure-7 --out massless.png --scale 3
  littlewood poster --mass-ratio 2 --offset 0.8 --inertia 2 --mu-s 0.7 --mu-k 0.5 --theta 1 \\
      --theta-rate 2 --out mine.svg";

/// Arguments of `littlewood poster`.
#[derive(Debug, Args)]
pub(crate) struct PosterArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Poster, .pdf, .svg or .png; an existing file is replaced once the drawing is complete
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) out: PathBuf,
    /// Pixels of a PNG for each of the 1600 units of the drawing's width: 2 gives 270 dpi
    #[arg(
        long,
        value_name = "FACTOR",
        value_parser = number,
        default_value_t = 2.0,
        help_heading = "Output"
    )]
    pub(crate) scale: f64,
}
