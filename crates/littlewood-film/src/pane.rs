//! A second picture beside the hoop, in which the motion runs along: the phase plane, the friction, or the energy.

use core::f64::consts::{PI, TAU};

use littlewood::si::Units;
use littlewood::tables::{Dimension, Quantity, SampleColumn};
use littlewood::theory::{PhasePlane, Window};
use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::marked;
use littlewood_style::ticks::{self, Tick};
use littlewood_style::{Curve, Dash, EnergyPart};

use crate::canvas::{Canvas, Place};
use crate::colour::{self, FRICTION_FORCE, INK, LINE, PAPER, SOFT, of_mode, of_region};
use crate::ledger::{EnergyParts, Ledger};
use crate::letters::Style;
use crate::plot::Plot;
use crate::schedule::Schedule;

/// What a film shows beside the hoop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum With {
    /// The plane of θ and θ′ with the curves of rolling and of lift-off.
    Plane,
    /// |F|/N with its limits against the time.
    Friction,
    /// The energy and what it has become against the time.
    Energy,
}

impl With {
    /// All, in order.
    pub const ALL: [Self; 3] = [Self::Plane, Self::Friction, Self::Energy];

    /// Lower-case name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Friction => "friction",
            Self::Energy => "energy",
        }
    }
}

/// Width of the pane in units of lettering.
pub(crate) const PANE: f64 = 236.0;

/// Instants at which a motion is sampled for a pane.
const SAMPLES: usize = 1500;

/// A part of a motion in one mode: its points, each with its time.
struct Piece {
    mode: Mode,
    points: Vec<(f64, [f64; 2])>,
}

/// A pane with what it shows of a motion.
pub(crate) struct Pane {
    with: With,
    plot: Plot,
    pieces: Vec<Piece>,
    energies: Option<(Ledger, Vec<(f64, EnergyParts)>)>,
    units: Option<Units>,
}

impl Pane {
    pub(crate) fn new(
        with: With,
        trajectory: &Trajectory,
        schedule: &Schedule,
        [left, top, width, height]: [f64; 4],
        unit: f64,
        units: Option<Units>,
    ) -> Self {
        let samples: Vec<Sample> = trajectory.sample_evenly(SAMPLES, schedule.end()).collect();
        let times = [schedule.start(), schedule.end().max(schedule.start() + 1e-9)];
        let ledger = Ledger::new(trajectory);
        let energies = ledger.map(|ledger| {
            let parts = samples
                .iter()
                .filter_map(|sample| Some((sample.state.time, ledger.parts(sample, false)?)))
                .collect();
            (ledger, parts)
        });
        let (x, y) = match with {
            With::Plane => ([-PI, PI], rates(&samples, trajectory)),
            With::Friction => (times, [0.0, most_demand(trajectory)]),
            With::Energy => (times, [0.0, most_energy(energies.as_ref())]),
        };
        // What the colours of the energy mean takes two lines.
        let head = if with == With::Energy { 29.0 } else { 18.0 } * unit;
        let plot = Plot {
            left: left + 32.0 * unit,
            top: top + head,
            width: width - 44.0 * unit,
            height: height - head - 28.0 * unit,
            x,
            y,
            unit,
        };
        let value = |sample: &Sample| match with {
            With::Plane => Some([wrapped(sample.state.theta), sample.state.theta_rate]),
            With::Friction => demand(sample).map(|demand| [sample.state.time, demand]),
            With::Energy => None,
        };
        let mut pieces: Vec<Piece> = Vec::new();
        let mut begins = true;
        for sample in &samples {
            let Some(point) = value(sample) else {
                begins = true;
                continue;
            };
            let entry = (sample.state.time, point);
            match pieces.last_mut() {
                Some(piece) if !begins && piece.mode == sample.mode && !jumps(with, piece, point) => {
                    piece.points.push(entry);
                }
                _ => pieces.push(Piece { mode: sample.mode, points: vec![entry] }),
            }
            begins = false;
        }
        Self { with, plot, pieces, energies, units }
    }

    /// What does not change from frame to frame.
    pub(crate) fn draw_still(&self, canvas: &mut Canvas, trajectory: &Trajectory) {
        let plot = &self.plot;
        let u = plot.unit;
        match self.with {
            With::Plane => {
                self.draw_curves(canvas, trajectory);
                for piece in &self.pieces {
                    let points: Vec<[f64; 2]> = piece.points.iter().map(|(_, point)| *point).collect();
                    plot.line(canvas, &points, 1.2 * u, LINE, Dash::Solid);
                }
                let x: Vec<Tick> = ticks::angular(-PI, PI, 5);
                let name = with_unit(&marked(Quantity::Theta.sign()), Dimension::Angle.si_sign());
                self.frame(canvas, &x, &name, Dimension::AngularRate, &marked(Quantity::ThetaRate.sign()));
            }
            With::Friction => {
                let hoop = trajectory.hoop();
                for (limit, dash, sign) in
                    [(hoop.mu_s(), Dash::Solid, Quantity::MuS), (hoop.mu_k(), Dash::Dashed, Quantity::MuK)]
                {
                    let line = [[plot.x[0], limit], [plot.x[1], limit]];
                    plot.line(canvas, &line, 1.4 * u, FRICTION_FORCE, dash);
                    let (_, y) = plot.place([plot.x[1], limit]);
                    // One over, the other under its line, so that they never meet.
                    let below = if sign == Quantity::MuS { -3.0 } else { 10.0 };
                    let style = Style { size: 10.0 * u, is_bold: false, anchor: 1.0 };
                    canvas.words(
                        &marked(sign.sign()),
                        (plot.left + plot.width - 4.0 * u, y + below * u),
                        style,
                        FRICTION_FORCE,
                    );
                }
                for piece in &self.pieces {
                    let points: Vec<[f64; 2]> = piece.points.iter().map(|(_, point)| *point).collect();
                    plot.line(canvas, &points, 1.2 * u, LINE, Dash::Solid);
                }
                self.frame_of_time(canvas, "|*F*|/*N*", None);
            }
            With::Energy => {
                self.draw_energy(canvas, f64::INFINITY, 0.3);
                let style = Style { size: 9.0 * u, is_bold: true, anchor: 1.0 };
                for (line, parts) in EnergyPart::ALL.chunks(2).enumerate() {
                    let mut right = plot.left + plot.width;
                    let y = plot.top - (15.5 - 11.0 * line as f64) * u;
                    for part in parts.iter().rev().filter(|part| self.has(**part)) {
                        canvas.words(part.label(), (right, y), style, colour::of_energy(*part));
                        right -= style.width(part.label()) + 7.0 * u;
                    }
                }
                let unit = unit_sign(self.units.as_ref(), Dimension::Energy);
                let name = with_unit(&marked(SampleColumn::Energy.sign()), &unit);
                let style = Style { size: 10.0 * u, is_bold: false, anchor: 0.0 };
                canvas.words(&name, (plot.left, plot.top - 15.5 * u), style, INK);
                self.frame_of_time(canvas, "", Some(Dimension::Energy));
            }
        }
    }

    /// What the motion has done up to a time.
    pub(crate) fn draw_moving(&self, canvas: &mut Canvas, sample: &Sample) {
        let (plot, time) = (&self.plot, sample.state.time);
        let u = plot.unit;
        if self.with == With::Energy {
            self.draw_energy(canvas, time, 1.0);
        }
        for piece in &self.pieces {
            let points: Vec<[f64; 2]> =
                piece.points.iter().take_while(|(at, _)| *at <= time).map(|(_, point)| *point).collect();
            plot.line(canvas, &points, 2.2 * u, of_mode(piece.mode), Dash::Solid);
        }
        let now = match self.with {
            With::Plane => Some([wrapped(sample.state.theta), sample.state.theta_rate]),
            With::Friction => demand(sample).map(|demand| [time, demand]),
            With::Energy => None,
        };
        if self.with != With::Plane {
            let (x, _) = plot.place([time, plot.y[0]]);
            canvas.rectangle((x - 0.6 * u, plot.top), 1.2 * u, plot.height, INK);
        }
        if let Some(now) = now.filter(|now| now[1].is_finite()) {
            let (x, y) = plot.place([now[0], now[1].clamp(plot.y[0], plot.y[1])]);
            canvas.disc((x, y), 4.6 * u, PAPER);
            canvas.disc((x, y), 3.4 * u, INK);
        } else if self.with == With::Friction {
            let words = if sample.mode.touches_plane() { "*N* = *F* = 0" } else { "no contact" };
            let style = Style { size: 10.0 * u, is_bold: false, anchor: 0.5 };
            let place = (plot.left + 0.5 * plot.width, plot.top + 14.0 * u);
            canvas.label(words, place, style, SOFT);
        }
    }

    /// The curves f and n of rolling and that of lift-off, over the region of rolling.
    fn draw_curves(&self, canvas: &mut Canvas, trajectory: &Trajectory) {
        let (plot, hoop) = (&self.plot, trajectory.hoop());
        let plane = PhasePlane::new(hoop);
        let u = plot.unit;
        let window = Window { x: plot.x, y: plot.y };
        for outline in plane.rolling_region(&window) {
            let corners: Vec<Place> = outline.into_iter().map(|corner| plot.place(corner)).collect();
            canvas.polygon(&corners, of_region());
        }
        for (curve, lines) in [
            (Curve::LiftOff, plane.lift_off_curve(&window)),
            (Curve::NormalForceZero, plane.normal_force_curve(&window)),
            (Curve::SlipLimit, plane.slip_curve(&window)),
        ] {
            for line in lines {
                plot.line(canvas, &line, 0.8 * curve.width() * u, curve.colour(colour::THEME), curve.dash());
            }
        }
        let style = Style { size: 9.0 * u, is_bold: false, anchor: 1.0 };
        let mut right = plot.left + plot.width;
        for (words, curve) in [
            ("lift-off", Curve::LiftOff),
            ("*n*: *N* = 0", Curve::NormalForceZero),
            ("*f*: |*F*| = *μ*ₛ*N*", Curve::SlipLimit),
        ] {
            canvas.words(words, (right, plot.top - 4.5 * u), style, curve.colour(colour::THEME));
            right -= style.width(words) + 7.0 * u;
        }
    }

    fn has(&self, part: EnergyPart) -> bool {
        let most = self.plot.y[1];
        let parts = self.energies.iter().flat_map(|(_, parts)| parts);
        parts.map(|(_, parts)| parts.part(part)).fold(0.0, f64::max) > 1e-6 * most
    }

    /// The parts of the energy one upon the other up to a time.
    fn draw_energy(&self, canvas: &mut Canvas, until: f64, strength: f64) {
        let Some((_, parts)) = &self.energies else { return };
        let parts: Vec<&(f64, EnergyParts)> = parts.iter().take_while(|(time, _)| *time <= until).collect();
        let mut lower: Vec<[f64; 2]> = parts.iter().map(|(time, _)| [*time, 0.0]).collect();
        if lower.len() < 2 {
            return;
        }
        for part in EnergyPart::ALL {
            let upper: Vec<[f64; 2]> = lower
                .iter()
                .zip(&parts)
                .map(|([time, below], (_, parts))| [*time, below + parts.part(part).max(0.0)])
                .collect();
            self.plot.band(canvas, &lower, &upper, colour::of_energy(part).over(PAPER, strength));
            self.plot.line(canvas, &upper, 0.8 * self.plot.unit, PAPER, Dash::Solid);
            lower = upper;
        }
    }

    fn frame_of_time(&self, canvas: &mut Canvas, name: &str, dimension: Option<Dimension>) {
        let unit = self.units.map_or(1.0, |units| units.unit(Dimension::Time));
        let sign = if self.units.is_some() { "t" } else { Quantity::Time.sign() };
        let [low, high] = self.plot.x.map(|time| unit * time);
        let mut x = ticks::round(low, high, 5);
        x.iter_mut().for_each(|tick| tick.value /= unit);
        let title = with_unit(&marked(sign), &unit_sign(self.units.as_ref(), Dimension::Time));
        self.frame(canvas, &x, &title, dimension.unwrap_or(Dimension::Ratio), name);
    }

    fn frame(&self, canvas: &mut Canvas, x: &[Tick], x_name: &str, dimension: Dimension, name: &str) {
        let unit = self.units.map_or(1.0, |units| units.unit(dimension));
        let [low, high] = self.plot.y.map(|value| unit * value);
        let mut y = ticks::round(low, high, 5);
        y.iter_mut().for_each(|tick| tick.value /= unit);
        let title = if name.is_empty() {
            String::new()
        } else {
            with_unit(name, &unit_sign(self.units.as_ref(), dimension))
        };
        self.plot.draw_frame(canvas, [x, &y], [x_name, &title]);
    }
}

/// The sign of a unit, with marks.
pub(crate) fn unit_sign(units: Option<&Units>, dimension: Dimension) -> String {
    if units.is_some() { dimension.si_sign().to_owned() } else { marked(dimension.scale_sign()) }
}

pub(crate) fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} / {unit}") }
}

/// An angle between −π and π.
fn wrapped(theta: f64) -> f64 {
    let rest = libm::fmod(theta, TAU);
    if rest > PI {
        rest - TAU
    } else if rest < -PI {
        rest + TAU
    } else {
        rest
    }
}

/// Whether a line must not lead from the last point of a piece to the next.
fn jumps(with: With, piece: &Piece, next: [f64; 2]) -> bool {
    let Some((_, last)) = piece.points.last() else { return false };
    match with {
        With::Plane => (next[0] - last[0]).abs() > PI,
        With::Friction | With::Energy => false,
    }
}

/// |F|/N where there is a normal force.
fn demand(sample: &Sample) -> Option<f64> {
    (sample.mode.touches_plane() && sample.normal > 0.0).then(|| sample.friction.abs() / sample.normal)
}

fn most_demand(trajectory: &Trajectory) -> f64 {
    let most = trajectory.hoop().mu_s();
    if most > 0.0 { 1.3 * most } else { 1.0 }
}

fn most_energy(energies: Option<&(Ledger, Vec<(f64, EnergyParts)>)>) -> f64 {
    let parts = energies.into_iter().flat_map(|(_, parts)| parts);
    let sum =
        |parts: &EnergyParts| EnergyPart::ALL.iter().map(|part| parts.part(*part).max(0.0)).sum::<f64>();
    let most = parts.map(|(_, parts)| sum(parts)).filter(|sum| sum.is_finite()).fold(0.0, f64::max);
    if most > 0.0 { 1.05 * most } else { 1.0 }
}

/// The range of rates of a motion: symmetric, with the curves of rolling in sight; rates that grow without bound are cut.
fn rates(samples: &[Sample], trajectory: &Trajectory) -> [f64; 2] {
    let mut rates: Vec<f64> =
        samples.iter().map(|sample| sample.state.theta_rate.abs()).filter(|rate| rate.is_finite()).collect();
    rates.sort_by(f64::total_cmp);
    let most = rates.last().copied().unwrap_or(1.0);
    let usual = rates.get(rates.len() * 9 / 10).copied().unwrap_or(1.0);
    let at_top = PhasePlane::new(trajectory.hoop()).lift_off_rate(0.0).unwrap_or(1.0);
    let high = 1.12 * most.min(2.5 * usual.max(0.5 * at_top)).max(1.3 * at_top);
    [-high, high]
}
