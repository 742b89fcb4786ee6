//! Figures that the paper does not have: all of a motion on a sheet, the cone of friction,
//! Painlevé's paradox.

use core::f64::consts::{FRAC_PI_4, PI};

use crate::support::{Body, THIN, assert_near, columns, figure, series};
use littlewood::theory::PhasePlane;
use littlewood::{Hoop, HoopParameters, Limits, Mode, RestitutionLaw, Start};
use littlewood_figures::{Figure, FigureInput, Mark, Panel, Series, View, find_figure};

fn panel<'a>(figure: &'a Figure, name: &str) -> &'a Panel {
    figure
        .panels
        .iter()
        .find(|panel| panel.name == name)
        .expect("a panel")
}

fn of_panel<'a>(figure: &'a Figure, name: &str, series: &str) -> &'a Series {
    let layers = &panel(figure, name).layers;
    layers
        .iter()
        .map(|layer| &layer.series)
        .find(|found| found.name == series)
        .expect("a series")
}

#[test]
fn a_sheet_has_all_quantities_at_the_same_times() {
    let figure = figure("sheet");
    let names: Vec<&str> = figure.panels.iter().map(|panel| panel.name).collect();
    assert_eq!(
        names,
        [
            "theta",
            "theta_rate",
            "slip",
            "x",
            "y",
            "gap",
            "normal",
            "friction"
        ]
    );
    let frames: Vec<_> = figure.panels.iter().map(|panel| panel.frame).collect();
    assert!(
        frames
            .windows(2)
            .all(|pair| pair[0].left == pair[1].left && pair[0].width == pair[1].width)
    );
    let value = |name| {
        columns(
            of_panel(&figure, name, Mode::Rolling.name()),
            ["time", name],
        )
    };
    let [theta, rate, normal, friction] = ["theta", "theta_rate", "normal", "friction"].map(value);
    for i in 0..theta.len() {
        let (n, f) = THIN.rolling_forces(theta[i][1], rate[i][1]);
        assert_near(normal[i][1], n, 1e-10, "N by (2.12)");
        assert_near(friction[i][1], f, 1e-10, "F by (2.12)");
        assert!(
            [rate[i], normal[i], friction[i]]
                .iter()
                .all(|row| row[0] == theta[i][0])
        );
    }
}

#[test]
fn the_mass_centre_of_a_sheet_lies_on_the_line_to_the_particle() {
    let figure = figure("sheet");
    let h = 0.5;
    for mode in [Mode::Rolling, Mode::Flight] {
        let value = |name| columns(of_panel(&figure, name, mode.name()), [name]);
        let [theta, x, y, gap] = ["theta", "x", "y", "gap"].map(value);
        let centre = |name| columns(of_panel(&figure, name, "mass centre"), ["time", name]);
        let times = columns(of_panel(&figure, "theta", mode.name()), ["time"]);
        for i in (0..theta.len()).step_by(7) {
            let (sin, cos) = libm::sincos(theta[i][0]);
            assert_near(
                y[i][0],
                1.0 + gap[i][0],
                1e-12,
                "the centre is a radius above the lowest point",
            );
            for (name, wanted) in [("x", x[i][0] - h * sin), ("y", y[i][0] + h * cos)] {
                let is_there = centre(name)
                    .iter()
                    .any(|[time, found]| *time == times[i][0] && (found - wanted).abs() < 1e-11);
                assert!(is_there, "{mode}, {name} at {}", times[i][0]);
            }
        }
    }
}

#[test]
fn a_rate_without_bound_does_not_hide_the_rest_of_a_sheet() {
    let input = FigureInput::of_case("figure-7").expect("a case");
    let figure = find_figure("sheet")
        .expect("a figure")
        .figure(&input)
        .expect("it can be drawn");
    let rates = columns(
        of_panel(&figure, "theta_rate", Mode::Gliding.name()),
        ["theta_rate"],
    );
    // The axis ends at a rate of the glide, and a mark says that the rate has no bound.
    let View::Plane { y, .. } = &panel(&figure, "theta_rate").view else {
        panic!("a plane")
    };
    assert!(rates[0][0] > 0.4 && y.range.to < 10.0, "{:?}", y.range);
    assert_eq!(rates[rates.len() - 1], [f64::INFINITY]);
    let beyond = of_panel(&figure, "theta_rate", "gliding beyond the axis");
    assert_eq!(columns(beyond, ["theta_rate"]), [[f64::INFINITY]]);
    let labels = &panel(&figure, "theta_rate").labels;
    assert!(labels.iter().any(|label| label.text == "∞"));
    // η′ is finite at the end, −6/5.
    let slips = columns(of_panel(&figure, "slip", Mode::Gliding.name()), ["slip"]);
    assert_near(slips[slips.len() - 1][0], -1.2, 1e-12, "η′");
}

/// Where P = 0 for a thin hoop with the particle on the rim, by hand: with m = 1/γ, h = γ and I =
/// (1 − γ²)/γ, I + m h s (h s − μ (1 + h c)) = (1 − γ² c²)/γ − μ s (1 + γ c).
fn threshold(share: f64, theta: f64) -> f64 {
    let (sin, cos) = libm::sincos(theta);
    (1.0 - share * cos) / (share * sin)
}

#[test]
fn sliding_has_no_solution_above_the_curve_of_a_hoop() {
    let figure = figure("painleve");
    let mut shares = Vec::new();
    for found in series(&figure, "gamma=") {
        let share: f64 = found
            .name
            .trim_start_matches("gamma=")
            .parse()
            .expect("a number");
        shares.push(share);
        for [theta, mu] in columns(found, ["theta", "mu_k"]) {
            assert!(
                (mu - threshold(share, theta)).abs() <= 1e-9 * mu.max(1.0),
                "γ = {share} at {theta}: {mu}"
            );
        }
    }
    assert_eq!(shares, [1.0, 0.9, 0.6, 0.5]);
    for ([theta, mu], share) in columns(series(&figure, "least of a hoop")[0], ["theta", "mu_k"])
        .into_iter()
        .zip(&shares[1..])
    {
        assert_near(mu, (1.0 - share * share).sqrt() / share, 1e-12, "least μk");
        assert_near(libm::cos(theta), *share, 1e-6, "there cos θ = γ");
    }
    let own = columns(series(&figure, "least of this hoop")[0], ["theta", "mu_k"]);
    assert_near(own[0][1], 7.0_f64.sqrt() / 3.0, 1e-12, "γ = ¾");
    // γ (sin θ + cos θ) = 1 at μk = 1.
    let ends = columns(series(&figure, "ends")[0], ["theta"]);
    let half = libm::acos(1.0 / (0.75 * 2.0_f64.sqrt()));
    assert_near(ends[0][0], FRAC_PI_4 - half, 1e-12, "from");
    assert_near(ends[1][0], FRAC_PI_4 + half, 1e-12, "to");
}

#[test]
fn a_light_hoop_may_have_two_intervals_without_a_solution() {
    let hoop = Hoop::new(
        HoopParameters::thin(0.02)
            .with_offset(0.7)
            .with_friction(1.03, 1.03),
    )
    .expect("a hoop");
    let input = FigureInput::new(hoop, Start::at(1.0, 0.0), Limits::default());
    let figure = find_figure("painleve")
        .expect("a figure")
        .figure(&input)
        .expect("it can be drawn");
    let ends = columns(series(&figure, "ends")[0], ["theta"]);
    assert_eq!(ends.len(), 4);
    let (m, i) = (1.02, 0.02 + 0.02 * 0.49 / 1.02);
    let h = 0.7 / m;
    for [theta] in ends {
        let (sin, cos) = libm::sincos(theta);
        let p = i + m * h * sin * (h * sin - 1.03 * (1.0 + h * cos));
        assert!(p.abs() < 1e-12, "{p} at {theta}");
    }
}

#[test]
fn a_stroboscope_shows_the_hoop_at_equal_times_with_the_forces_there() {
    let figure = figure("stroboscope");
    let mut hoops: Vec<[f64; 2]> = series(&figure, "hoop, ")
        .into_iter()
        .flat_map(|found| columns(found, ["time", "x"]))
        .collect();
    hoops.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(hoops.len() >= 5 && hoops[0] == [0.0, 0.0]);
    let step = hoops[1][0];
    for pair in hoops.windows(2) {
        assert_near(pair[1][0] - pair[0][0], step, 1e-12, "a step of time");
    }
    let motion = littlewood::cases::find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a motion");
    let mut units = Vec::new();
    for (name, column, axis) in [
        ("normal force at", "normal", "y"),
        ("friction force at", "friction", "x"),
    ] {
        for found in series(&figure, name) {
            for rows in columns(found, ["time", "x", "y", column])
                .chunks(2)
                .zip(columns(found, [axis]).chunks(2))
            {
                let ([from, _], [a, b]) = (rows.0, rows.1) else {
                    panic!("an arrow has two ends")
                };
                let sample = motion.at(from[0]).expect("an instant of the motion");
                assert!(
                    from[1] == sample.centre.x && from[2] == 0.0,
                    "from the point of contact"
                );
                let force = if column == "normal" {
                    sample.normal
                } else {
                    sample.friction
                };
                assert_eq!(from[3], force);
                units.push(force / (b[0] - a[0]));
            }
        }
    }
    assert!(units.len() > 4);
    for unit in &units {
        assert_near(*unit, units[0], 1e-9, "one scale for all arrows");
    }
}

#[test]
fn a_motion_back_and_forth_is_shown_once() {
    let input = FigureInput::of_case("figure-2-libration").expect("a case");
    let figure = find_figure("stroboscope")
        .expect("a figure")
        .figure(&input)
        .expect("it can be drawn");
    let mut places: Vec<[f64; 2]> = series(&figure, "hoop, ")
        .into_iter()
        .flat_map(|found| columns(found, ["time", "x"]))
        .collect();
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    // To the left, as θ grows, with the one at the turn at most.
    assert!(
        places
            .windows(2)
            .rev()
            .skip(1)
            .all(|pair| pair[1][1] < pair[0][1])
    );
    assert!(figure.caption.contains("beginning"));
}

#[test]
fn rolling_follows_an_orbit_in_the_phase_portrait() {
    let figure = figure("phase-path");
    let energies: Vec<f64> = columns(
        series(&figure, Mode::Rolling.name())[0],
        ["theta", "theta_rate"],
    )
    .into_iter()
    .map(|[theta, rate]| THIN.energy(theta, rate))
    .collect();
    for energy in &energies {
        assert_near(*energy, energies[0], 1e-12, "E");
    }
    let changes = columns(series(&figure, "transition")[0], ["theta", "theta_rate"]);
    // Stick, slip, lift-off as computed elsewhere; the rate does not change in flight.
    let wanted = [
        [2.917_225_656_789_249, 2.936_443_261_445_296_5],
        [4.066_332_874_239_296, 2.460_879_504_634_977],
        [5.236_735_770_878_168, 1.998_705_937_114_14],
        [9.891_172_939_575_516, 1.998_705_937_114_14],
    ];
    assert_eq!(changes.len(), wanted.len());
    for (found, wanted) in changes.iter().flatten().zip(wanted.iter().flatten()) {
        assert_near(*found, *wanted, 1e-12, "a transition");
    }
}

#[test]
fn what_is_drawn_of_a_phase_path_is_in_its_window() {
    let fast = Hoop::littlewood(0.5, 0.4).expect("a hoop");
    let inputs = [
        FigureInput::of_case("figure-3-bounces").expect("a case"),
        FigureInput::of_case("figure-7").expect("a case"),
        FigureInput::new(fast, Start::at(7.0, 4.0), Limits::default()),
    ];
    for input in inputs {
        let figure = find_figure("phase-path")
            .expect("a figure")
            .figure(&input)
            .expect("it can be drawn");
        let View::Plane { x, y, .. } = &figure.panels[0].view else {
            panic!("a plane")
        };
        for layer in &figure.panels[0].layers {
            let marked = layer.is_marked_beyond || matches!(layer.mark, Mark::Beyond(_));
            for [theta, rate] in columns(&layer.series, ["theta", "theta_rate"]) {
                let is_head = layer.series.name == "arrow of time" || layer.series.name == "flow";
                let inside = (x.range.from - 1e-9..=x.range.to + 1e-9).contains(&theta)
                    && (marked || (y.range.from - 1e-9..=y.range.to + 1e-9).contains(&rate));
                assert!(is_head || inside, "{}: {theta}, {rate}", layer.series.name);
            }
        }
    }
}

#[test]
fn a_massless_hoop_with_its_particle_inside_has_a_portrait() {
    let l = 0.6;
    let body = Body {
        m1: 0.0,
        l,
        izz: 0.0,
    };
    let of = |mu: f64| {
        let hoop = Hoop::new(
            HoopParameters::thin(0.0)
                .with_offset(l)
                .with_friction(mu, mu),
        )
        .expect("a hoop");
        let input = FigureInput::new(hoop, Start::at(0.5, 0.3), Limits::default());
        find_figure("figure-4")
            .expect("a figure")
            .figure(&input)
            .expect("it can be drawn")
    };
    let figure = of(0.5);
    for orbit in series(&figure, "orbit") {
        for [theta, rate, energy] in columns(orbit, ["theta", "theta_rate", "energy"]) {
            assert_near(body.energy(theta, rate), energy, 1e-9, "E of (2.8)");
        }
    }
    for [theta, rate] in columns(series(&figure, "n")[0], ["theta", "theta_rate"]) {
        assert!(
            body.rolling_forces(theta, rate).0.abs() < 1e-8 * (1.0 + rate * rate),
            "N = 0 at {theta}"
        );
    }
    let slip = columns(series(&figure, "f")[0], ["theta"]);
    // Two about each bottom and two about each top, seen once and twice.
    assert_eq!(slip.len(), 2 * 6);
    for [theta] in slip {
        let (sin, cos) = libm::sincos(theta);
        assert_near(l * sin.abs() / (1.0 + l * cos), 0.5, 1e-12, "|F|/N");
    }
    for [theta, rate] in columns(series(&figure, "R")[0], ["theta", "theta_rate"]) {
        let (n, f) = body.rolling_forces(theta, 0.999 * rate);
        assert!(
            n >= -1e-9 && f.abs() <= 0.5 * n * (1.0 + 1e-6) + 1e-9,
            "𝓡 at {theta}, {rate}: {n}, {f}"
        );
    }
    // ℓ/√(1 − ℓ²) = 3/4: with more friction than that it never slips.
    assert!(of(0.76).series("f").is_none() && of(0.74).series("f").is_some());
}

/// Whether a place lies in a polygon, by the edges that a ray to the right crosses.
fn is_inside(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let crossed = edges.filter(|([ax, ay], [bx, by])| {
        (*ay > y) != (*by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
    });
    crossed.count() % 2 == 1
}

/// On a slope, and nowhere on the level plane.
#[test]
fn reverse_chatter_is_bounded_where_bounces_grow() {
    for slope in [0.6, 0.0] {
        let parameters = HoopParameters::thin(0.25)
            .with_friction(1.0, 1.0)
            .with_slope(slope);
        let hoop =
            Hoop::new(parameters.with_restitution(0.8, RestitutionLaw::Energetic)).expect("a hoop");
        let input = FigureInput::new(hoop, Start::at(1.0, 0.5), Limits::default());
        let figure = find_figure("figure-2b")
            .expect("a figure")
            .figure(&input)
            .expect("it can be drawn");
        assert_eq!(figure.caption.contains("reverse chatter"), slope > 0.0);
        if slope == 0.0 {
            continue;
        }
        let plane = PhasePlane::new(&hoop);
        let mut seen = 0;
        for row in series(&figure, "reverse chatter")
            .iter()
            .flat_map(|edges| edges.rows())
        {
            let [below, above] =
                [-1e-4, 1e-4].map(|by| plane.reverse_chatter(row[0], row[1] + by).is_some());
            seen += u32::from(below != above);
        }
        assert!(seen > 100, "{seen}");
    }
}

#[test]
fn the_region_of_rolling_is_filled_up_to_its_edge() {
    for hoop in [
        HoopParameters::thin(0.02).with_offset(0.7),
        HoopParameters::thin(1.0),
        HoopParameters::thin(0.0).with_offset(0.6),
    ] {
        let hoop = Hoop::new(hoop.with_friction(0.4, 0.3)).expect("a hoop");
        let input = FigureInput::new(hoop, Start::at(1.0, 0.5), Limits::default());
        let name = if hoop.mass_ratio() == 0.0 {
            "figure-4"
        } else {
            "figure-2b"
        };
        let figure = find_figure(name)
            .expect("a figure")
            .figure(&input)
            .expect("it can be drawn");
        let polygons: Vec<Vec<[f64; 2]>> = series(&figure, "R")[0]
            .pieces
            .iter()
            .map(|piece| piece.iter().map(|row| [row[0], row[1]]).collect())
            .collect();
        let View::Plane { y, .. } = &figure.panels[0].view else {
            panic!("a plane")
        };
        let plane = PhasePlane::new(&hoop);
        let (mut inside, mut wrong) = (0, 0);
        for i in 0..200 {
            for j in 0..100 {
                let place = [
                    2.0 * PI * (f64::from(i) + 0.31) / 200.0,
                    0.99 * y.range.to * (f64::from(j) + 0.37) / 50.0 - 0.99 * y.range.to,
                ];
                let wanted = plane.in_rolling_region(place[0], place[1]);
                let found = polygons.iter().any(|polygon| is_inside(polygon, place));
                inside += u32::from(wanted);
                wrong += u32::from(wanted != found);
            }
        }
        // Chords are flat to a part of 10,000 of the window.
        assert!(inside > 1000 && wrong < 30, "{hoop:?}: {wrong} of {inside}");
    }
}
