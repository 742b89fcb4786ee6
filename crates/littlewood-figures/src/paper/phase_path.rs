//! A motion in the phase portrait of rolling: Figure 3's motion in the plane of Figure 2(b), and
//! that of any other hoop.

use core::f64::consts::{PI, TAU};

use littlewood::theory::Window;
use littlewood::{Sample, State, Transition};
use littlewood_draw::{
    Entries, Figure, HATCH, IMPULSE, Label, Layer, Mark, Piece, REGION, SMALL, START, Series,
    Stroke, TRANSITION, key_of_curve, lift_off_condition,
};
use littlewood_style::Curve;
use littlewood_style::width::{BOLD, CURVE, FINE};

use crate::axes::{littlewood_window, plane_window};
use crate::columns::{THETA, THETA_RATE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds};
use crate::plane::{Orbits, Portrait};

const NAME: &str = "phase-path";
const COLUMNS: [&str; 3] = [TIME, THETA, THETA_RATE];
/// Least and greatest width of the window: one turn and a half, and four turns.
const WIDTHS: [f64; 2] = [3.0 * PI, 4.0 * TAU];
/// The width of a motion that is small in the plane.
const SWING: f64 = PI;
/// Arrows of time stand where the motion goes this part of the window.
const LEAST_STEP: f64 = 0.004;
/// Beyond this part of the window a name stands to the left of its dot.
const LAST: f64 = 0.85;
/// Transitions that all have a name.
const NAMED: usize = 6;

/// The row of a state, its angle less whole turns.
fn row_of(state: &State, turns: f64) -> [f64; 3] {
    [state.time, state.theta - turns, state.theta_rate]
}

/// The part of the plane in which a motion is seen.
fn window_of(input: &FigureInput, rows: &[Vec<f64>]) -> Window {
    let first = input.start.theta_rate.abs();
    if input.is_massless() && input.hoop.offset() == 1.0 {
        return littlewood_window(first);
    }
    let [low, high] = bounds(rows.iter().map(|row| row[1]), 0.05);
    let swings = rows.iter().map(|row| row[2].abs()).fold(0.0, f64::max);
    // What comes to rest in a small part of the plane is seen there, with the band.
    if input.hoop.rolling_resistance() > 0.0 && high - low < SWING && swings > 0.0 {
        let (middle, half) = (0.5 * (low + high), 0.8 * (high - low));
        return Window {
            x: [middle - half, middle + half],
            y: [-1.5 * swings, 1.5 * swings],
        };
    }
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

/// Cuts each piece where it leaves the window to the left or to the right.
fn cut(series: &mut Series, window: Window) {
    let is_out = |row: &Vec<f64>| !(window.x[0]..=window.x[1]).contains(&row[1]);
    let parts = series.pieces.iter().flat_map(|piece| piece.split(is_out));
    let parts = parts.filter(|part| part.len() > 1);
    series.pieces = parts.map(<[Vec<f64>]>::to_vec).collect();
}

/// What rolling does in the plane: orbits, and the curves that bound it, with their keys.
fn ground(portrait: &Portrait, input: &FigureInput) -> Result<(Vec<Layer>, Entries), FigureError> {
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    let mut keys = Vec::new();
    if !input.is_massless() {
        layers.push(portrait.unloaded().drawn(Mark::Hatch(HATCH)));
    }
    let is_rim = input.is_massless() && input.hoop.offset() == 1.0;
    let orbits = if is_rim && !portrait.resists() {
        Orbits::Levels(Vec::new())
    } else {
        portrait.choose(2, 4)
    };
    layers.extend(portrait.orbits(&orbits, FINE));
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
    if portrait.band_of_rest().is_some() {
        keys.push(key_of_curve(Curve::BandOfRest, input.hoop.slope()));
    }
    layers.extend(portrait.equilibria());
    Ok((layers, keys))
}

/// Dots at the transitions with their names, and impacts, in which the rate jumps.
fn changes(motion: &Shown, turns: f64, window: Window) -> (Vec<Layer>, Vec<Label>) {
    let (mut dots, mut jumps, mut labels) = (Vec::new(), Vec::new(), Vec::new());
    for transition in motion.passed() {
        let before = row_of(&transition.before, turns);
        let after = row_of(&transition.after, turns);
        if !is_inside(window, &before) {
            continue;
        }
        let label = Label::new(transition.cause.label(), &before[1..])
            .sized(SMALL)
            .led();
        let is_last = before[1] > window.x[0] + LAST * (window.x[1] - window.x[0]);
        labels.push(if is_last {
            label.shifted(-5.0, -12.0).right()
        } else {
            label.shifted(7.0, -10.0).left()
        });
        if transition.impact.is_some() && is_inside(window, &after) {
            jumps.push([before, after]);
        }
        dots.push(before);
    }
    if labels.len() > NAMED {
        labels.clear();
    }
    let mut layers = Vec::new();
    if !jumps.is_empty() {
        let series = Series::new("impact", &COLUMNS, jumps);
        layers.push(series.drawn(Stroke::solid(IMPULSE, BOLD)));
    }
    layers.push(Series::of_rows("transition", &COLUMNS, dots).drawn(TRANSITION));
    (layers, labels)
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    // The portrait has a period of a turn: only the place of Littlewood's hoop, which has none, is
    // moved.
    let turns = if input.is_massless() && hoop.offset() == 1.0 {
        TAU * libm::round(motion.start().theta / TAU)
    } else {
        0.0
    };
    let row = |sample: &Sample| row_of(&sample.state, turns);
    let mut modes = motion.by_mode("", &COLUMNS, row);
    let mut all: Piece = modes.rows().map(<[f64]>::to_vec).collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let window = window_of(input, &all);
    let portrait = Portrait::new(hoop, window);
    let (mut layers, curves) = ground(&portrait, input)?;
    let mut seen = modes.clone();
    seen.0.retain(|(_, series)| {
        let pairs = series.pieces.iter().flat_map(|piece| piece.windows(2));
        pairs.flatten().any(|row| is_inside(window, row))
    });
    let mut keys = seen.entries(|mode| mode.to_string());
    let is_seen = |transition: &Transition| is_inside(window, &row_of(&transition.before, turns));
    if motion.passed().any(is_seen) {
        keys.push((TRANSITION, "transition".to_owned()));
    }
    keys.extend(curves);
    modes.add_unbounded_end(&motion, row);
    for (_, series) in &mut modes.0 {
        cut(series, window);
    }
    layers.extend(modes.lines(BOLD).map(Layer::marked_beyond));
    layers.extend(motion.arrows(0.5, &COLUMNS, row, |_, [from, to]| {
        let part = |i: usize, range: [f64; 2]| (to[i] - from[i]) / (range[1] - range[0]);
        is_inside(window, from) && libm::hypot(part(1, window.x), part(2, window.y)) > LEAST_STEP
    }));
    let (dots, labels) = changes(&motion, turns, window);
    layers.extend(dots);
    let start = row_of(&motion.start(), turns);
    layers.push(Series::of_rows("start", &COLUMNS, [start]).drawn(START));
    let (orbits, rest) = if portrait.resists() {
        (
            "an orbit (grey), along which rolling resistance takes energy",
            "thick: band of rest",
        )
    } else {
        (
            "an orbit, a line of constant energy (grey)",
            "dots and rings: stable and unstable equilibria",
        )
    };
    let caption = format!(
        "The motion in the plane of rolling. In 𝓡 (shaded) rolling follows {orbits}. Sliding and \
         flight, which have *η*′ ≠ 0, are projected onto this plane. Cross: start; diamonds: transitions; arrows: time; {rest}.{} {}.",
        portrait.remark(),
        input.in_words()
    );
    let title = "A motion in the phase portrait";
    let content = portrait.content("plane", motion.say, layers, labels);
    let figure = input.plane(NAME, title, caption, content, keys)?;
    let is_out = |row: &Vec<f64>| !(window.x[0]..=window.x[1]).contains(&row[1]);
    let is_short = all.iter().any(is_out);
    let turns = is_short.then(|| "Shown are the first turns.".to_owned());
    Ok(figure.noted(turns).noted(motion.remark()))
}
