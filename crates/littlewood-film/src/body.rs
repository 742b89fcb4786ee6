//! The hoop with its particle, the trails, and the arrows at the contact point.

use core::f64::consts::PI;

use littlewood::modes::Position;
use littlewood::tables::SampleColumn;
use littlewood::{Hoop, Sample};
use littlewood_draw::marked;

use crate::camera::View;
use crate::canvas::{Canvas, Place};
use crate::colour::{FRICTION_FORCE, IMPULSE, INK, LINE, NORMAL_FORCE, PAPER, SLIP, SOFT, of_mode};
use crate::ground::CONTACT;
use crate::letters::Style;
use crate::scene::{Direction, DrawnArrow, Scene};
use crate::trail::Trail;
use littlewood_style::Rgb;

/// Width of the rim, in radii. Its outer edge is the circle of radius 1.
const RIM: f64 = 0.07;

/// Marks on the rim, so that its rotation is seen.
const MARKS: u32 = 24;

/// Shortest arrow that is drawn, in radii.
const SHORTEST: f64 = 1e-3;

/// The trail of the centre and, in the colour of the mode, that of the mass centre.
pub(crate) fn draw_trail(
    canvas: &mut Canvas,
    view: &View,
    trail: &Trail,
    scene: &Scene,
    unit: f64,
) {
    let pieces = trail.pieces(scene.sample);
    let place = |points: &[Sample], which: fn(&Sample) -> Position| -> Vec<Place> {
        points
            .iter()
            .map(|sample| view.place(which(sample)))
            .collect()
    };
    for (_, steps) in &pieces {
        canvas.line(&place(steps, |step| step.centre), 1.4 * unit, LINE);
    }
    for (mode, steps) in &pieces {
        canvas.line(
            &place(steps, |step| step.mass_centre),
            2.6 * unit,
            of_mode(*mode),
        );
    }
}

/// The whole path of the mass centre, and the hoop where it ends, pale.
pub(crate) fn draw_course(
    canvas: &mut Canvas,
    view: &View,
    course: impl Iterator<Item = Sample>,
    unit: f64,
) {
    let mut last = None;
    let points: Vec<Place> = course
        .map(|sample| {
            last = Some(sample.centre);
            view.place(sample.mass_centre)
        })
        .collect();
    if let Some(centre) = last {
        canvas.ring(view.place(centre), view.scale - 0.5 * unit, unit, LINE);
    }
    canvas.line(&points, 1.4 * unit, LINE);
}

/// Draws the rim, in this colour if one is given, the particle, the mass centre and the geometric
/// centre.
pub(crate) fn draw_body(
    canvas: &mut Canvas,
    view: &View,
    scene: &Scene,
    hoop: &Hoop,
    rim_colour: Option<Rgb>,
    unit: f64,
) {
    let centre = view.place(scene.sample.centre);
    let radius = view.scale;
    let rim = (RIM * radius).max(1.5 * unit);
    canvas.ring(centre, radius - 0.5 * rim, rim, SOFT);
    canvas.ring(
        centre,
        radius - 0.5 * rim,
        (rim - 1.6 * unit).max(1.0),
        rim_colour.unwrap_or(LINE),
    );
    let theta = scene.sample.state.theta + view.tilt.angle;
    for mark in 0..MARKS {
        let angle = theta + 2.0 * PI * f64::from(mark) / f64::from(MARKS);
        let is_long = mark % 6 == 0;
        let inner = radius - rim * if is_long { 2.1 } else { 1.0 };
        let (sin, cos) = libm::sincos(angle);
        let at = |r: f64| centre.shifted(-(r * sin), -(r * cos));
        canvas.line(&[at(inner), at(radius - 0.4 * unit)], 1.1 * unit, SOFT);
    }
    let particle = view.place(scene.sample.particle);
    canvas.line(&[centre, particle], 1.4 * unit, SOFT);
    canvas.disc(centre, 3.0 * unit, SOFT);
    canvas.disc(centre, 1.6 * unit, PAPER);
    if hoop.mass_ratio() > 0.0 {
        draw_mass_centre(canvas, view.place(scene.sample.mass_centre), 4.6 * unit);
    }
    canvas.disc(particle, particle_radius(radius, unit) + unit, PAPER);
    canvas.disc(particle, particle_radius(radius, unit), INK);
}

fn particle_radius(radius: f64, unit: f64) -> f64 {
    (0.095 * radius).clamp(3.5 * unit, 9.0 * unit)
}

/// The sign of a mass centre: a disc with two of its quarters black.
pub(crate) fn draw_mass_centre(canvas: &mut Canvas, centre: Place, radius: f64) {
    canvas.disc(centre, radius, INK);
    canvas.disc(centre, 0.8 * radius, PAPER);
    for (from, to) in [(0.0, 0.5 * PI), (PI, 1.5 * PI)] {
        let mut quarter = vec![centre];
        for i in 0..=8 {
            let (sin, cos) = libm::sincos(from + (to - from) * f64::from(i) / 8.0);
            quarter.push(centre.shifted(0.9 * radius * cos, -(0.9 * radius * sin)));
        }
        canvas.polygon(&quarter, INK);
    }
}

/// The weight, the normal force, the friction and the slip velocity, with their letters. Each has a
/// form of its own, so that they are told apart without colours too.
pub(crate) fn draw_arrows(canvas: &mut Canvas, view: &View, scene: &Scene, unit: f64) {
    let arrows = Arrows { view, scene, unit };
    if let Some(weight) = visible(&scene.weight) {
        arrows.draw_weight(canvas, weight);
    }
    if let Some(slip) = visible(&scene.slip) {
        arrows.draw_slip(canvas, slip);
    }
    if let Some(friction) = visible(&scene.friction) {
        arrows.draw_friction(canvas, friction);
    }
    if let Some(normal) = visible(&scene.normal) {
        arrows.draw_normal(canvas, normal);
    }
}

/// What the arrows of an instant are drawn with.
struct Arrows<'a> {
    view: &'a View,
    scene: &'a Scene,
    /// Pixels of a unit of lettering.
    unit: f64,
}

impl Arrows<'_> {
    const fn style(&self) -> Style {
        Style {
            size: 13.0 * self.unit,
            is_bold: true,
            anchor: 0.5,
        }
    }

    fn draw_weight(&self, canvas: &mut Canvas, weight: &DrawnArrow) {
        let unit = self.unit;
        let (tail, head) = ends(self.view, weight);
        Shape::Open.draw(canvas, tail, head, SOFT, unit);
        // On the side where the normal force is not.
        let side = if weight.tail.x > self.scene.lowest.x {
            11.0
        } else {
            -11.0
        };
        let place = head.shifted(side * unit, -(2.0 * unit));
        canvas.label(WEIGHT, place, self.style(), SOFT);
    }

    fn draw_slip(&self, canvas: &mut Canvas, slip: &DrawnArrow) {
        let unit = self.unit;
        // The slip velocity begins at the contact point, as the friction does; it is drawn lower,
        // so that F does not cover it.
        let lowered = 9.0 * unit;
        let (tail, head) = ends(self.view, slip);
        let [tail, head] = [tail, head].map(|place| self.view.moved(place, 0.0, lowered));
        let shape = Shape::Thin.unless_cut(slip);
        let side = shape.draw(canvas, tail, head, SLIP, unit);
        let place = Place::new(
            head.x + 11.0 * unit * side.x,
            head.y + 4.0 * unit + 11.0 * unit * side.y,
        );
        canvas.label(
            &marked(SampleColumn::Slip.sign()),
            place,
            self.style(),
            SLIP,
        );
    }

    fn draw_friction(&self, canvas: &mut Canvas, friction: &DrawnArrow) {
        let unit = self.unit;
        let (tail, head) = ends(self.view, friction);
        // From the edge of the point of contact, so that a short arrow is seen beside it.
        let beside = (CONTACT + 1.2) * unit * if friction.value < 0.0 { -1.0 } else { 1.0 };
        let [tail, head] = [tail, head].map(|place| self.view.moved(place, beside, 0.0));
        let shape = Shape::Hollow.unless_cut(friction);
        let side = shape.draw(canvas, tail, head, FRICTION_FORCE, unit);
        // Below the plane, where neither the particle nor, on this side, the slip velocity is.
        let beyond = head.shifted(7.0 * unit * side.x, 7.0 * unit * side.y);
        canvas.label(
            &marked(SampleColumn::Friction.sign()),
            self.view.moved(beyond, 0.0, 16.0 * unit),
            self.style(),
            FRICTION_FORCE,
        );
    }

    fn draw_normal(&self, canvas: &mut Canvas, normal: &DrawnArrow) {
        let unit = self.unit;
        let (tail, head) = ends(self.view, normal);
        let shape = Shape::Solid.unless_cut(normal);
        shape.draw(canvas, tail, head, NORMAL_FORCE, unit);
        // On the side where the particle is not.
        let side = if self.scene.sample.particle.x > self.scene.sample.centre.x {
            -11.0
        } else {
            11.0
        };
        let above = head.shifted(0.0, 6.0 * unit);
        canvas.label(
            &marked(SampleColumn::Normal.sign()),
            self.view.moved(above, side * unit, 0.0),
            self.style(),
            NORMAL_FORCE,
        );
    }
}

/// The letter of the weight.
pub(crate) const WEIGHT: &str = "*W*";

/// The form of an arrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A head that is filled, on a strong line: the normal force, impulses.
    Solid,
    /// A head that is empty: the friction.
    Hollow,
    /// A head of two strokes: the weight.
    Open,
    /// A narrow head on a thin line: the slip velocity.
    Thin,
    /// Two heads that are filled: what would be longer than can be shown.
    Cut,
}

impl Shape {
    fn unless_cut(self, arrow: &DrawnArrow) -> Self {
        if arrow.is_cut { Self::Cut } else { self }
    }

    /// Draws an arrow; returns its direction.
    pub(crate) fn draw(
        self,
        canvas: &mut Canvas,
        tail: Place,
        head: Place,
        colour: Rgb,
        unit: f64,
    ) -> Direction {
        let along = Direction {
            x: head.x - tail.x,
            y: head.y - tail.y,
        };
        let length = libm::hypot(along.x, along.y);
        if length == 0.0 {
            return along;
        }
        let arrow = Arrow {
            tail,
            head,
            length,
            direction: Direction {
                x: along.x / length,
                y: along.y / length,
            },
            colour,
            unit,
        };
        match self {
            Self::Solid => arrow.draw_solid(canvas, 1),
            Self::Cut => arrow.draw_solid(canvas, 2),
            Self::Hollow => arrow.draw_hollow(canvas),
            Self::Open => arrow.draw_open(canvas),
            Self::Thin => arrow.draw_thin(canvas),
        }
        arrow.direction
    }
}

/// An arrow of some length in the picture.
struct Arrow {
    tail: Place,
    head: Place,
    length: f64,
    /// From the tail to the head, of length 1.
    direction: Direction,
    colour: Rgb,
    /// Pixels of a unit of lettering.
    unit: f64,
}

impl Arrow {
    /// So far back from the head, and to the side.
    fn at(&self, back: f64, aside: f64) -> Place {
        let Direction { x, y } = self.direction;
        Place::new(
            self.head.x - back * x - aside * y,
            self.head.y - back * y + aside * x,
        )
    }

    /// Length of the tip: this many units of lettering, but no longer than the arrow.
    fn tip(&self, units: f64) -> f64 {
        (units * self.unit).min(self.length)
    }

    /// The line from the tail to a place behind the head, at least so many units of lettering wide.
    fn draw_line(&self, canvas: &mut Canvas, back: f64, width: f64, least: f64) {
        let width = width.max(least * self.unit);
        canvas.line(&[self.tail, self.at(back, 0.0)], width, self.colour);
    }

    fn draw_solid(&self, canvas: &mut Canvas, heads: usize) {
        let tip = self.tip(9.0);
        let half = 0.42 * tip;
        self.draw_line(canvas, 0.8 * tip, 0.3 * tip, 1.2);
        let Direction { x, y } = self.direction;
        for back in [0.0, 0.75 * tip].into_iter().take(heads) {
            let point = self.at(back, 0.0);
            let base = point.shifted(-(tip * x), -(tip * y));
            let side = |half: f64| base.shifted(-(half * y), half * x);
            canvas.polygon(&[point, side(half), side(-half)], self.colour);
        }
    }

    fn draw_hollow(&self, canvas: &mut Canvas) {
        let tip = self.tip(10.5);
        let half = 0.5 * tip;
        self.draw_line(canvas, 0.9 * tip, 0.24 * tip, 1.4);
        let outer = [self.head, self.at(tip, half), self.at(tip, -half)];
        canvas.polygon(&outer, self.colour);
        let inner = [
            self.at(0.27 * tip, 0.0),
            self.at(0.86 * tip, 0.58 * half),
            self.at(0.86 * tip, -0.58 * half),
        ];
        canvas.polygon(&inner, PAPER);
    }

    fn draw_open(&self, canvas: &mut Canvas) {
        let tip = self.tip(8.0);
        let width = 1.8 * self.unit;
        canvas.line(&[self.tail, self.head], width, self.colour);
        let strokes = [
            self.at(tip, 0.55 * tip),
            self.head,
            self.at(tip, -0.55 * tip),
        ];
        canvas.line(&strokes, width, self.colour);
    }

    fn draw_thin(&self, canvas: &mut Canvas) {
        let tip = self.tip(9.0);
        self.draw_line(canvas, 0.8 * tip, 0.16 * tip, 1.2);
        let head = [
            self.head,
            self.at(tip, 0.3 * tip),
            self.at(0.75 * tip, 0.0),
            self.at(tip, -0.3 * tip),
        ];
        canvas.polygon(&head, self.colour);
    }
}

/// The impulse of an impact, with its parts in words.
pub(crate) fn draw_impulse(
    canvas: &mut Canvas,
    view: &View,
    scene: &Scene,
    words: &[String],
    unit: f64,
) {
    let Some(impulse) = scene.impulse else { return };
    let (tail, head) = (view.place(impulse.tail), view.place(impulse.head));
    let length = libm::hypot(head.x - tail.x, head.y - tail.y);
    if length < unit {
        return;
    }
    Shape::Solid.draw(canvas, tail, head, IMPULSE, 1.4 * unit);
    // On the side where the particle is not.
    let (side, anchor) = if scene.sample.particle.x > scene.sample.centre.x {
        (-9.0, 1.0)
    } else {
        (9.0, 0.0)
    };
    let style = Style {
        size: 11.5 * unit,
        is_bold: true,
        anchor,
    };
    for (i, words) in words.iter().enumerate() {
        // Above the plane, however short the arrow is.
        let top = (head.y + 4.0 * unit).min(tail.y - 20.0 * unit);
        let place = Place::new(head.x + side * unit, top + 14.0 * i as f64 * unit);
        canvas.label(words, place, style, IMPULSE);
    }
}

/// An arrow that is longer than a rounding error.
fn visible(arrow: &Option<DrawnArrow>) -> Option<&DrawnArrow> {
    arrow.as_ref().filter(|arrow| {
        (arrow.head.x - arrow.tail.x).abs() + (arrow.head.y - arrow.tail.y).abs() > SHORTEST
    })
}

fn ends(view: &View, arrow: &DrawnArrow) -> (Place, Place) {
    (view.place(arrow.tail), view.place(arrow.head))
}
