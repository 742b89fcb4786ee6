//! The result formats of `littlewood`: a motion as a page, as JSON, as CSV and as a link.
//!
//! The command line, the laboratory in the browser and whatever else shows a motion write it
//! through this crate, so that the same motion is the same bytes everywhere. Nothing here opens a
//! file: the functions take a
//! [`std::io::Write`].
//!
//! ```
//! use littlewood::cases::find_case;
//! use littlewood_report::{Subject, json};
//!
//! let case = find_case("figure-3").expect("a named case");
//! let motion = case.simulate()?;
//! let mut text = Vec::new();
//! json::motion(&mut text, &Subject::of_case(case), &motion, None)?;
//! assert!(text.starts_with(b"{\n  \"case\": \"figure-3\""));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! For a person, [`page`] has a motion as a [`sheet`] of facts and tables, and [`sentence`] what
//! happens at an instant;
//! [`number`] and [`scale`] write single values, without dimension or in SI units.

pub mod csv;
mod impact;
mod instants;
pub mod json;
pub mod link;
pub mod number;
pub mod page;
mod record;
mod sampling;
pub mod scale;
pub mod sentence;
pub mod sheet;
mod subject;
mod uncertainty;

pub use impact::{ShownImpact, jam_of, kinetic_energy};
pub use instants::{Instant, instants};
pub use record::RESTITUTION_LAW;
pub use sampling::Sampling;
pub use subject::Subject;
pub use uncertainty::{SAMPLE, Spread, Uncertainty};
