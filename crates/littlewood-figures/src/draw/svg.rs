//! A sheet as SVG.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use littlewood_style::{Dash, Rgb};
use skrifa::GlyphId;

use super::canvas::STEPS;
use super::face::{FAMILY, rules};
use super::item::{HALO, HATCH, Item, Paint, Step, Words};
use super::letters::{self, Glyph, glyphs};
use super::markup::{plain, runs};
use crate::figure::{Anchor, Figure};
use crate::style::PAPER;

/// What the letters of an SVG are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Letters {
    /// Outlines: every program shows the right ones.
    #[default]
    Paths,
    /// Text that can be selected, in two faces that the file carries; programs that do not read faces from a file take
    /// another.
    Text,
}

/// A drawing.
pub(crate) fn document(figure: &Figure, items: &[Item], letters: Letters) -> String {
    let mut sheet = Sheet { body: String::new(), hatches: BTreeMap::new(), outlines: BTreeMap::new() };
    for item in items {
        sheet.add(item, letters);
    }
    let (w, h) = (decimal(figure.width), decimal(figure.height));
    let size = figure.print_mm.map_or_else(
        || format!("width=\"{w}\" height=\"{h}\""),
        |mm| {
            format!("width=\"{}mm\" height=\"{}mm\"", decimal(mm), decimal(mm * figure.height / figure.width))
        },
    );
    let family = match letters {
        Letters::Paths => String::new(),
        Letters::Text => format!(" font-family=\"{FAMILY}\""),
    };
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" {size} \
         viewBox=\"0 0 {w} {h}\" role=\"img\"{family}>\n<title>{}</title>\n<desc>{}</desc>\n<defs>\n",
        escape(&plain(&figure.title)),
        escape(&plain(&figure.caption)),
    );
    if letters == Letters::Text {
        let _ = write!(out, "<style>\n{}</style>\n", rules());
    }
    let [apart, wide, middle] = [HATCH[0], HATCH[1], 0.5 * HATCH[0]].map(decimal);
    for (id, colour) in sheet.hatches {
        let _ = writeln!(
            out,
            "<pattern id=\"{id}\" width=\"{apart}\" height=\"{apart}\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate(45)\"><path d=\"M{middle} 0V{apart}\" stroke=\"{}\" stroke-width=\"{wide}\"/></pattern>",
            colour.hex()
        );
    }
    for (id, outline) in sheet.outlines {
        let _ = writeln!(out, "<path id=\"{id}\" d=\"{outline}\"/>");
    }
    let _ = write!(
        out,
        "</defs>\n<rect width=\"{w}\" height=\"{h}\" fill=\"{}\"/>\n{}</svg>\n",
        PAPER.hex(),
        sheet.body
    );
    out
}

struct Sheet {
    body: String,
    /// By identifiers that mean the same in every drawing, so that several can stand in one page.
    hatches: BTreeMap<String, Rgb>,
    outlines: BTreeMap<String, String>,
}

impl Sheet {
    fn add(&mut self, item: &Item, letters: Letters) {
        match item {
            Item::Path { points, paint } => {
                let close = if matches!(paint, Paint::Edge { .. }) { "" } else { "z" };
                let paint = self.paint(*paint);
                let _ = writeln!(self.body, "<path d=\"{}{close}\" {paint}/>", data(points));
            }
            Item::Area { outlines, paint } => {
                let outlines: Vec<String> = outlines.iter().map(|outline| data(outline) + "z").collect();
                let paint = self.paint(*paint);
                let _ = writeln!(self.body, "<path d=\"{}\" {paint}/>", outlines.concat());
            }
            Item::Image { corners: [(left, top), (right, bottom)], image } => {
                let _ = writeln!(
                    self.body,
                    "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
                     xlink:href=\"data:image/png;base64,{}\"/>",
                    number(*left),
                    number(*top),
                    number(right - left),
                    number(bottom - top),
                    STANDARD.encode(image.png())
                );
            }
            Item::Rectangle { corners: [(left, top), (right, bottom)], paint } => {
                let paint = self.paint(*paint);
                let _ = writeln!(
                    self.body,
                    "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {paint}/>",
                    number(*left),
                    number(*top),
                    number(right - left),
                    number(bottom - top)
                );
            }
            Item::Circle { centre: (x, y), radius, paint } => {
                let paint = self.paint(*paint);
                let _ = writeln!(
                    self.body,
                    "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {paint}/>",
                    number(*x),
                    number(*y),
                    number(*radius)
                );
            }
            Item::Words(words) => match letters {
                Letters::Paths => self.outlined(words),
                Letters::Text => self.body += &text(words),
            },
        }
    }

    fn paint(&mut self, paint: Paint) -> String {
        match paint {
            Paint::Fill(colour) => format!("fill=\"{}\"", colour.hex()),
            Paint::Hatch(colour) => {
                let id = format!("hatch-{}", &colour.hex()[1..]);
                let paint = format!("fill=\"url(#{id})\"");
                self.hatches.insert(id, colour);
                paint
            }
            Paint::Edge { colour, width, dash } => {
                let mut out = format!(
                    "fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                    colour.hex(),
                    decimal(width)
                );
                if dash == Dash::Solid {
                    out += " stroke-linecap=\"round\"";
                } else {
                    let pattern: Vec<String> =
                        dash.pattern().iter().map(|part| decimal(part * width)).collect();
                    let _ = write!(out, " stroke-dasharray=\"{}\"", pattern.join(" "));
                }
                out
            }
        }
    }

    /// A text by the outlines of its letters, each of which the file has once.
    fn outlined(&mut self, words: &Words) {
        let [x, y] = words.at;
        let turn = if words.upwards { " rotate(-90)" } else { "" };
        let _ = writeln!(
            self.body,
            "<g aria-label=\"{}\" transform=\"translate({} {}){turn}\" fill=\"{}\">",
            escape(&plain(&words.text)),
            decimal(x),
            decimal(y),
            words.colour.hex()
        );
        let back = words.back();
        let glyphs = glyphs(&words.text, words.size);
        if words.halo {
            for glyph in &glyphs {
                let around = format!(
                    " fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                    PAPER.hex(),
                    decimal(2.0 * HALO / glyph.unit)
                );
                self.glyph(glyph, back, &around);
            }
        }
        for glyph in &glyphs {
            let bold = format!(
                " stroke=\"{}\" stroke-width=\"{}\"",
                words.colour.hex(),
                decimal(glyph.bold / glyph.unit)
            );
            self.glyph(glyph, back, if glyph.bold > 0.0 { &bold } else { "" });
        }
        self.body += "</g>\n";
    }

    fn glyph(&mut self, glyph: &Glyph, back: f64, attributes: &str) {
        let id = format!("{}{}", ["r", "i"][glyph.face], glyph.id.to_u32());
        if !self.outlines.contains_key(&id) {
            self.outlines.insert(id.clone(), outline(glyph.face, glyph.id));
        }
        if self.outlines.get(&id).is_some_and(String::is_empty) {
            return;
        }
        let [x, y] = glyph.at;
        let unit = format!("{:.5}", glyph.unit);
        let unit = unit.trim_end_matches('0');
        let _ = writeln!(
            self.body,
            "<use xlink:href=\"#{id}\" transform=\"matrix({unit} 0 0 -{unit} {} {})\"{attributes}/>",
            decimal(x - back),
            decimal(y)
        );
    }
}

/// A text as text.
fn text(words: &Words) -> String {
    let [x, y] = words.at;
    let mut attributes = format!(
        "x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"",
        decimal(x),
        decimal(y),
        decimal(words.size),
        words.colour.hex()
    );
    match words.anchor {
        Anchor::Left => {}
        Anchor::Middle => attributes += " text-anchor=\"middle\"",
        Anchor::Right => attributes += " text-anchor=\"end\"",
    }
    if words.upwards {
        let _ = write!(attributes, " transform=\"rotate(-90 {} {})\"", decimal(x), decimal(y));
    }
    if words.halo {
        let _ = write!(
            attributes,
            " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
            PAPER.hex(),
            decimal(2.0 * HALO)
        );
    }
    format!("<text {attributes}>{}</text>\n", spans(&words.text, words.size))
}

/// A text with its symbols.
fn spans(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut below = 0.0;
    for run in runs(text) {
        let [scale, wanted] = run.script.placed(size);
        let mut attributes = String::new();
        if wanted != below {
            let _ = write!(attributes, " dy=\"{}\"", decimal(wanted - below));
            below = wanted;
        }
        if scale != size {
            let _ = write!(attributes, " font-size=\"{}\"", decimal(scale));
        }
        if run.italic {
            attributes += " font-style=\"italic\"";
        }
        if run.bold {
            attributes += " font-weight=\"bold\"";
        }
        if attributes.is_empty() {
            out += &escape(run.text);
        } else {
            let _ = write!(out, "<tspan{attributes}>{}</tspan>", escape(run.text));
        }
    }
    out
}

/// The outline of a letter in units of its face.
fn outline(face: usize, id: GlyphId) -> String {
    let mut out = String::new();
    for stroke in letters::outline(face, id) {
        let (letter, points) = match stroke {
            letters::Stroke::Move(to) => ("M", vec![to]),
            letters::Stroke::Line(to) => ("L", vec![to]),
            letters::Stroke::Quad(a, to) => ("Q", vec![a, to]),
            letters::Stroke::Cubic(a, b, to) => ("C", vec![a, b, to]),
            letters::Stroke::Close => ("z", vec![]),
        };
        let numbers: Vec<String> = points.into_iter().flatten().map(decimal).collect();
        out += letter;
        out += &numbers.join(" ");
    }
    out
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Data of a path: the first point, then the way from each to the next.
fn data(points: &[Step]) -> String {
    let mut out = String::new();
    let mut last: Option<Step> = None;
    for &(x, y) in points {
        if let Some((a, b)) = last {
            if !out.ends_with('l') {
                out.push(' ');
            }
            let _ = write!(out, "{} {}", number(x - a), number(y - b));
        } else {
            let _ = write!(out, "M{} {}l", number(x), number(y));
        }
        last = Some((x, y));
    }
    if out.ends_with('l') {
        out += "0 0";
    }
    out
}

/// A whole number of steps as pixels.
fn number(value: i32) -> String {
    decimal(f64::from(value) / STEPS)
}

/// With two decimals at most.
fn decimal(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_exact_to_a_step() {
        assert_eq!(data(&[(0, 0), (20, 1), (-20, 0)]), "M0 0l1 0.05 -2 -0.05");
        assert_eq!(data(&[(5, 5)]), "M0.25 0.25l0 0");
    }

    #[test]
    fn a_subscript_goes_down_and_comes_back() {
        assert_eq!(
            spans("*μ*_{s}*N* < 1", 10.0),
            "<tspan font-style=\"italic\">μ</tspan><tspan dy=\"2.2\" font-size=\"7.2\">s</tspan>\
             <tspan dy=\"-2.2\" font-style=\"italic\">N</tspan> &lt; 1"
        );
    }
}
