//! Routh's diagram of an impact: its course in the plane of the impulses J and P.

use littlewood::impact::{Impact, ImpactCase};
use littlewood::tables::Dimension;
use littlewood::{Hoop, Mode, Restitution, RestitutionLaw, Transition};
use littlewood_draw::{
    Content, Entries, Figure, INK, Label, Layer, Mark, PAPER, Piece, START, Series, Stroke, short,
};
use littlewood_style::ImpulseLine;
use littlewood_style::width::BOLD;

use crate::columns::{FRICTION_IMPULSE, NORMAL_IMPULSE};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;
use littlewood::theory::Window;

const NAME: &str = "impact";
const COLUMNS: [&str; 2] = [FRICTION_IMPULSE, NORMAL_IMPULSE];

/// Room around the course, in parts of the largest impulse.
const MARGIN: f64 = 1.16;
/// Width of the line of the course.
const COURSE: f64 = 1.2 * BOLD;
/// Narrowest window, in parts of the largest impulse: without friction the course is a vertical.
const NARROWEST: f64 = 0.2;

/// An impact with all on which its course depends.
struct Diagram {
    hoop: Hoop,
    restitution: Restitution,
    impact: Impact,
    /// A, B and C.
    compliance: [f64; 3],
    /// Where the course bends, with its ends.
    course: Vec<[f64; 2]>,
    window: Window,
}

impl Diagram {
    fn new(hoop: Hoop, restitution: Restitution, theta: f64, impact: Impact) -> Option<Self> {
        let compliance = hoop.compliance(theta)?;
        let course: Vec<[f64; 2]> = hoop
            .impact_course(theta, &impact)
            .iter()
            .map(|impulse| [impulse.friction, impulse.normal])
            .collect();
        let top = MARGIN * impact.impulse.normal;
        let side = course
            .iter()
            .map(|[friction, _]| MARGIN * friction.abs())
            .fold(0.0, f64::max);
        let side = side
            .max(top * hoop.mu_s().max(hoop.mu_k()))
            .max(NARROWEST * top);
        Some(Self {
            hoop,
            restitution,
            impact,
            compliance: [compliance.a, compliance.b, compliance.c],
            course,
            window: Window {
                x: [-side, side],
                y: [0.0, top],
            },
        })
    }

    /// The straight lines a J + b P + c = 0, each with its style and its words.
    fn lines(&self) -> Vec<(ImpulseLine, [f64; 3])> {
        let [a, b, c] = self.compliance;
        let before = self.impact.before;
        let end = match self.restitution.law() {
            RestitutionLaw::Energetic | RestitutionLaw::Newton => {
                [b, c, before.gap_rate - self.impact.after.gap_rate]
            }
            RestitutionLaw::Poisson => [0.0, 1.0, -self.impact.impulse.normal],
        };
        vec![
            (ImpulseLine::Sticking, [a, b, before.slip]),
            (ImpulseLine::Compression, [b, c, before.gap_rate]),
            (ImpulseLine::Termination, end),
        ]
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

    /// The parts of the course, each with what the contact point does.
    fn parts(&self) -> Vec<(Mode, Piece)> {
        let last = match self.impact.case {
            ImpactCase::Slides
            | ImpactCase::ReversesInCompression
            | ImpactCase::ReversesInRestitution => Mode::Sliding,
            _ => Mode::Rolling,
        };
        let count = self.course.len().saturating_sub(1);
        self.course
            .windows(2)
            .enumerate()
            .map(|(i, ends)| {
                let mode = if i + 1 == count { last } else { Mode::Sliding };
                (mode, ends.iter().map(|point| point.to_vec()).collect())
            })
            .collect()
    }

    /// Where w = 0 on the course, after the start.
    fn greatest_compression(&self) -> Option<[f64; 2]> {
        let [_, b, c] = self.compliance;
        let gap_rate =
            |[friction, normal]: [f64; 2]| self.impact.before.gap_rate + b * friction + c * normal;
        self.course.windows(2).find_map(|ends| {
            let (from, to) = (gap_rate(ends[0]), gap_rate(ends[1]));
            let share = from / (from - to);
            (from < 0.0 && to >= 0.0)
                .then(|| [0, 1].map(|i| ends[0][i] + share * (ends[1][i] - ends[0][i])))
        })
    }

    fn layers(&self) -> Vec<Layer> {
        let drawn = |line: ImpulseLine, points: &[[f64; 2]]| {
            let rows = points.iter().map(|point| point.to_vec()).collect();
            Series::of_rows(line.name(), &COLUMNS, rows).drawn(Stroke::of_impulse_line(line))
        };
        let mut layers: Vec<Layer> = self
            .cones()
            .iter()
            .map(|(line, points)| drawn(*line, points))
            .collect();
        for (line, coefficients) in self.lines() {
            layers.extend(across(coefficients, self.window).map(|ends| drawn(line, &ends)));
        }
        let parts = self.parts();
        for (i, (mode, rows)) in parts.iter().enumerate() {
            let stroke = Stroke::of_mode(*mode).wide(COURSE);
            // Set off against the cone, on which it slips.
            let under = Mark::Line(Stroke::solid(PAPER, COURSE + 2.0));
            layers.push(Series::of_rows("course", &COLUMNS, rows.clone()).drawn(under));
            let mark = if i + 1 == parts.len() {
                Mark::Arrow(stroke)
            } else {
                Mark::Line(stroke)
            };
            layers.push(Series::of_rows("course", &COLUMNS, rows.clone()).drawn(mark));
        }
        let dot = |name: &str, at: [f64; 2], mark: Mark| {
            Series::of_rows(name, &COLUMNS, vec![at.to_vec()]).drawn(mark)
        };
        if let [_, bend, _] = self.course[..] {
            layers.push(dot("slip ends", bend, Mark::Dot(INK, 3.4)));
        }
        layers.extend(
            self.greatest_compression()
                .map(|at| dot("compressed most", at, Mark::Dot(INK, 3.4))),
        );
        layers.push(dot("start", [0.0, 0.0], START));
        layers
    }

    /// "u = 0" and so on: at the top of the line without slip, which is steep, and at the side of
    /// the others that is away from the course.
    fn labels(&self) -> Vec<Label> {
        let side = if self.impact.impulse.friction > 0.0 {
            0
        } else {
            1
        };
        let mut taken: Vec<f64> = Vec::new();
        let least = 0.055 * self.window.y[1];
        let mut labels = Vec::new();
        for (line, coefficients) in self.lines() {
            let Some([mut left, mut right]) = across(coefficients, self.window) else {
                continue;
            };
            if left[0] > right[0] {
                (left, right) = (right, left);
            }
            let text = match line {
                ImpulseLine::Sticking => "*u* = 0",
                ImpulseLine::Compression => "*w* = 0",
                ImpulseLine::Termination => "end",
                ImpulseLine::StaticCone | ImpulseLine::KineticCone => continue,
            };
            let colour = Stroke::of_impulse_line(line).colour;
            let beside = |at: [f64; 2], to_the_right: bool, down: f64| {
                let label = Label::new(text, &at).coloured(colour);
                if to_the_right {
                    label.shifted(8.0, down).left()
                } else {
                    label.shifted(-8.0, down).right()
                }
            };
            if line == ImpulseLine::Sticking {
                let top = if left[1] > right[1] { left } else { right };
                labels.push(beside(top, top[0] <= 0.5 * self.window.x[1], 14.0));
                continue;
            }
            // A jam is compressed most on a line through the origin, where there is no room.
            let is_low = |end: [f64; 2]| end[1] < least;
            let is_left = if side == 0 {
                !is_low(left)
            } else {
                is_low(right)
            };
            let [at, other] = if is_left {
                [left, right]
            } else {
                [right, left]
            };
            if taken.iter().any(|place| (place - at[1]).abs() < least) {
                continue;
            }
            taken.push(at[1]);
            // Where neither this line nor the one without slip runs.
            let is_top = at[1] + least > self.window.y[1];
            let down = if is_top {
                14.0
            } else if other[1] > at[1] {
                13.0
            } else {
                -13.0
            };
            labels.push(beside(at, is_left != is_top, down));
        }
        labels
    }

    fn keys(&self) -> Entries {
        let mut legend: Entries = Vec::new();
        for (mode, words) in [(Mode::Sliding, "it slips"), (Mode::Rolling, "it sticks")] {
            if self.parts().iter().any(|(other, _)| *other == mode) {
                legend.push((
                    Mark::Line(Stroke::of_mode(mode).wide(BOLD)),
                    words.to_owned(),
                ));
            }
        }
        let line = |line: ImpulseLine| Mark::Line(Stroke::of_impulse_line(line));
        legend.push((
            line(ImpulseLine::Sticking),
            "*u* = 0: without slip".to_owned(),
        ));
        legend.push((
            line(ImpulseLine::Compression),
            "*w* = 0: greatest compression".to_owned(),
        ));
        legend.push((
            line(ImpulseLine::Termination),
            self.termination().to_owned(),
        ));
        for (cone, _) in self.cones() {
            let index = if cone == ImpulseLine::StaticCone {
                "s"
            } else {
                "k"
            };
            legend.push((
                line(cone),
                format!("|*J*| = *μ*_{{{index}}} *P*: friction cone"),
            ));
        }
        legend
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

/// The part of the line a J + b P + c = 0 in a window.
fn across([a, b, c]: [f64; 3], window: Window) -> Option<[[f64; 2]; 2]> {
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
        let point = |i: usize, range: [f64; 2]| (foot[i] + at * along[i]).clamp(range[0], range[1]);
        [point(0, window.x), point(1, window.y)]
    };
    (from < to).then(|| [inside(from), inside(to)])
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

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let (restitution, transition, impact) = chosen(input)?;
    let state = transition.before;
    let Some(diagram) = Diagram::new(input.hoop, restitution, state.theta, impact) else {
        return Err(FigureError::NeedsInertia { figure: NAME });
    };
    let [a, b, c] = diagram.compliance;
    let say = input.wording();
    let velocity = |value: f64| say.value(value, Dimension::Velocity);
    let impulse = |value: f64| say.value(value, Dimension::Impulse);
    let lost = impact.energy_lost();
    // A compliance is the inverse of a mass.
    let compliance = |value: f64| match input.units {
        Some(units) => format!(
            "{}/{}",
            short(value / units.mass_kg),
            Dimension::Mass.si_sign()
        ),
        None => short(value),
    };
    let caption = format!(
        "Impact {} of the motion, at {} = {}, *θ* = {}: {}. Its course in the plane of the impulses *J* along the plane and \
         *P* upwards (Routh), with the slip velocity *u* = *u*_{{0}} + *AJ* + *BP* and the rate of the gap *w* = *w*_{{0}} + \
         *BJ* + *CP*. *A* = {}, *B* = {}, *C* = {}; *u* from {} to {}, *w* from {} to {}, *J* = {}, *P* = {}. Energy {}: {}. {}.",
        input.impact,
        say.time(),
        say.value(state.time, Dimension::Time),
        short(state.theta),
        impact.case.label(),
        compliance(a),
        compliance(b),
        compliance(c),
        velocity(impact.before.slip),
        velocity(impact.after.slip),
        velocity(impact.before.gap_rate),
        velocity(impact.after.gap_rate),
        impulse(impact.impulse.friction),
        impulse(impact.impulse.normal),
        if impact.gains_energy() {
            "gained by this law"
        } else {
            "lost"
        },
        say.quantity(
            if impact.gains_energy() { -lost } else { lost },
            Dimension::Energy
        ),
        input.in_words()
    );
    let keys = diagram.keys();
    let Window { x, y } = diagram.window;
    Ok(input.sheet(600.0)?.plot(
        NAME,
        "An impact in the plane of impulses",
        caption,
        450.0,
        Content {
            name: "plane of impulses",
            x: say.axis(FRICTION_IMPULSE, "*J*", x),
            y: say.axis(NORMAL_IMPULSE, "*P*", y),
            layers: diagram.layers(),
            labels: diagram.labels(),
        },
        keys,
    ))
}
