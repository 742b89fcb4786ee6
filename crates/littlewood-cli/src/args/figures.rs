//! Arguments of `littlewood figures`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::quantity::SetupArgs;
use super::{ProblemArgs, RunArgs, number};

pub(super) const FIGURES: &str = "\
Draw the figures of the paper, and more, of its hoops or of any other.

Each figure shows its own case (--list names it) unless --case, --scenario or flags give another \
hoop or start. Without names all figures that apply to the hoop are drawn; figures 4 to 7 apply to \
the massless hoop. With --restitution the motion continues after a landing.

Each figure is written into --out, in all formats of --format, once it is drawn; a file is replaced
only once the new one is complete. Bad input is refused before anything is written. Without names
a figure that does not apply to the hoop is left out, and standard error says why.";

pub(super) const FIGURES_EXAMPLES: &str = "\
Examples:
  littlewood figures --out figures
  littlewood figures figure-3b outcomes --out figures --format svg,csv
  littlewood figures --case libration --out libration
  littlewood figures --mass-ratio 2 --inertia 2 --mu-s 0.7 --out heavier
  littlewood figures impact bounces --case figure-3 --restitution 0.8 --impact 2 --out bounces
  littlewood figures figure-2b --out print --format png --scale 6.25";

/// Arguments of `littlewood figures`.
#[derive(Debug, Args)]
pub(crate) struct FiguresArgs {
    /// Figures to draw, see --list [default: all that apply to the hoop]
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<String>,
    /// List the figures: name, case, contents
    #[arg(long, exclusive = true)]
    pub(crate) list: bool,
    /// Named case instead of each figure's own, see `littlewood cases`; `libration` is short for
    /// figure-2-libration
    #[arg(long, value_name = "CASE", conflicts_with = "scenario")]
    case: Option<String>,
    /// Scenario file (TOML): case, [hoop], [start], [run], or [si.hoop] and [si.start]
    #[arg(long, value_name = "FILE")]
    scenario: Option<PathBuf>,
    #[command(flatten)]
    setup: SetupArgs<false>,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Which impact of the motion the figure `impact` shows, from 1
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = impact)]
    pub(crate) impact: usize,
    /// The line of the figure `bifurcation`, which was removed
    #[arg(long, value_name = "NAME=FROM:TO", hide = true)]
    pub(crate) along: Option<String>,
    /// Folder for the files; it is created if its parent exists
    #[arg(
        long,
        value_name = "DIR",
        required_unless_present = "list",
        help_heading = "Output"
    )]
    pub(crate) out: Option<PathBuf>,
    /// Formats, separated by commas
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        default_values = ["svg", "pdf", "png", "csv", "txt"],
        help_heading = "Output"
    )]
    pub(crate) format: Vec<FigureFormat>,
    /// Printed width in millimetres, such as 84 for a column and 178 for a page, with letters of 7
    /// to 8 points [default: the layout for a screen]
    #[arg(long, value_name = "MM", value_parser = number, help_heading = "Output")]
    pub(crate) width_mm: Option<f64>,
    /// Pixels of a PNG for 1/96 inch of the drawing: 3.125 gives 300 dpi, 6.25 gives 600
    #[arg(
        long,
        value_name = "FACTOR",
        value_parser = number,
        default_value_t = 2.0,
        help_heading = "Output"
    )]
    pub(crate) scale: f64,
}

/// The number of an impact.
fn impact(text: &str) -> Result<usize, String> {
    let number: usize = text
        .parse()
        .map_err(|_| "this is not a whole number from 1".to_owned())?;
    if number == 0 {
        Err("the first impact is 1".to_owned())
    } else {
        Ok(number)
    }
}

impl FiguresArgs {
    /// Whether each figure shows the hoop of its own case, as far as nothing else is asked for.
    pub(crate) const fn takes_own_cases(&self) -> bool {
        self.scenario.is_none() && self.case.is_none()
    }

    /// The same as `simulate` has it, with a case if none is asked for.
    pub(crate) fn problem(&self, case: &str) -> ProblemArgs<false> {
        let Self {
            scenario, setup, ..
        } = self;
        let own = || scenario.is_none().then(|| case.to_owned());
        ProblemArgs {
            case: self.case.clone().or_else(own),
            scenario: scenario.clone(),
            setup: setup.clone(),
        }
    }
}

/// A format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FigureFormat {
    /// Drawing
    Svg,
    /// The same drawing in pixels
    Png,
    /// The data drawn
    Csv,
    /// Caption
    Txt,
    /// Drawing as PDF
    Pdf,
}
