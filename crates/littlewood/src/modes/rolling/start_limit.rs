//! Whether a hoop rolls from a start on a limit of rolling: |F| = μs N, and of a massless hoop N = 0
//! (docs/theory/contact.md).
//!
//! Along the rolling the margins are power series in the angle that is passed
//! ([`MarginSeries`]). On a limit, but for rounding, the first coefficient that does not vanish
//! decides.

use core::f64::consts::PI;

use crate::math::series::{DEGREE, Series, led, times};
use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::{Loads, RollingLaw};
use crate::model::{Body, Hoop, SlipDirection};
use crate::modes::PhasePoint;

use super::boundary::{RollingLimit, in_body_frame};
use super::margin_series::MarginSeries;

/// What follows from η′ = 0 on a limit of rolling of a massless hoop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum MasslessLimit {
    /// It rolls: no margin is negative just after.
    Rolls,
    /// It glides; `unloaded` if N = 0 at the start.
    Glides { unloaded: bool },
    /// All coefficients of a margin are rounding, as at rest in an equilibrium of a slope.
    Undecided,
}

/// The margins of rolling along the motion from a start, with bounds of their rounding.
struct Margins {
    series: [Option<(Series, RollingLimit)>; 3],
    sizes: Sizes,
    /// The highest order that may decide.
    highest: usize,
}

impl Margins {
    fn new(hoop: &Hoop, law: &RollingLaw, place: &PhasePoint) -> Self {
        let angle = Angle::of(place.theta);
        let u = place.rate * place.rate;
        let moving = if u == 0.0 {
            law.acceleration(angle, Loads::of(u), 1.0)
        } else {
            place.rate
        };
        let heading = SlipDirection::of_sign(moving).map_or(1.0, SlipDirection::sign);
        let ahead = Angle {
            sin: heading * angle.sin,
            ..angle
        };
        let kinetic = law.denominator_of(angle) * u;
        let margins = MarginSeries::new(hoop, heading);
        let (mu, theta) = (hoop.mu_s(), place.theta.abs());
        let sizes = match hoop.body() {
            Body::Massless(_) => Sizes {
                terms: massless_sizes(law, mu, angle, u),
                roundings: 24.0,
                theta: [0.0, theta],
            },
            Body::Heavy(_) => {
                let terms = heavy_sizes(law, mu, angle, u);
                Sizes {
                    terms: [terms; 2],
                    roundings: 40.0,
                    theta: [theta; 2],
                }
            }
        };
        let highest = if law.is_steady(place.theta, place.rate) {
            0
        } else {
            DEGREE - 1
        };
        Self {
            series: margins.at(ahead, kinetic).map(|margin| {
                margin.map(|(series, limit)| (series, in_body_frame(limit, heading)))
            }),
            sizes,
            highest,
        }
    }

    /// The first coefficient of a margin that is not rounding: its order, and whether it is
    /// positive.
    fn first(&self, margin: usize, lowest: usize) -> Option<(usize, bool)> {
        let (series, _) = self.series[margin].as_ref()?;
        let order =
            (lowest..=self.highest).find(|n| series[*n].abs() > self.sizes.rounding(margin, *n))?;
        Some((order, series[order] > 0.0))
    }
}

/// Whether |F| < μs N just after a start of a heavy hoop on the limit of a slip in this direction.
/// None if rounding decides all orders.
pub(crate) fn static_friction_holds(
    hoop: &Hoop,
    law: &RollingLaw,
    place: &PhasePoint,
    slip: SlipDirection,
) -> Option<bool> {
    let margins = Margins::new(hoop, law, place);
    let is_this = |margin: &Option<(Series, RollingLimit)>| {
        margin.is_some_and(|(_, limit)| limit == RollingLimit::Friction(slip))
    };
    let margin = margins.series.iter().position(is_this)?;
    margins.first(margin, 1).map(|(_, is_positive)| is_positive)
}

impl MasslessLimit {
    /// None off all limits: there the signs of the margins decide.
    pub(crate) fn at(hoop: &Hoop, place: &PhasePoint) -> Option<Self> {
        let law = RollingLaw::of(hoop);
        let Angle { sin, cos } = Angle::of(place.theta);
        if law.bottom == 0.0 && cos < 0.0 && sin.abs() <= f64::EPSILON * PI {
            // The particle is at the plane, but for rounding: rolling has no orbit there.
            return None;
        }
        if law.tilt == 0.0 && law.is_steady(place.theta, place.rate) {
            // No force of friction is needed at the top and at the bottom.
            return None;
        }
        let margins = Margins::new(hoop, &law, place);
        let [normal, negative, positive] = [0, 1, 2].map(|margin| margins.first(margin, 0));
        let all = [normal, negative, positive];
        let is_clear = |first: &Option<(usize, bool)>| matches!(first, Some((0, _)));
        if all.iter().all(is_clear) {
            return None;
        }
        Some(
            if all.iter().flatten().any(|(_, is_positive)| !is_positive) {
                Self::Glides {
                    unloaded: !is_clear(&normal),
                }
            } else if all.iter().any(Option::is_none) {
                Self::Undecided
            } else {
                Self::Rolls
            },
        )
    }
}

/// Sums of the sizes of the terms of the first margin and of the others, and what rounds them.
struct Sizes {
    terms: [Series; 2],
    /// Largest number of roundings of a term: of a massless hoop 15 of D θ′², with the unit of time
    /// of a slope, and 9 of the other factors and sums; of others, with D² and Î, 40.
    roundings: f64,
    /// The angle, where its rounding counts: N of a massless hoop has the sign of factors that it
    /// does not change.
    theta: [f64; 2],
}

impl Sizes {
    /// Bound of the rounding of a coefficient. Each order adds a sum. With the angle, which is
    /// rounded, too, it changes by the next coefficient.
    fn rounding(&self, margin: usize, order: usize) -> f64 {
        let which = margin.min(1);
        let (terms, next) = (&self.terms[which], order as f64 + 1.0);
        let by_angle = self.theta[which] * next * terms[order + 1];
        0.5 * f64::EPSILON * ((self.roundings + order as f64) * terms[order] + by_angle)
    }
}

/// The sizes of the series of an angle, of D, and of what D carries.
struct AngleSizes {
    sines: Series,
    cosines: Series,
    height: f64,
    d: Series,
    carried: Series,
    /// D θ′².
    energy: Series,
}

impl AngleSizes {
    fn new(law: &RollingLaw, angle: Angle, u: f64) -> Self {
        let (l, m, pull) = (law.offset, law.mass, law.tilt.abs());
        let height = above_bottom(angle);
        let mut sines: Series = [0.0; DEGREE + 1];
        let mut cosines = sines;
        (sines[0], cosines[0]) = (angle.sin.abs(), angle.cos.abs());
        for n in 1..=DEGREE {
            (sines[n], cosines[n]) = (cosines[n - 1] / n as f64, sines[n - 1] / n as f64);
        }
        let d = led(law.bottom + 2.0 * l * height, 2.0 * l, &cosines);
        let energy = core::array::from_fn(|n| match n {
            0 => d[0] * u,
            1 => 2.0 * (l * sines[0] + pull * (m + l * cosines[0])),
            _ => 2.0 * l * (pull * sines[n] + cosines[n]),
        });
        Self {
            carried: led((m - l) + l * height, l, &cosines),
            sines,
            cosines,
            height,
            d,
            energy,
        }
    }
}

/// The series of [`MarginSeries::at`] of a massless hoop, of the sizes of their terms.
fn massless_sizes(law: &RollingLaw, mu: f64, angle: Angle, u: f64) -> [Series; 2] {
    let (l, pull) = (law.offset, law.tilt.abs());
    let of = AngleSizes::new(law, angle, u);
    let lever = led((1.0 - l) + of.height, 1.0, &of.cosines);
    let held: Series = core::array::from_fn(|n| of.carried[n] + pull * l * of.sines[n]);
    let [held, pulled] = [times(&of.d, &held), times(&of.energy, &lever)];
    [
        core::array::from_fn(|n| held[n] + l * pulled[n]),
        core::array::from_fn(|n| mu * of.carried[n] + l * of.sines[n]),
    ]
}

/// The same of a hoop with inertia.
fn heavy_sizes(law: &RollingLaw, mu: f64, angle: Angle, u: f64) -> Series {
    let (l, pull, inertia) = (law.offset, law.tilt.abs(), law.mass_inertia);
    let of = AngleSizes::new(law, angle, u);
    let square = times(&of.sines, &of.sines);
    let carried_square = times(&of.carried, &of.carried);
    let sin_carried = times(&of.sines, &of.carried);
    let with_inertia = |n: usize| if n == 0 { inertia } else { 0.0 };
    let weighed: Series =
        core::array::from_fn(|n| carried_square[n] + pull * l * sin_carried[n] + with_inertia(n));
    let along: Series = core::array::from_fn(|n| l * l * square[n] + with_inertia(n));
    let excess = led(law.inertia_excess[1].abs() + l * of.height, l, &of.cosines);
    let [held, loaded, along, driven, turned] = [
        times(&of.d, &weighed),
        times(&sin_carried, &of.d),
        times(&of.d, &along),
        times(&of.sines, &excess),
        times(&of.cosines, &of.d),
    ];
    let by_energy: Series =
        core::array::from_fn(|n| l * (driven[n] + mu * (l * square[n] + turned[n])));
    let by_energy = times(&of.energy, &by_energy);
    core::array::from_fn(|n| mu * held[n] + pull * along[n] + l * loaded[n] + by_energy[n])
}
