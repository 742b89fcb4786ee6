//! The friction cone: friction against normal force along a motion.

use littlewood::tables::{Dimension, SampleColumn};
use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Figure, IMPULSE, Label, Layer, Mark, REGION, SMALL, SOFT, START, Series, Stroke, TRANSITION,
    marked,
};

use crate::columns::{FRICTION, MU_K, MU_S, NORMAL, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{bounds, by_mode, heads, horizon, remark};
use crate::spikes::Spikes;
use crate::wording::Wording;
use littlewood::theory::Window;
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash};

const NAME: &str = "hodograph";
const COLUMNS: [&str; 3] = [TIME, NORMAL, FRICTION];
/// Forces that change by less than this part of the largest are shown larger, without the origin.
const SMALL_SHARE: f64 = 0.1;
/// Arrows of time and jumps are drawn where they are longer than this part of the window.
const LEAST_STEP: f64 = 0.004;
const LEAST_JUMP: f64 = 0.02;
/// Forces that are less than this part of the largest have their names to the left.
const POINT: f64 = 0.03;
/// Transitions that all have a name.
const NAMED: usize = 6;

fn row(sample: &Sample) -> Vec<f64> {
    vec![sample.state.time, sample.normal, sample.friction]
}

/// The part of the plane of forces in which a motion is seen.
fn window_of(rows: &[Vec<f64>], mu_s: f64) -> Window {
    let normals = || rows.iter().map(|row| row[1]);
    let frictions = || rows.iter().map(|row| row[2]);
    let most = normals().fold(0.0, f64::max);
    let least = normals().fold(f64::INFINITY, f64::min);
    let is_level = most - least < SMALL_SHARE * most;
    let x = if is_level { bounds(normals(), 0.15) } else { [-0.13 * most, 1.08 * most] };
    let limit = mu_s * most;
    let largest = frictions().map(f64::abs).fold(0.0, f64::max);
    let is_small = largest < SMALL_SHARE * limit;
    let y = match (is_level, is_small) {
        // Both cones are far away.
        (_, true) => bounds(frictions().chain([0.0]), 0.15),
        (true, false) => bounds(frictions(), 0.15),
        (false, false) => [-1.12 * limit, 1.12 * limit],
    };
    // Without friction there is none.
    let y = if y[1] - y[0] > 0.2 * most.min(1.0) || largest > 0.0 { y } else { [-0.5 * most, 0.5 * most] };
    Window { x, y }
}

/// The two lines |F| = μ N, as far as they are seen.
fn cone(window: Window, name: &'static str, mu: f64) -> Series {
    let pieces = [1.0, -1.0].into_iter().flat_map(|sign| {
        let from = f64::max(window.x[0], 0.0);
        window.pieces([from, window.x[1]], 64, &|normal| Some([normal, sign * mu * normal]))
    });
    let rows = pieces.map(|piece| piece.into_iter().map(Vec::from).collect()).collect();
    Series::new(name, &COLUMNS[1..], rows)
}

/// The inside of the cone |F| ≤ μs N, as far as it is seen.
fn inside(window: Window, mu: f64) -> Series {
    let Window { x: [left, right], y: [low, high] } = window;
    let left = f64::max(left, 0.0);
    // Where the lines enter and leave the window.
    let mut stops = vec![left, right];
    stops.extend([low, high].into_iter().filter(|_| mu > 0.0).map(|edge| edge.abs() / mu));
    stops.retain(|normal| (left..=right).contains(normal));
    stops.sort_by(f64::total_cmp);
    let edge = |sign: f64| {
        let cut = move |normal: f64| vec![normal, (sign * mu * normal).clamp(low, high)];
        stops.iter().map(move |normal| cut(*normal)).collect::<Vec<_>>()
    };
    let mut polygon = edge(1.0);
    polygon.extend(edge(-1.0).into_iter().rev());
    Series::of_rows("inside of the cone", &COLUMNS[1..], polygon)
}

/// From the last forces of a phase to the first of the next, where they jump.
fn jumps(motion: &Trajectory, window: Window) -> Vec<Vec<Vec<f64>>> {
    let until = horizon(motion);
    let pairs = motion.phases().windows(2).filter(|pair| {
        let is_seen = pair[1].start().time < until;
        // Before an impact and after it the forces are those of flights.
        is_seen && motion.end_of(&pair[0]).is_some_and(|transition| transition.impact.is_none())
    });
    pairs
        .filter_map(|pair| Some(vec![row(&pair[0].last()?), row(&pair[1].first())]))
        .filter(|rows| length(rows, window) > LEAST_JUMP)
        .collect()
}

/// Length of a step in parts of the window.
fn length(rows: &[Vec<f64>], window: Window) -> f64 {
    let part = |i: usize, range: [f64; 2]| (rows[1][i] - rows[0][i]) / (range[1] - range[0]);
    libm::hypot(part(1, window.x), part(2, window.y))
}

/// Dots at the ends of phases, with their names if they are few.
fn changes(motion: &Trajectory, largest: f64) -> (Layer, Vec<Label>) {
    let until = horizon(motion);
    let ends: Vec<(&'static str, Vec<f64>)> = motion
        .phases()
        .iter()
        .filter(|phase| phase.mode().has_normal_force())
        .filter_map(|phase| Some((motion.end_of(phase)?, phase.last()?)))
        .filter(|(transition, _)| transition.time() <= until)
        .map(|(transition, sample)| (transition.cause.label(), row(&sample)))
        .collect();
    let labels = if ends.len() > NAMED { &[][..] } else { &ends[..] };
    let labels = labels.iter().map(|(name, row)| {
        let up = if row[2] < 0.0 { 13.0 } else { -12.0 };
        let label = Label::new(*name, &row[1..]).sized(SMALL);
        // Before the point of the cone.
        if row[1] <= POINT * largest {
            label.shifted(10.0, up).right()
        } else {
            label.shifted(6.0, up).left()
        }
    });
    let labels = labels.collect();
    let rows = ends.into_iter().map(|(_, row)| row).collect();
    (Series::of_rows("transition", &COLUMNS, rows).drawn(TRANSITION), labels)
}

/// The impulses as dots, which lie in the cones as forces do.
fn of_impulses(spikes: &Spikes) -> Option<Layer> {
    let rows: Vec<Vec<f64>> = spikes
        .impulses
        .iter()
        .map(|(time, impulse)| vec![*time, spikes.scale * impulse.normal, spikes.scale * impulse.friction])
        .collect();
    (!rows.is_empty()).then(|| Series::of_rows("impulse", &COLUMNS, rows).drawn(Mark::Dot(IMPULSE, 2.8)))
}

fn in_words(spikes: &Spikes, say: Wording) -> String {
    if spikes.impulses.is_empty() {
        return String::new();
    }
    format!(
        " Red dots: the impulses (*P*, *J*) of the impacts, which lie in the same cones, {} as far from the origin as {}.",
        say.quantity(1.0, Dimension::Impulse),
        say.quantity(spikes.scale, Dimension::Force)
    )
}

/// Friction against normal force.
pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion_in_contact(NAME)?;
    let hoop = motion.hoop();
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    let in_contact: Vec<(Mode, Series)> = by_mode(&motion, "", &COLUMNS, &row)
        .into_iter()
        .filter(|(mode, _)| mode.has_normal_force())
        .collect();
    let largest = in_contact.iter().flat_map(|(_, series)| series.rows()).map(|row| row[1]);
    let spikes = Spikes::new(&motion, largest.fold(hoop.mass(), f64::max));
    let impulses = of_impulses(&spikes);
    let mut all: Vec<Vec<f64>> =
        in_contact.iter().flat_map(|(_, series)| series.rows()).map(<[f64]>::to_vec).collect();
    all.extend(impulses.iter().flat_map(|layer| layer.series.rows().map(<[f64]>::to_vec)));
    if all.iter().all(|row| row[1] <= 0.0) {
        return Err(FigureError::NoForce { figure: NAME, outcome: motion.outcome().kind() });
    }
    let window = window_of(&all, mu_s);

    let limit = Stroke::of_curve(Curve::SlipLimit).wide(CURVE);
    let cones = [
        (cone(window, MU_S, mu_s).drawn(Mark::Line(limit)), "*μ*_{s}"),
        (cone(window, MU_K, mu_k).drawn(Mark::Line(limit.dashed(Dash::Dotted))), "*μ*_{k}"),
    ];
    let mut layers = vec![inside(window, mu_s).drawn(Mark::Fill(REGION))];
    if window.x[0] < 0.0 {
        let axis = [vec![window.x[0], 0.0], vec![window.x[1], 0.0]].to_vec();
        let upright = [vec![0.0, window.y[0]], vec![0.0, window.y[1]]].to_vec();
        let zero = Series::new("zero", &COLUMNS[1..], vec![axis, upright]);
        layers.push(zero.drawn(Mark::Line(Stroke::solid(SOFT, FINE))));
    }
    let mut keys: Vec<(Mark, String)> = in_contact
        .iter()
        .map(|(mode, _)| (Mark::Line(Stroke::of_mode(*mode).wide(BOLD)), mode.to_string()))
        .collect();
    let mut is_seen = false;
    // With μs = μk there is one cone.
    for (layer, letter) in cones.into_iter().take(if mu_k < mu_s { 2 } else { 1 }) {
        if !layer.series.pieces.is_empty() && mu_s > 0.0 {
            is_seen = true;
            keys.push((layer.mark, format!("|*F*| = {letter}*N*")));
            layers.push(layer);
        }
    }
    let jumps = jumps(&motion, window);
    if !jumps.is_empty() {
        let mark = Mark::Arrow(Stroke::solid(SOFT, FINE).dashed(Dash::Short));
        keys.push((Mark::Line(Stroke::solid(SOFT, FINE).dashed(Dash::Short)), "jump".to_owned()));
        layers.push(Series::new("jump", &COLUMNS, jumps).drawn(mark));
    }
    for (mode, series) in in_contact {
        layers.push(series.drawn(Mark::Line(Stroke::of_mode(mode).wide(BOLD))));
    }
    for (mode, rows) in heads(&motion, 0.45, &row) {
        if mode.has_normal_force() && length(&rows, window) > LEAST_STEP {
            let mark = Mark::Head(Stroke::of_mode(mode).colour);
            layers.push(Series::new("arrow of time", &COLUMNS, vec![rows]).drawn(mark));
        }
    }
    if let Some(layer) = impulses {
        keys.push((layer.mark, "impulse".to_owned()));
        layers.push(layer);
    }
    let (dots, labels) = changes(&motion, window.x[1]);
    layers.push(dots);
    if let Some(first) = motion.phases().first().filter(|phase| phase.mode().has_normal_force()) {
        let start = Series::of_rows("start", &COLUMNS, vec![row(&first.first())]);
        layers.push(start.drawn(START));
    }
    let say = input.wording();
    let caption = format!(
        "Friction force *F* against normal force *N* along the motion, with the friction cone |*F*| ≤ *μ*_{{s}}*N* (shaded) \
         in which rolling stays; a slide runs along |*F*| = *μ*_{{k}}*N*, and in flight both are zero. Cross: start; \
         diamonds: transitions; arrows: time.{}{} {}; {}.",
        if is_seen { "" } else { " The cone is far beyond the window." },
        in_words(&spikes, say),
        say.hoop(hoop),
        say.start(hoop, &input.start)
    ) + &remark(&motion, say);
    let x = say.axis(NORMAL, &marked(SampleColumn::Normal.sign()), window.x);
    let y = say.axis(FRICTION, &marked(SampleColumn::Friction.sign()), window.y);
    let content = Content { name: "plane of forces", x, y, layers, labels };
    Ok(input.sheet(580.0)?.plot(NAME, "The friction cone along a motion", caption, 402.0, content, keys))
}
