//! Where sliding is well posed: P = Î + m h sin θ q as a trigonometric polynomial, and its zeros.

use crate::form::Trigonometric;
use crate::hoop::Heavy;

/// P and q of slides with σ = +1 at every angle, with this coefficient of friction; those with σ = −1 are the mirror image.
pub(crate) fn solvability(body: &Heavy, mu: f64) -> (Trigonometric, Trigonometric) {
    let Heavy { mass, h, inertia, .. } = *body;
    let q = Trigonometric::linear(-mu, h, -mu * h);
    let p = Trigonometric::sin().times(&q).scaled(mass * h).plus(&Trigonometric::linear(inertia, 0.0, 0.0));
    (p, q)
}

/// Whether P > 0 at every angle.
pub(crate) fn is_solvable(body: &Heavy, mu: f64) -> bool {
    body.inertia > 0.0 && solvability(body, mu).0.sign_changes().is_empty()
}

/// Whether P > 0 at every angle, of either direction of slip, whose cosine is at most this.
pub(crate) fn is_solvable_below(body: &Heavy, mu: f64, cos: f64) -> bool {
    // At the bottom P is Î.
    solvability(body, mu).0.sign_changes().into_iter().all(|angle| libm::cos(angle) > cos)
}
