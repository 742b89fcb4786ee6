//! How many digits of a motion can be trusted, by motions beside it.
//!
//! Two things move a printed number from that of the exact motion: the numbers of the hoop and of the start are doubles, each known to its last
//! place, and every phase of the simulation rounds. The first is measured by motions of which one of these numbers is another; the second by motions
//! in which each phase begins and ends beside where it would, by as much as rounding may do there.

use core::cell::Cell;

use crate::mechanics::{Impact, Settling};
use crate::model::{
    Direction, Heavy, Hoop, Limits, Massless, Mode, ParameterError, Quantity, Setup, Start, State,
};
use crate::modes::{Flight, GlideEntry, PhaseSolution, TakeOff};
use crate::walk::{
    Arrival, Cause, Ending, Event, Exact, Known, Next, Origin, Outcome, PhaseSeen, Recorder, Solved,
    SolvedBy, Solver, walk,
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

/// Digits of a number that nothing but its own last digit makes uncertain.
const ALL: u8 = 15;

/// Units of the last place by which a number is changed: enough to be seen through the rounding of the results. The change of these is
/// taken for one unit.
const UNITS: u64 = 8;

/// Motions with rounding of random signs on the way. The largest change in so many is nearly two standard deviations of the change, and taken
/// twice.
const SHAKEN: u64 = 12;

/// Places on a slide where it is shaken, its end among them.
const PIECES: u32 = 4;

impl Hoop {
    /// For each transition of the motion from `start` how many digits of its state can be trusted: those that the numbers of the hoop
    /// and of the start determine, each known to its last place, and that rounding on the way has left.
    ///
    /// Each number is changed in its last places, up and down, and the motion is simulated again, up to 24 times; and 12 times with each phase shaken
    /// by as much as it may round, all in random directions that are the same in every call. The changes of a state are its uncertainty.
    /// A transition is `None` from which on a motion with such a change has other events: the numbers do not decide what happens there.
    /// Numbers that are 0, ℓ̂ = 1 and e = 1 are taken to be meant exactly, and so is μs = μk, which are changed together.
    ///
    /// ```
    /// use littlewood::{Hoop, Limits, Start};
    ///
    /// let hoop = Hoop::figure_2(0.5, 0.4)?;
    /// let digits = hoop.digits(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
    /// assert!(digits.iter().all(|at| at.is_some_and(|at| at.time >= 13 && at.theta >= 13)));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn digits(&self, start: Start, limits: Limits) -> Result<Vec<Option<Digits>>, ParameterError> {
        let motion = self.events(start, limits, None)?;
        let mut spreads = Spreads { motion: &motion, of: vec![Some([0.0; 5]); motion.len()] };
        for pair in self.neighbours(start) {
            let changes = pair.map(|setup| {
                // A bound may forbid the one direction; the other remains.
                Self::new(setup.hoop).ok()?.events(setup.start, limits, None).ok()
            });
            spreads.add(changes.iter().flatten(), 0.5 / UNITS as f64);
        }
        let shaken = (0..SHAKEN).map(|seed| self.events(start, limits, Some(Signs::new(seed))));
        spreads.add(shaken.collect::<Result<Vec<_>, _>>()?.iter(), 2.0);
        let mut decided = true;
        Ok(Vec::from_iter(spreads.of.iter().zip(&motion).map(|(spread, event)| {
            decided &= spread.is_some();
            let spread = spread.filter(|_| decided)?;
            let values = event.state.numbers();
            let [time, theta, theta_rate, slip, x] =
                core::array::from_fn(|place| digits(values[place], spread[place]));
            Some(Digits { time, theta, theta_rate, slip, x })
        })))
    }

    /// The events of a motion, with rounding on the way or without.
    fn events(
        &self,
        start: Start,
        limits: Limits,
        signs: Option<Signs>,
    ) -> Result<Vec<Seen>, ParameterError> {
        let state = self.check(start)?;
        limits.check(&start)?;
        let (origin, state, limits) = Origin::of(state, limits);
        let mut events = Events { origin, seen: Vec::new() };
        let solver = Shaken { exact: Exact::new(self, &limits), signs };
        walk(&solver, (state, start.gap_rate), (&limits, Known::default()), &mut events);
        Ok(events.seen)
    }

    /// Hoops and starts that differ in the last place of one number, closer to zero and farther.
    fn neighbours(&self, start: Start) -> impl Iterator<Item = [Setup; 2]> {
        let setup = Setup::new(self.parameters(), start);
        let is_exact = |quantity, value: f64| {
            value == 0.0 || (value == 1.0 && matches!(quantity, Quantity::Offset | Quantity::Restitution))
        };
        let coefficients_are_equal = self.mu_s() == self.mu_k();
        Quantity::HOOP.into_iter().chain(Quantity::START).filter_map(move |quantity| {
            let value = setup.get(quantity).filter(|value| !is_exact(quantity, *value))?;
            if coefficients_are_equal && quantity == Quantity::MuK {
                return None;
            }
            Some([value.to_bits().saturating_sub(UNITS), value.to_bits() + UNITS].map(|bits| {
                let value = f64::from_bits(bits);
                let mut setup = setup;
                setup.set(quantity, value);
                if coefficients_are_equal && quantity == Quantity::MuS {
                    setup.set(Quantity::MuK, value);
                }
                setup
            }))
        })
    }
}

impl Digits {
    /// The least of the five.
    #[must_use]
    pub fn least(&self) -> u8 {
        let Self { time, theta, theta_rate, slip, x } = *self;
        [time, theta, theta_rate, slip, x].into_iter().min().unwrap_or(0)
    }
}

/// A transition, as far as it is compared.
#[derive(Clone, Copy, Debug)]
struct Seen {
    state: State,
    kind: (Cause, Option<Mode>, Option<Mode>, Option<Direction>),
}

/// Keeps the transitions of a motion.
struct Events {
    origin: Origin,
    seen: Vec<Seen>,
}

impl Recorder<PhaseSolution> for Events {
    fn phase(&mut self, _: PhaseSeen, _: PhaseSolution) {}

    fn transition(&mut self, event: &Event, _: Option<&Impact>, direction: Option<Direction>) {
        let Event { state, from, to, cause } = *event;
        self.seen.push(Seen { state: self.origin.state(state), kind: (cause, from, to, direction) });
    }
}

/// Changes of the numbers of each transition of a motion; none where an event is another.
struct Spreads<'a> {
    motion: &'a [Seen],
    of: Vec<Option<[f64; 5]>>,
}

impl Spreads<'_> {
    /// Adds the largest changes in some motions, times a factor.
    fn add<'a>(&mut self, others: impl Iterator<Item = &'a Vec<Seen>> + Clone, factor: f64) {
        for (index, (spread, seen)) in self.of.iter_mut().zip(self.motion).enumerate() {
            let mut largest = [0.0_f64; 5];
            for other in others.clone() {
                match other.get(index).filter(|other| other.kind == seen.kind) {
                    Some(other) => {
                        let pairs = other.state.numbers().into_iter().zip(seen.state.numbers());
                        for (most, (a, b)) in largest.iter_mut().zip(pairs) {
                            *most = most.max(if a == b { 0.0 } else { (a - b).abs() });
                        }
                    }
                    None => *spread = None,
                }
            }
            for (sum, most) in spread.iter_mut().flatten().zip(largest) {
                *sum += factor * most;
            }
        }
    }
}

/// Signs that look random: a linear congruence.
#[derive(Clone, Debug)]
struct Signs(Cell<u64>);

impl Signs {
    fn new(seed: u64) -> Self {
        Self(Cell::new(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)))
    }

    /// A number moved by so much, up or down; what would be no number is left.
    fn moved(&self, value: f64, by: f64) -> f64 {
        let state =
            self.0.get().wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0.set(state);
        let moved = if state >> 63 == 0 { value + by } else { value - by };
        if moved.is_finite() { moved } else { value }
    }
}

/// The exact solver, whose phases begin and end beside where they would.
struct Shaken<'a> {
    exact: Exact<'a>,
    signs: Option<Signs>,
}

impl Shaken<'_> {
    /// The start of a phase, each number moved in its last place: what a solution rounds on its way is as much as this.
    fn begun(&self, state: &State) -> State {
        let State { time, theta, theta_rate, slip, x } = *state;
        let Some(signs) = &self.signs else { return *state };
        let moved = |value: f64| signs.moved(value, f64::EPSILON * value.abs());
        State { time, theta: moved(theta), theta_rate: moved(theta_rate), slip: moved(slip), x }
    }

    /// A later state of a phase from a state, each number moved by the last place of what it is the sum of: of what it was, and of what the phase,
    /// in so many steps, has added.
    fn ended(&self, from: &State, (mode, steps): (Mode, f64), to: State) -> State {
        let Some(signs) = &self.signs else { return to };
        let least = f64::EPSILON * steps.sqrt();
        let moved = |value: f64, size: f64| signs.moved(value, least * size);
        let (h, friction) = match mode {
            Mode::Rolling => (0.0, 0.0),
            Mode::Flight => (self.hoop().h(), 0.0),
            Mode::Sliding | Mode::Gliding => (self.hoop().h(), self.hoop().mu_k()),
        };
        let duration = to.time - from.time;
        let rate = from.theta_rate.abs().max(to.theta_rate.abs());
        let turned = from.theta.abs() + rate * duration;
        let slipped = from.slip.abs().max(to.slip.abs());
        // Of the first integral of a slide, and of the second.
        let velocity = slipped + rate * (1.0 + h + friction * h) + friction * duration;
        let place = from.x.abs() + h + friction * h;
        State {
            time: moved(to.time, to.time + duration),
            theta: moved(to.theta, turned),
            theta_rate: moved(to.theta_rate, rate),
            // In contact rest is without rounding.
            slip: if to.slip == 0.0 && mode != Mode::Flight { 0.0 } else { moved(to.slip, velocity) },
            x: moved(to.x, place + turned + velocity * duration),
        }
    }

    /// A landing that comes earlier or later by as much as the last place of what the gap is the sum of.
    fn landed(&self, flight: &Flight, gap_rate: f64, signs: &Signs) -> (State, f64) {
        let duration = flight.duration();
        let gap = self.hoop().h() + (flight.take_off_rate() + 0.5 * duration) * duration;
        // A gap that grazes the plane comes to it as slowly as rounding lets it.
        let late = (f64::EPSILON * gap / gap_rate.abs()).min(duration);
        let duration = signs.moved(duration, late);
        (flight.state(duration), flight.gap(duration).1)
    }

    fn shaken(&self, from: &State, solved: SolvedBy<Self>) -> SolvedBy<Self> {
        let Solved { solution, direction, ending } = solved;
        let (mode, steps) = match &solution {
            PhaseSolution::Rolling(_) => (Mode::Rolling, 1.0),
            PhaseSolution::Sliding(slide) => (Mode::Sliding, slide.steps() as f64),
            PhaseSolution::Gliding(_) => (Mode::Gliding, 1.0),
            PhaseSolution::Flight(_) => (Mode::Flight, 1.0),
        };
        let moved = |state: State| self.ended(from, (mode, steps), state);
        let ending = match ending {
            Ending::Event { place, cause, arrival } => Ending::Event { place: moved(place), cause, arrival },
            Ending::Landing { state, gap_rate } => {
                let (state, gap_rate) = match (&solution, &self.signs) {
                    (PhaseSolution::Flight(flight), Some(signs)) => self.landed(flight, gap_rate, signs),
                    _ => (state, gap_rate),
                };
                Ending::Landing { state: moved(state), gap_rate }
            }
            Ending::Settled { state, settling } => Ending::Settled { state: moved(state), settling },
            Ending::Singular { state, solvability } => Ending::Singular { state: moved(state), solvability },
            Ending::Motion { event, end, verdict } => {
                let event = event.map(|(cause, state)| (cause, moved(state)));
                Ending::Motion { event, end, verdict }
            }
        };
        Solved { solution, direction, ending }
    }
}

impl Solver for Shaken<'_> {
    type Place = State;
    type Solution = PhaseSolution;
    type Verdict = Outcome;

    fn hoop(&self) -> &Hoop {
        self.exact.hoop()
    }

    fn until(&self) -> f64 {
        self.exact.until()
    }

    fn place(&self, state: State) -> State {
        state
    }

    fn state(place: &State) -> State {
        *place
    }

    fn decide(&self, state: &State, arrival: Arrival) -> Next {
        self.exact.decide(state, arrival)
    }

    fn roll(&self, state: &State, on_limit: bool) -> SolvedBy<Self> {
        self.shaken(state, self.exact.roll(&self.begun(state), on_limit))
    }

    fn slide(
        &self,
        state: &State,
        body: &Heavy,
        direction: Direction,
        slip_acceleration: Option<f64>,
    ) -> SolvedBy<Self> {
        let begun = self.begun(state);
        let mut from = begun;
        let mut solved = self.exact.slide(&begun, body, direction, slip_acceleration);
        if self.signs.is_none() {
            return solved;
        }
        // What is rounded on the way may grow by more than what is rounded at the start.
        for pieces in (2..=PIECES).rev() {
            let (PhaseSolution::Sliding(slide), Some(end)) =
                (&solved.solution, solved.ending.state(|place| *place))
            else {
                break;
            };
            let steps = (slide.steps() as f64 / f64::from(pieces)).max(1.0);
            let cut = slide.state((end.time - from.time) / f64::from(pieces));
            // The first integral keeps the size of the slip with which the slide has begun.
            let cut = self.ended(&State { slip: begun.slip, ..from }, (Mode::Sliding, steps), cut);
            if Direction::of_sign(cut.slip) != Some(direction) {
                break;
            }
            from = cut;
            solved = self.exact.slide(&from, body, direction, None);
        }
        self.shaken(&State { slip: begun.slip, ..from }, solved)
    }

    fn fly(&self, state: &State, body: &Heavy, take_off: TakeOff) -> SolvedBy<Self> {
        let take_off = match (take_off, &self.signs) {
            (TakeOff::Rising { gap_rate }, Some(signs)) => {
                TakeOff::Rising { gap_rate: signs.moved(gap_rate, f64::EPSILON * gap_rate) }
            }
            (take_off @ (TakeOff::Rising { .. } | TakeOff::Grazing | TakeOff::Unloaded), _) => take_off,
        };
        self.shaken(state, self.exact.fly(&self.begun(state), body, take_off))
    }

    fn settle(&self, state: &State, body: &Heavy, settling: &Settling) -> SolvedBy<Self> {
        self.shaken(state, self.exact.settle(&self.begun(state), body, settling))
    }

    fn glide(&self, state: &State, body: &Massless, entry: GlideEntry) -> SolvedBy<Self> {
        // A glide begins with forces that go with its state, which is not moved without them.
        self.shaken(state, self.exact.glide(state, body, entry))
    }
}

/// Significant digits of a value that is uncertain by `spread`.
fn digits(value: f64, spread: f64) -> u8 {
    if value.is_infinite() || spread == 0.0 {
        return if spread == 0.0 { ALL } else { 0 };
    }
    let relative = f64::EPSILON + spread / value.abs();
    // Rounds down; infinite where the value is 0.
    (-libm::log10(relative)).clamp(0.0, f64::from(ALL)) as u8
}
