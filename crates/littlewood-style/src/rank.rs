//! Colours for a list whose length is not known before: the sequences of a map, the most frequent first.

use crate::rgb::Rgb;
use crate::theme::Theme;

/// Ranks that have a colour of their own.
pub const RANKS: usize = 11;

/// Colour of a rank, from 0; all from [`RANKS`] on have one. Neighbours differ in lightness.
#[must_use]
pub const fn of_rank(rank: usize, theme: Theme) -> Rgb {
    match rank {
        0 => theme.pick(0xc9dcec, 0x1e3a52),
        1 => theme.pick(0x23366e, 0xa9bdf2),
        2 => theme.pick(0xe8a83a, 0x7a5200),
        3 => theme.pick(0x8a2f5c, 0xf0a3c8),
        4 => theme.pick(0x93c8a4, 0x1d5c38),
        5 => theme.pick(0x5a3a12, 0xe2c39a),
        6 => theme.pick(0xb9a5dd, 0x4b3a7d),
        7 => theme.pick(0x2f6b4f, 0x8fd6b4),
        8 => theme.pick(0xd9795f, 0x8a3220),
        9 => theme.pick(0x3a7fb0, 0x9ed4f7),
        10 => theme.pick(0xefe2b2, 0x5b5220),
        _ => theme.pick(0x9a9a9a, 0x6f6f6f),
    }
}
