//! A slide over whole turns: a linear map, and the time of a turn as a function of the energy at its beginning.
//!
//! Seen in the direction of travel, θ′ > 0, with f = μk σ there, twice the energy about the mean drift,
//! e = (Î + m h² s²) u + 2 m h c, obeys
//!
//! ```text
//! de/dθ = −2 f (1 + h c) N,       N = Î m w/P,       w = 1 − h c u.
//! ```
//!
//! The right side has one sign while N > 0: at each angle u = θ′² falls from turn to turn where f > 0, and rises where f < 0. It is
//! linear in e, with periodic coefficients that are of the order of f, so that nothing cancels however small f is:
//! e = e₀(θ) + ε A(θ), where e₀ is the slide with u = 0 at the section θs at which turns are counted. Over a turn
//! ε becomes α ε + β, with log α = κ = f ∮ 2 m Î (1 + h c) h c/(P G) dθ, G = Î + m h² s², and u = (e − 2 m h c)/G.
//!
//! The section is where u is least in each turn: the unstable equilibrium of the slide, q = 0, or where |q| is least
//! if q has no zero.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::mechanics::SlidingLaw;
use crate::model::Heavy;

use super::panel::{NODES, Rule, largest};

/// Most panels of a turn: those of very light hoops would be more.
const MOST_PANELS: usize = 160;

/// Panels at the beginning, before any is halved.
const PANELS: usize = 6;

/// The linear map is known to rounding where a tail of its coefficients is below this part of their largest value so far.
const CONVERGED: f64 = 1e-14;

/// The time is, where a tail of 1/√u is below this part of its largest value: the rule is exact to twice the degree.
const HALF_CONVERGED: f64 = 1e-8;

/// The section at which turns of a law are counted, in the direction of travel, within (−π, π].
pub(super) fn section(law: &SlidingLaw) -> f64 {
    // q = h √(1 + f²) sin(θ − atan f) − f.
    let f = law.friction;
    let reach = law.body.h * (1.0 + f * f).sqrt();
    let angle = if f.abs() < reach { libm::asin(f / reach) } else { FRAC_PI_2.copysign(f) };
    let section = libm::atan(f) + angle;
    if section > PI { section - TAU } else { section }
}

/// The slides of a law through one turn from the section.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    /// Growth of ε in a turn, log α, and its fall β.
    kappa: f64,
    beta: f64,
    /// Î + m h² s² at the section: ε = G u there.
    section_inertia: f64,
    nodes: Vec<Node>,
    /// base and gain at the top.
    top: (f64, f64),
}

/// A node of the quadrature.
#[derive(Clone, Copy, Debug)]
struct Node {
    weight: f64,
    /// u = base + ε gain.
    base: f64,
    gain: f64,
    /// ± lever: what the slip gains for each unit of the rate.
    lever: f64,
}

impl Node {
    /// The rate of the slide with ε.
    fn rate(&self, energy: f64) -> f64 {
        (self.base + energy * self.gain).sqrt()
    }
}

/// Values at the nodes of a panel.
struct Sampled {
    sin_cos: [(f64, f64); NODES],
    lower: [f64; NODES],
    inertia: [f64; NODES],
    growth: [f64; NODES],
    work: [f64; NODES],
}

impl Turn {
    /// The turn of a law in the direction of travel; `energies` between which times are wanted. None where P vanishes in the turn,
    /// or too many panels would be needed.
    pub(super) fn new(law: &SlidingLaw, energies: Option<(f64, f64)>) -> Option<Self> {
        let rule = Rule::get();
        let Heavy { mass, h, inertia, .. } = law.body;
        let start = section(law);
        let sin_start = libm::sin(start);
        let sign = if law.friction < 0.0 { -1.0 } else { 1.0 };
        let mut turn = Self {
            kappa: 0.0,
            beta: 0.0,
            section_inertia: inertia + mass * h * h * (sin_start * sin_start),
            nodes: Vec::new(),
            top: (f64::NAN, f64::NAN),
        };
        // The top is the end of a panel.
        let to_top = if start > 0.0 { TAU - start } else { -start };
        let mut ends: Vec<f64> = (0..=PANELS).map(|k| k as f64 / PANELS as f64 * TAU).collect();
        if to_top > 0.0 {
            ends.push(to_top);
            ends.sort_by(f64::total_cmp);
        }
        let mut pending: Vec<(f64, f64)> =
            ends.windows(2).rev().map(|pair| (pair[0], pair[1])).filter(|(a, b)| a < b).collect();
        // log A/f and the work −(e₀ − e₀(θs))/(f A) up to here.
        let (mut growth, mut work) = (0.0, 0.0);
        // Near the bottom of a rim hoop both are small differences.
        let mut scale = (0.0_f64, 0.0_f64);
        let f = law.friction;
        let value = |lower: f64, inertia: f64, growth: f64, work: f64| {
            let gain = libm::exp(f * growth);
            ((2.0 * mass * h * lower - f * gain * work) / inertia, gain / inertia)
        };
        if to_top == 0.0 {
            turn.top = value(0.0, inertia, 0.0, 0.0);
        }
        let mut panels = 0;
        while let Some((left, right)) = pending.pop() {
            let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
            let sampled = Sampled::new(law, start, rule.nodes.map(|x| centre + half * x))?;
            scale = (scale.0.max(largest(&sampled.growth)), scale.1.max(largest(&sampled.work)));
            let mut fine = rule.tail(&sampled.growth) <= CONVERGED * scale.0
                && rule.tail(&sampled.work) <= CONVERGED * scale.1;
            let mut nodes = [(0.0, 0.0); NODES];
            let mut works = [0.0; NODES];
            if fine {
                let growths = rule.up_to(&sampled.growth).map(|sum| growth + half * sum);
                for i in 0..NODES {
                    works[i] = sampled.work[i] * libm::exp(-f * growths[i]);
                }
                fine = rule.tail(&works) <= CONVERGED * scale.1.max(largest(&works));
                let sums = rule.up_to(&works);
                for i in 0..NODES {
                    let (lower, inertia) = (sampled.lower[i], sampled.inertia[i]);
                    nodes[i] = value(lower, inertia, growths[i], work + half * sums[i]);
                }
                for energy in energies.into_iter().flat_map(|(low, high)| [low, high]) {
                    let slowness = nodes.map(|(base, gain)| 1.0 / (base + energy * gain).sqrt());
                    fine &= rule.tail(&slowness) < HALF_CONVERGED * largest(&slowness);
                }
            }
            if !fine {
                panels += 1;
                if panels > MOST_PANELS {
                    return None;
                }
                pending.push((centre, right));
                pending.push((left, centre));
                continue;
            }
            for (i, (base, gain)) in nodes.into_iter().enumerate() {
                let (sin, cos) = sampled.sin_cos[i];
                let (weight, lever) = (half * rule.weights[i], sign * law.lever(sin, cos));
                turn.nodes.push(Node { weight, base, gain, lever });
            }
            growth += half * rule.integral(&sampled.growth);
            work += half * rule.integral(&works);
            if right == to_top {
                turn.top = value(lower_by(start, to_top), inertia, growth, work);
            }
        }
        turn.kappa = f * growth;
        turn.beta = -f * libm::exp(turn.kappa) * work;
        turn.top.0.is_finite().then_some(turn)
    }

    /// ε where the section is passed at this rate.
    pub(super) fn energy(&self, rate: f64) -> f64 {
        self.section_inertia * (rate * rate)
    }

    /// The rate at the section.
    pub(super) fn rate(&self, energy: f64) -> f64 {
        (energy / self.section_inertia).sqrt()
    }

    /// β, the change of ε where ε = 0.
    pub(super) const fn beta(&self) -> f64 {
        self.beta
    }

    /// log α.
    pub(super) const fn kappa(&self) -> f64 {
        self.kappa
    }

    /// ε after `turns` from ε.
    pub(super) fn after(&self, energy: f64, turns: f64) -> f64 {
        let one = libm::expm1(self.kappa);
        if one == 0.0 {
            return energy + turns * self.beta;
        }
        let grown = libm::expm1(turns * self.kappa);
        energy + (grown * energy + self.beta * (grown / one))
    }

    /// Turns from ε to `then`: none if it has been passed, infinite if it is not reached.
    pub(super) fn turns(&self, energy: f64, then: f64) -> f64 {
        let one = libm::expm1(self.kappa);
        if one == 0.0 {
            return ahead((then - energy) / self.beta);
        }
        let ratio = (then - energy) / (energy + self.beta / one);
        ahead(libm::log1p(ratio) / self.kappa)
    }

    /// Time of the turn that begins with ε.
    pub(super) fn time(&self, energy: f64) -> f64 {
        self.nodes.iter().fold(0.0, |sum, node| sum + node.weight / node.rate(energy))
    }

    /// h u at the top of the turn that begins with ε: the slide stays on the plane where it is below 1.
    pub(super) fn load_at_top(&self, h: f64, energy: f64) -> f64 {
        h * (self.top.0 + energy * self.top.1)
    }

    /// ε with which h u = 1 at the top.
    pub(super) fn lift_off_energy(&self, h: f64) -> f64 {
        (1.0 / h - self.top.0) / self.top.1
    }

    /// Largest value at the nodes of the magnitude of the part of η′ that comes and goes with the turns.
    pub(super) fn largest_slip(&self, energy: f64) -> f64 {
        self.nodes.iter().fold(0.0, |largest, node| largest.max(node.lever.abs() * node.rate(energy)))
    }

    /// Least value at the nodes of the part of σ η′ that comes and goes with the turns, σ θ′ (1 + h c + f h s).
    pub(super) fn lowest_slip(&self, energy: f64) -> f64 {
        self.nodes.iter().fold(f64::INFINITY, |lowest, node| lowest.min(node.lever * node.rate(energy)))
    }
}

fn ahead(turns: f64) -> f64 {
    if turns.is_nan() { f64::INFINITY } else { turns.max(0.0) }
}

/// cos θs − cos(θs + angle), without cancellation.
fn lower_by(start: f64, angle: f64) -> f64 {
    2.0 * libm::sin(start + 0.5 * angle) * libm::sin(0.5 * angle)
}

impl Sampled {
    /// At these angles from the section; none where P ≤ 0 at one of them.
    fn new(law: &SlidingLaw, start: f64, angles: [f64; NODES]) -> Option<Self> {
        let Heavy { mass, h, inertia: own, .. } = law.body;
        let mut sampled = Self {
            sin_cos: [(0.0, 0.0); NODES],
            lower: [0.0; NODES],
            inertia: [0.0; NODES],
            growth: [0.0; NODES],
            work: [0.0; NODES],
        };
        for (i, angle) in angles.into_iter().enumerate() {
            let (sin, cos) = libm::sincos(start + angle);
            let p = law.p(sin, law.q(1.0, sin, cos));
            if p <= 0.0 {
                return None;
            }
            let inertia = own + mass * h * h * (sin * sin);
            let push = 2.0 * mass * own * (1.0 + h * cos) / p;
            let load = h * cos / inertia;
            let lower = lower_by(start, angle);
            sampled.sin_cos[i] = (sin, cos);
            sampled.lower[i] = lower;
            sampled.inertia[i] = inertia;
            sampled.growth[i] = push * load;
            sampled.work[i] = push * (1.0 - 2.0 * mass * h * load * lower);
        }
        Some(sampled)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::model::{Body, Direction, Hoop, HoopParameters};

    proptest! {
        #[test]
        fn the_section_is_the_unstable_equilibrium_or_where_the_slope_of_the_energy_is_least(
            mass_ratio in 0.0..3.0_f64, offset in 0.05..1.0_f64, inertia in 0.1..3.0_f64, mu in 0.0..5.0_f64,
            positive in any::<bool>(),
        ) {
            let hoop = HoopParameters::thin(mass_ratio).with_offset(offset).with_inertia(inertia).with_friction(mu, mu);
            let Body::Heavy(body) = Hoop::new(hoop).unwrap().body() else { unreachable!("it has inertia") };
            let direction = if positive { Direction::Positive } else { Direction::Negative };
            let law = SlidingLaw::of_body(body, mu, direction);
            let (sin, cos) = libm::sincos(section(&law));
            let q = law.q(1.0, sin, cos);
            let slope = body.h * (cos + law.friction * sin);
            let size = 1.0 + mu;
            if mu < body.h * (1.0 + mu * mu).sqrt() {
                prop_assert!(q.abs() < 1e-14 * size && slope > -1e-7 * size, "{q} {slope}");
            } else {
                prop_assert!(slope.abs() < 1e-14 * size && q * law.friction < 0.0, "{q} {slope}");
            }
        }
    }
}
