//! A sheet as SVG.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use littlewood_style::Dash;

use crate::figure::Figure;
use crate::item::{Corners, Item, Paint, STEPS, Step, Words};
use crate::letters::{Glyph, glyphs};
use crate::markup::plain;
use crate::stroke::PAPER;

/// A drawing.
pub(crate) fn document(figure: &Figure, items: &[Item]) -> String {
    let mut sheet = Sheet {
        body: String::new(),
        outlines: BTreeMap::new(),
    };
    for item in items {
        sheet.add(item);
    }
    let (w, h) = (decimal(figure.width), decimal(figure.height));
    let size = figure.print_mm.map_or_else(
        || format!("width=\"{w}\" height=\"{h}\""),
        |mm| {
            format!(
                "width=\"{}mm\" height=\"{}mm\"",
                decimal(mm),
                decimal(mm * figure.height / figure.width)
            )
        },
    );
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" {size} \
         viewBox=\"0 0 {w} {h}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<defs>\n",
        escape(&plain(&figure.title)),
        escape(&plain(&figure.caption)),
    );
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
    outlines: BTreeMap<&'static str, &'static str>,
}

impl Sheet {
    fn add(&mut self, item: &Item) {
        match item {
            Item::Path { lines, paint } => {
                let close = if matches!(paint, Paint::Edge(_)) {
                    ""
                } else {
                    "z"
                };
                let lines: Vec<String> = lines.iter().map(|line| data(line) + close).collect();
                let paint = Self::paint(*paint);
                let _ = writeln!(self.body, "<path d=\"{}\" {paint}/>", lines.concat());
            }
            Item::Image {
                corners: Corners { low, high },
                image,
            } => {
                let [x, y] = [low.x, low.y].map(number);
                let [wide, high] = [high.x - low.x, high.y - low.y].map(number);
                let _ = writeln!(
                    self.body,
                    "<image x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" preserveAspectRatio=\"none\" \
                     xlink:href=\"data:image/png;base64,{}\"/>",
                    STANDARD.encode(image.png())
                );
            }
            Item::Circle {
                centre: Step { x, y },
                radius,
                paint,
            } => {
                let ([x, y, radius], paint) = ([*x, *y, *radius].map(number), Self::paint(*paint));
                let _ = writeln!(
                    self.body,
                    "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {paint}/>"
                );
            }
            Item::Words(words) => self.outlined(words),
        }
    }

    fn paint(paint: Paint) -> String {
        match paint {
            Paint::Fill(colour) => format!("fill=\"{}\"", colour.hex()),
            Paint::Edge(edge) => {
                let (colour, width) = (edge.colour.hex(), decimal(edge.width));
                let ends = if edge.dash == Dash::Solid {
                    "stroke-linecap=\"round\"".to_owned()
                } else {
                    let pattern: Vec<String> = edge.pattern().map(decimal).collect();
                    format!("stroke-dasharray=\"{}\"", pattern.join(" "))
                };
                format!(
                    "fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\" {ends}"
                )
            }
        }
    }

    /// A text by the outlines of its letters, each of which the file has once.
    fn outlined(&mut self, words: &Words) {
        if let Some(ground) = words.ground {
            let [left, top, right, bottom] = words.frame().sides();
            let [x, y, wide, high] = [left, top, right - left, bottom - top].map(decimal);
            let colour = ground.hex();
            let _ = writeln!(
                self.body,
                "<rect x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" fill=\"{colour}\"/>"
            );
        }
        let ([x, y], colour) = (words.at.map(decimal), words.colour.hex());
        let turn = if words.upwards { " rotate(-90)" } else { "" };
        let _ = writeln!(
            self.body,
            "<g aria-label=\"{}\" transform=\"translate({x} {y}){turn}\" fill=\"{colour}\">",
            escape(&plain(&words.text)),
        );
        let back = words.back();
        for glyph in glyphs(&words.text, words.size) {
            let width = decimal(glyph.bold / glyph.unit);
            let bold = format!(" stroke=\"{colour}\" stroke-width=\"{width}\"");
            self.glyph(&glyph, back, if glyph.bold > 0.0 { &bold } else { "" });
        }
        self.body += "</g>\n";
    }

    fn glyph(&mut self, glyph: &Glyph, back: f64, attributes: &str) {
        let id = &glyph.letter.name;
        if glyph.letter.path.is_empty() {
            return;
        }
        self.outlines.insert(id, glyph.letter.path);
        let [x, y] = [glyph.at[0] - back, glyph.at[1]].map(decimal);
        let unit = format!("{:.5}", glyph.unit);
        let unit = unit.trim_end_matches('0');
        let _ = writeln!(
            self.body,
            "<use xlink:href=\"#{id}\" transform=\"matrix({unit} 0 0 -{unit} {x} {y})\"{attributes}/>"
        );
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Data of a path: the first point, then the way from each to the next.
fn data(points: &[Step]) -> String {
    let mut out = String::new();
    let mut last: Option<Step> = None;
    for &to in points {
        if let Some(from) = last {
            if !out.ends_with('l') {
                out.push(' ');
            }
            let _ = write!(out, "{} {}", number(to.x - from.x), number(to.y - from.y));
        } else {
            let _ = write!(out, "M{} {}l", number(to.x), number(to.y));
        }
        last = Some(to);
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
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_exact_to_a_step() {
        let points = [(0, 0), (20, 1), (-20, 0)].map(|(x, y)| Step::new(x, y));
        assert_eq!(data(&points), "M0 0l1 0.05 -2 -0.05");
        assert_eq!(data(&[Step::new(5, 5)]), "M0.25 0.25l0 0");
    }
}
