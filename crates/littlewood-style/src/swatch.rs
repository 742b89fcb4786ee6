//! All colours as one table, for style sheets and other languages.

use littlewood::Mode;
use littlewood::tables::Class;

use crate::accent::Accent;
use crate::arrow::Arrow;
use crate::class::of_class;
use crate::curve::Curve;
use crate::energy::EnergyPart;
use crate::impulse::ImpulseLine;
use crate::ink::Ink;
use crate::mode::of_mode;
use crate::rgb::Rgb;
use crate::theme::Theme;

/// A colour with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Swatch {
    /// What kind of thing has it: `ink`, `mode`, `class`, `arrow`, `curve`, `impulse`, `energy` or
    /// `accent`.
    pub group: &'static str,
    /// Which one.
    pub name: &'static str,
    /// The colour.
    pub colour: Rgb,
}

/// All colours on a paper.
pub fn swatches(theme: Theme) -> Vec<Swatch> {
    let mut swatches = Vec::new();
    let mut add = |group, name, colour| {
        swatches.push(Swatch {
            group,
            name,
            colour,
        });
    };
    for ink in Ink::ALL {
        add("ink", ink.name(), ink.colour(theme));
    }
    for mode in Mode::ALL {
        add("mode", mode.name(), of_mode(mode, theme));
    }
    for class in Class::ALL {
        add("class", class.name(), of_class(class, theme));
    }
    for arrow in Arrow::ALL {
        add("arrow", arrow.name(), arrow.colour(theme));
    }
    for curve in Curve::ALL {
        add("curve", curve.name(), curve.colour(theme));
    }
    for line in ImpulseLine::ALL {
        add("impulse", line.name(), line.colour(theme));
    }
    for part in EnergyPart::ALL {
        add("energy", part.name(), part.colour(theme));
    }
    for accent in Accent::ALL {
        add("accent", accent.name(), accent.colour(theme));
    }
    swatches
}
