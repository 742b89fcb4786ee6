//! What moves an event, and by how much, to first order.

use core::cmp::Ordering;

use littlewood::derivatives::{Derivative, NoDerivative, differentiable};
use littlewood::si::{SiSetup, Units};
use littlewood::tables::{Dimension, Group, Quantity};
use littlewood::{Cause, State, Transition};
use littlewood_report::number::{brief, three};
use littlewood_report::scale::Scale;
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::partials::{Change, Partials};
use crate::problem::Problem;

/// The part of a quantity by which it is changed, or of its usual range where it is 0.
const PART: f64 = 0.01;

/// What a small change of each quantity moves an event by.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Moves {
    cause: Cause,
    units: Option<Units>,
    rows: Vec<Row>,
}

#[derive(Clone, Copy, Debug)]
struct Row {
    quantity: Quantity,
    /// Whether the change is a part of the usual range.
    is_of_range: bool,
    /// In the units of the problem, as what follows.
    change: f64,
    moved: Derivative<Change>,
}

impl Row {
    fn moved(&self, column: usize) -> Derivative<f64> {
        self.moved
            .map(|numbers| numbers.get(column).copied().unwrap_or_default())
    }
}

#[wasm_bindgen]
impl Moves {
    /// Of a transition of the motion of a problem; none if there is no such transition.
    pub fn of(problem: &Problem, transition: usize) -> Option<Self> {
        let (trajectory, partials) = Partials::of(problem, transition)?;
        let event = trajectory.transitions().get(transition)?;
        Some(Self {
            cause: event.cause,
            units: problem.units,
            rows: rows(problem, event, &partials),
        })
    }

    /// The quantities, what each is changed by, and by how much that moves a column of
    /// [`State::COLUMNS`], as JSON: the largest move first, and last what has no derivative, with
    /// the reason.
    pub fn rows(&self, column: usize) -> String {
        let row = |row: &Row| {
            json!({
                "quantity": row.quantity.name(),
                "change": row.change,
                "moved": row.moved(column).ok(),
                "reason": row.moved.err().map(NoDerivative::label),
            })
        };
        Value::from_iter(self.sorted(column).into_iter().map(row)).to_string()
    }

    /// The quantity that moves a column most.
    pub fn sentence(&self, column: usize) -> String {
        let event = self.cause.label();
        let rows = self.sorted(column);
        let (Some(row), Some(column_moved)) = (rows.first(), State::COLUMNS.get(column)) else {
            return String::new();
        };
        let moved = match row.moved(column) {
            Err(reason) => {
                return format!(
                    "Nothing is known of what moves this event ({event}): {}.",
                    reason.label()
                );
            }
            Ok(0.0) => return format!("Nothing moves this event ({event})."),
            Ok(moved) => moved,
        };
        let scale = Scale::new(self.units.as_ref());
        let unit = column_moved
            .dimension()
            .map_or("", |it| unit_of(it, self.units.is_some()));
        let (sign, name) = (row.quantity.sign(), row.quantity.long_name());
        let part = if row.is_of_range {
            "of its usual range"
        } else {
            "of it"
        };
        let plus = if moved > 0.0 { "+" } else { "" };
        let by = format!("{plus}{} {unit}", brief(three(moved)));
        format!(
            "This event ({event}) moves most with {sign}, the {name}: +1 % {part} moves {} by {}.",
            scale.column_sign(*column_moved),
            by.trim_end()
        )
    }
}

impl Moves {
    fn sorted(&self, column: usize) -> Vec<&Row> {
        let mut rows: Vec<&Row> = self.rows.iter().collect();
        rows.sort_by(
            |one, other| match (one.moved(column), other.moved(column)) {
                (Ok(one), Ok(other)) => other.abs().total_cmp(&one.abs()),
                (Ok(_), Err(_)) => Ordering::Less,
                (Err(_), Ok(_)) => Ordering::Greater,
                (Err(_), Err(_)) => Ordering::Equal,
            },
        );
        rows
    }
}

/// What a small change of each quantity moves a transition by.
fn rows(problem: &Problem, event: &Transition, partials: &Partials) -> Vec<Row> {
    let setup = problem.setup();
    let row = |(quantity, value): (Quantity, f64)| {
        let [least, most] = quantity.row().usual;
        let is_of_range = value == 0.0;
        let change = PART * if is_of_range { most - least } else { value };
        let moved = match (&problem.units, unit_place(quantity)) {
            (None, _) => partials.move_of(|other| if other == quantity { change } else { 0.0 }),
            (Some(units), None) => {
                let plain = quantity.dimensionless();
                let change = units.from_si(plain.dimension(), change);
                partials
                    .move_of(|other| if other == plain { change } else { 0.0 })
                    .map(|moved| {
                        in_columns(moved, |dimension, moved| units.to_si(dimension, moved))
                    })
            }
            // A unit that grows makes the dimensionless numbers smaller, and those of the event
            // in SI units larger.
            (Some(units), Some(place)) => {
                let growth =
                    |dimension: Dimension| PART * 0.5 * f64::from(dimension.halves()[place]);
                let change =
                    |other: Quantity| -growth(other.dimension()) * setup.get(other).unwrap_or(0.0);
                let numbers = event.after.numbers();
                partials.move_of(change).map(|mut moved| {
                    for ((moved, number), column) in
                        moved.iter_mut().zip(numbers).zip(State::COLUMNS)
                    {
                        *moved += column.dimension().map_or(0.0, growth) * number;
                    }
                    in_columns(moved, |dimension, moved| units.to_si(dimension, moved))
                })
            }
        };
        Row {
            quantity,
            is_of_range,
            change,
            moved,
        }
    };
    values(problem).map(row).collect()
}

/// The quantities of hoop, plane and start on which the motion depends, in the units of a problem,
/// with their values.
fn values(problem: &Problem) -> impl Iterator<Item = (Quantity, f64)> {
    let setup = problem.setup();
    let si = problem
        .units
        .as_ref()
        .map(|units| SiSetup::new(&setup, units));
    let (hoop, start): (&'static [Quantity], &'static [Quantity]) = match si {
        None => (&Quantity::HOOP, &Quantity::START),
        Some(_) => (&Quantity::SI_HOOP, &Quantity::SI_START),
    };
    hoop.iter()
        .chain(start)
        .copied()
        .filter(|quantity| match quantity.group() {
            Group::Hoop | Group::Start => {
                differentiable(true).any(|known| known == quantity.dimensionless())
            }
            Group::Units => true,
            Group::Place | Group::Run => false,
        })
        .filter_map(move |quantity| {
            let value = match &si {
                None => setup.get(quantity),
                Some(si) => si.get(quantity),
            };
            Some((quantity, value?))
        })
}

/// The place of a quantity among the exponents of m2, R and g.
fn unit_place(quantity: Quantity) -> Option<usize> {
    [
        Quantity::ParticleMassKg,
        Quantity::RadiusM,
        Quantity::GravityMPerS2,
    ]
    .iter()
    .position(|unit| *unit == quantity)
}

fn in_columns(mut change: Change, convert: impl Fn(Dimension, f64) -> f64) -> Change {
    for (number, column) in change.iter_mut().zip(State::COLUMNS) {
        if let Some(dimension) = column.dimension() {
            *number = convert(dimension, *number);
        }
    }
    change
}

const fn unit_of(dimension: Dimension, is_si: bool) -> &'static str {
    match (dimension, is_si) {
        (Dimension::Angle, _) | (_, true) => dimension.si_sign(),
        (_, false) => dimension.scale_sign(),
    }
}
