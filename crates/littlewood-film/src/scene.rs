//! What is where at an instant: the body, the contact, the forces, in radii.

use littlewood::{Direction, Hoop, Mode, Point, Sample};

/// Length of an arrow for a force equal to the weight (m1 + m2) g, in radii.
const WEIGHT: f64 = 0.5;

/// Length of an arrow for the velocity √(gR), in radii.
const VELOCITY: f64 = 0.5;

/// Longest arrow, in radii. A longer one is cut there and drawn with two heads.
const LONGEST: f64 = 1.6;

/// A vector at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// Where it begins.
    pub tail: Point,
    /// Where it ends.
    pub head: Point,
    /// The value that it shows, dimensionless; it may be infinite.
    pub value: f64,
    /// Whether it would be longer than can be shown.
    pub is_cut: bool,
}

impl Arrow {
    /// An arrow along the unit vector (x, y), none for a value of zero.
    fn along((x, y): (f64, f64), tail: Point, value: f64, scale: f64) -> Option<Self> {
        if value == 0.0 || value.is_nan() {
            return None;
        }
        let wanted = value * scale;
        let length = wanted.clamp(-LONGEST, LONGEST);
        let head = Point { x: tail.x + length * x, y: tail.y + length * y };
        Some(Self { tail, head, value, is_cut: wanted != length })
    }
}

/// An instant of a motion as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene {
    /// Everything about the instant.
    pub sample: Sample,
    /// Geometric centre C.
    pub centre: Point,
    /// Particle, at ℓ̂ from C.
    pub particle: Point,
    /// Mass centre X̄, at h from C.
    pub mass_centre: Point,
    /// Lowest point of the rim, below C; in contact it is on the plane, to the last bit.
    pub lowest: Point,
    /// Point of contact X_P; none in flight.
    pub contact: Option<Point>,
    /// Normal force N, from the contact point upwards.
    pub normal: Option<Arrow>,
    /// Friction F, from the contact point along the plane.
    pub friction: Option<Arrow>,
    /// Slip velocity η′ of the contact point; none in flight.
    pub slip: Option<Arrow>,
}

impl Scene {
    /// The scene of an instant. Everything that is drawn is finite: where a gliding particle reaches θ = ±π, θ′ is
    /// infinite, but the body has a place.
    #[must_use]
    pub fn of(hoop: &Hoop, sample: Sample) -> Self {
        let centre = sample.centre();
        let lowest = Point { x: centre.x, y: sample.gap };
        let contact = (sample.mode != Mode::Flight).then_some(lowest);
        let force = WEIGHT / hoop.mass();
        let arrow = |direction, value, scale| Arrow::along(direction, contact?, value, scale);
        Self {
            sample,
            centre,
            particle: sample.particle(hoop),
            mass_centre: sample.mass_centre(hoop),
            lowest,
            contact,
            normal: arrow((0.0, 1.0), sample.normal, force),
            friction: arrow((1.0, 0.0), sample.friction, force),
            slip: arrow((1.0, 0.0), sample.state.slip, VELOCITY),
        }
    }

    /// Time τ.
    #[must_use]
    pub const fn time(&self) -> f64 {
        self.sample.state.time
    }

    /// Mode of motion.
    #[must_use]
    pub const fn mode(&self) -> Mode {
        self.sample.mode
    }

    /// The mode in words, with the direction of slip.
    #[must_use]
    pub fn caption(&self) -> String {
        caption(self.sample.mode, self.sample.direction)
    }

    /// Left, right and upper end of what is drawn.
    pub(crate) fn extent(&self) -> [f64; 3] {
        let mut extent = [self.centre.x - 1.0, self.centre.x + 1.0, self.centre.y + 1.0];
        for arrow in [self.normal, self.friction, self.slip].into_iter().flatten() {
            extent[0] = extent[0].min(arrow.head.x);
            extent[1] = extent[1].max(arrow.head.x);
            extent[2] = extent[2].max(arrow.head.y);
        }
        extent
    }
}

/// A mode in words, with the direction of slip.
pub(crate) fn caption(mode: Mode, direction: Option<Direction>) -> String {
    let arrow = match direction {
        Some(Direction::Negative) => " ←",
        Some(Direction::Positive) => " →",
        None => "",
    };
    format!("{mode}{arrow}")
}
