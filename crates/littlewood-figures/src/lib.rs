//! The figures of the loaded hoop: as SVG, PDF and PNG, and as the data that they show.
//!
//! A [`Figure`] is a value: panels with series of data, how each is drawn, labels and a caption. It
//! is made by name from
//! [`FIGURES`], of a hoop and a start ([`FigureInput`]), by functions that take all numbers from the library `littlewood`;
//! nothing is drawn by hand or from stored data. [`Figure::svg`], [`Figure::pdf`] and
//! [`Figure::png`] draw it,
//! [`Figure::csv`] writes the rows that are drawn. No file is touched here.
//!
//! ```
//! use littlewood_figures::{find_figure, plain};
//!
//! let figure = find_figure("figure-3b").expect("a name of the catalogue").of_the_paper()?;
//! assert!(figure.svg().starts_with("<svg"));
//! assert!(figure.csv().starts_with("panel,series,piece,"));
//! assert!(plain(&figure.caption).contains("the hoop at the start and at each transition"));
//! # Ok::<(), littlewood_figures::FigureError>(())
//! ```
//!
//! Any other hoop:
//!
//! ```
//! use littlewood::{Hoop, HoopParameters, Limits, Start};
//! use littlewood_figures::{FigureInput, find_figure};
//!
//! let hoop = Hoop::new(HoopParameters::thin(2.0).with_offset(0.8).with_friction(0.7, 0.5))?;
//! let input = FigureInput::new(hoop, Start::at(1.0, 2.0), Limits::default());
//! let portrait = find_figure("figure-2b").expect("a name of the catalogue").figure(&input)?;
//! assert_eq!(portrait.panels.len(), 1);
//! # Ok::<(), littlewood_figures::FigureError>(())
//! ```
//!
//! Texts carry marks, `*θ*` for a symbol, `` `E` `` for a vector, `_{s}` below and `^{2}` above the
//! line: [`plain`] takes them off, [`markdown`] translates them. Letters are drawn as
//! outlines, so that a figure looks the same everywhere. With [`FigureInput::width_mm`] a figure is
//! laid out for print, with [`FigureInput::units`] it is in SI units.

mod axes;
mod catalogue;
mod chart;
mod columns;
mod effort;
mod error;
mod fate;
mod impacts;
mod input;
mod motion;
mod page;
mod paper;
mod plane;
mod poster;
mod si;
mod spikes;
mod timeline;
mod wording;

pub use catalogue::{
    FIGURES, FigureEntry, GALLERY_SCALE, Watch, find_figure, gallery_page, instead_of,
};
pub use chart::{CHART_MM, chart};
pub use error::FigureError;
pub use input::FigureInput;
pub use littlewood_draw::*;
pub use poster::{POSTER_MM, poster};
