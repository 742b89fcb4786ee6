//! A sheet as PNG.

use littlewood_style::{Dash, Rgb};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, PixmapPaint, Shader, Stroke,
    StrokeDash, Transform,
};

use crate::error::DrawError;
use crate::item::{Frame, Item};
use crate::pencil::{Pencil, draw};
use crate::primitives::{Image, Path, Point, Segment};
use crate::stroke::{self, PAPER};

/// Least number of pixels of a picture to one of the drawing.
pub const LEAST_SCALE: f64 = 0.25;
/// Most.
pub const MOST_SCALE: f64 = 16.0;

/// Refuses a number of pixels to one of the drawing beyond [`LEAST_SCALE`] and [`MOST_SCALE`].
///
/// # Errors
/// [`DrawError::Scale`].
pub fn check_scale(scale: f64) -> Result<(), DrawError> {
    if (LEAST_SCALE..=MOST_SCALE).contains(&scale) {
        Ok(())
    } else {
        Err(DrawError::Scale {
            scale,
            least: LEAST_SCALE,
            most: MOST_SCALE,
        })
    }
}

struct Picture {
    pixels: Pixmap,
    transform: Transform,
}

/// A path for tiny-skia; none if nothing is to be seen.
pub fn skia(path: &[Segment]) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for segment in path {
        match *segment {
            Segment::Move(to) => {
                let [x, y] = single(to);
                builder.move_to(x, y);
            }
            Segment::Line(to) => {
                let [x, y] = single(to);
                builder.line_to(x, y);
            }
            Segment::Quad(a, to) => {
                let [[a, b], [x, y]] = [a, to].map(single);
                builder.quad_to(a, b, x, y);
            }
            Segment::Curve(a, b, to) => {
                let [[a, b], [c, d], [x, y]] = [a, b, to].map(single);
                builder.cubic_to(a, b, c, d, x, y);
            }
            Segment::Close => builder.close(),
        }
    }
    builder.finish()
}

fn single(point: Point) -> [f32; 2] {
    point.row().map(|value| value as f32)
}

fn paint(Rgb([r, g, b]): Rgb) -> Paint<'static> {
    Paint {
        shader: Shader::SolidColor(Color::from_rgba8(r, g, b, 255)),
        anti_alias: true,
        ..Paint::default()
    }
}

impl Pencil for Picture {
    fn fill(&mut self, path: &Path, colour: Rgb) {
        if let Some(path) = skia(path) {
            let paint = paint(colour);
            self.pixels
                .fill_path(&path, &paint, FillRule::Winding, self.transform, None);
        }
    }

    fn stroke(&mut self, path: &Path, edge: stroke::Stroke) {
        let line_cap = if edge.dash == Dash::Solid {
            LineCap::Round
        } else {
            LineCap::Butt
        };
        let dash = StrokeDash::new(edge.pattern().map(|part| part as f32).collect(), 0.0);
        let stroke = Stroke {
            width: edge.width as f32,
            line_cap,
            line_join: LineJoin::Round,
            dash,
            ..Stroke::default()
        };
        if let Some(path) = skia(path) {
            self.pixels
                .stroke_path(&path, &paint(edge.colour), &stroke, self.transform, None);
        }
    }

    fn image(&mut self, frame: Frame, image: &Image) {
        let [width, height] = image.size.map(|side| side as u32);
        let Some(mut own) = Pixmap::new(width, height) else {
            return;
        };
        let bytes = image
            .pixels
            .chunks_exact(3)
            .flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]);
        for (to, byte) in own.data_mut().iter_mut().zip(bytes) {
            *to = byte;
        }
        let x = ((frame.right - frame.left) / f64::from(width)) as f32;
        let y = ((frame.bottom - frame.top) / f64::from(height)) as f32;
        let (left, top) = (frame.left as f32, frame.top as f32);
        let transform = self.transform.pre_translate(left, top).pre_scale(x, y);
        self.pixels
            .draw_pixmap(0, 0, own.as_ref(), &PixmapPaint::default(), transform, None);
    }
}

/// Items in so many pixels to the right and downwards, so many to one of the drawing.
pub(crate) fn pixels(
    items: &[Item],
    width: u32,
    height: u32,
    scale: f64,
) -> Result<Image, DrawError> {
    let mut pixels = Pixmap::new(width, height).ok_or(DrawError::NoRoom { width, height })?;
    let Rgb([r, g, b]) = PAPER;
    pixels.fill(Color::from_rgba8(r, g, b, 255));
    let transform = Transform::from_scale(scale as f32, scale as f32);
    let mut picture = Picture { pixels, transform };
    // To the last pixel, which is not always covered whole.
    let [wide, high] = [width, height].map(|side| f64::from(side) / scale);
    draw(items, wide, high, &mut picture);
    // Paper covers all, so that there is nothing to see through.
    let colours = picture
        .pixels
        .pixels()
        .iter()
        .flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]);
    Ok(Image {
        size: [width, height].map(|side| side as usize),
        pixels: colours.collect(),
    })
}

impl Image {
    /// As a PNG file.
    pub fn png(&self) -> Vec<u8> {
        // Nothing that a file in memory could fail of: an image without pixels is an empty file.
        self.file(None).unwrap_or_default()
    }

    /// The same, with its pixels to a metre if its width in print is known.
    pub(crate) fn file(&self, to_a_metre: Option<u32>) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let [width, height] = self
            .size
            .map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let dimensions = |count| png::PixelDimensions {
            xppu: count,
            yppu: count,
            unit: png::Unit::Meter,
        };
        encoder.set_pixel_dims(to_a_metre.map(dimensions));
        encoder.set_compression(png::Compression::Balanced);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(bytes)
    }
}
