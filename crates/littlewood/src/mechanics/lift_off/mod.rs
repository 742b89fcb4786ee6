//! The least energy of a lift-off, and the proof that a motion never lifts off.

mod turn;

use std::sync::OnceLock;

use crate::math::bernstein::Bernstein;
use crate::math::trig::Angle;
use crate::mechanics::{FrictionlessIntegrals, energy, lowest_zero};
use crate::model::{Body, Heavy, Hoop, State};
use turn::{ENERGY_ROUNDING, WholeTurns, at_most};

impl Hoop {
    /// Least energy (2.8) of a lift-off, Î/(2h) + ℓ̂. Infinite for a balanced hoop, whose normal
    /// force is constant; `None` for a massless hoop, which stays at the plane, and on a slope,
    /// down which energy grows.
    ///
    /// A hoop in contact leaves the plane only where h cos θ θ′² ≥ 1 (2.18). Its energy is at least
    /// ½ (Î + m h² sin²θ) θ′² + ℓ̂ cos θ, the value for a mass centre that moves vertically. With
    /// θ′² = 1/(h cos θ) this decreases as cos θ grows, to Î/(2h) + ℓ̂ at the top. Sliding
    /// dissipates energy and rolling conserves it. A hoop in contact with less energy therefore
    /// never lifts off.
    ///
    /// ```
    /// let hoop = littlewood::Hoop::equal_masses(0.5, 0.4)?;
    /// assert_eq!(hoop.lift_off_energy(), Some(2.5));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    pub fn lift_off_energy(&self) -> Option<f64> {
        match self.body() {
            // A hoop gains energy down a slope.
            Body::Heavy(_) if self.slope() != 0.0 => None,
            Body::Heavy(body) if body.h == 0.0 => Some(f64::INFINITY),
            Body::Heavy(body) => Some(0.5 * body.inertia / body.h + body.offset),
            Body::Massless(_) => None,
        }
    }

    /// Whether energy and momentum prove, by a margin that covers rounding, that a hoop in contact
    /// at this state never lifts off; on a slope, and with rolling resistance, nothing is proved. The proof requires P > 0 at all
    /// angles it can reach, ℓ̂ cos θ ≤ E: where P ≤ 0, an impact without collision can throw the
    /// hoop up.
    ///
    /// It holds if the energy is below [`Hoop::lift_off_energy`]. It also holds if the energy
    /// without m V²/2, with V the horizontal velocity of the mass centre, is below it, and V is too
    /// small for friction to supply the difference, at any instant or over a whole turn.
    pub fn never_lifts_off(&self, state: &State) -> bool {
        ContactProof::default().holds(self, state)
    }
}

/// The proof that a hoop never lifts off, with the results common to all states of one hoop.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactProof {
    /// [`lowest_zero`] of P.
    lowest_zero: OnceLock<Option<f64>>,
    /// Bounds from the work of friction over whole turns, if they prove anything.
    whole_turns: OnceLock<Option<WholeTurns>>,
}

impl ContactProof {
    pub(crate) fn holds(&self, hoop: &Hoop, state: &State) -> bool {
        let Body::Heavy(body) = hoop.body() else {
            return false;
        };
        let Some(needed) = hoop.lift_off_energy() else {
            return false;
        };
        if hoop.rolling_resistance() > 0.0 {
            return false;
        }
        let energy = at_most(energy(hoop, state, 0.0, 0.0));
        let suffices = || {
            let turning =
                at_most(FrictionlessIntegrals::new(&body, state, Angle::of(state.theta)).energy);
            let (energy, needed) = (2.0 * energy, 2.0 * needed);
            let whole_turns = || WholeTurns::new(&body, hoop.friction(), needed);
            turning < needed
                && (turns_too_slowly(&body, energy, needed)
                    || self
                        .whole_turns
                        .get_or_init(whole_turns)
                        .is_some_and(|whole| turning < whole.turning && energy < whole.energy))
        };
        let zero = self
            .lowest_zero
            .get_or_init(|| lowest_zero(&body, hoop.mu_k()));
        zero.is_none_or(|cos| cos > energy / body.offset) && (energy < needed || suffices())
    }
}

/// Whether V is always too small for C, twice the energy without m V²/2, to grow to the value of a
/// lift-off.
///
/// dC = 2 m (η′ − V) dV and m dV = −σ μ N dτ, with η′ = V + θ′ (1 + h cos θ). C grows, in rolling
/// and in sliding, only where V has the sign of −θ′ and |V| ≥ |θ′| (1 + h cos θ). At the C of a
/// lift-off, |θ′| (1 + h cos θ) has a minimum over a turn, while m V² is at most twice the energy
/// minus C.
fn turns_too_slowly(body: &Heavy, energy: f64, needed: f64) -> bool {
    let fastest = FrictionlessIntegrals {
        energy: needed,
        momentum: ((energy - needed) / body.mass).sqrt(),
    };
    // In powers of cos θ + 1.
    let terms = fastest.standstills(body, -1.0);
    let size = terms
        .iter()
        .flatten()
        .fold(0.0, |size: f64, term| size.max(term.abs()));
    let mut excess = terms.map(|[first, second]| first + second);
    excess[0] += ENERGY_ROUNDING * size;
    Bernstein::from_taylor(&excess, 2.0)
        .negated()
        .first_crossing()
        .is_none()
}
