//! Without colours: any two kinds of lines in a panel differ in lightness, in dashes or in width.

use littlewood::cases::CASES;
use littlewood_figures::{FIGURES, Figure, FigureInput, Mark, Panel, Stroke};

/// Least difference in CIE lightness, as for modes and classes.
const LIGHTNESS: f64 = 12.0;
/// Least ratio of the widths of two lines that are told apart by them.
const WIDER: f64 = 1.45;

pub(crate) fn are_told_apart(a: Stroke, b: Stroke) -> bool {
    let lightness = (a.colour.lightness() - b.colour.lightness()).abs();
    let ratio = a.width.max(b.width) / a.width.min(b.width);
    a.dash != b.dash || lightness > LIGHTNESS || ratio > WIDER
}

/// The paper, in which lines over areas are edged.
const PAPER: [u8; 3] = [255; 3];

/// The lines of a panel, each kind once with the name of a series that has it.
fn lines(panel: &Panel) -> Vec<(&str, Stroke)> {
    let mut found: Vec<(&str, Stroke)> = Vec::new();
    for layer in &panel.layers {
        let (Mark::Line(stroke) | Mark::Arrow(stroke)) = layer.mark else {
            continue;
        };
        if stroke.colour.0 == PAPER {
            continue;
        }
        if layer.series.rows().next().is_some() && found.iter().all(|(_, other)| *other != stroke) {
            found.push((&layer.series.name, stroke));
        }
    }
    found
}

/// What cannot be told apart.
fn check(figure: &Figure, case: &str) -> Vec<String> {
    let mut found = Vec::new();
    for panel in &figure.panels {
        let lines = lines(panel);
        for (i, (a, first)) in lines.iter().enumerate() {
            for (b, second) in &lines[..i] {
                if !are_told_apart(*first, *second) {
                    let place = format!("{}, {}, {case}", figure.name, panel.name);
                    found.push(format!("{place}: {a}, {first:?}, and {b}, {second:?}"));
                }
            }
        }
        // A key means one thing.
        for (i, key) in panel.keys.iter().enumerate() {
            if panel.keys[..i].iter().any(|other| other.mark == key.mark) {
                found.push(format!(
                    "{}, {case}: two keys have the mark of '{}'",
                    figure.name, key.text
                ));
            }
        }
    }
    found
}

#[test]
fn any_two_kinds_of_lines_in_a_panel_are_told_apart_without_colours() {
    let (mut panels, mut failures) = (0, Vec::new());
    // The first is a drawing of the body, whose lines are no data.
    for entry in &FIGURES[1..] {
        for case in CASES
            .iter()
            .filter(|case| entry.name != "outcomes" || case.name == entry.case)
        {
            let input = FigureInput::of_case(case.name).expect("a case");
            let input = FigureInput {
                limits: input.limits.with_until(Some(30.0)),
                ..input
            };
            if let Ok(figure) = entry.figure(&input) {
                failures.extend(check(&figure, case.name));
                panels += figure.panels.len();
            }
        }
    }
    assert!(panels > 150, "{panels}");
    assert!(failures.is_empty(), "{failures:#?}");
}
