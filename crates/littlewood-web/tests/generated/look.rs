//! Colours and lines as TypeScript, for what is drawn, and as a style sheet, for the document.

use core::fmt::Write;

use littlewood::Mode;
use littlewood_style::{
    Accent, Arrow, Curve, Dash, EnergyPart, ImpulseLine, Ink, Rgb, Swatch, Theme, dash_of, of_mode,
    swatches,
};
use littlewood_web::HOP_CLASSES;

use crate::generated::source::{Source, WRITTEN, object, quoted, quoted_or_null};

/// How much of the colour of a class a map shows that lies behind curves and letters.
const MAP_OPACITY: f64 = 0.55;

/// How much of its colour a map shows of a motion without landing, and of one with the most.
const HOP_OPACITY: [f64; 2] = [0.04, 0.82];

/// How much of the ink the region where the hoop can roll adds to what is below it.
const REGION_OPACITY: f64 = 0.12;

/// `palette.ts`.
pub(crate) fn typescript() -> String {
    let mut source = Source::new("Colours and lines of the style crate.");
    source.lines("import type { Class, Mode } from './tables';");
    source.names(
        "INKS",
        "Ink",
        "Colours of what is not data.",
        Ink::ALL.map(Ink::name),
    );
    source.names(
        "ARROWS",
        "Arrow",
        "Vectors that are drawn at the hoop.",
        Arrow::ALL.map(Arrow::name),
    );
    source.names(
        "CURVES",
        "Curve",
        "Curves of the phase plane.",
        Curve::ALL.map(Curve::name),
    );
    source.names(
        "ACCENTS",
        "Accent",
        "Colours for what has none of its own.",
        Accent::ALL.map(Accent::name),
    );
    let lines = ImpulseLine::ALL.map(ImpulseLine::name);
    source.names(
        "IMPULSE_LINES",
        "ImpulseLine",
        "Lines of the plane of impulses.",
        lines,
    );
    let parts = EnergyPart::ALL.map(EnergyPart::name);
    source.names(
        "ENERGY_PARTS",
        "EnergyPart",
        "Where the energy of the start is, in the order in which the core gives it.",
        parts,
    );
    source.lines(
        "export interface Palette {
  ink: Readonly<Record<Ink, string>>;
  mode: Readonly<Record<Mode, string>>;
  /** A class in a map that lies behind curves. */
  class: Readonly<Record<Class, string>>;
  arrow: Readonly<Record<Arrow, string>>;
  curve: Readonly<Record<Curve, string>>;
  impulse: Readonly<Record<ImpulseLine, string>>;
  energy: Readonly<Record<EnergyPart, string>>;
  accent: Readonly<Record<Accent, string>>;
  /** Classes of landings in a map, the fewer the paler. */
  hops: readonly string[];
  /** The region where the hoop can roll, over whatever is below. */
  region: string;
}",
    );
    let palettes = Theme::ALL.map(|theme| (theme.name(), palette(theme)));
    source.record(
        "PALETTES",
        ("'light' | 'dark'", "Palette"),
        "The colours on each paper.",
        palettes,
    );
    let dashes = Mode::ALL.map(|mode| (mode.name(), pattern(dash_of(mode))));
    let doc = "Dashes of a line that shows a mode, in units of its width.";
    source.record("MODE_DASHES", ("Mode", "readonly number[]"), doc, dashes);
    source.lines(
        "export interface LineRow {
  label: string;
  /** In units of the width. */
  dash: readonly number[];
  width: number;
}",
    );
    source.lines(
        "export interface CurveRow extends LineRow {
  labelOnSlope: string;
  /** The letter of the paper. */
  letter: string | null;
  /** What it means to the hoop. */
  meaning: string | null;
}",
    );
    let curves = Curve::ALL.map(|curve| {
        let fields = [
            ("label", quoted(curve.label(0.0))),
            ("labelOnSlope", quoted(curve.label(1.0))),
            ("letter", quoted_or_null(curve.letter())),
            ("meaning", quoted_or_null(curve.meaning())),
            ("dash", pattern(curve.dash())),
            ("width", curve.width().to_string()),
        ];
        (curve.name(), object(&fields))
    });
    source.record(
        "CURVE_ROWS",
        ("Curve", "CurveRow"),
        "The table of curves.",
        curves,
    );
    let lines = ImpulseLine::ALL.map(|line| {
        let fields = [
            ("label", quoted(line.label())),
            ("dash", pattern(line.dash())),
            ("width", line.width().to_string()),
        ];
        (line.name(), object(&fields))
    });
    let doc = "The table of lines of the plane of impulses.";
    source.record("IMPULSE_LINE_ROWS", ("ImpulseLine", "LineRow"), doc, lines);
    let labels = EnergyPart::ALL.map(|part| (part.name(), quoted(part.label())));
    source.record(
        "ENERGY_LABELS",
        ("EnergyPart", "string"),
        "In words.",
        labels,
    );
    source.text()
}

fn palette(theme: Theme) -> String {
    let mut text = "{".to_owned();
    for swatches in swatches(theme).chunk_by(|a, b| a.group == b.group) {
        let _ = write!(text, "\n    {}: {{", swatches[0].group);
        for swatch in swatches {
            let _ = write!(
                text,
                "\n      {}: {},",
                swatch.name,
                quoted(&shown(swatch, theme).hex())
            );
        }
        text.push_str("\n    },");
    }
    let hops = hops(theme).map(|colour| quoted(&colour.hex())).join(", ");
    let _ = write!(
        text,
        "\n    hops: [{hops}],\n    region: {},\n  }}",
        quoted(&region(theme))
    );
    text
}

fn pattern(dash: Dash) -> String {
    format!("{:?}", dash.pattern())
}

/// `palette.css`: inks and accents as variables of the document; the colour of a mode, a class, an
/// arrow or a curve as a variable of the element that names it in an attribute, with a colour for
/// letters on it; that of a class of landings by its place.
pub(crate) fn css() -> String {
    let mut variables = String::new();
    let mut rules = String::new();
    for (light, dark) in swatches(Theme::Light).iter().zip(&swatches(Theme::Dark)) {
        let Swatch { group, name, .. } = light;
        let [on_light, on_dark] = [shown(light, Theme::Light), shown(dark, Theme::Dark)];
        let colour = light_dark(on_light.hex(), on_dark.hex());
        if ["ink", "accent"].contains(group) && *name != Ink::Region.name() {
            let _ = writeln!(variables, "  --{}: {colour};", name.replace('_', "-"));
        } else if *group != "ink" {
            let letters = light_dark(
                letters(on_light, Theme::Light),
                letters(on_dark, Theme::Dark),
            );
            let _ = write!(
                rules,
                "\n[data-{group}='{name}'] {{\n  --{group}: {colour};\n  --on-{group}: {letters};\n}}\n"
            );
        }
    }
    for (class, (light, dark)) in hops(Theme::Light)
        .into_iter()
        .zip(hops(Theme::Dark))
        .enumerate()
    {
        let colour = light_dark(light.hex(), dark.hex());
        let _ = write!(
            rules,
            "\n[data-hops='{class}'] {{\n  --hops: {colour};\n}}\n"
        );
    }
    let region = light_dark(region(Theme::Light), region(Theme::Dark));
    format!(
        "/* Colours of the style crate. {WRITTEN} */\n:root {{\n{variables}  --region: {region};\n}}\n{rules}"
    )
}

fn light_dark(light: String, dark: String) -> String {
    format!("light-dark({light}, {dark})")
}

/// A colour as the page shows it.
fn shown(swatch: &Swatch, theme: Theme) -> Rgb {
    if swatch.group == "class" {
        swatch.colour.over(Ink::Paper.colour(theme), MAP_OPACITY)
    } else {
        swatch.colour
    }
}

/// The colours of the classes of landings: one colour, so that its strength, in grey too, tells
/// more from fewer.
fn hops(theme: Theme) -> [Rgb; HOP_CLASSES] {
    let [least, most] = HOP_OPACITY;
    core::array::from_fn(|class| {
        let part = class as f64 / (HOP_CLASSES - 1) as f64;
        Accent::Violet
            .colour(theme)
            .over(Ink::Paper.colour(theme), least + (most - least) * part)
    })
}

/// The more legible colour for letters on a colour.
fn letters(ground: Rgb, theme: Theme) -> String {
    ground
        .more_legible(Ink::Paper.colour(theme), Ink::Ink.colour(theme))
        .hex()
}

/// Neutral and translucent: the colour of the region would be taken for a class of the map below.
fn region(theme: Theme) -> String {
    format!(
        "{}{:02x}",
        Ink::Ink.colour(theme).hex(),
        (255.0 * REGION_OPACITY).round() as u8
    )
}

/// `icon.svg`: a hoop on the plane with its particle.
pub(crate) fn icon() -> String {
    let ground = Ink::Soft.colour(Theme::Light).hex();
    let hoop = of_mode(Mode::Rolling, Theme::Light).hex();
    let particle = of_mode(Mode::Sliding, Theme::Light).hex();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 32 32\">\
         <path d=\"M1 30h30\" stroke=\"{ground}\" stroke-width=\"2\"/>\
         <circle cx=\"16\" cy=\"16\" r=\"12\" fill=\"none\" stroke=\"{hoop}\" stroke-width=\"3.5\"/>\
         <circle cx=\"24.5\" cy=\"7.5\" r=\"5\" fill=\"{particle}\"/></svg>\n"
    )
}
