//! A backend of the plotting library that writes SVG: real dashes, hatches, symbols set in two faces, and the faces
//! themselves, none of which the library's own SVG backend has.

use std::cell::{Cell, RefCell};
use std::convert::Infallible;
use std::fmt::Write as _;
use std::rc::Rc;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};

use super::face::{FAMILY, SCRIPT_SIZE, rules, width};
use super::markup::{Script, plain, runs};
use crate::figure::Figure;
use crate::style::PAPER;
use littlewood_style::Dash;

/// Steps of the backend's whole coordinates to a pixel.
pub(crate) const STEPS: f64 = 20.0;

/// A length in steps.
pub(crate) fn steps(pixels: f64) -> i32 {
    libm::round(pixels * STEPS) as i32
}

/// What the library's styles cannot say of a line or a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ink {
    pub(crate) dash: Dash,
    pub(crate) hatch: bool,
    pub(crate) halo: bool,
    /// Edges on whole pixels, so that areas side by side leave no seam.
    pub(crate) crisp: bool,
}

/// Plain lines, filled areas, texts without a halo.
pub(crate) const PLAIN: Ink = Ink { dash: Dash::Solid, hatch: false, halo: false, crisp: false };

/// A sheet to draw on.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    size: (u32, u32),
    sheet: Rc<RefCell<Sheet>>,
    ink: Rc<Cell<Ink>>,
}

#[derive(Debug, Default)]
struct Sheet {
    body: String,
    hatches: Vec<(u8, u8, u8)>,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self {
            size: (steps(width).unsigned_abs(), steps(height).unsigned_abs()),
            sheet: Rc::default(),
            ink: Rc::new(Cell::new(PLAIN)),
        }
    }

    /// Draws with this ink from now on.
    pub(crate) fn take(&self, ink: Ink) {
        self.ink.set(ink);
    }

    /// The finished picture.
    pub(crate) fn finish(&self, figure: &Figure) -> String {
        let sheet = self.sheet.borrow();
        let (w, h) = (number(self.size.0 as i32), number(self.size.1 as i32));
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"{FAMILY}\">\n<title>{}</title>\n<desc>{}</desc>\n<defs>\n<style>\n{}</style>\n",
            escape(&plain(&figure.title)),
            escape(&plain(&figure.caption)),
            rules()
        );
        for (i, (r, g, b)) in sheet.hatches.iter().enumerate() {
            let _ = writeln!(
                out,
                "<pattern id=\"hatch{i}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" \
                 patternTransform=\"rotate(45)\"><path d=\"M0 0V6\" stroke=\"#{r:02x}{g:02x}{b:02x}\" \
                 stroke-width=\"1.3\"/></pattern>"
            );
        }
        let _ = write!(
            out,
            "</defs>\n<rect width=\"{w}\" height=\"{h}\" fill=\"{}\"/>\n{}</svg>\n",
            PAPER.hex(),
            sheet.body
        );
        out
    }

    fn write(&self, element: &str) {
        let mut sheet = self.sheet.borrow_mut();
        sheet.body += element;
        sheet.body.push('\n');
    }

    fn stroke<S: BackendStyle>(&self, style: &S) -> String {
        let width = f64::from(style.stroke_width()) / STEPS;
        let mut out = format!(
            "fill=\"none\" {} stroke-width=\"{}\" stroke-linejoin=\"round\"",
            paint("stroke", style.color()),
            decimal(width)
        );
        let dash = self.ink.get().dash;
        if dash == Dash::Solid {
            out += " stroke-linecap=\"round\"";
        } else {
            let pattern: Vec<String> = dash.pattern().iter().map(|part| decimal(part * width)).collect();
            let _ = write!(out, " stroke-dasharray=\"{}\"", pattern.join(" "));
        }
        out
    }

    fn fill<S: BackendStyle>(&self, style: &S) -> String {
        if !self.ink.get().hatch {
            return paint("fill", style.color());
        }
        let mut sheet = self.sheet.borrow_mut();
        let rgb = style.color().rgb;
        let known = sheet.hatches.iter().position(|hatch| *hatch == rgb);
        let i = known.unwrap_or_else(|| {
            sheet.hatches.push(rgb);
            sheet.hatches.len() - 1
        });
        format!("fill=\"url(#hatch{i})\"")
    }
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Canvas {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        if style.color().alpha > 0.0 {
            let data = outline(path);
            self.write(&format!("<path d=\"{data}\" {}/>", self.stroke(style)));
        }
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let mut paint = if fill { self.fill(style) } else { self.stroke(style) };
        if self.ink.get().crisp {
            paint += " shape-rendering=\"crispEdges\"";
        }
        self.write(&format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {paint}/>",
            number(left),
            number(top),
            number(right - left),
            number(bottom - top)
        ));
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let paint = if fill { self.fill(style) } else { self.stroke(style) };
        let radius = number(i32::try_from(radius).unwrap_or(i32::MAX));
        self.write(&format!("<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\" {paint}/>", number(x), number(y)));
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vertices: I,
        style: &S,
    ) -> Drawn {
        if style.color().alpha > 0.0 {
            let data = outline(vertices);
            self.write(&format!("<path d=\"{data}z\" {}/>", self.fill(style)));
        }
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, (x, y): BackendCoord) -> Drawn {
        let size = style.size() / STEPS;
        let anchor = style.anchor();
        let (x, y) = (f64::from(x) / STEPS, f64::from(y) / STEPS);
        let baseline = match anchor.v_pos {
            VPos::Top => 0.76,
            VPos::Center => 0.33,
            VPos::Bottom => -0.24,
        };
        let mut attributes = format!(
            "x=\"{}\" y=\"{}\" font-size=\"{}\" {}",
            decimal(x),
            decimal(y + baseline * size),
            decimal(size),
            paint("fill", style.color())
        );
        match anchor.h_pos {
            HPos::Left => {}
            HPos::Center => attributes += " text-anchor=\"middle\"",
            HPos::Right => attributes += " text-anchor=\"end\"",
        }
        let turn = match style.transform() {
            FontTransform::None => 0,
            FontTransform::Rotate90 => 90,
            FontTransform::Rotate180 => 180,
            FontTransform::Rotate270 => -90,
        };
        if turn != 0 {
            let _ = write!(attributes, " transform=\"rotate({turn} {} {})\"", decimal(x), decimal(y));
        }
        if self.ink.get().halo {
            let _ = write!(
                attributes,
                " stroke=\"{}\" stroke-width=\"3.5\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                PAPER.hex()
            );
        }
        self.write(&format!("<text {attributes}>{}</text>", spans(text, size)));
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = style.size();
        Ok((libm::ceil(width(text, size)) as u32, libm::ceil(size) as u32))
    }
}

/// A text with its symbols.
fn spans(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut below = 0.0;
    for run in runs(text) {
        let (wanted, scale) = match run.script {
            Script::Line => (0.0, 1.0),
            Script::Sub => (0.22 * size, SCRIPT_SIZE),
            Script::Super => (-0.36 * size, SCRIPT_SIZE),
        };
        let mut attributes = String::new();
        if wanted != below {
            let _ = write!(attributes, " dy=\"{}\"", decimal(wanted - below));
            below = wanted;
        }
        if scale != 1.0 {
            let _ = write!(attributes, " font-size=\"{}\"", decimal(scale * size));
        }
        if run.italic {
            attributes += " font-style=\"italic\"";
        }
        if attributes.is_empty() {
            out += &escape(run.text);
        } else {
            let _ = write!(out, "<tspan{attributes}>{}</tspan>", escape(run.text));
        }
    }
    out
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn paint(attribute: &str, BackendColor { alpha, rgb: (r, g, b) }: BackendColor) -> String {
    let mut out = format!("{attribute}=\"#{r:02x}{g:02x}{b:02x}\"");
    if alpha < 1.0 {
        let _ = write!(out, " {attribute}-opacity=\"{}\"", decimal(alpha));
    }
    out
}

/// Data of a path: the first point, then the way from each to the next.
fn outline(points: impl IntoIterator<Item = BackendCoord>) -> String {
    let mut out = String::new();
    let mut last: Option<BackendCoord> = None;
    for (x, y) in points {
        match last {
            None => {
                let _ = write!(out, "M{} {}l", number(x), number(y));
            }
            Some(there) if there == (x, y) => continue,
            Some((a, b)) => {
                if !out.ends_with('l') {
                    out.push(' ');
                }
                let _ = write!(out, "{} {}", number(x - a), number(y - b));
            }
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
        assert_eq!(outline([(0, 0), (20, 1), (20, 1), (-20, 0)]), "M0 0l1 0.05 -2 -0.05");
        assert_eq!(outline([(5, 5)]), "M0.25 0.25l0 0");
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
