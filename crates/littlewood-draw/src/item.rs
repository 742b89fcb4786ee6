//! What is on a sheet: shapes and words, without the language of any file.

use littlewood_style::Rgb;

use crate::clip;
use crate::letters::width;
use crate::primitives::{Anchor, Image};
use crate::stroke::Stroke;

/// A place in steps.
pub(crate) type Step = (i32, i32);

/// Steps to a pixel.
pub(crate) const STEPS: f64 = 20.0;

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
    /// Pixels in a rectangle by its left upper and its right lower corner.
    Image { corners: [Step; 2], image: Image },
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
    pub(crate) fn clipped(self, bounds: [Step; 2]) -> Option<Self> {
        let Self::Path { lines, paint } = self else {
            return Some(self);
        };
        if lines.iter().flatten().all(|place| holds(bounds, *place)) {
            return Some(Self::Path { lines, paint });
        }
        let places = |line: &Vec<Step>| {
            line.iter()
                .map(|&(x, y)| [f64::from(x), f64::from(y)])
                .collect::<Vec<_>>()
        };
        let bounds = bounds.map(|(x, y)| [f64::from(x), f64::from(y)]);
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
        let step = |[x, y]: [f64; 2]| (libm::round(x) as i32, libm::round(y) as i32);
        let kept = kept.into_iter().filter(|line| line.len() > 1);
        let lines: Vec<Vec<Step>> = kept
            .map(|line| line.into_iter().map(step).collect())
            .collect();
        (!lines.is_empty()).then(|| Self::path(&lines, paint))
    }
}

/// Whether a place is within bounds; rounding to a step may take one on the frame outside.
pub(crate) fn holds([low, high]: [Step; 2], (x, y): Step) -> bool {
    (low.0 - 1..=high.0 + 1).contains(&x) && (low.1 - 1..=high.1 + 1).contains(&y)
}

/// The outline of a rectangle by its left upper and its right lower corner.
pub(crate) fn outline([(left, top), (right, bottom)]: [Step; 2]) -> Vec<Step> {
    vec![
        (left, top),
        (right, top),
        (right, bottom),
        (left, bottom),
        (left, top),
    ]
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

    /// The box of its letters: left, top, right and bottom in pixels.
    pub(crate) fn frame(&self) -> [f64; 4] {
        let (from, to) = (-self.back(), width(&self.text, self.size) - self.back());
        let (above, below) = (ASCENT * self.size, DESCENT * self.size);
        let [x, y] = self.at;
        if self.upwards {
            [x - above, y - to, x + below, y - from]
        } else {
            [x + from, y - above, x + to, y + below]
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
        let Item::Path { lines, .. } = Item::path(
            &[vec![(0, 0), (20, 1), (20, 1), (0, 0)]],
            Paint::Fill(Rgb([0; 3])),
        ) else {
            panic!("a path")
        };
        assert_eq!(lines, [[(0, 0), (20, 1), (0, 0)]]);
    }
}
