//! An axis of a sweep: one quantity, evenly spaced.

use littlewood::{Group, ParameterError, Quantity};
use thiserror::Error;

/// What is wrong with the axes of a grid.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AxisError {
    /// A quantity that no motion depends on, or a number in SI units.
    #[error("a sweep cannot vary {quantity}; axes are {}", names(&Quantity::AXES))]
    NotAnAxis {
        /// The quantity.
        quantity: Quantity,
    },
    /// An end is NaN or infinite, or the ends are farther apart than a double can say.
    #[error("axis {quantity}: {value} is not a finite number")]
    NotFinite {
        /// The quantity.
        quantity: Quantity,
        /// The end, or the distance of the ends.
        value: f64,
    },
    /// No points.
    #[error("axis {quantity}: 0 points; at least 1 is needed")]
    Empty {
        /// The quantity.
        quantity: Quantity,
    },
    /// One point cannot have two ends.
    #[error("axis {quantity}: 1 point cannot include both ends, {from} and {to}")]
    OnePointTwoEnds {
        /// The quantity.
        quantity: Quantity,
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
    },
    /// Many points at one value.
    #[error("axis {quantity}: {count} points from {from} to {from} are all the same")]
    NoExtent {
        /// The quantity.
        quantity: Quantity,
        /// The value.
        from: f64,
        /// Number of points.
        count: usize,
    },
    /// No axis at all.
    #[error("a grid needs at least one axis")]
    None,
    /// Two axes of the same quantity.
    #[error("axis {quantity} is given twice")]
    Twice {
        /// The quantity.
        quantity: Quantity,
    },
    /// More points than 2⁶³.
    #[error("the grid has more points than can be counted")]
    TooMany,
    /// A value on an axis has no physical meaning, whatever the other axes say.
    #[error("axis {quantity}: at {value}: {source}")]
    Value {
        /// The quantity.
        quantity: Quantity,
        /// The value on the axis.
        value: f64,
        /// The bound it breaks.
        source: ParameterError,
    },
    /// A fixed value has no physical meaning.
    #[error("{0}")]
    Fixed(#[from] ParameterError),
}

/// The names of some quantities, for messages.
pub(crate) fn names(quantities: &[Quantity]) -> String {
    quantities.iter().map(|quantity| quantity.name()).collect::<Vec<_>>().join(", ")
}

/// An axis: `count` values of one quantity of [`Quantity::AXES`], evenly spaced, both ends included.
///
/// ```
/// use littlewood::Quantity;
/// use littlewood_sweep::{Axis, AxisError};
///
/// let axis = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 5)?;
/// assert_eq!(axis.values().collect::<Vec<_>>(), [-4.0, -2.0, 0.0, 2.0, 4.0]);
/// let error = Axis::new(Quantity::Until, 0.0, 4.0, 5);
/// assert_eq!(error, Err(AxisError::NotAnAxis { quantity: Quantity::Until }));
/// # Ok::<(), AxisError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    quantity: Quantity,
    from: f64,
    to: f64,
    count: usize,
}

impl Axis {
    /// Checks that the quantity can be varied, that the ends are finite, that there is a point, and that several points
    /// differ.
    ///
    /// # Errors
    /// Names what is wrong.
    pub fn new(quantity: Quantity, from: f64, to: f64, count: usize) -> Result<Self, AxisError> {
        if !Quantity::AXES.contains(&quantity) {
            return Err(AxisError::NotAnAxis { quantity });
        }
        for value in [from, to] {
            if !value.is_finite() {
                return Err(AxisError::NotFinite { quantity, value });
            }
        }
        match count {
            0 => Err(AxisError::Empty { quantity }),
            1 if from != to => Err(AxisError::OnePointTwoEnds { quantity, from, to }),
            2.. if from == to => Err(AxisError::NoExtent { quantity, from, count }),
            _ if !(to - from).is_finite() => Err(AxisError::NotFinite { quantity, value: to - from }),
            _ => Ok(Self { quantity, from, to, count }),
        }
    }

    /// The quantity.
    #[must_use]
    pub const fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Whether its values are hoops, not starts.
    pub(crate) fn is_of_the_hoop(&self) -> bool {
        self.quantity.group() == Group::Hoop
    }

    /// First value.
    #[must_use]
    pub const fn from(&self) -> f64 {
        self.from
    }

    /// Last value.
    #[must_use]
    pub const fn to(&self) -> f64 {
        self.to
    }

    /// Number of values.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Value `i`: from + (to − from)·i/(count − 1), and the end itself for the last one and all beyond.
    #[must_use]
    pub fn value(&self, i: usize) -> f64 {
        let last = self.count - 1;
        if i == 0 {
            self.from
        } else if i >= last {
            self.to
        } else {
            self.from + (self.to - self.from) * i as f64 / last as f64
        }
    }

    /// All values in order.
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        (0..self.count).map(|i| self.value(i))
    }
}
