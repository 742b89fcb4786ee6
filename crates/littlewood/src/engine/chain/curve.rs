//! The curves on which rolling slips, |F| = μs N, and coordinates on them.

use super::super::roll::{RollTable, SlipPiece, SlipPoint};

/// A slip on one of the curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) struct Point {
    /// Index of the part of a curve.
    pub(super) part: usize,
    /// Coordinate on it.
    pub(super) at: f64,
}

/// What the coordinate on a part is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coordinate {
    /// The angle, reduced to a turn.
    Angle,
    /// 1/K, where the level K of the orbits has a pole: the angles of fast slips hardly differ.
    InverseLevel,
}

/// A part of a curve.
#[derive(Clone, Debug)]
struct Part {
    side: usize,
    piece: SlipPiece,
    coordinate: Coordinate,
    /// Angles of its ends.
    angles: (f64, f64),
}

/// The curves of one body, in parts.
#[derive(Clone, Debug)]
pub(super) struct Curves {
    roll: RollTable,
    parts: Vec<Part>,
}

/// Largest amplification of the rounding of levels that polynomials are made for: next to an extremum of the level there is no bound.
const MOST_AMPLIFIED: f64 = 1e3;

/// An end of a piece is a pole if 1/K is smaller there than in the middle by this.
const POLE: f64 = 1e-9;

impl Curves {
    pub(super) fn new(roll: &RollTable) -> Self {
        let mut parts = Vec::new();
        for side in [0, 1] {
            for piece in roll.slips(side) {
                let middle = 0.5 * (piece.left + piece.right);
                let slowest = POLE * roll.inverse_level(side, middle).abs();
                let half = |end: f64| {
                    let is_pole = roll.inverse_level(side, end).abs() <= slowest;
                    let coordinate = if is_pole { Coordinate::InverseLevel } else { Coordinate::Angle };
                    Part { side, piece, coordinate, angles: (end.min(middle), end.max(middle)) }
                };
                parts.extend([half(piece.left), half(piece.right)]);
            }
        }
        Self { roll: roll.clone(), parts }
    }

    /// The coordinates of the ends of the parts.
    pub(super) fn bounds(&self) -> impl Iterator<Item = (f64, f64)> {
        self.parts.iter().map(|part| {
            let ends = [part.angles.0, part.angles.1].map(|angle| match part.coordinate {
                Coordinate::Angle => angle,
                Coordinate::InverseLevel => self.roll.inverse_level(part.side, angle).max(0.0),
            });
            (ends[0].min(ends[1]), ends[0].max(ends[1]))
        })
    }

    /// A slip at a rate.
    pub(super) fn point(&self, slip: SlipPoint, theta_rate: f64) -> Option<Point> {
        let holds = |part: &Part| {
            part.side == slip.side && part.angles.0 <= slip.angle && slip.angle <= part.angles.1
        };
        let index = self.parts.iter().position(holds)?;
        let at = match self.parts[index].coordinate {
            Coordinate::Angle => slip.angle,
            Coordinate::InverseLevel => {
                1.0 / (self.roll.law().denominator(slip.angle) * (1.0 + theta_rate * theta_rate))
            }
        };
        Some(Point { part: index, at })
    }

    /// By how much a coordinate moves, between two of a part, where the level of the orbit moves by a part of itself, over that part: what
    /// rounding of the level is amplified by. Orbits that graze the limit of friction slip at very different angles.
    pub(super) fn amplification(&self, part: usize, (from, to): (f64, f64)) -> f64 {
        let Part { side, coordinate, .. } = &self.parts[part];
        match coordinate {
            Coordinate::Angle => {
                let [first, last] = [from, to].map(|angle| self.roll.inverse_level(*side, angle));
                (first * (to - from) / (last - first)).abs().min(MOST_AMPLIFIED)
            }
            Coordinate::InverseLevel => from.abs(),
        }
    }

    /// The slip at a point, and |θ′|; none where no orbit has it.
    pub(super) fn slip(&self, point: Point) -> Option<(SlipPoint, f64)> {
        let Part { side, piece, coordinate, .. } = &self.parts[point.part];
        let (angle, k) = match coordinate {
            Coordinate::Angle => (point.at, 1.0 / self.roll.inverse_level(*side, point.at)),
            Coordinate::InverseLevel => {
                let k = 1.0 / point.at;
                (self.roll.slip_on(piece, *side, k)?, k)
            }
        };
        let d = self.roll.law().denominator(angle);
        let u = (k - d) / d;
        (u > 0.0 && u.is_finite()).then(|| (SlipPoint { side: *side, angle }, u.sqrt()))
    }
}
