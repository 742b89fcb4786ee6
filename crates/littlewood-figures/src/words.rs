//! Symbols and numbers as they are printed.

use littlewood_style::ticks;

/// A symbol or a unit as it is printed, with marks: letters are italic, an index stands below the line, an exponent
/// above it. Small letters after a capital one are its index.
pub(crate) fn marked(sign: &str) -> String {
    let mut out = String::new();
    let mut letters = sign.chars().peekable();
    while let Some(letter) = letters.next() {
        if let Some(index) = lowered(letter) {
            out += &format!("_{{{index}}}");
        } else if letter == '²' {
            out += "^{2}";
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

/// The letter or digit of which this is the small one below the line.
const fn lowered(letter: char) -> Option<char> {
    match letter {
        '₁' => Some('1'),
        '₂' => Some('2'),
        'ₛ' => Some('s'),
        'ₖ' => Some('k'),
        _ => None,
    }
}

/// A number for print, with the minus sign of print.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    ticks::minus(if text == "-0" { "0" } else { text })
}

#[cfg(test)]
mod tests {
    use littlewood::{Cause, Class, Dimension, Mode, OutcomeKind, Quantity, SampleColumn};

    use super::*;
    use crate::draw::missing;

    #[test]
    fn signs_are_marked() {
        assert_eq!(marked("Izz/(m₂R²)"), "*I*_{zz}/(*m*_{2}*R*^{2})");
        assert_eq!(marked("m₂√(gR)"), "*m*_{2}√(*gR*)");
        assert_eq!(marked("θ′"), "*θ*′");
        assert_eq!(marked("μₛ"), "*μ*_{s}");
    }

    #[test]
    fn the_faces_have_the_letters_that_figures_take_from_the_tables() {
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
