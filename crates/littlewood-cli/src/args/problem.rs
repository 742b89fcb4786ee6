//! A hoop, a start and limits as they are typed.

use std::path::PathBuf;

use clap::Args;
use littlewood::Quantity;

use crate::values::{Given, Origin};

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
    pub(super) hoop: HoopArgs,
    #[command(flatten)]
    pub(super) start: StartArgs,
    #[command(flatten)]
    pub(super) place: PlaceArgs,
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
pub(super) struct HoopArgs {
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
pub(super) struct StartArgs {
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
pub(super) struct PlaceArgs {
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
pub(crate) fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "this is not a number".to_owned())
}
