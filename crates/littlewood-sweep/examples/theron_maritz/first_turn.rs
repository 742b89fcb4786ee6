//! The first turn of a hoop, as Theron and Maritz follow it (Math. Comput. Modelling 47, 2008,
//! 1077): from the start to one revolution, to the instant when θ′ changes sign, or to lift-off.

use core::f64::consts::TAU;

use littlewood::tables::PhaseSequence;
use littlewood::{
    Hoop, Limits, Outcome, OutcomeKind, ParameterError, Phase, Proof, SlipDirection, Start,
};

/// Instants at which a phase is sampled for a stop. A phase of rolling lasts at most one period of
/// its orbit, in which θ′ changes sign twice at most, half a period apart.
const INSTANTS: u32 = 64;

/// Limits of transitions to which a motion is followed, one after the other until it stops. Most
/// first turns have few transitions; with μs = μk slips can shrink without end.
const TRANSITIONS: [usize; 3] = [6, 30, 200];

/// What ends a first turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Stop {
    /// |θ − θ0| = 2π.
    Revolution,
    /// θ′ = 0.
    TurnsBack,
    /// The hoop leaves the plane.
    LiftsOff,
    /// The motion ends in another way: a Painlevé paradox, or a particle at the plane.
    Ends,
    /// None of these happens, or not within 200 transitions: rest, or an orbit that approaches the
    /// top.
    Never,
}

impl Stop {
    /// Lower-case name, as the list prints it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Revolution => "revolution",
            Self::TurnsBack => "turns_back",
            Self::LiftsOff => "lifts_off",
            Self::Ends => "ends",
            Self::Never => "never",
        }
    }
}

/// The first turn of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FirstTurn {
    /// Phases up to the stop; the last is the one in which it comes. After lift-off it is the
    /// flight.
    pub(crate) sequence: PhaseSequence,
    /// What stops it.
    pub(crate) stop: Stop,
    /// Time τ of the stop; NaN if it never comes.
    pub(crate) time: f64,
}

impl FirstTurn {
    /// Follows a motion through its first turn.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub(crate) fn new(hoop: &Hoop, start: Start) -> Result<Self, ParameterError> {
        let [few, more, most] = TRANSITIONS;
        for transitions in [few, more] {
            if let (turn, false) = Self::within(hoop, start, transitions)? {
                return Ok(turn);
            }
        }
        Ok(Self::within(hoop, start, most)?.0)
    }

    /// The first turn within a number of transitions, and whether they have cut it off.
    fn within(
        hoop: &Hoop,
        start: Start,
        transitions: usize,
    ) -> Result<(Self, bool), ParameterError> {
        // Slips that shrink for ever, too, come to the end of the turn.
        let limits = Limits::default()
            .with_transitions(transitions)
            .with_proof(Proof::None);
        let motion = hoop.simulate(start, limits)?;
        let mut sequence = PhaseSequence::default();
        let Some(travel) = SlipDirection::of_sign(start.theta_rate) else {
            for phase in motion.phases() {
                sequence.push(phase.mode(), phase.direction());
            }
            let turn = Self {
                sequence,
                stop: Stop::Never,
                time: f64::NAN,
            };
            return Ok((
                turn,
                motion.outcome().kind() == OutcomeKind::TransitionLimit,
            ));
        };
        let turn = Turn {
            theta: start.theta,
            travel: travel.sign(),
        };
        for phase in motion.phases() {
            sequence.push(phase.mode(), phase.direction());
            if !phase.mode().touches_plane() {
                return Ok((
                    Self {
                        sequence,
                        stop: Stop::LiftsOff,
                        time: phase.start().time,
                    },
                    false,
                ));
            }
            let duration = if phase.duration().is_finite() {
                phase.duration()
            } else {
                period(phase, &motion.outcome()).unwrap_or(0.0)
            };
            if let Some((stop, elapsed)) = turn.stop_in(phase, duration) {
                return Ok((
                    Self {
                        sequence,
                        stop,
                        time: phase.start().time + elapsed,
                    },
                    false,
                ));
            }
        }
        let never = Self {
            sequence,
            stop: Stop::Never,
            time: f64::NAN,
        };
        Ok(match motion.outcome().kind() {
            OutcomeKind::TransitionLimit => (never, true),
            OutcomeKind::RollsForever
            | OutcomeKind::SlidesForever
            | OutcomeKind::SlipsForever
            | OutcomeKind::RepeatsForever
            | OutcomeKind::StaysInContact
            | OutcomeKind::Rests
            | OutcomeKind::TimeLimit => (never, false),
            OutcomeKind::Landing
            | OutcomeKind::ParticleAtPlane
            | OutcomeKind::ParticleAtBottom
            | OutcomeKind::ParticleAtTop
            | OutcomeKind::Inconsistent
            | OutcomeKind::Ambiguous
            | OutcomeKind::Singular
            | OutcomeKind::StepLimit
            | OutcomeKind::Unresolved
            | OutcomeKind::NotComputed
            | OutcomeKind::Invalid => (
                Self {
                    stop: Stop::Ends,
                    ..never
                },
                false,
            ),
        })
    }
}

/// The period of a phase that lasts for ever; none if it does not come back.
fn period(phase: &Phase, outcome: &Outcome) -> Option<f64> {
    let recurrence = phase.recurrence().or_else(|| outcome.recurrence());
    recurrence.and_then(|recurrence| recurrence.period())
}

/// Where a turn began, and in which direction.
struct Turn {
    theta: f64,
    travel: f64,
}

impl Turn {
    fn stop_at(&self, phase: &Phase, elapsed: f64) -> Option<Stop> {
        let state = phase.sample(elapsed).state;
        if self.travel * state.theta_rate <= 0.0 {
            Some(Stop::TurnsBack)
        } else if (state.theta - self.theta).abs() >= TAU {
            Some(Stop::Revolution)
        } else {
            None
        }
    }

    /// The first stop in a phase, and the time from the start of the phase.
    fn stop_in(&self, phase: &Phase, duration: f64) -> Option<(Stop, f64)> {
        let mut before = 0.0;
        for instant in 1..=INSTANTS {
            // A little more than a period, so that rounding does not hide its end.
            let mut after = duration * f64::from(instant) / f64::from(INSTANTS) * (1.0 + 1e-12);
            let Some(mut stop) = self.stop_at(phase, after) else {
                before = after;
                continue;
            };
            loop {
                let middle = 0.5 * (before + after);
                if middle <= before || middle >= after {
                    return Some((stop, after));
                }
                match self.stop_at(phase, middle) {
                    Some(earlier) => (stop, after) = (earlier, middle),
                    None => before = middle,
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use littlewood::{Hoop, HoopParameters, Limits, Start};

    use super::{FirstTurn, Stop};

    /// The hoop of Theron and Maritz with their particle of mass 3, and one friction.
    fn hoop(offset: f64, mu: f64) -> Hoop {
        let third = 1.0 / 3.0;
        Hoop::new(
            HoopParameters::thin(third)
                .with_offset(offset)
                .with_friction(mu, mu),
        )
        .unwrap()
    }

    #[test]
    fn first_turns_end_where_they_must() {
        // Rough and slow: it rolls round, and takes the time that the orbit says.
        let turn = FirstTurn::new(&hoop(0.3, 5.0), Start::at(0.0, 0.3)).unwrap();
        assert_eq!(
            (turn.sequence.to_string(), turn.stop),
            ("R".to_owned(), Stop::Revolution)
        );
        let motion = hoop(0.3, 5.0)
            .simulate(Start::at(0.0, 0.3), Limits::until(turn.time))
            .unwrap();
        let end = motion.at(turn.time).unwrap().state;
        assert!((end.theta - TAU).abs() < 1e-9, "{}", end.theta);
        // So fast that 1 < h θ′²: off at once.
        let turn = FirstTurn::new(&hoop(1.0, 0.5), Start::at(0.0, 1.5)).unwrap();
        assert_eq!(
            (turn.sequence.to_string(), turn.stop, turn.time),
            ("F".to_owned(), Stop::LiftsOff, 0.0)
        );
        // At rest on the top nothing happens.
        let turn = FirstTurn::new(&hoop(0.5, 0.5), Start::at(0.0, 0.0)).unwrap();
        assert_eq!(turn.stop, Stop::Never);
        // Started below the top it rocks: θ′ changes sign where the energy of the start is used up, cos
        // θ as at the start.
        let start = Start::at(2.5, 1e-9);
        let turn = FirstTurn::new(&hoop(0.3, 5.0), start).unwrap();
        assert_eq!(
            (turn.sequence.to_string(), turn.stop),
            ("R".to_owned(), Stop::TurnsBack)
        );
        let end = hoop(0.3, 5.0)
            .simulate(start, Limits::until(turn.time))
            .unwrap()
            .at(turn.time)
            .unwrap()
            .state;
        assert!(
            (end.theta - (TAU - 2.5)).abs() < 1e-6 && end.theta_rate.abs() < 1e-6,
            "{end:?}"
        );
    }

    #[test]
    fn mirrored_starts_have_mirrored_first_turns() {
        let mirrored = |text: &str| -> String {
            text.chars()
                .map(|c| match c {
                    '+' => '-',
                    '-' => '+',
                    c => c,
                })
                .collect()
        };
        for i in 1..40 {
            let hoop = hoop(0.025 * f64::from(i), 0.05 + 0.01 * f64::from(i % 7));
            for rate in [0.1, 0.4, 0.9, 1.2] {
                let right = FirstTurn::new(&hoop, Start::at(0.0, rate)).unwrap();
                let left = FirstTurn::new(&hoop, Start::at(0.0, -rate)).unwrap();
                assert_eq!(
                    mirrored(&right.sequence.to_string()),
                    left.sequence.to_string()
                );
                assert_eq!(
                    (right.stop, right.time.to_bits()),
                    (left.stop, left.time.to_bits())
                );
            }
        }
    }
}
