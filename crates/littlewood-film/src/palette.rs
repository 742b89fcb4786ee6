//! Colours: told apart by the colour-blind, and by their lightness in grey.

use littlewood::Mode;

/// A colour, red, green and blue.
pub(crate) type Rgb = [u8; 3];

pub(crate) const PAPER: Rgb = [0xff, 0xff, 0xff];
pub(crate) const INK: Rgb = [0x22, 0x22, 0x22];
pub(crate) const SOFT: Rgb = [0x6b, 0x6b, 0x6b];
pub(crate) const PALE: Rgb = [0xc4, 0xc4, 0xc4];
pub(crate) const EARTH: Rgb = [0xec, 0xea, 0xe4];

pub(crate) const NORMAL: Rgb = [0x00, 0x6d, 0x4e];
pub(crate) const FRICTION: Rgb = [0x9a, 0x1b, 0x6a];
pub(crate) const SLIP: Rgb = [0xb8, 0x6f, 0x00];

/// All colours that are drawn with; what else there is in a picture are mixtures at edges.
pub(crate) const INKS: [Rgb; 12] = [
    PAPER,
    INK,
    SOFT,
    PALE,
    EARTH,
    NORMAL,
    FRICTION,
    SLIP,
    of_mode(Mode::Rolling),
    of_mode(Mode::Sliding),
    of_mode(Mode::Gliding),
    of_mode(Mode::Flight),
];

/// Colour of a mode.
pub(crate) const fn of_mode(mode: Mode) -> Rgb {
    match mode {
        Mode::Rolling => [0x00, 0x4b, 0x87],
        Mode::Sliding => [0xd5, 0x5e, 0x00],
        Mode::Gliding => [0xc8, 0x6f, 0xa0],
        Mode::Flight => [0x56, 0xb4, 0xe9],
    }
}

/// Colour of letters on a patch in the colour of a mode.
pub(crate) const fn on_mode(mode: Mode) -> Rgb {
    match mode {
        Mode::Rolling | Mode::Sliding => PAPER,
        Mode::Gliding | Mode::Flight => INK,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, 0 to 1 (WCAG 2).
    fn luminance(colour: Rgb) -> f64 {
        let [r, g, b] = colour.map(|value| {
            let value = f64::from(value) / 255.0;
            if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// CIE lightness L*, 0 to 100.
    fn lightness(colour: Rgb) -> f64 {
        116.0 * libm::cbrt(luminance(colour)) - 16.0
    }

    fn contrast(a: Rgb, b: Rgb) -> f64 {
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn modes_that_meet_in_one_film_differ_in_grey() {
        for set in [&[Mode::Rolling, Mode::Sliding, Mode::Flight][..], &[Mode::Rolling, Mode::Gliding]] {
            for (i, &a) in set.iter().enumerate() {
                for &b in &set[..i] {
                    let gap = (lightness(of_mode(a)) - lightness(of_mode(b))).abs();
                    assert!(gap > 12.0, "{a} and {b}: {gap}");
                }
            }
        }
    }

    #[test]
    fn letters_are_legible_on_what_they_stand_on() {
        for mode in Mode::ALL {
            // 3 is the bound of WCAG 2 for bold letters.
            assert!(contrast(of_mode(mode), on_mode(mode)) > 3.5, "{mode}");
        }
        for ink in [INK, SOFT, NORMAL, FRICTION, SLIP] {
            assert!(contrast(ink, PAPER) > 3.5, "{ink:?}");
        }
        assert!(contrast(SOFT, EARTH) > 4.0);
    }
}
