//! Figures in SI units: the same data, converted by the core's dimensions, and units everywhere.

use crate::support::{assert_near, columns, series};
use littlewood::si::{SiParameters, Units};
use littlewood::tables::SampleColumn;
use littlewood_figures::{FIGURES, FigureInput, View, find_figure, plain};

/// R = 0.4 m and g = 10 m/s² make √(R/g) = 0.2 s and √(gR) = 2 m/s; m2 g = 5 N, m2 g R = 2 J.
fn units() -> Units {
    SiParameters {
        particle_mass_kg: 0.5,
        radius_m: 0.4,
        gravity_m_per_s2: 10.0,
        ..SiParameters::default()
    }
    .units()
    .expect("units")
}

/// What one unit of (2.9) of a column is, by hand.
fn unit(column: &str) -> Option<(f64, &'static str)> {
    Some(match column {
        "time" => (0.2, "_s"),
        "theta" => (1.0, "_rad"),
        "theta_rate" => (5.0, "_rad_per_s"),
        "slip" | "gap_rate" => (2.0, "_m_per_s"),
        "x" | "y" | "gap" => (0.4, "_m"),
        "normal_force" | "friction_force" | "normal" | "friction" => (5.0, "_n"),
        "energy" | "energy_lost" | "w" => (2.0, "_j"),
        "impulse" | "normal_impulse" | "friction_impulse" => (1.0, "_n_s"),
        "mu_s" | "mu_k" | "demand" | "landing" | "share" | "right" | "up" => (1.0, ""),
        _ => return None,
    })
}

#[test]
fn every_number_is_converted_and_its_column_says_the_unit() {
    for entry in FIGURES {
        let input = FigureInput::of_case(entry.case).expect("a case");
        let own = entry.figure(&input).expect("it can be drawn");
        let si = entry
            .figure(&FigureInput {
                units: Some(units()),
                ..input
            })
            .expect("it can be drawn");
        for (own, si) in own.panels.iter().zip(&si.panels) {
            for (own, si) in own.layers.iter().zip(&si.layers) {
                let (own, si) = (&own.series, &si.series);
                // Its force is round in either unit.
                if own.name == "scale of forces" {
                    continue;
                }
                for (i, column) in own.columns.iter().enumerate() {
                    if column == "log10_gap_rate" {
                        for (a, b) in own.rows().zip(si.rows()) {
                            assert_near(b[i], a[i] + libm::log10(2.0), 1e-12, "a logarithm");
                        }
                        continue;
                    }
                    let (unit, suffix) =
                        unit(column).unwrap_or_else(|| panic!("{}: {column}", entry.name));
                    assert_eq!(si.columns[i], format!("{column}{suffix}"));
                    for (a, b) in own.rows().zip(si.rows()) {
                        assert!(
                            a[i] == b[i] || (b[i] / a[i] / unit - 1.0).abs() < 1e-12,
                            "{}: {column}",
                            entry.name
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn the_scale_of_forces_is_round_and_that_of_the_arrows() {
    let entry = find_figure("stroboscope").expect("a figure");
    let weight_n = [5.0, 0.3 * 9.80665, 123.4];
    for weight_n in weight_n {
        let hoop = SiParameters {
            particle_mass_kg: weight_n / 10.0,
            radius_m: 0.4,
            gravity_m_per_s2: 10.0,
            ..SiParameters::default()
        };
        let input = FigureInput {
            units: Some(hoop.units().expect("units")),
            ..FigureInput::of_case(entry.case).expect("a case")
        };
        let figure = entry.figure(&input).expect("it can be drawn");
        let labels = figure.panels.iter().flat_map(|panel| &panel.labels);
        let said = labels.filter_map(|label| label.text.strip_suffix(" N"));
        let said: Vec<&str> = said.collect();
        let [force] = said[..] else {
            panic!("one force is said: {said:?}")
        };
        let digits = force.trim_matches(['0', '.']);
        assert_eq!(digits.len(), 1, "{force} N is round");
        let force: f64 = force.parse().expect("a number");
        let bar = columns(series(&figure, "scale of forces")[0], ["x_m"]);
        let normal = columns(series(&figure, "normal force at")[0], ["y_m", "normal_n"]);
        let of_a_metre = normal[1][1] / (normal[1][0] - normal[0][0]);
        assert_near(
            of_a_metre * (bar[1][0] - bar[0][0]),
            force,
            1e-9 * force,
            "N",
        );
    }
}

#[test]
fn axes_and_labels_have_si_units_and_none_of_the_paper() {
    for entry in FIGURES {
        let input = FigureInput {
            units: Some(units()),
            ..FigureInput::of_case(entry.case).expect("a case")
        };
        let figure = entry.figure(&input).expect("it can be drawn");
        for panel in &figure.panels {
            let axes = match &panel.view {
                View::Plane {
                    x, y, axes: true, ..
                } => vec![x, y],
                View::Plane { .. } => vec![],
                View::Space { x, y, z, .. } => vec![x, y, z],
            };
            for axis in axes {
                let title = plain(&axis.title);
                assert!(
                    !title.contains('√') && !title.contains("(R)") && !title.contains("m₂g"),
                    "{title}"
                );
                let suffix = SampleColumn::Time
                    .dimension()
                    .map(littlewood::tables::Dimension::si_suffix);
                if suffix.is_some_and(|suffix| axis.column == format!("time{suffix}")) {
                    assert!(title.is_empty() || title == "t  (s)", "{title}");
                }
            }
            for text in panel
                .labels
                .iter()
                .map(|label| &label.text)
                .chain(panel.keys.iter().map(|key| &key.text))
            {
                assert!(!text.contains("*τ*"), "{}: {text}", entry.name);
            }
        }
        assert!(figure.caption.contains("SI units"), "{}", figure.caption);
    }
}

#[test]
fn figure_7a_slips_at_ln_5_times_the_unit_of_time() {
    let entry = find_figure("figure-7a").expect("a figure");
    let input = FigureInput {
        units: Some(units()),
        ..FigureInput::of_case(entry.case).expect("a case")
    };
    let figure = entry.figure(&input).expect("it can be drawn");
    let labels: Vec<String> = figure
        .panels
        .iter()
        .flat_map(|panel| &panel.labels)
        .map(|label| plain(&label.text))
        .collect();
    // 0.2 ln 5 = 0.32189.
    assert!(
        labels.iter().any(|text| text == "tₛ = 0.3219 s"),
        "{labels:?}"
    );
    assert!(
        plain(&figure.caption).contains("θ′(0) = 2.5 rad/s"),
        "{}",
        figure.caption
    );
}
