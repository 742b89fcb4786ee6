//! The region of a start in the phase plane of the paper, and the motion that begins there.

use crate::mechanics::region::PhasePlane;
use crate::mechanics::{ContactForces, RollingType, contact, energy, rolling_energy};
use crate::model::{
    Body, Hoop, Limits, Mode, ParameterError, SlipDirection, Start, State, Undecided, named,
};
use crate::modes::{Recurrence, RollingEnd, RollingLimit, RollingOrbit};
use crate::walk::{Arrival, Candidates, NextMotion, Origin, RelativeStart, ResistedMotion};

named! {
    /// The region of the state space that contains a start.
    pub enum StartRegion, "region of starts" {
        /// 𝓡 of (2.14), (3.10): rolling.
        Rolling = 0, "rolling_region";
        /// 𝓝 without 𝓡: N > 0 and |F| > μs N.
        BeyondFriction = 1, "beyond_friction";
        /// N ≤ 0 in rolling and 1 − h cos θ θ′² > 0: sliding in contact. The paper calls it loss of
        /// contact.
        SlidingBand = 2, "sliding_band";
        /// 1 − h cos θ θ′² < 0, or zero and decreasing, or an opening gap: flight.
        LossOfContact = 3, "loss_of_contact";
        /// η′ ≠ 0 and in contact.
        Slipping = 4, "slipping";
        /// Massless hoop outside 𝓡, or with η′ ≠ 0: gliding.
        Gliding = 5, "gliding";
        /// No motion is consistent.
        Inconsistent = 6, "inconsistent";
        /// Several motions are consistent.
        Ambiguous = 7, "ambiguous";
        /// At complete rest, and rolling resistance and static friction hold the hoop.
        BandOfRest = 8, "band_of_rest";
        /// Rounding decides between motions.
        Unresolved = 9, "unresolved";
    }
}

/// The classification of a start, without a simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Classification {
    /// Region.
    pub region: StartRegion,
    /// Mode that begins, if exactly one is consistent.
    pub mode: Option<Mode>,
    /// Direction of slip that begins; none for rolling and flight, and for a glide from η′ = 0,
    /// whose solution determines it.
    pub direction: Option<SlipDirection>,
    /// Energy E (2.8).
    pub energy: f64,
    /// N and F that rolling would need (2.12), or rest where rolling resistance holds the angle.
    pub rolling_forces: ContactForces,
    /// 1 − h cos θ θ′²/cos α.
    pub contact: f64,
    /// The end of rolling for a start in 𝓡; none if it rolls for ever, and with rolling resistance,
    /// where the hoop may turn back before.
    pub rolling_end: Option<RollingEnd>,
    /// The recurrence for a start in 𝓡 that rolls for ever; none with rolling resistance.
    pub recurrence: Option<Recurrence>,
    /// For Littlewood's hoop in 𝓡: Type I, II or III; none on the stable manifold, and with rolling
    /// resistance, where the energy does not tell the type.
    pub rolling_type: Option<RollingType>,
    /// For a start that rolls or rests, and from which bounces can grow, so that this is not the
    /// only motion: the ratio of successive bounces ([`PhasePlane::reverse_chatter`]).
    pub reverse_chatter: Option<f64>,
    /// The candidates, if no motion or more than one is consistent.
    pub candidates: Option<Candidates>,
    /// What rounding does not decide, if the motion is unresolved.
    pub undecided: Option<Undecided>,
}

impl Classification {
    /// Adds the motion that begins in contact.
    fn add_motion(&mut self, hoop: &Hoop, state: &State, origin: &Origin) {
        let next = NextMotion::at(hoop, state, Arrival::Start);
        (self.mode, self.direction) = (next.mode(), next.direction());
        self.region = match next {
            NextMotion::Roll { on_limit } => {
                self.add_rolling(hoop, state, origin, on_limit);
                StartRegion::Rolling
            }
            NextMotion::Slide { .. } => self.region_of_slip(state),
            NextMotion::Resisted { motion, .. } => match motion {
                ResistedMotion::Rest => StartRegion::BandOfRest,
                ResistedMotion::Roll(_) => StartRegion::Rolling,
                ResistedMotion::Skid(_) | ResistedMotion::Slide { .. } => {
                    self.region_of_slip(state)
                }
            },
            NextMotion::Glide { .. } => {
                self.direction = SlipDirection::of_sign(state.slip);
                StartRegion::Gliding
            }
            NextMotion::Fly { .. } | NextMotion::Settle { .. } => StartRegion::LossOfContact,
            NextMotion::Undecided(undecided) => {
                self.undecided = Some(origin.undecided(undecided));
                StartRegion::Unresolved
            }
            NextMotion::None(candidates) => {
                self.candidates = Some(origin.candidates(*candidates));
                StartRegion::Inconsistent
            }
            NextMotion::Several(candidates) => {
                self.candidates = Some(origin.candidates(*candidates));
                StartRegion::Ambiguous
            }
        };
    }

    /// The region of a start that slips, or begins to.
    fn region_of_slip(&self, state: &State) -> StartRegion {
        match (state.slip == 0.0, self.rolling_forces.normal > 0.0) {
            (false, _) => StartRegion::Slipping,
            (true, true) => StartRegion::BeyondFriction,
            (true, false) => StartRegion::SlidingBand,
        }
    }

    /// Adds how rolling from a state ends, or what recurs if it does not.
    fn add_rolling(&mut self, hoop: &Hoop, state: &State, origin: &Origin, on_limit: bool) {
        let (theta, theta_rate) = (state.theta, state.theta_rate);
        let orbit = RollingOrbit::of(hoop, theta, theta_rate);
        let end = if on_limit {
            orbit.end_from_limit()
        } else {
            orbit.end()
        };
        self.rolling_type = hoop.rolling_type(theta, theta_rate, end);
        let is_endless = end.is_none() && !orbit.leaves_bounds();
        self.recurrence = is_endless.then(|| origin.recurrence(orbit.recurrence()));
        self.rolling_end = end.map(|end| origin.rolling_end(end));
    }
}

impl Hoop {
    /// Kinetic and potential energy of a start (2.8); on a slope the potential energy includes m x̄
    /// sin α.
    pub fn energy_of(&self, start: &Start) -> f64 {
        let (origin, RelativeStart { state, gap_rate }, _) =
            Origin::of(self, start, Limits::default());
        origin.energy(energy(self, &state, 0.0, gap_rate))
    }

    /// Determines the region of a start, the motion that begins, and, for Littlewood's hoop, its
    /// type.
    ///
    /// ```
    /// use littlewood::theory::RollingType;
    /// use littlewood::{Hoop, Start};
    ///
    /// let hoop = Hoop::littlewood(0.5, 0.4)?;
    /// let start = hoop.classify(Start::at(0.0, 0.5))?;
    /// assert_eq!(start.rolling_type, Some(RollingType::III));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// A start that is not finite.
    pub fn classify(&self, start: Start) -> Result<Classification, ParameterError> {
        self.check(start)?;
        let (origin, RelativeStart { state, gap_rate }, _) =
            Origin::of(self, &start, Limits::default());
        let (theta, theta_rate) = (state.theta, state.theta_rate);
        let plane = PhasePlane::new(self);
        let mut found = Classification {
            region: StartRegion::LossOfContact,
            mode: Some(Mode::Flight),
            direction: None,
            energy: origin.energy(energy(self, &state, 0.0, gap_rate)),
            rolling_forces: origin.forces(plane.forces_at_unit_gravity(theta, theta_rate)),
            contact: contact(1.0, self.h(), libm::cos(theta) * (theta_rate * theta_rate)),
            rolling_end: None,
            recurrence: None,
            rolling_type: None,
            reverse_chatter: None,
            candidates: None,
            undecided: None,
        };
        if start.gap_rate > 0.0 {
            return Ok(found);
        }
        found.add_motion(self, &state, &origin);
        if matches!(found.mode, Some(Mode::Rolling | Mode::Rest)) {
            found.reverse_chatter = plane.reverse_chatter(start.theta, start.theta_rate);
        }
        Ok(found)
    }

    fn rolling_type(
        &self,
        theta: f64,
        theta_rate: f64,
        end: Option<RollingEnd>,
    ) -> Option<RollingType> {
        match self.body() {
            Body::Massless(body) if body.offset == 1.0 => {
                if self.slope() != 0.0 {
                    return end.map(|end| match end.limit {
                        RollingLimit::NormalForce => RollingType::I,
                        RollingLimit::Friction(_) => RollingType::III,
                    });
                }
                let by_energy =
                    RollingType::of_energy(rolling_energy(theta, theta_rate), self.mu_s())?;
                // Near e = 1 + 2 cos θ_s the energy may round to either side, so the end of rolling
                // decides.
                match (end?.limit, by_energy) {
                    (_, RollingType::II) => Some(RollingType::II),
                    (RollingLimit::NormalForce, _) => Some(RollingType::I),
                    (RollingLimit::Friction(_), _) => Some(RollingType::III),
                }
            }
            Body::Massless(_) | Body::Heavy(_) => None,
        }
    }
}
