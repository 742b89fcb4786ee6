//! Pictures: the right colour at the right place.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

use std::f64::consts::PI;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::support::{figure_2, map, workers};
use littlewood::tables::{Class, Quantity, Setup, SummaryColumn};
use littlewood::theory::PhasePlane;
use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, Start};
use littlewood_draw::MIXED_OUTCOMES;
use littlewood_style::{Curve, Theme, of_class};
use littlewood_sweep::{
    Axis, Chunk, Columns, Grid, Options, Picture, PictureError, PictureSize, Progress, Shade,
    SweepError, sweep_grid,
};

fn draw(grid: &Grid, shade: Shade, size: PictureSize) -> (Picture, Vec<u8>) {
    let picture = Picture::of_grid(
        grid,
        Limits::until(50.0),
        shade,
        size,
        &workers(2),
        &Options::default(),
    )
    .unwrap();
    let png = picture.png().unwrap();
    (picture, png)
}

fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels)
}

#[test]
fn the_map_of_figure_2_has_its_regions_where_they_are() {
    let size = PictureSize {
        width: 600,
        height: 400,
    };
    let (picture, png) = draw(&map(100), Shade::Class, size);
    let total: u64 = Class::ALL.iter().map(|&class| picture.count(class)).sum();
    assert_eq!((total, picture.count(Class::NotComputed)), (10_000, 0));
    let (width, height, pixels) = decode(&png);
    assert_eq!((width, height), (600, 400));
    // Colours along the line θ = 0, downwards in the picture: from θ′ = 4 (leaves at once) through
    // θ′ = 0 (rolls for ever) to θ′ = −4, which mirrors the upper half.
    let x = 318;
    let column: Vec<[u8; 3]> = (0..400)
        .map(|y| core::array::from_fn(|k| pixels[(y * 600 + x) * 3 + k]))
        .collect();
    let [dark, pale] =
        [Class::LeavesAtOnce, Class::RollsForever].map(|class| of_class(class, Theme::Light).0);
    let first = column.iter().position(|colour| *colour == dark).unwrap();
    let last = column.iter().rposition(|colour| *colour == dark).unwrap();
    assert!(last - first > 250, "{first} {last}");
    assert_eq!(column[usize::midpoint(first, last)], pale);
    // On it the body rolls for ever while θ′² < 1.2², roughly, of the 4: a bit less than a third.
    let rolling = column[first..last]
        .iter()
        .filter(|colour| **colour == pale)
        .count() as f64;
    assert!(
        (0.25..0.33).contains(&(rolling / (last - first) as f64)),
        "{rolling}"
    );
}

/// The share of pixels of the map that have the colour of another class than the motion that begins
/// there, among those that have the colour of a class.
fn wrong(picture: &Picture, grid: &Grid) -> f64 {
    let figure = picture.figure(None).unwrap();
    let [[left, top], [right, bottom]] = figure.panels.last().unwrap().axes_frame();
    let (width, height, pixels) = decode(&picture.png().unwrap());
    let scale = f64::from(width) / figure.width;
    let mut seen = Vec::new();
    // Steps that share no factor with the sides go everywhere.
    for i in 0..4000_u32 {
        let (x, y) = (i * 761 % width, i * 577 % height);
        let share = |pixel: u32, from: f64, to: f64| {
            ((f64::from(pixel) + 0.5) / scale - from) / (to - from)
        };
        let place = [share(x, left, right), 1.0 - share(y, top, bottom)];
        let at = 3 * (y * width + x) as usize;
        let colour = Class::ALL
            .into_iter()
            .find(|class| of_class(*class, Theme::Light).0 == pixels[at..at + 3]);
        if place.iter().all(|share| (0.0..1.0).contains(share))
            && let Some(class) = colour
        {
            let mut point = *grid.base();
            let [theta, rate] = [0, 1].map(|k| grid.axes()[k].between(place[k]));
            point.start = Start::at(theta, rate);
            seen.push((point, class));
        }
    }
    assert!(seen.len() > 2000, "{}", seen.len());
    let points = seen.iter().map(|(point, _)| *point);
    let columns = workers(2).compute(points, Limits::until(50.0)).unwrap();
    let wrong = seen
        .iter()
        .zip(columns.classes())
        .filter(|((_, shown), class)| shown != *class);
    wrong.count() as f64 / seen.len() as f64
}

/// The map of a hoop, its points without the boundaries between them.
fn of_points(hoop: HoopParameters, count: usize, limits: Limits) -> (Grid, Picture) {
    let base = Setup::new(hoop, Start::at(0.0, 0.0));
    let grid = Grid::new(base, map(count).axes().to_vec()).unwrap();
    let size = PictureSize {
        width: 600,
        height: 400,
    };
    let mut picture = Picture::new(&grid, limits, Shade::Class, size).unwrap();
    let mut add = |chunk: &Chunk, columns: &Columns| picture.add(chunk, columns);
    let options = Options::default();
    sweep_grid(&grid, limits, &[], Some(&mut add), &workers(2), &options).unwrap();
    (grid, picture)
}

#[test]
fn boundaries_are_followed_to_the_pixel() {
    // Bounces, and jams that go on by the law of restitution, are not seen in the classes.
    let hoop = figure_2().hoop;
    let law = RestitutionLaw::Energetic;
    let bouncing = hoop.with_restitution(0.5, law);
    let jamming = hoop.with_friction(3.0, 3.0).with_restitution(0.5, law);
    for hoop in [hoop, bouncing, jamming] {
        let (grid, mut picture) = of_points(hoop, 121, Limits::until(50.0));
        let before = wrong(&picture, &grid);
        assert!(picture.follow(&workers(2), &Options::default()).unwrap());
        let after = wrong(&picture, &grid);
        // What reaches less than a cell far is not seen.
        assert!(before > 5.0 * after && after < 0.002, "{before} {after}");
    }
}

#[test]
fn where_motions_take_long_boundaries_are_located_less_closely_and_the_key_says_so() {
    // Almost without friction a motion slides for thousands of turns.
    let hoop = figure_2().hoop.with_friction(1e-4, 1e-4);
    for (count, is_cut) in [(3, false), (20, true)] {
        let (_, mut picture) = of_points(hoop, count, Limits::default());
        let followed = AtomicU64::new(0);
        let count = |progress: Progress| {
            followed.fetch_max(progress.followed, Ordering::Relaxed);
        };
        let options = Options {
            progress: Some(&count),
            ..Options::default()
        };
        assert!(picture.follow(&workers(2), &options).unwrap());
        // Otherwise there are tens of thousands.
        let followed = followed.into_inner();
        assert!((16..8_000).contains(&followed), "{followed}");
        let caption = picture.figure(None).unwrap().caption;
        assert_eq!(caption.contains("less closely"), is_cut, "{caption}");
    }
}

#[test]
fn a_picture_is_the_same_every_time_and_a_finer_grid_is_thinned() {
    let size = PictureSize {
        width: 400,
        height: 300,
    };
    let (_, first) = draw(&map(30), Shade::Column(SummaryColumn::JumpHeight), size);
    let (_, second) = draw(&map(30), Shade::Column(SummaryColumn::JumpHeight), size);
    assert!(first == second);
    let axes = vec![
        Axis::new(Quantity::Theta, -PI, PI, 2_000).unwrap(),
        Axis::new(Quantity::ThetaRate, 4.0, -4.0, 3).unwrap(),
    ];
    let (picture, _) = draw(&Grid::new(figure_2(), axes).unwrap(), Shade::Class, size);
    assert_eq!(
        Class::ALL
            .iter()
            .map(|&class| picture.count(class))
            .sum::<u64>(),
        6_000
    );
}

#[test]
fn every_shade_can_be_drawn_also_where_nothing_has_a_value() {
    let axes = vec![
        Axis::new(Quantity::MassRatio, 0.5, 0.5, 1).unwrap(),
        Axis::new(Quantity::ThetaRate, -0.1, 0.1, 4).unwrap(),
    ];
    let grid = Grid::new(figure_2(), axes).unwrap();
    for shade in Shade::all() {
        draw(
            &grid,
            shade,
            PictureSize {
                width: 300,
                height: 300,
            },
        );
    }
}

#[test]
fn what_is_no_map_is_refused() {
    let one = Grid::new(figure_2(), vec![map(3).axes()[0]]).unwrap();
    let size = PictureSize::default();
    let error = Picture::new(&one, Limits::default(), Shade::Class, size).unwrap_err();
    assert!(matches!(error, PictureError::NotTwoAxes { found: 1 }));
    for column in SummaryColumn::ALL {
        let picture = Picture::new(&map(3), Limits::default(), Shade::Column(column), size);
        let is_number = SummaryColumn::numbers().any(|number| number == column);
        match picture {
            Ok(_) => assert!(is_number, "{column}"),
            Err(PictureError::NoNumber { column: refused }) => {
                assert!(!is_number && refused == column);
            }
            Err(error) => panic!("{error}"),
        }
    }
    let column = "end_x_by_mu_k".parse().unwrap();
    let error =
        Picture::new(&map(3), Limits::default(), Shade::Derivative(column), size).unwrap_err();
    assert!(matches!(error, PictureError::NotComputed { column: refused } if refused == column));
    let grid = map(3).with_derivatives(vec![column]);
    assert!(Picture::new(&grid, Limits::default(), Shade::Derivative(column), size).is_ok());
    for (width, height) in [(0, 500), (500, 299), (100_000, 500)] {
        let error = Picture::of_grid(
            &map(3),
            Limits::default(),
            Shade::Class,
            PictureSize { width, height },
            &workers(1),
            &Options::default(),
        );
        assert!(matches!(
            error,
            Err(SweepError::Picture(PictureError::Size { .. }))
        ));
    }
}

/// The points of the curves over a map of one turn and of rates below 4, as angles and rates.
fn curves(hoop: HoopParameters, theta_first: bool) -> Vec<(Curve, f64, f64)> {
    let theta = Axis::new(Quantity::Theta, -PI, PI, 20).unwrap();
    let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 20).unwrap();
    let axes = if theta_first {
        vec![theta, rate]
    } else {
        vec![rate, theta]
    };
    let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), axes).unwrap();
    let picture = Picture::new(
        &grid,
        Limits::default(),
        Shade::Class,
        PictureSize::default(),
    );
    let figure = picture
        .and_then(Picture::with_curves)
        .unwrap()
        .figure(None)
        .unwrap();
    let plane = figure
        .panels
        .into_iter()
        .find(|panel| panel.name == "plane")
        .unwrap();
    let named = |name: &str| Curve::ALL.into_iter().find(|curve| curve.name() == name);
    let known = plane
        .layers
        .iter()
        .filter_map(|layer| Some((named(&layer.series.name)?, &layer.series.pieces)));
    known
        .flat_map(|(curve, pieces)| pieces.iter().flatten().map(move |point| (curve, point)))
        .map(|(curve, point)| {
            let [x, y] = if theta_first {
                [point[0], point[1]]
            } else {
                [point[1], point[0]]
            };
            (curve, PI * (2.0 * x - 1.0), 4.0 * (2.0 * y - 1.0))
        })
        .collect()
}

#[test]
fn each_curve_is_where_its_equation_holds() {
    let heavy = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let massless = HoopParameters::thin(0.0).with_friction(0.5, 0.5);
    let (tilted, tilted_massless) = (heavy.with_slope(0.4), massless.with_slope(0.3));
    let cases = [
        (heavy, true),
        (heavy, false),
        (tilted, true),
        (massless, true),
        (tilted_massless, true),
    ];
    for (parameters, theta_first) in cases {
        let hoop = Hoop::new(parameters).unwrap();
        let plane = PhasePlane::new(&hoop);
        let mut seen = [0; 3];
        for (curve, theta, rate) in curves(parameters, theta_first) {
            let forces = plane.forces(theta, rate);
            let (miss, number) = match curve {
                Curve::SlipLimit if forces.normal.abs() < 1e-9 => (forces.friction, 0),
                Curve::SlipLimit => (forces.friction.abs() - 0.5 * forces.normal, 0),
                Curve::NormalForceZero => (forces.normal, 1),
                Curve::LiftOff => (
                    libm::cos(hoop.slope()) - hoop.h() * libm::cos(theta) * rate * rate,
                    2,
                ),
                Curve::Separatrix | Curve::ReverseChatter | Curve::Level | Curve::BandOfRest => {
                    (f64::NAN, 0)
                }
            };
            // Far up the plane the forces are large, and so are their errors.
            assert!(
                miss.abs() < 1e-9 * (1.0 + rate * rate),
                "{curve:?} at {theta} {rate}: {miss}"
            );
            seen[number] += 1;
        }
        // A massless hoop has verticals and lines, and never lifts off.
        let least = if parameters.mass_ratio > 0.0 {
            [20, 20, 20]
        } else {
            [8, 8, 0]
        };
        assert!(
            seen.iter().zip(least).all(|(count, least)| *count >= least),
            "{seen:?}"
        );
        assert!(parameters.mass_ratio > 0.0 || seen[2] == 0, "{seen:?}");
    }
}

#[test]
fn what_changes_from_point_to_point_has_one_tint_and_its_part_in_the_key() {
    // After many bounces sequences depend on the last digits.
    let law = RestitutionLaw::Energetic;
    let bouncing = figure_2()
        .hoop
        .with_friction(0.1, 0.05)
        .with_restitution(0.9, law);
    let base = Setup::new(bouncing, Start::at(0.0, 0.0));
    let grid = Grid::new(base, map(60).axes().to_vec()).unwrap();
    let size = PictureSize {
        width: 600,
        height: 400,
    };
    let limits = Limits::default().with_transitions(300);
    let (workers, options) = (workers(2), Options::default());
    let picture =
        Picture::of_grid(&grid, limits, Shade::Sequence, size, &workers, &options).unwrap();
    let figure = picture.figure(None).unwrap();
    let plane = figure.panels.last().unwrap();
    let mixed = plane
        .layers
        .iter()
        .find(|layer| layer.series.name == "mixed")
        .unwrap();
    // Closed curves, counterclockwise about what is mixed.
    let area = mixed.series.pieces.iter().map(|piece| {
        let edges = piece.iter().zip(piece.iter().cycle().skip(1));
        edges
            .map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1]))
            .sum::<f64>()
    });
    let part = format!("{:.1} %", 100.0 * area.sum::<f64>());
    let keys: Vec<&str> = plane.keys.iter().map(|key| &*key.text).collect();
    let own = format!("of these mixed more finely than drawn, {part}");
    assert!(keys.contains(&&*own), "{own}: {keys:?}");
    // Not followed to its boundaries a picture has the same tint.
    let mut points = Picture::new(&grid, limits, Shade::Sequence, size).unwrap();
    let mut add = |chunk: &Chunk, columns: &Columns| points.add(chunk, columns);
    sweep_grid(&grid, limits, &[], Some(&mut add), &workers, &options).unwrap();
    let tint = |picture: &Picture| {
        let (_, _, pixels) = decode(&picture.png().unwrap());
        let own = pixels
            .chunks_exact(3)
            .filter(|pixel| **pixel == MIXED_OUTCOMES.0);
        own.count() as f64 / (pixels.len() / 3) as f64
    };
    let [followed, found] = [tint(&picture), tint(&points)];
    // Boundaries cut the corners of cells.
    assert!(
        followed > 0.02 && (0.8..1.25).contains(&(followed / found)),
        "{followed} {found}"
    );
}
