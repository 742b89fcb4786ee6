//! The equations of motion in contact, impacts and closed forms.

pub(crate) mod bouncing;
pub mod closed_form;
pub(crate) mod curves;
pub(crate) mod equations;
pub(crate) mod frictionless;
pub(crate) mod impact;
pub(crate) mod lift_off;
pub(crate) mod region;
pub(crate) mod resisted;
mod resisted_curves;
mod resisted_impact;
mod resisted_settling;
pub(crate) mod reverse_chatter;
pub(crate) mod settling;
pub(crate) mod solvability;

pub(crate) use self::closed_form::{RollingType, rolling_energy};
pub(crate) use self::equations::{
    Accelerations, Clearance, ContactForces, ContactMotion, Loads, RollingLaw, SlidePath,
    SlidingLaw, contact, contact_rounding, energy, energy_at, energy_of, leaves_plane,
    slip_acceleration_at_rest,
};
pub(crate) use self::frictionless::{FrictionlessIntegrals, MarginAtTop, converge};
pub(crate) use self::impact::{Contact, ContactVelocities, Impact, ImpactCase, Impulse};
pub(crate) use self::lift_off::ContactProof;
pub(crate) use self::resisted::{HeldLaw, ResistedRollingLaw};
pub(crate) use self::settling::{BounceConditions, Bounces, Settling};
pub(crate) use self::solvability::lowest_zero;
