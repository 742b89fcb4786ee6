//! Plain values that all drawings are made of.

/// Pixels row by row from the top, three bytes each: red, green and blue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Width and height.
    pub size: [usize; 2],
    /// The pixels.
    pub pixels: Vec<u8>,
}

/// Which part of a text stands at its place; its middle in the vertical.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Left,
    /// Its middle.
    Middle,
    /// Its right end.
    Right,
}

impl Anchor {
    /// Which part of the width lies to the left of the place.
    pub const fn share(self) -> f64 {
        match self {
            Self::Left => 0.0,
            Self::Middle => 0.5,
            Self::Right => 1.0,
        }
    }
}

/// A piece of a path, in pixels, downwards positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Begins a line.
    Move([f64; 2]),
    /// Goes on straight.
    Line([f64; 2]),
    /// A quadratic curve: its handle and its end.
    Quad([f64; 2], [f64; 2]),
    /// A cubic curve: its handles and its end.
    Curve([f64; 2], [f64; 2], [f64; 2]),
    /// Closes the line.
    Close,
}

impl Segment {
    /// The same at other places.
    pub fn placed(self, place: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        match self {
            Self::Move(to) => Self::Move(place(to)),
            Self::Line(to) => Self::Line(place(to)),
            Self::Quad(a, to) => Self::Quad(place(a), place(to)),
            Self::Curve(a, b, to) => Self::Curve(place(a), place(b), place(to)),
            Self::Close => Self::Close,
        }
    }
}

/// A path.
pub(crate) type Path = [Segment];
