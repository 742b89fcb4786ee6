//! The description of a run, as stores keep it: two runs with the same description have the same
//! result.

use littlewood::tables::{DerivativeColumn, PhaseSequence, Quantity, Setup};
use littlewood::{HoopParameters, Limits, Start};
use serde_json::{Map, Value, json};

use crate::axis::{Axis, Spacing, Varies};
use crate::grid::Grid;
use crate::setup::{RESTITUTION_LAW, given};
use crate::starts::StartList;

/// Version of the files that stores consist of. Version 1 had sequences of three bits a phase and
/// no version, version 2 no columns of impacts, version 4 NaN in tables and attributes with parts,
/// version 5 no half swings.
pub const STORE_FORMAT: u32 = 6;

const SPACING: &str = "spacing";

const DERIVATIVES: &str = "derivatives";

/// The version of stores that have none.
const FIRST_FORMAT: u64 = 1;

/// A version of a store that this program does not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForeignVersion {
    /// The part that has a version: the format, or the code of sequences.
    pub what: &'static str,
    /// The version that is there.
    pub found: u64,
    /// The version that is needed.
    pub needed: u32,
    /// The version of the program that made the store, if it says so.
    pub program: Option<String>,
}

impl ForeignVersion {
    /// Of the version in a header and those in a description; none if all are those of this
    /// program.
    pub(crate) fn find(header: Option<&Value>, run: &Value) -> Option<Self> {
        let number =
            |version: Option<&Value>| version.and_then(Value::as_u64).unwrap_or(FIRST_FORMAT);
        let program = run
            .get("version")
            .and_then(Value::as_str)
            .map(str::to_owned);
        [
            ("format", header, STORE_FORMAT),
            ("format", run.get("format"), STORE_FORMAT),
            (
                "sequences of version",
                run.get("sequence_version"),
                PhaseSequence::VERSION,
            ),
        ]
        .into_iter()
        .map(|(what, version, needed)| (what, number(version), needed))
        .find(|&(_, found, needed)| found != u64::from(needed))
        .map(|(what, found, needed)| Self {
            what,
            found,
            needed,
            program,
        })
    }
}

fn numbers(values: impl Iterator<Item = (Quantity, f64)>) -> Map<String, Value> {
    values
        .map(|(quantity, value)| (quantity.name().to_owned(), value.into()))
        .collect()
}

/// The name of the law of restitution; null where there is no restitution.
fn law(setup: &Setup, has_restitution: bool) -> Value {
    has_restitution
        .then(|| setup.hoop.restitution_law.unwrap_or_default().name())
        .into()
}

/// What a run computes, in JSON.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Description(pub(crate) Value);

impl Description {
    pub(crate) fn of_grid(grid: &Grid, limits: Limits, chunk: &[usize]) -> Self {
        let place = given(grid.base()).filter(|(quantity, _)| grid.axis(*quantity).is_none());
        let fixed = numbers(place);
        let axis = grid.axis(Quantity::Restitution).is_some();
        let has_restitution = axis || grid.base().get(Quantity::Restitution).is_some();
        let axes: Vec<Value> = grid
            .axes()
            .iter()
            .map(|axis| {
                let mut axis_value = json!({
                    "quantity": axis.varies().name(),
                    "from": axis.from(),
                    "to": axis.to(),
                    "count": axis.count(),
                });
                if axis.spacing() != Spacing::default() {
                    axis_value[SPACING] = axis.spacing().name().into();
                }
                axis_value
            })
            .collect();
        Self::with_derivatives(
            grid.derivatives(),
            json!({
                "version": env!("CARGO_PKG_VERSION"),
                "format": STORE_FORMAT,
                "sequence_version": PhaseSequence::VERSION,
                "points": "grid",
                "axes": axes,
                "fixed": fixed,
                RESTITUTION_LAW: law(grid.base(), has_restitution),
                "limits": of_limits(limits),
                "chunk": chunk,
            }),
        )
    }

    pub(crate) fn of_list(list: &StartList, limits: Limits, chunk: usize) -> Self {
        let base = numbers(given(list.base()));
        let column = list.columns().contains(&Quantity::Restitution);
        let has_restitution = column || list.base().get(Quantity::Restitution).is_some();
        Self::with_derivatives(
            list.derivatives(),
            json!({
                "version": env!("CARGO_PKG_VERSION"),
                "format": STORE_FORMAT,
                "sequence_version": PhaseSequence::VERSION,
                "points": "list",
                "list": list.fingerprint(),
                "base": base,
                RESTITUTION_LAW: law(list.base(), has_restitution),
                "limits": of_limits(limits),
                "chunk": chunk,
            }),
        )
    }

    /// Stores without derivatives say nothing of them.
    fn with_derivatives(derivatives: &[DerivativeColumn], mut value: Value) -> Self {
        if !derivatives.is_empty() {
            value[DERIVATIVES] =
                Vec::from_iter(derivatives.iter().map(DerivativeColumn::to_string)).into();
        }
        Self(value)
    }

    pub(crate) fn crc(&self) -> u32 {
        crc32fast::hash(self.0.to_string().as_bytes())
    }

    /// In what another description differs: `name: there / here`.
    pub(crate) fn differences(&self, there: &Value) -> Vec<String> {
        let mut differences = Vec::new();
        compare("", Some(there), Some(&self.0), &mut differences);
        differences
    }

    pub(crate) fn grid(value: &Value) -> Option<(Grid, Limits, Vec<usize>)> {
        let axes = value.get("axes")?.as_array()?;
        let axes = axes.iter().map(axis).collect::<Option<Vec<_>>>()?;
        let chunk = value.get("chunk")?.as_array()?;
        let chunk = chunk
            .iter()
            .map(|size| usize::try_from(size.as_u64()?).ok())
            .collect::<Option<Vec<_>>>()?;
        let derivatives = value
            .get(DERIVATIVES)
            .and_then(Value::as_array)
            .into_iter()
            .flatten();
        let derivatives = derivatives
            .map(|name| name.as_str()?.parse().ok())
            .collect::<Option<Vec<_>>>()?;
        let grid = Grid::new(base(value)?, axes).ok()?;
        Some((
            grid.with_derivatives(derivatives),
            read_limits(value.get("limits")?)?,
            chunk,
        ))
    }
}

/// The numbers that a run has in common.
fn base(run: &Value) -> Option<Setup> {
    let mut base = Setup::new(HoopParameters::default(), Start::default());
    for (name, number) in run.get("fixed")?.as_object()? {
        let quantity = name.parse().ok()?;
        base.set(quantity, number.as_f64()?);
        base.get(quantity)?;
    }
    if let Some(name) = run.get(RESTITUTION_LAW).and_then(Value::as_str) {
        base.hoop.restitution_law = Some(name.parse().ok()?);
    }
    Some(base)
}

fn axis(axis: &Value) -> Option<Axis> {
    let name = axis.get("quantity")?.as_str()?;
    let varies = if name == Varies::Friction.name() {
        Varies::Friction
    } else {
        Varies::One(name.parse().ok()?)
    };
    let count = usize::try_from(axis.get("count")?.as_u64()?).ok()?;
    let spacing = match axis.get(SPACING) {
        None => Spacing::default(),
        Some(name) => [Spacing::Even, Spacing::Log]
            .into_iter()
            .find(|spacing| name == spacing.name())?,
    };
    let [from, to] = ["from", "to"].map(|end| axis.get(end).and_then(Value::as_f64));
    Axis::new(varies, from?, to?, count)
        .ok()?
        .with_spacing(spacing)
        .ok()
}

fn read_limits(limits: &Value) -> Option<Limits> {
    let slides = match limits.get("slides") {
        Some(slides) => usize::try_from(slides.as_u64()?).ok()?,
        None => Limits::default().slides,
    };
    Some(
        Limits::default()
            .with_until(limits.get("until")?.as_f64())
            .with_transitions(usize::try_from(limits.get("transitions")?.as_u64()?).ok()?)
            .with_slides(slides)
            .with_proof(limits.get("proof")?.as_str()?.parse().ok()?),
    )
}

fn of_limits(limits: Limits) -> Value {
    let mut value = json!({ "until": limits.until, "transitions": limits.transitions, "proof": limits.proof.name() });
    if limits.slides != Limits::default().slides {
        value["slides"] = json!(limits.slides);
    }
    value
}

fn compare(path: &str, there: Option<&Value>, here: Option<&Value>, differences: &mut Vec<String>) {
    // As text: -0.0 and 0.0 are equal as numbers, but not the same start.
    if there.map(Value::to_string) == here.map(Value::to_string) {
        return;
    }
    let join = |key: &str| {
        if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        }
    };
    match (there, here) {
        (Some(Value::Object(there)), Some(Value::Object(here))) => {
            let keys: std::collections::BTreeSet<_> = there.keys().chain(here.keys()).collect();
            for key in keys {
                compare(&join(key), there.get(key), here.get(key), differences);
            }
        }
        (Some(Value::Array(there)), Some(Value::Array(here))) if there.len() == here.len() => {
            for (i, (there, here)) in there.iter().zip(here).enumerate() {
                compare(&join(&i.to_string()), Some(there), Some(here), differences);
            }
        }
        _ => {
            let show = |value: Option<&Value>| {
                value.map_or_else(|| "nothing".to_owned(), Value::to_string)
            };
            differences.push(format!(
                "{path}: {} there, {} here",
                show(there),
                show(here)
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_comes_back_from_its_description() {
        let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
        let friction = Axis::new(Varies::Friction, 0.01, 1.0, 5)
            .and_then(|axis| axis.with_spacing(Spacing::Log));
        let theta = Axis::new(Quantity::Theta, -1.0, 1.0, 3);
        let axes = vec![friction.expect("an axis"), theta.expect("an axis")];
        let derivatives = vec!["end_x_by_mu_k".parse().expect("a derivative")];
        let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 1.0)), axes).expect("a grid");
        let grid = grid.with_derivatives(derivatives);
        let description = Description::of_grid(&grid, Limits::default(), &[5, 3]);
        let (again, limits, chunk) =
            Description::grid(&description.0).expect("a description of a grid");
        assert_eq!(
            (again, limits, chunk),
            (grid, Limits::default(), vec![5, 3])
        );
        // Stores of evenly spaced axes are as they have always been.
        assert!(description.0["axes"][1].get(SPACING).is_none());
    }
}
