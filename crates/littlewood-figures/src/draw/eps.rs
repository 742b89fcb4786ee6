//! A sheet as Encapsulated PostScript, its letters as outlines.

use std::fmt::Write as _;

use littlewood_style::{Dash, Rgb};

use super::item::Item;
use super::markup::plain;
use super::pdf::shares;
use super::pencil::{Edge, Path, Pencil, Segment, draw};
use crate::figure::{Figure, Image};

/// Short names of the operators.
const OPERATORS: &str = "\
/m {moveto} bind def /l {lineto} bind def /c {curveto} bind def /h {closepath} bind def
/f {setrgbcolor fill} bind def /s {setrgbcolor stroke} bind def
/d {0 setdash setlinecap setlinewidth} bind def
";

/// Bytes of an image in a line.
const LINE: usize = 96;

struct Script(String);

impl Script {
    fn path(&mut self, path: &Path) {
        for segment in path {
            let (points, operator) = match *segment {
                Segment::Move(to) => (vec![to], "m"),
                Segment::Line(to) => (vec![to], "l"),
                Segment::Curve(a, b, to) => (vec![a, b, to], "c"),
                Segment::Close => (vec![], "h"),
            };
            for value in points.into_iter().flatten() {
                let _ = write!(self.0, "{} ", libm::round(1e3 * value) / 1e3);
            }
            self.0 += operator;
            self.0.push('\n');
        }
    }

    fn paint(&mut self, colour: Rgb, operator: &str) {
        let [r, g, b] = shares(colour);
        let _ = writeln!(self.0, "{r} {g} {b} {operator}");
    }
}

impl Pencil for Script {
    fn fill(&mut self, path: &Path, colour: Rgb) {
        self.path(path);
        self.paint(colour, "f");
    }

    fn stroke(&mut self, path: &Path, edge: Edge) {
        let cap = i32::from(edge.dash == Dash::Solid);
        let dashes: Vec<String> = edge.pattern().map(|part| format!("{part:.3}")).collect();
        let _ = writeln!(self.0, "{} {cap} [{}] d", edge.width, dashes.join(" "));
        self.path(path);
        self.paint(edge.colour, "s");
    }

    fn image(&mut self, [[left, top], [right, bottom]]: [[f64; 2]; 2], image: &Image) {
        let [width, height] = image.size;
        let _ = writeln!(
            self.0,
            "gsave {left} {top} translate {} {} scale\n{width} {height} 8 [{width} 0 0 {height} 0 0]\n\
             {{currentfile {} string readhexstring pop}} false 3 colorimage",
            right - left,
            bottom - top,
            3 * width
        );
        for row in image.pixels.chunks(LINE) {
            for byte in row {
                let _ = write!(self.0, "{byte:02x}");
            }
            self.0.push('\n');
        }
        self.0 += "grestore\n";
    }

    fn clip(&mut self, path: &Path) {
        self.0 += "gsave\n";
        self.path(path);
        self.0 += "clip newpath\n";
    }

    fn unclip(&mut self) {
        self.0 += "grestore\n";
    }
}

/// A document of one page.
pub(crate) fn document(figure: &Figure, items: &[Item]) -> String {
    let scale = figure.points();
    let [width, height] = [figure.width, figure.height].map(|side| side * scale);
    // Comments of a document are ASCII.
    let title: String = plain(&figure.title).chars().filter(char::is_ascii).collect();
    let mut script = Script(format!(
        "%!PS-Adobe-3.0 EPSF-3.0\n%%Creator: littlewood\n%%Title: {title}\n%%BoundingBox: 0 0 {} {}\n\
         %%HiResBoundingBox: 0 0 {width:.4} {height:.4}\n%%LanguageLevel: 2\n%%Pages: 1\n%%EndComments\n\
         gsave\n{OPERATORS}0 {height:.4} translate {scale} -{scale} scale 1 setlinejoin\n",
        libm::ceil(width),
        libm::ceil(height)
    ));
    draw(items, [figure.width, figure.height], &mut script);
    script.0 += "grestore\n%%EOF\n";
    script.0
}
