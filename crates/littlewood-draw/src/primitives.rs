//! Plain values that all drawings are made of.

/// A place: in pixels, to the right and downwards, or in the units of axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Downwards on a sheet, upwards along axes.
    pub y: f64,
}

impl Point {
    /// A place by its numbers.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Both numbers, as labels have them.
    pub const fn row(self) -> [f64; 2] {
        [self.x, self.y]
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

/// As a row of a series.
impl From<Point> for Vec<f64> {
    fn from(point: Point) -> Self {
        point.row().to_vec()
    }
}

/// The part of an axis that is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Its lowest value.
    pub from: f64,
    /// Its highest value.
    pub to: f64,
}

impl Range {
    /// Lowest and highest value.
    pub const fn ends(self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// From the lowest to the highest value.
    pub const fn length(self) -> f64 {
        self.to - self.from
    }

    /// Whether a value is seen.
    pub fn contains(self, value: f64) -> bool {
        (self.from..=self.to).contains(&value)
    }
}

impl From<[f64; 2]> for Range {
    fn from([from, to]: [f64; 2]) -> Self {
        Self { from, to }
    }
}

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
    Move(Point),
    /// Goes on straight.
    Line(Point),
    /// A quadratic curve: its handle and its end.
    Quad(Point, Point),
    /// A cubic curve: its handles and its end.
    Curve(Point, Point, Point),
    /// Closes the line.
    Close,
}

impl Segment {
    /// The same at other places.
    pub fn placed(self, place: impl Fn(Point) -> Point) -> Self {
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
