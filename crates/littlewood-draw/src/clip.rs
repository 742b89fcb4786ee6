//! Which parts of lines and polygons lie within a rectangle.

type Place = [f64; 2];
/// Left upper and right lower corner.
pub(crate) type Bounds = [Place; 2];

/// The pieces of a line within bounds; it is interrupted where it is not finite.
pub(crate) fn line(points: &[Place], bounds: Bounds) -> Vec<Vec<Place>> {
    let mut runs: Vec<Vec<Place>> = Vec::new();
    let mut end = None;
    for pair in points.windows(2) {
        let Some([a, b]) = segment(pair[0], pair[1], bounds) else {
            end = None;
            continue;
        };
        match runs.last_mut() {
            Some(run) if end == Some(a) => run.push(b),
            _ => runs.push(vec![a, b]),
        }
        end = Some(b);
    }
    runs
}

fn segment(a: Place, b: Place, [low, high]: Bounds) -> Option<[Place; 2]> {
    if a.iter().chain(&b).any(|value| !value.is_finite()) {
        return None;
    }
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let step = b[k] - a[k];
        for (distance, slope) in [(a[k] - low[k], -step), (high[k] - a[k], step)] {
            if slope == 0.0 {
                if distance < 0.0 {
                    return None;
                }
            } else if slope > 0.0 {
                to = to.min(distance / slope);
            } else {
                from = from.max(distance / slope);
            }
        }
    }
    let at = |t: f64| match t {
        0.0 => a,
        1.0 => b,
        _ => [0, 1].map(|k| a[k] + t * (b[k] - a[k])),
    };
    (from <= to).then(|| [at(from), at(to)])
}

/// The part of a polygon within bounds, side by side of them; where it is cut in two, they hang
/// together along a side.
pub(crate) fn polygon(points: &[Place], [low, high]: Bounds) -> Vec<Place> {
    let mut kept = points.to_vec();
    for (k, sign, bound) in [
        (0, 1.0, low[0]),
        (0, -1.0, high[0]),
        (1, 1.0, low[1]),
        (1, -1.0, high[1]),
    ] {
        let over = |place: Place| sign * (place[k] - bound);
        let corners = core::mem::take(&mut kept);
        for (i, &to) in corners.iter().enumerate() {
            let from = corners[(i + corners.len() - 1) % corners.len()];
            let (before, after) = (over(from), over(to));
            if (before < 0.0) != (after < 0.0) {
                let share = before / (before - after);
                let mut crossing = [0, 1].map(|j| from[j] + share * (to[j] - from[j]));
                crossing[k] = bound;
                kept.push(crossing);
            }
            if after >= 0.0 {
                kept.push(to);
            }
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: Bounds = [[0.0, 0.0], [1.0, 1.0]];

    #[test]
    fn a_line_is_cut_at_the_sides() {
        // Through the square, out at the right, in again at the top.
        let points = [[-1.0, 0.5], [2.0, 0.5], [2.0, 3.0], [0.5, 3.0], [0.5, 0.5]];
        let runs = line(&points, SQUARE);
        assert_eq!(
            runs,
            [vec![[0.0, 0.5], [1.0, 0.5]], vec![[0.5, 1.0], [0.5, 0.5]]]
        );
        assert!(line(&[[2.0, 0.0], [2.0, f64::NAN], [0.5, 0.5]], SQUARE).is_empty());
    }

    #[test]
    fn a_polygon_is_cut_at_the_sides() {
        let area = |points: &[Place]| {
            let sum = |i: usize| {
                let (a, b) = (points[i], points[(i + 1) % points.len()]);
                0.5 * (a[0] * b[1] - a[1] * b[0])
            };
            (0..points.len()).map(sum).sum::<f64>()
        };
        // A diamond about a corner: a quarter of it lies within. One about the centre loses its
        // four tips.
        let diamond = |[x, y]: Place, r: f64| [[x - r, y], [x, y - r], [x + r, y], [x, y + r]];
        assert_eq!(area(&polygon(&diamond([0.0, 0.0], 0.5), SQUARE)), 0.125);
        assert_eq!(
            area(&polygon(&diamond([0.5, 0.5], 0.75), SQUARE)),
            1.125 - 4.0 * 0.0625
        );
        assert!(polygon(&diamond([3.0, 3.0], 0.5), SQUARE).is_empty());
    }
}
