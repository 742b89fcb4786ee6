//! Curves as points: dense where they bend, cut where they leave the window, every point on the curve itself.

/// The part of the plane that a panel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    pub(crate) x: [f64; 2],
    pub(crate) y: [f64; 2],
}

type Point = [f64; 2];
type Curve<'a> = &'a dyn Fn(f64) -> Option<Point>;

/// Largest distance of a chord from its curve, in parts of the window.
const FLAT: f64 = 1.5e-4;
/// How often an interval is halved at most.
const DEPTH: u32 = 12;

impl Window {
    fn holds(&self, [x, y]: Point) -> bool {
        (self.x[0]..=self.x[1]).contains(&x) && (self.y[0]..=self.y[1]).contains(&y)
    }

    /// The pieces of a curve in the window, from samples in `cells` intervals of its parameter. A piece that lies
    /// between two samples is not seen.
    pub(crate) fn pieces(&self, [from, to]: [f64; 2], cells: u32, curve: Curve<'_>) -> Vec<Vec<Point>> {
        let seen = |s: f64| curve(s).filter(|point| self.holds(*point));
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        let mut open = false;
        let mut last = from;
        for i in 0..=cells {
            let s = if i == cells { to } else { from + (to - from) * f64::from(i) / f64::from(cells) };
            let here = seen(s);
            if i > 0 {
                match (seen(last), here) {
                    (Some(p), Some(q)) => {
                        self.refine(&mut pieces, &mut open, curve, [last, s], [p, q]);
                    }
                    (Some(p), None) => {
                        let (edge, q) = border(last, s, p, &seen);
                        self.refine(&mut pieces, &mut open, curve, [last, edge], [p, q]);
                        open = false;
                    }
                    (None, Some(q)) => {
                        let (edge, p) = border(s, last, q, &seen);
                        self.refine(&mut pieces, &mut open, curve, [edge, s], [p, q]);
                    }
                    (None, None) => {}
                }
            }
            last = s;
        }
        pieces.iter().map(|piece| self.thinned(piece)).collect()
    }

    /// The same piece without the points that lie on the chords between the others.
    fn thinned(&self, piece: &[Point]) -> Vec<Point> {
        let mut kept: Vec<Point> = piece.first().copied().into_iter().collect();
        let mut from = 0;
        for to in 2..piece.len() {
            if (from + 1..to).any(|i| self.sagitta(piece[from], piece[i], piece[to]) > FLAT) {
                from = to - 1;
                kept.push(piece[from]);
            }
        }
        kept.extend(piece.get(1..).and_then(<[Point]>::last));
        kept
    }

    fn refine(
        &self,
        pieces: &mut Vec<Vec<Point>>,
        open: &mut bool,
        curve: Curve<'_>,
        ends: [f64; 2],
        points: [Point; 2],
    ) {
        if !*open {
            pieces.push(vec![points[0]]);
            *open = true;
        }
        if let Some(piece) = pieces.last_mut() {
            self.halve(piece, curve, ends, points, DEPTH);
        }
    }

    fn halve(
        &self,
        piece: &mut Vec<Point>,
        curve: Curve<'_>,
        [a, b]: [f64; 2],
        [p, q]: [Point; 2],
        depth: u32,
    ) {
        let middle = 0.5 * (a + b);
        match curve(middle).filter(|point| self.holds(*point)) {
            Some(m) if depth > 0 && self.sagitta(p, m, q) > FLAT => {
                self.halve(piece, curve, [a, middle], [p, m], depth - 1);
                self.halve(piece, curve, [middle, b], [m, q], depth - 1);
            }
            _ => piece.push(q),
        }
    }

    /// Distance of a point from a chord, in parts of the window.
    fn sagitta(&self, p: Point, m: Point, q: Point) -> f64 {
        let scale = |d: f64, side: [f64; 2]| d / (side[1] - side[0]);
        let (ax, ay) = (scale(q[0] - p[0], self.x), scale(q[1] - p[1], self.y));
        let (bx, by) = (scale(m[0] - p[0], self.x), scale(m[1] - p[1], self.y));
        let length = (ax * ax + ay * ay).sqrt();
        if length == 0.0 { (bx * bx + by * by).sqrt() } else { (ax * by - ay * bx).abs() / length }
    }
}

/// The last visible place between a visible one and one that is not.
fn border(
    mut seen_at: f64,
    mut unseen_at: f64,
    mut point: Point,
    seen: &dyn Fn(f64) -> Option<Point>,
) -> (f64, Point) {
    loop {
        let middle = 0.5 * (seen_at + unseen_at);
        if middle == seen_at || middle == unseen_at {
            return (seen_at, point);
        }
        match seen(middle) {
            Some(there) => (seen_at, point) = (middle, there),
            None => unseen_at = middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { x: [-2.0, 2.0], y: [-1.0, 1.0] };

    #[test]
    fn a_curve_is_cut_where_it_leaves() {
        let pieces = WINDOW.pieces([-2.0, 2.0], 100, &|s| Some([s, s * s]));
        let [piece] = &pieces[..] else { panic!("{pieces:?}") };
        assert_eq!((piece[0], piece[piece.len() - 1]), ([-1.0, 1.0], [1.0, 1.0]));
        assert!(piece.iter().all(|[x, y]| *y == x * x));
    }

    #[test]
    fn chords_are_close() {
        let pieces = WINDOW.pieces([0.0, core::f64::consts::TAU], 40, &|s| {
            let (sin, cos) = libm::sincos(s);
            Some([cos, sin])
        });
        let [piece] = &pieces[..] else { panic!("{pieces:?}") };
        for pair in piece.windows(2) {
            let (x, y) = (0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1]));
            assert!((x * x + y * y).sqrt() > 1.0 - 2e-3);
        }
    }
}
