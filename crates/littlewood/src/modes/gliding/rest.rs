//! The first rest of the slip, η′ = v + θ′(1 + ℓ̂ cos θ) = 0.
//!
//! With L = 1 − ℓ̂ + b and the heights of [`super::particle`], a b η′ is v √(ab) ± z L, so that η′ vanishes only while z has the
//! sign that v does not have on the side of the particle, and there it has the sign, or the opposite sign, of
//!
//! ```text
//! P = v² a b − z² L²,
//! ```
//!
//! a polynomial of degree three in the height. Its coefficients are written down at both ends of the way, about each in the height
//! from there, without the terms that cancel: P0 = a0 b0 η0′ (η0′ − 2 θ0′ L0) at the start, with the root at a start from rest divided
//! out. So the rests that lie next to the start (Type II), to the turning point, to the bottom (ℓ̂ near 1) and to the top are as exact
//! as those between.
//!
//! At a start from rest P/f has, at f = 0, the value −2 L0 G with G = ℓ̂ sin θ η″ = 1 + ℓ̂c − ℓ̂(ℓ̂ + c) θ′² (3.17), and N = L0 G/D where the hoop
//! rolls.

use crate::math::bernstein::{Bernstein, first_crossing, value_and_slope};
use crate::math::bracket::Bracket;
use crate::model::Direction;

use super::particle::{Particle, Place};

/// How a glide begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GlideEntry {
    /// With η′ ≠ 0.
    Moving,
    /// With η′ = 0. The event that led there may know whether the normal force of rolling is positive.
    FromRest { presses: Option<bool> },
    /// With η′ = η″ = 0, on N = 0 of rolling.
    Unloaded,
}

/// How a glide slips: the direction of slip, and where it comes to rest for the first time, if it does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slip {
    pub(super) direction: Direction,
    pub(super) rest: Option<Place>,
}

/// The part of the way of the particle on which the slip can come to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// Down, from the start to the bottom.
    Down,
    /// Down, from the turning point to the bottom.
    DownFromTurn,
    /// Up, from the start to the turning point.
    UpToTurn,
    /// Up, from the start to the top.
    UpToTop,
}

/// c0 + c1 x + c2 x² + c3 x³. Where c0 is small against the other terms, a root near 0 is as exact as c0.
type Cubic = [f64; 4];

/// Height from one of the ends of a way.
enum Height {
    FromBegin(f64),
    ToEnd(f64),
}

/// What the polynomials are made of.
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
    /// Follows the slip of a particle.
    pub(super) fn of(particle: &Particle, slip: f64, entry: GlideEntry) -> Self {
        let mut terms = Terms::new(particle, slip);
        let begun = match entry {
            GlideEntry::Moving => Direction::of_sign(slip),
            GlideEntry::FromRest { presses } => {
                // The sign of N has been decided before. G has it, but for rounding.
                if presses.is_some_and(|presses| presses != (terms.pull > 0.0)) {
                    terms.pull = 0.0;
                }
                None
            }
            GlideEntry::Unloaded => {
                terms.pull = 0.0;
                None
            }
        };
        if begun.is_none() {
            terms.slip = 0.0;
        }
        let direction = begun.unwrap_or_else(|| {
            // Where the slip is towards the side of the particle, P < 0 on the way down and P > 0 on the way up.
            let down = if particle.rise > 0.0 { -1.0 } else { 1.0 };
            let towards = -particle.side * down * initial_sign(&terms.about_start(down));
            if towards < 0.0 { Direction::Negative } else { Direction::Positive }
        });
        Self { direction, rest: Way::of(particle).and_then(|way| terms.rest(particle, way)) }
    }
}

impl Way {
    /// None where v does not allow any rest.
    fn of(particle: &Particle) -> Option<Self> {
        let drift = particle.momentum * particle.side;
        let rises = particle.rise > 0.0;
        match (rises, particle.reaches_top()) {
            (true, true) => (drift > 0.0).then_some(Self::UpToTop),
            (true, false) if drift > 0.0 => Some(Self::UpToTurn),
            // With v = 0 the slip comes to rest at the turning point itself.
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
            rise: particle.rise * particle.rise,
            bottom: particle.square_at_bottom(),
            top: particle.square_at_top(),
            momentum: particle.momentum * particle.momentum,
            slip: slip * (slip - 2.0 * rate * lever),
            // At the top a glide begins only with ℓ̂ θ′² = 1, where G = 0.
            pull: if a == 0.0 { 0.0 } else { b * ((1.0 - rate) * (1.0 + rate)) + inside * (1.0 + l * spin) },
        }
    }

    /// P about the start, in f times `down`, which is −1 on the way up.
    fn about_start(&self, down: f64) -> Cubic {
        let Self { a, b, lever, slip, pull, .. } = *self;
        let slope = (b - a) * slip - 2.0 * lever * pull;
        [a * b * slip, slope * down, 4.0 * lever - self.rise - self.momentum, -2.0 * down]
    }

    /// Heights of the turning point below the top and above the bottom.
    fn turn(&self) -> (f64, f64) {
        (-0.5 * self.top, 0.5 * self.bottom)
    }

    /// P about the turning point, in the height below it.
    fn about_turn(&self) -> Cubic {
        let (a, b) = self.turn();
        let (momentum, lever) = (self.momentum, self.inside + b);
        [momentum * a * b, momentum * (b - a) - 2.0 * lever * lever, 4.0 * lever - momentum, -2.0]
    }

    /// P about the bottom, in b.
    fn about_bottom(&self) -> Cubic {
        let Self { inside, whole, bottom, momentum, .. } = *self;
        let slope = whole * momentum - 2.0 * inside * (bottom - inside);
        [-bottom * inside * inside, slope, 4.0 * inside - momentum - bottom, 2.0]
    }

    /// P about the top, in a.
    fn about_top(&self) -> Cubic {
        let Self { outside, whole, top, momentum, .. } = *self;
        let slope = whole * momentum - 2.0 * outside * (outside - top);
        [-top * outside * outside, slope, 4.0 * outside - momentum - top, -2.0]
    }

    /// P about the two ends of a way, in the height that has been passed and in the height that is left, and the whole height.
    fn ends(&self, way: Way) -> (Cubic, Cubic, f64) {
        match way {
            Way::Down => (self.about_start(1.0), self.about_bottom(), self.b),
            Way::DownFromTurn => (self.about_turn(), self.about_bottom(), self.turn().1),
            Way::UpToTurn => (self.about_start(-1.0), self.about_turn(), 0.5 * self.rise),
            Way::UpToTop => (self.about_start(-1.0), self.about_top(), self.a),
        }
    }

    /// The first rest on a way.
    fn rest(&self, particle: &Particle, way: Way) -> Option<Place> {
        let at_turn = way == Way::DownFromTurn && particle.momentum == 0.0;
        let ends = self.ends(way);
        let found = if at_turn { Height::FromBegin(0.0) } else { first_rest(ends)? };
        let (turn_a, turn_b) = self.turn();
        let (from_turn, down) = match way {
            Way::Down => (false, 1.0),
            Way::DownFromTurn => (true, 1.0),
            Way::UpToTurn | Way::UpToTop => (false, -1.0),
        };
        // a, b, z², and the height that has been passed.
        let (below_top, above_bottom, square, passed) = match (found, way) {
            (Height::FromBegin(y), _) if from_turn => (turn_a + y, turn_b - y, 2.0 * y, y),
            (Height::FromBegin(y), _) => {
                (self.a + down * y, self.b - down * y, self.rise + 2.0 * down * y, y)
            }
            (Height::ToEnd(y), Way::UpToTurn) => (turn_a + y, turn_b - y, 2.0 * y, ends.2 - y),
            (Height::ToEnd(y), Way::UpToTop) => (y, self.whole - y, self.top + 2.0 * y, ends.2 - y),
            (Height::ToEnd(y), Way::Down | Way::DownFromTurn) => {
                (self.whole - y, y, self.bottom - 2.0 * y, ends.2 - y)
            }
        };
        let fall_rate = down * square.max(0.0).sqrt();
        let elapsed = if from_turn {
            particle.rise + fall_rate
        } else {
            2.0 * down * passed / (fall_rate - particle.rise)
        };
        Some(Place { elapsed, below_top, above_bottom, fall_rate })
    }
}

/// Sign just right of 0.
fn initial_sign(cubic: &Cubic) -> f64 {
    cubic.iter().find(|c| **c != 0.0).map_or(0.0, |c| c.signum())
}

/// The first change of sign on a way: on its first half by the polynomial about its begin, on the other by that about its end.
fn first_rest((begin, end, height): (Cubic, Cubic, f64)) -> Option<Height> {
    let middle = 0.5 * height;
    let sign = initial_sign(&begin);
    let [begin, end] = [begin, end].map(|cubic| cubic.map(|c| sign * c));
    // Without a root at the start itself, where the slip is at rest, or a particle at the top.
    let roots = begin.iter().take_while(|c| **c == 0.0).count();
    let first = first_crossing(&begin[roots..], middle).map(Height::FromBegin);
    first.or_else(|| {
        let Bracket { low, high } = Bernstein::from_taylor(&end, middle).reversed().first_crossing()?;
        let bracket = Bracket { low: middle * (1.0 - high), high: middle * (1.0 - low) };
        let back = |x| {
            let (value, slope) = value_and_slope(&end, x);
            (-value, -slope)
        };
        Some(Height::ToEnd(bracket.refine(back)))
    })
}
