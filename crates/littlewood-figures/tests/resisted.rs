//! Figures of hoops with rolling resistance: against the closed forms of
//! docs/theory/rolling-resistance.md and the motions themselves.

use core::f64::consts::{PI, TAU};

use crate::support::{columns, outlines, winding};
use littlewood::{Hoop, HoopParameters, Limits, Start, Trajectory};
use littlewood_figures::{Figure, FigureError, FigureInput, find_figure, plain};
use littlewood_style::RestingPlace;

fn hoop(offset: f64, resistance: f64) -> HoopParameters {
    HoopParameters::thin(1.0)
        .with_offset(offset)
        .with_inertia(0.5)
        .with_friction(0.5, 0.4)
        .with_rolling_resistance(resistance)
}

fn input(parameters: HoopParameters, start: Start) -> FigureInput {
    let hoop = Hoop::new(parameters).expect("a hoop");
    FigureInput::new(hoop, start, Limits::default())
}

/// Slides, rolls, turns back and rests.
fn swings() -> FigureInput {
    input(hoop(0.4, 0.05), Start::at(1.0, 0.2).with_slip(0.6))
}

fn figure(name: &str, input: &FigureInput) -> Figure {
    find_figure(name)
        .expect("a figure")
        .figure(input)
        .expect("it can be drawn")
}

fn motion(input: &FigureInput) -> Trajectory {
    input
        .hoop
        .simulate(input.start, input.limits)
        .expect("a motion")
}

/// When the motion rests.
fn rests(motion: &Trajectory) -> f64 {
    motion.phases().last().expect("phases").start().time
}

#[test]
fn portraits_have_the_band_of_rest_and_no_level_of_energy() {
    for name in ["figure-2a", "figure-2b", "phase-path"] {
        let input = input(hoop(0.4, 0.05), Start::at(1.0, 2.0));
        let figure = figure(name, &input);
        let band = figure.series("band_of_rest").expect("the band");
        // h = 0.2: |sin θ| ≤ ¼.
        let half = libm::asin(0.25);
        for piece in outlines(band, ["theta", "theta_rate"]) {
            let middle = 0.5 * (piece[0][0] + piece[1][0]);
            let is_whole = piece[1][0] - piece[0][0] > 2.0 * half - 1e-9;
            let turn = libm::round(middle / PI);
            assert!(
                !is_whole || (middle - PI * turn).abs() < 1e-12,
                "{name}: {middle}"
            );
            assert!(piece.iter().all(|row| row[1] == 0.0), "{name}");
        }
        let orbits = figure.series("orbits").expect("orbits");
        // An orbit gives energy away: above θ′ = 0 the one that passes the bottom with less rate than
        // another comes from nearer.
        assert!(orbits.rows().count() > 500, "{name}");
        let caption = plain(&figure.caption);
        assert!(
            caption.contains("band of rest") && !caption.contains("constant energy"),
            "{caption}"
        );
        let has_key = |text: &str| figure.panels[0].keys.iter().any(|key| key.text == text);
        assert!(name == "figure-2a" || has_key("band of rest"), "{name}");
    }
    let massless = HoopParameters::thin(0.0)
        .with_friction(0.5, 0.4)
        .with_rolling_resistance(0.05);
    let massless = input(massless, Start::at(0.0, 0.5));
    assert!(
        figure("figure-4", &massless)
            .series("band_of_rest")
            .is_some()
    );
    for name in ["figure-5a", "figure-5b", "figure-6b"] {
        let found = find_figure(name).expect("a figure").figure(&massless);
        let is_refused = |error: &FigureError| {
            matches!(
                error,
                FigureError::NeedsNoResistance {
                    resistance: 0.05,
                    ..
                }
            )
        };
        assert!(found.is_err_and(|error| is_refused(&error)), "{name}");
    }
}

#[test]
fn what_resistance_takes_is_beside_what_sliding_takes() {
    let input = swings();
    let motion = motion(&input);
    let figure = figure("energy", &input);
    let last = |name: &str| {
        let series = figure.series(name).unwrap_or_else(|| panic!("no {name}"));
        series.rows().last().expect("rows")[1]
    };
    let (all, resisted, slid) = (
        last("lost"),
        last("lost_to_rolling_resistance"),
        last("lost_to_friction"),
    );
    let taken = motion.rolling_resistance_energy_lost();
    assert!(
        (resisted - taken).abs() < 1e-12 && taken > 0.1,
        "{resisted} {taken}"
    );
    assert!(
        slid > 0.01 && (all - resisted - slid).abs() < 1e-12,
        "{all} {slid}"
    );
    let keys: Vec<&str> = figure.panels[0]
        .keys
        .iter()
        .map(|key| key.text.as_str())
        .collect();
    assert!(keys.contains(&"lost to rolling resistance") && keys.contains(&"lost to friction"));
}

#[test]
fn a_picture_that_is_cut_has_lost_what_the_motion_has_lost_until_then() {
    let parameters = HoopParameters::thin(1.0)
        .with_friction(0.5, 0.4)
        .with_rolling_resistance(1e-3);
    let input = input(parameters, Start::at(2.5, 0.0));
    let motion = motion(&input);
    assert!(motion.transitions().len() > 100);
    let figure = figure("energy", &input);
    let lost = columns(
        figure.series("lost").expect("losses"),
        ["time", "energy_lost"],
    );
    let [time, value] = *lost.last().expect("rows");
    let sample = motion.at(time).expect("an instant");
    let start = motion.phases()[0].first().energy;
    assert!(time < 0.5 * rests(&motion));
    assert!((value - (start - sample.energy)).abs() < 1e-9, "{value}");
    assert!(lost.windows(2).all(|pair| pair[1][1] >= pair[0][1] - 1e-12));
    let says = |figure: &Figure| {
        figure
            .notes
            .iter()
            .any(|note| note.contains("The hoop rests at"))
    };
    assert!(says(&figure), "{:?}", figure.notes);
}

#[test]
fn the_couple_is_at_its_limit_while_the_hoop_turns_and_balances_it_at_rest() {
    let input = swings();
    let figure = figure("forces", &input);
    let couple = figure
        .series("couple of rolling resistance")
        .expect("the couple");
    let motion = motion(&input);
    let hoop = motion.hoop();
    let mut held = 0;
    for row in couple.rows() {
        let (time, couple) = (row[0], row[1]);
        let mut events = motion.transitions().iter();
        if events.any(|event| (event.time() - time).abs() < 1e-9) {
            continue;
        }
        let sample = motion.at(time).expect("an instant");
        let limit = hoop.rolling_resistance() * sample.normal;
        if sample.state.theta_rate == 0.0 {
            assert!(couple.abs() <= limit + 1e-12, "{time}");
            held += 1;
        } else if sample.state.theta_rate.abs() > 1e-6 {
            let expected = -limit.copysign(sample.state.theta_rate);
            assert!(
                (couple - expected).abs() < 1e-9,
                "{time}: {couple} {expected}"
            );
        }
    }
    assert!(held > 2, "{held}");
}

#[test]
fn pictures_of_a_motion_that_rests_end_shortly_after() {
    let input = swings();
    let since = rests(&motion(&input));
    for name in ["sheet", "forces", "energy"] {
        let figure = figure(name, &input);
        let times = figure.panels.iter().flat_map(|panel| &panel.layers);
        let last = times
            .filter(|layer| layer.series.column("time") == Some(0))
            .flat_map(|layer| layer.series.rows().map(|row| row[0]).collect::<Vec<_>>())
            .fold(0.0, f64::max);
        assert!(
            last > since && last < 1.101 * since,
            "{name}: {last} {since}"
        );
    }
}

#[test]
fn outcomes_say_in_which_turn_a_hoop_rests() {
    let input = input(hoop(0.4, 0.15), Start::at(0.0, 0.0));
    let figure = figure("outcomes", &input);
    let mut places = 0;
    for place in RestingPlace::ALL {
        let Some(region) = figure.series(place.name()) else {
            continue;
        };
        places += 1;
        let lines = outlines(region, ["theta", "theta_rate"]);
        for k in 0..12 {
            let start = Start::at(-1.2 + 0.7 * f64::from(k), 0.3 * f64::from(k % 7) - 0.9);
            if winding(&lines, [start.theta, start.theta_rate]) == 0 {
                continue;
            }
            let motion = input.hoop.simulate(start, input.limits).expect("a motion");
            let end = motion.outcome().state().theta;
            // A boundary is located to a part of the plane.
            let is_near = (end / TAU - libm::round(end / TAU)).abs() < 1e-2;
            assert!(
                is_near || RestingPlace::of(end) == place,
                "{start:?} {end} {place:?}"
            );
        }
    }
    assert!(places >= 4, "{places}");
}
