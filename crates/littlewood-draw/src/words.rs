//! Symbols and numbers as they are printed.

use core::f64::consts::PI;

use littlewood_style::ticks;

use crate::markup::{Script, small};

/// A symbol or a unit as it is printed, with marks: letters are italic, an index stands below the
/// line, an exponent above it. Small letters after a capital one are its index; other words of
/// three and more are names of functions, and upright.
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
            out += &if word.len() > 2 {
                word
            } else {
                format!("*{word}*")
            };
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
    let own = whole
        .trim_start_matches(['-', '0', '.'])
        .chars()
        .filter(char::is_ascii_digit)
        .count();
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
    let is_one =
        twelfths != 0.0 && (value - twelfths * PI / 12.0).abs() < 1e-12 && twelfths.abs() < 100.0;
    if is_one {
        ticks::of_pi(twelfths as i64, 12)
    } else {
        short(value)
    }
}
