//! What it takes to follow the motions of a hoop from the starts of a plane.

use core::f64::consts::PI;

use littlewood::theory::Body;
use littlewood::{Engine, Hoop, Limits, Mode, Start, Summary};

use crate::axes::plane_window;

/// How many of the motions that tell how long motions are do not matter.
const FEW: usize = 1;
/// Transitions of a long motion, and of one that bounces on and on.
const LONG: usize = 100;
const BOUNCES: usize = 1_000;
/// Phases after which a motion that slips out of rolling again and again is in its chain.
const IN_CHAIN: usize = 8;
/// Hoops that are better balanced, by h, are simulated though they are not light.
const BALANCED: f64 = 1e-3;
/// A smaller part of μs between the coefficients makes slips so short and so many that hardly any
/// of what chains prepare is used twice.
const NEARLY_EQUAL: f64 = 1e-2;
/// Half swings that are followed to the rest, and transitions of motions that each take long.
const HALF_SWINGS: f64 = 60.0;
const FEW_PHASES: usize = 24;
/// Half swings from which on the rest is out of reach, and until when motions are then followed that
/// may roll on for thousands of turns.
const HARDLY_RESISTED: f64 = 1e4;
const SOON: f64 = 200.0;
/// With less friction each slide goes on for many turns.
const LITTLE_FRICTION: f64 = 1e-4;

/// What the motions of a hoop take, from the least to the most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effort {
    /// A microsecond: phases are looked up, or are few.
    Tables,
    /// Ten: phases are computed where the motion goes.
    Direct,
    /// Thousands of slips out of rolling, passed at once.
    Chains,
    /// Many bounces after a lift-off.
    Bounces,
    /// A few phases, which are simulated.
    Simulated,
    /// Half swings against rolling resistance, which are simulated.
    Resisted {
        /// Whether they are many, and whether their end is out of reach.
        many: bool,
        endless: bool,
    },
    /// Many reversals, or many phases that are simulated.
    Long,
    /// Many phases, each of which takes long.
    Slow,
}

impl Effort {
    /// Of a hoop, whose motions are stopped at limits and followed by an engine.
    pub(crate) fn of(hoop: &Hoop, limits: Limits, engine: &Engine) -> Self {
        let resists = hoop.rolling_resistance() > 0.0;
        if matches!(hoop.body(), Body::Massless(_)) {
            return if resists {
                Self::Simulated
            } else {
                Self::Tables
            };
        }
        if resists {
            // A half swing of any width loses about 2χ/h or more.
            let half_swings = PI * hoop.h() / (2.0 * hoop.rolling_resistance());
            return Self::Resisted {
                many: half_swings > HALF_SWINGS,
                endless: half_swings > HARDLY_RESISTED,
            };
        }
        if engine.is_exact() && hoop.h() > BALANCED && hoop.mu_k() > 0.0 {
            return Self::Slow;
        }
        let [long, rolls, bounces] = long_motions(hoop, limits, engine);
        let bounces = bounces > FEW;
        if long <= FEW {
            return match (engine.is_prepared(), engine.is_exact()) {
                _ if bounces => Self::Bounces,
                // What follows a landing is looked up only to its end.
                (true, _) if limits.until.is_some() && hoop.restitution().is_some() => Self::Direct,
                (true, _) => Self::Tables,
                (false, false) => Self::Direct,
                (false, true) => Self::Simulated,
            };
        }
        let apart = hoop.mu_s() - hoop.mu_k();
        let nearly_equal = apart > 0.0 && apart < NEARLY_EQUAL * hoop.mu_s();
        if hoop.mu_k() < LITTLE_FRICTION {
            Self::Slow
        } else if engine.interpolates_slips() && !nearly_equal && !bounces && long - rolls <= FEW {
            Self::Chains
        } else {
            Self::Long
        }
    }

    /// About the microseconds that a transition takes.
    pub(crate) const fn of_a_transition(self) -> f64 {
        match self {
            Self::Tables | Self::Direct | Self::Chains | Self::Bounces => 1.0,
            Self::Simulated | Self::Resisted { .. } | Self::Long | Self::Slow => 6.0,
        }
    }

    /// The limits of such motions: what goes on is cut earlier.
    pub(crate) fn cut(self, limits: Limits, engine: &Engine) -> Limits {
        let most = match self {
            // Next to a boundary there may be a few that go on and on.
            Self::Tables | Self::Direct | Self::Bounces => BOUNCES,
            Self::Chains => usize::MAX,
            Self::Slow if engine.is_exact() => FEW_PHASES,
            Self::Resisted { many: true, .. } => FEW_PHASES,
            Self::Simulated | Self::Resisted { many: false, .. } | Self::Long | Self::Slow => LONG,
        };
        let endless = matches!(self, Self::Resisted { endless: true, .. });
        let until = if endless {
            Some(limits.until.map_or(SOON, |until| until.min(SOON)))
        } else {
            limits.until
        };
        let transitions = limits.transitions.min(most);
        limits.with_transitions(transitions).with_until(until)
    }
}

/// How many of some motions are long before they lift off, how many of these roll again and again,
/// and how many go on and on after they have lifted off.
fn long_motions(hoop: &Hoop, limits: Limits, engine: &Engine) -> [usize; 3] {
    let rolls = |summary: &Summary| {
        summary
            .sequence
            .codes()
            .skip(IN_CHAIN)
            .flatten()
            .any(|code| code.mode().0 == Mode::Rolling)
    };
    let motions = engine.long_motions(plane_window(hoop), Start::default(), limits, LONG);
    motions.fold([0; 3], |[long, rolling, bounces], summary| {
        if summary.lift_off_time.is_nan() {
            [long + 1, rolling + usize::from(rolls(&summary)), bounces]
        } else {
            [
                long,
                rolling,
                bounces + usize::from(hoop.restitution().is_some()),
            ]
        }
    })
}
