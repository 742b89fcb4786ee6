//! JSON, one object, every number with as many digits as it takes to read the same number back.

use std::io::{self, Write};

use littlewood::cases::CASES;
use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension, SummaryColumn};
use littlewood::theory::Classification;
use littlewood::{Hoop, Trajectory};
use serde::{Serialize, Serializer};

use crate::record::{
    CaseRecord, ClassificationRecord, Fields, OutcomeRecord, PhaseRecord, SiRecord, StartRecord,
    TransitionRecord, UncertaintyRecord, hoop, sample, si_sample,
};
use crate::{Sampling, Subject, instants, jam_of};

#[derive(Serialize)]
struct MotionDocument<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    case: Option<&'static str>,
    hoop: Fields,
    start: StartRecord,
    transitions: Vec<TransitionRecord>,
    outcome: OutcomeRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertainty: Option<UncertaintyRecord>,
    phases: Vec<PhaseRecord>,
    #[serde(flatten)]
    energy: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sampled_until: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    samples: Option<Samples<'a>>,
}

/// The samples, written one after the other as they are computed.
struct Samples<'a> {
    trajectory: &'a Trajectory,
    sampling: Sampling,
    units: Option<&'a Units>,
}

#[derive(Serialize)]
struct SampleEntry {
    #[serde(flatten)]
    sample: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<Fields>,
}

impl Serialize for Samples<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self {
            trajectory,
            sampling,
            units,
        } = self;
        serializer.collect_seq(instants(trajectory, *sampling).map(|instant| SampleEntry {
            sample: sample(&instant),
            si: units.map(|units| si_sample(units, &instant)),
        }))
    }
}

/// A motion.
///
/// # Errors
/// A failure to write.
pub fn motion(
    writer: impl Write,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    sampling: Option<Sampling>,
) -> io::Result<()> {
    let units = subject.units;
    let energy = energy_lost(trajectory);
    let document = MotionDocument {
        case: subject.case.map(|case| case.name),
        hoop: hoop(trajectory.hoop().parameters()),
        start: StartRecord::of(trajectory, subject.start, units),
        transitions: trajectory
            .transitions()
            .iter()
            .enumerate()
            .map(|(index, it)| {
                let digits = subject.digits.and_then(|digits| digits.get(index));
                TransitionRecord::new(
                    it,
                    units,
                    digits,
                    subject.derivatives.map(|all| (all, index)),
                )
            })
            .collect(),
        outcome: OutcomeRecord::new(&trajectory.outcome(), units, subject.derivatives),
        uncertainty: subject.uncertainty.map(UncertaintyRecord::new),
        phases: trajectory
            .phases()
            .iter()
            .map(|phase| PhaseRecord::new(phase, units))
            .collect(),
        energy: Fields::of_details(energy.clone()),
        si: units.map(|units| SiRecord::new(trajectory.hoop().parameters(), units, energy)),
        sampled_until: sampling.map(|sampling| sampling.until),
        samples: sampling.map(|sampling| Samples {
            trajectory,
            sampling,
            units,
        }),
    };
    write(writer, &document)
}

/// The energy lost, and the parts of it that rolling resistance and impacts have where there can be
/// any.
fn energy_lost(trajectory: &Trajectory) -> Vec<(&'static str, Detail)> {
    let energy = |name, value| (name, Detail::Real(value, Dimension::Energy));
    let impacts = trajectory
        .hoop()
        .restitution()
        .map(|_| trajectory.impact_energy_lost());
    let impacts = impacts.map(|lost| energy(SummaryColumn::ImpactEnergyLost.name(), lost));
    let resistance = (trajectory.hoop().rolling_resistance() > 0.0).then(|| {
        energy(
            "rolling_resistance_energy_lost",
            trajectory.rolling_resistance_energy_lost(),
        )
    });
    [energy("energy_lost", trajectory.energy_lost())]
        .into_iter()
        .chain(resistance)
        .chain(impacts)
        .collect()
}

#[derive(Serialize)]
struct ClassificationDocument {
    #[serde(skip_serializing_if = "Option::is_none")]
    case: Option<&'static str>,
    hoop: Fields,
    start: StartRecord,
    #[serde(flatten)]
    classification: ClassificationRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    jam: Option<TransitionRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiRecord>,
}

/// What is known of a start.
///
/// # Errors
/// A failure to write.
pub fn classification(
    writer: impl Write,
    subject: &Subject<'_>,
    body: &Hoop,
    found: &Classification,
) -> io::Result<()> {
    let units = subject.units;
    let document = ClassificationDocument {
        case: subject.case.map(|case| case.name),
        hoop: hoop(body.parameters()),
        start: StartRecord::new(subject.start, found.mode, found.direction, units),
        classification: found.into(),
        jam: jam_of(body, subject.start, found)
            .map(|impact| TransitionRecord::of_jam(&impact, units)),
        si: units.map(|units| SiRecord::new(body.parameters(), units, None)),
    };
    write(writer, &document)
}

/// The named cases.
///
/// # Errors
/// A failure to write.
pub fn cases(writer: impl Write) -> io::Result<()> {
    write(
        writer,
        &CASES.iter().map(CaseRecord::from).collect::<Vec<_>>(),
    )
}

/// Any document, indented, with a newline at the end.
///
/// # Errors
/// A failure to write.
pub fn write(mut writer: impl Write, document: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut writer, document)?;
    writeln!(writer)
}
