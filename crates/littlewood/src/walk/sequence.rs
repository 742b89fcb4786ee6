//! The sequence of the modes of a motion, in 64 bits.

use core::fmt;

use crate::model::{Mode, SlipDirection, getters, named};

named! {
    /// The code of a phase in a sequence: mode and direction of slip.
    pub enum PhaseCode, "phase",
    /// Mode and direction, and the meaning of the letter.
    row: ((Mode, Option<SlipDirection>), &'static str) {
        /// Rolling.
        Rolling = 1, "R" => ((Mode::Rolling, None), "rolling");
        /// Sliding with negative slip velocity.
        SlidingNegative = 2, "-" => ((Mode::Sliding, Some(SlipDirection::Negative)), "sliding with negative slip velocity");
        /// Sliding with positive slip velocity.
        SlidingPositive = 3, "+" => ((Mode::Sliding, Some(SlipDirection::Positive)), "sliding with positive slip velocity");
        /// Gliding with negative slip velocity.
        GlidingNegative = 4, "n" => ((Mode::Gliding, Some(SlipDirection::Negative)), "gliding with negative slip velocity");
        /// Gliding with positive slip velocity.
        GlidingPositive = 5, "g" => ((Mode::Gliding, Some(SlipDirection::Positive)), "gliding with positive slip velocity");
        /// Gliding without slip.
        GlidingWithoutSlip = 6, "G" => ((Mode::Gliding, None), "gliding without slip");
        /// Flight.
        Flight = 7, "F" => ((Mode::Flight, None), "flight");
        /// Rest.
        Rest = 8, "0" => ((Mode::Rest, None), "rest");
        /// Skidding with negative slip velocity.
        SkiddingNegative = 9, "s" => ((Mode::Skidding, Some(SlipDirection::Negative)), "skidding with negative slip velocity");
        /// Skidding with positive slip velocity.
        SkiddingPositive = 10, "S" => ((Mode::Skidding, Some(SlipDirection::Positive)), "skidding with positive slip velocity");
    }
}

getters! {
    PhaseCode, self:
    /// The mode and the direction of slip.
    pub mode: (Mode, Option<SlipDirection>) = self.row().0;
    /// Meaning of the letter, for legends.
    pub meaning: &'static str = self.row().1;
}

impl PhaseCode {
    /// The code of a mode and a direction of slip.
    #[must_use]
    pub const fn new(mode: Mode, direction: Option<SlipDirection>) -> Self {
        match (mode, direction) {
            (Mode::Rolling, _) => Self::Rolling,
            (Mode::Sliding, Some(SlipDirection::Positive)) => Self::SlidingPositive,
            (Mode::Sliding, Some(SlipDirection::Negative) | None) => Self::SlidingNegative,
            (Mode::Gliding, Some(SlipDirection::Negative)) => Self::GlidingNegative,
            (Mode::Gliding, Some(SlipDirection::Positive)) => Self::GlidingPositive,
            (Mode::Gliding, None) => Self::GlidingWithoutSlip,
            (Mode::Flight, _) => Self::Flight,
            (Mode::Rest, _) => Self::Rest,
            (Mode::Skidding, Some(SlipDirection::Positive)) => Self::SkiddingPositive,
            (Mode::Skidding, Some(SlipDirection::Negative) | None) => Self::SkiddingNegative,
        }
    }
}

/// A sequence of phases in 64 bits: up to [`PhaseSequence::CAPACITY`] phases of four bits each, and
/// a bit that is set if more follow.
///
/// Displayed with one letter per phase, the name of its [`PhaseCode`], and `…` if more phases
/// follow.
///
/// ```
/// use littlewood::{Hoop, Limits, Start};
///
/// let hoop = Hoop::equal_masses(0.5, 0.4)?;
/// let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
/// assert_eq!(motion.summary().sequence.to_string(), "-R+F");
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PhaseSequence(u64);

getters! {
    PhaseSequence, self:
    /// The number stored in arrays, encoded as [`PhaseSequence::ENCODING`] describes.
    pub bits: u64 = self.0;
    /// Whether the sequence is empty: no motion was consistent at the start.
    pub is_empty: bool = self.0 == 0;
    /// Whether there were more phases than fit.
    pub is_truncated: bool = self.0 & Self::OVERFLOW != 0;
}

impl PhaseSequence {
    /// Number of phases that fit.
    pub const CAPACITY: u32 = 15;

    /// Version of the code. Version 1 had three bits a phase, version 2 neither rest nor skidding.
    pub const VERSION: u32 = 3;

    /// Description of the bits.
    pub const ENCODING: &'static str =
        "4 bits a phase, the first phase lowest, up to 15 phases; bit 63 is set if there are more";

    /// Bits of a phase; 0 ends the sequence.
    pub const BITS: u32 = 4;

    const OVERFLOW: u64 = 1 << 63;

    /// The bits of all phases that fit.
    const PHASES: u64 = (1 << (Self::BITS * Self::CAPACITY)) - 1;

    /// The lowest bit of each phase.
    const LAST_BITS: u64 = Self::PHASES / ((1 << Self::BITS) - 1);

    /// From the 64 bits of [`PhaseSequence::bits`].
    #[must_use]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    /// Adds a phase.
    pub const fn push(&mut self, mode: Mode, direction: Option<SlipDirection>) {
        let length = self.len();
        if length < Self::CAPACITY {
            self.0 |= (PhaseCode::new(mode, direction).code() as u64) << (Self::BITS * length);
        } else {
            self.0 |= Self::OVERFLOW;
        }
    }

    pub(crate) const fn append(&mut self, other: Self) {
        let length = self.len();
        // Phases beyond the capacity are shifted out.
        self.0 |= ((other.0 & Self::PHASES) << (Self::BITS * length)) & Self::PHASES;
        if other.is_truncated() || length + other.len() > Self::CAPACITY {
            self.0 |= Self::OVERFLOW;
        }
    }

    /// The phases of the mirror image of a motion.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        // Codes of opposite directions differ in the lowest bit, and those of skidding in the one
        // above it, too. Sliding, 2 and 3, and gliding, 4 and 5, are the codes without the highest
        // bit that have exactly one of the two in the middle; skidding, 9 and 10, those with it
        // that have exactly one of the two lowest.
        let [lowest, low, high, highest] = [self.0, self.0 >> 1, self.0 >> 2, self.0 >> 3];
        let slides_or_glides = !highest & (low ^ high) & Self::LAST_BITS;
        let skids = highest & (lowest ^ low) & Self::LAST_BITS;
        Self(self.0 ^ slides_or_glides ^ (skids | skids << 1))
    }

    /// Number of phases stored.
    pub const fn len(self) -> u32 {
        let used = u64::BITS - (self.0 & !Self::OVERFLOW).leading_zeros();
        used.div_ceil(Self::BITS)
    }

    /// The first phase, if any.
    pub fn first(self) -> Option<(Mode, Option<SlipDirection>)> {
        self.codes()
            .next()
            .and_then(Result::ok)
            .map(PhaseCode::mode)
    }

    /// The phases stored; an unknown code is an error.
    pub fn codes(
        self,
    ) -> impl Iterator<Item = Result<PhaseCode, crate::model::named::UnknownCode>> {
        (0..self.len()).map(move |i| PhaseCode::try_from((self.0 >> (Self::BITS * i)) as u8 & 0xf))
    }
}

impl fmt::Display for PhaseSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text: String = self
            .codes()
            .map(|code| code.map_or("?", PhaseCode::name))
            .collect();
        if self.is_truncated() {
            text.push('…');
        }
        f.pad(&text)
    }
}
