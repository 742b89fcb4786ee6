//! What a figure is: panels with series of data, and how each is drawn.

use std::borrow::Cow;

use littlewood_style::ticks::{self, Tick};
use littlewood_style::{Curve, Rgb};

use crate::clip;
use crate::markup::plain;
use crate::primitives::{Anchor, Image, Point, Range};
use crate::stroke::{INK, LETTER, ROOM, Stroke};

/// A figure, complete: [`Figure::svg`], [`Figure::png`] and [`Figure::csv`] only write it down.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Name, as the command line and files have it.
    pub name: &'static str,
    /// What it shows, in a few words; with marks, see [`crate::plain`].
    pub title: String,
    /// Caption; with marks.
    pub caption: String,
    /// Width in pixels, on a screen 1/96 inch each.
    pub width: f64,
    /// Height in pixels.
    pub height: f64,
    /// Width in print, in millimetres, if it is made for print: lines and letters then have the
    /// same size at any width.
    pub print_mm: Option<f64>,
    /// The panels.
    pub panels: Vec<Panel>,
    /// What was cut, limited or left out, a sentence each: [`Figure::fitted`] puts them below the
    /// panels and at the end of the caption.
    pub notes: Vec<String>,
}

/// Where a panel stands on its sheet, in pixels, axis labels included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelFrame {
    /// Its left side.
    pub left: f64,
    /// Its upper side.
    pub top: f64,
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
}

impl PanelFrame {
    /// That of a panel which is all of a sheet, or its upper part.
    pub const fn from_corner(width: f64, height: f64) -> Self {
        Self {
            left: 0.0,
            top: 0.0,
            width,
            height,
        }
    }
}

/// A part of a figure with axes of its own.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Name in the file of data.
    pub name: &'static str,
    /// Where it stands.
    pub frame: PanelFrame,
    /// Axes.
    pub view: View,
    /// Pixels over the whole of the axes, below all that is drawn.
    pub image: Option<Image>,
    /// What is drawn, the lowest first.
    pub layers: Vec<Layer>,
    /// Texts.
    pub labels: Vec<Label>,
    /// Keys to colours.
    pub keys: Vec<Key>,
}

/// The axes of a panel.
#[derive(Clone, Debug)]
pub enum View {
    /// Two axes.
    Plane {
        /// To the right.
        x: PlotAxis,
        /// Upwards.
        y: PlotAxis,
        /// Whether axes are drawn.
        axes: bool,
        /// Angle by which the coordinates of the data are turned against the axes,
        /// counterclockwise.
        tilt: f64,
    },
    /// Three axes, seen from a direction.
    Space {
        /// To the right.
        x: PlotAxis,
        /// Upwards.
        y: PlotAxis,
        /// To the back.
        z: PlotAxis,
        /// Rotation about the upward axis.
        yaw: f64,
        /// Elevation of the eye.
        pitch: f64,
    },
}

/// An axis: the column that runs along it, from where to where.
#[derive(Clone, Debug)]
#[must_use]
pub struct PlotAxis {
    /// Name of the column.
    pub column: Cow<'static, str>,
    /// Symbol and unit, with marks.
    pub title: String,
    /// Lowest and highest value.
    pub range: Range,
    /// Where it begins to be logarithmic, on either side of zero; infinite for a linear axis.
    pub linear: f64,
    /// Which ticks it has.
    pub scale: Scale,
    /// Ticks.
    pub ticks: Vec<Tick>,
}

/// Which ticks an axis has, as many as there is room for.
#[derive(Clone, Debug, PartialEq)]
pub enum Scale {
    /// Round numbers.
    Round,
    /// Round numbers from zero on.
    NotNegative,
    /// Whole numbers.
    Whole,
    /// Multiples of a fraction of π, and others that stand in any case.
    Angle(Vec<Tick>),
    /// Powers of ten; the values of the axis are their logarithms.
    Decades,
    /// These, as many as there is room for.
    Given(Vec<Tick>),
    /// Round numbers, without labels: another panel below has them.
    Bare,
    /// None.
    Nothing,
}

/// Data and how they are drawn.
#[derive(Clone, Debug)]
pub struct Layer {
    /// The data.
    pub series: Series,
    /// How.
    pub mark: Mark,
    /// Whether a mark says where it leaves the axes above or below: of a curve that is data, not of
    /// one that goes on beyond any window.
    pub is_marked_beyond: bool,
}

/// Rows that are drawn together, such as the points of a line.
pub type Piece = Vec<Vec<f64>>;

/// Rows of named columns, in pieces that are drawn one by one.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Series {
    /// Name.
    pub name: String,
    /// Names of the columns.
    pub columns: Vec<Cow<'static, str>>,
    /// Pieces of rows.
    pub pieces: Vec<Piece>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A line for each piece.
    Line(Stroke),
    /// A line with a head at its end.
    Arrow(Stroke),
    /// A head at the first row of each piece, pointing to the second.
    Head(Rgb),
    /// A polygon for each piece.
    Fill(Rgb),
    /// The area that all pieces bound together: those around it, and those around its holes in the
    /// other direction.
    Region(Rgb),
    /// A hatched polygon for each piece.
    Hatch(Rgb),
    /// A hatched area that all pieces bound together.
    HatchedRegion(Rgb),
    /// A dot on each row.
    Dot(Rgb, f64),
    /// A circle on each row, white inside.
    Ring(Rgb, f64),
    /// A square on its corner on each row, edged with paper.
    Diamond(Rgb, f64),
    /// A cross on each row.
    Cross(Rgb, f64),
    /// A triangle at the end of the upward axis beyond which each row lies.
    Beyond(Rgb),
    /// A hoop on each row, whose last column is the angle of its particle.
    Hoop(HoopShape),
}

/// A hoop as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoopShape {
    /// Offset of the particle, ℓ̂, in radii.
    pub offset: f64,
    /// That of the mass centre, h.
    pub h: f64,
    /// Radius in units of the axes.
    pub radius: f64,
    /// Colour of the rim.
    pub rim: Stroke,
}

/// A text in a panel.
#[derive(Clone, Debug)]
#[must_use]
pub struct Label {
    /// Text, with marks.
    pub text: String,
    /// Where, in the coordinates of the axes.
    pub at: Vec<f64>,
    /// How far from there, in pixels to the right and downwards.
    pub shift: [f64; 2],
    /// Which end of the text is there.
    pub anchor: Anchor,
    /// Size of the letters in pixels.
    pub size: f64,
    /// Colour.
    pub colour: Rgb,
    /// Whether it stands where it is asked for: the figure has made room for it.
    pub is_fixed: bool,
    /// Whether it is the name of its place alone: it may stand far off, at the end of a line from
    /// there.
    pub is_led: bool,
    /// Whether it is the name of the area that its place is in: it may stand anywhere in it, and
    /// nowhere else.
    pub is_of_area: bool,
}

/// A line of the key.
#[derive(Clone, Debug)]
pub struct Key {
    /// What it shows.
    pub mark: Mark,
    /// What it means, with marks.
    pub text: String,
    /// Where its left end stands in the figure, in pixels.
    pub at: [f64; 2],
}

impl Mark {
    /// Whether it fills or hatches what its pieces bound.
    pub(crate) const fn is_area(self) -> bool {
        matches!(
            self,
            Self::Fill(_) | Self::Region(_) | Self::Hatch(_) | Self::HatchedRegion(_)
        )
    }
}

impl From<Stroke> for Mark {
    fn from(stroke: Stroke) -> Self {
        Self::Line(stroke)
    }
}

impl From<Curve> for Mark {
    fn from(curve: Curve) -> Self {
        Self::Line(Stroke::of_curve(curve))
    }
}

/// How far off the sheet places are told apart, in lengths of the axis.
const FAR: f64 = 1e3;

impl PlotAxis {
    fn has_words(&self) -> bool {
        self.scale != Scale::Nothing || !self.title.is_empty()
    }

    /// An axis with round ticks.
    pub fn new(
        column: impl Into<Cow<'static, str>>,
        title: impl Into<String>,
        range: Range,
    ) -> Self {
        let (column, title) = (column.into(), title.into());
        Self {
            column,
            title,
            range,
            linear: f64::INFINITY,
            scale: Scale::Round,
            ticks: Vec::new(),
        }
    }

    /// Values with small ticks, which only an axis that is not linear has.
    pub fn small_ticks(&self) -> Vec<f64> {
        let Range { from, to } = self.range;
        let decade = |size: f64| libm::floor(libm::log10(size)) as i32;
        let mut values: Vec<f64> = if self.scale == Scale::Nothing {
            Vec::new()
        } else if self.scale == Scale::Decades {
            ticks::of_one_digit(libm::floor(from) as i32, libm::floor(to) as i32)
                .map(libm::log10)
                .collect()
        } else if self.linear.is_finite() {
            let last = decade(f64::max(from.abs(), to.abs()));
            ticks::of_one_digit(decade(self.linear), last)
                .flat_map(|size| [-size, size])
                .collect()
        } else {
            Vec::new()
        };
        values.retain(|value| (from..=to).contains(value));
        values
    }

    /// An axis of which nothing is seen.
    pub fn silent(column: &'static str, range: Range) -> Self {
        Self {
            scale: Scale::Nothing,
            ..Self::new(column, "", range)
        }
    }

    /// Which part of the axis lies before a value. What lies far off the sheet need not be told
    /// from what lies farther off.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let bent = |value: f64| {
            if self.linear.is_finite() {
                libm::asinh(value / self.linear)
            } else {
                value
            }
        };
        let [low, high] = self.range.ends().map(bent);
        ((bent(value) - low) / (high - low)).clamp(-FAR, FAR)
    }
}

/// A place of coordinates that are turned by an angle, counterclockwise, in those that are not.
pub fn tilted(angle: f64, place: Point) -> Point {
    if angle == 0.0 {
        return place;
    }
    let Point { x, y } = place;
    let (sin, cos) = libm::sincos(angle);
    Point {
        x: x * cos - y * sin,
        y: x * sin + y * cos,
    }
}

impl Panel {
    /// Its axes: to the right, upwards, to the back.
    pub fn axes(&self) -> Vec<&PlotAxis> {
        match &self.view {
            View::Plane { x, y, .. } => vec![x, y],
            View::Space { x, y, z, .. } => vec![x, y, z],
        }
    }

    /// Where the axes of a plane stand: left upper and right lower corner in pixels.
    pub fn axes_frame(&self) -> [[f64; 2]; 2] {
        // Axes without a word on them take no room.
        let has_axes = match &self.view {
            View::Plane { x, y, axes, .. } => *axes && [x, y].iter().any(|axis| axis.has_words()),
            View::Space { .. } => false,
        };
        let [left, below] = if has_axes { ROOM } else { [0.0; 2] };
        let frame = self.frame;
        [
            [frame.left + left, frame.top],
            [frame.left + frame.width, frame.top + frame.height - below],
        ]
    }

    /// Where a place of its plane is drawn, in pixels; none in space.
    pub fn place(&self, place: Point) -> Option<Point> {
        let View::Plane { x, y, tilt, .. } = &self.view else {
            return None;
        };
        let [[left, top], [end, bottom]] = self.axes_frame();
        let turned = tilted(*tilt, place);
        Some(Point {
            x: left + x.share(turned.x) * (end - left),
            y: bottom - y.share(turned.y) * (bottom - top),
        })
    }

    /// The pieces of a line in its plane that lie within the axes, in pixels.
    pub fn line(&self, points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let places: Option<Vec<[f64; 2]>> = points
            .iter()
            .map(|point| Some(self.place((*point).into())?.row()))
            .collect();
        clip::line(&places.unwrap_or_default(), self.axes_frame())
    }
}

impl Series {
    /// A series of one piece.
    pub fn of_rows<Row: Into<Vec<f64>>>(
        name: impl Into<String>,
        columns: &[&'static str],
        rows: impl IntoIterator<Item = Row>,
    ) -> Self {
        Self::new(name, columns, [rows])
    }

    /// A series.
    pub fn new<Rows: IntoIterator<Item: Into<Vec<f64>>>>(
        name: impl Into<String>,
        columns: &[&'static str],
        pieces: impl IntoIterator<Item = Rows>,
    ) -> Self {
        let piece = |rows: Rows| rows.into_iter().map(Into::into).collect();
        Self {
            name: name.into(),
            columns: columns.iter().copied().map(Cow::Borrowed).collect(),
            pieces: pieces.into_iter().map(piece).collect(),
        }
    }

    /// Place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| *column == name)
    }

    /// All rows.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.pieces.iter().flatten().map(Vec::as_slice)
    }

    /// Drawn so.
    pub fn drawn(self, mark: impl Into<Mark>) -> Layer {
        Layer {
            series: self,
            mark: mark.into(),
            is_marked_beyond: false,
        }
    }
}

impl Layer {
    /// A mark says where it leaves the axes above or below, and how far it goes.
    #[must_use]
    pub fn marked_beyond(self) -> Self {
        Self {
            is_marked_beyond: true,
            ..self
        }
    }
}

impl Label {
    /// A text of the usual size, its middle at a place.
    pub fn new(text: impl Into<String>, at: &[f64]) -> Self {
        Self {
            text: text.into(),
            at: at.to_vec(),
            shift: [0.0, 0.0],
            anchor: Anchor::Middle,
            size: LETTER,
            colour: INK,
            is_fixed: false,
            is_led: false,
            is_of_area: false,
        }
    }

    /// Where it is asked for.
    pub fn fixed(self) -> Self {
        Self {
            is_fixed: true,
            ..self
        }
    }

    /// The name of its place alone, to which a line leads where it stands far off.
    pub fn led(self) -> Self {
        Self {
            is_led: true,
            ..self
        }
    }

    /// The name of the area that its place is in.
    pub fn of_area(self) -> Self {
        Self {
            is_of_area: true,
            ..self
        }
    }

    /// So far from the place, in pixels.
    pub fn shifted(self, right: f64, down: f64) -> Self {
        Self {
            shift: [right, down],
            ..self
        }
    }

    /// Its left end at the place.
    pub fn left(self) -> Self {
        Self {
            anchor: Anchor::Left,
            ..self
        }
    }

    /// Its right end at the place.
    pub fn right(self) -> Self {
        Self {
            anchor: Anchor::Right,
            ..self
        }
    }

    /// In this colour.
    pub fn coloured(self, colour: Rgb) -> Self {
        Self { colour, ..self }
    }

    /// In letters of this size.
    pub fn sized(self, size: f64) -> Self {
        Self { size, ..self }
    }
}

impl Figure {
    /// With what was cut, limited or left out, if anything was.
    #[must_use]
    pub fn noted(mut self, note: impl Into<Option<String>>) -> Self {
        self.notes.extend(note.into());
        self
    }

    /// The caption without marks.
    pub fn caption_txt(&self) -> String {
        format!("{}\n\n{}\n", plain(&self.title), plain(&self.caption))
    }

    /// The series of this name in any panel.
    pub fn series(&self, name: &str) -> Option<&Series> {
        self.panels
            .iter()
            .flat_map(|panel| &panel.layers)
            .map(|layer| &layer.series)
            .find(|s| s.name == name)
    }
}
