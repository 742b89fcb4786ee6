//! A segment of a slide on which θ′ keeps its sign.

use crate::engine::fallback::Fallback;
use crate::engine::quadrature::{
    MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT,
};
use crate::math::trig::Angle;
use crate::mechanics::SlidingLaw;

use super::segment::{LocalCoefficients, SlideSegment};
use super::series::{
    DEGREE, Expansion, Family, Series, Signs, SlipSigns, TermBound, scaled, sum_of_sizes, value,
};

/// Up to this multiple of a segment u has no zero: the terms of its series are at most the part
/// [`RegularSegment::MAX_TERM_RATIO`] of the first, but for a linear term that makes it grow by at
/// most `MAX_GROWTH` on the segment. The Gauss sum of 1/√u is then exact to rounding: its
/// singularities lie outside the ellipse about the segment with the half axes 1.3 and 1.2, r = 5
/// and r⁻²⁴ = 2e-17.
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

/// A segment with the coordinate t = z/width up to 1, in the frame of motion.
#[derive(Clone, Debug)]
pub(super) struct RegularSegment<S = SlipSigns> {
    /// z at t = 1.
    pub(super) width: f64,
    /// u in powers of t, truncated at `degree`, which is even.
    pub(super) u: Series,
    pub(super) degree: usize,
    /// On the segment without its start.
    pub(super) signs: S,
    /// At t = 0.
    pub(super) angle: Angle,
    /// t at the end: 1, or at the end of an interval of the grid.
    pub(super) end: f64,
    /// Set if it crosses a whole interval.
    pub(super) known_time: Option<KnownTime>,
    /// Set if it ends at the end of an interval.
    pub(super) exit: Option<SegmentExit>,
}

/// The time from a coordinate to the end of a segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownTime {
    pub(super) from: f64,
    pub(super) time: f64,
}

/// What a table holds for the end of an interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentExit {
    pub(super) u: f64,
    pub(super) coefficients: LocalCoefficients,
}

/// The coordinates between which a segment lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) start: f64,
    pub(super) end: f64,
}

impl Span {
    /// Largest |t| on the ellipse about it.
    pub(super) fn ellipse_radius(self) -> f64 {
        0.5 * (self.start + self.end).abs() + (ELLIPSE_FACTOR - 0.5) * (self.end - self.start)
    }
}

impl RegularSegment {
    /// The largest sum of the other terms of u, as a part of the first.
    pub(super) const MAX_TERM_RATIO: f64 = 0.9;

    /// Whether u has no zero near a segment by the sizes of its terms: on the ellipse about it all
    /// but the first are at most the part [`RegularSegment::MAX_TERM_RATIO`] of that.
    pub(super) fn is_zero_free(u: &[f64], span: Span) -> bool {
        let radius = span.ellipse_radius();
        radius * sum_of_sizes(&u[1..], radius) <= Self::MAX_TERM_RATIO * u[0]
    }

    /// Whether the linear term alone allows [`RegularSegment::is_zero_free`].
    pub(super) fn may_be_zero_free(u0: f64, slope: f64, span: Span) -> bool {
        span.ellipse_radius() * slope.abs() <= Self::MAX_TERM_RATIO * u0
    }
}

impl<S: Signs> RegularSegment<S> {
    /// The widest segment from an angle on which the series of u has converged; `from_zero` if
    /// η″ = 0 at its start.
    pub(super) fn new(
        expansion: &Expansion<impl Family<Signs = S>>,
        angle: Angle,
        from_zero: bool,
    ) -> Result<Self, Fallback> {
        let [u0, slope, ..] = expansion.u;
        let convergence_radius = expansion.convergence_radius(0);
        let bound = TermBound {
            lead: 0,
            first: 1,
            max_width: convergence_radius,
            stretch: ELLIPSE_FACTOR,
            max_ratio: RegularSegment::MAX_TERM_RATIO,
        };
        // A rising linear term moves no zero onto the segment: it is bounded on the segment alone.
        let bound = if slope > 0.0 {
            TermBound {
                first: 2,
                max_width: convergence_radius.min(MAX_GROWTH * u0 / slope),
                ..bound
            }
        } else {
            bound
        };
        let width = expansion.smooth(bound).ok_or(Fallback::TurningPoint)?;
        let with_width = |width: f64| {
            let u = scaled(expansion.u, width);
            let signs = expansion.family.signs(&u, width, from_zero);
            let signs = signs.ok_or(Fallback::Pole)?;
            Ok(Self {
                width,
                u,
                degree: DEGREE,
                signs,
                angle,
                end: 1.0,
                known_time: None,
                exit: None,
            })
        };
        let segment = with_width(width)?;
        // Where η″ vanishes at the end of a segment, or twice on it, half of it has its signs.
        if segment.signs.are_unknown() {
            with_width(0.5 * width)
        } else {
            Ok(segment)
        }
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
        -self.angle.sin / ((1.0 + self.angle.cos) * self.width)
    }

    /// The angle between two coordinates.
    pub(super) fn delta_theta(&self, span: Span) -> f64 {
        let (from, to) = (self.width * span.start, self.width * span.end);
        2.0 * libm::atan((to - from) / (1.0 + from * to))
    }
}

impl<S: Signs> SlideSegment for RegularSegment<S> {
    #[inline]
    fn u(&self, t: f64) -> f64 {
        match self.exit {
            Some(exit) if t == self.end => exit.u,
            _ => value(&self.u[..=self.degree], t),
        }
    }

    #[inline]
    fn u_at<const N: usize>(&self, t: [f64; N]) -> [f64; N] {
        let mut u = [self.u[self.degree]; N];
        for c in self.u[..self.degree].iter().rev() {
            for j in 0..N {
                u[j] = u[j] * t[j] + c;
            }
        }
        u
    }

    fn theta_rate(&self, _: f64, u: f64) -> f64 {
        u.sqrt()
    }

    #[inline]
    fn angle(&self, t: f64) -> Angle {
        match &self.exit {
            Some(exit) if t == self.end => exit.coefficients.angle,
            _ => self.angle.plus(Angle::of_half_tangent(self.width * t)),
        }
    }

    #[inline]
    fn coefficients(&self, law: &SlidingLaw, t: f64) -> LocalCoefficients {
        match self.exit {
            Some(exit) if t == self.end => exit.coefficients,
            _ => LocalCoefficients::new(law, self.angle(t)),
        }
    }

    fn theta_slope(&self, t: f64) -> f64 {
        let z = self.width * t;
        2.0 * self.width / (1.0 + z * z)
    }

    fn time_slope(&self, t: f64, u: f64) -> f64 {
        self.theta_slope(t) / u.sqrt()
    }

    fn time(&self, from: f64, to: f64) -> f64 {
        if let Some(known) = self.known_time
            && from == known.from
            && to == self.end
        {
            return known.time;
        }
        if from == 0.0 && to == 1.0 && self.degree == DEGREE {
            return self.whole_time();
        }
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let t = NODE.map(|node| middle + half * node);
        let u = self.u_at(t);
        let mut sum = 0.0;
        for j in 0..NODES {
            let z = self.width * t[j];
            sum += WEIGHT[j] / ((1.0 + z * z) * u[j].sqrt());
        }
        2.0 * self.width * half * sum
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    /// The farthest point of the ellipse about a segment, with half axes that are these parts of
    /// its length, from t = 0: by its points, not by its formula.
    fn farthest(Span { start, end }: Span) -> f64 {
        let (centre, length) = (0.5 * (start + end), end - start);
        (0..360)
            .map(|degrees| {
                let (sin, cos) = libm::sincos(f64::from(degrees) * (TAU / 360.0));
                libm::hypot(centre + 1.3 * length * cos, 1.2 * length * sin)
            })
            .fold(0.0, f64::max)
    }

    /// One term beside the first, a little smaller and a little larger than the part of it that it
    /// may be on the ellipse.
    #[test]
    fn u_has_no_zero_where_its_terms_on_the_ellipse_are_small() {
        for (start, end) in [(0.0, 1.0), (-1.0, 1.0), (-0.9, -0.2), (0.3, 0.5)] {
            let span = Span { start, end };
            let radius = farthest(span);
            for degree in 1..=DEGREE {
                for u0 in [1e-6, 1.0, 30.0] {
                    for (part, is_free) in [(0.89, true), (0.91, false)] {
                        for sign in [-1.0, 1.0] {
                            let mut u = [0.0; DEGREE + 1];
                            u[0] = u0;
                            u[degree] = sign * part * u0 / libm::pow(radius, degree as f64);
                            let told = RegularSegment::is_zero_free(&u, span);
                            assert_eq!(told, is_free, "{span:?} {degree} {u0} {part}");
                            let may_be = RegularSegment::may_be_zero_free(u0, u[1], span);
                            assert_eq!(may_be, is_free || degree > 1, "{span:?} {degree} {part}");
                        }
                    }
                }
            }
        }
    }
}
