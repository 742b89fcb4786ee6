//! Recurrence of endless motions, and the one endless motion that does not recur: a balanced hoop
//! down a slope.

use crate::math::number::Number;
use crate::model::{Detail, Dimension, named};

/// Recurrence of a motion that lasts for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[expect(missing_docs, reason = "the text of each says what its fields are")]
pub enum Recurrence<T = f64> {
    /// Rest in an equilibrium (for a homogeneous disc, anywhere).
    Rest,
    /// Oscillation about the stable equilibrium, in one period from the smallest angle to the
    /// largest and back.
    Libration {
        period: T,
        theta_min: T,
        theta_max: T,
    },
    /// Rotation over the top in one direction, a turn in a period.
    Rotation { period: T },
    /// Acceleration of a balanced hoop down a slope: x″ of the centre.
    Downhill { acceleration: T },
    /// Approach to the unstable equilibrium at θ on the separatrix, in infinite time.
    Asymptotic { theta: T },
}

named! {
    /// The kind of a recurrence.
    pub enum RecurrenceKind, "recurrence" {
        /// [`Recurrence::Rest`].
        Rest = 0, "rest";
        /// [`Recurrence::Libration`].
        Libration = 1, "libration";
        /// [`Recurrence::Rotation`].
        Rotation = 2, "rotation";
        /// [`Recurrence::Asymptotic`].
        Asymptotic = 3, "asymptotic";
        /// [`Recurrence::Downhill`].
        Downhill = 4, "downhill";
    }
}

impl Recurrence {
    /// The kind.
    pub const fn kind(&self) -> RecurrenceKind {
        match self {
            Self::Rest => RecurrenceKind::Rest,
            Self::Libration { .. } => RecurrenceKind::Libration,
            Self::Rotation { .. } => RecurrenceKind::Rotation,
            Self::Asymptotic { .. } => RecurrenceKind::Asymptotic,
            Self::Downhill { .. } => RecurrenceKind::Downhill,
        }
    }

    /// Kind and values with their names in records.
    pub fn details(&self) -> Vec<(&'static str, Detail)> {
        let mut details = vec![("recurrence", Detail::Word(self.kind().name()))];
        let angle = |value| Detail::Real(value, Dimension::Angle);
        if let Some(period) = self.period() {
            details.push(("period", Detail::Real(period, Dimension::Time)));
        }
        match *self {
            Self::Libration {
                theta_min,
                theta_max,
                ..
            } => {
                details.extend([
                    ("theta_min", angle(theta_min)),
                    ("theta_max", angle(theta_max)),
                ]);
            }
            Self::Asymptotic { theta } => details.push(("theta_limit", angle(theta))),
            Self::Downhill { acceleration } => {
                details.push((
                    "acceleration",
                    Detail::Real(acceleration, Dimension::Acceleration),
                ));
            }
            Self::Rest | Self::Rotation { .. } => {}
        }
        details
    }
}

impl<T: Copy> Recurrence<T> {
    /// Period; none for rest, on the separatrix, and down a slope.
    pub const fn period(&self) -> Option<T> {
        match self {
            Self::Libration { period, .. } | Self::Rotation { period } => Some(*period),
            Self::Rest | Self::Asymptotic { .. } | Self::Downhill { .. } => None,
        }
    }
}

impl<T: Number> Recurrence<T> {
    /// In units in which velocities are `pace` times as large.
    pub(crate) fn at_pace(self, pace: T) -> Self {
        self.map_each(
            |time| time / pace,
            |angle| angle,
            |acceleration| acceleration * (pace * pace),
        )
    }

    /// Applies a function to each number.
    pub(crate) fn map<U>(self, f: impl Fn(T) -> U) -> Recurrence<U> {
        self.map_each(&f, &f, &f)
    }

    /// Applies a function to each time, one to each angle, and one to each acceleration.
    fn map_each<U>(
        self,
        of_time: impl Fn(T) -> U,
        of_angle: impl Fn(T) -> U,
        of_acceleration: impl Fn(T) -> U,
    ) -> Recurrence<U> {
        match self {
            Self::Rest => Recurrence::Rest,
            Self::Libration {
                period,
                theta_min,
                theta_max,
            } => Recurrence::Libration {
                period: of_time(period),
                theta_min: of_angle(theta_min),
                theta_max: of_angle(theta_max),
            },
            Self::Rotation { period } => Recurrence::Rotation {
                period: of_time(period),
            },
            Self::Downhill { acceleration } => Recurrence::Downhill {
                acceleration: of_acceleration(acceleration),
            },
            Self::Asymptotic { theta } => Recurrence::Asymptotic {
                theta: of_angle(theta),
            },
        }
    }
}
