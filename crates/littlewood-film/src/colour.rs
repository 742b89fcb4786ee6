//! Colours of the films: those of the figures.

use littlewood::Mode;
use littlewood_draw::{REGION, THEME};
use littlewood_style::{Accent, Arrow, EnergyPart, Ink, Rgb};

pub(crate) use littlewood_draw::{
    FRICTION_FORCE, GRID as LINE, IMPULSE, INK, NORMAL_FORCE, PAPER, SOFT,
};

pub(crate) const GROUND: Rgb = Ink::Ground.colour(THEME);
pub(crate) const SLIP: Rgb = Arrow::Slip.colour(THEME);

/// Colours of lanes, from the top.
pub(crate) const LANES: [Rgb; 2] = [Accent::Violet.colour(THEME), Accent::Teal.colour(THEME)];

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

/// All colours that are drawn with, with impulses and energies, and with lanes, only where these
/// are shown; what else there is in a picture are mixtures at edges.
pub(crate) fn all(with_energies: bool, with_lanes: bool) -> Vec<Rgb> {
    let energies = EnergyPart::ALL
        .map(of_energy)
        .into_iter()
        .chain([IMPULSE])
        .filter(|_| with_energies);
    [
        PAPER,
        INK,
        SOFT,
        LINE,
        GROUND,
        REGION,
        NORMAL_FORCE,
        FRICTION_FORCE,
        SLIP,
    ]
    .into_iter()
    .chain(Mode::ALL.map(of_mode))
    .chain(energies)
    .chain(LANES.into_iter().filter(|_| with_lanes))
    .collect()
}
