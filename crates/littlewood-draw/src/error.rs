//! What can go wrong with a drawing.

/// A drawing that cannot be made.
#[derive(Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum DrawError {
    /// A scale out of bounds.
    #[error(
        "scale is {scale}, but must be from {least} to {most} pixels of the picture to one of the drawing"
    )]
    Scale { scale: f64, least: f64, most: f64 },
    /// A width out of bounds.
    #[error("width in print is {mm} mm, but must be from {least} to {most} mm")]
    Width { mm: f64, least: f64, most: f64 },
    /// More pixels than there is memory for.
    #[error("there is no room for a picture of {width} x {height} pixels")]
    NoRoom { width: u32, height: u32 },
}
