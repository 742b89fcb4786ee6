//! The records that programs read, with their fixed names. A number that is not finite becomes `null` in JSON.

use littlewood::{
    Classification, Direction, Findings, Hoop, HoopParameters, Limit, Mode, NamedCase, Outcome, Phase,
    Recurrence, RollingEnd, RollingType, Sample, SiParameters, Start, State, Transition, Units,
};
use serde::Serialize;

/// σ as a number; 0 where there is no slip.
pub(crate) fn sign(direction: Option<Direction>) -> i8 {
    match direction {
        Some(Direction::Negative) => -1,
        Some(Direction::Positive) => 1,
        None => 0,
    }
}

/// A hoop (2.9).
#[derive(Debug, Serialize)]
pub(crate) struct HoopRecord {
    mass_ratio: f64,
    offset: f64,
    inertia: f64,
    mu_s: f64,
    mu_k: f64,
}

impl From<HoopParameters> for HoopRecord {
    fn from(hoop: HoopParameters) -> Self {
        let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = hoop;
        Self { mass_ratio, offset, inertia, mu_s, mu_k }
    }
}

/// A state.
#[derive(Debug, Serialize)]
pub(crate) struct StateRecord {
    time: f64,
    theta: f64,
    theta_rate: f64,
    slip: f64,
    x: f64,
}

impl From<State> for StateRecord {
    fn from(state: State) -> Self {
        let State { time, theta, theta_rate, slip, x } = state;
        Self { time, theta, theta_rate, slip, x }
    }
}

impl From<Start> for StateRecord {
    fn from(start: Start) -> Self {
        let Start { time, theta, theta_rate, slip, x } = start;
        Self { time, theta, theta_rate, slip, x }
    }
}

/// A state in SI units.
#[derive(Debug, Serialize)]
pub(crate) struct SiStateRecord {
    time_s: f64,
    theta_rad: f64,
    theta_rate_rad_per_s: f64,
    slip_m_per_s: f64,
    x_m: f64,
}

impl SiStateRecord {
    pub(crate) fn new(units: &Units, state: &State) -> Self {
        let si = units.state(state);
        Self {
            time_s: si.time_s,
            theta_rad: si.theta_rad,
            theta_rate_rad_per_s: si.theta_rate_rad_per_s,
            slip_m_per_s: si.slip_m_per_s,
            x_m: si.x_m,
        }
    }
}

/// A start with the motion that begins there.
#[derive(Debug, Serialize)]
pub(crate) struct StartRecord {
    #[serde(flatten)]
    state: StateRecord,
    mode: Option<&'static str>,
    direction: i8,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiStateRecord>,
}

impl StartRecord {
    pub(crate) fn new(
        start: &Start,
        mode: Option<Mode>,
        direction: Option<Direction>,
        units: Option<&Units>,
    ) -> Self {
        let Start { time, theta, theta_rate, slip, x } = *start;
        let state = State { time, theta, theta_rate, slip, x };
        Self {
            state: state.into(),
            mode: mode.map(Mode::name),
            direction: sign(direction),
            si: units.map(|units| SiStateRecord::new(units, &state)),
        }
    }
}

/// What changes at a transition.
#[derive(Debug, Serialize)]
pub(crate) struct EdgeRecord {
    /// Mode that ends.
    pub(crate) from: Option<&'static str>,
    /// Mode that begins.
    pub(crate) to: Option<&'static str>,
    /// σ of the motion that begins.
    pub(crate) direction: i8,
    /// Event.
    pub(crate) cause: &'static str,
}

impl From<&Transition> for EdgeRecord {
    fn from(transition: &Transition) -> Self {
        Self {
            from: Some(transition.from.name()),
            to: transition.to.map(Mode::name),
            direction: sign(transition.direction),
            cause: transition.cause.name(),
        }
    }
}

/// A transition.
#[derive(Debug, Serialize)]
pub(crate) struct TransitionRecord {
    #[serde(flatten)]
    state: StateRecord,
    #[serde(flatten)]
    edge: EdgeRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiStateRecord>,
}

impl TransitionRecord {
    pub(crate) fn new(transition: &Transition, units: Option<&Units>) -> Self {
        Self {
            state: transition.state.into(),
            edge: transition.into(),
            si: units.map(|units| SiStateRecord::new(units, &transition.state)),
        }
    }
}

/// A phase of motion.
#[derive(Debug, Serialize)]
pub(crate) struct PhaseRecord {
    mode: &'static str,
    direction: i8,
    start_time: f64,
    /// `null` for ever.
    duration: f64,
    energy_start: f64,
    energy_lost: f64,
    small_inertia_limit: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiPhaseRecord>,
}

#[derive(Debug, Serialize)]
struct SiPhaseRecord {
    start_time_s: f64,
    duration_s: f64,
    energy_start_j: f64,
    energy_lost_j: f64,
}

impl PhaseRecord {
    pub(crate) fn new(phase: &Phase, units: Option<&Units>) -> Self {
        let start_time = phase.start().time;
        let duration = phase.duration();
        let energy_start = phase.first().energy;
        let energy_lost = phase.energy_lost();
        Self {
            mode: phase.mode().name(),
            direction: sign(phase.direction()),
            start_time,
            duration,
            energy_start,
            energy_lost,
            small_inertia_limit: !phase.is_outside_small_inertia_limit(),
            si: units.map(|units| SiPhaseRecord {
                start_time_s: start_time * units.time_s,
                duration_s: duration * units.time_s,
                energy_start_j: energy_start * units.energy_j(),
                energy_lost_j: energy_lost * units.energy_j(),
            }),
        }
    }
}

/// How a motion ended.
#[derive(Debug, Serialize)]
pub(crate) struct OutcomeRecord {
    kind: &'static str,
    #[serde(flatten)]
    state: StateRecord,
    #[serde(flatten)]
    details: Details,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiOutcomeRecord>,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Details {
    Landing { gap_rate: f64 },
    Recurs(RecurrenceRecord),
    TransitionLimit { transitions: usize },
    Undecided(FindingsRecord),
    Singular { solvability: f64 },
    Nothing {},
}

#[derive(Debug, Serialize)]
struct SiOutcomeRecord {
    #[serde(flatten)]
    state: SiStateRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_rate_m_per_s: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    period_s: Option<f64>,
}

impl OutcomeRecord {
    pub(crate) fn new(outcome: &Outcome, units: Option<&Units>) -> Self {
        let details = match outcome {
            Outcome::Landing { gap_rate, .. } => Details::Landing { gap_rate: *gap_rate },
            Outcome::RollsForever { recurrence, .. } | Outcome::SlidesForever { recurrence, .. } => {
                Details::Recurs(recurrence.into())
            }
            Outcome::TransitionLimit { transitions, .. } => {
                Details::TransitionLimit { transitions: *transitions }
            }
            Outcome::Inconsistent { findings, .. } | Outcome::Ambiguous { findings, .. } => {
                Details::Undecided(findings.into())
            }
            Outcome::Singular { solvability, .. } => Details::Singular { solvability: *solvability },
            _ => Details::Nothing {},
        };
        let si = units.map(|units| SiOutcomeRecord {
            state: SiStateRecord::new(units, &outcome.state()),
            gap_rate_m_per_s: match details {
                Details::Landing { gap_rate } => Some(gap_rate * units.velocity_m_per_s()),
                _ => None,
            },
            period_s: match &details {
                Details::Recurs(recurrence) => recurrence.period.map(|period| period * units.time_s),
                _ => None,
            },
        });
        Self { kind: outcome.kind(), state: outcome.state().into(), details, si }
    }
}

/// How a motion that lasts for ever comes back.
#[derive(Debug, Serialize)]
pub(crate) struct RecurrenceRecord {
    recurrence: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    period: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_min: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_max: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_limit: Option<f64>,
}

impl From<&Recurrence> for RecurrenceRecord {
    fn from(recurrence: &Recurrence) -> Self {
        let blank =
            Self { recurrence: "rest", period: None, theta_min: None, theta_max: None, theta_limit: None };
        match *recurrence {
            Recurrence::Rest => blank,
            Recurrence::Libration { period, theta_min, theta_max } => Self {
                recurrence: "libration",
                period: Some(period),
                theta_min: Some(theta_min),
                theta_max: Some(theta_max),
                ..blank
            },
            Recurrence::Rotation { period } => Self { recurrence: "rotation", period: Some(period), ..blank },
            Recurrence::Asymptotic { theta } => {
                Self { recurrence: "asymptotic", theta_limit: Some(theta), ..blank }
            }
        }
    }
}

/// What was found where the motion that follows is not unique.
#[derive(Debug, Serialize)]
pub(crate) struct FindingsRecord {
    consistent: Vec<MotionRecord>,
    rolling_normal: f64,
    rolling_friction: f64,
    contact: f64,
    solvability_negative: f64,
    solvability_positive: f64,
}

#[derive(Debug, Serialize)]
struct MotionRecord {
    mode: &'static str,
    direction: i8,
}

impl From<&Findings> for FindingsRecord {
    fn from(findings: &Findings) -> Self {
        let motion = |(mode, direction): (Mode, Option<Direction>)| MotionRecord {
            mode: mode.name(),
            direction: sign(direction),
        };
        let [solvability_negative, solvability_positive] = findings.solvability;
        Self {
            consistent: findings.consistent().map(motion).collect(),
            rolling_normal: findings.rolling_forces.normal,
            rolling_friction: findings.rolling_forces.friction,
            contact: findings.contact,
            solvability_negative,
            solvability_positive,
        }
    }
}

/// An instant of a motion.
#[derive(Debug, Serialize)]
pub(crate) struct SampleRecord {
    /// Time.
    pub(crate) time: f64,
    mode: &'static str,
    direction: i8,
    theta: f64,
    theta_rate: f64,
    slip: f64,
    x: f64,
    theta_acceleration: f64,
    slip_acceleration: f64,
    normal: f64,
    friction: f64,
    gap: f64,
    gap_rate: f64,
    energy: f64,
    centre_y: f64,
    mass_centre_x: f64,
    mass_centre_y: f64,
    particle_x: f64,
    particle_y: f64,
}

impl SampleRecord {
    pub(crate) fn new(hoop: &Hoop, sample: &Sample) -> Self {
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        Self {
            time: sample.state.time,
            mode: sample.mode.name(),
            direction: sign(sample.direction),
            theta: sample.state.theta,
            theta_rate: sample.state.theta_rate,
            slip: sample.state.slip,
            x: sample.state.x,
            theta_acceleration: sample.theta_acceleration,
            slip_acceleration: sample.slip_acceleration,
            normal: sample.normal,
            friction: sample.friction,
            gap: sample.gap,
            gap_rate: sample.gap_rate,
            energy: sample.energy,
            centre_y: sample.centre().y,
            mass_centre_x: mass_centre.x,
            mass_centre_y: mass_centre.y,
            particle_x: particle.x,
            particle_y: particle.y,
        }
    }
}

/// An instant of a motion in SI units.
#[derive(Debug, Serialize)]
pub(crate) struct SiSampleRecord {
    time_s: f64,
    theta_rad: f64,
    theta_rate_rad_per_s: f64,
    slip_m_per_s: f64,
    x_m: f64,
    theta_acceleration_rad_per_s2: f64,
    slip_acceleration_m_per_s2: f64,
    normal_n: f64,
    friction_n: f64,
    gap_m: f64,
    gap_rate_m_per_s: f64,
    energy_j: f64,
    centre_y_m: f64,
    mass_centre_x_m: f64,
    mass_centre_y_m: f64,
    particle_x_m: f64,
    particle_y_m: f64,
}

impl SiSampleRecord {
    pub(crate) fn new(units: &Units, hoop: &Hoop, sample: &Sample) -> Self {
        let state = units.state(&sample.state);
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        let length = |radii: f64| radii * units.length_m;
        Self {
            time_s: state.time_s,
            theta_rad: state.theta_rad,
            theta_rate_rad_per_s: state.theta_rate_rad_per_s,
            slip_m_per_s: state.slip_m_per_s,
            x_m: state.x_m,
            theta_acceleration_rad_per_s2: sample.theta_acceleration / (units.time_s * units.time_s),
            slip_acceleration_m_per_s2: sample.slip_acceleration * units.gravity_m_per_s2,
            normal_n: sample.normal * units.force_n(),
            friction_n: sample.friction * units.force_n(),
            gap_m: length(sample.gap),
            gap_rate_m_per_s: sample.gap_rate * units.velocity_m_per_s(),
            energy_j: sample.energy * units.energy_j(),
            centre_y_m: length(sample.centre().y),
            mass_centre_x_m: length(mass_centre.x),
            mass_centre_y_m: length(mass_centre.y),
            particle_x_m: length(particle.x),
            particle_y_m: length(particle.y),
        }
    }
}

/// The hoop and the units in SI.
#[derive(Debug, Serialize)]
pub(crate) struct SiRecord {
    hoop: SiHoopRecord,
    units: UnitsRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy_lost_j: Option<f64>,
}

#[derive(Debug, Serialize)]
struct SiHoopRecord {
    disc_mass_kg: f64,
    particle_mass_kg: f64,
    radius_m: f64,
    offset_m: f64,
    inertia_kg_m2: f64,
    gravity_m_per_s2: f64,
    mu_s: f64,
    mu_k: f64,
}

#[derive(Debug, Serialize)]
struct UnitsRecord {
    mass_kg: f64,
    length_m: f64,
    time_s: f64,
    velocity_m_per_s: f64,
    force_n: f64,
    energy_j: f64,
}

impl SiRecord {
    pub(crate) fn new(hoop: &Hoop, units: &Units, energy_lost: Option<f64>) -> Self {
        let si = SiParameters::from_hoop(hoop, units);
        Self {
            hoop: SiHoopRecord {
                disc_mass_kg: si.disc_mass_kg,
                particle_mass_kg: si.particle_mass_kg,
                radius_m: si.radius_m,
                offset_m: si.offset_m,
                inertia_kg_m2: si.inertia_kg_m2,
                gravity_m_per_s2: si.gravity_m_per_s2,
                mu_s: si.mu_s,
                mu_k: si.mu_k,
            },
            units: UnitsRecord {
                mass_kg: units.mass_kg,
                length_m: units.length_m,
                time_s: units.time_s,
                velocity_m_per_s: units.velocity_m_per_s(),
                force_n: units.force_n(),
                energy_j: units.energy_j(),
            },
            energy_lost_j: energy_lost.map(|energy| energy * units.energy_j()),
        }
    }
}

/// A named case.
#[derive(Debug, Serialize)]
pub(crate) struct CaseRecord {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    hoop: HoopRecord,
    start: StateRecord,
}

impl From<&'static NamedCase> for CaseRecord {
    fn from(case: &'static NamedCase) -> Self {
        let NamedCase { name, title, source, hoop, start } = *case;
        Self { name, title, source, hoop: hoop.into(), start: start.into() }
    }
}

/// What is known of a start.
#[derive(Debug, Serialize)]
pub(crate) struct ClassificationRecord {
    region: &'static str,
    energy: f64,
    rolling_normal: f64,
    rolling_friction: f64,
    /// `null` where N ≤ 0.
    friction_demand: f64,
    contact: f64,
    rolling_type: Option<&'static str>,
    rolling_end: Option<RollingEndRecord>,
    rolls_forever: Option<RecurrenceRecord>,
    findings: Option<FindingsRecord>,
}

#[derive(Debug, Serialize)]
struct RollingEndRecord {
    elapsed: f64,
    theta: f64,
    theta_rate: f64,
    cause: &'static str,
    direction: i8,
}

impl From<&RollingEnd> for RollingEndRecord {
    fn from(end: &RollingEnd) -> Self {
        let (cause, direction) = match end.limit {
            Limit::Friction(direction) => ("slip", Some(direction)),
            Limit::NormalForce => ("normal_force_zero", None),
        };
        Self {
            elapsed: end.elapsed,
            theta: end.theta,
            theta_rate: end.theta_rate,
            cause,
            direction: sign(direction),
        }
    }
}

impl From<&Classification> for ClassificationRecord {
    fn from(found: &Classification) -> Self {
        Self {
            region: found.region.name(),
            energy: found.energy,
            rolling_normal: found.rolling_forces.normal,
            rolling_friction: found.rolling_forces.friction,
            friction_demand: found.rolling_forces.demand(),
            contact: found.contact,
            rolling_type: found.rolling_type.map(RollingType::name),
            rolling_end: found.rolling_end.as_ref().map(RollingEndRecord::from),
            rolls_forever: found.recurrence.as_ref().map(RecurrenceRecord::from),
            findings: found.findings.as_ref().map(FindingsRecord::from),
        }
    }
}
