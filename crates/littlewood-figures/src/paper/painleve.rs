//! Painlevé's paradox: where sliding has no solution or several, in the plane of angle and
//! friction, for a family of hoops.

use core::f64::consts::PI;

use littlewood::tables::Quantity;
use littlewood::theory::{Body, PhasePlane, SlidingLaw, Window};
use littlewood::{Hoop, HoopParameters, ParameterError, RotationDirection, SlipDirection};
use littlewood_draw::{
    Content, Entries, FRICTION_FORCE, Figure, HATCH, INK, Label, Layer, Mark, SMALL, SOFT, Series,
    Stroke, marked, short,
};
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash};

use crate::columns::{MU_K, THETA};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::close_at;
use crate::wording::Wording;

const NAME: &str = "painleve";
const COLUMNS: [&str; 2] = [THETA, MU_K];

/// The family: thin hoops with the particle on the rim, by γ, the share of the particle in the
/// mass. One is massless.
const SHARES: [f64; 8] = [1.0, 0.9, 0.75, 0.6, 0.5, 1.0 / 3.0, 0.2, 0.1];
/// Greatest coefficient that is shown in any case.
const USUAL: f64 = 2.0;
/// A hoop that needs more than this is named, but not shown: a heavy one needs its mass over that
/// of the particle.
const FAR: f64 = 6.0;
/// The lines of the family, and of the least coefficients of all thin hoops.
const THIN: Stroke = Stroke::solid(SOFT, FINE);
const MINIMA: Stroke = Stroke::solid(SOFT, 1.2).dashed(Dash::DashDot);
/// Least distance of members of the family, in parts of the window.
const APART: f64 = 0.1;
/// Angles among which the least coefficient is looked for.
const CELLS: u32 = 720;

/// The coefficient of friction at which sliding to the right ceases to have a solution, by the
/// angle.
enum Threshold {
    /// P = Î + m h sin θ q is linear in μk.
    Heavy {
        /// Without friction.
        smooth: SlidingLaw,
        /// With a coefficient of one.
        rough: SlidingLaw,
    },
    /// The limit Î → 0: the slip boundary itself.
    Massless(PhasePlane),
}

impl Threshold {
    fn new(hoop: &Hoop) -> Result<Option<Self>, ParameterError> {
        let law = |mu: f64| {
            let hoop = Hoop::new(hoop.parameters().with_friction(mu, mu))?;
            Ok::<_, ParameterError>(SlidingLaw::new(
                &hoop,
                SlipDirection::Positive,
                RotationDirection::Positive,
            ))
        };
        Ok(match hoop.body() {
            Body::Heavy(_) => law(0.0)?
                .zip(law(1.0)?)
                .map(|(smooth, rough)| Self::Heavy { smooth, rough }),
            Body::Massless(_) => Some(Self::Massless(PhasePlane::new(hoop))),
        })
    }

    /// None where no friction is enough.
    fn at(&self, theta: f64) -> Option<f64> {
        match self {
            Self::Heavy { smooth, rough } => {
                let (without, with) = (smooth.painleve(theta), rough.painleve(theta));
                (without > with).then(|| without / (without - with))
            }
            Self::Massless(plane) => {
                let demand = plane.forces(theta, 0.0).demand();
                demand.is_finite().then_some(demand)
            }
        }
    }

    /// The angle of the least coefficient, and that coefficient.
    fn least(&self) -> [f64; 2] {
        if let Self::Massless(_) = self {
            return [0.0, 0.0];
        }
        let angle = |i: f64| PI * i / f64::from(CELLS);
        let at = |theta: f64| self.at(theta).unwrap_or(f64::INFINITY);
        let best = (1..CELLS)
            .map(f64::from)
            .reduce(|a, b| if at(angle(b)) < at(angle(a)) { b } else { a });
        let best = best.unwrap_or(1.0);
        // The golden section of the interval about it.
        let (mut from, mut to) = (angle(best - 1.0), angle(best + 1.0));
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..60 {
            let (a, b) = (to - golden * (to - from), from + golden * (to - from));
            if at(a) < at(b) { to = b } else { from = a }
        }
        let theta = 0.5 * (from + to);
        [theta, at(theta)]
    }

    fn curve(&self, window: Window) -> Vec<Vec<[f64; 2]>> {
        window.pieces([1e-6, PI - 1e-6], CELLS, &|theta| {
            Some([theta, self.at(theta)?])
        })
    }

    /// The angles between which sliding of a hoop with inertia has no solution with this
    /// coefficient.
    fn between(&self, mu: f64) -> Vec<[f64; 2]> {
        if matches!(self, Self::Massless(_)) {
            return Vec::new();
        }
        let is_within = |theta: f64| self.at(theta).is_some_and(|threshold| threshold <= mu);
        let edge = |mut inside: f64, mut outside: f64| loop {
            let half = 0.5 * (inside + outside);
            if half == inside || half == outside {
                return inside;
            }
            if is_within(half) {
                inside = half;
            } else {
                outside = half;
            }
        };
        // The least coefficient lies between two angles at which there may be solutions.
        let mut angles: Vec<f64> = (0..=CELLS)
            .map(|i| PI * f64::from(i) / f64::from(CELLS))
            .collect();
        angles.push(self.least()[0]);
        angles.sort_by(f64::total_cmp);
        let mut found: Vec<[f64; 2]> = Vec::new();
        for pair in angles.windows(2) {
            match (is_within(pair[0]), is_within(pair[1])) {
                (false, true) => found.push([edge(pair[1], pair[0]), PI]),
                (true, false) => {
                    if let Some(last) = found.last_mut() {
                        last[1] = edge(pair[0], pair[1]);
                    }
                }
                (true, true) | (false, false) => {}
            }
        }
        found
    }
}

/// Whether a hoop is thin, with the particle on the rim.
fn is_of_the_family(hoop: &Hoop) -> bool {
    hoop.offset() == 1.0 && hoop.inertia() == hoop.mass_ratio()
}

/// A member of the family.
struct Member {
    /// γ.
    share: f64,
    threshold: Threshold,
}

/// The members of the family that are seen, each apart from the others and from the hoop itself,
/// whose least coefficient is `own`.
fn family(own: f64, hoop: &Hoop, most: f64) -> Result<Vec<Member>, ParameterError> {
    let mut taken = vec![own];
    let mut found = Vec::new();
    for share in SHARES {
        let member = Hoop::new(HoopParameters::thin(1.0 / share - 1.0))?;
        let Some(threshold) = Threshold::new(&member)? else {
            continue;
        };
        let [_, least] = threshold.least();
        let is_own = is_of_the_family(hoop) && (1.0 / hoop.mass() - share).abs() < 1e-12;
        let is_apart = taken
            .iter()
            .all(|other| (least - other).abs() > APART * most);
        if !is_own && is_apart && least < 0.9 * most {
            taken.push(least);
            found.push(Member { share, threshold });
        }
    }
    Ok(found)
}

impl Member {
    /// Its curve, with its name at the least coefficient, where the massless one has no place.
    fn drawn(&self, window: Window) -> (Layer, Label) {
        let name = format!("gamma={:.4}", self.share);
        let curve = Series::new(name, &COLUMNS, self.threshold.curve(window));
        let label = if self.share < 1.0 {
            let text = format!("*γ* = {}", short(libm::round(100.0 * self.share) / 100.0));
            let label = Label::new(text, &self.threshold.least());
            label.shifted(-7.0, -10.0).right()
        } else {
            let high = 0.62 * window.y[1];
            let label = Label::new("massless", &[2.0 * libm::atan(high), high]);
            label.shifted(8.0, 4.0).left()
        };
        (curve.drawn(THIN), label.sized(SMALL).coloured(SOFT))
    }
}

/// The region of a hoop, above its curve.
fn region(mut curve: Vec<Vec<[f64; 2]>>, most: f64) -> Layer {
    curve.iter_mut().for_each(|piece| close_at(piece, most));
    Series::new("no solution or several", &COLUMNS, curve).drawn(Mark::Hatch(HATCH))
}

/// The coefficient of the hoop, with the angles between which sliding has no solution.
fn of_friction(hoop: &Hoop, own: &Threshold) -> (Vec<Layer>, Vec<Label>) {
    let mu = hoop.mu_k();
    let stroke = Stroke::of_curve(Curve::SlipLimit)
        .wide(CURVE)
        .dashed(Dash::Dotted);
    let ends = own.between(mu).into_iter().flatten();
    let ends = ends.map(|theta| [theta, mu]);
    let layers = vec![
        Series::of_rows(MU_K, &COLUMNS, [[0.0, mu], [PI, mu]]).drawn(stroke),
        Series::of_rows("ends", &COLUMNS, ends).drawn(Mark::Ring(FRICTION_FORCE, 3.4)),
    ];
    let label = Label::new(marked(Quantity::MuK.sign()), &[PI, mu])
        .shifted(-8.0, -11.0)
        .right();
    (layers, vec![label.coloured(FRICTION_FORCE)])
}

fn in_words(hoop: &Hoop, own: &Threshold, say: Wording) -> String {
    let angle = |theta: f64| {
        format!(
            "{}°",
            short(libm::round(100.0 * theta.to_degrees()) / 100.0)
        )
    };
    let of_hoop = match own {
        Threshold::Massless(_) => {
            "This hoop has no inertia: hatched is the limit of small inertia, where |*F*| ≤ *μ*_{k}*N* suffices to roll; the \
             massless hoop glides there."
                .to_owned()
        }
        Threshold::Heavy { .. } => {
            let [theta, least] = own.least();
            let mu = short(hoop.mu_k());
            let between: Vec<String> = own
                .between(hoop.mu_k())
                .into_iter()
                .map(|[from, to]| format!("from *θ* = {} to {}", angle(from), angle(to)))
                .collect();
            let now = if between.is_empty() {
                format!("*μ*_{{k}} = {mu} is below it")
            } else {
                format!("*μ*_{{k}} = {mu} exceeds the threshold {} (rings)", between.join(" and "))
            };
            format!("For this hoop it is {}, at *θ* = {}; {now}.", short(least), angle(theta))
        }
    };
    format!("{of_hoop} {}.", say.body(hoop))
}

fn keys(is_far: bool) -> Entries {
    let of_hoop = [
        (Mark::Hatch(HATCH), "no solution or several"),
        (Mark::Line(Stroke::solid(INK, BOLD)), "this hoop"),
    ];
    let of_family = [
        (Mark::Line(THIN), "thin hoops"),
        (Mark::Line(MINIMA), "least *μ*_{k}"),
    ];
    let of_hoop = of_hoop.into_iter().filter(|_| !is_far);
    let keys = of_hoop.chain(of_family);
    keys.map(|(mark, text)| (mark, text.to_owned())).collect()
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let (hoop, say) = (&input.hoop, input.wording());
    let Some(own) = Threshold::new(hoop)? else {
        return Err(FigureError::NeedsOffset { figure: NAME });
    };
    let place @ [_, least] = own.least();
    let is_far = least > FAR;
    let most = USUAL
        .max(if is_far { 0.0 } else { 1.35 * least })
        .max(1.3 * hoop.mu_k());
    let window = Window {
        x: [0.0, PI],
        y: [0.0, most],
    };
    let curve = own.curve(window);
    let mut layers = vec![region(curve.clone(), most)];
    let family = family(least, hoop, most)?;
    let (lines, mut labels): (Vec<Layer>, Vec<Label>) =
        family.iter().map(|member| member.drawn(window)).unzip();
    layers.extend(lines);
    let minima = window.pieces([0.0, 0.5 * PI - 1e-6], CELLS, &|theta| {
        Some([theta, libm::tan(theta)])
    });
    layers.push(Series::new("least", &COLUMNS, minima).drawn(MINIMA));
    layers.push(Series::new("this hoop", &COLUMNS, curve).drawn(Stroke::solid(INK, BOLD)));
    let (lines, marks) = of_friction(hoop, &own);
    layers.extend(lines);
    labels.extend(marks);
    let dots = family.iter().filter(|member| member.share < 1.0);
    let dots = dots.map(|member| member.threshold.least());
    layers.push(Series::of_rows("least of a hoop", &COLUMNS, dots).drawn(Mark::Dot(SOFT, 2.8)));
    if is_far {
        let text = format!("this hoop: above *μ*_{{k}} = {}", short(least));
        // Below all curves, unless the coefficient of the hoop is there.
        let high = if hoop.mu_k() < 0.2 * most { 0.88 } else { 0.06 };
        let label = Label::new(text, &[PI, high * most]).shifted(-10.0, 0.0);
        labels.push(label.right());
    } else if least > 0.0 {
        let dot = Series::of_rows("least of this hoop", &COLUMNS, [place]);
        layers.push(dot.drawn(Mark::Dot(INK, 3.6)));
    }
    let caption = format!(
        "Painlevé's paradox: where sliding with *η*′ > 0 has no solution with a normal force, or more than one, *I\u{302}* + *mh* sin \
         *θ* (*h* sin *θ* − *μ*_{{k}}(1 + *h* cos *θ*)) ≤ 0; for *η*′ < 0 at −*θ*. Thin: where it begins for thin hoops with the \
         particle on the rim, *γ* = *m*_{{2}}/(*m*_{{1}} + *m*_{{2}}). The least *μ*_{{k}} is √(1 − *γ*^{{2}})/*γ*, at cos *θ* = *γ* \
         (dots, dash-dotted: *μ*_{{k}} = tan *θ*). {}",
        in_words(hoop, &own, say)
    );
    let content = Content {
        name: "plane",
        x: say.angle(window.x.into()),
        y: say.axis(MU_K, &marked(Quantity::MuK.sign()), window.y.into()),
        layers,
        labels,
    };
    input.plane(NAME, "Painlevé's paradox", caption, content, keys(is_far))
}
