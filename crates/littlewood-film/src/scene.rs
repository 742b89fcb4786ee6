//! What is where at an instant: the body, the contact, the forces, in radii.

use littlewood::impact::{ImpactCase, Impulse};
use littlewood::modes::Position;
use littlewood::{Hoop, Mode, Sample};

use crate::camera::Tilt;
use crate::impacts::ShownImpact;

/// Longest arrow, in radii. A longer one is cut there and drawn with two heads.
const LONGEST: f64 = 1.7;

/// Lengths of arrows for a force equal to the weight (m1 + m2) g, and for the velocity √(gR), in
/// radii: as long as the largest of a motion has room, within these bounds.
const WEIGHT: [f64; 2] = [0.15, 0.6];
const VELOCITY: [f64; 2] = [0.1, 1.0];

/// Length of the largest impulse of a motion, in radii.
const IMPULSE: f64 = 1.3;

/// A vector of length 1; 0 along an arrow that has no length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Part along the plane; in a picture, to the right.
    pub x: f64,
    /// Part away from the plane; in a picture, down.
    pub y: f64,
}

impl Direction {
    const ALONG_PLANE: Self = Self { x: 1.0, y: 0.0 };
    const OFF_PLANE: Self = Self { x: 0.0, y: 1.0 };
}

/// Lengths of arrows: one scale for both forces, so that their sum is the reaction of the plane,
/// and one for the slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrowScale {
    /// Radii for the force m2 g.
    pub force: f64,
    /// The weight (m1 + m2) g, over m2 g.
    pub weight: f64,
    /// Direction of the weight, which on a slope is not normal to the plane.
    pub down: Direction,
    /// Radii for the velocity √(gR).
    pub velocity: f64,
    /// Radii for the impulse m2 √(gR).
    pub impulse: f64,
}

impl ArrowScale {
    /// Scales with which the largest arrow of these instants has room.
    pub(crate) fn fitting(
        hoop: &Hoop,
        samples: impl Iterator<Item = Sample>,
        impacts: &[ShownImpact],
    ) -> Self {
        let (mut force, mut velocity) = (0.0_f64, 0.0_f64);
        for sample in samples.filter(|sample| sample.mode.touches_plane()) {
            force = force.max(sample.normal.abs()).max(sample.friction.abs());
            if sample.state.slip.is_finite() {
                velocity = velocity.max(sample.state.slip.abs());
            }
        }
        let weight = LONGEST * hoop.mass() / force;
        Self {
            force: weight.clamp(WEIGHT[0], WEIGHT[1]) / hoop.mass(),
            weight: hoop.mass(),
            down: Direction {
                x: -libm::sin(hoop.slope()),
                y: -libm::cos(hoop.slope()),
            },
            velocity: (LONGEST / velocity).clamp(VELOCITY[0], VELOCITY[1]),
            impulse: impulse_scale(impacts),
        }
    }
}

fn impulse_scale(impacts: &[ShownImpact]) -> f64 {
    let size = |impulse: Impulse| libm::hypot(impulse.normal, impulse.friction);
    let largest = impacts
        .iter()
        .map(|shown| size(shown.impact.impulse))
        .fold(0.0, f64::max);
    if largest > 0.0 {
        IMPULSE / largest
    } else {
        IMPULSE
    }
}

/// The impulse of an impact as an arrow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnImpulse {
    /// The point of contact.
    pub tail: Position,
    /// Where it ends.
    pub head: Position,
    /// The impulse of the whole impact.
    pub impulse: Impulse,
    /// What the contact point does in the impact.
    pub case: ImpactCase,
}

impl DrawnImpulse {
    pub(crate) fn new(shown: &ShownImpact, scale: ArrowScale) -> Self {
        let impulse = shown.impact.impulse;
        let tail = shown.place;
        let head = Position {
            x: tail.x + scale.impulse * impulse.friction,
            y: tail.y + scale.impulse * impulse.normal,
        };
        Self {
            tail,
            head,
            impulse,
            case: shown.impact.case,
        }
    }
}

/// A vector at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnArrow {
    /// Where it begins.
    pub tail: Position,
    /// Where it ends.
    pub head: Position,
    /// The value that it shows, dimensionless; it may be infinite.
    pub value: f64,
    /// Whether it would be longer than can be shown.
    pub is_cut: bool,
}

impl DrawnArrow {
    /// An arrow along a unit vector, none for a value of zero.
    fn along(direction: Direction, tail: Position, value: f64, scale: f64) -> Option<Self> {
        if value == 0.0 || value.is_nan() {
            return None;
        }
        let wanted = value * scale;
        let length = wanted.clamp(-LONGEST, LONGEST);
        let head = Position {
            x: tail.x + length * direction.x,
            y: tail.y + length * direction.y,
        };
        Some(Self {
            tail,
            head,
            value,
            is_cut: wanted != length,
        })
    }
}

/// An instant of a motion as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene {
    /// Everything about the instant.
    pub sample: Sample,
    /// Lowest point of the rim, below C; in contact it is on the plane, to the last bit.
    pub lowest: Position,
    /// Point of contact X_P; none in flight.
    pub contact: Option<Position>,
    /// Normal force N, from the contact point upwards.
    pub normal: Option<DrawnArrow>,
    /// Friction F, from the contact point along the plane.
    pub friction: Option<DrawnArrow>,
    /// Weight (m1 + m2) g, from the mass centre downwards; on the scale of N and F.
    pub weight: Option<DrawnArrow>,
    /// Slip velocity η′ of the contact point; none in flight.
    pub slip: Option<DrawnArrow>,
    /// Impulse of an impact that is past by no more than a moment.
    pub impulse: Option<DrawnImpulse>,
}

impl Scene {
    /// The scene of an instant. Everything that is drawn is finite: where a gliding particle
    /// reaches θ = ±π, θ′ is infinite, but the body has a place.
    #[must_use]
    pub fn of(sample: Sample, scale: ArrowScale) -> Self {
        let lowest = Position {
            x: sample.centre.x,
            y: sample.gap,
        };
        let contact = sample.mode.touches_plane().then_some(lowest);
        let arrow = |direction, value, scale| DrawnArrow::along(direction, contact?, value, scale);
        Self {
            sample,
            lowest,
            contact,
            normal: arrow(Direction::OFF_PLANE, sample.normal, scale.force),
            friction: arrow(Direction::ALONG_PLANE, sample.friction, scale.force),
            weight: DrawnArrow::along(scale.down, sample.mass_centre, scale.weight, scale.force),
            slip: arrow(Direction::ALONG_PLANE, sample.state.slip, scale.velocity),
            impulse: None,
        }
    }

    /// Time τ.
    pub const fn time(&self) -> f64 {
        self.sample.state.time
    }

    /// Mode of motion.
    pub const fn mode(&self) -> Mode {
        self.sample.mode
    }

    /// Left, right, lower and upper end of what is drawn and of the plane beneath, as a level
    /// camera sees them.
    pub(crate) fn extent(&self, tilt: Tilt) -> [f64; 4] {
        let centre = self.sample.centre;
        let [centre, foot] = [centre, Position { y: 0.0, ..centre }].map(|point| tilt.level(point));
        let mut extent = [
            centre.x - 1.0,
            centre.x + 1.0,
            foot.y.min(centre.y - 1.0),
            centre.y + 1.0,
        ];
        for arrow in [self.normal, self.friction, self.slip]
            .into_iter()
            .flatten()
        {
            let head = tilt.level(arrow.head);
            extent = [
                extent[0].min(head.x),
                extent[1].max(head.x),
                extent[2].min(head.y),
                extent[3].max(head.y),
            ];
        }
        extent
    }
}
