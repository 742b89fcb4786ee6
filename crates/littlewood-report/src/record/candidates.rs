//! What was examined where the motion that follows is not unique.

use littlewood::theory::Candidates;
use serde::Serialize;

use super::fields::Fields;

/// The motions that are consistent, and the numbers that decide.
#[derive(Debug, Serialize)]
pub(crate) struct CandidatesRecord {
    consistent: Vec<Fields>,
    #[serde(flatten)]
    details: Fields,
}

impl From<Candidates> for CandidatesRecord {
    fn from(candidates: Candidates) -> Self {
        Self {
            consistent: candidates
                .consistent()
                .map(|(mode, direction)| {
                    [("mode", Some(mode).into()), ("direction", direction.into())].into_iter().collect()
                })
                .collect(),
            details: Fields::of_details(candidates.details()),
        }
    }
}
