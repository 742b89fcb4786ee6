//! The look of all pictures of `littlewood`: figures, maps, films, the page and the pictures of the
//! Python package.
//!
//! A colour means one thing. Modes, classes of outcomes, forces and curves each have their own;
//! what has none (kinetic and potential energy) takes an [`Accent`]. Colours are told apart by the
//! colour-blind, and in grey: modes and classes that meet in one picture differ in lightness, and
//! lines in their dashes too. Each colour has a variant for a light and for a dark paper.

mod accent;
mod arrow;
mod class;
mod curve;
mod dash;
mod energy;
mod impulse;
mod ink;
mod mode;
mod named;
mod rank;
mod rgb;
mod scale;
mod swatch;
mod theme;
pub mod ticks;
pub mod width;

pub use accent::Accent;
pub use arrow::Arrow;
pub use class::{RestingPlace, of_class};
pub use curve::Curve;
pub use dash::Dash;
pub use energy::EnergyPart;
pub use impulse::ImpulseLine;
pub use ink::Ink;
pub use mode::{dash_of, of_mode};
pub use rank::{RANKS, of_rank};
pub use rgb::Rgb;
pub use scale::of_fraction;
pub use swatch::{Swatch, swatches};
pub use theme::Theme;
