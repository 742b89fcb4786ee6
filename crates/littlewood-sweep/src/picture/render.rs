//! A map as a PNG file.

use littlewood::Class;
use littlewood_style::{Ink, Theme, of_class};
use plotters::backend::BitMapBackend;
use plotters::drawing::IntoDrawingArea as _;

use super::cells::Cells;
use super::error::PictureError;
use super::frame::{FINE, Frame, PictureSize, encode, reduce};
use super::map::Picture;
use super::pen::Pen;
use super::scale::Scale;

impl Picture {
    /// The picture as a PNG file.
    ///
    /// # Errors
    /// If the drawing library refuses; no input is known that makes it.
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        // Letters are set on whole pixels, which shows in their distances: so all is drawn larger, then reduced.
        let size = PictureSize { width: FINE * self.size.width, height: FINE * self.size.height };
        let frame = self.frame.enlarged(FINE);
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        let scale = Scale::of(&self.cells);
        self.paint(&mut pixels, size, frame, scale.as_ref());
        {
            let area = BitMapBackend::with_buffer(&mut pixels, (size.width, size.height)).into_drawing_area();
            Pen { area, frame }.draw(self, scale.as_ref())?;
        }
        encode(&reduce(&pixels, self.size), self.size)
    }

    /// Colours the pixels of the map.
    fn paint(&self, pixels: &mut [u8], size: PictureSize, frame: Frame, scale: Option<&Scale>) {
        let Frame { left, top, width, height, .. } = frame;
        let [nx, ny] = self.counts;
        let flipped = [0, 1].map(|k| {
            let axis = &self.grid.axes()[k];
            axis.from() > axis.to()
        });
        let stride = size.width as usize * 3;
        let (left, top, width, height) = (left as usize, top as usize, width as usize, height as usize);
        for py in 0..height {
            let y = (height - 1 - py) * ny / height;
            let y = if flipped[1] { ny - 1 - y } else { y };
            for px in 0..width {
                let x = px * nx / width;
                let x = if flipped[0] { nx - 1 - x } else { x };
                let place = y * nx + x;
                let colour = match &self.cells {
                    Cells::Class(cells) => of_class(cells[place], Theme::Light),
                    Cells::Real(cells) => match (cells[place], scale) {
                        (None, _) => of_class(Class::NotComputed, Theme::Light),
                        (Some(value), Some(scale)) => scale.colour(value),
                        (Some(_), None) => Ink::NoValue.colour(Theme::Light),
                    },
                };
                let offset = (top + py) * stride + (left + px) * 3;
                pixels[offset..offset + 3].copy_from_slice(&colour.0);
            }
        }
    }
}
