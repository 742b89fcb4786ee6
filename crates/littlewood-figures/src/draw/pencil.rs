//! A sheet as paths: what PDF, EPS and pictures have in common.

use littlewood_style::{Dash, Rgb};

use super::canvas::STEPS;
use super::item::{HALO, HATCH, Item, Paint, Step, Words};
use super::letters::{Stroke, glyphs, outline};
use crate::figure::Image;
use crate::style::PAPER;

/// A piece of a path, in pixels, downwards positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Segment {
    Move([f64; 2]),
    Line([f64; 2]),
    Curve([f64; 2], [f64; 2], [f64; 2]),
    Close,
}

/// A path.
pub(crate) type Path = [Segment];

/// Something that draws paths.
pub(crate) trait Pencil {
    /// Fills a path.
    fn fill(&mut self, path: &Path, colour: Rgb);
    /// Draws along a path.
    fn stroke(&mut self, path: &Path, edge: Edge);
    /// Draws pixels in a rectangle by its left upper and its right lower corner.
    fn image(&mut self, corners: [[f64; 2]; 2], image: &Image);
    /// Draws inside a path only, until [`Pencil::unclip`].
    fn clip(&mut self, path: &Path);
    /// Draws everywhere again.
    fn unclip(&mut self);
}

/// A line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    pub(crate) colour: Rgb,
    pub(crate) width: f64,
    pub(crate) dash: Dash,
}

impl Edge {
    /// Lengths of dashes and gaps in pixels; empty for a solid line.
    pub(crate) fn pattern(&self) -> impl Iterator<Item = f64> {
        self.dash.pattern().iter().map(|part| part * self.width)
    }
}

/// Draws all that is on a sheet.
pub(crate) fn draw(items: &[Item], [width, height]: [f64; 2], pencil: &mut impl Pencil) {
    pencil.fill(&rectangle([0.0, 0.0], [width, height]), PAPER);
    for item in items {
        match item {
            Item::Path { points, paint } => painted(&polygon(points, *paint), *paint, pencil),
            Item::Area { outlines, paint } => {
                let path: Vec<Segment> =
                    outlines.iter().flat_map(|outline| polygon(outline, *paint)).collect();
                painted(&path, *paint, pencil);
            }
            Item::Image { corners, image } => pencil.image(corners.map(pixels), image),
            Item::Rectangle { corners, paint } => {
                let [from, to] = corners.map(pixels);
                painted(&rectangle(from, to), *paint, pencil);
            }
            Item::Circle { centre, radius, paint } => {
                painted(&circle(pixels(*centre), f64::from(*radius) / STEPS), *paint, pencil);
            }
            Item::Words(words) => written(words, pencil),
        }
    }
}

fn painted(path: &Path, paint: Paint, pencil: &mut impl Pencil) {
    match paint {
        Paint::Fill(colour) => pencil.fill(path, colour),
        Paint::Edge { colour, width, dash } => pencil.stroke(path, Edge { colour, width, dash }),
        Paint::Hatch(colour) => {
            pencil.clip(path);
            pencil.stroke(&hatch(path), Edge { colour, width: HATCH[1], dash: Dash::Solid });
            pencil.unclip();
        }
    }
}

fn pixels((x, y): Step) -> [f64; 2] {
    [f64::from(x) / STEPS, f64::from(y) / STEPS]
}

fn polygon(points: &[Step], paint: Paint) -> Vec<Segment> {
    let mut path: Vec<Segment> = points
        .iter()
        .enumerate()
        .map(|(i, point)| if i == 0 { Segment::Move(pixels(*point)) } else { Segment::Line(pixels(*point)) })
        .collect();
    if !matches!(paint, Paint::Edge { .. }) {
        path.push(Segment::Close);
    }
    path
}

fn rectangle([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> Vec<Segment> {
    vec![
        Segment::Move([left, top]),
        Segment::Line([right, top]),
        Segment::Line([right, bottom]),
        Segment::Line([left, bottom]),
        Segment::Close,
    ]
}

/// A circle as four cubic curves.
fn circle([x, y]: [f64; 2], radius: f64) -> Vec<Segment> {
    // Puts the middle of each curve on the circle.
    const HANDLE: f64 = 0.552_284_749_830_793_4;
    let at = |a: f64, b: f64| [x + radius * a, y + radius * b];
    let mut path = vec![Segment::Move(at(1.0, 0.0))];
    for [a, b] in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
        // The direction in which the circle goes on, a quarter of a turn further.
        let [c, d] = [-b, a];
        path.push(Segment::Curve(
            at(a + HANDLE * c, b + HANDLE * d),
            at(c + HANDLE * a, d + HANDLE * b),
            at(c, d),
        ));
    }
    path.push(Segment::Close);
    path
}

/// The lines of a hatch over the box of a polygon: those of the pattern of an SVG.
fn hatch(path: &Path) -> Vec<Segment> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for stroke in path {
        if let Segment::Move(point) | Segment::Line(point) = stroke {
            for i in 0..2 {
                low[i] = low[i].min(point[i]);
                high[i] = high[i].max(point[i]);
            }
        }
    }
    let apart = HATCH[0] * core::f64::consts::SQRT_2;
    let [first, last] = [low, high].map(|corner| (corner[0] + corner[1]) / apart - 0.5);
    let (first, last) = (libm::ceil(first), libm::floor(last));
    let count = if last >= first { (last - first) as u32 + 1 } else { 0 };
    (0..count)
        .flat_map(|i| {
            let sum = (first + f64::from(i) + 0.5) * apart;
            let right = high[0].min(sum - low[1]);
            let left = low[0].max(sum - high[1]);
            [Segment::Move([left, sum - left]), Segment::Line([right, sum - right])]
        })
        .collect()
}

/// A text by the outlines of its letters.
fn written(words: &Words, pencil: &mut impl Pencil) {
    let back = words.back();
    let (mut path, mut bold) = (Vec::new(), Vec::new());
    for glyph in glyphs(&words.text, words.size) {
        let begin = path.len();
        let place = |[x, y]: [f64; 2]| {
            let [right, down] = [glyph.at[0] - back + glyph.unit * x, glyph.at[1] - glyph.unit * y];
            let [x, y] = words.at;
            if words.upwards { [x + down, y - right] } else { [x + right, y + down] }
        };
        let mut here = [0.0; 2];
        for stroke in outline(glyph.face, glyph.id) {
            let (segment, end) = match stroke {
                Stroke::Move(to) => (Segment::Move(place(to)), to),
                Stroke::Line(to) => (Segment::Line(place(to)), to),
                Stroke::Quad(a, to) => {
                    let [first, second] = [here, to].map(|end| place(towards(end, a)));
                    (Segment::Curve(first, second, place(to)), to)
                }
                Stroke::Cubic(a, b, to) => (Segment::Curve(place(a), place(b), place(to)), to),
                Stroke::Close => (Segment::Close, here),
            };
            path.push(segment);
            here = end;
        }
        if glyph.bold > 0.0 {
            bold.push((path[begin..].to_vec(), glyph.bold));
        }
    }
    if words.halo {
        pencil.stroke(&path, Edge { colour: PAPER, width: 2.0 * HALO, dash: Dash::Solid });
    }
    pencil.fill(&path, words.colour);
    for (path, width) in bold {
        pencil.stroke(&path, Edge { colour: words.colour, width, dash: Dash::Solid });
    }
}

/// Two thirds of the way: where a cubic curve has its handle for that of a quadratic one.
fn towards(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| from[i] + 2.0 / 3.0 * (to[i] - from[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hatch_covers_the_box_and_stays_in_it() {
        let lines = hatch(&rectangle([0.0, 0.0], [30.0, 20.0]));
        // The sums of the coordinates go from 0 to 50, and the lines are 6√2 apart.
        assert_eq!(lines.len(), 2 * 6);
        for segment in lines {
            let (Segment::Move([x, y]) | Segment::Line([x, y])) = segment else { panic!("{segment:?}") };
            assert!((-1e-9..=30.0 + 1e-9).contains(&x) && (-1e-9..=20.0 + 1e-9).contains(&y));
        }
    }

    #[test]
    fn a_quadratic_curve_has_its_handles_at_two_thirds() {
        assert_eq!(towards([0.0, 0.0], [3.0, 6.0]), [2.0, 4.0]);
        assert_eq!(towards([6.0, 0.0], [3.0, 6.0]), [4.0, 4.0]);
    }
}
