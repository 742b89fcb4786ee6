//! Motions that bounce for ever: two symmetric flights a turn, without slip at any impact.
//!
//! With e = 1 and enough friction there is one such motion for each impact angle φ. The hoop flies
//! over the top from θ = −φ to φ at the rate ω1, then under the bottom to 2π − φ at the rate ω2.
//! Each flight is symmetric in time: the slip velocity is zero at both ends, and the gap closes at
//! the speed v at which it opened:
//!
//! ```text
//! v = φ/ω1 − h sin φ ω1 = (π − φ)/ω2 + h sin φ ω2,   ω2 − ω1 = κ v,   κ = 2 m h sin φ/D(φ).
//! ```
//!
//! The last equation is the change of θ′ in an elastic impact that sticks. With α = 1 − κ h sin φ,
//! X = ω1² solves
//!
//! ```text
//! h sin φ α (1 + α) X² + (π − 2 α² φ) X − α κ φ² = 0.
//! ```

use core::f64::consts::PI;

use crate::model::{Body, Hoop, Start};

/// A motion that bounces for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BouncingOrbit {
    /// Angle φ of the impacts, 0 < φ < π.
    pub angle: f64,
    /// Rate ω1 of the flight over the top.
    pub top_rate: f64,
    /// Rate ω2 of the flight under the bottom.
    pub bottom_rate: f64,
    /// Gap rate v after each impact.
    pub gap_rate: f64,
    /// Least coefficient of static friction for which the impacts stick.
    pub friction: f64,
}

impl BouncingOrbit {
    /// The motion of a hoop with impacts at this angle. `None` for a massless or a balanced hoop,
    /// on a slope, with rolling resistance, which takes energy from each impact, for an angle outside (0, π), and where the rim would penetrate the plane.
    ///
    /// ```
    /// use littlewood::impact::BouncingOrbit;
    /// use littlewood::Hoop;
    ///
    /// let hoop = Hoop::equal_masses(0.5, 0.4)?;
    /// let orbit = BouncingOrbit::new(&hoop, 1.0).expect("bounces");
    /// assert!((orbit.gap_rate - (1.0 / orbit.top_rate - 0.5 * 1.0_f64.sin() * orbit.top_rate)).abs() < 1e-14);
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    pub fn new(hoop: &Hoop, angle: f64) -> Option<Self> {
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        let loses = hoop.slope() != 0.0 || hoop.rolling_resistance() != 0.0;
        if !(angle > 0.0 && angle < PI) || body.h == 0.0 || loses {
            return None;
        }
        let (sin, cos) = libm::sincos(angle);
        let (arm, lever) = (body.h * sin, 1.0 + body.h * cos);
        let about_contact = body.inertia + body.mass * lever * lever;
        let kappa = 2.0 * body.mass * arm / (about_contact + body.mass * arm * arm);
        let alpha = 1.0 - kappa * arm;
        let (square, linear, constant) = (
            arm * alpha * (1.0 + alpha),
            PI - 2.0 * alpha * alpha * angle,
            -alpha * kappa * angle * angle,
        );
        // The larger root, without cancellation. For α > 0 the roots have opposite signs.
        let root = (linear * linear - 4.0 * square * constant).max(0.0).sqrt();
        let top_square = if linear > 0.0 {
            -2.0 * constant / (linear + root)
        } else {
            (root - linear) / (2.0 * square)
        };
        let top_rate = top_square.sqrt();
        let gap_rate = angle / top_rate - arm * top_rate;
        let orbit = Self {
            angle,
            top_rate,
            bottom_rate: top_rate + kappa * gap_rate,
            gap_rate,
            friction: body.mass * arm * lever / about_contact,
        };
        // For α ≤ 0 the rates have no positive solution. Under the bottom the gap decreases from
        // the middle of the flight to its ends. Over the top its slope changes sign at most once in
        // each half, so it is positive throughout if it is at mid-flight, where it is (φ/ω1)²/2 − h
        // (1 − cos φ). Then v > 0.
        let opens = angle / top_rate > 2.0 * body.h.sqrt() * libm::sin(0.5 * angle);
        (alpha > 0.0 && opens).then_some(orbit)
    }

    /// Time of one turn.
    pub fn period(&self) -> f64 {
        2.0 * (self.angle / self.top_rate + (PI - self.angle) / self.bottom_rate)
    }

    /// The start of the flight over the top.
    pub fn start(&self) -> Start {
        Start::at(-self.angle, self.top_rate).with_gap_rate(self.gap_rate)
    }
}
