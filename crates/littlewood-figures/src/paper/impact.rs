//! Routh's diagram of an impact: its course in the plane of the impulses J and P.

use littlewood::impact::{Compliance, ContactVelocities, Impact, ImpactVertex};
use littlewood::tables::Dimension;
use littlewood::theory::Window;
use littlewood::{Hoop, Mode, Restitution, RestitutionLaw, State, Transition};
use littlewood_draw::{
    Content, Entries, Figure, INK, Label, Layer, Mark, PAPER, START, Series, Stroke, short,
};
use littlewood_style::ImpulseLine;
use littlewood_style::width::BOLD;

use crate::columns::{FRICTION_IMPULSE, NORMAL_IMPULSE};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;

const NAME: &str = "impact";
const COLUMNS: [&str; 2] = [FRICTION_IMPULSE, NORMAL_IMPULSE];

/// Room around the course, in parts of the largest impulse.
const MARGIN: f64 = 1.16;
/// Width of the line of the course.
const COURSE: f64 = 1.2 * BOLD;
/// Room for a name, in parts of the height of the window.
const LEAST_PLACE: f64 = 0.055;
/// Narrowest window, in parts of the largest impulse: without friction the course is a vertical.
const NARROWEST: f64 = 0.2;

/// An impact with all on which its course depends.
struct Diagram {
    hoop: Hoop,
    restitution: Restitution,
    impact: Impact,
    compliance: Compliance,
    /// Where the course bends, with its ends.
    vertices: Vec<ImpactVertex>,
    greatest_compression: Option<[f64; 2]>,
    window: Window,
}

impl Diagram {
    fn new(hoop: Hoop, restitution: Restitution, theta: f64, impact: Impact) -> Option<Self> {
        let compliance = hoop.compliance(theta)?;
        let vertices = hoop.impact_course(theta, &impact);
        let top = MARGIN * impact.impulse.normal;
        let side = vertices
            .iter()
            .map(|vertex| MARGIN * vertex.impulse.friction.abs())
            .fold(0.0, f64::max);
        let side = side
            .max(top * hoop.mu_s().max(hoop.mu_k()))
            .max(NARROWEST * top);
        Some(Self {
            hoop,
            restitution,
            impact,
            compliance,
            greatest_compression: greatest_compression(&vertices),
            vertices,
            window: Window {
                x: [-side, side],
                y: [0.0, top],
            },
        })
    }

    fn resists(&self) -> bool {
        self.hoop.rolling_resistance() > 0.0
    }

    /// The stretches of the course between which the couple of rolling resistance changes, that is
    /// where a rotation ends; without resistance all of it.
    fn regimes(&self) -> Vec<Regime> {
        let Compliance { a, b, c, .. } = self.compliance;
        let [_, top] = self.window.y;
        let mut regimes: Vec<Regime> = Vec::new();
        if !self.resists() {
            regimes.extend(self.vertices.first().map(|&start| Regime {
                start,
                turns: 0.0,
                to: top,
                slip: Response {
                    friction: a,
                    normal: b,
                },
                gap: Response {
                    friction: b,
                    normal: c,
                },
            }));
        }
        for piece in self.vertices.windows(2).filter(|_| self.resists()) {
            let (start, end) = (piece[0], piece[1]);
            let turns = sign(start.velocities.theta_rate + end.velocities.theta_rate);
            let [from, to] = [start, end].map(|vertex| vertex.impulse.normal);
            let friction = end.impulse.friction - start.impulse.friction;
            let by_normal =
                |change: f64, by_friction: f64| (change - by_friction * friction) / (to - from);
            let opened = end.velocities.gap_rate - start.velocities.gap_rate;
            let slipped = end.velocities.slip - start.velocities.slip;
            // What holds the angle leaves the mass, and each impulse its own direction.
            let lightness = by_normal(opened, 0.0);
            let (slip, gap) = if turns == 0.0 {
                (
                    Response {
                        friction: lightness,
                        normal: 0.0,
                    },
                    Response {
                        friction: 0.0,
                        normal: lightness,
                    },
                )
            } else {
                (
                    Response {
                        friction: a,
                        normal: by_normal(slipped, a),
                    },
                    Response {
                        friction: b,
                        normal: by_normal(opened, b),
                    },
                )
            };
            match regimes.last_mut() {
                Some(last) if last.turns == turns => last.to = to,
                _ => regimes.push(Regime {
                    start,
                    turns,
                    to,
                    slip,
                    gap,
                }),
            }
        }
        if let Some(last) = regimes.last_mut() {
            last.to = top;
        }
        regimes
    }

    /// The straight lines, each with its style. With rolling resistance each is that of the
    /// rotation which the course has at the same normal impulse.
    fn lines(&self) -> Vec<(ImpulseLine, [[f64; 2]; 2])> {
        let regimes = self.regimes();
        let mut lines = Vec::new();
        for (i, regime) in regimes.iter().enumerate() {
            let ImpactVertex {
                impulse: from,
                velocities,
                ..
            } = regime.start;
            let line = |response: Response, value: f64| Line {
                friction: response.friction,
                normal: response.normal,
                constant: value - response.friction * from.friction - response.normal * from.normal,
            };
            let end = match self.restitution.law() {
                RestitutionLaw::Energetic | RestitutionLaw::Newton => {
                    line(regime.gap, velocities.gap_rate - self.impact.after.gap_rate)
                }
                RestitutionLaw::Poisson => Line {
                    friction: 0.0,
                    normal: 1.0,
                    constant: -self.impact.impulse.normal,
                },
            };
            let window = Window {
                x: self.window.x,
                y: [from.normal, regime.to],
            };
            let last = i + 1 == regimes.len();
            for (style, line) in [
                (ImpulseLine::Sticking, line(regime.slip, velocities.slip)),
                (
                    ImpulseLine::Compression,
                    line(regime.gap, velocities.gap_rate),
                ),
                (ImpulseLine::Termination, end),
            ] {
                if last || style != ImpulseLine::Termination {
                    lines.extend(line.within(window).map(|ends| (style, ends)));
                }
            }
        }
        lines
    }

    /// The friction cones, each as one line from side to side.
    fn cones(&self) -> Vec<(ImpulseLine, Vec<[f64; 2]>)> {
        let (mu_s, mu_k) = (self.hoop.mu_s(), self.hoop.mu_k());
        let [_, top] = self.window.y;
        let cone = |mu: f64| vec![[-mu * top, top], [0.0, 0.0], [mu * top, top]];
        let mut cones = vec![(ImpulseLine::StaticCone, cone(mu_s))];
        if mu_k != mu_s {
            cones.push((ImpulseLine::KineticCone, cone(mu_k)));
        }
        cones
    }

    /// The parts of the course, each with the mode of contact in it.
    fn parts(&self) -> Vec<(Mode, [[f64; 2]; 2])> {
        let holds = |rate: fn(&ContactVelocities) -> f64, ends: &[ImpactVertex]| {
            ends.iter().all(|vertex| rate(&vertex.velocities) == 0.0)
        };
        let parts = self.vertices.windows(2).map(|ends| {
            let sticks = holds(|velocities| velocities.slip, ends);
            let still = self.resists() && holds(|velocities| velocities.theta_rate, ends);
            let mode = match (sticks, still) {
                (false, false) => Mode::Sliding,
                (true, false) => Mode::Rolling,
                (false, true) => Mode::Skidding,
                (true, true) => Mode::Rest,
            };
            (mode, [0, 1].map(|end| point(&ends[end])))
        });
        parts.collect()
    }

    fn layers(&self) -> Vec<Layer> {
        let drawn = |line: ImpulseLine, points: &[[f64; 2]]| {
            Series::of_rows(line.name(), &COLUMNS, points.to_vec())
                .drawn(Stroke::of_impulse_line(line))
        };
        let mut layers: Vec<Layer> = self
            .cones()
            .iter()
            .map(|(line, points)| drawn(*line, points))
            .collect();
        for (style, ends) in self.lines() {
            layers.push(drawn(style, &ends));
        }
        let parts = self.parts();
        for (i, (mode, rows)) in parts.iter().enumerate() {
            let stroke = Stroke::of_mode(*mode).wide(COURSE);
            let series = Series::of_rows("course", &COLUMNS, rows.to_vec());
            // Set off against the cone, on which it slips.
            layers.push(series.clone().drawn(Stroke::solid(PAPER, COURSE + 2.0)));
            layers.push(series.drawn(if i + 1 == parts.len() {
                Mark::Arrow(stroke)
            } else {
                Mark::Line(stroke)
            }));
        }
        let dot = |name: &str, at: [f64; 2], mark: Mark| {
            Series::of_rows(name, &COLUMNS, [at]).drawn(mark)
        };
        for ends in self.vertices.windows(2).take(parts.len().saturating_sub(1)) {
            let slips = |vertex: &ImpactVertex| vertex.velocities.slip != 0.0;
            let name = if slips(&ends[0]) && !slips(&ends[1]) || !self.resists() {
                "slip ends"
            } else {
                "rotation ends"
            };
            layers.push(dot(name, point(&ends[1]), Mark::Dot(INK, 3.4)));
        }
        layers.extend(
            self.greatest_compression
                .map(|at| dot("compressed most", at, Mark::Dot(INK, 3.4))),
        );
        layers.push(dot("start", [0.0, 0.0], START));
        layers
    }

    /// Of each style the line that is longest in the picture.
    fn longest_lines(&self) -> Vec<(ImpulseLine, [[f64; 2]; 2])> {
        let [left, right] = self.window.x;
        let [_, top] = self.window.y;
        let length = |[from, to]: &[[f64; 2]; 2]| {
            libm::hypot((to[0] - from[0]) / (right - left), (to[1] - from[1]) / top)
        };
        let mut longest: Vec<(ImpulseLine, [[f64; 2]; 2])> = Vec::new();
        for (style, ends) in self.lines() {
            match longest.iter_mut().find(|(other, _)| *other == style) {
                Some((_, other)) if length(other) < length(&ends) => *other = ends,
                Some(_) => {}
                None => longest.push((style, ends)),
            }
        }
        longest
    }

    /// "u = 0" and so on: at the top of the line without slip, which is steep, and at the side of
    /// the others that is away from the course.
    fn labels(&self) -> Vec<Label> {
        let mut taken: Vec<f64> = Vec::new();
        let least = LEAST_PLACE * self.window.y[1];
        let mut labels = Vec::new();
        for (style, mut ends) in self.longest_lines() {
            ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let [left, right] = ends;
            let ends = Ends { left, right };
            let text = match style {
                ImpulseLine::Sticking => "*u* = 0",
                ImpulseLine::Compression => "*w* = 0",
                ImpulseLine::Termination => "end",
                ImpulseLine::StaticCone | ImpulseLine::KineticCone => continue,
            };
            let Beside {
                at,
                to_the_right,
                down,
            } = if style == ImpulseLine::Sticking {
                self.beside_sticking(ends)
            } else {
                self.beside_other(ends)
            };
            if style != ImpulseLine::Sticking {
                if taken.iter().any(|place| (place - at[1]).abs() < least) {
                    continue;
                }
                taken.push(at[1]);
            }
            let label = Label::new(text, &at).coloured(Stroke::of_impulse_line(style).colour);
            labels.push(if to_the_right {
                label.shifted(8.0, down).left()
            } else {
                label.shifted(-8.0, down).right()
            });
        }
        labels
    }

    /// At the upper end of the line without slip.
    fn beside_sticking(&self, Ends { left, right }: Ends) -> Beside {
        let at = if left[1] > right[1] { left } else { right };
        Beside {
            at,
            to_the_right: at[0] <= 0.5 * self.window.x[1],
            down: 14.0,
        }
    }

    /// At the end of another line that is away from the course.
    fn beside_other(&self, Ends { left, right }: Ends) -> Beside {
        let least = LEAST_PLACE * self.window.y[1];
        // A jam is compressed most on a line through the origin, where there is no room.
        let is_low = |end: [f64; 2]| end[1] < least;
        let is_left = if self.impact.impulse.friction > 0.0 {
            !is_low(left)
        } else {
            is_low(right)
        };
        let (at, other) = if is_left {
            (left, right)
        } else {
            (right, left)
        };
        // Where neither this line nor the one without slip runs.
        let is_top = at[1] + least > self.window.y[1];
        let down = if is_top {
            14.0
        } else if other[1] > at[1] {
            13.0
        } else {
            -13.0
        };
        Beside {
            at,
            to_the_right: is_left != is_top,
            down,
        }
    }

    fn keys(&self) -> Entries {
        let parts = self.parts();
        let modes = [
            (Mode::Sliding, "it slips"),
            (Mode::Rolling, "it sticks"),
            (Mode::Skidding, "it slips, without rotation"),
            (Mode::Rest, "it sticks, without rotation"),
        ];
        let mut keys: Entries = modes
            .into_iter()
            .filter(|(mode, _)| parts.iter().any(|(other, _)| other == mode))
            .map(|(mode, words)| (Stroke::of_mode(mode).wide(BOLD).into(), words.to_owned()))
            .collect();
        let mut line = |line: ImpulseLine, words: &str| {
            keys.push((Stroke::of_impulse_line(line).into(), words.to_owned()));
        };
        for (style, _) in self.longest_lines() {
            match style {
                ImpulseLine::Sticking => line(style, "*u* = 0: without slip"),
                ImpulseLine::Compression => line(style, "*w* = 0: greatest compression"),
                ImpulseLine::Termination => line(style, self.termination()),
                ImpulseLine::StaticCone | ImpulseLine::KineticCone => {}
            }
        }
        for (cone, _) in self.cones() {
            line(
                cone,
                if cone == ImpulseLine::StaticCone {
                    "|*J*| = *μ*_{s} *P*: friction cone"
                } else {
                    "|*J*| = *μ*_{k} *P*: friction cone"
                },
            );
        }
        keys
    }

    /// What is the same on the line of termination.
    const fn termination(&self) -> &'static str {
        match self.restitution.law() {
            RestitutionLaw::Energetic => "end: *e*^{2} of the work is given back",
            RestitutionLaw::Poisson => "end: *P* is 1 + *e* times that at *w* = 0",
            RestitutionLaw::Newton => "end: *w* is −*e* times that before",
        }
    }
}

/// How a velocity answers to the impulses J and P; with rolling resistance P brings its couple.
#[derive(Clone, Copy)]
struct Response {
    friction: f64,
    normal: f64,
}

/// A stretch of the course with one sign of θ′, or none.
struct Regime {
    start: ImpactVertex,
    turns: f64,
    /// The normal impulse up to which it goes.
    to: f64,
    slip: Response,
    gap: Response,
}

fn sign(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}

/// J and P.
const fn point(vertex: &ImpactVertex) -> [f64; 2] {
    [vertex.impulse.friction, vertex.impulse.normal]
}

/// Where w = 0 on the course, after the start.
fn greatest_compression(course: &[ImpactVertex]) -> Option<[f64; 2]> {
    course.windows(2).find_map(|ends| {
        let [from, to] = [0, 1].map(|end| ends[end].velocities.gap_rate);
        let share = from / (from - to);
        let [a, b] = [0, 1].map(|end| point(&ends[end]));
        (from < 0.0 && to >= 0.0).then(|| [0, 1].map(|i| a[i] + share * (b[i] - a[i])))
    })
}

/// The ends of a line in the window.
struct Ends {
    left: [f64; 2],
    right: [f64; 2],
}

/// Where a name stands beside a line: at an end of it, to its right or left, so far below.
struct Beside {
    at: [f64; 2],
    to_the_right: bool,
    down: f64,
}

/// A line in the plane of impulses, on which this sum is zero.
struct Line {
    /// Coefficients of J and of P.
    friction: f64,
    normal: f64,
    constant: f64,
}

impl Line {
    /// Its ends in a window.
    fn within(&self, window: Window) -> Option<[[f64; 2]; 2]> {
        let (a, b, c) = (self.friction, self.normal, self.constant);
        let norm = a * a + b * b;
        if norm == 0.0 {
            return None;
        }
        let (foot, along) = ([-a * c / norm, -b * c / norm], [-b, a]);
        let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
        for (i, range) in [window.x, window.y].into_iter().enumerate() {
            if along[i] == 0.0 {
                if foot[i] < range[0] || foot[i] > range[1] {
                    return None;
                }
                continue;
            }
            let [p, q] = range.map(|bound| (bound - foot[i]) / along[i]);
            (from, to) = (from.max(p.min(q)), to.min(p.max(q)));
        }
        let inside = |at: f64| {
            let point =
                |i: usize, range: [f64; 2]| (foot[i] + at * along[i]).clamp(range[0], range[1]);
            [point(0, window.x), point(1, window.y)]
        };
        (from < to).then(|| [inside(from), inside(to)])
    }
}

/// The impact that is asked for.
fn chosen(input: &FigureInput) -> Result<(Restitution, Transition, Impact), FigureError> {
    input.heavy(NAME)?;
    let Some(restitution) = input.hoop.restitution() else {
        return Err(FigureError::NeedsRestitution { figure: NAME });
    };
    let motion = input.hoop.simulate(input.start, input.limits)?;
    let mut found = impacts::single(&motion);
    let index = input.impact.checked_sub(1);
    match index.and_then(|index| found.nth(index)) {
        Some((transition, impact)) => Ok((restitution, *transition, impact)),
        None => match impacts::single(&motion).count() {
            0 => Err(FigureError::NoImpact {
                figure: NAME,
                outcome: motion.outcome().kind(),
            }),
            impacts => Err(FigureError::ImpactNumber {
                number: input.impact,
                impacts,
            }),
        },
    }
}

/// The state of a motion before its impact, and the impact, in words.
fn caption(input: &FigureInput, state: State, impact: &Impact, compliance: Compliance) -> String {
    let say = input.wording();
    let velocity = |value: f64| say.value(value, Dimension::Velocity);
    let impulse = |value: f64| say.value(value, Dimension::Impulse);
    let (gains, lost) = (impact.gains_energy(), impact.energy_lost());
    let Compliance { a, b, c, .. } = compliance;
    // It is the inverse of a mass.
    let [a, b, c] = [a, b, c].map(|value| match input.units {
        Some(units) => format!(
            "{}/{}",
            short(value / units.mass_kg),
            Dimension::Mass.si_sign()
        ),
        None => short(value),
    });
    let laws = if input.hoop.rolling_resistance() > 0.0 {
        ", with the slip velocity *u* and the rate *w* of the gap. The couple of rolling resistance \
         changes where the rotation ends, and with it the lines: each is that of the rotation which \
         the course has at the same *P*;"
            .to_owned()
    } else {
        format!(
            ", with the slip velocity *u* = *u*_{{0}} + *AJ* + *BP* and the rate of the gap *w* = *w*_{{0}} + \
             *BJ* + *CP*. *A* = {a}, *B* = {b}, *C* = {c};"
        )
    };
    format!(
        "Impact {} of the motion, at {} = {}, *θ* = {}: {}. Its course in the plane of the impulses *J* along the plane and \
         *P* upwards (Routh){laws} *u* from {} to {}, *w* from {} to {}, *J* = {}, *P* = {}. Energy {}: {}. {}.",
        input.impact,
        say.time(),
        say.value(state.time, Dimension::Time),
        short(state.theta),
        impact.case.label(),
        velocity(impact.before.slip),
        velocity(impact.after.slip),
        velocity(impact.before.gap_rate),
        velocity(impact.after.gap_rate),
        impulse(impact.impulse.friction),
        impulse(impact.impulse.normal),
        if gains { "gained by this law" } else { "lost" },
        say.quantity(if gains { -lost } else { lost.max(0.0) }, Dimension::Energy),
        input.in_words()
    )
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let (restitution, transition, impact) = chosen(input)?;
    let state = transition.before;
    let Some(diagram) = Diagram::new(input.hoop, restitution, state.theta, impact) else {
        return Err(FigureError::NeedsInertia { figure: NAME });
    };
    let say = input.wording();
    let content = Content {
        name: "plane of impulses",
        x: say.axis(FRICTION_IMPULSE, "*J*", diagram.window.x.into()),
        y: say.axis(NORMAL_IMPULSE, "*P*", diagram.window.y.into()),
        layers: diagram.layers(),
        labels: diagram.labels(),
    };
    let title = "An impact in the plane of impulses";
    let caption = caption(input, state, &impact, diagram.compliance);
    let sheet = input.sheet(600.0)?;
    Ok(sheet.plot(NAME, title, caption, 450.0, content, diagram.keys()))
}
