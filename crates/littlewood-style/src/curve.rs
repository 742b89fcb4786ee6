//! Curves of the (θ, θ′) plane.

use core::f64::consts::FRAC_PI_2;

use littlewood::Mode;
use littlewood::theory::{PhasePlane, Window};

use crate::arrow::Arrow;
use crate::dash::Dash;
use crate::ink::Ink;
use crate::mode::of_mode;
use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;
use crate::width::{BOLD, CURVE, FINE};

named! {
    /// A curve of the (θ, θ′) plane. A limit of a force has the colour of the force.
    pub enum Curve {
        /// f: static friction gives way in rolling, |F| = μs N (2.13, 3.9).
        SlipLimit = "slip_limit",
        /// n: N = 0 in rolling (3.8).
        NormalForceZero = "normal_force_zero",
        /// Through the unstable equilibrium; without inertia its stable and unstable manifold.
        Separatrix = "separatrix",
        /// N = 0 in sliding, beyond which the body leaves the plane (2.18).
        LiftOff = "lift_off",
        /// The rates between which bounces grow out of rolling, on a slope.
        ReverseChatter = "chatter",
        /// Orbits of rolling, of constant energy without rolling resistance.
        Level = "level",
        /// Where rolling resistance holds the hoop at rest, at θ′ = 0.
        BandOfRest = "band_of_rest",
    }
}

/// Orbits from rest in a turn, and those that pass a top.
const FROM_REST: u32 = 3;
const OVER_TOP: u32 = 5;

impl Curve {
    /// The letter of the paper, for those that have one.
    pub const fn letter(self) -> Option<&'static str> {
        match self {
            Self::SlipLimit => Some("f"),
            Self::NormalForceZero => Some("n"),
            Self::Separatrix
            | Self::LiftOff
            | Self::ReverseChatter
            | Self::Level
            | Self::BandOfRest => None,
        }
    }

    /// In words, for legends. The weight normal to a plane at the slope α is cos α of the whole.
    pub const fn label(self, slope: f64) -> &'static str {
        match self {
            Self::SlipLimit => "f: |F| = μₛ N in rolling",
            Self::NormalForceZero => "n: N = 0 in rolling",
            Self::Separatrix => "separatrix",
            Self::LiftOff if slope == 0.0 => "lift-off: h cos θ θ′² = 1",
            Self::LiftOff => "lift-off: h cos θ θ′² = cos α",
            Self::ReverseChatter => "bounces grow out of rolling",
            Self::Level => "orbits of rolling",
            Self::BandOfRest => "band of rest",
        }
    }

    /// What it means to the hoop, in a sentence; none of those that the label explains.
    pub const fn meaning(self) -> Option<&'static str> {
        match self {
            Self::SlipLimit => Some("rolling uses up all friction: beyond it, it slips"),
            Self::NormalForceZero => Some("a rolling hoop would no longer press on the ground"),
            Self::LiftOff => Some("above it: it leaves the ground at once"),
            Self::BandOfRest => Some("without motion it stays here: the ground holds it"),
            Self::Separatrix | Self::ReverseChatter | Self::Level => None,
        }
    }

    /// What holds on it, as the label says.
    pub fn condition(self, slope: f64) -> &'static str {
        let label = self.label(slope);
        label
            .split_once(": ")
            .map_or(label, |(_, condition)| condition)
    }

    /// Its pieces in a window of the plane of a hoop; of orbits as many as are told apart.
    pub fn pieces(self, plane: &PhasePlane, window: &Window) -> Vec<Vec<[f64; 2]>> {
        match self {
            Self::SlipLimit => plane.slip_curve(window),
            Self::NormalForceZero => plane.normal_force_curve(window),
            Self::Separatrix => plane.separatrix_curve(window),
            Self::LiftOff => plane.lift_off_curve(window),
            Self::ReverseChatter => plane.reverse_chatter_curve(window),
            Self::Level => plane.orbits(window, FROM_REST, OVER_TOP),
            Self::BandOfRest => {
                let band = plane.band_of_rest(window).into_iter();
                band.map(|ends| ends.map(|theta| [theta, 0.0]).to_vec())
                    .collect()
            }
        }
    }

    /// Where its letter stands in a window: on the curve, at about a part of its lowest point in
    /// sight, near θ = π/2; below θ′ = 0, as the motions of the paper are above. None without a
    /// letter, or where the curve does not pass.
    pub fn place_of_letter(self, plane: &PhasePlane, window: &Window) -> Option<[f64; 2]> {
        let part = match self {
            Self::SlipLimit => 0.66,
            Self::NormalForceZero => 0.86,
            Self::Separatrix
            | Self::LiftOff
            | Self::ReverseChatter
            | Self::Level
            | Self::BandOfRest => return None,
        };
        let pieces = self.pieces(plane, window);
        let lowest = pieces
            .iter()
            .flatten()
            .map(|[_, rate]| *rate)
            .fold(0.0, f64::min);
        let wanted = part * lowest;
        let margin = 0.02 * (window.x[1] - window.x[0]);
        let is_inside = |theta: f64| theta > window.x[0] + margin && theta < window.x[1] - margin;
        let on_chord = |chord: &[[f64; 2]]| {
            let ([x, y], [to_x, to_y]) = (chord[0], chord[1]);
            let along = if y == to_y {
                (FRAC_PI_2 - x) / (to_x - x)
            } else {
                (wanted - y) / (to_y - y)
            }
            .clamp(0.0, 1.0);
            [x + along * (to_x - x), y + along * (to_y - y)]
        };
        let far = |[x, y]: &[f64; 2]| ((y - wanted) / lowest).abs() + 0.05 * (x - FRAC_PI_2).abs();
        let places = pieces
            .iter()
            .flat_map(|piece| piece.windows(2))
            .map(on_chord);
        places
            .filter(|[x, _]| is_inside(*x))
            .min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::SlipLimit => Arrow::FrictionForce.colour(theme),
            Self::NormalForceZero | Self::LiftOff => Arrow::NormalForce.colour(theme),
            Self::Separatrix => Ink::Ink.colour(theme),
            Self::ReverseChatter => Arrow::Impulse.colour(theme),
            Self::Level => Ink::Faint.colour(theme),
            Self::BandOfRest => of_mode(Mode::Rest, theme),
        }
    }

    /// Dashes.
    pub const fn dash(self) -> Dash {
        match self {
            Self::SlipLimit => Dash::Dashed,
            Self::LiftOff => Dash::Short,
            Self::ReverseChatter => Dash::Dotted,
            Self::NormalForceZero | Self::Separatrix | Self::Level | Self::BandOfRest => {
                Dash::Solid
            }
        }
    }

    /// Width in pixels of 1/96 inch.
    pub const fn width(self) -> f64 {
        match self {
            Self::SlipLimit | Self::NormalForceZero => BOLD,
            Self::Separatrix | Self::LiftOff | Self::ReverseChatter => CURVE,
            Self::Level => FINE,
            Self::BandOfRest => 2.0 * BOLD,
        }
    }
}
