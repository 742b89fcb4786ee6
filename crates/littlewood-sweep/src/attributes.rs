//! What stores say of their columns: the attributes of the CF conventions, and how codes are to be
//! read.

use littlewood::OutcomeKind;
use littlewood::tables::{
    ColumnType, DerivativeColumn, Dimension, PhaseCode, PhaseSequence, SummaryColumn,
};
use serde_json::{Map, Value, json};

use crate::axis::Varies;
use crate::columns::Column;

pub(crate) const CONVENTIONS: &str = "CF-1.11";

pub(crate) type Attributes = Map<String, Value>;

pub(crate) fn of_axis(varies: Varies) -> Attributes {
    named(varies.long_name())
        .into_iter()
        .chain(units(varies.dimension()))
        .collect()
}

pub(crate) fn of_column(column: Column) -> Attributes {
    match column {
        Column::Summary(column) => of_summary(column),
        Column::Derivative(column) => {
            let [long_name, units, scale] = of_derivative(column);
            attributes_of([
                ("long_name", long_name.into()),
                ("units", units.into()),
                ("scale", scale.into()),
            ])
        }
    }
}

/// Long name, unit and scale of a derivative.
pub fn of_derivative(DerivativeColumn { number, quantity }: DerivativeColumn) -> [String; 3] {
    let [over, under] = [number.dimension(), quantity.dimension()];
    let units = match [over, under].map(Dimension::cf_unit) {
        [over, "1"] => over.to_owned(),
        ["1", under] => format!("{under}-1"),
        [over, under] => format!("{over} {under}-1"),
    };
    let scale = match [over, under].map(Dimension::scale) {
        [over, "1"] => over.to_owned(),
        [over, under] => format!("{over}/({under})"),
    };
    let long_name = format!(
        "derivative of the {} by the {}",
        number.long_name(),
        quantity.long_name()
    );
    [long_name, units, scale]
}

fn of_summary(column: SummaryColumn) -> Attributes {
    let mut attributes = named(column.long_name());
    attributes.extend(match column.column_type() {
        ColumnType::Outcome => {
            let codes = OutcomeKind::ALL.map(OutcomeKind::code);
            flags(&codes, &OutcomeKind::NAMES)
        }
        ColumnType::Flag => flags(&[0, 1], &["no", "yes"]),
        ColumnType::Sequence => {
            // In the order of the codes: a map of JSON would sort them as texts, 10 before 2.
            let end = (0, "end of the sequence".to_owned());
            let legend =
                PhaseCode::ALL.map(|phase| (phase.code(), format!("{phase}: {}", phase.meaning())));
            let entries = [end].into_iter().chain(legend).map(|(code, meaning)| {
                let meaning = Value::from(meaning);
                format!("\"{code}\":{meaning}")
            });
            let legend = Vec::from_iter(entries).join(",");
            attributes_of([
                ("encoding", PhaseSequence::ENCODING.into()),
                ("version", PhaseSequence::VERSION.into()),
                ("legend", format!("{{{legend}}}").into()),
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

fn attributes_of<'a>(attributes: impl IntoIterator<Item = (&'a str, Value)>) -> Attributes {
    attributes
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}

fn named(long_name: &str) -> Attributes {
    attributes_of([("long_name", long_name.into())])
}

/// `units` that UDUNITS can parse, and the scale of (2.9) of which the values are multiples.
fn units(dimension: Dimension) -> Attributes {
    attributes_of([
        ("units", dimension.cf_unit().into()),
        ("scale", dimension.scale().into()),
    ])
}

fn flags(codes: &[u8], names: &[&str]) -> Attributes {
    attributes_of([
        ("flag_values", json!(codes)),
        ("flag_meanings", names.join(" ").into()),
    ])
}

#[cfg(test)]
mod tests {
    use littlewood::tables::Quantity;

    use super::*;

    /// UDUNITS parses `1` and `rad`; it refuses scales such as `sqrt(R/g)`, and reads `R` as
    /// roentgen, `m2` as square metres.
    const PARSED_BY_UDUNITS: [&str; 2] = ["1", "rad"];

    #[test]
    fn derivatives_have_the_units_of_their_quotients() {
        let of = |name: &str| of_derivative(name.parse().expect("a derivative"));
        let [long_name, units, scale] = of("jump_length_by_theta_rate");
        assert_eq!(
            long_name,
            "derivative of the length of the first jump by the rate of the angle"
        );
        assert_eq!([units.as_str(), scale.as_str()], ["1", "R/(sqrt(g/R))"]);
        let [_, units, scale] = of("end_theta_by_theta");
        assert_eq!([units.as_str(), scale.as_str()], ["rad rad-1", "1"]);
        let [_, units, scale] = of("end_x_by_theta");
        assert_eq!([units.as_str(), scale.as_str()], ["rad-1", "R"]);
        assert!("end_x_by_gravity".parse::<DerivativeColumn>().is_err());
        assert!("outcome_by_theta".parse::<DerivativeColumn>().is_err());
    }

    #[test]
    fn units_can_be_parsed_and_scales_stand_beside_them() {
        let quantities = Quantity::HOOP
            .into_iter()
            .chain(Quantity::START)
            .map(|it| of_axis(it.into()));
        let columns = SummaryColumn::ALL.into_iter().map(of_summary);
        for attributes in quantities.chain(columns) {
            assert!(attributes["long_name"].is_string());
            match attributes.get("units") {
                Some(units) => {
                    assert!(PARSED_BY_UDUNITS.contains(&units.as_str().unwrap()));
                    assert!(attributes["scale"].is_string());
                }
                None => assert!(
                    attributes.contains_key("flag_values") || attributes.contains_key("legend")
                ),
            }
        }
    }

    #[test]
    fn flags_have_a_meaning_of_one_word_for_each_value() {
        for column in SummaryColumn::ALL {
            let attributes = of_summary(column);
            let Some(values) = attributes.get("flag_values") else {
                continue;
            };
            let words = attributes["flag_meanings"]
                .as_str()
                .unwrap()
                .split(' ')
                .count();
            assert_eq!(values.as_array().unwrap().len(), words, "{column}");
        }
    }
}
