//! The input of a simulation: quantities and units, the hoop, its start and the limits.

pub(crate) mod dimension;
pub(crate) mod error;
pub(crate) mod hoop;
pub(crate) mod limits;
pub(crate) mod mode;
pub(crate) mod named;
pub(crate) mod quantity;
pub(crate) mod restitution;
pub(crate) mod setup;
pub(crate) mod si;
pub(crate) mod state;
pub(crate) mod undecided;
pub(crate) mod units;

pub(crate) use self::dimension::{Detail, Dimension, System};
pub(crate) use self::error::{MIN_INERTIA, MIN_MASSLESS_OFFSET, ParameterError, within};
pub(crate) use self::hoop::{Body, Composition, Friction, Heavy, Hoop, HoopParameters, Massless};
pub(crate) use self::limits::{Limits, Proof, length_of_slide, weight_of_slides};
pub(crate) use self::mode::{Mode, RotationDirection, SlipDirection};
pub(crate) use self::named::{getters, named, setters};
pub(crate) use self::quantity::{
    Bound, MAX_COORDINATE, MAX_TIME, Number, Quantity, Reading, STANDARD_GRAVITY,
};
pub(crate) use self::restitution::{Restitution, RestitutionLaw};
pub(crate) use self::setup::Setup;
pub(crate) use self::state::{Start, State};
pub(crate) use self::undecided::{Margin, Undecided};
pub(crate) use self::units::Units;
