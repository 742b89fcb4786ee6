//! Limits of a simulation, and the proofs that end it.

use crate::model::{Body, Bound, Heavy, Hoop, ParameterError, Quantity, Start, State, named, within};

/// The most that a slide counts: whole turns of a longer one are passed at once.
const LONGEST_SLIDE: f64 = 32.0;

named! {
    /// Which proofs end a motion, besides those that a phase lasts for ever.
    #[derive(Default)]
    pub enum Proof, "proof",
    /// In words, for help and messages.
    pub label: &'static str {
        /// None: the motion is followed to a phase without end, or to a limit.
        None = 0, "none" => "only that a phase lasts for ever";
        /// That it repeats itself ([`crate::Outcome::RepeatsForever`], [`crate::Outcome::SlidesForever`]) or slips for ever
        /// ([`crate::Outcome::SlipsForever`]); at a limit of transitions or of steps, that it stays in contact.
        #[default]
        Endless = 1, "endless" => "that the motion repeats itself or slips for ever; at a limit, that it stays in contact";
        /// The same, and at any time that it never lifts off ([`crate::Outcome::StaysInContact`]): for the question who jumps.
        Contact = 2, "contact" => "the same, and as soon as it is known that the hoop never lifts off";
    }
}

/// When to stop a motion that has not come to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Limits {
    /// Time τ at which to stop, if any. A motion that is proved to roll for ever is reported as such in any case.
    pub until: Option<f64>,
    /// Largest number of transitions. Light hoops on nearly smooth planes need it, whose friction takes off next to no energy,
    /// and e = 1, where bounces that slip, or on a plane without friction, do not end.
    pub transitions: usize,
    /// Largest length of all slides together: of each, that of its chord in the plane of time and angle, √(Δτ² + Δθ²), but no more than 32, since
    /// whole turns of a longer one are passed at once; times 1 + ln(1 + m/Î), since the particle of a light hoop passes the bottom in short steps.
    /// Motions on planes of next to no friction need it, which slide thousands of times; the default takes about a quarter of a second.
    pub slides: usize,
    /// Which proofs end a motion that is not followed to a time limit.
    pub proof: Proof,
}

impl Default for Limits {
    fn default() -> Self {
        Self { until: None, transitions: 10_000, slides: 30_000, proof: Proof::default() }
    }
}

/// m/Î of lighter hoops tells no more: their slides are not resolved.
const LIGHTEST: f64 = 1e18;

/// What the length of the slides of a hoop is multiplied by.
pub(crate) fn weight_of_slides(hoop: &Hoop) -> f64 {
    match hoop.body() {
        Body::Heavy(Heavy { mass, inertia, .. }) => 1.0 + libm::log1p((mass / inertia).min(LIGHTEST)),
        Body::Massless(_) => 1.0,
    }
}

/// What a slide from a state to another counts of the length of all slides.
pub(crate) fn length_of_slide(from: &State, to: &State) -> f64 {
    let (time, angle) = (to.time - from.time, to.theta - from.theta);
    (time * time + angle * angle).sqrt().min(LONGEST_SLIDE)
}

impl Limits {
    pub(crate) fn check(&self, start: &Start) -> Result<(), ParameterError> {
        if let Some(until) = self.until {
            Quantity::Until.check(until)?;
            within(Quantity::Until, until, Bound::AtLeast(Quantity::Time, start.time))?;
        }
        Ok(())
    }

    /// The proofs that end a motion: none where the states up to a time limit are wanted.
    pub(crate) const fn proof(&self) -> Proof {
        if self.until.is_some() { Proof::None } else { self.proof }
    }

    /// Stops at the time τ.
    #[must_use]
    pub fn until(time: f64) -> Self {
        Self::default().with_until(Some(time))
    }

    /// The same limits with a time limit, or without one.
    #[must_use]
    pub const fn with_until(self, until: Option<f64>) -> Self {
        Self { until, ..self }
    }

    /// The same limits with a largest number of transitions.
    #[must_use]
    pub const fn with_transitions(self, transitions: usize) -> Self {
        Self { transitions, ..self }
    }

    /// The same limits with a largest length of all slides.
    #[must_use]
    pub const fn with_slides(self, slides: usize) -> Self {
        Self { slides, ..self }
    }

    /// The same limits, ending a motion by these proofs.
    #[must_use]
    pub const fn with_proof(self, proof: Proof) -> Self {
        Self { proof, ..self }
    }
}
