//! Well-posedness of sliding: P = Î + m h sin θ q as a trigonometric polynomial, and its zeros.

use crate::math::form::Trigonometric;
use crate::model::Heavy;

/// P and q as functions of θ for σ = +1 and this coefficient of friction; those for σ = −1 are the
/// mirror image.
pub(crate) fn solvability(body: &Heavy, mu: f64) -> (Trigonometric, Trigonometric) {
    let h = body.h;
    let q = Trigonometric::linear(-mu, h, -mu * h);
    let p = Trigonometric::sin()
        .times(&q)
        .scaled(body.mass * h)
        .plus(&Trigonometric::linear(body.inertia, 0.0, 0.0));
    (p, q)
}

/// Whether P > 0 at every angle, and so with less friction.
pub(crate) fn is_solvable(body: &Heavy, mu: f64) -> bool {
    let (h, inertia) = (body.h, body.inertia);
    // At a cosine P is least where sin θ is this. Where it vanishes there no zero need be searched
    // for.
    let (mut sin, mut cos) = (1.0, 0.0);
    for _ in 0..3 {
        sin = (0.5 * mu * (1.0 + h * cos) / h).min(1.0);
        cos = (1.0 - sin * sin).sqrt();
    }
    let vanishes = inertia + body.mass * h * sin * (h * sin - mu * (1.0 + h * cos)) <= 0.0;
    inertia > 0.0 && !vanishes && lowest_zero(body, mu).is_none()
}

/// Least cos θ at which P vanishes, for either direction of slip; `None` where P has no zeros. At
/// the bottom P = Î, so P > 0 at smaller cosines.
pub(crate) fn lowest_zero(body: &Heavy, mu: f64) -> Option<f64> {
    if is_clearly_positive(body, mu) {
        return None;
    }
    solvability(body, mu)
        .0
        .sign_changes()
        .into_iter()
        .map(libm::cos)
        .reduce(f64::min)
}

/// Whether bounds of P tell that P > 0 at every angle.
fn is_clearly_positive(body: &Heavy, mu: f64) -> bool {
    const PARTS: u32 = 8;
    let h = body.h;
    // With y = h |sin θ| from one number to another, P ≥ Î − m y μ (1 + h cos θ) + m y² with the
    // largest cosine.
    (0..PARTS).all(|part| {
        let [low, high] = [part, part + 1].map(|part| f64::from(part) / f64::from(PARTS));
        let friction = mu * (1.0 + h * (1.0 - low * low).sqrt());
        let y = (0.5 * friction).clamp(h * low, h * high);
        body.mass * y * (friction - y) < (1.0 - 1e-9) * body.inertia
    })
}
