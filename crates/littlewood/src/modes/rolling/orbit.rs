//! The orbit of a rolling body: time as an elliptic integral of the angle, its inverse, and the end
//! of rolling.
//!
//! Let z = −cos(ϑ/2) = k sin ψ, zero at the bottom, where ϑ is the angle in the direction of motion
//! and k² = (K − D(π))/(4ℓ̂) in libration, k = 1 in rotation. With β = 4ℓ̂k² and κ = K − D(0), the
//! energy over the top,
//!
//! ```text
//! dτ = 2 sqrt(D / (|κ| + β cos²ψ)) dψ,     D = D(π) + β sin²ψ,
//! τ(ψ) = 2 sqrt(D(π)/γ) [s R_F(c², q², p) + β s³/(3 D(π)) R_J(c², q², p, 1)],
//! ```
//!
//! with s = sin ψ, c = cos ψ, γ = |κ| + β, q² = (|κ| + βc²)/γ, p = 1 + βs²/D(π): an integral of the
//! third kind in Carlson's symmetric form (DLMF 19.25.14). Its two terms have the same sign, so
//! nothing cancels. It holds for libration, rotation and the separatrix.
//!
//! The time between two places on the same side of the bottom, however near to each other, is a sum
//! of two terms of one sign, too, by the addition theorem (DLMF 19.11):
//!
//! ```text
//! τ(ψ1) − τ(ψ0) = τ(ψ3) + 2 arsinh(β s0 s1 s3 / sqrt(γ D(π))).
//! ```

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::math::bernstein::Bernstein;
use crate::math::bracket::{Bracket, Step};
use crate::math::carlson::{rf, rj};
use crate::math::form::{HalfAngle, on_arc};
use crate::mechanics::RollingLaw;
use crate::model::{Direction, Hoop};

use super::boundary::{Boundary, RollingEnd, RollingLimit, Stiction, in_body_frame};
use super::incline::Incline;
use super::recurrence::Recurrence;
use super::rim::RimOrbit;

/// The orbit of a rolling body through a state.
#[derive(Clone, Copy, Debug)]
pub struct RollingOrbit {
    kind: Kind,
    /// √cos α for users, 1 for the solvers ([`crate::walk::Origin`]).
    pace: f64,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Elliptic(Elliptic),
    Rim(RimOrbit),
    Incline(Incline),
}

/// An orbit of a body with D(π) > 0, that is, of every body but Littlewood's hoop.
#[derive(Clone, Copy, Debug)]
struct Elliptic {
    law: RollingLaw,
    boundary: Boundary,
    /// Direction of motion at the start: ϑ = travel·θ increases.
    travel: f64,
    motion: Swing,
    /// D ϑ′² at the start.
    kinetic: f64,
    /// |κ|, with κ = K − D(0).
    excess: f64,
    /// β = 4ℓ̂k².
    swing: f64,
    /// Turn of ϑ, and z = −cos(ϑ/2), y = sin(ϑ/2) at the start.
    lap: f64,
    z: f64,
    y: f64,
    /// Time from the bottom to the start, and from the bottom to the top or the turning point.
    entered: f64,
    quarter: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Swing {
    Rest,
    Libration,
    Rotation,
}

impl RollingOrbit {
    /// The orbit of `hoop` through (θ, θ′).
    #[must_use]
    pub fn new(hoop: &Hoop, theta: f64, theta_rate: f64) -> Self {
        let pace = hoop.pace();
        Self {
            pace,
            ..Self::of(hoop, theta, theta_rate / pace)
        }
    }

    /// The orbit in units in which gravity normal to the plane is 1.
    pub(crate) fn of(hoop: &Hoop, theta: f64, theta_rate: f64) -> Self {
        let law = RollingLaw::of(hoop);
        let kind = if hoop.slope() != 0.0 {
            Kind::Incline(Incline::new(hoop, law, theta, theta_rate))
        } else if law.bottom > 0.0 {
            Kind::Elliptic(Elliptic::new(hoop, law, theta, theta_rate))
        } else {
            Kind::Rim(RimOrbit::new(hoop.mu_s(), theta, theta_rate))
        };
        Self { kind, pace: 1.0 }
    }

    /// (θ, θ′) after the time `elapsed`.
    pub fn position(&self, elapsed: f64) -> (f64, f64) {
        let elapsed = elapsed * self.pace;
        let (theta, theta_rate) = match &self.kind {
            Kind::Elliptic(orbit) => orbit.position(elapsed),
            Kind::Rim(orbit) => orbit.position(elapsed),
            Kind::Incline(orbit) => orbit.position(elapsed),
        };
        (theta, theta_rate * self.pace)
    }

    /// The first point ahead at which rolling ends; none proves that the body rolls for ever.
    pub fn end(&self) -> Option<RollingEnd> {
        let end = match &self.kind {
            Kind::Elliptic(orbit) => orbit.end(false),
            Kind::Rim(orbit) => orbit.end(),
            Kind::Incline(orbit) => orbit.end(),
        }?;
        Some(RollingEnd {
            elapsed: end.elapsed / self.pace,
            theta_rate: end.theta_rate * self.pace,
            ..end
        })
    }

    /// [`Self::end`] for a start with |F| = μs N after which static friction holds: the start is no end.
    pub(crate) fn end_from_limit(&self) -> Option<RollingEnd> {
        match &self.kind {
            Kind::Elliptic(orbit) => orbit.end(true),
            Kind::Rim(orbit) => orbit.end(),
            Kind::Incline(orbit) => orbit.end(),
        }
    }

    /// Recurrence of the orbit while the limits of friction and of the normal force are not
    /// reached.
    pub fn recurrence(&self) -> Recurrence {
        let recurrence = match &self.kind {
            Kind::Elliptic(orbit) => orbit.recurrence(),
            Kind::Rim(orbit) => orbit.recurrence(),
            Kind::Incline(orbit) => orbit.recurrence(),
        };
        recurrence.at_pace(self.pace)
    }

    /// Whether an unbalanced hoop leaves the bounds of θ on a slope: rolling then ends, if only
    /// beyond them.
    pub(crate) fn leaves_bounds(&self) -> bool {
        match &self.kind {
            Kind::Incline(orbit) => orbit.leaves_bounds(),
            Kind::Elliptic(_) | Kind::Rim(_) => false,
        }
    }

    pub(crate) fn stiction(&self) -> Stiction {
        match &self.kind {
            Kind::Elliptic(orbit) => orbit.stiction(),
            Kind::Rim(orbit) => orbit.stiction(),
            Kind::Incline(orbit) => orbit.stiction(),
        }
    }
}

impl Elliptic {
    fn new(hoop: &Hoop, law: RollingLaw, theta: f64, theta_rate: f64) -> Self {
        // At a turning point gravity decides the direction of motion.
        let travel =
            match Direction::of_sign(theta_rate).or_else(|| Direction::of_sign(libm::sin(theta))) {
                Some(direction) => direction.sign(),
                None => 1.0,
            };
        let (lap, z, y) = reduce(travel * theta, libm::sincos(0.5 * (travel * theta)));
        let four_l = 4.0 * law.offset;
        let denominator = law.bottom + four_l * z * z;
        let kinetic = denominator * theta_rate * theta_rate;
        if kinetic == 0.0 && theta_rate != 0.0 {
            // The kinetic energy underflows: the start is a turning point, where gravity decides.
            return Self::new(hoop, law, theta, 0.0);
        }
        // Energy relative to the top and to the bottom, with the least cancellation.
        let over_top = kinetic - four_l * y * y;
        let over_bottom = kinetic + four_l * z * z;
        let rotates = over_top >= 0.0;
        let motion = match (
            rotates,
            theta_rate == 0.0 && libm::sin(theta) * law.offset == 0.0,
        ) {
            (_, true) => Swing::Rest,
            (true, false) => Swing::Rotation,
            (false, false) => Swing::Libration,
        };
        let mut orbit = Self {
            law,
            boundary: Boundary::new(hoop, &law, (over_top, over_bottom)),
            travel,
            motion,
            kinetic,
            excess: over_top.abs(),
            swing: if rotates { four_l } else { over_bottom },
            lap,
            z,
            y,
            entered: 0.0,
            quarter: f64::INFINITY,
        };
        if motion == Swing::Libration && orbit.amplitude() <= 0.5 * f64::EPSILON * theta.abs() {
            // Both turning points round to the angle of the start.
            orbit.motion = Swing::Rest;
        }
        if orbit.motion != Swing::Rest {
            orbit.entered = match orbit.motion {
                Swing::Libration if kinetic == 0.0 => -orbit.time_from_bottom(1.0, 0.0),
                Swing::Libration => {
                    orbit.time_from_bottom(orbit.phase_sine(z), (kinetic / orbit.swing).sqrt())
                }
                Swing::Rest | Swing::Rotation => orbit.time_from_bottom(z, y),
            };
            if orbit.excess > 0.0 {
                orbit.quarter = orbit.time_from_bottom(1.0, 0.0);
            }
        }
        orbit
    }

    /// Half the width of the libration in θ.
    fn amplitude(&self) -> f64 {
        2.0 * libm::atan2(self.swing.sqrt(), self.excess.sqrt())
    }

    /// sin ψ = z/k.
    fn phase_sine(&self, z: f64) -> f64 {
        z * (4.0 * self.law.offset / self.swing).sqrt()
    }

    /// sin ψ and cos ψ from z, y and D ϑ′².
    fn phase(&self, [z, y]: [f64; 2], kinetic: f64) -> Phase {
        match self.motion {
            Swing::Rest | Swing::Rotation => (z, y),
            Swing::Libration => (
                self.phase_sine(z).clamp(-1.0, 1.0),
                (kinetic.max(0.0) / self.swing).sqrt(),
            ),
        }
    }

    fn start_phase(&self) -> Phase {
        self.phase([self.z, self.y], self.kinetic)
    }

    /// Time from the start to a place of the same turn on the way up or down, with its z² − z0².
    fn time_since_start(&self, to: Phase, rise: f64) -> f64 {
        let gain = match self.motion {
            Swing::Rest | Swing::Rotation => rise,
            Swing::Libration => 4.0 * self.law.offset * rise / self.swing,
        };
        time_between(
            self.law.bottom,
            (self.excess, self.swing),
            [self.start_phase(), to],
            gain,
        )
    }

    /// Time from a phase to the top or the turning point.
    fn time_to_quarter(&self, (sine, cosine): Phase) -> f64 {
        if sine <= 0.0 {
            self.quarter - self.time_from_bottom(sine, cosine)
        } else {
            let arc = [(sine, cosine), (1.0, 0.0)];
            time_between(
                self.law.bottom,
                (self.excess, self.swing),
                arc,
                cosine * cosine,
            )
        }
    }

    /// τ(ψ) − τ(0) for ψ in [−π/2, π/2], from sin ψ and cos ψ.
    fn time_from_bottom(&self, sine: f64, cosine: f64) -> f64 {
        time_from_bottom(self.law.bottom, (self.excess, self.swing), (sine, cosine))
    }

    /// dτ/dψ.
    fn phase_slowness(&self, sine: f64, cosine: f64) -> f64 {
        let d = self.law.bottom + self.swing * sine * sine;
        2.0 * (d / (self.excess + self.swing * cosine * cosine)).sqrt()
    }

    fn position(&self, elapsed: f64) -> (f64, f64) {
        if self.motion == Swing::Rest {
            return (self.travel * self.angle_of(self.lap, self.z, self.y), 0.0);
        }
        let total = self.entered + elapsed;
        let half_period = 2.0 * self.quarter;
        let (turns, local) = if half_period.is_finite() {
            let turns = ((total + self.quarter) / half_period).floor();
            (turns, total - half_period * turns)
        } else {
            (0.0, total)
        };
        let (sine, cosine) = self.phase_at(local);
        let d = self.law.bottom + self.swing * sine * sine;
        if self.motion == Swing::Rotation {
            let theta = self.angle_of(self.lap + turns, sine, cosine);
            let rate = ((self.excess + self.swing * cosine * cosine) / d).sqrt();
            (self.travel * theta, self.travel * rate)
        } else {
            let back = if turns.rem_euclid(2.0) == 0.0 {
                1.0
            } else {
                -1.0
            };
            let four_l = 4.0 * self.law.offset;
            let z = back * sine * (self.swing / four_l).sqrt();
            let y = ((self.excess + self.swing * cosine * cosine) / four_l).sqrt();
            let rate = back * cosine * (self.swing / d).sqrt();
            (
                self.travel * self.angle_of(self.lap, z, y),
                self.travel * rate,
            )
        }
    }

    /// Sine and cosine of ψ, by inversion of the increasing function τ(ψ).
    fn phase_at(&self, local: f64) -> (f64, f64) {
        let direction = |psi: f64| {
            let (sine, cosine) = libm::sincos(psi);
            (sine, cosine.max(0.0))
        };
        let guess = if self.quarter.is_finite() {
            local / self.quarter * FRAC_PI_2
        } else {
            0.0
        };
        direction(
            Bracket {
                low: -FRAC_PI_2,
                high: FRAC_PI_2,
            }
            .iterate(guess, |psi| {
                let (sine, cosine) = direction(psi);
                let value = local - self.time_from_bottom(sine, cosine);
                let last = f64::EPSILON * psi.abs().max(f64::EPSILON);
                Step {
                    value,
                    step: value / self.phase_slowness(sine, cosine),
                    last,
                }
            }),
        )
    }

    /// ϑ in turn `lap`, from z = −cos(ϑ/2) and y = sin(ϑ/2).
    fn angle_of(&self, lap: f64, z: f64, y: f64) -> f64 {
        TAU * lap + 2.0 * libm::atan2(y, -z)
    }

    fn recurrence(&self) -> Recurrence {
        match self.motion {
            Swing::Rest => Recurrence::Rest,
            Swing::Rotation if self.quarter.is_finite() => Recurrence::Rotation {
                period: 2.0 * self.quarter,
            },
            Swing::Rotation => Recurrence::Asymptotic {
                theta: self.travel * self.angle_of(self.lap, 1.0, 0.0),
            },
            Swing::Libration => {
                let bottom = self.travel * self.angle_of(self.lap, 0.0, 1.0);
                let amplitude = self.amplitude();
                Recurrence::Libration {
                    period: 4.0 * self.quarter,
                    theta_min: bottom - amplitude,
                    theta_max: bottom + amplitude,
                }
            }
        }
    }

    /// The arcs ahead, which together cover the orbit.
    fn arcs(&self) -> impl Iterator<Item = Arc> {
        let four_l = 4.0 * self.law.offset;
        let here = Place {
            x: -self.z,
            y: self.y,
            kinetic: self.kinetic,
        };
        let bottom = Place {
            x: 0.0,
            y: 1.0,
            kinetic: self.kinetic + four_l * self.z * self.z,
        };
        let past_bottom = self.z >= 0.0;
        // From here to an end of the arc, and on from the bottom.
        let first = |to: Place, apart: f64| {
            let ahead = if past_bottom {
                Arc {
                    from: here,
                    to,
                    apart,
                    pass: Pass::First,
                }
            } else {
                Arc {
                    from: bottom,
                    to,
                    apart: -to.x,
                    pass: Pass::First,
                }
            };
            let down = Arc {
                from: here,
                to: bottom,
                apart: here.x,
                pass: Pass::First,
            };
            [(!past_bottom).then_some(down), Some(ahead)]
        };
        let arcs = match self.motion {
            Swing::Rest => [None; 4],
            Swing::Rotation => {
                let top = |x: f64| Place {
                    x,
                    y: 0.0,
                    kinetic: self.excess,
                };
                let [a, b] = first(top(-1.0), self.y);
                let again = |from, to, apart| {
                    self.quarter.is_finite().then_some(Arc {
                        from,
                        to,
                        apart,
                        pass: Pass::NextTurn,
                    })
                };
                let down = if past_bottom {
                    again(top(1.0), bottom, 1.0)
                } else {
                    again(top(1.0), here, self.y)
                };
                [
                    a,
                    b,
                    down,
                    if past_bottom {
                        again(bottom, here, self.z)
                    } else {
                        None
                    },
                ]
            }
            Swing::Libration => {
                let (k, y) = ((self.swing / four_l).sqrt(), (self.excess / four_l).sqrt());
                let turn = |x: f64| Place { x, y, kinetic: 0.0 };
                let [a, b] = first(
                    turn(-k),
                    self.kinetic / (four_l * (k * self.y + y * self.z)),
                );
                let back = |from, to| {
                    Some(Arc {
                        from,
                        to,
                        apart: k,
                        pass: Pass::WayBack,
                    })
                };
                [a, b, back(turn(-k), bottom), back(bottom, turn(k))]
            }
        };
        arcs.into_iter()
            .flatten()
            .filter(|arc| arc.from.direction() != arc.to.direction())
    }

    fn end(&self, from_limit: bool) -> Option<RollingEnd> {
        self.arcs().enumerate().find_map(|(passed, arc)| {
            let at_limit = (from_limit && passed == 0)
                .then(|| self.limit_at_start(&arc))
                .flatten();
            let crossings = self
                .boundary
                .on_arc(arc.from.direction(), arc.to.direction())
                .filter_map(|(margin, limit)| {
                    let margin = if at_limit == Some(limit) {
                        margin.starting_at_zero()
                    } else {
                        margin
                    };
                    let bracket = margin.first_crossing()?;
                    Some((bracket.refine(|x| margin.value_and_slope(x)), limit))
                });
            let (at, limit) = crossings.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some(self.end_at(&arc, at, limit))
        })
    }

    /// The limit whose margin is nearest to zero at the start.
    fn limit_at_start(&self, arc: &Arc) -> Option<RollingLimit> {
        let margins = self
            .boundary
            .on_arc(arc.from.direction(), arc.to.direction())
            .map(|(margin, limit)| (start_value(&margin).abs(), limit));
        margins
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|nearest| nearest.1)
    }

    fn end_at(&self, arc: &Arc, at: f64, limit: RollingLimit) -> RollingEnd {
        let [x, y] = on_arc(arc.from.direction(), arc.to.direction(), at);
        let z = -x;
        let four_l = 4.0 * self.law.offset;
        // z² − z² at the start of the arc, from the half angle that is passed.
        let rise = arc.passed(at) * (y * -arc.from.x + z * arc.from.y);
        let kinetic = match self.motion {
            Swing::Rest | Swing::Rotation => self.excess + four_l * y * y,
            Swing::Libration => (arc.from.kinetic - four_l * rise).max(0.0),
        };
        let speed = (kinetic / (self.law.bottom + four_l * z * z)).sqrt();
        let there @ (sine, cosine) = self.phase([z, y], kinetic);
        let next = || self.time_to_quarter(self.start_phase());
        let (elapsed, lap, rate) = match arc.pass {
            Pass::First if arc.from.direction() == [-self.z, self.y] => {
                (self.time_since_start(there, rise), self.lap, speed)
            }
            Pass::First => (
                self.time_from_bottom(sine, cosine) - self.entered,
                self.lap,
                speed,
            ),
            Pass::NextTurn => (
                next() + self.time_to_quarter((-sine, cosine)),
                self.lap + 1.0,
                speed,
            ),
            Pass::WayBack => (next() + self.time_to_quarter(there), self.lap, -speed),
        };
        RollingEnd {
            elapsed: elapsed.max(0.0),
            theta: self.travel * self.angle_of(lap, z, y),
            theta_rate: self.travel * rate,
            limit: in_body_frame(limit, self.travel),
        }
    }

    fn stiction(&self) -> Stiction {
        let Some(arc) = self.arcs().next() else {
            return Stiction::Holds;
        };
        let d = self.law.bottom + 4.0 * self.law.offset * self.z * self.z;
        let margins = self
            .boundary
            .on_arc(arc.from.direction(), arc.to.direction());
        let negative = margins.filter_map(|(margin, limit)| {
            if margin.initial_sign() >= 0.0 {
                None
            } else {
                Some((start_value(&margin) / (d * d), limit))
            }
        });
        Stiction::of(negative, self.travel)
    }
}

/// τ(ψ) − τ(0) for ψ in [−π/2, π/2], from D(π), |κ| and β, and from sin ψ and cos ψ.
pub(crate) fn time_from_bottom(
    bottom: f64,
    (excess, swing): (f64, f64),
    (sine, cosine): (f64, f64),
) -> f64 {
    let gamma = excess + swing;
    let c2 = cosine * cosine;
    let q2 = (excess + swing * c2) / gamma;
    let lift = swing * sine * sine / bottom;
    let first = rf(c2, q2, 1.0 + lift);
    let third = if lift == 0.0 {
        0.0
    } else {
        lift / 3.0 * rj(c2, q2, 1.0 + lift, 1.0)
    };
    2.0 * (bottom / gamma).sqrt() * sine * (first + third)
}

/// τ(ψ1) − τ(ψ0) from sin²ψ1 − sin²ψ0, which may be known better than its terms.
pub(crate) fn time_between(
    bottom: f64,
    orbit: (f64, f64),
    [from, to]: [Phase; 2],
    gain: f64,
) -> f64 {
    if from.0 * to.0 <= 0.0 {
        return time_from_bottom(bottom, orbit, to) - time_from_bottom(bottom, orbit, from);
    }
    if gain == 0.0 {
        return 0.0;
    }
    // The time is odd in ψ.
    let sign = 1.0_f64.copysign(gain * to.0);
    let [(s0, c0), (s1, c1)] =
        if gain < 0.0 { [to, from] } else { [from, to] }.map(|(s, c)| (s.abs(), c));
    let (excess, swing) = orbit;
    let (at_bottom, at_quarter) = (excess + swing, bottom + swing);
    let kinetic = [c0, c1].map(|c| (excess + swing * c * c).sqrt());
    let d = [s0, s1].map(|s| (bottom + swing * s * s).sqrt());
    // sn and cn of the difference; cn as a quotient of sums of positive terms.
    let sn = (at_bottom * at_quarter).sqrt() * gain.abs()
        / (s1 * c0 * kinetic[0] * d[1] + s0 * c1 * kinetic[1] * d[0]);
    let (a, b) = (c1 * d[0], s1 * kinetic[0]);
    let cn = (at_bottom * c0 * a * d[1] + at_quarter * s0 * b * kinetic[1])
        / (at_bottom * a * a + at_quarter * b * b);
    let (sine, cosine) = (sn * bottom.sqrt(), cn * at_quarter.sqrt());
    let length = libm::hypot(sine, cosine);
    let (sine, cosine) = (sine / length, cosine / length);
    let rest = swing * s0 * s1 * sine / (at_bottom * bottom).sqrt();
    sign * (time_from_bottom(bottom, orbit, (sine, cosine)) + 2.0 * libm::asinh(rest))
}

fn start_value(margin: &Bernstein) -> f64 {
    margin.coefficients()[0]
}

/// sin ψ and cos ψ.
type Phase = (f64, f64);

/// A half angle, and D ϑ′² there.
#[derive(Clone, Copy, Debug)]
struct Place {
    x: f64,
    y: f64,
    kinetic: f64,
}

impl Place {
    const fn direction(&self) -> HalfAngle {
        [self.x, self.y]
    }
}

#[derive(Clone, Copy, Debug)]
struct Arc {
    from: Place,
    to: Place,
    /// Sine of the half angle between them.
    apart: f64,
    pass: Pass,
}

impl Arc {
    /// Sine of the half angle that is passed at a barycentric coordinate, against the motion
    /// negative.
    fn passed(&self, at: f64) -> f64 {
        let along = self.from.x * self.to.x + self.from.y * self.to.y;
        let sine = at * self.apart;
        let passed = sine / libm::hypot(sine, 1.0 - at + at * along);
        if self.pass == Pass::WayBack {
            -passed
        } else {
            passed
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    First,
    NextTurn,
    WayBack,
}

/// Turn number and (−cos, sin) of half an angle within the turn, sin ≥ 0, from its sine and cosine.
pub(crate) fn reduce(angle: f64, (sin, cos): (f64, f64)) -> (f64, f64, f64) {
    let mut lap = (angle / TAU).floor();
    let flip = if lap.rem_euclid(2.0) == 0.0 {
        1.0
    } else {
        -1.0
    };
    let (mut x, mut y) = (flip * cos, flip * sin);
    if y < 0.0 {
        // Rounding moved the angle across a multiple of 2π.
        lap += if x > 0.0 { -1.0 } else { 1.0 };
        (x, y) = (-x, -y);
    }
    (lap, -x, y)
}
