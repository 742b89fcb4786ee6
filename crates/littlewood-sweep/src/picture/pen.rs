//! What is drawn around the map: title, axes, legend.

use std::sync::Once;

use plotters::backend::BitMapBackend;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontStyle, IntoFont as _, RGBColor, TextStyle, register_font};

use littlewood::Class;
use littlewood_style::ticks::{self, Tick};
use littlewood_style::{Ink, Rgb, Theme, of_class};

use super::error::PictureError;
use super::frame::{FINE, Frame};
use super::map::{Picture, Shade};
use super::names::{along, axis_name, ticks_of, title};
use super::scale::{Scale, of_fraction};
use crate::axis::Axis;

const FONT: &str = "DejaVu Sans";

/// Registers the font, once; it is part of the program, so that pictures are the same everywhere.
fn letters() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // A font that the crate ships always parses; should it not, drawing text fails and says so.
        let _ = register_font(FONT, FontStyle::Normal, dejavu::sans::regular());
        let _ = register_font(FONT, FontStyle::Bold, dejavu::sans::bold());
    });
}

pub(super) struct Pen<'a> {
    pub(super) area: DrawingArea<BitMapBackend<'a>, plotters::coord::Shift>,
    pub(super) frame: Frame,
}

#[derive(Clone, Copy)]
struct Style {
    size: f64,
    colour: Ink,
    bold: bool,
    across: HPos,
    up: VPos,
}

impl Pen<'_> {
    pub(super) fn draw(&self, picture: &Picture, scale: Option<&Scale>) -> Result<(), PictureError> {
        letters();
        let Frame { left, top, width, height, letter } = self.frame;
        let right = left + width;
        let plain = Style { size: 1.0, colour: Ink::Ink, bold: false, across: HPos::Left, up: VPos::Center };
        self.text(&title(picture.shade), left, self.at(1.2), Style { size: 1.25, bold: true, ..plain })?;
        self.text(&picture.fixed(), left, self.at(2.8), Style { size: 0.9, colour: Ink::Soft, ..plain })?;

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
        let name = |axis: &Axis| axis_name(axis.quantity());
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
            (Shade::Column(_), Some(scale)) => {
                self.bar(scale, side)?;
                let missing = picture.count(Class::NotComputed);
                if missing > 0 {
                    let y = top + height * 4 / 5 + self.at(6.2);
                    let colour = of_class(Class::NotComputed, Theme::Light);
                    let share = 100.0 * missing as f64 / picture.grid.len() as f64;
                    self.swatch(side, y, colour, Class::NotComputed.label(), &format!("{share:.1} %"))?;
                }
            }
            (Shade::Column(_), None) => {
                self.swatch(
                    side,
                    top + self.at(1.0),
                    Ink::NoValue.colour(Theme::Light),
                    "no value anywhere",
                    "",
                )?;
            }
            (Shade::Class, _) => {
                let mut y = top + self.at(1.0);
                for class in Class::ALL {
                    let count = picture.count(class);
                    if count > 0 {
                        let share = 100.0 * count as f64 / picture.grid.len() as f64;
                        let share =
                            if share < 0.05 { format!("{count} points") } else { format!("{share:.1} %") };
                        self.swatch(side, y, of_class(class, Theme::Light), class.label(), &share)?;
                        y += self.at(3.2);
                    }
                }
            }
        }
        self.area.present().map_err(PictureError::drawing)
    }

    fn bar(&self, scale: &Scale, side: i32) -> Result<(), PictureError> {
        let Frame { top, height, .. } = self.frame;
        let (wide, tall) = (self.at(1.6), height * 4 / 5);
        let bottom = top + tall;
        for i in 0..tall {
            let colour = of_fraction((f64::from(i) + 0.5) / f64::from(tall));
            let y = bottom - i;
            let strip = Rectangle::new([(side, y - 1), (side + wide, y)], rgb(colour).filled());
            self.area.draw(&strip).map_err(PictureError::drawing)?;
        }
        let plain = Style { size: 1.0, colour: Ink::Ink, bold: false, across: HPos::Left, up: VPos::Center };
        let ticks = ticks::round(scale.low, scale.high, 8);
        for Tick { value, label } in ticks {
            let y = bottom - libm::round(scale.fraction(value) * f64::from(tall)) as i32;
            self.line([(side + wide, y), (side + wide + self.at(0.35), y)])?;
            self.text(&label, side + wide + self.at(0.7), y, plain)?;
        }
        let small = Style { size: 0.85, colour: Ink::Soft, ..plain };
        if scale.beyond[1] {
            self.text("values above: as the top", side, top - self.at(0.9), small)?;
        }
        if scale.beyond[0] {
            self.text("values below: as the bottom", side, bottom + self.at(0.9), small)?;
        }
        self.swatch(side, bottom + self.at(3.0), Ink::NoValue.colour(Theme::Light), "does not happen", "")
    }

    fn swatch(&self, x: i32, y: i32, colour: Rgb, label: &str, share: &str) -> Result<(), PictureError> {
        let (half, wide) = (self.at(0.6), self.at(1.6));
        let corners = [(x, y - half), (x + wide, y + half)];
        self.area.draw(&Rectangle::new(corners, rgb(colour).filled())).map_err(PictureError::drawing)?;
        self.area
            .draw(&Rectangle::new(corners, rgb(Ink::Soft.colour(Theme::Light)).stroke_width(FINE)))
            .map_err(PictureError::drawing)?;
        let plain = Style { size: 1.0, colour: Ink::Ink, bold: false, across: HPos::Left, up: VPos::Center };
        let x = x + wide + self.at(0.6);
        self.text(label, x, y, plain)?;
        self.text(share, x, y + self.at(1.3), Style { size: 0.85, colour: Ink::Soft, ..plain })
    }

    /// A length in letters, in pixels.
    fn at(&self, letters: f64) -> i32 {
        libm::round(letters * self.frame.letter) as i32
    }

    fn line(&self, points: [(i32, i32); 2]) -> Result<(), PictureError> {
        self.area
            .draw(&PathElement::new(points, rgb(Ink::Ink.colour(Theme::Light)).stroke_width(FINE)))
            .map_err(PictureError::drawing)
    }

    fn text(&self, text: &str, x: i32, y: i32, style: Style) -> Result<(), PictureError> {
        // The middle of the box of a letter lies above the middle of the letter.
        let y = if matches!(style.up, VPos::Center) { y + self.at(0.1) } else { y };
        let weight = if style.bold { FontStyle::Bold } else { FontStyle::Normal };
        let font = (FONT, style.size * self.frame.letter, weight).into_font();
        let colour = rgb(style.colour.colour(Theme::Light));
        let text_style = TextStyle::from(font).color(&colour).pos(Pos::new(style.across, style.up));
        self.area.draw(&Text::new(text.to_owned(), (x, y), text_style)).map_err(PictureError::drawing)
    }
}

const fn rgb(Rgb([red, green, blue]): Rgb) -> RGBColor {
    RGBColor(red, green, blue)
}
