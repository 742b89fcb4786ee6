//! The size of a picture, and its pixels as a PNG file.

use super::error::PictureError;

/// Size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureSize {
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

impl Default for PictureSize {
    fn default() -> Self {
        Self { width: 1500, height: 1000 }
    }
}

/// Smallest and largest side of a picture.
pub(super) const SIDES: [u32; 2] = [300, 10_000];

impl PictureSize {
    /// Size of letters.
    pub(super) fn letter(self) -> f64 {
        (f64::from(self.width) / 62.0).min(f64::from(self.height) / 40.0)
    }

    pub(super) const fn enlarged(self, factor: u32) -> Self {
        Self { width: factor * self.width, height: factor * self.height }
    }
}

/// Where the map lies in the drawing, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    pub(super) left: i32,
    pub(super) top: i32,
    pub(super) width: i32,
    pub(super) height: i32,
}

impl Frame {
    pub(super) const fn right(self) -> i32 {
        self.left + self.width
    }

    pub(super) const fn bottom(self) -> i32 {
        self.top + self.height
    }
}

/// How much larger than the picture the drawing is.
pub(super) const FINE: u32 = 2;

/// Means of squares of FINE × FINE pixels.
pub(super) fn reduce(pixels: &[u8], size: PictureSize) -> Vec<u8> {
    let (width, fine) = (size.width as usize, FINE as usize);
    let mut reduced = Vec::with_capacity(width * size.height as usize * 3);
    for y in 0..size.height as usize {
        for x in 0..width {
            for channel in 0..3 {
                let mut sum = 0;
                for (i, j) in (0..fine).flat_map(|i| (0..fine).map(move |j| (i, j))) {
                    sum += usize::from(pixels[((y * fine + i) * width * fine + x * fine + j) * 3 + channel]);
                }
                let mean = (sum + fine * fine / 2) / (fine * fine);
                reduced.push(u8::try_from(mean).unwrap_or(u8::MAX));
            }
        }
    }
    reduced
}

/// Pixels as a PNG file.
pub(super) fn encode(pixels: &[u8], size: PictureSize) -> Result<Vec<u8>, PictureError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().map_err(PictureError::drawing)?;
    writer.write_image_data(pixels).map_err(PictureError::drawing)?;
    writer.finish().map_err(PictureError::drawing)?;
    Ok(bytes)
}
