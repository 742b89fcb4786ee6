//! How bounces come to an end: the rest of a sequence of ever smaller bounces, summed.
//!
//! Where W = 1 − h cos θ θ′² > 0 and each bounce gives back less than it takes, bounces accumulate: infinitely many in a
//! finite time. Once they are short, θ, W, the compliances of the impact and the acceleration a = −h sin θ θ′² of the slip in
//! flight hardly change any more. With those held fixed a flight of the rate v takes 2v/W and adds 2 a v/W to the slip, the
//! impact is homogeneous in (u, v), and the sum of all of them is found from a few: where it does the same each time, sticks,
//! reverses or slips on, it is geometric. What is neglected is of the order of the square of the time that is left.
//!
//! The ratio of the rates of successive bounces decides, not e. Where they slip it is e. Where they stick, a drives the slip of
//! each flight against sign B, so that k1 = C + μk |B| at first and k2 < k1 behind it: the ratio is then below e by the energetic
//! law and by Poisson's, also for e = 1, and e by Newton's. It is e for all of them without friction, and where B or a vanishes.
//! So bounces never grow for e < 1, as they do for other bodies near k1 = 0 (reverse chatter).

use thiserror::Error;

use crate::mechanics::{Contact, ContactVelocities, Impact, ImpactCase, Impulse, contact};
use crate::model::{Body, Heavy, Hoop, Restitution, State};

/// Bounces are followed one by one until those that remain take less than this, also in units of 1/|θ′|: its square is
/// the order of the error.
const LONGEST: f64 = 1e-7;

/// What the sum may be wrong by: in angle and position, in times and velocities in units of 1 + |θ′|.
const ERROR: f64 = 10.0 * LONGEST * LONGEST;

/// A ratio is the quotient of sums of a dozen products, all of one sign: so close to 1 it is not known to be less.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Slip velocities that are the same part of the rate of their bounces, but for this, repeat themselves.
const SAME_KIND: f64 = 1e-14;

/// Bounces slower than the first by this factor add nothing to the sums.
const NEGLIGIBLE: f64 = 1e-20;

/// Bounces of changing kind that are summed one by one.
const MAX_BOUNCES: usize = 4096;

/// The end of bouncing, from a flight on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settling {
    /// Rate of the gap with which the first flight begins.
    pub gap_rate: f64,
    /// Time from the start of the first flight.
    pub duration: f64,
    /// Ratio of the rates of successive bounces in the end: the effective coefficient of restitution.
    pub ratio: f64,
    /// All impacts together, as one at the end of the time; its case is that of each in the end.
    pub impact: Impact,
}

/// Why bounces do not settle.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NoSettling {
    /// A massless hoop has no impacts.
    #[error("a massless hoop has no impacts")]
    Massless,
    /// The gap does not open.
    #[error("gap_rate = {gap_rate} sqrt(g R) must be finite and greater than 0")]
    Closed {
        /// The gap rate that was given.
        gap_rate: f64,
    },
    /// 1 − h cos θ θ′² ≤ 0: the gap opens further by itself.
    #[error("1 - h cos(theta) theta'^2 = {contact} is not positive: the plane does not pull the rim back")]
    LeavesPlane {
        /// 1 − h cos θ θ′².
        contact: f64,
    },
    /// The bounces do not shrink, or not by more than rounding: e = 1 where they slip, without friction, and by Newton's law. With
    /// e < 1 that would be reverse chatter, by which a hoop at rest against the plane could as well begin to bounce; this body
    /// has none.
    #[error("each bounce is {ratio} times as fast as the one before")]
    Grows {
        /// Ratio of the rates of successive bounces.
        ratio: f64,
    },
    /// The bounces change their kind more often than are summed.
    #[error("the bounces have not taken one kind within {bounces}")]
    Unsettled {
        /// Number of bounces that were followed, many that slip alike at once.
        bounces: usize,
    },
}

impl Hoop {
    /// The sum of all bounces from a state on in which the gap opens at a small rate, with the angle and the rate held fixed.
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
    /// Says why they do not settle.
    pub fn settling(
        &self,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Result<Settling, NoSettling> {
        let Body::Heavy(body) = self.body() else { return Err(NoSettling::Massless) };
        if !(gap_rate.is_finite() && gap_rate > 0.0) {
            return Err(NoSettling::Closed { gap_rate });
        }
        Bounces::new(self, &body, state, restitution)?.sum(state, gap_rate, f64::INFINITY)
    }

    /// The same where the bounces that remain are short enough for it.
    #[inline]
    pub(crate) fn short_settling(
        &self,
        body: &Heavy,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Option<Settling> {
        // No sum is shorter than its first bounce, and W ≤ 1 + h θ′².
        if gap_rate > LONGEST * (1.0 + body.h * (state.theta_rate * state.theta_rate)) {
            return None;
        }
        let pace = 1.0 + state.theta_rate.abs();
        let bounces = Bounces::new(self, body, state, restitution).ok()?;
        if 2.0 * gap_rate / bounces.contact_force * pace > LONGEST {
            return None;
        }
        let settling = bounces.sum(state, gap_rate, LONGEST).ok()?;
        let Settling { duration, impact: Impact { before, after, .. }, .. } = settling;
        // An impact that ends the slip may change the velocities at once, however slow the bounce.
        let spin = after.theta_rate - before.theta_rate;
        if duration * pace > LONGEST || duration * (spin.abs() + (after.slip - before.slip).abs()) > ERROR {
            return None;
        }
        // The angle and the rate change on the way: with those of later on the sum is the same.
        let holds = [0.5, 1.0].into_iter().all(|part| {
            let theta = state.theta + part * duration * state.theta_rate;
            let later = State { theta, theta_rate: state.theta_rate + part * spin, ..*state };
            let sum = Bounces::new(self, body, &later, restitution)
                .and_then(|bounces| bounces.sum(&later, gap_rate, 2.0 * LONGEST));
            sum.is_ok_and(|Settling { duration: other, impact, .. }| {
                let other_spin = impact.after.theta_rate - impact.before.theta_rate;
                (other - duration).abs() * pace <= ERROR
                    && (other_spin - spin).abs() <= ERROR * pace
                    && (impact.after.slip - after.slip).abs() <= ERROR * pace
            })
        });
        holds.then_some(settling)
    }
}

/// Bounces at a fixed angle and rate.
struct Bounces {
    contact: Contact,
    restitution: Restitution,
    /// W = 1 − h cos θ θ′².
    contact_force: f64,
    /// a = −h sin θ θ′².
    slip_acceleration: f64,
}

/// Sums over bounces.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    duration: f64,
    normal: f64,
    friction: f64,
    theta_rate: f64,
    normal_work: f64,
    friction_work: f64,
}

impl Sums {
    /// Adds a bounce `times` over, its works `works` times.
    fn add(&mut self, duration: f64, impact: &Impact, times: f64, works: f64) {
        self.duration += duration * times;
        self.normal += impact.impulse.normal * times;
        self.friction += impact.impulse.friction * times;
        self.theta_rate += (impact.after.theta_rate - impact.before.theta_rate) * times;
        self.normal_work += impact.normal_work * works;
        self.friction_work += impact.friction_work * works;
    }
}

impl Bounces {
    fn new(hoop: &Hoop, body: &Heavy, state: &State, restitution: Restitution) -> Result<Self, NoSettling> {
        let (sin, cos) = libm::sincos(state.theta);
        let rate = state.theta_rate;
        let contact_force = contact(1.0, body.h, cos * (rate * rate));
        if contact_force <= 0.0 {
            return Err(NoSettling::LeavesPlane { contact: contact_force });
        }
        Ok(Self {
            contact: Contact::new(hoop, body, state.theta),
            restitution,
            contact_force,
            slip_acceleration: -body.h * sin * (rate * rate),
        })
    }

    /// The sum, or why there is none; of a sum that is longer than `longest` it need not be found out.
    fn sum(&self, state: &State, gap_rate: f64, longest: f64) -> Result<Settling, NoSettling> {
        let mut sums = Sums::default();
        let (mut slip, mut opening) = (state.slip, gap_rate);
        for bounce in 0..MAX_BOUNCES {
            if sums.duration > longest {
                return Err(NoSettling::Unsettled { bounces: bounce });
            }
            let duration = 2.0 * opening / self.contact_force;
            let before = ContactVelocities {
                theta_rate: state.theta_rate,
                slip: slip + self.slip_acceleration * duration,
                gap_rate: -opening,
            };
            let impact = self.contact.impact(before, self.restitution);
            let ratio = impact.after.gap_rate / opening;
            let shrinks = 1.0 - ratio > ROUNDING;
            // As long as the bounces do the same, everything changes from one to the next by this ratio.
            let repeats = (impact.after.slip - slip * ratio).abs() <= SAME_KIND * slip.abs() * ratio;
            if repeats && impact.case != ImpactCase::Slides {
                if !shrinks {
                    return Err(NoSettling::Grows { ratio });
                }
                let (count, squares) =
                    (geometric(ratio, f64::INFINITY), geometric(ratio * ratio, f64::INFINITY));
                sums.add(duration, &impact, count, squares);
                return Ok(self.settled((state, gap_rate), &sums, 0.0, (ratio, impact.case)));
            }
            if impact.case == ImpactCase::Slides {
                let slides = Slides { ratio, slip, before: before.slip, after: impact.after.slip };
                let number = slides.number();
                if number == f64::INFINITY && !shrinks {
                    return Err(NoSettling::Grows { ratio });
                }
                let (count, squares) = (geometric(ratio, number), geometric(ratio * ratio, number));
                sums.add(duration, &Impact { friction_work: 0.0, ..impact }, count, squares);
                sums.friction_work += impact.impulse.friction * slides.slipped(number);
                slip += (impact.after.slip - slip) * count;
                if number == f64::INFINITY {
                    return Ok(self.settled((state, gap_rate), &sums, slip, (ratio, impact.case)));
                }
                opening *= libm::pow(ratio, number);
            } else {
                sums.add(duration, &impact, 1.0, 1.0);
                (slip, opening) = (impact.after.slip, impact.after.gap_rate);
            }
            if opening <= NEGLIGIBLE * gap_rate {
                return Ok(self.settled((state, gap_rate), &sums, slip, (ratio, impact.case)));
            }
            if opening > gap_rate / f64::EPSILON {
                return Err(NoSettling::Grows { ratio });
            }
        }
        Err(NoSettling::Unsettled { bounces: MAX_BOUNCES })
    }

    fn settled(
        &self,
        (state, gap_rate): (&State, f64),
        sums: &Sums,
        slip: f64,
        (ratio, case): (f64, ImpactCase),
    ) -> Settling {
        let impulse = Impulse { normal: sums.normal, friction: sums.friction };
        let before = ContactVelocities {
            theta_rate: state.theta_rate,
            slip: state.slip + self.slip_acceleration * sums.duration,
            gap_rate: gap_rate - self.contact_force * sums.duration,
        };
        let after = ContactVelocities { theta_rate: state.theta_rate + sums.theta_rate, slip, gap_rate: 0.0 };
        let impact = Impact {
            case,
            before,
            after,
            impulse,
            normal_work: sums.normal_work,
            friction_work: sums.friction_work,
        };
        Settling { gap_rate, duration: sums.duration, ratio, impact }
    }
}

/// 1 + r + r² + …, so many terms.
fn geometric(ratio: f64, count: f64) -> f64 {
    if ratio == 1.0 || count <= 1.0 { count } else { libm::expm1(count * libm::log(ratio)) / (ratio - 1.0) }
}

/// Bounces that slip throughout, from one on: their slip velocities, behind one more and one more, are sₖ = s0 + (s1 − s0) gₖ with the
/// geometric sum gₖ.
#[derive(Clone, Copy, Debug)]
struct Slides {
    ratio: f64,
    /// After the impact before the first.
    slip: f64,
    /// Before and after the first.
    before: f64,
    after: f64,
}

impl Slides {
    /// Bounces that slip, this one among them: all, or about half of those that do, so that rounding does not lead past the last.
    fn number(&self) -> f64 {
        let Self { ratio, slip, before, after } = *self;
        // A slip velocity, and how it changes with gₖ.
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
        let most =
            further(before, change - (1.0 - ratio) * (before - slip)).min(further(after, change * ratio));
        1.0 + (0.5 * most).floor()
    }

    /// The sum of the mean slip velocities in so many impacts, each in units of its impulse.
    fn slipped(&self, number: f64) -> f64 {
        let Self { ratio, slip, before, after } = *self;
        let count = geometric(ratio, number);
        let change = after - slip;
        slip * count
            + change * (ratio / (1.0 + ratio) * count * geometric(ratio, number - 1.0))
            + 0.5 * (before - slip + change) * geometric(ratio * ratio, number)
    }
}
