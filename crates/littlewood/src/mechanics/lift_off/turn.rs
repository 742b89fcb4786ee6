//! The work of friction over a whole turn: whether it can accelerate the rotation of a hoop to a
//! lift-off.

use core::f64::consts::PI;
use std::sync::LazyLock;

use crate::model::{Friction, Heavy};

/// Bound on the relative rounding error of an energy.
pub(super) const ENERGY_ROUNDING: f64 = 1e-12;

/// Number of cells of half a turn. A power of 2: θ = π/2 is a boundary.
const CELLS_PER_HALF_TURN: usize = 256;

/// Least (J − a²/J)/J: cancellation then leaves thirteen digits.
const MIN_DENOMINATOR_RATIO: f64 = 1e-3;

/// Cosines at the boundaries of the cells, from the bottom up.
static COSINES: LazyLock<[f64; CELLS_PER_HALF_TURN + 1]> = LazyLock::new(|| {
    core::array::from_fn(|k| -libm::cos(PI * k as f64 / CELLS_PER_HALF_TURN as f64))
});

/// Upper bound of a quantity with rounded terms.
pub(super) fn at_most(quantity: f64) -> f64 {
    quantity + ENERGY_ROUNDING * (1.0 + quantity.abs())
}

/// The proof that a hoop never lifts off, by the work of friction over whole turns (docs/ends.md):
/// C, twice the energy without that of the horizontal velocity v of the mass centre against θ′,
/// grows by at most some Δ in a turn, and a lift-off requires C = L. With ω = |θ′| (1 + h cos θ)
/// and φ = F/N in the direction of the rotation, v* is such that friction with φ = μs where ω ≤ v*,
/// and φ = −μk elsewhere, does no work on C in a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WholeTurns {
    /// Upper bound L − Δ of C.
    pub(super) turning: f64,
    /// Upper bound L − Δ + m v*² of twice the energy.
    pub(super) energy: f64,
}

/// The cosines of the angles in a cell.
#[derive(Clone, Copy, Debug)]
struct CosineRange {
    low: f64,
    high: f64,
}

/// Bounds of C.
#[derive(Clone, Copy, Debug)]
struct EnergyRange {
    min: f64,
    max: f64,
}

/// Bounds in a cell, for sin θ of either sign.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Least ω.
    min_velocity: f64,
    /// Half the largest gain of C, with φ = μs.
    gain: f64,
    /// Half the least loss of C, with φ = −μk.
    loss: f64,
}

impl WholeTurns {
    /// The bounds for a hoop with P > 0 at every angle, with `needed` = L. `None` if L − Δ ≤ 2 ℓ̂.
    pub(super) fn new(body: &Heavy, friction: Friction, needed: f64) -> Option<Self> {
        let cells = || {
            COSINES.windows(2).map(|ends| CosineRange {
                low: ends[0],
                high: ends[1],
            })
        };
        let separatrix = 2.0 * body.offset;
        let room = 0.5 * (needed - separatrix);
        let between = |min: f64| EnergyRange { min, max: needed };
        let gain = cells().try_fold(0.0, |gain, cosines| {
            let gain = gain + Cell::new(body, friction, cosines, between(separatrix)).gain;
            (gain < room).then_some(gain)
        })?;
        let turning = needed - at_most(2.0 * gain);
        if turning <= at_most(separatrix) {
            return None;
        }
        let mut cells: Vec<Cell> = cells()
            .map(|cosines| Cell::new(body, friction, cosines, between(turning)))
            .collect();
        cells.sort_unstable_by(|a, b| a.min_velocity.total_cmp(&b.min_velocity));
        let mut work = -cells.iter().map(|cell| cell.loss).sum::<f64>() * (1.0 - ENERGY_ROUNDING);
        let fastest = cells.iter().find(|cell| {
            work += (cell.gain + cell.loss) * (1.0 + ENERGY_ROUNDING);
            work > 0.0
        });
        // Without friction C is constant.
        let velocity = fastest.map_or(f64::INFINITY, |cell| {
            cell.min_velocity * (1.0 - ENERGY_ROUNDING)
        });
        Some(Self {
            turning,
            energy: turning + body.mass * velocity * velocity,
        })
    }
}

impl Cell {
    /// The bounds in a range of cosines, for C in a range.
    fn new(
        body: &Heavy,
        Friction { mu_s, mu_k, .. }: Friction,
        CosineRange { low, high }: CosineRange,
        energy: EnergyRange,
    ) -> Self {
        let (mass, h, offset) = (body.mass, body.h, body.offset);
        let is_above = low + high > 0.0;
        let [inner, outer] = if is_above { [low, high] } else { [high, low] };
        let sine_square = |cos: f64| (1.0 - cos) * (1.0 + cos);
        let spin = |cos: f64| body.inertia + mass * h * h * sine_square(cos);
        let [light, heavy] = [spin(outer), spin(inner)];
        let [short, long] = [1.0 + h * low, 1.0 + h * high];
        let [slow, fast] = [
            (energy.min - 2.0 * offset * high) / heavy,
            (energy.max - 2.0 * offset * low) / light,
        ];
        // w = 1 − h cos θ u, non-negative before a lift-off.
        let [weak, strong] = if is_above {
            [1.0 - h * high * fast, 1.0 - h * low * slow]
        } else {
            [1.0 - h * high * slow, 1.0 - h * low * fast]
        };
        // The mean of 1/(J ± a) is 1/(J − a²/J).
        let coupling = mu_s * mass * h * long;
        let denominator = light - coupling * coupling * sine_square(inner) / light;
        let scale = 2.0 * PI / CELLS_PER_HALF_TURN as f64 * mass * body.inertia;
        Self {
            min_velocity: short * slow.max(0.0).sqrt(),
            gain: if denominator > MIN_DENOMINATOR_RATIO * light {
                scale * mu_s * strong * long / denominator
            } else {
                f64::INFINITY
            },
            loss: scale * mu_k * weak.max(0.0) * short / heavy,
        }
    }
}
