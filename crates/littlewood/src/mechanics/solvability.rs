//! Well-posedness of sliding: P = Î + m h sin θ q as a trigonometric polynomial, and its zeros.

use crate::math::form::Trigonometric;
use crate::model::Heavy;

/// P and q as functions of θ for σ = +1 and this coefficient of friction; those for σ = −1 are the mirror image.
pub(crate) fn solvability(body: &Heavy, mu: f64) -> (Trigonometric, Trigonometric) {
    let Heavy { mass, h, inertia, .. } = *body;
    let q = Trigonometric::linear(-mu, h, -mu * h);
    let p = Trigonometric::sin().times(&q).scaled(mass * h).plus(&Trigonometric::linear(inertia, 0.0, 0.0));
    (p, q)
}

/// Whether P > 0 at every angle, and so with less friction.
pub(crate) fn is_solvable(body: &Heavy, mu: f64) -> bool {
    let Heavy { mass, h, inertia, .. } = *body;
    // At a cosine P is least where sin θ is this. Where it vanishes there no zero need be searched for.
    let (mut sin, mut cos) = (1.0, 0.0);
    for _ in 0..3 {
        sin = (0.5 * mu * (1.0 + h * cos) / h).min(1.0);
        cos = (1.0 - sin * sin).sqrt();
    }
    let vanishes = inertia + mass * h * sin * (h * sin - mu * (1.0 + h * cos)) <= 0.0;
    inertia > 0.0 && !vanishes && lowest_zero(body, mu).is_none()
}

/// Least cos θ at which P vanishes, for either direction of slip; `None` where P has no zeros. At the bottom P = Î, so
/// P > 0 at smaller cosines.
pub(crate) fn lowest_zero(body: &Heavy, mu: f64) -> Option<f64> {
    if is_clearly_positive(body, mu) {
        return None;
    }
    solvability(body, mu).0.sign_changes().into_iter().map(libm::cos).reduce(f64::min)
}

/// Whether bounds of P tell that P > 0 at every angle.
fn is_clearly_positive(body: &Heavy, mu: f64) -> bool {
    const PARTS: u32 = 8;
    let Heavy { mass, h, inertia, .. } = *body;
    // With y = h |sin θ| from one number to another, P ≥ Î − m y μ (1 + h cos θ) + m y² with the largest cosine.
    (0..PARTS).all(|part| {
        let [low, high] = [part, part + 1].map(|part| f64::from(part) / f64::from(PARTS));
        let friction = mu * (1.0 + h * (1.0 - low * low).sqrt());
        let y = (0.5 * friction).clamp(h * low, h * high);
        mass * y * (friction - y) < (1.0 - 1e-9) * inertia
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Hoop, HoopParameters, Start, State};
    use core::f64::consts::PI;

    /// Inertias close to the lower bound of P, on both sides, are included. No lift-off is proved as far up as P is positive.
    #[test]
    fn the_lowest_zero_is_the_first_on_the_way_up() {
        let (mut with, mut without) = (0, 0);
        for h in [0.05, 0.3, 0.7, 1.0] {
            for mu in [0.1, 0.8, 3.0] {
                let bound = 0.25 * mu * mu * (1.0 + h) * (1.0 + h);
                for part in [0.05, 0.3, 0.6, 0.9, 1.0 - 1e-6, 1.0 + 1e-6, 2.0] {
                    let body = Heavy { mass: 1.0, h, offset: h, inertia: bound * part, tilt: -0.0 };
                    let p = |theta: f64, sigma: f64| {
                        let (sin, cos) = libm::sincos(theta);
                        body.inertia + h * sin * (h * sin - sigma * mu * (1.0 + h * cos))
                    };
                    let lowest = lowest_zero(&body, mu);
                    let seen = (0..=20_000)
                        .map(|k| PI * (1.0 - f64::from(k) / 20_000.0))
                        .find(|theta| p(*theta, 1.0) <= 0.0 || p(*theta, -1.0) <= 0.0);
                    assert_eq!(is_solvable(&body, mu), lowest.is_none(), "{body:?} {mu}");
                    let Some(lowest) = lowest else {
                        assert_eq!(seen, None, "{body:?} {mu}");
                        without += 1;
                        continue;
                    };
                    let parameters = HoopParameters::thin(0.0).with_offset(h).with_inertia(body.inertia);
                    let hoop = Hoop::new(parameters.with_friction(mu, mu)).unwrap();
                    // At rest E = ℓ̂ cos θ.
                    let is_proved =
                        |cos: f64| hoop.never_lifts_off(&State::from(Start::at(libm::acos(cos), 0.0)));
                    assert!(is_proved((lowest - 1e-3).max(-1.0)), "{body:?} {mu}");
                    assert!(!is_proved((lowest + 1e-3).min(1.0)), "{body:?} {mu}");
                    if let Some(theta) = seen {
                        with += 1;
                        assert!(
                            lowest <= libm::cos(theta) && lowest > libm::cos(theta + PI / 20_000.0),
                            "{body:?} {mu}"
                        );
                    } else {
                        // The zero lies between two samples.
                        let least = p(libm::acos(lowest), 1.0).min(p(libm::acos(lowest), -1.0));
                        assert!(least.abs() < 1e-12, "{body:?} {mu}: {least}");
                    }
                }
            }
        }
        assert!(with > 20 && without > 20, "{with} {without}");
    }
}
