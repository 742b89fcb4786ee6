//! Which proofs end a motion.

use crate::model::named::named;

named! {
    /// Which proofs end a motion, besides those that a phase lasts for ever.
    #[derive(Default)]
    pub enum Proof, "proof" {
        /// None: the motion is followed to a phase without end, or to a limit.
        None = 0, "none";
        /// That it repeats itself ([`crate::Outcome::RepeatsForever`], [`crate::Outcome::SlidesForever`]) or slips for ever
        /// ([`crate::Outcome::SlipsForever`]); at a limit of transitions or of steps, that it stays in contact.
        #[default]
        Endless = 1, "endless";
        /// The same, and at any time that it never lifts off ([`crate::Outcome::StaysInContact`]): for the question who jumps.
        Contact = 2, "contact";
    }
}

impl Proof {
    /// In words, for help and messages.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::None => "only that a phase lasts for ever",
            Self::Endless => {
                "that the motion repeats itself or slips for ever; at a limit, that it stays in contact"
            }
            Self::Contact => "the same, and as soon as it is known that the hoop never lifts off",
        }
    }
}
