//! Maps in vectors: areas bounded by curves, and images where the colours are a scale.

use core::f64::consts::PI;

use crate::support::{outlines, winding};
use littlewood::tables::{Class, Quantity, Setup, SummaryColumn};
use littlewood::{HoopParameters, Limits, Start};
use littlewood_figures::{Figure, Mark};
use littlewood_style::{RANKS, Theme, of_rank};
use littlewood_sweep::{Axis, Grid, Options, Picture, PictureSize, Shade, Workers};

fn picture(theta: [f64; 2], shade: Shade) -> Picture {
    let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let theta = Axis::new(Quantity::Theta, theta[0], theta[1], 41).expect("an axis");
    let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 41).expect("an axis");
    let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), vec![theta, rate]).expect("a grid");
    let workers = Workers::new(None).expect("threads");
    let (size, options) = (
        PictureSize {
            width: 600,
            height: 400,
        },
        Options::default(),
    );
    let mut picture = Picture::of_grid(&grid, Limits::default(), shade, size, &workers, &options)
        .expect("a picture")
        .in_vectors();
    assert!(picture.follow(&workers, &options).expect("good points"));
    picture
}

fn figure(theta: [f64; 2], shade: Shade) -> Figure {
    picture(theta, shade).figure(None).expect("a figure")
}

#[test]
fn the_region_beyond_lift_off_is_bounded_by_its_curve() {
    let figure = figure([-PI, PI], Shade::Class);
    let region = figure
        .series(Class::LeavesAtOnce.name())
        .expect("the class is there");
    let mut on_it = 0;
    for row in region.rows() {
        let [x, y] = [row[0], row[1]];
        if [x, y].iter().all(|at| *at > 0.0 && *at < 1.0) {
            let (theta, rate) = (PI * (2.0 * x - 1.0), 4.0 * (2.0 * y - 1.0));
            assert!(
                (0.5 * libm::cos(theta) * rate * rate - 1.0).abs() < 1e-4,
                "({theta}, {rate})"
            );
            on_it += 1;
        }
    }
    assert!(on_it > 60, "{on_it}");
}

#[test]
fn an_axis_that_falls_makes_the_same_map() {
    let [up, down] = [[-PI, PI], [PI, -PI]].map(|theta| figure(theta, Shade::Class));
    for class in [
        Class::LeavesAtOnce,
        Class::LiftsOffLater,
        Class::RollsForever,
    ] {
        let [a, b] = [&up, &down].map(|figure| {
            outlines(
                figure.series(class.name()).expect("the class is there"),
                ["right", "up"],
            )
        });
        for i in 0..37 {
            for j in 0..31 {
                let place = [(f64::from(i) + 0.43) / 37.0, (f64::from(j) + 0.39) / 31.0];
                assert_eq!(
                    winding(&a, place).abs(),
                    winding(&b, place).abs(),
                    "{class} at {place:?}"
                );
            }
        }
    }
}

#[test]
fn files_are_small_and_well_formed() {
    for shade in [
        Shade::Class,
        Shade::Sequence,
        Shade::Column(SummaryColumn::LiftOffTime),
    ] {
        let figure = figure([-PI, PI], shade);
        let svg = figure.svg();
        let document = roxmltree::Document::parse(&svg).expect("well-formed XML");
        let images = document
            .descendants()
            .filter(|node| node.has_tag_name("image"))
            .count();
        // The map, and the bar of its scale.
        assert_eq!(
            images,
            if shade.is_on_a_scale() { 2 } else { 0 },
            "{shade:?}"
        );
        assert!(svg.len() < 1_000_000, "{shade:?}: {}", svg.len());
        let pdf = figure.pdf();
        assert!(
            pdf.starts_with(b"%PDF") && pdf.len() < 1_000_000,
            "{shade:?}"
        );
        let has_images = pdf.windows(14).any(|part| part == b"/Subtype /Imag");
        assert_eq!(has_images, shade.is_on_a_scale(), "{shade:?}");
    }
}

#[test]
fn a_sequence_and_its_mirror_image_have_one_hue_in_two_tints() {
    let figure = figure([-PI, PI], Shade::Sequence);
    let keys = figure.panels.iter().flat_map(|panel| &panel.keys);
    let keys: Vec<(&str, Mark)> = keys
        .filter_map(|key| Some((key.text.split_once(',')?.0, key.mark)))
        .collect();
    let tints: Vec<[Mark; 2]> = (0..RANKS)
        .map(|rank| {
            [false, true].map(|is_mirrored| Mark::Fill(of_rank(rank, is_mirrored, Theme::Light)))
        })
        .collect();
    let mut pairs = 0;
    for (text, mark) in &keys {
        let turned = |letter| match letter {
            '+' => '−',
            '−' => '+',
            other => other,
        };
        let mirrored: String = text.chars().map(turned).collect();
        let other = keys
            .iter()
            .find(|(other, _)| *other == mirrored && other != text);
        let Some((_, other)) = other else { continue };
        assert!(
            tints
                .iter()
                .any(|tint| tint.contains(mark) && tint.contains(other)),
            "{text}"
        );
        assert!(mark != other, "{text}");
        pairs += 1;
    }
    assert!(pairs >= 6, "{pairs}");
}
