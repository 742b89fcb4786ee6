//! Impacts with rolling resistance (docs/theory/rolling-resistance.md#impacts).
//!
//! With a = h sin θ, d = 1 + h cos θ and J = Î + m d², the couple −ς χ P against the rotation keeps
//! an impact piecewise linear in the normal impulse P. A segment ends where its slip or its
//! rotation does, and what is at rest stays so while its friction can hold it:
//!
//! | segment | if | dθ′/dP | du/dP | dw/dP |
//! |---|---|---|---|---|
//! | slips, turns: q = a − σ μk d − ς χ | | q/Î | −σ μk/m + d q/Î | 1/m + a q/Î |
//! | sticks, turns | m d \|a − ς χ\| ≤ μs J | (a − ς χ)/J | 0 | Dχ/(m J) |
//! | slips, holds | \|a − σ μk d\| ≤ χ | 0 | −σ μk/m | 1/m |
//! | sticks, holds | \|a\| ≤ χ | 0 | 0 | 1/m |
//!
//! There are at most four segments, and dw/dP ≥ 1/m in one that does not end, so that each impact
//! ends.

use crate::math::bounded::Bounded;
use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::impact::{
    ContactVelocities, Impact, ImpactCase, ImpactVertex, Impulse, Slope, Sticking,
};
use crate::model::{
    Friction, Heavy, Margin, Restitution, RestitutionLaw, RotationDirection, SlipDirection,
    Undecided,
};

/// Most pieces of an impact: its segments are cut where the gap rate vanishes, which it does at
/// most three times, and where the impact ends.
const MOST_PIECES: usize = 10;

/// The coefficients of an impact at one angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ResistedContact<T = f64> {
    mass: T,
    inertia: T,
    /// a and d, from the contact point to the mass centre.
    arm: T,
    height: T,
    friction: Friction<T>,
    /// 1 + h |cos θ|, the sum of the sizes of the terms of d.
    reach: f64,
}

/// A stretch of an impact in which slip and rotation keep their signs.
#[derive(Clone, Copy, Debug)]
struct Segment<T> {
    slip: Option<SlipDirection>,
    rotation: Option<RotationDirection>,
    slope: Slope<T>,
    /// The couple of a unit of the normal impulse.
    couple: T,
}

/// The impulses at which slip and rotation of a segment end; infinite if they do not.
#[derive(Clone, Copy, Debug)]
struct Ends<T> {
    slip: T,
    rotation: T,
}

impl<T: Number> Ends<T> {
    /// What is left after an impulse within the segment.
    fn after(self, impulse: T) -> Self {
        let left = |length: T| {
            let left = length - impulse;
            if left.value() < 0.0 {
                T::constant(0.0)
            } else {
                left
            }
        };
        Self {
            slip: left(self.slip),
            rotation: left(self.rotation),
        }
    }

    fn first(&self) -> T {
        if self.slip.value() <= self.rotation.value() {
            self.slip
        } else {
            self.rotation
        }
    }
}

impl<T: Number> Segment<T> {
    fn ends(&self, now: &ContactVelocities<T>) -> Ends<T> {
        let until = |velocity: T, slope: T| {
            let [now, change] = [velocity, slope].map(|it| SlipDirection::of_sign(it.value()));
            if now.is_some() && now.map(SlipDirection::reversed) == change {
                velocity.abs() / slope.abs()
            } else {
                T::constant(f64::INFINITY)
            }
        };
        Ends {
            slip: until(now.slip, self.slope.slip),
            rotation: until(now.theta_rate, self.slope.spin),
        }
    }

    /// The velocities after an impulse. Rounding does not reverse what has all but stopped.
    fn after(&self, now: &ContactVelocities<T>, impulse: T) -> ContactVelocities<T> {
        let on = |velocity: T, slope: T, sign: f64| {
            let next = velocity + slope * impulse;
            if next.value() * sign < 0.0 {
                T::constant(0.0)
            } else {
                next
            }
        };
        let turns = self.rotation.map_or(0.0, RotationDirection::sign);
        let slips = self.slip.map_or(0.0, SlipDirection::sign);
        ContactVelocities {
            theta_rate: on(now.theta_rate, self.slope.spin, turns),
            slip: on(now.slip, self.slope.slip, slips),
            gap_rate: now.gap_rate + self.slope.gap_rate * impulse,
        }
    }
}

/// An impact, and which of its velocities have ended on the way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Followed<T> {
    pub(super) impact: Impact<T>,
    /// Whether it has one segment.
    pub(super) is_straight: bool,
    /// Whether the hoop turns in one direction from the start to the end.
    pub(super) turns_on: bool,
}

impl<T: Number> Followed<T> {
    fn of_units(self, before: ContactVelocities<T>, unit: f64) -> Self {
        let mut impact = self.impact.of_units(before, unit);
        let rate = self.impact.after.theta_rate.value();
        if rate != 0.0 && impact.after.theta_rate.value() == 0.0 {
            // The hoop turns, and may not stop by underflow.
            let least = f64::from_bits(1).copysign(rate);
            impact.after.theta_rate = impact.after.theta_rate.map(least, 1.0);
        }
        Self { impact, ..self }
    }
}

impl ResistedContact {
    /// Where the segments of an impact end, up to a normal impulse.
    pub(super) fn bends(&self, before: ContactVelocities, most: f64) -> Vec<ImpactVertex> {
        let (mut now, mut bends) = (before, Vec::new());
        let (mut normal, mut friction) = (0.0, 0.0);
        for _ in 0..MOST_PIECES {
            let segment = self.segment(&now, &mut |_, _| ());
            let ends = segment.ends(&now);
            let length = ends.first();
            normal += length;
            friction += segment.slope.friction * length;
            if normal >= most || normal.is_nan() {
                break;
            }
            now = stop(segment.after(&now, length), &ends);
            bends.push(ImpactVertex {
                impulse: Impulse { normal, friction },
                velocities: now,
            });
        }
        bends
    }

    /// [`Contact::sticking`](crate::mechanics::Contact::sticking).
    pub(super) fn sticking(
        &self,
        direction: SlipDirection,
        rotation: RotationDirection,
    ) -> Option<Sticking> {
        let slides = self.slides(direction, rotation).slope;
        let then = self.without_slip(rotation, &mut |_, _| ());
        let braking = -direction.sign() * slides.slip;
        let opens = then.slope.gap_rate > 0.0;
        (braking > 0.0 && then.slip.is_none() && opens).then_some(Sticking {
            in_slip: slides.gap_rate,
            in_stick: then.slope.gap_rate,
            braking,
        })
    }
}

impl<T: Number> ResistedContact<T> {
    /// The contact of a body at an angle; `None` without rolling resistance, if there is no
    /// derivative by it.
    pub(super) fn new(body: &Heavy<T>, friction: Friction<T>, angle: Angle<T>) -> Option<Self> {
        let level = body.h * angle.cos;
        (!friction.rolling_resistance.vanishes()).then(|| Self {
            mass: body.mass,
            inertia: body.inertia,
            arm: body.h * angle.sin,
            height: level + 1.0,
            friction,
            reach: 1.0 + level.value().abs(),
        })
    }

    /// J.
    fn about_contact(&self) -> T {
        self.inertia + self.mass * self.height * self.height
    }

    /// The same contact with bounds of its rounding.
    fn bounded(&self) -> ResistedContact<Bounded> {
        let rounded = |number: T, roundings: f64, size: f64| Bounded {
            value: number.value(),
            bound: 0.5 * f64::EPSILON * roundings * size,
        };
        let own = |number: T, roundings: f64| rounded(number, roundings, number.value().abs());
        let exact = |number: T| Bounded::constant(number.value());
        let Friction {
            mu_s,
            mu_k,
            rolling_resistance,
        } = self.friction;
        // 1 of m, 5 of Î, 2 of h and 2 of its factor, 1 of their product and 1 of the sum.
        ResistedContact {
            mass: own(self.mass, 1.0),
            inertia: own(self.inertia, 5.0),
            arm: own(self.arm, 5.0),
            height: rounded(self.height, 6.0, self.reach),
            friction: Friction {
                mu_s: exact(mu_s),
                mu_k: exact(mu_k),
                rolling_resistance: exact(rolling_resistance),
            },
            reach: self.reach,
        }
    }

    pub(super) const fn rolling_resistance(&self) -> T {
        self.friction.rolling_resistance
    }

    fn segment(&self, now: &ContactVelocities<T>, watch: &mut impl FnMut(Margin, T)) -> Segment<T> {
        let slip = SlipDirection::of_sign(now.slip.value());
        let rotation = RotationDirection::of_sign(now.theta_rate.value());
        let push = match slip {
            Some(slip) => self.arm - self.friction.mu_k * self.height * slip.sign(),
            None => self.arm,
        };
        // The couple holds the angle where it can.
        let turns = rotation.or_else(|| {
            let resistance = self.friction.rolling_resistance.value();
            RotationDirection::of_sign(push.value()).filter(|_| push.value().abs() > resistance)
        });
        match (slip, turns) {
            (_, None) => self.holds(slip, push),
            (Some(slip), Some(rotation)) => self.slides(slip, rotation),
            (None, Some(rotation)) => self.without_slip(rotation, watch),
        }
    }

    /// a − ς χ, the arm of the normal impulse with its couple.
    fn arm_of(&self, rotation: RotationDirection) -> T {
        self.arm - self.friction.rolling_resistance * rotation.sign()
    }

    /// The velocities as soon as the contact holds what it holds from the start: what is zero there
    /// may have derivatives, which friction and the couple take up at once.
    fn held(&self, now: ContactVelocities<T>, first: &Segment<T>) -> ContactVelocities<T> {
        let zero = T::constant(0.0);
        let turned = match (first.slip, first.rotation) {
            (Some(_), Some(_)) => return now,
            (_, None) => zero - now.theta_rate,
            (None, Some(_)) => zero - self.mass * self.height * now.slip / self.about_contact(),
        };
        ContactVelocities {
            theta_rate: now.theta_rate + turned,
            slip: match first.slip {
                Some(_) => now.slip + self.height * turned,
                None => zero,
            },
            gap_rate: now.gap_rate + self.arm * turned,
        }
    }

    fn couple(&self, rotation: RotationDirection) -> T {
        -(self.friction.rolling_resistance * rotation.sign())
    }

    fn slides(&self, slip: SlipDirection, rotation: RotationDirection) -> Segment<T> {
        let friction = -(self.friction.mu_k * slip.sign());
        let spin = (self.arm_of(rotation) + friction * self.height) / self.inertia;
        Segment {
            slip: Some(slip),
            rotation: Some(rotation),
            slope: Slope {
                friction,
                spin,
                slip: friction / self.mass + self.height * spin,
                gap_rate: T::constant(1.0) / self.mass + self.arm * spin,
            },
            couple: self.couple(rotation),
        }
    }

    /// Without slip while the hoop turns: it sticks while static friction can hold it.
    fn without_slip(
        &self,
        rotation: RotationDirection,
        watch: &mut impl FnMut(Margin, T),
    ) -> Segment<T> {
        let Friction { mu_s, mu_k, .. } = self.friction;
        let spin = self.arm_of(rotation) / self.about_contact();
        let friction = -(self.mass * self.height * spin);
        let excess = friction.abs() - mu_s;
        if mu_k.value() < mu_s.value() {
            watch(Margin::ImpactFriction, excess);
        }
        let reversed = SlipDirection::of_sign(-friction.value()).filter(|_| excess.value() > 0.0);
        if let Some(slip) = reversed {
            return self.slides(slip, rotation);
        }
        Segment {
            slip: None,
            rotation: Some(rotation),
            slope: Slope {
                friction,
                spin,
                slip: T::constant(0.0),
                gap_rate: T::constant(1.0) / self.mass + self.arm * spin,
            },
            couple: self.couple(rotation),
        }
    }

    /// Without rotation, from the arm of the impulses.
    fn holds(&self, slip: Option<SlipDirection>, push: T) -> Segment<T> {
        let zero = T::constant(0.0);
        let friction = slip.map_or(zero, |slip| -(self.friction.mu_k * slip.sign()));
        Segment {
            slip,
            rotation: None,
            slope: Slope {
                friction,
                spin: zero,
                slip: friction / self.mass,
                gap_rate: T::constant(1.0) / self.mass,
            },
            couple: -push,
        }
    }

    /// P of a slide, or Dχ, of which the gap rate of a segment has the sign.
    fn solvability(&self, segment: &Segment<T>) -> Option<(Margin, T)> {
        segment.rotation?;
        let slope = segment.slope.gap_rate * self.mass;
        Some(match segment.slip {
            Some(_) => (Margin::Painleve, slope * self.inertia),
            None => (Margin::ResistedDenominator, slope * self.about_contact()),
        })
    }

    /// Whether the impact depends on which of slip and rotation ends first: where both end
    /// together, at rest, a hoop begins to roll or to slip towards a by which friction it meets,
    /// the static one or the kinetic one.
    fn order_matters(&self, first: &Segment<T>) -> bool {
        let Friction {
            mu_s,
            mu_k,
            rolling_resistance,
        } = self.friction;
        let arm = self.arm.value();
        let sign = RotationDirection::of_sign(arm).map(RotationDirection::sign);
        let against = first.slip.map(SlipDirection::sign);
        let turns = first.rotation.map(RotationDirection::sign);
        let (lever, holds) = (
            (self.mass * self.height).value(),
            self.about_contact().value(),
        );
        let [weak, strong] =
            [-1.0, 1.0].map(|part| lever * (arm.abs() + part * rolling_resistance.value()));
        let [kinetic, limit] = [mu_k, mu_s].map(|mu| mu.value() * holds);
        against == turns
            && against == sign.map(|sign| -sign)
            && kinetic < weak
            && weak <= limit
            && limit < strong
    }

    /// The impact with these velocities, for a gap rate ≤ 0.
    pub(super) fn impact(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
    ) -> Followed<T> {
        self.watched(before, restitution, &mut |_, _| ())
    }

    fn watched(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
        watch: &mut impl FnMut(Margin, T),
    ) -> Followed<T> {
        let first = self.segment(&before, watch);
        if before.gap_rate.value() == 0.0 {
            if let Some((margin, number)) = self.solvability(&first) {
                watch(margin, number);
            }
            if first.slope.gap_rate.value() > 0.0 {
                return Followed {
                    impact: Impact::none(before),
                    is_straight: true,
                    turns_on: first.rotation.is_some(),
                };
            }
        }
        self.collide(before, first, restitution, watch)
    }

    /// The impact without collision of a hoop that presses, but which no motion keeps on the plane:
    /// where a normal impulse closes the gap. `None` where it opens it. Where a slide has reached P
    /// = 0, rounding may make P positive; it is set to zero.
    pub(super) fn jam(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
        watch: &mut impl FnMut(Margin, T),
    ) -> Option<Impact<T>> {
        let mut first = self.segment(&before, watch);
        if first.slope.gap_rate.value() > 0.0 {
            let slides = before.slip.value() != 0.0 && before.theta_rate.value() != 0.0;
            if !slides {
                return None;
            }
            let spin = T::constant(-1.0) / (self.mass * self.arm);
            first.slope = Slope {
                spin,
                slip: first.slope.friction / self.mass + self.height * spin,
                gap_rate: T::constant(0.0),
                ..first.slope
            };
        }
        Some(self.collide(before, first, restitution, watch).impact)
    }

    /// The number that decides on an impact, where its sign is rounding and the impacts to both
    /// sides of the tie differ.
    pub(super) fn undecided(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
    ) -> Option<Undecided> {
        first_tie(|mut watch| {
            let (before, restitution) = bounded(&before, &restitution);
            self.bounded().watched(before, restitution, &mut watch);
        })
    }

    /// The same of a jam.
    pub(super) fn undecided_jam(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
    ) -> Option<Undecided> {
        first_tie(|mut watch| {
            let (before, restitution) = bounded(&before, &restitution);
            self.bounded().jam(before, restitution, &mut watch);
        })
    }

    /// The impact from its first segment on, in units in which no square of a velocity that counts
    /// underflows or overflows. The impulse is in proportion to the closing rate, or, where pressing
    /// closes the gap, to the slip or the rotation that has to end first: these overflow in units
    /// that are too small.
    fn collide(
        &self,
        before: ContactVelocities<T>,
        first: Segment<T>,
        restitution: Restitution<T>,
        watch: &mut impl FnMut(Margin, T),
    ) -> Followed<T> {
        let mut sizes =
            [before.gap_rate, before.slip, before.theta_rate].map(|it| it.value().abs());
        sizes.sort_by(f64::total_cmp);
        let mut units = sizes
            .into_iter()
            .filter(|size| *size > 0.0)
            .map(|size| before.unit_for(size));
        let mut unit = units.next().unwrap_or(1.0);
        loop {
            let start = before.times(1.0 / unit);
            let found = Course::new(self, start, first, restitution)
                .follow(watch)
                .of_units(before, unit);
            match units.find(|other| *other != unit) {
                Some(other) if !found.impact.is_finite() => unit = other,
                Some(_) | None => return found,
            }
        }
    }
}

/// The velocities at the end of a segment: what ends is zero.
fn stop<T: Number>(now: ContactVelocities<T>, ends: &Ends<T>) -> ContactVelocities<T> {
    let length = ends.first().value();
    let zero = T::constant(0.0);
    ContactVelocities {
        theta_rate: if ends.rotation.value() <= length {
            zero
        } else {
            now.theta_rate
        },
        slip: if ends.slip.value() <= length {
            zero
        } else {
            now.slip
        },
        ..now
    }
}

/// Exact velocities and coefficients, with room for their rounding.
fn bounded<T: Number>(
    before: &ContactVelocities<T>,
    restitution: &Restitution<T>,
) -> (ContactVelocities<Bounded>, Restitution<Bounded>) {
    let exact = |number: T| Bounded::constant(number.value());
    (
        ContactVelocities {
            theta_rate: exact(before.theta_rate),
            slip: exact(before.slip),
            gap_rate: exact(before.gap_rate),
        },
        Restitution {
            coefficient: exact(restitution.coefficient),
            law: restitution.law,
        },
    )
}

/// The first number of an impact that rounding decides.
fn first_tie(follow: impl FnOnce(&mut dyn FnMut(Margin, Bounded))) -> Option<Undecided> {
    let mut tie = None;
    follow(&mut |margin, number| tie = tie.or_else(|| tied(margin, number)));
    tie
}

/// A number whose sign is rounding.
fn tied(margin: Margin, number: Bounded) -> Option<Undecided> {
    let Bounded { value, bound } = number;
    (value.abs() <= bound && bound > 0.0).then_some(Undecided::Rounding {
        margin,
        value,
        bound,
    })
}

/// An impulse and its work.
#[derive(Clone, Copy, Debug)]
struct Share<T> {
    impulse: T,
    work: T,
}

impl<T: Number> Share<T> {
    fn none() -> Self {
        Self {
            impulse: T::constant(0.0),
            work: T::constant(0.0),
        }
    }

    fn add(&mut self, impulse: T, work: T) {
        self.impulse = self.impulse + impulse;
        self.work = self.work + work;
    }
}

/// How a piece of an impact ends.
enum PieceEnd<T> {
    /// Slip or rotation ends.
    Segment,
    /// The gap rate vanishes.
    Turn { impulse: T },
    /// The impact ends.
    Impact(Ending<T>),
}

/// The end of an impact.
struct Ending<T> {
    impulse: T,
    /// The gap rate after it.
    opening: T,
}

/// An impact on its way.
struct Course<'a, T> {
    contact: &'a ResistedContact<T>,
    restitution: Restitution<T>,
    before: ContactVelocities<T>,
    now: ContactVelocities<T>,
    segment: Segment<T>,
    case: ImpactCase,
    is_first: bool,
    turns_on: bool,
    opens: bool,
    /// The impulses that are left until slip or rotation of this segment ends.
    ends: Ends<T>,
    /// While the gap closes and while it opens.
    compression: Share<T>,
    restituted: Share<T>,
    friction: Share<T>,
    couple_work: T,
}

impl<'a, T: Number> Course<'a, T> {
    fn new(
        contact: &'a ResistedContact<T>,
        before: ContactVelocities<T>,
        first: Segment<T>,
        restitution: Restitution<T>,
    ) -> Self {
        let case = match (first.slope.gap_rate.value() <= 0.0, first.slip) {
            (true, _) => ImpactCase::Jams,
            (false, None) => ImpactCase::SticksInCompression,
            (false, Some(_)) if before.slip.value() == 0.0 => ImpactCase::ReversesInCompression,
            (false, Some(_)) => ImpactCase::Slides,
        };
        Self {
            contact,
            restitution,
            before,
            now: contact.held(before, &first),
            segment: first,
            case,
            is_first: true,
            turns_on: first.rotation.is_some(),
            opens: false,
            ends: first.ends(&before),
            compression: Share::none(),
            restituted: Share::none(),
            friction: Share::none(),
            couple_work: T::constant(0.0),
        }
    }

    fn follow(mut self, watch: &mut impl FnMut(Margin, T)) -> Followed<T> {
        for _ in 0..MOST_PIECES {
            match self.piece(watch) {
                PieceEnd::Segment => self.bend(watch),
                PieceEnd::Turn { impulse } => {
                    self.push(impulse, T::constant(0.0));
                    self.opens = !self.opens;
                    self.ends = self.ends.after(impulse);
                }
                PieceEnd::Impact(Ending { impulse, opening }) => {
                    self.push(impulse, opening);
                    break;
                }
            }
        }
        let impact = Impact {
            case: self.case,
            before: self.before,
            after: self.now,
            impulse: Impulse {
                normal: self.compression.impulse + self.restituted.impulse,
                friction: self.friction.impulse,
            },
            normal_work: self.compression.work + self.restituted.work,
            friction_work: self.friction.work,
            resistance_work: self.couple_work,
        };
        Followed {
            impact,
            is_straight: self.is_first,
            turns_on: self.turns_on,
        }
    }

    /// Adds an impulse, after which the gap rate is known.
    fn push(&mut self, impulse: T, gap_rate: T) {
        let before = self.now;
        self.now = ContactVelocities {
            gap_rate,
            ..self.segment.after(&before, impulse)
        };
        let mean = |velocity: fn(&ContactVelocities<T>) -> T| {
            impulse * 0.5 * (velocity(&before) + velocity(&self.now))
        };
        let normal_work = mean(|it| it.gap_rate);
        let phase = if self.opens {
            &mut self.restituted
        } else {
            &mut self.compression
        };
        phase.add(impulse, normal_work);
        let friction = self.segment.slope.friction;
        self.friction
            .add(friction * impulse, friction * mean(|it| it.slip));
        self.couple_work = self.couple_work + self.segment.couple * mean(|it| it.theta_rate);
    }

    /// Goes on to the next segment.
    fn bend(&mut self, watch: &mut impl FnMut(Margin, T)) {
        let ends = self.ends;
        if self.is_first && self.contact.order_matters(&self.segment) {
            let left = self.now.slip + self.segment.slope.slip * ends.rotation;
            watch(Margin::ImpactOrder, left);
        }
        let length = ends.first();
        let next = self.segment.after(&self.now, length).gap_rate;
        // It has not passed zero but by rounding.
        let passes = (next.value() > 0.0) != self.opens;
        self.push(length, if passes { next.map(0.0, 1.0) } else { next });
        self.now = stop(self.now, &ends);
        let segment = self.contact.segment(&self.now, watch);
        let in_compression = self.now.gap_rate.value() <= 0.0;
        self.case = match (self.case, segment.slip, in_compression) {
            (ImpactCase::Jams, _, _) => ImpactCase::Jams,
            (case, slip, _) if slip == self.segment.slip => case,
            (_, None, true) => ImpactCase::SticksInCompression,
            (_, None, false) => ImpactCase::SticksInRestitution,
            (_, Some(_), true) => ImpactCase::ReversesInCompression,
            (_, Some(_), false) => ImpactCase::ReversesInRestitution,
        };
        self.turns_on &= segment.rotation == self.segment.rotation;
        self.ends = segment.ends(&self.now);
        self.segment = segment;
        self.is_first = false;
    }

    /// What ends the piece that begins now.
    fn piece(&self, watch: &mut impl FnMut(Margin, T)) -> PieceEnd<T> {
        let length = self.ends.first();
        let (rate, slope) = (self.now.gap_rate, self.segment.slope.gap_rate);
        let returns = if self.opens {
            slope.value() < 0.0
        } else {
            slope.value() > 0.0
        };
        let turn = if returns {
            -rate / slope
        } else {
            T::constant(f64::INFINITY)
        };
        let turns = turn.value() <= length.value();
        if self.opens {
            if returns {
                self.watch_fall(turns, watch);
            }
            let most = turn.value().min(length.value());
            if let Some(ending) = self.end(slope)
                && ending.impulse.value() <= most
            {
                return PieceEnd::Impact(ending);
            }
        }
        if turns {
            PieceEnd::Turn { impulse: turn }
        } else {
            PieceEnd::Segment
        }
    }

    /// The end of the impact by the law of restitution, if the slope of the gap rate stays; `None` if
    /// it does not end.
    fn end(&self, slope: T) -> Option<Ending<T>> {
        let e = self.restitution.coefficient;
        let (rate, closing) = (self.now.gap_rate, -self.before.gap_rate);
        let begins = rate.value() == 0.0 && self.restituted.impulse.value() == 0.0;
        let to = |opening: T| Ending {
            impulse: (opening - rate) / slope,
            opening,
        };
        let at_once = |opening: T| Ending {
            impulse: T::constant(0.0),
            opening,
        };
        if begins && self.is_first {
            // Without a kink all laws agree.
            return Some(to(e * closing));
        }
        match self.restitution.law {
            RestitutionLaw::Energetic if begins => {
                Some(to(e * (self.compression.work * -2.0 * slope).sqrt()))
            }
            RestitutionLaw::Energetic => {
                let left = -(e * e * self.compression.work) - self.restituted.work;
                let square = rate * rate + slope * 2.0 * left;
                if left.value() <= 0.0 {
                    return Some(at_once(rate));
                }
                (square.value() >= 0.0).then(|| {
                    let opening = square.sqrt();
                    Ending {
                        impulse: left * 2.0 / (rate + opening),
                        opening,
                    }
                })
            }
            RestitutionLaw::Poisson => {
                let left = e * self.compression.impulse - self.restituted.impulse;
                Some(if left.value() <= 0.0 {
                    at_once(rate)
                } else {
                    Ending {
                        impulse: left,
                        opening: rate + slope * left,
                    }
                })
            }
            RestitutionLaw::Newton => {
                let opening = e * closing;
                if rate.value() >= opening.value() {
                    return Some(at_once(opening));
                }
                (slope.value() > 0.0).then(|| to(opening))
            }
        }
    }

    /// Where the gap rate falls in restitution: next to the coefficient with which the impact ends
    /// just before the fall, or just before the gap closes again, it differs.
    fn watch_fall(&self, turns: bool, watch: &mut impl FnMut(Margin, T)) {
        let (rate, slope) = (self.now.gap_rate, self.segment.slope.gap_rate);
        let e = self.restitution.coefficient;
        let just_ends = match self.restitution.law {
            RestitutionLaw::Newton => rate / -self.before.gap_rate,
            RestitutionLaw::Energetic if turns => {
                let given = self.restituted.work - rate * rate / slope * 0.5;
                (given / -self.compression.work).sqrt()
            }
            RestitutionLaw::Poisson if turns => {
                (self.restituted.impulse - rate / slope) / self.compression.impulse
            }
            RestitutionLaw::Energetic | RestitutionLaw::Poisson => return,
        };
        watch(Margin::RestitutionOfFall, e - just_ends);
    }
}
