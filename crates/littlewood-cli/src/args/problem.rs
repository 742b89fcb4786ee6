//! A hoop, a start and limits as they are typed.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use littlewood::{Limits, Proof};

use super::quantity::{LimitArgs, SetupArgs};

/// A hoop and a start, in whatever way they are given. Without `PLACE` it starts at x = 0, τ = 0
/// unless a scenario says otherwise.
#[derive(Clone, Debug, Args)]
pub(crate) struct ProblemArgs<const PLACE: bool> {
    /// Named case, see `littlewood cases`; `libration` is short for figure-2-libration
    #[arg(value_name = "CASE", conflicts_with = "scenario")]
    pub(crate) case: Option<String>,
    /// Scenario file (TOML): case, [hoop], [start], [run], or [si.hoop] and [si.start]
    #[arg(long, value_name = "FILE")]
    pub(crate) scenario: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) setup: SetupArgs<PLACE>,
}

/// When to stop.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Limits")]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) limits: LimitArgs,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(MAX_TRANSITIONS),
          help = max_transitions())]
    pub(crate) max_transitions: Option<u64>,
    #[arg(
        long,
        value_name = "LENGTH",
        value_parser = clap::value_parser!(u64).range(MAX_SLIDES),
        help = max_slides()
    )]
    pub(crate) max_slides: Option<u64>,
    #[arg(long, value_name = "PROOF", value_parser = proofs(), help = proof())]
    pub(crate) proof: Option<Proof>,
}

/// Largest numbers of transitions that can be asked for.
pub(crate) const MAX_TRANSITIONS: RangeInclusive<u64> = 1..=u64::MAX;

/// Largest lengths of slides that can be asked for.
pub(crate) const MAX_SLIDES: RangeInclusive<u64> = 1..=u64::MAX;

fn max_slides() -> String {
    format!(
        "Stop when the total length of the slides, measured in time and angle, exceeds this; a \
         slide counts for at most 32 (1 + ln(1 + m/Î)), where m = 1 + m1/m2. On planes with very \
         little friction slides are long and many [default: {}]",
        Limits::default().slides
    )
}

fn max_transitions() -> String {
    format!(
        "Stop after this many transitions. Light hoops on nearly smooth planes have very many, and \
         lossless bounces never end [default: {}]",
        Limits::default().transitions
    )
}

fn proofs() -> impl TypedValueParser<Value = Proof> {
    let names = Proof::ALL.map(|proof| PossibleValue::new(proof.name()).help(proof.label()));
    PossibleValuesParser::new(names).try_map(|name| name.parse::<Proof>())
}

fn proof() -> String {
    format!(
        "Proof required before a motion is declared endless [default: {}]",
        Limits::default().proof
    )
}

/// A number after a flag.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "not a number".to_owned())
}
