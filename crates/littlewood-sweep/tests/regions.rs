//! Regions of a plane and the boundaries between them.

use core::convert::Infallible;

use littlewood_sweep::{Lattice, MIXED, Place, Region, Regions};

/// How closely boundaries are located.
const WIDTH: f64 = 1e-6;

fn find(count: [usize; 2], key: impl Fn(Place) -> u64) -> Regions {
    let [columns, rows] = count;
    let lattice = Lattice::even(columns, rows, &key);
    let mut ask = |places: &[Place]| {
        Ok::<_, Infallible>(Some(places.iter().map(|&place| key(place)).collect()))
    };
    Regions::find(&lattice, WIDTH, &mut ask).expect("nothing fails")
}

/// How often outlines wind about a place.
fn winding(outlines: &[Vec<Place>], [x, y]: Place) -> i32 {
    let edges = outlines
        .iter()
        .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    edges
        .map(|(a, b)| {
            let left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            match (a[1] <= y, b[1] <= y) {
                (true, false) if left > 0.0 => 1,
                (false, true) if left < 0.0 => -1,
                _ => 0,
            }
        })
        .sum()
}

/// Each place lies in the region of its key, once, and in no other.
fn check(found: &Regions, key: impl Fn(Place) -> u64, allowed: usize) {
    let mut wrong = 0;
    for i in 0..70 {
        for j in 0..60 {
            let place = [(f64::from(i) + 0.437) / 70.0, (f64::from(j) + 0.381) / 60.0];
            let own = key(place);
            let around = |region: &Region| winding(&region.outlines, place);
            for region in &found.regions {
                let times = around(region);
                assert!(
                    (0..=1).contains(&times),
                    "{} {place:?}: {times}",
                    region.key
                );
                wrong += usize::from((times == 1) != (region.key == own));
            }
        }
    }
    assert!(wrong <= allowed, "{wrong}");
    let area: f64 = found.regions.iter().map(|region| region.area).sum();
    assert!((area - 1.0).abs() < 1e-12, "{area}");
}

fn square([x, y]: Place) -> f64 {
    x * x + y * y
}

#[test]
fn a_ring_has_a_hole_and_its_points_lie_on_the_circles() {
    let key = |[x, y]: Place| {
        let r = square([x - 0.5, y - 0.5]);
        u64::from(r > 0.01) + u64::from(r > 0.1)
    };
    let found = find([177, 129], key);
    // Chords are flat to a part of the plane.
    check(&found, key, 16);
    assert_eq!(found.regions[1].outlines.len(), 2);
    assert!((found.regions[0].area - 0.01 * core::f64::consts::PI).abs() < 1e-4);
    for boundary in &found.boundaries {
        let wanted = if boundary.sides.contains(&0) {
            0.01
        } else {
            0.1
        };
        for [x, y] in &boundary.points {
            // To a width along the side of a cell.
            let r = square([x - 0.5, y - 0.5]);
            assert!((r - wanted).abs() < 1.1e-6, "{r}");
        }
    }
}

#[test]
fn boundaries_meet_where_three_regions_do() {
    // Sectors about a place that no side of a cell goes through.
    let middle = [0.412_345, 0.567_89];
    let key = |[x, y]: Place| {
        let angle = libm::atan2(y - middle[1], x - middle[0]);
        u64::from(angle > -1.9) + u64::from(angle > 0.3)
    };
    let found = find([61, 61], key);
    check(&found, key, 2);
    assert_eq!(found.boundaries.len(), 3);
    for boundary in &found.boundaries {
        // In the middle of the cell.
        let ends = [boundary.points.first(), boundary.points.last()];
        let cell = 1.0 / 60.0;
        let near = ends
            .into_iter()
            .flatten()
            .any(|[x, y]| square([x - middle[0], y - middle[1]]) < 0.5 * cell * cell);
        assert!(near, "{ends:?}");
        // Straight lines need no points between their ends, but for where they bend to the middle.
        assert!(boundary.points.len() <= 5, "{}", boundary.points.len());
    }
}

#[test]
fn a_band_between_two_rows_of_the_lattice_has_both_its_boundaries() {
    let key = |[_, y]: Place| u64::from(y > 0.513) + u64::from(y > 0.567);
    check(&find([11, 11], key), key, 0);
    // One that is not level crosses cells from side to side.
    let key = |[x, y]: Place| u64::from(y - 0.4 * x > 0.213) + u64::from(y - 0.4 * x > 0.217);
    check(&find([11, 11], key), key, 0);
}

#[test]
fn regions_that_touch_at_a_place_are_told_apart() {
    let key = |[x, y]: Place| u64::from((x - 0.503) * (y - 0.497) > 0.0);
    // To the size of a cell.
    let found = find([80, 80], key);
    check(&found, key, 2);
}

#[test]
fn where_all_places_differ_the_work_is_bounded() {
    let asked = core::cell::Cell::new(0);
    let key = |[x, y]: Place| {
        asked.set(asked.get() + 1);
        let mixed = (x * 1e6) as u64 ^ ((y * 1e6) as u64).rotate_left(7);
        mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 62
    };
    let found = find([65, 65], key);
    // All places of the lattice, and fourteen halvings of each part of a side.
    assert!(
        asked.get() <= 65 * 65 + 14 * 3 * 2 * 64 * 65,
        "{}",
        asked.get()
    );
    let area: f64 = found.regions.iter().map(|region| region.area).sum();
    assert!((area - 1.0).abs() < 1e-12, "{area}");
}

#[test]
fn what_is_not_answered_is_drawn_from_what_is_known() {
    let key = |[x, y]: Place| u64::from(square([x - 0.5, y - 0.5]) < 0.1) + u64::from(x > 0.61);
    let lattice = Lattice::even(33, 33, key);
    let mut errors = Vec::new();
    for most in [0, 200, 400, 100_000] {
        let mut asked = 0;
        let mut ask = |places: &[Place]| {
            asked += places.len();
            let keys = || places.iter().map(|&place| key(place)).collect();
            Ok::<_, Infallible>((asked <= most).then(keys))
        };
        let found = Regions::find(&lattice, WIDTH, &mut ask).expect("nothing fails");
        let area: f64 = found.regions.iter().map(|region| region.area).sum();
        assert!((area - 1.0).abs() < 1e-12, "{most}: {area}");
        // The straight boundary, at the border.
        let border = |region: &Region| {
            let places = region.outlines.iter().flatten();
            places
                .filter(|[x, y]| *y == 0.0 && *x > 0.5)
                .map(|[x, _]| (x - 0.61).abs())
                .fold(1.0, f64::min)
        };
        errors.push(border(&found.regions[0]));
    }
    // At most half the side of a cell, and at last to a width.
    let half = 0.5 / 32.0;
    assert!(errors.iter().all(|error| *error <= half), "{errors:?}");
    assert!(errors[3] < WIDTH, "{errors:?}");
}

#[test]
fn one_key_is_the_whole_plane() {
    let found = find([5, 5], |_| 7);
    assert_eq!(
        found.regions,
        [Region {
            key: 7,
            outlines: vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]],
            area: 1.0
        }]
    );
    assert!(found.boundaries.is_empty());
}

/// Keys that alternate, or are strewn among others, have one key; boundaries and narrow bands have
/// their own.
#[test]
fn what_changes_from_place_to_place_is_mixed() {
    let hash = |x: f64, y: f64| {
        let bits = (x.to_bits() ^ y.to_bits().rotate_left(17)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (bits ^ (bits >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 40
    };
    let few = |[x, y]: Place| u64::from(hash(x, y) % 5 == 0);
    let half = |[x, y]: Place| u64::from(hash(x, y) % 2 == 0);
    // But for some places on the border, which have fewer neighbours.
    for noise in [&few as &dyn Fn(Place) -> u64, &half] {
        let mut lattice = Lattice::even(41, 31, noise);
        lattice.mix();
        let mixed = lattice.keys.iter().filter(|key| **key == MIXED).count();
        assert!(100 * mixed > 97 * lattice.keys.len(), "{mixed}");
    }
    // A circle, a diagonal band as narrow as two cells, and a corner of noise beside them.
    let clear = |[x, y]: Place| {
        let is_round = (x - 0.3) * (x - 0.3) + (y - 0.4) * (y - 0.4) < 0.04;
        u64::from(is_round) + 2 * u64::from((x - y - 0.2).abs() < 0.04)
    };
    let known = Lattice::even(61, 61, clear);
    let mut mixed = known.clone();
    mixed.mix();
    assert_eq!(mixed.keys, known.keys);
    let corner = |place: Place| {
        if place[0] > 0.7 && place[1] > 0.7 {
            half(place)
        } else {
            0
        }
    };
    let mut lattice = Lattice::even(61, 61, corner);
    lattice.mix();
    let mut ask =
        |places: &[Place]| Ok::<_, ()>(Some(places.iter().map(|it| corner(*it)).collect()));
    let found = Regions::find(&lattice, 1e-6, &mut ask).expect("places are answered");
    let area = |key: u64| {
        let of_key = found.regions.iter().find(|region| region.key == key);
        of_key.map_or(0.0, |region| region.area)
    };
    // To within the half side of the square by which noise is known, all around.
    assert!(
        (area(MIXED).sqrt() - 0.3).abs() < 3.5 / 60.0,
        "{}",
        area(MIXED)
    );
    assert!((area(MIXED) + area(0) - 1.0).abs() < 0.005);
}
