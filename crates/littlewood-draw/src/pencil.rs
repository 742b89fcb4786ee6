//! A sheet as paths: what PDF and pictures have in common.

use littlewood_style::Rgb;

use crate::item::{Frame, Item, Paint, STEPS, Step, Words};
use crate::letters::outlines;
use crate::primitives::{Image, Path, Point, Segment};
use crate::stroke::{PAPER, Stroke};

/// Something that draws paths.
pub(crate) trait Pencil {
    /// Fills a path.
    fn fill(&mut self, path: &Path, colour: Rgb);
    /// Draws along a path.
    fn stroke(&mut self, path: &Path, edge: Stroke);
    /// Draws pixels in a rectangle.
    fn image(&mut self, frame: Frame, image: &Image);
    /// Draws a text: the outlines of its letters, unless there is a better way.
    fn words(&mut self, words: &Words)
    where
        Self: Sized,
    {
        written(words, self);
    }
}

/// Draws all that is on a sheet.
pub(crate) fn draw(items: &[Item], width: f64, height: f64, pencil: &mut impl Pencil) {
    pencil.fill(&rectangle(Frame::sheet(width, height)), PAPER);
    for item in items {
        match item {
            Item::Path { lines, paint } => {
                let path: Vec<Segment> = lines
                    .iter()
                    .flat_map(|line| polygon(line, *paint))
                    .collect();
                painted(&path, *paint, pencil);
            }
            Item::Image { corners, image } => pencil.image(Frame::of(*corners), image),
            Item::Circle {
                centre,
                radius,
                paint,
            } => painted(&circle(*centre, *radius), *paint, pencil),
            Item::Words(words) => {
                if let Some(ground) = words.ground {
                    pencil.fill(&rectangle(words.frame()), ground);
                }
                pencil.words(words);
            }
        }
    }
}

fn painted(path: &Path, paint: Paint, pencil: &mut impl Pencil) {
    match paint {
        Paint::Fill(colour) => pencil.fill(path, colour),
        Paint::Edge(edge) => pencil.stroke(path, edge),
    }
}

fn polygon(points: &[Step], paint: Paint) -> Vec<Segment> {
    let begin = points.first().map(|point| Segment::Move(point.pixels()));
    let rest = points.iter().skip(1);
    let rest = rest.map(|point| Segment::Line(point.pixels()));
    let end = matches!(paint, Paint::Fill(_)).then_some(Segment::Close);
    begin.into_iter().chain(rest).chain(end).collect()
}

fn rectangle(frame: Frame) -> [Segment; 5] {
    let [left, top, right, bottom] = frame.sides();
    [
        Segment::Move(Point::new(left, top)),
        Segment::Line(Point::new(right, top)),
        Segment::Line(Point::new(right, bottom)),
        Segment::Line(Point::new(left, bottom)),
        Segment::Close,
    ]
}

/// A circle as four cubic curves.
fn circle(centre: Step, radius: i32) -> Vec<Segment> {
    // Puts the middle of each curve on the circle.
    const HANDLE: f64 = 0.552_284_749_830_793_4;
    let (Point { x, y }, radius) = (centre.pixels(), f64::from(radius) / STEPS);
    let at = |a: f64, b: f64| Point::new(x + radius * a, y + radius * b);
    let quarter = |[a, b]: [f64; 2]| {
        // The direction in which the circle goes on, a quarter of a turn further.
        let [c, d] = [-b, a];
        Segment::Curve(
            at(a + HANDLE * c, b + HANDLE * d),
            at(c + HANDLE * a, d + HANDLE * b),
            at(c, d),
        )
    };
    let quarters = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(quarter);
    [
        &[Segment::Move(at(1.0, 0.0))],
        &quarters[..],
        &[Segment::Close],
    ]
    .concat()
}

/// A text by the outlines of its letters.
fn written(words: &Words, pencil: &mut impl Pencil) {
    let (back, [x, y]) = (words.back(), words.at);
    let place = |at: Point| {
        let right = at.x - back;
        if words.upwards {
            Point::new(x + at.y, y - right)
        } else {
            Point::new(x + right, y + at.y)
        }
    };
    let letters: Vec<(Vec<Segment>, f64)> = outlines(&words.text, words.size)
        .map(|(path, bold)| {
            (
                path.into_iter()
                    .map(|segment| segment.placed(place))
                    .collect(),
                bold,
            )
        })
        .collect();
    let path: Vec<Segment> = letters.iter().flat_map(|(path, _)| path).copied().collect();
    pencil.fill(&path, words.colour);
    for (path, width) in letters.iter().filter(|(_, bold)| *bold > 0.0) {
        pencil.stroke(path, Stroke::solid(words.colour, *width));
    }
}
