//! Motion with rolling resistance that other modes do not have: rolling that slows down, skidding,
//! and rest (docs/theory/rolling-resistance.md).

mod held;
mod leap;
mod rolling;
mod series;

pub use held::{Rest, Skidding};
pub use rolling::ResistedRolling;
pub(crate) use rolling::{ResistedBudget, ResistedEnd};
pub(crate) use series::RollingSeries;
