//! Hatches as lines: every file draws them alike.

use crate::item::{STEPS, Step};

/// Distance and width of the lines, which rise to the right, in pixels.
const APART: f64 = 6.0 * core::f64::consts::SQRT_2;
pub(crate) const WIDTH: f64 = 0.8;

/// The parts of the lines within the area that closed lines bound together.
pub(crate) fn lines(outlines: &[Vec<Step>]) -> Vec<Vec<Step>> {
    // Along a line the sum of the coordinates is constant.
    let across = |Step { x, y }: Step| f64::from(x + y);
    let edges: Vec<[Step; 2]> = outlines
        .iter()
        .flat_map(|line| {
            line.iter()
                .zip(line.iter().cycle().skip(1))
                .map(|(a, b)| [*a, *b])
        })
        .collect();
    let sums = || edges.iter().map(|[from, _]| across(*from));
    let step = APART * STEPS;
    let (first, last) = (
        sums().fold(f64::INFINITY, f64::min),
        sums().fold(f64::NEG_INFINITY, f64::max),
    );
    let (first, last) = (
        libm::ceil(first / step - 0.5),
        libm::floor(last / step - 0.5),
    );
    let count = if last >= first {
        (last - first) as u32 + 1
    } else {
        0
    };
    (0..count)
        .flat_map(|i| {
            let sum = (first + f64::from(i) + 0.5) * step;
            let mut crossings: Vec<(f64, i32)> = edges
                .iter()
                .filter(|[a, b]| (across(*a) <= sum) != (across(*b) <= sum))
                .map(|[a, b]| {
                    let share = (sum - across(*a)) / (across(*b) - across(*a));
                    let x = f64::from(a.x) + share * f64::from(b.x - a.x);
                    (x, if across(*a) <= sum { 1 } else { -1 })
                })
                .collect();
            crossings.sort_by(|(a, _), (b, _)| a.total_cmp(b));
            let place = move |x: f64| Step::new(libm::round(x) as i32, libm::round(sum - x) as i32);
            let mut turns = 0;
            let parts = crossings.windows(2).filter_map(move |pair| {
                turns += pair[0].1;
                (turns != 0).then(|| vec![place(pair[0].0), place(pair[1].0)])
            });
            parts.filter(|part| part[0] != part[1]).collect::<Vec<_>>()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(side: i32) -> Vec<Step> {
        let half = side / 2;
        let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
        corners.map(|(x, y)| Step::new(x, y)).to_vec()
    }

    #[test]
    fn a_hatch_covers_the_area_and_leaves_its_hole() {
        let length = |lines: &[Vec<Step>]| {
            let of = |line: &Vec<Step>| {
                let [a, b] = [line[0], line[1]];
                libm::hypot(f64::from(b.x - a.x), f64::from(b.y - a.y))
            };
            lines.iter().map(of).sum::<f64>()
        };
        // Lines that are 6 pixels apart: their length is the area over that, up to the lines at the
        // corners.
        let outer = square(12_000);
        let whole = length(&lines(std::slice::from_ref(&outer)));
        assert!(
            (whole / (12_000.0 * 12_000.0 / 120.0) - 1.0).abs() < 0.02,
            "{whole}"
        );
        let hole: Vec<Step> = square(6_000).into_iter().rev().collect();
        let holed = length(&lines(&[outer, hole.clone()]));
        assert!((holed / whole - 0.75).abs() < 0.02, "{holed}");
        assert!(
            lines(&[hole])
                .iter()
                .flatten()
                .all(|it| it.x.abs() <= 3_000 && it.y.abs() <= 3_000)
        );
    }
}
