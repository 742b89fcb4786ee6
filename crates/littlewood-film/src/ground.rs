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
    let shown = view.seen(window);
    if shown[0] > shown[1] {
        // From far above a slope the camera sees one side of it.
        canvas.polygon(&view.under(window), colour::GROUND);
        return;
    }
    let plane = Plane {
        view,
        window,
        unit,
        units,
        shown,
    };
    plane.draw_surface(canvas);
    plane.draw_marks(canvas);
    plane.draw_name(canvas);
}

/// The part of the plane in the window.
struct Plane<'a> {
    view: &'a View,
    window: Window,
    /// Pixels of a unit of lettering.
    unit: f64,
    units: Option<&'a Units>,
    /// The ends of the plane in the window, in radii.
    shown: [f64; 2],
}

impl Plane<'_> {
    fn at(&self, x: f64) -> Place {
        self.view.place(Position { x, y: 0.0 })
    }

    fn is_level(&self) -> bool {
        self.view.tilt.sin == 0.0
    }

    /// The name of the axis stands at the upper end of the plane.
    fn is_named_first(&self) -> bool {
        self.view.tilt.sin < 0.0
    }

    /// How far below the plane letters stand.
    fn depth_of_letters(&self) -> f64 {
        (GROUND - 3.5) * self.unit
    }

    const fn style(&self) -> Style {
        Style {
            size: 9.5 * self.unit,
            is_bold: false,
            anchor: 0.5,
        }
    }

    fn draw_surface(&self, canvas: &mut Canvas) {
        let thickness = (1.4 * self.unit).max(1.0);
        if self.is_level() {
            let corner = Place::new(0.0, self.at(0.0).y);
            let width = self.window.width;
            canvas.rectangle(corner, width, GROUND * self.unit, colour::GROUND);
            canvas.rectangle(corner, width, thickness, INK);
        } else {
            canvas.polygon(&self.view.under(self.window), colour::GROUND);
            let ends = self.shown.map(|x| self.at(x));
            let middle = ends.map(|end| self.view.moved(end, 0.0, 0.5 * thickness));
            canvas.line(&middle, thickness, INK);
        }
    }

    fn draw_marks(&self, canvas: &mut Canvas) {
        let Self { view, unit, .. } = *self;
        // One of what is printed, in radii.
        let one = self
            .units
            .map_or(1.0, |units| 1.0 / units.unit(Dimension::Length));
        let steps = Steps::new(view.scale * one, unit);
        let [first, last] = self.shown.map(|x| x / (one * steps.mark));
        let marks = (libm::floor(last) - libm::ceil(first))
            .min(view.scale * (self.shown[1] - self.shown[0]) / (CLOSEST * unit));
        let marks_to_a_number = libm::round(steps.number / steps.mark);
        let mut mark = 0.0;
        while mark <= marks {
            let index = libm::ceil(first) + mark;
            let x = index * steps.mark * one;
            let place = self.at(x);
            let is_numbered = libm::fmod(index, marks_to_a_number) == 0.0;
            let length = if is_numbered { 5.0 } else { 3.0 } * unit;
            canvas.line(&[place, view.moved(place, 0.0, length)], unit, INK);
            let words_at = view.moved(place, 0.0, self.depth_of_letters());
            if is_numbered && self.has_room_for_number(x, words_at) {
                // Adding zero makes -0 a 0.
                let words = format!("{:.*}", steps.decimals, index * steps.mark + 0.0);
                canvas.words(&words.replace('-', "−"), words_at, self.style(), SOFT);
            }
            mark += 1.0;
        }
    }

    /// Numbers keep away from the ends of the plane, from the name of the axis most, and from the
    /// lower edge of the window.
    fn has_room_for_number(&self, x: f64, words_at: Place) -> bool {
        let margins = if self.is_named_first() {
            [46.0, 8.0]
        } else {
            [8.0, 46.0]
        }
        .map(|pixels| pixels * self.unit / self.view.scale);
        let bottom = self.window.top + self.window.height - 2.0 * self.unit;
        x > self.shown[0] + margins[0]
            && x < self.shown[1] - margins[1]
            && (self.is_level() || words_at.y < bottom)
    }

    /// The name of the axis, with its unit.
    fn draw_name(&self, canvas: &mut Canvas) {
        let Self { view, unit, .. } = *self;
        let name = with_unit(
            &marked(SampleColumn::X.sign()),
            &unit_sign(self.units, Dimension::Length),
        );
        let deep = self.depth_of_letters();
        if self.is_level() {
            let end = Style {
                anchor: 1.0,
                ..self.style()
            };
            let place = Place::new(self.window.width - 4.0 * unit, self.at(0.0).y + deep);
            canvas.words(&name, place, end, SOFT);
        } else {
            let (end, back) = if self.is_named_first() {
                (self.shown[0], 24.0)
            } else {
                (self.shown[1], -24.0)
            };
            let mut place = view.moved(self.at(end), back * unit, deep);
            let beside = 18.0 * unit;
            place.x = place.x.clamp(beside, self.window.width - beside);
            canvas.words(&name, place, self.style(), SOFT);
        }
    }
}

/// Distances along the plane, in the unit that is printed.
struct Steps {
    /// From one number to the next.
    number: f64,
    /// From one mark to the next.
    mark: f64,
    /// Decimals of the numbers.
    decimals: usize,
}

impl Steps {
    /// The shortest for which there is room, if a printed unit has so many pixels.
    fn new(scale: f64, unit: f64) -> Self {
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
        Self {
            number: each,
            mark: finer,
            decimals: usize::try_from(-decade).unwrap_or(0),
        }
    }
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
    let height = libm::hypot(below.x - lowest.x, below.y - lowest.y);
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
        let place = Place::new(
            0.5 * (lowest.x + below.x) + 7.0 * unit,
            0.5 * (lowest.y + below.y) + 4.0 * unit,
        );
        canvas.label(gap, place, style, INK);
    }
}
