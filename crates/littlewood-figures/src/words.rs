//! Quantities, hoops and starts in captions and on axes.

use core::f64::consts::PI;

use littlewood::{Dimension, Group, Hoop, Quantity, Setup, Start};
use littlewood_style::ticks;

/// Parameters on which rolling depends.
const ROLLING: [Quantity; 4] = [Quantity::MassRatio, Quantity::Offset, Quantity::Inertia, Quantity::MuS];

/// The parameters of a hoop, with marks; with the law, if it has a coefficient of restitution.
pub(crate) fn hoop_in_words(hoop: &Hoop) -> String {
    let law = hoop.restitution().map_or_else(String::new, |e| format!(", law: {}", e.law().label()));
    listed(hoop, Quantity::HOOP) + &law
}

/// Those parameters of a hoop on which rolling depends, with marks.
pub(crate) fn rolling_in_words(hoop: &Hoop) -> String {
    listed(hoop, ROLLING)
}

/// Those parameters of a hoop that do not concern friction, with marks.
pub(crate) fn body_in_words(hoop: &Hoop) -> String {
    listed(hoop, ROLLING.into_iter().filter(|quantity| *quantity != Quantity::MuS))
}

fn listed(hoop: &Hoop, quantities: impl IntoIterator<Item = Quantity>) -> String {
    let setup = Setup::new(hoop.parameters(), Start::default());
    let words: Vec<String> = quantities
        .into_iter()
        .filter_map(|quantity| Some(format!("{} = {}", marked(quantity.sign()), short(setup.get(quantity)?))))
        .collect();
    words.join(", ")
}

/// A start, with marks.
pub(crate) fn start_in_words(hoop: &Hoop, start: &Start) -> String {
    let setup = Setup::new(hoop.parameters(), *start);
    let words: Vec<String> = Quantity::START
        .into_iter()
        .filter(|quantity| quantity.group() == Group::Start)
        .filter_map(|quantity| {
            let value = setup.get(quantity)?;
            // Only a hoop that is thrown has a rate of the gap to speak of.
            if quantity == Quantity::GapRate && value == 0.0 {
                return None;
            }
            let angle = Some(value).filter(|_| quantity.dimension() == Dimension::Angle);
            let number = angle.and_then(fraction_of_pi).unwrap_or_else(|| short(value));
            Some(format!("{}(0) = {number}", marked(quantity.sign())))
        })
        .collect();
    words.join(", ")
}

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

/// A multiple of π/12, if it is one.
fn fraction_of_pi(value: f64) -> Option<String> {
    let twelfths = libm::round(12.0 * value / PI);
    let is_one = twelfths != 0.0 && (value - twelfths * PI / 12.0).abs() < 1e-12 && twelfths.abs() < 100.0;
    is_one.then(|| ticks::of_pi(twelfths as i64, 12))
}

#[cfg(test)]
mod tests {
    use littlewood::{Cause, Class, Mode, OutcomeKind, SampleColumn};

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
