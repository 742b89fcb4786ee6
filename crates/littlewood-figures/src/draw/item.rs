//! What is on a sheet: shapes and words, without the language of any file.

use littlewood_style::{Dash, Rgb};

use super::letters::width;
use crate::figure::{Anchor, Image};

/// A place in steps.
pub(crate) type Step = (i32, i32);

/// A shape or a text.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// A line from point to point, or the polygon.
    Path { points: Vec<Step>, paint: Paint },
    /// An area by all curves that bound it, around holes in the other direction.
    Area { outlines: Vec<Vec<Step>>, paint: Paint },
    /// Pixels in a rectangle by its left upper and its right lower corner.
    Image { corners: [Step; 2], image: Image },
    /// A rectangle by its left upper and its right lower corner.
    Rectangle { corners: [Step; 2], paint: Paint },
    /// A circle.
    Circle { centre: Step, radius: i32, paint: Paint },
    /// A text.
    Words(Words),
}

/// How a shape is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Paint {
    /// Its inside.
    Fill(Rgb),
    /// Hatching on its inside.
    Hatch(Rgb),
    /// Its edge, of a width in pixels.
    Edge { colour: Rgb, width: f64, dash: Dash },
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
    /// Whether the paper is laid around its letters.
    pub(crate) halo: bool,
}

/// Width of the paper around letters on either side, in pixels.
pub(crate) const HALO: f64 = 1.75;

/// Distance and width of the lines of a hatch, which rise to the right, in pixels.
pub(crate) const HATCH: [f64; 2] = [6.0, 0.8];

impl Words {
    /// How far the text is moved back from its place.
    pub(crate) fn back(&self) -> f64 {
        match self.anchor {
            Anchor::Left => 0.0,
            Anchor::Middle => 0.5 * width(&self.text, self.size),
            Anchor::Right => width(&self.text, self.size),
        }
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
const ASCENT: f64 = 0.7;
const DESCENT: f64 = 0.2;
