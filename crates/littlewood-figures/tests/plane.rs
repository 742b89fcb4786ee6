//! The loci, orbits and regions of the phase planes against the equations of the paper.

use core::f64::consts::{PI, TAU};

use crate::support::{THIN, assert_near, columns, figure, outlines, series, winding};
use littlewood::{Cause, Hoop, Limits, Mode, Start};
use littlewood_figures::{Dash, Figure, FigureInput, Mark, Range, Series, View, find_figure};

const PLANE: [&str; 2] = ["theta", "theta_rate"];
const EXACT: f64 = 1e-10;

#[test]
fn static_friction_gives_way_on_the_loci_of_figure_2() {
    for name in ["figure-2a", "figure-2b"] {
        let figure = figure(name);
        let loci = series(&figure, "f mu_s=");
        assert_eq!(loci.len(), if name == "figure-2a" { 4 } else { 1 });
        for locus in loci {
            for [theta, rate, mu_s] in columns(locus, ["theta", "theta_rate", "mu_s"]) {
                let (normal, friction) = THIN.rolling_forces(theta, rate);
                assert!(normal >= -EXACT, "{name}: N = {normal} on f");
                assert_near(friction.abs(), mu_s * normal, EXACT, name);
            }
        }
    }
}

#[test]
fn the_loci_have_the_coefficients_of_the_paper() {
    let figure = figure("figure-2a");
    let mut found: Vec<f64> = series(&figure, "f mu_s=")
        .iter()
        .map(|locus| columns(locus, ["mu_s"])[0][0])
        .collect();
    found.sort_by(f64::total_cmp);
    assert_eq!(found, [0.1, 0.25, 0.5, 1.0]);
}

#[test]
fn the_normal_force_vanishes_on_n_and_is_negative_beyond() {
    for name in ["figure-2a", "figure-2b", "outcomes"] {
        let figure = figure(name);
        for [theta, rate] in columns(series(&figure, "n")[0], PLANE) {
            let (normal, _) = THIN.rolling_forces(theta, rate);
            assert_near(normal, 0.0, EXACT, name);
            let (beyond, _) = THIN.rolling_forces(theta, 1.01 * rate);
            assert!(beyond < 0.0);
        }
    }
}

#[test]
fn orbits_conserve_energy() {
    for name in ["figure-2a", "figure-2b"] {
        let figure = figure(name);
        let orbits = series(&figure, "orbit E=");
        assert_eq!(orbits.len(), 9);
        for orbit in orbits {
            for [theta, rate, energy] in columns(orbit, ["theta", "theta_rate", "energy"]) {
                assert_near(THIN.energy(theta, rate), energy, EXACT, name);
            }
        }
        for [theta, rate] in columns(series(&figure, "separatrix")[0], PLANE) {
            assert_near(THIN.energy(theta, rate), THIN.energy(0.0, 0.0), EXACT, name);
        }
        let flows = if name == "figure-2b" {
            series(&figure, "flow")
        } else {
            Vec::new()
        };
        for flow in flows {
            for piece in &flow.pieces {
                let [from, to] = [&piece[0], &piece[1]];
                assert_near(
                    THIN.energy(from[0], from[1]),
                    THIN.energy(to[0], to[1]),
                    EXACT,
                    name,
                );
                assert!(
                    (to[0] - from[0]) * from[1] > 0.0,
                    "arrows point along the motion"
                );
            }
        }
    }
}

#[test]
fn an_orbit_of_libration_is_closed_and_dense() {
    let figure = figure("figure-2b");
    let closed: Vec<&Series> = series(&figure, "orbit E=")
        .into_iter()
        .filter(|orbit| columns(orbit, ["energy"])[0][0] < THIN.l)
        .collect();
    assert_eq!(closed.len(), 3);
    for orbit in closed {
        let whole = orbit.pieces.iter().find(|piece| {
            let (first, last) = (&piece[0], &piece[piece.len() - 1]);
            (first[0] - last[0]).abs() < 1e-9 && (first[1] - last[1]).abs() < 1e-6
        });
        let whole = whole.unwrap_or_else(|| panic!("{} is open", orbit.name));
        assert!(whole.len() > 12);
    }
}

#[test]
fn the_region_of_rolling_is_that_of_2_14() {
    let figure = figure("figure-2b");
    for region in series(&figure, "R") {
        for [theta, rate] in columns(region, PLANE) {
            // Corners are on the border; a little further in both conditions hold.
            let (normal, friction) = THIN.rolling_forces(theta, 0.999 * rate);
            assert!(
                normal > 0.0 && friction.abs() <= 0.5 * normal,
                "({theta}, {rate})"
            );
        }
    }
}

#[test]
fn the_body_leaves_the_plane_beyond_the_curve_of_figure_outcomes() {
    let figure = figure("outcomes");
    let h = THIN.l / (1.0 + THIN.m1);
    for [theta, rate] in columns(series(&figure, "lift-off")[0], PLANE) {
        assert_near(h * libm::cos(theta) * rate * rate, 1.0, EXACT, "lift-off");
    }
    // The region beyond it is bounded by it, to a part of 10⁶ of the window, and by the window.
    let littlewood_figures::View::Plane { x, y, .. } = &figure.panels[0].view else {
        panic!("a plane")
    };
    let mut on_it = 0;
    for [theta, rate] in columns(series(&figure, "leaves_at_once")[0], PLANE) {
        let on_edge =
            |range: Range, value: f64| range.ends().iter().any(|end| (end - value).abs() < 1e-3);
        if !on_edge(x.range, theta) && !on_edge(y.range, rate) {
            assert_near(
                h * libm::cos(theta) * rate * rate,
                1.0,
                1e-4,
                "the boundary",
            );
            on_it += 1;
        }
    }
    assert!(on_it > 100, "{on_it}");
}

#[test]
fn classes_are_those_of_the_simulation() {
    use littlewood::{Cause, Hoop, Limits, Mode, Outcome, Start};
    let figure = figure("outcomes");
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("a hoop");
    let regions = ["leaves_at_once", "lifts_off_later", "rolls_forever"]
        .map(|name| (name, outlines(series(&figure, name)[0], PLANE)));
    let mut wrong = 0;
    for i in 0..40 {
        for j in 0..30 {
            let theta = -0.5 * PI + 3.0 * PI * (f64::from(i) + 0.37) / 40.0;
            let rate = 7.0 * (f64::from(j) + 0.41) / 30.0 - 3.5;
            let motion = hoop
                .simulate(Start::at(theta, rate), Limits::default())
                .expect("a motion");
            let flies_first = motion.phases()[0].mode() == Mode::Flight;
            let lands = motion
                .transitions()
                .iter()
                .any(|transition| transition.cause == Cause::Landing);
            let found = match (motion.outcome(), flies_first, lands) {
                (Outcome::Landing { .. }, true, true) => "leaves_at_once",
                (Outcome::Landing { .. }, false, true) => "lifts_off_later",
                (Outcome::RollsForever { .. }, ..) => "rolls_forever",
                other => panic!("{other:?}"),
            };
            for (name, outlines) in &regions {
                let times = winding(outlines, [theta, rate]);
                assert!(
                    (0..=1).contains(&times),
                    "{name} ({theta}, {rate}): {times}"
                );
                wrong += u32::from((times == 1) != (found == *name));
            }
        }
    }
    // A place may lie between a boundary and its chord.
    assert!(wrong <= 2, "{wrong}");
}

/// θ_s for μs = ½ (3.9): cos θ_s = 3/5, so tan θ_s = 4/3.
fn theta_s() -> f64 {
    libm::atan2(4.0, 3.0)
}

/// e of (3.2).
fn e(theta: f64, rate: f64) -> f64 {
    let cos = libm::cos(theta);
    (1.0 + cos) * rate * rate + cos
}

#[test]
fn the_massless_hoop_slips_at_theta_s_and_unloads_at_rate_one() {
    for name in [
        "figure-4",
        "figure-5a",
        "figure-5b",
        "figure-6b",
        "figure-7a",
    ] {
        let figure = figure(name);
        for [theta, rate] in columns(series(&figure, "f")[0], PLANE) {
            assert_near(theta.abs(), theta_s(), 1e-14, name);
            assert!(rate.abs() <= 1.0 + 1e-12);
        }
        for [_, rate] in columns(series(&figure, "n")[0], PLANE) {
            assert_near(rate.abs(), 1.0, EXACT, name);
        }
        for [theta, rate] in columns(series(&figure, "R")[0], PLANE) {
            assert!(
                theta.abs() <= theta_s() + 1e-12 && rate.abs() <= 1.0 + EXACT,
                "{name}"
            );
        }
        // Four corners of a rectangle at least reach the border.
        let widest = columns(series(&figure, "R")[0], PLANE)
            .into_iter()
            .map(|[theta, _]| theta)
            .fold(0.0, f64::max);
        assert_near(widest, theta_s(), 1e-9, name);
    }
}

#[test]
fn massless_orbits_conserve_e() {
    for (name, prefix) in [
        ("figure-4", "orbit E="),
        ("figure-5b", "Type "),
        ("figure-5b", "end of rolling"),
    ] {
        let figure = figure(name);
        for orbit in series(&figure, prefix) {
            for [theta, rate, energy] in columns(orbit, ["theta", "theta_rate", "energy"]) {
                assert_near(e(theta, rate), energy, EXACT, &orbit.name);
            }
        }
    }
}

#[test]
fn motions_of_each_type_end_where_the_type_says() {
    let figure = figure("figure-5b");
    let corner = 1.0 + 2.0 * 0.6;
    let ends = columns(
        series(&figure, "end of rolling")[0],
        ["theta", "theta_rate", "energy"],
    );
    let mut count = [0; 3];
    for [theta, rate, energy] in ends {
        let (on_n, on_f) = (
            (rate.abs() - 1.0).abs() < 1e-9,
            (theta.abs() - theta_s()).abs() < 1e-9,
        );
        assert!(theta * rate > 0.0, "rolling ends outward");
        if (energy - corner).abs() < 1e-9 {
            assert!((rate.abs() - 1.0).abs() < 1e-7 && (theta.abs() - theta_s()).abs() < 1e-7);
            count[1] += 1;
        } else if energy > corner {
            assert!(on_n && !on_f, "Type I at ({theta}, {rate})");
            count[0] += 1;
        } else {
            assert!(on_f && !on_n, "Type III at ({theta}, {rate})");
            count[2] += 1;
        }
    }
    assert_eq!(count, [4, 2, 10]);
}

fn made(name: &str, input: &FigureInput) -> Figure {
    find_figure(name)
        .expect("a name of the catalogue")
        .figure(input)
        .expect("it can be drawn")
}

/// Coefficients of friction from little to much, on both sides of 1, where Type II meets the
/// equilibrium.
const FRICTIONS: [f64; 19] = [
    0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999, 1.0, 1.001, 1.01, 1.1, 1.5, 2.0, 3.0, 5.0,
    7.0, 10.0,
];

fn littlewood_with(mu_s: f64) -> Hoop {
    Hoop::littlewood(mu_s, 0.5 * mu_s).expect("a hoop")
}

/// How the simulated motion from a place in 𝓡 ends to roll; `None` where it does not.
fn simulated(hoop: &Hoop, theta: f64, rate: f64) -> Option<Cause> {
    let start = Start::at(theta, rate);
    let motion = hoop.simulate(start, Limits::default()).expect("a motion");
    let first = motion.transitions().first()?;
    (first.from == Some(Mode::Rolling)).then_some(first.cause)
}

fn of_type(name: &str) -> Option<Cause> {
    match name {
        "Type I" => Some(Cause::NormalForceZero),
        "Type III" => Some(Cause::Slip),
        _ => None,
    }
}

#[test]
fn the_lines_of_each_type_are_motions_that_end_so_for_every_friction() {
    for mu_s in FRICTIONS {
        let hoop = littlewood_with(mu_s);
        let input = FigureInput::new(hoop, Start::at(0.1, 0.0), Limits::default());
        let figure = made("figure-5b", &input);
        let two = 1.0 + 2.0 * (1.0 - mu_s * mu_s) / (1.0 + mu_s * mu_s);
        let corner = 2.0 * libm::atan(mu_s);
        let mut seen = Vec::new();
        for layer in &figure.panels[0].layers {
            let name = &*layer.series.name;
            if !name.starts_with("Type ") {
                continue;
            }
            let Mark::Line(stroke) = layer.mark else {
                panic!("{name}: a line")
            };
            let dash = match name {
                "Type I" => Dash::Solid,
                "Type II" => Dash::DashDot,
                _ => Dash::Short,
            };
            assert_eq!(stroke.dash, dash, "{name} with {mu_s}");
            seen.push(name.to_owned());
            for piece in &layer.series.pieces {
                let middle = &piece[piece.len() / 2];
                if name == "Type II" {
                    assert_near(e(middle[0], middle[1]), two, 1e-13, name);
                    let ends = [&piece[0], &piece[piece.len() - 1]];
                    assert!(ends.iter().any(|row| {
                        (row[0].abs() - corner).abs() < 1e-9 && (row[1].abs() - 1.0).abs() < 1e-9
                    }));
                } else {
                    let found = simulated(&hoop, middle[0], middle[1]);
                    assert_eq!(found, of_type(name), "{name} at {middle:?} with {mu_s}");
                }
            }
        }
        for name in ["Type I", "Type II", "Type III"] {
            assert!(seen.iter().any(|it| it == name), "no {name} with {mu_s}");
        }
    }
}

#[test]
fn regions_and_names_of_types_are_those_of_simulated_motions_for_every_friction() {
    for (mu_s, width_mm) in FRICTIONS
        .iter()
        .flat_map(|mu_s| [(*mu_s, None), (*mu_s, Some(84.0))])
    {
        let hoop = littlewood_with(mu_s);
        let input = FigureInput {
            width_mm,
            ..FigureInput::new(hoop, Start::at(0.1, 0.0), Limits::default())
        };
        let figure = made("figure-5a", &input);
        let panel = &figure.panels[0];
        let (corner, two) = (
            2.0 * libm::atan(mu_s),
            1.0 + 2.0 * (1.0 - mu_s * mu_s) / (1.0 + mu_s * mu_s),
        );
        // The dark area is Type I.
        let dark = outlines(series(&figure, "Type I")[0], PLANE);
        for i in -9..=9 {
            for j in -9..=9 {
                let [theta, rate] = [0.106 * f64::from(i) * corner, 0.106 * f64::from(j)];
                let energy = e(theta, rate);
                // Not on what bounds it, or on the manifolds.
                if (energy - two).abs() < 1e-3 || (energy - 1.0).abs() < 1e-9 {
                    continue;
                }
                let is_dark = winding(&dark, [theta, rate]) != 0;
                let found = simulated(&hoop, theta, rate);
                assert_eq!(
                    found == Some(Cause::NormalForceZero),
                    is_dark,
                    "{found:?} from {theta}, {rate} with {mu_s}"
                );
            }
        }
        // A name stands in its region with all its letters, or its line ends there.
        let View::Plane { x, y, .. } = &panel.view else {
            panic!("a plane")
        };
        let [[left, top], [right, bottom]] = panel.axes_frame();
        for name in ["Type I", "Type III"] {
            let boxes: Vec<_> = figure
                .texts()
                .into_iter()
                .filter(|(text, _)| text == name)
                .map(|(_, frame)| frame)
                .collect();
            assert!(!boxes.is_empty(), "no {name} with {mu_s}");
            let ends = figure.series(&format!("in {name}"));
            if let Some(ends) = ends {
                assert_eq!(ends.rows().count(), boxes.len());
                for row in ends.rows() {
                    assert_eq!(
                        simulated(&hoop, row[0], row[1]),
                        of_type(name),
                        "{name} {mu_s}"
                    );
                }
            }
            for [from, above, to, below] in boxes {
                for [pixels, down] in [[from, above], [to, above], [to, below], [from, below]] {
                    let theta = x.range.from + (pixels - left) / (right - left) * x.range.length();
                    let rate = y.range.to - (down - top) / (bottom - top) * y.range.length();
                    if ends.is_some() {
                        assert!(rate.abs() > 1.0, "{name} beside 𝓡 with {mu_s}");
                    } else {
                        let found = simulated(&hoop, theta, rate);
                        assert_eq!(
                            found,
                            of_type(name),
                            "{name} at {theta}, {rate} with {mu_s}"
                        );
                    }
                }
            }
        }
        let place = panel.labels.iter().find(|label| label.text == "Type II");
        let place = &place.expect("Type II has room").at;
        assert_near(e(place[0], place[1]), two, 1e-13, "Type II");
    }
}

#[test]
fn the_manifolds_of_the_equilibrium_are_those_of_3_7() {
    let figure = figure("figure-5a");
    for (name, sign) in [("Ws", -1.0), ("Wu", 1.0)] {
        for [theta, rate] in columns(series(&figure, name)[0], PLANE) {
            assert_near(rate, sign * libm::tan(0.5 * theta), EXACT, name);
            assert_near(e(theta, rate), 1.0, EXACT, name);
        }
    }
    for piece in &series(&figure, "Type II")[0].pieces {
        for row in piece {
            assert_near(e(row[0], row[1]), 1.0 + 2.0 * 0.6, EXACT, "Type II");
        }
    }
}

#[test]
fn gliding_conserves_the_corrected_integral_and_not_the_printed_one() {
    for (name, prefix) in [("figure-6a", "w="), ("figure-6b", "gliding")] {
        let figure = figure(name);
        let mut spread = 0.0_f64;
        for lines in series(&figure, prefix) {
            for piece in &lines.pieces {
                let printed: Vec<f64> = piece
                    .iter()
                    .map(|row| {
                        let (theta, rate, w) = (row[0], row[1], row[2]);
                        let (sin, cos) = libm::sincos(theta);
                        assert_near(0.5 * sin * sin * rate * rate + cos, w, EXACT, name);
                        0.5 * sin * rate * rate - theta
                    })
                    .collect();
                let (low, high) = printed
                    .iter()
                    .fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(*v), b.max(*v)));
                spread = spread.max(high - low);
            }
        }
        assert!(spread > 1.0, "{name}: the printed w varies by {spread}");
    }
}

#[test]
fn windows_show_a_turn_and_more() {
    let figure = figure("figure-2a");
    let [from, to] = match &figure.panels[0].view {
        littlewood_figures::View::Plane { x, .. } => x.range.ends(),
        littlewood_figures::View::Space { .. } => panic!("a plane"),
    };
    assert!(to - from > TAU);
}
