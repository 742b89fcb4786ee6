//! The plane of rolling (θ, θ′) as series: loci |F| = μs N and N = 0, orbits, regions.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use littlewood::theory::closed_form::slip_angle;
use littlewood::theory::{Body, PhasePlane, RollingLaw, Stability, Window};
use littlewood::{Hoop, ParameterError};
use littlewood_draw::{
    Anchor, Content, INK, Label, Layer, Mark, PlotAxis, Point, STABLE, Series, Stroke, UNSTABLE,
};
use littlewood_style::Curve;

use crate::axes::{linear_to, separatrix_rate};
use crate::columns::{MU_S, ORBIT, PLANE, THETA, THETA_RATE};
use crate::wording::Wording;

/// A phase plane in a window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Portrait {
    pub(crate) hoop: Hoop,
    pub(crate) plane: PhasePlane,
    pub(crate) law: RollingLaw,
    pub(crate) window: Window,
    /// Where the axis of rates begins to be logarithmic.
    pub(crate) linear: f64,
}

/// Orbits of rolling.
#[derive(Clone, Debug)]
pub(crate) enum Orbits {
    /// Of constant energies.
    Levels(Vec<f64>),
    /// With rolling resistance.
    Resisted(Series),
}

/// What fits into so many times the rate at which the axis begins to be logarithmic is traced
/// there.
const INNER: f64 = 4.0;

/// Rows of two coordinates and a number that belongs to all.
pub(crate) fn rows_with(
    pieces: Vec<Vec<[f64; 2]>>,
    last: f64,
) -> impl Iterator<Item = impl Iterator<Item = [f64; 3]>> {
    let pieces = pieces.into_iter();
    pieces.map(move |piece| piece.into_iter().map(move |[x, y]| [x, y, last]))
}

impl Portrait {
    pub(crate) fn new(hoop: &Hoop, window: Window) -> Self {
        let linear = linear_to(hoop, window.y[1]);
        Self {
            hoop: *hoop,
            plane: PhasePlane::new(hoop),
            law: RollingLaw::new(hoop),
            window,
            linear,
        }
    }

    /// A panel of the plane.
    pub(crate) fn content(
        &self,
        name: &'static str,
        say: Wording,
        layers: Vec<Layer>,
        labels: Vec<Label>,
    ) -> Content {
        Content {
            name,
            x: say.angle(self.window.x.into()),
            y: PlotAxis {
                linear: self.linear,
                ..say.rate(self.window.y.into())
            },
            layers,
            labels,
        }
    }

    /// What a caption says of the axis of rates.
    pub(crate) fn remark(&self) -> &'static str {
        if self.linear.is_finite() {
            " The axis of rates is logarithmic on either side of zero."
        } else {
            ""
        }
    }

    /// The angle in the middle of the window.
    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.window.x[0] + self.window.x[1])
    }

    /// A rate at a part of the upper half of the window, as it is seen.
    pub(crate) fn rate_at(&self, share: f64) -> f64 {
        let most = self.window.y[1];
        if !self.linear.is_finite() {
            return share * most;
        }
        self.linear * libm::sinh(share * libm::asinh(most / self.linear))
    }

    /// The window in which an orbit is traced: one that is small in the whole one has a window of
    /// its own.
    fn window_of(&self, energy: f64) -> Window {
        self.window_to(self.plane.level_rate(PI, energy))
    }

    /// The window in which what is so fast at the bottom is traced.
    fn window_to(&self, rate: Option<f64>) -> Window {
        let inner = INNER * self.linear;
        let is_small = inner < self.window.y[1] && rate.is_some_and(|it| it < inner);
        if is_small {
            Window {
                y: [-inner, inner],
                ..self.window
            }
        } else {
            self.window
        }
    }

    /// The locus |F| = μs N of (2.13) for a coefficient of friction.
    pub(crate) fn slip_locus(&self, mu_s: f64) -> Result<Series, ParameterError> {
        let parameters = self.hoop.parameters();
        let other = Hoop::new(parameters.with_friction(mu_s, parameters.mu_k.min(mu_s)))?;
        let pieces = PhasePlane::new(&other).slip_curve(&self.window);
        Ok(Series::new(
            format!("f {MU_S}={mu_s}"),
            &[THETA, THETA_RATE, MU_S],
            rows_with(pieces, mu_s),
        ))
    }

    /// The same of a massless hoop, with the angle at which static friction gives way; none where
    /// it always holds.
    pub(crate) fn massless_limit(&self) -> Option<(f64, Series)> {
        let Body::Massless(body) = self.hoop.body() else {
            return None;
        };
        let pieces = self.plane.slip_curve(&self.window);
        // With rolling resistance it is another one each way, about there.
        let theta = match slip_angle(&body, self.hoop.mu_s()) {
            None if self.resists() && !pieces.is_empty() => FRAC_PI_2,
            limit => limit?,
        };
        Some((theta, Series::new("f", &PLANE, pieces)))
    }

    /// The locus N = 0.
    pub(crate) fn unloading_locus(&self) -> Series {
        Series::new("n", &PLANE, self.plane.normal_force_curve(&self.window))
    }

    /// The locus beyond which the body leaves the plane.
    pub(crate) fn lift_off_locus(&self) -> Series {
        Series::new("lift-off", &PLANE, self.plane.lift_off_curve(&self.window))
    }

    /// The rates between which bounces grow out of rolling; none on a level plane.
    pub(crate) fn reverse_chatter(&self) -> Series {
        let pieces = self.plane.reverse_chatter_curve(&self.window);
        Series::new("reverse chatter", &PLANE, pieces)
    }

    /// The region N < 0, above and below n.
    pub(crate) fn unloaded(&self) -> Series {
        let mut pieces = self.plane.normal_force_curve(&self.window);
        let [low, high] = self.window.y;
        for piece in &mut pieces {
            let is_below = piece.first().is_some_and(|row| row[1] < 0.0);
            close_at(piece, if is_below { low } else { high });
        }
        Series::new("N<0", &PLANE, pieces)
    }

    /// The region 𝓡 of (2.14).
    pub(crate) fn rolling_region(&self) -> Series {
        Series::new("R", &PLANE, self.plane.rolling_region(&self.window))
    }

    /// The orbit of an energy E: ½ D(θ) θ′² + ℓ̂ cos θ = E.
    pub(crate) fn orbit(&self, energy: f64) -> Series {
        let pieces = self.plane.level_curve(energy, &self.window_of(energy));
        let name = format!("orbit E={}", rounded(energy));
        Series::new(name, &ORBIT, rows_with(pieces, energy))
    }

    /// Whether rolling resistance takes energy from rolling.
    pub(crate) fn resists(&self) -> bool {
        self.hoop.rolling_resistance() > 0.0
    }

    /// Orbits that fill the window, below a separatrix so wide.
    pub(crate) fn orbits(&self, orbits: &Orbits, separatrix: f64) -> Vec<Layer> {
        let mut layers: Vec<Layer> = match orbits {
            Orbits::Levels(energies) => energies
                .iter()
                .map(|energy| self.orbit(*energy).drawn(Curve::Level))
                .collect(),
            Orbits::Resisted(series) => vec![series.clone().drawn(Curve::Level)],
        };
        let stroke = Stroke::of_curve(Curve::Separatrix).wide(separatrix);
        layers.push(self.separatrix().drawn(stroke));
        layers
    }

    /// Orbits: so many librations and rotations.
    pub(crate) fn choose(&self, librations: u32, rotations: u32) -> Orbits {
        if self.resists() {
            let well = self.window_to(Some(separatrix_rate(&self.hoop)));
            let mut pieces = self.plane.orbits(&well, librations, 0);
            pieces.extend(self.plane.orbits(&self.window, 0, rotations));
            Orbits::Resisted(Series::new("orbits", &PLANE, pieces))
        } else {
            Orbits::Levels(self.energies(librations, rotations))
        }
    }

    /// The band of rest, if rolling resistance makes one.
    pub(crate) fn band_of_rest(&self) -> Option<Layer> {
        let pieces = Curve::BandOfRest.pieces(&self.plane, &self.window);
        let series = || Series::new(Curve::BandOfRest.name(), &PLANE, pieces.clone());
        (!pieces.is_empty()).then(|| series().drawn(Curve::BandOfRest))
    }

    /// The separatrix through the unstable equilibrium; with rolling resistance through the far
    /// edges of the upper bands of rest.
    pub(crate) fn separatrix(&self) -> Series {
        if self.resists() {
            let well = self.window_to(Some(separatrix_rate(&self.hoop)));
            let pieces = self.plane.separatrix_curve(&well);
            return Series::new(Curve::Separatrix.name(), &PLANE, pieces);
        }
        let energy = self.law.separatrix_energy();
        let pieces = self.plane.separatrix_curve(&self.window_of(energy));
        let name = Curve::Separatrix.name();
        Series::new(name, &ORBIT, rows_with(pieces, energy))
    }

    /// Energies of orbits that fill the window: librations by equal steps of θ′ at the bottom,
    /// rotations at the top.
    pub(crate) fn energies(&self, librations: u32, rotations: u32) -> Vec<f64> {
        let most = self.plane.separatrix_rate(PI);
        let within = (1..=librations).map(|i| most * f64::from(i) / f64::from(librations + 1));
        let beyond =
            (1..=rotations).map(|i| self.rate_at((f64::from(i) - 0.35) / f64::from(rotations)));
        within
            .map(|rate| self.law.energy(PI, rate))
            .chain(beyond.map(|rate| self.law.energy(0.0, rate)))
            .collect()
    }

    /// Arrows of the flow over an angle: places on orbits, each with the next place.
    pub(crate) fn flow_of(&self, orbits: &Orbits, theta: f64) -> Series {
        let series = match orbits {
            Orbits::Levels(energies) => return self.flow(energies, theta),
            Orbits::Resisted(series) => series,
        };
        let chords = series.pieces.iter().flat_map(|piece| piece.windows(2));
        let crossing = chords.filter_map(|chord| {
            let [from, to] = chord else { return None };
            if (from[0] < theta) == (to[0] < theta) {
                return None;
            }
            let slope = (to[1] - from[1]) / (to[0] - from[0]);
            let rate = from[1] + slope * (theta - from[0]);
            let step = 0.04_f64.copysign(rate);
            let is_seen = rate.abs() <= self.rate_at(0.93);
            is_seen.then_some([[theta, rate], [theta + step, rate + slope * step]])
        });
        Series::new("flow", &PLANE, crossing)
    }

    /// Arrows of the flow: places on the orbits of these energies over an angle, each with the next
    /// place.
    pub(crate) fn flow(&self, energies: &[f64], theta: f64) -> Series {
        let step = 0.04;
        let pieces = energies
            .iter()
            .filter_map(|energy| {
                let here = self.plane.level_rate(theta, *energy)?;
                let next = self.plane.level_rate(theta + step, *energy)?;
                let before = self.plane.level_rate(theta - step, *energy)?;
                let seen = here <= self.rate_at(0.93) && here > 0.0;
                seen.then_some([
                    [[theta, here], [theta + step, next]],
                    [[theta, -here], [theta - step, -before]],
                ])
            })
            .flatten();
        Series::new("flow", &PLANE, pieces)
    }
}

/// The lines *n* of Littlewood's hoop, between the angles at which it slips.
pub(crate) fn unloading_lines(theta_s: f64) -> Series {
    let pieces = [1.0, -1.0].map(|rate| [[-theta_s, rate], [theta_s, rate]]);
    Series::new("n", &PLANE, pieces)
}

/// Makes a curve the outline of what is between it and a level.
pub(crate) fn close_at(curve: &mut Vec<[f64; 2]>, level: f64) {
    if let (Some(first), Some(last)) = (curve.first().copied(), curve.last().copied()) {
        curve.extend([[last[0], level], [first[0], level]]);
    }
}

/// A label and its mirror image: at the other side of the first or the second axis.
pub(crate) fn mirrored(label: Label, axis: usize) -> [Label; 2] {
    let mut other = label.clone();
    other.at[axis] = -label.at[axis];
    other.shift[axis] = -label.shift[axis];
    other.anchor = match label.anchor {
        Anchor::Left if axis == 0 => Anchor::Right,
        Anchor::Right if axis == 0 => Anchor::Left,
        anchor => anchor,
    };
    [label, other]
}

/// Two places of an orbit as they follow each other: to the right where θ′ > 0.
pub(crate) fn in_time<Row: AsRef<[f64]>>(a: Row, b: Row) -> [Row; 2] {
    let (from, to) = (a.as_ref(), b.as_ref());
    if (to[0] - from[0]) * from[1] > 0.0 {
        [a, b]
    } else {
        [b, a]
    }
}

/// For names.
fn rounded(value: f64) -> f64 {
    libm::round(value * 1e4) / 1e4
}

/// What several figures of the plane have in common.
impl Portrait {
    /// A name at the row of a series that is nearest to a place, measured in parts of the window.
    pub(crate) fn name_of(
        &self,
        series: &Series,
        at: Point,
        name: impl Into<String>,
    ) -> Option<Label> {
        let Window { x, y } = self.window;
        let distance = |row: &[f64]| {
            let (dx, dy) = (
                (row[0] - at.x) / (x[1] - x[0]),
                (row[1] - at.y) / (y[1] - y[0]),
            );
            dx * dx + dy * dy
        };
        let nearest = series
            .rows()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        Some(Label::new(name, &nearest[..2]))
    }

    /// "N < 0" in the hatched regions, where there is room.
    pub(crate) fn mark_of_unloading(&self) -> Vec<Label> {
        let most = self.window.y[1];
        let Some(least) = self
            .plane
            .normal_force_rate(0.0)
            .filter(|rate| *rate < 0.8 * most)
        else {
            return Vec::new();
        };
        let middle = if self.linear.is_finite() {
            (least * most).sqrt()
        } else {
            0.5 * (least + most)
        };
        let turns = (libm::ceil(self.window.x[0] / TAU) as i32)
            ..=(libm::floor(self.window.x[1] / TAU) as i32);
        turns
            .flat_map(|turn| {
                [1.0, -1.0].map(|sign| {
                    Label::new("*N* < 0", &[TAU * f64::from(turn), sign * middle]).of_area()
                })
            })
            .collect()
    }

    /// Arrowheads on the separatrix of a level plane, which goes over the tops.
    pub(crate) fn separatrix_heads(&self) -> Vec<Layer> {
        let angles = if self.hoop.slope() == 0.0 && !self.resists() {
            &[0.62 * PI, 1.38 * PI][..]
        } else {
            &[]
        };
        let heads = |theta: &f64| {
            self.flow(&[self.law.separatrix_energy()], *theta)
                .drawn(Mark::Head(INK))
        };
        angles.iter().map(heads).collect()
    }

    /// Dots on the stable equilibria, rings on the unstable ones; or the band of rest.
    pub(crate) fn equilibria(&self) -> Vec<Layer> {
        let (mut stable, mut unstable) = (Vec::new(), Vec::new());
        for equilibrium in self.plane.equilibria() {
            let first = libm::ceil((self.window.x[0] - equilibrium.theta) / TAU) as i32;
            let last = libm::floor((self.window.x[1] - equilibrium.theta) / TAU) as i32;
            for turn in first..=last {
                let row = [equilibrium.theta + TAU * f64::from(turn), 0.0];
                match equilibrium.stability {
                    Stability::Stable { .. } => stable.push(row),
                    Stability::Unstable { .. } => unstable.push(row),
                    Stability::Neutral => {}
                }
            }
        }
        let mut layers: Vec<Layer> = self.band_of_rest().into_iter().collect();
        layers.extend([
            Series::of_rows("stable equilibrium", &PLANE, stable).drawn(STABLE),
            Series::of_rows("unstable equilibrium", &PLANE, unstable).drawn(UNSTABLE),
        ]);
        layers
    }
}
