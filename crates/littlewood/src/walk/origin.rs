//! The origin of a motion: τ, x and the whole turns of its start, and the pace of gravity normal to
//! the plane.
//!
//! The equations depend neither on τ nor on x, and on θ only through its sine and cosine. So each
//! motion is simulated from τ = 0, x = 0 and
//! |θ| ≤ π, and the origin is added to the results. Each result is the rounded sum of two numbers; nothing else depends on the origin.
//!
//! On a slope α the motion is simulated in units in which gravity normal to the plane is 1.
//! Velocities are then divided by √cos α, times multiplied by it, and forces and energies divided
//! by cos α. On a level plane these factors are 1 and change no bit.

use crate::math::trig::{WholeTurns, neutral_zero, split_turns};
use crate::mechanics::{ContactForces, ContactVelocities, Impact, Impulse};
use crate::model::{Dimension, Hoop, Limits, Start, State, Undecided};
use crate::modes::{Position, Recurrence, RollingEnd, Sample, SlideLimit};
use crate::walk::{Candidates, Outcome};

/// The τ, x and whole turns of a start, and the units of its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    time: f64,
    x: f64,
    /// Whole turns, which restore θ of the start exactly.
    turns: WholeTurns,
    /// The time limit relative to the start, and as given.
    until: Option<[f64; 2]>,
    /// √cos α, the unit of velocity.
    pace: f64,
    /// θ′ and η′ of the start relative to the origin, and as given: what does not change is given
    /// back as it was.
    velocities: [[f64; 2]; 2],
    /// The energy at the x of the start, m x sin α.
    height: f64,
}

/// A start relative to its origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RelativeStart {
    pub(crate) state: State,
    /// The rate at which the rim leaves the plane.
    pub(crate) gap_rate: f64,
}

impl Origin {
    /// The origin of a motion, and its start and limits relative to it.
    pub(crate) fn of(hoop: &Hoop, start: &Start, limits: Limits) -> (Self, RelativeStart, Limits) {
        let state = start.state();
        let pace = hoop.pace();
        let (theta, turns) = split_turns(state.theta);
        let [time, x] = [state.time, state.x].map(neutral_zero);
        let until = limits
            .until
            .map(|until| [(until - state.time) * pace, until]);
        let relative = State {
            time: 0.0,
            theta,
            theta_rate: state.theta_rate / pace,
            slip: state.slip / pace,
            x: 0.0,
        };
        let velocities = [
            [relative.theta_rate, state.theta_rate],
            [relative.slip, state.slip],
        ];
        let height = if hoop.slope() == 0.0 {
            -0.0
        } else {
            hoop.mass() * x * libm::sin(hoop.slope())
        };
        (
            Self {
                time,
                x,
                turns,
                until,
                pace,
                velocities,
                height,
            },
            RelativeStart {
                state: relative,
                gap_rate: start.gap_rate / pace,
            },
            limits.with_until(until.map(|[elapsed, _]| elapsed)),
        )
    }

    pub(crate) const fn time(&self, elapsed: f64) -> f64 {
        match self.until {
            // The difference may have lost digits of a limit near zero.
            Some([most, until]) if elapsed == most => until,
            Some(_) | None => self.time + elapsed / self.pace,
        }
    }

    pub(crate) const fn elapsed(&self, time: f64) -> f64 {
        (time - self.time) * self.pace
    }

    pub(crate) const fn duration(&self, elapsed: f64) -> f64 {
        elapsed / self.pace
    }

    /// A time since an instant, from the units of the results.
    pub(crate) const fn passed(&self, duration: f64) -> f64 {
        duration * self.pace
    }

    pub(crate) const fn velocity(&self, velocity: f64) -> f64 {
        velocity * self.pace
    }

    /// A force, an acceleration or a difference of energies in the units of the results.
    pub(crate) const fn force(&self, force: f64) -> f64 {
        force * (self.pace * self.pace)
    }

    pub(crate) const fn energy(&self, energy: f64) -> f64 {
        self.force(energy) + self.height
    }

    pub(crate) const fn theta(&self, theta: f64) -> f64 {
        self.turns.add_to(theta)
    }

    /// The absolute state from one relative to the origin.
    pub(crate) const fn state(&self, state: State) -> State {
        let State {
            time,
            theta,
            theta_rate,
            slip,
            x,
        } = state;
        let [[seen_rate, rate], [seen_slip, given_slip]] = self.velocities;
        let theta_rate = if theta_rate.to_bits() == seen_rate.to_bits() {
            rate
        } else {
            self.velocity(theta_rate)
        };
        let slip = if slip.to_bits() == seen_slip.to_bits() {
            given_slip
        } else {
            self.velocity(slip)
        };
        State {
            time: self.time(time),
            theta: self.theta(theta),
            theta_rate,
            slip,
            x: self.x + x,
        }
    }

    pub(crate) fn sample(&self, sample: Sample) -> Sample {
        let moved = |position: Position| Position {
            x: self.x + position.x,
            ..position
        };
        Sample {
            state: self.state(sample.state),
            centre: moved(sample.centre),
            mass_centre: moved(sample.mass_centre),
            particle: moved(sample.particle),
            theta_acceleration: self.force(sample.theta_acceleration),
            slip_acceleration: self.force(sample.slip_acceleration),
            normal: self.force(sample.normal),
            friction: self.force(sample.friction),
            couple: self.force(sample.couple),
            gap_rate: self.velocity(sample.gap_rate),
            energy: self.energy(sample.energy),
            ..sample
        }
    }

    pub(crate) const fn forces(&self, forces: ContactForces) -> ContactForces {
        ContactForces {
            normal: self.force(forces.normal),
            friction: self.force(forces.friction),
        }
    }

    pub(crate) const fn candidates(&self, candidates: Candidates) -> Candidates {
        Candidates {
            rolling_forces: self.forces(candidates.rolling_forces),
            ..candidates
        }
    }

    pub(crate) fn undecided(&self, undecided: Undecided) -> Undecided {
        undecided.map(|value| match undecided.dimension() {
            Dimension::Time => self.duration(value),
            Dimension::AngularRate | Dimension::Velocity => self.velocity(value),
            _ => value,
        })
    }

    pub(crate) const fn rolling_end(&self, end: RollingEnd) -> RollingEnd {
        RollingEnd {
            elapsed: self.duration(end.elapsed),
            theta: self.theta(end.theta),
            theta_rate: self.velocity(end.theta_rate),
            ..end
        }
    }

    const fn velocities(&self, velocities: ContactVelocities) -> ContactVelocities {
        let ContactVelocities {
            theta_rate,
            slip,
            gap_rate,
        } = velocities;
        let [theta_rate, slip, gap_rate] = [
            self.velocity(theta_rate),
            self.velocity(slip),
            self.velocity(gap_rate),
        ];
        ContactVelocities {
            theta_rate,
            slip,
            gap_rate,
        }
    }

    pub(crate) const fn impact(&self, impact: Impact) -> Impact {
        let Impulse { normal, friction } = impact.impulse;
        Impact {
            before: self.velocities(impact.before),
            after: self.velocities(impact.after),
            impulse: Impulse {
                normal: self.velocity(normal),
                friction: self.velocity(friction),
            },
            normal_work: self.force(impact.normal_work),
            friction_work: self.force(impact.friction_work),
            resistance_work: self.force(impact.resistance_work),
            ..impact
        }
    }

    pub(crate) fn outcome(&self, mut outcome: Outcome) -> Outcome {
        let state = outcome.state_mut();
        *state = self.state(*state);
        match &mut outcome {
            Outcome::Landing { gap_rate, .. } => *gap_rate = self.velocity(*gap_rate),
            Outcome::RollsForever { recurrence, .. }
            | Outcome::SlidesForever { recurrence, .. } => {
                *recurrence = self.recurrence(*recurrence);
            }
            Outcome::Unresolved { undecided, .. } => {
                *undecided = self.undecided(*undecided);
            }
            Outcome::RepeatsForever { period, .. } => *period = self.duration(*period),
            Outcome::Inconsistent { candidates, .. } | Outcome::Ambiguous { candidates, .. } => {
                *candidates = self.candidates(*candidates);
            }
            Outcome::StepLimit {
                limit: SlideLimit::One { time_left, .. },
                ..
            } => {
                *time_left = self.duration(*time_left);
            }
            // A motion slips for ever on a level plane only, whose units are those of the results.
            Outcome::SlipsForever { .. }
            | Outcome::StepLimit {
                limit: SlideLimit::All { .. },
                ..
            }
            | Outcome::StaysInContact { .. }
            | Outcome::Rests { .. }
            | Outcome::ParticleAtPlane { .. }
            | Outcome::ParticleAtBottom { .. }
            | Outcome::ParticleAtTop { .. }
            | Outcome::TimeLimit { .. }
            | Outcome::TransitionLimit { .. }
            | Outcome::Singular { .. } => {}
        }
        outcome
    }

    pub(crate) fn recurrence(&self, recurrence: Recurrence) -> Recurrence {
        match recurrence.at_pace(self.pace) {
            Recurrence::Libration {
                period,
                theta_min,
                theta_max,
            } => {
                let (theta_min, theta_max) = (self.theta(theta_min), self.theta(theta_max));
                Recurrence::Libration {
                    period,
                    theta_min,
                    theta_max,
                }
            }
            Recurrence::Asymptotic { theta } => Recurrence::Asymptotic {
                theta: self.theta(theta),
            },
            same @ (Recurrence::Rest
            | Recurrence::Rotation { .. }
            | Recurrence::Downhill { .. }) => same,
        }
    }
}
