//! The first rest of the slip, η′ = v + θ′(1 + ℓ̂ cos θ) = 0 (docs/theory/massless.md).
//!
//! With L = 1 − ℓ̂ + b and the heights a, b of [`super::particle`], √(ab) η′ = v √(ab) ± z L. So η′
//! vanishes only where the two terms have opposite signs, at the zeros of P = v² a b − z² L², a
//! cubic polynomial in the height. It is expanded about both ends of the path, in the height from
//! that end, without cancelling terms: P0 = a0 b0 η0′ (η0′ − 2 θ0′ L0) at the start, and at a start
//! from rest the known root is divided out. There P/f → −2 L0 G as f → 0, with G = ℓ̂ sin θ η″ =
//! 1 + ℓ̂c − ℓ̂(ℓ̂ + c) θ′² (3.17). In rolling N = L0 G/D.

use crate::math::bernstein::{Bernstein, first_crossing, value_and_slope};
use crate::math::bracket::Bracket;
use crate::model::SlipDirection;

use super::particle::{Particle, ParticleState, signed_product};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GlideEntry {
    /// With η′ ≠ 0.
    Moving,
    /// With η′ = 0. `presses` is the sign of the normal force of rolling, if the preceding event
    /// determined it.
    FromRest { presses: Option<bool> },
    /// With η′ = η″ = 0, where N = 0 in rolling.
    Unloaded,
}

impl GlideEntry {
    /// The direction of a slip velocity, if it is not zero, and G = `pull`: zero where the
    /// preceding event determined another sign of N, which is that of G except for rounding.
    pub(super) fn begun(self, slip: f64, pull: f64) -> (Option<SlipDirection>, f64) {
        match self {
            Self::Moving => (SlipDirection::of_sign(slip), pull),
            Self::FromRest { presses } if presses.is_none_or(|presses| presses == (pull > 0.0)) => {
                (None, pull)
            }
            Self::FromRest { .. } | Self::Unloaded => (None, 0.0),
        }
    }
}

/// The slip of a glide: its direction, and its first zero, if any.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slip {
    pub(super) direction: SlipDirection,
    pub(super) rest: Option<ParticleState>,
}

/// The part of the particle's path on which the slip can vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// From the start down to the bottom.
    Down,
    /// From the turning point down to the bottom.
    DownFromTurn,
    /// From the start up to the turning point.
    UpToTurn,
    /// From the start up to the top.
    UpToTop,
}

/// c0 + c1 x + c2 x² + c3 x³. A root near 0 has the relative accuracy of c0.
type Cubic = [f64; 4];

/// A place on a path, in the variable of the polynomials: the height, or the time on a slope.
pub(super) enum Along {
    FromBegin(f64),
    ToEnd(f64),
}

/// Quantities at the start from which the polynomials are formed.
struct Terms {
    /// 1 − ℓ̂ and 1 + ℓ̂, L at the bottom and at the top.
    inside: f64,
    outside: f64,
    /// a + b = 2 ℓ̂.
    whole: f64,
    /// a0, b0 and L0.
    a: f64,
    b: f64,
    lever: f64,
    /// V0², and z² at the bottom and at the top.
    rise: f64,
    bottom: f64,
    top: f64,
    /// v².
    momentum: f64,
    /// η0′ (η0′ − 2 θ0′ L0).
    slip: f64,
    /// G.
    pull: f64,
}

impl Slip {
    /// The slip of a glide that starts with the slip velocity `slip`.
    pub(super) fn of(particle: &Particle, slip: f64, entry: GlideEntry) -> Self {
        let mut terms = Terms::new(particle, slip);
        let begun;
        (begun, terms.pull) = entry.begun(slip, terms.pull);
        if begun.is_none() {
            terms.slip = 0.0;
        }
        let direction = begun.unwrap_or_else(|| {
            // With slip towards the side of the particle, P < 0 on the way down and P > 0 on the
            // way up.
            let down = if particle.rise > 0.0 { -1.0 } else { 1.0 };
            let towards = -particle.side * down * initial_sign(&terms.about_start(down));
            if towards < 0.0 {
                SlipDirection::Negative
            } else {
                SlipDirection::Positive
            }
        });
        Self {
            direction,
            rest: Path::of(particle).and_then(|path| terms.rest(particle, path)),
        }
    }
}

impl Path {
    /// None if the sign of v excludes a zero of the slip.
    fn of(particle: &Particle) -> Option<Self> {
        let drift = particle.momentum * particle.side;
        let rises = particle.rise > 0.0;
        match (rises, particle.reaches_top()) {
            (true, true) => (drift > 0.0).then_some(Self::UpToTop),
            (true, false) if drift > 0.0 => Some(Self::UpToTurn),
            // With v = 0 the slip vanishes at the turning point.
            (true, false) => Some(Self::DownFromTurn),
            (false, _) => (drift < 0.0).then_some(Self::Down),
        }
    }
}

impl Terms {
    fn new(particle: &Particle, slip: f64) -> Self {
        let l = particle.offset;
        let inside = particle.inside;
        let (a, b) = (particle.below_top, particle.above_bottom);
        let lever = inside + b;
        let (rate, spin) = particle.spin();
        Self {
            inside,
            outside: 1.0 + l,
            whole: 2.0 * l,
            a,
            b,
            lever,
            rise: signed_product([particle.rise; 2]),
            bottom: particle.square_at_bottom(),
            top: particle.square_at_top(),
            momentum: signed_product([particle.momentum; 2]),
            slip: signed_product([slip, slip - 2.0 * rate * lever]),
            // A glide from the top has ℓ̂ θ′² = 1, hence G = 0.
            pull: if a == 0.0 {
                0.0
            } else {
                b * ((1.0 - rate) * (1.0 + rate)) + inside * (1.0 + l * spin)
            },
        }
    }

    /// P about the start, in f × `down`; `down` is −1 on the way up.
    fn about_start(&self, down: f64) -> Cubic {
        let Self {
            a,
            b,
            lever,
            slip,
            pull,
            ..
        } = *self;
        let slope = (b - a) * slip - 2.0 * lever * pull;
        [
            signed_product([a, b, slip]),
            slope * down,
            4.0 * lever - self.rise - self.momentum,
            -2.0 * down,
        ]
    }

    /// Heights of the turning point below the top and above the bottom.
    fn turn(&self) -> (f64, f64) {
        (-0.5 * self.top, 0.5 * self.bottom)
    }

    /// P about the turning point, in the height below it.
    fn about_turn(&self) -> Cubic {
        let (a, b) = self.turn();
        let (momentum, lever) = (self.momentum, self.inside + b);
        [
            signed_product([momentum, a, b]),
            momentum * (b - a) - 2.0 * lever * lever,
            4.0 * lever - momentum,
            -2.0,
        ]
    }

    /// P about the bottom, in b.
    fn about_bottom(&self) -> Cubic {
        let Self {
            inside,
            whole,
            bottom,
            momentum,
            ..
        } = *self;
        let slope = whole * momentum - 2.0 * inside * (bottom - inside);
        [
            -bottom * inside * inside,
            slope,
            4.0 * inside - momentum - bottom,
            2.0,
        ]
    }

    /// P about the top, in a.
    fn about_top(&self) -> Cubic {
        let Self {
            outside,
            whole,
            top,
            momentum,
            ..
        } = *self;
        let slope = whole * momentum - 2.0 * outside * (outside - top);
        [
            -top * outside * outside,
            slope,
            4.0 * outside - momentum - top,
            -2.0,
        ]
    }

    /// P about the two ends of a path, in the height from each end, and the total height.
    fn ends(&self, path: Path) -> (Cubic, Cubic, f64) {
        match path {
            Path::Down => (self.about_start(1.0), self.about_bottom(), self.b),
            Path::DownFromTurn => (self.about_turn(), self.about_bottom(), self.turn().1),
            Path::UpToTurn => (self.about_start(-1.0), self.about_turn(), 0.5 * self.rise),
            Path::UpToTop => (self.about_start(-1.0), self.about_top(), self.a),
        }
    }

    /// The first zero of the slip on a path.
    fn rest(&self, particle: &Particle, path: Path) -> Option<ParticleState> {
        let at_turn = path == Path::DownFromTurn && particle.momentum == 0.0;
        let ends = self.ends(path);
        let found = if at_turn {
            Along::FromBegin(0.0)
        } else {
            first_rest(ends, initial_sign(&ends.0))?
        };
        let (turn_a, turn_b) = self.turn();
        let (from_turn, down) = match path {
            Path::Down => (false, 1.0),
            Path::DownFromTurn => (true, 1.0),
            Path::UpToTurn | Path::UpToTop => (false, -1.0),
        };
        // a, b, z², and the height from the beginning of the path.
        let (below_top, above_bottom, square, passed) = match (found, path) {
            (Along::FromBegin(y), _) if from_turn => (turn_a + y, turn_b - y, 2.0 * y, y),
            (Along::FromBegin(y), _) => (
                self.a + down * y,
                self.b - down * y,
                self.rise + 2.0 * down * y,
                y,
            ),
            (Along::ToEnd(y), Path::UpToTurn) => (turn_a + y, turn_b - y, 2.0 * y, ends.2 - y),
            (Along::ToEnd(y), Path::UpToTop) => (y, self.whole - y, self.top + 2.0 * y, ends.2 - y),
            (Along::ToEnd(y), Path::Down | Path::DownFromTurn) => {
                (self.whole - y, y, self.bottom - 2.0 * y, ends.2 - y)
            }
        };
        let fall_rate = down * square.max(0.0).sqrt();
        let elapsed = if from_turn {
            particle.rise + fall_rate
        } else if passed == 0.0 {
            0.0
        } else {
            2.0 * down * passed / (fall_rate - particle.rise)
        };
        Some(ParticleState {
            elapsed,
            below_top,
            above_bottom,
            fall_rate,
        })
    }
}

/// Sign just above 0.
fn initial_sign(cubic: &Cubic) -> f64 {
    cubic
        .iter()
        .find(|c| **c != 0.0)
        .map_or(0.0, |c| c.signum())
}

/// The first change from this sign on a path: by the polynomial about its beginning on the first
/// half, about its end on the second.
pub(super) fn first_rest<const N: usize>(
    (begin, end, length): ([f64; N], [f64; N], f64),
    sign: f64,
) -> Option<Along> {
    let middle = 0.5 * length;
    let [begin, end] = [begin, end].map(|polynomial| polynomial.map(|c| sign * c));
    // Divides out a root at the start: slip from rest, or a particle at the top.
    let roots = begin.iter().take_while(|c| **c == 0.0).count().min(N - 1);
    let first = first_crossing(&begin[roots..], middle).map(Along::FromBegin);
    first.or_else(|| {
        let Bracket { low, high } = Bernstein::from_taylor(&end, middle)
            .reversed()
            .first_crossing()?;
        let bracket = Bracket {
            low: middle * (1.0 - high),
            high: middle * (1.0 - low),
        };
        let back = |x| {
            let (value, slope) = value_and_slope(&end, x);
            (-value, -slope)
        };
        Some(Along::ToEnd(bracket.refine(back)))
    })
}
