//! A grid: a base setup and axes that vary some of its quantities.

use core::ops::Range;

use littlewood::tables::{DerivativeColumn, Quantity, Setup};
use littlewood::{Hoop, HoopParameters};

use crate::axis::{Axis, AxisError};
use crate::getters::getters;
use crate::regions::Place;
use crate::setup::quantities;

/// The points of a grid, numbered row by row: the last axis runs fastest.
///
/// ```
/// use littlewood::tables::{DerivativeColumn, Quantity, Setup};
/// use littlewood::{HoopParameters, Start};
/// use littlewood_sweep::{Axis, Grid};
///
/// let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
/// let theta = Axis::new(Quantity::Theta, -1.0, 1.0, 3)?;
/// let rate = Axis::new(Quantity::ThetaRate, 0.0, 4.0, 5)?;
/// let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), vec![theta, rate])?;
/// assert_eq!(grid.len(), 15);
/// assert_eq!(grid.point(6).start, Start::at(0.0, 1.0));
/// # Ok::<(), littlewood_sweep::AxisError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    base: Setup,
    axes: Vec<Axis>,
    len: u64,
    derivatives: Vec<DerivativeColumn>,
}

getters! {
    Grid:
    /// The derivatives that are computed.
    derivatives(self) -> &[DerivativeColumn] = self.derivatives.as_slice();
    /// The base setup; where there is an axis it has the first value of the axis.
    base(self) -> &Setup = &self.base;
    /// The axes, slowest first.
    axes(self) -> &[Axis] = self.axes.as_slice();
    /// Number of points; never zero.
    #[expect(clippy::len_without_is_empty, reason = "a grid is never empty")]
    len(self) -> u64 = self.len;
}

impl Grid {
    /// Checks every value that has a meaning of its own: ends of axes, fixed values, and a value on
    /// an axis together with fixed values. Where the fault is in a combination of two axes (μk > μs
    /// on a grid of both, say), the points with that combination have the outcome
    /// [`OutcomeKind::Invalid`](littlewood::OutcomeKind::Invalid), and the others are computed.
    ///
    /// # Errors
    /// Names the axis, its value and the bound it breaks.
    pub fn new(base: Setup, axes: Vec<Axis>) -> Result<Self, AxisError> {
        if axes.is_empty() {
            return Err(AxisError::None);
        }
        let mut points = 1_u128;
        for (i, axis) in axes.iter().enumerate() {
            for quantity in axis.varies().quantities() {
                if axes[..i]
                    .iter()
                    .any(|other| other.varies().quantities().any(|taken| taken == quantity))
                {
                    return Err(AxisError::Twice { quantity });
                }
            }
            points = points.saturating_mul(axis.count() as u128);
        }
        let len = i64::try_from(points)
            .map_err(|_| AxisError::TooMany { points })?
            .unsigned_abs();
        let mut base = base;
        for axis in &axes {
            axis.varies().set(&mut base, axis.from());
        }
        let grid = Self {
            base,
            axes,
            len,
            derivatives: Vec::new(),
        };
        grid.check_each()?;
        for related in CONTRADICTIONS {
            grid.check_together(related)?;
        }
        Ok(grid)
    }

    /// With derivatives of numbers of the summary, which are NaN where they do not exist.
    #[must_use]
    pub fn with_derivatives(mut self, derivatives: Vec<DerivativeColumn>) -> Self {
        self.derivatives = derivatives;
        self
    }

    /// Number of values on each axis.
    pub fn shape(&self) -> Vec<usize> {
        self.axes.iter().map(Axis::count).collect()
    }

    /// Number of starts of each hoop: the points of the axes that are not of the hoop.
    pub(crate) fn starts_of_a_hoop(&self) -> u64 {
        let counts = self.axes.iter().filter(|axis| !axis.is_of_the_hoop());
        counts.map(|axis| axis.count() as u64).product()
    }

    /// The point with a number below [`Grid::len`].
    pub fn point(&self, index: u64) -> Setup {
        let mut point = self.base;
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            let count = axis.count() as u64;
            let i = usize::try_from(rest % count).unwrap_or(usize::MAX);
            axis.varies().set(&mut point, axis.value(i));
            rest /= count;
        }
        point
    }

    /// The points of a range of numbers.
    pub fn points(&self, range: Range<u64>) -> impl Iterator<Item = Setup> + '_ {
        range.map(|index| self.point(index))
    }

    /// The point at these fractions of the way along the axes; axes beyond them have their first
    /// value.
    pub(crate) fn point_between(&self, place: Place) -> Setup {
        let mut point = self.base;
        for (axis, fraction) in self.axes.iter().zip(place) {
            axis.varies().set(&mut point, axis.between(fraction));
        }
        point
    }

    /// The point at one place of each axis.
    pub fn point_at(&self, indices: &[usize]) -> Setup {
        let mut point = self.base;
        for (axis, &i) in self.axes.iter().zip(indices) {
            axis.varies().set(&mut point, axis.value(i));
        }
        point
    }

    /// The axis of a quantity; none where it is fixed.
    pub fn axis(&self, quantity: Quantity) -> Option<&Axis> {
        self.axes
            .iter()
            .find(|axis| axis.varies().quantities().any(|varied| varied == quantity))
    }

    /// The quantities of [`Quantity::AXES`] that have no axis, and a value that does not go without
    /// saying.
    pub(crate) fn fixed(&self) -> impl Iterator<Item = (Quantity, f64)> + '_ {
        let fixed = Quantity::AXES
            .into_iter()
            .filter(|&quantity| self.axis(quantity).is_none());
        fixed.filter_map(|quantity| Some((quantity, self.base.said(quantity)?)))
    }

    /// Checks every quantity alone: bounds are intervals, so checking the ends of an axis checks
    /// all of it.
    fn check_each(&self) -> Result<(), AxisError> {
        for quantity in quantities() {
            match self.axis(quantity) {
                Some(axis) => {
                    for value in [axis.from(), axis.to()] {
                        quantity.check(value).map_err(|source| AxisError::Value {
                            quantity,
                            value,
                            source,
                        })?;
                    }
                }
                None => {
                    if let Some(value) = self.base.get(quantity) {
                        quantity.check(value)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Checks quantities that can contradict each other: with one axis among them its ends, with
    /// none the fixed values. The values that contradict nothing are an interval, so that an axis
    /// between two of them has no others; of an axis that leaves the interval the first value
    /// outside is named.
    fn check_together(&self, related: &[Quantity]) -> Result<(), AxisError> {
        let mut axes = related
            .iter()
            .filter_map(|&quantity| Some((quantity, self.axis(quantity)?)));
        let mut point = Setup {
            hoop: WITHOUT_CONTRADICTION,
            ..self.base
        };
        for &quantity in related {
            if let Some(value) = self.base.get(quantity) {
                point.set(quantity, value);
            }
        }
        match (axes.next(), axes.next()) {
            (None, _) => {
                Hoop::new(point.hoop)?;
            }
            (Some((quantity, axis)), None) => {
                let check = |i: usize| {
                    let value = axis.value(i);
                    let mut point = point;
                    point.set(quantity, value);
                    match Hoop::new(point.hoop) {
                        Ok(_) => Ok(()),
                        Err(source) => Err(AxisError::Value {
                            quantity,
                            value,
                            source,
                        }),
                    }
                };
                check(0)?;
                let last = axis.count() - 1;
                if check(last).is_err() {
                    let (mut inside, mut outside) = (0, last);
                    while outside - inside > 1 {
                        let middle = inside + (outside - inside) / 2;
                        *(if check(middle).is_ok() {
                            &mut inside
                        } else {
                            &mut outside
                        }) = middle;
                    }
                    check(outside)?;
                }
            }
            (Some(_), Some(_)) => {}
        }
        Ok(())
    }
}

/// Quantities that can contradict each other though each is within its bounds: μk > μs, a point
/// mass at the centre, and a massless hoop with restitution.
const CONTRADICTIONS: [&[Quantity]; 2] = [
    &[Quantity::MuS, Quantity::MuK],
    &[
        Quantity::MassRatio,
        Quantity::Offset,
        Quantity::Inertia,
        Quantity::Restitution,
    ],
];

/// A hoop whose other parameters contradict no value of the related ones.
const WITHOUT_CONTRADICTION: HoopParameters = HoopParameters::thin(1.0)
    .with_offset(0.5)
    .with_friction(0.5, 0.5);
