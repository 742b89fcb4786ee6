//! Shapes and words on pixels. Everything is opaque and of one colour, lines are straight or
//! circular: what is drawn needs no operation of the rasteriser that differs between processors.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8, Rect,
    Stroke, StrokeDash, Transform,
};

use crate::camera::Window;
use crate::colour::PAPER;
use crate::error::FilmError;
use crate::letters::Style;
use crate::size::{FrameSize, SizeError};
use littlewood_draw::Image;
use littlewood_style::Rgb;

/// A picture that is being drawn.
#[derive(Debug)]
pub(crate) struct Canvas {
    pixels: Pixmap,
}

/// A place in the picture, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    pub(crate) x: f64,
    pub(crate) y: f64,
}

impl Place {
    pub(crate) const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// So many pixels further to the right and down.
    pub(crate) fn shifted(self, right: f64, down: f64) -> Self {
        Self::new(self.x + right, self.y + down)
    }
}

impl Canvas {
    /// A white picture.
    pub(crate) fn new(size: FrameSize) -> Result<Self, FilmError> {
        let mut pixels =
            Pixmap::new(size.width(), size.height()).ok_or(FilmError::from(SizeError { size }))?;
        let Rgb([red, green, blue]) = PAPER;
        if let Some(white) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
            pixels.pixels_mut().fill(white);
        }
        Ok(Self { pixels })
    }

    /// Takes over another picture of the same size.
    pub(crate) fn copy(&mut self, other: &[u8]) {
        self.pixels.data_mut().copy_from_slice(other);
    }

    /// Takes over what another picture of the same size has in a window, as far as there is such.
    pub(crate) fn restore(&mut self, other: &[u8], window: Window) {
        let sides = [self.pixels.width(), self.pixels.height()];
        let columns = [window.left, window.left + window.width];
        let rows = [window.top, window.top + window.height];
        let within = |ends: [f64; 2], side: u32| {
            ends.map(|value| libm::round(value.clamp(0.0, f64::from(side))) as usize)
        };
        let ([left, right], [top, bottom]) = (within(columns, sides[0]), within(rows, sides[1]));
        let stride = 4 * sides[0] as usize;
        let data = self.pixels.data_mut();
        for row in top..bottom {
            let range = row * stride + 4 * left..row * stride + 4 * right;
            data[range.clone()].copy_from_slice(&other[range]);
        }
    }

    /// Draws an image with its left upper corner at a place, its columns up to one.
    pub(crate) fn image(&mut self, image: &Image, corner: Place, columns: usize) {
        let [left, top] = [corner.x, corner.y].map(|side| side as usize);
        let stride = self.pixels.width() as usize;
        let columns = columns.min(image.size[0]).min(stride.saturating_sub(left));
        let rows = self.pixels.pixels_mut().chunks_exact_mut(stride).skip(top);
        for (to, from) in rows.zip(image.pixels.chunks_exact(3 * image.size[0])) {
            for (to, from) in to[left..][..columns].iter_mut().zip(from.chunks_exact(3)) {
                if let Some(colour) =
                    PremultipliedColorU8::from_rgba(from[0], from[1], from[2], 255)
                {
                    *to = colour;
                }
            }
        }
    }

    /// Red, green, blue and 255 for each pixel, row by row.
    pub(crate) fn data(&self) -> &[u8] {
        self.pixels.data()
    }

    pub(crate) fn fill(&mut self, path: Option<Path>, colour: Rgb) {
        if let Some(path) = path {
            let transform = Transform::identity();
            self.pixels
                .fill_path(&path, &paint(colour), FillRule::Winding, transform, None);
        }
    }

    /// Draws a line in dashes and gaps of these lengths by turns; unbroken if there are none.
    fn stroke(&mut self, path: Option<Path>, colour: Rgb, width: f64, pattern: &[f64]) {
        let Some(path) = path else { return };
        let dash = StrokeDash::new(pattern.iter().map(|part| *part as f32).collect(), 0.0);
        let stroke = Stroke {
            // A thinner line would be drawn by another method, with less contrast.
            width: width.max(1.0) as f32,
            line_cap: LineCap::Butt,
            line_join: LineJoin::Round,
            dash,
            ..Stroke::default()
        };
        self.pixels
            .stroke_path(&path, &paint(colour), &stroke, Transform::identity(), None);
    }

    pub(crate) fn rectangle(&mut self, corner: Place, width: f64, height: f64, colour: Rgb) {
        let [x, y] = [corner.x, corner.y].map(|side| side as f32);
        let rectangle = Rect::from_xywh(x, y, width as f32, height as f32);
        self.fill(rectangle.map(PathBuilder::from_rect), colour);
    }

    /// A rectangle with half circles at its sides.
    pub(crate) fn pill(&mut self, corner: Place, width: f64, height: f64, colour: Rgb) {
        let radius = 0.5 * height;
        self.rectangle(corner.shifted(radius, 0.0), width - height, height, colour);
        let [left, right] = [corner.x + radius, corner.x + width - radius];
        for x in [left, right] {
            self.disc(Place::new(x, corner.y + radius), radius, colour);
        }
    }

    pub(crate) fn disc(&mut self, centre: Place, radius: f64, colour: Rgb) {
        self.fill(circle(centre, radius), colour);
    }

    /// A circle; its line lies half inside and half outside.
    pub(crate) fn ring(&mut self, centre: Place, radius: f64, width: f64, colour: Rgb) {
        self.stroke(circle(centre, radius), colour, width, &[]);
    }

    pub(crate) fn line(&mut self, points: &[Place], width: f64, colour: Rgb) {
        self.stroke(polyline(points, false), colour, width, &[]);
    }

    pub(crate) fn dashes(&mut self, points: &[Place], width: f64, dash: f64, colour: Rgb) {
        self.stroke(polyline(points, false), colour, width, &[dash, dash]);
    }

    pub(crate) fn polygon(&mut self, points: &[Place], colour: Rgb) {
        self.fill(polyline(points, true), colour);
    }

    pub(crate) fn words(&mut self, words: &str, place: Place, style: Style, colour: Rgb) {
        let outline = style.outline(words, place);
        if style.is_bold {
            self.stroke(outline.clone(), colour, style.bold(), &[]);
        }
        self.fill(outline, colour);
    }

    /// Words with a border that sets them off against what is behind them.
    pub(crate) fn label(&mut self, words: &str, place: Place, style: Style, colour: Rgb) {
        self.stroke(style.outline(words, place), PAPER, 0.3 * style.size, &[]);
        self.words(words, place, style, colour);
    }
}

fn paint(colour: Rgb) -> Paint<'static> {
    let mut paint = Paint::default();
    let Rgb([red, green, blue]) = colour;
    paint.set_color_rgba8(red, green, blue, 255);
    paint.anti_alias = true;
    paint
}

fn circle(centre: Place, radius: f64) -> Option<Path> {
    PathBuilder::from_circle(centre.x as f32, centre.y as f32, radius as f32)
}

fn polyline(points: &[Place], closed: bool) -> Option<Path> {
    let (first, rest) = points.split_first()?;
    let mut path = PathBuilder::new();
    path.move_to(first.x as f32, first.y as f32);
    for point in rest {
        path.line_to(point.x as f32, point.y as f32);
    }
    if closed {
        path.close();
    }
    path.finish()
}
