//! Captions of all figures of all named motions are LaTeX.

use littlewood::si::SiParameters;
use littlewood_figures::{FIGURES, FigureInput};

/// What LaTeX would not take.
fn faults(tex: &str) -> Vec<String> {
    let mut found = Vec::new();
    found.extend(
        tex.chars()
            .filter(|letter| !letter.is_ascii())
            .map(|letter| format!("letter {letter}")),
    );
    for (open, close) in [('{', '}'), ('[', ']')] {
        let count = |wanted: char| tex.chars().filter(|letter| *letter == wanted).count();
        if count(open) != count(close) {
            found.push(format!("{open} without {close}"));
        }
    }
    if tex.contains("$$") {
        found.push("an empty formula".to_owned());
    }
    let (mut is_formula, mut last) = (false, ' ');
    for letter in tex.chars() {
        match letter {
            '$' if last != '\\' => is_formula = !is_formula,
            '%' | '&' | '#' if last != '\\' => found.push(format!("{letter} alone")),
            '^' | '_' if !is_formula && last != '\\' => found.push(format!("{letter} in a text")),
            '~' => found.push("~".to_owned()),
            _ => {}
        }
        last = if last == '\\' && letter == '\\' {
            ' '
        } else {
            letter
        };
    }
    if is_formula {
        found.push("a formula without end".to_owned());
    }
    found
}

#[test]
fn captions_have_nothing_that_latex_does_not_take() {
    assert_eq!(faults("5% of $x$ é").len(), 2);
    let units = SiParameters {
        particle_mass_kg: 0.14,
        radius_m: 0.45,
        gravity_m_per_s2: 9.81,
        ..SiParameters::default()
    }
    .units()
    .expect("units");
    let mut count = 0;
    for case in littlewood::cases::CASES {
        let input = FigureInput::of_case(case.name).expect("a case");
        let limits = input.limits.with_until(Some(30.0));
        for units in [None, Some(units)] {
            let input = FigureInput {
                limits,
                units,
                ..input
            };
            // Slow figures are set for their own case only: other cases change just the numbers in
            // their captions.
            let slow = |name| name == "outcomes";
            for entry in FIGURES
                .iter()
                .filter(|entry| entry.case == case.name || !slow(entry.name))
            {
                if let Ok(figure) = entry.figure(&input) {
                    let tex = figure.caption_tex();
                    assert_eq!(
                        faults(&tex),
                        [""; 0],
                        "{} of {}: {tex}",
                        entry.name,
                        case.name
                    );
                    count += 1;
                }
            }
        }
    }
    assert!(count > 200, "{count}");
}
