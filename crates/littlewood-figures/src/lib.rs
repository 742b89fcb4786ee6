//! Figures.

mod axes;
mod catalogue;
mod csv;
mod draw;
mod error;
mod figure;
mod paper;
mod motion;
mod plane;
mod style;
mod subject;
mod ticks;
mod trace;
mod words;

pub use catalogue::{Entry, FIGURES, find_figure};
pub use draw::{LEAST_SCALE, MOST_SCALE, markdown, plain};
pub use error::FigureError;
pub use figure::{Anchor, Axis, Figure, Key, Label, Layer, Mark, Panel, Series, Tick, View};
pub use style::{Colour, Dash, Stroke};
pub use subject::Subject;
