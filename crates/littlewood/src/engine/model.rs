//! The equations and tables of one hoop, and its phases from them.

use std::sync::OnceLock;

use crate::math::trig::Angle;
use crate::mechanics::solvability::is_solvable;
use crate::mechanics::{RollingLaw, SlidingLaw};
use crate::model::{Body, Heavy, Hoop, SlipDirection, weight_of_slides};
use crate::modes::rolling::HalfAngleOrbit;

use super::error_bound::{ErrorModel, TurningPointError};
use super::fallback::{Fallback, FallbackCounts};
use super::half_swings::{HalfSwing, HalfSwings};
use super::orbit::OrbitPoint;
use super::roll::{self, MarginTables, Margins, RollEnd, margins_of};
use super::slide::{
    MotionFrame, ResistedRollEnd, RollStart, RollTables, SlideEnd, SlideEvent, SlideLaws,
    SlidePoint, SlideProblem, SlideTables, solve_slide,
};
use super::slip_slides::{SlideSource, SlipSlides};
use super::slope::{self, SlopeTables};
use super::state::EngineState;

#[derive(Clone, Debug)]
pub(super) struct HoopModel {
    pub(super) body: Heavy,
    sliding: SlideLaws,
    pub(super) rolling: RollingLaw,
    pub(super) margins: Margins,
    pub(super) error_model: ErrorModel,
    /// What a unit of the length of a slide counts.
    pub(super) slide_weight: f64,
    /// P > 0 at every angle, with μs, too: then never more than one motion is consistent. False with
    /// rolling resistance, of which this says nothing.
    pub(super) is_solvable: bool,
    slide_tables: SlideTables,
    /// Slides out of rolling; none where they are followed.
    slip_slides: Option<SlipSlides>,
    margin_tables: MarginTables,
    /// Rolling to positive and to negative angles on a slope.
    slope_tables: Option<Box<[SlopeTables; 2]>>,
    /// Rolling with resistance.
    resisted_rolling: Option<Box<RollTables>>,
    half_swings: OnceLock<Option<Box<HalfSwings>>>,
    pub(super) fallbacks: FallbackCounts,
}

/// θ′² below which energies on a slope underflow: parts ε of ε of it are still normal numbers.
const MIN_SQUARE_OF_RATE: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);

/// How a slide begins, and for how long it is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlideStart {
    pub(super) slip: SlipDirection,
    /// The direction of rotation, with rolling resistance.
    pub(super) towards: Option<f64>,
    /// Whether η′ = η″ = 0.
    pub(super) from_limit: bool,
    /// Whether it begins where rolling slips, and slides that do are interpolated.
    pub(super) is_interpolated: bool,
    pub(super) time_left: f64,
}

impl HoopModel {
    /// None of a massless hoop.
    pub(super) fn new(hoop: &Hoop) -> Option<Self> {
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        let chi = hoop.rolling_resistance();
        Some(Self {
            body,
            // 0 − χ is not −0.
            sliding: [chi, 0.0 - chi].map(|resistance| {
                [body, body.mirrored()].map(|body| {
                    SlipDirection::ALL.map(|direction| SlidingLaw {
                        resistance,
                        ..SlidingLaw::of_body(body, hoop.mu_k(), direction)
                    })
                })
            }),
            rolling: RollingLaw::of(hoop),
            margins: margins_of(hoop, 1.0)?,
            error_model: ErrorModel::new(&body, hoop.mu_s(), chi),
            slide_weight: weight_of_slides(hoop),
            is_solvable: chi == 0.0 && is_solvable(&body, hoop.mu_s().max(hoop.mu_k())),
            slide_tables: SlideTables::default(),
            slip_slides: SlipSlides::are_interpolated(hoop).then(SlipSlides::default),
            margin_tables: MarginTables::default(),
            slope_tables: (hoop.slope() != 0.0)
                .then(|| Box::new([1.0, -1.0].map(|heading| SlopeTables::new(hoop, heading)))),
            resisted_rolling: (chi > 0.0).then(|| Box::new(RollTables::new(hoop, &body))),
            half_swings: OnceLock::new(),
            fallbacks: FallbackCounts::default(),
        })
    }

    /// The equations of a slide that turns to positive angles. Only rolling resistance makes those to
    /// negative ones differ, and they only in θ″ and η″.
    pub(super) const fn sliding(&self, direction: SlipDirection) -> &SlidingLaw {
        match direction {
            SlipDirection::Negative => &self.sliding[0][0][0],
            SlipDirection::Positive => &self.sliding[0][0][1],
        }
    }

    /// The same in a direction of rotation.
    pub(super) const fn sliding_towards(
        &self,
        direction: SlipDirection,
        heading: f64,
    ) -> &SlidingLaw {
        let is_against = (heading < 0.0) as usize;
        &self.sliding[is_against][0][direction.index()]
    }

    /// The orbit of rolling through a state, in the direction of motion.
    fn orbit(&self, start: &EngineState) -> Result<HalfAngleOrbit, Fallback> {
        let (state, heading) = (start.state, start.heading());
        HalfAngleOrbit::enter(
            &self.rolling,
            heading * state.theta,
            heading * state.theta_rate,
        )
        .ok_or(Fallback::Separatrix)
    }

    /// The end of the rolling that begins at a state, in the direction of motion, on the limit of
    /// static friction or not.
    pub(super) fn roll(
        &self,
        start: &EngineState,
        on_limit: bool,
        uses_tables: bool,
    ) -> Result<RollEnd, Fallback> {
        if let Some(tables) = &self.slope_tables {
            if on_limit {
                // Rounding would decide whether the hoop slips at once.
                return Err(Fallback::FrictionLimit);
            }
            if start.u() < MIN_SQUARE_OF_RATE {
                // Gravity decides where it goes.
                return Err(Fallback::Standstill);
            }
            return slope::solve_roll(tables, start);
        }
        if start.state.theta_rate == 0.0 {
            // Gravity decides where it goes.
            return Err(Fallback::Standstill);
        }
        roll::solve_roll(
            &self.orbit(start)?,
            &self.margins,
            on_limit,
            uses_tables.then_some(&self.margin_tables),
        )
    }

    /// Where rolling from a state, before its slip, is after a time.
    pub(super) fn rolled(&self, start: &EngineState, time: f64) -> Option<OrbitPoint> {
        match &self.slope_tables {
            Some(tables) => slope::after(tables, start, time),
            None => self.orbit(start).ok()?.after(time),
        }
    }

    /// The end of the rolling with resistance that begins at a state, in the direction of motion.
    pub(super) fn roll_resisted(
        &self,
        start: &EngineState,
        heading: f64,
        time_left: f64,
        uses_tables: bool,
    ) -> Option<Result<ResistedRollEnd, Fallback>> {
        let tables = self.resisted_rolling.as_ref()?;
        Some(tables.solve(&RollStart {
            mirror: heading,
            theta: heading * start.state.theta,
            angle: start.angle.mirrored_by(heading),
            u: start.u(),
            time_left,
            uses_tables,
        }))
    }

    /// The half swing that begins at rest, if it is interpolated.
    pub(super) fn half_swing(&self, start: &EngineState, heading: f64) -> Option<HalfSwing> {
        let tables = self.resisted_rolling.as_ref()?;
        let half_swings = self
            .half_swings
            .get_or_init(|| HalfSwings::new(tables).map(Box::new));
        half_swings
            .as_ref()?
            .from(heading * start.state.theta, tables)
    }

    /// 2 θ″ where a half swing ends, and a bound of θ′² on the way from where it begins.
    pub(super) fn turning_point_error(
        &self,
        start: Angle,
        end: Angle,
    ) -> Option<TurningPointError> {
        let tables = self.resisted_rolling.as_ref()?;
        let ([_, u], [u_slope, _]) = (tables.at_rest(start), tables.at_rest(end));
        Some(TurningPointError { u, u_slope })
    }

    /// Whether rolling is left to the simulation: on a slope tables are not worth making for few
    /// phases.
    pub(super) const fn leaves_rolling(&self, uses_tables: bool) -> bool {
        self.slope_tables.is_some() && !uses_tables
    }

    /// The end of the slide that begins at a state, or where it is at the time limit.
    pub(super) fn slide(
        &self,
        start: &EngineState,
        slide: SlideStart,
        uses_tables: bool,
    ) -> Result<SlideEnd, Fallback> {
        let (state, angle) = (start.state, start.angle);
        // From rest it moves away from the turning point at which it is: none is ahead.
        let mirror = slide.towards.unwrap_or_else(|| {
            let law = self.sliding(slide.slip);
            let backs = state.theta_rate == 0.0 && law.u_growth(angle.sin, angle.cos) < 0.0;
            if backs { -1.0 } else { start.heading() }
        });
        let law = self.sliding_towards(slide.slip, mirror);
        let u = start.u();
        let (alpha, beta) = law.slip_acceleration(angle.sin, angle.cos);
        let sigma = slide.slip.sign();
        let slip_coefficient = law.slip_coefficient(angle.sin, angle.cos);
        let frame = MotionFrame {
            laws: &self.sliding,
            is_against: false,
            mirror,
            theta: mirror * state.theta,
            sigma: mirror * sigma,
            integral: mirror * (state.slip - state.theta_rate * slip_coefficient),
        };
        let start = SlidePoint {
            z: 0.0,
            u,
            elapsed: 0.0,
            slip: sigma * state.slip,
            slip_acceleration: if slide.from_limit {
                0.0
            } else {
                sigma * (alpha + beta * u)
            },
            angle: angle.mirrored_by(mirror),
        };
        if slide.is_interpolated
            && let Some(event) = self.interpolated(&frame, &start)
            && event.elapsed <= slide.time_left
        {
            return Ok(SlideEnd::Event(event));
        }
        solve_slide(SlideProblem {
            frame,
            start,
            from_limit: slide.from_limit,
            time_left: slide.time_left,
            tables: uses_tables.then_some(&self.slide_tables),
        })
    }

    /// The end of a slide out of rolling, if it is interpolated.
    fn interpolated(&self, frame: &MotionFrame<'_>, start: &SlidePoint) -> Option<SlideEvent> {
        let slides = self.slip_slides.as_ref()?;
        let event = slides.end(self.slide_source(), frame, start)?;
        Some(event.mirrored_by(frame.mirror))
    }

    /// What slides out of rolling are computed from.
    pub(super) const fn slide_source(&self) -> SlideSource<'_> {
        SlideSource {
            laws: &self.sliding,
            rolling: &self.rolling,
            margins: &self.margins,
            tables: &self.slide_tables,
        }
    }
}
