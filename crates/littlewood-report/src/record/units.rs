//! The hoop and the units in SI.

use littlewood::{Hoop, SiParameters, Units};
use serde::Serialize;

/// The hoop and the units in SI.
#[derive(Debug, Serialize)]
pub(crate) struct SiRecord {
    hoop: SiHoopRecord,
    units: UnitsRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy_lost_j: Option<f64>,
}

#[derive(Debug, Serialize)]
struct SiHoopRecord {
    disc_mass_kg: f64,
    particle_mass_kg: f64,
    radius_m: f64,
    offset_m: f64,
    inertia_kg_m2: f64,
    gravity_m_per_s2: f64,
    mu_s: f64,
    mu_k: f64,
}

#[derive(Debug, Serialize)]
struct UnitsRecord {
    mass_kg: f64,
    length_m: f64,
    time_s: f64,
    velocity_m_per_s: f64,
    force_n: f64,
    energy_j: f64,
}

impl SiRecord {
    pub(crate) fn new(hoop: &Hoop, units: &Units, energy_lost: Option<f64>) -> Self {
        let si = SiParameters::from_hoop(hoop, units);
        Self {
            hoop: SiHoopRecord {
                disc_mass_kg: si.disc_mass_kg,
                particle_mass_kg: si.particle_mass_kg,
                radius_m: si.radius_m,
                offset_m: si.offset_m,
                inertia_kg_m2: si.inertia_kg_m2,
                gravity_m_per_s2: si.gravity_m_per_s2,
                mu_s: si.mu_s,
                mu_k: si.mu_k,
            },
            units: UnitsRecord {
                mass_kg: units.mass_kg,
                length_m: units.length_m,
                time_s: units.time_s,
                velocity_m_per_s: units.velocity_m_per_s(),
                force_n: units.force_n(),
                energy_j: units.energy_j(),
            },
            energy_lost_j: energy_lost.map(|energy| energy * units.energy_j()),
        }
    }
}
