//! What is written: SVG that parses and has its labels, tables that hold what is drawn, refusals
//! that say why.

use crate::support;
use littlewood::tables::Class;
use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, Start};
use littlewood_figures::{
    DrawError, FIGURES, Figure, FigureError, FigureInput, View, find_figure, plain,
};
use roxmltree::Document;

/// Texts of a drawing, as a program reads them aloud.
fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("well-formed XML");
    document
        .descendants()
        .filter_map(|node| node.attribute("aria-label"))
        .map(str::to_owned)
        .collect()
}

fn wanted(figure: &Figure) -> Vec<String> {
    let mut wanted = Vec::new();
    for panel in &figure.panels {
        wanted.extend(panel.labels.iter().map(|label| label.text.clone()));
        wanted.extend(panel.keys.iter().map(|key| key.text.clone()));
        if let View::Plane {
            x, y, axes: true, ..
        } = &panel.view
        {
            wanted.extend([x.title.clone(), y.title.clone()]);
            wanted.extend(
                x.ticks
                    .iter()
                    .chain(&y.ticks)
                    .map(|tick| tick.label.clone()),
            );
        }
    }
    wanted
        .into_iter()
        .map(|text| plain(&text))
        .filter(|text| !text.is_empty())
        .collect()
}

#[test]
fn every_drawing_parses_and_has_its_labels() {
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("the figure can be made");
        let svg = figure.svg();
        let found = texts(&svg);
        for text in wanted(&figure) {
            assert!(
                found.contains(&text),
                "{}: no '{text}' among {found:?}",
                entry.name
            );
        }
        assert!(!figure.caption.is_empty() && svg.contains("<desc>"));
    }
}

#[test]
fn the_labels_of_the_paper_are_there() {
    for (name, labels) in [
        (
            "figure-1",
            &[
                "C", "m₂", "X_P", "θ", "ℓ", "h", "R", "x", "E₁", "E₂", "e₁", "e₂",
            ][..],
        ),
        (
            "figure-2a",
            &[
                "μₛ = 0.1",
                "μₛ = 0.25",
                "μₛ = 0.5",
                "μₛ = 1",
                "N < 0",
                "n: N = 0",
            ],
        ),
        ("figure-2b", &["f", "n", "N < 0", "𝓡", "π"]),
        ("figure-3a", &["s", "r", "L"]),
        (
            "figure-3b",
            &[
                "start, τ = 0",
                "stick, τ = 0.5641",
                "slip, τ = 0.9732",
                "lift-off, τ = 1.5187",
                "landing, τ = 3.8474",
            ],
        ),
        ("figure-4", &["f", "n", "𝓡"]),
        (
            "figure-5a",
            &["Type I", "Type II", "Type III", "W^s", "W^u"],
        ),
        ("figure-5b", &["Type I", "Type II", "Type III"]),
        ("figure-6b", &["𝓡"]),
        ("figure-7a", &["τₛ = 1.6094", "rolling", "gliding"]),
        ("figure-7b", &["rolling: a cycloid", "gliding: a parabola"]),
    ] {
        let found = texts(&support::figure(name).svg());
        for label in labels {
            assert!(
                found.iter().any(|text| text == label),
                "{name}: no '{label}' among {found:?}"
            );
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
        ("outcomes", "where the paper lets it leave, it slides first"),
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
        let layers = figure
            .panels
            .iter()
            .flat_map(|panel| panel.layers.iter().map(move |layer| (panel.name, layer)));
        for (panel, layer) in layers {
            for (number, piece) in layer.series.pieces.iter().enumerate() {
                for row in piece {
                    let line = lines.next().expect("a line for each row");
                    let prefix = format!("{panel},{},{number},", layer.series.name);
                    let cells = line
                        .strip_prefix(&prefix)
                        .unwrap_or_else(|| panic!("{line} for {prefix}"));
                    let cells: Vec<&str> = cells.split(',').collect();
                    for (value, column) in row.iter().zip(&layer.series.columns) {
                        let place = header
                            .iter()
                            .position(|name| name == column)
                            .expect("a column");
                        let read: Option<f64> = cells[place - 3].parse().ok();
                        assert_eq!(read, value.is_finite().then_some(*value), "all digits");
                    }
                }
            }
        }
        assert_eq!(lines.next(), None);
    }
}

fn input(mass_ratio: f64, offset: f64, inertia: f64, mu_s: f64, mu_k: f64) -> FigureInput {
    let hoop = Hoop::new(
        HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k),
    )
    .expect("a hoop");
    FigureInput::new(hoop, Start::at(1.2, 1.5), Limits::until(30.0))
}

#[test]
fn other_hoops_have_the_same_figures() {
    let heavy = [
        input(2.0, 1.0, 2.0, 0.7, 0.5),
        input(0.0, 1.0, 0.02, 0.3, 0.3),
        input(10.0, 0.3, 5.0, 0.2, 0.1),
        input(0.5, 0.01, 0.25, 1.5, 0.0),
        input(0.3, 1.0, 0.3, 1.2, 1.2),
    ];
    let massless = [
        input(0.0, 1.0, 0.0, 0.2, 0.1),
        input(0.0, 1.0, 0.0, 2.5, 1.0),
    ];
    for input in heavy.iter().chain(&massless) {
        for entry in FIGURES.iter().filter(|entry| entry.name != "outcomes") {
            match entry.figure(input) {
                Ok(figure) => {
                    Document::parse(&figure.svg()).expect("well-formed XML");
                    assert!(!figure.csv().contains("NaN"));
                }
                Err(
                    FigureError::NeedsInertia { .. }
                    | FigureError::NeedsMassless { .. }
                    | FigureError::NeedsRestitution { .. }
                    | FigureError::NoMotion { .. },
                ) => {}
                Err(other) => panic!("{}: {other}", entry.name),
            }
        }
    }
}

#[test]
fn a_caption_names_small_and_large_numbers() {
    let hoop = input(1e-6, 1.0, 2e-6, 1e9, 5.4e8);
    let caption = plain(
        &find_figure("sheet")
            .expect("a name")
            .figure(&hoop)
            .expect("a figure")
            .caption,
    );
    for words in ["m₁/m₂ = 10⁻⁶", "2×10⁻⁶", "μₛ = 10⁹", "μₖ = 5.4×10⁸"] {
        assert!(caption.contains(words), "{words}: {caption}");
    }
}

/// Motions whose slips hardly differ from rolling, or that are simulated, are not followed to ten
/// thousand transitions.
#[test]
fn outcomes_of_motions_without_end_are_cut_and_the_caption_says_so() {
    let nearly_equal = input(1.0, 1.0, 1.0, 0.5, 0.4999);
    let caption = |input: FigureInput| {
        let input = FigureInput {
            limits: Limits::default(),
            ..input
        };
        plain(
            &find_figure("outcomes")
                .expect("a name")
                .figure(&input)
                .expect("a figure")
                .caption,
        )
    };
    assert!(caption(nearly_equal).contains("or to 100 transitions"));
    assert!(!caption(input(1.0, 1.0, 1.0, 0.5, 0.4)).contains("transitions"));
    // A light hoop that bounces and slips again and again: its motions take so long that the work
    // bounds the transitions, which the key says, too.
    let light = HoopParameters::thin(0.05)
        .with_friction(0.5, 0.4)
        .with_restitution(0.5, RestitutionLaw::Energetic);
    let light = FigureInput {
        hoop: Hoop::new(light).expect("a hoop"),
        limits: Limits::default(),
        ..nearly_equal
    };
    let figure = find_figure("outcomes")
        .expect("a name")
        .figure(&light)
        .expect("a figure");
    let keys = figure.panels.iter().flat_map(|panel| &panel.keys);
    let is_said = |text: &str| text.starts_with("goes on after 50 transitions, ");
    assert_eq!(keys.filter(|key| is_said(&key.text)).count(), 1);
    assert!(plain(&figure.caption).contains("or to 50 transitions"));
    // It rolls on for thousands of turns, which once took 22 s.
    let parameters = HoopParameters::thin(0.28)
        .with_offset(0.73)
        .with_friction(1.1, 1.1)
        .with_rolling_resistance(1e-10);
    let hardly_resisted = FigureInput {
        hoop: Hoop::new(parameters).expect("a hoop"),
        ..nearly_equal
    };
    assert!(caption(hardly_resisted).contains("followed to τ = 200"));
}

#[test]
fn a_hoop_that_a_figure_cannot_show_is_refused() {
    let heavy = input(1.0, 1.0, 1.0, 0.5, 0.4);
    let massless = input(0.0, 1.0, 0.0, 0.5, 0.4);
    let inside = input(0.0, 0.5, 0.0, 0.5, 0.4);
    let disc = input(1.0, 0.0, 1.0, 0.5, 0.4);
    let make = |name: &str, input: &FigureInput| find_figure(name).expect("a name").figure(input);
    assert!(matches!(
        make("figure-4", &heavy),
        Err(FigureError::NeedsMassless {
            mass_ratio: 1.0,
            ..
        })
    ));
    assert!(matches!(
        make("figure-2a", &massless),
        Err(FigureError::NeedsInertia {
            figure: "figure-2a"
        })
    ));
    assert!(matches!(
        make("figure-5b", &inside),
        Err(FigureError::NeedsRim { offset: 0.5, .. })
    ));
    assert!(matches!(
        make("figure-2b", &disc),
        Err(FigureError::NeedsOffset { .. })
    ));
    let at_once = FigureInput {
        limits: Limits::until(0.0),
        ..heavy
    };
    for name in ["sheet", "energy", "forces", "stroboscope", "phase-path"] {
        assert!(
            matches!(
                make(name, &at_once),
                Err(FigureError::NoDuration { time: 0.0, .. })
            ),
            "{name}"
        );
    }
    let Err(error) = make("figure-1", &disc) else {
        panic!("refused")
    };
    assert!(error.to_string().contains("offset 0"));
}

#[test]
fn a_scale_out_of_bounds_is_refused() {
    let figure = support::figure("figure-1");
    for scale in [0.0, -1.0, 17.0, f64::NAN, f64::INFINITY] {
        assert!(
            matches!(figure.png(scale), Err(DrawError::Scale { .. })),
            "{scale}"
        );
    }
    let small = figure.png(1.0).expect("a picture");
    assert_eq!(&small[1..4], b"PNG");
    let side =
        |at: usize| u32::from_be_bytes([small[at], small[at + 1], small[at + 2], small[at + 3]]);
    assert_eq!(
        [side(16), side(20)],
        [figure.width, figure.height].map(|side| libm::ceil(side) as u32)
    );
}

/// The figure of outcomes of a named case, stopped at a time.
fn outcomes(case: &str, until: Option<f64>) -> Figure {
    let input = FigureInput::of_case(case).expect("a case");
    let input = FigureInput {
        limits: input.limits.with_until(until),
        ..input
    };
    find_figure("outcomes")
        .expect("a name of the catalogue")
        .figure(&input)
        .expect("the figure can be made")
}

/// The names of the classes that it shows.
fn classes(figure: &Figure) -> Vec<Class> {
    Class::ALL
        .into_iter()
        .filter(|class| figure.series(class.name()).is_some())
        .collect()
}

#[test]
fn a_hoop_in_the_air_at_the_time_limit_has_lifted_off() {
    let until = 2.0;
    let input = FigureInput::of_case("figure-3").expect("a case");
    let figure = outcomes("figure-3", Some(until));
    assert!(plain(&figure.caption).contains("followed to τ = 2."));
    assert!(classes(&figure).contains(&Class::InContact));
    let mut in_the_air = 0;
    let regions: Vec<_> = classes(&figure)
        .into_iter()
        .map(|class| {
            let series = figure.series(class.name()).expect("it is shown");
            (class, support::outlines(series, ["theta", "theta_rate"]))
        })
        .collect();
    for i in 0..24 {
        for j in 0..20 {
            let place = [
                9.4 * (f64::from(i) + 0.37) / 24.0 - 1.5,
                6.9 * (f64::from(j) + 0.41) / 20.0 - 3.4,
            ];
            let start = Start::at(place[0], place[1]);
            let motion = input
                .hoop
                .simulate(start, Limits::until(until))
                .expect("a motion");
            if motion.at(until).is_none_or(|sample| sample.gap <= 0.0) {
                continue;
            }
            in_the_air += 1;
            for (class, outlines) in &regions {
                let is_jump = matches!(class, Class::LeavesAtOnce | Class::LiftsOffLater);
                assert!(
                    is_jump || support::winding(outlines, place) == 0,
                    "{place:?} is in flight, not {class}"
                );
            }
        }
    }
    assert!(in_the_air > 10, "{in_the_air}");
}

#[test]
fn the_massless_hoop_has_its_particle_at_the_plane_or_at_the_top() {
    let figure = outcomes("figure-7", None);
    assert_eq!(
        classes(&figure),
        [Class::ParticleAtPlane, Class::ParticleAtTop]
    );
    // It does not lift off, and the caption does not speak of it.
    assert!(figure.series("lift-off").is_none());
    assert!(
        !plain(&figure.caption).contains("beyond"),
        "{}",
        figure.caption
    );
    let keys: Vec<&str> = figure.panels[0]
        .keys
        .iter()
        .map(|key| key.text.as_str())
        .collect();
    assert!(
        keys[0].starts_with(Class::ParticleAtPlane.label()),
        "{keys:?}"
    );
    assert!(
        keys[1].starts_with(Class::ParticleAtTop.label()),
        "{keys:?}"
    );
}
