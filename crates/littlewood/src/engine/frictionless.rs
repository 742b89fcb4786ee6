//! Slides without kinetic friction: both first integrals in closed form.
//!
//! With c = cos ϑ, s = sin ϑ and u = ϑ′² the contact breaks where 1 − h c u = (Î + m h² − h C c + m h² c²)/J vanishes, whose numerator
//! falls towards the top as long as u ≥ 0; η′ vanishes only where A² J = (C − 2 m h c)(1 + h c)², a cubic equation. C, A and J are those
//! of [`FrictionlessIntegrals`].

use crate::math::bernstein::Bernstein;
use crate::mechanics::equations::contact;
use crate::mechanics::frictionless::FrictionlessIntegrals;
use crate::model::hoop::Heavy;

use super::place::Place;

/// A lift-off, a turning point at the top, or a zero of η′ that is nearer than this part of the terms is left to the solvers of phases.
const SIGN_TOLERANCE: f64 = 1e-9;

/// Whether a slide without kinetic friction comes so close to the top, at so low a rate, or stays so close to rest at the bottom, that
/// rounding tells whether it passes, or which way it goes.
pub(super) fn is_next_to_equilibrium(body: &Heavy, place: &Place) -> bool {
    let energy = FrictionlessIntegrals::new(body, &place.state, place.direction).energy;
    let over_bottom = energy + 2.0 * body.offset;
    over_bottom <= 8.0 * f64::EPSILON * body.offset
        || (energy - 2.0 * body.offset).abs() <= SIGN_TOLERANCE * energy.abs()
}

/// Whether a slide without kinetic friction is proved to have no event: it repeats itself for ever.
pub(super) fn slides_forever(body: &Heavy, Place { state, direction }: &Place) -> bool {
    let Heavy { h, inertia, offset, .. } = *body;
    let integrals = FrictionlessIntegrals::new(body, state, *direction);
    let FrictionlessIntegrals { energy, momentum } = integrals;
    let over_top = energy - 2.0 * offset;
    let rotates = over_top > SIGN_TOLERANCE * energy.abs();
    if !rotates && over_top > -SIGN_TOLERANCE * energy.abs() {
        return false;
    }
    if rotates && contact(1.0, h, over_top / inertia) < SIGN_TOLERANCE {
        return false;
    }
    // The same sign as θ′ all the way round.
    if rotates && momentum * state.theta_rate > 0.0 {
        return true;
    }
    // In powers of c + 1, up to the turning point or the top.
    let width = if rotates { 2.0 } else { 1.0 + energy / (2.0 * offset) };
    let terms = integrals.standstills(body, -1.0);
    let size = terms.iter().flatten().fold(0.0, |size: f64, term| size.max(term.abs()));
    let excess = Bernstein::from_taylor(&terms.map(|[first, second]| first + second), width);
    let least = SIGN_TOLERANCE * size;
    excess.coefficients().iter().all(|c| *c > least)
        || (rotates && excess.coefficients().iter().all(|c| *c < -least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::trig::sincos;
    use crate::model::hoop::{Body, Hoop};
    use crate::model::limits::Limits;
    use crate::model::state::{Start, State};
    use crate::walk::outcome::OutcomeKind;

    /// What is not known to slide for ever is only followed for longer, which no test of answers would notice.
    #[test]
    fn most_that_slides_for_ever_is_known_to() {
        let hoop = Hoop::figure_2(0.0, 0.0).unwrap();
        let Body::Heavy(body) = hoop.body() else { unreachable!("it has mass") };
        // Librations, and rotations.
        let (mut for_ever, mut known) = ([0, 0], [0, 0]);
        for i in 0..32 {
            for j in 0..32 {
                let start = Start::at(0.05 + 0.2 * f64::from(i), -2.2 + 0.14 * f64::from(j)).with_slip(0.3);
                let motion = hoop.simulate(start, Limits::default()).unwrap();
                let state = State::from(start);
                let is_known = slides_forever(&body, &Place::new(state));
                if motion.transitions().is_empty() && motion.outcome().kind() == OutcomeKind::SlidesForever {
                    let energy = FrictionlessIntegrals::new(&body, &state, sincos(state.theta)).energy;
                    let rotates = usize::from(energy > 2.0 * body.offset);
                    for_ever[rotates] += 1;
                    known[rotates] += usize::from(is_known);
                } else {
                    assert!(!is_known, "{start:?}");
                }
            }
        }
        assert!(for_ever.into_iter().all(|count| count > 30), "{for_ever:?}");
        for (known, all) in known.into_iter().zip(for_ever) {
            assert!(5 * known > 4 * all, "{known} of {all}");
        }
    }
}
