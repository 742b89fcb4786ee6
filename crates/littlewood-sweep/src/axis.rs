//! An axis of a sweep: one quantity, or both coefficients of friction together, evenly spaced or by
//! equal factors.

use core::fmt;

use crate::getters::getters;
use littlewood::ParameterError;
use littlewood::tables::{Dimension, Group, Number, Quantity, Setup};
use thiserror::Error;

/// What an axis varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Varies {
    /// A quantity of [`Quantity::AXES`].
    One(Quantity),
    /// μ = μs = μk.
    Friction,
}

impl Varies {
    /// Lower-case name, as files and flags have it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::One(quantity) => quantity.name(),
            Self::Friction => "mu",
        }
    }

    /// Symbol as it is printed.
    pub const fn sign(self) -> &'static str {
        match self {
            Self::One(quantity) => quantity.sign(),
            Self::Friction => "μ",
        }
    }

    /// What it is, in words.
    pub const fn long_name(self) -> &'static str {
        match self {
            Self::One(quantity) => quantity.row().long_name,
            Self::Friction => "coefficient of static and kinetic friction",
        }
    }

    /// Dimension.
    pub const fn dimension(self) -> Dimension {
        match self {
            Self::One(quantity) => quantity.dimension(),
            Self::Friction => Dimension::Ratio,
        }
    }

    /// The quantities that have the value of the axis.
    pub fn quantities(self) -> impl Iterator<Item = Quantity> {
        let (first, second) = match self {
            Self::One(quantity) => (quantity, None),
            Self::Friction => (Quantity::MuS, Some(Quantity::MuK)),
        };
        core::iter::once(first).chain(second)
    }

    pub(crate) fn set(self, setup: &mut Setup, value: f64) {
        self.quantities()
            .for_each(|quantity| setup.set(quantity, value));
    }
}

impl fmt::Display for Varies {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl From<Quantity> for Varies {
    fn from(quantity: Quantity) -> Self {
        Self::One(quantity)
    }
}

/// How the values of an axis are spaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spacing {
    /// By equal differences.
    #[default]
    Even,
    /// By equal factors.
    Log,
}

impl Spacing {
    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Even => "even",
            Self::Log => "log",
        }
    }
}

/// What is wrong with the axes of a grid.
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum AxisError {
    #[error("a sweep cannot vary {quantity}; axes are {}, {}", names(&Quantity::AXES), Varies::Friction)]
    NotAnAxis { quantity: Quantity },
    /// An end is NaN or infinite, or the ends are farther apart than a double can say.
    #[error("axis {axis}: {} is not a finite number", Number(*value))]
    NotFinite { axis: Varies, value: f64 },
    #[error("axis {axis}: 0 points; at least 1 is needed")]
    Empty { axis: Varies },
    #[error("axis {axis}: 1 point cannot include both ends, {} and {}", Number(*from), Number(*to))]
    OnePointTwoEnds { axis: Varies, from: f64, to: f64 },
    #[error("axis {axis}: {count} points from {} to {} are all the same", Number(*from), Number(*from))]
    NoExtent {
        axis: Varies,
        from: f64,
        count: usize,
    },
    #[error("axis {axis}: equal factors cannot lead from {} to {}", Number(*from), Number(*to))]
    NoFactor { axis: Varies, from: f64, to: f64 },
    #[error("a grid needs at least one axis")]
    None,
    #[error("axis {quantity} is given twice")]
    Twice { quantity: Quantity },
    #[error("the grid has {}{points} points; at most {} can be counted", if *points == u128::MAX { "more than " } else { "" }, i64::MAX)]
    TooMany { points: u128 },
    #[error("axis {quantity}: at {}: {source}", Number(*value))]
    Value {
        quantity: Quantity,
        value: f64,
        source: ParameterError,
    },
    #[error("{0}")]
    Fixed(#[from] ParameterError),
}

/// The names of some quantities, for messages.
pub(crate) fn names(quantities: &[Quantity]) -> String {
    quantities
        .iter()
        .map(|quantity| quantity.name())
        .collect::<Vec<_>>()
        .join(", ")
}

/// An axis: `count` values of one quantity of [`Quantity::AXES`], or of [`Varies::Friction`], both
/// ends included.
///
/// ```
/// use littlewood::tables::Quantity;
/// use littlewood_sweep::{Axis, AxisError, Spacing, Varies};
///
/// let axis = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 5)?;
/// assert_eq!(axis.values().collect::<Vec<_>>(), [-4.0, -2.0, 0.0, 2.0, 4.0]);
/// let friction = Axis::new(Varies::Friction, 0.01, 1.0, 3)?.with_spacing(Spacing::Log)?;
/// assert_eq!(friction.values().collect::<Vec<_>>(), [0.01, 0.1, 1.0]);
/// let error = Axis::new(Quantity::Until, 0.0, 4.0, 5);
/// assert_eq!(error, Err(AxisError::NotAnAxis { quantity: Quantity::Until }));
/// # Ok::<(), AxisError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    varies: Varies,
    from: f64,
    to: f64,
    count: usize,
    spacing: Spacing,
}

getters! {
    Axis:
    /// What it varies.
    varies(self) -> Varies = self.varies;
    /// How its values are spaced.
    spacing(self) -> Spacing = self.spacing;
    /// First value.
    from(self) -> f64 = self.from;
    /// Last value.
    to(self) -> f64 = self.to;
    /// Number of values.
    count(self) -> usize = self.count;
}

impl Axis {
    /// Checks that the quantity can be varied, that the ends are finite, that there is a point, and
    /// that several points differ.
    ///
    /// # Errors
    /// Names what is wrong.
    pub fn new(
        varies: impl Into<Varies>,
        from: f64,
        to: f64,
        count: usize,
    ) -> Result<Self, AxisError> {
        let axis = varies.into();
        if let Varies::One(quantity) = axis
            && !Quantity::AXES.contains(&quantity)
        {
            return Err(AxisError::NotAnAxis { quantity });
        }
        for value in [from, to] {
            if !value.is_finite() {
                return Err(AxisError::NotFinite { axis, value });
            }
        }
        match count {
            0 => Err(AxisError::Empty { axis }),
            1 if from != to => Err(AxisError::OnePointTwoEnds { axis, from, to }),
            2.. if from == to => Err(AxisError::NoExtent { axis, from, count }),
            _ if !(to - from).is_finite() => Err(AxisError::NotFinite {
                axis,
                value: to - from,
            }),
            _ => Ok(Self {
                varies: axis,
                from,
                to,
                count,
                spacing: Spacing::Even,
            }),
        }
    }

    /// The same ends and number of values, spaced otherwise.
    ///
    /// # Errors
    /// Equal factors between numbers of different signs, or from or to 0.
    pub fn with_spacing(self, spacing: Spacing) -> Result<Self, AxisError> {
        let Self {
            varies: axis,
            from,
            to,
            ..
        } = self;
        if spacing == Spacing::Log && !(to / from > 0.0 && (to / from).is_finite()) {
            return Err(AxisError::NoFactor { axis, from, to });
        }
        Ok(Self { spacing, ..self })
    }

    /// Whether its values are hoops, not starts.
    pub(crate) fn is_of_the_hoop(&self) -> bool {
        self.varies
            .quantities()
            .any(|quantity| quantity.group() == Group::Hoop)
    }

    /// Value `i`: from + (to − from)·i/(count − 1), or from·(to/from)^(i/(count − 1)), and the end
    /// itself for the last one and all beyond.
    pub fn value(&self, i: usize) -> f64 {
        let last = self.count - 1;
        if i == 0 {
            self.from
        } else if i >= last {
            self.to
        } else {
            match self.spacing {
                Spacing::Even => self.from + (self.to - self.from) * i as f64 / last as f64,
                Spacing::Log => self.between(i as f64 / last as f64),
            }
        }
    }

    /// The value at a fraction from 0 to 1 of the way from the first to the last.
    pub fn between(&self, fraction: f64) -> f64 {
        match self.spacing {
            Spacing::Even if fraction == 1.0 => self.to,
            Spacing::Even => self.from + (self.to - self.from) * fraction,
            Spacing::Log => self.from * libm::pow(self.to / self.from, fraction),
        }
    }

    /// The fraction of the way at which a value stands; the inverse of [`Axis::between`].
    pub fn fraction(&self, value: f64) -> f64 {
        match self.spacing {
            Spacing::Even => (value - self.from) / (self.to - self.from),
            Spacing::Log => libm::log(value / self.from) / libm::log(self.to / self.from),
        }
    }

    /// All values in order.
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        (0..self.count).map(|i| self.value(i))
    }
}
