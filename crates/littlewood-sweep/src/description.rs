//! The description of a run, as stores keep it: two runs with the same description have the same result.

use littlewood::{HoopParameters, Limits, Start};
use serde_json::{Map, Value, json};

use crate::axis::{Axis, Coordinate};
use crate::grid::Grid;
use crate::point::Point;
use crate::starts::StartList;

/// What a run computes, in JSON.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Description(pub(crate) Value);

impl Description {
    pub(crate) fn of_grid(grid: &Grid, limits: Limits, chunk: &[usize]) -> Self {
        let fixed: Map<String, Value> = Coordinate::ALL
            .into_iter()
            .filter(|&coordinate| grid.axes().iter().all(|axis| axis.coordinate() != coordinate))
            .map(|coordinate| (coordinate.name().to_owned(), coordinate.of_point(grid.base()).into()))
            .collect();
        let axes: Vec<Value> = grid
            .axes()
            .iter()
            .map(|axis| {
                json!({
                    "quantity": axis.coordinate().name(),
                    "from": axis.from(),
                    "to": axis.to(),
                    "count": axis.count(),
                })
            })
            .collect();
        Self(json!({
            "version": env!("CARGO_PKG_VERSION"),
            "points": "grid",
            "axes": axes,
            "fixed": fixed,
            "start_time": grid.base().start.time,
            "start_x": grid.base().start.x,
            "limits": of_limits(limits),
            "chunk": chunk,
        }))
    }

    pub(crate) fn of_list(list: &StartList, limits: Limits, chunk: usize) -> Self {
        let base = list.base();
        let base_values: Map<String, Value> = Coordinate::ALL
            .into_iter()
            .map(|coordinate| (coordinate.name().to_owned(), coordinate.of_point(base).into()))
            .collect();
        Self(json!({
            "version": env!("CARGO_PKG_VERSION"),
            "points": "list",
            "list": list.fingerprint(),
            "base": base_values,
            "start_time": base.start.time,
            "start_x": base.start.x,
            "limits": of_limits(limits),
            "chunk": chunk,
        }))
    }

    /// CRC-32 of the text.
    pub(crate) fn crc(&self) -> u32 {
        crc32fast::hash(self.0.to_string().as_bytes())
    }

    /// What another description says otherwise: `name: there / here`.
    pub(crate) fn differences(&self, there: &Value) -> Vec<String> {
        let mut differences = Vec::new();
        compare("", Some(there), Some(&self.0), &mut differences);
        differences
    }

    /// The grid and the limits again.
    pub(crate) fn grid(value: &Value) -> Option<(Grid, Limits, Vec<usize>)> {
        let mut base = Point {
            hoop: HoopParameters { mass_ratio: 1.0, offset: 0.5, inertia: 1.0, mu_s: 0.0, mu_k: 0.0 },
            start: Start::at(0.0, 0.0)
                .with_time(value.get("start_time")?.as_f64()?)
                .with_x(value.get("start_x")?.as_f64()?),
        };
        for (name, number) in value.get("fixed")?.as_object()? {
            Coordinate::find(name)?.set(&mut base, number.as_f64()?);
        }
        let mut axes = Vec::new();
        for axis in value.get("axes")?.as_array()? {
            let coordinate = Coordinate::find(axis.get("quantity")?.as_str()?)?;
            let count = usize::try_from(axis.get("count")?.as_u64()?).ok()?;
            axes.push(
                Axis::new(coordinate, axis.get("from")?.as_f64()?, axis.get("to")?.as_f64()?, count).ok()?,
            );
        }
        let limits = value.get("limits")?;
        let limits = Limits {
            until: limits.get("until")?.as_f64(),
            transitions: usize::try_from(limits.get("transitions")?.as_u64()?).ok()?,
        };
        let chunk = value.get("chunk")?.as_array()?;
        let chunk =
            chunk.iter().map(|size| usize::try_from(size.as_u64()?).ok()).collect::<Option<Vec<_>>>()?;
        Some((Grid::new(base, axes).ok()?, limits, chunk))
    }
}

fn of_limits(limits: Limits) -> Value {
    json!({ "until": limits.until, "transitions": limits.transitions })
}

fn compare(path: &str, there: Option<&Value>, here: Option<&Value>, differences: &mut Vec<String>) {
    // As text: -0.0 and 0.0 are equal as numbers, but not the same start.
    if there.map(Value::to_string) == here.map(Value::to_string) {
        return;
    }
    let join = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
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
            let show = |value: Option<&Value>| value.map_or_else(|| "nothing".to_owned(), Value::to_string);
            differences.push(format!("{path}: {} there, {} here", show(there), show(here)));
        }
    }
}
