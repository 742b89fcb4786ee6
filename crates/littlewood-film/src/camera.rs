//! Where the plane and the body lie in the picture: one scale for both directions. The camera is
//! level, and sees the slope.

use littlewood::modes::Position;
use littlewood::{Hoop, Sample, Trajectory};

use crate::canvas::Place;
use crate::scene::{ArrowScale, Scene};
use crate::schedule::Schedule;

/// What the picture shows of the path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Framing {
    /// The whole path where it leaves the hoop large enough, else as `follow`
    #[default]
    Auto,
    /// The whole path, however small the hoop is
    Whole,
    /// The camera moves with the mass centre; an inset shows the whole path
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

/// Smallest radius of a hoop that is followed: it then goes out of sight of the plane in a very
/// high jump.
const SMALLEST_FOLLOWED: f64 = 48.0;

/// The part of the picture in which the motion is seen, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// The slope of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tilt {
    pub(crate) angle: f64,
    pub(crate) sin: f64,
    pub(crate) cos: f64,
}

impl Tilt {
    pub(crate) fn of(hoop: &Hoop) -> Self {
        let angle = hoop.slope();
        let (sin, cos) = libm::sincos(angle);
        Self { angle, sin, cos }
    }

    /// How far a point lies to the right of the origin of the plane and above it.
    pub(crate) fn level(self, Position { x, y }: Position) -> Position {
        Position {
            x: x * self.cos - y * self.sin,
            y: x * self.sin + y * self.cos,
        }
    }

    /// How high a hoop in contact reaches down.
    fn base(self, centre: Position) -> f64 {
        self.level(Position { y: 1.0, ..centre }).y - 1.0
    }
}

/// How a motion is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Camera {
    window: Window,
    tilt: Tilt,
    /// Pixels for a radius.
    scale: f64,
    /// Middle of the path, half its width, and its lowest height.
    middle: f64,
    half: f64,
    lowest: f64,
    /// Smallest scale with which the whole path is shown.
    least: f64,
    /// Whether the camera follows the body sideways, and upwards.
    follows: [bool; 2],
}

/// What the camera sees at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct View {
    /// Pixels for a radius.
    pub(crate) scale: f64,
    pub(crate) tilt: Tilt,
    /// The place of the point (0, 0) in the picture.
    pub(crate) origin: Place,
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
        let tilt = Tilt::of(trajectory.hoop());
        let [mut left, mut right] = [f64::INFINITY, f64::NEG_INFINITY];
        let [mut lowest, mut top, mut rise] = [f64::INFINITY, f64::NEG_INFINITY, 2.0_f64];
        for sample in trajectory.sample_evenly(EXAMINED, schedule.end) {
            let [from, to, low, high] = Scene::of(sample, scale).extent(tilt);
            (left, right) = (left.min(from), right.max(to));
            (lowest, top) = (lowest.min(low), top.max(high));
            rise = rise.max(high - tilt.base(sample.centre));
        }
        let fits = |height: f64| window.height / (height + ABOVE);
        let upright = fits(rise);
        let whole = fits(top - lowest).min(window.width / (right - left + 2.0 * BESIDE));
        let middle = 0.5 * (left + right);
        let largest = window.height / (2.0 + ABOVE);
        let is_whole = match framing {
            Framing::Whole => true,
            Framing::Auto => whole >= SMALLEST * unit,
            Framing::Follow => false,
        };
        let least = match framing {
            Framing::Whole | Framing::Follow => 0.0,
            Framing::Auto => SMALLEST * unit,
        };
        let half = 0.5 * (right - left) + BESIDE;
        if is_whole {
            return Self {
                window,
                tilt,
                scale: whole.min(largest),
                middle,
                half,
                lowest,
                least,
                follows: [false; 2],
            };
        }
        let scale = upright
            .min(window.width / 5.0)
            .min(largest)
            .max(SMALLEST_FOLLOWED * unit);
        Self {
            window,
            tilt,
            scale,
            middle,
            half,
            lowest,
            least,
            follows: [true, scale > upright],
        }
    }

    /// Gives cameras one scale, in which all that any of them sees is in sight; their radii have
    /// these lengths. Whether the hoops are large enough.
    pub(crate) fn join(cameras: &mut [Self], lengths: &[f64]) -> bool {
        let all = || cameras.iter().zip(lengths);
        let from = all().map(|(it, length)| length * (it.middle - it.half));
        let to = all().map(|(it, length)| length * (it.middle + it.half));
        let (from, to) = (
            from.fold(f64::INFINITY, f64::min),
            to.fold(f64::NEG_INFINITY, f64::max),
        );
        let scale = |(it, length): (&Self, &f64)| {
            let across = if it.is_still() {
                it.window.width / (to - from)
            } else {
                f64::INFINITY
            };
            (it.scale / length).min(across)
        };
        let scale = all().map(scale).fold(f64::INFINITY, f64::min);
        for (camera, length) in cameras.iter_mut().zip(lengths) {
            camera.scale = scale * length;
            camera.middle = 0.5 * (from + to) / length;
        }
        cameras.iter().all(|camera| camera.scale >= camera.least)
    }

    /// Whether the view is the same in all frames.
    pub(crate) const fn is_still(&self) -> bool {
        !self.follows[0]
    }

    /// What the camera sees of a scene.
    pub(crate) fn view(&self, scene: &Scene) -> View {
        let Window {
            left,
            top,
            width,
            height,
        } = self.window;
        let Sample {
            centre,
            mass_centre,
            ..
        } = scene.sample;
        let [across, base] = if self.follows[0] {
            [
                self.tilt
                    .level(Position {
                        y: centre.y,
                        ..mass_centre
                    })
                    .x,
                self.tilt.base(centre),
            ]
        } else {
            [self.middle, self.lowest]
        };
        let floor = top + height;
        // The plane stays where it is as long as the hoop is in sight.
        let lift = if self.follows[1] {
            let highest = (height / self.scale - ABOVE - 2.0).max(0.0);
            (self.tilt.cos * scene.sample.gap - highest).max(0.0)
        } else {
            0.0
        };
        // Whole pixels, so that what stands still does not flicker.
        let origin_y = libm::round(floor) + (lift + base) * self.scale;
        View {
            scale: self.scale,
            tilt: self.tilt,
            origin: Place::new(left + 0.5 * width - across * self.scale, origin_y),
        }
    }
}

impl View {
    /// Place of a point in the picture.
    pub(crate) fn place(&self, point: Position) -> Place {
        let point = self.tilt.level(point);
        Place::new(
            self.origin.x + self.scale * point.x,
            self.origin.y - self.scale * point.y,
        )
    }

    /// A place so many pixels further along the plane and into it.
    pub(crate) fn moved(&self, place: Place, along: f64, into: f64) -> Place {
        let Tilt { sin, cos, .. } = self.tilt;
        Place::new(
            place.x + along * cos + into * sin,
            place.y - along * sin + into * cos,
        )
    }

    /// Between which x the plane is seen in a window.
    pub(crate) fn seen(&self, window: Window) -> [f64; 2] {
        let Window {
            left,
            top,
            width,
            height,
        } = window;
        let Tilt { sin, cos, .. } = self.tilt;
        let sides = [
            (self.origin.x, self.scale * cos, [left, left + width]),
            (self.origin.y, -self.scale * sin, [top, top + height]),
        ];
        let crossings =
            sides
                .into_iter()
                .filter(|(_, step, _)| *step != 0.0)
                .map(|(origin, step, sides)| {
                    let [a, b] = sides.map(|side| (side - origin) / step);
                    [a.min(b), a.max(b)]
                });
        crossings.fold([f64::NEG_INFINITY, f64::INFINITY], |seen, at| {
            [seen[0].max(at[0]), seen[1].min(at[1])]
        })
    }

    /// The corners of what lies under the plane in a window.
    pub(crate) fn under(&self, window: Window) -> Vec<Place> {
        let Window {
            left,
            top,
            width,
            height,
        } = window;
        let corners = [
            Place::new(left, top),
            Place::new(left + width, top),
            Place::new(left + width, top + height),
            Place::new(left, top + height),
        ];
        let depth = |corner: Place| {
            (corner.x - self.origin.x) * self.tilt.sin + (corner.y - self.origin.y) * self.tilt.cos
        };
        let mut under = Vec::new();
        for (i, corner) in corners.into_iter().enumerate() {
            let next = corners[(i + 1) % corners.len()];
            let [here, there] = [corner, next].map(depth);
            if here > 0.0 {
                under.push(corner);
            }
            if (here > 0.0) != (there > 0.0) {
                let share = here / (here - there);
                under.push(Place::new(
                    corner.x + share * (next.x - corner.x),
                    corner.y + share * (next.y - corner.y),
                ));
            }
        }
        under
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is drawn of a force on a slope: the weight points downwards, the reaction of the plane
    /// of a hoop at rest upwards.
    #[test]
    fn the_weight_is_vertical_in_the_picture() {
        for slope in [0.0, 0.4, -0.4, 1.5] {
            let parameters = littlewood::HoopParameters::thin(1.0)
                .with_friction(20.0, 20.0)
                .with_slope(slope);
            let hoop = Hoop::new(parameters).expect("a hoop");
            let plane = littlewood::theory::PhasePlane::new(&hoop);
            // Where there is no equilibrium only the weight is looked at.
            let rest = plane
                .equilibria()
                .first()
                .map(|equilibrium| equilibrium.theta);
            let start = littlewood::Start::at(rest.unwrap_or(1.0), 0.0);
            let limits = littlewood::Limits::default().with_until(Some(1e-3));
            let motion = hoop.simulate(start, limits).expect("a motion");
            let sample = motion.at(0.0).expect("an instant");
            let scale = ArrowScale::fitting(&hoop, core::iter::once(sample), &[]);
            let scene = Scene::of(sample, scale);
            let view = View {
                scale: 100.0,
                tilt: Tilt::of(&hoop),
                origin: Place::new(320.0, 300.0),
            };
            let weight = scene.weight.expect("an arrow");
            let [tail, head] = [weight.tail, weight.head].map(|end| view.place(end));
            assert!(
                (head.x - tail.x).abs() < 1e-11 && head.y > tail.y + 10.0,
                "{slope}: {tail:?} {head:?}"
            );
            if rest.is_some() {
                let ends = |arrow: Option<crate::scene::DrawnArrow>| {
                    arrow.map_or(Place::new(0.0, 0.0), |arrow| {
                        let [tail, head] = [arrow.tail, arrow.head].map(|end| view.place(end));
                        head.shifted(-tail.x, -tail.y)
                    })
                };
                let (normal, friction) = (ends(scene.normal), ends(scene.friction));
                let sum = normal.shifted(friction.x, friction.y);
                assert!(
                    sum.x.abs() < 1e-9 && (sum.y + (head.y - tail.y)).abs() < 1e-9,
                    "{slope}: {sum:?}"
                );
            }
        }
    }
}
