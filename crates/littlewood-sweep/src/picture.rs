//! A map as a picture: two axes, a colour for every point, a legend.

use std::sync::Once;

use littlewood::Limits;
use plotters::backend::BitMapBackend;
use plotters::drawing::{DrawingArea, IntoDrawingArea as _};
use plotters::element::{PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontStyle, IntoFont as _, RGBColor, TextStyle, register_font};

use crate::axis::{Axis, Coordinate};
use crate::chunk::{Chunk, Chunks};
use crate::columns::{Columns, Real};
use crate::compute::Workers;
use crate::error::{PictureError, StoreError, SweepError};
use crate::grid::Grid;
use crate::outcome::Class;
use crate::palette::{NOTHING, Rgb, of_class, of_fraction};
use crate::run::{Options, Progress};
use crate::ticks::{self, Tick, minus};
use crate::zarr::ZarrStore;

/// What the colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// The class of the outcome.
    Class,
    /// A real column, on a scale; where it has no value, grey.
    Column(Real),
}

/// Size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

impl Default for Size {
    fn default() -> Self {
        Self { width: 1500, height: 1000 }
    }
}

/// Smallest and largest side of a picture.
const SIDES: [u32; 2] = [300, 10_000];

/// A map of a grid with two axes: the first runs to the right, the second upwards.
///
/// It holds a value for each pixel, not for each point: a grid that is finer than the picture is thinned, and its size
/// does not matter. The shares in the legend are those of all points.
#[derive(Clone, Debug)]
pub struct Picture {
    grid: Grid,
    limits: Limits,
    shade: Shade,
    size: Size,
    frame: Frame,
    /// Cells to the right and upwards.
    counts: [usize; 2],
    cells: Cells,
    /// Points of each class, in the order of [`Class::ALL`].
    tally: [u64; Class::ALL.len()],
}

#[derive(Clone, Debug)]
enum Cells {
    Class(Vec<Class>),
    /// None where it is not computed.
    Real(Vec<Option<f64>>),
}

/// Where the map lies in the picture, in pixels.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: i32,
    top: i32,
    width: i32,
    height: i32,
    /// Size of letters.
    letter: f64,
}

impl Frame {
    fn new(size: Size) -> Self {
        let letter = (f64::from(size.width) / 62.0).min(f64::from(size.height) / 40.0);
        let letters = |count: f64| libm::round(count * letter) as i32;
        let (left, top) = (letters(4.5), letters(5.6));
        Self {
            left,
            top,
            width: size.width as i32 - left - letters(16.5),
            height: size.height as i32 - top - letters(4.6),
            letter,
        }
    }

    fn enlarged(self, factor: u32) -> Self {
        let times = |length: i32| length * factor as i32;
        Self {
            left: times(self.left),
            top: times(self.top),
            width: times(self.width),
            height: times(self.height),
            letter: self.letter * f64::from(factor),
        }
    }
}

/// How much larger than the picture the drawing is.
const FINE: u32 = 2;

/// Means of squares of FINE × FINE pixels.
fn reduce(pixels: &[u8], size: Size) -> Vec<u8> {
    let (width, fine) = (size.width as usize, FINE as usize);
    let mut reduced = Vec::with_capacity(width * size.height as usize * 3);
    for y in 0..size.height as usize {
        for x in 0..width {
            for channel in 0..3 {
                let mut sum = 0;
                for (i, j) in (0..fine).flat_map(|i| (0..fine).map(move |j| (i, j))) {
                    sum += usize::from(pixels[((y * fine + i) * width * fine + x * fine + j) * 3 + channel]);
                }
                let mean = (sum + fine * fine / 2) / (fine * fine);
                reduced.push(u8::try_from(mean).unwrap_or(u8::MAX));
            }
        }
    }
    reduced
}

impl Picture {
    /// An empty picture of a grid.
    ///
    /// # Errors
    /// If the grid has not two axes, or the picture no room.
    pub fn new(grid: &Grid, limits: Limits, shade: Shade, size: Size) -> Result<Self, PictureError> {
        let [x, y] = grid.axes() else {
            return Err(PictureError::NotTwoAxes { found: grid.axes().len() });
        };
        let [least, most] = SIDES;
        if [size.width, size.height].iter().any(|side| !(least..=most).contains(side)) {
            return Err(PictureError::Size { width: size.width, height: size.height, least, most });
        }
        let frame = Frame::new(size);
        let pixels = |length: i32| usize::try_from(length).unwrap_or(1).max(1);
        let counts = [x.count().min(pixels(frame.width)), y.count().min(pixels(frame.height))];
        let cells = match shade {
            Shade::Class => Cells::Class(vec![Class::NotComputed; counts[0] * counts[1]]),
            Shade::Column(_) => Cells::Real(vec![None; counts[0] * counts[1]]),
        };
        let mut tally = [0; Class::ALL.len()];
        tally[Class::NotComputed as usize] = grid.len();
        Ok(Self { grid: grid.clone(), limits, shade, size, frame, counts, cells, tally })
    }

    /// Computes a grid and draws it; nothing is kept but the picture. A cancelled picture is white where it is not
    /// computed.
    ///
    /// # Errors
    /// As [`Picture::new`] and [`Workers::compute`].
    pub fn of_grid(
        grid: &Grid,
        limits: Limits,
        shade: Shade,
        size: Size,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, SweepError> {
        let mut picture = Self::new(grid, limits, shade, size)?;
        let chunks = Chunks::new(grid, options.chunk_points);
        let mut done = 0;
        for chunk in (0..chunks.count()).map(|number| chunks.chunk(number)) {
            if options.cancel.is_some_and(|flag| flag.load(core::sync::atomic::Ordering::Relaxed)) {
                break;
            }
            let columns = workers.compute(chunk.points(grid), limits)?;
            picture.add(&chunk, &columns);
            done += columns.len() as u64;
            if let Some(progress) = options.progress {
                progress(Progress { done, reused: 0, total: grid.len() });
            }
        }
        Ok(picture)
    }

    /// Draws a store.
    ///
    /// # Errors
    /// As [`Picture::new`]; a chunk that cannot be read.
    pub fn of_store(store: &ZarrStore, shade: Shade, size: Size) -> Result<Self, SweepError> {
        let mut picture = Self::new(store.grid(), store.limits(), shade, size)?;
        for number in 0..store.chunks().count() {
            if let Some(columns) = store.columns(number).map_err(|error: StoreError| error)? {
                picture.add(&store.chunks().chunk(number), &columns);
            }
        }
        Ok(picture)
    }

    /// Adds the results of a chunk of the grid.
    pub fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        let axes = [self.grid.axes()[0].count(), self.grid.axes()[1].count()];
        for (i, indices) in chunk.indices().enumerate() {
            let row = columns.row(i);
            let class = Class::of(&row);
            self.tally[class as usize] += 1;
            self.tally[Class::NotComputed as usize] -= 1;
            let [Some(x), Some(y)] = [0, 1].map(|k| cell(indices[k], axes[k], self.counts[k])) else {
                continue;
            };
            let place = y * self.counts[0] + x;
            match (&mut self.cells, self.shade) {
                (Cells::Class(cells), _) => cells[place] = class,
                (Cells::Real(cells), Shade::Column(column)) => cells[place] = Some(column.of(&row)),
                (Cells::Real(_), Shade::Class) => {}
            }
        }
    }

    /// Number of points of a class.
    #[must_use]
    pub const fn count(&self, class: Class) -> u64 {
        self.tally[class as usize]
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// None is known.
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        // Letters are set on whole pixels, which shows in their distances: so all is drawn larger, then reduced.
        let size = Size { width: FINE * self.size.width, height: FINE * self.size.height };
        let frame = self.frame.enlarged(FINE);
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        let scale = Scale::of(&self.cells);
        self.paint(&mut pixels, size, frame, scale.as_ref());
        {
            let area = BitMapBackend::with_buffer(&mut pixels, (size.width, size.height)).into_drawing_area();
            Pen { area, frame }.draw(self, scale.as_ref())?;
        }
        encode(&reduce(&pixels, self.size), self.size.width, self.size.height)
    }

    fn paint(&self, pixels: &mut [u8], size: Size, frame: Frame, scale: Option<&Scale>) {
        let Frame { left, top, width, height, .. } = frame;
        let [nx, ny] = self.counts;
        let flipped = [0, 1].map(|k| {
            let axis = &self.grid.axes()[k];
            axis.from() > axis.to()
        });
        let stride = size.width as usize * 3;
        let (left, top, width, height) = (left as usize, top as usize, width as usize, height as usize);
        for py in 0..height {
            let y = (height - 1 - py) * ny / height;
            let y = if flipped[1] { ny - 1 - y } else { y };
            for px in 0..width {
                let x = px * nx / width;
                let x = if flipped[0] { nx - 1 - x } else { x };
                let place = y * nx + x;
                let colour = match &self.cells {
                    Cells::Class(cells) => of_class(cells[place]),
                    Cells::Real(cells) => match (cells[place], scale) {
                        (None, _) => of_class(Class::NotComputed),
                        (Some(value), Some(scale)) => scale.colour(value),
                        (Some(_), None) => NOTHING,
                    },
                };
                let offset = (top + py) * stride + (left + px) * 3;
                pixels[offset..offset + 3].copy_from_slice(&colour);
            }
        }
    }

    /// What is fixed, in words.
    fn fixed(&self) -> String {
        let mut parts: Vec<String> = Coordinate::ALL
            .into_iter()
            .filter(|&coordinate| self.grid.axes().iter().all(|axis| axis.coordinate() != coordinate))
            .map(|coordinate| {
                let value = coordinate.of_point(self.grid.base());
                let rounded = libm::round(value * 1e6) / 1e6;
                format!("{} {} {rounded}", coordinate.symbol(), if rounded == value { '=' } else { '≈' })
            })
            .collect();
        if let Some(until) = self.limits.until {
            parts.push(format!("τ ≤ {until}"));
        }
        minus(&parts.join(",  "))
    }
}

/// The cell of a place on an axis, if the axis has not been thinned there.
fn cell(index: usize, count: usize, cells: usize) -> Option<usize> {
    if cells == count {
        return Some(index);
    }
    // Cell j shows the place in the middle of its share of the axis.
    let j = index * cells / count;
    ((2 * j + 1) * count / (2 * cells) == index).then_some(j)
}

/// The scale of a continuous column.
struct Scale {
    low: f64,
    high: f64,
    /// Whether there are values below and above it.
    beyond: [bool; 2],
}

impl Scale {
    /// From the lowest to the highest value, less half a per cent at either end if that is far out.
    fn of(cells: &Cells) -> Option<Self> {
        let Cells::Real(cells) = cells else { return None };
        let mut values: Vec<f64> =
            cells.iter().copied().flatten().filter(|value| value.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let (&first, &last) = (values.first()?, values.last()?);
        let cut = values.len() / 200;
        let (mut low, mut high) = (values[cut], values[values.len() - 1 - cut]);
        let near = 0.25 * (high - low);
        if low - first <= near {
            low = first;
        }
        if last - high <= near {
            high = last;
        }
        if low == high {
            (low, high) = (low - 0.5, high + 0.5);
        }
        let reaches = |bound: f64| cells.iter().flatten().any(|&value| value == bound);
        let beyond = [first < low || reaches(f64::NEG_INFINITY), last > high || reaches(f64::INFINITY)];
        Some(Self { low, high, beyond })
    }

    fn fraction(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    fn colour(&self, value: f64) -> Rgb {
        if value.is_nan() { NOTHING } else { of_fraction(self.fraction(value)) }
    }
}

const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
const FAINT: RGBColor = RGBColor(0x66, 0x66, 0x66);
const FONT: &str = "DejaVu Sans";

/// Makes the letters known, once; they are part of the program, so that pictures are the same everywhere.
fn letters() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // A font that the crate ships always parses; should it not, drawing text fails and says so.
        let _ = register_font(FONT, FontStyle::Normal, dejavu::sans::regular());
        let _ = register_font(FONT, FontStyle::Bold, dejavu::sans::bold());
    });
}

fn drawing<E: core::fmt::Display>(error: E) -> PictureError {
    PictureError::Drawing(error.to_string())
}

struct Pen<'a> {
    area: DrawingArea<BitMapBackend<'a>, plotters::coord::Shift>,
    frame: Frame,
}

#[derive(Clone, Copy)]
struct Style {
    size: f64,
    colour: RGBColor,
    bold: bool,
    across: HPos,
    up: VPos,
}

impl Pen<'_> {
    fn draw(&self, picture: &Picture, scale: Option<&Scale>) -> Result<(), PictureError> {
        letters();
        let Frame { left, top, width, height, letter } = self.frame;
        let right = left + width;
        let title = match picture.shade {
            Shade::Class => "what becomes of the motion".to_owned(),
            Shade::Column(column) => format!("{}  ({})", column.long_name(), pretty_unit(column.unit())),
        };
        let plain = Style { size: 1.0, colour: INK, bold: false, across: HPos::Left, up: VPos::Center };
        self.text(&title, left, self.at(1.2), Style { size: 1.25, bold: true, ..plain })?;
        self.text(&picture.fixed(), left, self.at(2.8), Style { size: 0.9, colour: FAINT, ..plain })?;

        let axes = picture.grid.axes();
        let bottom = top + height;
        let mark = self.at(0.35);
        for Tick { value, label } in ticks_of(&axes[0], picture.counts[0], 8) {
            let x = left + libm::round(along(&axes[0], picture.counts[0], value) * f64::from(width)) as i32;
            self.line([(x, bottom), (x, bottom + mark)])?;
            self.text(&label, x, bottom + self.at(1.1), Style { across: HPos::Center, ..plain })?;
        }
        for Tick { value, label } in ticks_of(&axes[1], picture.counts[1], 9) {
            let y =
                bottom - libm::round(along(&axes[1], picture.counts[1], value) * f64::from(height)) as i32;
            self.line([(left - mark, y), (left, y)])?;
            self.text(&label, left - self.at(0.7), y, Style { across: HPos::Right, ..plain })?;
        }
        let middle = left + width / 2;
        let name = |axis: &Axis| axis_name(axis.coordinate());
        self.text(
            &name(&axes[0]),
            middle,
            bottom + self.at(3.0),
            Style { size: 1.15, across: HPos::Center, ..plain },
        )?;
        self.text(
            &name(&axes[1]),
            left,
            top - self.at(1.1),
            Style { size: 1.15, across: HPos::Left, ..plain },
        )?;
        for (from, to) in [
            ((left, top), (right, top)),
            ((left, bottom), (right, bottom)),
            ((left, top), (left, bottom)),
            ((right, top), (right, bottom)),
        ] {
            self.line([from, to])?;
        }

        let side = right + libm::round(letter * 1.2) as i32;
        match (picture.shade, scale) {
            (Shade::Column(_), Some(scale)) => self.bar(scale, side)?,
            (Shade::Column(_), None) => {
                self.swatch(side, top + self.at(1.0), NOTHING, "no value anywhere", "")?;
            }
            (Shade::Class, _) => {
                let mut y = top + self.at(1.0);
                for class in Class::ALL {
                    let count = picture.count(class);
                    if count > 0 {
                        let share = 100.0 * count as f64 / picture.grid.len() as f64;
                        let share =
                            if share < 0.05 { format!("{count} points") } else { format!("{share:.1} %") };
                        self.swatch(side, y, of_class(class), class.label(), &share)?;
                        y += self.at(3.2);
                    }
                }
            }
        }
        self.area.present().map_err(drawing)
    }

    fn bar(&self, scale: &Scale, side: i32) -> Result<(), PictureError> {
        let Frame { top, height, .. } = self.frame;
        let (wide, tall) = (self.at(1.6), height * 4 / 5);
        let bottom = top + tall;
        for i in 0..tall {
            let [r, g, b] = of_fraction((f64::from(i) + 0.5) / f64::from(tall));
            let y = bottom - i;
            let strip = Rectangle::new([(side, y - 1), (side + wide, y)], RGBColor(r, g, b).filled());
            self.area.draw(&strip).map_err(drawing)?;
        }
        let plain = Style { size: 1.0, colour: INK, bold: false, across: HPos::Left, up: VPos::Center };
        let ticks = ticks::round(scale.low, scale.high, 8);
        for Tick { value, label } in ticks {
            let y = bottom - libm::round(scale.fraction(value) * f64::from(tall)) as i32;
            self.line([(side + wide, y), (side + wide + self.at(0.35), y)])?;
            self.text(&label, side + wide + self.at(0.7), y, plain)?;
        }
        let small = Style { size: 0.85, colour: FAINT, ..plain };
        if scale.beyond[1] {
            self.text("values above: as the top", side, top - self.at(0.9), small)?;
        }
        if scale.beyond[0] {
            self.text("values below: as the bottom", side, bottom + self.at(0.9), small)?;
        }
        self.swatch(side, bottom + self.at(3.0), NOTHING, "does not happen", "")
    }

    fn swatch(&self, x: i32, y: i32, [r, g, b]: Rgb, label: &str, share: &str) -> Result<(), PictureError> {
        let (half, wide) = (self.at(0.6), self.at(1.6));
        let corners = [(x, y - half), (x + wide, y + half)];
        self.area.draw(&Rectangle::new(corners, RGBColor(r, g, b).filled())).map_err(drawing)?;
        self.area.draw(&Rectangle::new(corners, FAINT.stroke_width(FINE))).map_err(drawing)?;
        let plain = Style { size: 1.0, colour: INK, bold: false, across: HPos::Left, up: VPos::Center };
        let x = x + wide + self.at(0.6);
        self.text(label, x, y, plain)?;
        self.text(share, x, y + self.at(1.3), Style { size: 0.85, colour: FAINT, ..plain })
    }

    /// So many letters, in pixels.
    fn at(&self, letters: f64) -> i32 {
        libm::round(letters * self.frame.letter) as i32
    }

    fn line(&self, points: [(i32, i32); 2]) -> Result<(), PictureError> {
        self.area.draw(&PathElement::new(points, INK.stroke_width(FINE))).map_err(drawing)
    }

    fn text(&self, text: &str, x: i32, y: i32, style: Style) -> Result<(), PictureError> {
        // The middle of the box of a letter lies above the middle of the letter.
        let y = if matches!(style.up, VPos::Center) { y + self.at(0.1) } else { y };
        let weight = if style.bold { FontStyle::Bold } else { FontStyle::Normal };
        let font = (FONT, style.size * self.frame.letter, weight).into_font();
        let text_style = TextStyle::from(font).color(&style.colour).pos(Pos::new(style.across, style.up));
        self.area.draw(&Text::new(text.to_owned(), (x, y), text_style)).map_err(drawing)
    }
}

/// The lowest and the highest value that a picture shows: half a cell beyond the ends.
fn span(axis: &Axis, cells: usize) -> (f64, f64) {
    let half = if axis.count() > 1 {
        0.5 * (axis.to() - axis.from()).abs() / (cells - 1).max(1) as f64
    } else {
        0.5
    };
    (axis.from().min(axis.to()) - half, axis.from().max(axis.to()) + half)
}

/// Where a value lies, from 0 to 1.
fn along(axis: &Axis, cells: usize, value: f64) -> f64 {
    let (low, high) = span(axis, cells);
    (value - low) / (high - low)
}

fn ticks_of(axis: &Axis, cells: usize, most: usize) -> Vec<Tick> {
    let (low, high) = if axis.count() > 1 {
        (axis.from().min(axis.to()), axis.from().max(axis.to()))
    } else {
        span(axis, cells)
    };
    match axis.coordinate() {
        Coordinate::Theta => ticks::angular(low, high, most),
        _ => ticks::round(low, high, most),
    }
}

fn axis_name(coordinate: Coordinate) -> String {
    match coordinate {
        Coordinate::ThetaRate | Coordinate::Slip => {
            format!("{}  ({})", coordinate.symbol(), pretty_unit(coordinate.unit()))
        }
        _ => coordinate.symbol().to_owned(),
    }
}

/// A unit as print has it.
fn pretty_unit(unit: &str) -> String {
    match unit {
        "sqrt(R/g)" => "√(R/g)".to_owned(),
        "sqrt(g/R)" => "√(g/R)".to_owned(),
        "sqrt(g R)" => "√(gR)".to_owned(),
        "m2 g R" => "m₂gR".to_owned(),
        other => other.to_owned(),
    }
}

fn encode(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, PictureError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().map_err(drawing)?;
    writer.write_image_data(pixels).map_err(drawing)?;
    writer.finish().map_err(drawing)?;
    Ok(bytes)
}
