//! A map as pixels: numbers on a scale, or what no boundaries have been followed for.

use littlewood::tables::Class;
use littlewood_draw::Image;
use littlewood_style::{Ink, Rgb, Theme, of_class, of_rank};

use super::cells::{Cell, class_of};
use super::map::Picture;
use super::names::is_flipped;
use super::scale::Scale;
use crate::regions::{MIXED, Place, Regions};

/// How far off, in cells, one of the region of a pixel is looked for.
const NEAR: usize = 2;

impl Picture {
    /// The map in so many pixels to the right and upwards: each has the colour of the nearest cell
    /// in its region.
    pub(super) fn image(&self, width: usize, height: usize, scale: Option<&Scale>) -> Image {
        let size = [width, height];
        let regions = keys_of_pixels(&self.regions, width, height);
        // What no boundaries have been followed for has no regions.
        let keys = (!self.shade.is_on_a_scale()).then(|| self.lattice().keys);
        let flipped = [0, 1].map(|k| is_flipped(&self.grid.axes()[k]));
        let from_the_first = |pixel: usize, k: usize| {
            if flipped[k] {
                size[k] - 1 - pixel
            } else {
                pixel
            }
        };
        let places = |k: usize| {
            (0..size[k])
                .map(move |i| (i as f64 + 0.5) / size[k] as f64)
                .collect::<Vec<f64>>()
        };
        let (across, upwards) = (places(0), places(1));
        let mut pixels = Vec::with_capacity(3 * width * height);
        for y in (0..height).rev().map(|y| from_the_first(y, 1)) {
            for x in (0..width).map(|x| from_the_first(x, 0)) {
                let at = self.cell_near([across[x], upwards[y]], regions[y * width + x]);
                let colour = match &keys {
                    Some(keys) => self.colour_of(keys[at]),
                    None => self.colour(self.cells[at], scale),
                };
                pixels.extend(colour.0);
            }
        }
        Image { size, pixels }
    }

    /// The number of the nearest cell, of a region if there is one.
    fn cell_near(&self, place: Place, region: Option<u64>) -> usize {
        let [nx, ny] = self.counts;
        let exact = [0, 1].map(|k| place[k] * (self.counts[k] - 1) as f64);
        let [i, j] = exact.map(|at| libm::round(at) as usize);
        let nearest = j * nx + i;
        let own = self.key_of(self.cells[nearest].key);
        let Some(key) = region.filter(|key| ![own, MIXED].contains(key)) else {
            return nearest;
        };
        let around = |middle: usize, count: usize| {
            middle.saturating_sub(NEAR)..(middle + NEAR + 1).min(count)
        };
        let away = |(i, j): (usize, usize)| libm::hypot(i as f64 - exact[0], j as f64 - exact[1]);
        around(j, ny)
            .flat_map(|j| around(i, nx).map(move |i| (i, j)))
            .filter(|&(i, j)| self.key_of(self.cells[j * nx + i].key) == key)
            .min_by(|a, b| away(*a).total_cmp(&away(*b)))
            .map_or(nearest, |(i, j)| j * nx + i)
    }

    /// The colour of what a region has in common.
    pub(super) fn colour_of(&self, key: u64) -> Rgb {
        if key == MIXED {
            return Ink::Mixed.colour(Theme::Light);
        }
        let (rank, is_mirrored) = self.rank(key);
        class_of(key).map_or_else(
            || of_rank(rank, is_mirrored, Theme::Light),
            |class| of_class(class, Theme::Light),
        )
    }

    /// The colour of a number, if there is a scale.
    fn colour(&self, cell: Cell, scale: Option<&Scale>) -> Rgb {
        if let Some(Class::NotComputed | Class::Invalid) = cell.class() {
            return self.colour_of(cell.key);
        }
        scale.map_or_else(
            || Ink::NoValue.colour(Theme::Light),
            |scale| scale.colour(cell.number),
        )
    }
}

/// The keys of the regions in which the middles of pixels lie, row by row, the lowest first; none
/// where there is no region.
fn keys_of_pixels(found: &Regions, width: usize, height: usize) -> Vec<Option<u64>> {
    let mut keys = vec![None; width * height];
    // The first pixel whose middle is not before a fraction of the way.
    let first = |at: f64, count: usize| {
        libm::ceil(at * count as f64 - 0.5).clamp(0.0, count as f64) as usize
    };
    for region in &found.regions {
        let mut rows: Vec<Vec<f64>> = vec![Vec::new(); height];
        let edges = region
            .outlines
            .iter()
            .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
        for (a, b) in edges {
            let (low, high) = if a[1] < b[1] { (a, b) } else { (b, a) };
            let (from, to) = (first(low[1], height), first(high[1], height));
            for (row, crossings) in rows.iter_mut().enumerate().take(to).skip(from) {
                let y = (row as f64 + 0.5) / height as f64;
                crossings.push(low[0] + (high[0] - low[0]) * (y - low[1]) / (high[1] - low[1]));
            }
        }
        for (row, crossings) in rows.iter_mut().enumerate() {
            crossings.sort_by(f64::total_cmp);
            for inside in crossings.chunks_exact(2) {
                let columns = first(inside[0], width)..first(inside[1], width);
                keys[row * width..][columns].fill(Some(region.key));
            }
        }
    }
    keys
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::regions::Region;

    #[test]
    fn pixels_are_those_whose_middles_lie_in_a_region() {
        let square = |from: f64, to: f64| vec![[from, from], [to, from], [to, to], [from, to]];
        let hole = square(0.4, 0.6).into_iter().rev().collect();
        let ring = Region {
            key: 7,
            outlines: vec![square(0.2, 0.8), hole],
            area: 0.32,
        };
        let keys = keys_of_pixels(
            &Regions {
                regions: vec![ring],
                boundaries: Vec::new(),
            },
            10,
            10,
        );
        for (i, key) in keys.iter().enumerate() {
            let inside =
                |from: usize, to: usize| [i % 10, i / 10].iter().all(|at| (from..to).contains(at));
            assert_eq!(key.is_some(), inside(2, 8) && !inside(4, 6), "{i}");
        }
    }
}
