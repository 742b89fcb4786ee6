//! What is on a sheet: shapes and words, without the language of any file.

use littlewood_style::Rgb;

use crate::clip;
use crate::letters::width;
use crate::primitives::{Anchor, Image, Point};
use crate::stroke::Stroke;

/// Steps to a pixel.
pub(crate) const STEPS: f64 = 20.0;

/// A place in steps, to the right and downwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Step {
    pub(crate) const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The nearest one.
    pub(crate) fn of_pixels(place: Point) -> Self {
        Self::new(steps(place.x), steps(place.y))
    }

    pub(crate) fn pixels(self) -> Point {
        self.place().map(|side| side / STEPS).into()
    }

    pub(crate) fn place(self) -> [f64; 2] {
        [f64::from(self.x), f64::from(self.y)]
    }

    /// So far from here.
    pub(crate) const fn by(self, right: i32, down: i32) -> Self {
        Self::new(self.x + right, self.y + down)
    }
}

/// A rectangle by its left upper and its right lower corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corners {
    pub(crate) low: Step,
    pub(crate) high: Step,
}

impl Corners {
    /// Whether a place is in it; rounding to a step may take one on the frame outside.
    pub(crate) fn holds(self, Step { x, y }: Step) -> bool {
        let Self { low, high } = self;
        (low.x - 1..=high.x + 1).contains(&x) && (low.y - 1..=high.y + 1).contains(&y)
    }

    /// Its outline.
    pub(crate) fn outline(self) -> [Step; 5] {
        let Self { low, high } = self;
        let (right_upper, left_lower) = (Step::new(high.x, low.y), Step::new(low.x, high.y));
        [low, right_upper, high, left_lower, low]
    }
}

/// A length in steps.
pub(crate) fn steps(pixels: f64) -> i32 {
    libm::round(pixels * STEPS) as i32
}

/// A shape or a text.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// Lines from point to point; or the area that they bound together, around holes in the other
    /// direction.
    Path { lines: Vec<Vec<Step>>, paint: Paint },
    /// Pixels in a rectangle.
    Image { corners: Corners, image: Image },
    /// A circle.
    Circle {
        centre: Step,
        radius: i32,
        paint: Paint,
    },
    /// A text.
    Words(Words),
}

impl Item {
    /// Lines without points that are equal and follow each other.
    pub(crate) fn path(lines: &[Vec<Step>], paint: Paint) -> Self {
        let mut lines = lines.to_vec();
        lines.iter_mut().for_each(Vec::dedup);
        Self::Path { lines, paint }
    }

    /// The part of a line or an area within bounds; none if nothing is there.
    pub(crate) fn clipped(self, bounds: Corners) -> Option<Self> {
        let Self::Path { lines, paint } = self else {
            return Some(self);
        };
        if lines.iter().flatten().all(|place| bounds.holds(*place)) {
            return Some(Self::Path { lines, paint });
        }
        let places = |line: &Vec<Step>| line.iter().map(|it| it.place()).collect::<Vec<_>>();
        let bounds = [bounds.low, bounds.high].map(Step::place);
        let kept: Vec<Vec<[f64; 2]>> = match paint {
            Paint::Edge(_) => lines
                .iter()
                .flat_map(|points| clip::line(&places(points), bounds))
                .collect(),
            Paint::Fill(_) => lines
                .iter()
                .map(|line| clip::polygon(&places(line), bounds))
                .collect(),
        };
        let step = |[x, y]: [f64; 2]| Step::new(libm::round(x) as i32, libm::round(y) as i32);
        let kept = kept.into_iter().filter(|line| line.len() > 1);
        let lines: Vec<Vec<Step>> = kept
            .map(|line| line.into_iter().map(step).collect())
            .collect();
        (!lines.is_empty()).then(|| Self::path(&lines, paint))
    }
}

/// A rectangle in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Frame {
    /// Of a whole sheet.
    pub(crate) const fn sheet(width: f64, height: f64) -> Self {
        Self {
            left: 0.0,
            top: 0.0,
            right: width,
            bottom: height,
        }
    }

    /// Left, top, right and bottom.
    pub(crate) const fn sides(self) -> [f64; 4] {
        [self.left, self.top, self.right, self.bottom]
    }

    pub(crate) fn of(corners: Corners) -> Self {
        let (low, high) = (corners.low.pixels(), corners.high.pixels());
        Self {
            left: low.x,
            top: low.y,
            right: high.x,
            bottom: high.y,
        }
    }

    pub(crate) const fn holds(self, inner: Self) -> bool {
        inner.left >= self.left
            && inner.top >= self.top
            && inner.right <= self.right
            && inner.bottom <= self.bottom
    }

    /// So much larger on all sides.
    pub(crate) fn grown(self, by: f64) -> Self {
        Self {
            left: self.left - by,
            top: self.top - by,
            right: self.right + by,
            bottom: self.bottom + by,
        }
    }
}

/// How a shape is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Paint {
    /// Its inside.
    Fill(Rgb),
    /// Its edge.
    Edge(Stroke),
}

/// A text, with marks.
#[derive(Clone, Debug)]
pub(crate) struct Words {
    pub(crate) text: String,
    /// Where its base line begins, ends or has its middle, in pixels.
    pub(crate) at: [f64; 2],
    pub(crate) anchor: Anchor,
    pub(crate) size: f64,
    pub(crate) colour: Rgb,
    /// Whether it runs upwards.
    pub(crate) upwards: bool,
    /// Colour of a box behind its letters, which hides what is below them.
    pub(crate) ground: Option<Rgb>,
}

impl Words {
    /// How far the text is moved back from its place.
    pub(crate) fn back(&self) -> f64 {
        self.anchor.share() * width(&self.text, self.size)
    }

    /// The box of its letters.
    pub(crate) fn frame(&self) -> Frame {
        let (from, to) = (-self.back(), width(&self.text, self.size) - self.back());
        let (above, below) = (ASCENT * self.size, DESCENT * self.size);
        let [x, y] = self.at;
        let [left, top, right, bottom] = if self.upwards {
            [x - above, y - to, x + below, y - from]
        } else {
            [x + from, y - above, x + to, y + below]
        };
        Frame {
            left,
            top,
            right,
            bottom,
        }
    }
}

/// Height of letters above and below the base line in parts of their size.
pub(crate) const ASCENT: f64 = 0.7;
pub(crate) const DESCENT: f64 = 0.2;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_no_point_twice_in_a_row() {
        let [a, b] = [Step::new(0, 0), Step::new(20, 1)];
        let Item::Path { lines, .. } = Item::path(&[vec![a, b, b, a]], Paint::Fill(Rgb([0; 3])))
        else {
            panic!("a path")
        };
        assert_eq!(lines, [[a, b, a]]);
    }
}
