//! Pictures: the right colour at the right place.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests stand outside of test functions")]

use std::f64::consts::PI;

use crate::support::{figure_2, map, workers};
use littlewood::Limits;
use littlewood::tables::{Class, Quantity, SummaryColumn};
use littlewood_style::{Theme, of_class};
use littlewood_sweep::{Axis, Grid, Options, Picture, PictureError, PictureSize, Shade, SweepError};

fn draw(grid: &Grid, shade: Shade, size: PictureSize) -> (Picture, Vec<u8>) {
    let picture =
        Picture::of_grid(grid, Limits::until(50.0), shade, size, &workers(2), &Options::default()).unwrap();
    let png = picture.png().unwrap();
    (picture, png)
}

fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels)
}

#[test]
fn the_map_of_figure_2_has_its_regions_where_they_are() {
    let size = PictureSize { width: 600, height: 400 };
    let (picture, png) = draw(&map(100), Shade::Class, size);
    let total: u64 = Class::ALL.iter().map(|&class| picture.count(class)).sum();
    assert_eq!((total, picture.count(Class::NotComputed)), (10_000, 0));
    let (width, height, pixels) = decode(&png);
    assert_eq!((width, height), (600, 400));
    // Colours along the line θ = 0, downwards in the picture: from θ′ = 4 (leaves at once) through θ′ = 0 (rolls for
    // ever) to θ′ = −4, which mirrors the upper half.
    let x = 243;
    let column: Vec<[u8; 3]> =
        (0..400).map(|y| core::array::from_fn(|k| pixels[(y * 600 + x) * 3 + k])).collect();
    let [dark, pale] =
        [Class::LeavesAtOnce, Class::RollsForever].map(|class| of_class(class, Theme::Light).0);
    let first = column.iter().position(|colour| *colour == dark).unwrap();
    let last = column.iter().rposition(|colour| *colour == dark).unwrap();
    assert!(last - first > 250, "{first} {last}");
    assert_eq!(column[usize::midpoint(first, last)], pale);
    // On it the body rolls for ever while θ′² < 1.2², roughly, of the 4: a bit less than a third.
    let rolling = column[first..last].iter().filter(|colour| **colour == pale).count() as f64;
    assert!((0.25..0.33).contains(&(rolling / (last - first) as f64)), "{rolling}");
}

#[test]
fn a_picture_is_the_same_every_time_and_a_finer_grid_is_thinned() {
    let size = PictureSize { width: 400, height: 300 };
    let (_, first) = draw(&map(30), Shade::Column(SummaryColumn::JumpHeight), size);
    let (_, second) = draw(&map(30), Shade::Column(SummaryColumn::JumpHeight), size);
    assert!(first == second);
    let axes = vec![
        Axis::new(Quantity::Theta, -PI, PI, 2_000).unwrap(),
        Axis::new(Quantity::ThetaRate, 4.0, -4.0, 3).unwrap(),
    ];
    let (picture, _) = draw(&Grid::new(figure_2(), axes).unwrap(), Shade::Class, size);
    assert_eq!(Class::ALL.iter().map(|&class| picture.count(class)).sum::<u64>(), 6_000);
}

#[test]
fn every_shade_can_be_drawn_also_where_nothing_has_a_value() {
    let axes = vec![
        Axis::new(Quantity::MassRatio, 0.5, 0.5, 1).unwrap(),
        Axis::new(Quantity::ThetaRate, -0.1, 0.1, 4).unwrap(),
    ];
    let grid = Grid::new(figure_2(), axes).unwrap();
    for shade in Shade::all() {
        draw(&grid, shade, PictureSize { width: 300, height: 300 });
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
            Err(PictureError::NoNumber { column: refused }) => assert!(!is_number && refused == column),
            Err(error) => panic!("{error}"),
        }
    }
    for (width, height) in [(0, 500), (500, 299), (100_000, 500)] {
        let error = Picture::of_grid(
            &map(3),
            Limits::default(),
            Shade::Class,
            PictureSize { width, height },
            &workers(1),
            &Options::default(),
        );
        assert!(matches!(error, Err(SweepError::Picture(PictureError::Size { .. }))));
    }
}
