//! Tables of the core: quantities, modes, causes, kinds and laws of impacts, outcomes, classes,
//! regions, phases, columns, cases, edges.

use littlewood::cases::{CASES, find_case};
use littlewood::impact::ImpactCase;
use littlewood::si::STANDARD_GRAVITY;
use littlewood::tables::{
    Class, ColumnType, Dimension, PhaseCode, PhaseSequence, Presence, Quantity, SampleColumn,
    SummaryColumn,
};
use littlewood::theory::{EDGES, RollingType, StartRegion};
use littlewood::{Cause, Limits, Mode, OutcomeKind, Proof, RestitutionLaw};
use littlewood_report::Sampling;
use littlewood_sweep::Varies;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::record::{ByName, hoop_by_name, law_name, start_by_name};
use crate::samples::OUTSIDE;

/// The quantities that a user can set, one dictionary each.
#[pyfunction]
pub(crate) fn quantities(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    Quantity::ALL
        .into_iter()
        .map(|quantity| {
            let row = quantity.row();
            let dict = PyDict::new(py);
            dict.set_item("name", quantity.name())?;
            dict.set_item("group", row.group.name())?;
            dict.set_item("is_si", quantity.is_si())?;
            dict.set_item("twin", row.twin.map(Quantity::name))?;
            dict.set_item("symbol", row.symbol)?;
            dict.set_item("sign", row.sign)?;
            dict.set_item("unit", quantity.unit())?;
            dict.set_item("unit_sign", quantity.unit_sign())?;
            dict.set_item("cf_unit", row.dimension.cf_unit())?;
            dict.set_item("scale", row.dimension.scale())?;
            dict.set_item("long_name", row.long_name)?;
            dict.set_item("help", row.help)?;
            dict.set_item(
                "bounds",
                row.bounds
                    .iter()
                    .map(ToString::to_string)
                    .collect::<Vec<_>>(),
            )?;
            dict.set_item("default", row.presence.default_value())?;
            dict.set_item("is_optional", row.presence == Presence::Optional)?;
            let default = row.presence.default_value();
            let unsaid = default.is_some_and(|value| quantity.goes_without_saying(value));
            dict.set_item("goes_without_saying", unsaid)?;
            Ok(dict)
        })
        .collect()
}

/// The columns of a sample, one dictionary each. Those of codes have no unit.
#[pyfunction]
pub(crate) fn sample_columns(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    SampleColumn::ALL
        .into_iter()
        .map(|column| {
            let dimension = column.dimension();
            let dict = PyDict::new(py);
            dict.set_item("name", column.name())?;
            dict.set_item("sign", column.sign())?;
            dict.set_item("long_name", column.long_name())?;
            dict.set_item("unit_sign", dimension.map(Dimension::scale_sign))?;
            dict.set_item("cf_unit", dimension.map(Dimension::cf_unit))?;
            dict.set_item("scale", dimension.map(Dimension::scale))?;
            dict.set_item("si_name", column.si_name())?;
            dict.set_item("si_unit", dimension.map(Dimension::si_unit))?;
            Ok(dict)
        })
        .collect()
}

/// The columns of a summary, one dictionary each.
#[pyfunction]
pub(crate) fn summary_columns(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    SummaryColumn::ALL
        .into_iter()
        .map(|column| {
            let (kind, dtype) = match column.column_type() {
                ColumnType::Outcome => ("outcome", "uint8"),
                ColumnType::Sequence => ("sequence", "uint64"),
                ColumnType::Count => ("count", "uint32"),
                ColumnType::Flag => ("flag", "uint8"),
                ColumnType::Real => ("real", "float64"),
            };
            let dict = PyDict::new(py);
            dict.set_item("name", column.name())?;
            dict.set_item("kind", kind)?;
            dict.set_item("dtype", dtype)?;
            dict.set_item("cf_unit", column.dimension().cf_unit())?;
            dict.set_item("scale", column.dimension().scale())?;
            dict.set_item("long_name", column.long_name())?;
            Ok(dict)
        })
        .collect()
}

/// A named case.
#[derive(IntoPyObject)]
pub(crate) struct CaseDict {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    hoop: ByName<Option<f64>>,
    restitution_law: Option<&'static str>,
    start: ByName<f64>,
}

#[pyfunction]
pub(crate) fn cases() -> Vec<CaseDict> {
    CASES
        .iter()
        .map(|case| CaseDict {
            name: case.name,
            title: case.title,
            source: case.source,
            hoop: hoop_by_name(case.setup.hoop),
            restitution_law: law_name(case.setup.hoop),
            start: start_by_name(case.setup.start),
        })
        .collect()
}

/// An edge of the automaton.
#[derive(IntoPyObject)]
pub(crate) struct EdgeDict {
    body: &'static str,
    from_mode: Option<&'static str>,
    cause: &'static str,
    guard: &'static str,
    reset: &'static str,
    to_mode: Option<&'static str>,
    source: &'static str,
}

/// The name of the case of this name, or of one that is short for it.
#[pyfunction]
pub(crate) fn name_of_case(name: &str) -> Option<&'static str> {
    find_case(name).map(|case| case.name)
}

#[pyfunction]
pub(crate) fn edges() -> Vec<EdgeDict> {
    EDGES
        .iter()
        .map(|edge| EdgeDict {
            body: edge.body.name(),
            from_mode: edge.from.map(Mode::name),
            cause: edge.cause.name(),
            guard: edge.guard,
            reset: edge.reset,
            to_mode: edge.to.map(Mode::name),
            source: edge.source,
        })
        .collect()
}

/// Sequences of phases, one letter a phase.
#[pyfunction]
pub(crate) fn sequence_names(bits: PyReadonlyArray1<'_, u64>) -> Vec<String> {
    bits.as_array()
        .iter()
        .map(|&bits| PhaseSequence::from_bits(bits).to_string())
        .collect()
}

fn names(quantities: &[Quantity]) -> Vec<&'static str> {
    quantities.iter().map(|quantity| quantity.name()).collect()
}

/// An item of a table of codes, and what it is in words.
#[derive(IntoPyObject)]
struct Coded {
    code: u8,
    name: &'static str,
    label: &'static str,
}

/// An outcome.
#[derive(IntoPyObject)]
struct OutcomeRow {
    code: u8,
    name: &'static str,
    label: &'static str,
    is_final: bool,
}

/// An item of a table of codes without other words.
#[derive(IntoPyObject)]
struct Code {
    code: u8,
    name: &'static str,
}

/// An axis that is no quantity.
#[derive(IntoPyObject)]
struct Axis {
    name: &'static str,
    sign: &'static str,
    long_name: &'static str,
}

/// The least and the largest count.
#[derive(IntoPyObject)]
struct Counts {
    least: u64,
    most: u64,
}

/// Adds a table of codes, as a list of rows with these fields, each by a method of the item.
macro_rules! add_table {
    ($module:ident, $name:literal, $row:ident of $table:ident { $($field:ident: $of:ident),+ }) => {
        let row = |item: $table| $row { $($field: item.$of()),+ };
        $module.add($name, Vec::from($table::ALL.map(row)))?
    };
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("HOOP", names(&Quantity::HOOP))?;
    module.add("START", names(&Quantity::START))?;
    module.add("AXES", names(&Quantity::AXES))?;
    let friction = Varies::Friction;
    let friction = Axis {
        name: friction.name(),
        sign: friction.sign(),
        long_name: friction.long_name(),
    };
    module.add("FRICTION", friction)?;
    module.add("SI_HOOP", names(&Quantity::SI_HOOP))?;
    module.add("SI_START", names(&Quantity::SI_START))?;
    module.add("STANDARD_GRAVITY", STANDARD_GRAVITY)?;
    module.add("MAX_TRANSITIONS", Limits::default().transitions)?;
    module.add("MAX_SLIDES", Limits::default().slides)?;
    module.add("MOST_COUNT", usize::MAX)?;
    let counts = Counts {
        least: *Sampling::COUNTS.start(),
        most: *Sampling::COUNTS.end(),
    };
    module.add("SAMPLE_COUNTS", counts)?;
    module.add("PROOF", Limits::default().proof.name())?;
    module.add("PROOFS", Proof::NAMES.to_vec())?;
    module.add("OUTSIDE", OUTSIDE)?;
    add_table!(module, "MODES", Code of Mode { code: code, name: name });
    add_table!(module, "REGIONS", Code of StartRegion { code: code, name: name });
    add_table!(module, "ROLLING_TYPES", Code of RollingType { code: code, name: name });
    add_table!(module, "CAUSES", Coded of Cause { code: code, name: name, label: label });
    add_table!(module, "IMPACT_CASES", Coded of ImpactCase { code: code, name: name, label: label });
    add_table!(module, "RESTITUTION_LAWS", Coded of RestitutionLaw { code: code, name: name, label: label });
    add_table!(module, "CLASSES", Coded of Class { code: code, name: name, label: label });
    add_table!(module, "PHASES", Coded of PhaseCode { code: code, name: name, label: meaning });
    add_table!(module, "OUTCOMES", OutcomeRow of OutcomeKind { code: code, name: name, label: label, is_final: is_final });
    module.add("SEQUENCE_CAPACITY", PhaseSequence::CAPACITY)?;
    module.add("SEQUENCE_VERSION", PhaseSequence::VERSION)?;
    module.add("SEQUENCE_ENCODING", PhaseSequence::ENCODING)
}
