//! Where labels stand, for random motions: each is inside its panel, none on another, and the
//! caption names those that are not drawn. `LITTLEWOOD_LABELS=5000` takes 5000 motions.

use crate::random::Draw;
use littlewood_figures::{FIGURES, Figure, FigureInput, View};

/// Figures of each motion.
const EACH: usize = 3;

/// The boxes of the labels of a panel: of what is drawn, by the text and by where it stands.
fn check(figure: &Figure, input: &FigureInput) {
    let texts = figure.texts();
    let name = figure.name;
    let apart =
        |a: &[f64; 4], b: &[f64; 4]| a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
    for (i, (text, own)) in texts.iter().enumerate() {
        let [left, top, right, bottom] = *own;
        let is_on_sheet =
            left >= 0.0 && top >= 0.0 && right <= figure.width && bottom <= figure.height;
        assert!(is_on_sheet, "{name}: '{text}' leaves the sheet, {input:?}");
        for (other, frame) in &texts[..i] {
            assert!(
                apart(own, frame),
                "{name}: '{text}' and '{other}', {input:?}"
            );
        }
    }
    for panel in &figure.panels {
        let [[left, top], [right, bottom]] = panel.axes_frame();
        let has_axes = matches!(panel.view, View::Plane { axes: true, .. });
        for label in panel
            .labels
            .iter()
            .filter(|label| has_axes && !label.is_fixed)
        {
            let text = littlewood_figures::plain(&label.text);
            let drawn = texts.iter().any(|(other, [l, t, r, b])| {
                *other == text && *l >= left && *r <= right && *t >= top && *b <= bottom
            });
            assert!(drawn, "{name}: '{text}' is not in its panel, {input:?}");
        }
    }
}

#[test]
fn labels_of_random_motions_stand_in_their_panels_and_beside_each_other() {
    let motions = std::env::var("LITTLEWOOD_LABELS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(500);
    let (mut draw, mut made) = (Draw(40), 0);
    let mut figures = FIGURES.iter().cycle();
    for motion in 0..motions {
        let width_mm = [None, Some(84.0), Some(178.0)][motion % 3];
        let input = FigureInput {
            width_mm,
            ..draw.input()
        };
        for entry in figures.by_ref().take(EACH) {
            if entry.name == "outcomes" && (motion % 40 != 1 || input.hoop.mu_k() < 0.05) {
                continue;
            }
            if let Ok(figure) = entry.figure(&input) {
                check(&figure, &input);
                made += 1;
            }
        }
    }
    assert!(made > motions, "{made} figures");
}
