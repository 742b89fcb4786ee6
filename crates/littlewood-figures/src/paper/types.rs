//! Figure 5: the region 𝓡 of the massless hoop and the three types of motion in it.

use littlewood::Mode;
use littlewood::theory::closed_form::{
    rolling_energy, stable_manifold_rate, unstable_manifold_rate,
};
use littlewood_draw::{
    Entries, FRICTION_FORCE, Figure, INK, Label, Layer, Mark, NORMAL_FORCE, PAPER, REGION, Series,
    Stroke, THEME, short,
};

use crate::columns::{ENERGY, PLANE, THETA, THETA_RATE};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Portrait, in_time, rows, unloading_lines};
use littlewood::theory::Window;
use littlewood_style::ticks::Tick;
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash, of_mode};

/// The part of the plane with 𝓡 in it, and θ_s.
fn portrait_of(input: &FigureInput) -> (Portrait, f64) {
    let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
    let side = f64::min(1.45 * theta_s, 3.1);
    (
        Portrait::new(
            &input.hoop,
            Window {
                x: [-side, side],
                y: [-1.35, 1.35],
            },
        ),
        theta_s,
    )
}

/// Energy at the corners of 𝓡, where N and the static friction give way together: Type II.
fn type_two_energy(theta_s: f64) -> f64 {
    rolling_energy(theta_s, 1.0)
}

/// An orbit as far as it runs in 𝓡.
fn in_region(portrait: &Portrait, theta_s: f64, energy: f64) -> Vec<Vec<[f64; 2]>> {
    let inner = Portrait {
        window: Window {
            x: [-theta_s, theta_s],
            y: [-1.0, 1.0],
        },
        ..*portrait
    };
    inner
        .orbit(energy)
        .pieces
        .into_iter()
        .map(|piece| piece.into_iter().map(|row| [row[0], row[1]]).collect())
        .collect()
}

fn frame(portrait: &Portrait, theta_s: f64) -> impl Iterator<Item = Layer> {
    let limit = portrait
        .massless_limit()
        .map(|(_, series)| series.drawn(Curve::SlipLimit));
    limit
        .into_iter()
        .chain([unloading_lines(theta_s).drawn(Curve::NormalForceZero)])
}

const NOTE: &str =
    "The caption of the paper has *θ*_{s} = 26.5651°, which is half of *θ*_{s} by (3.9).";

fn figure(
    input: &FigureInput,
    name: [&'static str; 2],
    caption: String,
    drawn: (Vec<Layer>, Vec<Label>),
    keys: Entries,
) -> Result<Figure, FigureError> {
    let (portrait, theta_s) = portrait_of(input);
    let (say, Window { x, y }) = (input.wording(), portrait.window);
    let own = [1.0, -1.0].map(|sign: f64| Tick {
        value: sign * theta_s,
        label: format!("{}*θ*_{{s}}", if sign < 0.0 { "−" } else { "" }),
    });
    let x = say.angle_with(x, own.to_vec());
    input.plane(name, caption, [x, say.rate(y)], drawn, keys)
}

/// Figure 5(a).
pub(crate) fn regions(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-5a";
    input.littlewood_that_rolls(NAME)?;
    let (portrait, theta_s) = portrait_of(input);
    let two = type_two_energy(theta_s);
    // Type I is between the orbit of Type II and the lines n.
    let border = in_region(&portrait, theta_s, two);
    let unloaded_first = border
        .iter()
        .map(|piece| {
            let edge = if piece.iter().all(|[_, rate]| *rate >= 0.0) {
                1.0
            } else {
                -1.0
            };
            let mut polygon = piece.clone();
            polygon.push([theta_s, edge]);
            polygon.push([-theta_s, edge]);
            polygon
        })
        .collect();
    let mut layers = vec![
        portrait.rolling_region().drawn(Mark::Fill(REGION)),
        Series::new("Type I", &PLANE, rows(unloaded_first))
            .drawn(Mark::Fill(of_mode(Mode::Rolling, THEME).over(PAPER, 0.3))),
        Series::new("Type II", &PLANE, rows(border))
            .drawn(Stroke::solid(INK, CURVE).dashed(Dash::DashDot)),
    ];
    let window = Window {
        x: [-theta_s, theta_s],
        y: [-1.0, 1.0],
    };
    // Towards the equilibrium, and away from it.
    type Manifold = (&'static str, &'static str, fn(f64) -> f64, f64);
    let manifolds: [Manifold; 2] = [
        ("Ws", "flow on Ws", stable_manifold_rate, 0.98),
        ("Wu", "flow on Wu", unstable_manifold_rate, 1.02),
    ];
    for (name, _, rate, _) in manifolds {
        let pieces = window.pieces(window.x, 200, &|theta| Some([theta, rate(theta)]));
        layers.push(Series::new(name, &PLANE, rows(pieces)).drawn(Curve::Separatrix));
    }
    layers.extend(frame(&portrait, theta_s));
    layers.extend(portrait.equilibria());
    for (_, name, rate, onward) in manifolds {
        let head = |share: f64| {
            [share * theta_s, onward * share * theta_s]
                .map(|theta| vec![theta, rate(theta)])
                .to_vec()
        };
        let heads = [0.6, -0.6].map(head);
        layers.push(Series::new(name, &PLANE, heads.to_vec()).drawn(Mark::Head(INK)));
    }

    let middle = 0.5 * (1.0 + libm::sqrt((two - 1.0) / 2.0));
    let labels = vec![
        Label::new("Type I", &[0.0, middle]),
        Label::new("Type I", &[0.0, -middle]),
        Label::new("Type III", &[0.0, 0.42]),
        Label::new("Type III", &[0.0, -0.42]),
        Label::new("Type III", &[0.68 * theta_s, 0.0]),
        Label::new("Type III", &[-0.68 * theta_s, 0.0]),
        Label::new(
            "Type II",
            &[
                0.56 * theta_s,
                libm::sqrt((two - libm::cos(0.56 * theta_s)) / (1.0 + libm::cos(0.56 * theta_s))),
            ],
        )
        .sized(12.5),
        Label::new(
            "*W*^{s}",
            &[-0.8 * theta_s, stable_manifold_rate(-0.8 * theta_s)],
        )
        .shifted(8.0, -10.0),
        Label::new(
            "*W*^{u}",
            &[0.8 * theta_s, unstable_manifold_rate(0.8 * theta_s)],
        )
        .shifted(-8.0, -10.0),
        Label::new("*n*: *N* = 0", &[0.0, 1.0])
            .shifted(0.0, -14.0)
            .coloured(NORMAL_FORCE),
        Label::new("*n*: *N* = 0", &[0.0, -1.0])
            .shifted(0.0, 14.0)
            .coloured(NORMAL_FORCE),
        Label::new("*f*", &[theta_s, 0.0])
            .shifted(10.0, 0.0)
            .left()
            .coloured(FRICTION_FORCE),
        Label::new("*f*", &[-theta_s, 0.0])
            .shifted(-10.0, 0.0)
            .right()
            .coloured(FRICTION_FORCE),
        Label::new("𝓡", &[-0.88 * theta_s, -0.86]).sized(20.0),
    ];
    let caption = format!(
        "The region 𝓡 of the rolling massless hoop and what ends a motion in it. On *n* the normal force vanishes; on \
         *f* static friction gives way, at *θ* = ±*θ*_{{s}} with *θ*_{{s}} = 2 atan *μ*_{{s}} = {}° (3.9). Type I, 1 + \
         2 cos *θ*_{{s}} < *e* < 3: *N* vanishes first. Type II, dash-dotted: both at once. Type III: static friction \
         gives way first, unless the motion lies on the stable manifold *W*^{{s}}. *μ*_{{s}} = {}. {NOTE}",
        short(theta_s.to_degrees()),
        short(input.hoop.mu_s())
    );
    figure(
        input,
        [NAME, "Figure 5(a): the region 𝓡 and its boundaries"],
        caption,
        (layers, labels),
        Vec::new(),
    )
}

/// Figure 5(b).
pub(crate) fn motions(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-5b";
    input.littlewood_that_rolls(NAME)?;
    let (portrait, theta_s) = portrait_of(input);
    let two = type_two_energy(theta_s);
    let top = libm::cos(theta_s);
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    let share = |from: f64, to: f64, part: f64| from + (to - from) * part;
    let of_type = Stroke::of_mode(Mode::Rolling).wide(CURVE);
    let kinds: [(&str, Vec<f64>, Stroke); 3] = [
        (
            "Type I",
            vec![share(two, 3.0, 0.35), share(two, 3.0, 0.72)],
            of_type.dashed(Dash::Solid),
        ),
        ("Type II", vec![two], of_type.dashed(Dash::DashDot)),
        (
            "Type III",
            vec![
                share(1.0, two, 0.2),
                share(1.0, two, 0.6),
                share(top, 1.0, 0.3),
                share(top, 1.0, 0.62),
                share(top, 1.0, 0.88),
            ],
            of_type.dashed(Dash::Short),
        ),
    ];
    let (mut exits, mut heads, mut keys) = (Vec::new(), Vec::new(), Vec::new());
    for (name, energies, stroke) in kinds {
        keys.push((Mark::Line(stroke), name.to_owned()));
        for energy in energies {
            let orbit: Vec<Vec<[f64; 2]>> = in_region(&portrait, theta_s, energy);
            for piece in &orbit {
                // Orbits run to the right where θ′ > 0.
                let exit = piece
                    .iter()
                    .copied()
                    .reduce(|a, b| if a[0] * a[1] >= b[0] * b[1] { a } else { b });
                exits.extend(exit.map(|[theta, rate]| vec![theta, rate, energy]));
                let i = piece.len() * 2 / 3;
                if let Some([a, b]) = piece.get(i..i + 2).and_then(<[_]>::first_chunk) {
                    heads.push((stroke.colour, in_time(a, b)));
                }
            }
            let pieces = orbit
                .into_iter()
                .map(|piece| {
                    piece
                        .into_iter()
                        .map(|[theta, rate]| vec![theta, rate, energy])
                        .collect()
                })
                .collect();
            layers.push(Series::new(name, &[THETA, THETA_RATE, ENERGY], pieces).drawn(stroke));
        }
    }
    let manifolds = Series::new(
        "manifolds",
        &PLANE,
        rows(in_region(&portrait, theta_s, 1.0)),
    );
    layers.push(manifolds.drawn(Stroke::of_curve(Curve::Separatrix).wide(FINE)));
    layers.extend(frame(&portrait, theta_s));
    for (colour, piece) in heads {
        layers.push(Series::new("flow", &PLANE, vec![piece]).drawn(Mark::Head(colour)));
    }
    layers.push(
        Series::of_rows("end of rolling", &[THETA, THETA_RATE, ENERGY], exits)
            .drawn(Mark::Dot(INK, 3.0)),
    );
    layers.extend(portrait.equilibria());
    let labels = vec![
        Label::new("*n*", &[0.0, 1.0])
            .shifted(0.0, -12.0)
            .coloured(NORMAL_FORCE),
        Label::new("*n*", &[0.0, -1.0])
            .shifted(0.0, 12.0)
            .coloured(NORMAL_FORCE),
        Label::new("*f*", &[theta_s, 0.0])
            .shifted(12.0, 0.0)
            .coloured(FRICTION_FORCE),
        Label::new("*f*", &[-theta_s, 0.0])
            .shifted(-12.0, 0.0)
            .coloured(FRICTION_FORCE),
    ];
    let caption = format!(
        "Rolling motions of the massless hoop in 𝓡, each to the place where rolling ends (dots). Type I ends on *n*, \
         where the normal force vanishes; Type III on *f*, where static friction gives way; Type II in a corner, where \
         both happen. Thin: the stable and unstable manifolds of the equilibrium. *μ*_{{s}} = {}, *θ*_{{s}} = {}°. \
         {NOTE}",
        short(input.hoop.mu_s()),
        short(theta_s.to_degrees())
    );
    figure(
        input,
        [NAME, "Figure 5(b): motions of Types I, II and III"],
        caption,
        (layers, labels),
        keys,
    )
}
