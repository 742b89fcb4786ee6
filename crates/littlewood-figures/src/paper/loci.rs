//! Figure 2(a): where static friction gives way in rolling, for four coefficients.

use core::f64::consts::PI;

use crate::axes::portrait_window;
use crate::columns::PLANE;
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::Portrait;
use littlewood::tables::Quantity;
use littlewood_draw::{Figure, HATCH, INK, Label, Mark, Series, Stroke, marked, short};
use littlewood_style::width::CURVE;
use littlewood_style::{Curve, Dash};

const NAME: &str = "figure-2a";

/// The coefficients of the paper, and how their curves are drawn.
const COEFFICIENTS: [(f64, Dash); 4] = [
    (0.1, Dash::Dotted),
    (0.25, Dash::Short),
    (0.5, Dash::Dashed),
    (1.0, Dash::DashDot),
];

/// Heights of the arrow across the curves, in parts of the upper half as it is seen: the first at which it
/// crosses all.
const HEIGHTS: [f64; 4] = [0.78, 0.9, 0.62, 0.46];

/// The greatest angle of the half turn from the top on at which a locus has this rate.
fn reach(locus: &Series, rate: f64) -> Option<f64> {
    let pairs = locus.pieces.iter().flat_map(|piece| piece.windows(2));
    let crossed = pairs
        .filter(|pair| (pair[0][1] < rate) != (pair[1][1] < rate))
        .map(|pair| {
            let share = (rate - pair[0][1]) / (pair[1][1] - pair[0][1]);
            pair[0][0] + share * (pair[1][0] - pair[0][0])
        });
    crossed
        .filter(|theta| (0.0..PI).contains(theta))
        .reduce(f64::max)
}

/// The arrow that crosses all curves at a height, from the locus of the least coefficient to that
/// of the greatest.
fn across(least: &Series, greatest: &Series, height: f64) -> Option<[[f64; 2]; 2]> {
    let (from, to) = (reach(least, height)?, reach(greatest, height)?);
    (from > to + 0.3).then_some([[from + 0.14, height], [to - 0.1, height]])
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.with_inertia(NAME)?;
    let portrait = Portrait::new(&input.hoop, portrait_window(&input.hoop));
    let mut layers = vec![portrait.unloaded().drawn(Mark::Hatch(HATCH))];
    layers.extend(portrait.orbits(&portrait.choose(3, 6), 1.2));
    let (mut keys, mut loci) = (Vec::new(), Vec::new());
    for (mu_s, dash) in COEFFICIENTS {
        let mark = Mark::Line(Stroke::of_curve(Curve::SlipLimit).wide(CURVE).dashed(dash));
        let text = format!("{} = {}", marked(Quantity::MuS.sign()), short(mu_s));
        let locus = portrait.slip_locus(mu_s)?;
        if !locus.pieces.is_empty() {
            keys.push((mark, text));
        }
        loci.push(locus.clone());
        layers.push(locus.drawn(mark));
    }
    let unloading = portrait.unloading_locus();
    let mark = Mark::Line(Stroke::of_curve(Curve::NormalForceZero));
    if !unloading.pieces.is_empty() {
        keys.push((mark, "*n*: *N* = 0".to_owned()));
    }

    let heights = HEIGHTS.map(|share| portrait.rate_at(share));
    let arrow = heights
        .into_iter()
        .find_map(|height| across(&loci[0], &loci[3], height));
    let mut labels = portrait.mark_of_unloading();
    if let Some(ends) = arrow {
        let arrow = Series::of_rows("increasing mu_s", &PLANE, ends);
        layers.push(arrow.drawn(Mark::Arrow(Stroke::solid(INK, 1.2))));
        labels.push(Label::new("*μ*_{s}", &ends[0]).shifted(5.0, 0.0).left());
    }
    layers.push(unloading.drawn(mark));
    layers.extend(portrait.equilibria());
    let say = input.wording();
    let orbits = if portrait.resists() {
        "Grey: orbits, which lose energy to rolling resistance, above *θ*′ = 0 to the right and below it to the left, and end in the \
         band of rest (thick); black: the orbits to its far edge about the top."
    } else {
        "Grey: orbits of constant energy; black: the separatrix; ring and dot: unstable and stable equilibrium."
    };
    let caption = format!(
        "Where static friction gives way in rolling: loci |*F*| = *μ*_{{s}}*N* (2.13) for four coefficients. As \
         *μ*_{{s}} grows{} they approach the locus *n*, *N* = 0; beyond it (hatched) rolling would need *N* \
         < 0. {orbits} The closed loops of small *μ*_{{s}} enclose starts that slip although the hoop is nearly at \
         rest.{} {}.",
        if arrow.is_some() { " (arrow)" } else { "" },
        portrait.remark(),
        say.body(&input.hoop)
    );
    let title = "Figure 2(a): loci |*F*| = *μ*_{s}*N* of rolling";
    let content = portrait.content("plane", say, layers, labels);
    input.plane(NAME, title, caption, content, keys)
}
