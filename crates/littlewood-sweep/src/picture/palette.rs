//! Colours of the classes: told apart by the colour-blind, and by their lightness in grey.

use crate::outcome::Class;

/// A colour, red, green and blue.
pub(crate) type Rgb = [u8; 3];

/// Colour of points where a column has no value.
pub(crate) const NOTHING: Rgb = [0xe4, 0xe4, 0xe4];

/// Colour of a class.
pub(crate) const fn of_class(class: Class) -> Rgb {
    match class {
        Class::LeavesAtOnce => [0x22, 0x22, 0x5c],
        Class::LiftsOffLater => [0xd5, 0x5e, 0x00],
        Class::RollsForever => [0xd3, 0xea, 0xf5],
        Class::SlidesForever => [0x2a, 0xa1, 0x98],
        Class::InContactAtLimit => [0x56, 0xb4, 0xe9],
        Class::ParticleAtPlane => [0xd9, 0x88, 0xb8],
        Class::ParticleAtBottom => [0x7a, 0x3b, 0x69],
        Class::ParticleAtTop => [0xf0, 0xe4, 0x42],
        Class::Painleve => [0x00, 0x00, 0x00],
        Class::Unresolved => [0x77, 0x77, 0x77],
        Class::Invalid => NOTHING,
        Class::NotComputed => [0xff, 0xff, 0xff],
    }
}

/// Colour of a fraction from 0 to 1 on the scale of continuous columns.
pub(crate) fn of_fraction(fraction: f64) -> Rgb {
    colorous::VIRIDIS.eval_continuous(fraction.clamp(0.0, 1.0)).into_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE lightness L*, 0 to 100.
    fn lightness(colour: Rgb) -> f64 {
        let linear = colour.map(|value| {
            let value = f64::from(value) / 255.0;
            if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        });
        let y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
        if y > 0.008_856 { 116.0 * libm::cbrt(y) - 16.0 } else { 903.3 * y }
    }

    #[test]
    fn classes_that_meet_in_one_map_differ_in_grey() {
        let heavy = [
            Class::LeavesAtOnce,
            Class::LiftsOffLater,
            Class::InContactAtLimit,
            Class::RollsForever,
            Class::Painleve,
        ];
        let massless =
            [Class::ParticleAtPlane, Class::RollsForever, Class::ParticleAtBottom, Class::Painleve];
        for set in [&heavy[..], &massless] {
            for (i, &a) in set.iter().enumerate() {
                for &b in &set[..i] {
                    let gap = (lightness(of_class(a)) - lightness(of_class(b))).abs();
                    assert!(gap > 12.0, "{a:?} and {b:?}: {gap}");
                }
            }
        }
    }

    #[test]
    fn the_scale_grows_lighter() {
        let scale: Vec<f64> = (0..=20).map(|i| lightness(of_fraction(f64::from(i) / 20.0))).collect();
        assert!(scale.windows(2).all(|pair| pair[1] > pair[0]), "{scale:?}");
    }
}
