//! The number of significant digits of a motion, estimated from perturbed motions.
//!
//! A printed number differs from the exact one for two reasons: the parameters of the hoop and the
//! start are known to the last place of a double only, and every phase of the simulation rounds.
//! Motions with one perturbed parameter measure the first error. Motions whose phases start and end
//! with perturbed states, by the size of the rounding, measure the second.

use core::cell::Cell;

use crate::mechanics::Settling;
use crate::model::{
    Heavy, Hoop, Limits, Massless, Mode, ParameterError, Quantity, RotationDirection, Setup,
    SlipDirection, Start, State,
};
use crate::modes::{Entry, Flight, GlideEntry, PhasePoint, PhaseSolution, StaticLimit, TakeOff};
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{
    Arrival, Exact, NextMotion, Outcome, PhaseEnd, PhaseResult, ResistedMotion, Solver, Transition,
};

/// Estimated numbers of significant decimal digits of the state at a transition, from 0 to 15.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Digits {
    /// Of the time τ.
    pub time: u8,
    /// Of the angle θ.
    pub theta: u8,
    /// Of the rate θ′.
    pub theta_rate: u8,
    /// Of the slip velocity η′.
    pub slip: u8,
    /// Of the position x.
    pub x: u8,
}

/// Digits of a number with an error of its last place only.
const MAX_DIGITS: u8 = 15;

/// Perturbation of a parameter in units of the last place: large enough to exceed the rounding of
/// the results. The measured change is divided by this number.
const PERTURBATION_ULPS: u64 = 8;

/// Number of motions with perturbed phases. The largest of 12 random changes is nearly two standard
/// deviations; it counts twice.
const PERTURBED_MOTIONS: u64 = 12;

/// Number of perturbations of a slide, with that of its end: rounding on the way may grow more than
/// that at the start.
const PERTURBATIONS_PER_SLIDE: u32 = 4;

impl Hoop {
    /// Estimates the significant digits of the state at each transition of the motion from `start`.
    /// They account for the last place of each parameter of the hoop and the start, and for
    /// rounding in the simulation.
    ///
    /// The motion is simulated again up to 24 times with one parameter perturbed up or down in its
    /// last places. Then it is simulated 12 times with each phase perturbed by its rounding in
    /// pseudo-random directions, the same in every call. The changes of a state are its
    /// uncertainty. A transition and all later ones are `None` if a perturbed motion has another
    /// event there: the parameters do not determine it. Nor do they from a start that is on the limit
    /// of static friction, to rounding: the simulation takes it to be on it. Zeros, ℓ̂ = 1 and e = 1 are exact, and so
    /// is μs = μk: equal coefficients are perturbed together.
    ///
    /// ```
    /// use littlewood::{Hoop, Limits, Start};
    ///
    /// let hoop = Hoop::equal_masses(0.5, 0.4)?;
    /// let digits = hoop.digits(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
    /// assert!(digits.iter().all(|at| at.is_some_and(|at| at.time >= 13 && at.theta >= 13)));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn digits(
        &self,
        start: Start,
        limits: Limits,
    ) -> Result<Vec<Option<Digits>>, ParameterError> {
        let motion = self.simulate(start, limits)?;
        let is_on_limit = motion.starts_on_static_limit();
        let motion = motion.transitions;
        // The direction of a glide is known after its beginning.
        let compared = limits.transitions.min(motion.len() + 1);
        let limits = limits.with_transitions(compared);
        let mut uncertainties = Uncertainties {
            motion: &motion,
            of: vec![Some([0.0; 5]); motion.len()],
        };
        for pair in self.neighbours(start) {
            let changed = pair.map(|setup| {
                // A bound may exclude one of the two directions.
                let hoop = Self::new(setup.hoop).ok()?;
                Some(hoop.simulate(setup.start, limits).ok()?.transitions)
            });
            uncertainties.add(changed.iter().flatten(), 0.5 / PERTURBATION_ULPS as f64);
        }
        let perturbed = (0..PERTURBED_MOTIONS).map(|seed| {
            let signs = RandomSigns::new(seed);
            let motion = self.simulate_by(start, limits, |exact| PerturbedSolver { exact, signs });
            motion.map(|motion| motion.transitions)
        });
        uncertainties.add(perturbed.collect::<Result<Vec<_>, _>>()?.iter(), 2.0);
        let mut is_determined = !is_on_limit;
        let found = uncertainties
            .of
            .iter()
            .zip(&motion)
            .map(|(uncertainty, event)| {
                is_determined &= uncertainty.is_some();
                let uncertainty = uncertainty.filter(|_| is_determined)?;
                let values = event.before.numbers();
                let [time, theta, theta_rate, slip, x] =
                    core::array::from_fn(|place| digits(values[place], uncertainty[place]));
                Some(Digits {
                    time,
                    theta,
                    theta_rate,
                    slip,
                    x,
                })
            });
        Ok(found.collect())
    }

    /// Hoops and starts with one number perturbed in its last places, towards zero and away from
    /// it.
    fn neighbours(&self, start: Start) -> impl Iterator<Item = [Setup; 2]> {
        let setup = Setup::new(self.parameters(), start);
        let is_exact = |quantity, value: f64| {
            value == 0.0
                || (value == 1.0 && matches!(quantity, Quantity::Offset | Quantity::Restitution))
        };
        let coefficients_are_equal = self.mu_s() == self.mu_k();
        Quantity::HOOP
            .into_iter()
            .chain(Quantity::START)
            .filter_map(move |quantity| {
                let value = setup
                    .get(quantity)
                    .filter(|value| !is_exact(quantity, *value))?;
                if coefficients_are_equal && quantity == Quantity::MuK {
                    return None;
                }
                Some(
                    [
                        value.to_bits().saturating_sub(PERTURBATION_ULPS),
                        value.to_bits() + PERTURBATION_ULPS,
                    ]
                    .map(|bits| {
                        let value = f64::from_bits(bits);
                        let mut setup = setup;
                        setup.set(quantity, value);
                        if coefficients_are_equal && quantity == Quantity::MuS {
                            setup.set(Quantity::MuK, value);
                        }
                        setup
                    }),
                )
            })
    }
}

impl Trajectory {
    /// Whether the start is on the limit of static friction, to rounding.
    fn starts_on_static_limit(&self) -> bool {
        let rolls_or_slides = self.phases.first().map(Phase::mode) != Some(Mode::Flight);
        let place = PhasePoint {
            theta: self.relative.theta,
            rate: self.relative.theta_rate,
        };
        self.start.slip == 0.0 && rolls_or_slides && StaticLimit::at(&self.hoop, &place).is_some()
    }
}

impl Digits {
    /// The minimum of the five numbers.
    pub fn least(&self) -> u8 {
        let others = [self.time, self.theta, self.theta_rate, self.slip];
        others.into_iter().fold(self.x, u8::min)
    }
}

/// Uncertainties of the state before each transition of a motion; none if a perturbed motion has
/// another event.
struct Uncertainties<'a> {
    motion: &'a [Transition],
    of: Vec<Option<[f64; 5]>>,
}

impl Uncertainties<'_> {
    /// Adds the largest changes over some motions, times a factor.
    fn add<'a>(&mut self, others: impl Iterator<Item = &'a Vec<Transition>> + Clone, factor: f64) {
        let kind = |it: &Transition| (it.cause, it.from, it.to, it.direction);
        for (index, (uncertainty, event)) in self.of.iter_mut().zip(self.motion).enumerate() {
            let mut largest = [0.0_f64; 5];
            for other in others.clone() {
                match other.get(index).filter(|other| kind(other) == kind(event)) {
                    Some(other) => {
                        let pairs = other
                            .before
                            .numbers()
                            .into_iter()
                            .zip(event.before.numbers());
                        for (most, (a, b)) in largest.iter_mut().zip(pairs) {
                            *most = most.max(if a == b { 0.0 } else { (a - b).abs() });
                        }
                    }
                    None => *uncertainty = None,
                }
            }
            for (sum, most) in uncertainty.iter_mut().flatten().zip(largest) {
                *sum += factor * most;
            }
        }
    }
}

/// Pseudo-random signs from a linear congruential generator.
#[derive(Clone, Debug)]
struct RandomSigns(Cell<u64>);

impl RandomSigns {
    fn new(seed: u64) -> Self {
        Self(Cell::new(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)))
    }

    /// The value moved up or down by `by`; unchanged if the result is not finite.
    fn moved(&self, value: f64, by: f64) -> f64 {
        let state = self
            .0
            .get()
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.0.set(state);
        let moved = if state >> 63 == 0 {
            value + by
        } else {
            value - by
        };
        if moved.is_finite() { moved } else { value }
    }
}

/// The exact solver with perturbed starts and ends of phases.
struct PerturbedSolver<'a> {
    exact: Exact<'a>,
    signs: RandomSigns,
}

impl PerturbedSolver<'_> {
    /// The start of a phase with each number moved in its last place, the size of the rounding
    /// within the solution.
    fn perturbed_start(&self, state: &State) -> State {
        let moved = |value: f64| self.signs.moved(value, f64::EPSILON * value.abs());
        State {
            theta: moved(state.theta),
            theta_rate: moved(state.theta_rate),
            slip: moved(state.slip),
            ..*state
        }
    }

    /// A later state of a phase, with each number moved by the rounding of its terms: the earlier
    /// value, and the change over a number of steps. An end at θ′ = 0 comes later by the rounding of
    /// the rate over `turn`, the size of θ″ there.
    fn perturbed_end(&self, from: &State, to: State, mode: Mode, steps: f64, turn: f64) -> State {
        let least = f64::EPSILON * steps.sqrt();
        let moved = |value: f64, size: f64| self.signs.moved(value, least * size);
        let (h, friction) = match mode {
            Mode::Rolling | Mode::Rest => (0.0, 0.0),
            Mode::Flight => (self.hoop().h(), 0.0),
            Mode::Sliding | Mode::Gliding | Mode::Skidding => (self.hoop().h(), self.hoop().mu_k()),
        };
        let duration = to.time - from.time;
        let rate = from.theta_rate.abs().max(to.theta_rate.abs());
        let turned = from.theta.abs() + rate * duration;
        let slipped = from.slip.abs().max(to.slip.abs());
        // Rolling ends at an angle, whose rounding along the orbit is one of time and rate.
        let stops = self.stops(&to);
        let late = match mode {
            Mode::Rolling | Mode::Sliding | Mode::Gliding if stops => {
                (rate / turn).min(duration / f64::EPSILON)
            }
            Mode::Rolling => (to.theta / to.theta_rate)
                .abs()
                .min(duration / f64::EPSILON),
            Mode::Sliding | Mode::Gliding | Mode::Flight | Mode::Rest | Mode::Skidding => 0.0,
        };
        let along = if late == 0.0 || stops {
            0.0
        } else {
            (to.theta_rate - from.theta_rate).abs() / duration * late
        };
        // Terms of the first and of the second integral of a slide.
        let velocity = slipped + rate * (1.0 + h + friction * h) + friction * duration;
        let place = from.x.abs() + h + friction * h;
        State {
            time: moved(to.time, to.time + duration + late),
            theta: moved(to.theta, turned),
            // With rolling resistance θ′ = 0 is exact, too.
            theta_rate: if stops && mode != Mode::Flight {
                0.0
            } else {
                moved(to.theta_rate, rate + along)
            },
            // In contact, η′ = 0 is exact.
            slip: if to.slip == 0.0 && mode != Mode::Flight {
                0.0
            } else {
                moved(to.slip, velocity)
            },
            x: moved(to.x, place + turned + velocity * duration),
        }
    }

    /// Whether θ′ is zero by rolling resistance.
    fn stops(&self, state: &State) -> bool {
        self.hoop().rolling_resistance() > 0.0 && state.theta_rate == 0.0
    }

    /// A landing with its time moved by its own rounding, and by that of the terms of the gap.
    fn perturbed_landing(&self, flight: &Flight, gap_rate: f64) -> (State, f64) {
        let duration = flight.duration();
        let gap = self.hoop().h() + (flight.take_off_rate() + 0.5 * duration) * duration;
        // At a grazing landing the gap rate, a divisor, may be as small as rounding.
        let late = f64::EPSILON * (gap / gap_rate.abs()).max(duration);
        let duration = self.signs.moved(duration, late.min(duration));
        (flight.state(duration), flight.gap(duration).1)
    }

    /// A slide perturbed at its start, at some places on the way, and at its end.
    fn slide_in_pieces<'a>(
        &self,
        state: &State,
        entry: Entry,
        slide: impl Fn(&State, Entry) -> PhaseResult<Exact<'a>>,
    ) -> PhaseResult<Self> {
        let perturbed_start = self.perturbed_start(state);
        let mut from = perturbed_start;
        let mut solved = slide(&perturbed_start, entry);
        // Rounding on the way may grow more than rounding at the start.
        for pieces in (2..=PERTURBATIONS_PER_SLIDE).rev() {
            let (PhaseSolution::Sliding(sliding), Some(end)) =
                (&solved.solution, solved.end.state(|place| place))
            else {
                break;
            };
            let steps = (sliding.steps() as f64 / f64::from(pieces)).max(1.0);
            let cut = sliding.state((end.time - from.time) / f64::from(pieces));
            // The rounding of the first integral scales with the slip at the start of the slide.
            let cut = self.perturbed_end(
                &State {
                    slip: perturbed_start.slip,
                    ..from
                },
                cut,
                Mode::Sliding,
                steps,
                f64::INFINITY,
            );
            let turns = sliding.rotation();
            if SlipDirection::of_sign(cut.slip) != Some(sliding.direction())
                || turns.is_some() && RotationDirection::of_sign(cut.theta_rate) != turns
            {
                break;
            }
            from = cut;
            solved = slide(&from, Entry::Moving);
        }
        self.perturbed(
            &State {
                slip: perturbed_start.slip,
                ..from
            },
            solved,
        )
    }

    /// A phase from a state with the state of its event moved.
    fn perturbed(&self, from: &State, solved: PhaseResult<Exact<'_>>) -> PhaseResult<Self> {
        let PhaseResult {
            solution,
            direction,
            mut end,
        } = solved;
        if let (PhaseSolution::Flight(flight), PhaseEnd::Landing { state, gap_rate }) =
            (&solution, &mut end)
        {
            (*state, *gap_rate) = self.perturbed_landing(flight, *gap_rate);
        }
        let steps = match &solution {
            PhaseSolution::Sliding(slide) => slide.steps() as f64,
            PhaseSolution::ResistedRolling(rolling) => rolling.steps() as f64,
            PhaseSolution::Rolling(_)
            | PhaseSolution::Gliding(_)
            | PhaseSolution::Flight(_)
            | PhaseSolution::Skidding(_)
            | PhaseSolution::Rest(_) => 1.0,
        };
        match &mut end {
            PhaseEnd::Rest { point: state, .. }
            | PhaseEnd::Event { point: state, .. }
            | PhaseEnd::Landing { state, .. }
            | PhaseEnd::Settled { state, .. }
            | PhaseEnd::Singular { state, .. }
            | PhaseEnd::Motion {
                event: Some((_, state)),
                ..
            } => {
                let turn = if self.stops(state) {
                    let sample = solution.sample(self.hoop(), *state, 0.0);
                    sample.theta_acceleration.abs()
                } else {
                    f64::INFINITY
                };
                *state = self.perturbed_end(from, *state, solution.mode(), steps, turn);
            }
            PhaseEnd::Motion { event: None, .. } => {}
        }
        PhaseResult {
            solution,
            direction,
            end,
        }
    }
}

impl Solver for PerturbedSolver<'_> {
    type Point = State;
    type Solution = PhaseSolution;
    type Outcome = Outcome;

    fn hoop(&self) -> &Hoop {
        self.exact.hoop()
    }

    fn until(&self) -> f64 {
        self.exact.until()
    }

    fn point(&self, state: State) -> State {
        state
    }

    fn state(point: &State) -> &State {
        point
    }

    fn next_motion(&self, state: &State, arrival: Arrival) -> NextMotion {
        self.exact.next_motion(state, arrival)
    }

    fn roll(&self, state: &State, on_limit: bool) -> PhaseResult<Self> {
        self.perturbed(
            state,
            self.exact.roll(&self.perturbed_start(state), on_limit),
        )
    }

    fn slide(
        &self,
        state: &State,
        body: &Heavy,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
    ) -> PhaseResult<Self> {
        self.slide_in_pieces(state, entry, |from, entry| {
            self.exact.slide(from, body, direction, entry, may_lift_off)
        })
    }

    fn fly(&self, state: &State, body: &Heavy, take_off: TakeOff) -> PhaseResult<Self> {
        let take_off = match take_off {
            TakeOff::Rising { gap_rate } => TakeOff::Rising {
                gap_rate: self.signs.moved(gap_rate, f64::EPSILON * gap_rate),
            },
            TakeOff::Grazing | TakeOff::Unloaded => take_off,
        };
        self.perturbed(
            state,
            self.exact.fly(&self.perturbed_start(state), body, take_off),
        )
    }

    fn settle(&self, state: &State, body: &Heavy, settling: &Settling) -> PhaseResult<Self> {
        self.perturbed(
            state,
            self.exact
                .settle(&self.perturbed_start(state), body, settling),
        )
    }

    fn glide(&self, state: &State, body: &Massless, entry: GlideEntry) -> PhaseResult<Self> {
        // The entry of a glide is tied to its state, so the start is not perturbed.
        self.perturbed(state, self.exact.glide(state, body, entry))
    }

    fn resisted(
        &self,
        state: &State,
        body: &Heavy,
        motion: ResistedMotion,
        half_swings: usize,
    ) -> PhaseResult<Self> {
        let resisted = |from: &State, motion| self.exact.resisted(from, body, motion, half_swings);
        match motion {
            ResistedMotion::Slide {
                direction,
                rotation,
                entry,
            } => self.slide_in_pieces(state, entry, |from, entry| {
                let motion = ResistedMotion::Slide {
                    direction,
                    rotation,
                    entry,
                };
                resisted(from, motion)
            }),
            // What is zero stays zero.
            ResistedMotion::Roll(_) | ResistedMotion::Skid(_) | ResistedMotion::Rest => {
                self.perturbed(state, resisted(&self.perturbed_start(state), motion))
            }
        }
    }
}

/// Rounding of numbers below the normal ones: each product and sum on the way loses up to half a
/// unit of 2^−1074.
const SUBNORMAL_ERROR: f64 = 64.0 * 5e-324;

/// Significant digits of a value with the uncertainty `spread`.
fn digits(value: f64, spread: f64) -> u8 {
    if spread == 0.0 && (value == 0.0 || !value.is_subnormal()) {
        return MAX_DIGITS;
    }
    if value.is_infinite() {
        return 0;
    }
    let relative = f64::EPSILON + (spread + SUBNORMAL_ERROR) / value.abs();
    // Rounds down. The error of a value 0 is infinite.
    (-libm::log10(relative)).clamp(0.0, f64::from(MAX_DIGITS)) as u8
}
