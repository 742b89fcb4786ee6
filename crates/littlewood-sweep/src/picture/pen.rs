//! What is drawn around the map and over it: title, axes, legend, curves.

use littlewood_style::ticks::Tick;
use littlewood_style::{Curve, Ink, Rgb, Theme, width};
use plotters::backend::BitMapBackend;
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontTransform, RGBColor, TextStyle};

use super::curves::Point;
use super::error::PictureError;
use super::frame::{FINE, Frame};
use super::layout::{Entry, Layout, Sign};
use super::letters::Face;
use super::map::Picture;
use super::names::{along, axis_name, unit_of};
use super::scale::{Kind, Scale};

pub(super) struct Pen<'a> {
    pub(super) area: DrawingArea<BitMapBackend<'a>, Shift>,
    pub(super) layout: &'a Layout,
}

/// Letters that make up a curve's width: pictures are wider than figures, whose widths these are.
const LINES: f64 = 1.0 / 12.0;

impl Pen<'_> {
    pub(super) fn draw(&self, picture: &Picture) -> Result<(), PictureError> {
        let Layout { frame, title, lines, entries, scale, bar, ticks, .. } = self.layout;
        let frame = *frame;
        let Frame { left, top, width, height } = frame;
        let axes = picture.grid.axes();

        if picture.has_curves {
            for (curve, points) in picture.curves() {
                self.curve(curve, &points)?;
            }
        }
        if let Some(scale) = scale {
            for pair in picture.contours(scale) {
                let [a, b] = pair.map(|point| self.pixel(point));
                self.stroke(&[a, b], Ink::Paper.colour(Theme::Light), 0.6 * FINE_LINE)?;
            }
        }

        self.text(title, left, self.at(1.3), Face::TITLE, Ink::Ink, HPos::Left)?;
        for (line, y) in lines {
            self.text(line, left, *y, Face::SMALL, Ink::Soft, HPos::Left)?;
        }
        if let (Some(scale), Some(bar)) = (scale, bar) {
            self.bar(scale, *bar, unit_of(picture.shade, picture.units.as_ref()))?;
        }
        for entry in entries {
            self.entry(entry)?;
        }

        let mark = self.at(0.35);
        let units = picture.units.as_ref();
        for Tick { value, label } in &ticks[0] {
            let x = left + libm::round(along(&axes[0], *value) * f64::from(width)) as i32;
            self.line([(x, frame.bottom()), (x, frame.bottom() + mark)])?;
            self.text(label, x, frame.bottom() + self.at(1.15), Face::PLAIN, Ink::Ink, HPos::Center)?;
        }
        for Tick { value, label } in &ticks[1] {
            let y = frame.bottom() - libm::round(along(&axes[1], *value) * f64::from(height)) as i32;
            self.line([(left - mark, y), (left, y)])?;
            self.text(label, left - self.at(0.7), y, Face::PLAIN, Ink::Ink, HPos::Right)?;
        }
        let below = frame.bottom() + self.at(2.9);
        self.text(&axis_name(&axes[0], units), left + width / 2, below, Face::NAME, Ink::Ink, HPos::Center)?;
        self.upright(&axis_name(&axes[1], units), self.at(1.2), top + height / 2)?;
        for (from, to) in [
            ((left, top), (frame.right(), top)),
            ((left, frame.bottom()), (frame.right(), frame.bottom())),
            ((left, top), (left, frame.bottom())),
            ((frame.right(), top), (frame.right(), frame.bottom())),
        ] {
            self.line([from, to])?;
        }
        self.area.present().map_err(PictureError::drawing)
    }

    fn bar(&self, scale: &Scale, [top, bottom]: [i32; 2], unit: f64) -> Result<(), PictureError> {
        let Frame { left, width, .. } = self.layout.frame;
        for i in 0..width {
            let colour = scale.at((f64::from(i) + 0.5) / f64::from(width));
            let strip = Rectangle::new([(left + i, top), (left + i + 1, bottom)], rgb(colour).filled());
            self.area.draw(&strip).map_err(PictureError::drawing)?;
        }
        for Tick { value, label } in scale.ticks(unit, 10) {
            let x = left + libm::round(scale.fraction(value) * f64::from(width)) as i32;
            if scale.kind != Kind::Counts {
                self.line([(x, bottom), (x, bottom + self.at(0.3))])?;
            }
            self.text(&label, x, bottom + self.at(1.0), Face::PLAIN, Ink::Ink, HPos::Center)?;
        }
        Ok(())
    }

    fn entry(&self, entry: &Entry) -> Result<(), PictureError> {
        let [x, y] = entry.at;
        match entry.sign {
            Sign::Fill(colour) => {
                let (half, wide) = (self.at(0.5), self.at(1.5));
                let corners = [(x, y - half), (x + wide, y + half)];
                self.area
                    .draw(&Rectangle::new(corners, rgb(colour).filled()))
                    .map_err(PictureError::drawing)?;
                let edge = rgb(Ink::Soft.colour(Theme::Light)).stroke_width(FINE);
                self.area.draw(&Rectangle::new(corners, edge)).map_err(PictureError::drawing)?;
            }
            Sign::Line(curve) => {
                let ends = [(f64::from(x), f64::from(y)), (f64::from(x + self.at(2.4)), f64::from(y))];
                self.dashed(&ends, curve)?;
            }
            Sign::None => {}
        }
        let x = x + self.at(entry.indent());
        let ink = if entry.sign == Sign::None { Ink::Soft } else { Ink::Ink };
        self.text(&entry.label, x, y, Face::PLAIN, ink, HPos::Left)?;
        let share = x + self.at(Face::PLAIN.width(&entry.label) + 0.5);
        self.text(&entry.share, share, y, Face::SMALL, Ink::Soft, HPos::Left)
    }

    /// Where a point of the map lies.
    fn pixel(&self, [x, y]: Point) -> (f64, f64) {
        let frame = self.layout.frame;
        (
            f64::from(frame.left) + x * f64::from(frame.width),
            f64::from(frame.bottom()) - y * f64::from(frame.height),
        )
    }

    /// A curve with a border of paper, which sets it off from any colour.
    fn curve(&self, curve: Curve, points: &[Point]) -> Result<(), PictureError> {
        for run in clipped(points) {
            let run: Vec<(f64, f64)> = thinned(run.into_iter().map(|point| self.pixel(point)));
            self.stroke(&run, Ink::Paper.colour(Theme::Light), 2.2 * curve.width() * LINES)?;
            self.dashed(&run, curve)?;
        }
        Ok(())
    }

    fn dashed(&self, points: &[(f64, f64)], curve: Curve) -> Result<(), PictureError> {
        let wide = curve.width() * LINES;
        let colour = curve.colour(Theme::Light);
        let pattern: Vec<f64> =
            curve.dash().pattern().iter().map(|part| part * wide * self.layout.letter).collect();
        if pattern.is_empty() {
            return self.stroke(points, colour, wide);
        }
        for dash in dashes(points, &pattern) {
            self.stroke(&dash, colour, wide)?;
        }
        Ok(())
    }

    /// A line of this width in letters.
    fn stroke(&self, points: &[(f64, f64)], colour: Rgb, wide: f64) -> Result<(), PictureError> {
        let mut places: Vec<(i32, i32)> =
            points.iter().map(|(x, y)| (libm::round(*x) as i32, libm::round(*y) as i32)).collect();
        places.dedup();
        let pixels = self.at(wide).max(1).unsigned_abs();
        self.area
            .draw(&PathElement::new(places, rgb(colour).stroke_width(pixels)))
            .map_err(PictureError::drawing)
    }

    /// A length in letters, in pixels.
    fn at(&self, letters: f64) -> i32 {
        libm::round(letters * self.layout.letter) as i32
    }

    fn line(&self, points: [(i32, i32); 2]) -> Result<(), PictureError> {
        self.area
            .draw(&PathElement::new(points, rgb(Ink::Ink.colour(Theme::Light)).stroke_width(FINE)))
            .map_err(PictureError::drawing)
    }

    fn text(
        &self,
        text: &str,
        x: i32,
        y: i32,
        face: Face,
        ink: Ink,
        across: HPos,
    ) -> Result<(), PictureError> {
        // The middle of the box of a letter lies above the middle of the letter.
        let place = (x, y + self.at(0.1));
        let colour = rgb(ink.colour(Theme::Light));
        let style =
            TextStyle::from(face.font(self.layout.letter)).color(&colour).pos(Pos::new(across, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), place, style)).map_err(PictureError::drawing)
    }

    /// A name that runs upwards.
    fn upright(&self, text: &str, x: i32, y: i32) -> Result<(), PictureError> {
        let font = Face::NAME.font(self.layout.letter).transform(FontTransform::Rotate270);
        let colour = rgb(Ink::Ink.colour(Theme::Light));
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(HPos::Center, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), (x, y), style)).map_err(PictureError::drawing)
    }
}

/// Width of the finest line in letters.
const FINE_LINE: f64 = width::CURVE * LINES;

/// The parts of a line within the map, cut at its edges.
pub(super) fn clipped(points: &[Point]) -> Vec<Vec<Point>> {
    let mut runs: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some([a, b]) = clip(pair[0], pair[1]) else { continue };
        match runs.last_mut() {
            Some(run) if run.last() == Some(&a) => run.push(b),
            _ => runs.push(vec![a, b]),
        }
    }
    runs
}

/// Shortest piece of a curve, in pixels: the library sets corners on whole pixels, which shows where they are close.
const PIECE: f64 = 12.0;

/// A line without the points that are close to those before them.
fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let mut last = None;
    for point in points {
        last = Some(point);
        if kept.last().is_none_or(|&(x, y)| libm::hypot(point.0 - x, point.1 - y) >= PIECE) {
            kept.push(point);
        }
    }
    if kept.last().copied() != last {
        kept.extend(last);
    }
    kept
}

/// The part of a segment within the unit square.
fn clip(a: Point, b: Point) -> Option<[Point; 2]> {
    let (mut from, mut to) = (0.0, 1.0);
    for k in 0..2 {
        let step = b[k] - a[k];
        for (distance, slope) in [(a[k], -step), (1.0 - a[k], step)] {
            if slope == 0.0 {
                if distance < 0.0 {
                    return None;
                }
            } else if slope > 0.0 {
                to = f64::min(to, distance / slope);
            } else {
                from = f64::max(from, distance / slope);
            }
        }
    }
    let at = |t: f64| {
        [0, 1].map(|k| {
            if t == 0.0 {
                a[k]
            } else if t == 1.0 {
                b[k]
            } else {
                a[k] + t * (b[k] - a[k])
            }
        })
    };
    (from < to).then(|| [at(from), at(to)])
}

/// A line in dashes of these lengths and gaps, by turns.
fn dashes(points: &[(f64, f64)], pattern: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let mut dashes = Vec::new();
    let (mut part, mut left) = (0, pattern[0]);
    let mut dash: Vec<(f64, f64)> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let [(ax, ay), (bx, by)] = [pair[0], pair[1]];
        let length = libm::hypot(bx - ax, by - ay);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let t = done / length;
            let place = (ax + t * (bx - ax), ay + t * (by - ay));
            if part % 2 == 0 {
                dash.push(place);
                dashes.push(core::mem::take(&mut dash));
            } else {
                dash = vec![place];
            }
            part = (part + 1) % pattern.len();
            left = pattern[part];
        }
        left -= length - done;
        if part % 2 == 0 {
            dash.push((bx, by));
        }
    }
    if part % 2 == 0 && dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

const fn rgb(Rgb([red, green, blue]): Rgb) -> RGBColor {
    RGBColor(red, green, blue)
}
