//! The energy of the start as a bar of its parts: kinetic, potential, and what has been lost.

use littlewood_style::{EnergyPart, EnergyParts, Rgb};

use crate::canvas::Canvas;
use crate::colour::{self, INK, PAPER, SOFT};
use crate::letters::Style;

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

/// The bar as high as `most` has room, in a column by its left end, its upper and its lower edge in
/// pixels; what is lost hangs from the top of what was there at the start.
pub(crate) fn draw_bar(
    canvas: &mut Canvas,
    [left, top, bottom]: [f64; 3],
    parts: &EnergyParts,
    most: f64,
    unit: f64,
) {
    canvas.rectangle((left, top), COLUMN * unit, bottom - top, PAPER);
    let left = left + BESIDE * unit;
    let (top, bottom) = (top + ABOVE * unit, bottom - BELOW * unit);
    let scale = if most > 0.0 {
        (bottom - top) / most
    } else {
        0.0
    };
    let wide = WIDTH * unit;
    let mut from = bottom;
    for part in EnergyPart::ALL {
        let height = scale * parts.part(part).max(0.0);
        canvas.rectangle((left, from - height), wide, height, of_energy(part));
        if height > 3.0 * unit {
            canvas.rectangle((left, from - 0.5 * unit), wide, unit, PAPER);
        }
        from -= height;
    }
    // The energy at the start.
    let level = bottom - scale * parts.start;
    canvas.rectangle(
        (left - 3.0 * unit, level - 0.6 * unit),
        wide + 6.0 * unit,
        1.2 * unit,
        INK,
    );
    canvas.rectangle(
        (left - 3.0 * unit, bottom - 0.6 * unit),
        wide + 6.0 * unit,
        1.2 * unit,
        INK,
    );
    draw_words(canvas, [left + wide + 9.0 * unit, top, bottom], parts, unit);
}

/// What the colours mean, from the top of the bar down, each with its share.
fn draw_words(canvas: &mut Canvas, [left, top, bottom]: [f64; 3], parts: &EnergyParts, unit: f64) {
    let style = Style {
        size: 10.0 * unit,
        is_bold: false,
        anchor: 0.0,
    };
    let share = Style {
        is_bold: true,
        ..style
    };
    let each = (bottom - top) / EnergyPart::ALL.len() as f64;
    for (i, part) in EnergyPart::ALL.into_iter().rev().enumerate() {
        let middle = top + (i as f64 + 0.5) * each;
        canvas.rectangle(
            (left, middle - 11.0 * unit),
            4.0 * unit,
            24.0 * unit,
            of_energy(part),
        );
        let x = left + 8.0 * unit;
        canvas.words(part.label(), (x, middle - 2.0 * unit), style, SOFT);
        canvas.words(&percent(parts, part), (x, middle + 11.0 * unit), share, INK);
    }
}

fn percent(parts: &EnergyParts, part: EnergyPart) -> String {
    if parts.start <= 0.0 {
        return "–".to_owned();
    }
    let value = 100.0 * parts.part(part) / parts.start;
    let rounded = libm::round(value);
    if rounded < 0.0 {
        format!("−{} %", -rounded)
    } else {
        format!("{} %", rounded.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_whole_and_have_a_sign() {
        let parts = EnergyParts {
            kinetic: 0.25,
            potential: 1.5,
            friction: 0.003,
            impacts: -0.1,
            start: 2.0,
        };
        let found = EnergyPart::ALL.map(|part| percent(&parts, part));
        assert_eq!(found, ["13 %", "75 %", "0 %", "−5 %"]);
        assert_eq!(
            percent(
                &EnergyParts {
                    start: 0.0,
                    ..parts
                },
                EnergyPart::Kinetic
            ),
            "–"
        );
    }
}
