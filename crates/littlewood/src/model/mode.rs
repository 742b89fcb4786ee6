//! Modes of motion and directions of slip.

use crate::model::named;

named! {
    /// The four modes of motion of the paper.
    pub enum Mode, "mode of motion" {
        /// η′ = 0, static friction (2.10).
        Rolling = 0, "rolling";
        /// η′ ≠ 0, kinetic friction (2.16).
        Sliding = 1, "sliding";
        /// In contact with N = 0 (3.17).
        Gliding = 2, "gliding";
        /// Off the plane (§2e).
        Flight = 3, "flight";
    }
}

impl Mode {
    /// Whether the rim touches the plane.
    pub const fn touches_plane(self) -> bool {
        match self {
            Self::Rolling | Self::Sliding | Self::Gliding => true,
            Self::Flight => false,
        }
    }

    /// Whether N > 0.
    pub const fn has_normal_force(self) -> bool {
        match self {
            Self::Rolling | Self::Sliding => true,
            Self::Gliding | Self::Flight => false,
        }
    }

    /// The mode with an arrow for the direction of slip, for tables and films: `sliding ←`.
    pub fn with_arrow(self, direction: Option<SlipDirection>) -> String {
        direction.map_or_else(
            || self.to_string(),
            |direction| format!("{self} {}", direction.arrow()),
        )
    }
}

/// Direction of slip, σ = sign(η′).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SlipDirection {
    /// σ = −1.
    Negative,
    /// σ = +1.
    Positive,
}

impl SlipDirection {
    /// Both directions.
    pub const ALL: [Self; 2] = [Self::Negative, Self::Positive];

    /// σ as a number.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Negative => -1.0,
            Self::Positive => 1.0,
        }
    }

    pub(crate) const fn index(self) -> usize {
        match self {
            Self::Negative => 0,
            Self::Positive => 1,
        }
    }

    /// σ in records; 0 without slip.
    pub const fn code(direction: Option<Self>) -> i8 {
        match direction {
            Some(Self::Negative) => -1,
            Some(Self::Positive) => 1,
            None => 0,
        }
    }

    /// The sign of a number; `None` for zero and NaN.
    pub fn of_sign(value: f64) -> Option<Self> {
        if value > 0.0 {
            Some(Self::Positive)
        } else if value < 0.0 {
            Some(Self::Negative)
        } else {
            None
        }
    }

    /// The other direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Positive => Self::Negative,
        }
    }

    /// Arrow in this direction.
    pub const fn arrow(self) -> char {
        match self {
            Self::Negative => '←',
            Self::Positive => '→',
        }
    }
}
