//! The plane, the point of contact and the gap.

use littlewood::{Dimension, Position, SampleColumn};

use crate::camera::{GROUND, View};
use crate::canvas::Canvas;
use crate::colour::{self, INK, PAPER, SOFT};
use crate::letters::Style;
use crate::scene::Scene;

/// Closest that marks stand, in units of lettering.
const CLOSEST: f64 = 2.0;

/// The plane with a mark at every radius, or at so many radii that marks can be told apart.
pub(crate) fn draw_plane(canvas: &mut Canvas, view: &View, width: f64, unit: f64) {
    let (_, y) = view.place(Position { x: 0.0, y: 0.0 });
    canvas.rectangle((0.0, y), width, GROUND * unit, colour::GROUND);
    canvas.rectangle((0.0, y), width, (1.4 * unit).max(1.0), INK);
    let style = Style { size: 9.5 * unit, is_bold: false, anchor: 0.5 };
    let (each, between) = steps(view.scale, unit);
    let [first, last] = [view.x_at(0.0), view.x_at(width)].map(|x| x / between);
    let marks = (libm::floor(last) - libm::ceil(first)).min(width / (CLOSEST * unit));
    let mut mark = 0.0;
    while mark <= marks {
        let x = (libm::ceil(first) + mark) * between;
        let (place, _) = view.place(Position { x, y: 0.0 });
        let is_labelled = libm::fmod(x, each) == 0.0;
        let length = if is_labelled { 5.0 } else { 3.0 } * unit;
        canvas.line(&[(place, y), (place, y + length)], unit, INK);
        if is_labelled && place > 8.0 * unit && place < width - 26.0 * unit {
            let words = format!("{}", x as i64).replace('-', "−");
            canvas.words(&words, (place, y + (GROUND - 3.5) * unit), style, SOFT);
        }
        mark += 1.0;
    }
    let end = Style { anchor: 1.0, ..style };
    let place = (width - 4.0 * unit, y + (GROUND - 3.5) * unit);
    let title = format!("{}/{}", SampleColumn::X.sign(), Dimension::Length.scale_sign());
    canvas.words(&title, place, end, SOFT);
}

/// Every how many radii there is room for a number, and for a mark.
fn steps(scale: f64, unit: f64) -> (f64, f64) {
    let (mut each, mut parts) = (1.0, 1.0);
    // One, two, five, ten; marks divide the step of the numbers into fives or halves.
    for (factor, finer) in [(2.0, 2.0), (2.5, 5.0), (2.0, 2.0)].into_iter().cycle() {
        let is_close = each * scale < 30.0 * unit;
        if !is_close {
            break;
        }
        each *= factor;
        parts = finer;
    }
    (each, if scale >= CLOSEST * unit { 1.0 } else { each / parts })
}

/// The point of contact, or the lowest point of the rim over the plane and the gap between them.
pub(crate) fn draw_contact(canvas: &mut Canvas, view: &View, scene: &Scene, gap: &str, unit: f64) {
    let lowest = view.place(scene.lowest);
    if scene.contact.is_some() {
        canvas.disc(lowest, 3.8 * unit, PAPER);
        canvas.disc(lowest, 2.8 * unit, INK);
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
