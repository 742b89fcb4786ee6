//! A second picture beside the hoop, in which the motion runs along: the phase plane, the friction,
//! or the energy.

use core::f64::consts::{PI, TAU};

use littlewood::energy::{EnergyLedger, EnergyParts};
use littlewood::si::Units;
use littlewood::tables::{Dimension, Quantity, SampleColumn};
use littlewood::theory::{PhasePlane, Window};
use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Dash, DrawError, GRID, Image, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, Point,
    REGION, SMALL, Scale, Series, Sheet, Stroke, marked,
};
use littlewood_style::width::FINE;
use littlewood_style::{Curve, EnergyPart};

use crate::camera;
use crate::canvas::{Canvas, Place};
use crate::colour::{FRICTION_FORCE, INK, PAPER, SOFT, of_energy, of_mode};
use crate::letters::Style;
use crate::schedule::Schedule;

/// What a film shows beside the hoop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum With {
    /// The plane of theta and theta' with the curves f, n and that of lift-off
    Plane,
    /// |F|/N with mu_s and mu_k against the time
    Friction,
    /// Kinetic and potential energy, and what is lost, against the time
    Energy,
}

/// Width of the pane in units of lettering.
pub(crate) const PANE: f64 = 236.0;

/// Units of lettering to a pixel of the figure: its letters are about as large as those beside it.
const SCALE: f64 = 0.8;

/// Instants at which a motion is sampled for a pane.
const SAMPLES: usize = 1500;

/// Width of the line of the motion, in pixels of the figure.
const MOTION: f64 = 2.6;

/// Columns of a figure.
const COLUMNS: [&str; 2] = ["right", "up"];

/// A part of a motion in one mode: its points, each with its time.
struct Piece {
    mode: Mode,
    points: Vec<(f64, [f64; 2])>,
}

/// A pane: a figure that is drawn once, and once more as it is at the end, of which a film uncovers
/// more and more.
pub(crate) struct Pane {
    with: With,
    panel: Panel,
    /// Where the figure stands, and pixels to one of it.
    corner: Place,
    scale: f64,
    still: Image,
    /// With the whole motion, where that runs from left to right.
    done: Option<Image>,
    pieces: Vec<Piece>,
    /// What a unit of either axis is worth.
    units: [f64; 2],
}

impl Pane {
    /// The pane of a motion at a place of the picture.
    pub(crate) fn new(
        with: With,
        trajectory: &Trajectory,
        schedule: &Schedule,
        place: camera::Window,
        unit: f64,
        units: Option<Units>,
    ) -> Result<Self, DrawError> {
        let shown = Shown::new(with, trajectory, schedule, units);
        let size = PaneSize {
            width: libm::round(place.width),
            height: libm::round(place.height),
        };
        let scale = SCALE * unit;
        let (panel, still) = shown.draw(size, scale, false)?;
        let done = match with {
            With::Plane => None,
            With::Friction | With::Energy => Some(shown.draw(size, scale, true)?.1),
        };
        Ok(Self {
            with,
            panel,
            corner: Place::new(libm::round(place.left), libm::round(place.top)),
            scale,
            still,
            done,
            units: shown.worth(),
            pieces: shown.pieces,
        })
    }

    /// What does not change from frame to frame.
    pub(crate) fn draw_still(&self, canvas: &mut Canvas) {
        canvas.image(&self.still, self.corner, self.still.size[0]);
    }

    /// Where a place of the figure is drawn.
    fn place(&self, right: f64, down: f64) -> Place {
        self.corner.shifted(self.scale * right, self.scale * down)
    }

    /// What the motion has done up to a time.
    pub(crate) fn draw_moving(&self, canvas: &mut Canvas, sample: &Sample) {
        let time = sample.state.time;
        let [[left, top], [right, bottom]] = self.panel.axes_frame();
        let in_units = |[x, y]: [f64; 2]| [self.units[0] * x, self.units[1] * y];
        let placed = |point| self.panel.place(in_units(point).into()).unwrap_or_default();
        if let Some(done) = &self.done {
            let now = placed([time, 0.0]).x.clamp(left, right);
            canvas.image(done, self.corner, libm::round(self.scale * now) as usize);
            let corner = self.place(now - 0.7, top);
            canvas.rectangle(corner, 1.4 * self.scale, self.scale * (bottom - top), INK);
        } else {
            for piece in &self.pieces {
                let until = piece.points.iter().take_while(|(at, _)| *at <= time);
                let points: Vec<[f64; 2]> = until.map(|(_, point)| in_units(*point)).collect();
                for run in self.panel.line(&points) {
                    let run: Vec<Place> = run.into_iter().map(|[x, y]| self.place(x, y)).collect();
                    canvas.line(&run, MOTION * self.scale, of_mode(piece.mode));
                }
            }
        }
        if let Some(now) = place_of(self.with, sample).filter(|now| now[1].is_finite()) {
            let Point { x, y } = placed(now);
            let centre = self.place(x, y.clamp(top, bottom));
            canvas.disc(centre, 5.4 * self.scale, PAPER);
            canvas.disc(centre, 4.0 * self.scale, INK);
        } else if self.with == With::Friction {
            let words = if sample.mode.touches_plane() {
                "*N* = *F* = 0"
            } else {
                "no contact"
            };
            let style = Style {
                size: 12.0 * self.scale,
                is_bold: false,
                anchor: 0.5,
            };
            canvas.label(
                words,
                self.place(0.5 * (left + right), top + 16.0),
                style,
                SOFT,
            );
        }
    }
}

/// Room above and below the frame of the figure, in its pixels.
const ABOVE: f64 = 10.0;
const BELOW: f64 = 2.0;

/// Width and height of a pane, in whole pixels of the film.
#[derive(Clone, Copy)]
struct PaneSize {
    width: f64,
    height: f64,
}

/// What is drawn of a motion.
struct Shown<'a> {
    with: With,
    trajectory: &'a Trajectory,
    units: Option<Units>,
    ranges: [[f64; 2]; 2],
    pieces: Vec<Piece>,
    energies: Vec<(f64, EnergyParts)>,
}

impl<'a> Shown<'a> {
    fn new(
        with: With,
        trajectory: &'a Trajectory,
        schedule: &Schedule,
        units: Option<Units>,
    ) -> Self {
        let samples: Vec<Sample> = trajectory.sample_evenly(SAMPLES, schedule.end).collect();
        let times = [schedule.start, schedule.end.max(schedule.start + 1e-9)];
        let ledger = EnergyLedger::new(trajectory);
        let ranges = match with {
            With::Plane => [[-PI, PI], rates(&samples, trajectory)],
            With::Friction => [times, [0.0, most_demand(trajectory)]],
            With::Energy => [times, range_of_energies(ledger.as_ref(), &samples)],
        };
        Self {
            with,
            trajectory,
            units,
            ranges,
            pieces: pieces(with, &samples),
            energies: ledger.map_or_else(Vec::new, |ledger| energies(&ledger, &samples)),
        }
    }

    /// The figure in pixels and its panel, with the motion in colour where it is done.
    fn draw(&self, size: PaneSize, scale: f64, is_done: bool) -> Result<(Panel, Image), DrawError> {
        let [width, height] = [size.width, size.height].map(|side| side / scale);
        let sheet = Sheet::new(None, width)?;
        let (keys, room) = sheet.keys(self.entries(), 0.0);
        let [left, inner] = sheet.span();
        let top = room + ABOVE;
        let frame = PanelFrame {
            left,
            top,
            width: inner,
            height: height - top - BELOW,
        };
        let mut panel = Sheet::panel(frame, self.content(is_done));
        panel.keys = keys;
        let figure = sheet
            .figure("pane", "", String::new(), height, vec![panel.clone()])
            .fitted();
        let image = figure.pixels(size.width as u32, size.height as u32, scale)?;
        Ok((panel, image))
    }

    /// What a unit of either axis is worth in the units of the film.
    fn worth(&self) -> [f64; 2] {
        self.dimensions()
            .map(|dimension| self.units.map_or(1.0, |units| units.unit(dimension)))
    }

    fn dimensions(&self) -> [Dimension; 2] {
        match self.with {
            With::Plane => [Dimension::Angle, Dimension::AngularRate],
            With::Friction => [Dimension::Time, Dimension::Ratio],
            With::Energy => [Dimension::Time, Dimension::Energy],
        }
    }

    fn content(&self, is_done: bool) -> Content {
        let time = if self.units.is_some() {
            "*t*".to_owned()
        } else {
            marked(Quantity::Time.sign())
        };
        let names = match self.with {
            With::Plane => {
                [Quantity::Theta, Quantity::ThetaRate].map(|quantity| marked(quantity.sign()))
            }
            With::Friction => [time, "|*F*|/*N*".to_owned()],
            With::Energy => [time, marked(SampleColumn::Energy.sign())],
        };
        let (dimensions, worth) = (self.dimensions(), self.worth());
        let axis = |k: usize| {
            // The sign of the radian is a word.
            let unit = match dimensions[k] {
                Dimension::Angle => dimensions[k].si_sign().to_owned(),
                other => unit_sign(self.units.as_ref(), other),
            };
            let range = self.ranges[k].map(|value| worth[k] * value);
            PlotAxis::new(COLUMNS[k], with_unit(&names[k], &unit), range.into())
        };
        let (mut x, y) = (axis(0), axis(1));
        if self.with == With::Plane {
            x.scale = Scale::Angle(Vec::new());
        }
        let mut layers = match self.with {
            With::Plane => self.curves(),
            With::Friction => self.limits(),
            With::Energy => self.bands(if is_done { 1.0 } else { 0.3 }),
        };
        for piece in &self.pieces {
            let stroke = if is_done {
                Stroke::solid(of_mode(piece.mode), MOTION)
            } else {
                Stroke::solid(GRID, 1.4)
            };
            layers.push(self.layer(
                vec![piece.points.iter().map(|(_, at)| *at).collect()],
                Mark::Line(stroke),
            ));
        }
        Content {
            name: "pane",
            x,
            y,
            layers,
            labels: self.labels(),
        }
    }

    fn layer(&self, pieces: Vec<Vec<[f64; 2]>>, mark: Mark) -> Layer {
        let [right, up] = self.worth();
        let row = |[x, y]: [f64; 2]| [right * x, up * y];
        let pieces = pieces.into_iter().map(|piece| piece.into_iter().map(row));
        Series::new("", &COLUMNS, pieces).drawn(mark)
    }

    /// The curves f and n of rolling and that of lift-off, over the region of rolling.
    fn curves(&self) -> Vec<Layer> {
        let plane = PhasePlane::new(self.trajectory.hoop());
        let [x, y] = self.ranges;
        let window = Window { x, y };
        let region = self.layer(plane.rolling_region(&window), Mark::Fill(REGION));
        let lines =
            CURVES.map(|(curve, _)| self.layer(curve.pieces(&plane, &window), of_curve(curve)));
        core::iter::once(region).chain(lines).collect()
    }

    /// The coefficients of friction.
    fn friction(&self) -> [(Quantity, f64, Dash); 2] {
        let hoop = self.trajectory.hoop();
        [
            (Quantity::MuS, hoop.mu_s(), Dash::Solid),
            (Quantity::MuK, hoop.mu_k(), Dash::Dashed),
        ]
    }

    fn limits(&self) -> Vec<Layer> {
        let line = |(_, limit, dash)| {
            let stroke = Stroke {
                colour: FRICTION_FORCE,
                width: 1.6,
                dash,
            };
            self.layer(
                vec![self.ranges[0].map(|time| [time, limit]).to_vec()],
                Mark::Line(stroke),
            )
        };
        self.friction().map(line).to_vec()
    }

    fn labels(&self) -> Vec<Label> {
        if self.with != With::Friction {
            return Vec::new();
        }
        let label = |(quantity, limit, _): (Quantity, f64, Dash)| {
            // One over, the other under its line, so that they never meet.
            let down = if quantity == Quantity::MuS { -8.0 } else { 8.0 };
            let at = [self.worth()[0] * self.ranges[0][1], limit];
            // At one place in the first and in the last picture.
            let label = Label::new(marked(quantity.sign()), &at)
                .right()
                .shifted(-5.0, down)
                .fixed();
            label.sized(SMALL).coloured(FRICTION_FORCE)
        };
        self.friction().map(label).to_vec()
    }

    /// The parts of the energy one upon the other, the potential energy up to its own value.
    fn bands(&self, strength: f64) -> Vec<Layer> {
        let least = self.ranges[1][0];
        let mut lower: Vec<[f64; 2]> = self
            .energies
            .iter()
            .map(|(time, _)| [*time, least])
            .collect();
        let mut layers = Vec::new();
        for part in EnergyPart::ALL {
            let above = |([time, below], (_, parts)): (&[f64; 2], &(f64, EnergyParts))| {
                let value = part.of(parts);
                let height = match part {
                    EnergyPart::Potential => value - least,
                    EnergyPart::Kinetic
                    | EnergyPart::Friction
                    | EnergyPart::RollingResistance
                    | EnergyPart::Impacts => value,
                };
                [*time, below + height.max(0.0)]
            };
            let upper: Vec<[f64; 2]> = lower.iter().zip(&self.energies).map(above).collect();
            let area = lower.iter().chain(upper.iter().rev()).copied().collect();
            let colour = of_energy(part).over(PAPER, strength);
            layers.push(self.layer(vec![area], Mark::Fill(colour)));
            layers.push(self.layer(vec![upper.clone()], Mark::Line(Stroke::solid(PAPER, FINE))));
            lower = upper;
        }
        layers
    }

    /// The keys.
    fn entries(&self) -> Vec<(Mark, String)> {
        match self.with {
            With::Plane => CURVES
                .map(|(curve, words)| (of_curve(curve), words.to_owned()))
                .to_vec(),
            With::Friction => Vec::new(),
            With::Energy => {
                let [least, most] = self.ranges[1];
                let is_seen = |part: &EnergyPart| {
                    self.energies
                        .iter()
                        .map(|(_, parts)| part.of(parts).abs())
                        .fold(0.0, f64::max)
                        > 1e-6 * (most - least)
                };
                let key = |part: EnergyPart| (Mark::Fill(of_energy(part)), part.label().to_owned());
                EnergyPart::ALL
                    .into_iter()
                    .filter(is_seen)
                    .map(key)
                    .collect()
            }
        }
    }
}

/// The curves of the plane, and what they are called where there is little room.
const CURVES: [(Curve, &str); 3] = [
    (Curve::SlipLimit, "*f*: |*F*| = *μ*_{s}*N*"),
    (Curve::NormalForceZero, "*n*: *N* = 0"),
    (Curve::LiftOff, "lift-off"),
];

fn of_curve(curve: Curve) -> Mark {
    let stroke = Stroke::of_curve(curve);
    Mark::Line(stroke.wide(0.8 * stroke.width))
}

/// The parts of a motion in one mode. A new one also begins where the motion comes back into the
/// pane, and where θ goes beyond ±π in the plane.
fn pieces(with: With, samples: &[Sample]) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut begins = true;
    for sample in samples {
        let Some(point) = place_of(with, sample) else {
            begins = true;
            continue;
        };
        let entry = (sample.state.time, point);
        let turns = |last: [f64; 2]| with == With::Plane && (point[0] - last[0]).abs() > PI;
        let jumps = |piece: &Piece| piece.points.last().is_some_and(|(_, last)| turns(*last));
        match pieces.last_mut() {
            Some(piece) if !begins && piece.mode == sample.mode && !jumps(piece) => {
                piece.points.push(entry);
            }
            _ => pieces.push(Piece {
                mode: sample.mode,
                points: vec![entry],
            }),
        }
        begins = false;
    }
    pieces
}

/// The parts of the energy of the samples, each with its time.
fn energies(ledger: &EnergyLedger<'_>, samples: &[Sample]) -> Vec<(f64, EnergyParts)> {
    let parts = |sample: &Sample| Some((sample.state.time, ledger.parts(sample)?));
    samples.iter().filter_map(parts).collect()
}

/// Where a motion is in a pane.
fn place_of(with: With, sample: &Sample) -> Option<[f64; 2]> {
    match with {
        With::Plane => Some([wrapped(sample.state.theta), sample.state.theta_rate]),
        // |F|/N where there is a normal force.
        With::Friction => (sample.mode.touches_plane() && sample.normal > 0.0)
            .then(|| [sample.state.time, sample.friction.abs() / sample.normal]),
        With::Energy => None,
    }
}

/// The sign of a unit, with marks.
pub(crate) fn unit_sign(units: Option<&Units>, dimension: Dimension) -> String {
    if units.is_some() {
        dimension.si_sign().to_owned()
    } else {
        marked(dimension.scale_sign())
    }
}

pub(crate) fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name} / {unit}")
    }
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

fn most_demand(trajectory: &Trajectory) -> f64 {
    let most = trajectory.hoop().mu_s();
    if most > 0.0 { 1.3 * most } else { 1.0 }
}

/// The scale of the energies of a motion with a little air above; of one that does not begin, or
/// that does not move, something.
fn range_of_energies(ledger: Option<&EnergyLedger<'_>>, samples: &[Sample]) -> [f64; 2] {
    let [low, high] = ledger.map_or([0.0; 2], |ledger| ledger.scale(samples));
    let span = if high > low { high - low } else { 1.0 };
    [low, low + 1.05 * span]
}

/// The range of rates of a motion: symmetric, with the curves of rolling in sight; rates that grow
/// without bound are cut.
fn rates(samples: &[Sample], trajectory: &Trajectory) -> [f64; 2] {
    let mut rates: Vec<f64> = samples
        .iter()
        .map(|sample| sample.state.theta_rate.abs())
        .filter(|rate| rate.is_finite())
        .collect();
    rates.sort_by(f64::total_cmp);
    let most = rates.last().copied().unwrap_or(1.0);
    let usual = rates.get(rates.len() * 9 / 10).copied().unwrap_or(1.0);
    let at_top = PhasePlane::new(trajectory.hoop())
        .lift_off_rate(0.0)
        .unwrap_or(1.0);
    let high = 1.12 * most.min(2.5 * usual.max(0.5 * at_top)).max(1.3 * at_top);
    [-high, high]
}
