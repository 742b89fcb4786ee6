//! Grids, lists of points and what becomes of them.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

use crate::support::{bits, figure_2, map, mixed, reals, workers};
use littlewood::tables::{Class, Quantity, Setup, SummaryColumn, SummaryValue};
use littlewood::{Hoop, HoopParameters, Limits, OutcomeKind, RestitutionLaw, Start, Summary};
use littlewood_random::Draw;
use littlewood_sweep::{Axis, AxisError, Chunks, Grid, Spacing};
use proptest::prelude::*;

#[test]
fn the_map_of_figure_2_has_the_known_counts() {
    let grid = map(200);
    let columns = workers(2)
        .compute(grid.points(0..grid.len()), Limits::until(50.0))
        .unwrap();
    let classes: Vec<Class> = columns
        .summaries()
        .map(|summary| Class::of(&summary))
        .collect();
    let count = |wanted: fn(&Class) -> bool| classes.iter().filter(|class| wanted(class)).count();
    assert_eq!(count(|class| *class == Class::LeavesAtOnce), 9_784);
    assert_eq!(count(|class| *class == Class::LiftsOffLater), 12_690);
    assert_eq!(count(|class| class.stays_in_contact()), 17_526);
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let grid = mixed();
    let limits = Limits::until(30.0);
    let one = workers(1)
        .compute(grid.points(0..grid.len()), limits)
        .unwrap();
    for threads in [2, 3, 7] {
        let many = workers(threads);
        // Twice: the second time engines are kept from the first.
        for _ in 0..2 {
            let columns = many.compute(grid.points(0..grid.len()), limits).unwrap();
            assert_eq!(bits(&columns), bits(&one));
        }
    }
}

/// Outcome, sequence and number of transitions of a row are those of the simulation in lists of 1,
/// 100 and 1,000 rows, of which the longest have tables.
#[test]
fn a_row_does_not_depend_on_the_length_of_its_list() {
    let limits = Limits::until(40.0).with_transitions(200);
    let codes = |summary: &Summary| (summary.outcome, summary.sequence, summary.transitions);
    let bounces = figure_2()
        .hoop
        .with_restitution(0.5, RestitutionLaw::Energetic);
    let light = HoopParameters::thin(0.0)
        .with_inertia(1e-2)
        .with_friction(0.5, 0.4);
    for (stream, hoop) in [figure_2().hoop, bounces, light].into_iter().enumerate() {
        let starts = Vec::from_iter((0..1000).map(|number| {
            let mut draw = Draw::of_case(32, stream as u64, number);
            let [theta, rate, slip] =
                [Quantity::Theta, Quantity::ThetaRate, Quantity::Slip].map(|it| draw.allowed(it));
            Start::at(theta, rate).with_slip(if draw.comes(0.5) { slip } else { 0.0 })
        }));
        let of = |length: usize| -> Vec<_> {
            let points =
                |list: &[Start]| Vec::from_iter(list.iter().map(|start| Setup::new(hoop, *start)));
            let lists = starts
                .chunks(length)
                .map(|list| workers(2).compute(points(list), limits).unwrap());
            lists
                .flat_map(|columns| {
                    columns
                        .summaries()
                        .map(|one| codes(&one))
                        .collect::<Vec<_>>()
                })
                .collect()
        };
        let long = of(1000);
        assert_eq!(of(100), long);
        let body = Hoop::new(hoop).unwrap();
        for (start, (row, alone)) in starts.iter().zip(long.iter().zip(of(1))).step_by(3) {
            assert_eq!(
                (row, *row),
                (
                    &alone,
                    codes(&body.simulate(*start, limits).unwrap().summary())
                ),
                "{start:?}"
            );
        }
    }
}

#[test]
fn a_point_has_the_summary_of_its_simulation() {
    let grid = mixed();
    let limits = Limits::until(30.0);
    let columns = workers(2)
        .compute(grid.points(0..grid.len()), limits)
        .unwrap();
    let mut invalid = 0;
    for (number, found) in columns.summaries().enumerate() {
        let point = grid.point(number as u64);
        let Ok(hoop) = Hoop::new(point.hoop) else {
            assert!(point.hoop.mu_k > point.hoop.mu_s);
            assert_eq!(
                (found.outcome, Class::of(&found)),
                (OutcomeKind::Invalid, Class::Invalid)
            );
            assert!(SummaryColumn::reals().all(|column| reals(&columns, column)[number].is_nan()));
            invalid += 1;
            continue;
        };
        let expected = hoop.simulate(point.start, limits).unwrap().summary();
        for column in SummaryColumn::ALL {
            match (column.of(&found), column.of(&expected)) {
                (SummaryValue::F64(a), SummaryValue::F64(b)) => assert!(
                    a == b
                        || (a.is_nan() && b.is_nan())
                        || (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                    "{point:?}: {column}: {a} {b}"
                ),
                (a, b) => assert_eq!(a, b, "{point:?}: {column}"),
            }
        }
    }
    // μs in 0.1, 0.3, 0.5, 0.7 and μk in 0, 0.3, 0.6: of 12 pairs (0.1, 0.3), (0.1, 0.6), (0.3,
    // 0.6), (0.5, 0.6) are contradictions, and whether (0.3, 0.3) is one depends on how 0.3 is
    // rounded on either axis.
    let equal = grid.axes()[0].value(1) < grid.axes()[2].value(1);
    assert_eq!(invalid, (4 + usize::from(equal)) * 77);
}

/// Without rolling resistance nothing rests; with χ ≥ h a level hoop rests wherever it is put. Between
/// them each half swing ends, and the last one within the band h |sin θ| ≤ χ.
#[test]
fn a_map_by_resistance_has_where_and_when_hoops_rest() {
    let resistance = Axis::new(Quantity::RollingResistance, 0.0, 0.6, 4).unwrap();
    let theta = Axis::new(Quantity::Theta, -3.0, 3.0, 7).unwrap();
    let mut base = figure_2();
    base.start.theta_rate = 0.0;
    let h = Hoop::new(base.hoop).unwrap().h();
    let grid = Grid::new(base, vec![resistance, theta]).unwrap();
    let columns = workers(1)
        .compute(grid.points(0..grid.len()), Limits::default())
        .unwrap();
    let mut rest = [0; 4];
    for (number, found) in columns.summaries().enumerate() {
        let point = grid.point(number as u64);
        let chi = point.hoop.rolling_resistance;
        let motion = Hoop::new(point.hoop)
            .unwrap()
            .simulate(point.start, Limits::default())
            .unwrap();
        assert_eq!(found.half_swings, motion.summary().half_swings, "{point:?}");
        let end = motion.summary().end;
        for (a, b) in [(found.end.time, end.time), (found.end.theta, end.theta)] {
            assert!(
                (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                "{point:?}: {a} {b}"
            );
        }
        if Class::of(&found) == Class::Rests {
            assert!(h * libm::sin(found.end.theta).abs() <= chi, "{point:?}");
            assert_eq!(found.outcome, OutcomeKind::Rests);
            rest[number / 7] += 1;
        }
        if chi >= h {
            assert_eq!((found.end.time, found.half_swings), (0.0, 0), "{point:?}");
            assert_eq!(found.end.theta, point.start.theta, "{point:?}");
        }
    }
    assert_eq!((rest[0], rest[3]), (0, 7));
    assert!(rest[1] > 0 && rest[2] > 0, "{rest:?}");
}

#[test]
fn points_are_numbered_row_by_row() {
    let grid = map(3);
    let starts: Vec<(f64, f64)> = grid
        .points(0..9)
        .map(|point| {
            (
                point.start.theta / std::f64::consts::PI,
                point.start.theta_rate,
            )
        })
        .collect();
    assert_eq!(
        starts[..4],
        [(-1.0, -4.0), (-1.0, 0.0), (-1.0, 4.0), (0.0, -4.0)]
    );
    assert_eq!(starts[8], (1.0, 4.0));
}

#[test]
fn equal_factors_lead_from_end_to_end() {
    let axis =
        Axis::new(Quantity::MuS, 1e-3, 10.0, 9).and_then(|axis| axis.with_spacing(Spacing::Log));
    let axis = axis.expect("an axis");
    let values: Vec<f64> = axis.values().collect();
    assert_eq!((values[0], values[8]), (1e-3, 10.0));
    for pair in values.windows(2) {
        assert!(
            (pair[1] / pair[0] - libm::sqrt(10.0)).abs() < 1e-13,
            "{values:?}"
        );
    }
    for (i, value) in values.into_iter().enumerate() {
        assert!((axis.fraction(value) - i as f64 / 8.0).abs() < 1e-14);
    }
    for (from, to) in [(0.0, 1.0), (-1.0, 1.0), (1.0, 0.0)] {
        let axis = Axis::new(Quantity::Theta, from, to, 3)
            .and_then(|axis| axis.with_spacing(Spacing::Log));
        assert!(matches!(axis, Err(AxisError::NoFactor { .. })), "{axis:?}");
    }
    let negative =
        Axis::new(Quantity::Theta, -1.0, -4.0, 3).and_then(|axis| axis.with_spacing(Spacing::Log));
    assert_eq!(negative.expect("an axis").value(1), -2.0);
}

#[test]
fn axes_without_meaning_are_refused() {
    let axis = |from, to, count| Axis::new(Quantity::Offset, from, to, count);
    let message = |result: Result<Axis, AxisError>| result.unwrap_err().to_string();
    assert_eq!(
        message(axis(0.0, 1.0, 0)),
        "axis offset: 0 points; at least 1 is needed"
    );
    assert_eq!(
        message(axis(0.0, f64::NAN, 3)),
        "axis offset: NaN is not a finite number"
    );
    assert_eq!(
        message(axis(f64::INFINITY, 1.0, 3)),
        "axis offset: inf is not a finite number"
    );
    assert_eq!(
        message(axis(-1e308, 1e308, 3)),
        "axis offset: inf is not a finite number"
    );
    assert_eq!(
        message(axis(0.0, 1.0, 1)),
        "axis offset: 1 point cannot include both ends, 0 and 1"
    );
    assert_eq!(
        message(axis(1.0, 1.0, 2)),
        "axis offset: 2 points from 1 to 1 are all the same"
    );
    assert_eq!(
        axis(0.5, 0.5, 1).unwrap().values().collect::<Vec<_>>(),
        [0.5]
    );
    for quantity in Quantity::ALL {
        let axis = Axis::new(quantity, 0.0, 1.0, 2);
        assert_eq!(
            axis.is_ok(),
            Quantity::AXES.contains(&quantity),
            "{quantity}"
        );
    }
    let message = message(Axis::new(Quantity::X, 0.0, 1.0, 2));
    assert!(
        message.starts_with("a sweep cannot vary x; axes are theta, theta_rate"),
        "{message}"
    );
}

#[test]
fn grids_without_meaning_are_refused_and_say_why() {
    let axis = |quantity, from, to| Axis::new(quantity, from, to, 3).unwrap();
    let message = |base, axes| Grid::new(base, axes).unwrap_err().to_string();
    let base = figure_2();
    assert_eq!(message(base, vec![]), "a grid needs at least one axis");
    let theta = axis(Quantity::Theta, 0.0, 1.0);
    assert_eq!(
        message(base, vec![theta, theta]),
        "axis theta is given twice"
    );
    assert_eq!(
        message(base, vec![axis(Quantity::Offset, 0.5, 1.5)]),
        "axis offset: at 1.5: offset = 1.5 must not exceed 1"
    );
    // Both ends are fine with some μs, but not with the one that is fixed; the first value above it
    // is named.
    assert_eq!(
        message(base, vec![axis(Quantity::MuK, 0.4, 0.8)]),
        "axis mu_k: at 0.6000000000000001: mu_k = 0.6000000000000001 must not exceed mu_s = 0.5"
    );
    assert_eq!(
        message(base, vec![axis(Quantity::MuS, 0.3, 0.5)]),
        "axis mu_s: at 0.3: mu_k = 0.4 must not exceed mu_s = 0.3"
    );
    let mut point_mass = base;
    (point_mass.hoop.inertia, point_mass.hoop.mass_ratio) = (0.0, 0.0);
    assert!(
        message(point_mass, vec![axis(Quantity::Offset, 0.0, 1.0)])
            .starts_with("axis offset: at 0: offset = 0"),
    );
    let mut nan = base;
    nan.start.slip = f64::NAN;
    assert_eq!(
        message(nan, vec![theta]),
        "slip = NaN sqrt(g R) must be a finite number"
    );
    nan = base;
    nan.start.x = f64::INFINITY;
    assert_eq!(
        message(nan, vec![theta]),
        "x = inf R must be a finite number"
    );
    let long = |quantity| Axis::new(quantity, 0.0, 1.0, usize::MAX / 2).unwrap();
    assert_eq!(
        message(base, vec![long(Quantity::Theta), long(Quantity::Slip)]),
        "the grid has 85070591730234615847396907784232501249 points; at most 9223372036854775807 can be counted"
    );
    // An axis takes the place of a fixed value, however wrong.
    nan = base;
    nan.start.theta = f64::NAN;
    assert!(Grid::new(nan, vec![theta]).is_ok());
}

#[test]
fn the_first_refusal_in_order_is_told_whatever_the_threads() {
    let mut points: Vec<Setup> = map(40).points(0..1600).collect();
    for bad in [1500, 900, 901] {
        points[bad].start.slip = 1e7 + bad as f64;
    }
    points[950].hoop.offset = 2.0;
    for threads in [1, 4] {
        let error = workers(threads)
            .compute(points.iter().copied(), Limits::until(1.0))
            .unwrap_err();
        assert!(error.to_string().contains("10000900"), "{error}");
    }
}

#[test]
fn a_limit_before_the_start_is_refused() {
    let error = workers(1)
        .compute([figure_2()], Limits::until(-1.0))
        .unwrap_err();
    assert!(error.to_string().starts_with("until = -1"), "{error}");
}

#[test]
fn a_slice_of_starts_can_be_computed() {
    let starts = [
        Start::at(std::f64::consts::FRAC_PI_2, 2.0),
        Start::at(0.0, 4.0),
    ];
    let points = starts.map(|start| Setup::new(figure_2().hoop, start));
    let columns = workers(1).compute(points, Limits::default()).unwrap();
    let sequences: Vec<String> = columns
        .summaries()
        .map(|summary| summary.sequence.to_string())
        .collect();
    assert_eq!(sequences, ["-R+F", "F"]);
    // Figure 3: the lift-off of the paper's motion, to 40 digits.
    assert!((reals(&columns, SummaryColumn::LiftOffTime)[0] - 1.518_670_213_819_437).abs() < 1e-13);
    assert!(
        (reals(&columns, SummaryColumn::FirstSlipTime)[0] - 0.973_223_074_772_405_4).abs() < 1e-13
    );
    assert!(
        workers(1)
            .compute([], Limits::default())
            .unwrap()
            .is_empty()
    );
}

fn any_grid() -> impl Strategy<Value = (Grid, usize)> {
    let counts = prop::sample::subsequence(Quantity::AXES.to_vec(), 1..=4)
        .prop_shuffle()
        .prop_flat_map(|quantities| {
            let len = quantities.len();
            (
                Just(quantities),
                prop::collection::vec(1_usize..7, len),
                1_usize..80,
            )
        });
    counts.prop_map(|(quantities, counts, chunk)| {
        let hoop = HoopParameters::thin(1.0)
            .with_offset(0.5)
            .with_friction(0.9, 0.1);
        let axes = quantities
            .into_iter()
            .zip(counts)
            .map(|(quantity, count)| {
                let (from, to) = match quantity {
                    Quantity::MuK => (0.0, 0.3),
                    _ => (0.4, 0.7),
                };
                Axis::new(quantity, from, if count == 1 { from } else { to }, count).unwrap()
            })
            .collect();
        (
            Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), axes).unwrap(),
            chunk,
        )
    })
}

proptest! {
    #[test]
    fn chunks_cover_a_grid_once((grid, size) in any_grid()) {
        let chunks = Chunks::new(&grid, size);
        let mut seen = std::collections::HashSet::new();
        for number in 0..chunks.count() {
            let chunk = chunks.chunk(number);
            prop_assert!(!chunk.is_empty() && chunk.len() <= size);
            prop_assert_eq!(chunk.points(&grid).count(), chunk.len());
            for (indices, point) in chunk.indices().zip(chunk.points(&grid)) {
                prop_assert_eq!(point, grid.point_at(&indices));
                prop_assert!(indices.iter().zip(grid.shape()).all(|(&i, count)| i < count));
                prop_assert!(seen.insert(indices));
            }
        }
        prop_assert_eq!(seen.len() as u64, grid.len());
    }
}
