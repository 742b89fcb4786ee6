//! Figure 5: the region 𝓡 of the massless hoop and the three types of motion in it.

use core::f64::consts::{FRAC_PI_2, PI};

use littlewood::theory::closed_form::{
    rolling_energy, stable_manifold_rate, unstable_manifold_rate,
};
use littlewood::theory::{RollingType, Window};
use littlewood::{Hoop, Mode, Start};
use littlewood_draw::{
    Entries, FRICTION_FORCE, Figure, INK, LETTER, Label, Layer, Mark, NORMAL_FORCE, PAPER, Piece,
    REGION, Series, Stroke, THEME, short, width,
};

use crate::columns::{ENERGY, PLANE, THETA, THETA_RATE};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Portrait, in_time, rows, unloading_lines};
use littlewood_style::ticks::Tick;
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash, of_mode};

/// Rates from the axis of the plane to its end.
const MOST: f64 = 1.35;
/// Where a name stands that has no room in its region: at this rate, beyond *n*; that of Type I at
/// this part of θ_s.
const BEYOND: f64 = 1.19;
const BESIDE: f64 = 0.55;
/// Room about the letters of a name in its region, and from them to their line, in pixels.
const ABOUT: f64 = 4.0;
/// Places at which a name is tried, and how much larger than it is its box may be.
const PLACES: u32 = 100;
const LARGER: [f64; 6] = [3.0, 2.5, 2.0, 1.6, 1.3, 1.0];
/// Points of the orbit of Type II.
const POINTS: u32 = 160;

/// The part of the plane with 𝓡 in it, and θ_s.
fn portrait_of(input: &FigureInput) -> (Portrait, f64) {
    let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
    let side = f64::min(1.45 * theta_s, PI);
    (
        Portrait::new(
            &input.hoop,
            Window {
                x: [-side, side],
                y: [-MOST, MOST],
            },
        ),
        theta_s,
    )
}

/// The type of a motion that rolls from here, as the core has it.
fn type_of(hoop: &Hoop, [theta, rate]: [f64; 2]) -> Option<RollingType> {
    let found = hoop.classify(Start::at(theta, rate)).ok()?;
    found.rolling_type
}

/// Which of the four parts into which the manifolds of the equilibrium divide 𝓡.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Above,
    Below,
    Left,
    Right,
}

impl Part {
    const ALL: [Self; 4] = [Self::Above, Self::Below, Self::Left, Self::Right];

    /// Motions that pass over the top have more energy than at rest there.
    fn of([theta, rate]: [f64; 2]) -> Self {
        match (rolling_energy(theta, rate) > 1.0, theta > 0.0, rate > 0.0) {
            (true, _, true) => Self::Above,
            (true, _, false) => Self::Below,
            (false, true, _) => Self::Right,
            (false, false, _) => Self::Left,
        }
    }

    /// The place on its axis at a share of the way out.
    fn place(self, share: f64, theta_s: f64) -> [f64; 2] {
        match self {
            Self::Above => [0.0, share],
            Self::Below => [0.0, -share],
            Self::Left => [-share * theta_s, 0.0],
            Self::Right => [share * theta_s, 0.0],
        }
    }
}

fn name_of(kind: RollingType) -> String {
    format!("Type {kind}")
}

/// The orbit of Type II, from corner to corner of 𝓡: by the angle where it passes over the top, by
/// the rate where it turns.
fn orbit_of_two(mu_s: f64, theta_s: f64) -> [Vec<[f64; 2]>; 2] {
    let energy = RollingType::energy_of_ii(mu_s);
    let shares = (0..=POINTS).map(|i| 2.0 * f64::from(i) / f64::from(POINTS) - 1.0);
    let upper_or_right: Vec<[f64; 2]> = if energy >= 1.0 {
        let rate = |theta: f64| {
            let cos = libm::cos(theta);
            ((energy - cos) / (1.0 + cos)).sqrt()
        };
        shares
            .map(|share| [share * theta_s, rate(share * theta_s)])
            .collect()
    } else {
        let angle = |rate: f64| {
            let square = rate * rate;
            libm::acos((energy - square) / (1.0 + square))
        };
        shares.map(|rate| [angle(rate), rate]).collect()
    };
    let mirrored = upper_or_right.iter().map(|[theta, rate]| {
        if energy >= 1.0 {
            [*theta, -rate]
        } else {
            [-theta, *rate]
        }
    });
    [mirrored.collect(), upper_or_right.clone()]
}

/// The motions of Type II: of an orbit that meets the equilibrium, those that leave it.
fn motions_of_two(mu_s: f64, theta_s: f64) -> Vec<Vec<[f64; 2]>> {
    let mut pieces = orbit_of_two(mu_s, theta_s).to_vec();
    if RollingType::energy_of_ii(mu_s) == 1.0 {
        for piece in &mut pieces {
            piece.retain(|[theta, rate]| theta * rate >= 0.0);
        }
    }
    pieces
}

/// Type I: between the orbits of Type II and the lines n.
fn region_of_one(mu_s: f64, theta_s: f64) -> Vec<Vec<[f64; 2]>> {
    let [first, second] = orbit_of_two(mu_s, theta_s);
    if RollingType::energy_of_ii(mu_s) < 1.0 {
        // One region, from the left orbit to the right one.
        return vec![first.into_iter().chain(second.into_iter().rev()).collect()];
    }
    let closed = |(mut piece, edge): (Vec<[f64; 2]>, f64)| {
        piece.extend([[theta_s, edge], [-theta_s, edge]]);
        piece
    };
    [(first, -1.0), (second, 1.0)].map(closed).to_vec()
}

/// Names of the types in their regions: in the middle of each part that has room for one; if none
/// has, beside 𝓡, with a line to the region.
fn names_of_types(input: &FigureInput) -> Result<(Vec<Layer>, Vec<Label>), FigureError> {
    let (portrait, theta_s) = portrait_of(input);
    let (hoop, Window { x, y }) = (&input.hoop, portrait.window);
    let [wide, tall] = input.plane_size()?;
    let to_a_pixel = [(x[1] - x[0]) / wide, (y[1] - y[0]) / tall];
    let fits = |kind: RollingType, part: Part, at: [f64; 2], larger: f64| {
        let half = [
            0.5 * width(&name_of(kind), LETTER) + ABOUT,
            0.5 * LETTER + ABOUT,
        ];
        let sides = [-1.0, -0.5, 0.0, 0.5, 1.0];
        let mut around = sides
            .iter()
            .flat_map(|a| [[*a, -1.0], [*a, 1.0], [-1.0, *a], [1.0, *a]]);
        around.all(|around| {
            let place: [f64; 2] =
                core::array::from_fn(|k| at[k] + larger * around[k] * half[k] * to_a_pixel[k]);
            // Beyond π angles begin again.
            place[0].abs() < theta_s
                && Part::of(place) == part
                && type_of(hoop, place) == Some(kind)
        })
    };
    let (mut layers, mut labels) = (Vec::new(), Vec::new());
    for kind in [RollingType::I, RollingType::III] {
        let name = name_of(kind);
        let before = labels.len();
        for part in Part::ALL {
            let places =
                || (1..PLACES).map(|i| part.place(f64::from(i) / f64::from(PLACES), theta_s));
            let roomy = LARGER.into_iter().find_map(|larger| {
                let free: Vec<_> = places()
                    .filter(|at| fits(kind, part, *at, larger))
                    .collect();
                free.get(free.len() / 2).copied()
            });
            labels.extend(roomy.map(|at| Label::new(&*name, &at).fixed()));
        }
        if labels.len() > before {
            continue;
        }
        let over = |side: f64, at: f64, target: [f64; 2], label: Label| {
            let below = BEYOND - (0.5 * LETTER + ABOUT) * to_a_pixel[1];
            let line = vec![
                vec![side * at, side * below],
                target.map(|it| side * it).to_vec(),
            ];
            (line, label)
        };
        let energy = RollingType::energy_of_ii(hoop.mu_s());
        let lines = [1.0, -1.0].map(|side| match kind {
            // A strip below n.
            RollingType::I | RollingType::II => {
                let theta = BESIDE * theta_s;
                let cos = libm::cos(theta);
                let least = ((energy - cos) / (1.0 + cos)).max(0.0).sqrt();
                let label = Label::new(&*name, &[side * theta, side * BEYOND]);
                over(side, theta, [theta, 0.5 * (least + 1.0)], label)
            }
            // A strip beside f, from beyond f.
            RollingType::III => {
                let theta = 0.5 * (libm::acos(energy.clamp(-1.0, 1.0)) + theta_s);
                let label = Label::new(&*name, &[side * x[1], side * BEYOND]);
                let label = label.shifted(-side * ABOUT, 0.0);
                let label = if side > 0.0 {
                    label.right()
                } else {
                    label.left()
                };
                over(side, 0.5 * (theta_s + x[1]), [theta, 0.0], label)
            }
        });
        let (pieces, own): (Vec<Piece>, Vec<Label>) = lines.into_iter().unzip();
        let ends = pieces.iter().map(|piece| piece[1].clone()).collect();
        layers.push(
            Series::new(format!("to {name}"), &PLANE, pieces).drawn(Stroke::solid(INK, FINE)),
        );
        layers.push(Series::of_rows(format!("in {name}"), &PLANE, ends).drawn(Mark::Dot(INK, 1.8)));
        labels.extend(own.into_iter().map(Label::fixed));
    }
    Ok((layers, labels))
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
    let mu_s = input.hoop.mu_s();
    let two = RollingType::energy_of_ii(mu_s);
    let mut layers = vec![
        portrait.rolling_region().drawn(Mark::Fill(REGION)),
        Series::new("Type I", &PLANE, rows(region_of_one(mu_s, theta_s)))
            .drawn(Mark::Fill(of_mode(Mode::Rolling, THEME).over(PAPER, 0.3))),
        Series::new("Type II", &PLANE, rows(motions_of_two(mu_s, theta_s)))
            .drawn(Stroke::solid(INK, CURVE).dashed(Dash::DashDot)),
    ];
    let window = Window {
        x: [-theta_s, theta_s],
        y: [-1.0, 1.0],
    };
    // The manifolds leave 𝓡 through f, or through n, which they cross at ±π/2.
    let reach = f64::min(theta_s, FRAC_PI_2);
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
            [share * reach, onward * share * reach]
                .map(|theta| vec![theta, rate(theta)])
                .to_vec()
        };
        let heads = [0.6, -0.6].map(head);
        layers.push(Series::new(name, &PLANE, heads.to_vec()).drawn(Mark::Head(INK)));
    }

    let on_two = if two >= 1.0 {
        let theta = 0.56 * theta_s;
        [
            theta,
            ((two - libm::cos(theta)) / (1.0 + libm::cos(theta))).sqrt(),
        ]
    } else {
        [libm::acos((two - 0.25) / 1.25), 0.5]
    };
    let (lines, mut labels) = names_of_types(input)?;
    layers.extend(lines);
    let manifold = |share: f64, rate: fn(f64) -> f64| [share * reach, rate(share * reach)];
    labels.extend([
        Label::new("Type II", &on_two).sized(12.5),
        Label::new("*W*^{s}", &manifold(-0.8, stable_manifold_rate)).shifted(8.0, -10.0),
        Label::new("*W*^{u}", &manifold(0.8, unstable_manifold_rate)).shifted(-8.0, -10.0),
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
    ]);
    let caption = format!(
        "The region 𝓡 of the rolling massless hoop and what ends a motion in it. On *n* the normal force vanishes; on \
         *f* static friction gives way, at *θ* = ±*θ*_{{s}} with *θ*_{{s}} = 2 atan *μ*_{{s}} = {}° (3.9). Type I \
         (darker), 1 + 2 cos *θ*_{{s}} = {} < *e* < 3: *N* vanishes first. Type II, dash-dotted, *e* = {}: both at once. \
         Type III, *e* < {}: static friction gives way first. A motion on the stable manifold *W*^{{s}}, *e* = 1, has no \
         type: it comes to the top. *μ*_{{s}} = {}. {NOTE}",
        short(theta_s.to_degrees()),
        short(two),
        short(two),
        short(two),
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
    let mu_s = input.hoop.mu_s();
    let two = RollingType::energy_of_ii(mu_s);
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    // Motions that turn, and motions that pass over the top: some on either side of Type II.
    let bounds = [
        libm::cos(theta_s),
        f64::min(two, 1.0),
        f64::max(two, 1.0),
        3.0,
    ];
    let shares: [&[f64]; 3] = [&[0.3, 0.62, 0.88], &[0.2, 0.6], &[0.35, 0.72]];
    let between = bounds.windows(2).zip(shares).flat_map(|(ends, shares)| {
        shares
            .iter()
            .map(|share| ends[0] + (ends[1] - ends[0]) * share)
    });
    let mut energies: Vec<f64> = between
        .filter(|energy| *energy != two)
        .chain([two])
        .collect();
    energies.sort_by(f64::total_cmp);
    let of_type = Stroke::of_mode(Mode::Rolling).wide(CURVE);
    let (mut exits, mut heads, mut keys) = (Vec::new(), Vec::new(), Vec::new());
    for kind in RollingType::ALL {
        let stroke = of_type.dashed(match kind {
            RollingType::I => Dash::Solid,
            RollingType::II => Dash::DashDot,
            RollingType::III => Dash::Short,
        });
        keys.push((Mark::Line(stroke), name_of(kind)));
        for &energy in &energies {
            if RollingType::of_energy(energy, mu_s) != Some(kind) {
                continue;
            }
            let orbit = match kind {
                RollingType::II => motions_of_two(mu_s, theta_s),
                RollingType::I | RollingType::III => in_region(&portrait, theta_s, energy),
            };
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
            layers.push(
                Series::new(name_of(kind), &[THETA, THETA_RATE, ENERGY], pieces).drawn(stroke),
            );
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
