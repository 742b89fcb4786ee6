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
    /// At the top.
    top: LinearU,
}

/// u = `base` + ε `gain`.
#[derive(Clone, Copy, Debug)]
struct LinearU {
    base: f64,
    gain: f64,
}

impl LinearU {
    fn at(&self, energy: f64) -> f64 {
        self.base + energy * self.gain
    }
}

#[derive(Clone, Copy, Debug)]
struct Node {
    weight: f64,
    u: LinearU,
    /// ± L, the derivative of the slip velocity in the rate.
    slip_coefficient: f64,
}

impl Node {
    /// θ′ of the slide with ε.
    fn rate(&self, energy: f64) -> f64 {
        self.u.at(energy).sqrt()
    }
}

/// Values of ε.
#[derive(Clone, Copy, Debug)]
pub(super) struct EnergyRange {
    pub(super) low: f64,
    pub(super) high: f64,
}

/// A part of a turn, by angles from the section.
#[derive(Clone, Copy, Debug)]
struct Panel {
    left: f64,
    right: f64,
}

impl Panel {
    fn centre(&self) -> f64 {
        0.5 * (self.left + self.right)
    }

    fn half_width(&self) -> f64 {
        0.5 * (self.right - self.left)
    }

    /// The right half first: panels are taken from the end of a list.
    fn halves(&self) -> [Self; 2] {
        let centre = self.centre();
        [
            Self {
                left: centre,
                ..*self
            },
            Self {
                right: centre,
                ..*self
            },
        ]
    }
}

/// The panels of a turn from the last to the first; one ends at the top, where the load is largest.
fn initial_panels(to_top: f64) -> Vec<Panel> {
    let mut ends: Vec<f64> = (0..=INITIAL_PANELS)
        .map(|k| k as f64 / INITIAL_PANELS as f64 * TAU)
        .chain([to_top])
        .collect();
    ends.sort_by(|a, b| b.total_cmp(a));
    ends.windows(2)
        .map(|pair| Panel {
            left: pair[1],
            right: pair[0],
        })
        .filter(|panel| panel.left < panel.right)
        .collect()
}

/// The integrals from the section up to a panel.
#[derive(Clone, Copy, Debug)]
struct Sums<'a> {
    law: &'a SlidingLaw,
    /// Angle of the section.
    start: f64,
    /// log A/f and the work −(e₀ − e₀(θs))/(f A).
    growth: f64,
    work: f64,
    /// The largest integrands so far: near the bottom of a rim hoop both are small differences.
    max_growth: f64,
    max_work: f64,
}

/// The integrands at the nodes of a panel.
struct Integrands {
    samples: [Sample; NODES],
    growths: [f64; NODES],
    /// The work without and with the factor 1/A.
    plain_works: [f64; NODES],
    works: [f64; NODES],
    u: [LinearU; NODES],
}

impl Integrands {
    fn nodes(&self, panel: Panel) -> impl Iterator<Item = Node> {
        let weights = Rule::get().weights;
        (0..NODES).map(move |i| Node {
            weight: panel.half_width() * weights[i],
            u: self.u[i],
            slip_coefficient: self.samples[i].slip_coefficient,
        })
    }
}

impl<'a> Sums<'a> {
    fn new(law: &'a SlidingLaw) -> Self {
        Self {
            law,
            start: section(law),
            growth: 0.0,
            work: 0.0,
            max_growth: 0.0,
            max_work: 0.0,
        }
    }

    fn angle_to_top(&self) -> f64 {
        if self.start > 0.0 {
            TAU - self.start
        } else {
            -self.start
        }
    }

    /// G at the section.
    fn inertia_at_section(&self) -> f64 {
        let Heavy {
            mass, h, inertia, ..
        } = self.law.body;
        let sin = libm::sin(self.start);
        inertia + mass * h * h * (sin * sin)
    }

    /// u after these sums, at an angle with this cos θs − cos θ and G.
    fn u_at(&self, lower: f64, inertia: f64) -> LinearU {
        let Heavy { mass, h, .. } = self.law.body;
        let f = self.law.friction;
        let gain = libm::exp(f * self.growth);
        LinearU {
            base: (2.0 * mass * h * lower - f * gain * self.work) / inertia,
            gain: gain / inertia,
        }
    }

    /// None if P ≤ 0 at a node.
    fn integrands(&self, panel: Panel) -> Option<Integrands> {
        let rule = Rule::get();
        let (centre, half) = (panel.centre(), panel.half_width());
        let mut samples = [Sample::default(); NODES];
        for (sample, x) in samples.iter_mut().zip(rule.nodes) {
            *sample = Sample::new(self.law, self.start, centre + half * x)?;
        }
        let growths = samples.map(|sample| sample.growth);
        let growth_to = rule.up_to(&growths).map(|sum| self.growth + half * sum);
        let works: [f64; NODES] = core::array::from_fn(|i| {
            samples[i].work * libm::exp(-self.law.friction * growth_to[i])
        });
        let work_to = rule.up_to(&works).map(|sum| self.work + half * sum);
        let u = core::array::from_fn(|i| {
            let sums = Self {
                growth: growth_to[i],
                work: work_to[i],
                ..*self
            };
            sums.u_at(samples[i].lower, samples[i].inertia)
        });
        Some(Integrands {
            samples,
            growths,
            plain_works: samples.map(|sample| sample.work),
            works,
            u,
        })
    }

    /// Whether a panel resolves its integrals, and the times of turns with these energies.
    fn are_resolved_by(&mut self, integrands: &Integrands, energies: Option<EnergyRange>) -> bool {
        let rule = Rule::get();
        let Integrands {
            growths,
            plain_works,
            works,
            u,
            ..
        } = integrands;
        self.max_growth = self.max_growth.max(largest(growths));
        self.max_work = self.max_work.max(largest(plain_works));
        let resolves_time = |energy: f64| {
            let slowness = u.map(|u| 1.0 / u.at(energy).sqrt());
            rule.tail(&slowness) < TIME_TOLERANCE * largest(&slowness)
        };
        rule.tail(growths) <= MAP_TOLERANCE * self.max_growth
            && rule.tail(plain_works) <= MAP_TOLERANCE * self.max_work
            && rule.tail(works) <= MAP_TOLERANCE * self.max_work.max(largest(works))
            && energies
                .is_none_or(|EnergyRange { low, high }| resolves_time(low) && resolves_time(high))
    }

    fn add(&mut self, panel: Panel, integrands: &Integrands) {
        let rule = Rule::get();
        self.growth += panel.half_width() * rule.integral(&integrands.growths);
        self.work += panel.half_width() * rule.integral(&integrands.works);
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
            top: LinearU {
                base: f64::NAN,
                gain: f64::NAN,
            },
        }
    }

    /// The map of a law in the direction of motion, accurate for times in a range of energies. None
    /// if P vanishes in the turn, or if it needs too many panels.
    pub(super) fn new(law: &SlidingLaw, energies: Option<EnergyRange>) -> Option<Self> {
        let mut sums = Sums::new(law);
        let to_top = sums.angle_to_top();
        let mut map = Self::identity(sums.inertia_at_section());
        let mut pending = initial_panels(to_top);
        let mut halvings = 0;
        // Panels are taken from the end of the list.
        while let Some(panel) = pending.pop() {
            let integrands = sums.integrands(panel)?;
            if !sums.are_resolved_by(&integrands, energies) {
                halvings += 1;
                if halvings > MAX_HALVINGS {
                    return None;
                }
                pending.extend(panel.halves());
                continue;
            }
            map.nodes.extend(integrands.nodes(panel));
            sums.add(panel, &integrands);
            if panel.right == to_top {
                map.top = sums.u_at(lower_by(sums.start, to_top), law.body.inertia);
            }
        }
        map.kappa = law.friction * sums.growth;
        map.beta = -law.friction * libm::exp(map.kappa) * sums.work;
        map.top.base.is_finite().then_some(map)
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
        h * self.top.at(energy)
    }

    /// ε with which h u = 1 at the top.
    pub(super) fn lift_off_energy(&self, h: f64) -> f64 {
        (1.0 / h - self.top.base) / self.top.gain
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
