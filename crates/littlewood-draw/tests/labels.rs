//! Labels stand beside curves, in their axes, and those without room are named.

use littlewood_draw::{Content, Figure, INK, Label, PlotAxis, Series, Sheet, Stroke};

fn placed(labels: Vec<Label>) -> (Figure, usize) {
    let count = labels.len();
    let line = Series::of_rows("line", &["x", "y"], vec![vec![0.0, 0.5], vec![1.0, 0.5]]);
    let axis = |column| PlotAxis::new(column, "", [0.0, 1.0]);
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
    let line = panel.place([0.5, 0.5]).expect("a plane")[1];
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

#[test]
fn what_has_no_room_is_named_in_the_caption() {
    let names = (0..200).map(|i| Label::new(format!("transition {i}"), &[0.5, 0.5]));
    let (figure, count) = placed(names.collect());
    let drawn = figure.panels[0].labels.len();
    let named = figure.caption.matches("transition ").count();
    assert!(
        drawn > 1 && named > 0 && drawn + named == count,
        "{drawn} and {named} of {count}"
    );
    let seen = figure
        .texts()
        .iter()
        .filter(|(text, _)| text.starts_with("transition"))
        .count();
    assert_eq!(seen, drawn);
}

#[test]
fn a_label_of_what_is_out_of_sight_is_no_label() {
    let (figure, _) = placed(vec![Label::new("far off", &[2.0, 0.5])]);
    assert!(figure.panels[0].labels.is_empty() && !figure.caption.contains("far off"));
}
