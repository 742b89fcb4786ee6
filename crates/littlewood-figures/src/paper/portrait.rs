//! Figures 2(b) and 4: phase portraits of rolling, with inertia and without.

use core::f64::consts::{FRAC_PI_2, PI};

use littlewood::theory::Window;
use littlewood_draw::{
    Entries, FAINT, FRICTION_FORCE, Figure, HATCH, INK, Label, Layer, Mark, NORMAL_FORCE, Point,
    REGION, Series, key_of_curve, lift_off_condition, short,
};
use littlewood_style::Curve;
use littlewood_style::width::CURVE;

use crate::axes::portrait_window;
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::{Orbits, Portrait, mirrored};

/// The names of the curves and of 𝓡.
fn names(portrait: &Portrait, slip: &Series, unloading: &Series) -> Vec<Label> {
    let (most, hoop) = (portrait.window.y[1], &portrait.hoop);
    let mut labels = portrait.mark_of_unloading();
    let f = portrait.name_of(slip, Point::new(0.62 * PI, 0.72 * most), "*f*");
    labels.extend(f.map(|f| f.shifted(11.0, 0.0).coloured(FRICTION_FORCE)));
    let n = portrait.name_of(unloading, Point::new(0.45 * PI, 0.72 * most), "*n*");
    labels.extend(n.map(|n| n.shifted(10.0, 0.0).coloured(NORMAL_FORCE)));
    // Without friction it has no area.
    if hoop.mu_s() > 0.0 {
        labels.push(Label::new("𝓡", &[PI, 0.62 * most]).sized(20.0).of_area());
    }
    labels
}

/// What a caption says of the orbits, and of where the hoop is at rest.
fn orbits_in_words(portrait: &Portrait) -> String {
    let on_top = if portrait.hoop.slope() == 0.0 {
        ", the particle on top"
    } else {
        ""
    };
    if !portrait.resists() {
        return format!(
            "Phase portrait of rolling (2.10): orbits are lines of constant energy. Ring: unstable equilibrium{on_top}, \
             with its separatrix (black). Dot: stable equilibrium."
        );
    }
    if portrait.band_of_rest().is_none() {
        return "Phase portrait of rolling with rolling resistance, which takes energy along all orbits (grey). It holds the hoop nowhere."
            .to_owned();
    }
    "Phase portrait of rolling with rolling resistance: orbits (grey) lose energy, each is shown to its second turning point, and end in \
     the band of rest (thick), where the resistance holds the hoop against its weight. Black: the orbits that come to the far edge of \
     the band about the top, and those that leave it there."
        .to_owned()
}

/// Keys of what the caption of a hoop without rolling resistance need not name.
fn keys_of(portrait: &Portrait) -> Entries {
    let band = portrait.band_of_rest().into_iter();
    band.map(|_| key_of_curve(Curve::BandOfRest, portrait.hoop.slope()))
        .collect()
}

/// Figure 2(b).
pub(crate) fn with_inertia(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-2b";
    input.with_inertia(NAME)?;
    let hoop = &input.hoop;
    let portrait = Portrait::new(hoop, portrait_window(hoop));
    let orbits = portrait.choose(3, 6);
    let mut layers = vec![
        portrait.rolling_region().drawn(Mark::Fill(REGION)),
        portrait.unloaded().drawn(Mark::Hatch(HATCH)),
    ];
    layers.extend(portrait.orbits(&orbits, CURVE));
    let slip = portrait.slip_locus(hoop.mu_s())?;
    let unloading = portrait.unloading_locus();
    let lift_off = portrait.lift_off_locus();
    let labels = names(&portrait, &slip, &unloading);
    layers.push(slip.drawn(Curve::SlipLimit));
    let lifts_off = !lift_off.pieces.is_empty();
    layers.push(lift_off.drawn(Curve::LiftOff));
    layers.push(unloading.drawn(Curve::NormalForceZero));
    let chatter = portrait.reverse_chatter();
    let chatters = !chatter.pieces.is_empty();
    if chatters {
        layers.push(chatter.drawn(Curve::ReverseChatter));
    }
    layers.push(portrait.flow_of(&orbits, PI).drawn(Mark::Head(FAINT)));
    layers.extend(portrait.separatrix_heads());
    let equilibria = portrait.equilibria();
    // The curve is close to others.
    let mut keys: Entries = lifts_off
        .then(|| key_of_curve(Curve::LiftOff, hoop.slope()))
        .into_iter()
        .collect();
    keys.extend(keys_of(&portrait));
    layers.extend(equilibria);
    let say = input.wording();
    let caption = format!(
        "{} On the curves *f* static friction \
         gives way, |*F*| = *μ*_{{s}}*N*; on *n* the normal force of rolling vanishes. Shaded: region 𝓡 of (2.14), \
         where the hoop can roll. Hatched: *N* < 0. The paper lets the hoop lose contact there at once; but \
         between *n* and the curve {} it slides.{}{} {}{}.",
        orbits_in_words(&portrait),
        lift_off_condition(hoop.slope()),
        portrait.remark(),
        if chatters {
            " Within the dotted curves bounces grow out of rolling (reverse chatter)."
        } else {
            ""
        },
        if hoop.mu_s() == 0.0 {
            "Without friction 𝓡 has no area. "
        } else {
            ""
        },
        say.rolling(hoop)
    );
    let title = "Figure 2(b): phase portrait of rolling";
    let content = portrait.content("plane", say, layers, labels);
    input.plane(NAME, title, caption, content, keys)
}

/// Where arrows stand on the manifolds, away from the lines n, which they cross at ±π/2.
const HEADS: f64 = 0.63 * PI;

/// How far from where an orbit turns its arrows stand.
const AFTER: f64 = 0.05 * PI;

const FIGURE_4: &str = "figure-4";

/// The names of the curves and of 𝓡 of a massless hoop.
fn massless_names(portrait: &Portrait, unloading: &Series, limit: Option<&Series>) -> Vec<Label> {
    let most = portrait.window.y[1];
    let mut labels = Vec::new();
    let n = portrait.name_of(unloading, Point::new(0.3 * PI, 0.7 * most), "*n*");
    labels.extend(n.map(|n| n.shifted(10.0, -4.0).coloured(NORMAL_FORCE)));
    if let Some(series) = limit {
        // Beside each vertical of half a turn, outside of 𝓡.
        let verticals = series.pieces.iter().filter_map(|piece| piece.first());
        for (row, right) in verticals
            .filter(|row| (0.0..PI).contains(&row[0]) && row[1] != 0.0)
            .zip([10.0, -10.0])
        {
            let label = Label::new("*f*", &[row[0], 0.7 * row[1]]).shifted(right, 0.0);
            labels.push(label.coloured(FRICTION_FORCE));
        }
    }
    labels.push(
        Label::new("𝓡", &[portrait.middle(), 0.62 * most])
            .sized(20.0)
            .of_area(),
    );
    labels
}

/// Figure 4 with the particle inside the rim: the portrait of footnote 7, which has a stable
/// equilibrium; or with rolling resistance.
fn massless_beyond(input: &FigureInput, window: Window) -> Result<Figure, FigureError> {
    let hoop = &input.hoop;
    let portrait = Portrait::new(hoop, window);
    let orbits = portrait.choose(3, 6);
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    layers.extend(portrait.orbits(&orbits, CURVE));
    let unloading = portrait.unloading_locus();
    let limit = portrait.massless_limit().map(|(_, series)| series);
    let labels = massless_names(&portrait, &unloading, limit.as_ref());
    layers.push(unloading.drawn(Curve::NormalForceZero));
    let always = limit.is_none();
    layers.extend(limit.map(|series| series.drawn(Curve::SlipLimit)));
    let middle = portrait.middle();
    layers.push(portrait.flow_of(&orbits, middle).drawn(Mark::Head(FAINT)));
    layers.extend(portrait.separatrix_heads());
    layers.extend(portrait.equilibria());
    let say = input.wording();
    let friction = match (always, portrait.resists()) {
        (true, true) => "Static friction always holds.",
        (true, false) => {
            "Static friction always holds, for *μ*_{s} is not less than *ℓ*/√(1 − *ℓ*^{2}); *ℓ* in radii."
        }
        (false, true) => {
            "On *f* static friction gives way, |*ℓ* sin *θ* − *ςχ*| = *μ*_{s}(1 + *ℓ* cos *θ*) with the sign *ς* of *θ*′, whatever the rate; *ℓ* in radii."
        }
        (false, false) => {
            "On *f* static friction gives way, |*F*|/*N* = *ℓ* |sin *θ*|/(1 + *ℓ* cos *θ*) = *μ*_{s}, whatever the rate; *ℓ* in radii. \
             Towards the bottom it holds again."
        }
    };
    let (title, first) = if portrait.resists() {
        (
            "Figure 4 with rolling resistance",
            format!("A massless hoop. {}", orbits_in_words(&portrait)),
        )
    } else {
        (
            "Figure 4 with the particle inside the rim",
            "Phase portrait of a rolling massless hoop with the particle inside the rim (footnote 7): lines of constant energy. \
             Unlike Littlewood's hoop it has a stable equilibrium (dot), about which it can roll for ever."
                .to_owned(),
        )
    };
    let last = if portrait.resists() {
        "."
    } else {
        "; black: separatrix."
    };
    let caption = format!(
        "{first} {friction} On *n* the normal force vanishes. Shaded: 𝓡, where the hoop can roll{last} {}.",
        say.rolling(hoop)
    );
    let content = portrait.content("plane", say, layers, labels);
    let keys = keys_of(&portrait);
    input.plane(FIGURE_4, title, caption, content, keys)
}

/// What bounds 𝓡 in Figure 4, and the names.
fn bounds_of_rolling(portrait: &Portrait) -> (Vec<Layer>, Vec<Label>) {
    let mut layers = vec![portrait.unloading_locus().drawn(Curve::NormalForceZero)];
    let n = Label::new("*n*", &[0.8 * PI, 1.0]).shifted(0.0, -11.0);
    let mut labels = mirrored(n.coloured(NORMAL_FORCE), 1).to_vec();
    labels.extend(mirrored(
        Label::new("*N* < 0", &[-0.25 * PI, 1.75]).of_area(),
        1,
    ));
    if let Some((theta, limit)) = portrait.massless_limit() {
        layers.push(limit.drawn(Curve::SlipLimit));
        let f = Label::new("*f*", &[theta, -0.72]).shifted(10.0, 0.0);
        labels.extend(mirrored(f.coloured(FRICTION_FORCE), 0));
        labels.push(Label::new("𝓡", &[-0.62 * theta, 0.0]).sized(20.0).of_area());
    }
    (layers, labels)
}

/// Angles at which orbits of Figure 4 turn, and rates with which others pass over the top.
const TURNS: [f64; 4] = [0.2 * PI, 0.4 * PI, 0.6 * PI, 0.8 * PI];
const RATES: [f64; 6] = [0.25, 0.5, 0.75, 1.2, 1.5, 1.8];

/// The arrows of Figure 4: of the manifolds, of the orbits that pass over the top, and of those
/// that turn.
fn heads(portrait: &Portrait, over: &[f64], turning: &[f64]) -> Vec<Layer> {
    let separatrix = [portrait.law.separatrix_energy()];
    let mut angles = vec![-HEADS, HEADS];
    // In 𝓡, halfway to its boundary.
    if let Some((limit, _)) = portrait.massless_limit() {
        let inside = 0.5 * f64::min(limit, FRAC_PI_2);
        angles.extend([-inside, inside]);
    }
    let of_manifolds = angles
        .into_iter()
        .map(|theta| portrait.flow(&separatrix, theta));
    let mut layers: Vec<Layer> = of_manifolds
        .map(|flow| flow.drawn(Mark::Head(INK)))
        .collect();
    layers.push(portrait.flow(over, 0.0).drawn(Mark::Head(FAINT)));
    for (energy, turn) in turning.iter().zip(TURNS) {
        // A little after they have turned, where they go outwards.
        for side in [1.0, -1.0] {
            let flow = portrait.flow(&[*energy], side * (turn + AFTER));
            layers.push(flow.drawn(Mark::Head(FAINT)));
        }
    }
    layers
}

/// Figure 4.
pub(crate) fn massless(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = FIGURE_4;
    input.massless(NAME)?;
    input.level(NAME)?;
    if input.hoop.offset() < 1.0 {
        return massless_beyond(input, portrait_window(&input.hoop));
    }
    let window = Window {
        x: [-PI, PI],
        y: [-2.0, 2.0],
    };
    if input.hoop.rolling_resistance() > 0.0 {
        return massless_beyond(input, window);
    }
    let portrait = Portrait::new(&input.hoop, window);
    // By (3.2), at the top and at rest.
    let over = RATES.map(|rate| 2.0 * rate * rate + 1.0);
    let turning = TURNS.map(libm::cos);
    let mut layers = vec![
        portrait.rolling_region().drawn(Mark::Fill(REGION)),
        portrait.unloaded().drawn(Mark::Hatch(HATCH)),
    ];
    let orbits = Orbits::Levels([&over[..], &turning].concat());
    layers.extend(portrait.orbits(&orbits, CURVE));
    let (bounds, labels) = bounds_of_rolling(&portrait);
    layers.extend(bounds);
    layers.extend(heads(&portrait, &over, &turning));
    layers.extend(portrait.equilibria());
    let caption = format!(
        "Phase portrait of the rolling massless hoop (3.1), lines of constant *e* (3.2). There is no equilibrium at \
         *θ* = ±π, where the equation is singular. Shaded: region 𝓡 (3.10), bounded by *f*, where static friction \
         gives way (*θ* = ±*θ*_{{s}}, *θ*_{{s}} = 2 atan *μ*_{{s}}), and by *n*, where the normal force vanishes \
         (*θ*′ = ±1; hatched: *N* < 0). 𝓡 shrinks to nothing as *μ*_{{s}} → 0. Black: stable and unstable manifolds of the \
         equilibrium. *μ*_{{s}} = {}.",
        short(input.hoop.mu_s())
    );
    let title = "Figure 4: phase portrait of the rolling massless hoop";
    let content = portrait.content("plane", input.wording(), layers, labels);
    input.plane(NAME, title, caption, content, Vec::new())
}
