//! What holds in a flight, from the printed states alone.

use littlewood::modes::{Flight, PhaseSolution};
use littlewood::{Cause, Hoop, Mode, Phase, State, Trajectory};

use super::dd::Dd;
use super::instants;

/// A start of a flight, with the rate of the gap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TakeOff {
    pub(crate) h: f64,
    pub(crate) state: State,
    pub(crate) gap_rate: f64,
    /// Out of sliding: 1 = h cos θ θ′².
    pub(crate) lifts_off: bool,
    /// θ as it is followed, without whole turns of the start of the motion.
    pub(crate) followed: f64,
}

impl TakeOff {
    /// That of a flight of a motion, by its index among the phases.
    fn of(motion: &Trajectory, index: usize, flight: &Flight) -> Self {
        let state = motion.phases()[index].start();
        let slid = index > 0 && motion.phases()[index - 1].mode() == Mode::Sliding;
        let gap_rate = flight.take_off_rate();
        let lifts_off = slid && gap_rate == 0.0;
        Self {
            h: motion.hoop().h(),
            state,
            gap_rate,
            lifts_off,
            followed: flight.state(0.0).theta,
        }
    }

    /// Height of the rim over the plane after a time, by a parabola and a cosine added up as they
    /// stand, and what its computation in doubles may be off by.
    ///
    /// The terms of the gap are rounded, each a few times; beyond a radian the whole terms, below
    /// what is left of them at the start. The time is known to its last digits. At a lift-off 1 = h
    /// cos θ θ′² is taken for exact, and the printed state leaves a rest.
    pub(crate) fn gap(&self, time: f64) -> (f64, f64) {
        let Self {
            h,
            state:
                State {
                    theta,
                    theta_rate: rate,
                    ..
                },
            gap_rate,
            lifts_off,
            followed,
        } = *self;
        let (h_, rate_, time_) = (Dd::from(h), Dd::from(rate), Dd::from(time));
        let angle = Dd::from(theta).without_turns();
        let ((sin0, cos0), (sin1, cos1)) = (angle.sincos(), (angle + rate_ * time_).sincos());
        let rise = Dd::from(gap_rate) - h_ * sin0 * rate_;
        let gap = rise * time_ - Dd::from(0.5) * time_ * time_ + h_ * (cos0 - cos1);
        let slope = rise.high - time + (h_ * sin1 * rate_).high;

        let (sin, cos, turned) = (sin0.high.abs(), cos0.high.abs(), (rate * time).abs());
        let square = turned * turned;
        let (versine, odd, even) = if turned < 1.0 {
            (0.5 * square, square * turned / 6.0, square * square / 24.0)
        } else {
            (2.0, 1.0 + turned, 2.0)
        };
        // h cos θ θ′² − 1, the acceleration at the start, is a difference.
        let bend = if turned < 1.0 {
            h * cos * rate * rate
        } else {
            0.0
        };
        let terms =
            gap_rate * time + 0.5 * (1.0 + bend) * time * time + h * (cos * even + sin * odd);
        // What sums of two doubles leave, of terms that cancel.
        let rest = 16.0 * f64::EPSILON * (gap_rate * time + time * time + h * (2.0 + turned));
        let mut rounding = 4.0 * f64::EPSILON * (terms + time * slope.abs() + rest);
        if theta != followed {
            // A motion is followed without the whole turns of its start: the printed angle is the
            // rounded sum of both.
            let digit = f64::EPSILON * theta.abs().max(followed.abs());
            rounding += digit * h * (sin * versine + cos * odd);
        }
        if !lifts_off {
            return (gap.high, rounding);
        }
        // By so much another cosine changes the gap, and the sine that goes with it.
        let change = versine + cos / sin * odd;
        (
            gap.high,
            rounding + (self.rest() + f64::EPSILON * h * cos) * change,
        )
    }

    /// Of h cos θ = 1/θ′² at a lift-off, what the printed state leaves.
    fn rest(&self) -> f64 {
        let (rate, (_, cos)) = (
            Dd::from(self.state.theta_rate),
            Dd::from(self.state.theta).without_turns().sincos(),
        );
        let rest = Dd::from(self.h) * cos * rate * rate - Dd::from(1.0);
        if self.lifts_off {
            rest.high.abs() / (rate.high * rate.high)
        } else {
            0.0
        }
    }
}

/// Asserts that the rim is at the plane at each landing of a motion: how many there are.
#[track_caller]
pub(crate) fn check_landings(motion: &Trajectory) -> usize {
    let mut landings = 0;
    for (index, phase) in motion.phases().iter().enumerate() {
        let PhaseSolution::Flight(flight) = phase.solution() else {
            continue;
        };
        if motion
            .end_of(phase)
            .is_some_and(|end| end.cause == Cause::Landing)
        {
            let (gap, rounding) = TakeOff::of(motion, index, flight).gap(flight.duration());
            assert!(
                gap.abs() <= rounding,
                "gap {gap:e} where {rounding:e} is rounding, at a landing: {phase:?}"
            );
            landings += 1;
        }
    }
    landings
}

/// Asserts of instants of each flight of a motion that the rim is above the plane, and that the
/// numbers of the state there have the energy and the momentum of the start: how many flights there
/// are.
#[track_caller]
pub(crate) fn check_flights(motion: &Trajectory) -> usize {
    let mut flights = 0;
    for (index, phase) in motion.phases().iter().enumerate() {
        let PhaseSolution::Flight(flight) = phase.solution() else {
            continue;
        };
        let take_off = TakeOff::of(motion, index, flight);
        for elapsed in instants(phase.duration().min(flight.duration()), 40) {
            check_instant(motion.hoop(), phase, (&take_off, flight), elapsed);
        }
        flights += 1;
    }
    flights
}

#[track_caller]
fn check_instant(
    hoop: &Hoop,
    phase: &Phase,
    (take_off, flight): (&TakeOff, &Flight),
    elapsed: f64,
) {
    let (first, now) = (phase.first(), flight.state(elapsed));
    let (m, h, rate, v) = (hoop.mass(), hoop.h(), now.theta_rate, take_off.gap_rate);
    let (there, slope) = flight.gap(elapsed);
    let (sin, cos) = libm::sincos(now.theta);
    let [vx, vy] = [now.slip - (1.0 + h * cos) * rate, slope - h * sin * rate];
    let (x, y) = flight.mass_centre_velocity(elapsed);
    let [along, up] = [
        now.slip.abs() + (1.0 + h) * rate.abs(),
        v + elapsed + h * rate.abs(),
    ];
    // The last digit of an angle moves the rim, and so does the rest at a lift-off.
    let digit = f64::EPSILON * (1.0 + now.theta.abs() + first.state.theta.abs());
    let lean = if take_off.lifts_off {
        1.0 / libm::sin(first.state.theta).abs()
    } else {
        0.0
    };
    let swing = (digit * h + 2.0 * take_off.rest() * lean) * rate.abs();
    assert!(
        (vx - x).abs() <= 4.0 * f64::EPSILON * along + swing,
        "{vx} {x} at {elapsed}: {first:?}"
    );
    if flight.settles() {
        return;
    }
    let (exact, rounding) = take_off.gap(elapsed);
    assert!(
        (there - exact).abs() <= rounding,
        "{there:e} {exact:e} {rounding:e} at {elapsed}: {first:?}"
    );
    let height = flight.apex().1;
    assert!(
        there >= -rounding && there <= height + rounding,
        "{there:e} of {height:e}: {first:?}"
    );
    assert!(
        (vy - y).abs() <= 8.0 * f64::EPSILON * up + swing,
        "{vy} {y} at {elapsed}: {first:?}"
    );
    let spin = hoop.body().inertia_about_mass_centre() * rate * rate;
    let energy = 0.5 * (m * (vx * vx + vy * vy) + spin) + hoop.offset() * cos + m * there;
    let size = m * (along * along + up * up + h + there) + spin;
    let error = m * (swing * (vy.abs() + swing) + digit * h + rounding);
    assert!(
        (energy - first.energy).abs() <= 8.0 * f64::EPSILON * size + error,
        "{energy}: {first:?}"
    );
    assert_eq!(phase.sample(0.5 * elapsed).energy, first.energy);
}
