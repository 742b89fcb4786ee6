//! The plane, the point of contact and the gap.

use littlewood::modes::Position;
use littlewood::si::Units;
use littlewood::tables::{Dimension, SampleColumn};
use littlewood_draw::marked;

use crate::camera::{GROUND, View};
use crate::canvas::Canvas;
use crate::colour::{self, INK, PAPER, SOFT};
use crate::letters::Style;
use crate::pane::{unit_sign, with_unit};
use crate::scene::Scene;

/// Radius of the point of contact, in units of lettering.
pub(crate) const CONTACT: f64 = 2.6;

/// Closest that marks stand, in units of lettering.
const CLOSEST: f64 = 2.0;

/// The plane with a mark at every radius or metre, or at as many of them or such parts that marks can be told apart.
/// `width` is that of the window, which begins at the left of the picture.
pub(crate) fn draw_plane(canvas: &mut Canvas, view: &View, width: f64, unit: f64, units: Option<&Units>) {
    let (_, y) = view.place(Position { x: 0.0, y: 0.0 });
    canvas.rectangle((0.0, y), width, GROUND * unit, colour::GROUND);
    canvas.rectangle((0.0, y), width, (1.4 * unit).max(1.0), INK);
    let style = Style { size: 9.5 * unit, is_bold: false, anchor: 0.5 };
    // One of what is printed, in radii.
    let one = units.map_or(1.0, |units| 1.0 / units.unit(Dimension::Length));
    let (each, between, digits) = steps(view.scale * one, unit);
    let [first, last] = [view.x_at(0.0), view.x_at(width)].map(|x| x / (one * between));
    let marks = (libm::floor(last) - libm::ceil(first)).min(width / (CLOSEST * unit));
    let per_label = libm::round(each / between);
    let mut mark = 0.0;
    while mark <= marks {
        let number = libm::ceil(first) + mark;
        let (place, _) = view.place(Position { x: number * between * one, y: 0.0 });
        let is_labelled = libm::fmod(number, per_label) == 0.0;
        let length = if is_labelled { 5.0 } else { 3.0 } * unit;
        canvas.line(&[(place, y), (place, y + length)], unit, INK);
        if is_labelled && place > 8.0 * unit && place < width - 46.0 * unit {
            // Adding zero makes -0 a 0.
            let words = format!("{:.digits$}", number * between + 0.0).replace('-', "−");
            canvas.words(&words, (place, y + (GROUND - 3.5) * unit), style, SOFT);
        }
        mark += 1.0;
    }
    let end = Style { anchor: 1.0, ..style };
    let place = (width - 4.0 * unit, y + (GROUND - 3.5) * unit);
    let length = Dimension::Length;
    let sign = marked(SampleColumn::X.sign());
    canvas.words(&with_unit(&sign, &unit_sign(units, length)), place, end, SOFT);
}

/// Every how many units there is room for a number, and for a mark, and with how many decimals the numbers are written,
/// if a unit has so many pixels.
fn steps(scale: f64, unit: f64) -> (f64, f64, usize) {
    let least = 46.0 * unit / scale;
    let mut decade = libm::floor(libm::log10(least)) as i32;
    let power = |decade: i32| {
        if decade < 0 { 1.0 / libm::exp10(f64::from(-decade)) } else { libm::exp10(f64::from(decade)) }
    };
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power(decade) >= least);
    let factor = factor.unwrap_or_else(|| {
        decade += 1;
        1.0
    });
    let each = factor * power(decade);
    // A two is divided into halves, the others into fifths.
    let parts = if factor == 2.0 { 2.0 } else { 5.0 };
    let finer = if each / parts * scale >= 5.0 * unit { each / parts } else { each };
    (each, finer, usize::try_from(-decade).unwrap_or(0))
}

/// The point of contact, or the lowest point of the rim over the plane and the gap between them.
pub(crate) fn draw_contact(canvas: &mut Canvas, view: &View, scene: &Scene, gap: &str, unit: f64) {
    let lowest = view.place(scene.lowest);
    if scene.contact.is_some() {
        canvas.disc(lowest, CONTACT * unit + unit, PAPER);
        canvas.disc(lowest, CONTACT * unit, INK);
        return;
    }
    let below = view.place(Position { y: 0.0, ..scene.lowest });
    let height = below.1 - lowest.1;
    if height > 3.0 * unit {
        canvas.dashes(&[lowest, below], 1.2 * unit, 2.5 * unit, INK);
    }
    canvas.line(&[(below.0 - 5.0 * unit, below.1), (below.0 + 5.0 * unit, below.1)], 2.4 * unit, INK);
    canvas.disc(lowest, 3.0 * unit, INK);
    canvas.disc(lowest, 1.8 * unit, PAPER);
    let style = Style { size: 10.5 * unit, is_bold: false, anchor: 0.0 };
    if height > 12.0 * unit {
        let place = (lowest.0 + 7.0 * unit, 0.5 * (lowest.1 + below.1) + 4.0 * unit);
        canvas.label(gap, place, style, INK);
    }
}
