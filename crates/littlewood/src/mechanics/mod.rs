//! The equations of motion in contact, impacts, closed forms.

pub(crate) mod bouncing;
pub mod closed_form;
pub(crate) mod equations;
pub(crate) mod frictionless;
pub(crate) mod impact;
pub(crate) mod lift_off;
pub(crate) mod region;
pub(crate) mod settling;
pub(crate) mod solvability;
