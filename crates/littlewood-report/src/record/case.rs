//! Named cases.

use littlewood::NamedCase;
use serde::Serialize;

use super::hoop::HoopRecord;
use super::state::StateRecord;

/// A named case.
#[derive(Debug, Serialize)]
pub(crate) struct CaseRecord {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    hoop: HoopRecord,
    start: StateRecord,
}

impl From<&'static NamedCase> for CaseRecord {
    fn from(case: &'static NamedCase) -> Self {
        let NamedCase { name, title, source, hoop, start } = *case;
        Self { name, title, source, hoop: hoop.into(), start: start.into() }
    }
}
