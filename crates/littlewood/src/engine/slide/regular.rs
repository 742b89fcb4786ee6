//! A step of a slide on which θ′ keeps its sign.

use crate::engine::quadrature::{
    MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT,
};

use crate::engine::fallback::Fallback;

use crate::mechanics::SlidingLaw;

use super::segment::{LawAt, SlideSegment};
use super::series::{DEGREE, Expansion, Series, SignPattern, scaled, sum_of_sizes, value};

/// Up to this multiple of a step u has no zero: the terms of its series are at most the part
/// [`RegularSegment::MAX_TERM_RATIO`] of the first, but for a linear term that makes it grow by at most
/// `MAX_GROWTH` on the step. The Gauss sum of 1/√u is then exact to rounding: its singularities lie
/// outside the ellipse about the step with the half axes 1.3 and 1.2, r = 5 and r⁻²⁴ = 2e-17.
const ELLIPSE_FACTOR: f64 = 1.8;
const MAX_GROWTH: f64 = 0.9;

/// Powers of the Gauss nodes on [0, 1], by power.
const POWERS: [[f64; NODES]; DEGREE + 1] = {
    let mut table = [[1.0; NODES]; DEGREE + 1];
    let mut k = 1;
    while k <= DEGREE {
        let mut j = 0;
        while j < NODES {
            table[k][j] = table[k - 1][j] * (0.5 + 0.5 * NODE[j]);
            j += 1;
        }
        k += 1;
    }
    table
};

/// A step, with the coordinate t = z/width up to 1, in the frame of motion.
#[derive(Clone, Debug)]
pub(super) struct RegularSegment {
    /// z at the end.
    pub(super) width: f64,
    /// With coefficients that tell up to the degree, which is even.
    pub(super) u: Series,
    pub(super) degree: usize,
    /// SignPattern of σ η″ on the step, behind its beginning.
    pub(super) signs: SignPattern,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) doubt: f64,
    /// sin ϑ and cos ϑ at t = 0.
    pub(super) direction: (f64, f64),
    /// t at its end: 1, or at the end of a tile.
    pub(super) end: f64,
    /// The time from this t to the end, where it is known.
    pub(super) known: Option<(f64, f64)>,
    /// u and the law at the end, where that is the end of a tile.
    pub(super) exit: Option<(f64, LawAt)>,
}

impl RegularSegment {
    /// The part of u that the terms behind the first may be.
    pub(super) const MAX_TERM_RATIO: f64 = 0.9;

    /// The step from an angle with this sine and cosine, where η″ = 0 if it is `from_zero`. `reach`
    /// is the width on which the series has converged.
    pub(super) fn new(
        expansion: &Expansion,
        direction: (f64, f64),
        reach: f64,
        from_zero: bool,
    ) -> Result<Self, Fallback> {
        let [u0, slope, ..] = expansion.u;
        let width = if slope > 0.0 {
            expansion.smooth(
                (0, 2),
                (reach.min(MAX_GROWTH * u0 / slope), ELLIPSE_FACTOR),
                Self::MAX_TERM_RATIO,
            )
        } else {
            expansion.smooth((0, 1), (reach, ELLIPSE_FACTOR), Self::MAX_TERM_RATIO)
        };
        let width = width.ok_or(Fallback::TurningPoint)?;
        let on = |width: f64| {
            let u = scaled(expansion.u, width);
            expansion
                .signs(&u, width, from_zero)
                .map(|(signs, doubt)| (width, u, signs, doubt))
        };
        let mut step = on(width).ok_or(Fallback::Pole)?;
        // Where η″ vanishes at the end of a step, or twice on it, half of the step has its signs.
        if step.2 == SignPattern::Unknown {
            step = on(0.5 * width).ok_or(Fallback::Pole)?;
        }
        let (width, u, signs, doubt) = step;
        Ok(Self {
            width,
            u,
            degree: DEGREE,
            signs,
            doubt,
            direction,
            end: 1.0,
            known: None,
            exit: None,
        })
    }

    /// Whether u has no zero near the step between two t by the sizes of its terms: on the same
    /// ellipse about the step all but the first are at most the part [`RegularSegment::MAX_TERM_RATIO`] of that.
    pub(super) fn is_clear(u: &[f64], (from, to): (f64, f64)) -> bool {
        let far = Self::far(from, to);
        far * sum_of_sizes(&u[1..], far) <= Self::MAX_TERM_RATIO * u[0]
    }

    /// Whether its first two coefficients allow that.
    pub(super) fn is_nearly_even(u0: f64, slope: f64, (from, to): (f64, f64)) -> bool {
        Self::far(from, to) * slope.abs() <= Self::MAX_TERM_RATIO * u0
    }

    /// Largest |t| on the ellipse about the step between two t.
    pub(super) fn far(from: f64, to: f64) -> f64 {
        0.5 * (from + to).abs() + (ELLIPSE_FACTOR - 0.5) * (to - from)
    }

    fn whole_time(&self) -> f64 {
        let mut u = [0.0; NODES];
        for (c, powers) in self.u.iter().zip(&POWERS) {
            for j in 0..NODES {
                u[j] += c * powers[j];
            }
        }
        let square = self.width * self.width;
        let mut sum = 0.0;
        for j in 0..NODES {
            sum += WEIGHT[j] / ((1.0 + square * POWERS[2][j]) * u[j].sqrt());
        }
        self.width * sum
    }

    /// t at the top, if that is near.
    pub(super) fn top(&self) -> f64 {
        let (sin, cos) = self.direction;
        -sin / ((1.0 + cos) * self.width)
    }

    pub(super) fn turned(&self, from: f64, to: f64) -> f64 {
        let (from, to) = (self.width * from, self.width * to);
        2.0 * libm::atan((to - from) / (1.0 + from * to))
    }
}

/// sin and cos of an angle from those of another, and the tangent of half the difference.
#[inline]
pub(super) fn rotated((sin, cos): (f64, f64), z: f64) -> (f64, f64) {
    let square = z * z;
    let inverse = 1.0 / (1.0 + square);
    let (turn_sin, turn_cos) = (2.0 * z * inverse, (1.0 - square) * inverse);
    (
        sin * turn_cos + cos * turn_sin,
        cos * turn_cos - sin * turn_sin,
    )
}

impl SlideSegment for RegularSegment {
    #[inline]
    fn u(&self, t: f64) -> f64 {
        match self.exit {
            Some((u, _)) if t == self.end => u,
            _ => value(&self.u[..=self.degree], t),
        }
    }

    fn rate(&self, _: f64, u: f64) -> f64 {
        u.sqrt()
    }

    #[inline]
    fn direction(&self, t: f64) -> (f64, f64) {
        match &self.exit {
            Some((_, there)) if t == self.end => there.direction,
            _ => rotated(self.direction, self.width * t),
        }
    }

    #[inline]
    fn law_at(&self, law: &SlidingLaw, t: f64) -> LawAt {
        match self.exit {
            Some((_, there)) if t == self.end => there,
            _ => LawAt::new(law, self.direction(t)),
        }
    }

    fn turning(&self, t: f64) -> f64 {
        let z = self.width * t;
        2.0 * self.width / (1.0 + z * z)
    }

    fn slowness(&self, t: f64, u: f64) -> f64 {
        self.turning(t) / u.sqrt()
    }

    fn time(&self, from: f64, to: f64) -> f64 {
        if let Some((_, time)) = self
            .known
            .filter(|(begin, _)| from == *begin && to == self.end)
        {
            return time;
        }
        if from == 0.0 && to == 1.0 && self.degree == DEGREE {
            return self.whole_time();
        }
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let t = NODE.map(|node| middle + half * node);
        let mut u = [self.u[self.degree]; NODES];
        for c in self.u[..self.degree].iter().rev() {
            for j in 0..NODES {
                u[j] = u[j] * t[j] + c;
            }
        }
        let mut sum = 0.0;
        for j in 0..NODES {
            let z = self.width * t[j];
            sum += WEIGHT[j] / ((1.0 + z * z) * u[j].sqrt());
        }
        2.0 * self.width * half * sum
    }
}
