//! The plane, the point of contact and the gap.

use littlewood::modes::Position;
use littlewood::si::Units;
use littlewood::tables::{Dimension, SampleColumn};
use littlewood_draw::marked;

use crate::camera::{GROUND, View, Window};
use crate::canvas::{Canvas, Place};
use crate::colour::{self, INK, PAPER, SOFT};
use crate::letters::Style;
use crate::pane::{unit_sign, with_unit};
use crate::scene::Scene;

/// Radius of the point of contact, in units of lettering.
pub(crate) const CONTACT: f64 = 2.6;

/// Closest that marks stand, in units of lettering.
const CLOSEST: f64 = 2.0;

/// The plane with a mark at every radius or metre, or at as many of them or such parts that marks
/// can be told apart. The window begins at the left of the picture.
pub(crate) fn draw_plane(
    canvas: &mut Canvas,
    view: &View,
    window: Window,
    unit: f64,
    units: Option<&Units>,
) {
    let seen = view.seen(window);
    if seen[0] > seen[1] {
        // From far above a slope the camera sees one side of it.
        canvas.polygon(&view.under(window), colour::GROUND);
        return;
    }
    let at = |x: f64| view.place(Position { x, y: 0.0 });
    let (thickness, is_level) = ((1.4 * unit).max(1.0), view.tilt.sin == 0.0);
    if is_level {
        let (_, y) = at(0.0);
        canvas.rectangle((0.0, y), window.width, GROUND * unit, colour::GROUND);
        canvas.rectangle((0.0, y), window.width, thickness, INK);
    } else {
        canvas.polygon(&view.under(window), colour::GROUND);
        canvas.line(
            &seen.map(|x| view.moved(at(x), 0.0, 0.5 * thickness)),
            thickness,
            INK,
        );
    }
    let style = Style {
        size: 9.5 * unit,
        is_bold: false,
        anchor: 0.5,
    };
    // One of what is printed, in radii.
    let one = units.map_or(1.0, |units| 1.0 / units.unit(Dimension::Length));
    let (each, between, digits) = steps(view.scale * one, unit);
    let [first, last] = seen.map(|x| x / (one * between));
    let marks = (libm::floor(last) - libm::ceil(first))
        .min(view.scale * (seen[1] - seen[0]) / (CLOSEST * unit));
    // The name of the axis stands at the upper end, the numbers keep away from it.
    let is_named_first = view.tilt.sin < 0.0;
    let margins = if is_named_first {
        [46.0, 8.0]
    } else {
        [8.0, 46.0]
    }
    .map(|pixels| pixels * unit / view.scale);
    let deep = (GROUND - 3.5) * unit;
    let is_inside = |(_, y): Place| is_level || y < window.top + window.height - 2.0 * unit;
    let per_label = libm::round(each / between);
    let mut mark = 0.0;
    while mark <= marks {
        let number = libm::ceil(first) + mark;
        let x = number * between * one;
        let place = at(x);
        let is_labelled = libm::fmod(number, per_label) == 0.0;
        let length = if is_labelled { 5.0 } else { 3.0 } * unit;
        canvas.line(&[place, view.moved(place, 0.0, length)], unit, INK);
        let words_at = view.moved(place, 0.0, deep);
        let has_room = x > seen[0] + margins[0] && x < seen[1] - margins[1] && is_inside(words_at);
        if is_labelled && has_room {
            // Adding zero makes -0 a 0.
            let words = format!("{:.digits$}", number * between + 0.0).replace('-', "−");
            canvas.words(&words, words_at, style, SOFT);
        }
        mark += 1.0;
    }
    let name = with_unit(
        &marked(SampleColumn::X.sign()),
        &unit_sign(units, Dimension::Length),
    );
    if is_level {
        let end = Style {
            anchor: 1.0,
            ..style
        };
        canvas.words(
            &name,
            (window.width - 4.0 * unit, at(0.0).1 + deep),
            end,
            SOFT,
        );
    } else {
        let (end, back) = if is_named_first {
            (seen[0], 24.0)
        } else {
            (seen[1], -24.0)
        };
        let (x, y) = view.moved(at(end), back * unit, deep);
        let beside = 18.0 * unit;
        canvas.words(
            &name,
            (x.clamp(beside, window.width - beside), y),
            style,
            SOFT,
        );
    }
}

/// Every how many units there is room for a number, and for a mark, and with how many decimals the
/// numbers are written, if a unit has so many pixels.
fn steps(scale: f64, unit: f64) -> (f64, f64, usize) {
    let least = 46.0 * unit / scale;
    let mut decade = libm::floor(libm::log10(least)) as i32;
    let power = |decade: i32| {
        if decade < 0 {
            1.0 / libm::exp10(f64::from(-decade))
        } else {
            libm::exp10(f64::from(decade))
        }
    };
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|factor| factor * power(decade) >= least);
    let factor = factor.unwrap_or_else(|| {
        decade += 1;
        1.0
    });
    let each = factor * power(decade);
    // A two is divided into halves, the others into fifths.
    let parts = if factor == 2.0 { 2.0 } else { 5.0 };
    let finer = if each / parts * scale >= 5.0 * unit {
        each / parts
    } else {
        each
    };
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
    let below = view.place(Position {
        y: 0.0,
        ..scene.lowest
    });
    let height = libm::hypot(below.0 - lowest.0, below.1 - lowest.1);
    if height > 3.0 * unit {
        canvas.dashes(&[lowest, below], 1.2 * unit, 2.5 * unit, INK);
    }
    canvas.line(
        &[-5.0, 5.0].map(|along| view.moved(below, along * unit, 0.0)),
        2.4 * unit,
        INK,
    );
    canvas.disc(lowest, 3.0 * unit, INK);
    canvas.disc(lowest, 1.8 * unit, PAPER);
    let style = Style {
        size: 10.5 * unit,
        is_bold: false,
        anchor: 0.0,
    };
    if height > 12.0 * unit {
        let place = (
            0.5 * (lowest.0 + below.0) + 7.0 * unit,
            0.5 * (lowest.1 + below.1) + 4.0 * unit,
        );
        canvas.label(gap, place, style, INK);
    }
}
