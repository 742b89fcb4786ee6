//! The orbit of a rolling body: time as an elliptic integral of the angle, its inverse, and the end
//! of rolling.

use core::f64::consts::FRAC_PI_2;

use crate::math::bernstein::Bernstein;
use crate::math::bracket::{Bracket, RootStep};
use crate::math::form::{HalfAngle, on_arc};
use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::RollingLaw;
use crate::model::{Hoop, SlipDirection};

use super::boundary::{Boundary, RollingEnd, RollingLimit, Stiction, in_body_frame};
use super::half_angle::{HalfAngleOrbit, OrbitEnergy, OrbitPass, ReducedAngle};
use super::incline::Incline;
use super::recurrence::Recurrence;
use super::rim::RimOrbit;

/// ψ at the top or the turning point.
const QUARTER: Angle = Angle { sin: 1.0, cos: 0.0 };

/// The orbit of a rolling body through a state, without rolling resistance.
#[derive(Clone, Copy, Debug)]
pub struct RollingOrbit {
    shape: OrbitShape,
    /// √cos α for users, 1 for the solvers ([`crate::walk::Origin`]).
    pace: f64,
}

#[derive(Clone, Copy, Debug)]
enum OrbitShape {
    Elliptic(Elliptic),
    Rim(RimOrbit),
    Incline(Incline),
}

/// An orbit of a body with D(π) > 0, that is, of every body but Littlewood's hoop.
#[derive(Clone, Copy, Debug)]
struct Elliptic {
    law: RollingLaw,
    boundary: Boundary,
    /// Direction of motion at the start: ϑ = heading·θ increases.
    heading: f64,
    kind: OrbitKind,
    orbit: HalfAngleOrbit,
    /// Time from the bottom to the start, and from the bottom to the top or the turning point.
    start_time: f64,
    quarter_period: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OrbitKind {
    Rest,
    Libration,
    Rotation,
}

impl RollingOrbit {
    /// The orbit of `hoop` through (θ, θ′); `None` with rolling resistance, where energy is lost
    /// and no orbit is one of constant energy.
    pub fn new(hoop: &Hoop, theta: f64, theta_rate: f64) -> Option<Self> {
        let pace = hoop.pace();
        (hoop.rolling_resistance() == 0.0).then(|| Self {
            pace,
            ..Self::of(hoop, theta, theta_rate / pace)
        })
    }

    /// The orbit in units in which gravity normal to the plane is 1.
    pub(crate) fn of(hoop: &Hoop, theta: f64, theta_rate: f64) -> Self {
        let law = RollingLaw::of(hoop);
        let shape = if hoop.slope() != 0.0 {
            OrbitShape::Incline(Incline::new(hoop, law, theta, theta_rate))
        } else if law.bottom > 0.0 {
            OrbitShape::Elliptic(Elliptic::new(hoop, law, theta, theta_rate))
        } else {
            OrbitShape::Rim(RimOrbit::new(hoop.mu_s(), theta, theta_rate))
        };
        Self { shape, pace: 1.0 }
    }

    /// (θ, θ′) after the time `elapsed`.
    pub fn position(&self, elapsed: f64) -> (f64, f64) {
        let elapsed = elapsed * self.pace;
        let (theta, theta_rate) = match &self.shape {
            OrbitShape::Elliptic(orbit) => orbit.position(elapsed),
            OrbitShape::Rim(orbit) => orbit.position(elapsed),
            OrbitShape::Incline(orbit) => orbit.position(elapsed),
        };
        (theta, theta_rate * self.pace)
    }

    /// The first point ahead at which rolling ends; none proves that the body rolls for ever.
    pub fn end(&self) -> Option<RollingEnd> {
        let end = match &self.shape {
            OrbitShape::Elliptic(orbit) => orbit.end(false),
            OrbitShape::Rim(orbit) => orbit.end(),
            OrbitShape::Incline(orbit) => orbit.end(false),
        }?;
        Some(RollingEnd {
            elapsed: end.elapsed / self.pace,
            theta_rate: end.theta_rate * self.pace,
            ..end
        })
    }

    /// [`Self::end`] for a start with |F| = μs N after which static friction holds: the start is no end.
    pub(crate) fn end_from_limit(&self) -> Option<RollingEnd> {
        match &self.shape {
            OrbitShape::Elliptic(orbit) => orbit.end(true),
            OrbitShape::Rim(orbit) => orbit.end(),
            OrbitShape::Incline(orbit) => orbit.end(true),
        }
    }

    /// Recurrence of the orbit while the limits of friction and of the normal force are not
    /// reached.
    pub fn recurrence(&self) -> Recurrence {
        let recurrence = match &self.shape {
            OrbitShape::Elliptic(orbit) => orbit.recurrence(),
            OrbitShape::Rim(orbit) => orbit.recurrence(),
            OrbitShape::Incline(orbit) => orbit.recurrence(),
        };
        recurrence.at_pace(self.pace)
    }

    /// Whether an unbalanced hoop leaves the bounds of θ on a slope: rolling then ends, if only
    /// beyond them.
    pub(crate) fn leaves_bounds(&self) -> bool {
        match &self.shape {
            OrbitShape::Incline(orbit) => orbit.leaves_bounds(),
            OrbitShape::Elliptic(_) | OrbitShape::Rim(_) => false,
        }
    }

    pub(crate) fn stiction(&self) -> Stiction {
        match &self.shape {
            OrbitShape::Elliptic(orbit) => orbit.stiction(),
            OrbitShape::Rim(orbit) => orbit.stiction(),
            OrbitShape::Incline(orbit) => orbit.stiction(),
        }
    }
}

impl Elliptic {
    fn new(hoop: &Hoop, law: RollingLaw, theta: f64, theta_rate: f64) -> Self {
        // At a turning point gravity decides the direction of motion.
        let heading = match SlipDirection::of_sign(theta_rate)
            .or_else(|| SlipDirection::of_sign(libm::sin(theta)))
        {
            Some(direction) => direction.sign(),
            None => 1.0,
        };
        let half = (0.5 * (heading * theta)).angle();
        let path = HalfAngleOrbit::new(&law, heading * theta, half, theta_rate);
        if path.twice_kinetic == 0.0 && theta_rate != 0.0 {
            // The kinetic energy underflows: the start is a turning point, where gravity decides.
            return Self::new(hoop, law, theta, 0.0);
        }
        let kind = match (
            path.rotates,
            theta_rate == 0.0 && libm::sin(theta) * law.offset == 0.0,
        ) {
            (_, true) => OrbitKind::Rest,
            (true, false) => OrbitKind::Rotation,
            (false, false) => OrbitKind::Libration,
        };
        let mut orbit = Self {
            law,
            boundary: Boundary::new(hoop, &law, (path.over_top(), path.orbit_level())),
            heading,
            kind,
            orbit: path,
            start_time: 0.0,
            quarter_period: f64::INFINITY,
        };
        if kind == OrbitKind::Libration && orbit.amplitude() <= 0.5 * f64::EPSILON * theta.abs() {
            // Both turning points round to the angle of the start.
            orbit.kind = OrbitKind::Rest;
        }
        if orbit.kind != OrbitKind::Rest {
            let ReducedAngle { z, y, .. } = path.start;
            orbit.start_time = match orbit.kind {
                OrbitKind::Libration if path.twice_kinetic == 0.0 => {
                    -path.energy.time_from_bottom(QUARTER)
                }
                OrbitKind::Libration => path.energy.time_from_bottom(Angle {
                    sin: path.phase_sine(z),
                    cos: (path.twice_kinetic / path.energy.beta).sqrt(),
                }),
                OrbitKind::Rest | OrbitKind::Rotation => {
                    path.energy.time_from_bottom(Angle { sin: z, cos: y })
                }
            };
            if path.energy.separatrix_gap > 0.0 {
                orbit.quarter_period = path.energy.time_from_bottom(QUARTER);
            }
        }
        orbit
    }

    /// Half the width of the libration in θ.
    fn amplitude(&self) -> f64 {
        let OrbitEnergy {
            separatrix_gap,
            beta,
            ..
        } = self.orbit.energy;
        2.0 * libm::atan2(beta.sqrt(), separatrix_gap.sqrt())
    }

    /// Time from the start to a point of the same turn on the way up or down, with its z² − z0².
    fn time_since_start(&self, to: Angle, delta_z2: f64) -> f64 {
        let HalfAngleOrbit { energy, four_l, .. } = self.orbit;
        let gain = if self.orbit.rotates {
            delta_z2
        } else {
            four_l * delta_z2 / energy.beta
        };
        energy.time_between(self.orbit.start_phase(), to, gain)
    }

    /// Time from a phase to the top or the turning point.
    fn time_to_quarter(&self, phase: Angle) -> f64 {
        let energy = &self.orbit.energy;
        if phase.sin <= 0.0 {
            self.quarter_period - energy.time_from_bottom(phase)
        } else {
            energy.time_between(phase, QUARTER, phase.cos * phase.cos)
        }
    }

    /// dτ/dψ.
    fn phase_slowness(&self, Angle { sin, cos }: Angle) -> f64 {
        let OrbitEnergy {
            bottom,
            separatrix_gap,
            beta,
        } = self.orbit.energy;
        2.0 * ((bottom + beta * sin * sin) / (separatrix_gap + beta * cos * cos)).sqrt()
    }

    fn position(&self, elapsed: f64) -> (f64, f64) {
        let HalfAngleOrbit { start, four_l, .. } = self.orbit;
        if self.kind == OrbitKind::Rest {
            return (self.heading * start.angle(), 0.0);
        }
        let total = self.start_time + elapsed;
        let half_period = 2.0 * self.quarter_period;
        let (turns, local) = if half_period.is_finite() {
            let turns = ((total + self.quarter_period) / half_period).floor();
            (turns, total - half_period * turns)
        } else {
            (0.0, total)
        };
        let Angle { sin, cos } = self.phase_at(local);
        let OrbitEnergy {
            bottom,
            separatrix_gap,
            beta,
        } = self.orbit.energy;
        let d = bottom + beta * sin * sin;
        let over_top = separatrix_gap + beta * cos * cos;
        let (here, rate) = if self.kind == OrbitKind::Rotation {
            let here = ReducedAngle {
                turn: start.turn + turns,
                z: sin,
                y: cos,
            };
            (here, (over_top / d).sqrt())
        } else {
            let back = if turns.rem_euclid(2.0) == 0.0 {
                1.0
            } else {
                -1.0
            };
            let here = ReducedAngle {
                z: back * sin * (beta / four_l).sqrt(),
                y: (over_top / four_l).sqrt(),
                ..start
            };
            (here, back * cos * (beta / d).sqrt())
        };
        (self.heading * here.angle(), self.heading * rate)
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
        let guess = if self.quarter_period.is_finite() {
            local / self.quarter_period * FRAC_PI_2
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
                RootStep {
                    value,
                    step: value / self.phase_slowness(phase),
                    last,
                }
            }),
        )
    }

    fn recurrence(&self) -> Recurrence {
        let ReducedAngle { turn, .. } = self.orbit.start;
        let at = |z: f64, y: f64| ReducedAngle { turn, z, y }.angle();
        match self.kind {
            OrbitKind::Rest => Recurrence::Rest,
            OrbitKind::Rotation if self.quarter_period.is_finite() => Recurrence::Rotation {
                period: 2.0 * self.quarter_period,
            },
            OrbitKind::Rotation => Recurrence::Asymptotic {
                theta: self.heading * at(1.0, 0.0),
            },
            OrbitKind::Libration => {
                let bottom = self.heading * at(0.0, 1.0);
                let amplitude = self.amplitude();
                Recurrence::Libration {
                    period: 4.0 * self.quarter_period,
                    theta_min: bottom - amplitude,
                    theta_max: bottom + amplitude,
                }
            }
        }
    }

    /// The arcs ahead, which together cover the orbit.
    fn arcs(&self) -> impl Iterator<Item = OrbitArc> {
        let HalfAngleOrbit {
            energy,
            four_l,
            start: ReducedAngle { z, y, .. },
            twice_kinetic,
            ..
        } = self.orbit;
        let arc = |from, to, sin_width, pass| {
            Some(OrbitArc {
                from,
                to,
                sin_width,
                pass,
            })
        };
        let here = OrbitPoint::new(-z, y, twice_kinetic);
        let bottom = OrbitPoint::new(0.0, 1.0, twice_kinetic + four_l * z * z);
        let past_bottom = z >= 0.0;
        // From here to an end of the arc, over the bottom if that is ahead.
        let first = |to: OrbitPoint, sin_width: f64| {
            if past_bottom {
                [None, arc(here, to, sin_width, OrbitPass::First)]
            } else {
                [
                    arc(here, bottom, here.x, OrbitPass::First),
                    arc(bottom, to, -to.x, OrbitPass::First),
                ]
            }
        };
        let arcs = match self.kind {
            OrbitKind::Rest => [None; 4],
            OrbitKind::Rotation => {
                let top = |x: f64| OrbitPoint::new(x, 0.0, energy.separatrix_gap);
                let [a, b] = first(top(-1.0), y);
                // On the separatrix there is no next turn.
                let again = |from, to, sin_width| {
                    arc(from, to, sin_width, OrbitPass::NextTurn)
                        .filter(|_| self.quarter_period.is_finite())
                };
                if past_bottom {
                    [a, b, again(top(1.0), bottom, 1.0), again(bottom, here, z)]
                } else {
                    [a, b, again(top(1.0), here, y), None]
                }
            }
            OrbitKind::Libration => {
                let k = (energy.beta / four_l).sqrt();
                let height = (energy.separatrix_gap / four_l).sqrt();
                let turn = |x: f64| OrbitPoint::new(x, height, 0.0);
                let [a, b] = first(turn(-k), twice_kinetic / (four_l * (k * y + height * z)));
                let back = |from, to| arc(from, to, k, OrbitPass::WayBack);
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
                    let margin = if from_limit && passed == 0 {
                        margin.without_rounding_at_start()
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
    fn limit_at_start(&self, arc: &OrbitArc) -> Option<RollingLimit> {
        let margins = self
            .boundary
            .on_arc(arc.from.direction(), arc.to.direction())
            .map(|(margin, limit)| (start_value(&margin).abs(), limit));
        margins
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|nearest| nearest.1)
    }

    fn end_at(&self, arc: &OrbitArc, at: f64, limit: RollingLimit) -> RollingEnd {
        let HalfAngleOrbit {
            energy,
            four_l,
            start,
            ..
        } = self.orbit;
        let [x, y] = on_arc(arc.from.direction(), arc.to.direction(), at);
        let z = -x;
        // z² − z² at the start of the arc, from the half angle that is passed.
        let delta_z2 = arc.passed(at) * (y * -arc.from.x + z * arc.from.y);
        let twice_kinetic = if self.orbit.rotates {
            energy.separatrix_gap + four_l * y * y
        } else {
            (arc.from.twice_kinetic - four_l * delta_z2).max(0.0)
        };
        let there = self.orbit.phase(z, y, twice_kinetic);
        let to_quarter =
            |to: Angle| self.time_to_quarter(self.orbit.start_phase()) + self.time_to_quarter(to);
        let is_from_start = arc.from.direction() == [-start.z, start.y];
        let elapsed = match arc.pass {
            OrbitPass::First if is_from_start => self.time_since_start(there, delta_z2),
            OrbitPass::First => energy.time_from_bottom(there) - self.start_time,
            OrbitPass::NextTurn => to_quarter(there.mirrored()),
            OrbitPass::WayBack => to_quarter(there),
        };
        let turn = match arc.pass {
            OrbitPass::First | OrbitPass::WayBack => start.turn,
            OrbitPass::NextTurn => start.turn + 1.0,
        };
        let speed = (twice_kinetic / (self.law.bottom + four_l * z * z)).sqrt();
        let rate = match arc.pass {
            OrbitPass::First | OrbitPass::NextTurn => speed,
            OrbitPass::WayBack => -speed,
        };
        RollingEnd {
            elapsed: elapsed.max(0.0),
            theta: self.heading * ReducedAngle { turn, z, y }.angle(),
            theta_rate: self.heading * rate,
            limit: in_body_frame(limit, self.heading),
        }
    }

    fn stiction(&self) -> Stiction {
        let Some(arc) = self.arcs().next() else {
            return Stiction::Holds;
        };
        let HalfAngleOrbit { four_l, start, .. } = self.orbit;
        let d = self.law.bottom + four_l * start.z * start.z;
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
        Stiction::of(negative, self.heading)
    }
}

fn start_value(margin: &Bernstein) -> f64 {
    margin.coefficients()[0]
}

/// A half angle, and D ϑ′² there.
#[derive(Clone, Copy, Debug)]
struct OrbitPoint {
    x: f64,
    y: f64,
    twice_kinetic: f64,
}

impl OrbitPoint {
    const fn new(x: f64, y: f64, twice_kinetic: f64) -> Self {
        Self {
            x,
            y,
            twice_kinetic,
        }
    }

    const fn direction(&self) -> HalfAngle {
        [self.x, self.y]
    }
}

#[derive(Clone, Copy, Debug)]
struct OrbitArc {
    from: OrbitPoint,
    to: OrbitPoint,
    /// Sine of the half angle between them.
    sin_width: f64,
    pass: OrbitPass,
}

impl OrbitArc {
    /// Sine of the half angle that is passed at a barycentric coordinate, against the motion
    /// negative.
    fn passed(&self, at: f64) -> f64 {
        let along = self.from.x * self.to.x + self.from.y * self.to.y;
        let sine = at * self.sin_width;
        let passed = sine / libm::hypot(sine, 1.0 - at + at * along);
        if self.pass == OrbitPass::WayBack {
            -passed
        } else {
            passed
        }
    }
}
