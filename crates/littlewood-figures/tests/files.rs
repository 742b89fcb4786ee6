//! What is written: SVG that parses and has its labels, tables that hold what is drawn, refusals that say why.

mod support;

use littlewood::{Hoop, HoopParameters, Limits, Start};
use littlewood_figures::{FIGURES, Figure, FigureError, Subject, View, find_figure, plain};
use roxmltree::Document;

/// Texts of a drawing, one for each `text` element.
fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("well-formed XML");
    document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| {
            node.descendants().filter(roxmltree::Node::is_text).filter_map(|node| node.text()).collect()
        })
        .collect()
}

fn wanted(figure: &Figure) -> Vec<String> {
    let mut wanted = Vec::new();
    for panel in &figure.panels {
        wanted.extend(panel.labels.iter().map(|label| label.text.clone()));
        wanted.extend(panel.keys.iter().map(|key| key.text.clone()));
        if let View::Plane { x, y, axes: true } = &panel.view {
            wanted.extend([x.title.clone(), y.title.clone()]);
            wanted.extend(x.ticks.iter().chain(&y.ticks).map(|tick| tick.label.clone()));
        }
    }
    wanted.into_iter().map(|text| plain(&text)).filter(|text| !text.is_empty()).collect()
}

#[test]
fn every_drawing_parses_and_has_its_labels() {
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("the figure can be made");
        let svg = figure.svg().expect("a drawing");
        let found = texts(&svg);
        for text in wanted(&figure) {
            assert!(found.contains(&text), "{}: no '{text}' among {found:?}", entry.name);
        }
        assert!(svg.contains("@font-face") && svg.contains("base64,"), "the letters are in the file");
        assert!(!figure.caption.is_empty() && svg.contains("<desc>"));
    }
}

#[test]
fn the_labels_of_the_paper_are_there() {
    for (name, labels) in [
        ("figure-1", &["C", "m2", "XP", "θ", "ℓ", "h", "R", "x", "E1", "E2", "e1", "e2"][..]),
        ("figure-2a", &["μs = 0.1", "μs = 0.25", "μs = 0.5", "μs = 1", "N < 0", "n: N = 0"]),
        ("figure-2b", &["f", "n", "N < 0", "𝓡", "π"]),
        ("figure-3a", &["s", "r", "L"]),
        ("figure-3b", &["start", "stick", "slip", "lift-off", "landing"]),
        ("figure-4", &["f", "n", "𝓡"]),
        ("figure-5a", &["Type I", "Type II", "Type III", "Ws", "Wu"]),
        ("figure-5b", &["Type I", "Type II", "Type III"]),
        ("figure-6b", &["𝓡"]),
        ("figure-7a", &["τs = 1.6094", "rolling", "gliding"]),
        ("figure-7b", &["rolling: a cycloid", "gliding: a parabola"]),
    ] {
        let found = texts(&support::figure(name).svg().expect("a drawing"));
        for label in labels {
            assert!(found.iter().any(|text| text == label), "{name}: no '{label}' among {found:?}");
        }
    }
}

#[test]
fn captions_say_where_the_paper_is_wrong() {
    for (name, words) in [
        ("figure-2b", "it slides"),
        ("figure-3a", "not found by a threshold"),
        ("figure-5a", "26.5651°"),
        ("figure-5b", "26.5651°"),
        ("figure-6a", "is not conserved by (3.17)"),
        ("figure-6b", "corrected integral"),
        ("figure-7a", "corrected integral"),
        ("outcomes", "not, as the paper has it"),
    ] {
        let caption = plain(&support::figure(name).caption);
        assert!(caption.contains(words), "{name}: {caption}");
    }
    assert!(plain(&support::figure("figure-5a").caption).contains("53.1301°"));
}

#[test]
fn the_table_holds_what_is_drawn() {
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("the figure can be made");
        let table = figure.csv();
        let mut lines = table.lines();
        let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
        assert_eq!(header[..3], ["panel", "series", "piece"]);
        let layers =
            figure.panels.iter().flat_map(|panel| panel.layers.iter().map(move |layer| (panel.name, layer)));
        for (panel, layer) in layers {
            for (number, piece) in layer.series.pieces.iter().enumerate() {
                for row in piece {
                    let line = lines.next().expect("a line for each row");
                    let prefix = format!("{panel},{},{number},", layer.series.name);
                    let cells = line.strip_prefix(&prefix).unwrap_or_else(|| panic!("{line} for {prefix}"));
                    let cells: Vec<&str> = cells.split(',').collect();
                    for (value, column) in row.iter().zip(&layer.series.columns) {
                        let place = header.iter().position(|name| name == column).expect("a column");
                        let read: Option<f64> = cells[place - 3].parse().ok();
                        assert_eq!(read, value.is_finite().then_some(*value), "all digits");
                    }
                }
            }
        }
        assert_eq!(lines.next(), None);
    }
}

fn subject(mass_ratio: f64, offset: f64, inertia: f64, mu_s: f64, mu_k: f64) -> Subject {
    let hoop = Hoop::new(HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k }).expect("a hoop");
    Subject { hoop, start: Start::at(1.2, 1.5), limits: Limits::until(30.0) }
}

#[test]
fn other_hoops_have_the_same_figures() {
    let heavy = [
        subject(2.0, 1.0, 2.0, 0.7, 0.5),
        subject(0.0, 1.0, 0.02, 0.3, 0.3),
        subject(10.0, 0.3, 5.0, 0.2, 0.1),
        subject(0.5, 0.01, 0.25, 1.5, 0.0),
        subject(0.3, 1.0, 0.3, 1.2, 1.2),
    ];
    let massless = [subject(0.0, 1.0, 0.0, 0.2, 0.1), subject(0.0, 1.0, 0.0, 2.5, 1.0)];
    for subject in heavy.iter().chain(&massless) {
        for entry in FIGURES.iter().filter(|entry| entry.name != "outcomes") {
            match entry.figure(subject) {
                Ok(figure) => {
                    Document::parse(&figure.svg().expect("a drawing")).expect("well-formed XML");
                    assert!(!figure.csv().contains("NaN"));
                }
                Err(
                    FigureError::NeedsInertia { .. }
                    | FigureError::NeedsMassless { .. }
                    | FigureError::NoMotion { .. },
                ) => {}
                Err(other) => panic!("{}: {other}", entry.name),
            }
        }
    }
}

#[test]
fn a_hoop_that_a_figure_cannot_show_is_refused() {
    let heavy = subject(1.0, 1.0, 1.0, 0.5, 0.4);
    let massless = subject(0.0, 1.0, 0.0, 0.5, 0.4);
    let inside = subject(0.0, 0.5, 0.0, 0.5, 0.4);
    let disc = subject(1.0, 0.0, 1.0, 0.5, 0.4);
    let make = |name: &str, subject: &Subject| find_figure(name).expect("a name").figure(subject);
    assert!(matches!(make("figure-4", &heavy), Err(FigureError::NeedsMassless { mass_ratio: 1.0, .. })));
    assert!(matches!(make("figure-2a", &massless), Err(FigureError::NeedsInertia { figure: "figure-2a" })));
    assert!(matches!(make("figure-5b", &inside), Err(FigureError::NeedsRim { offset: 0.5, .. })));
    assert!(matches!(make("figure-2b", &disc), Err(FigureError::NeedsOffset { .. })));
    let Err(error) = make("figure-1", &disc) else { panic!("refused") };
    assert!(error.to_string().contains("offset 0"));
}

#[test]
fn a_scale_out_of_bounds_is_refused() {
    let figure = support::figure("figure-1");
    for scale in [0.0, -1.0, 17.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(figure.png(scale), Err(FigureError::Scale { .. })), "{scale}");
    }
    let small = figure.png(1.0).expect("a picture");
    assert_eq!(&small[1..4], b"PNG");
    let side = |at: usize| u32::from_be_bytes([small[at], small[at + 1], small[at + 2], small[at + 3]]);
    assert_eq!([side(16), side(20)], [figure.width, figure.height].map(|side| libm::ceil(side) as u32));
}
