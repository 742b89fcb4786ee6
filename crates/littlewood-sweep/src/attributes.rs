//! What stores say of their columns: the attributes of the CF conventions, and how codes are to be read.

use littlewood::OutcomeKind;
use littlewood::tables::{ColumnType, Dimension, PhaseCode, PhaseSequence, Quantity, SummaryColumn};
use serde_json::{Map, Value, json};

use crate::axis::Varies;

/// The conventions that the attributes follow.
pub(crate) const CONVENTIONS: &str = "CF-1.11";

/// Attributes, by their names.
pub(crate) type Attributes = Map<String, Value>;

/// Of a quantity of a hoop or a start.
pub(crate) fn of_quantity(quantity: Quantity) -> Attributes {
    let mut attributes = named(quantity.long_name());
    attributes.extend(units(quantity.dimension()));
    attributes
}

/// Of an axis.
pub(crate) fn of_axis(varies: Varies) -> Attributes {
    let mut attributes = named(varies.long_name());
    attributes.extend(units(varies.dimension()));
    attributes
}

/// Of a column of results, as numbers.
pub(crate) fn of_column(column: SummaryColumn) -> Attributes {
    let mut attributes = named(column.long_name());
    attributes.extend(match column.column_type() {
        ColumnType::Outcome => {
            let codes = OutcomeKind::ALL.map(OutcomeKind::code);
            flags(&codes, &OutcomeKind::NAMES)
        }
        ColumnType::Flag => flags(&[0, 1], &["no", "yes"]),
        ColumnType::Sequence => {
            let legend = PhaseCode::ALL
                .into_iter()
                .map(|phase| (phase.code().to_string(), format!("{phase}: {}", phase.meaning()).into()));
            let end = [("0".to_owned(), "end of the sequence".into())];
            let legend: Attributes = end.into_iter().chain(legend).collect();
            attributes_of([
                ("encoding", PhaseSequence::ENCODING.into()),
                ("version", PhaseSequence::VERSION.into()),
                ("legend", legend.into()),
            ])
        }
        ColumnType::Count | ColumnType::Real => units(column.dimension()),
    });
    attributes
}

/// Of a column of results that holds words.
pub(crate) fn of_words(column: SummaryColumn) -> Attributes {
    let mut attributes = named(column.long_name());
    if column.column_type() == ColumnType::Sequence {
        let letters = PhaseCode::ALL.map(|phase| format!("{phase} {}", phase.meaning()));
        attributes.insert("legend".to_owned(), letters.join(", ").into());
    }
    attributes
}

fn attributes_of<const N: usize>(attributes: [(&str, Value); N]) -> Attributes {
    attributes.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

fn named(long_name: &str) -> Attributes {
    attributes_of([("long_name", long_name.into())])
}

/// `units` that UDUNITS can parse, and the scale of (2.9) of which the values are multiples.
fn units(dimension: Dimension) -> Attributes {
    attributes_of([("units", dimension.cf_unit().into()), ("scale", dimension.scale().into())])
}

fn flags(codes: &[u8], names: &[&str]) -> Attributes {
    attributes_of([("flag_values", json!(codes)), ("flag_meanings", names.join(" ").into())])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// UDUNITS parses `1` and `rad`; it refuses scales such as `sqrt(R/g)`, and reads `R` as roentgen, `m2` as square metres.
    const PARSED_BY_UDUNITS: [&str; 2] = ["1", "rad"];

    #[test]
    fn units_can_be_parsed_and_scales_stand_beside_them() {
        let quantities = Quantity::HOOP.into_iter().chain(Quantity::START).map(of_quantity);
        let columns = SummaryColumn::ALL.into_iter().map(of_column);
        for attributes in quantities.chain(columns) {
            assert!(attributes["long_name"].is_string());
            match attributes.get("units") {
                Some(units) => {
                    assert!(PARSED_BY_UDUNITS.contains(&units.as_str().unwrap()));
                    assert!(attributes["scale"].is_string());
                }
                None => assert!(attributes.contains_key("flag_values") || attributes.contains_key("legend")),
            }
        }
    }

    #[test]
    fn flags_have_a_meaning_of_one_word_for_each_value() {
        for column in SummaryColumn::ALL {
            let attributes = of_column(column);
            let Some(values) = attributes.get("flag_values") else { continue };
            let words = attributes["flag_meanings"].as_str().unwrap().split(' ').count();
            assert_eq!(values.as_array().unwrap().len(), words, "{column}");
        }
    }
}
