//! Named cases.

use littlewood::cases::NamedCase;
use serde::Serialize;

use super::fields::Fields;
use super::setup::{hoop, start};

#[derive(Debug, Serialize)]
pub(crate) struct CaseRecord {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    hoop: Fields,
    start: Fields,
}

impl From<&NamedCase> for CaseRecord {
    fn from(case: &NamedCase) -> Self {
        let NamedCase { name, title, source, setup } = *case;
        Self { name, title, source, hoop: hoop(setup.hoop), start: start(setup.start) }
    }
}
