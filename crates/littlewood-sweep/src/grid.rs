//! A grid: a base point and axes that vary some of its coordinates.

use core::ops::Range;

use littlewood::{Bound, Engine, Hoop, HoopParameters, Limits, ParameterError, Quantity, Start};

use crate::axis::{Axis, Coordinate};
use crate::error::AxisError;
use crate::point::Point;

/// The points of a grid, numbered row by row: the last axis runs fastest.
///
/// ```
/// use littlewood::{HoopParameters, Start};
/// use littlewood_sweep::{Axis, Coordinate, Grid, Point};
///
/// let base = Point {
///     hoop: HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s: 0.5, mu_k: 0.4 },
///     start: Start::at(0.0, 0.0),
/// };
/// let theta = Axis::new(Coordinate::Theta, -1.0, 1.0, 3)?;
/// let rate = Axis::new(Coordinate::ThetaRate, 0.0, 4.0, 5)?;
/// let grid = Grid::new(base, vec![theta, rate])?;
/// assert_eq!(grid.len(), 15);
/// assert_eq!(grid.point(6).start, Start::at(0.0, 1.0));
/// # Ok::<(), littlewood_sweep::AxisError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    base: Point,
    axes: Vec<Axis>,
    len: u64,
}

impl Grid {
    /// Checks every value that has a meaning of its own: ends of axes, fixed values, and a value on an axis together
    /// with fixed values. Where the fault is in a combination of two axes (μk > μs on a grid of both, say), the points
    /// with that combination have the outcome [`crate::outcome::INVALID`], and the others are computed.
    ///
    /// # Errors
    /// Names the axis, its value and the bound it breaks.
    pub fn new(base: Point, axes: Vec<Axis>) -> Result<Self, AxisError> {
        if axes.is_empty() {
            return Err(AxisError::None);
        }
        let mut len = 1_u64;
        for (i, axis) in axes.iter().enumerate() {
            let coordinate = axis.coordinate();
            if axes[..i].iter().any(|other| other.coordinate() == coordinate) {
                return Err(AxisError::Twice { coordinate });
            }
            len = len
                .checked_mul(axis.count() as u64)
                .filter(|&len| len <= i64::MAX as u64)
                .ok_or(AxisError::TooMany)?;
        }
        let mut base = base;
        for axis in &axes {
            axis.coordinate().set(&mut base, axis.from());
        }
        let grid = Self { base, axes, len };
        grid.check()?;
        Ok(grid)
    }

    /// The base point; where there is an axis it has the first value of the axis.
    #[must_use]
    pub const fn base(&self) -> &Point {
        &self.base
    }

    /// The axes, slowest first.
    #[must_use]
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Number of values on each axis.
    #[must_use]
    pub fn shape(&self) -> Vec<usize> {
        self.axes.iter().map(Axis::count).collect()
    }

    /// Number of points; never zero.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grid is never empty")]
    pub const fn len(&self) -> u64 {
        self.len
    }

    /// The point with a number below [`Grid::len`].
    #[must_use]
    pub fn point(&self, index: u64) -> Point {
        let mut point = self.base;
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            let count = axis.count() as u64;
            let i = usize::try_from(rest % count).unwrap_or(usize::MAX);
            axis.coordinate().set(&mut point, axis.value(i));
            rest /= count;
        }
        point
    }

    /// The points of a range of numbers.
    pub fn points(&self, range: Range<u64>) -> impl Iterator<Item = Point> + '_ {
        range.map(|index| self.point(index))
    }

    /// The point at one place of each axis.
    #[must_use]
    pub fn point_at(&self, indices: &[usize]) -> Point {
        let mut point = self.base;
        for (axis, &i) in self.axes.iter().zip(indices) {
            axis.coordinate().set(&mut point, axis.value(i));
        }
        point
    }

    fn axis(&self, coordinate: Coordinate) -> Option<&Axis> {
        self.axes.iter().find(|axis| axis.coordinate() == coordinate)
    }

    fn check(&self) -> Result<(), AxisError> {
        // Every coordinate alone: bounds are intervals, so the ends of an axis speak for it.
        for coordinate in Coordinate::ALL {
            match self.axis(coordinate) {
                Some(axis) => {
                    for value in [axis.from(), axis.to()] {
                        alone(coordinate, value).map_err(|source| AxisError::Value {
                            coordinate,
                            value,
                            source,
                        })?;
                    }
                }
                None => alone(coordinate, coordinate.of_point(&self.base))?,
            }
        }
        plain(self.base.start)?;
        // Relations between coordinates: with one axis in them the axis is to blame, with none the fixed values.
        for related in [
            &[Coordinate::MuS, Coordinate::MuK][..],
            &[Coordinate::MassRatio, Coordinate::Offset, Coordinate::Inertia],
        ] {
            let mut axes = related.iter().filter_map(|&coordinate| self.axis(coordinate));
            let mut point = Point { hoop: HARMLESS, ..self.base };
            for coordinate in related {
                coordinate.set(&mut point, coordinate.of_point(&self.base));
            }
            match (axes.next(), axes.next()) {
                (None, _) => {
                    Hoop::new(point.hoop)?;
                }
                (Some(axis), None) => {
                    let coordinate = axis.coordinate();
                    for value in axis.values() {
                        coordinate.set(&mut point, value);
                        Hoop::new(point.hoop).map_err(|source| AxisError::Value {
                            coordinate,
                            value,
                            source,
                        })?;
                    }
                }
                (Some(_), Some(_)) => {}
            }
        }
        Ok(())
    }
}

/// A hoop with which every admissible value of one coordinate can be joined.
const HARMLESS: HoopParameters =
    HoopParameters { mass_ratio: 1.0, offset: 0.5, inertia: 1.0, mu_s: 0.5, mu_k: 0.5 };

/// Checks one coordinate by itself.
pub(crate) fn alone(coordinate: Coordinate, value: f64) -> Result<(), ParameterError> {
    let mut point = Point { hoop: HARMLESS, start: Start::at(0.0, 0.0) };
    coordinate.set(&mut point, value);
    match coordinate {
        Coordinate::MuS => point.hoop.mu_k = 0.0,
        Coordinate::MuK if value > point.hoop.mu_s => point.hoop.mu_s = value,
        _ => {}
    }
    Hoop::new(point.hoop)?;
    plain(point.start)
}

/// Checks a start, by a motion that takes no time.
pub(crate) fn plain(start: Start) -> Result<(), ParameterError> {
    let hoop = Hoop::new(HARMLESS)?;
    Engine::new(&hoop).summary(start, Limits { until: Some(start.time), transitions: 0 }).map(|_| ())
}

/// Whether a hoop is refused for a relation between its parameters, each of which is admissible.
pub(crate) const fn is_relation(error: &ParameterError) -> bool {
    matches!(
        error,
        ParameterError::NoMotion { .. }
            | ParameterError::OutOfBounds { quantity: Quantity::MuK, bound: Bound::AtMost(..), .. }
    )
}
