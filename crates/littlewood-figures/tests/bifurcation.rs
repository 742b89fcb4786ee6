//! How motions change along a line: the boundaries and the times against what is known of them
//! otherwise.

use crate::support::{assert_near, columns};
use littlewood::tables::Quantity;
use littlewood::{Hoop, Limits, Start};
use littlewood_figures::{
    Axis, Figure, FigureError, FigureInput, Series, Varies, find_figure, plain,
};

fn along(
    input: FigureInput,
    varies: impl Into<Varies>,
    from: f64,
    to: f64,
) -> Result<Figure, FigureError> {
    let along = Some(Axis::new(varies, from, to, 2).expect("an axis"));
    find_figure("bifurcation")
        .expect("a figure")
        .figure(&FigureInput { along, ..input })
}

fn of_case(name: &str) -> FigureInput {
    FigureInput::of_case(name).expect("a case")
}

/// The places of the boundaries.
fn boundaries(figure: &Figure, name: &str) -> Vec<f64> {
    let rows = columns(figure.series("boundary").expect("boundaries"), [name]);
    rows.chunks(2).map(|pair| pair[0][0]).collect()
}

#[test]
fn the_hoop_leaves_the_plane_from_the_rate_on_at_which_n_is_zero() {
    let theta = 0.3_f64;
    let input = FigureInput {
        start: Start::at(theta, 1.0),
        ..of_case("figure-3")
    };
    let figure = along(input, Quantity::ThetaRate, 0.2, 3.0).expect("it can be drawn");
    let last = *boundaries(&figure, "theta_rate")
        .last()
        .expect("a boundary");
    // h cos θ θ′² = 1 with h = 1/2.
    assert_near(
        last,
        libm::sqrt(2.0 / libm::cos(theta)),
        1e-9,
        "lift-off at once",
    );
    assert!(
        plain(&figure.caption).contains("leaves at once"),
        "{}",
        figure.caption
    );
}

#[test]
fn littlewoods_hoop_rolls_between_the_angles_of_the_paper() {
    let figure = along(of_case("figure-7"), Quantity::Theta, -3.1, 3.1).expect("it can be drawn");
    let found = boundaries(&figure, "theta");
    // (3.9): cos θ_s = 3/5 for μs = 1/2.
    let theta_s = libm::acos(0.6);
    assert_eq!(found.len(), 2);
    assert_near(found[0], -theta_s, 1e-9, "−θs");
    assert_near(found[1], theta_s, 1e-9, "θs");
}

#[test]
fn transitions_have_the_times_of_the_table_of_figure_3() {
    let figure =
        along(of_case("figure-3"), Quantity::ThetaRate, 2.0, 2.001).expect("it can be drawn");
    let rows = columns(
        figure.series("transition").expect("transitions"),
        ["theta_rate", "time"],
    );
    let first: Vec<f64> = rows
        .into_iter()
        .filter(|[rate, _]| *rate == 2.0)
        .map(|[_, time]| time)
        .collect();
    assert_eq!(first.len(), 4);
    assert_near(first[2], 1.518_670_213_819_437, 1e-12, "lift-off");
    for (found, wanted) in first.iter().zip([0.56411, 0.97322, 1.51867, 3.84740]) {
        assert_near(*found, wanted, 6e-6, "a transition");
    }
}

#[test]
fn phases_fill_the_time_of_each_motion_and_meet_at_transitions() {
    let figure =
        along(of_case("figure-3"), Quantity::ThetaRate, 1.8, 2.6).expect("it can be drawn");
    let transitions = columns(
        figure.series("transition").expect("transitions"),
        ["theta_rate", "time"],
    );
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for mode in ["rolling", "sliding", "flight"] {
        let series = figure.panels[1].layers.iter().map(|layer| &layer.series);
        let series: &Series = series
            .into_iter()
            .find(|series| series.name == mode)
            .expect("the mode is shown");
        corners.extend(columns(series, ["theta_rate", "time"]));
    }
    let most = corners.iter().map(|corner| corner[1]).fold(0.0, f64::max);
    for [rate, time] in corners {
        let is_end = time == 0.0 || time == most;
        assert!(
            is_end || transitions.contains(&[rate, time]),
            "({rate}, {time})"
        );
    }
}

#[test]
fn where_nothing_changes_or_nothing_can_be_it_is_refused() {
    // Near the bottom it rolls for ever.
    let input = FigureInput {
        start: Start::at(3.0, 0.1),
        ..of_case("figure-3")
    };
    let error = along(input, Quantity::ThetaRate, 0.1, 0.2).expect_err("no transition");
    assert!(matches!(error, FigureError::NoTransition { .. }), "{error}");
    assert!(
        error
            .to_string()
            .contains("theta_rate goes from 0.1 to 0.2"),
        "{error}"
    );
    let error = along(of_case("figure-3"), Quantity::MuS, 0.1, 1.0).expect_err("μk above μs");
    assert!(matches!(error, FigureError::Axis(_)), "{error}");
    let balanced = Hoop::new(
        littlewood::HoopParameters::thin(1.0)
            .with_offset(0.0)
            .with_friction(0.5, 0.4),
    );
    let input = FigureInput::new(
        balanced.expect("a hoop"),
        Start::at(0.0, 1.0),
        Limits::default(),
    );
    let error = along(input, Quantity::Slip, 0.0, 1.0).expect_err("a balanced hoop");
    assert!(matches!(error, FigureError::NeedsOffset { .. }), "{error}");
}

#[test]
fn a_line_of_friction_has_both_coefficients() {
    let input = FigureInput {
        start: Start::at(core::f64::consts::FRAC_PI_2, 1.5),
        ..of_case("figure-3")
    };
    let figure = along(input, Varies::Friction, 0.3, 1.0).expect("it can be drawn");
    let found = boundaries(&figure, "mu");
    // Rolling holds from the start on where |F| ≤ μs N at θ = π/2, θ′ = 1.5, by (2.12).
    let (normal, friction) = crate::support::THIN.rolling_forces(core::f64::consts::FRAC_PI_2, 1.5);
    assert!(
        found
            .iter()
            .any(|mu| (mu - friction.abs() / normal).abs() < 1e-9),
        "{found:?}"
    );
    let axis = figure.csv();
    assert!(
        axis.lines().next().expect("a header").contains("mu"),
        "{axis:.100}"
    );
}
