//! A motion in the phase portrait of rolling: Figure 3's motion in the plane of Figure 2(b), and
//! that of any other hoop.

use core::f64::consts::{PI, TAU};

use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Entries, Figure, HATCH, IMPULSE, Label, Layer, Mark, Piece, REGION, SMALL, START, Series,
    Stroke, TRANSITION, lift_off_condition,
};

use crate::axes::plane_window;
use crate::columns::{THETA, THETA_RATE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{add_unbounded_end, arrows, bounds, by_mode, entries, horizon, lines, remark};
use crate::plane::Portrait;
use littlewood::theory::Window;
use littlewood_style::Curve;
use littlewood_style::width::{BOLD, CURVE, FINE};

const NAME: &str = "phase-path";
const COLUMNS: [&str; 3] = [TIME, THETA, THETA_RATE];
/// Least and greatest width of the window: one turn and a half, and four turns.
const WIDTHS: [f64; 2] = [3.0 * PI, 4.0 * TAU];
/// Greatest rate that is shown of Littlewood's hoop, whose rate has no bound.
const LITTLEWOOD: f64 = 2.5;
/// Arrows of time stand where the motion goes this part of the window.
const LEAST_STEP: f64 = 0.004;
/// Beyond this part of the window a name stands to the left of its dot.
const LAST: f64 = 0.85;
/// Transitions that all have a name.
const NAMED: usize = 6;

/// Its row, the angle less whole turns.
fn row(sample: &Sample, turns: f64) -> Vec<f64> {
    vec![
        sample.state.time,
        sample.state.theta - turns,
        sample.state.theta_rate,
    ]
}

/// The part of the plane in which a motion is seen.
fn window_of(input: &FigureInput, rows: &[Vec<f64>]) -> Window {
    let first = input.start.theta_rate.abs();
    if input.is_massless() && input.hoop.offset() == 1.0 {
        let most = f64::max(LITTLEWOOD, 1.08 * first);
        return Window {
            x: [-PI, PI],
            y: [-most, most],
        };
    }
    let [low, high] = bounds(rows.iter().map(|row| row[1]), 0.05);
    let from = rows.first().map_or(0.0, |row| row[1]);
    let most = WIDTHS[1];
    let x = match high - low {
        wide if wide > most && from > 0.5 * (low + high) => {
            [from - 0.95 * most, from + 0.05 * most]
        }
        wide if wide > most => [from - 0.05 * most, from + 0.95 * most],
        wide if wide < WIDTHS[0] => [-0.5, 0.5].map(|share| 0.5 * (low + high) + share * WIDTHS[0]),
        _ => [low, high],
    };
    let fastest = rows.iter().map(|row| row[2].abs()).fold(0.0, f64::max);
    // The rate of a massless hoop may grow out of all proportion at the end.
    let fastest = if input.is_massless() { first } else { fastest };
    let most = f64::max(plane_window(&input.hoop).y[1], 1.08 * fastest);
    Window {
        x,
        y: [-most, most],
    }
}

fn is_inside(window: Window, row: &[f64]) -> bool {
    (window.x[0]..=window.x[1]).contains(&row[1]) && (window.y[0]..=window.y[1]).contains(&row[2])
}

/// Each piece, cut where it leaves the window to the left or to the right.
fn inside(series: Series, window: Window) -> Series {
    let pieces = series.pieces.iter().flat_map(|piece| {
        piece
            .split(|row| !(window.x[0]..=window.x[1]).contains(&row[1]))
            .filter(|part| part.len() > 1)
            .map(<[Vec<f64>]>::to_vec)
    });
    let pieces = pieces.collect();
    Series { pieces, ..series }
}

/// What rolling does in the plane: orbits, and the curves that bound it, with their keys.
fn ground(portrait: &Portrait, input: &FigureInput) -> Result<(Vec<Layer>, Entries), FigureError> {
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    let mut keys = Vec::new();
    if !input.is_massless() {
        layers.push(portrait.unloaded().drawn(Mark::Hatch(HATCH)));
    }
    if !(input.is_massless() && input.hoop.offset() == 1.0) {
        let orbit = |energy| portrait.orbit(energy).drawn(Curve::Level);
        layers.extend(portrait.energies(2, 4).into_iter().map(orbit));
    }
    layers.push(
        portrait
            .separatrix()
            .drawn(Stroke::of_curve(Curve::Separatrix).wide(FINE)),
    );
    let slip = if input.is_massless() {
        portrait.massless_limit().map(|(_, series)| series)
    } else {
        Some(portrait.slip_locus(input.hoop.mu_s())?)
    };
    let curves = [
        (slip, Curve::SlipLimit, "*f*: |*F*| = *μ*_{s}*N*".to_owned()),
        (
            Some(portrait.lift_off_locus()).filter(|_| !input.is_massless()),
            Curve::LiftOff,
            lift_off_condition(input.hoop.slope()),
        ),
        (
            Some(portrait.unloading_locus()),
            Curve::NormalForceZero,
            "*n*: *N* = 0".to_owned(),
        ),
    ];
    for (series, curve, words) in curves {
        let Some(series) = series.filter(|series| !series.pieces.is_empty()) else {
            continue;
        };
        // Less than in the portrait alone: what matters here is the motion.
        let mark = Mark::Line(Stroke::of_curve(curve).wide(CURVE));
        layers.push(series.drawn(mark));
        keys.push((mark, words));
    }
    layers.extend(portrait.equilibria());
    Ok((layers, keys))
}

/// Dots at the transitions with their names, and impacts, in which the rate jumps.
fn changes(motion: &Trajectory, turns: f64, window: Window) -> (Vec<Layer>, Vec<Label>) {
    let until = horizon(motion);
    let (mut dots, mut jumps, mut labels) = (Vec::new(), Vec::new(), Vec::new());
    for transition in motion
        .transitions()
        .iter()
        .filter(|transition| transition.time() <= until)
    {
        let [before, after] = [transition.before, transition.after]
            .map(|state| vec![state.time, state.theta - turns, state.theta_rate]);
        if !is_inside(window, &before) {
            continue;
        }
        let label = Label::new(transition.cause.label(), &before[1..]).sized(SMALL);
        let is_last = before[1] > window.x[0] + LAST * (window.x[1] - window.x[0]);
        labels.push(if is_last {
            label.shifted(-5.0, -12.0).right()
        } else {
            label.shifted(7.0, -10.0).left()
        });
        if transition.impact.is_some() && is_inside(window, &after) {
            jumps.push(vec![before.clone(), after]);
        }
        dots.push(before);
    }
    if labels.len() > NAMED {
        labels.clear();
    }
    let mut layers = Vec::new();
    if !jumps.is_empty() {
        let mark = Mark::Line(Stroke::solid(IMPULSE, BOLD));
        layers.push(Series::new("impact", &COLUMNS, jumps).drawn(mark));
    }
    layers.push(Series::of_rows("transition", &COLUMNS, dots).drawn(TRANSITION));
    (layers, labels)
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let turns = TAU * libm::round(motion.start().theta / TAU);
    // The portrait has a period of a turn: only the place of Littlewood's hoop, which has none, is
    // moved.
    let turns = if input.is_massless() && hoop.offset() == 1.0 {
        turns
    } else {
        0.0
    };
    let row = |sample: &Sample| row(sample, turns);
    let mut modes: Vec<(Mode, Series)> = by_mode(&motion, "", &COLUMNS, &row);
    let mut all: Piece = modes
        .iter()
        .flat_map(|(_, series)| series.rows())
        .map(<[f64]>::to_vec)
        .collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let window = window_of(input, &all);
    let portrait = Portrait::new(hoop, window);
    let (mut layers, curves) = ground(&portrait, input)?;
    let mut keys = entries(&modes, |mode| mode.to_string());
    if motion
        .transitions()
        .iter()
        .any(|transition| transition.time() <= horizon(&motion))
    {
        keys.push((TRANSITION, "transition".to_owned()));
    }
    keys.extend(curves);
    add_unbounded_end(&motion, &mut modes, &row);
    let modes = modes
        .into_iter()
        .map(|(mode, series)| (mode, inside(series, window)));
    layers.extend(lines(modes.collect(), BOLD).map(Layer::marked_beyond));
    layers.extend(arrows(&motion, 0.5, &COLUMNS, &row, |_, rows| {
        let part = |i: usize, range: [f64; 2]| (rows[1][i] - rows[0][i]) / (range[1] - range[0]);
        is_inside(window, &rows[0])
            && libm::hypot(part(1, window.x), part(2, window.y)) > LEAST_STEP
    }));
    let (dots, labels) = changes(&motion, turns, window);
    layers.extend(dots);
    let start = motion.start();
    let start = vec![start.time, start.theta - turns, start.theta_rate];
    layers.push(Series::of_rows("start", &COLUMNS, vec![start]).drawn(START));
    let say = input.wording();
    let is_short = all
        .iter()
        .any(|row| !(window.x[0]..=window.x[1]).contains(&row[1]));
    let caption = format!(
        "The motion in the plane of rolling. In 𝓡 (shaded) rolling follows an orbit, a line of constant energy (grey). Sliding and \
         flight, which have *η*′ ≠ 0, are projected onto this plane. Cross: start; diamonds: transitions; arrows: time; dots and \
         rings: stable and unstable equilibria.{} {}.",
        portrait.remark(),
        input.in_words()
    );
    let axes = portrait.axes(say);
    let titles = [NAME, "A motion in the phase portrait"];
    let figure = input.plane(titles, caption, axes, (layers, labels), keys)?;
    let turns = is_short.then(|| "Shown are the first turns.".to_owned());
    Ok(figure.noted(turns).noted(remark(&motion, say)))
}
