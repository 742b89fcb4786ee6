//! A slide, followed step by step to its event.
//!
//! Everything is seen in the frame of motion, ϑ growing. On a step
//!
//! - 1 − h cos ϑ u can fall through zero only where sin ϑ < 0, since there its derivative is h sin ϑ θ′³: where sin ϑ keeps its sign,
//!   or turns from positive to negative, its sign at the end tells whether it has; over the top its sign there tells;
//! - the signs of η″ tell whether η′ is monotone, or has one extremum: its values there and at the end tell whether it has
//!   vanished.

use crate::equations::{SlidingLaw, contact};

use super::super::piece::{Piece, Way, Waypoint};
use super::super::slide::SlideEvent;
use super::step::{Signs, Step};

/// Most steps: a slide over more than a few turns is left to the exact solver.
const MOST_STEPS: usize = 48;

/// Forces and slips within this of zero are in doubt.
const UNCERTAIN: f64 = 1e-9;

/// Where a slide begins, in the frame of motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begin {
    pub(super) theta: f64,
    /// Positive.
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
}

/// Follows a slide in the direction `sigma` of slip to its event, in the frame of motion. None where a sign is in doubt, θ′ comes
/// close to zero or P does, or the slide takes longer than a few turns.
pub(super) fn follow(law: &SlidingLaw, sigma: f64, begin: &Begin) -> Option<SlideEvent> {
    let h = law.body.h;
    let (sin, cos) = begin.direction;
    let (alpha, beta) = law.slip_acceleration(sin, cos);
    let u = begin.theta_rate * begin.theta_rate;
    let integral = begin.slip - begin.theta_rate * law.lever(sin, cos);
    let mut here = Waypoint {
        z: 0.0,
        u,
        elapsed: 0.0,
        slip: sigma * begin.slip,
        slip_acceleration: sigma * (alpha + beta * u),
        direction: (sin, cos),
    };
    let mut theta = begin.theta;
    for _ in 0..MOST_STEPS {
        let step = Step::new(law, sigma, here.direction, here.u)?;
        let way = Way { law, piece: &step, travel: 1.0, sigma, integral };
        let event = |at: &Waypoint, lifts_off: bool| SlideEvent {
            elapsed: at.elapsed,
            theta: theta + step.turned_by(at.z),
            theta_rate: at.u.sqrt(),
            slip: if lifts_off { sigma * at.slip } else { 0.0 },
            direction: at.direction,
            lifts_off,
        };
        let (sin, cos) = step.direction(1.0);
        let u = step.u(1.0);
        let w = contact(1.0, h, cos * u);
        let lifts_off = if here.direction.0 < 0.0 && sin >= 0.0 {
            // Over the top.
            let top = -here.direction.0 / ((1.0 + here.direction.1) * step.width);
            let at_top = contact(1.0, h, step.u(top.min(1.0)));
            if at_top < UNCERTAIN {
                return None;
            }
            false
        } else {
            if w.abs() < UNCERTAIN {
                return None;
            }
            w < 0.0
        };
        let there = if lifts_off {
            way.lift_off(&here, 1.0)?
        } else {
            let elapsed = here.elapsed + step.whole_time();
            let (alpha, beta) = law.slip_acceleration(sin, cos);
            Waypoint {
                z: 1.0,
                u,
                elapsed,
                slip: way.slip(u.sqrt(), law.lever(sin, cos), elapsed),
                slip_acceleration: sigma * (alpha + beta * u),
                direction: (sin, cos),
            }
        };
        match step.signs {
            Signs::Unknown => return None,
            // η′ must rise from zero.
            Signs::Negative | Signs::Rising if here.slip <= 0.0 => return None,
            Signs::Positive | Signs::Negative | Signs::Falling | Signs::Rising => {}
        }
        if there.slip <= 0.0 {
            return Some(event(&way.rest(&here, &there)?, false));
        }
        match step.signs {
            Signs::Positive | Signs::Negative => {}
            // Where η″ is next to zero it is not known how it changes its sign; η′ changes there by no more than this.
            Signs::Falling => {
                if there.slip <= step.doubt * (there.elapsed - here.elapsed) {
                    return None;
                }
            }
            // A minimum inside.
            Signs::Rising | Signs::Unknown => return None,
        }
        if lifts_off {
            return Some(event(&there, true));
        }
        theta += step.turned_by(1.0);
        here = Waypoint { z: 0.0, ..there };
    }
    None
}
