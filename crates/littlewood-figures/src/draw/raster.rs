//! A figure as PNG: the SVG itself, drawn by resvg with the faces of the figure and no others.

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use super::face::{FACES, FAMILY};
use crate::error::FigureError;
use crate::figure::Figure;

/// Least number of pixels of a picture to one of the drawing.
pub const LEAST_SCALE: f64 = 0.25;
/// Most.
pub const MOST_SCALE: f64 = 16.0;

fn faces() -> Arc<Database> {
    static DATABASE: OnceLock<Arc<Database>> = OnceLock::new();
    Arc::clone(DATABASE.get_or_init(|| {
        let mut database = Database::new();
        for face in FACES {
            database.load_font_data(face.to_vec());
        }
        Arc::new(database)
    }))
}

impl Figure {
    /// The figure as PNG, with `scale` pixels to a pixel of the SVG: 2 for a screen, 3.125 for 300 dpi in print.
    ///
    /// # Errors
    /// A scale out of bounds.
    pub fn png(&self, scale: f64) -> Result<Vec<u8>, FigureError> {
        if !(LEAST_SCALE..=MOST_SCALE).contains(&scale) {
            return Err(FigureError::Scale { scale, least: LEAST_SCALE, most: MOST_SCALE });
        }
        let failed = |message: &dyn core::fmt::Display| FigureError::Drawing(message.to_string());
        let options = Options { font_family: FAMILY.to_owned(), fontdb: faces(), ..Options::default() };
        let tree = Tree::from_str(&self.svg()?, &options).map_err(|error| failed(&error))?;
        let side = |length: f64| libm::ceil(length * scale) as u32;
        let mut pixels = Pixmap::new(side(self.width), side(self.height))
            .ok_or_else(|| failed(&"no room for the picture"))?;
        resvg::render(&tree, Transform::from_scale(scale as f32, scale as f32), &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| failed(&error))
    }
}
