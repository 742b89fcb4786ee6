//! The friction that rolling demands, |F|/N, along orbits.

use core::f64::consts::{PI, TAU};

use littlewood::Mode;
use littlewood::tables::Dimension;
use littlewood::theory::{PhasePlane, RollingLaw, Window};
use littlewood_draw::{
    Content, Entries, FRICTION_FORCE, Figure, Label, Layer, Mark, SOFT, START, Series, Stroke,
    short,
};
use littlewood_style::width::{BOLD, CURVE};
use littlewood_style::{Curve, Dash};

use crate::columns::{DEMAND, ENERGY, MU_S, THETA};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds};
use crate::plane::rows_with;

const NAME: &str = "friction-demand";

/// The demand is shown larger where it is less than this part of the usual window.
const SMALL_SHARE: f64 = 0.08;
/// Intervals in which a curve is looked for.
const CELLS: u32 = 1440;

/// An orbit along which the demand is shown.
struct Orbit {
    name: &'static str,
    energy: f64,
    stroke: Stroke,
}

/// The plane of a hoop, and the turns that are shown.
struct Demand<'a> {
    input: &'a FigureInput,
    plane: PhasePlane,
    law: RollingLaw,
    turn: [f64; 2],
}

impl<'a> Demand<'a> {
    fn new(input: &'a FigureInput) -> Result<Self, FigureError> {
        let turn = if input.is_massless() {
            [-PI + 1e-3, PI - 1e-3]
        } else if input.hoop.slope() == 0.0 {
            [0.0, TAU]
        } else {
            // No turn is as the one before it: those of the motion are shown.
            turns_of(input)?.map(|turns| TAU * turns)
        };
        Ok(Self {
            input,
            plane: PhasePlane::new(&input.hoop),
            law: RollingLaw::new(&input.hoop),
            turn,
        })
    }

    /// |F|/N on the orbit of an energy, as far as it reaches; infinite where N ≤ 0.
    fn at(&self, theta: f64, energy: f64) -> Option<f64> {
        let forces = self
            .plane
            .forces(theta, self.plane.level_rate(theta, energy)?);
        Some(if forces.normal > 0.0 {
            forces.friction.abs() / forces.normal
        } else {
            f64::INFINITY
        })
    }

    /// The energy of the start.
    fn energy(&self) -> f64 {
        let start = self.input.start;
        self.law.energy(start.theta, start.theta_rate)
    }

    /// The orbit of the start, the separatrix, and one on either side of it; of a massless hoop
    /// none: N and F vanish together, and their ratio is the same on all orbits.
    fn orbits(&self) -> Vec<Orbit> {
        if self.input.is_massless() {
            return Vec::new();
        }
        let hoop = &self.input.hoop;
        let fallen = if hoop.slope() == 0.0 {
            0.0
        } else {
            self.law.energy(self.turn[0], 0.0) - self.law.energy(0.0, 0.0)
        };
        let separatrix = self.law.separatrix_energy() + fallen;
        let slow = self.law.energy(PI, 0.7 * self.plane.separatrix_rate(PI));
        let orbit = |name, energy, stroke| Orbit {
            name,
            energy,
            stroke,
        };
        let thin = |dash| Stroke::solid(SOFT, CURVE).dashed(dash);
        vec![
            orbit(
                "start",
                self.energy(),
                Stroke::of_mode(Mode::Rolling).wide(BOLD),
            ),
            orbit(
                Curve::Separatrix.name(),
                separatrix,
                Stroke::of_curve(Curve::Separatrix),
            ),
            orbit("libration", slow + fallen, thin(Dash::DashDot)),
            orbit("rotation", separatrix + hoop.offset(), thin(Dash::Short)),
        ]
    }

    /// The greatest demand on orbits; that of a massless hoop has no bound.
    fn highest(&self, orbits: &[Orbit]) -> f64 {
        if orbits.is_empty() {
            return f64::INFINITY;
        }
        let [from, to] = self.turn;
        let angles = (0..=720).map(|i| from + (to - from) * f64::from(i) / 720.0);
        let demands = angles.flat_map(|theta| orbits.iter().map(move |it| (theta, it.energy)));
        demands
            .filter_map(|(theta, energy)| self.at(theta, energy))
            .fold(0.0, f64::max)
    }

    /// The curves, the lowest first, with their keys.
    fn curves(&self, orbits: &[Orbit], window: Window) -> (Vec<Layer>, Entries) {
        let (mut layers, mut keys) = (Vec::new(), Vec::new());
        if self.input.is_massless() {
            let demand = |theta| Some([theta, self.plane.forces(theta, 0.0).demand()]);
            let pieces = window.pieces(window.x, CELLS, &demand);
            let series = Series::new("every orbit", &[THETA, DEMAND], pieces);
            layers.push(series.drawn(Stroke::of_mode(Mode::Rolling).wide(BOLD)));
        }
        for Orbit {
            name,
            energy,
            stroke,
        } in orbits.iter().rev()
        {
            let demand = |theta| {
                let demand = self
                    .at(theta, *energy)
                    .filter(|demand| demand.is_finite())?;
                Some([theta, demand])
            };
            let pieces = rows_with(window.pieces(window.x, CELLS, &demand), *energy);
            layers.push(Series::new(*name, &[THETA, DEMAND, ENERGY], pieces).drawn(*stroke));
            let what = if *name == "start" {
                "orbit of the start"
            } else {
                name
            };
            let energy = self.input.wording().value(*energy, Dimension::Energy);
            keys.insert(0, (Mark::Line(*stroke), format!("{what}, *E* = {energy}")));
        }
        (layers, keys)
    }

    /// The start, with the demand there.
    fn start(&self) -> [f64; 2] {
        let start = self.input.start;
        let rate = if self.input.is_massless() {
            0.0
        } else {
            start.theta_rate
        };
        let theta = if self.input.hoop.slope() == 0.0 {
            start.theta - TAU * libm::floor((start.theta - self.turn[0]) / TAU)
        } else {
            start.theta
        };
        [theta, self.plane.forces(start.theta, rate).demand()]
    }
}

/// The turns through which a motion goes until it first leaves the plane.
fn turns_of(input: &FigureInput) -> Result<[f64; 2], FigureError> {
    let motion = input.hoop.simulate(input.start, input.limits)?;
    let motion = Shown::new(motion, input.wording());
    let phases = motion.phases().iter();
    let touching = phases.take_while(|phase| phase.mode().touches_plane());
    let angles = touching
        .flat_map(|phase| motion.instants(phase))
        .map(|it| it.state.theta);
    let [from, to] = bounds(angles.chain([input.start.theta]), 0.0).map(|theta| theta / TAU);
    Ok([
        libm::floor(from),
        f64::max(libm::ceil(to), libm::floor(from) + 1.0),
    ])
}

fn caption(input: &FigureInput) -> String {
    let (hoop, say) = (&input.hoop, input.wording());
    let text = if input.is_massless() {
        "The ratio |*F*|/*N* in rolling of a massless hoop. It is the same on all orbits and at all rates, since *F* and \
         *N* vanish together (3.9). Where the curve exceeds *μ*_{s} the hoop slips."
    } else {
        "The ratio |*F*|/*N* in rolling along four orbits of constant energy *E* (2.12), in either direction. Where a \
         curve exceeds *μ*_{s} the hoop slips. A curve ends at the frame, where *N* = 0, or where the orbit turns."
    };
    let downhill = if input.is_massless() || hoop.slope() == 0.0 {
        ""
    } else {
        " On a slope *E* counts from *θ* = 0, and each turn downhill demands more."
    };
    let start = say.start(hoop, &input.start);
    format!("{text}{downhill} {}; {start}.", say.rolling(hoop))
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let (say, mu_s) = (input.wording(), input.hoop.mu_s());
    let demand = Demand::new(input)?;
    let (orbits, turn) = (demand.orbits(), demand.turn);
    // A heavy hoop demands so little that beside μs nothing of it would be seen.
    let highest = demand.highest(&orbits);
    let usual = f64::max(f64::min(2.4 * mu_s, 1.25 * f64::max(highest, mu_s)), 0.1);
    let is_far = highest < SMALL_SHARE * usual && highest > 0.0;
    let most = if is_far { 1.3 * highest } else { usual };
    let window = Window {
        x: turn,
        y: [0.0, most],
    };
    let (mut layers, keys) = demand.curves(&orbits, window);
    let label = if is_far {
        let text = format!("*μ*_{{s}} = {} is above", short(mu_s));
        let label = Label::new(text, &[turn[1], most]).shifted(-10.0, 14.0);
        label.right()
    } else {
        let rows = turn.map(|theta| [theta, mu_s]);
        let limit = Series::of_rows(MU_S, &[THETA, DEMAND], rows);
        layers.push(limit.drawn(Stroke::of_curve(Curve::SlipLimit).wide(CURVE)));
        Label::new("*μ*_{s}", &[turn[1], mu_s]).shifted(-14.0, -11.0)
    };
    let [theta, here] = demand.start();
    if here <= most {
        let row = [theta, here, demand.energy()];
        layers.push(Series::of_rows("start", &[THETA, DEMAND, ENERGY], [row]).drawn(START));
    }
    let content = Content {
        name: "demand",
        x: say.angle(turn),
        y: say.axis(DEMAND, "|*F*|/*N*", window.y),
        layers,
        labels: vec![label.coloured(FRICTION_FORCE)],
    };
    let title = "Friction demand of rolling";
    let sheet = input.sheet(620.0)?;
    Ok(sheet.plot(NAME, title, caption(input), 376.0, content, keys))
}
