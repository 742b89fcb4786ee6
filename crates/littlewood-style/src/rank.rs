//! Colours for a list whose length is not known before: the sequences of a map, the most frequent
//! first. A sequence and its mirror image have one hue in two tints.

use crate::rgb::Rgb;
use crate::theme::Theme;

/// Hues.
pub const RANKS: usize = 6;

/// Colour of a rank, from 0, and of the mirror image; all from [`RANKS`] on have one. Neighbours
/// differ in lightness.
pub const fn of_rank(rank: usize, is_mirrored: bool, theme: Theme) -> Rgb {
    let [own, mirrored] = match rank {
        0 => [
            theme.pick(0xc9dcec, 0x1e3a52),
            theme.pick(0x8fb4d3, 0x34618a),
        ],
        1 => [
            theme.pick(0x23366e, 0xa9bdf2),
            theme.pick(0x5a70b4, 0x7289cf),
        ],
        2 => [
            theme.pick(0xe8a83a, 0x7a5200),
            theme.pick(0xf6d9a0, 0xb07a10),
        ],
        3 => [
            theme.pick(0x8a2f5c, 0xf0a3c8),
            theme.pick(0xc47ba0, 0xb56a91),
        ],
        4 => [
            theme.pick(0x93c8a4, 0x4e9a78),
            theme.pick(0x2f6b4f, 0x8fd6b4),
        ],
        5 => [
            theme.pick(0x5a3a12, 0xe2c39a),
            theme.pick(0xab8458, 0xab8458),
        ],
        _ => [theme.pick(0x9a9a9a, 0x6f6f6f); 2],
    };
    if is_mirrored { mirrored } else { own }
}
