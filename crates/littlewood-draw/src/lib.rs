//! How all pictures are drawn.
//!
//! A [`Figure`] is a value: panels with series of data, how each is drawn, labels and a caption.
//! [`Figure::svg`],
//! [`Figure::png`] and, with the feature `pdf`, `Figure::pdf` write the same drawing, [`Figure::csv`] the rows that are
//! drawn. Letters are outlines, in a PDF a font of them, so that a figure looks the same
//! everywhere. No file is touched here, and nothing is known of mechanics.
//!
//! Texts carry marks, `*θ*` for a symbol, `` `E` `` for a vector, `_{s}` below and `^{2}` above the
//! line: [`plain`] takes them off, [`markdown`] translates them.
//!
//! ```
//! use littlewood_draw::{Content, INK, Mark, PlotAxis, Range, Series, Sheet, Stroke};
//!
//! let line = Series::of_rows("line", &["x", "y"], vec![vec![0.0, 0.0], vec![1.0, 2.0]]);
//! let content = Content {
//!     name: "plane",
//!     x: PlotAxis::new("x", "*x*", Range { from: 0.0, to: 1.0 }),
//!     y: PlotAxis::new("y", "*y*", Range { from: 0.0, to: 2.0 }),
//!     layers: vec![line.drawn(Mark::Line(Stroke::solid(INK, 1.5)))],
//!     labels: Vec::new(),
//! };
//! let sheet = Sheet::new(Some(84.0), 620.0)?;
//! let figure = sheet.plot("line", "A line", String::new(), 430.0, content, Vec::new()).fitted();
//! assert!(figure.svg().starts_with("<svg"));
//! # Ok::<(), littlewood_draw::DrawError>(())
//! ```

mod chart;
mod clip;
mod csv;
mod error;
mod figure;
mod finish;
mod font;
mod hatch;
mod item;
mod letters;
mod marks;
mod markup;
mod output;
#[cfg(feature = "pdf")]
mod pdf;
mod pencil;
mod place;
mod primitives;
mod raster;
mod sheet;
mod space;
mod stroke;
mod svg;
mod words;

pub use error::DrawError;
pub use figure::{
    Figure, HoopShape, Key, Label, Layer, Mark, Panel, PanelFrame, Piece, PlotAxis, Scale, Series,
    View, tilted,
};
pub use font::font;
pub use letters::{missing, outlines, width, wrapped};
pub use littlewood_style::{Dash, Rgb, ticks::Tick};
pub use marks::{STABLE, START, TRANSITION, UNSTABLE, key_of_curve, lift_off_condition};
pub use markup::{Run, Script, markdown, plain, runs, unicode};
pub use output::Shape;
pub use primitives::{Anchor, Image, Point, Range, Segment};
pub use raster::{LEAST_SCALE, MOST_SCALE, check_scale, skia};
pub use sheet::{
    Content, Entries, LEAST_WIDTH_MM, MOST_WIDTH_MM, POINTS_TO_A_MM, PRINT_POINTS, Sheet,
    check_width, seen,
};
pub use stroke::*;
pub use words::{angle, marked, short};
