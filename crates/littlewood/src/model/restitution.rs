//! A coefficient of restitution with its law.

use crate::model::named;

named! {
    /// What the coefficient of restitution is a ratio of; the energetic law, which never gains energy, is the default.
    #[derive(Default)]
    pub enum RestitutionLaw, "law of restitution",
    /// In words, for menus and legends.
    pub label: &'static str {
        /// Of works: the work that the normal force gives back is e² of what it has taken up (Stronge).
        #[default]
        Energetic = 0, "energetic" => "energetic (Stronge)";
        /// Of impulses: that of restitution is e times that of compression.
        Poisson = 1, "poisson" => "impulses (Poisson)";
        /// Of velocities: the gap opens e times as fast as it has closed. It can gain energy where friction changes on the
        /// way.
        Newton = 2, "newton" => "velocities (Newton)";
    }
}

/// A coefficient of restitution 0 ≤ e ≤ 1 with its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution {
    pub(super) coefficient: f64,
    pub(super) law: RestitutionLaw,
}

impl Restitution {
    /// The coefficient e.
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// The law.
    #[must_use]
    pub const fn law(&self) -> RestitutionLaw {
        self.law
    }
}
