//! Why a motion is unresolved: the number on which it depends, and the bound that this number does
//! not exceed, or exceeds.

use crate::model::{Detail, Dimension, Quantity, named};

named! {
    /// A number whose sign or size decides how a motion goes on, and which may be rounding.
    pub enum Margin, "margin",
    /// Name in sentences, and dimension.
    row: (&'static str, Dimension) {
        /// P of a slide, or of the slip in an impact.
        Painleve = 0, "painleve" => ("P", Dimension::Ratio);
        /// η′ of a slide in the limit P = 0.
        SlipAtSingularity = 1, "slip_at_singularity" => ("η′ in the limit P = 0", Dimension::Velocity);
        /// w of a slide in the limit P = 0, without its regular part.
        ContactAtSingularity = 2, "contact_at_singularity" => ("w next to P = 0", Dimension::Ratio);
        /// The time in which a slide changes, against the last digit of τ.
        TimeScale = 3, "time_scale" => ("the time in which the slide changes", Dimension::Time);
        /// The gap rate after an impact, against the smallest number with all digits.
        GapRate = 4, "gap_rate_after_impact" => ("the gap rate after the impact", Dimension::Velocity);
        /// |B|/A − μs where slip ends in an impact: the friction that a stick needs, less what there is.
        ImpactFriction = 5, "impact_friction" => (
            "|B|/A − μs where the slip of the impact ends",
            Dimension::Ratio
        );
        /// D_χ of rolling with resistance, where the contact does not slip.
        ResistedDenominator = 6, "resisted_denominator" => ("D_χ", Dimension::Ratio);
        /// η′ where the rotation of an impact ends: which of both ends first.
        ImpactOrder = 7, "slip_where_rotation_ends" => (
            "η′ where the rotation of the impact ends",
            Dimension::Velocity
        );
        /// The coefficient of restitution, less that with which an impact ends just before its gap
        /// rate falls.
        RestitutionOfFall = 8, "restitution_of_fall" => (
            "e, less that of an impact that ends just before its gap rate falls",
            Dimension::Ratio
        );
        /// μs N − |F| of rolling, and μs − |tan α| of rest, with rolling resistance.
        StaticFriction = 9, "static_friction" => ("μs N − |F|", Dimension::Ratio);
        /// χ − |M|/N of rest and of skidding.
        HeldAngle = 10, "held_angle" => ("χ − |M|/N", Dimension::Ratio);
        /// N of rolling with rolling resistance.
        NormalForce = 11, "normal_force" => ("N of rolling", Dimension::Ratio);
        /// The acceleration with which a velocity leaves zero in the direction of a mode.
        Onset = 12, "onset" => ("the acceleration from rest", Dimension::Ratio);
        /// The distance of the particle of a massless hoop from the contact point, against the last
        /// digit of the angle.
        ContactDistance = 13, "contact_distance" => (
            "the distance of the particle from the contact point",
            Dimension::Length
        );
    }
}

/// Why a motion is unresolved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Undecided {
    /// The size of a margin is at most the bound of its rounding.
    Rounding {
        /// What would decide.
        margin: Margin,
        /// Its computed value.
        value: f64,
        /// The bound of its rounding.
        bound: f64,
    },
    /// A quantity leaves the range in which it is resolved.
    Range {
        /// The quantity.
        quantity: Quantity,
        /// The value that it would have; infinite if it has no bound.
        value: f64,
        /// The largest size.
        bound: f64,
    },
}

impl Undecided {
    /// A number that overflows.
    pub(crate) const fn overflow(quantity: Quantity, value: f64) -> Self {
        Self::Range {
            quantity,
            value,
            bound: f64::MAX,
        }
    }

    /// The name of what was compared, and its name in sentences.
    pub const fn names(&self) -> (&'static str, &'static str) {
        match self {
            Self::Rounding { margin, .. } => (margin.name(), margin.row().0),
            Self::Range { quantity, .. } => (quantity.name(), quantity.sign()),
        }
    }

    /// Dimension of value and bound.
    pub const fn dimension(&self) -> Dimension {
        match self {
            Self::Rounding { margin, .. } => margin.row().1,
            Self::Range { quantity, .. } => quantity.dimension(),
        }
    }

    /// The value that was compared, and its bound.
    pub const fn compared(&self) -> [f64; 2] {
        match *self {
            Self::Rounding { value, bound, .. } | Self::Range { value, bound, .. } => {
                [value, bound]
            }
        }
    }

    /// With value and bound in other units.
    pub(crate) fn map(self, convert: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Rounding {
                margin,
                value,
                bound,
            } => Self::Rounding {
                margin,
                value: convert(value),
                bound: convert(bound),
            },
            Self::Range {
                quantity,
                value,
                bound,
            } => Self::Range {
                quantity,
                value: convert(value),
                bound: convert(bound),
            },
        }
    }

    /// What was compared, with the names in records.
    pub fn details(&self) -> [(&'static str, Detail); 3] {
        let ([value, bound], dimension) = (self.compared(), self.dimension());
        [
            ("compared", Detail::Word(self.names().0)),
            ("value", Detail::Real(value, dimension)),
            ("bound", Detail::Real(bound, dimension)),
        ]
    }
}
