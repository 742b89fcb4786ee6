//! Colours of the films: those of [`littlewood_style`] on white paper.

use littlewood::Mode;
use littlewood_style::{Arrow, EnergyPart, Ink, Rgb, Theme};

/// What films are drawn on.
pub(crate) const THEME: Theme = Theme::Light;

pub(crate) const PAPER: Rgb = Ink::Paper.colour(THEME);
pub(crate) const INK: Rgb = Ink::Ink.colour(THEME);
pub(crate) const SOFT: Rgb = Ink::Soft.colour(THEME);
pub(crate) const LINE: Rgb = Ink::Line.colour(THEME);
pub(crate) const GROUND: Rgb = Ink::Ground.colour(THEME);

pub(crate) const NORMAL_FORCE: Rgb = Arrow::NormalForce.colour(THEME);
pub(crate) const FRICTION_FORCE: Rgb = Arrow::FrictionForce.colour(THEME);
pub(crate) const SLIP: Rgb = Arrow::Slip.colour(THEME);

pub(crate) const IMPULSE: Rgb = Arrow::Impulse.colour(THEME);

/// Colour of the region where the hoop can roll.
pub(crate) const fn of_region() -> Rgb {
    Ink::Region.colour(THEME)
}

/// Colour of a part of the energy.
pub(crate) const fn of_energy(part: EnergyPart) -> Rgb {
    part.colour(THEME)
}

/// Colour of a mode.
pub(crate) const fn of_mode(mode: Mode) -> Rgb {
    littlewood_style::of_mode(mode, THEME)
}

/// Colour of letters on a patch in the colour of a mode.
pub(crate) fn on_mode(mode: Mode) -> Rgb {
    of_mode(mode).more_legible(INK, PAPER)
}

/// All colours that are drawn with, with impulses and energies only where these are shown; what else there is in a picture
/// are mixtures at edges.
pub(crate) fn all(with_energies: bool) -> Vec<Rgb> {
    let energies = EnergyPart::ALL.map(of_energy).into_iter().chain([IMPULSE]).filter(|_| with_energies);
    [PAPER, INK, SOFT, LINE, GROUND, of_region(), NORMAL_FORCE, FRICTION_FORCE, SLIP]
        .into_iter()
        .chain(Mode::ALL.map(of_mode))
        .chain(energies)
        .collect()
}
