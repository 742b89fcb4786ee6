//! The first rest of the slip, η′ = v + θ′(1 + ℓ̂ cos θ) = 0.
//!
//! With L = 1 − ℓ̂ + b and the heights of [`super::particle`], a b η′ is v √(ab) ± z L, so that η′ vanishes only while z has the
//! sign that v does not have on the side of the particle, and there it has the sign, or the opposite sign, of
//!
//! ```text
//! P = v² a b − z² L²,
//! ```
//!
//! a polynomial of degree three in the height; on the rim, where L = b, its factor v² a − z² b is of degree two. Its coefficients
//! are written down at both ends of the way, about each in the height from there, without the terms that cancel:
//! P0 = a0 b0 η0′ (η0′ − 2 θ0′ L0) at the start, with the root at a start from rest divided out. So the rests that lie next to the start
//! (Type II), to the turning point, to the bottom (ℓ̂ near 1) and to the top are as exact as those between.
//!
//! At a start from rest P/f has, at f = 0, the value −2 L0 G with G = ℓ̂ sin θ η″ = 1 + ℓ̂c − ℓ̂(ℓ̂ + c) θ′² (3.17), and N = L0 G/D where the hoop
//! rolls.

use crate::model::mode::Direction;

use super::cubic::Cubic;
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

/// P about the two ends of a way: in the height that has been passed, and in the height that is left, each up to a positive factor.
struct Ends {
    begin: Cubic,
    end: Cubic,
    height: f64,
}

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
    /// θ′² at the start.
    spin: f64,
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
        let is_from_rest = begun.is_none();
        let direction = begun.unwrap_or_else(|| {
            // P/f < 0 where the slip is towards the side of the particle, on the way up and on the way down.
            let down = if particle.rise > 0.0 { -1.0 } else { 1.0 };
            let towards = -particle.side * terms.about_start_from_rest(down).initial_sign();
            if towards < 0.0 { Direction::Negative } else { Direction::Positive }
        });
        Self { direction, rest: Way::of(particle).and_then(|way| terms.rest(particle, way, is_from_rest)) }
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
            a,
            b,
            lever,
            rise: particle.rise * particle.rise,
            bottom: particle.square_at_bottom(),
            top: particle.square_at_top(),
            momentum: particle.momentum * particle.momentum,
            spin,
            slip: slip * (slip - 2.0 * rate * lever),
            // At the top a glide begins only with ℓ̂ θ′² = 1, where G = 0.
            pull: if a == 0.0 { 0.0 } else { b * ((1.0 - rate) * (1.0 + rate)) + inside * (1.0 + l * spin) },
        }
    }

    fn is_on_rim(&self) -> bool {
        self.inside == 0.0
    }

    /// D(θ0) of rolling.
    fn denominator(&self) -> f64 {
        self.inside * self.inside + 2.0 * self.b
    }

    /// P/f about a start from rest, in f times `down`, which is −1 on the way up.
    fn about_start_from_rest(&self, down: f64) -> Cubic {
        if self.is_on_rim() {
            Cubic([-2.0 * self.pull, 2.0 * down, 0.0, 0.0])
        } else {
            let slope = 4.0 * self.lever - self.spin * self.denominator();
            Cubic([-2.0 * self.lever * self.pull, slope * down, -2.0, 0.0])
        }
    }

    /// P about a start with η′ ≠ 0, in f times `down`.
    fn about_start(&self, down: f64) -> Cubic {
        let Self { a, b, lever, slip, pull, .. } = *self;
        if self.is_on_rim() {
            Cubic([a * slip, (slip - 2.0 * pull) * down, 2.0, 0.0])
        } else {
            let slope = (b - a) * slip - 2.0 * lever * pull;
            Cubic([a * b * slip, slope * down, 4.0 * lever - self.rise - self.momentum, -2.0 * down])
        }
    }

    /// Heights of the turning point below the top and above the bottom.
    fn turn(&self) -> (f64, f64) {
        (-0.5 * self.top, 0.5 * self.bottom)
    }

    /// P about the turning point, in the height below it.
    fn about_turn(&self) -> Cubic {
        let (a, b) = self.turn();
        let momentum = self.momentum;
        if self.is_on_rim() {
            Cubic([momentum * a, momentum - 2.0 * b, 2.0, 0.0])
        } else {
            let lever = self.inside + b;
            Cubic([momentum * a * b, momentum * (b - a) - 2.0 * lever * lever, 4.0 * lever - momentum, -2.0])
        }
    }

    /// The same of P/f after a start from rest.
    fn about_turn_from_rest(&self) -> Cubic {
        let (up, down) = (2.0 - self.b * self.spin, 2.0 + self.a * self.spin);
        if self.is_on_rim() {
            Cubic([-self.b * up, 2.0, 0.0, 0.0])
        } else {
            let slope = 4.0 * self.lever - self.spin * self.denominator() + 2.0 * self.rise;
            Cubic([-0.5 * self.lever * self.lever * (up * down), slope, -2.0, 0.0])
        }
    }

    /// P about the bottom, in b.
    fn about_bottom(&self) -> Cubic {
        let Self { inside, outside, bottom, momentum, .. } = *self;
        if self.is_on_rim() {
            return Cubic([2.0 * momentum, -(bottom + momentum), 2.0, 0.0]);
        }
        let slope = (outside - inside) * momentum - 2.0 * inside * (bottom - inside);
        Cubic([-bottom * inside * inside, slope, 4.0 * inside - momentum - bottom, 2.0])
    }

    /// The same of P/f after a start from rest.
    fn about_bottom_from_rest(&self) -> Cubic {
        let Self { inside, a, b, spin, .. } = *self;
        if self.is_on_rim() {
            return Cubic([2.0 * b * spin, -2.0, 0.0, 0.0]);
        }
        let slope = spin * self.denominator() - 4.0 * inside;
        Cubic([-inside * inside * (2.0 + spin * a), slope, -2.0, 0.0])
    }

    /// P about the top, in a.
    fn about_top(&self) -> Cubic {
        let Self { inside, outside, top, momentum, .. } = *self;
        if self.is_on_rim() {
            return Cubic([-2.0 * top, momentum + top - 4.0, 2.0, 0.0]);
        }
        let slope = (outside - inside) * momentum - 2.0 * outside * (outside - top);
        Cubic([-top * outside * outside, slope, 4.0 * outside - momentum - top, -2.0])
    }

    /// The same of P/f after a start from rest.
    fn about_top_from_rest(&self) -> Cubic {
        let Self { outside, b, spin, .. } = *self;
        if self.is_on_rim() {
            return Cubic([2.0 * (b * spin - 2.0), 2.0, 0.0, 0.0]);
        }
        let slope = 4.0 * outside - spin * self.denominator();
        Cubic([outside * outside * (b * spin - 2.0), slope, -2.0, 0.0])
    }

    fn ends(&self, way: Way, is_from_rest: bool) -> Ends {
        let start =
            |down| if is_from_rest { self.about_start_from_rest(down) } else { self.about_start(down) };
        let (begin, end, height) = match (way, is_from_rest) {
            (Way::Down, false) => (start(1.0), self.about_bottom(), self.b),
            (Way::Down, true) => (start(1.0), self.about_bottom_from_rest(), self.b),
            // The way begins with a rise, on which a start from rest does not have the sign of v that this one has.
            (Way::DownFromTurn, _) => (self.about_turn(), self.about_bottom(), self.turn().1),
            (Way::UpToTurn, false) => (start(-1.0), self.about_turn(), 0.5 * self.rise),
            (Way::UpToTurn, true) => (start(-1.0), self.about_turn_from_rest(), 0.5 * self.rise),
            (Way::UpToTop, false) => (start(-1.0), self.about_top(), self.a),
            (Way::UpToTop, true) => (start(-1.0), self.about_top_from_rest(), self.a),
        };
        Ends { begin, end, height }
    }

    /// The first rest on a way.
    fn rest(&self, particle: &Particle, way: Way, is_from_rest: bool) -> Option<Place> {
        let at_turn = way == Way::DownFromTurn && particle.momentum == 0.0;
        let found =
            if at_turn { Height::FromBegin(0.0) } else { self.ends(way, is_from_rest).first_rest()? };
        Some(self.place(particle, way, found))
    }

    /// Where the particle is at a height of the way.
    fn place(&self, particle: &Particle, way: Way, height: Height) -> Place {
        let Self { a, b, rise, bottom, top, .. } = *self;
        let whole = self.outside - self.inside;
        let (turn_a, turn_b) = self.turn();
        // a, b, z², and f on ways from the start.
        let (below_top, above_bottom, square, fall) = match (way, height) {
            (Way::Down, Height::FromBegin(f)) => (a + f, b - f, rise + 2.0 * f, f),
            (Way::Down, Height::ToEnd(left)) => (whole - left, left, bottom - 2.0 * left, b - left),
            (Way::DownFromTurn, Height::FromBegin(y)) => (turn_a + y, turn_b - y, 2.0 * y, y),
            (Way::DownFromTurn, Height::ToEnd(left)) => {
                (whole - left, left, bottom - 2.0 * left, turn_b - left)
            }
            (Way::UpToTurn | Way::UpToTop, Height::FromBegin(f)) => (a - f, b + f, rise - 2.0 * f, -f),
            (Way::UpToTurn, Height::ToEnd(y)) => (turn_a + y, turn_b - y, 2.0 * y, y - 0.5 * rise),
            (Way::UpToTop, Height::ToEnd(left)) => (left, whole - left, top + 2.0 * left, left - a),
        };
        let speed = square.max(0.0).sqrt();
        let fall_rate = match way {
            Way::Down | Way::DownFromTurn => speed,
            Way::UpToTurn | Way::UpToTop => -speed,
        };
        let elapsed = match way {
            Way::DownFromTurn => particle.rise + fall_rate,
            Way::Down | Way::UpToTurn | Way::UpToTop => 2.0 * fall / (fall_rate - particle.rise),
        };
        Place { elapsed, below_top, above_bottom, fall_rate }
    }
}

impl Ends {
    /// The first change of sign on the way: on its first half by the polynomial about its begin, on the other by that about its end.
    fn first_rest(&self) -> Option<Height> {
        let middle = 0.5 * self.height;
        // A root at the start itself, where the slip is at rest, or a particle at the top.
        let begin = if self.begin.0[0] == 0.0 { self.begin.without_root_at_zero() } else { self.begin };
        let sign = begin.initial_sign();
        let first = begin.first_change(0.0, middle, sign).map(Height::FromBegin);
        first.or_else(|| self.end.first_change(middle, 0.0, sign).map(Height::ToEnd))
    }
}
