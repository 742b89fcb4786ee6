//! The figures by name, and the letters that they use.

use littlewood_figures::{FIGURES, find_figure, missing};

#[test]
fn names_are_told_apart_and_found() {
    for (i, entry) in FIGURES.iter().enumerate() {
        assert!(FIGURES[..i].iter().all(|other| other.name != entry.name));
        assert_eq!(
            find_figure(entry.name).map(|found| found.title),
            Some(entry.title)
        );
        assert!(
            littlewood::cases::find_case(entry.case).is_some(),
            "{}",
            entry.case
        );
    }
    assert!(find_figure("figure-8").is_none());
}

#[test]
fn the_faces_have_all_letters() {
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("the figure can be made");
        assert_eq!(figure.name, entry.name);
        for panel in &figure.panels {
            for label in &panel.labels {
                assert_eq!(missing(&label.text), "", "{}", label.text);
            }
            for key in &panel.keys {
                assert_eq!(missing(&key.text), "", "{}", key.text);
            }
            for axis in panel.axes() {
                assert_eq!(missing(&axis.title), "", "{}", axis.title);
                assert!(
                    axis.ticks
                        .iter()
                        .all(|tick| missing(&tick.label).is_empty())
                );
            }
        }
    }
}
