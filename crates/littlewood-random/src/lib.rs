//! Random hoops, starts and limits over the whole accepted range: the one generator of tests,
//! fuzzers, digests and measurements.
//!
//! Sizes are log-uniform up to the bound of each quantity. Mixed with them are zero, the bounds,
//! the smallest numbers, numbers that a person types, ties (equal coefficients, a particle on the
//! rim, multiples of π/2, starts on a boundary of the phase plane) and the usual ranges. The same
//! seed draws the same numbers on every machine.

use std::f64::consts::{FRAC_PI_2, PI};

use littlewood::tables::{Bound, Quantity, Setup};
use littlewood::theory::{Body, PhasePlane};
use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, SlipDirection, Start};

/// Small numbers, each of which some computation may take for zero.
const TINY: [f64; 12] = [
    5e-324,
    f64::MIN_POSITIVE,
    1e-300,
    1e-150,
    1e-30,
    1e-16,
    2e-16,
    1e-12,
    1e-9,
    1e-6,
    1e-4,
    1e-3,
];

/// Numbers that a person types.
const NICE: [f64; 8] = [0.1, 0.25, 0.4, 0.5, 0.75, 1.0, 2.0, 3.0];

/// Numbers that are no parameter of anything.
const WRONG: [f64; 8] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    -1.0,
    -5e-324,
    1.000_000_000_000_000_2e9,
];

/// A motion, to τ = 20, whose slip sticks where pressing closes the gap: the jam that follows at the
/// same instant ends no phase. A random search found it.
pub fn jam_after_a_stick() -> Setup {
    let hoop = HoopParameters::thin(1.356_047_422_593_375_2e-10)
        .with_inertia(0.0)
        .with_friction(2.459_977_907_555_684_8e5, 2.459_977_907_555_684_8e5)
        .with_rolling_resistance(0.148_703_238_957_026_58)
        .with_slope(5.537_676_958_089_897e-4)
        .with_restitution(0.0, RestitutionLaw::Poisson);
    Setup::new(hoop, Start::at(-1e-16, 0.425_739_530_581_016_93))
}

/// Random numbers (SplitMix64).
#[derive(Clone, Debug)]
pub struct Draw(u64);

impl Draw {
    /// The numbers of a case, independent of those of other cases.
    #[must_use]
    pub fn of_case(seed: u64, stream: u64, number: u64) -> Self {
        let mut draw = Self(seed);
        let mixed = draw.bits() ^ stream.wrapping_mul(0xd134_2543_de82_ef95);
        let mut draw = Self(mixed);
        Self(draw.bits() ^ number.wrapping_mul(0x9e6c_63d0_876a_68ed))
    }

    /// 64 random bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below another.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }

    /// A number from 0 to 1, uniform.
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between two, uniform.
    // An array, as the usual range of a quantity in its table.
    pub fn between(&mut self, [from, to]: [f64; 2]) -> f64 {
        from + (to - from) * self.share()
    }

    /// True with this probability.
    pub fn comes(&mut self, probability: f64) -> bool {
        self.share() < probability
    }

    /// One of some items; panics without any.
    pub fn one_of<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// A number between two powers of ten, uniform in its logarithm.
    // An array, as `between`.
    pub fn of_any_size(&mut self, powers: [f64; 2]) -> f64 {
        libm::exp10(self.between(powers))
    }

    /// A value that a quantity may have by itself.
    pub fn allowed(&mut self, quantity: Quantity) -> f64 {
        let most = largest(quantity);
        let size = match self.below(12) {
            0 => 0.0,
            1 => most,
            2 => most.next_down(),
            3 => self.one_of(&TINY),
            4 => self.one_of(&NICE),
            5 | 6 => self.of_any_size([-12.0, libm::log10(most)]),
            7 => self.of_any_size([-2.0, libm::log10(most).min(2.0)]),
            8 if quantity == Quantity::Theta => {
                let quarters = self.below(13) as f64 - 6.0;
                self.beside(quarters * FRAC_PI_2)
            }
            _ => self.between(quantity.row().usual),
        };
        let value = if self.comes(0.5) { -size } else { size };
        if quantity.check(value).is_ok() {
            value
        } else {
            size.clamp(0.0, most)
        }
    }

    /// A number, or one beside it.
    fn beside(&mut self, value: f64) -> f64 {
        match self.below(5) {
            0 => value.next_up(),
            1 => value.next_down(),
            2 => value + self.one_of(&[1e-12, -1e-9, 1e-6]),
            _ => value,
        }
    }

    /// A value that may be out of bounds.
    pub fn any(&mut self, quantity: Quantity) -> f64 {
        match self.below(8) {
            0 => self.one_of(&WRONG),
            1 => largest(quantity).next_up(),
            2 => -self.allowed(quantity),
            _ => self.allowed(quantity),
        }
    }

    /// Parameters of a hoop, each within its bounds; now and then they contradict each other.
    pub fn hoop(&mut self) -> HoopParameters {
        let (mass_ratio, inertia) = match self.below(8) {
            0 => (0.0, 0.0),
            1 => (0.0, self.allowed(Quantity::Inertia)),
            2 => (self.allowed(Quantity::MassRatio), 0.0),
            3 => {
                let mass_ratio = self.allowed(Quantity::MassRatio);
                (mass_ratio, mass_ratio)
            }
            _ => (
                self.allowed(Quantity::MassRatio),
                self.allowed(Quantity::Inertia),
            ),
        };
        let offset = if self.comes(0.3) {
            1.0
        } else {
            self.allowed(Quantity::Offset)
        };
        let mu_s = self.allowed(Quantity::MuS).abs();
        let mu_k = match self.below(10) {
            0 | 1 => mu_s,
            2 => 0.0,
            3 => mu_s.next_down().max(0.0),
            4 => mu_s * (1.0 - self.one_of(&TINY)),
            5 => self.allowed(Quantity::MuK),
            _ => mu_s * self.share(),
        };
        let hoop = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k);
        if inertia == 0.0 || self.comes(0.6) {
            return hoop;
        }
        let coefficient = match self.below(4) {
            0 => 0.0,
            1 => 1.0,
            2 => self.allowed(Quantity::Restitution),
            _ => self.share(),
        };
        hoop.with_restitution(coefficient, self.one_of(RestitutionLaw::ALL.as_slice()))
    }

    /// A start, each number within its bounds.
    pub fn start(&mut self) -> Start {
        let theta = if self.comes(0.5) {
            self.between([-PI, PI])
        } else {
            self.allowed(Quantity::Theta)
        };
        let mut start = Start::at(theta, self.allowed(Quantity::ThetaRate));
        if self.comes(0.5) {
            start = start.with_slip(self.allowed(Quantity::Slip));
        }
        if self.comes(0.1) {
            start = start.with_gap_rate(self.allowed(Quantity::GapRate));
        }
        if self.comes(0.1) {
            start = start
                .with_time(self.allowed(Quantity::Time))
                .with_x(self.allowed(Quantity::X));
        }
        start
    }

    /// A start on a boundary of the phase plane of a hoop, to the last digit or nearly so; none
    /// where the boundary does not cross the angle that was drawn, or is out of bounds there.
    pub fn on_boundary(&mut self, hoop: &Hoop) -> Option<Start> {
        let plane = PhasePlane::new(hoop);
        let theta = self.between([-PI, PI]);
        let rate = boundary_rate(&plane, theta, self.below(BOUNDARIES))?;
        let nudge = self.one_of(&[0.0, 0.0, 0.0, 1e-15, -1e-15, 1e-9, -1e-9, 1e-6]);
        let rate = (if self.comes(0.5) { -rate } else { rate }) * (1.0 + nudge);
        Quantity::ThetaRate
            .check(rate)
            .is_ok()
            .then(|| Start::at(theta, rate))
    }

    /// A hoop with a start; now and then they contradict each other.
    pub fn setup(&mut self) -> Setup {
        let (hoop, start) = (self.hoop(), self.start());
        let boundary = if self.comes(0.15) {
            Hoop::new(hoop).ok()
        } else {
            None
        };
        Setup::new(
            hoop,
            boundary
                .and_then(|hoop| self.on_boundary(&hoop))
                .unwrap_or(start),
        )
    }

    /// The same, drawn until they are accepted.
    pub fn motion(&mut self) -> (Hoop, Start) {
        loop {
            let Setup { hoop, start } = self.setup();
            if let Ok(hoop) = Hoop::new(hoop)
                && hoop
                    .simulate(
                        start,
                        Limits::default()
                            .with_transitions(1)
                            .with_until(Some(start.time)),
                    )
                    .is_ok()
            {
                return (hoop, start);
            }
        }
    }

    /// The same of a hoop that is not massless.
    pub fn heavy_motion(&mut self) -> (Hoop, Start) {
        loop {
            let (hoop, start) = self.motion();
            if matches!(hoop.body(), Body::Heavy(_)) {
                return (hoop, start);
            }
        }
    }

    /// A hoop that is put on a slope, up to nearly vertical.
    pub fn on_slope(&mut self, hoop: &Hoop) -> Hoop {
        let slope = if self.comes(0.5) {
            self.between([-1.5, 1.5])
        } else {
            self.allowed(Quantity::Slope)
        };
        let slope = if self.comes(0.1) {
            libm::atan(hoop.mu_s()).copysign(slope)
        } else {
            slope
        };
        Hoop::new(hoop.parameters().with_slope(slope)).unwrap_or(*hoop)
    }

    /// A hoop whose rotation the plane resists: by coefficients of any size, often next to the least
    /// at which a level hoop rests anywhere, or at which rolling has Painlevé's paradox.
    pub fn resisted(&mut self, hoop: &Hoop) -> Hoop {
        let coefficient = match self.below(10) {
            0 => self.beside(hoop.h()),
            1 => {
                let offset = hoop.offset();
                let ratio = (1.0 + hoop.mass_ratio() + hoop.inertia() + offset * offset) / offset;
                self.beside((ratio * ratio - 4.0).max(0.0).sqrt())
            }
            2..=5 => self.of_any_size([-12.0, 1.0]),
            6 | 7 => self.allowed(Quantity::RollingResistance),
            _ => self.between(Quantity::RollingResistance.row().usual),
        };
        let resists = |coefficient: f64| {
            Hoop::new(hoop.parameters().with_rolling_resistance(coefficient)).ok()
        };
        resists(coefficient.max(0.0)).unwrap_or(*hoop)
    }

    /// As [`Draw::in_contact`] with rolling resistance, often without rotation, and next to an angle
    /// at which the hoop begins to turn out of rest or of a skid.
    pub fn resisted_in_contact(&mut self) -> (Hoop, Start) {
        let (hoop, start) = self.in_contact();
        let hoop = self.resisted(&hoop);
        let mut start = start;
        if self.comes(0.4) {
            start.theta_rate = 0.0;
        }
        if self.comes(0.3) {
            // The weight at rest, and kinetic friction in a skid, pull with this part of N.
            let pull = match SlipDirection::of_sign(start.slip) {
                None => libm::tan(hoop.slope()),
                Some(direction) => -direction.sign() * hoop.mu_k(),
            };
            let arm = hoop.h() * (1.0 + pull * pull).sqrt();
            let balance = self.one_of(&[-1.0, 1.0]) * hoop.rolling_resistance() - pull;
            let angle = libm::asin(balance / arm);
            let angle = if self.comes(0.5) { angle } else { PI - angle };
            if angle.is_finite() {
                start.theta = self.beside(angle - libm::atan(pull));
            }
        }
        (hoop, start)
    }

    /// A hoop and a start in contact with sizes about one, for the modes that may follow: level or
    /// on a slope, down to small inertia, on rough planes and smooth ones. Often next to where a
    /// mode begins to be consistent, or on it: the lift-off of the particle, the limits of the
    /// phase plane, Painlevé's friction.
    pub fn in_contact(&mut self) -> (Hoop, Start) {
        loop {
            if let Some(drawn) = self.try_in_contact() {
                return drawn;
            }
        }
    }

    fn try_in_contact(&mut self) -> Option<(Hoop, Start)> {
        let mass_ratio = match self.below(4) {
            0 => 0.0,
            1 => self.of_any_size([-6.0, 0.5]),
            _ => self.between([0.0, 3.0]),
        };
        let inertia = match self.below(5) {
            0 => 0.0,
            1 => mass_ratio,
            _ => self.of_any_size([-6.0, 0.5]),
        };
        let offset = match self.below(6) {
            0 | 1 => 1.0,
            2 => self.of_any_size([-3.0, 0.0]),
            3 => self.one_of(&[0.0, 0.5, 1.0_f64.next_down()]),
            _ => self.share(),
        };
        let slope = match self.below(4) {
            0 => 0.0,
            1 => self.of_any_size([-6.0, 0.0]),
            _ => self.between([0.0, 1.57]),
        };
        let theta = if self.comes(0.1) {
            let quarters = self.below(5) as f64 - 2.0;
            self.beside(quarters * FRAC_PI_2)
        } else {
            self.between([-PI, PI])
        };
        let (sin, cos) = libm::sincos(theta);
        let mass = 1.0 + mass_ratio;
        let h = offset / mass;
        let painleve = (inertia + mass_ratio * offset * h + mass * (h * sin) * (h * sin))
            / (mass * h * sin.abs() * (1.0 + h * cos));
        let (mu_s, mu_k) = self.friction_about(painleve);
        let slope = if self.comes(0.5) { -slope } else { slope };
        let hoop = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k)
            .with_slope(slope);
        let hoop = Hoop::new(hoop).ok()?;
        let rate = self.rate_in_contact(&hoop, theta)?;
        let slip = match self.below(4) {
            0 => self.of_any_size([-9.0, 0.5]),
            1 => -self.of_any_size([-9.0, 0.5]),
            _ => 0.0,
        };
        Quantity::ThetaRate.check(rate).ok()?;
        Some((hoop, Start::at(theta, rate).with_slip(slip)))
    }

    /// Coefficients of static and kinetic friction, often next to one at which P vanishes.
    fn friction_about(&mut self, painleve: f64) -> (f64, f64) {
        let mu_s = match self.below(6) {
            0 => self.one_of(&NICE),
            1 => self.one_of(&[0.0, 1e-9, 1e3]),
            2 if painleve < 1e3 => painleve * (1.0 + self.of_any_size([-15.0, 0.0])),
            _ => self.of_any_size([-2.0, 1.5]),
        };
        let mu_k = match self.below(6) {
            0 | 1 => mu_s,
            2 => 0.0,
            3 if painleve < mu_s => self.beside(painleve),
            _ => mu_s * self.share(),
        };
        (mu_s, mu_k)
    }

    /// θ′ at an angle, often next to where the hoop lifts off, or on a boundary of the phase plane;
    /// none where the boundary does not cross the angle.
    fn rate_in_contact(&mut self, hoop: &Hoop, theta: f64) -> Option<f64> {
        let lift_off = (libm::cos(hoop.slope()) / (hoop.h() * libm::cos(theta))).sqrt();
        let rate = match self.below(6) {
            0 => 0.0,
            1 => boundary_rate(&PhasePlane::new(hoop), theta, self.below(BOUNDARIES))?,
            2 | 3 if lift_off.is_finite() => {
                let away = self.of_any_size([-16.0, 0.5]);
                lift_off
                    * (1.0
                        + if self.comes(0.2) {
                            -away.min(1.0)
                        } else {
                            away
                        })
            }
            _ => self.of_any_size([-3.0, 1.0]),
        };
        Some(if self.comes(0.5) { -rate } else { rate })
    }

    /// A hoop and a start as a person sets them: every number in its usual range.
    pub fn usual(&mut self) -> Setup {
        let mut usual = |quantity: Quantity| self.between(quantity.row().usual);
        let hoop = [Quantity::MassRatio, Quantity::Offset, Quantity::Inertia].map(&mut usual);
        let start = [Quantity::Theta, Quantity::ThetaRate, Quantity::Slip].map(&mut usual);
        let mu_s = usual(Quantity::MuS);
        let mu_k = mu_s * self.share();
        let mut hoop = HoopParameters::thin(hoop[0])
            .with_offset(hoop[1])
            .with_inertia(hoop[2])
            .with_friction(mu_s, mu_k);
        if self.comes(0.2) {
            hoop = hoop.with_restitution(self.share(), self.one_of(RestitutionLaw::ALL.as_slice()));
        }
        let slip = if self.comes(0.5) { start[2] } else { 0.0 };
        Setup::new(hoop, Start::at(start[0], start[1]).with_slip(slip))
    }

    /// Limits of the motion from a start.
    pub fn limits(&mut self, start: Start) -> Limits {
        let until = match self.below(4) {
            0 | 1 => None,
            2 => Some(start.time + self.one_of(&[0.0, 1e-300, 1e-9, 1.0, 50.0, 1e5, 1e9, 1e150])),
            _ => Some(start.time + self.of_any_size([-3.0, 4.0])),
        };
        let limits = Limits::default().with_until(until);
        if self.comes(0.3) {
            limits.with_transitions(self.one_of(&[1, 2, 3, 7, 100]))
        } else {
            limits
        }
    }
}

/// Boundaries of the phase plane: N = 0 and slip to either side in rolling, lift-off, and the
/// separatrix.
pub const BOUNDARIES: usize = 5;

/// θ′ on one of them, by its number, at an angle; none where it does not cross the angle.
pub fn boundary_rate(plane: &PhasePlane, theta: f64, which: usize) -> Option<f64> {
    match which {
        0 => plane.normal_force_rate(theta),
        1 => plane.slip_rate(theta, SlipDirection::Positive),
        2 => plane.slip_rate(theta, SlipDirection::Negative),
        3 => plane.lift_off_rate(theta),
        _ => Some(plane.separatrix_rate(theta)),
    }
}

/// The largest value that a quantity may have; of one without a bound a large one.
fn largest(quantity: Quantity) -> f64 {
    let bound = |bound: &Bound| match *bound {
        Bound::AtMostConstant(most)
        | Bound::MagnitudeAtMost(most)
        | Bound::ResolvedAtMost(most) => Some(most),
        Bound::MagnitudeBelow(bound) => Some(bound.next_down()),
        Bound::Finite
        | Bound::Positive
        | Bound::NonNegative
        | Bound::AtMost(..)
        | Bound::AtLeast(..) => None,
    };
    quantity.bounds().iter().find_map(bound).unwrap_or(1e9)
}

/// The command that follows a motion.
pub fn command(setup: &Setup, limits: Limits) -> String {
    let mut words = "littlewood simulate".to_owned();
    for quantity in Quantity::HOOP.into_iter().chain(Quantity::START) {
        if let Some(value) = setup.get(quantity)
            && quantity.row().presence.default_value() != Some(value)
        {
            words += &format!(" --{} {value:e}", quantity.name().replace('_', "-"));
        }
    }
    if let Some(law) = setup.hoop.restitution_law {
        words += &format!(" --restitution-law {law}");
    }
    if let Some(until) = limits.until {
        words += &format!(" --until {until:e}");
    }
    if limits != Limits::default().with_until(limits.until) {
        words += &format!(" --max-transitions {}", limits.transitions);
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of the generator from 1234567, as published with the reference
    /// implementation.
    #[test]
    fn the_generator_is_split_mix_64() {
        let mut draw = Draw(1_234_567);
        assert_eq!(
            [draw.bits(), draw.bits(), draw.bits()],
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }
}
