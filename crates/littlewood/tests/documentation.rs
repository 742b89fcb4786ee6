//! What docs/sweep.md lists stands in the tables of the core.

use littlewood::OutcomeKind;
use littlewood::tables::{Class, PhaseCode, Quantity, SummaryColumn};

const SWEEP: &str = include_str!("../../../docs/sweep.md");

/// The text from one heading to the next, on one line.
fn section(heading: &str) -> String {
    let (_, text) = SWEEP
        .split_once(&format!("\n## {heading}\n"))
        .expect("a heading of docs/sweep.md");
    let text = text.split("\n## ").next().unwrap_or_default();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_columns_are_those_of_a_summary() {
    let text = section("Columns");
    for column in SummaryColumn::ALL {
        let begins = text.contains(&format!("| `{column}`"));
        assert!(
            begins || text.contains(&format!(", `{column}`")),
            "{column}"
        );
    }
}

#[test]
fn the_codes_are_those_of_outcomes_and_phases() {
    let text = section("Columns");
    for outcome in OutcomeKind::ALL {
        assert!(
            text.contains(&format!(" {} {outcome}", outcome.code())),
            "{outcome}"
        );
    }
    for phase in PhaseCode::ALL {
        assert!(
            text.contains(&format!(" {} `{phase}`", phase.code())),
            "{phase}"
        );
    }
}

#[test]
fn the_classes_are_those_of_the_core() {
    let text = section("Classes");
    for class in Class::ALL {
        assert!(text.contains(&format!("`{class}`")), "{class}");
    }
}

#[test]
fn the_columns_of_a_list_are_quantities_of_a_hoop_and_a_start() {
    let text = SWEEP.split_whitespace().collect::<Vec<_>>().join(" ");
    let (listed, _) = text
        .split_once(", in any order")
        .expect("the columns of a list");
    let (_, listed) = listed
        .rsplit_once(" Columns are ")
        .expect("the first of them");
    let mut listed: Vec<&str> = listed
        .split(", ")
        .map(|name| name.trim_matches('`'))
        .collect();
    let mut known: Vec<&str> = Quantity::HOOP
        .into_iter()
        .chain(Quantity::START)
        .map(Quantity::name)
        .collect();
    listed.sort_unstable();
    known.sort_unstable();
    assert_eq!(listed, known);
}
