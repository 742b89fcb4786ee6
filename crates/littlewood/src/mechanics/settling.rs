//! Settling: the sum of an infinite sequence of decaying bounces, or chatter
//! (docs/theory/impact.md).
//!
//! Where W = cos α − h cos θ θ′² > 0 and each bounce is slower than the previous one, infinitely
//! many bounces take a finite time. Once they are short, θ, W, the compliance and the slip
//! acceleration a = −h sin θ θ′² − sin α in flight are nearly constant. With these fixed, a flight
//! with initial gap rate v takes 2v/W and adds 2 a v/W to the slip, and bounces of one kind have a
//! geometric sum, with an error of the order of the square of the remaining time. The ratio of
//! successive gap rates decides, not e.

use thiserror::Error;

use crate::math::number::Number;
use crate::mechanics::{Contact, ContactVelocities, Impact, ImpactCase, Impulse, contact};
use crate::model::{Body, Friction, Heavy, Hoop, Restitution, State};

/// Longest time summed with fixed coefficients, also in units of 1/|θ′|. The error is of the order
/// of its square.
const MAX_SETTLING_TIME: f64 = 1e-7;

/// Largest error of the sum: in angle and position, and in times and velocities in units of 1 +
/// |θ′|.
const MAX_SUM_ERROR: f64 = 10.0 * MAX_SETTLING_TIME * MAX_SETTLING_TIME;

/// Rounding error of a ratio, a quotient of sums of a dozen products of one sign.
pub(super) const RATIO_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Relative tolerance for equal ratios of slip velocity to gap rate in successive bounces.
const REPETITION_TOLERANCE: f64 = 1e-14;

/// Gap rate, over the first, below which bounces do not change the sums: 1e-20 is far below ε.
const NEGLIGIBLE_RATE_RATIO: f64 = 1e-20;

/// Maximum number of bounces of changing kind, which are summed one by one.
const MAX_BOUNCES: usize = 4096;

/// The sum of all bounces from a flight on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settling<T = f64> {
    /// Gap rate at the start of the first flight.
    pub gap_rate: T,
    /// Total time of the flights.
    pub duration: T,
    /// Limit of the ratio of successive gap rates: the effective coefficient of restitution.
    pub ratio: T,
    /// All impacts combined into one at the end of the time, with the case of the last ones.
    pub impact: Impact<T>,
}

/// Reason why bounces do not settle.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum NoSettling {
    /// A massless hoop has no impacts.
    #[error("a massless hoop has no impacts")]
    Massless,
    /// The gap does not open.
    #[error("gap_rate = {gap_rate} sqrt(g R) must be finite and greater than 0")]
    Closed { gap_rate: f64 },
    /// 1 − h cos θ θ′² ≤ 0: the gap grows without an impact.
    #[error("1 - h cos(theta) theta'^2 = {contact} is not positive: the gap does not close again")]
    LeavesPlane { contact: f64 },
    /// The bounces do not decay by more than rounding: e = 1 in slip, without friction, or by
    /// Newton's law; or they grow, on a slope ([reverse
    /// chatter](crate::theory::PhasePlane::reverse_chatter)).
    #[error("each bounce is {ratio} times as fast as the one before")]
    Grows { ratio: f64 },
    /// The bounces did not take one kind within the maximum number, in which a run of bounces that
    /// slip counts as one.
    #[error("the kind of the bounces still changes after {bounces}")]
    Unsettled { bounces: usize },
}

impl Hoop {
    /// The sum of all bounces from a state with a small positive gap rate, at fixed θ and θ′.
    ///
    /// ```
    /// use littlewood::{Hoop, Restitution, RestitutionLaw, Start};
    ///
    /// // A balanced hoop bounces like a ball: 2v/(1 − e).
    /// let hoop = Hoop::new(littlewood::HoopParameters::thin(1.0).with_offset(0.0))?;
    /// let settling = hoop.settling(
    ///     &Start::at(0.0, 0.0).check()?,
    ///     1e-9,
    ///     Restitution::new(0.5, RestitutionLaw::Energetic)?,
    /// )?;
    /// assert!((settling.duration - 4e-9).abs() < 1e-24);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The reason why the bounces do not settle.
    pub fn settling(
        &self,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Result<Settling, NoSettling> {
        let Body::Heavy(body) = self.body() else {
            return Err(NoSettling::Massless);
        };
        if !(gap_rate.is_finite() && gap_rate > 0.0) {
            return Err(NoSettling::Closed { gap_rate });
        }
        let gravity = libm::cos(self.slope());
        Bounces::new(self, &body, state, restitution, gravity)?
            .sum(ContactVelocities::of(state, gap_rate), f64::INFINITY)
    }

    /// [`Hoop::settling`], if the remaining bounces are short enough for fixed coefficients.
    #[inline]
    pub(crate) fn short_settling(
        &self,
        body: &Heavy,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Option<Settling> {
        // No sum is shorter than its first bounce, and W ≤ 1 + h θ′².
        if gap_rate > MAX_SETTLING_TIME * (1.0 + body.h * (state.theta_rate * state.theta_rate)) {
            return None;
        }
        let pace = 1.0 + state.theta_rate.abs();
        let bounces = Bounces::new(self, body, state, restitution, 1.0).ok()?;
        if 2.0 * gap_rate / bounces.contact_force * pace > MAX_SETTLING_TIME {
            return None;
        }
        let settling = bounces
            .sum(ContactVelocities::of(state, gap_rate), MAX_SETTLING_TIME)
            .ok()?;
        let Settling {
            duration,
            impact: Impact { before, after, .. },
            ..
        } = settling;
        // A slow bounce can still change the velocities by a finite amount if its impact ends the
        // slip.
        let spin = after.theta_rate - before.theta_rate;
        if duration * pace > MAX_SETTLING_TIME
            || duration * (spin.abs() + (after.slip - before.slip).abs()) > MAX_SUM_ERROR
        {
            return None;
        }
        // The sum must not depend on whether θ and θ′ are those of the start, the middle or the
        // end.
        let holds = [0.5, 1.0].into_iter().all(|part| {
            let theta = state.theta + part * duration * state.theta_rate;
            let later = State {
                theta,
                theta_rate: state.theta_rate + part * spin,
                ..*state
            };
            let sum = Bounces::new(self, body, &later, restitution, 1.0).and_then(|bounces| {
                bounces.sum(
                    ContactVelocities::of(&later, gap_rate),
                    2.0 * MAX_SETTLING_TIME,
                )
            });
            sum.is_ok_and(
                |Settling {
                     duration: other,
                     impact,
                     ..
                 }| {
                    let other_spin = impact.after.theta_rate - impact.before.theta_rate;
                    (other - duration).abs() * pace <= MAX_SUM_ERROR
                        && (other_spin - spin).abs() <= MAX_SUM_ERROR * pace
                        && (impact.after.slip - after.slip).abs() <= MAX_SUM_ERROR * pace
                },
            )
        });
        holds.then_some(settling)
    }
}

/// What stays fixed in all bounces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BounceConditions<T = f64> {
    pub(crate) theta: T,
    pub(crate) theta_rate: T,
    pub(crate) friction: Friction<T>,
    pub(crate) restitution: Restitution<T>,
    /// Gravity normal to the plane: cos α for users, 1 for the solvers.
    pub(crate) gravity: f64,
}

/// Bounces at a fixed angle and rate.
pub(crate) struct Bounces<T = f64> {
    contact: Contact<T>,
    restitution: Restitution<T>,
    /// W = cos α − h cos θ θ′².
    contact_force: T,
    /// a = −h sin θ θ′² − sin α.
    slip_acceleration: T,
}

#[derive(Clone, Copy, Debug)]
struct Sums<T> {
    duration: T,
    normal: T,
    friction: T,
    theta_rate: T,
    normal_work: T,
    friction_work: T,
}

impl<T: Number> Sums<T> {
    fn new() -> Self {
        let zero = T::constant(0.0);
        Self {
            duration: zero,
            normal: zero,
            friction: zero,
            theta_rate: zero,
            normal_work: zero,
            friction_work: zero,
        }
    }

    /// Adds `times` a bounce, and `works` times its work.
    fn add(&mut self, duration: T, impact: &Impact<T>, times: T, works: T) {
        self.duration = self.duration + duration * times;
        self.normal = self.normal + impact.impulse.normal * times;
        self.friction = self.friction + impact.impulse.friction * times;
        self.theta_rate =
            self.theta_rate + (impact.after.theta_rate - impact.before.theta_rate) * times;
        self.normal_work = self.normal_work + impact.normal_work * works;
        self.friction_work = self.friction_work + impact.friction_work * works;
    }
}

impl Bounces {
    fn new(
        hoop: &Hoop,
        body: &Heavy,
        state: &State,
        restitution: Restitution,
        gravity: f64,
    ) -> Result<Self, NoSettling> {
        let conditions = BounceConditions {
            theta: state.theta,
            theta_rate: state.theta_rate,
            friction: hoop.friction(),
            restitution,
            gravity,
        };
        Self::of(body, conditions)
    }
}

impl<T: Number> Bounces<T> {
    pub(crate) fn of(body: &Heavy<T>, conditions: BounceConditions<T>) -> Result<Self, NoSettling> {
        let BounceConditions {
            theta,
            theta_rate: rate,
            friction,
            restitution,
            gravity,
        } = conditions;
        let angle = theta.angle();
        let contact_force = contact(gravity, body.h, angle.cos * (rate * rate));
        if contact_force.value() <= 0.0 {
            return Err(NoSettling::LeavesPlane {
                contact: contact_force.value(),
            });
        }
        Ok(Self {
            contact: Contact::of(body, friction, angle),
            restitution,
            contact_force,
            slip_acceleration: -body.h * angle.sin * (rate * rate) - body.pull() * gravity,
        })
    }

    /// The sum of all bounces from θ′, η′ and a gap rate. A sum longer than `longest` may return
    /// [`NoSettling::Unsettled`].
    pub(crate) fn sum(
        &self,
        start: ContactVelocities<T>,
        longest: f64,
    ) -> Result<Settling<T>, NoSettling> {
        let mut sums = Sums::<T>::new();
        let one = T::constant(1.0);
        let (mut slip, mut opening) = (start.slip, start.gap_rate);
        for bounce in 0..MAX_BOUNCES {
            if sums.duration.value() > longest {
                return Err(NoSettling::Unsettled { bounces: bounce });
            }
            let duration = opening * 2.0 / self.contact_force;
            let before = ContactVelocities {
                theta_rate: start.theta_rate,
                slip: slip + self.slip_acceleration * duration,
                gap_rate: -opening,
            };
            let impact = self.contact.impact(before, self.restitution);
            let ratio = impact.after.gap_rate / opening;
            let (r, now) = (ratio.value(), slip.value());
            let shrinks = 1.0 - r > RATIO_ROUNDING;
            // All velocities of a repeating bounce scale with this ratio.
            let repeats =
                (impact.after.slip.value() - now * r).abs() <= REPETITION_TOLERANCE * now.abs() * r;
            if repeats && impact.case != ImpactCase::Slides {
                if !shrinks {
                    return Err(NoSettling::Grows { ratio: r });
                }
                let (count, squares) = (
                    geometric(ratio, f64::INFINITY),
                    geometric(ratio * ratio, f64::INFINITY),
                );
                sums.add(duration, &impact, count, squares);
                return Ok(self.settled(start, &sums, T::constant(0.0), (ratio, impact.case)));
            }
            if impact.case == ImpactCase::Slides {
                let slides = Slides {
                    ratio,
                    slip,
                    before: before.slip,
                    after: impact.after.slip,
                };
                let number = slides.number();
                if number == f64::INFINITY && !shrinks {
                    return Err(NoSettling::Grows { ratio: r });
                }
                let (count, squares) = (geometric(ratio, number), geometric(ratio * ratio, number));
                sums.add(
                    duration,
                    &Impact {
                        friction_work: T::constant(0.0),
                        ..impact
                    },
                    count,
                    squares,
                );
                sums.friction_work =
                    sums.friction_work + impact.impulse.friction * slides.slipped(number);
                slip = slip + (impact.after.slip - slip) * count;
                if number == f64::INFINITY {
                    return Ok(self.settled(start, &sums, slip, (ratio, impact.case)));
                }
                let power = libm::pow(r, number);
                opening = opening * ratio.map(power, number * power / r);
            } else {
                sums.add(duration, &impact, one, one);
                (slip, opening) = (impact.after.slip, impact.after.gap_rate);
            }
            if opening.value() <= NEGLIGIBLE_RATE_RATIO * start.gap_rate.value() {
                return Ok(self.settled(start, &sums, slip, (ratio, impact.case)));
            }
            if opening.value() > start.gap_rate.value() / f64::EPSILON {
                return Err(NoSettling::Grows { ratio: r });
            }
        }
        Err(NoSettling::Unsettled {
            bounces: MAX_BOUNCES,
        })
    }

    fn settled(
        &self,
        start: ContactVelocities<T>,
        sums: &Sums<T>,
        slip: T,
        (ratio, case): (T, ImpactCase),
    ) -> Settling<T> {
        let impulse = Impulse {
            normal: sums.normal,
            friction: sums.friction,
        };
        let before = ContactVelocities {
            theta_rate: start.theta_rate,
            slip: start.slip + self.slip_acceleration * sums.duration,
            gap_rate: start.gap_rate - self.contact_force * sums.duration,
        };
        let theta_rate = start.theta_rate + sums.theta_rate;
        let after = ContactVelocities {
            theta_rate,
            slip,
            gap_rate: T::constant(0.0),
        };
        let impact = Impact {
            case,
            before,
            after,
            impulse,
            normal_work: sums.normal_work,
            friction_work: sums.friction_work,
        };
        Settling {
            gap_rate: start.gap_rate,
            duration: sums.duration,
            ratio,
            impact,
        }
    }
}

/// 1 + r + r² + … with `count` terms.
fn geometric<T: Number>(ratio: T, count: f64) -> T {
    let r = ratio.value();
    if r == 1.0 || count <= 1.0 {
        // The derivative of the sum at r = 1 is that of its terms.
        let slope = if count <= 1.0 {
            0.0
        } else {
            0.5 * count * (count - 1.0)
        };
        return ratio.map(count, slope);
    }
    let power = libm::expm1(count * libm::log(r));
    let sum = power / (r - 1.0);
    let last = if count == f64::INFINITY {
        0.0
    } else {
        count * (power + 1.0) / r
    };
    ratio.map(sum, (last - sum) / (r - 1.0))
}

/// A run of bounces that slip throughout. The slip velocity after the kth is sₖ = s0 + (s1 − s0)
/// gₖ, with the geometric sum gₖ of k terms.
#[derive(Clone, Copy, Debug)]
struct Slides<T> {
    ratio: T,
    /// Slip velocity s0 after the impact before the first.
    slip: T,
    /// Slip velocities before and after the first impact.
    before: T,
    after: T,
}

impl<T: Number> Slides<T> {
    /// Number of bounces to add, including the first: all if infinitely many slip, otherwise about
    /// half of those that do, so that rounding does not pass the last.
    fn number(&self) -> f64 {
        let [ratio, slip, before, after] =
            [self.ratio, self.slip, self.before, self.after].map(T::value);
        // The number of bounces until the slip velocity `now` + `change` gₖ vanishes.
        let further = |now: f64, change: f64| {
            let until = -now / change;
            if now == 0.0 {
                0.0
            } else if until <= 0.0 || (1.0 - ratio) * until >= 1.0 {
                f64::INFINITY
            } else if ratio == 1.0 {
                until
            } else {
                libm::log1p(-(1.0 - ratio) * until) / libm::log(ratio)
            }
        };
        let change = after - slip;
        let most = further(before, change - (1.0 - ratio) * (before - slip))
            .min(further(after, change * ratio));
        1.0 + (0.5 * most).floor()
    }

    /// The sum of the mean slip velocities in `number` impacts, each weighted with its impulse over
    /// the first.
    fn slipped(&self, number: f64) -> T {
        let Self {
            ratio,
            slip,
            before,
            after,
        } = *self;
        let count = geometric(ratio, number);
        let change = after - slip;
        slip * count
            + change * (ratio / (ratio + 1.0) * count * geometric(ratio, number - 1.0))
            + (before - slip + change) * 0.5 * geometric(ratio * ratio, number)
    }
}
