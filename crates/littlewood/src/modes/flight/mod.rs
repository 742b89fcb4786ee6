//! Free flight (§2e): the mass centre follows a parabola and the hoop turns at constant rate, until
//! the rim touches down (docs/theory/jumps.md).
//!
//! With φ = ω Δτ, ω = |θ′|, C = cos φ − 1 + φ²/2, S = φ − sin φ, and angles positive in the
//! direction of rotation, the gap is
//!
//! ```text
//! v φ/ω + b φ²/2 − h [c0 C(φ) + s0 S(φ)],   b = h c0 − 1/θ′²    up to one radian,
//! v φ/ω − φ²/(2 θ′²) + h [c0 (1 − cos φ) − s0 S(φ)]             beyond, where b would lose digits of a fast hoop.
//! ```
//!
//! The search excludes its roots at the start. The zeros of its second derivative are known;
//! between them gap′ is monotone, and between the zeros of gap′ the gap is. For h θ′² ≤ 1 the gap
//! is concave and the argument is the time, which also covers a hoop that does not turn.

mod gap;

use crate::math::number::Number;
use crate::math::trig::{Angle, sincos};
use crate::mechanics::{Accelerations, Clearance, ContactForces, energy};
use crate::model::{Heavy, Hoop, Mode, Quantity, State, getters};
use crate::modes::{Instant, Sample, Undecided};

use gap::{Bound, Gap, MAX_RESOLVED_ANGLE};

pub(crate) use gap::sine_follows_from_rate;

/// Turn below which the change of the slip is computed as such. The difference of velocities has six
/// digits of it there, and next to ε none, so that bounces that grow would not. Those that settle
/// are summed before they are as short.
const MAX_BRIEF_TURN: f64 = 1e-10;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TakeOff {
    /// The normal force vanishes: 1 = h cos θ θ′².
    Grazing,
    /// 1 < h cos θ θ′²: the plane cannot hold the rim.
    Unloaded,
    /// The gap opens at this rate.
    Rising { gap_rate: f64 },
}

/// Arguments, in the angle φ or the time, of the landing and of the maximum of the gap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlightExtent {
    pub(crate) landing: f64,
    pub(crate) apex: f64,
}

/// A phase of flight.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    h: f64,
    pull: f64,
    start: State,
    vx: f64,
    vy: f64,
    mass_centre_x: f64,
    gap: Gap,
    /// Rate of the argument of the gap in time: |θ′|, or 1.
    clock: f64,
    landing: Bound,
    /// Maximum of the gap; none if it is computed on demand.
    apex: Option<Bound>,
    /// Whether the flight stands for infinitely many bounces, with a gap below 1e-14.
    settles: bool,
}

getters! {
    Flight, [self]:
    /// Whether the flight stands for infinitely many bounces after which the hoop settles.
    pub settles: bool = self.settles;
    /// Rate of the gap at the start.
    pub take_off_rate: f64 = self.gap.rise * self.clock;
    /// Whether it begins at a lift-off from sliding, where the gap opens with the third power of
    /// the time.
    pub(crate) lifts_off: bool = self.gap.opening == 0.0 && self.gap.rise == 0.0;
    /// Time from the start of the flight to the landing.
    pub duration: f64 = self.landing.at / self.clock;
}

impl Flight {
    /// From a state with the rim on the plane. The decision on flight used the same cosine, so 1 −
    /// h cos θ θ′² has the same sign here.
    pub(crate) fn new(body: &Heavy, start: State, take_off: TakeOff) -> Self {
        Self::at_angle(body, start, take_off, start.theta.angle())
    }

    /// [`Self::new`] with the sine and cosine of the angle.
    pub(crate) fn at_angle(body: &Heavy, start: State, take_off: TakeOff, angle: Angle) -> Self {
        let flight = Self::without_landing(body, start, take_off, angle);
        if flight.is_concave() {
            return Self {
                landing: flight.gap.only_landing(),
                ..flight
            };
        }
        let (apex, landing) = flight.gap.extent();
        Self {
            landing,
            apex: Some(apex),
            ..flight
        }
    }

    /// [`Self::new`] with known angles φ.
    pub(crate) fn with_extent(
        body: &Heavy,
        start: State,
        take_off: TakeOff,
        angle: Angle,
        extent: FlightExtent,
    ) -> Self {
        let flight = Self::without_landing(body, start, take_off, angle);
        let [landing, apex] = [extent.landing, extent.apex].map(|phi| flight.gap.bound(phi));
        Self {
            landing,
            apex: Some(apex),
            ..flight
        }
    }

    /// A flight whose landing and maximum are still unset.
    fn without_landing(
        body: &Heavy,
        start: State,
        take_off: TakeOff,
        Angle { sin, cos }: Angle,
    ) -> Self {
        let h = body.h;
        let rate = start.theta_rate;
        let travel = if rate < 0.0 { -1.0 } else { 1.0 };
        let square = rate * rate;
        // −w, with the w of the decision on flight.
        let opening = h * (cos * square) - 1.0;
        let weight = 1.0 / square;
        let in_angle = Gap {
            h,
            sin: travel * sin,
            cos,
            rise: 0.0,
            opening: opening * weight,
            weight,
            spin: 1.0,
            theta: travel * start.theta,
        };
        let rising = |gap_rate: f64| {
            let in_time = Gap {
                rise: gap_rate,
                opening,
                weight: 1.0,
                spin: rate.abs(),
                ..in_angle
            };
            if h * square <= 1.0 || in_time.is_parabola() {
                (in_time, 1.0, gap_rate)
            } else {
                let rise = gap_rate / rate.abs();
                (Gap { rise, ..in_angle }, rate.abs(), gap_rate)
            }
        };
        let (gap, clock, gap_rate) = match take_off {
            TakeOff::Grazing => (in_angle.at_lift_off(), rate.abs(), 0.0),
            TakeOff::Unloaded => (in_angle, rate.abs(), 0.0),
            TakeOff::Rising { gap_rate } => rising(gap_rate),
        };
        Self {
            h,
            pull: body.pull(),
            start,
            vx: start.slip - (1.0 + h * cos) * rate,
            vy: gap_rate - h * sin * rate,
            mass_centre_x: start.x - h * sin,
            gap,
            clock,
            landing: Bound::default(),
            apex: None,
            settles: false,
        }
    }

    /// Infinitely many bounces of total duration `duration`, as one flight.
    pub(crate) fn settling(body: &Heavy, start: State, gap_rate: f64, duration: f64) -> Self {
        let angle = start.theta.angle();
        let rate = start.theta_rate;
        let take_off = TakeOff::Rising { gap_rate };
        let flight = Self::without_landing(body, start, take_off, angle);
        let opening = body.h * (angle.cos * (rate * rate)) - 1.0;
        let gap = Gap {
            rise: gap_rate,
            opening,
            weight: 1.0,
            spin: rate.abs(),
            ..flight.gap
        };
        let landing = Bound {
            at: duration,
            ..Bound::default()
        };
        Self {
            gap,
            clock: 1.0,
            landing,
            settles: true,
            ..flight
        }
    }

    /// Whether the gap is concave up to the landing; its argument is then the time.
    fn is_concave(&self) -> bool {
        let is_slow = self.h * (self.start.theta_rate * self.start.theta_rate) <= 1.0;
        self.gap.rise > 0.0 && (is_slow || self.gap.is_parabola())
    }

    fn highest(&self) -> Bound {
        self.apex
            .unwrap_or_else(|| self.gap.only_apex(self.landing.at))
    }

    /// Arguments of the landing and of the maximum of the gap.
    pub(crate) fn extent(&self) -> FlightExtent {
        FlightExtent {
            landing: self.landing.at,
            apex: self.highest().at,
        }
    }

    /// Why the landing is not resolved: on a steep slope a flight may last for more turns than
    /// doubles tell apart.
    pub(crate) fn undecided(&self) -> Option<Undecided> {
        (self.landing.at >= MAX_RESOLVED_ANGLE).then_some(Undecided::Range {
            quantity: Quantity::Theta,
            value: self.landing.at,
            bound: MAX_RESOLVED_ANGLE,
        })
    }

    pub(crate) fn landing_rate(&self) -> f64 {
        self.clock * self.landing.slope
    }

    /// Time since the start, and height, of the largest gap between the rim and the plane. Both are
    /// zero for settling bounces, whose gap is not resolved.
    pub fn apex(&self) -> (f64, f64) {
        if self.settles {
            return (0.0, 0.0);
        }
        let Bound { at, gap, .. } = self.highest();
        (at / self.clock, gap)
    }

    /// State after the time `elapsed`.
    pub fn state(&self, elapsed: f64) -> State {
        let rate = self.start.theta_rate;
        let turn = rate * elapsed;
        let theta = self.start.theta + turn;
        let (sin, cos) = sincos(theta);
        let is_brief = elapsed > 0.0 && turn.abs() < MAX_BRIEF_TURN;
        let slip = if is_brief && !self.settles {
            let middle = libm::sin(self.start.theta + 0.5 * turn);
            self.start.slip - (self.pull + self.h * (rate * rate) * middle) * elapsed
        } else {
            self.vx - self.pull * elapsed + (1.0 + self.h * cos) * rate
        };
        State {
            time: self.start.time + elapsed,
            theta,
            theta_rate: rate,
            slip,
            x: self.mass_centre_x + (self.vx - 0.5 * self.pull * elapsed) * elapsed + self.h * sin,
        }
    }

    /// Gap under the rim and its rate after the time `elapsed`. For settling bounces the gap is
    /// zero, and the rate is that of a flight without impacts: the impulses act together at the
    /// end.
    pub fn gap(&self, elapsed: f64) -> (f64, f64) {
        let Bound { gap, slope, .. } = self.gap.bound(self.clock * elapsed);
        (if self.settles { 0.0 } else { gap }, self.clock * slope)
    }

    /// Velocity (x̄′, ȳ′) of the mass centre after the time `elapsed`; x̄′ is conserved on a level
    /// plane.
    pub fn mass_centre_velocity(&self, elapsed: f64) -> (f64, f64) {
        (self.vx - self.pull * elapsed, self.vy - elapsed)
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State, elapsed: f64) -> Sample {
        let (gap, gap_rate) = self.gap(elapsed);
        let rate = state.theta_rate;
        let instant = Instant {
            mode: Mode::Flight,
            direction: None,
            accelerations: Accelerations {
                theta: 0.0,
                slip: -self.h * libm::sin(state.theta) * rate * rate - self.pull,
            },
            forces: ContactForces::NONE,
            couple: 0.0,
            clearance: Clearance { gap, gap_rate },
        };
        // The energy of the start: at an angle of many turns, the rounding of θ times the rate
        // dominates the velocities.
        let energy = energy(hoop, &self.start, 0.0, self.take_off_rate());
        Sample {
            energy,
            ..instant.sample(hoop, state)
        }
    }
}
