//! The plane of rolling (θ, θ′) as series: loci |F| = μs N and N = 0, orbits, regions.

use core::f64::consts::{PI, TAU};

use littlewood::theory::closed_form::slip_angle;
use littlewood::theory::{Body, PhasePlane, RollingLaw, Stability};
use littlewood::{Direction, Hoop, ParameterError};
use littlewood_style::Curve;

use crate::columns::{ENERGY, MU_S, PLANE, THETA, THETA_RATE};
use crate::figure::{Label, Layer, Mark, Series};
use crate::style::INK;
use crate::trace::Window;

/// Intervals in which a curve is looked for.
const CELLS: u32 = 480;

/// A phase plane in a window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Portrait {
    pub(crate) hoop: Hoop,
    pub(crate) plane: PhasePlane,
    pub(crate) law: RollingLaw,
    pub(crate) window: Window,
}

/// Of a heavy hoop.
pub(crate) const BEYOND: &str =
    " What is not seen of *f* and *n* lies beyond the window, at far greater rates.";

/// Rows of the two coordinates.
pub(crate) fn rows(pieces: Vec<Vec<[f64; 2]>>) -> Vec<Vec<Vec<f64>>> {
    pieces.into_iter().map(|piece| piece.into_iter().map(Vec::from).collect()).collect()
}

/// Rows of the two coordinates and a number that belongs to all.
fn rows_with(pieces: Vec<Vec<[f64; 2]>>, last: f64) -> Vec<Vec<Vec<f64>>> {
    pieces.into_iter().map(|piece| piece.into_iter().map(|[x, y]| vec![x, y, last]).collect()).collect()
}

impl Portrait {
    pub(crate) fn new(hoop: &Hoop, window: Window) -> Self {
        Self { hoop: *hoop, plane: PhasePlane::new(hoop), law: RollingLaw::new(hoop), window }
    }

    /// The graphs ±rate(θ).
    fn graph(&self, rate: &dyn Fn(f64) -> Option<f64>) -> Vec<Vec<[f64; 2]>> {
        // Where D = 0, at θ = ±π without inertia, nothing is defined.
        let inside = |theta: f64| self.law.denominator(theta) > 1e-12;
        [1.0, -1.0]
            .into_iter()
            .flat_map(|sign| {
                self.window.pieces(self.window.x, CELLS, &|theta| {
                    Some([theta, sign * rate(theta).filter(|_| inside(theta))?])
                })
            })
            .collect()
    }

    /// The locus |F| = μs N of (2.13) for a coefficient of friction.
    pub(crate) fn slip_locus(&self, mu_s: f64) -> Result<Series, ParameterError> {
        let parameters = self.hoop.parameters();
        let other = Hoop::new(parameters.with_friction(mu_s, parameters.mu_k.min(mu_s)))?;
        let plane = PhasePlane::new(&other);
        let pieces = [Direction::Positive, Direction::Negative]
            .into_iter()
            .flat_map(|direction| self.graph(&|theta| plane.slip_rate(theta, direction)))
            .collect();
        Ok(Series::new(format!("f {MU_S}={mu_s}"), &[THETA, THETA_RATE, MU_S], rows_with(pieces, mu_s)))
    }

    /// The locus N = 0.
    pub(crate) fn unloading_locus(&self) -> Series {
        if matches!(self.hoop.body(), Body::Massless(body) if body.offset == 1.0) {
            // N = cos²(θ/2) (1 − θ′²) (3.8).
            let [from, to] = self.window.x;
            let lines = [1.0, -1.0].map(|rate| vec![vec![from, rate], vec![to, rate]]);
            return Series::new("n", &PLANE, lines.to_vec());
        }
        Series::new("n", &PLANE, rows(self.graph(&|theta| self.plane.normal_force_rate(theta))))
    }

    /// The locus 1 = h cos θ θ′² beyond which the body leaves the plane.
    pub(crate) fn lift_off_locus(&self) -> Series {
        Series::new("lift-off", &PLANE, rows(self.graph(&|theta| self.plane.lift_off_rate(theta))))
    }

    /// The region N < 0, above and below n.
    pub(crate) fn unloaded(&self) -> Series {
        let pieces = [1.0, -1.0]
            .into_iter()
            .flat_map(|sign| {
                let edge = if sign > 0.0 { self.window.y[1] } else { self.window.y[0] };
                let rate = |theta: f64| Some([theta, sign * self.plane.normal_force_rate(theta)?]);
                let mut pieces = self.window.pieces(self.window.x, CELLS, &rate);
                for piece in &mut pieces {
                    if let (Some(first), Some(last)) = (piece.first().copied(), piece.last().copied()) {
                        piece.push([last[0], edge]);
                        piece.push([first[0], edge]);
                    }
                }
                pieces
            })
            .collect();
        Series::new("N<0", &PLANE, rows(pieces))
    }

    /// The rates |θ′| between which static friction holds at an angle, at most `most`.
    fn holding(&self, theta: f64, most: f64) -> Option<[f64; 2]> {
        if let Body::Massless(body) = self.hoop.body()
            && body.offset < 1.0
        {
            let holds = self.plane.forces(theta, 0.0).demand() <= self.hoop.mu_s();
            // Towards the bottom N grows with the rate.
            return holds
                .then(|| [0.0, self.plane.normal_force_rate(theta).map_or(most, |rate| rate.min(most))]);
        }
        if let Body::Massless(body) = self.hoop.body() {
            // N and F vanish together, at one rate: the angle alone decides.
            let holds = slip_angle(&body, self.hoop.mu_s()).is_none_or(|limit| theta.abs() <= limit);
            return self.plane.normal_force_rate(theta).filter(|_| holds).map(|rate| [0.0, rate.min(most)]);
        }
        let mu = self.hoop.mu_s();
        let (at_rest, at_one) = (self.plane.forces(theta, 0.0), self.plane.forces(theta, 1.0));
        let (mut low, mut high) = (0.0, most * most);
        // μs N ± F ≥ 0 and N ≥ 0, each linear in θ′².
        for (share, normal) in [(1.0, mu), (-1.0, mu), (0.0, 1.0)] {
            let constant = normal * at_rest.normal + share * at_rest.friction;
            let slope = normal * at_one.normal + share * at_one.friction - constant;
            let root = -constant / slope;
            if slope < 0.0 {
                high = f64::min(high, root);
            } else if slope > 0.0 {
                low = f64::max(low, root);
            } else if constant < 0.0 {
                return None;
            }
        }
        (low <= high).then(|| [low.sqrt(), high.sqrt()])
    }

    /// The region 𝓡 of (2.14).
    pub(crate) fn rolling_region(&self) -> Series {
        let most = self.window.y[1];
        let top = |theta: f64| self.holding(theta, most).map(|[_, high]| [theta, high]);
        let mut pieces = Vec::new();
        for upper in self.window.pieces(self.window.x, CELLS, &top) {
            // The lower edge bends where the upper one may be straight.
            let ends = [upper.first(), upper.last()].map(|end| end.map_or(0.0, |[theta, _]| *theta));
            let bottom = |theta: f64| Some([theta, self.holding(theta, most)?[0]]);
            let mut lower = self.window.pieces(ends, CELLS, &bottom).concat();
            lower.reverse();
            let mirrored = |points: &[[f64; 2]]| points.iter().map(|[x, y]| [*x, -y]).collect::<Vec<_>>();
            if lower.iter().all(|[_, low]| *low == 0.0) {
                let mut below = mirrored(&upper);
                below.reverse();
                pieces.push([upper, below].concat());
            } else {
                let above = [upper, lower].concat();
                pieces.push(mirrored(&above));
                pieces.push(above);
            }
        }
        Series::new("R", &PLANE, rows(pieces))
    }

    /// The orbit of an energy E: ½ D(θ) θ′² + ℓ̂ cos θ = E.
    pub(crate) fn orbit(&self, energy: f64) -> Series {
        let offset = self.hoop.offset();
        let pieces = if energy >= offset {
            self.graph(&|theta| self.plane.level_rate(theta, energy))
        } else if matches!(self.hoop.body(), Body::Massless(body) if body.offset == 1.0) {
            self.massless_orbit(energy)
        } else {
            // Libration: θ = π + a sin s, so that θ′, which vanishes with cos s, is smooth.
            let swing = libm::acos(-energy / offset);
            let first = libm::floor((self.window.x[0] - swing) / TAU);
            let count = libm::ceil((self.window.x[1] - self.window.x[0]) / TAU) as u32 + 2;
            (0..count)
                .flat_map(|turn| {
                    let centre = PI + TAU * (first + f64::from(turn));
                    self.window.pieces([-0.5 * PI, 1.5 * PI], CELLS, &|s| {
                        let (sin, cos) = libm::sincos(s);
                        let theta = centre + swing * sin;
                        let rate = self.plane.level_rate(theta, energy).unwrap_or(0.0);
                        Some([theta, if cos < 0.0 { -rate } else { rate }])
                    })
                })
                .collect()
        };
        Series::new(
            format!("orbit E={}", rounded(energy)),
            &[THETA, THETA_RATE, ENERGY],
            rows_with(pieces, energy),
        )
    }

    /// An orbit of Littlewood's hoop below the energy of the separatrix. It turns once and runs out to θ = ±π; with
    /// ½ D(θ) r² + ℓ̂ cos θ = E it is a function of the rate r.
    fn massless_orbit(&self, energy: f64) -> Vec<Vec<[f64; 2]>> {
        let offset = self.hoop.offset();
        [1.0, -1.0]
            .into_iter()
            .flat_map(|side| {
                self.window.pieces(self.window.y, CELLS, &|rate| {
                    let square = rate * rate;
                    let cos = (energy - 0.5 * (1.0 + offset * offset) * square) / (offset * (1.0 + square));
                    (cos.abs() <= 1.0).then(|| [side * libm::acos(cos), rate])
                })
            })
            .collect()
    }

    /// The separatrix through the unstable equilibrium.
    pub(crate) fn separatrix(&self) -> Series {
        Series { name: Curve::Separatrix.name().to_owned(), ..self.orbit(self.law.separatrix_energy()) }
    }

    /// Energies of orbits that fill the window: librations by equal steps of θ′ at the bottom, rotations at the top.
    pub(crate) fn energies(&self, librations: u32, rotations: u32) -> Vec<f64> {
        let most = self.plane.separatrix_rate(PI);
        let within = (1..=librations).map(|i| most * f64::from(i) / f64::from(librations + 1));
        let beyond = (1..=rotations).map(|i| self.window.y[1] * (f64::from(i) - 0.35) / f64::from(rotations));
        within
            .map(|rate| self.law.energy(PI, rate))
            .chain(beyond.map(|rate| self.law.energy(0.0, rate)))
            .collect()
    }

    /// Arrows of the flow: places on the orbits of these energies over an angle, each with the next place.
    pub(crate) fn flow(&self, energies: &[f64], theta: f64) -> Series {
        let step = 0.04;
        let pieces = energies
            .iter()
            .filter_map(|energy| {
                let here = self.plane.level_rate(theta, *energy)?;
                let next = self.plane.level_rate(theta + step, *energy)?;
                let before = self.plane.level_rate(theta - step, *energy)?;
                let seen = here <= 0.93 * self.window.y[1] && here > 0.0;
                seen.then(|| {
                    [
                        vec![vec![theta, here], vec![theta + step, next]],
                        vec![vec![theta, -here], vec![theta - step, -before]],
                    ]
                })
            })
            .flatten()
            .collect();
        Series::new("flow", &PLANE, pieces)
    }
}

/// The row of a series nearest to a place, measured in parts of the window.
pub(crate) fn nearest(series: &Series, at: [f64; 2], window: Window) -> Option<[f64; 2]> {
    let distance = |row: &[f64]| {
        let dx = (row[0] - at[0]) / (window.x[1] - window.x[0]);
        let dy = (row[1] - at[1]) / (window.y[1] - window.y[0]);
        dx * dx + dy * dy
    };
    series.rows().min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|row| [row[0], row[1]])
}

/// For names.
fn rounded(value: f64) -> f64 {
    libm::round(value * 1e4) / 1e4
}

/// What several figures of the plane have in common.
impl Portrait {
    /// "N < 0" in the hatched regions, where there is room.
    pub(crate) fn mark_of_unloading(&self) -> Vec<Label> {
        let most = self.window.y[1];
        let Some(least) = self.plane.normal_force_rate(0.0).filter(|rate| *rate < 0.8 * most) else {
            return Vec::new();
        };
        let turns =
            (libm::ceil(self.window.x[0] / TAU) as i32)..=(libm::floor(self.window.x[1] / TAU) as i32);
        turns
            .flat_map(|turn| {
                [1.0, -1.0]
                    .map(|sign| Label::new("*N* < 0", &[TAU * f64::from(turn), sign * 0.5 * (least + most)]))
            })
            .collect()
    }

    /// Dots on the stable equilibria, rings on the unstable ones.
    pub(crate) fn equilibria(&self) -> Vec<Layer> {
        let (mut stable, mut unstable) = (Vec::new(), Vec::new());
        for equilibrium in self.plane.equilibria() {
            let first = libm::ceil((self.window.x[0] - equilibrium.theta) / TAU) as i32;
            let last = libm::floor((self.window.x[1] - equilibrium.theta) / TAU) as i32;
            for turn in first..=last {
                let row = vec![equilibrium.theta + TAU * f64::from(turn), 0.0];
                match equilibrium.stability {
                    Stability::Stable { .. } => stable.push(row),
                    Stability::Unstable { .. } => unstable.push(row),
                    Stability::Neutral => {}
                }
            }
        }
        vec![
            Series::of_rows("stable equilibrium", &PLANE, stable).drawn(Mark::Dot(INK, 3.4)),
            Series::of_rows("unstable equilibrium", &PLANE, unstable).drawn(Mark::Ring(INK, 3.4)),
        ]
    }
}
