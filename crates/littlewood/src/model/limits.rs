//! Limits of a simulation and the proofs that end it.

use crate::model::{
    Body, Bound, Heavy, Hoop, ParameterError, Quantity, Start, State, named, setters, within,
};

/// Largest length that one slide adds to the total: the solver skips whole turns of a longer one.
const MAX_COUNTED_LENGTH: f64 = 32.0;

named! {
    /// Proofs that end a motion, in addition to the proof that a phase lasts for ever.
    #[derive(Default)]
    pub enum Proof, "proof",
    /// Label for help and messages.
    pub label: &'static str {
        /// No other: a motion ends in a phase without end or at a limit.
        None = 0, "none" => "that a phase lasts for ever";
        /// The motion is periodic ([`crate::Outcome::RepeatsForever`],
        /// [`crate::Outcome::SlidesForever`]) or slips for ever ([`crate::Outcome::SlipsForever`]);
        /// at a limit of transitions or slides, it stays in contact.
        #[default]
        Endless = 1, "endless" => "the same, or that the motion repeats itself or slips for ever; at a limit, that it stays in contact";
        /// As `Endless`; a proof that the hoop never lifts off ([`crate::Outcome::StaysInContact`])
        /// ends a motion at any time.
        Contact = 2, "contact" => "the same, or at any time that the hoop never lifts off";
    }
}

/// Limits of a motion without a final outcome.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Limits {
    /// Time limit τ. Endless rolling is reported as such in any case.
    pub until: Option<f64>,
    /// Maximum number of transitions. Light hoops on nearly smooth planes reach it, since friction
    /// dissipates little energy, and so do hoops with e = 1, whose bounces with slip, or without
    /// friction, do not end.
    pub transitions: usize,
    /// Maximum total length of the slides. Each adds its chord √(Δτ² + Δθ²), at most 32, since the
    /// solver skips whole turns of a longer slide. The sum is multiplied by 1 + ln(1 + m/Î), since
    /// the particle of a light hoop passes the bottom in short steps. Motions with thousands of
    /// slides, on planes with little friction, reach it; the default takes about a quarter of a
    /// second.
    pub slides: usize,
    /// Proofs that end a motion without a time limit.
    pub proof: Proof,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            until: None,
            transitions: 10_000,
            slides: 30_000,
            proof: Proof::default(),
        }
    }
}

/// Largest m/Î in the weight: slides of lighter hoops are not resolved.
const MAX_MASS_OVER_INERTIA: f64 = 1e18;

/// Factor on the length of the slides of a hoop.
pub(crate) fn weight_of_slides(hoop: &Hoop) -> f64 {
    match hoop.body() {
        Body::Heavy(Heavy { mass, inertia, .. }) => {
            1.0 + libm::log1p((mass / inertia).min(MAX_MASS_OVER_INERTIA))
        }
        Body::Massless(_) => 1.0,
    }
}

/// Length that a slide between two states adds to the total.
pub(crate) fn length_of_slide(from: &State, to: &State) -> f64 {
    let (time, angle) = (to.time - from.time, to.theta - from.theta);
    (time * time + angle * angle).sqrt().min(MAX_COUNTED_LENGTH)
}

impl Limits {
    /// Checks the time limit of a motion from a start, as each simulation does.
    ///
    /// ```
    /// use littlewood::{Limits, Start};
    ///
    /// let start = Start::at(1.0, 0.0);
    /// assert!(Limits::until(20.0).check(&start).is_ok());
    /// let error = Limits::until(-1.0).check(&start).unwrap_err();
    /// assert!(error.to_string().contains("until"));
    /// ```
    ///
    /// # Errors
    /// A time limit that is not finite, out of its bounds, or before the start.
    pub fn check(&self, start: &Start) -> Result<(), ParameterError> {
        if let Some(until) = self.until {
            Quantity::Until.check(until)?;
            within(
                Quantity::Until,
                until,
                Bound::AtLeast(Quantity::Time, start.time),
            )?;
        }
        Ok(())
    }

    /// The proofs that end a motion: none with a time limit, up to which all states are required.
    pub(crate) const fn proof(&self) -> Proof {
        if self.until.is_some() {
            Proof::None
        } else {
            self.proof
        }
    }

    /// The default limits with a time limit τ.
    #[must_use]
    pub fn until(time: f64) -> Self {
        Self::default().with_until(Some(time))
    }
}

setters! {
    Limits:
    /// The same limits with a time limit, or without one.
    with_until(until: Option<f64>);
    /// The same limits with a maximum number of transitions.
    with_transitions(transitions: usize);
    /// The same limits with a maximum total length of the slides.
    with_slides(slides: usize);
    /// The same limits with these proofs.
    with_proof(proof: Proof);
}
