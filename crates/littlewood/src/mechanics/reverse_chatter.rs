//! Reverse chatter: bounces that grow out of rolling, infinitely many in a finite time
//! (docs/studies/bounces-out-of-nothing.md).
//!
//! With w = cos α − h cos θ θ′², a = −h sin θ θ′² − sin α, the compliances A, B, C, M = μk A − |B|,
//! p = 2 |a|/(w M) and the slopes k1 = C − μk |B| and k2 = C − B²/A of the gap rate in slip and in
//! stick, the ratio of successive bounces exceeds e only if a B > 0 and M > 0. It exceeds 1 where p
//! lies between two numbers of the angle, and so θ′² between two linear forms.
//!
//! With rolling resistance B is m h sin θ (1 + h cos θ) with h sin θ − ς χ for h sin θ, and k2 =
//! Dχ/(m J). The slip of a bounce may end in a reversal, and out of rest the hoop may turn, so that
//! bounces are followed until they repeat themselves.

use crate::mechanics::impact::Sticking;
use crate::mechanics::region::PhasePlane;
use crate::mechanics::settling::{NoSettling, RATIO_ROUNDING};
use crate::mechanics::{BounceConditions, Bounces, Contact, ContactVelocities, contact};
use crate::model::{Body, Heavy, Restitution, RestitutionLaw, RotationDirection, SlipDirection};

/// θ′ of a hoop whose rotation no bounce ends, of bounces with a gap rate of 1.
const FAST: f64 = 1e200;

/// The ratio of bounces that do end it, as where a hoop that rolls stops dead, is larger.
const LARGEST_RATIO: f64 = 1e100;

/// The values of p between which bounces grow; k2 > k1.
fn growing(restitution: Restitution, slopes: &Sticking) -> Option<[f64; 2]> {
    let (k1, k2) = (slopes.in_slip, slopes.in_stick);
    let e = restitution.coefficient();
    let gain = k2 - k1;
    let (low, high) = match restitution.law() {
        RestitutionLaw::Energetic => {
            let root = ((e * e * k2 - k1) / gain).sqrt();
            (
                (1.0 - e) * (1.0 + e) / (e * gain * (e + root)),
                (1.0 + root) / k1,
            )
        }
        RestitutionLaw::Poisson => ((1.0 - e) / (e * gain), ((1.0 + e) * k2 / k1 - 2.0) / gain),
        RestitutionLaw::Newton => return None,
    };
    let high = if k1 > 0.0 { high } else { f64::INFINITY };
    (low < high).then_some([low, high])
}

/// The ratio of bounces that grow, with rolling resistance. Out of rolling the bounces are too small
/// to end the rotation.
fn resisted_growth(body: &Heavy, conditions: BounceConditions) -> Option<f64> {
    let theta_rate = if conditions.theta_rate == 0.0 {
        0.0
    } else {
        FAST.copysign(conditions.theta_rate)
    };
    let thrown = ContactVelocities {
        theta_rate,
        slip: 0.0,
        gap_rate: 1.0,
    };
    match Bounces::of(body, conditions).and_then(|it| it.sum(thrown, f64::INFINITY)) {
        Err(NoSettling::Grows { ratio }) => {
            (ratio > 1.0 + RATIO_ROUNDING && ratio < LARGEST_RATIO).then_some(ratio)
        }
        Ok(_) | Err(_) => None,
    }
}

impl PhasePlane {
    /// The body and its restitution, and the slope of the plane.
    fn bouncing(&self) -> Option<(Heavy, Restitution)> {
        let Body::Heavy(body) = self.hoop.body() else {
            return None;
        };
        Some((body, self.hoop.restitution()?))
    }

    /// The ratio of successive bounces, where bounces grow out of rolling (reverse chatter): there
    /// rolling, or rest, is not the only motion. `None` where they do not grow, without a
    /// coefficient of restitution, and on a level plane.
    ///
    /// ```
    /// use littlewood::theory::PhasePlane;
    /// use littlewood::{Hoop, HoopParameters, RestitutionLaw};
    ///
    /// // A loaded hoop at rest on a slope of 40°, with the particle uphill.
    /// let parameters = HoopParameters::thin(0.3).with_friction(1.5, 1.5).with_slope(40_f64.to_radians());
    /// let hoop = Hoop::new(parameters.with_restitution(0.8, RestitutionLaw::Energetic))?;
    /// let ratio = PhasePlane::new(&hoop).reverse_chatter(-1.5, 0.0).expect("bounces grow");
    /// assert!((1.0..1.5).contains(&ratio));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    pub fn reverse_chatter(&self, theta: f64, theta_rate: f64) -> Option<f64> {
        let (body, restitution) = self.bouncing()?;
        let rate = theta_rate / self.pace;
        let (sin, cos) = libm::sincos(theta);
        let weight = contact(1.0, body.h, cos * (rate * rate));
        let drift = -body.h * sin * (rate * rate) - body.pull();
        if self.hoop.rolling_resistance() > 0.0 {
            let conditions = BounceConditions {
                theta,
                theta_rate: rate,
                friction: self.hoop.friction(),
                restitution,
                gravity: 1.0,
            };
            return resisted_growth(&body, conditions);
        }
        if !(weight > 0.0 && drift * sin > 0.0) {
            return None;
        }
        let before = ContactVelocities {
            theta_rate: 0.0,
            slip: 2.0 * drift / weight,
            gap_rate: -1.0,
        };
        let ratio = Contact::new(&self.hoop, &body, theta)
            .impact(before, restitution)
            .after
            .gap_rate;
        (ratio.is_finite() && ratio > 1.0 + RATIO_ROUNDING).then_some(ratio)
    }

    /// |θ′| between which bounces grow out of rolling in this direction at an angle. Without rolling
    /// resistance they are those of both.
    pub fn reverse_chatter_rates(
        &self,
        theta: f64,
        rotation: RotationDirection,
    ) -> Option<[f64; 2]> {
        let (body, restitution) = self.bouncing()?;
        let (sin, cos) = libm::sincos(theta);
        let pull = body.pull();
        if pull * sin >= 0.0 {
            return None;
        }
        let direction = SlipDirection::of_sign(sin)?;
        let slopes = Contact::new(&self.hoop, &body, theta).sticking(direction, rotation)?;
        let [low, high] = growing(restitution, &slopes)?;
        // |a| over w lies between ½ M p, and both are linear in u: constant + slope u > 0.
        let beyond = |share: f64| [pull.abs() - share, -body.h * (sin.abs() - share * cos)];
        let [least, most] = [low, high].map(|p| 0.5 * slopes.braking * p);
        let until = if most.is_finite() {
            beyond(most).map(|term| -term)
        } else {
            [1.0, -body.h * cos]
        };
        let mut range = [0.0, f64::INFINITY];
        for [constant, slope] in [beyond(least), until] {
            let root = -constant / slope;
            if slope < 0.0 {
                range[1] = f64::min(range[1], root);
            } else if slope > 0.0 {
                range[0] = f64::max(range[0], root);
            } else if constant <= 0.0 {
                return None;
            }
        }
        (range[0] < range[1] && range[1].is_finite()).then(|| range.map(|u| self.pace * u.sqrt()))
    }
}
