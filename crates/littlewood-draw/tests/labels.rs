//! Labels stand beside curves, in their axes, and those without room are named.

use littlewood_draw::{Content, Figure, INK, Label, PlotAxis, Series, Sheet, Stroke};

fn placed(labels: Vec<Label>) -> (Figure, usize) {
    let count = labels.len();
    let line = Series::of_rows("line", &["x", "y"], vec![vec![0.0, 0.5], vec![1.0, 0.5]]);
    let axis = |column| PlotAxis::new(column, "", [0.0, 1.0].into());
    let layers = vec![line.drawn(Stroke::solid(INK, 1.0))];
    let content = Content {
        name: "plane",
        x: axis("x"),
        y: axis("y"),
        layers,
        labels,
    };
    let sheet = Sheet::new(Some(84.0), 620.0).expect("a width");
    (
        sheet
            .plot(
                "labels",
                "Labels",
                "A caption.".to_owned(),
                430.0,
                content,
                Vec::new(),
            )
            .fitted(),
        count,
    )
}

#[test]
fn a_label_leaves_a_curve_and_stays_in_the_axes() {
    let (figure, _) = placed(vec![
        Label::new("on the line", &[0.5, 0.5]),
        Label::new("at the end", &[1.0, 1.0]),
    ]);
    let panel = &figure.panels[0];
    let [[left, top], [right, bottom]] = panel.axes_frame();
    let line = panel.place([0.5, 0.5].into()).expect("a plane").y;
    for (text, [l, t, r, b]) in figure
        .texts()
        .iter()
        .filter(|(text, _)| text.contains(" the "))
    {
        assert!(
            *l >= left && *r <= right && *t >= top && *b <= bottom,
            "{text}"
        );
        assert!(*b < line || *t > line, "{text}");
    }
}

/// The lines of small letters below the panels, together.
fn below(figure: &Figure) -> String {
    let bottom = figure
        .panels
        .iter()
        .map(|panel| panel.frame.top + panel.frame.height);
    let bottom = bottom.fold(0.0, f64::max);
    let texts = figure.texts().into_iter();
    let lines = texts.filter(|(_, [_, top, ..])| *top >= bottom);
    lines.map(|(text, _)| text).collect::<Vec<_>>().join(" ")
}

#[test]
fn what_has_no_room_is_named_in_the_picture_and_in_the_caption() {
    for (all, one) in [(200, false), (60, true)] {
        let name = |i| {
            if one {
                "slip".to_owned()
            } else {
                format!("transition {i}")
            }
        };
        let names = (0..all).map(|i| Label::new(name(i), &[0.5, 0.5]));
        let (figure, count) = placed(names.collect());
        let drawn = figure.panels[0].labels.len();
        let note = below(&figure);
        let wanted = format!("There is no room for {} names: ", count - drawn);
        assert!(drawn > 1 && note.starts_with(&wanted), "{drawn}: {note}");
        assert!(figure.caption.ends_with(&note), "{}", figure.caption);
        // A few names, each once, whatever there are: the picture has not more words than lines.
        let named = note.trim_start_matches(&wanted);
        if one {
            assert_eq!(named, "slip.");
        } else {
            assert!(
                named.matches("transition").count() == 8 && named.ends_with(", …."),
                "{note}"
            );
        }
        assert!(figure.texts().iter().all(|(_, [left, _, right, bottom])| {
            *left >= 0.0 && *right <= figure.width && *bottom <= figure.height
        }));
    }
}

#[test]
fn a_label_of_what_is_out_of_sight_is_no_label() {
    let (figure, _) = placed(vec![Label::new("far off", &[2.0, 0.5])]);
    assert!(figure.panels[0].labels.is_empty() && !figure.caption.contains("far off"));
}
