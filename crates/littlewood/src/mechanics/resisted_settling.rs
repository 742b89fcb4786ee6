//! Settling with rolling resistance: the rotation changes from bounce to bounce, and may end on the
//! way (docs/theory/rolling-resistance.md#impacts).
//!
//! Bounces of three kinds have a sum. Where slip, rotation and gap rate all shrink by one ratio the
//! next bounce is the first in other units. Where slip and gap rate do, and the hoop turns on, the
//! rotation is a geometric sum, which must not reach zero. And where each impact has one segment,
//! slip and rotation are both such sums, until one of them vanishes.

use crate::math::number::Number;
use crate::mechanics::ContactVelocities;
use crate::mechanics::resisted_impact::{Followed, ResistedContact};
use crate::mechanics::settling::{
    Bounces, MAX_BOUNCES, NEGLIGIBLE_RATE_RATIO, NoSettling, RATIO_ROUNDING, Run, Settling, Sums,
    geometric, scales,
};

/// What the bounces of a run have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// One bounce, or bounces that are the same in other units.
    Scaled,
    /// The hoop turns on.
    Turning,
    /// Each impact has one segment.
    Straight,
}

/// A run of bounces, and the rotation before it.
struct ResistedRun<T> {
    run: Run<T>,
    theta_rate: T,
    kind: Kind,
    number: f64,
}

impl<T: Number> ResistedRun<T> {
    fn new(run: Run<T>, theta_rate: T, followed: &Followed<T>) -> Self {
        let after = run.first.after;
        let ratio = run.ratio.value();
        let [slip_scales, rotation_scales] =
            [(run.slip, after.slip), (theta_rate, after.theta_rate)]
                .map(|(before, after)| scales(before.value(), after.value(), ratio));
        let [before, spin] = [theta_rate, after.theta_rate - theta_rate].map(T::value);
        let until = |number: f64, is_zero: bool| if is_zero { f64::INFINITY } else { number };
        let rotation = until(run.further(before, spin), before == 0.0 && spin == 0.0);
        let sticks = [run.slip, run.first.before.slip, after.slip]
            .iter()
            .all(|slip| slip.value() == 0.0);
        let slip = until(run.until_stop(), sticks);
        let turns_for_ever = followed.turns_on && rotation == f64::INFINITY;
        let (kind, number) = if slip_scales && rotation_scales {
            (Kind::Scaled, f64::INFINITY)
        } else if slip_scales && turns_for_ever {
            (Kind::Turning, f64::INFINITY)
        } else if followed.is_straight {
            (Kind::Straight, 1.0 + (0.5 * rotation.min(slip)).floor())
        } else {
            (Kind::Scaled, 1.0)
        };
        let kind = if number == 1.0 { Kind::Scaled } else { kind };
        Self {
            run,
            theta_rate,
            kind,
            number,
        }
    }

    /// Slip, rotation and gap rate after the run.
    fn after(&self) -> ContactVelocities<T> {
        let Self {
            ref run, number, ..
        } = *self;
        let (first, ratio) = (run.first.after, run.ratio);
        let zero = T::constant(0.0);
        if number == 1.0 {
            return first;
        }
        let count = geometric(ratio, number);
        let summed = |before: T, after: T| before + (after - before) * count;
        let rotation = summed(self.theta_rate, first.theta_rate);
        match self.kind {
            Kind::Scaled => ContactVelocities {
                theta_rate: zero,
                slip: zero,
                gap_rate: zero,
            },
            Kind::Turning => ContactVelocities {
                theta_rate: rotation,
                slip: zero,
                gap_rate: zero,
            },
            Kind::Straight => ContactVelocities {
                theta_rate: rotation,
                slip: summed(run.slip, first.slip),
                gap_rate: if number == f64::INFINITY {
                    zero
                } else {
                    run.opening_after(-run.first.before.gap_rate, number)
                },
            },
        }
    }

    /// Adds the run to the sums.
    fn add_to(&self, sums: &mut Sums<T>, rolling_resistance: T) {
        let Self {
            ref run,
            theta_rate,
            number,
            ..
        } = *self;
        let first = &run.first;
        let count = geometric(run.ratio, number);
        let squares = geometric(run.ratio * run.ratio, number);
        let spin = first.after.theta_rate - first.before.theta_rate;
        sums.duration = sums.duration + run.duration * count;
        sums.normal = sums.normal + first.impulse.normal * count;
        sums.friction = sums.friction + first.impulse.friction * count;
        sums.normal_work = sums.normal_work + first.normal_work * squares;
        let slides = self.kind == Kind::Straight;
        sums.friction_work = sums.friction_work
            + if slides {
                first.impulse.friction * run.slipped(number)
            } else {
                first.friction_work * squares
            };
        sums.resistance_work = sums.resistance_work
            + match self.kind {
                Kind::Scaled => first.resistance_work * squares,
                // The rotation before each impact is a geometric sum, and changes in it in
                // proportion.
                Kind::Turning | Kind::Straight => {
                    let couple = -(rolling_resistance * first.impulse.normal)
                        * sign(theta_rate.value() + first.after.theta_rate.value());
                    let before = theta_rate * count + spin * run.weighted(number);
                    let within = first.resistance_work - couple * theta_rate;
                    couple * before + within * squares
                }
            };
    }
}

/// −1, 0 or 1.
fn sign(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}

impl<T: Number> Bounces<T> {
    pub(super) fn sum_resisted(
        &self,
        resisted: &ResistedContact<T>,
        start: ContactVelocities<T>,
        longest: f64,
    ) -> Result<Settling<T>, NoSettling> {
        let mut sums = Sums::<T>::new();
        let mut now = start;
        for bounce in 0..MAX_BOUNCES {
            if sums.duration.value() > longest {
                return Err(NoSettling::Unsettled { bounces: bounce });
            }
            let duration = self.flight(now.gap_rate);
            let before = self.landing(now, duration);
            if resisted.undecided(before, self.restitution).is_some() {
                return Err(NoSettling::Undecided);
            }
            let followed = resisted.impact(before, self.restitution);
            let first = followed.impact;
            let run = Run {
                slip: now.slip,
                duration,
                first,
                ratio: first.after.gap_rate / now.gap_rate,
            };
            let run = ResistedRun::new(run, now.theta_rate, &followed);
            let r = run.run.ratio.value();
            if !r.is_finite() {
                // Only the end of the rotation ends the impact.
                return Err(NoSettling::Grows {
                    ratio: f64::INFINITY,
                });
            }
            if run.number == f64::INFINITY && 1.0 - r <= RATIO_ROUNDING {
                return Err(NoSettling::Grows { ratio: r });
            }
            run.add_to(&mut sums, resisted.rolling_resistance());
            now = run.after();
            let left = now.gap_rate.value() / start.gap_rate.value();
            if left <= NEGLIGIBLE_RATE_RATIO {
                return Ok(self.settled(start, &sums, now, &run.run));
            }
            if left > 1.0 / f64::EPSILON {
                return Err(NoSettling::Grows { ratio: r });
            }
        }
        Err(NoSettling::Unsettled {
            bounces: MAX_BOUNCES,
        })
    }
}
