//! A map as a PNG file.

use littlewood::tables::Class;
use littlewood_style::{Rgb, Theme, of_class, of_rank};
use plotters::backend::BitMapBackend;
use plotters::drawing::IntoDrawingArea as _;

use super::cells::Cell;
use super::error::PictureError;
use super::frame::{FINE, Frame, PictureSize, encode, reduce};
use super::layout::Layout;
use super::map::Picture;
use super::names::is_flipped;
use super::pen::Pen;
use super::scale::Scale;
use super::shade::Shade;

impl Picture {
    /// The picture as a PNG file.
    ///
    /// # Errors
    /// If the drawing library refuses; no input is known that makes it.
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        // Letters are set on whole pixels, which shows in their distances: so all is drawn larger, then reduced.
        let size = self.size.enlarged(FINE);
        let layout = Layout::new(self);
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        self.paint(&mut pixels, size, &layout);
        {
            let area = BitMapBackend::with_buffer(&mut pixels, (size.width, size.height)).into_drawing_area();
            Pen { area, layout: &layout }.draw(self)?;
        }
        encode(&reduce(&pixels, self.size), self.size)
    }

    /// Colours the pixels of the map.
    pub(super) fn paint(&self, pixels: &mut [u8], size: PictureSize, layout: &Layout) {
        let Frame { left, top, width, height } = layout.frame;
        let [left, top, width, height] = [left, top, width, height].map(|side| side as usize);
        let [nx, ny] = self.counts;
        let flipped = [0, 1].map(|k| is_flipped(&self.grid.axes()[k]));
        let scale = layout.scale.as_ref();
        let stride = size.width as usize * 3;
        // Pixels are counted from the first values of the axes.
        let mut set = |x: usize, y: usize, colour: Rgb| {
            let x = if flipped[0] { width - 1 - x } else { x };
            let y = if flipped[1] { y } else { height - 1 - y };
            let offset = (top + y) * stride + (left + x) * 3;
            pixels[offset..offset + 3].copy_from_slice(&colour.0);
        };
        let nearest = |pixel: usize, count: usize, size: usize| {
            if size < 2 { 0 } else { (2 * pixel * (count - 1) + size - 1) / (2 * (size - 1)) }
        };
        let columns: Vec<usize> = (0..width).map(|x| nearest(x, nx, width)).collect();
        for y in 0..height {
            let row = nearest(y, ny, height) * nx;
            for (x, column) in columns.iter().enumerate() {
                set(x, y, self.colour(self.cells[row + column], scale));
            }
        }
        for ([x0, y0, x1, y1], corners) in &self.refined.blocks {
            for y in *y0..=*y1 {
                for x in *x0..=*x1 {
                    let corner = 2 * usize::from(2 * y > y0 + y1) + usize::from(2 * x > x0 + x1);
                    set(x, y, self.colour(corners[corner], scale));
                }
            }
        }
        for (&(x, y), cell) in &self.refined.pixels {
            set(x, y, self.colour(*cell, scale));
        }
    }

    fn colour(&self, cell: Cell, scale: Option<&Scale>) -> Rgb {
        match (self.shade, cell.class()) {
            (_, Some(class @ (Class::NotComputed | Class::Invalid))) | (Shade::Class, Some(class)) => {
                of_class(class, Theme::Light)
            }
            (Shade::Class | Shade::Sequence, _) => of_rank(self.rank(cell.key), Theme::Light),
            (Shade::EnergyLost | Shade::Column(_), _) => match scale {
                Some(scale) => scale.colour(cell.number),
                None => littlewood_style::Ink::NoValue.colour(Theme::Light),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use littlewood::tables::{Quantity, Setup};
    use littlewood::{HoopParameters, Limits, Start};

    use super::*;
    use crate::axis::Axis;
    use crate::compute::Workers;
    use crate::grid::Grid;
    use crate::options::Options;
    use crate::sweep::sweep_grid;

    /// The share of pixels of the map that have another colour than the motion that begins there.
    fn wrong(picture: &Picture, workers: &Workers) -> f64 {
        let (layout, size) = (Layout::new(picture), picture.size.enlarged(FINE));
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        picture.paint(&mut pixels, size, &layout);
        let Frame { left, top, width, height } = layout.frame;
        // Steps that share no factor with the sides go everywhere.
        let places: Vec<(i32, i32)> = (0..4000).map(|i| (i * 761 % width, i * 577 % height)).collect();
        let axes = picture.grid.axes();
        let points = places.iter().map(|&(x, y)| {
            let mut point = *picture.grid.base();
            axes[0].varies().set(&mut point, axes[0].between(f64::from(x) / f64::from(width - 1)));
            axes[1].varies().set(&mut point, axes[1].between(f64::from(y) / f64::from(height - 1)));
            point
        });
        let columns = workers.compute(points, Limits::default()).expect("good points");
        let wrong = places.iter().zip(columns.classes()).filter(|&(&(x, y), class)| {
            let at = ((top + height - 1 - y) * size.width as i32 + left + x) as usize * 3;
            pixels[at..at + 3] != of_class(*class, Theme::Light).0
        });
        wrong.count() as f64 / places.len() as f64
    }

    #[test]
    fn boundaries_are_followed_to_the_pixel() {
        let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
        let theta = Axis::new(Quantity::Theta, -PI, PI, 31).expect("an axis");
        let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 41).expect("an axis");
        let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), vec![theta, rate]).expect("a grid");
        let (workers, options) = (Workers::new(None).expect("threads"), Options::default());
        let size = PictureSize { width: 600, height: 400 };
        let mut picture = Picture::new(&grid, Limits::default(), Shade::Class, size).expect("a picture");
        let mut add = |chunk: &crate::Chunk, columns: &crate::Columns| picture.add(chunk, columns);
        sweep_grid(&grid, Limits::default(), &[], Some(&mut add), &workers, &options).expect("a run");
        let before = wrong(&picture, &workers);
        assert!(picture.refine(Limits::default(), &workers, &options).expect("refined"));
        let after = wrong(&picture, &workers);
        // A corner of a region that reaches less than a cell far is not seen.
        assert!(before > 0.02 && after < 0.002, "{before} {after}");
    }
}
