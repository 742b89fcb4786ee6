//! One hoop, one start, one motion.

use std::collections::TryReserveError;
use std::io;

use littlewood::impact::{BouncingOrbit, ContactVelocities, Impact};
use littlewood::tables::{Detail, Quantity, Setup, UnknownName};
use littlewood::theory::{Candidates, Classification, RollingType};
use littlewood::thresholds::{ClassAt, SearchRange};
use littlewood::{
    Hoop, Limits, Mode, Phase, RestitutionLaw, Sample, SlipDirection, Start, Trajectory as Core,
};
use littlewood_report::page::{self, Look};
use littlewood_report::scale::Scale;
use littlewood_report::sheet::{Block, Row, Sheet, Table};
use littlewood_report::{Instant, Sampling, Subject, instants, json, sentence};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::derivatives::{self, AtTimes, OfMotion};
use crate::error::{refuse, too_large, unknown};
use crate::record::{
    ByName, CountLimits, GivenHoop, StartNumbers, StateDict, hoop, limits, start, start_by_name,
};
use crate::samples::Samples;
use crate::units::{Scales, units};

/// What follows from the parameters of a hoop: m, h, Î, and its law of restitution.
#[derive(IntoPyObject)]
pub(crate) struct DerivedHoop {
    mass: f64,
    h: f64,
    inertia_about_mass_centre: f64,
    restitution_law: Option<&'static str>,
}

/// Checks the parameters of a hoop.
#[pyfunction]
pub(crate) fn check_hoop(py: Python<'_>, given: GivenHoop) -> PyResult<DerivedHoop> {
    let hoop = hoop(py, &given)?;
    let law = hoop
        .restitution()
        .map(|restitution| RestitutionLaw::name(restitution.law()));
    Ok(DerivedHoop {
        mass: hoop.mass(),
        h: hoop.h(),
        inertia_about_mass_centre: hoop.body().inertia_about_mass_centre(),
        restitution_law: law,
    })
}

/// Checks a time limit for a start at τ = 0, before anything is computed.
#[pyfunction]
pub(crate) fn check_until(py: Python<'_>, until: f64) -> PyResult<()> {
    Limits::until(until)
        .check(&Start::default())
        .map_err(|error| refuse(py, &error, None))
}

/// Refuses the name of a proof that there is not.
#[pyfunction]
pub(crate) fn check_proof(py: Python<'_>, proof: &str) -> PyResult<()> {
    let counts = CountLimits {
        transitions: 0,
        slides: 0,
    };
    limits(py, None, counts, proof).map(drop)
}

/// A simulated motion, and the start that it was given.
#[pyclass(frozen, module = "littlewood._core")]
pub(crate) struct Trajectory(Core, Start);

/// A part of a page: what it is, its label or headings, its rows, and the columns of numbers.
#[derive(IntoPyObject)]
pub(crate) struct BlockDict {
    kind: &'static str,
    head: Vec<String>,
    rows: Vec<RowDict>,
    numbers: Vec<usize>,
}

/// A row of a page, with the mode that it is about, if any.
#[derive(IntoPyObject)]
pub(crate) struct RowDict {
    mode: Option<&'static str>,
    cells: Vec<String>,
}

/// Simulates a motion, with the interpreter released.
#[pyfunction]
pub(crate) fn simulate(
    py: Python<'_>,
    given: GivenHoop,
    start_numbers: StartNumbers,
    until: Option<f64>,
    max_transitions: usize,
    max_slides: usize,
    proof: &str,
) -> PyResult<Trajectory> {
    let hoop = hoop(py, &given)?;
    let counts = CountLimits {
        transitions: max_transitions,
        slides: max_slides,
    };
    let limits = limits(py, until, counts, proof)?;
    let start = start(start_numbers);
    let motion = py.detach(|| hoop.simulate(start, limits));
    motion
        .map(|motion| Trajectory(motion, start))
        .map_err(|error| refuse(py, &error, None))
}

/// The velocities that an impact changes.
#[derive(IntoPyObject)]
pub(crate) struct VelocitiesDict {
    theta_rate: f64,
    slip: f64,
    gap_rate: f64,
}

impl From<ContactVelocities> for VelocitiesDict {
    fn from(velocities: ContactVelocities) -> Self {
        let ContactVelocities {
            theta_rate,
            slip,
            gap_rate,
        } = velocities;
        Self {
            theta_rate,
            slip,
            gap_rate,
        }
    }
}

/// The impulse of the plane on the body, upwards and along E1.
#[derive(IntoPyObject)]
pub(crate) struct ImpulseDict {
    normal: f64,
    friction: f64,
}

#[derive(IntoPyObject)]
pub(crate) struct ImpactDict {
    case: &'static str,
    before: VelocitiesDict,
    after: VelocitiesDict,
    impulse: ImpulseDict,
    normal_work: f64,
    friction_work: f64,
    resistance_work: f64,
    energy_lost: f64,
    gains_energy: bool,
}

impl From<&Impact> for ImpactDict {
    fn from(impact: &Impact) -> Self {
        Self {
            case: impact.case.name(),
            before: impact.before.into(),
            after: impact.after.into(),
            impulse: ImpulseDict {
                normal: impact.impulse.normal,
                friction: impact.impulse.friction,
            },
            normal_work: impact.normal_work,
            friction_work: impact.friction_work,
            resistance_work: impact.resistance_work,
            energy_lost: impact.energy_lost(),
            gains_energy: impact.gains_energy(),
        }
    }
}

/// A transition; `direction` is that of the slip of the mode that begins.
#[derive(IntoPyObject)]
pub(crate) struct TransitionDict {
    before: StateDict,
    after: StateDict,
    impact: Option<ImpactDict>,
    from_mode: Option<&'static str>,
    to_mode: Option<&'static str>,
    direction: i8,
    cause: &'static str,
}

/// A phase; `ended_by` is the place of the transition that ends it.
#[derive(IntoPyObject)]
pub(crate) struct PhaseDict {
    mode: &'static str,
    direction: i8,
    start: StateDict,
    end: Option<StateDict>,
    energy_start: f64,
    energy_lost: f64,
    is_small_inertia_limit: bool,
    ended_by: Option<usize>,
}

/// How a motion ended, with what is known besides, and all of it in a sentence.
#[derive(IntoPyObject)]
pub(crate) struct OutcomeDict<'py> {
    kind: &'static str,
    state: StateDict,
    details: Bound<'py, PyDict>,
    sentence: String,
}

/// The instant `time`, at a transition just before it; none outside the motion.
fn before(motion: &Core, time: f64) -> Option<Instant> {
    if time == motion.start().time {
        // The first of all instants, which is just before a jam if the start jams.
        return instants(motion, Sampling::of(motion, 2)).next();
    }
    let earlier = motion
        .phases()
        .partition_point(|phase| phase.start().time < time);
    let last = motion.phases().get(..earlier).and_then(<[Phase]>::last);
    let ended = last
        .filter(|phase| phase.end_time() == time)
        .and_then(Phase::last);
    ended.or_else(|| motion.at(time)).map(after)
}

/// An instant of a motion that begins or goes on.
fn after(sample: Sample) -> Instant {
    Instant {
        sample,
        mode: Some(sample.mode),
        event: None,
    }
}

#[pymethods]
impl Trajectory {
    fn phases(&self) -> Vec<PhaseDict> {
        let transitions = self.0.transitions();
        self.0
            .phases()
            .iter()
            .map(|phase| PhaseDict {
                mode: phase.mode().name(),
                direction: SlipDirection::code(phase.direction()),
                start: phase.start().into(),
                end: phase.end().map(StateDict::from),
                energy_start: phase.first().energy,
                energy_lost: phase.energy_lost(),
                is_small_inertia_limit: !phase.is_outside_small_inertia_limit(),
                ended_by: self
                    .0
                    .end_of(phase)
                    .and_then(|end| transitions.element_offset(end)),
            })
            .collect()
    }

    fn transitions(&self) -> Vec<TransitionDict> {
        self.0
            .transitions()
            .iter()
            .map(|transition| TransitionDict {
                before: transition.before.into(),
                after: transition.after.into(),
                impact: transition.impact.as_ref().map(ImpactDict::from),
                from_mode: transition.from.map(Mode::name),
                to_mode: transition.to.map(Mode::name),
                direction: SlipDirection::code(transition.direction),
                cause: transition.cause.name(),
            })
            .collect()
    }

    fn outcome<'py>(&self, py: Python<'py>) -> PyResult<OutcomeDict<'py>> {
        let outcome = self.0.outcome();
        let details = PyDict::new(py);
        add_details(&details, outcome.details())?;
        add_candidates(&details, outcome.candidates())?;
        Ok(OutcomeDict {
            kind: outcome.kind().name(),
            state: outcome.state().into(),
            details,
            sentence: sentence::outcome(&self.0, Scale::new(None)),
        })
    }

    /// The motion as the command line prints it.
    fn text(&self) -> String {
        let mut text = Vec::new();
        // Writing to memory does not fail.
        let _ = self.page().write(&mut text, false, None);
        String::from_utf8(text).unwrap_or_default()
    }

    /// The motion as the command line writes it in JSON, with so many evenly spaced instants, if
    /// any, and in SI units, too, if it has some.
    fn json(
        &self,
        py: Python<'_>,
        samples: Option<usize>,
        scales: Option<Scales>,
    ) -> PyResult<String> {
        let units = scales.map(|scales| units(py, scales)).transpose()?;
        let subject = Subject {
            units: units.as_ref(),
            ..self.subject()
        };
        let sampling = samples.map(|count| Sampling::of(&self.0, count));
        py.detach(|| {
            let mut text = Room(Vec::new());
            json::motion(&mut text, &subject, &self.0, sampling)?;
            String::from_utf8(text.0).map_err(io::Error::other)
        })
        .map_err(|error| PyMemoryError::new_err(error.to_string()))
    }

    /// The same in parts: facts, tables and notes.
    fn blocks(&self) -> Vec<BlockDict> {
        let words = |kind, head: &str| BlockDict {
            kind,
            head: vec![head.to_owned()],
            rows: vec![],
            numbers: vec![],
        };
        let plain = |cell: &String| RowDict {
            mode: None,
            cells: vec![cell.clone()],
        };
        let row = |row: &Row| RowDict {
            mode: row.mode.map(Mode::name),
            cells: row.cells.clone(),
        };
        let block = |block: &Block| match block {
            Block::Title(text) => Some(words("title", text)),
            Block::Fact(label, lines) => Some(BlockDict {
                rows: lines.iter().map(plain).collect(),
                ..words("fact", label)
            }),
            Block::Table(Table {
                head,
                rows,
                numbers,
            }) => Some(BlockDict {
                kind: "table",
                head: head.clone(),
                rows: rows.iter().map(row).collect(),
                numbers: numbers.clone(),
            }),
            Block::Note(text) => Some(words("note", text)),
            Block::Gap => None,
        };
        self.page().blocks().iter().filter_map(block).collect()
    }

    fn end_time(&self) -> f64 {
        self.0.end_time()
    }

    /// Time up to which plots and tables show the motion: its end, or two periods of one that lasts
    /// for ever.
    fn shown_until(&self) -> f64 {
        Sampling::of(&self.0, 2).until
    }

    fn energy_lost(&self) -> f64 {
        self.0.energy_lost()
    }

    fn rolling_resistance_energy_lost(&self) -> f64 {
        self.0.rolling_resistance_energy_lost()
    }

    fn impact_energy_lost(&self) -> f64 {
        self.0.impact_energy_lost()
    }

    fn sequence(&self) -> String {
        self.0.summary().sequence.to_string()
    }

    /// The instants `times`; at a transition the last of what ends (`is_before`), or the first of
    /// what begins.
    fn at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        is_before: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let times: Vec<f64> = times.as_array().iter().copied().collect();
        let samples = py.detach(|| -> Result<Samples, TryReserveError> {
            let mut samples = Samples::with_room(times.len())?;
            for time in times {
                let instant = if is_before {
                    before(&self.0, time)
                } else {
                    self.0.at(time).map(after)
                };
                match instant {
                    Some(Instant { sample, mode, .. }) => samples.push(&sample, mode),
                    None => samples.push_nothing(time),
                }
            }
            Ok(samples)
        });
        samples.map_err(|error| too_large(&error))?.into_dict(py)
    }

    /// `count` instants evenly spaced up to `until`, and both sides of each transition.
    fn sample_evenly<'py>(
        &self,
        py: Python<'py>,
        count: usize,
        until: f64,
    ) -> PyResult<Bound<'py, PyDict>> {
        let samples = py.detach(|| -> Result<Samples, TryReserveError> {
            let mut samples =
                Samples::with_room(count.saturating_add(2 * self.0.transitions().len()))?;
            for Instant { sample, mode, .. } in instants(&self.0, Sampling { count, until }) {
                samples.push(&sample, mode);
            }
            Ok(samples)
        });
        samples.map_err(|error| too_large(&error))?.into_dict(py)
    }

    /// The derivatives of the transitions and of the outcome with respect to these quantities, or
    /// to all that there are.
    fn derivatives<'py>(
        &self,
        py: Python<'py>,
        quantities: Option<Vec<String>>,
    ) -> PyResult<OfMotion<'py>> {
        derivatives::all(py, &self.0, quantities)
    }

    /// The derivatives of the state at fixed times.
    fn derivatives_at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        quantities: Option<Vec<String>>,
    ) -> PyResult<AtTimes<'py>> {
        let times: Vec<f64> = times.as_array().iter().copied().collect();
        derivatives::at(py, &self.0, &times, quantities)
    }
}

impl Trajectory {
    fn page(&self) -> Sheet {
        let mut sheet = Sheet::default();
        page::motion(&mut sheet, &self.subject(), &self.0, Look::default());
        sheet
    }

    const fn subject(&self) -> Subject<'static> {
        Subject::of_start(self.1)
    }
}

/// A text in memory; more of it than there is room for is an error and not the end of the process.
struct Room(Vec<u8>);

impl io::Write for Room {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.try_reserve(bytes.len()).map_err(io::Error::other)?;
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn add_details(
    dict: &Bound<'_, PyDict>,
    details: impl IntoIterator<Item = (&'static str, Detail)>,
) -> PyResult<()> {
    for (name, detail) in details {
        match detail {
            Detail::Real(value, _) => dict.set_item(name, value)?,
            Detail::Count(count) => dict.set_item(name, count)?,
            Detail::Word(word) => dict.set_item(name, word)?,
        }
    }
    Ok(())
}

/// The motions that are consistent, and the numbers that decide.
fn add_candidates(dict: &Bound<'_, PyDict>, candidates: Option<Candidates>) -> PyResult<()> {
    let Some(candidates) = candidates else {
        return Ok(());
    };
    let consistent: Vec<(&str, i8)> = candidates
        .consistent()
        .map(|(mode, direction)| (mode.name(), SlipDirection::code(direction)))
        .collect();
    dict.set_item("consistent", consistent)?;
    add_details(dict, candidates.details())
}

/// How rolling ends: after a time, at an angle and a rate.
#[derive(IntoPyObject)]
struct RollingEndDict {
    elapsed: f64,
    theta: f64,
    theta_rate: f64,
    cause: &'static str,
}

/// Where a start lies, as a dictionary.
#[pyfunction]
pub(crate) fn classify(
    py: Python<'_>,
    given: GivenHoop,
    start_numbers: StartNumbers,
) -> PyResult<Bound<'_, PyDict>> {
    let found: Classification = hoop(py, &given)?
        .classify(start(start_numbers))
        .map_err(|error| refuse(py, &error, None))?;
    let dict = PyDict::new(py);
    dict.set_item("region", found.region.name())?;
    dict.set_item("mode", found.mode.map(Mode::name))?;
    dict.set_item("direction", SlipDirection::code(found.direction))?;
    dict.set_item("energy", found.energy)?;
    dict.set_item("rolling_normal", found.rolling_forces.normal)?;
    dict.set_item("rolling_friction", found.rolling_forces.friction)?;
    dict.set_item("contact", found.contact)?;
    dict.set_item("rolling_type", found.rolling_type.map(RollingType::name))?;
    let end = found.rolling_end.map(|end| RollingEndDict {
        elapsed: end.elapsed,
        theta: end.theta,
        theta_rate: end.theta_rate,
        cause: end.limit.cause().name(),
    });
    dict.set_item("rolling_end", end)?;
    dict.set_item("reverse_chatter", found.reverse_chatter)?;
    let details = PyDict::new(py);
    if let Some(recurrence) = &found.recurrence {
        add_details(&details, recurrence.details())?;
    }
    add_candidates(&details, found.candidates)?;
    if let Some(undecided) = &found.undecided {
        add_details(&details, undecided.details())?;
    }
    dict.set_item("details", details)?;
    Ok(dict)
}

/// A value of a quantity, and the class of its motion.
#[derive(IntoPyObject)]
pub(crate) struct ClassAtDict {
    value: f64,
    class_name: &'static str,
}

impl From<ClassAt> for ClassAtDict {
    fn from(ClassAt { value, class }: ClassAt) -> Self {
        let class_name = class.name();
        Self { value, class_name }
    }
}

/// Where the class of a motion changes, if it does, and that in words.
#[derive(IntoPyObject)]
pub(crate) struct ThresholdDict {
    sides: Option<[ClassAtDict; 2]>,
    has_unresolved_between: bool,
    text: String,
}

/// Finds the value of a quantity at which the class of a motion changes, with the interpreter
/// released; without a range in the usual one.
#[pyfunction]
pub(crate) fn threshold(
    py: Python<'_>,
    given: GivenHoop,
    start_numbers: StartNumbers,
    of: &str,
    between: Option<[f64; 2]>,
    until: Option<f64>,
) -> PyResult<ThresholdDict> {
    let quantity: Quantity = of
        .parse()
        .map_err(|error: UnknownName| unknown(py, &error, "of", "a quantity"))?;
    let mut setup = Setup::new(hoop(py, &given)?.parameters(), start(start_numbers));
    let range = match between {
        Some([first, last]) => {
            SearchRange::between(quantity, first, last).map_err(|error| refuse(py, &error, None))?
        }
        None => SearchRange::usual(quantity, setup.get(quantity)),
    };
    // What is refused where the search begins is an error of the input.
    setup.set(quantity, range.near);
    let limits = Limits::default().with_until(until);
    Hoop::new(setup.hoop)
        .and_then(|hoop| hoop.classify(setup.start).and(limits.check(&setup.start)))
        .map_err(|error| refuse(py, &error, None))?;
    Ok(
        match py.detach(|| range.of_motion(&setup, quantity, limits)) {
            Ok(found) => ThresholdDict {
                sides: Some([found.below, found.above].map(ClassAtDict::from)),
                has_unresolved_between: found.has_unresolved_between,
                text: sentence::threshold(quantity, &found).join(" "),
            },
            Err(searched) => ThresholdDict {
                sides: None,
                has_unresolved_between: false,
                text: sentence::no_threshold(quantity, &searched),
            },
        },
    )
}

/// A motion that bounces for ever.
#[derive(IntoPyObject)]
pub(crate) struct OrbitDict {
    top_rate: f64,
    bottom_rate: f64,
    gap_rate: f64,
    friction: f64,
    period: f64,
    start: ByName<f64>,
}

/// The motion that bounces for ever with impacts at this angle, if there is one.
#[pyfunction]
pub(crate) fn bouncing_orbit(
    py: Python<'_>,
    given: GivenHoop,
    angle: f64,
) -> PyResult<Option<OrbitDict>> {
    let orbit = BouncingOrbit::new(&hoop(py, &given)?, angle);
    Ok(orbit.map(|orbit| OrbitDict {
        top_rate: orbit.top_rate,
        bottom_rate: orbit.bottom_rate,
        gap_rate: orbit.gap_rate,
        friction: orbit.friction,
        period: orbit.period(),
        start: start_by_name(orbit.start()),
    }))
}
