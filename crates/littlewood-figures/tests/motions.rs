//! The motions of the figures against the reference table, the parabola, the cycloid and the laws
//! of friction.

use crate::support::{assert_near, columns, figure, series};
use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, Start};
use littlewood_figures::{FigureInput, Series, find_figure};

/// Stick, slip and lift-off of Figure 3, computed elsewhere with 40 digits: τ, θ, θ′, η′.
const EVENTS: [[f64; 4]; 3] = [
    [
        0.564_107_553_101_996_7,
        2.917_225_656_789_249,
        2.936_443_261_445_296_5,
        0.0,
    ],
    [
        0.973_223_074_772_405_4,
        4.066_332_874_239_296,
        2.460_879_504_634_977,
        0.0,
    ],
    [
        1.518_670_213_819_437,
        5.236_735_770_878_168,
        1.998_705_937_114_14,
        0.607_696_268_534_750_7,
    ],
];
const LANDING: f64 = 3.847_395_556_686_894;

#[test]
fn figure_3a_has_the_transitions_of_the_table() {
    let figure = figure("figure-3a");
    let found = columns(
        series(&figure, "transition")[0],
        ["time", "theta", "theta_rate", "slip"],
    );
    assert_eq!(found.len(), 3);
    for (found, event) in found.iter().zip(EVENTS) {
        for (a, b) in found.iter().zip(event) {
            assert_near(*a, b, 1e-13, "transition");
        }
    }
    for [slip] in columns(series(&figure, "rolling")[0], ["slip"]) {
        assert_eq!(slip, 0.0);
    }
    let sliding = series(&figure, "sliding")[0];
    assert_eq!(sliding.pieces.len(), 2);
    let slip = sliding.column("slip").expect("a column");
    assert!(sliding.pieces[0].iter().all(|row| row[slip] <= 0.0));
    assert!(sliding.pieces[1].iter().all(|row| row[slip] >= 0.0));
}

#[test]
fn many_phases_of_a_mode_in_the_space_of_states_have_one_letter_with_their_number() {
    let light = HoopParameters::thin(0.05)
        .with_friction(0.5, 0.4)
        .with_restitution(0.5, littlewood::RestitutionLaw::Energetic);
    let hoop = Hoop::new(light).expect("a hoop");
    let light = FigureInput::new(hoop, Start::at(1.0, 2.0), Limits::default());
    let of_case = |name: &str| FigureInput::of_case(name).expect("a case");
    let mut counted = 0;
    for input in [light, of_case("stick-slip-no-jump"), of_case("figure-3")] {
        let entry = find_figure("figure-3a").expect("a figure");
        let figure = entry.figure(&input).expect("it can be drawn");
        for (letter, mode) in [("*s*", Mode::Sliding), ("*r*", Mode::Rolling)] {
            let phases = series(&figure, mode.name())[0].pieces.len();
            let labels = figure.panels.iter().flat_map(|panel| &panel.labels);
            let found: Vec<&str> = labels
                .map(|label| &*label.text)
                .filter(|text| text.ends_with(letter))
                .collect();
            if phases > 2 {
                assert_eq!(found, [format!("{phases} × {letter}")], "{input:?}");
                counted += 1;
            } else {
                assert_eq!(found, vec![letter; phases], "{input:?}");
            }
        }
    }
    assert!(counted > 2, "{counted}");
}

/// Divided differences of a column against time with respect to the first row, after adding a
/// multiple of τ².
fn slopes(series: &Series, column: &str, square: f64) -> Vec<f64> {
    let rows = columns(series, ["time", column]);
    let value = |row: &[f64; 2]| row[1] + square * (row[0] - rows[0][0]) * (row[0] - rows[0][0]);
    rows[1..]
        .iter()
        .map(|row| (value(row) - value(&rows[0])) / (row[0] - rows[0][0]))
        .collect()
}

fn assert_parabola(series: &Series) {
    for (column, square) in [("x", 0.0), ("y", 0.5)] {
        let slopes = slopes(series, column, square);
        // The first differences are those of small numbers.
        let last = slopes[slopes.len() - 1];
        for slope in &slopes[10..] {
            assert_near(*slope, last, 1e-10, &series.name);
        }
    }
}

#[test]
fn figure_3b_ends_in_a_parabola_and_shows_the_hoop_at_each_transition() {
    let figure = figure("figure-3b");
    assert_parabola(series(&figure, "mass centre, flight")[0]);
    let times: Vec<f64> = columns(series(&figure, "hoop")[0], ["time"])
        .into_iter()
        .map(|[time]| time)
        .collect();
    let wanted = [0.0, EVENTS[0][0], EVENTS[1][0], EVENTS[2][0], LANDING];
    assert_eq!(times.len(), wanted.len());
    for (a, b) in times.iter().zip(wanted) {
        assert_near(*a, b, 1e-13, "hoop");
    }
    for name in ["centre, rolling", "centre, sliding"] {
        for [y] in columns(series(&figure, name)[0], ["y"]) {
            assert_eq!(y, 1.0, "on the plane the centre is a radius above it");
        }
    }
}

#[test]
fn figure_7_rolls_on_a_cycloid_and_glides_on_a_parabola() {
    let path = figure("figure-7b");
    for [x, y] in columns(series(&path, "rolling")[0], ["x", "y"]) {
        // From the top: θ with y = 1 + cos θ, x = −θ − sin θ.
        let theta = libm::acos((y - 1.0).clamp(-1.0, 1.0));
        if theta > 1e-3 {
            assert_near(x, -theta - libm::sin(theta), 1e-10, "cycloid");
        }
    }
    assert_parabola(series(&path, "gliding")[0]);

    let plane = figure("figure-7a");
    let changes = columns(
        series(&plane, "transition")[0],
        ["time", "theta", "theta_rate", "slip"],
    );
    let slip_at = changes[0];
    assert_near(slip_at[0], libm::log(5.0), 1e-14, "τ_s");
    assert_near(libm::cos(slip_at[1]), 0.6, 1e-14, "cos θ_s");
    assert_near(slip_at[2], 0.75, 1e-14, "θ′(τ_s)");
    let times = columns(series(&path, "hoop")[0], ["time"]);
    let end = libm::log(5.0) + (89.0_f64.sqrt() - 3.0) / 5.0;
    assert_near(times[times.len() - 1][0], end, 1e-14, "τ_g");
    // η′ = θ′(1 + cos θ) + v with the momentum v that the hoop has when it slips.
    let v = -0.75 * 1.6;
    for series in series(&plane, "gliding") {
        if series.columns.len() == 4 {
            // At its end the rate has no bound, which the first term meets as 0·∞.
            let rows = columns(series, ["theta", "theta_rate", "slip"]);
            assert_eq!(rows[rows.len() - 1][1], f64::INFINITY);
            for &[theta, rate, slip] in &rows[..rows.len() - 1] {
                assert_near(
                    slip,
                    v + rate * (1.0 + libm::cos(theta)),
                    1e-9,
                    "v of (3.18)",
                );
            }
        }
    }
}

#[test]
fn forces_obey_the_laws_of_friction() {
    let figure = figure("forces");
    let [normal, friction] =
        ["normal force", "friction force"].map(|name| series(&figure, name)[0].clone());
    assert_eq!(normal.pieces.len(), 4, "sliding, rolling, sliding, flight");
    for (phase, (n, f)) in normal.pieces.iter().zip(&friction.pieces).enumerate() {
        for (n, f) in n.iter().zip(f) {
            let (n, f) = (n[1], f[1]);
            match phase {
                // Friction opposes the slip: to the left first.
                0 => assert_near(f, 0.4 * n, 1e-12, "slide"),
                1 => assert!(f.abs() <= 0.5 * n * (1.0 + 1e-12)),
                2 => assert_near(f, -0.4 * n, 1e-12, "slide"),
                _ => assert!(n == 0.0 && f == 0.0),
            }
        }
    }
    let rolled = &normal.pieces[1];
    let (n, f) = (
        rolled[rolled.len() - 1][1],
        friction.pieces[1][rolled.len() - 1][1],
    );
    assert_near(
        f.abs(),
        0.5 * n,
        1e-12,
        "rolling ends where static friction gives way",
    );
    let lift_off = normal.pieces[2].last().expect("rows")[1];
    assert_near(lift_off, 0.0, 1e-12, "N at lift-off");
}

#[test]
fn energy_is_lost_in_slides_alone() {
    let figure = figure("energy");
    let [total, kinetic, potential] = ["total energy", "kinetic energy", "potential energy"]
        .map(|name| series(&figure, name)[0].clone());
    for (phase, piece) in total.pieces.iter().enumerate() {
        for (row, total) in piece.iter().enumerate() {
            let sum = kinetic.pieces[phase][row][1] + potential.pieces[phase][row][1];
            assert_near(total[1], sum, 1e-13, "T + U");
            assert!(kinetic.pieces[phase][row][1] >= 0.0);
            match phase {
                1 | 3 => assert_near(total[1], piece[0][1], 1e-12, "conserved"),
                _ => assert!(row == 0 || total[1] < piece[row - 1][1] + 1e-14, "falls"),
            }
        }
    }
    assert_near(
        total.pieces[0][0][1],
        8.0,
        1e-14,
        "E at the start: ½·4·4 + 0",
    );
}

#[test]
fn figure_7a_ends_at_the_horizontal_velocity_of_the_particle() {
    // It rolls with θ′² (1 + cos θ) + cos θ = 3/2 up to cos θ = 3/5, so that θ′ = 3/4, and leaves
    // the particle there with −θ′ (1 + cos θ) = −6/5, which a free fall keeps. At the plane the
    // particle is the contact point.
    let figure = figure("figure-7a");
    let glides = series(&figure, "gliding");
    let slip = glides
        .iter()
        .filter(|series| series.column("theta").is_none());
    let last = slip
        .flat_map(|series| columns(series, ["time", "slip"]))
        .last()
        .expect("an end");
    assert_near(last[1], -1.2, 1e-12, "η′ at τ_g");
}

#[test]
fn what_cannot_be_shown_is_refused_with_the_reason() {
    let refused = |name: &str, hoop: Hoop, start: Start| {
        let input = FigureInput::new(hoop, start, Limits::default());
        let entry = find_figure(name).expect("a figure");
        entry
            .figure(&input)
            .expect_err("nothing to show")
            .to_string()
    };
    let smooth = Hoop::littlewood(0.0, 0.0).expect("a hoop");
    for name in ["figure-5a", "figure-5b", "figure-6b"] {
        assert!(
            refused(name, smooth, Start::at(0.0, 0.5)).contains("mu_s 0"),
            "{name}"
        );
    }
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    for name in ["figure-3a", "forces"] {
        assert!(
            refused(name, hoop, Start::at(0.0, 3.5)).contains("leaves the plane at once"),
            "{name}"
        );
    }
}

#[test]
fn the_names_of_transitions_stand_beside_or_above_each_other() {
    // Slip, reversal and stick within a tenth of the picture.
    let hoop = Hoop::new(
        HoopParameters::thin(0.0)
            .with_inertia(0.05)
            .with_friction(0.5, 0.4),
    )
    .expect("a hoop");
    let input = FigureInput::new(hoop, Start::at(2.0, 0.5), Limits::until(8.0));
    let motion = hoop.simulate(input.start, input.limits).expect("a motion");
    let figure = find_figure("forces")
        .expect("a figure")
        .figure(&input)
        .expect("it can be drawn");
    let named = figure.panels[0]
        .labels
        .iter()
        .filter(|label| Cause::ALL.iter().any(|cause| cause.label() == label.text));
    assert_eq!(named.count(), motion.transitions().len());
    let labels = figure.panels[0].labels.iter();
    let named = labels.filter(|label| Mode::ALL.iter().any(|mode| mode.name() == label.text));
    let without = motion.phases().len() - named.count();
    assert!(without > 1, "{without}");
    let note = format!("There is no room for the names of {without} phases.");
    assert!(figure.notes.contains(&note), "{:?}", figure.notes);
    assert!(figure.caption.ends_with(&note));
}

/// The hoops of a figure on a ramp: their circles touch the line of the plane, which rises by the
/// slope, and the particle is drawn where a level camera sees it.
#[test]
fn on_a_ramp_the_hoop_is_drawn_on_the_ramp() {
    let ramp = littlewood::cases::find_case("ramp-jump")
        .expect("a case")
        .setup;
    for (slope, theta) in [(0.2, 0.5), (-0.7, -0.5), (1.4, 0.5)] {
        let hoop = Hoop::new(ramp.hoop.with_slope(slope)).expect("a hoop");
        let rise = libm::tan(slope);
        let start = Start::at(theta, 0.0);
        let input = FigureInput::new(hoop, start, Limits::default());
        for (name, hoops) in [("figure-3b", "hoop"), ("stroboscope", "hoop, ")] {
            let figure = find_figure(name)
                .expect("a figure")
                .figure(&input)
                .expect("it can be drawn");
            let panel = &figure.panels[0];
            let place = |at: [f64; 2]| panel.place(at.into()).expect("a plane").row();
            let [origin, unit_x, unit_y] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(place);
            let along = [unit_x[0] - origin[0], unit_x[1] - origin[1]];
            let radius = libm::hypot(along[0], along[1]);
            assert_near(
                -along[1] / along[0],
                rise,
                1e-9 * (1.0 + rise.abs()),
                "the slope",
            );
            assert_near(
                libm::hypot(unit_y[0] - origin[0], unit_y[1] - origin[1]),
                radius,
                1e-9,
                "one scale",
            );
            let [[left, top], [right, bottom]] = panel.axes_frame();
            let svg = figure.svg();
            let circles: Vec<[f64; 2]> = svg
                .split("<circle ")
                .skip(1)
                .map(|circle| {
                    let value = |name: &str| {
                        let (_, rest) = circle
                            .split_once(&format!("{name}=\""))
                            .expect("it has one");
                        rest.split_once('"')
                            .expect("an end")
                            .0
                            .parse::<f64>()
                            .expect("a number")
                    };
                    [value("cx"), value("cy")]
                })
                .collect();
            let series: Vec<&Series> = panel
                .layers
                .iter()
                .map(|layer| &layer.series)
                .filter(|series| series.name.starts_with(hoops))
                .collect();
            assert!(!series.is_empty(), "{name}");
            for [x, y, theta] in series
                .into_iter()
                .flat_map(|series| columns(series, ["x", "y", "theta"]))
            {
                let [right_of, down] = place([x, y]);
                assert!(
                    right_of - radius > left && right_of + radius < right,
                    "{name} at {slope}"
                );
                assert!(
                    down - radius > top && down + radius < bottom,
                    "{name} at {slope}"
                );
                let particle = [
                    right_of - 0.8 * radius * libm::sin(theta + slope),
                    down - 0.8 * radius * libm::cos(theta + slope),
                ];
                let nearest = circles
                    .iter()
                    .map(|[cx, cy]| libm::hypot(cx - particle[0], cy - particle[1]))
                    .fold(f64::INFINITY, f64::min);
                assert!(
                    nearest < 0.1,
                    "{name} at {slope}: the particle is {nearest} pixels off"
                );
            }
        }
    }
}
