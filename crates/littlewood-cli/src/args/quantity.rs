//! Flags for quantities: one for each row of the table of the core.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser as _};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use littlewood::RestitutionLaw;
use littlewood::tables::{Dimension, Group, Quantity, System};
use littlewood_report::RESTITUTION_LAW;

use super::number;
use crate::values::{Given, flag, si_name};

const SI_HEADING: &str = "SI units (instead of the dimensionless flags)";

/// Identifier and flag of the switch that asks for SI units.
const SI: &str = "si";

/// In SI units the unit, else the kind of number.
fn value_name(quantity: Quantity) -> String {
    let dimension = quantity.dimension();
    if quantity.is_si() {
        return dimension.si_suffix().trim_start_matches('_').to_uppercase();
    }
    if quantity.unit().is_empty() {
        return "RATIO".to_owned();
    }
    let word = match dimension {
        Dimension::Ratio => "RATIO",
        Dimension::Angle => "RAD",
        Dimension::Mass => "MASS",
        Dimension::Length => "LENGTH",
        Dimension::Time => "TIME",
        Dimension::AngularRate => "RATE",
        Dimension::AngularAcceleration | Dimension::Acceleration => "ACCELERATION",
        Dimension::Velocity => "VELOCITY",
        Dimension::Force => "FORCE",
        Dimension::Energy => "ENERGY",
        Dimension::Moment => "MOMENT",
        Dimension::Impulse => "IMPULSE",
        Dimension::Inertia => "INERTIA",
    };
    word.to_owned()
}

fn heading(quantity: Quantity) -> &'static str {
    match (quantity.group(), quantity.row().system) {
        (Group::Run, _) => "Limits",
        (Group::Hoop | Group::Units | Group::Start | Group::Place, System::Si) => SI_HEADING,
        (Group::Hoop | Group::Units, System::Dimensionless) => "Hoop (dimensionless, 2.9)",
        (Group::Start | Group::Place, System::Dimensionless) => "Start (dimensionless, 2.9)",
    }
}

fn hyphened(name: &str) -> String {
    name.replace('_', "-")
}

fn argument(quantity: Quantity) -> Arg {
    let row = quantity.row();
    let in_si = si_name(quantity);
    let help = match row.presence.default_value() {
        Some(default) => format!("{} [default: {default}]", row.help),
        None => row.help.to_owned(),
    };
    let argument = Arg::new(quantity.name())
        .long(hyphened(quantity.name()))
        .action(ArgAction::Set);
    let argument = argument
        .value_parser(number)
        .value_name(value_name(quantity))
        .help(help);
    let argument = argument.help_heading(heading(quantity));
    // A quantity without a twin is the same number in both systems, and has both names.
    if row.twin.is_none() && in_si != quantity.name() {
        argument.visible_alias(hyphened(&in_si))
    } else {
        argument
    }
}

fn degrees_flag(quantity: Quantity) -> Option<String> {
    (quantity.dimension() == Dimension::Angle).then(|| hyphened(quantity.name()) + "-deg")
}

/// The flag of an angle in degrees, if the quantity is one.
fn in_degrees(quantity: Quantity) -> Option<Arg> {
    let flag = degrees_flag(quantity)?;
    let help = format!(
        "The same in degrees, instead of --{}",
        hyphened(quantity.name())
    );
    let argument = Arg::new(flag.clone())
        .long(flag)
        .action(ArgAction::Set)
        .value_parser(number)
        .value_name("DEGREES");
    Some(
        argument
            .help_heading(heading(quantity))
            .help(help)
            .conflicts_with(quantity.name()),
    )
}

/// The flag of the law of restitution.
fn law_argument() -> Arg {
    let names = RestitutionLaw::ALL.map(|law| PossibleValue::new(law.name()).help(law.label()));
    let help = format!(
        "Definition of the coefficient of restitution: the ratio of works, impulses or velocities; \
         also with SI parameters [default: {}]",
        RestitutionLaw::default()
    );
    Arg::new(RESTITUTION_LAW)
        .long(hyphened(RESTITUTION_LAW))
        .value_name("LAW")
        .action(ArgAction::Set)
        .value_parser(
            PossibleValuesParser::new(names).try_map(|name| name.parse::<RestitutionLaw>()),
        )
        .help_heading(heading(Quantity::Restitution))
        .help(help)
}

fn typed(matches: &ArgMatches, quantities: impl Iterator<Item = Quantity>) -> Vec<Given> {
    quantities
        .filter_map(|quantity| {
            let degrees = || {
                Some(
                    matches
                        .get_one::<f64>(&degrees_flag(quantity)?)?
                        .to_radians(),
                )
            };
            let value = matches.get_one(quantity.name()).copied().or_else(degrees)?;
            Some(Given::by_flag(quantity, value))
        })
        .collect()
}

/// The numbers of a hoop and a start that were typed. Without `PLACE` there are no flags for where
/// and when the motion starts: `--x` is free for an axis.
#[derive(Clone, Debug, Default)]
pub(crate) struct SetupArgs<const PLACE: bool> {
    pub(crate) given: Vec<Given>,
    /// Whether SI units are asked for.
    pub(crate) si: bool,
    /// The law of restitution.
    pub(crate) law: Option<RestitutionLaw>,
}

impl<const PLACE: bool> SetupArgs<PLACE> {
    fn quantities() -> impl Iterator<Item = Quantity> {
        Quantity::ALL
            .into_iter()
            .filter(|quantity| match quantity.group() {
                Group::Hoop | Group::Start | Group::Units => true,
                Group::Place => PLACE || quantity.is_si(),
                Group::Run => false,
            })
    }
}

impl<const PLACE: bool> Args for SetupArgs<PLACE> {
    fn augment_args(mut command: Command) -> Command {
        let help = format!(
            "Read and print SI units; any of the flags below implies it. With a named case, {} and \
             {} set the scale",
            flag(Quantity::ParticleMassKg),
            flag(Quantity::RadiusM),
        );
        let switch = Arg::new(SI)
            .long(SI)
            .action(ArgAction::SetTrue)
            .help_heading(SI_HEADING)
            .help(help);
        let (si, plain): (Vec<_>, Vec<_>) =
            Self::quantities().partition(|quantity| quantity.is_si());
        for quantity in plain {
            command = command.arg(argument(quantity)).args(in_degrees(quantity));
            if quantity == Quantity::Restitution {
                command = command.arg(law_argument());
            }
        }
        command.arg(switch).args(si.into_iter().map(argument))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const PLACE: bool> FromArgMatches for SetupArgs<PLACE> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self {
            given: typed(matches, Self::quantities()),
            si: matches.get_flag(SI),
            law: matches.get_one(RESTITUTION_LAW).copied(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The limits that were typed.
#[derive(Clone, Debug, Default)]
pub(crate) struct LimitArgs {
    pub(crate) given: Vec<Given>,
}

impl LimitArgs {
    fn quantities() -> impl Iterator<Item = Quantity> {
        Quantity::ALL
            .into_iter()
            .filter(|quantity| quantity.group() == Group::Run)
    }
}

impl Args for LimitArgs {
    fn augment_args(command: Command) -> Command {
        command.args(Self::quantities().map(argument))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for LimitArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self {
            given: typed(matches, Self::quantities()),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
