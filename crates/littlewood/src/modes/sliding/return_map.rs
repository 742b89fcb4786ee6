//! A slide over whole turns (docs/theory/many-turns.md): the linear map of the energy, and the time
//! of a turn.
//!
//! In the direction of motion, with f = μk σ and G = Î + m h² s², twice the energy relative to the
//! mean drift is e = G u + 2 m h c = e₀(θ) + ε A(θ), where e₀ is the slide with u = 0 at the
//! section θs at which turns are counted. A turn maps ε to α ε + β, with log α = κ = f ∮ 2 m Î (1 +
//! h c) h c/(P G) dθ.
//!
//! The section lies at the minimum of u in each turn: the unstable equilibrium of the slide, q = 0,
//! or the minimum of |q| if q has no zero.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::math::panel::{NODES, Rule, largest};
use crate::mechanics::SlidingLaw;
use crate::model::Heavy;

/// Largest number of panel halvings in a turn; only very light hoops would need more.
const MAX_HALVINGS: usize = 160;

const INITIAL_PANELS: usize = 6;

/// Largest tail of the coefficients of the linear map, relative to their largest value: the map is
/// then exact to rounding.
const MAP_TOLERANCE: f64 = 1e-14;

/// Largest relative tail of 1/√u. The square root of the rounding suffices, since the rule is exact
/// to twice the degree.
const TIME_TOLERANCE: f64 = 1e-8;

/// Angle of the section at which turns are counted, in the direction of motion, within (−π, π].
pub(super) fn section(law: &SlidingLaw) -> f64 {
    // q = h √(1 + f²) sin(θ − atan f) − f.
    let f = law.friction;
    let reach = law.body.h * (1.0 + f * f).sqrt();
    let angle = if f.abs() < reach {
        libm::asin(f / reach)
    } else {
        FRAC_PI_2.copysign(f)
    };
    let section = libm::atan(f) + angle;
    if section > PI { section - TAU } else { section }
}

/// The map of the energy ε over one turn from the section.
#[derive(Clone, Debug)]
pub(super) struct ReturnMap {
    /// log α and β.
    kappa: f64,
    beta: f64,
    /// Î + m h² s² at the section: ε = G u there.
    section_inertia: f64,
    nodes: Vec<Node>,
    /// `base` and `gain` at the top.
    top: (f64, f64),
}

#[derive(Clone, Copy, Debug)]
struct Node {
    weight: f64,
    /// u = base + ε gain.
    base: f64,
    gain: f64,
    /// ± L, the derivative of the slip velocity in the rate.
    slip_coefficient: f64,
}

impl Node {
    /// θ′ of the slide with ε.
    fn rate(&self, energy: f64) -> f64 {
        (self.base + energy * self.gain).sqrt()
    }
}

/// The coefficients of the linear map at an angle.
#[derive(Clone, Copy, Default)]
struct Sample {
    /// ± L.
    slip_coefficient: f64,
    /// cos θs − cos θ.
    lower: f64,
    /// G.
    inertia: f64,
    /// d log A/dθ over f.
    growth: f64,
    /// −(de/dθ)/f of e₀.
    work: f64,
}

impl ReturnMap {
    /// The map of turns that change nothing.
    pub(super) const fn identity(section_inertia: f64) -> Self {
        Self {
            kappa: 0.0,
            beta: 0.0,
            section_inertia,
            nodes: Vec::new(),
            top: (f64::NAN, f64::NAN),
        }
    }

    /// The turn of a law in the direction of motion, accurate for times between two `energies`.
    /// None if P vanishes in the turn, or if it needs too many panels.
    pub(super) fn new(law: &SlidingLaw, energies: Option<(f64, f64)>) -> Option<Self> {
        let rule = Rule::get();
        let Heavy {
            mass, h, inertia, ..
        } = law.body;
        let f = law.friction;
        let start = section(law);
        let sin_start = libm::sin(start);
        let mut turn = Self::identity(inertia + mass * h * h * (sin_start * sin_start));
        // A panel ends at the top. Panels are taken from the end of the list.
        let to_top = if start > 0.0 { TAU - start } else { -start };
        let mut ends: Vec<f64> = (0..=INITIAL_PANELS)
            .map(|k| k as f64 / INITIAL_PANELS as f64 * TAU)
            .chain([to_top])
            .collect();
        ends.sort_by(|a, b| b.total_cmp(a));
        let mut pending: Vec<(f64, f64)> = ends
            .windows(2)
            .map(|pair| (pair[1], pair[0]))
            .filter(|(a, b)| a < b)
            .collect();
        // log A/f and the work −(e₀ − e₀(θs))/(f A) so far.
        let (mut growth, mut work) = (0.0, 0.0);
        // The largest values so far: near the bottom of a rim hoop both are small differences.
        let mut scale = (0.0_f64, 0.0_f64);
        let value = |lower: f64, inertia: f64, growth: f64, work: f64| {
            let gain = libm::exp(f * growth);
            (
                (2.0 * mass * h * lower - f * gain * work) / inertia,
                gain / inertia,
            )
        };
        let mut halvings = 0;
        while let Some((left, right)) = pending.pop() {
            let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
            let mut samples = [Sample::default(); NODES];
            for (sample, x) in samples.iter_mut().zip(rule.nodes) {
                *sample = Sample::new(law, start, centre + half * x)?;
            }
            let growths = samples.map(|sample| sample.growth);
            let growth_to = rule.up_to(&growths).map(|sum| growth + half * sum);
            let works: [f64; NODES] =
                core::array::from_fn(|i| samples[i].work * libm::exp(-f * growth_to[i]));
            let work_to = rule.up_to(&works).map(|sum| work + half * sum);
            let values: [(f64, f64); NODES] = core::array::from_fn(|i| {
                value(
                    samples[i].lower,
                    samples[i].inertia,
                    growth_to[i],
                    work_to[i],
                )
            });
            let plain_works = samples.map(|sample| sample.work);
            scale = (
                scale.0.max(largest(&growths)),
                scale.1.max(largest(&plain_works)),
            );
            let is_resolved = |energy: f64| {
                let slowness = values.map(|(base, gain)| 1.0 / (base + energy * gain).sqrt());
                rule.tail(&slowness) < TIME_TOLERANCE * largest(&slowness)
            };
            let is_fine = rule.tail(&growths) <= MAP_TOLERANCE * scale.0
                && rule.tail(&plain_works) <= MAP_TOLERANCE * scale.1
                && rule.tail(&works) <= MAP_TOLERANCE * scale.1.max(largest(&works))
                && energies.is_none_or(|(low, high)| is_resolved(low) && is_resolved(high));
            if !is_fine {
                halvings += 1;
                if halvings > MAX_HALVINGS {
                    return None;
                }
                pending.extend([(centre, right), (left, centre)]);
                continue;
            }
            for (i, (base, gain)) in values.into_iter().enumerate() {
                turn.nodes.push(Node {
                    weight: half * rule.weights[i],
                    base,
                    gain,
                    slip_coefficient: samples[i].slip_coefficient,
                });
            }
            growth += half * rule.integral(&growths);
            work += half * rule.integral(&works);
            if right == to_top {
                turn.top = value(lower_by(start, to_top), inertia, growth, work);
            }
        }
        turn.kappa = f * growth;
        turn.beta = -f * libm::exp(turn.kappa) * work;
        turn.top.0.is_finite().then_some(turn)
    }

    /// ε of a slide that passes the section at this rate.
    pub(super) fn energy(&self, rate: f64) -> f64 {
        self.section_inertia * (rate * rate)
    }

    pub(super) fn rate(&self, energy: f64) -> f64 {
        (energy / self.section_inertia).sqrt()
    }

    /// β, the change of ε where ε = 0.
    pub(super) const fn beta(&self) -> f64 {
        self.beta
    }

    pub(super) const fn kappa(&self) -> f64 {
        self.kappa
    }

    /// ε after a number of turns.
    pub(super) fn after(&self, energy: f64, turns: f64) -> f64 {
        let one = libm::expm1(self.kappa);
        if one == 0.0 {
            return energy + turns * self.beta;
        }
        let grown = libm::expm1(turns * self.kappa);
        energy + (grown * energy + self.beta * (grown / one))
    }

    /// Number of turns from ε to `then`: zero if it was passed, infinite if it is not reached.
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
        self.nodes
            .iter()
            .fold(0.0, |sum, node| sum + node.weight / node.rate(energy))
    }

    /// h u at the top of the turn that begins with ε; the slide stays in contact if it is below 1.
    pub(super) fn load_at_top(&self, h: f64, energy: f64) -> f64 {
        h * (self.top.0 + energy * self.top.1)
    }

    /// ε with which h u = 1 at the top.
    pub(super) fn lift_off_energy(&self, h: f64) -> f64 {
        (1.0 / h - self.top.0) / self.top.1
    }

    /// Largest magnitude, over the nodes, of the oscillating part of η′.
    pub(super) fn max_slip(&self, energy: f64) -> f64 {
        self.nodes.iter().fold(0.0, |largest, node| {
            largest.max(node.slip_coefficient.abs() * node.rate(energy))
        })
    }

    /// Minimum, over the nodes, of the oscillating part of σ η′, σ θ′ (1 + h c + f h s).
    pub(super) fn min_slip(&self, energy: f64) -> f64 {
        self.nodes.iter().fold(f64::INFINITY, |lowest, node| {
            lowest.min(node.slip_coefficient * node.rate(energy))
        })
    }
}

fn ahead(turns: f64) -> f64 {
    if turns.is_nan() {
        f64::INFINITY
    } else {
        turns.max(0.0)
    }
}

/// cos θs − cos(θs + angle), without cancellation.
fn lower_by(start: f64, angle: f64) -> f64 {
    2.0 * libm::sin(start + 0.5 * angle) * libm::sin(0.5 * angle)
}

impl Sample {
    /// At an angle relative to the section; none if P ≤ 0 there.
    fn new(law: &SlidingLaw, start: f64, angle: f64) -> Option<Self> {
        let Heavy {
            mass,
            h,
            inertia: own,
            ..
        } = law.body;
        let (sin, cos) = libm::sincos(start + angle);
        let p = law.p(sin, law.q(1.0, sin, cos));
        let inertia = own + mass * h * h * (sin * sin);
        let push = 2.0 * mass * own * (1.0 + h * cos) / p;
        let load = h * cos / inertia;
        let lower = lower_by(start, angle);
        let slip_coefficient = if law.friction < 0.0 {
            -law.slip_coefficient(sin, cos)
        } else {
            law.slip_coefficient(sin, cos)
        };
        let work = push * (1.0 - 2.0 * mass * h * load * lower);
        (p > 0.0).then_some(Self {
            slip_coefficient,
            lower,
            inertia,
            growth: push * load,
            work,
        })
    }
}
