//! The equations of one hoop, and its phases from them.

use crate::mechanics::solvability::is_solvable;
use crate::mechanics::{RollingLaw, SlidingLaw};
use crate::model::{Body, Direction, Heavy, Hoop};
use crate::modes::rolling::margin_forms;

use super::fallback::{Fallback, FallbackCounts};
use super::orbit::{Orbit, Reached};
use super::roll::{self, MarginTables, Margins, RollEnd};
use super::slide::{self, MotionFrame, SlideEnd, SlidePoint, SlideTables};
use super::slope::{self, SlopeTables};
use super::state::EngineState;

#[derive(Clone, Debug)]
pub(super) struct HoopModel {
    pub(super) body: Heavy,
    /// For σ = −1 and σ = +1, as they are and mirrored.
    sliding: [[SlidingLaw; 2]; 2],
    pub(super) rolling: RollingLaw,
    pub(super) margins: Margins,
    /// P > 0 at every angle, with μs, too: then never more than one motion is consistent.
    pub(super) is_solvable: bool,
    /// What has been computed of slides and of rolling, to be kept.
    cells: SlideTables,
    octants: MarginTables,
    /// Rolling to positive and to negative angles on a slope.
    ramps: Option<Box<[SlopeTables; 2]>>,
    pub(super) fallbacks: FallbackCounts,
}

impl HoopModel {
    /// None of a massless hoop.
    pub(super) fn new(hoop: &Hoop) -> Option<Self> {
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        Some(Self {
            body,
            sliding: [body, body.mirrored()].map(|body| {
                Direction::ALL.map(|direction| SlidingLaw::of_body(body, hoop.mu_k(), direction))
            }),
            rolling: RollingLaw::of(hoop),
            margins: margin_forms(hoop, 1.0)?,
            is_solvable: is_solvable(&body, hoop.mu_s().max(hoop.mu_k())),
            cells: SlideTables::default(),
            octants: MarginTables::default(),
            ramps: (hoop.slope() != 0.0)
                .then(|| Box::new([1.0, -1.0].map(|travel| SlopeTables::new(hoop, travel)))),
            fallbacks: FallbackCounts::default(),
        })
    }

    pub(super) const fn sliding(&self, direction: Direction) -> &SlidingLaw {
        match direction {
            Direction::Negative => &self.sliding[0][0],
            Direction::Positive => &self.sliding[0][1],
        }
    }

    /// The orbit of rolling through a place, in the direction of motion.
    fn orbit(&self, place: &EngineState) -> Result<Orbit<'_>, Fallback> {
        let (state, travel) = (place.state, place.travel());
        Orbit::enter(
            &self.rolling,
            travel * state.theta,
            travel * state.theta_rate,
        )
        .ok_or(Fallback::Separatrix)
    }

    /// The end of the rolling that begins at a place, in the direction of motion, on the limit of
    /// static friction or not; by what is kept, if the motion is long.
    pub(super) fn roll(
        &self,
        place: &EngineState,
        on_limit: bool,
        is_long: bool,
    ) -> Result<RollEnd, Fallback> {
        if let Some(ramps) = &self.ramps {
            return slope::follow(ramps, place);
        }
        if place.state.theta_rate == 0.0 {
            // Gravity decides where it goes.
            return Err(Fallback::Standstill);
        }
        roll::follow(
            &self.orbit(place)?,
            &self.margins,
            on_limit,
            is_long.then_some(&self.octants),
        )
    }

    /// Where rolling from a place, to a slip, is after a time.
    pub(super) fn rolled(&self, place: &EngineState, time: f64) -> Option<Reached> {
        match &self.ramps {
            Some(ramps) => slope::after(ramps, place, time),
            None => self.orbit(place).ok()?.after(time),
        }
    }

    /// Whether rolling is left to the simulation: on a slope what is kept is not worth making for
    /// few phases.
    pub(super) const fn leaves_rolling(&self, is_long: bool) -> bool {
        self.ramps.is_some() && !is_long
    }

    /// The end of the slide that begins at a place, or where it is cut after the time `allowed`;
    /// `from_limit` where η′ = η″ = 0 at the start.
    pub(super) fn slide(
        &self,
        place: &EngineState,
        direction: Direction,
        from_limit: bool,
        allowed: f64,
        is_long: bool,
    ) -> Result<SlideEnd, Fallback> {
        let (state, sign) = (place.state, place.travel());
        let (sin, cos) = place.direction;
        let law = self.sliding(direction);
        let u = place.u();
        let (alpha, beta) = law.slip_acceleration(sin, cos);
        let sigma = direction.sign();
        let frame = MotionFrame {
            laws: &self.sliding,
            sign,
            theta: sign * state.theta,
            sigma: sign * sigma,
            integral: sign * (state.slip - state.theta_rate * law.lever(sin, cos)),
        };
        let here = SlidePoint {
            z: 0.0,
            u,
            elapsed: 0.0,
            slip: sigma * state.slip,
            slip_acceleration: if from_limit {
                0.0
            } else {
                sigma * (alpha + beta * u)
            },
            direction: (sign * sin, cos),
        };
        slide::follow(
            frame,
            here,
            from_limit,
            allowed,
            is_long.then_some(&self.cells),
        )
    }
}
