//! Modes of motion.

use littlewood::Mode;

use crate::dash::Dash;
use crate::rgb::Rgb;
use crate::theme::Theme;

/// Colour of a mode.
pub const fn of_mode(mode: Mode, theme: Theme) -> Rgb {
    match mode {
        Mode::Rolling => theme.pick(0x004b87, 0x018de9),
        Mode::Sliding => theme.pick(0xbf5300, 0xfb9d52),
        Mode::Gliding => theme.pick(0xc66d9e, 0xec98d6),
        Mode::Flight => theme.pick(0x2e9dd4, 0x95e1fa),
        Mode::Rest => theme.pick(0x300000, 0xfcfcc0),
        Mode::Skidding => theme.pick(0x300c8a, 0x7d3fdc),
    }
}

/// Dashes of a line that shows a mode.
pub const fn dash_of(mode: Mode) -> Dash {
    match mode {
        Mode::Rolling => Dash::Solid,
        Mode::Sliding => Dash::Dashed,
        Mode::Gliding => Dash::DashDot,
        Mode::Flight => Dash::Dotted,
        Mode::Rest => Dash::DashDotDot,
        Mode::Skidding => Dash::Short,
    }
}
