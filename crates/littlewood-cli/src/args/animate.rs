//! Arguments of `littlewood animate`.

use std::path::PathBuf;

use clap::Args;
use littlewood_film::{Framing, With};

use super::{ProblemArgs, RunArgs, number, size};

pub(super) const ANIMATE: &str = "\
Make a film of a motion: hoop, particle, contact point, gap, forces, impulses of impacts, slip \
velocity, mode and clock.

The motion is given as in `simulate`. Without --until an endless motion is shown for one \
oscillation, two periods or 10 units of time, one that rests for a tenth longer than it moved; \
the film says so.

With --beside two motions run in one clock, one over the other, each with its name; the first is \
that of the other flags, and lengths and arrows have one scale.

The extension of --out chooses the format: .gif, or .mp4 (H.264) and .webm (VP9), which need \
ffmpeg, or .png for the one frame that tells most. A GIF has the same bytes on every machine. For a presentation an .mp4 of 1280x720 has \
a megabyte or less.";

pub(super) const ANIMATE_EXAMPLES: &str = "\
Examples:
  littlewood animate figure-3 --out figure-3.gif
  littlewood animate figure-7 --slow 6 --fps 50 --size 1280x720 --out figure-7.gif
  littlewood animate libration --fps 60 --size 1920x1080 --out libration.mp4
  littlewood animate figure-3 --with plane --size 1280x720 --out plane.gif
  littlewood animate figure-3 --beside figure-7 --size 1280x720 --out two.mp4
  littlewood animate figure-3-bounces --with energy --out bounces.gif
  littlewood animate figure-3 --particle-mass-kg 0.14 --radius-m 0.45 --slow 10 --out hoop.gif";

/// Arguments of `littlewood animate`.
#[derive(Debug, Args)]
pub(crate) struct AnimateArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Film, .gif, .mp4 or .webm, or a frame, .png; an existing file is replaced once it is complete
    #[arg(long, value_name = "FILE", help_heading = "Film")]
    pub(crate) out: PathBuf,
    /// Seconds of film for a unit of time sqrt(R/g) [default: 3]; in SI units, how many times
    /// slower than real the film is [default: 10]
    #[arg(long, value_name = "FACTOR", value_parser = number, help_heading = "Film")]
    pub(crate) slow: Option<f64>,
    /// Frames per second, at most 50 for a GIF
    #[arg(long, value_name = "N", default_value_t = 25, help_heading = "Film")]
    pub(crate) fps: u32,
    /// A second motion under the first: a case, or a scenario file that ends in .toml
    #[arg(long, value_name = "CASE|FILE", help_heading = "Film")]
    pub(crate) beside: Option<String>,
    /// Size in pixels [default: 640x360; 640x600 with --beside]
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size, help_heading = "Film")]
    pub(crate) size: Option<(u32, u32)>,
    /// How the camera moves
    #[arg(long, value_enum, default_value_t, help_heading = "Film")]
    pub(crate) camera: Framing,
    /// Show a second picture beside the hoop
    #[arg(long, value_enum, help_heading = "Film")]
    pub(crate) with: Option<With>,
    /// Seconds to hold the last frame [default: 1.5; 0 for an oscillation, which loops]
    #[arg(long, value_name = "S", value_parser = number, help_heading = "Film")]
    pub(crate) hold: Option<f64>,
}
