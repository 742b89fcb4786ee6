//! The friction cone: friction against normal force along a motion.

use littlewood::tables::SampleColumn;
use littlewood::{Hoop, Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Entries, Figure, IMPULSE, Label, Layer, Mark, Piece, REGION, SMALL, SOFT, START,
    Series, Stroke, TRANSITION, marked,
};

use crate::columns::{FRICTION, FRICTION_IMPULSE, MU_K, MU_S, NORMAL, NORMAL_IMPULSE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{NOISE, arrows, bounds, by_mode, entries, horizon, lines, remark};
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

/// A plane of forces or of impulses: its columns, upright to the plane and along it.
type Columns = [&'static str; 2];
const FORCES: Columns = [NORMAL, FRICTION];
const IMPULSES: Columns = [NORMAL_IMPULSE, FRICTION_IMPULSE];

/// Both cones from their point to the greatest normal force.
fn whole(most: f64, mu_s: f64) -> Window {
    let limit = if mu_s > 0.0 {
        1.12 * mu_s * most
    } else {
        0.5 * most
    };
    Window {
        x: [-0.13 * most, 1.08 * most],
        y: [-limit, limit],
    }
}

/// The part of the plane of forces in which a motion is seen.
fn window_of(rows: &[Vec<f64>], mu_s: f64) -> Window {
    let normals = || rows.iter().map(|row| row[1]);
    let frictions = || rows.iter().map(|row| row[2]);
    let most = normals().fold(0.0, f64::max);
    let least = normals().fold(f64::INFINITY, f64::min);
    let all = whole(most, mu_s);
    // What changes by rounding alone is a dot.
    if most - least <= NOISE * most {
        return all;
    }
    let is_level = most - least < SMALL_SHARE * most;
    let x = if is_level {
        bounds(normals(), 0.15)
    } else {
        all.x
    };
    let largest = frictions().map(f64::abs).fold(0.0, f64::max);
    let y = if largest <= NOISE * most {
        all.y
    } else if largest < SMALL_SHARE * mu_s * most {
        // Both cones are far away.
        bounds(frictions().chain([0.0]), 0.15)
    } else if is_level {
        bounds(frictions(), 0.15)
    } else {
        all.y
    };
    Window { x, y }
}

/// The two lines |F| = μ N, as far as they are seen.
fn cone(window: Window, columns: Columns, name: &'static str, mu: f64) -> Series {
    let pieces = [1.0, -1.0].into_iter().flat_map(|sign| {
        let from = f64::max(window.x[0], 0.0);
        window.pieces([from, window.x[1]], 64, &|normal| {
            Some([normal, sign * mu * normal])
        })
    });
    let rows = pieces
        .map(|piece| piece.into_iter().map(Vec::from).collect())
        .collect();
    Series::new(name, &columns, rows)
}

/// The inside of the cone |F| ≤ μs N, as far as it is seen.
fn inside(window: Window, columns: Columns, mu: f64) -> Series {
    let Window {
        x: [left, right],
        y: [low, high],
    } = window;
    let left = f64::max(left, 0.0);
    // Where the lines enter and leave the window.
    let mut stops = vec![left, right];
    stops.extend(
        [low, high]
            .into_iter()
            .filter(|_| mu > 0.0)
            .map(|edge| edge.abs() / mu),
    );
    stops.retain(|normal| (left..=right).contains(normal));
    stops.sort_by(f64::total_cmp);
    let edge = |sign: f64| {
        let cut = move |normal: f64| vec![normal, (sign * mu * normal).clamp(low, high)];
        stops
            .iter()
            .map(move |normal| cut(*normal))
            .collect::<Vec<_>>()
    };
    let mut polygon = edge(1.0);
    polygon.extend(edge(-1.0).into_iter().rev());
    Series::of_rows("inside of the cone", &columns, polygon)
}

/// From the last forces of a phase to the first of the next, where they jump.
fn jumps(motion: &Trajectory, window: Window) -> Vec<Piece> {
    let until = horizon(motion);
    let pairs = motion.phases().windows(2).filter(|pair| {
        let is_seen = pair[1].start().time < until;
        // Before an impact and after it the forces are those of flights.
        is_seen
            && motion
                .end_of(&pair[0])
                .is_some_and(|transition| transition.impact.is_none())
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
    let labels = if ends.len() > NAMED {
        &[][..]
    } else {
        &ends[..]
    };
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
    (
        Series::of_rows("transition", &COLUMNS, rows).drawn(TRANSITION),
        labels,
    )
}

/// The cones in a window, with the axes where their point is seen, and what they mean.
fn cones(
    hoop: &Hoop,
    window: Window,
    columns: Columns,
    [upright, along]: [&str; 2],
) -> (Vec<Layer>, Entries) {
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    let limit = Stroke::of_curve(Curve::SlipLimit).wide(CURVE);
    let cones = [
        (cone(window, columns, MU_S, mu_s).drawn(limit), "*μ*_{s}"),
        (
            cone(window, columns, MU_K, mu_k).drawn(limit.dashed(Dash::Dotted)),
            "*μ*_{k}",
        ),
    ];
    let mut layers = vec![inside(window, columns, mu_s).drawn(Mark::Fill(REGION))];
    if window.x[0] < 0.0 {
        let axis = [vec![window.x[0], 0.0], vec![window.x[1], 0.0]].to_vec();
        let upright = [vec![0.0, window.y[0]], vec![0.0, window.y[1]]].to_vec();
        let zero = Series::new("zero", &columns, vec![axis, upright]);
        layers.push(zero.drawn(Stroke::solid(SOFT, FINE)));
    }
    let mut keys = Vec::new();
    // With μs = μk there is one cone.
    for (layer, letter) in cones.into_iter().take(if mu_k < mu_s { 2 } else { 1 }) {
        if !layer.series.pieces.is_empty() && mu_s > 0.0 {
            keys.push((layer.mark, format!("|{along}| = {letter}{upright}")));
            layers.push(layer);
        }
    }
    (layers, keys)
}

/// The impulses as dots, which lie in the same cones.
fn of_impulses(hoop: &Hoop, spikes: &Spikes, say: Wording) -> Option<(Content, Entries)> {
    let rows: Piece = spikes
        .impulses
        .iter()
        .map(|(_, impulse)| vec![impulse.normal, impulse.friction])
        .collect();
    let most = rows.iter().map(|row| row[0]).fold(0.0, f64::max);
    (most > 0.0).then(|| {
        let window = whole(most, hoop.mu_s());
        let (mut layers, mut keys) = cones(hoop, window, IMPULSES, ["*P*", "*J*"]);
        let mark = Mark::Dot(IMPULSE, 2.8);
        keys.push((mark, "impulse".to_owned()));
        layers.push(Series::of_rows("impulse", &IMPULSES, rows).drawn(mark));
        let [x, y] = [
            say.axis(NORMAL_IMPULSE, "*P*", window.x),
            say.axis(FRICTION_IMPULSE, "*J*", window.y),
        ];
        (
            Content {
                name: "plane of impulses",
                x,
                y,
                layers,
                labels: Vec::new(),
            },
            keys,
        )
    })
}

/// The forces of a motion in contact, and whether a cone is seen.
fn of_forces(motion: &Trajectory, say: Wording) -> Option<(Content, Entries, bool)> {
    let in_contact: Vec<(Mode, Series)> = by_mode(motion, "", &COLUMNS, &row)
        .into_iter()
        .filter(|(mode, _)| mode.has_normal_force())
        .collect();
    let all: Piece = in_contact
        .iter()
        .flat_map(|(_, series)| series.rows())
        .map(<[f64]>::to_vec)
        .collect();
    if all.iter().all(|row| row[1] <= 0.0) {
        return None;
    }
    let window = window_of(&all, motion.hoop().mu_s());
    let (mut layers, of_cones) = cones(motion.hoop(), window, FORCES, ["*N*", "*F*"]);
    let is_seen = !of_cones.is_empty();
    let mut keys = entries(&in_contact, |mode| mode.to_string());
    keys.extend(of_cones);
    let jumps = jumps(motion, window);
    if !jumps.is_empty() {
        let stroke = Stroke::solid(SOFT, FINE).dashed(Dash::Short);
        keys.push((Mark::Line(stroke), "jump".to_owned()));
        layers.push(Series::new("jump", &COLUMNS, jumps).drawn(Mark::Arrow(stroke)));
    }
    layers.extend(lines(in_contact, BOLD));
    let is_seen_move = |mode: Mode, rows: &[Vec<f64>]| {
        mode.has_normal_force() && length(rows, window) > LEAST_STEP
    };
    layers.extend(arrows(motion, 0.45, &COLUMNS, &row, is_seen_move));
    let (dots, labels) = changes(motion, window.x[1]);
    layers.push(dots);
    if let Some(first) = motion
        .phases()
        .first()
        .filter(|phase| phase.mode().has_normal_force())
    {
        let start = Series::of_rows("start", &COLUMNS, vec![row(&first.first())]);
        layers.push(start.drawn(START));
    }
    let x = say.axis(NORMAL, &marked(SampleColumn::Normal.sign()), window.x);
    let y = say.axis(FRICTION, &marked(SampleColumn::Friction.sign()), window.y);
    Some((
        Content {
            name: "plane of forces",
            x,
            y,
            layers,
            labels,
        },
        keys,
        is_seen,
    ))
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion_in_contact(NAME)?;
    let (hoop, say) = (motion.hoop(), input.wording());
    let forces = of_forces(&motion, say);
    let impulses = of_impulses(hoop, &Spikes::new(&motion), say);
    let is_far = forces
        .as_ref()
        .is_some_and(|(_, _, is_seen)| !is_seen && hoop.mu_s() > 0.0);
    let caption = format!(
        "Friction force *F* against normal force *N* along the motion, with the friction cone |*F*| ≤ *μ*_{{s}}*N* (shaded) \
         in which rolling stays; a slide runs along |*F*| = *μ*_{{k}}*N*, and in flight both are zero. Cross: start; \
         diamonds: transitions; arrows: time.{}{} {}.",
        if is_far {
            " The cone is far beyond the window."
        } else {
            ""
        },
        if impulses.is_some() {
            " Dots: the impulses (*P*, *J*) of the impacts, in the same cones."
        } else {
            ""
        },
        input.in_words()
    );
    let mut keys: Entries = Vec::new();
    let mut contents = Vec::new();
    for (content, own) in forces
        .map(|(content, keys, _)| (content, keys))
        .into_iter()
        .chain(impulses)
    {
        let is_new = |(mark, _): &(Mark, String)| keys.iter().all(|(known, _)| known != mark);
        keys.extend(own.into_iter().filter(is_new).collect::<Vec<_>>());
        contents.push(content);
    }
    let title = "The friction cone along a motion";
    match <[Content; 2]>::try_from(contents) {
        Ok(contents) => Ok(input
            .sheet(860.0)?
            .pair(NAME, title, caption, 362.0, contents, keys)
            .noted(remark(&motion, say))),
        Err(mut contents) => match contents.pop() {
            Some(content) => Ok(input
                .sheet(580.0)?
                .plot(NAME, title, caption, 402.0, content, keys)
                .noted(remark(&motion, say))),
            None => Err(FigureError::NoForce {
                figure: NAME,
                outcome: motion.outcome().kind(),
            }),
        },
    }
}
