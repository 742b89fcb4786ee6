//! The curves on which rolling slips, |F| = μs N, and coordinates on them.

use crate::math::bracket::Bracket;
use crate::model::SlipDirection;

use super::slip_curves::{SlipCurves, SlipPoint};

/// A slip on one of the curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) struct CurvePoint {
    pub(super) part: usize,
    pub(super) at: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Coordinate {
    /// The angle, reduced to a turn.
    Angle,
    /// 1/K, where the level K of the orbits has a pole: the angles of fast slips hardly differ.
    InverseLevel,
    /// |θ′|, where it vanishes: nor do those of slips next to a turning point, and what follows goes like the root of the difference.
    Rate,
}

#[derive(Clone, Debug)]
struct CurvePart {
    slip: SlipDirection,
    /// Angles between which the level is monotone.
    piece: Bracket,
    coordinate: Coordinate,
    angles: (f64, f64),
    bounds: (f64, f64),
}

/// The curves of one body, in parts.
#[derive(Clone, Debug)]
pub(super) struct Curves {
    slips: SlipCurves,
    parts: Vec<CurvePart>,
}

/// Largest amplification of the rounding of levels that polynomials are made for: next to an
/// extremum of the level there is no bound.
const MAX_AMPLIFICATION: f64 = 1e3;

/// More halvings of a part on which slips are told by their rate: chains that contract towards a
/// turning point end at small ones.
const MORE_HALVINGS_TO_REST: u32 = 3;

/// An end of a piece is a pole if 1/K is smaller there than in the middle by this.
const POLE_TOLERANCE: f64 = 1e-9;

impl Curves {
    pub(super) fn new(slips: SlipCurves) -> Self {
        let mut parts = Vec::new();
        for side in SlipDirection::ALL {
            let (rests, extrema) = slips.rests_and_extrema(side);
            for piece in slips.slips(side) {
                let inside = |cuts: &[f64]| -> Vec<f64> {
                    cuts.iter()
                        .copied()
                        .filter(|angle| piece.0 < *angle && *angle < piece.1)
                        .collect()
                };
                let rests = inside(&rests);
                let mut ends = vec![piece.0, piece.1];
                if !rests.is_empty() {
                    ends.extend(&rests);
                    ends.extend(inside(&extrema));
                    ends.sort_by(f64::total_cmp);
                }
                for pair in ends.windows(2) {
                    let middle = 0.5 * (pair[0] + pair[1]);
                    if !slips
                        .slip_rate_squared(side, middle)
                        .is_some_and(|u| u > 0.0)
                    {
                        continue;
                    }
                    let slowest = POLE_TOLERANCE * slips.inverse_level(side, middle).abs();
                    let half = |end: f64| {
                        let coordinate = if rests.contains(&end) {
                            Coordinate::Rate
                        } else if slips.inverse_level(side, end).abs() <= slowest {
                            Coordinate::InverseLevel
                        } else {
                            Coordinate::Angle
                        };
                        let angles = (end.min(middle), end.max(middle));
                        let at = |angle: f64| match coordinate {
                            Coordinate::Angle => angle,
                            Coordinate::InverseLevel => slips.inverse_level(side, angle).max(0.0),
                            Coordinate::Rate => slips
                                .slip_rate_squared(side, angle)
                                .map_or(0.0, |u| u.max(0.0).sqrt()),
                        };
                        let (one, other) = (at(angles.0), at(angles.1));
                        CurvePart {
                            slip: side,
                            piece: Bracket {
                                low: piece.0,
                                high: piece.1,
                            },
                            coordinate,
                            angles,
                            bounds: (one.min(other), one.max(other)),
                        }
                    };
                    parts.extend([half(pair[0]), half(pair[1])]);
                }
            }
        }
        Self { slips, parts }
    }

    pub(super) fn bounds(&self) -> impl Iterator<Item = (f64, f64)> {
        self.parts.iter().map(|part| part.bounds)
    }

    /// The angle of a slip at a rate, on a part on which rates rise or fall.
    fn angle_at(&self, part: &CurvePart, rate: f64) -> f64 {
        let (low, high) = part.angles;
        let [first, last] = [low, high].map(|angle| {
            self.slips
                .slip_rate_squared(part.slip, angle)
                .unwrap_or(0.0)
        });
        let falls = if first > last { 1.0 } else { -1.0 };
        Bracket { low, high }.refine(|angle| {
            let (u, slope) = self.slips.slip_rate_squared_and_slope(part.slip, angle);
            (falls * (u - rate * rate), falls * slope)
        })
    }

    pub(super) fn point(&self, slip: SlipPoint, theta_rate: f64) -> Option<CurvePoint> {
        let holds = |part: &CurvePart| {
            part.slip == slip.slip && part.angles.0 <= slip.angle && slip.angle <= part.angles.1
        };
        let index = self.parts.iter().position(holds)?;
        let at = match self.parts[index].coordinate {
            Coordinate::Angle => slip.angle,
            Coordinate::InverseLevel => self
                .slips
                .inverse(self.slips.level(theta_rate * theta_rate, slip.angle)),
            Coordinate::Rate => theta_rate.abs(),
        };
        Some(CurvePoint { part: index, at })
    }

    /// More halvings than of other parts, and where chains end on it.
    pub(super) fn more_halvings(&self, part: usize) -> (u32, Option<f64>) {
        match self.parts[part].coordinate {
            Coordinate::Angle | Coordinate::InverseLevel => (0, None),
            Coordinate::Rate => (MORE_HALVINGS_TO_REST, Some(self.parts[part].bounds.0)),
        }
    }

    /// By how much a coordinate moves, between two of a part, where the level of the orbit moves by
    /// a part of itself, over that part: what rounding of the level is amplified by. Orbits that
    /// graze the limit of friction slip at very different angles.
    pub(super) fn amplification(&self, part: usize, from: f64, to: f64) -> f64 {
        let part = &self.parts[part];
        let moves = |angles: [f64; 2]| {
            let [first, last] = angles.map(|angle| self.slips.inverse_level(part.slip, angle));
            (first * (to - from) / (last - first)).abs()
        };
        match part.coordinate {
            Coordinate::Angle => moves([from, to]).min(MAX_AMPLIFICATION),
            Coordinate::InverseLevel => from.abs(),
            Coordinate::Rate => moves([from, to].map(|rate| self.angle_at(part, rate))),
        }
    }

    /// The slip at a point, and |θ′|; none where no orbit has it.
    pub(super) fn slip(&self, point: CurvePoint) -> Option<(SlipPoint, f64)> {
        let part = &self.parts[point.part];
        let side = part.slip;
        let (angle, u) = match part.coordinate {
            Coordinate::Angle => (point.at, self.slips.slip_rate_squared(side, point.at)?),
            Coordinate::InverseLevel => {
                let level = self.slips.level_of(point.at);
                let angle = self.slips.slip_on(part.piece, side, level)?;
                (angle, self.slips.rate_squared(level, angle))
            }
            Coordinate::Rate => {
                let slip = SlipPoint {
                    slip: side,
                    angle: self.angle_at(part, point.at),
                };
                return (point.at > 0.0).then_some((slip, point.at));
            }
        };
        (u > 0.0 && u.is_finite()).then(|| (SlipPoint { slip: side, angle }, u.sqrt()))
    }
}
