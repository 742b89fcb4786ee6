//! Figure 6: gliding of the massless hoop, alone and together with rolling.

use core::f64::consts::PI;

use littlewood::theory::{GlidingIntegrals, Massless, Window};
use littlewood::{Hoop, Limits, Mode, Phase, Start};
use littlewood_draw::{
    Content, FAINT, Figure, INK, Label, Layer, Mark, REGION, SOFT, Series, Stroke, TRANSITION,
    short,
};
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash};

use crate::columns::{PLANE, THETA, THETA_RATE, W};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Portrait, in_time, mirrored, rows_with, unloading_lines};

const WINDOW: Window = Window {
    x: [-PI, PI],
    y: [-2.6, 2.6],
};
/// Many lines side by side, told from rolling by where they are: dashes would only disturb.
const GLIDING: Stroke = Stroke::of_mode(Mode::Gliding).dashed(Dash::Solid);
/// Lines that run side by side.
const THIN: f64 = 1.2;
const COLUMNS: [&str; 3] = [THETA, THETA_RATE, W];

/// A line of constant w = ½ ℓ̂² sin²θ θ′² + ℓ̂ cos θ. The particle falls freely: with its vertical
/// velocity V, from one value to another, as the parameter, ℓ̂ cos θ = w − ½ V² and
/// θ′ = −V/(ℓ̂ sin θ).
fn line_of(body: &Massless, w: f64, side: f64, from: f64, to: f64) -> Vec<Vec<[f64; 3]>> {
    let l = body.offset;
    let pieces = WINDOW.pieces([from, to], 600, &|v| {
        // 1 − cos θ and 1 + cos θ, without cancellation at the top.
        let (below_top, above_bottom) = ((l - w + 0.5 * v * v) / l, (l + w - 0.5 * v * v) / l);
        if below_top <= 0.0 || above_bottom <= 0.0 {
            return None;
        }
        let theta = 2.0 * libm::atan2(below_top.sqrt(), above_bottom.sqrt());
        Some([
            side * theta,
            -side * v / (l * (below_top * above_bottom).sqrt()),
        ])
    });
    rows_with(pieces, w).map(Iterator::collect).collect()
}

/// The greatest speed of a fall with this w: to the lowest place.
fn fastest(body: &Massless, w: f64) -> f64 {
    (2.0 * (w + body.offset)).sqrt()
}

/// Where a line first has a rate, pointing along the flow.
fn head_at_rate(line: &[[f64; 3]], wanted: f64) -> Option<[[f64; 3]; 2]> {
    let crosses = |pair: &&[[f64; 3]]| (pair[0][1] - wanted) * (pair[1][1] - wanted) <= 0.0;
    let at = line.windows(2).find(crosses)?;
    Some(in_time(at[0], at[1]))
}

/// The places on lines over an angle, pointing along the flow.
fn heads_at_angle(lines: &[Vec<[f64; 3]>], theta: f64) -> impl Iterator<Item = [[f64; 3]; 2]> {
    lines
        .iter()
        .flat_map(|line| line.windows(2))
        .filter(move |pair| (pair[0][0] - theta) * (pair[1][0] - theta) < 0.0)
        .filter(|pair| pair[0][1].abs() < 2.4)
        .map(|pair| in_time(pair[0], pair[1]))
}

/// The lines of Figure 6(a), and arrows of their flow.
fn lines(body: &Massless) -> Vec<Layer> {
    let mut layers: Vec<Layer> = Vec::new();
    let mut flow: Vec<[[f64; 3]; 2]> = Vec::new();
    // Just below 1 they come closest to the top.
    for w in [
        -0.75, -0.4, 0.0, 0.4, 0.75, 0.9, 0.98, 1.25, 1.75, 2.5, 3.5, 5.0,
    ] {
        let v = fastest(body, w);
        for side in [1.0, -1.0] {
            let pieces = line_of(body, w, side, -v, v);
            if w < 1.0 {
                for piece in &pieces {
                    flow.extend(
                        [0.9, -0.9]
                            .into_iter()
                            .filter_map(|it| head_at_rate(piece, it)),
                    );
                }
            } else {
                flow.extend(heads_at_angle(&pieces, side * 0.5 * PI));
            }
            layers.push(Series::new(format!("w={w}"), &COLUMNS, pieces).drawn(GLIDING));
        }
    }
    for side in [1.0, -1.0] {
        // With w = 1 the particle comes to the top, θ = 0, with V = 0, and passes over it.
        let v = fastest(body, 1.0);
        let mut pieces = line_of(body, 1.0, side, -v, -1e-6);
        pieces.extend(line_of(body, 1.0, side, 1e-6, v));
        flow.extend(heads_at_angle(&pieces, side * 0.5 * PI));
        let series = Series::new("w=1", &COLUMNS, pieces);
        layers.push(series.drawn(Stroke::solid(INK, CURVE)));
    }
    layers.push(Series::new("flow", &COLUMNS, flow).drawn(Mark::Head(INK)));
    layers
}

/// Figure 6(a).
pub(crate) fn alone(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-6a";
    let body = input.littlewood(NAME)?;
    input.level(NAME)?;
    let mut layers = lines(&body);
    let singular = Series::of_rows("singular", &PLANE, WINDOW.y.map(|rate| [0.0, rate]));
    layers.push(singular.drawn(Stroke::solid(SOFT, FINE).dashed(Dash::Dashed)));
    let one = Label::new("*w* = 1", &[0.0, 1.0]).shifted(32.0, -11.0);
    let mut labels = mirrored(one, 1).to_vec();
    labels.extend([
        Label::new("*w* > 1", &[0.16 * PI, 2.3]).left(),
        Label::new("*w* > 1", &[-0.16 * PI, -2.3]).right(),
    ]);
    let caption = "Phase portrait of gliding (3.17)_{1}: lines of constant *w* = ½ sin^{2}*θ* *θ*′^{2} + cos *θ*, the \
                   vertical energy of the freely falling particle. (The *w* printed in (3.18), ½ sin *θ* *θ*′^{2} − *θ*, \
                   is not conserved by (3.17), and its lines are not the orbits.) On the black lines *w* = 1: they alone \
                   pass through *θ* = 0, with *θ*′ = ±1. *θ*′ is unbounded as *θ* → ±π, which is reached in a finite time."
        .to_owned();
    let title = "Figure 6(a): phase portrait of gliding";
    let content = content(input, layers, labels);
    input.plane(NAME, title, caption, content, Vec::new())
}

fn content(input: &FigureInput, layers: Vec<Layer>, labels: Vec<Label>) -> Content {
    Content {
        name: "plane",
        x: input.wording().angle(WINDOW.x.into()),
        y: input.wording().rate(WINDOW.y.into()),
        layers,
        labels,
    }
}

/// Motions that roll from some starts in 𝓡 and then glide, with their mirror images.
#[derive(Default)]
struct Motions {
    rolling: Vec<Vec<[f64; 2]>>,
    gliding: Vec<Vec<[f64; 3]>>,
    /// Where they leave 𝓡.
    changes: Vec<[f64; 2]>,
}

impl Motions {
    fn new(hoop: &Hoop, body: &Massless, theta_s: f64) -> Result<Self, FigureError> {
        // Over the top by their rate there, and at rest at an angle. Few, since gliding lines
        // converge towards θ = ±π.
        let starts = [
            Start::at(0.0, 0.5),
            Start::at(0.0, 0.92),
            Start::at(0.75 * theta_s, 0.0),
        ];
        let mut motions = Self::default();
        for start in starts {
            let motion = hoop.simulate(start, Limits::default())?;
            let first = motion.phases().first();
            if let Some(phase) = first.filter(|phase| phase.mode() == Mode::Rolling) {
                motions.add(body, phase);
            }
        }
        Ok(motions)
    }

    fn add(&mut self, body: &Massless, phase: &Phase) {
        let Some(end) = phase.end() else {
            return;
        };
        let half: Vec<[f64; 2]> = (0..=80)
            .map(|i| phase.sample(phase.duration() * f64::from(i) / 80.0).state)
            .map(|state| [state.theta, state.theta_rate])
            .collect();
        let w = GlidingIntegrals::at(body, &end).w;
        let falling = -libm::sin(end.theta) * end.theta_rate;
        let onward = line_of(body, w, 1.0, falling, -fastest(body, w));
        // The other half of each orbit, and the other three, by symmetry: through the top (θ, θ′) →
        // (−θ, θ′) with time reversed, otherwise (θ, −θ′); and (−θ, −θ′).
        for [a, b] in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            self.rolling
                .push(half.iter().map(|[x, y]| [a * x, b * y]).collect());
            let image = |[x, y, w]: &[f64; 3]| [a * x, b * y, *w];
            let images = onward.iter().map(|piece| piece.iter().map(image).collect());
            self.gliding.extend(images);
            self.changes.push([a * end.theta, b * end.theta_rate]);
        }
    }

    /// Arrows in the middle of rolling.
    fn flow_of_rolling(&self) -> Vec<[[f64; 2]; 2]> {
        let middle = |piece: &Vec<[f64; 2]>| {
            let middle = piece.len() / 2;
            Some(in_time(*piece.get(middle)?, *piece.get(middle + 1)?))
        };
        self.rolling.iter().filter_map(middle).collect()
    }

    /// Arrows of gliding at an angle.
    fn flow_of_gliding(&self) -> Vec<[[f64; 3]; 2]> {
        let beyond = |row: &[f64; 3]| row[0].abs() - 0.62 * PI;
        let head = |piece: &Vec<[f64; 3]>| {
            let crosses = |pair: &&[[f64; 3]]| beyond(&pair[1]) * beyond(&pair[0]) <= 0.0;
            let at = piece.windows(2).find(crosses)?;
            Some(in_time(at[0], at[1]))
        };
        self.gliding.iter().filter_map(head).collect()
    }
}

/// Lines of Figure 6(a), as far as they run outside 𝓡.
fn elsewhere(body: &Massless, theta_s: f64) -> Layer {
    let is_inside = |row: &[f64; 3]| row[0].abs() <= theta_s && row[1].abs() <= 1.0;
    let mut pieces: Vec<Vec<[f64; 3]>> = Vec::new();
    for w in [-0.75, -0.4, 0.0, 0.35, 1.4, 1.9, 2.6, 3.6] {
        let v = fastest(body, w);
        for side in [1.0, -1.0] {
            for line in line_of(body, w, side, -v, v) {
                let parts = line.split(is_inside).filter(|part| part.len() > 1);
                pieces.extend(parts.map(<[_]>::to_vec));
            }
        }
    }
    Series::new("gliding elsewhere", &COLUMNS, pieces).drawn(Stroke::solid(FAINT, FINE))
}

/// Figure 6(b).
pub(crate) fn combined(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-6b";
    let body = input.littlewood_that_rolls(NAME)?;
    let portrait = Portrait::new(&input.hoop, WINDOW);
    let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
    let motions = Motions::new(&input.hoop, &body, theta_s)?;
    let rolling = Stroke::of_mode(Mode::Rolling).wide(THIN);
    let [flow_of_gliding, flow_of_rolling] = [
        Series::new("flow", &COLUMNS, motions.flow_of_gliding()),
        Series::new("flow of rolling", &PLANE, motions.flow_of_rolling()),
    ];
    let inner = Portrait {
        window: Window {
            x: [-theta_s, theta_s],
            y: [-1.0, 1.0],
        },
        ..portrait
    };
    let mut layers = vec![
        portrait.rolling_region().drawn(Mark::Fill(REGION)),
        elsewhere(&body, theta_s),
        Series::new("gliding", &COLUMNS, motions.gliding).drawn(GLIDING.wide(THIN)),
        Series::new("rolling", &PLANE, motions.rolling).drawn(rolling),
        inner.separatrix().drawn(Curve::Separatrix),
    ];
    if let Some((_, limit)) = portrait.massless_limit() {
        layers.push(limit.drawn(Curve::SlipLimit));
    }
    layers.extend([
        unloading_lines(theta_s).drawn(Curve::NormalForceZero),
        flow_of_gliding.drawn(Mark::Head(GLIDING.colour)),
        flow_of_rolling.drawn(Mark::Head(rolling.colour)),
        Series::of_rows("transition", &PLANE, motions.changes).drawn(TRANSITION),
    ]);
    layers.extend(portrait.equilibria());
    let labels = vec![
        Label::new("rolls", &[0.0, 0.63]).coloured(rolling.colour),
        Label::new("glides", &[0.72 * PI, 1.3]).coloured(GLIDING.colour),
        Label::new("glides", &[-0.72 * PI, -1.3]).coloured(GLIDING.colour),
        Label::new("𝓡", &[-0.72 * theta_s, 0.0])
            .sized(20.0)
            .of_area(),
    ];
    let caption = format!(
        "Rolling (in 𝓡, shaded) and gliding (outside it) of the massless hoop together. Motions leave 𝓡 where static \
         friction gives way (*f*, dashed) or the normal force vanishes (*n*) at the diamonds and glide on along a line of constant *w* to *θ* = ±π. \
         Gliding motions that enter 𝓡 become rolling ones only if *η*′ = 0 there. Black: stable and unstable manifolds of \
         the equilibrium. *μ*_{{s}} = {}. Gliding by the corrected integral, see Figure 6(a); grey: other gliding motions, outside 𝓡.",
        short(input.hoop.mu_s())
    );
    let title = "Figure 6(b): combined phase portrait";
    let content = content(input, layers, labels);
    input.plane(NAME, title, caption, content, Vec::new())
}
