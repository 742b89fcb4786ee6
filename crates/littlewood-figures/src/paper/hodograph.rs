//! The friction cone: friction against normal force along a motion.

use littlewood::theory::Window;
use littlewood::{Hoop, Mode, Sample};
use littlewood_draw::{
    Content, Entries, Figure, IMPULSE, Label, Layer, Mark, Piece, REGION, SMALL, SOFT, START,
    Series, Stroke, TRANSITION,
};
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash};

use crate::columns::{FRICTION, FRICTION_IMPULSE, MU_K, MU_S, NORMAL, NORMAL_IMPULSE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{NOISE, Shown, bounds};
use crate::spikes::Spikes;

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

const fn row(sample: &Sample) -> [f64; 3] {
    [sample.state.time, sample.normal, sample.friction]
}

/// A plane of forces or of impulses.
struct Plane {
    name: &'static str,
    /// Its columns, upright to the plane and along it.
    columns: [&'static str; 2],
    /// Their letters.
    upright: &'static str,
    along: &'static str,
}

const FORCES: Plane = Plane {
    name: "plane of forces",
    columns: [NORMAL, FRICTION],
    upright: "*N*",
    along: "*F*",
};
const IMPULSES: Plane = Plane {
    name: "plane of impulses",
    columns: [NORMAL_IMPULSE, FRICTION_IMPULSE],
    upright: "*P*",
    along: "*J*",
};

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
fn cone(window: Window, columns: &[&'static str; 2], name: &'static str, mu: f64) -> Series {
    let pieces = [1.0, -1.0].into_iter().flat_map(|sign| {
        let from = f64::max(window.x[0], 0.0);
        window.pieces([from, window.x[1]], 64, &|normal| {
            Some([normal, sign * mu * normal])
        })
    });
    Series::new(name, columns, pieces)
}

/// The inside of the cone |F| ≤ μs N, as far as it is seen.
fn inside(window: Window, columns: &[&'static str; 2], mu: f64) -> Series {
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
        let cut = move |normal: &f64| [*normal, (sign * mu * normal).clamp(low, high)];
        stops.iter().map(cut)
    };
    let polygon = edge(1.0).chain(edge(-1.0).rev());
    Series::of_rows("inside of the cone", columns, polygon)
}

/// From the last forces of a phase to the first of the next, where they jump.
fn jumps(motion: &Shown, window: Window) -> Vec<[[f64; 3]; 2]> {
    let pairs = motion.phases().windows(2).filter(|pair| {
        // Before an impact and after it the forces are those of flights.
        let end = motion.end_of(&pair[0]);
        pair[1].start().time < motion.until && end.is_some_and(|end| end.impact.is_none())
    });
    pairs
        .filter_map(|pair| Some([row(&pair[0].last()?), row(&pair[1].first())]))
        .filter(|rows| length(rows, window) > LEAST_JUMP)
        .collect()
}

/// Length of a step in parts of the window.
fn length([from, to]: &[[f64; 3]; 2], window: Window) -> f64 {
    let part = |i: usize, range: [f64; 2]| (to[i] - from[i]) / (range[1] - range[0]);
    libm::hypot(part(1, window.x), part(2, window.y))
}

/// Dots at the ends of phases, with their names if they are few.
fn changes(motion: &Shown, largest: f64) -> (Layer, Vec<Label>) {
    let phases = motion.phases().iter();
    let ends: Vec<(&'static str, [f64; 3])> = phases
        .filter(|phase| phase.mode().has_normal_force())
        .filter_map(|phase| Some((motion.end_of(phase)?, phase.last()?)))
        .filter(|(transition, _)| transition.time() <= motion.until)
        .map(|(transition, sample)| (transition.cause.label(), row(&sample)))
        .collect();
    let named = ends.iter().filter(|_| ends.len() <= NAMED);
    let labels = named.map(|(name, row)| {
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
    let rows = ends.into_iter().map(|(_, row)| row);
    let dots = Series::of_rows("transition", &COLUMNS, rows).drawn(TRANSITION);
    (dots, labels)
}

impl Plane {
    /// The cones in a window, with the axes where their point is seen, and what they mean.
    fn cones(&self, hoop: &Hoop, window: Window) -> (Vec<Layer>, Entries) {
        let (mu_s, mu_k, columns) = (hoop.mu_s(), hoop.mu_k(), &self.columns);
        let limit = Stroke::of_curve(Curve::SlipLimit).wide(CURVE);
        let of_mu_k = limit.dashed(Dash::Dotted);
        let cones = [
            (cone(window, columns, MU_S, mu_s).drawn(limit), "*μ*_{s}"),
            (cone(window, columns, MU_K, mu_k).drawn(of_mu_k), "*μ*_{k}"),
        ];
        let mut layers = vec![inside(window, columns, mu_s).drawn(Mark::Fill(REGION))];
        if window.x[0] < 0.0 {
            let along = window.x.map(|x| [x, 0.0]);
            let upright = window.y.map(|y| [0.0, y]);
            let zero = Series::new("zero", columns, [along, upright]);
            layers.push(zero.drawn(Stroke::solid(SOFT, FINE)));
        }
        let mut keys = Vec::new();
        let Self { along, upright, .. } = self;
        // With μs = μk there is one cone.
        for (layer, letter) in cones.into_iter().take(if mu_k < mu_s { 2 } else { 1 }) {
            if !layer.series.pieces.is_empty() && mu_s > 0.0 {
                keys.push((layer.mark, format!("|{along}| = {letter}{upright}")));
                layers.push(layer);
            }
        }
        (layers, keys)
    }

    fn content(
        &self,
        motion: &Shown,
        window: Window,
        layers: Vec<Layer>,
        labels: Vec<Label>,
    ) -> Content {
        let [upright, along] = self.columns;
        Content {
            name: self.name,
            x: motion.say.axis(upright, self.upright, window.x),
            y: motion.say.axis(along, self.along, window.y),
            layers,
            labels,
        }
    }
}

/// The impulses as dots, which lie in the same cones.
fn of_impulses(motion: &Shown) -> Option<(Content, Entries)> {
    let rows: Vec<[f64; 2]> = Spikes::new(motion)
        .impulses
        .iter()
        .map(|(_, impulse)| [impulse.normal, impulse.friction])
        .collect();
    let most = rows.iter().map(|row| row[0]).fold(0.0, f64::max);
    (most > 0.0).then(|| {
        let window = whole(most, motion.hoop().mu_s());
        let (mut layers, mut keys) = IMPULSES.cones(motion.hoop(), window);
        let mark = Mark::Dot(IMPULSE, 2.8);
        keys.push((mark, "impulse".to_owned()));
        layers.push(Series::of_rows("impulse", &IMPULSES.columns, rows).drawn(mark));
        (IMPULSES.content(motion, window, layers, Vec::new()), keys)
    })
}

/// The forces of a motion in contact.
struct Forces {
    content: Content,
    keys: Entries,
    /// Whether a cone is seen.
    has_cone: bool,
}

fn of_forces(motion: &Shown) -> Option<Forces> {
    let mut in_contact = motion.by_mode("", &COLUMNS, row);
    in_contact.0.retain(|(mode, _)| mode.has_normal_force());
    let all: Piece = in_contact.rows().map(<[f64]>::to_vec).collect();
    if all.iter().all(|row| row[1] <= 0.0) {
        return None;
    }
    let window = window_of(&all, motion.hoop().mu_s());
    let (mut layers, of_cones) = FORCES.cones(motion.hoop(), window);
    let has_cone = !of_cones.is_empty();
    let mut keys = in_contact.entries(|mode| mode.to_string());
    keys.extend(of_cones);
    let jumps = jumps(motion, window);
    if !jumps.is_empty() {
        let stroke = Stroke::solid(SOFT, FINE).dashed(Dash::Short);
        keys.push((Mark::Line(stroke), "jump".to_owned()));
        layers.push(Series::new("jump", &COLUMNS, jumps).drawn(Mark::Arrow(stroke)));
    }
    layers.extend(in_contact.lines(BOLD));
    let is_seen = |mode: Mode, rows: &[[f64; 3]; 2]| {
        mode.has_normal_force() && length(rows, window) > LEAST_STEP
    };
    layers.extend(motion.arrows(0.45, &COLUMNS, row, is_seen));
    let (dots, labels) = changes(motion, window.x[1]);
    layers.push(dots);
    let first = motion.phases().first();
    if let Some(first) = first.filter(|phase| phase.mode().has_normal_force()) {
        let start = Series::of_rows("start", &COLUMNS, [row(&first.first())]);
        layers.push(start.drawn(START));
    }
    Some(Forces {
        content: FORCES.content(motion, window, layers, labels),
        keys,
        has_cone,
    })
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let motion = input.motion_in_contact(NAME)?;
    let (forces, impulses) = (of_forces(&motion), of_impulses(&motion));
    let is_far = forces
        .as_ref()
        .is_some_and(|forces| !forces.has_cone && motion.hoop().mu_s() > 0.0);
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
    let forces = forces.map(|forces| (forces.content, forces.keys));
    for (content, own) in forces.into_iter().chain(impulses) {
        for entry in own {
            if keys.iter().all(|(known, _)| *known != entry.0) {
                keys.push(entry);
            }
        }
        contents.push(content);
    }
    let title = "The friction cone along a motion";
    let figure = match <[Content; 2]>::try_from(contents) {
        Ok(contents) => input
            .sheet(860.0)?
            .pair(NAME, title, caption, 362.0, contents, keys),
        Err(mut contents) => match contents.pop() {
            Some(content) => input.plane(NAME, title, caption, content, keys)?,
            None => {
                return Err(FigureError::NoForce {
                    figure: NAME,
                    outcome: motion.outcome().kind(),
                });
            }
        },
    };
    Ok(figure.noted(motion.remark()))
}
