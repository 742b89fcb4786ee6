//! Where the plane and the body lie in the picture: one scale for both directions.

use littlewood::Trajectory;
use littlewood::modes::Position;

use crate::scene::{ArrowScale, Scene};
use crate::schedule::Schedule;

/// What the picture shows of the path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Framing {
    /// The whole path if the hoop is large all the same, else as `Follow`.
    #[default]
    Auto,
    /// The whole path, however small the hoop is.
    Whole,
    /// The camera follows the mass centre; the whole path is shown in small beside it.
    Follow,
}

/// Thickness of the ground under the plane, in units of lettering.
pub(crate) const GROUND: f64 = 33.0;

/// Space beside and above the path, in radii.
const BESIDE: f64 = 0.25;
const ABOVE: f64 = 0.2;

/// Instants at which the path is examined; it is smooth on their scale.
pub(crate) const EXAMINED: usize = 4000;

/// Smallest radius, in units of lettering, with which `Auto` shows the whole path.
const SMALLEST: f64 = 72.0;

/// Smallest radius of a hoop that is followed: it then goes out of sight of the plane in a very high jump.
const SMALLEST_FOLLOWED: f64 = 48.0;

/// The part of the picture in which the motion is seen, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// How a motion is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Camera {
    window: Window,
    /// Pixels for a radius.
    scale: f64,
    /// Middle of the path.
    middle: f64,
    /// Whether the camera follows the body sideways, and upwards.
    follows: [bool; 2],
}

/// What the camera sees at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct View {
    /// Pixels for a radius.
    pub(crate) scale: f64,
    /// The place of the point (0, 0) in the picture.
    origin: (f64, f64),
}

impl Camera {
    /// A camera for a motion.
    pub(crate) fn new(
        trajectory: &Trajectory,
        schedule: &Schedule,
        framing: Framing,
        mut window: Window,
        unit: f64,
        scale: ArrowScale,
    ) -> Self {
        window.height -= GROUND * unit;
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY, 2.0];
        for sample in trajectory.sample_evenly(EXAMINED, schedule.end()) {
            let [left, right, top] = Scene::of(sample, scale).extent();
            bounds = [bounds[0].min(left), bounds[1].max(right), bounds[2].max(top)];
        }
        let [left, right, top] = bounds;
        let upright = window.height / (top + ABOVE);
        let whole = upright.min(window.width / (right - left + 2.0 * BESIDE));
        let middle = 0.5 * (left + right);
        let largest = window.height / (2.0 + ABOVE);
        let is_whole = match framing {
            Framing::Whole => true,
            Framing::Auto => whole >= SMALLEST * unit,
            Framing::Follow => false,
        };
        if is_whole {
            return Self { window, scale: whole.min(largest), middle, follows: [false; 2] };
        }
        let scale = upright.min(window.width / 5.0).min(largest).max(SMALLEST_FOLLOWED * unit);
        Self { window, scale, middle, follows: [true, scale > upright] }
    }

    /// Whether the view is the same in all frames.
    pub(crate) const fn is_still(&self) -> bool {
        !self.follows[0]
    }

    /// The height of the plane in the picture, where the camera does not rise with the hoop.
    pub(crate) fn floor(&self) -> f64 {
        libm::round(self.window.top + self.window.height)
    }

    /// What the camera sees of a scene.
    pub(crate) fn view(&self, scene: &Scene) -> View {
        let Window { left, top, width, height } = self.window;
        let across = if self.follows[0] { scene.mass_centre.x } else { self.middle };
        let floor = top + height;
        // The plane stays where it is as long as the hoop is in sight.
        let lift = if self.follows[1] {
            let highest = (height / self.scale - ABOVE - 2.0).max(0.0);
            (scene.sample.gap - highest).max(0.0)
        } else {
            0.0
        };
        // Whole pixels, so that what stands still does not flicker.
        let origin_y = libm::round(floor) + lift * self.scale;
        View { scale: self.scale, origin: (left + 0.5 * width - across * self.scale, origin_y) }
    }
}

impl View {
    /// Place of a point in the picture.
    pub(crate) fn place(&self, point: Position) -> (f64, f64) {
        (self.origin.0 + self.scale * point.x, self.origin.1 - self.scale * point.y)
    }

    /// The horizontal coordinate that is seen at a place.
    pub(crate) fn x_at(&self, place: f64) -> f64 {
        (place - self.origin.0) / self.scale
    }
}
