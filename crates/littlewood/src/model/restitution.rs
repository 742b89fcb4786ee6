//! Coefficient and law of restitution.

use crate::model::{getters, named};

named! {
    /// Definition of the coefficient of restitution. The default, the energetic law, never
    /// increases the energy.
    #[derive(Default)]
    pub enum RestitutionLaw, "law of restitution",
    /// Label for menus and legends.
    pub label: &'static str {
        /// Ratio of works: the normal force does e² times as much work in restitution as it absorbs
        /// in compression (Stronge).
        #[default]
        Energetic = 0, "energetic" => "energetic (Stronge)";
        /// Ratio of impulses: that of restitution is e times that of compression.
        Poisson = 1, "poisson" => "impulses (Poisson)";
        /// Ratio of velocities: the gap opens e times as fast as it closed. It can increase the
        /// energy if slip ends during the impact.
        Newton = 2, "newton" => "velocities (Newton)";
    }
}

/// A coefficient of restitution 0 ≤ e ≤ 1 with its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution<T = f64> {
    pub(crate) coefficient: T,
    pub(crate) law: RestitutionLaw,
}

getters! {
    Restitution, [self]:
    /// The coefficient e.
    pub coefficient: f64 = self.coefficient;
    /// The law.
    pub law: RestitutionLaw = self.law;
}
