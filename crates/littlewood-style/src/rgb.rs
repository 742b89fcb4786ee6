//! A colour, how light it is, and how it looks in grey.

/// A colour of the sRGB space: red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[must_use]
pub struct Rgb(pub [u8; 3]);

impl Rgb {
    /// Of a number like `0x004b87`.
    pub(crate) const fn of_hex(hex: u32) -> Self {
        let [_, red, green, blue] = hex.to_be_bytes();
        Self([red, green, blue])
    }

    /// As style sheets and programs that plot write it: `#004b87`.
    pub fn hex(self) -> String {
        let [red, green, blue] = self.0;
        format!("#{red:02x}{green:02x}{blue:02x}")
    }

    /// Relative luminance, 0 to 1 (WCAG 2).
    pub fn luminance(self) -> f64 {
        let [red, green, blue] = self.0.map(|value| {
            let value = f64::from(value) / 255.0;
            if value <= 0.040_45 {
                value / 12.92
            } else {
                libm::pow((value + 0.055) / 1.055, 2.4)
            }
        });
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }

    /// CIE lightness L*, 0 to 100: what is left of a colour in grey.
    pub fn lightness(self) -> f64 {
        let luminance = self.luminance();
        if luminance > 0.008_856 {
            116.0 * libm::cbrt(luminance) - 16.0
        } else {
            903.3 * luminance
        }
    }

    /// Contrast ratio of two colours, 1 to 21 (WCAG 2).
    pub fn contrast(self, other: Self) -> f64 {
        let (a, b) = (self.luminance() + 0.05, other.luminance() + 0.05);
        f64::max(a, b) / f64::min(a, b)
    }

    /// The more legible of two colours on this one.
    pub fn more_legible(self, a: Self, b: Self) -> Self {
        if self.contrast(a) >= self.contrast(b) {
            a
        } else {
            b
        }
    }

    /// This colour laid over another with an opacity from 0 to 1.
    pub fn over(self, ground: Self, opacity: f64) -> Self {
        Self(core::array::from_fn(|k| {
            let [above, below] = [self.0[k], ground.0[k]].map(f64::from);
            libm::round(opacity * above + (1.0 - opacity) * below) as u8
        }))
    }
}
