//! Modes of motion, directions of slip and of rotation.

use crate::model::named;

named! {
    /// The four modes of motion of the paper, and the two that rolling resistance adds.
    pub enum Mode, "mode of motion" {
        /// η′ = 0, static friction (2.10).
        Rolling = 0, "rolling";
        /// η′ ≠ 0, kinetic friction (2.16).
        Sliding = 1, "sliding";
        /// In contact with N = 0 (3.17).
        Gliding = 2, "gliding";
        /// Off the plane (§2e).
        Flight = 3, "flight";
        /// η′ = θ′ = 0, in the band of rest of rolling resistance.
        Rest = 4, "rest";
        /// η′ ≠ 0 and θ′ = 0: rolling resistance holds the angle while the rim slips.
        Skidding = 5, "skidding";
    }
}

impl Mode {
    /// Whether the rim touches the plane.
    pub const fn touches_plane(self) -> bool {
        match self {
            Self::Rolling | Self::Sliding | Self::Gliding | Self::Rest | Self::Skidding => true,
            Self::Flight => false,
        }
    }

    /// Whether N > 0.
    pub const fn has_normal_force(self) -> bool {
        match self {
            Self::Rolling | Self::Sliding | Self::Rest | Self::Skidding => true,
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

/// Declares the sign of a velocity as an enumeration.
macro_rules! directions {
    ($( $(#[$meta:meta])* $Type:ident, $symbol:literal; )+) => { $(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub enum $Type {
            #[doc = concat!($symbol, " = −1.")]
            Negative,
            #[doc = concat!($symbol, " = +1.")]
            Positive,
        }

        impl $Type {
            /// Both directions.
            pub const ALL: [Self; 2] = [Self::Negative, Self::Positive];

            #[doc = concat!($symbol, " as a number.")]
            pub const fn sign(self) -> f64 {
                match self {
                    Self::Negative => -1.0,
                    Self::Positive => 1.0,
                }
            }

            #[doc = concat!($symbol, " in records; 0 without a direction.")]
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
        }
    )+ };
}

directions! {
    /// Direction of slip, σ = sign(η′).
    SlipDirection, "σ";
    /// Direction of rotation, ς = sign(θ′), against which rolling resistance acts.
    RotationDirection, "ς";
}

impl SlipDirection {
    pub(crate) const fn index(self) -> usize {
        match self {
            Self::Negative => 0,
            Self::Positive => 1,
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
