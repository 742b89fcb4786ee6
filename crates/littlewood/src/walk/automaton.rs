//! The automaton of the paper as a table of edges: mode, event, next mode.
//!
//! [`crate::Hoop::simulate`] takes no other edge. The tests check every simulated transition against the table, and
//! that motions take every edge.

use crate::mechanics::Impact;
use crate::model::{Mode, SlipDirection, State, getters, named};
use crate::modes::RollingLimit;

named! {
    /// The event that ends a phase.
    pub enum Cause, "cause of a transition",
    /// Label, and whether the motion stays in contact without an impact.
    row: (&'static str, bool) {
        /// Rolling: static friction reaches its limit, |F| = μs N (2.13, 3.9).
        Slip = 0, "slip" => ("slip", true);
        /// Rolling of a massless hoop: N = 0 before |F| = μs N (3.8).
        NormalForceZero = 1, "normal_force_zero" => ("N = 0", true);
        /// Sliding or gliding: η′ = 0, and static friction holds.
        Stick = 2, "stick" => ("stick", true);
        /// Sliding or gliding: η′ changes sign.
        Reversal = 3, "reversal" => ("reversal", true);
        /// Sliding or gliding: η′ touches zero without a change of sign.
        Graze = 4, "graze" => ("graze", true);
        /// Sliding: N = 0 with the mass centre rising (§2d).
        LiftOff = 5, "lift_off" => ("lift-off", false);
        /// Flight: the rim touches the plane (§2e); with a coefficient of restitution the event
        /// includes the impact.
        Landing = 6, "landing" => ("landing", false);
        /// Gliding: the particle on the rim reaches the plane, θ = ±π (3.20).
        ParticleAtPlane = 7, "particle_at_plane" => ("particle at the plane", false);
        /// Gliding: a particle inside the rim reaches its lowest point, θ = ±π.
        ParticleAtBottom = 8, "particle_at_bottom" => ("particle at the bottom", false);
        /// Gliding: the particle reaches θ = 0 with upward velocity left.
        ParticleAtTop = 9, "particle_at_top" => ("particle at the top", false);
        /// Sliding: P = Î + m h sin θ q reaches zero while N > 0 (Painlevé).
        Singularity = 10, "singularity" => ("P = 0", false);
        /// Flight: infinitely many bounces have ended, and the rim stays on the plane.
        Settle = 11, "settle" => ("settles", false);
        /// Sliding with P ≤ 0: an impact without collision ends the slip (Painlevé).
        Jam = 12, "jam" => ("jam", false);
        /// Rolling or sliding with rolling resistance: θ′ = 0.
        TurningPoint = 13, "turning_point" => ("turning point", true);
    }
}

getters! {
    Cause, self:
    /// Label for tables and figures.
    pub label: &'static str = self.row().0;
    /// Whether the motion stays in contact without an impact, so that its first integrals continue
    /// to hold.
    pub(crate) keeps_contact: bool = self.row().1;
}

named! {
    /// A class of bodies.
    pub enum BodyClass, "class of bodies" {
        /// Î > 0.
        Heavy = 0, "heavy";
        /// Î = 0.
        Massless = 1, "massless";
    }
}

/// An edge of the automaton.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Class of bodies to which it applies.
    pub body: BodyClass,
    /// Mode that ends; none if no motion was consistent.
    pub from: Option<Mode>,
    /// Event.
    pub cause: Cause,
    /// Guard condition, in the symbols of the paper.
    pub guard: &'static str,
    /// Quantities set at the transition; all others are continuous.
    pub reset: &'static str,
    /// Mode that begins; none if the simulation ends.
    pub to: Option<Mode>,
    /// Equation or section of the paper, or another source.
    pub source: &'static str,
}

/// Edges, one per line: body, mode that ends, event, mode that begins; guard, reset, source.
macro_rules! edges {
    ($( $body:ident: $from:expr, $cause:ident, $to:expr => $guard:literal, $reset:literal, $source:literal; )+) => {
        &[$( Edge {
            body: BodyClass::$body,
            from: $from,
            cause: Cause::$cause,
            guard: $guard,
            reset: $reset,
            to: $to,
            source: $source,
        } ),+]
    };
}

/// All edges.
pub const EDGES: &[Edge] = {
    use Mode::{Flight, Gliding, Rest, Rolling, Skidding, Sliding};
    edges! {
        Heavy: Some(Rolling), Slip, Some(Sliding) => "|F| = mu_s N and |F| - mu_s N grows", "sigma = -sign F", "(2.13), 2(c)";
        Heavy: Some(Rolling), Slip, Some(Flight) => "|F| = mu_s N and |F| - mu_s N grows, h cos(theta) theta'^2 > cos(alpha)", "none", "docs/theory/contact.md";
        Heavy: Some(Sliding), Stick, Some(Rolling) => "eta' = 0 and |F_roll| <= mu_s N_roll", "eta' = 0", "2(c)";
        Heavy: Some(Sliding), Reversal, Some(Sliding) => "eta' = 0 and |F_roll| > mu_s N_roll", "sigma = -sigma", "2(c)";
        Heavy: Some(Sliding), Graze, Some(Sliding) => "eta' = 0 and eta'' = 0", "none", "2(c)";
        Heavy: Some(Sliding), LiftOff, Some(Flight) => "h cos(theta) theta'^2 = cos(alpha) and sin(theta) theta' < 0", "none", "(2.18), 2(d)";
        Heavy: Some(Flight), Landing, None => "gap = 0, falling, no e", "none", "2(e)";
        Heavy: Some(Flight), Landing, Some(Flight) => "gap = 0, falling", "theta', eta', gap' by the impact", "Routh, Keller";
        Heavy: Some(Flight), Landing, Some(Rolling) => "gap = 0, falling, e = 0", "theta', eta' = 0 by the impact", "Routh, Keller";
        Heavy: Some(Flight), Landing, Some(Sliding) => "gap = 0, falling, e = 0", "theta', eta' by the impact", "Routh, Keller";
        Heavy: Some(Flight), Settle, Some(Rolling) => "bounces accumulate", "theta', eta' = 0 by the sum of the impacts", "Zeno";
        Heavy: Some(Flight), Settle, Some(Sliding) => "bounces accumulate", "theta', eta' by the sum of the impacts", "Zeno";
        Heavy: None, Jam, Some(Rolling) => "P <= 0, e = 0", "theta', eta' = 0 by the impact", "Painleve";
        Heavy: None, Jam, Some(Sliding) => "P <= 0, e = 0", "theta', eta' = 0 by the impact", "Painleve";
        Heavy: None, Jam, Some(Flight) => "P <= 0", "theta', eta' = 0, gap' by the impact", "Painleve";
        Heavy: Some(Sliding), Jam, Some(Flight) => "P = 0, N > 0", "theta', eta' = 0, gap' by the impact", "Painleve";
        Heavy: Some(Sliding), Singularity, None => "P = 0, N > 0, no e", "none", "Painleve";
        Heavy: Some(Flight), Landing, Some(Rest) => "gap = 0, falling, e = 0, chi > 0", "theta' = eta' = 0 by the impact", "docs/theory/rolling-resistance.md";
        Heavy: Some(Flight), Landing, Some(Skidding) => "gap = 0, falling, e = 0, chi > 0", "theta' = 0, eta' by the impact", "docs/theory/rolling-resistance.md";
        Heavy: Some(Flight), Settle, Some(Rest) => "bounces accumulate, chi > 0", "theta' = eta' = 0 by the sum of the impacts", "docs/theory/rolling-resistance.md";
        Heavy: Some(Flight), Settle, Some(Skidding) => "bounces accumulate, chi > 0", "theta' = 0, eta' by the sum of the impacts", "docs/theory/rolling-resistance.md";
        Heavy: None, Jam, Some(Rest) => "P <= 0 or D_chi < 0, e = 0", "theta' = eta' = 0 by the impact", "docs/theory/rolling-resistance.md";
        Heavy: None, Jam, Some(Skidding) => "P <= 0 or D_chi < 0, e = 0", "theta' = 0, eta' by the impact", "docs/theory/rolling-resistance.md";
        Heavy: Some(Rolling), TurningPoint, Some(Rest) => "theta' = 0 and |h sin(theta) + (1 + h cos(theta)) tan(alpha)| <= chi", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Rolling), TurningPoint, Some(Rolling) => "theta' = 0 outside the band of rest", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Rolling), TurningPoint, Some(Sliding) => "theta' = 0 and |F_roll| > mu_s N_roll", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Rolling), TurningPoint, Some(Skidding) => "theta' = 0 and |tan(alpha)| > mu_s", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Rolling), Slip, None => "|F| = mu_s N, chi > 0, no motion is consistent, no e", "none", "docs/theory/rolling-resistance.md";
        Heavy: Some(Sliding), TurningPoint, Some(Sliding) => "theta' = 0", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Sliding), TurningPoint, Some(Skidding) => "theta' = 0 and |h sin(theta) - sigma mu_k (1 + h cos(theta))| <= chi", "theta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Sliding), Stick, None => "eta' = 0, chi > 0, no motion is consistent, no e", "eta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Skidding), Stick, Some(Rest) => "eta' = 0 and |h sin(theta) + (1 + h cos(theta)) tan(alpha)| <= chi", "eta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Skidding), Stick, Some(Rolling) => "eta' = 0 outside the band of rest", "eta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Skidding), Reversal, Some(Skidding) => "eta' = 0 and |tan(alpha)| > mu_s", "eta' = 0", "docs/theory/rolling-resistance.md";
        Heavy: Some(Skidding), Reversal, Some(Sliding) => "eta' = 0 and |F_roll| > mu_s N_roll", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Rolling), Slip, Some(Gliding) => "|tan(theta/2)| = mu_s, leaving", "N = F = 0", "(3.9), 3(d)";
        Massless: Some(Rolling), NormalForceZero, Some(Gliding) => "theta'^2 = 1, growing", "N = F = 0", "(3.8), 3(d)";
        Massless: Some(Gliding), Stick, Some(Rolling) => "eta' = 0 inside R", "eta' = 0", "(3.10), 3(e)";
        Massless: Some(Gliding), Reversal, Some(Gliding) => "eta' = 0 outside R", "sigma = -sigma", "3(e)";
        Massless: Some(Rolling), TurningPoint, Some(Rest) => "theta' = 0 and |l sin(theta) + (1 + l cos(theta)) tan(alpha)| <= chi", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Rolling), TurningPoint, Some(Rolling) => "theta' = 0 outside the band of rest", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Rolling), TurningPoint, Some(Gliding) => "theta' = 0, and friction gives way", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Rolling), TurningPoint, Some(Skidding) => "theta' = 0 and |tan(alpha)| > mu_s", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Gliding), TurningPoint, Some(Gliding) => "theta' = 0", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Gliding), TurningPoint, Some(Skidding) => "theta' = 0 and |l sin(theta) - sigma mu_k (1 + l cos(theta))| <= chi", "theta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Gliding), Stick, None => "eta' = 0 and D_chi < 0", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Skidding), Stick, Some(Rest) => "eta' = 0 and |l sin(theta) + (1 + l cos(theta)) tan(alpha)| <= chi", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Skidding), Stick, Some(Rolling) => "eta' = 0 outside the band of rest", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Skidding), Reversal, Some(Skidding) => "eta' = 0 and |tan(alpha)| > mu_s", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Skidding), Reversal, Some(Gliding) => "eta' = 0, and friction gives way", "eta' = 0", "docs/theory/rolling-resistance.md";
        Massless: Some(Gliding), ParticleAtPlane, None => "theta = +-pi, l = 1", "none", "(3.20)";
        Massless: Some(Gliding), ParticleAtBottom, None => "theta = +-pi, l < 1", "none", "(3.20)";
        Massless: Some(Gliding), ParticleAtTop, None => "theta = 0 with l sin(theta) theta' not 0", "none", "(3.18)";
    }
};

impl RollingLimit {
    /// The event at which rolling ends.
    pub const fn cause(self) -> Cause {
        match self {
            Self::Friction(_) => Cause::Slip,
            Self::NormalForce => Cause::NormalForceZero,
        }
    }
}

/// An event between two phases, or at the end of the last phase.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Event {
    /// State just before.
    pub(crate) state: State,
    pub(crate) from: Option<Mode>,
    pub(crate) to: Option<Mode>,
    pub(crate) cause: Cause,
}

impl Event {
    pub(crate) const fn new(state: State, from: Mode, cause: Cause) -> Self {
        Self {
            state,
            from: Some(from),
            to: None,
            cause,
        }
    }
}

/// A change of the mode of motion, or the event that ends the simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Transition {
    /// State just before.
    pub before: State,
    /// State just after; equal to `before` unless there is an impact.
    pub after: State,
    /// The impact, if the velocities jump. For bounces that settle it is the sum of their impacts.
    pub impact: Option<Impact>,
    /// Mode that ends; none for a jam from a state without a consistent motion.
    pub from: Option<Mode>,
    /// Mode that begins; none if the simulation ends.
    pub to: Option<Mode>,
    /// Direction of slip of the motion that begins.
    pub direction: Option<SlipDirection>,
    /// Event.
    pub cause: Cause,
}

impl Transition {
    /// Time.
    pub const fn time(&self) -> f64 {
        self.before.time
    }

    /// Whether it is a bounce: a landing after which the hoop flies again.
    pub fn is_bounce(&self) -> bool {
        self.cause == Cause::Landing && self.to == Some(Mode::Flight)
    }
}
