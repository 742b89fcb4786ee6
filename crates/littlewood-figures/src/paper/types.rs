//! Figure 5: the region 𝓡 of the massless hoop and the three types of motion in it.

use core::f64::consts::{FRAC_PI_2, PI};

use littlewood::theory::closed_form::{
    rolling_energy, stable_manifold_rate, unstable_manifold_rate,
};
use littlewood::theory::{RollingType, Window};
use littlewood::{Hoop, Mode, Start};
use littlewood_draw::{
    Entries, FRICTION_FORCE, Figure, INK, LETTER, Label, Layer, Mark, NORMAL_FORCE, PAPER, REGION,
    Rgb, Series, Stroke, THEME, short, width,
};
use littlewood_style::ticks::Tick;
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash, of_mode};

use crate::columns::{ORBIT, PLANE};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Portrait, in_time, mirrored, rows_with, unloading_lines};

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

/// A place of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    theta: f64,
    rate: f64,
}

impl Place {
    const fn at(theta: f64, rate: f64) -> Self {
        Self { theta, rate }
    }

    const fn row(self) -> [f64; 2] {
        [self.theta, self.rate]
    }

    /// The type of a motion that rolls from here, as the core has it.
    fn kind(self, hoop: &Hoop) -> Option<RollingType> {
        let found = hoop.classify(Start::at(self.theta, self.rate)).ok()?;
        found.rolling_type
    }
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
    fn of(Place { theta, rate }: Place) -> Self {
        match (rolling_energy(theta, rate) > 1.0, theta > 0.0, rate > 0.0) {
            (true, _, true) => Self::Above,
            (true, _, false) => Self::Below,
            (false, true, _) => Self::Right,
            (false, false, _) => Self::Left,
        }
    }

    /// The place on its axis at a share of the way out.
    const fn place(self, share: f64, theta_s: f64) -> Place {
        match self {
            Self::Above => Place::at(0.0, share),
            Self::Below => Place::at(0.0, -share),
            Self::Left => Place::at(-share * theta_s, 0.0),
            Self::Right => Place::at(share * theta_s, 0.0),
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

/// Where Figure 5 is drawn.
struct Ground<'a> {
    input: &'a FigureInput,
    portrait: Portrait,
    theta_s: f64,
    /// Parts of the plane to a pixel, to the right and upwards.
    to_a_pixel: Place,
}

impl<'a> Ground<'a> {
    fn new(input: &'a FigureInput) -> Result<Self, FigureError> {
        let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
        let side = f64::min(1.45 * theta_s, PI);
        let window = Window {
            x: [-side, side],
            y: [-MOST, MOST],
        };
        let Window { x, y } = window;
        let [wide, tall] = input.plane_size()?;
        Ok(Self {
            input,
            portrait: Portrait::new(&input.hoop, window),
            theta_s,
            to_a_pixel: Place::at((x[1] - x[0]) / wide, (y[1] - y[0]) / tall),
        })
    }

    fn mu_s(&self) -> f64 {
        self.input.hoop.mu_s()
    }

    /// The energy of Type II.
    fn energy_of_two(&self) -> f64 {
        RollingType::energy_of_ii(self.mu_s())
    }

    /// 𝓡.
    fn region(&self) -> Window {
        Window {
            x: [-self.theta_s, self.theta_s],
            y: [-1.0, 1.0],
        }
    }

    /// Whether the name of a type has room about a place in a part of its region, in a box so much
    /// larger.
    fn fits(&self, kind: RollingType, part: Part, at: Place, larger: f64) -> bool {
        let wide = 0.5 * width(&name_of(kind), LETTER) + ABOUT;
        let high = 0.5 * LETTER + ABOUT;
        let sides = [-1.0, -0.5, 0.0, 0.5, 1.0];
        let mut around = sides
            .iter()
            .flat_map(|a| [[*a, -1.0], [*a, 1.0], [-1.0, *a], [1.0, *a]]);
        around.all(|[right, up]| {
            let place = Place::at(
                at.theta + larger * right * wide * self.to_a_pixel.theta,
                at.rate + larger * up * high * self.to_a_pixel.rate,
            );
            // Beyond π angles begin again.
            place.theta.abs() < self.theta_s
                && Part::of(place) == part
                && place.kind(&self.input.hoop) == Some(kind)
        })
    }

    /// The name of a type in the middle of each part of its region that has room for it.
    fn names_inside(&self, kind: RollingType) -> Vec<Label> {
        let in_part = |part: Part| {
            let places = (1..PLACES).map(|i| f64::from(i) / f64::from(PLACES));
            let places = places.map(|share| part.place(share, self.theta_s));
            LARGER.into_iter().find_map(|larger| {
                let free: Vec<Place> = places
                    .clone()
                    .filter(|at| self.fits(kind, part, *at, larger))
                    .collect();
                free.get(free.len() / 2).copied()
            })
        };
        let places = Part::ALL.into_iter().filter_map(in_part);
        places
            .map(|at| Label::new(name_of(kind), &at.row()).fixed())
            .collect()
    }

    /// The name of a type beside 𝓡, on either side, with a line to its region.
    fn names_beside(&self, kind: RollingType) -> (Vec<Layer>, [Label; 2]) {
        let (name, energy) = (name_of(kind), self.energy_of_two());
        // Where the line begins, where it ends, and where the name stands, to the right.
        let (from, to, label) = match kind {
            // A strip below n.
            RollingType::I | RollingType::II => {
                let theta = BESIDE * self.theta_s;
                let cos = libm::cos(theta);
                let least = ((energy - cos) / (1.0 + cos)).max(0.0).sqrt();
                let label = Label::new(&*name, &[theta, BEYOND]);
                (theta, Place::at(theta, 0.5 * (least + 1.0)), label)
            }
            // A strip beside f, from beyond f.
            RollingType::III => {
                let theta = 0.5 * (libm::acos(energy.clamp(-1.0, 1.0)) + self.theta_s);
                let edge = self.portrait.window.x[1];
                let label = Label::new(&*name, &[edge, BEYOND]).shifted(-ABOUT, 0.0);
                (
                    0.5 * (self.theta_s + edge),
                    Place::at(theta, 0.0),
                    label.right(),
                )
            }
        };
        let below = BEYOND - (0.5 * LETTER + ABOUT) * self.to_a_pixel.rate;
        let lines = [1.0, -1.0].map(|side| {
            let begin = [side * from, side * below];
            [begin, to.row().map(|it| side * it)]
        });
        let layers = vec![
            Series::new(format!("to {name}"), &PLANE, lines).drawn(Stroke::solid(INK, FINE)),
            Series::of_rows(format!("in {name}"), &PLANE, lines.map(|line| line[1]))
                .drawn(Mark::Dot(INK, 1.8)),
        ];
        let [label, left] = mirrored(label, 0);
        let [_, other] = mirrored(left, 1);
        (layers, [label, other].map(Label::fixed))
    }

    /// Names of the types in their regions; if none has room, beside 𝓡.
    fn names_of_types(&self) -> (Vec<Layer>, Vec<Label>) {
        let (mut layers, mut labels) = (Vec::new(), Vec::new());
        for kind in [RollingType::I, RollingType::III] {
            let inside = self.names_inside(kind);
            if inside.is_empty() {
                let (lines, beside) = self.names_beside(kind);
                layers.extend(lines);
                labels.extend(beside);
            }
            labels.extend(inside);
        }
        (layers, labels)
    }

    /// An orbit as far as it runs in 𝓡.
    fn in_region(&self, energy: f64) -> Vec<Vec<[f64; 2]>> {
        let inner = Portrait {
            window: self.region(),
            ..self.portrait
        };
        let pieces = inner.orbit(energy).pieces.into_iter();
        pieces
            .map(|piece| piece.into_iter().map(|row| [row[0], row[1]]).collect())
            .collect()
    }

    /// *f* and *n*.
    fn bounds(&self) -> impl Iterator<Item = Layer> {
        let limit = self.portrait.massless_limit();
        let limit = limit.map(|(_, series)| series.drawn(Curve::SlipLimit));
        let n = unloading_lines(self.theta_s).drawn(Curve::NormalForceZero);
        limit.into_iter().chain([n])
    }

    fn figure(
        self,
        name: &'static str,
        title: &str,
        caption: String,
        layers: Vec<Layer>,
        labels: Vec<Label>,
        keys: Entries,
    ) -> Result<Figure, FigureError> {
        let say = self.input.wording();
        let own = [1.0, -1.0].map(|sign: f64| Tick {
            value: sign * self.theta_s,
            label: format!("{}*θ*_{{s}}", if sign < 0.0 { "−" } else { "" }),
        });
        let mut content = self.portrait.content("plane", say, layers, labels);
        content.x = say.angle_with(self.portrait.window.x.into(), own.to_vec());
        self.input.plane(name, title, caption, content, keys)
    }
}

/// The names of *n* and *f*, on both sides.
fn names_of_bounds(n: Label, f: Label) -> impl Iterator<Item = Label> {
    let n = mirrored(n.coloured(NORMAL_FORCE), 1);
    n.into_iter().chain(mirrored(f.coloured(FRICTION_FORCE), 0))
}

const NOTE: &str =
    "The caption of the paper has *θ*_{s} = 26.5651°, which is half of *θ*_{s} by (3.9).";

/// A manifold of the equilibrium.
struct Manifold {
    name: &'static str,
    flow: &'static str,
    rate: fn(f64) -> f64,
    /// The next place along the flow, towards the equilibrium or away from it.
    onward: f64,
}

const MANIFOLDS: [Manifold; 2] = [
    Manifold {
        name: "Ws",
        flow: "flow on Ws",
        rate: stable_manifold_rate,
        onward: 0.98,
    },
    Manifold {
        name: "Wu",
        flow: "flow on Wu",
        rate: unstable_manifold_rate,
        onward: 1.02,
    },
];

impl Manifold {
    fn line(&self, window: Window) -> Layer {
        let pieces = window.pieces(window.x, 200, &|theta| Some([theta, (self.rate)(theta)]));
        Series::new(self.name, &PLANE, pieces).drawn(Curve::Separatrix)
    }

    /// Arrows on both halves, which reach so far.
    fn heads(&self, reach: f64) -> Layer {
        let head = |share: f64| {
            [share * reach, self.onward * share * reach].map(|theta| [theta, (self.rate)(theta)])
        };
        Series::new(self.flow, &PLANE, [0.6, -0.6].map(head)).drawn(Mark::Head(INK))
    }
}

/// Figure 5(a).
pub(crate) fn regions(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-5a";
    input.littlewood_that_rolls(NAME)?;
    let ground = Ground::new(input)?;
    let (mu_s, theta_s, two) = (ground.mu_s(), ground.theta_s, ground.energy_of_two());
    let mut layers = vec![
        ground.portrait.rolling_region().drawn(Mark::Fill(REGION)),
        Series::new("Type I", &PLANE, region_of_one(mu_s, theta_s))
            .drawn(Mark::Fill(of_mode(Mode::Rolling, THEME).over(PAPER, 0.3))),
        Series::new("Type II", &PLANE, motions_of_two(mu_s, theta_s))
            .drawn(Stroke::solid(INK, CURVE).dashed(Dash::DashDot)),
    ];
    layers.extend(MANIFOLDS.iter().map(|it| it.line(ground.region())));
    layers.extend(ground.bounds());
    layers.extend(ground.portrait.equilibria());
    // The manifolds leave 𝓡 through f, or through n, which they cross at ±π/2.
    let reach = f64::min(theta_s, FRAC_PI_2);
    layers.extend(MANIFOLDS.iter().map(|it| it.heads(reach)));
    let on_two = if two >= 1.0 {
        let theta = 0.56 * theta_s;
        let cos = libm::cos(theta);
        [theta, ((two - cos) / (1.0 + cos)).sqrt()]
    } else {
        [libm::acos((two - 0.25) / 1.25), 0.5]
    };
    let (lines, mut labels) = ground.names_of_types();
    layers.extend(lines);
    let manifold = |share: f64, rate: fn(f64) -> f64| [share * reach, rate(share * reach)];
    labels.extend([
        Label::new("Type II", &on_two).sized(12.5),
        Label::new("*W*^{s}", &manifold(-0.8, stable_manifold_rate)).shifted(8.0, -10.0),
        Label::new("*W*^{u}", &manifold(0.8, unstable_manifold_rate)).shifted(-8.0, -10.0),
    ]);
    let f = Label::new("*f*", &[theta_s, 0.0]).shifted(10.0, 0.0).left();
    let n = Label::new("*n*: *N* = 0", &[0.0, 1.0]).shifted(0.0, -14.0);
    labels.extend(names_of_bounds(n, f));
    labels.push(
        Label::new("𝓡", &[-0.88 * theta_s, -0.86])
            .sized(20.0)
            .of_area(),
    );
    let [degrees, two, mu_s] = [theta_s.to_degrees(), two, mu_s].map(short);
    let caption = format!(
        "The region 𝓡 of the rolling massless hoop and what ends a motion in it. On *n* the normal force vanishes; on \
         *f* static friction gives way, at *θ* = ±*θ*_{{s}} with *θ*_{{s}} = 2 atan *μ*_{{s}} = {degrees}° (3.9). Type I \
         (darker), 1 + 2 cos *θ*_{{s}} = {two} < *e* < 3: *N* vanishes first. Type II, dash-dotted, *e* = {two}: both at once. \
         Type III, *e* < {two}: static friction gives way first. A motion on the stable manifold *W*^{{s}}, *e* = 1, has no \
         type: it comes to the top. *μ*_{{s}} = {mu_s}. {NOTE}"
    );
    let title = "Figure 5(a): the region 𝓡 and its boundaries";
    ground.figure(NAME, title, caption, layers, labels, Vec::new())
}

/// How motions of a type are drawn.
fn stroke_of(kind: RollingType) -> Stroke {
    Stroke::of_mode(Mode::Rolling)
        .wide(CURVE)
        .dashed(match kind {
            RollingType::I => Dash::Solid,
            RollingType::II => Dash::DashDot,
            RollingType::III => Dash::Short,
        })
}

/// Energies of motions that turn, and of those that pass over the top: some on either side of Type
/// II, and Type II.
fn energies(ground: &Ground<'_>) -> Vec<f64> {
    let two = ground.energy_of_two();
    let bounds = [
        libm::cos(ground.theta_s),
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
    energies
}

/// Motions of all types, with where they end and arrows of their flow.
#[derive(Default)]
struct Motions {
    lines: Vec<Layer>,
    exits: Vec<[f64; 3]>,
    heads: Vec<(Rgb, [[f64; 2]; 2])>,
}

impl Motions {
    fn add(&mut self, ground: &Ground<'_>, kind: RollingType, energy: f64) {
        let stroke = stroke_of(kind);
        let orbit = match kind {
            RollingType::II => motions_of_two(ground.mu_s(), ground.theta_s),
            RollingType::I | RollingType::III => ground.in_region(energy),
        };
        for piece in &orbit {
            // Orbits run to the right where θ′ > 0.
            let later = |a: [f64; 2], b: [f64; 2]| if a[0] * a[1] >= b[0] * b[1] { a } else { b };
            let exit = piece.iter().copied().reduce(later);
            self.exits
                .extend(exit.map(|[theta, rate]| [theta, rate, energy]));
            let i = piece.len() * 2 / 3;
            if let Some([a, b]) = piece.get(i..i + 2) {
                self.heads.push((stroke.colour, in_time(*a, *b)));
            }
        }
        let series = Series::new(name_of(kind), &ORBIT, rows_with(orbit, energy));
        self.lines.push(series.drawn(stroke));
    }
}

/// Figure 5(b).
pub(crate) fn motions(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-5b";
    input.littlewood_that_rolls(NAME)?;
    let ground = Ground::new(input)?;
    let (mu_s, theta_s) = (ground.mu_s(), ground.theta_s);
    let energies = energies(&ground);
    let mut motions = Motions::default();
    for kind in RollingType::ALL {
        let is_own = |energy: &&f64| RollingType::of_energy(**energy, mu_s) == Some(kind);
        for energy in energies.iter().filter(is_own) {
            motions.add(&ground, kind, *energy);
        }
    }
    let mut layers = vec![ground.portrait.rolling_region().drawn(Mark::Fill(REGION))];
    layers.extend(motions.lines);
    let manifolds = Series::new("manifolds", &PLANE, ground.in_region(1.0));
    layers.push(manifolds.drawn(Stroke::of_curve(Curve::Separatrix).wide(FINE)));
    layers.extend(ground.bounds());
    for (colour, head) in motions.heads {
        layers.push(Series::of_rows("flow", &PLANE, head).drawn(Mark::Head(colour)));
    }
    let ends = Series::of_rows("end of rolling", &ORBIT, motions.exits);
    layers.push(ends.drawn(Mark::Dot(INK, 3.0)));
    layers.extend(ground.portrait.equilibria());
    let f = Label::new("*f*", &[theta_s, 0.0]).shifted(12.0, 0.0);
    let n = Label::new("*n*", &[0.0, 1.0]).shifted(0.0, -12.0);
    let labels = names_of_bounds(n, f).collect();
    let caption = format!(
        "Rolling motions of the massless hoop in 𝓡, each to the place where rolling ends (dots). Type I ends on *n*, \
         where the normal force vanishes; Type III on *f*, where static friction gives way; Type II in a corner, where \
         both happen. Thin: the stable and unstable manifolds of the equilibrium. *μ*_{{s}} = {}, *θ*_{{s}} = {}°. \
         {NOTE}",
        short(mu_s),
        short(theta_s.to_degrees())
    );
    let keys = RollingType::ALL.map(|kind| (Mark::Line(stroke_of(kind)), name_of(kind)));
    let title = "Figure 5(b): motions of Types I, II and III";
    ground.figure(NAME, title, caption, layers, labels, keys.into())
}
