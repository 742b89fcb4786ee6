//! The regions of a plane: areas whose places have one key each, bounded by curves.
//!
//! Where neighbours on a lattice differ, the boundary between them is followed through the cells of a finer lattice, from side
//! to side. Where it crosses a side is found by bisection. A cell in which more than one boundary runs is halved, so that
//! places at which three regions meet are found too.

mod cell;
mod chain;
mod follow;
mod grid;
mod line;

use follow::{Fine, Followed};
pub use line::Band;

/// A place in the unit square: fractions of the way to the right and upwards.
pub type Place = [f64; 2];

/// What is asked for the keys of places, many at once.
pub type Ask<'a, E> = dyn FnMut(&[Place]) -> Result<Vec<u64>, E> + 'a;

/// A lattice on which the keys are known.
#[derive(Clone, Debug)]
pub struct Lattice {
    /// Places of its columns and of its rows, growing from 0 to 1.
    pub places: [Vec<f64>; 2],
    /// Row by row, the lowest first.
    pub keys: Vec<u64>,
}

/// How finely boundaries are followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// Cells to either side in each cell of the lattice, a power of two.
    pub parts: usize,
    /// How far apart the places are between which a boundary crosses a side.
    pub width: f64,
    /// Cells with a boundary at most: with more the parts are fewer. Where places next to each other differ everywhere there
    /// would be no end.
    pub most: usize,
    /// How often a cell is halved in which boundaries meet.
    pub halvings: u32,
    /// How far a curve may be from its chords.
    pub flat: f64,
}

impl Default for Detail {
    fn default() -> Self {
        Self { parts: 4, width: 1e-6, most: 24_000, halvings: 6, flat: 1.5e-4 }
    }
}

/// All places of a key.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The key.
    pub key: u64,
    /// Closed curves that have the region to their left: those around its parts counterclockwise, those around holes
    /// clockwise.
    pub outlines: Vec<Vec<Place>>,
    /// Area in parts of the plane.
    pub area: f64,
}

/// A curve between two regions, or two of their parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary {
    /// The keys on its left and on its right.
    pub sides: [u64; 2],
    /// Its points, each between two places that differ and are next to each other.
    pub points: Vec<Place>,
}

/// The regions of a plane and the boundaries between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Regions {
    /// By their keys.
    pub regions: Vec<Region>,
    /// In an order that depends on nothing but them; the border of the plane is not among them.
    pub boundaries: Vec<Boundary>,
}

impl Regions {
    /// Finds the regions; `ask` is asked for the keys of places, many at once.
    ///
    /// ```
    /// use littlewood_sweep::{Detail, Lattice, Regions};
    ///
    /// let inside = |[x, y]: [f64; 2]| u64::from((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) < 0.16);
    /// let lattice = Lattice::even([11, 11], |place| inside(place));
    /// let mut ask = |places: &[[f64; 2]]| Ok::<_, ()>(places.iter().map(|&place| inside(place)).collect());
    /// let found = Regions::find(&lattice, &Detail::default(), &mut ask)?;
    /// assert!((found.regions[1].area - 0.16 * std::f64::consts::PI).abs() < 1e-3);
    /// # Ok::<(), ()>(())
    /// ```
    ///
    /// # Errors
    /// What `ask` returns.
    pub fn find<E>(lattice: &Lattice, detail: &Detail, ask: &mut Ask<'_, E>) -> Result<Self, E> {
        let mut lattice = lattice.clone();
        let mut parts = detail.parts.max(1);
        let followed = loop {
            match Fine::new(&lattice, parts).follow(detail, ask)? {
                Some(followed) => break followed,
                None if parts > 1 => parts /= 2,
                None => lattice = lattice.coarser(),
            }
        };
        let Followed { mut nodes, cells, frame } = followed;
        let segments = cell::segments(cells, detail.halvings, &mut nodes, detail.width, ask)?;
        let (regions, boundaries) = chain::regions(nodes, &segments, &frame, detail.flat);
        Ok(Self { regions, boundaries })
    }
}

impl Lattice {
    /// Evenly spaced columns and rows, two at least of each, with the keys of their places.
    pub fn even(count: [usize; 2], key: impl Fn(Place) -> u64) -> Self {
        let places = count.map(|count| {
            let last = count.max(2) - 1;
            (0..=last).map(|i| i as f64 / last as f64).collect::<Vec<f64>>()
        });
        let keys = places[1].iter().flat_map(|&y| places[0].iter().map(move |&x| [x, y])).map(key).collect();
        Self { places, keys }
    }

    /// Cells to the right and upwards.
    fn cells(&self) -> [usize; 2] {
        [0, 1].map(|k| self.places[k].len() - 1)
    }

    /// Every other column and row.
    fn coarser(&self) -> Self {
        let kept: [Vec<usize>; 2] = self.cells().map(|last| {
            (0..=last).filter(|i| i % 2 == 0 && (*i == 0 || i + 1 != last) || *i == last).collect()
        });
        let columns = self.places[0].len();
        let keys = kept[1].iter().flat_map(|j| kept[0].iter().map(move |i| j * columns + i));
        let keys = keys.map(|place| self.keys[place]).collect();
        Self { places: [0, 1].map(|k| kept[k].iter().map(|&i| self.places[k][i]).collect()), keys }
    }
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use super::*;

    fn find(count: [usize; 2], detail: &Detail, key: impl Fn(Place) -> u64) -> Regions {
        let lattice = Lattice::even(count, &key);
        let mut ask =
            |places: &[Place]| Ok::<_, Infallible>(places.iter().map(|&place| key(place)).collect());
        Regions::find(&lattice, detail, &mut ask).expect("nothing fails")
    }

    /// How often outlines wind about a place.
    fn winding(outlines: &[Vec<Place>], [x, y]: Place) -> i32 {
        let edges = outlines.iter().flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
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
                    assert!((0..=1).contains(&times), "{} {place:?}: {times}", region.key);
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
        let found = find([12, 9], &Detail { parts: 16, ..Detail::default() }, key);
        // Chords are flat to a part of the plane.
        check(&found, key, 16);
        assert_eq!(found.regions[1].outlines.len(), 2);
        assert!((found.regions[0].area - 0.01 * core::f64::consts::PI).abs() < 1e-4);
        for boundary in &found.boundaries {
            let wanted = if boundary.sides.contains(&0) { 0.01 } else { 0.1 };
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
        let found = find([16, 16], &Detail::default(), key);
        check(&found, key, 0);
        assert_eq!(found.boundaries.len(), 3);
        for boundary in &found.boundaries {
            let ends = [boundary.points.first(), boundary.points.last()];
            let near = ends.into_iter().flatten().any(|[x, y]| {
                square([x - middle[0], y - middle[1]])
                    < (2.0 / 15.0 / 4.0 / 64.0_f64) * (2.0 / 15.0 / 4.0 / 64.0)
            });
            assert!(near, "{ends:?}");
            // Straight lines need no points between their ends.
            assert!(boundary.points.len() <= 4, "{}", boundary.points.len());
        }
    }

    #[test]
    fn a_boundary_is_followed_where_the_lattice_sees_it_no_more() {
        // A tongue that becomes narrower than a cell.
        let key = |[x, y]: Place| u64::from((y - 0.503).abs() < 0.12 * (0.93 - x));
        let found = find([11, 11], &Detail { parts: 8, ..Detail::default() }, key);
        check(&found, key, 0);
        let tip = found.regions[1].outlines[0].iter().map(|place| place[0]).fold(0.0, f64::max);
        assert!(tip > 0.87, "{tip}");
    }

    #[test]
    fn a_band_between_two_rows_of_the_lattice_has_both_its_boundaries() {
        let key = |[_, y]: Place| u64::from(y > 0.513) + u64::from(y > 0.567);
        check(&find([11, 11], &Detail::default(), key), key, 0);
    }

    #[test]
    fn regions_that_touch_at_a_place_are_told_apart() {
        let key = |[x, y]: Place| u64::from((x - 0.503) * (y - 0.497) > 0.0);
        let found = find([9, 9], &Detail::default(), key);
        check(&found, key, 0);
    }

    #[test]
    fn where_all_places_differ_the_work_is_bounded() {
        let asked = core::cell::Cell::new(0);
        let key = |[x, y]: Place| {
            asked.set(asked.get() + 1);
            let mixed = (x * 1e6) as u64 ^ ((y * 1e6) as u64).rotate_left(7);
            mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 62
        };
        let detail = Detail { most: 500, ..Detail::default() };
        let found = find([65, 65], &detail, key);
        assert!(asked.get() < 400_000, "{}", asked.get());
        let area: f64 = found.regions.iter().map(|region| region.area).sum();
        assert!((area - 1.0).abs() < 1e-12, "{area}");
    }

    #[test]
    fn one_key_is_the_whole_plane() {
        let found = find([5, 5], &Detail::default(), |_| 7);
        assert_eq!(
            found.regions,
            [Region {
                key: 7,
                outlines: vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]],
                area: 1.0,
            }]
        );
        assert!(found.boundaries.is_empty());
    }
}
