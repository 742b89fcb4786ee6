//! What a figure says is what it shows: each of these was once not so.

use crate::support::{columns, figure, series};
use littlewood::{Hoop, HoopParameters, Limits, Start};
use littlewood_figures::{Figure, FigureInput, Mark, View, find_figure, plain};

fn of(name: &str, input: &FigureInput) -> Figure {
    find_figure(name)
        .expect("a name of the catalogue")
        .figure(input)
        .expect("it can be drawn")
}

fn of_case(name: &str, case: &str) -> Figure {
    of(name, &FigureInput::of_case(case).expect("a case"))
}

/// A motion of the hoop of Figure 3, with another parameter.
fn of_hoop(name: &str, change: impl Fn(HoopParameters) -> HoopParameters) -> Figure {
    let hoop =
        Hoop::new(change(HoopParameters::thin(1.0).with_friction(0.5, 0.4))).expect("a hoop");
    of(
        name,
        &FigureInput::new(
            hoop,
            Start::at(core::f64::consts::FRAC_PI_2, 2.0),
            Limits::default(),
        ),
    )
}

#[test]
fn the_arrow_of_the_caption_crosses_all_loci() {
    let figure = figure("figure-2a");
    assert!(figure.caption.contains("(arrow)"));
    let arrow = columns(
        series(&figure, "increasing mu_s")[0],
        ["theta", "theta_rate"],
    );
    let [[from, height], [to, _]] = arrow[..] else {
        panic!("two ends")
    };
    // Where |F| = μs N on the line of this rate, from (2.11) and (2.12).
    for mu in [0.1, 0.25, 0.5, 1.0] {
        let excess = |theta: f64| {
            let (normal, friction) = crate::support::THIN.rolling_forces(theta, height);
            friction.abs() - mu * normal
        };
        assert!(
            excess(from) * excess(to) < 0.0,
            "{mu} between {from} and {to}"
        );
    }
    // Of a heavy hoop nothing of the loci may be seen.
    let heavy = of_hoop("figure-2a", |_| {
        HoopParameters::thin(1e6).with_friction(0.5, 0.4)
    });
    assert_eq!(
        heavy.caption.contains("(arrow)"),
        heavy.series("increasing mu_s").is_some()
    );
}

#[test]
fn the_weight_is_on_the_axis_beside_which_it_stands() {
    for (name, case) in [
        ("forces", "figure-7"),
        ("sheet", "figure-7"),
        ("forces", "figure-3"),
    ] {
        let figure = of_case(name, case);
        let panel = figure
            .panels
            .iter()
            .find(|panel| panel.layers.iter().any(|it| it.series.name == "weight"));
        let panel = panel.expect("a panel of the normal force");
        let View::Plane { y, .. } = &panel.view else {
            panic!("a plane")
        };
        for label in panel.labels.iter().filter(|label| label.text == "weight") {
            assert!(y.range.contains(label.at[1]), "{name} of {case}");
        }
        assert!(
            figure.texts().iter().any(|(text, _)| text == "weight"),
            "{name} of {case}"
        );
    }
}

#[test]
fn impulses_have_an_axis_of_their_own() {
    for name in ["forces", "sheet"] {
        for panel in &of_case(name, "figure-3-bounces").panels {
            let View::Plane { x, y, .. } = &panel.view else {
                panic!("a plane")
            };
            let has = |part: &str| {
                panel
                    .layers
                    .iter()
                    .any(|layer| layer.series.name.contains(part))
            };
            assert!(
                !has("impulse")
                    || [x, y].iter().any(|it| it.title.contains('P'))
                    || y.column == "demand"
            );
            assert!(
                !has("impulse") || !y.title.starts_with("*N*") && !y.title.starts_with("*F*"),
                "{name}"
            );
        }
    }
}

#[test]
fn the_outcomes_of_a_massless_hoop_have_their_curves_and_no_lift_off() {
    let figure = of_case("outcomes", "figure-7");
    // (3.9): |θ| = 2 atan μs, whatever the rate; and θ′ = ±1.
    for [theta, _] in columns(series(&figure, "f")[0], ["theta", "theta_rate"]) {
        assert!(
            (theta.abs() - 2.0 * libm::atan(0.5)).abs() < 1e-12,
            "{theta}"
        );
    }
    for [_, rate] in columns(series(&figure, "n")[0], ["theta", "theta_rate"]) {
        assert!((rate.abs() - 1.0).abs() < 1e-12, "{rate}");
    }
    assert!(figure.series("lift-off").is_none());
}

#[test]
fn a_smooth_plane_has_no_region_of_rolling_and_slip_at_every_half_turn() {
    let figure = of_hoop("figure-2b", |hoop| hoop.with_friction(0.0, 0.0));
    assert!(
        figure.panels[0]
            .labels
            .iter()
            .all(|label| label.text != "𝓡")
    );
    // F = ½ sin θ (θ′² − 1) for this hoop.
    let limit = columns(series(&figure, "f ")[0], ["theta", "theta_rate"]);
    assert!(
        limit
            .iter()
            .all(|[theta, rate]| (libm::sin(*theta) * (rate * rate - 1.0)).abs() < 1e-9)
    );
    for wanted in [0.0, core::f64::consts::PI] {
        let on = limit.iter().filter(|[theta, rate]| {
            (theta - wanted).abs() < 1e-9 && (rate.abs() - 1.0).abs() > 0.1
        });
        assert!(on.count() >= 2, "{wanted}");
    }
}

#[test]
fn the_key_of_the_paradox_says_what_the_caption_says() {
    let figure = figure("painleve");
    assert!(
        figure.panels[0]
            .keys
            .iter()
            .any(|key| key.text == "no solution or several")
    );
    assert!(plain(&figure.caption).contains("no solution with a normal force, or more than one"));
}

#[test]
fn the_hoops_that_are_drawn_are_counted() {
    for case in ["figure-3", "figure-3-bounces", "ramp-jump"] {
        let figure = of_case("figure-3b", case);
        let hoops = figure.panels[0]
            .layers
            .iter()
            .filter(|layer| matches!(layer.mark, Mark::Hoop(_)));
        let drawn = hoops
            .map(|layer| layer.series.rows().count())
            .sum::<usize>()
            - 1;
        let caption = plain(&figure.caption);
        let all = FigureInput::of_case(case).expect("a case");
        let all = all
            .hoop
            .simulate(all.start, all.limits)
            .expect("a motion")
            .transitions()
            .len();
        let words = format!("{drawn} of {all} transitions");
        assert!(
            caption.contains(&words) || drawn == all && caption.contains("each transition"),
            "{caption}"
        );
    }
}

#[test]
fn a_number_of_the_input_is_printed_whole() {
    let units = littlewood::si::SiParameters {
        particle_mass_kg: 0.1,
        radius_m: 0.3,
        ..Default::default()
    };
    let input = FigureInput {
        units: Some(units.units().expect("units")),
        ..FigureInput::of_case("figure-3").expect("a case")
    };
    let caption = of("figure-3b", &input).caption;
    assert!(
        plain(&caption).contains("g = 9.80665 m/s²")
            && plain(&caption).contains("I_zz = 0.009 kg m²")
    );
}

#[test]
fn figures_of_a_level_plane_refuse_a_slope_and_the_others_have_its_curves() {
    let hoop = Hoop::new(
        HoopParameters::thin(0.0)
            .with_friction(0.5, 0.4)
            .with_slope(0.3),
    )
    .expect("a hoop");
    let input = FigureInput::new(hoop, Start::at(0.0, 0.5), Limits::default());
    for name in [
        "figure-4",
        "figure-5a",
        "figure-5b",
        "figure-6a",
        "figure-6b",
        "figure-7a",
    ] {
        let refused = find_figure(name)
            .expect("a name")
            .figure(&input)
            .expect_err("a slope");
        assert!(
            refused.to_string().contains("the slope 0.3 rad"),
            "{refused}"
        );
    }
    let plane = littlewood::theory::PhasePlane::new(&hoop);
    for [theta, rate] in columns(
        series(&of("outcomes", &input), "n")[0],
        ["theta", "theta_rate"],
    ) {
        assert!(
            plane.forces(theta, rate).normal.abs() < 1e-9 * (1.0 + rate * rate),
            "{theta} {rate}"
        );
    }
}
