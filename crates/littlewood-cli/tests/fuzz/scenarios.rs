//! Scenario files: as they should be, and damaged.

use std::fmt::Write as _;
use std::fs;

use littlewood::tables::Quantity;
use serde_json::Value;

use crate::fuzz::damage::damage_text;
use crate::fuzz::program::{judge, run as run_program};
use crate::fuzz::{Case, Verdict};
use littlewood_random::Draw;

/// The examples that the program comes with.
const EXAMPLES: [&str; 4] = [
    include_str!("../../examples/figure-3.toml"),
    include_str!("../../examples/hula-hoop.toml"),
    include_str!("../../examples/pushed.toml"),
    include_str!("../../examples/thrown-ring.toml"),
];

pub(crate) fn run(case: &mut Case) -> Verdict {
    let draw = &mut case.draw;
    let mut text = if draw.comes(0.5) {
        draw.one_of(&EXAMPLES).to_owned()
    } else {
        written(draw)
    };
    while draw.comes(0.5) {
        text = damage_text(draw, &text);
    }
    let path = case.folder.join("scenario.toml");
    fs::write(&path, &text).expect("written");
    let words = [
        "simulate",
        "--scenario",
        "scenario.toml",
        "--format",
        "json",
    ]
    .map(str::to_owned);
    case.told.tell(format!(
        "littlewood simulate --format json --scenario {}",
        path.display()
    ));
    let ran = run_program(&words, &case.folder);
    let verdict = judge(&ran)?;
    // A scenario may name a file for the result.
    if verdict == "done" && !ran.stdout.is_empty() {
        serde_json::from_slice::<Value>(&ran.stdout).map_err(|error| format!("JSON: {error}"))?;
    }
    Ok(verdict)
}

/// A file with the numbers of a random motion.
fn written(draw: &mut Draw) -> String {
    let setup = draw.setup();
    let mut text = String::new();
    for (table, quantities) in [("hoop", &Quantity::HOOP[..]), ("start", &Quantity::START)] {
        let _ = writeln!(text, "[{table}]");
        for &quantity in quantities {
            if let Some(value) = setup.get(quantity) {
                let value = if draw.comes(0.02) {
                    draw.any(quantity)
                } else {
                    value
                };
                let _ = writeln!(text, "{} = {value:e}", quantity.name());
            }
        }
    }
    if let Some(law) = setup.hoop.restitution_law {
        text = text.replace("[start]", &format!("restitution_law = \"{law}\"\n[start]"));
    }
    if let Some(until) = draw.limits(setup.start).until {
        let _ = writeln!(text, "[run]\nuntil = {until:e}");
    }
    text
}
