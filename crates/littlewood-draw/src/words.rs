//! Symbols and numbers as they are printed.

use core::f64::consts::PI;

use littlewood_style::ticks;

use crate::markup::{Script, small};

/// A symbol or a unit as it is printed, with marks: letters are italic, an index stands below the line, an exponent
/// above it. Small letters after a capital one are its index; other words of three and more are names of functions, and upright.
pub fn marked(sign: &str) -> String {
    let mut out = String::new();
    let mut letters = sign.chars().peekable();
    while let Some(letter) = letters.next() {
        if let Some((plain, script)) = small(letter) {
            let mark = if script == Script::Sub { '_' } else { '^' };
            out += &format!("{mark}{{{plain}}}");
        } else if letter.is_ascii_lowercase() {
            let mut word = letter.to_string();
            while let Some(next) = letters.next_if(char::is_ascii_lowercase) {
                word.push(next);
            }
            out += &if word.len() > 2 { word } else { format!("*{word}*") };
        } else if letter.is_alphabetic() {
            out += &format!("*{letter}*");
            let mut index = String::new();
            while letter.is_uppercase()
                && let Some(small) = letters.next_if(char::is_ascii_lowercase)
            {
                index.push(small);
            }
            if !index.is_empty() {
                out += &format!("_{{{index}}}");
            }
        } else {
            out.push(letter);
        }
    }
    // Italics that end and begin again at once go on.
    out.replace("**", "")
}

/// Digits of a number for print, and decimals, at least.
const DIGITS: i32 = 4;
/// A number that has no more digits than this is printed whole.
const WHOLE: usize = 6;

/// A number for print, without trailing zeros, with the minus sign of print; with marks.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return ticks::minus(&value.to_string());
    }
    let decade = libm::floor(libm::log10(value.abs())) as i32;
    if !(-5..7).contains(&decade) {
        let text = format!("{value:.digits$e}", digits = DIGITS as usize - 1);
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
        let factor = match mantissa {
            "1" => String::new(),
            "-1" => "-".to_owned(),
            other => format!("{other}×"),
        };
        return ticks::minus(&format!("{factor}10^{{{power}}}"));
    }
    let whole = value.to_string();
    let own = whole.trim_start_matches(['-', '0', '.']).chars().filter(char::is_ascii_digit).count();
    if own <= WHOLE {
        return ticks::minus(&whole);
    }
    let digits = DIGITS.max(DIGITS - 1 - decade) as usize;
    let text = format!("{value:.digits$}");
    ticks::minus(text.trim_end_matches('0').trim_end_matches('.'))
}

/// An angle for print, rad: a multiple of π/12, if it is one.
pub fn angle(value: f64) -> String {
    let twelfths = libm::round(12.0 * value / PI);
    let is_one = twelfths != 0.0 && (value - twelfths * PI / 12.0).abs() < 1e-12 && twelfths.abs() < 100.0;
    if is_one { ticks::of_pi(twelfths as i64, 12) } else { short(value) }
}

#[cfg(test)]
mod tests {
    use littlewood::tables::{Class, Dimension, Quantity, SampleColumn};
    use littlewood::{Cause, Mode, OutcomeKind};

    use super::*;
    use crate::letters::missing;

    #[test]
    fn signs_are_marked() {
        assert_eq!(marked("Izz/(m₂R²)"), "*I*_{zz}/(*m*_{2}*R*^{2})");
        assert_eq!(marked("m₂√(gR)"), "*m*_{2}√(*gR*)");
        assert_eq!(marked("θ′"), "*θ*′");
        assert_eq!(marked("dθ/dt = h cos α"), "*dθ*/*dt* = *h* cos *α*");
        assert_eq!(marked("μₛ"), "*μ*_{s}");
    }

    #[test]
    fn numbers_have_four_digits_and_four_decimals() {
        assert_eq!(short(2.0), "2");
        assert_eq!(short(-0.0), "0");
        assert_eq!(short(core::f64::consts::FRAC_PI_2), "1.5708");
        assert_eq!(short(0.000_123_456_7), "0.0001235");
        assert_eq!(short(-12.5), "−12.5");
        assert_eq!(short(53.130_102), "53.1301");
        assert_eq!((short(9.80665), short(1000.0)), ("9.80665".to_owned(), "1000".to_owned()));
        assert_eq!(short(123_456.7), "123456.7");
        assert_eq!(short(1.5e-9), "1.5×10^{−9}");
        assert_eq!(short(-1e9), "−10^{9}");
    }

    #[test]
    fn the_faces_have_the_letters_of_the_tables() {
        for sign in Quantity::ALL
            .iter()
            .map(|quantity| quantity.sign())
            .chain([SampleColumn::Normal.sign(), SampleColumn::Friction.sign()])
            .chain([Dimension::Force.scale_sign(), Dimension::Energy.scale_sign()])
            .chain(Quantity::ALL.iter().map(|quantity| quantity.unit_sign()))
        {
            assert_eq!(missing(&marked(sign)), "", "{sign}");
        }
        for label in Class::ALL
            .iter()
            .map(|class| class.label())
            .chain(Cause::ALL.iter().map(|cause| cause.label()))
            .chain(OutcomeKind::ALL.iter().map(|outcome| outcome.label()))
            .chain(Mode::NAMES)
        {
            assert_eq!(missing(label), "", "{label}");
        }
    }
}
