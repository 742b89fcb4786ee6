//! Widths of lines in pixels of 1/96 inch.

/// The finest line, 0.6 pt in print.
pub const FINE: f64 = 0.8;
/// A curve, 1.2 pt.
pub const CURVE: f64 = 1.6;
/// An emphasised curve, 1.8 pt.
pub const BOLD: f64 = 2.4;
