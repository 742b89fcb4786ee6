//! Figure 6: gliding of the massless hoop, alone and together with rolling.

use core::f64::consts::PI;

use littlewood::theory::{GlidingIntegrals, Massless};
use littlewood::{Limits, Mode, Start};
use littlewood_draw::{
    Entries, FAINT, Figure, INK, Label, Layer, Mark, Piece, REGION, SOFT, Series, Stroke,
    TRANSITION, short,
};

use crate::columns::{PLANE, THETA, THETA_RATE, W};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Portrait, in_time, unloading_lines};
use littlewood::theory::Window;
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash};

pub(super) const WINDOW: Window = Window {
    x: [-PI, PI],
    y: [-2.6, 2.6],
};
/// Many lines side by side, told from rolling by where they are: dashes would only disturb.
pub(super) const GLIDING: Stroke = Stroke::of_mode(Mode::Gliding).dashed(Dash::Solid);
/// Lines that run side by side.
const THIN: f64 = 1.2;
const COLUMNS: [&str; 3] = [THETA, THETA_RATE, W];

/// A line of constant w = ½ ℓ̂² sin²θ θ′² + ℓ̂ cos θ. The particle falls freely: with its vertical
/// velocity V as the parameter, ℓ̂ cos θ = w − ½ V² and θ′ = −V/(ℓ̂ sin θ).
pub(super) fn line_of(body: &Massless, w: f64, side: f64, velocities: [f64; 2]) -> Vec<Piece> {
    let l = body.offset;
    WINDOW
        .pieces(velocities, 600, &|v| {
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
        })
        .into_iter()
        .map(|piece| {
            piece
                .into_iter()
                .map(|[theta, rate]| vec![theta, rate, w])
                .collect()
        })
        .collect()
}

/// The greatest speed of a fall with this w: to the lowest place.
pub(super) fn fastest(body: &Massless, w: f64) -> f64 {
    (2.0 * (w + body.offset)).sqrt()
}

/// Where each piece has one of these rates first, pointing along the flow.
fn heads(pieces: &[Piece], rates: &[f64]) -> Vec<Piece> {
    let head = |piece: &Piece, wanted: f64| {
        let at = piece
            .windows(2)
            .find(|pair| (pair[0][1] - wanted) * (pair[1][1] - wanted) <= 0.0)?;
        Some(in_time(&at[0], &at[1]))
    };
    pieces
        .iter()
        .flat_map(|piece| rates.iter().filter_map(move |rate| head(piece, *rate)))
        .collect()
}

/// Figure 6(a).
pub(crate) fn alone(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-6a";
    let body = input.littlewood(NAME)?;
    input.level(NAME)?;
    let mut layers: Vec<Layer> = Vec::new();
    let mut flow = Vec::new();
    // Just below 1 they come closest to the top.
    for w in [
        -0.75, -0.4, 0.0, 0.4, 0.75, 0.9, 0.98, 1.25, 1.75, 2.5, 3.5, 5.0,
    ] {
        let v = fastest(&body, w);
        for side in [1.0, -1.0] {
            let pieces = line_of(&body, w, side, [-v, v]);
            let at = if w < 1.0 { vec![0.9, -0.9] } else { vec![] };
            flow.extend(heads(&pieces, &at));
            if w > 1.0 {
                flow.extend(heads_at_angle(&pieces, side * 0.5 * PI));
            }
            let name = format!("w={w}");
            layers.push(Series::new(name, &COLUMNS, pieces).drawn(GLIDING));
        }
    }
    for side in [1.0, -1.0] {
        // With w = 1 the particle comes to the top, θ = 0, with V = 0, and passes over it.
        let v = fastest(&body, 1.0);
        let pieces = [
            line_of(&body, 1.0, side, [-v, -1e-6]),
            line_of(&body, 1.0, side, [1e-6, v]),
        ]
        .concat();
        flow.extend(heads_at_angle(&pieces, side * 0.5 * PI));
        layers.push(Series::new("w=1", &COLUMNS, pieces).drawn(Stroke::solid(INK, CURVE)));
    }
    layers.push(Series::new("flow", &COLUMNS, flow).drawn(Mark::Head(INK)));
    let singular = Series::of_rows(
        "singular",
        &PLANE,
        vec![vec![0.0, WINDOW.y[0]], vec![0.0, WINDOW.y[1]]],
    );
    layers.push(singular.drawn(Stroke::solid(SOFT, FINE).dashed(Dash::Dashed)));
    let labels = vec![
        Label::new("*w* = 1", &[0.0, 1.0]).shifted(32.0, -11.0),
        Label::new("*w* = 1", &[0.0, -1.0]).shifted(32.0, 11.0),
        Label::new("*w* = 0", &[0.5 * PI, 0.0]),
        Label::new("*w* = 0", &[-0.5 * PI, 0.0]),
        Label::new("*w* > 1", &[0.16 * PI, 2.3]).left(),
        Label::new("*w* > 1", &[-0.16 * PI, -2.3]).right(),
    ];
    let caption = "Phase portrait of gliding (3.17)_{1}: lines of constant *w* = ½ sin^{2}*θ* *θ*′^{2} + cos *θ*, the \
                   vertical energy of the freely falling particle. (The *w* printed in (3.18), ½ sin *θ* *θ*′^{2} − *θ*, \
                   is not conserved by (3.17), and its lines are not the orbits.) On the black lines *w* = 1: they alone \
                   pass through *θ* = 0, with *θ*′ = ±1. *θ*′ is unbounded as *θ* → ±π, which is reached in a finite time."
        .to_owned();
    figure(
        input,
        [NAME, "Figure 6(a): phase portrait of gliding"],
        caption,
        (layers, labels),
    )
}

/// The place on each piece over an angle, pointing along the flow.
fn heads_at_angle(pieces: &[Piece], theta: f64) -> Vec<Piece> {
    pieces
        .iter()
        .flat_map(|piece| {
            piece
                .windows(2)
                .filter(|pair| (pair[0][0] - theta) * (pair[1][0] - theta) < 0.0)
        })
        .filter(|pair| pair[0][1].abs() < 2.4)
        .map(|pair| in_time(&pair[0], &pair[1]))
        .collect()
}

fn figure(
    input: &FigureInput,
    name: [&'static str; 2],
    caption: String,
    drawn: (Vec<Layer>, Vec<Label>),
) -> Result<Figure, FigureError> {
    let say = input.wording();
    input.plane(
        name,
        caption,
        [say.angle(WINDOW.x), say.rate(WINDOW.y)],
        drawn,
        Entries::new(),
    )
}

/// Figure 6(b).
pub(crate) fn combined(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-6b";
    let body = input.littlewood_that_rolls(NAME)?;
    let portrait = Portrait::new(&input.hoop, WINDOW);
    let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    let (mut rolling, mut gliding, mut changes) = (Vec::new(), Vec::new(), Vec::new());
    // Starts in 𝓡: over the top by their rate there, and at rest at an angle.
    // Few, since gliding lines converge towards θ = ±π.
    let starts = [
        Start::at(0.0, 0.5),
        Start::at(0.0, 0.92),
        Start::at(0.75 * theta_s, 0.0),
    ];
    for start in starts {
        let motion = input.hoop.simulate(start, Limits::default())?;
        let Some(phase) = motion
            .phases()
            .first()
            .filter(|phase| phase.mode() == Mode::Rolling)
        else {
            continue;
        };
        let (Some(end), duration) = (phase.end(), phase.duration()) else {
            continue;
        };
        let half: Vec<[f64; 2]> = (0..=80)
            .map(|i| phase.sample(duration * f64::from(i) / 80.0).state)
            .map(|state| [state.theta, state.theta_rate])
            .collect();
        let w = GlidingIntegrals::at(&body, &end).w;
        let falling = -libm::sin(end.theta) * end.theta_rate;
        let onward = line_of(&body, w, 1.0, [falling, -fastest(&body, w)]);
        // The other half of each orbit, and the other three, by symmetry: through the top (θ, θ′) →
        // (−θ, θ′) with time reversed, otherwise (θ, −θ′); and (−θ, −θ′).
        let images: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
        for [a, b] in images {
            rolling.push(
                half.iter()
                    .map(|[x, y]| vec![a * x, b * y])
                    .collect::<Vec<_>>(),
            );
            gliding.extend(onward.iter().map(|piece| {
                piece
                    .iter()
                    .map(|row| vec![a * row[0], b * row[1], w])
                    .collect::<Vec<_>>()
            }));
            changes.push(vec![a * end.theta, b * end.theta_rate]);
        }
    }
    let flow_r = rolling.iter().filter_map(|piece: &Piece| {
        let middle = piece.len() / 2;
        Some(in_time(piece.get(middle)?, piece.get(middle + 1)?))
    });
    let flow_r = flow_r.collect();
    let flow_g = gliding.iter().filter_map(|piece: &Piece| {
        let beyond = |row: &[f64]| row[0].abs() - 0.62 * PI;
        let at = piece
            .windows(2)
            .find(|pair| beyond(&pair[1]) * beyond(&pair[0]) <= 0.0)?;
        Some(in_time(&at[0], &at[1]))
    });
    let flow_g = flow_g.collect();
    // Gliding elsewhere: the lines of Figure 6(a), as far as they run outside 𝓡.
    let outside = |row: &Vec<f64>| row[0].abs() > theta_s || row[1].abs() > 1.0;
    let mut elsewhere = Vec::new();
    for w in [-0.75, -0.4, 0.0, 0.35, 1.4, 1.9, 2.6, 3.6] {
        let v = fastest(&body, w);
        for side in [1.0, -1.0] {
            for piece in line_of(&body, w, side, [-v, v]) {
                elsewhere.extend(
                    piece
                        .split(|row| !outside(row))
                        .filter(|part| part.len() > 1)
                        .map(<[_]>::to_vec),
                );
            }
        }
    }
    layers.push(
        Series::new("gliding elsewhere", &COLUMNS, elsewhere).drawn(Stroke::solid(FAINT, FINE)),
    );
    layers.push(Series::new("gliding", &COLUMNS, gliding).drawn(GLIDING.wide(THIN)));
    layers.push(
        Series::new("rolling", &PLANE, rolling).drawn(Stroke::of_mode(Mode::Rolling).wide(THIN)),
    );
    let manifolds = Portrait {
        window: Window {
            x: [-theta_s, theta_s],
            y: [-1.0, 1.0],
        },
        ..portrait
    }
    .separatrix();
    layers.push(manifolds.drawn(Curve::Separatrix));
    if let Some((_, limit)) = portrait.massless_limit() {
        layers.push(limit.drawn(Curve::SlipLimit));
    }
    layers.push(unloading_lines(theta_s).drawn(Curve::NormalForceZero));
    layers.push(Series::new("flow", &COLUMNS, flow_g).drawn(Mark::Head(GLIDING.colour)));
    let of_rolling = Mark::Head(Stroke::of_mode(Mode::Rolling).colour);
    layers.push(Series::new("flow of rolling", &PLANE, flow_r).drawn(of_rolling));
    layers.push(Series::of_rows("transition", &PLANE, changes).drawn(TRANSITION));
    layers.extend(portrait.equilibria());
    let labels = vec![
        Label::new("rolls", &[0.0, 0.63]).coloured(Stroke::of_mode(Mode::Rolling).colour),
        Label::new("glides", &[0.72 * PI, 1.3]).coloured(GLIDING.colour),
        Label::new("glides", &[-0.72 * PI, -1.3]).coloured(GLIDING.colour),
        Label::new("𝓡", &[-0.72 * theta_s, 0.0]).sized(20.0),
    ];
    let caption = format!(
        "Rolling (in 𝓡, shaded) and gliding (outside it) of the massless hoop together. Motions leave 𝓡 where static \
         friction gives way (*f*, dashed) or the normal force vanishes (*n*) at the diamonds and glide on along a line of constant *w* to *θ* = ±π. \
         Gliding motions that enter 𝓡 become rolling ones only if *η*′ = 0 there. Black: stable and unstable manifolds of \
         the equilibrium. *μ*_{{s}} = {}. Gliding by the corrected integral, see Figure 6(a); grey: other gliding motions, outside 𝓡.",
        short(input.hoop.mu_s())
    );
    figure(
        input,
        [NAME, "Figure 6(b): combined phase portrait"],
        caption,
        (layers, labels),
    )
}
