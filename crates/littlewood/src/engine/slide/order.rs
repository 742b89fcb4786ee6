//! What is the same for all slides between two: slides do not cross in the (ϑ, u) plane.
//!
//! On a table a slide is a number u_c, and n³ P σ η″ = a + u_c b. The slides between two are the
//! numbers between two, on every table that they pass.

use crate::math::trig::Angle;
use crate::mechanics::SlidingLaw;

use super::series::SIGN_DEGREE;
use super::table::{AngleInterval, SlideTable, SlideTables};

/// On intervals half as wide as the coarsest: what the sums for η″ leave out, which grows with the
/// eleventh power of the width, is then less than a millionth of them also for fast slides.
const ORDER_HALVINGS: usize = 1;

/// A point of a slide.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct StripSide {
    pub(in crate::engine) angle: Angle,
    pub(in crate::engine) u: f64,
}

/// The slides between two, from angles on both sides of a third on.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct SlideStrip {
    pub(in crate::engine) first: StripSide,
    pub(in crate::engine) last: StripSide,
    /// The third, in the turn from 0 on.
    pub(in crate::engine) middle: f64,
}

/// u_c of two slides on a table.
#[derive(Clone, Copy, Debug)]
struct Centres {
    first: f64,
    last: f64,
}

impl Centres {
    fn map(self, change: impl Fn(f64) -> f64) -> Self {
        Self {
            first: change(self.first),
            last: change(self.last),
        }
    }
}

/// How far it is known that η″ of all slides in a strip falls through zero at most once.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct SingleFall {
    pub(in crate::engine) to: f64,
    /// It is of slides that begin with a larger σ η″.
    pub(in crate::engine) sign_uncertainty: f64,
}

impl SlideTables {
    /// Whether σ η″ of every slide in a strip, positive where it begins, changes its sign at most
    /// once, up to an angle or beyond; none where that is not known.
    pub(in crate::engine) fn single_fall(
        &self,
        law: &SlidingLaw,
        sigma: f64,
        strip: SlideStrip,
        to: f64,
    ) -> Option<SingleFall> {
        let mut interval = AngleInterval::holding(strip.middle, ORDER_HALVINGS);
        let mut table = self.get(law, sigma, interval)?;
        let centre = |side: StripSide| table.solutions.u_centre(side.angle, side.u);
        let mut centres = Centres {
            first: centre(strip.first),
            last: centre(strip.last),
        };
        let mut fall = SingleFall {
            to: interval.end(),
            sign_uncertainty: 0.0,
        };
        // Tables reach over the ends of their intervals, before the start of a slide, too. One that
        // rises there is positive behind its start. If two tables tell of a fall, it is the same:
        // on what both reach over it is one function.
        let mut may_have_fallen = false;
        loop {
            let signs = table.strip_signs(centres);
            fall.sign_uncertainty = fall.sign_uncertainty.max(signs.sign_uncertainty);
            if may_have_fallen || !signs.only_rise {
                if !signs.only_fall {
                    return None;
                }
                may_have_fallen = true;
            }
            if fall.to >= to {
                return Some(fall);
            }
            interval = AngleInterval::at(interval.exit(), ORDER_HALVINGS)?;
            fall.to += interval.width();
            let before = table;
            table = self.get(law, sigma, interval)?;
            centres = centres.map(|u_centre| {
                table
                    .solutions
                    .u_centre_of_entry(before.solutions.exit(u_centre))
            });
        }
    }
}

/// How σ η″ of the slides in a strip changes its sign on a table.
struct StripSigns {
    /// At most once, from positive to negative.
    only_fall: bool,
    /// At most once, from negative to positive.
    only_rise: bool,
    /// The largest |η″| of which the sign is not known.
    sign_uncertainty: f64,
}

impl SlideTable {
    fn strip_signs(&self, centres: Centres) -> StripSigns {
        let [first, last] = [centres.first, centres.last].map(|at| self.slip_acceleration(at));
        let band = first.remainder.max(last.remainder);
        // Of Bernstein coefficients that are not certainly positive all behind are certainly
        // negative. They are linear in u_c: the slides of which one is not certainly positive are
        // all on one side, and the next is largest at an end of that.
        let only_fall = |sign: f64| {
            (0..SIGN_DEGREE).all(|k| {
                let [here, next] = [k, k + 1].map(|k| Ends {
                    first: sign * first.low[k],
                    last: sign * last.low[k],
                });
                let is_negative = |part: f64| next.at(part) < -band;
                let crossing = (band - here.first) / (here.last - here.first);
                (here.first > band || is_negative(0.0))
                    && (here.last > band || is_negative(1.0))
                    && ((here.first > band) == (here.last > band) || is_negative(crossing))
            })
        };
        StripSigns {
            only_fall: only_fall(1.0),
            only_rise: only_fall(-1.0),
            sign_uncertainty: self.sign_uncertainty(band),
        }
    }
}

/// A coefficient of two slides, and of those between them.
struct Ends {
    first: f64,
    last: f64,
}

impl Ends {
    fn at(&self, part: f64) -> f64 {
        self.first + part * (self.last - self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::contact;
    use crate::model::{Body, Hoop, HoopParameters, SlipDirection};

    /// σ η″ of the slide through a point, at so many angles from there on, by Runge's method.
    fn slip_accelerations(law: &SlidingLaw, sigma: f64, mut u: f64, angles: &[f64]) -> Vec<f64> {
        let slope = |angle: f64, u: f64| {
            let Angle { sin, cos } = Angle::of(angle);
            law.u_growth(sin, cos) * contact(1.0, law.body.h, cos * u)
        };
        let mut values = Vec::new();
        for (angle, next) in angles.iter().zip(&angles[1..]) {
            let Angle { sin, cos } = Angle::of(*angle);
            let (alpha, beta) = law.slip_acceleration(sin, cos);
            values.push(sigma * (alpha + beta * u));
            let (step, middle) = (next - angle, 0.5 * (angle + next));
            let k1 = slope(*angle, u);
            let k2 = slope(middle, u + 0.5 * step * k1);
            let k3 = slope(middle, u + 0.5 * step * k2);
            let k4 = slope(*next, u + step * k3);
            u += step / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        }
        values
    }

    /// Compared with slides all over strips, integrated by another method: behind a fall none rises.
    /// Many strips are refused, among them some whose slides do rise.
    #[test]
    fn slides_in_a_strip_fall_at_most_once_where_it_is_told() {
        let (mut told, mut falls, mut refused, mut rises) = (0, 0, 0, 0);
        for (mass_ratio, inertia, mu) in [(1.0, 1.0, 0.4), (0.2, 0.4, 0.5), (0.05, 0.05, 0.3)] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_inertia(inertia)
                .with_friction(mu, mu);
            let Body::Heavy(body) = Hoop::new(hoop).unwrap().body() else {
                unreachable!("it has mass")
            };
            let tables = SlideTables::default();
            for (direction, k) in (0..400).flat_map(|k| SlipDirection::ALL.map(|slip| (slip, k))) {
                let (law, sigma) = (SlidingLaw::of_body(body, mu, direction), direction.sign());
                let middle = 0.0157 * f64::from(k);
                let (u, width) = (0.2 + 0.37 * f64::from(k % 23), 0.01 * f64::from(1 + k % 5));
                let (first, last) = (u * (1.0 - width), u * (1.0 + width));
                // All through one angle: those between the two are those with u between.
                let side = |u: f64| StripSide {
                    angle: Angle::of(middle),
                    u,
                };
                let strip = SlideStrip {
                    first: side(first),
                    last: side(last),
                    middle,
                };
                let to = middle + 1.0;
                let angles: Vec<f64> = (0..=200).map(|j| middle + 0.005 * f64::from(j)).collect();
                let known = tables.single_fall(&law, sigma, strip, to);
                for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
                    let u = first + part * (last - first);
                    let values = slip_accelerations(&law, sigma, u, &angles);
                    let least = known.map_or(1e-6, |fall| fall.sign_uncertainty + 1e-6);
                    if values[0] <= least {
                        continue;
                    }
                    let fallen = values.iter().position(|value| *value < -least);
                    let rises_again =
                        fallen.is_some_and(|at| values[at..].iter().any(|value| *value > least));
                    match known {
                        Some(fall) => {
                            assert!(fall.to >= to && !rises_again, "{mass_ratio} {k} {part}");
                            told += 1;
                            falls += u32::from(fallen.is_some());
                        }
                        None => {
                            refused += 1;
                            rises += u32::from(rises_again);
                        }
                    }
                }
            }
        }
        assert!(told > 1_000 && falls > 100, "{told} {falls}");
        assert!(refused > 100 && rises > 10, "{refused} {rises}");
    }
}
