//! What can go wrong with a drawing.

/// A drawing that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum DrawError {
    /// A scale out of bounds.
    #[error(
        "scale is {scale}, but must be from {least} to {most} pixels of the picture to one of the drawing"
    )]
    Scale {
        /// The scale.
        scale: f64,
        /// Least.
        least: f64,
        /// Most.
        most: f64,
    },
    /// A width out of bounds.
    #[error("width in print is {mm} mm, but must be from {least} to {most} mm")]
    Width {
        /// The width in millimetres.
        mm: f64,
        /// Least.
        least: f64,
        /// Most.
        most: f64,
    },
    /// More pixels than there is memory for.
    #[error("there is no room for a picture of {width} x {height} pixels")]
    NoRoom {
        /// Width.
        width: u32,
        /// Height.
        height: u32,
    },
}
