//! The friction that rolling demands, |F|/N, along orbits.

use core::f64::consts::{PI, TAU};

use littlewood::Mode;
use littlewood::tables::Dimension;
use littlewood::theory::{PhasePlane, RollingLaw};
use littlewood_draw::{
    Content, FRICTION_FORCE, Figure, Label, Mark, Piece, SOFT, START, Series, Stroke, short,
};

use crate::columns::{DEMAND, ENERGY, MU_S, THETA};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{bounds, horizon, instants};
use crate::plane::rows;
use littlewood::theory::Window;
use littlewood_style::width::{BOLD, CURVE};
use littlewood_style::{Curve, Dash};

const NAME: &str = "friction-demand";

/// |F|/N on the orbit of an energy, as far as it reaches and N > 0.
fn demand_on(plane: &PhasePlane, energy: f64, window: Window) -> Vec<Piece> {
    window
        .pieces(window.x, 1440, &|theta| {
            let rate = plane.level_rate(theta, energy)?;
            let forces = plane.forces(theta, rate);
            (forces.normal > 0.0).then(|| [theta, forces.friction.abs() / forces.normal])
        })
        .into_iter()
        .map(|piece| {
            piece
                .into_iter()
                .map(|[theta, demand]| vec![theta, demand, energy])
                .collect()
        })
        .collect()
}

/// The demand is shown larger where it is less than this part of the usual window.
const SMALL_SHARE: f64 = 0.08;

/// The greatest share on the orbit of an energy where N > 0.
fn highest_on(plane: &PhasePlane, energy: f64, [from, to]: [f64; 2]) -> f64 {
    (0..=720)
        .map(|i| from + (to - from) * f64::from(i) / 720.0)
        .filter_map(|theta| Some(plane.forces(theta, plane.level_rate(theta, energy)?)))
        .map(|forces| {
            if forces.normal > 0.0 {
                forces.friction.abs() / forces.normal
            } else {
                f64::INFINITY
            }
        })
        .fold(0.0, f64::max)
}

/// The turns through which a motion goes until it first leaves the plane.
fn turns_of(input: &FigureInput) -> Result<[f64; 2], FigureError> {
    let motion = input.hoop.simulate(input.start, input.limits)?;
    let until = horizon(&motion);
    let touching = motion
        .phases()
        .iter()
        .take_while(|phase| phase.mode().touches_plane());
    let angles = touching
        .flat_map(|phase| instants(&motion, phase, until))
        .map(|it| it.state.theta);
    let [from, to] = bounds(angles.chain([input.start.theta]), 0.0).map(|theta| theta / TAU);
    Ok([
        libm::floor(from),
        f64::max(libm::ceil(to), libm::floor(from) + 1.0),
    ])
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let say = input.wording();
    let (plane, law) = (PhasePlane::new(hoop), RollingLaw::new(hoop));
    let mu_s = hoop.mu_s();
    // On a slope no turn is as the one before it: those of the motion are shown.
    let turns = if hoop.slope() == 0.0 {
        [0.0, 1.0]
    } else {
        turns_of(input)?
    };
    let turn = if input.is_massless() {
        [-PI + 1e-3, PI - 1e-3]
    } else {
        turns.map(|turns| TAU * turns)
    };
    let fallen = if hoop.slope() == 0.0 {
        0.0
    } else {
        law.energy(turn[0], 0.0) - law.energy(0.0, 0.0)
    };
    let separatrix = law.separatrix_energy() + fallen;
    let start = law.energy(input.start.theta, input.start.theta_rate);
    let (first, second) = if input.is_massless() {
        (0.5 * separatrix, separatrix + 1.0)
    } else {
        (
            law.energy(PI, 0.7 * plane.separatrix_rate(PI)) + fallen,
            separatrix + hoop.offset(),
        )
    };
    let orbits = [
        ("start", start, Stroke::of_mode(Mode::Rolling).wide(BOLD)),
        (
            Curve::Separatrix.name(),
            separatrix,
            Stroke::of_curve(Curve::Separatrix),
        ),
        (
            "libration",
            first,
            Stroke::solid(SOFT, CURVE).dashed(Dash::DashDot),
        ),
        (
            "rotation",
            second,
            Stroke::solid(SOFT, CURVE).dashed(Dash::Short),
        ),
    ];
    // A heavy hoop demands so little that beside μs nothing of it would be seen.
    let highest = orbits
        .iter()
        .map(|(_, energy, _)| highest_on(&plane, *energy, turn))
        .fold(0.0, f64::max);
    let usual = f64::max(f64::min(2.4 * mu_s, 1.25 * f64::max(highest, mu_s)), 0.1);
    let is_far = !input.is_massless() && highest < SMALL_SHARE * usual && highest > 0.0;
    let most = if is_far { 1.3 * highest } else { usual };
    let window = Window {
        x: turn,
        y: [0.0, most],
    };
    let mut layers = Vec::new();
    let mut keys = Vec::new();
    // N and F of a massless hoop vanish together, and their ratio is the same on all orbits.
    let orbits = if input.is_massless() {
        &orbits[..0]
    } else {
        &orbits[..]
    };
    if input.is_massless() {
        let demand = window.pieces(window.x, 1440, &|theta| {
            Some([theta, plane.forces(theta, 0.0).demand()])
        });
        let series = Series::new("every orbit", &[THETA, DEMAND], rows(demand));
        layers.push(series.drawn(Stroke::of_mode(Mode::Rolling).wide(BOLD)));
    }
    for (name, energy, stroke) in orbits.iter().copied() {
        let series = Series::new(
            name,
            &[THETA, DEMAND, ENERGY],
            demand_on(&plane, energy, window),
        );
        layers.push(series.drawn(stroke));
        let what = if name == "start" {
            "orbit of the start"
        } else {
            name
        };
        let text = format!("{what}, *E* = {}", say.value(energy, Dimension::Energy));
        keys.push((Mark::Line(stroke), text));
    }
    layers.reverse();
    let label = if is_far {
        let text = format!("*μ*_{{s}} = {} is above", short(mu_s));
        Label::new(text, &[turn[1], most])
            .shifted(-10.0, 14.0)
            .right()
    } else {
        let limit = Series::of_rows(
            MU_S,
            &[THETA, DEMAND],
            turn.map(|theta| vec![theta, mu_s]).to_vec(),
        );
        layers.push(limit.drawn(Stroke::of_curve(Curve::SlipLimit).wide(CURVE)));
        Label::new("*μ*_{s}", &[turn[1], mu_s]).shifted(-14.0, -11.0)
    };
    let theta = input.start.theta;
    let at = if hoop.slope() == 0.0 {
        theta - TAU * libm::floor((theta - turn[0]) / TAU)
    } else {
        theta
    };
    let here_rate = if input.is_massless() {
        0.0
    } else {
        input.start.theta_rate
    };
    let here = plane.forces(input.start.theta, here_rate).demand();
    if here <= most {
        let row = vec![at, here, start];
        layers.push(Series::of_rows("start", &[THETA, DEMAND, ENERGY], vec![row]).drawn(START));
    }
    let label = label.coloured(FRICTION_FORCE);
    let y = say.axis(DEMAND, "|*F*|/*N*", [0.0, most]);
    Ok(input.sheet(620.0)?.plot(
        NAME,
        "Friction demand of rolling",
        if input.is_massless() {
            format!(
                "The ratio |*F*|/*N* in rolling of a massless hoop. It is the same on all orbits and at all rates, since *F* and \
                 *N* vanish together (3.9). Where the curve exceeds *μ*_{{s}} the hoop slips. {}; {}.",
                say.rolling(hoop),
                say.start(hoop, &input.start)
            )
        } else {
            format!(
                "The ratio |*F*|/*N* in rolling along four orbits of constant energy *E* (2.12), in either direction. Where a \
                 curve exceeds *μ*_{{s}} the hoop slips. A curve ends at the frame, where *N* = 0, or where the orbit turns.{} {}; \
                 {}.",
                if hoop.slope() == 0.0 { "" } else { " On a slope *E* counts from *θ* = 0, and each turn downhill demands more." },
                say.rolling(hoop),
                say.start(hoop, &input.start)
            )
        },
        376.0,
        Content { name: "demand", x: say.angle(turn), y, layers, labels: vec![label] },
        keys,
    ))
}
