//! The orbit of a rolling body: time as an elliptic integral of the angle, its inverse, and the end
//! of rolling.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::math::bernstein::Bernstein;
use crate::math::bracket::{Bracket, Step};
use crate::math::form::{HalfAngle, on_arc};
use crate::math::trig::Angle;
use crate::mechanics::RollingLaw;
use crate::model::{Direction, Hoop};

use super::boundary::{Boundary, RollingEnd, RollingLimit, Stiction, in_body_frame};
use super::half_angle::{HalfAngleOrbit, OrbitPass, ReducedAngle};
use super::incline::Incline;
use super::recurrence::Recurrence;
use super::rim::RimOrbit;

/// ψ at the top or the turning point.
const QUARTER: Angle = Angle { sin: 1.0, cos: 0.0 };

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
    orbit: HalfAngleOrbit,
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
            Kind::Incline(orbit) => orbit.end(false),
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
            Kind::Incline(orbit) => orbit.end(true),
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
        let half = libm::sincos(0.5 * (travel * theta));
        let half = Angle {
            sin: half.0,
            cos: half.1,
        };
        let path = HalfAngleOrbit::new(&law, travel * theta, half, theta_rate);
        if path.twice_kinetic == 0.0 && theta_rate != 0.0 {
            // The kinetic energy underflows: the start is a turning point, where gravity decides.
            return Self::new(hoop, law, theta, 0.0);
        }
        let motion = match (
            path.rotates,
            theta_rate == 0.0 && libm::sin(theta) * law.offset == 0.0,
        ) {
            (_, true) => Swing::Rest,
            (true, false) => Swing::Rotation,
            (false, false) => Swing::Libration,
        };
        let mut orbit = Self {
            law,
            boundary: Boundary::new(hoop, &law, (path.over_top(), path.orbit_level())),
            travel,
            motion,
            orbit: path,
            entered: 0.0,
            quarter: f64::INFINITY,
        };
        if motion == Swing::Libration && orbit.amplitude() <= 0.5 * f64::EPSILON * theta.abs() {
            // Both turning points round to the angle of the start.
            orbit.motion = Swing::Rest;
        }
        if orbit.motion != Swing::Rest {
            let ReducedAngle { z, y, .. } = path.start;
            orbit.entered = match orbit.motion {
                Swing::Libration if path.twice_kinetic == 0.0 => {
                    -path.energy.time_from_bottom(QUARTER)
                }
                Swing::Libration => path.energy.time_from_bottom(Angle {
                    sin: path.phase_sine(z),
                    cos: (path.twice_kinetic / path.energy.beta).sqrt(),
                }),
                Swing::Rest | Swing::Rotation => {
                    path.energy.time_from_bottom(Angle { sin: z, cos: y })
                }
            };
            if path.energy.separatrix_gap > 0.0 {
                orbit.quarter = path.energy.time_from_bottom(QUARTER);
            }
        }
        orbit
    }

    /// Half the width of the libration in θ.
    fn amplitude(&self) -> f64 {
        2.0 * libm::atan2(
            self.orbit.energy.beta.sqrt(),
            self.orbit.energy.separatrix_gap.sqrt(),
        )
    }

    /// ψ at z, y and D ϑ′².
    fn phase(&self, z: f64, y: f64, twice_kinetic: f64) -> Angle {
        match self.motion {
            Swing::Rest => Angle { sin: z, cos: y },
            Swing::Rotation | Swing::Libration => self.orbit.phase(z, y, twice_kinetic),
        }
    }

    fn start_phase(&self) -> Angle {
        let ReducedAngle { z, y, .. } = self.orbit.start;
        self.phase(z, y, self.orbit.twice_kinetic)
    }

    /// Time from the start to a point of the same turn on the way up or down, with its z² − z0².
    fn time_since_start(&self, to: Angle, rise: f64) -> f64 {
        let gain = match self.motion {
            Swing::Rest | Swing::Rotation => rise,
            Swing::Libration => self.orbit.four_l * rise / self.orbit.energy.beta,
        };
        self.orbit.energy.time_between(self.start_phase(), to, gain)
    }

    /// Time from a phase to the top or the turning point.
    fn time_to_quarter(&self, phase: Angle) -> f64 {
        let energy = &self.orbit.energy;
        if phase.sin <= 0.0 {
            self.quarter - energy.time_from_bottom(phase)
        } else {
            energy.time_between(phase, QUARTER, phase.cos * phase.cos)
        }
    }

    /// dτ/dψ.
    fn phase_slowness(&self, Angle { sin, cos }: Angle) -> f64 {
        let d = self.law.bottom + self.orbit.energy.beta * sin * sin;
        2.0 * (d / (self.orbit.energy.separatrix_gap + self.orbit.energy.beta * cos * cos)).sqrt()
    }

    fn position(&self, elapsed: f64) -> (f64, f64) {
        if self.motion == Swing::Rest {
            return (
                self.travel
                    * self.angle_of(
                        self.orbit.start.turn,
                        self.orbit.start.z,
                        self.orbit.start.y,
                    ),
                0.0,
            );
        }
        let total = self.entered + elapsed;
        let half_period = 2.0 * self.quarter;
        let (turns, local) = if half_period.is_finite() {
            let turns = ((total + self.quarter) / half_period).floor();
            (turns, total - half_period * turns)
        } else {
            (0.0, total)
        };
        let Angle {
            sin: sine,
            cos: cosine,
        } = self.phase_at(local);
        let d = self.law.bottom + self.orbit.energy.beta * sine * sine;
        if self.motion == Swing::Rotation {
            let theta = self.angle_of(self.orbit.start.turn + turns, sine, cosine);
            let rate =
                ((self.orbit.energy.separatrix_gap + self.orbit.energy.beta * cosine * cosine) / d)
                    .sqrt();
            (self.travel * theta, self.travel * rate)
        } else {
            let back = if turns.rem_euclid(2.0) == 0.0 {
                1.0
            } else {
                -1.0
            };
            let four_l = 4.0 * self.law.offset;
            let z = back * sine * (self.orbit.energy.beta / four_l).sqrt();
            let y = ((self.orbit.energy.separatrix_gap + self.orbit.energy.beta * cosine * cosine)
                / four_l)
                .sqrt();
            let rate = back * cosine * (self.orbit.energy.beta / d).sqrt();
            (
                self.travel * self.angle_of(self.orbit.start.turn, z, y),
                self.travel * rate,
            )
        }
    }

    /// ψ, by inversion of the increasing function τ(ψ).
    fn phase_at(&self, local: f64) -> Angle {
        let phase = |psi: f64| {
            let (sin, cos) = libm::sincos(psi);
            Angle {
                sin,
                cos: cos.max(0.0),
            }
        };
        let guess = if self.quarter.is_finite() {
            local / self.quarter * FRAC_PI_2
        } else {
            0.0
        };
        phase(
            Bracket {
                low: -FRAC_PI_2,
                high: FRAC_PI_2,
            }
            .iterate(guess, |psi| {
                let phase = phase(psi);
                let value = local - self.orbit.energy.time_from_bottom(phase);
                let last = f64::EPSILON * psi.abs().max(f64::EPSILON);
                Step {
                    value,
                    step: value / self.phase_slowness(phase),
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
                theta: self.travel * self.angle_of(self.orbit.start.turn, 1.0, 0.0),
            },
            Swing::Libration => {
                let bottom = self.travel * self.angle_of(self.orbit.start.turn, 0.0, 1.0);
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
            x: -self.orbit.start.z,
            y: self.orbit.start.y,
            kinetic: self.orbit.twice_kinetic,
        };
        let bottom = Place {
            x: 0.0,
            y: 1.0,
            kinetic: self.orbit.twice_kinetic + four_l * self.orbit.start.z * self.orbit.start.z,
        };
        let past_bottom = self.orbit.start.z >= 0.0;
        // From here to an end of the arc, and on from the bottom.
        let first = |to: Place, apart: f64| {
            let ahead = if past_bottom {
                Arc {
                    from: here,
                    to,
                    apart,
                    pass: OrbitPass::First,
                }
            } else {
                Arc {
                    from: bottom,
                    to,
                    apart: -to.x,
                    pass: OrbitPass::First,
                }
            };
            let down = Arc {
                from: here,
                to: bottom,
                apart: here.x,
                pass: OrbitPass::First,
            };
            [(!past_bottom).then_some(down), Some(ahead)]
        };
        let arcs = match self.motion {
            Swing::Rest => [None; 4],
            Swing::Rotation => {
                let top = |x: f64| Place {
                    x,
                    y: 0.0,
                    kinetic: self.orbit.energy.separatrix_gap,
                };
                let [a, b] = first(top(-1.0), self.orbit.start.y);
                let again = |from, to, apart| {
                    self.quarter.is_finite().then_some(Arc {
                        from,
                        to,
                        apart,
                        pass: OrbitPass::NextTurn,
                    })
                };
                let down = if past_bottom {
                    again(top(1.0), bottom, 1.0)
                } else {
                    again(top(1.0), here, self.orbit.start.y)
                };
                [
                    a,
                    b,
                    down,
                    if past_bottom {
                        again(bottom, here, self.orbit.start.z)
                    } else {
                        None
                    },
                ]
            }
            Swing::Libration => {
                let (k, y) = (
                    (self.orbit.energy.beta / four_l).sqrt(),
                    (self.orbit.energy.separatrix_gap / four_l).sqrt(),
                );
                let turn = |x: f64| Place { x, y, kinetic: 0.0 };
                let [a, b] = first(
                    turn(-k),
                    self.orbit.twice_kinetic
                        / (four_l * (k * self.orbit.start.y + y * self.orbit.start.z)),
                );
                let back = |from, to| {
                    Some(Arc {
                        from,
                        to,
                        apart: k,
                        pass: OrbitPass::WayBack,
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
            Swing::Rest | Swing::Rotation => self.orbit.energy.separatrix_gap + four_l * y * y,
            Swing::Libration => (arc.from.kinetic - four_l * rise).max(0.0),
        };
        let speed = (kinetic / (self.law.bottom + four_l * z * z)).sqrt();
        let there = self.phase(z, y, kinetic);
        let next = || self.time_to_quarter(self.start_phase());
        let (elapsed, lap, rate) = match arc.pass {
            OrbitPass::First
                if arc.from.direction() == [-self.orbit.start.z, self.orbit.start.y] =>
            {
                (
                    self.time_since_start(there, rise),
                    self.orbit.start.turn,
                    speed,
                )
            }
            OrbitPass::First => (
                self.orbit.energy.time_from_bottom(there) - self.entered,
                self.orbit.start.turn,
                speed,
            ),
            OrbitPass::NextTurn => (
                next() + self.time_to_quarter(there.mirrored()),
                self.orbit.start.turn + 1.0,
                speed,
            ),
            OrbitPass::WayBack => (
                next() + self.time_to_quarter(there),
                self.orbit.start.turn,
                -speed,
            ),
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
        let d = self.law.bottom + 4.0 * self.law.offset * self.orbit.start.z * self.orbit.start.z;
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

fn start_value(margin: &Bernstein) -> f64 {
    margin.coefficients()[0]
}

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
    pass: OrbitPass,
}

impl Arc {
    /// Sine of the half angle that is passed at a barycentric coordinate, against the motion
    /// negative.
    fn passed(&self, at: f64) -> f64 {
        let along = self.from.x * self.to.x + self.from.y * self.to.y;
        let sine = at * self.apart;
        let passed = sine / libm::hypot(sine, 1.0 - at + at * along);
        if self.pass == OrbitPass::WayBack {
            -passed
        } else {
            passed
        }
    }
}
