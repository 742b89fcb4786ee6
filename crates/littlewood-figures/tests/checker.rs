//! All figures of random hoops and starts of the whole range, as lists of shapes: what stands on
//! what, what is cut, what is not there. 30 motions, or with `LITTLEWOOD_THOROUGH` 300; `--nocapture`
//! tells each defect.

use std::collections::BTreeMap;

use littlewood::{Limits, Mode};
use littlewood_figures::{FIGURES, Figure, FigureInput, Layer, Mark, Panel, Shape, Stroke, View};
use littlewood_random::Draw;

use crate::grey::are_told_apart;
use crate::random::{FRAME, shows_something};

/// What can be wrong with a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Defect {
    TextOnText,
    TextOnCurve,
    TextOutside,
    PanelWithoutInk,
    KeyWithoutMark,
    CutWithoutMark,
    AlikeInGrey,
    ChangeUnseen,
}

/// Pixels by which the box of letters reaches beyond their ink.
const AROUND: f64 = 2.0;

/// Whether a chord passes a box (Liang and Barsky).
fn passes([a, b]: [[f64; 2]; 2], [left, top, right, bottom]: [f64; 4]) -> bool {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (start, step, low, high) in [
        (a[0], b[0] - a[0], left, right),
        (a[1], b[1] - a[1], top, bottom),
    ] {
        if step == 0.0 {
            if start < low || start > high {
                return false;
            }
            continue;
        }
        let ends = [(low - start) / step, (high - start) / step];
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    from <= to
}

/// The lines of data of a figure.
fn curves(figure: &Figure) -> Vec<Stroke> {
    let layers = figure.panels.iter().flat_map(|panel| &panel.layers);
    let is_data = |layer: &&Layer| !FRAME.contains(&layer.series.name.as_str());
    layers
        .filter(is_data)
        .filter_map(|layer| match layer.mark {
            Mark::Line(stroke) if stroke.width > 1.0 => Some(stroke),
            _ => None,
        })
        .collect()
}

fn texts(figure: &Figure, found: &mut Vec<(Defect, String)>) {
    let (texts, curves) = (figure.texts(), curves(figure));
    let shapes = figure.shapes();
    for (i, (text, frame)) in texts.iter().enumerate() {
        let [left, top, right, bottom] = *frame;
        if left < 0.0 || top < 0.0 || right > figure.width || bottom > figure.height {
            found.push((Defect::TextOutside, text.clone()));
        }
        for (other, [l, t, r, b]) in &texts[..i] {
            if left < *r && *l < right && top < *b && *t < bottom {
                found.push((Defect::TextOnText, format!("{text} and {other}")));
            }
        }
        let ink = [left + AROUND, top + AROUND, right - AROUND, bottom - AROUND];
        let is_on_curve = shapes.iter().any(|shape| match shape {
            Shape::Line { lines, stroke } if curves.contains(stroke) => lines
                .iter()
                .flat_map(|line| line.windows(2))
                .any(|chord| passes([chord[0], chord[1]], ink)),
            Shape::Line { .. } | Shape::Area { .. } | Shape::Text { .. } => false,
        });
        if is_on_curve {
            found.push((Defect::TextOnCurve, text.clone()));
        }
    }
}

/// Whether a line leaves the panel upwards or downwards by more than a line's width, without a mark.
fn is_cut(panel: &Panel, layer: &Layer) -> bool {
    let View::Plane {
        x, y, axes: true, ..
    } = &panel.view
    else {
        return false;
    };
    let (Mark::Line(_), "time") = (layer.mark, x.column.as_ref()) else {
        return false;
    };
    let Some(place) = layer.series.column(&y.column) else {
        return false;
    };
    let room = 0.01 * y.range.length();
    let is_out = |row: &[f64]| row[place] > y.range.to + room || row[place] < y.range.from - room;
    let is_marked = panel
        .layers
        .iter()
        .any(|other| matches!(other.mark, Mark::Beyond(_)));
    layer.series.rows().any(is_out) && !is_marked
}

/// The least part of an axis by which a curve has to change to be seen, and the part of a value that
/// is rounding.
const SEEN: f64 = 0.02;
const ROUNDING: f64 = 1e-9;

/// Whether several quantities change in time, and none of them by as much as can be seen.
fn changes_unseen(panel: &Panel) -> bool {
    let View::Plane {
        x, y, axes: true, ..
    } = &panel.view
    else {
        return false;
    };
    // Modes are parts of one quantity.
    let is_mode = |name: &str| Mode::ALL.iter().any(|mode| mode.name() == name);
    let is_data = |layer: &&Layer| {
        let name = layer.series.name.as_str();
        !FRAME.contains(&name) && !is_mode(name)
    };
    let lines = panel.layers.iter().filter(is_data);
    let lines =
        lines.filter(|layer| matches!(layer.mark, Mark::Line(stroke) if stroke.width > 1.0));
    let changes: Vec<[f64; 2]> = lines
        .filter_map(|layer| {
            let place = layer.series.column(&y.column)?;
            let values = || layer.series.rows().map(|row| row[place]);
            let (low, high) = (
                values().fold(f64::INFINITY, f64::min),
                values().fold(f64::NEG_INFINITY, f64::max),
            );
            Some([high - low, f64::max(low.abs(), high.abs())])
        })
        .collect();
    let size = changes.iter().map(|[_, size]| *size).fold(0.0, f64::max);
    let some_changes = changes.len() > 1 && changes.iter().any(|[by, _]| *by > ROUNDING * size);
    let none_is_seen = changes.iter().all(|[by, _]| *by < SEEN * y.range.length());
    x.column == "time" && some_changes && none_is_seen
}

fn panels(figure: &Figure, found: &mut Vec<(Defect, String)>) {
    let marks: Vec<Mark> = figure
        .panels
        .iter()
        .flat_map(|panel| panel.layers.iter())
        .filter(|layer| layer.series.rows().next().is_some())
        .map(|layer| layer.mark)
        .collect();
    for panel in &figure.panels {
        let says_so = panel
            .labels
            .iter()
            .any(|label| label.text.starts_with("nothing to show"));
        if !says_so && !shows_something(panel) {
            found.push((Defect::PanelWithoutInk, panel.name.to_owned()));
        }
        if changes_unseen(panel) {
            found.push((Defect::ChangeUnseen, panel.name.to_owned()));
        }
        let is_like = |key: &Mark, mark: &Mark| match (key, mark) {
            (Mark::Line(a), Mark::Line(b) | Mark::Arrow(b)) => {
                a.colour == b.colour && a.dash == b.dash
            }
            (Mark::Hoop(_), Mark::Hoop(_)) => true,
            (Mark::Line(a), Mark::Hoop(shape)) => a.colour == shape.rim.colour,
            (key, mark) => key == mark,
        };
        for key in &panel.keys {
            let widths_only = matches!(key.mark, Mark::Line(_))
                && (key.text.starts_with("thick") || key.text.starts_with("thin"));
            if !widths_only && !marks.iter().any(|mark| is_like(&key.mark, mark)) {
                found.push((Defect::KeyWithoutMark, key.text.clone()));
            }
        }
        for (i, a) in panel.keys.iter().enumerate() {
            for b in &panel.keys[..i] {
                if let (Mark::Line(first), Mark::Line(second)) = (a.mark, b.mark)
                    && !are_told_apart(first, second)
                {
                    found.push((Defect::AlikeInGrey, format!("{} and {}", a.text, b.text)));
                }
            }
        }
        for layer in panel.layers.iter().filter(|layer| is_cut(panel, layer)) {
            let name = format!("{}: {}", panel.name, layer.series.name);
            found.push((Defect::CutWithoutMark, name));
        }
    }
}

#[test]
fn pictures_of_random_motions_have_no_defects() {
    let motions = if std::env::var_os("LITTLEWOOD_THOROUGH").is_some() {
        300
    } else {
        30
    };
    let mut counts: BTreeMap<(Defect, &str), usize> = BTreeMap::new();
    let mut made = 0;
    for number in 0..motions {
        let mut draw = Draw::of_case(58, 0, number);
        // Whole range and usual sizes in turn.
        let (hoop, start) = if number % 2 == 0 {
            draw.motion()
        } else {
            draw.resisted_in_contact()
        };
        let limits = Limits::default()
            .with_transitions(300)
            .with_until(Some(200.0));
        let input = FigureInput {
            width_mm: Some(84.0),
            ..FigureInput::new(hoop, start, limits)
        };
        for entry in FIGURES.iter().filter(|entry| entry.name != "outcomes") {
            let Ok(figure) = entry.figure(&input) else {
                continue;
            };
            made += 1;
            let mut found = Vec::new();
            texts(&figure, &mut found);
            panels(&figure, &mut found);
            for (defect, what) in &found {
                println!("{number} {} {defect:?}: {what}", entry.name);
            }
            let mut kinds: Vec<Defect> = found.into_iter().map(|(defect, _)| defect).collect();
            kinds.sort();
            kinds.dedup();
            for kind in kinds {
                *counts.entry((kind, entry.name)).or_default() += 1;
            }
        }
    }
    println!("{made} figures of {motions} motions");
    for ((defect, name), count) in &counts {
        println!("{defect:?} {name}: {count}");
    }
    assert!(counts.is_empty(), "{counts:?}");
    assert!(made > 5 * motions, "{made} figures");
}
