//! The formulas of sliding with σ = +1.

use crate::hoop::Heavy;
use crate::trig::sincos;

/// Formulas of sliding with σ = +1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    pub(super) body: Heavy,
    pub(super) mu: f64,
}

impl Law {
    pub(super) fn q(&self, sin: f64, cos: f64) -> f64 {
        self.body.h * sin - self.mu * (1.0 + self.body.h * cos)
    }

    pub(super) fn p(&self, sin: f64, cos: f64) -> f64 {
        self.body.inertia + self.body.mass * self.body.h * sin * self.q(sin, cos)
    }

    /// a of du/dϑ = a w.
    pub(super) fn drive(&self, sin: f64, cos: f64) -> f64 {
        2.0 * self.body.mass * self.q(sin, cos) / self.p(sin, cos)
    }

    /// α and β of η″ = α + β u.
    pub(super) fn slip_acceleration(&self, sin: f64, cos: f64) -> (f64, f64) {
        let Heavy { mass, h, inertia, .. } = self.body;
        let alpha = ((1.0 + h * cos) * mass * self.q(sin, cos) - self.mu * inertia) / self.p(sin, cos);
        (alpha, -h * cos * alpha - h * sin)
    }

    /// Its zeros are the extrema over ϑ of the level on which η″ = 0: α′β − β′α − a β h sin ϑ.
    pub(super) fn level_slope(&self, theta: f64) -> f64 {
        let Heavy { mass, h, inertia, .. } = self.body;
        let (sin, cos) = sincos(theta);
        let (q, p) = (self.q(sin, cos), self.p(sin, cos));
        let q_slope = h * cos + self.mu * h * sin;
        let p_slope = mass * h * (cos * q + sin * q_slope);
        let top = (1.0 + h * cos) * mass * q - self.mu * inertia;
        let top_slope = mass * ((1.0 + h * cos) * q_slope - h * sin * q);
        let (alpha, beta) = self.slip_acceleration(sin, cos);
        let alpha_slope = (top_slope * p - top * p_slope) / (p * p);
        let beta_slope = -h * (cos * alpha_slope - sin * alpha) - h * cos;
        alpha_slope * beta - beta_slope * alpha - self.drive(sin, cos) * beta * h * sin
    }
}
