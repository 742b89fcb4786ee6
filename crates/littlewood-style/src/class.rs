//! Classes of outcomes.

use littlewood::tables::Class;

use core::f64::consts::TAU;

use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;

/// Colour of a class of outcomes.
pub const fn of_class(class: Class, theme: Theme) -> Rgb {
    match class {
        Class::LeavesAtOnce => theme.pick(0x191b54, 0xe8d5ff),
        Class::LiftsOffLater => theme.pick(0xdf9a01, 0x795100),
        Class::RollsForever => theme.pick(0xbad0db, 0x00415b),
        Class::RepeatsForever => theme.pick(0x004844, 0x5dcbc1),
        Class::SlipsForever => theme.pick(0x6a2f12, 0xe7ac93),
        Class::InContact => theme.pick(0x74849b, 0x69798f),
        Class::ParticleAtPlane => theme.pick(0xb69ec9, 0x665177),
        Class::ParticleAtBottom => theme.pick(0x400f33, 0xffcfdc),
        Class::ParticleAtTop => theme.pick(0x686300, 0xa39b00),
        Class::Rests => theme.pick(0xb4d89a, 0x184413),
        Class::Painleve => theme.pick(0x000000, 0xffffff),
        Class::Unresolved => theme.pick(0x616161, 0x989898),
        Class::Invalid => theme.pick(0xe4e4e4, 0x292929),
        // The paper.
        Class::NotComputed => theme.pick(0xffffff, 0x14171d),
    }
}

named! {
    /// Where a hoop rests: in which turn between two tops.
    pub enum RestingPlace {
        /// Two turns back or more.
        FarBack = "rests_far_back",
        /// One turn back.
        Back = "rests_back",
        /// Between the tops 0 and 2π.
        Here = "rests_here",
        /// One turn on.
        On = "rests_on",
        /// Two turns on or more.
        FarOn = "rests_far_on",
    }
}

impl RestingPlace {
    /// Of an angle θ.
    pub fn of(theta: f64) -> Self {
        let turn = libm::floor(theta / TAU);
        if turn < -1.0 {
            Self::FarBack
        } else if turn < 0.0 {
            Self::Back
        } else if turn < 1.0 {
            Self::Here
        } else if turn < 2.0 {
            Self::On
        } else {
            Self::FarOn
        }
    }

    /// In words, for legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::FarBack => "rests, θ < −2π",
            Self::Back => "rests, −2π < θ < 0",
            Self::Here => "rests, 0 < θ < 2π",
            Self::On => "rests, 2π < θ < 4π",
            Self::FarOn => "rests, θ > 4π",
        }
    }

    /// Colour: shades of that of all that rest.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::FarBack => theme.pick(0x335423, 0xd6efc4),
            Self::Back => theme.pick(0x5b8346, 0xa3c98c),
            Self::Here => of_class(Class::Rests, theme),
            Self::On => theme.pick(0x8bb374, 0x6f9a58),
            Self::FarOn => theme.pick(0xe9f7e0, 0x45692f),
        }
    }
}
