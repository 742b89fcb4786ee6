//! What `threshold` takes.

use clap::Args;
use littlewood::tables::Quantity;

use super::errors::parse_name;
use super::{ProblemArgs, RunArgs, ShortFormat};
use crate::axis::parse_number;

pub(super) const THRESHOLD: &str = "\
Find the value of a quantity at which the outcome of a motion changes, to the last digit.

Outcomes are the classes of `map`: leaves at once, lifts off later, rolls for ever and so on. \
Without a range the change is found that is nearest to the value of the motion, within the usual \
range of the quantity. With --of NAME=FROM:TO it is the first one from FROM on towards TO, which \
may be less: from the least value on, the smallest at which the outcome changes.

The range is searched in 200 steps, so that what changes twice within a step is not seen. A value \
that no hoop or start can have ends the search on its side. Takes the hoop and the start as \
`simulate` does.";

pub(super) const THRESHOLD_EXAMPLES: &str = "\
Examples:
  littlewood threshold figure-3 --of theta_rate
  littlewood threshold figure-3 --of mu_s=0.4:3
  littlewood threshold disc-rests-on-ramp --of slope=0:0.5 --format json";

/// Arguments of `littlewood threshold`.
#[derive(Debug, Args)]
pub(crate) struct ThresholdArgs {
    #[command(flatten)]
    pub(crate) problem: ProblemArgs<true>,
    /// The quantity, dimensionless, such as mu_s or theta_rate; with a range NAME=FROM:TO, whose
    /// ends may be written with pi
    #[arg(long, value_name = "NAME[=FROM:TO]", value_parser = parse_of, help_heading = "Threshold")]
    pub(crate) of: ThresholdOf,
    #[command(flatten)]
    pub(crate) run: RunArgs,
    /// Output format
    #[arg(long, value_enum, default_value_t = ShortFormat::Table, help_heading = "Output")]
    pub(crate) format: ShortFormat,
}

/// A quantity, and the range in which its threshold is looked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ThresholdOf {
    pub(crate) quantity: Quantity,
    pub(crate) ends: Option<[f64; 2]>,
}

fn parse_of(text: &str) -> Result<ThresholdOf, String> {
    const FORM: &str = "hint: a range is NAME=FROM:TO, such as slope=0:pi/4";
    let Some((name, range)) = text.split_once('=') else {
        let quantity = parse_name(text, "")?;
        return Ok(ThresholdOf {
            quantity,
            ends: None,
        });
    };
    let quantity = parse_name(name.trim(), "")?;
    let (from, to) = range.split_once(':').ok_or(FORM)?;
    let end = |text: &str| {
        parse_number(text.trim()).ok_or_else(|| format!("'{text}' is not a number\n\n{FORM}"))
    };
    let ends = Some([end(from)?, end(to)?]);
    Ok(ThresholdOf { quantity, ends })
}
