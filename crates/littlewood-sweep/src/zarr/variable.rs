//! The columns of a store: name, type, fill value, attributes, and their values as bytes.

use serde_json::{Map, Value, json};
use zarrs::array::builder::ArrayBuilderFillValue;
use zarrs::array::{DataType, data_type};

use crate::columns::{Columns, Real};
use crate::outcome::{NOT_COMPUTED, codes};

/// What the letters of a sequence mean; three bits a phase, the first phase lowest.
const SEQUENCE_LEGEND: [(&str, &str); 8] = [
    ("0", "end of the sequence"),
    ("1", "R: rolling"),
    ("2", "-: sliding with negative slip velocity"),
    ("3", "+: sliding with positive slip velocity"),
    ("4", "n: gliding with negative slip velocity"),
    ("5", "g: gliding with positive slip velocity"),
    ("6", "G: gliding without slip"),
    ("7", "F: flight"),
];

/// A column of the store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variable {
    Outcome,
    Sequence,
    Transitions,
    Painleve,
    Real(Real),
}

impl Variable {
    pub(super) fn all() -> impl Iterator<Item = Self> {
        [Self::Outcome, Self::Sequence, Self::Transitions, Self::Painleve]
            .into_iter()
            .chain(Real::ALL.into_iter().map(Self::Real))
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Outcome => "outcome",
            Self::Sequence => "sequence",
            Self::Transitions => "transitions",
            Self::Painleve => "painleve",
            Self::Real(column) => column.name(),
        }
    }

    pub(super) fn data_type(self) -> DataType {
        match self {
            Self::Outcome | Self::Painleve => data_type::uint8(),
            Self::Sequence => data_type::uint64(),
            Self::Transitions => data_type::uint32(),
            Self::Real(_) => data_type::float64(),
        }
    }

    pub(super) fn fill_value(self) -> ArrayBuilderFillValue {
        match self {
            Self::Outcome => NOT_COMPUTED.into(),
            Self::Painleve => 0_u8.into(),
            Self::Sequence => 0_u64.into(),
            Self::Transitions => 0_u32.into(),
            Self::Real(_) => f64::NAN.into(),
        }
    }

    pub(super) fn attributes(self) -> Map<String, Value> {
        let attributes = match self {
            Self::Outcome => json!({
                "long_name": "outcome",
                "flag_values": codes().map(|(code, _)| code).collect::<Vec<_>>(),
                "flag_meanings": codes().map(|(_, name)| name).collect::<Vec<_>>().join(" "),
            }),
            Self::Sequence => {
                let legend: Map<String, Value> = SEQUENCE_LEGEND
                    .iter()
                    .map(|&(code, meaning)| (code.to_owned(), meaning.into()))
                    .collect();
                json!({
                    "long_name": "sequence of phases",
                    "encoding": "3 bits a phase, the first phase lowest, up to 20 phases; bit 63 is set if there are more",
                    "legend": legend,
                })
            }
            Self::Transitions => json!({ "long_name": "number of transitions", "units": "1" }),
            Self::Painleve => json!({
                "long_name": "whether the motion met a Painlevé paradox",
                "flag_values": [0, 1],
                "flag_meanings": "no yes",
            }),
            Self::Real(column) => json!({ "long_name": column.long_name(), "units": column.unit() }),
        };
        match attributes {
            Value::Object(map) => map,
            _ => Map::new(),
        }
    }

    /// The values of a chunk in a box of the full chunk size, little-endian.
    pub(super) fn bytes(self, columns: &Columns, places: &[usize], size: usize) -> Vec<u8> {
        fn spread<const N: usize>(
            places: &[usize],
            size: usize,
            fill: [u8; N],
            value: impl Fn(usize) -> [u8; N],
        ) -> Vec<u8> {
            let mut bytes = if places.len() == size { vec![0; size * N] } else { fill.repeat(size) };
            for (i, &place) in places.iter().enumerate() {
                bytes[place * N..(place + 1) * N].copy_from_slice(&value(i));
            }
            bytes
        }
        match self {
            Self::Outcome => spread(places, size, [NOT_COMPUTED], |i| [columns.outcome[i]]),
            Self::Painleve => spread(places, size, [0], |i| [columns.painleve[i]]),
            Self::Sequence => spread(places, size, [0; 8], |i| columns.sequence[i].to_le_bytes()),
            Self::Transitions => spread(places, size, [0; 4], |i| columns.transitions[i].to_le_bytes()),
            Self::Real(column) => {
                let values = columns.real(column);
                spread(places, size, f64::NAN.to_le_bytes(), |i| values[i].to_le_bytes())
            }
        }
    }

    /// Takes the values of a chunk out of a box of the full chunk size.
    pub(super) fn read(self, bytes: &[u8], places: &[usize], columns: &mut Columns) {
        fn word<const N: usize>(bytes: &[u8], place: usize) -> [u8; N] {
            core::array::from_fn(|i| bytes[place * N + i])
        }
        for (i, &place) in places.iter().enumerate() {
            match self {
                Self::Outcome => columns.outcome[i] = bytes[place],
                Self::Painleve => columns.painleve[i] = bytes[place],
                Self::Sequence => columns.sequence[i] = u64::from_le_bytes(word(bytes, place)),
                Self::Transitions => columns.transitions[i] = u32::from_le_bytes(word(bytes, place)),
                Self::Real(column) => {
                    columns.reals[column as usize][i] = f64::from_le_bytes(word(bytes, place));
                }
            }
        }
    }
}
