//! Rolling along one orbit, to its slip.
//!
//! Where it slips is a zero of the forms of [`crate::rolling`] on the arcs ahead, isolated in Bernstein form; when, an elliptic
//! integral. Both are those of the exact solver; only the root is found with fewer steps, and no time is computed that is not
//! needed.
//!
//! Everything is seen in the direction of motion.

use core::f64::consts::TAU;

use crate::equations::RollingLaw;
use crate::form::{HalfAngle, on_arc};
use crate::hoop::Hoop;
use crate::rolling::{margin_forms, time_from_bottom};
use crate::trig::sincos;

use super::super::duration::duration;
use super::super::roll::{RollEnd, SlipPoint};
use super::super::solver::MIN_RATE;

/// Orbits whose energy over the top is a smaller part of their constant are left to the exact solver.
const SEPARATRIX: f64 = 1e-9;

/// Part of an orbit between two directions of the half angle.
#[derive(Clone, Copy, Debug)]
struct Arc {
    from: HalfAngle,
    to: HalfAngle,
    pass: Pass,
}

#[derive(Clone, Copy, Debug)]
enum Pass {
    First,
    NextTurn,
    WayBack,
}

/// An orbit entered at a state: z = −cos ϑ/2 and y = sin ϑ/2 ≥ 0 there.
#[derive(Clone, Copy, Debug)]
struct Orbit<'a> {
    law: &'a RollingLaw,
    rotates: bool,
    lap: f64,
    z: f64,
    y: f64,
    /// D ϑ′².
    kinetic: f64,
    /// |K − D(0)| and 4ℓ̂k².
    excess: f64,
    swing: f64,
}

/// Follows the orbit on which rolling holds at an angle, with a positive rate. None next to the separatrix.
pub(super) fn follow(hoop: &Hoop, law: &RollingLaw, theta: f64, theta_rate: f64) -> Option<RollEnd> {
    let mut lap = (theta / TAU).floor();
    let (sin, cos) = sincos(0.5 * theta);
    let flip = if lap.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
    let (mut x, mut y) = (flip * cos, flip * sin);
    if y < 0.0 {
        // Rounding put the angle on the wrong side of a multiple of 2π.
        lap += if x > 0.0 { -1.0 } else { 1.0 };
        (x, y) = (-x, -y);
    }
    let z = -x;
    let four_l = 4.0 * law.offset;
    let kinetic = (law.bottom + four_l * z * z) * theta_rate * theta_rate;
    let over_top = kinetic - four_l * y * y;
    let over_bottom = kinetic + four_l * z * z;
    let k = law.bottom + over_bottom;
    if over_top.abs() <= SEPARATRIX * k {
        return None;
    }
    let rotates = over_top > 0.0;
    let swing = if rotates { four_l } else { over_bottom };
    let orbit = Orbit { law, rotates, lap, z, y, kinetic, excess: over_top.abs(), swing };
    let forms = margin_forms(hoop, k)?;
    for arc in orbit.arcs() {
        let mut first: Option<(f64, usize)> = None;
        for (side, form) in forms.iter().enumerate() {
            let margin = form.restricted(arc.from, arc.to);
            // No crossing without a change of sign.
            if margin.0.iter().all(|c| *c > 0.0) {
                continue;
            }
            if let Some(bracket) = margin.bernstein().first_crossing() {
                let at = bracket.refine_from_secant(|t| margin.value_and_slope([1.0 - t, t], [-1.0, 1.0]));
                if first.is_none_or(|(before, _)| at < before) {
                    first = Some((at, side));
                }
            }
        }
        if let Some((at, side)) = first {
            return orbit.slip(&arc, at, side);
        }
    }
    Some(RollEnd::Never)
}

impl Orbit<'_> {
    /// The arcs that lie ahead, until every point of the orbit has been passed.
    fn arcs(&self) -> impl Iterator<Item = Arc> {
        let here = [-self.z, self.y];
        let bottom = [0.0, 1.0];
        let past_bottom = self.z >= 0.0;
        let arc = |from, to, pass| Arc { from, to, pass };
        let farthest = if self.rotates {
            [-1.0, 0.0]
        } else {
            let four_l = 4.0 * self.law.offset;
            [-(self.swing / four_l).sqrt(), (self.excess / four_l).sqrt()]
        };
        let first = (!past_bottom).then(|| arc(here, bottom, Pass::First));
        let second = arc(if past_bottom { here } else { bottom }, farthest, Pass::First);
        let (third, fourth) = if self.rotates {
            let third = arc([1.0, 0.0], if past_bottom { bottom } else { here }, Pass::NextTurn);
            (third, past_bottom.then(|| arc(bottom, here, Pass::NextTurn)))
        } else {
            let [x, y] = farthest;
            (arc(farthest, bottom, Pass::WayBack), Some(arc(bottom, [-x, y], Pass::WayBack)))
        };
        [first, Some(second), Some(third), fourth].into_iter().flatten().filter(|arc| arc.from != arc.to)
    }

    /// Sine and cosine of the phase at a point, by z, y, and D ϑ′² there.
    fn phase(&self, z: f64, y: f64, kinetic: f64) -> (f64, f64) {
        if self.rotates {
            (z, y)
        } else {
            let sine = z * (4.0 * self.law.offset / self.swing).sqrt();
            (sine.clamp(-1.0, 1.0), (kinetic / self.swing).sqrt())
        }
    }

    /// Time from the entry to a phase on an arc.
    fn time(&self, (sine, cosine): (f64, f64), pass: Pass) -> f64 {
        let orbit = (self.excess, self.swing);
        let (s0, c0) = self.phase(self.z, self.y, self.kinetic);
        let (s1, c1) = match pass {
            Pass::First => (sine, cosine),
            Pass::NextTurn => (-sine, -cosine),
            Pass::WayBack => (sine, -cosine),
        };
        let turned = libm::atan2(s1 * c0 - c1 * s0, c1 * c0 + s1 * s0);
        // Up to half a turn of the phase, give or take rounding.
        let arc = if turned < -1.0 { turned + TAU } else { turned.max(0.0) };
        if let Some(time) = duration(self.law.bottom, orbit, (s0, c0), arc) {
            return time;
        }
        let from_bottom = |phase| time_from_bottom(self.law.bottom, orbit, phase);
        let half_period = || 2.0 * from_bottom((1.0, 0.0));
        let (entered, reached) = (from_bottom((s0, c0)), from_bottom((sine, cosine)));
        let elapsed = match pass {
            Pass::First => reached - entered,
            Pass::NextTurn => half_period() + reached - entered,
            Pass::WayBack => half_period() - reached - entered,
        };
        elapsed.max(0.0)
    }

    /// The slip at a point of an arc.
    fn slip(&self, arc: &Arc, at: f64, side: usize) -> Option<RollEnd> {
        let [x, y] = on_arc(arc.from, arc.to, at);
        let z = -x;
        let four_l = 4.0 * self.law.offset;
        let d = self.law.bottom + four_l * z * z;
        // K − D changes by 4ℓ̂ (z0² − z²).
        let kinetic = if self.rotates {
            self.excess + four_l * y * y
        } else {
            (self.kinetic + four_l * (self.z - z) * (self.z + z)).max(0.0)
        };
        let rate = (kinetic / d).sqrt();
        if rate < MIN_RATE {
            return None;
        }
        let (lap, rate) = match arc.pass {
            Pass::First => (self.lap, rate),
            Pass::NextTurn => (self.lap + 1.0, rate),
            Pass::WayBack => (self.lap, -rate),
        };
        let angle = 2.0 * libm::atan2(y, -z);
        Some(RollEnd::Slip {
            elapsed: self.time(self.phase(z, y, kinetic), arc.pass),
            theta: TAU * lap + angle,
            theta_rate: rate,
            point: SlipPoint { side, angle },
            stop: 0,
            direction: (-2.0 * y * z, z * z - y * y),
        })
    }
}
