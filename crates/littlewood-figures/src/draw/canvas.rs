//! A backend of the plotting library that keeps what is drawn: real dashes, hatches and symbols set in two faces, which
//! none of the library's own backends has.

use std::cell::{Cell, RefCell};
use std::convert::Infallible;
use std::rc::Rc;

use littlewood_style::{Dash, Rgb};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};

use super::item::{Item, Paint, Step, Words};
use super::letters::width;
use crate::figure::{Anchor, Image};

/// Steps of the backend's whole coordinates to a pixel.
pub(crate) const STEPS: f64 = 20.0;

/// Narrowest line in pixels.
const HAIR: f64 = 0.6;

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
}

/// Plain lines, filled areas, texts without a halo.
pub(crate) const PLAIN: Ink = Ink { dash: Dash::Solid, hatch: false, halo: false };

/// A sheet to draw on.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    size: (u32, u32),
    items: Rc<RefCell<Vec<Item>>>,
    ink: Rc<Cell<Ink>>,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self {
            size: (steps(width).unsigned_abs(), steps(height).unsigned_abs()),
            items: Rc::default(),
            ink: Rc::new(Cell::new(PLAIN)),
        }
    }

    /// Draws with this ink from now on.
    pub(crate) fn take(&self, ink: Ink) {
        self.ink.set(ink);
    }

    /// All that has been drawn, the lowest first.
    pub(crate) fn finish(&self) -> Vec<Item> {
        self.items.take()
    }

    /// An area with holes, which the library does not know.
    pub(crate) fn area(&self, outlines: &[Vec<Step>], paint: Paint) {
        let outlines = outlines.iter().map(|outline| distinct(outline.iter().copied())).collect();
        self.keep(Item::Area { outlines, paint });
    }

    /// Pixels, which the library would draw one by one.
    pub(crate) fn image(&self, corners: [Step; 2], image: Image) {
        self.keep(Item::Image { corners, image });
    }

    fn keep(&self, item: Item) {
        self.items.borrow_mut().push(item);
    }

    fn edge<S: BackendStyle>(&self, style: &S) -> Paint {
        // A tick of the library is one of its units wide, which here is a step.
        let width = f64::max(f64::from(style.stroke_width()) / STEPS, HAIR);
        Paint::Edge { colour: colour(style.color()), width, dash: self.ink.get().dash }
    }

    fn inside<S: BackendStyle>(&self, style: &S) -> Paint {
        let colour = colour(style.color());
        if self.ink.get().hatch { Paint::Hatch(colour) } else { Paint::Fill(colour) }
    }

    fn paint<S: BackendStyle>(&self, style: &S, fill: bool) -> Paint {
        if fill { self.inside(style) } else { self.edge(style) }
    }
}

/// All colours of figures cover what is below them.
const fn colour(BackendColor { rgb: (r, g, b), .. }: BackendColor) -> Rgb {
    Rgb([r, g, b])
}

/// The points, each of those that are equal and follow each other once.
fn distinct(points: impl IntoIterator<Item = BackendCoord>) -> Vec<BackendCoord> {
    let mut points: Vec<BackendCoord> = points.into_iter().collect();
    points.dedup();
    points
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
            self.keep(Item::Path { points: distinct(path), paint: self.edge(style) });
        }
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let paint = self.paint(style, fill);
        self.keep(Item::Rectangle { corners: [from, to], paint });
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        centre: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let radius = i32::try_from(radius).unwrap_or(i32::MAX);
        self.keep(Item::Circle { centre, radius, paint: self.paint(style, fill) });
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vertices: I,
        style: &S,
    ) -> Drawn {
        if style.color().alpha > 0.0 {
            self.keep(Item::Path { points: distinct(vertices), paint: self.inside(style) });
        }
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, (x, y): BackendCoord) -> Drawn {
        if text.is_empty() {
            return Ok(());
        }
        let size = style.size() / STEPS;
        let anchor = style.anchor();
        let down = size
            * match anchor.v_pos {
                VPos::Top => 0.76,
                VPos::Center => 0.33,
                VPos::Bottom => -0.24,
            };
        let anchor = match anchor.h_pos {
            HPos::Left => Anchor::Left,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::Right,
        };
        let upwards = matches!(style.transform(), FontTransform::Rotate270);
        let (x, y) = (f64::from(x) / STEPS, f64::from(y) / STEPS);
        let at = if upwards { [x + down, y] } else { [x, y + down] };
        self.keep(Item::Words(Words {
            text: text.to_owned(),
            at,
            anchor,
            size,
            colour: colour(style.color()),
            upwards,
            halo: self.ink.get().halo,
        }));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_no_point_twice_in_a_row() {
        assert_eq!(distinct([(0, 0), (20, 1), (20, 1), (0, 0)]), [(0, 0), (20, 1), (0, 0)]);
    }
}
