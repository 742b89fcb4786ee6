//! What was seen when every figure was looked at: each of these was once not so.

use crate::support::{columns, series};
use core::f64::consts::PI;
use littlewood::cases::CASES;
use littlewood::theory::PhasePlane;
use littlewood::{Hoop, HoopParameters, Limits, Mode, OutcomeKind, Start};
use littlewood_figures::{
    FIGURES, Figure, FigureInput, Mark, Point, Scale, View, find_figure, plain,
};
use littlewood_style::{EnergyPart, Theme};

fn of_case(name: &str, case: &str) -> Figure {
    let input = FigureInput::of_case(case).expect("a case");
    find_figure(name)
        .expect("a name of the catalogue")
        .figure(&input)
        .expect("it can be drawn")
}

/// All figures of all cases, but for the slow ones.
fn all(mut check: impl FnMut(&Figure, &str)) {
    for case in CASES {
        let input = FigureInput::of_case(case.name).expect("a case");
        for entry in FIGURES.iter().filter(|entry| entry.name != "outcomes") {
            if let Ok(figure) = entry.figure(&input) {
                check(&figure, case.name);
            }
        }
    }
}

#[test]
fn each_key_is_of_something_that_is_drawn() {
    all(|figure, case| {
        let layers = || figure.panels.iter().flat_map(|panel| &panel.layers);
        for key in figure.panels.iter().flat_map(|panel| &panel.keys) {
            // Those of Figure 3(b) say what a width means, in any colour.
            if key.text.starts_with("thick: ") || key.text.starts_with("thin: ") {
                continue;
            }
            let is_it = |mark: Mark| match (mark, key.mark) {
                (Mark::Line(a) | Mark::Arrow(a), Mark::Line(b) | Mark::Arrow(b)) => {
                    a.colour == b.colour && a.dash == b.dash
                }
                (Mark::Hoop(hoop), Mark::Line(b)) => {
                    hoop.rim.colour == b.colour && hoop.rim.dash == b.dash
                }
                (a, b) => core::mem::discriminant(&a) == core::mem::discriminant(&b),
            };
            let is_drawn =
                layers().any(|layer| is_it(layer.mark) && layer.series.rows().next().is_some());
            assert!(is_drawn, "{}, {case}: '{}'", figure.name, key.text);
        }
    });
}

#[test]
fn a_curve_of_a_motion_that_leaves_its_axes_is_marked_there() {
    let mut found = 0;
    all(|figure, case| {
        for panel in &figure.panels {
            let View::Plane { x, y, .. } = &panel.view else {
                continue;
            };
            let rows = |is_it: &dyn Fn(&str, Mark) -> bool| -> Vec<[f64; 2]> {
                let layers = panel.layers.iter();
                let series = layers
                    .filter(|layer| is_it(&layer.series.name, layer.mark))
                    .map(|layer| &layer.series);
                series
                    .filter(|series| {
                        series
                            .column(&x.column)
                            .and(series.column(&y.column))
                            .is_some()
                    })
                    .flat_map(|series| columns(series, [&x.column, &y.column]))
                    .filter(|[across, _]| x.range.contains(*across))
                    .collect()
            };
            let is_mode = |name: &str| Mode::ALL.iter().any(|mode| mode.name() == name);
            let data = rows(&|name, mark| is_mode(name) && matches!(mark, Mark::Line(_)));
            let marks = rows(&|_, mark| matches!(mark, Mark::Beyond(_)));
            let [low, high] = y.range.ends();
            for is_above in [false, true] {
                let is_out = |value: f64| if is_above { value > high } else { value < low };
                let farthest = |rows: &[[f64; 2]]| {
                    let values = rows.iter().map(|row| row[1]);
                    values
                        .filter(|value| is_out(*value))
                        .max_by(|a, b| a.abs().total_cmp(&b.abs()))
                };
                let wanted = farthest(&data);
                let what = || format!("{}, {}, {case}", figure.name, panel.name);
                assert_eq!(wanted, farthest(&marks), "{}", what());
                found += usize::from(wanted.is_some());
            }
        }
    });
    // The rate of a massless hoop, the forces of a light one.
    assert!(found > 2, "{found}");
}

#[test]
fn an_axis_that_is_not_linear_shows_it() {
    let mut found = 0;
    all(|figure, case| {
        for panel in &figure.panels {
            for axis in panel.axes() {
                let is_bent = axis.linear.is_finite() || axis.scale == Scale::Decades;
                if axis.scale == Scale::Nothing {
                    continue;
                }
                let small = axis.small_ticks();
                let what = || format!("{}, {}, {case}: {small:?}", figure.name, axis.title);
                assert_eq!(small.len() > 2, is_bent, "{}", what());
                // The labels are of values with small ticks, or of zero.
                let is_small = |value: f64| {
                    small
                        .iter()
                        .any(|small| (small - value).abs() <= 1e-12 * value.abs())
                };
                assert!(
                    !is_bent
                        || axis
                            .ticks
                            .iter()
                            .all(|tick| tick.value == 0.0 || is_small(tick.value)),
                    "{}: {:?}",
                    what(),
                    axis.ticks
                );
                found += usize::from(is_bent);
            }
        }
    });
    assert!(found > 2, "{found}");
}

/// What figures say of what they do not show begins so.
const LEFT_OUT: [&str; 5] = [
    "Shown is",
    "Shown are",
    "There is no room",
    "Outcomes vary",
    "Phases whose ends",
];

#[test]
fn what_a_caption_says_was_left_out_stands_in_the_picture() {
    let mut found = 0;
    all(|figure, case| {
        let texts: Vec<String> = figure.texts().into_iter().map(|(text, _)| text).collect();
        let seen = texts.join(" ");
        let caption = plain(&figure.caption);
        for part in LEFT_OUT {
            for (at, _) in caption.match_indices(part) {
                let sentence = &caption[at..];
                let end = sentence.find(". ").map_or(sentence.len(), |end| end + 1);
                let sentence = &sentence[..end];
                assert!(
                    seen.contains(sentence),
                    "{}, {case}: {sentence}",
                    figure.name
                );
                found += 1;
            }
        }
        for note in &figure.notes {
            assert!(
                caption.contains(&plain(note)) && seen.contains(&plain(note)),
                "{case}: {note}"
            );
        }
    });
    assert!(found > 2, "{found}");
}

#[test]
fn kinetic_and_potential_energy_have_colours_that_nothing_else_has() {
    all(|figure, case| {
        // What rolling resistance takes has the colour of its couple.
        let accents =
            [EnergyPart::Kinetic, EnergyPart::Potential].map(|it| it.colour(Theme::Light));
        let layers = || figure.panels.iter().flat_map(|panel| &panel.layers);
        let has_one = layers().any(|layer| match layer.mark {
            Mark::Line(stroke) => accents.contains(&stroke.colour),
            Mark::Fill(colour) => accents.contains(&colour),
            _ => false,
        });
        assert_eq!(has_one, figure.name == "energy", "{}, {case}", figure.name);
    });
}

#[test]
fn each_hoop_of_a_path_has_one_label_with_its_time() {
    for case in CASES {
        let input = FigureInput::of_case(case.name).expect("a case");
        let Ok(figure) = find_figure("figure-3b").expect("a figure").figure(&input) else {
            continue;
        };
        let hoops = series(&figure, "hoop")[0].rows().count();
        let labels = &figure.panels[0].labels;
        assert!(labels.len() <= hoops, "{}", case.name);
        assert!(
            labels.iter().all(|label| label.text.contains(" = ")),
            "{}",
            case.name
        );
    }
}

#[test]
fn the_name_of_the_weight_stands_on_no_curve() {
    for (case, name) in [
        ("ramp-jump", "weight × cos α"),
        ("figure-3", "weight"),
        ("jam", "weight"),
    ] {
        let figure = of_case("forces", case);
        let panel = &figure.panels[0];
        let texts = figure.texts();
        let (_, [left, top, right, bottom]) = texts
            .iter()
            .find(|(text, _)| text == name)
            .expect("the name");
        let normal = panel.layers.last().expect("the curve").series.rows();
        for Point { x, y } in normal.filter_map(|row| panel.place([row[0], row[1]].into())) {
            let beside = x < *left || x > *right || y < *top || y > *bottom;
            assert!(beside, "{case}: {x}, {y}");
        }
    }
}

#[test]
fn every_caption_of_a_hoop_on_a_slope_names_it() {
    for case in ["ramp-jump", "ramp-libration", "ramp-bounces", "uphill-disc"] {
        let input = FigureInput::of_case(case).expect("a case");
        for entry in FIGURES.iter().filter(|entry| entry.name != "outcomes") {
            let Ok(figure) = entry.figure(&input) else {
                continue;
            };
            assert!(
                plain(&figure.caption).contains("α = "),
                "{}, {case}: {}",
                entry.name,
                figure.caption
            );
        }
    }
}

#[test]
fn far_beyond_a_small_separatrix_all_starts_roll_for_ever() {
    for parameters in [
        HoopParameters::thin(1000.0),
        HoopParameters::thin(1.0).with_offset(1e-3),
    ] {
        let hoop = Hoop::new(parameters.with_friction(0.5, 0.4)).expect("a hoop");
        let separatrix = PhasePlane::new(&hoop).separatrix_rate(PI);
        for i in 0..40 {
            for j in -20..=20 {
                let start = Start::at(PI * f64::from(i) / 20.0, separatrix * f64::from(j));
                let kind = hoop
                    .simulate(start, Limits::default())
                    .expect("a motion")
                    .outcome()
                    .kind();
                // At an equilibrium it rolls, too.
                assert!(kind == OutcomeKind::RollsForever, "{start:?}: {kind}");
            }
        }
    }
}
