//! Texts as outlines: which letter stands where, and the curves of each.

use std::collections::HashMap;
use std::sync::OnceLock;

use crate::markup::{Script, private, runs, scripted, small, symbol};
use crate::primitives::{Point, Segment};

/// Size of an index or exponent.
const SCRIPT_SIZE: f64 = 0.72;
/// How far an index stands below the line and an exponent above it, in parts of the size.
const DOWN: f64 = 0.22;
const UP: f64 = 0.36;

impl Script {
    /// Size of its letters and how far they stand below the line, of a text of a size.
    fn placed(self, size: f64) -> [f64; 2] {
        match self {
            Self::Line => [size, 0.0],
            Self::Sub => [SCRIPT_SIZE * size, DOWN * size],
            Self::Super => [SCRIPT_SIZE * size, -UP * size],
        }
    }
}

/// A letter as it is drawn.
#[derive(Debug)]
pub(crate) struct Letter {
    /// A name that means the same letter in every drawing.
    pub(crate) name: String,
    /// Its outline as an SVG path, in thousandths of the size, upwards positive.
    pub(crate) path: &'static str,
    /// Its width, in the same unit.
    pub(crate) advance: f64,
    /// The letter itself.
    #[cfg_attr(
        not(feature = "pdf"),
        expect(dead_code, reason = "a PDF alone says which letters its outlines are")
    )]
    pub(crate) sign: char,
}

/// The letters by whether they are italic, and their code.
fn letters() -> &'static HashMap<(bool, char), Letter> {
    static LETTERS: OnceLock<HashMap<(bool, char), Letter>> = OnceLock::new();
    LETTERS.get_or_init(|| {
        include_str!("../fonts/letters.txt")
            .lines()
            .filter_map(letter)
            .collect()
    })
}

fn letter(line: &'static str) -> Option<((bool, char), Letter)> {
    let mut parts = line.splitn(4, ' ');
    let (face, code, advance) = (parts.next()?, parts.next()?, parts.next()?.parse().ok()?);
    let sign = char::from_u32(u32::from_str_radix(code, 16).ok()?)?;
    let path = parts.next().unwrap_or_default();
    Some((
        (face == "i", sign),
        Letter {
            name: format!("{face}{code}"),
            path,
            advance,
            sign,
        },
    ))
}

/// All letters, each with the sign of Unicode that is this letter in plain text: italic ones are
/// mathematical symbols, and small ones below and above the line are signs, too. With their sizes,
/// and how far they stand below the line.
pub(crate) fn all() -> impl Iterator<Item = (char, &'static Letter, [f64; 2])> {
    let sign = |italic, letter| if italic { symbol(letter) } else { letter };
    let own = letters()
        .iter()
        .map(move |(&(italic, letter), own)| (sign(italic, letter), own, [1.0, 0.0]));
    let ascii = ('!'..='~').flat_map(|plain| {
        [Script::Sub, Script::Super].map(|script| (private(plain, script), plain, script))
    });
    own.chain(scripted().chain(ascii).filter_map(|(sign, plain, script)| {
        Some((sign, of_text(false, plain)?, script.placed(1.0)))
    }))
}

/// The letter of a text: in italics those that have them.
fn of_text(italic: bool, letter: char) -> Option<&'static Letter> {
    letters()
        .get(&(italic, letter))
        .or_else(|| letters().get(&(false, letter)))
}

/// A letter of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Glyph {
    pub(crate) letter: &'static Letter,
    /// How far it stands from the beginning of the text, to the right and downwards.
    pub(crate) at: [f64; 2],
    /// Length of a unit of its outline.
    pub(crate) unit: f64,
    /// Width of a line along its outline, which makes it bold; zero for others.
    pub(crate) bold: f64,
}

/// The same in parts of the size.
const BOLD: f64 = 0.045;

/// The letters of a text, and its width.
fn set(text: &str, size: f64) -> (Vec<Glyph>, f64) {
    let (mut glyphs, mut across) = (Vec::new(), 0.0);
    for run in runs(text) {
        for letter in run.text.chars() {
            let (plain, script) = small(letter).unwrap_or((letter, run.script));
            // What no face has is seen as a question mark.
            let Some(letter) = of_text(run.italic, plain).or_else(|| of_text(false, '?')) else {
                continue;
            };
            let [scale, down] = script.placed(size);
            let unit = scale / 1000.0;
            let bold = if run.bold { BOLD * scale } else { 0.0 };
            glyphs.push(Glyph {
                letter,
                at: [across, down],
                unit,
                bold,
            });
            across += unit * letter.advance;
        }
    }
    (glyphs, across)
}

/// The letters of a text.
pub(crate) fn glyphs(text: &str, size: f64) -> Vec<Glyph> {
    set(text, size).0
}

/// Width of a text with marks, in the unit of its size.
pub fn width(text: &str, size: f64) -> f64 {
    set(text, size).1
}

/// Stands for an equals sign with its room, as a part of a word.
const EQUALS: &str = "\u{a0}=\u{a0}";

/// A text with marks in lines no wider than there is room, as far as words are not. A line does not
/// end within an equation.
pub fn wrapped(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let text = text.replace(" = ", EQUALS);
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        let word = &word.replace(EQUALS, " = ");
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The pieces of an outline, in thousandths of the size, upwards positive.
pub(crate) fn outline(path: &str) -> impl Iterator<Item = Segment> {
    let is_kind = |letter: char| letter.is_ascii_uppercase();
    path.match_indices(is_kind).filter_map(move |(at, kind)| {
        let numbers = path[at + kind.len()..].split(is_kind).next()?;
        let mut numbers = numbers.split(' ').filter_map(|number| number.parse().ok());
        let mut point = || Some(Point::new(numbers.next()?, numbers.next()?));
        match kind {
            "M" => Some(Segment::Move(point()?)),
            "L" => Some(Segment::Line(point()?)),
            "Q" => Some(Segment::Quad(point()?, point()?)),
            _ => Some(Segment::Close),
        }
    })
}

/// The outlines of the letters of a text, with marks, that begins at the origin, downwards
/// positive; each with the width of a line along it, which makes it bold.
pub fn outlines(text: &str, size: f64) -> impl Iterator<Item = (Vec<Segment>, f64)> {
    glyphs(text, size).into_iter().map(
        |Glyph {
             letter,
             at: [right, down],
             unit,
             bold,
         }| {
            let place = |at: Point| Point::new(right + unit * at.x, down - unit * at.y);
            (
                outline(letter.path)
                    .map(|segment| segment.placed(place))
                    .collect(),
                bold,
            )
        },
    )
}

/// Letters of a text, with marks, that no face has.
pub fn missing(text: &str) -> String {
    let plain = |letter| small(letter).map_or(letter, |(plain, _)| plain);
    runs(text)
        .into_iter()
        .flat_map(|run| {
            run.text
                .chars()
                .filter(move |&letter| of_text(run.italic, plain(letter)).is_none())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_stand_one_after_another() {
        let found = glyphs("*μ*_{s}*N*", 10.0);
        assert_eq!(found.len(), 3);
        assert!(found.windows(2).all(|pair| pair[0].at[0] < pair[1].at[0]));
        assert_eq!(found[1].at[1], DOWN * 10.0);
    }

    #[test]
    fn every_letter_has_a_closed_outline_and_nothing_of_it_is_lost() {
        for (key, letter) in letters() {
            let strokes: Vec<Segment> = outline(letter.path).collect();
            let kinds = |kind: char| letter.path.matches(kind).count();
            let of = |is: fn(&Segment) -> bool| strokes.iter().filter(|stroke| is(stroke)).count();
            assert_eq!(of(|s| matches!(s, Segment::Move(_))), kinds('M'), "{key:?}");
            assert_eq!(of(|s| matches!(s, Segment::Line(_))), kinds('L'), "{key:?}");
            assert_eq!(
                of(|s| matches!(s, Segment::Quad(..))),
                kinds('Q'),
                "{key:?}"
            );
            assert_eq!(of(|s| matches!(s, Segment::Close)), kinds('Z'), "{key:?}");
            assert_eq!(kinds('C'), 0, "{key:?}");
            assert!(
                letter.path.is_empty()
                    || matches!(strokes[..], [Segment::Move(_), .., Segment::Close])
            );
        }
    }
}
