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
pub(super) const NEGLIGIBLE_RATE_RATIO: f64 = 1e-20;

/// Maximum number of bounces of changing kind, which are summed one by one.
pub(super) const MAX_BOUNCES: usize = 4096;

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
    /// Rounding decides on an impact ([`ImpactError::Undecided`](crate::impact::ImpactError::Undecided)).
    #[error("rounding decides between stick and slip in a bounce")]
    Undecided,
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
        let spin_of = |impact: &Impact| impact.after.theta_rate - impact.before.theta_rate;
        let (duration, spin) = (settling.duration, spin_of(&settling.impact));
        // A slow bounce can still change the velocities by a finite amount if its impact ends the
        // slip.
        let slip_change = settling.impact.after.slip - settling.impact.before.slip;
        if duration * pace > MAX_SETTLING_TIME
            || duration * (spin.abs() + slip_change.abs()) > MAX_SUM_ERROR
        {
            return None;
        }
        // The sum must not depend on whether θ and θ′ are those of the start, the middle or the
        // end.
        let holds = [0.5, 1.0].into_iter().all(|part| {
            let later = State {
                theta: state.theta + part * duration * state.theta_rate,
                theta_rate: state.theta_rate + part * spin,
                ..*state
            };
            // With rolling resistance the sum may depend on where the rotation ends.
            let from = if self.rolling_resistance() > 0.0 {
                state
            } else {
                &later
            };
            let start = ContactVelocities::of(from, gap_rate);
            let sum = Bounces::new(self, body, &later, restitution, 1.0)
                .and_then(|bounces| bounces.sum(start, 2.0 * MAX_SETTLING_TIME));
            sum.is_ok_and(|other| {
                let slip_error = other.impact.after.slip - settling.impact.after.slip;
                (other.duration - duration).abs() * pace <= MAX_SUM_ERROR
                    && (spin_of(&other.impact) - spin).abs() <= MAX_SUM_ERROR * pace
                    && slip_error.abs() <= MAX_SUM_ERROR * pace
            })
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
    pub(super) restitution: Restitution<T>,
    /// W = cos α − h cos θ θ′².
    contact_force: T,
    /// a = −h sin θ θ′² − sin α.
    slip_acceleration: T,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Sums<T> {
    pub(super) duration: T,
    pub(super) normal: T,
    pub(super) friction: T,
    pub(super) theta_rate: T,
    pub(super) normal_work: T,
    pub(super) friction_work: T,
    pub(super) resistance_work: T,
}

impl<T: Number> Sums<T> {
    pub(super) fn new() -> Self {
        let zero = T::constant(0.0);
        Self {
            duration: zero,
            normal: zero,
            friction: zero,
            theta_rate: zero,
            normal_work: zero,
            friction_work: zero,
            resistance_work: zero,
        }
    }

    /// Adds a run of `number` bounces, each as fast as the one before times `ratio`, from the first.
    fn add(&mut self, run: &Run<T>, number: f64) {
        let Run {
            ratio,
            duration,
            ref first,
            ..
        } = *run;
        // Velocities and impulses of a run are geometric sequences, and works those of squares.
        let count = geometric(ratio, number);
        let squares = geometric(ratio * ratio, number);
        let spin = first.after.theta_rate - first.before.theta_rate;
        self.duration = self.duration + duration * count;
        self.normal = self.normal + first.impulse.normal * count;
        self.friction = self.friction + first.impulse.friction * count;
        self.theta_rate = self.theta_rate + spin * count;
        self.normal_work = self.normal_work + first.normal_work * squares;
        self.friction_work = self.friction_work
            + if run.slides() {
                first.impulse.friction * run.slipped(number)
            } else {
                first.friction_work * squares
            };
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
        let (rate, gravity) = (conditions.theta_rate, conditions.gravity);
        let angle = conditions.theta.angle();
        let contact_force = contact(gravity, body.h, angle.cos * (rate * rate));
        if contact_force.value() <= 0.0 {
            return Err(NoSettling::LeavesPlane {
                contact: contact_force.value(),
            });
        }
        Ok(Self {
            contact: Contact::of(body, conditions.friction, angle),
            restitution: conditions.restitution,
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
        // The rates after the first underflow.
        let unit = start.unit_for(start.gap_rate.value());
        let Settling {
            duration,
            ratio,
            impact,
            ..
        } = self.sum_in_units(start.times(1.0 / unit), longest / unit)?;
        Ok(Settling {
            gap_rate: start.gap_rate,
            duration: duration * unit,
            ratio,
            impact: impact.of_units(impact.before.times(unit), unit),
        })
    }

    fn sum_in_units(
        &self,
        start: ContactVelocities<T>,
        longest: f64,
    ) -> Result<Settling<T>, NoSettling> {
        if let Some(resisted) = self.contact.resisted() {
            return self.sum_resisted(resisted, start, longest);
        }
        let mut sums = Sums::<T>::new();
        let (mut slip, mut opening) = (start.slip, start.gap_rate);
        for bounce in 0..MAX_BOUNCES {
            if sums.duration.value() > longest {
                return Err(NoSettling::Unsettled { bounces: bounce });
            }
            let run = self.run(start.theta_rate, slip, opening);
            if self
                .contact
                .undecided(&run.first, self.restitution)
                .is_some()
            {
                return Err(NoSettling::Undecided);
            }
            let r = run.ratio.value();
            let number = run.number();
            let shrinks = 1.0 - r > RATIO_ROUNDING;
            if number == f64::INFINITY && !shrinks {
                return Err(NoSettling::Grows { ratio: r });
            }
            sums.add(&run, number);
            slip = run.slip_after(number);
            let settled = |opening: T| {
                let after = ContactVelocities {
                    theta_rate: start.theta_rate + sums.theta_rate,
                    slip,
                    gap_rate: opening,
                };
                self.settled(start, &sums, after, &run)
            };
            if number == f64::INFINITY {
                return Ok(settled(T::constant(0.0)));
            }
            opening = if run.slides() {
                run.opening_after(opening, number)
            } else {
                run.first.after.gap_rate
            };
            if opening.value() <= NEGLIGIBLE_RATE_RATIO * start.gap_rate.value() {
                return Ok(settled(opening));
            }
            if opening.value() > start.gap_rate.value() / f64::EPSILON {
                return Err(NoSettling::Grows { ratio: r });
            }
        }
        Err(NoSettling::Unsettled {
            bounces: MAX_BOUNCES,
        })
    }

    /// The duration of a flight.
    pub(super) fn flight(&self, opening: T) -> T {
        opening * 2.0 / self.contact_force
    }

    /// The velocities after a flight.
    pub(super) fn landing(&self, now: ContactVelocities<T>, duration: T) -> ContactVelocities<T> {
        ContactVelocities {
            slip: now.slip + self.slip_acceleration * duration,
            gap_rate: -now.gap_rate,
            ..now
        }
    }

    /// The run of bounces that begins with a slip and a gap rate.
    fn run(&self, theta_rate: T, slip: T, opening: T) -> Run<T> {
        let now = ContactVelocities {
            theta_rate,
            slip,
            gap_rate: opening,
        };
        let duration = self.flight(opening);
        let before = self.landing(now, duration);
        let first = self.contact.impact(before, self.restitution);
        Run {
            slip,
            duration,
            ratio: first.after.gap_rate / opening,
            first,
        }
    }

    pub(super) fn settled(
        &self,
        start: ContactVelocities<T>,
        sums: &Sums<T>,
        after: ContactVelocities<T>,
        last: &Run<T>,
    ) -> Settling<T> {
        let before = ContactVelocities {
            theta_rate: start.theta_rate,
            slip: start.slip + self.slip_acceleration * sums.duration,
            gap_rate: start.gap_rate - self.contact_force * sums.duration,
        };
        let after = ContactVelocities {
            gap_rate: T::constant(0.0),
            ..after
        };
        let impact = Impact {
            case: last.first.case,
            before,
            after,
            impulse: Impulse {
                normal: sums.normal,
                friction: sums.friction,
            },
            normal_work: sums.normal_work,
            friction_work: sums.friction_work,
            resistance_work: sums.resistance_work,
        };
        Settling {
            gap_rate: start.gap_rate,
            duration: sums.duration,
            ratio: last.ratio,
            impact,
        }
    }
}

/// Whether a velocity is that before a bounce times the ratio.
pub(super) fn scales(before: f64, after: f64, ratio: f64) -> bool {
    (after - before * ratio).abs() <= REPETITION_TOLERANCE * before.abs() * ratio
}

/// 1 + r + r² + … with `count` terms.
pub(super) fn geometric<T: Number>(ratio: T, count: f64) -> T {
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

/// A run of bounces of one kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run<T> {
    /// Slip velocity s0 after the impact before the first.
    pub(super) slip: T,
    /// Duration of the first flight, and the impact that ends it.
    pub(super) duration: T,
    pub(super) first: Impact<T>,
    /// The ratio of successive gap rates.
    pub(super) ratio: T,
}

impl<T: Number> Run<T> {
    /// Whether the contact slips throughout. The slip velocity after the kth impact is then
    /// sₖ = s0 + (s1 − s0) gₖ, with the geometric sum gₖ of k terms.
    fn slides(&self) -> bool {
        self.first.case == ImpactCase::Slides
    }

    /// Whether all velocities of the next bounce are those of the first times the ratio.
    fn repeats(&self) -> bool {
        let [slip, after, ratio] = [self.slip, self.first.after.slip, self.ratio].map(T::value);
        scales(slip, after, ratio)
    }

    /// Number of bounces to add, including the first: all if infinitely many are of one kind;
    /// of those that slip about half, so that rounding does not pass the last.
    fn number(&self) -> f64 {
        if !self.slides() {
            return if self.repeats() { f64::INFINITY } else { 1.0 };
        }
        1.0 + (0.5 * self.until_stop()).floor()
    }

    /// The number of bounces of one kind until the slip velocity vanishes, before or after an
    /// impact.
    pub(super) fn until_stop(&self) -> f64 {
        let Impact { before, after, .. } = self.first;
        let [ratio, slip, before, after] =
            [self.ratio, self.slip, before.slip, after.slip].map(T::value);
        let change = after - slip;
        self.further(before, change - (1.0 - ratio) * (before - slip))
            .min(self.further(after, change * ratio))
    }

    /// The number of bounces until a velocity `now` + `change` gₖ vanishes.
    pub(super) fn further(&self, now: f64, change: f64) -> f64 {
        let ratio = self.ratio.value();
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
    }

    /// The gap rate after `number` bounces that begin with `opening`.
    pub(super) fn opening_after(&self, opening: T, number: f64) -> T {
        let r = self.ratio.value();
        let power = libm::pow(r, number);
        opening * self.ratio.map(power, number * power / r)
    }

    /// Slip velocity after `number` bounces.
    fn slip_after(&self, number: f64) -> T {
        let after = self.first.after.slip;
        if self.slides() {
            self.slip + (after - self.slip) * geometric(self.ratio, number)
        } else if number == f64::INFINITY {
            T::constant(0.0)
        } else {
            after
        }
    }

    /// The sum of the mean slip velocities in `number` impacts, each weighted with its impulse over
    /// the first.
    pub(super) fn slipped(&self, number: f64) -> T {
        let Self { ratio, slip, .. } = *self;
        let count = geometric(ratio, number);
        let change = self.first.after.slip - slip;
        slip * count
            + change * self.weighted(number)
            + (self.first.before.slip - slip + change) * 0.5 * geometric(ratio * ratio, number)
    }

    /// The sum of gₖ rᵏ over `number` bounces.
    pub(super) fn weighted(&self, number: f64) -> T {
        let ratio = self.ratio;
        let count = geometric(ratio, number);
        ratio / (ratio + 1.0) * count * geometric(ratio, number - 1.0)
    }
}
