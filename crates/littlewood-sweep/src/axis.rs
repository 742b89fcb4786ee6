//! An axis of a sweep: one quantity, evenly spaced.

use core::fmt;

use littlewood::{HoopParameters, Quantity, Start};

use crate::error::AxisError;
use crate::point::Point;

/// A quantity that a sweep can vary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Coordinate {
    /// Angle θ of the particle from the upward vertical, in radians.
    Theta,
    /// Rate θ′, in √(g/R).
    ThetaRate,
    /// Slip velocity η′, in √(gR).
    Slip,
    /// Mass ratio m1/m2.
    MassRatio,
    /// Offset ℓ/R of the particle.
    Offset,
    /// Moment of inertia I_zz/(m2 R²).
    Inertia,
    /// Coefficient of static friction μs.
    MuS,
    /// Coefficient of kinetic friction μk.
    MuK,
}

impl Coordinate {
    /// All coordinates, in the order in which tables have them.
    pub const ALL: [Self; 8] = [
        Self::Theta,
        Self::ThetaRate,
        Self::Slip,
        Self::MassRatio,
        Self::Offset,
        Self::Inertia,
        Self::MuS,
        Self::MuK,
    ];

    /// The quantity of the core, which has its symbol and its unit in plain letters.
    #[must_use]
    pub const fn quantity(self) -> Quantity {
        match self {
            Self::Theta => Quantity::Theta,
            Self::ThetaRate => Quantity::ThetaRate,
            Self::Slip => Quantity::Slip,
            Self::MassRatio => Quantity::MassRatio,
            Self::Offset => Quantity::Offset,
            Self::Inertia => Quantity::Inertia,
            Self::MuS => Quantity::MuS,
            Self::MuK => Quantity::MuK,
        }
    }

    /// Name, as files and the command line write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.quantity().name()
    }

    /// The coordinate of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|coordinate| coordinate.name() == name)
    }

    /// The coordinate of a quantity of the core.
    #[must_use]
    pub fn of(quantity: Quantity) -> Option<Self> {
        Self::ALL.into_iter().find(|coordinate| coordinate.quantity() == quantity)
    }

    /// What it is, in words.
    #[must_use]
    pub const fn long_name(self) -> &'static str {
        match self {
            Self::Theta => "angle of the particle from the upward vertical",
            Self::ThetaRate => "rate of the angle",
            Self::Slip => "slip velocity of the contact point",
            Self::MassRatio => "mass of the disc over mass of the particle",
            Self::Offset => "distance of the particle from the centre over the radius",
            Self::Inertia => "moment of inertia of the disc over m2 R^2",
            Self::MuS => "coefficient of static friction",
            Self::MuK => "coefficient of kinetic friction",
        }
    }

    /// Unit, as files write it; `1` for a ratio.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Theta => "rad",
            Self::ThetaRate => "sqrt(g/R)",
            Self::Slip => "sqrt(g R)",
            Self::MassRatio | Self::Offset | Self::Inertia | Self::MuS | Self::MuK => "1",
        }
    }

    /// Symbol, as pictures write it.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Theta => "θ",
            Self::ThetaRate => "θ′",
            Self::Slip => "η′",
            Self::MassRatio => "m₁/m₂",
            Self::Offset => "ℓ/R",
            Self::Inertia => "I/(m₂R²)",
            Self::MuS => "μₛ",
            Self::MuK => "μₖ",
        }
    }

    /// Whether the hoop depends on it, and not only the start.
    #[must_use]
    pub const fn is_of_the_hoop(self) -> bool {
        !matches!(self, Self::Theta | Self::ThetaRate | Self::Slip)
    }

    /// Its value in a point.
    #[must_use]
    pub const fn of_point(self, point: &Point) -> f64 {
        let Point { hoop, start } = point;
        match self {
            Self::Theta => start.theta,
            Self::ThetaRate => start.theta_rate,
            Self::Slip => start.slip,
            Self::MassRatio => hoop.mass_ratio,
            Self::Offset => hoop.offset,
            Self::Inertia => hoop.inertia,
            Self::MuS => hoop.mu_s,
            Self::MuK => hoop.mu_k,
        }
    }

    /// Sets it in a point.
    pub const fn set(self, point: &mut Point, value: f64) {
        let Point { hoop, start }: &mut Point = point;
        let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = hoop;
        let Start { theta, theta_rate, slip, .. } = start;
        *match self {
            Self::Theta => theta,
            Self::ThetaRate => theta_rate,
            Self::Slip => slip,
            Self::MassRatio => mass_ratio,
            Self::Offset => offset,
            Self::Inertia => inertia,
            Self::MuS => mu_s,
            Self::MuK => mu_k,
        } = value;
    }
}

impl fmt::Display for Coordinate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// An axis: `count` values of one coordinate, evenly spaced, both ends included.
///
/// ```
/// use littlewood_sweep::{Axis, Coordinate};
///
/// let axis = Axis::new(Coordinate::ThetaRate, -4.0, 4.0, 5)?;
/// assert_eq!(axis.values().collect::<Vec<_>>(), [-4.0, -2.0, 0.0, 2.0, 4.0]);
/// # Ok::<(), littlewood_sweep::AxisError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    coordinate: Coordinate,
    from: f64,
    to: f64,
    count: usize,
}

impl Axis {
    /// Checks that the ends are finite, that there is a point, and that several points differ.
    ///
    /// # Errors
    /// Names what is wrong.
    pub fn new(coordinate: Coordinate, from: f64, to: f64, count: usize) -> Result<Self, AxisError> {
        for value in [from, to] {
            if !value.is_finite() {
                return Err(AxisError::NotFinite { coordinate, value });
            }
        }
        match count {
            0 => Err(AxisError::Empty { coordinate }),
            1 if from != to => Err(AxisError::OnePointTwoEnds { coordinate, from, to }),
            2.. if from == to => Err(AxisError::NoExtent { coordinate, from, count }),
            _ if !(to - from).is_finite() => Err(AxisError::NotFinite { coordinate, value: to - from }),
            _ => Ok(Self { coordinate, from, to, count }),
        }
    }

    /// The coordinate.
    #[must_use]
    pub const fn coordinate(&self) -> Coordinate {
        self.coordinate
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
