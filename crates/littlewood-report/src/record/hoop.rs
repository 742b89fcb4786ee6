//! A hoop.

use littlewood::HoopParameters;
use serde::Serialize;

/// A hoop (2.9).
#[derive(Debug, Serialize)]
pub(crate) struct HoopRecord {
    mass_ratio: f64,
    offset: f64,
    inertia: f64,
    mu_s: f64,
    mu_k: f64,
}

impl From<HoopParameters> for HoopRecord {
    fn from(hoop: HoopParameters) -> Self {
        let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = hoop;
        Self { mass_ratio, offset, inertia, mu_s, mu_k }
    }
}
