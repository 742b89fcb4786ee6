//! The energy of the start as a bar of its parts: kinetic, potential, and what has been lost.

use littlewood::energy::EnergyParts;
use littlewood::si::Units;
use littlewood::tables::Dimension;
use littlewood_style::{EnergyPart, Rgb};

use crate::canvas::{Canvas, Place};
use crate::colour::{self, INK, PAPER, SOFT};
use crate::letters::Style;
use crate::pane::unit_sign;

/// Width of the column in which the bar stands with its words, in units of lettering.
pub(crate) const COLUMN: f64 = 118.0;

/// Width of the bar, and how far it stands from the edges of its column.
const WIDTH: f64 = 15.0;
const BESIDE: f64 = 8.0;
const ABOVE: f64 = 14.0;
const BELOW: f64 = 10.0;

/// How strong the colours of what is lost are.
const LOST: f64 = 0.55;

/// What is lost is pale, so that it is told from what is left in grey, too.
fn of_energy(part: EnergyPart) -> Rgb {
    let is_lost = matches!(part, EnergyPart::Friction | EnergyPart::Impacts);
    colour::of_energy(part).over(PAPER, if is_lost { LOST } else { 1.0 })
}

/// What the bar shows: the parts on a scale of energies, in some units.
#[derive(Clone, Copy)]
pub(crate) struct Bar<'a> {
    pub(crate) parts: &'a EnergyParts,
    /// The energies at its lower and at its upper end.
    pub(crate) scale: [f64; 2],
    pub(crate) units: Option<&'a Units>,
}

impl Bar<'_> {
    /// Where an energy stands on the bar: 0 at its lower end, 1 at its upper one.
    fn place(&self, energy: f64) -> f64 {
        let [low, high] = self.scale;
        if high > low {
            (energy - low) / (high - low)
        } else {
            0.0
        }
    }

    /// Where each part begins and ends: the potential energy at its own place on the scale, the
    /// others upon it.
    fn stack(&self) -> [(EnergyPart, [f64; 2]); EnergyPart::ALL.len()] {
        let mut below = 0.0;
        EnergyPart::ALL.map(|part| {
            let value = part.of(self.parts);
            let above = match part {
                EnergyPart::Potential => self.place(value),
                EnergyPart::Kinetic | EnergyPart::Friction | EnergyPart::Impacts => {
                    below + self.place(self.scale[0] + value)
                }
            };
            let from = below;
            below = above.max(from);
            (part, [from, below])
        })
    }

    /// A part in the units of the film, to a hundredth of the scale or finer.
    fn value(&self, part: EnergyPart) -> String {
        let worth = self
            .units
            .map_or(1.0, |units| units.unit(Dimension::Energy));
        let span = worth * (self.scale[1] - self.scale[0]);
        let digits = if span > 0.0 && span.is_finite() {
            (2.0 - libm::floor(libm::log10(span))).clamp(0.0, 12.0) as usize
        } else {
            2
        };
        let text = format!("{:.digits$}", worth * part.of(self.parts));
        match text.strip_prefix('-') {
            Some(zero) if zero.bytes().all(|it| matches!(it, b'0' | b'.')) => zero.to_owned(),
            Some(size) => format!("−{size}"),
            None => text,
        }
    }
}

/// A column of the picture, in pixels.
#[derive(Clone, Copy)]
pub(crate) struct Column {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) bottom: f64,
}

/// The bar in its column; what is lost hangs from the top of what was there at the start.
pub(crate) fn draw_bar(canvas: &mut Canvas, column: Column, bar: &Bar<'_>, unit: f64) {
    let Column { left, top, bottom } = column;
    canvas.rectangle(Place::new(left, top), COLUMN * unit, bottom - top, PAPER);
    let left = left + BESIDE * unit;
    let (top, bottom) = (top + ABOVE * unit, bottom - BELOW * unit);
    let level = |place: f64| bottom - place * (bottom - top);
    let wide = WIDTH * unit;
    for (part, [from, to]) in bar.stack() {
        let height = level(from) - level(to);
        canvas.rectangle(Place::new(left, level(to)), wide, height, of_energy(part));
        if height > 3.0 * unit {
            canvas.rectangle(
                Place::new(left, level(from) - 0.5 * unit),
                wide,
                unit,
                PAPER,
            );
        }
    }
    let mut mark = |place: f64, beyond: f64| {
        canvas.rectangle(
            Place::new(left - beyond * unit, level(place) - 0.6 * unit),
            wide + 2.0 * beyond * unit,
            1.2 * unit,
            INK,
        );
    };
    mark(bar.place(bar.parts.start), 3.0);
    mark(0.0, 3.0);
    let zero = bar.place(0.0);
    if (0.0..=1.0).contains(&zero) {
        mark(zero, 1.0);
        let style = Style {
            size: 9.0 * unit,
            is_bold: false,
            anchor: 1.0,
        };
        canvas.words(
            "0",
            Place::new(left - 1.5 * unit, level(zero) + 3.0 * unit),
            style,
            INK,
        );
    }
    let words = Column {
        left: left + wide + 9.0 * unit,
        top,
        bottom,
    };
    draw_words(canvas, words, bar, unit);
}

/// What the colours mean, from the top of the bar down, each with its value.
fn draw_words(canvas: &mut Canvas, column: Column, bar: &Bar<'_>, unit: f64) {
    let Column { left, top, bottom } = column;
    let style = Style {
        size: 10.0 * unit,
        is_bold: false,
        anchor: 0.0,
    };
    let bold = Style {
        is_bold: true,
        ..style
    };
    let sign = unit_sign(bar.units, Dimension::Energy);
    let each = (bottom - top) / EnergyPart::ALL.len() as f64;
    for (i, part) in EnergyPart::ALL.into_iter().rev().enumerate() {
        let middle = top + (i as f64 + 0.5) * each;
        canvas.rectangle(
            Place::new(left, middle - 11.0 * unit),
            4.0 * unit,
            24.0 * unit,
            of_energy(part),
        );
        let x = left + 8.0 * unit;
        canvas.words(
            part.label(),
            Place::new(x, middle - 2.0 * unit),
            style,
            SOFT,
        );
        let value = format!("{} {sign}", bar.value(part));
        canvas.words(&value, Place::new(x, middle + 11.0 * unit), bold, INK);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARTS: EnergyParts = EnergyParts {
        potential: -0.5,
        kinetic: 1.25,
        friction: 0.003,
        impacts: -0.253,
        start: 0.5,
    };

    /// On a scale from −1 to 1: half of the potential energy's way to zero, kinetic energy from
    /// there to 0.75; what was gained takes no room.
    #[test]
    fn the_parts_stand_at_their_places_on_the_scale() {
        let bar = Bar {
            parts: &PARTS,
            scale: [-1.0, 1.0],
            units: None,
        };
        let [potential, kinetic, friction, impacts] = bar.stack().map(|(_, place)| place);
        assert_eq!((potential, kinetic), ([0.0, 0.25], [0.25, 0.875]));
        assert!((friction[1] - 0.8765).abs() < 1e-12);
        assert_eq!(impacts, [friction[1]; 2]);
        assert_eq!(bar.place(0.0), 0.5);
        let values = EnergyPart::ALL.map(|part| bar.value(part));
        assert_eq!(values, ["−0.50", "1.25", "0.00", "−0.25"]);
    }

    #[test]
    fn a_body_at_rest_has_no_scale_and_no_minus_zero() {
        let parts = EnergyParts {
            potential: 0.0,
            kinetic: -1e-17,
            friction: 0.0,
            impacts: 0.0,
            start: 0.0,
        };
        let bar = Bar {
            parts: &parts,
            scale: [0.0; 2],
            units: None,
        };
        assert_eq!(bar.value(EnergyPart::Kinetic), "0.00");
        assert!(bar.stack().iter().all(|(_, place)| *place == [0.0; 2]));
    }
}
