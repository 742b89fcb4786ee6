//! The slides out of rolling of one body on a level plane: a family with one parameter
//! (docs/engine.md).
//!
//! Rolling slips on curves of the phase plane, |F| = μs N, with η′ = 0. What follows up to the next
//! event is therefore a function of the angle of the slip. On parts of a turn the end of the slide
//! is a polynomial through slides that [`solve_slide`] has followed.
//!
//! That no other event comes first is proved for every slide, not for those at the nodes. Slides do
//! not cross in the (ϑ, u) plane: where the curve crosses them to one side only, all slides of a
//! part lie between the first and the last, and what is linear in u has its extremes on these two.
//! So η″ falls through zero at most once on every one if it does between those two, and η′ is
//! positive until it vanishes for the first and only time. And w falls through zero at most once
//! before the top, so that its sign at the end decides.

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::math::form::Trigonometric;
use crate::math::trig::Angle;
use crate::mechanics::{RollingLaw, contact};
use crate::model::{Hoop, SlipDirection};

use super::interpolant::{Basis, Interpolant, NODES, Tolerance};
use super::roll::{MarginForm, Margins, RoundedNumber};
use super::slide::{
    MotionFrame, SIGN_TOLERANCE, SingleFall, SlideEnd, SlideEvent, SlideLaws, SlidePoint,
    SlideProblem, SlideStrip, SlideTables, StripSide, slip_scale, solve_slide,
};

/// Parts of a turn of the angle of the slip, before they are halved: not wider than the intervals
/// on which the order of slides is examined.
const PARTS: usize = 32;

/// How often a part is halved where its slides do not end alike, or their polynomials have not
/// converged.
const HALVINGS: usize = 3;

/// Angle, time and rate at the end of a slide are told to a few units in the last place of the
/// largest of a part, or of 1: so much is rounding of the slides at the nodes.
const TOLERANCE: f64 = 2e-15;

/// By how many tolerances the polynomials may miss slides that are not at nodes.
const MAX_MISS: f64 = 8.0;

/// The first integral of a slide is the same at its interpolated end as at its start to so many
/// roundings of its terms: three numbers, each known to a few units in the last place.
const MAX_RESIDUAL: f64 = 64.0 * f64::EPSILON;

/// What the slides are computed from.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlideSource<'a> {
    pub(super) laws: &'a SlideLaws,
    pub(super) rolling: &'a RollingLaw,
    pub(super) margins: &'a Margins,
    pub(super) tables: &'a SlideTables,
}

/// The slides out of rolling of a hoop, computed when a motion first needs them, and the same
/// whichever motion that is.
#[derive(Clone, Debug, Default)]
pub(super) struct SlipSlides(OnceLock<Families>);

#[derive(Clone, Debug)]
struct Families {
    basis: Basis,
    /// By [`SlipDirection::index`] in the frame of motion.
    families: [Family; 2],
}

/// The slides in one direction in the frame of motion.
#[derive(Clone, Debug)]
struct Family {
    slip: SlipDirection,
    /// θ′² on the curve, as a quotient.
    numerator: Trigonometric,
    denominator: Trigonometric,
    /// Angles at which the curve crosses the slides to the other side, or goes to infinity.
    turns: Vec<f64>,
    parts: [Box<[OnceLock<Fit>]>; HALVINGS + 1],
}

/// The slides that begin on a part of a turn.
#[derive(Clone, Debug)]
enum Fit {
    Interpolated(Box<FittedSlides>),
    /// Its halves may do better.
    Halved,
    /// They are followed.
    Followed,
}

#[derive(Clone, Debug)]
struct FittedSlides {
    lifts_off: bool,
    /// Angle turned, time, and θ′ at the end.
    ends: Interpolant<3>,
    /// Up to where η″ of all of them falls through zero at most once.
    fall: SingleFall,
}

/// The ends of a part of a turn.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    left: f64,
    right: f64,
}

impl Bounds {
    fn middle(self) -> f64 {
        0.5 * (self.left + self.right)
    }

    /// Angles from which slides are compared with the polynomials: none is a node.
    fn probes(self) -> [f64; 3] {
        [self.left, self.middle(), self.right]
    }

    fn hold(self, angle: f64) -> bool {
        self.left < angle && angle < self.right
    }
}

/// The angle of a slip, and the end of the slide from there.
#[derive(Clone, Copy, Debug)]
struct Sample {
    angle: f64,
    event: SlideEvent,
}

impl SlipSlides {
    /// Whether a hoop has slides out of rolling that begin with η″ ≠ 0 and end by friction. Behind
    /// others, rounding decides what follows. On a slope the curves are others in each direction of
    /// motion. With rolling resistance they are other curves than those of [`Family`].
    pub(super) fn are_interpolated(hoop: &Hoop) -> bool {
        let is_level = hoop.slope() == 0.0 && hoop.rolling_resistance() == 0.0;
        is_level && hoop.mu_k() > 0.0 && hoop.mu_s() > hoop.mu_k()
    }

    /// The end of a slide from a slip out of rolling. None where it has to be followed.
    pub(super) fn end(
        &self,
        source: SlideSource<'_>,
        frame: &MotionFrame<'_>,
        start: &SlidePoint,
    ) -> Option<SlideEvent> {
        let Families { basis, families } = self.0.get_or_init(|| Families::new(source));
        let family = &families[usize::from(frame.sigma > 0.0)];
        let turns = (frame.theta / TAU).floor();
        let angle = frame.theta - TAU * turns;
        let slides = family.find(angle, basis, source)?;
        let [turned, elapsed, theta_rate] = slides.ends.at(angle);
        let is_proved = angle + turned <= slides.fall.to
            && start.slip_acceleration > slides.fall.sign_uncertainty;
        if !is_proved {
            return None;
        }
        let law = &source.laws[0][0][family.slip.index()];
        let angle = start.angle.plus(Angle::of(turned));
        let (h, u) = (law.body.h, theta_rate * theta_rate);
        let contact_margin = RoundedNumber {
            value: contact(1.0, h, angle.cos * u),
            scale: 1.0 + h * u,
        };
        // By the first integral, from the start of this slide.
        let slip = RoundedNumber {
            value: frame.sigma
                * (frame.integral + theta_rate * law.slip_coefficient(angle.sin, angle.cos)
                    - law.mean_slip_loss() * elapsed),
            scale: slip_scale(u, frame.integral),
        };
        let (zero, other) = if slides.lifts_off {
            (contact_margin, slip)
        } else {
            (slip, contact_margin)
        };
        // Where η″ is next to zero it is not known how it changes its sign; η′ changes there by no
        // more than this.
        let uncertain = slides.fall.sign_uncertainty * elapsed;
        let is_event = zero.value.abs() <= MAX_RESIDUAL * zero.scale
            && other.value > SIGN_TOLERANCE * other.scale + uncertain;
        is_event.then_some(SlideEvent {
            elapsed,
            theta: frame.theta + turned,
            theta_rate,
            slip: if slides.lifts_off {
                frame.sigma * slip.value
            } else {
                0.0
            },
            angle,
            lifts_off: slides.lifts_off,
            turning_points: 0.0,
        })
    }
}

impl Families {
    fn new(source: SlideSource<'_>) -> Self {
        Self {
            basis: Basis::new(),
            families: SlipDirection::ALL.map(|slip| Family::new(source, slip)),
        }
    }
}

impl Family {
    fn new(source: SlideSource<'_>, slip: SlipDirection) -> Self {
        let MarginForm { a, b } = &source.margins[slip.index()];
        let [a, b] = [a, b].map(Trigonometric::from_form);
        // On the orbit of the level L = −A/B, D u = L − (D − D(π)).
        let numerator = a
            .plus(&source.rolling.above_bottom().times(&b))
            .scaled(-1.0);
        let denominator = source.rolling.denominator_polynomial().times(&b);
        // The curve crosses slides, du/dϑ = 2 m (q/P) (1 − h cos ϑ u), to the other side where
        // (u′ of the curve − du/dϑ) P, times the square of the denominator, changes its sign.
        let law = &source.laws[0][0][slip.index()];
        let (mass, h) = (law.body.mass, law.body.h);
        let q = Trigonometric::linear(-law.friction, h, -law.friction * h);
        let p = Trigonometric::linear(law.body.inertia, 0.0, 0.0)
            .plus(&Trigonometric::linear(0.0, mass * h, 0.0).times(&q));
        let slope = numerator
            .derivative()
            .times(&denominator)
            .minus(&numerator.times(&denominator.derivative()));
        let w = denominator.minus(&Trigonometric::linear(0.0, 0.0, h).times(&numerator));
        let crossing = slope
            .times(&p)
            .minus(&q.scaled(2.0 * mass).times(&w).times(&denominator));
        let mut turns = crossing.sign_changes();
        turns.extend(denominator.sign_changes());
        Self {
            slip,
            numerator,
            denominator,
            turns,
            parts: core::array::from_fn(|halvings| {
                (0..PARTS << halvings).map(|_| OnceLock::new()).collect()
            }),
        }
    }

    /// The slides that end as the one from an angle of a turn; none where that has to be followed.
    fn find(&self, angle: f64, basis: &Basis, source: SlideSource<'_>) -> Option<&FittedSlides> {
        let narrowest = (angle * ((PARTS << HALVINGS) as f64 / TAU)) as usize;
        for (halvings, parts) in self.parts.iter().enumerate() {
            let number = narrowest >> (HALVINGS - halvings);
            let part = parts
                .get(number)?
                .get_or_init(|| self.part(halvings, number, basis, source));
            match part {
                Fit::Interpolated(slides) => return Some(slides),
                Fit::Halved => {}
                Fit::Followed => return None,
            }
        }
        None
    }

    fn part(&self, halvings: usize, number: usize, basis: &Basis, source: SlideSource<'_>) -> Fit {
        let width = TAU / (PARTS << halvings) as f64;
        let bounds = Bounds {
            left: number as f64 * width,
            right: (number + 1) as f64 * width,
        };
        if self.turns.iter().any(|turn| bounds.hold(*turn)) {
            return Fit::Halved;
        }
        let probes = bounds.probes().map(|angle| self.solved(angle, source));
        if probes.iter().all(Option::is_none) {
            return Fit::Followed;
        }
        let [Some(first), Some(middle), Some(last)] = probes else {
            return Fit::Halved;
        };
        self.fitted(bounds, &[first, middle, last], basis, source)
            .map_or(Fit::Halved, |slides| Fit::Interpolated(Box::new(slides)))
    }

    /// The slides from a part on which the curve crosses them to one side only, with those from its
    /// ends and its middle, if all are known to end alike.
    fn fitted(
        &self,
        bounds: Bounds,
        probes: &[SlideEvent; 3],
        basis: &Basis,
        source: SlideSource<'_>,
    ) -> Option<FittedSlides> {
        let lifts_off = probes[0].lifts_off;
        let is_alike = |event: &SlideEvent| event.lifts_off == lifts_off;
        if !probes.iter().all(is_alike) {
            return None;
        }
        let fall = self.single_fall(bounds, probes, source)?;
        let numbers = |end: Sample| {
            let Sample { angle, event } = end;
            [event.theta - angle, event.elapsed, event.theta_rate]
        };
        let mut values = [[0.0; 3]; NODES];
        for (value, angle) in values
            .iter_mut()
            .zip(basis.nodes(bounds.left, bounds.right))
        {
            let event = self.solved(angle, source).filter(is_alike)?;
            *value = numbers(Sample { angle, event });
        }
        let tolerance = Tolerance {
            relative: TOLERANCE,
            least: probes.iter().fold(TOLERANCE, |least, event| {
                least.max(self.rounding(event, source))
            }),
        };
        let ends = basis.through(bounds.left, bounds.right, &values, &[tolerance; 3])?;
        let agrees = |end: Sample| {
            let pairs = ends.at(end.angle).into_iter().zip(numbers(end));
            pairs.into_iter().all(|(found, expected)| {
                (found - expected).abs() <= MAX_MISS * tolerance.of(expected)
            })
        };
        let mut samples = bounds.probes().into_iter().zip(*probes);
        samples
            .all(|(angle, event)| agrees(Sample { angle, event }))
            .then_some(FittedSlides {
                lifts_off,
                ends,
                fall,
            })
    }

    /// How far it is known, to the end of these slides or beyond, that η″ falls through zero at most
    /// once on all slides of a part.
    fn single_fall(
        &self,
        bounds: Bounds,
        slides: &[SlideEvent; 3],
        source: SlideSource<'_>,
    ) -> Option<SingleFall> {
        let side = |angle: f64| {
            Some(StripSide {
                angle: Angle::of(angle),
                u: self.rate_squared(angle)?,
            })
        };
        let strip = SlideStrip {
            first: side(bounds.left)?,
            last: side(bounds.right)?,
            middle: bounds.middle(),
        };
        let farthest = slides.iter().fold(0.0, |far, end| end.theta.max(far));
        let law = &source.laws[0][0][self.slip.index()];
        let fall = source
            .tables
            .single_fall(law, self.slip.sign(), strip, farthest)?;
        // Behind the top w may fall to zero again.
        Some(SingleFall {
            to: fall.to.min(TAU),
            ..fall
        })
    }

    /// Rounding of the end of a slide: η′ is known to ε (1 + |θ′|), and the time at which it
    /// vanishes to that over η″.
    fn rounding(&self, event: &SlideEvent, source: SlideSource<'_>) -> f64 {
        if event.lifts_off {
            return f64::EPSILON;
        }
        let law = &source.laws[0][0][self.slip.index()];
        let (alpha, beta) = law.slip_acceleration(event.angle.sin, event.angle.cos);
        let rate = event.theta_rate;
        f64::EPSILON * (1.0 + rate) / (alpha + beta * (rate * rate)).abs()
    }

    /// θ′² on the curve; none where no orbit slips.
    fn rate_squared(&self, angle: f64) -> Option<f64> {
        let u = self.numerator.value(angle) / self.denominator.value(angle);
        (u > 0.0 && u.is_finite()).then_some(u)
    }

    /// The end of the slide from an angle of the curve, before the next top.
    fn solved(&self, angle: f64, source: SlideSource<'_>) -> Option<SlideEvent> {
        match solve_slide(self.slide(angle, source)?) {
            Ok(SlideEnd::Event(event)) if event.turning_points == 0.0 && event.theta < TAU => {
                Some(event)
            }
            Ok(SlideEnd::Event(_) | SlideEnd::Turn(_) | SlideEnd::Cut(_) | SlideEnd::Never)
            | Err(_) => None,
        }
    }

    /// The slide from an angle of the curve; none where the hoop does not slip there.
    fn slide<'a>(&self, angle: f64, source: SlideSource<'a>) -> Option<SlideProblem<'a>> {
        let u = self.rate_squared(angle)?;
        let (at, sigma) = (Angle::of(angle), self.slip.sign());
        let law = &source.laws[0][0][self.slip.index()];
        let (alpha, beta) = law.slip_acceleration(at.sin, at.cos);
        let slip_acceleration = sigma * (alpha + beta * u);
        let slips = contact(1.0, law.body.h, at.cos * u) > 0.0 && slip_acceleration > 0.0;
        slips.then(|| SlideProblem {
            frame: MotionFrame {
                laws: source.laws,
                mirror: 1.0,
                is_against: false,
                theta: angle,
                sigma,
                integral: -u.sqrt() * law.slip_coefficient(at.sin, at.cos),
            },
            start: SlidePoint {
                z: 0.0,
                u,
                elapsed: 0.0,
                slip: 0.0,
                slip_acceleration,
                angle: at,
            },
            from_limit: false,
            time_left: f64::INFINITY,
            tables: Some(source.tables),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::model::HoopModel;
    use crate::model::HoopParameters;

    /// All that is interpolated is what is followed, from angles all over the curves of several
    /// hoops: the same event, its numbers to the rounding of the end of a slide. Where two events
    /// change places, slides are followed.
    #[test]
    fn interpolated_slides_end_as_those_that_are_followed() {
        for (mass_ratio, inertia, mu_s, mu_k, least_part) in [
            (1.0, 1.0, 0.5, 0.4, 0.9),
            (1.0, 1.0, 0.5, 0.1, 0.7),
            (0.2, 0.4, 0.9, 0.5, 0.7),
            (3.0, 0.8, 2.0, 1.0, 0.6),
            (0.05, 0.05, 0.3, 0.28, 0.2),
        ] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_k);
            let hoop = Hoop::new(hoop).unwrap();
            let model = HoopModel::new(&hoop).unwrap();
            let (source, slides) = (model.slide_source(), SlipSlides::default());
            let families = Families::new(source).families;
            let (mut followed, mut sticks, mut lifts) = (0, 0, 0);
            for (family, k) in families
                .iter()
                .flat_map(|family| (0..3_000).map(move |k| (family, k)))
            {
                let angle = TAU * (f64::from(k) + 0.37) / 3_000.0;
                let Some(expected) = family.solved(angle, source) else {
                    continue;
                };
                followed += 1;
                let problem = family.slide(angle, source).unwrap();
                let Some(found) = slides.end(source, &problem.frame, &problem.start) else {
                    continue;
                };
                assert_eq!(found.lifts_off, expected.lifts_off, "{mu_s} {angle}");
                let rounding = 64.0 * f64::EPSILON + 16.0 * family.rounding(&expected, source);
                for (found, expected) in [
                    (found.theta, expected.theta),
                    (found.elapsed, expected.elapsed),
                    (found.theta_rate, expected.theta_rate),
                    (found.slip, expected.slip),
                    (found.angle.sin, expected.angle.sin),
                    (found.angle.cos, expected.angle.cos),
                ] {
                    let error = (found - expected).abs();
                    assert!(
                        error <= rounding * (1.0 + expected.abs()),
                        "{mass_ratio} {mu_s} {angle}: {found} {expected}"
                    );
                }
                *if found.lifts_off {
                    &mut lifts
                } else {
                    &mut sticks
                } += 1;
            }
            let part = f64::from(sticks + lifts) / f64::from(followed);
            assert!(
                part > least_part,
                "{mass_ratio} {mu_s}: {sticks} {lifts} of {followed}"
            );
        }
    }

    /// A slide that does not begin on the curve ends elsewhere.
    #[test]
    fn a_slide_from_beside_the_curve_is_followed() {
        let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
        let model = HoopModel::new(&hoop).unwrap();
        let (source, slides) = (model.slide_source(), SlipSlides::default());
        let family = &Families::new(source).families[0];
        for (factor, is_interpolated) in [(1.0, true), (1.0 + 1e-12, false)] {
            let mut problem = family.slide(1.2, source).unwrap();
            problem.frame.integral *= factor;
            let found = slides.end(source, &problem.frame, &problem.start);
            assert_eq!(found.is_some(), is_interpolated, "{factor}");
        }
    }
}
