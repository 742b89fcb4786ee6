//! Letters as a font, TrueType: those of a document, in it, and all of them, for other programs.

use std::collections::BTreeMap;

#[cfg(feature = "pdf")]
use crate::letters::Letter;
use crate::letters::{all, outline};
use crate::primitives::{Point, Segment};

/// Its units to the size, of which all coordinates of the letters are whole numbers.
const UNITS: u16 = 2000;

/// The letters of a document, each with its number; zero is a blank.
#[cfg(feature = "pdf")]
#[derive(Debug, Default)]
pub(crate) struct Font(Vec<&'static Letter>);

/// A glyph of a font file, its width, and the box of its points.
#[derive(Default)]
struct Shape {
    width: i16,
    bytes: Vec<u8>,
    frame: [i16; 4],
    points: i16,
    contours: i16,
}

#[cfg(feature = "pdf")]
impl Font {
    /// The number of a letter, which belongs to the font from now on.
    pub(crate) fn number(&mut self, letter: &'static Letter) -> u16 {
        let known = self.0.iter().position(|own| own.name == letter.name);
        let place = known.unwrap_or_else(|| {
            self.0.push(letter);
            self.0.len() - 1
        });
        place as u16 + 1
    }

    /// The letters in the order of their numbers, from 1.
    pub(crate) fn letters(&self) -> &[&'static Letter] {
        &self.0
    }

    /// The font file.
    pub(crate) fn file(&self) -> Vec<u8> {
        file(
            self.0
                .iter()
                .map(|letter| shape(outline(letter.path), letter.advance)),
            Vec::new(),
        )
    }
}

/// When it was made and changed, in seconds from 1904: 1970, as an earlier time is taken for a
/// mistake.
const EPOCH: u64 = 2_082_844_800;

/// Name of the font of all letters.
const NAME: &str = "Littlewood";

/// All letters as a TrueType font, for other programs that draw. Italic letters are the
/// mathematical symbols of Unicode, and the small ones below and above the line stand at their
/// codes: it draws what [`unicode`](crate::unicode) returns.
pub fn font() -> Vec<u8> {
    let shapes: BTreeMap<char, Shape> = all()
        .map(|(sign, letter, [scale, down])| {
            let place = |at: Point| Point::new(scale * at.x, scale * at.y - 1000.0 * down);
            let outline = outline(letter.path).map(|segment| segment.placed(place));
            (sign, shape(outline, scale * letter.advance))
        })
        .collect();
    // Groups of one letter each: first code, last code, number.
    let groups = shapes
        .keys()
        .zip(1_u32..)
        .flat_map(|(&sign, number)| [u32::from(sign), u32::from(sign), number]);
    let count = shapes.len() as u32;
    // One table for all of Unicode, at byte 12, of format 12.
    let mut cmap = words([0, 1, 3, 10, 0, 12, 12, 0]);
    cmap.extend(
        [16 + 12 * count, 0, count]
            .into_iter()
            .chain(groups)
            .flat_map(u32::to_be_bytes),
    );
    // Family, style, whole name and name in PostScript: parts of one text.
    let style: Vec<u8> = "Regular"
        .encode_utf16()
        .flat_map(u16::to_be_bytes)
        .collect();
    let text: Vec<u8> = NAME.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let (long, short) = (text.len() as i16, style.len() as i16);
    let mut name = words([0, 4, 6 + 12 * 4]);
    for [kind, length, place] in [[1, long, 0], [2, short, long], [4, long, 0], [6, long, 0]] {
        name.extend(words([3, 1, 0x409, kind, length, place]));
    }
    name.extend(text.into_iter().chain(style));
    let post = [&[0, 3, 0, 0][..], &[0; 28]].concat();
    file(
        shapes.into_values(),
        vec![(*b"cmap", cmap), (*b"name", name), (*b"post", post)],
    )
}

/// A font file of shapes, their numbers from 1, with these tables more.
fn file(shapes: impl Iterator<Item = Shape>, mut tables: Vec<([u8; 4], Vec<u8>)>) -> Vec<u8> {
    let shapes: Vec<Shape> = core::iter::once(Shape::default()).chain(shapes).collect();
    let frame = shapes
        .iter()
        .fold([0; 4], |[left, low, right, high]: [i16; 4], shape| {
            let [a, b, c, d] = shape.frame;
            [left.min(a), low.min(b), right.max(c), high.max(d)]
        });
    let count = shapes.len() as i16;
    let most = |of: fn(&Shape) -> i16| shapes.iter().map(of).max().unwrap_or(0);
    let (mut glyf, mut loca) = (Vec::new(), Vec::new());
    for shape in &shapes {
        loca.extend((glyf.len() as u32).to_be_bytes());
        glyf.extend(&shape.bytes);
    }
    loca.extend((glyf.len() as u32).to_be_bytes());
    let hmtx = words(
        shapes
            .iter()
            .flat_map(|shape| [shape.width, shape.frame[0]]),
    );
    // The numbers in the order of the tables of the format; what only screens of few pixels need is
    // zero.
    let head = [
        &[
            0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0x5f, 0x0f, 0x3c, 0xf5, 0, 0,
        ][..],
        &UNITS.to_be_bytes(),
        &EPOCH.to_be_bytes(),
        &EPOCH.to_be_bytes(),
        &words(frame),
        &words([0, 8, 2, 1, 0]),
    ];
    let widest = most(|shape| shape.width);
    let [left, low, right, high] = frame;
    let hhea = words([
        1, 0, high, low, 0, widest, left, 0, right, 1, 0, 0, 0, 0, 0, 0, 0, count,
    ]);
    let [points, contours] = [most(|shape| shape.points), most(|shape| shape.contours)];
    let maxp = words([
        1, 0, count, points, contours, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
    ]);
    tables.extend([
        (*b"glyf", glyf),
        (*b"head", head.concat()),
        (*b"hhea", hhea),
        (*b"hmtx", hmtx),
        (*b"loca", loca),
        (*b"maxp", maxp),
    ]);
    tables.sort();
    assembled(tables)
}

/// In units of the font.
fn units(thousandths: f64) -> i16 {
    libm::round(thousandths * f64::from(UNITS) / 1000.0) as i16
}

fn words(values: impl IntoIterator<Item = i16>) -> Vec<u8> {
    values.into_iter().flat_map(i16::to_be_bytes).collect()
}

/// A point of a contour, on the curve or off it.
#[derive(Clone, Copy, PartialEq)]
struct ContourPoint {
    at: [i16; 2],
    is_on: bool,
}

/// The contours of a letter.
fn contours(outline: impl Iterator<Item = Segment>) -> Vec<Vec<ContourPoint>> {
    let mut contours: Vec<Vec<ContourPoint>> = Vec::new();
    let point = |at: Point, is_on| ContourPoint {
        at: at.row().map(units),
        is_on,
    };
    for segment in outline {
        let points = match segment {
            Segment::Move(to) => {
                contours.push(vec![point(to, true)]);
                continue;
            }
            // Letters have no cubic curves.
            Segment::Line(to) | Segment::Curve(_, _, to) => vec![point(to, true)],
            Segment::Quad(handle, to) => vec![point(handle, false), point(to, true)],
            Segment::Close => Vec::new(),
        };
        if let Some(last) = contours.last_mut() {
            last.extend(points);
        }
    }
    // A contour closes by itself.
    for contour in &mut contours {
        if contour.len() > 1 && contour.first() == contour.last() {
            contour.pop();
        }
    }
    contours
}

/// A letter as a glyph of so much width.
fn shape(outline: impl Iterator<Item = Segment>, advance: f64) -> Shape {
    let width = units(advance);
    let contours = contours(outline);
    let points: Vec<ContourPoint> = contours.iter().flatten().copied().collect();
    let values = |k: usize| points.iter().map(move |point| point.at[k]);
    let ends = |k: usize| [values(k).min(), values(k).max()].map(|end| end.unwrap_or(0));
    let [[left, right], [low, high]] = [ends(0), ends(1)];
    let frame = [left, low, right, high];
    if points.is_empty() {
        return Shape {
            width,
            ..Shape::default()
        };
    }
    let mut bytes = words([contours.len() as i16]);
    bytes.extend(words(frame));
    let mut end = -1;
    for contour in &contours {
        end += contour.len() as i16;
        bytes.extend(words([end]));
    }
    bytes.extend(words([0]));
    bytes.extend(points.iter().map(|point| u8::from(point.is_on)));
    for k in 0..2 {
        let before = core::iter::once(0).chain(values(k));
        bytes.extend(words(
            values(k).zip(before).map(|(value, before)| value - before),
        ));
    }
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    Shape {
        width,
        bytes,
        frame,
        points: points.len() as i16,
        contours: contours.len() as i16,
    }
}

/// A font file of tables, in the order of their names.
fn assembled(tables: Vec<([u8; 4], Vec<u8>)>) -> Vec<u8> {
    let sum = |bytes: &[u8]| {
        bytes.chunks(4).fold(0_u32, |sum, chunk| {
            let mut word = [0; 4];
            word[..chunk.len()].copy_from_slice(chunk);
            sum.wrapping_add(u32::from_be_bytes(word))
        })
    };
    let count = tables.len() as u16;
    let log = count.ilog2() as u16;
    let search = 16 << log;
    let mut file = vec![0, 1, 0, 0];
    file.extend(
        [count, search, log, 16 * count - search]
            .into_iter()
            .flat_map(u16::to_be_bytes),
    );
    let mut at = 12 + 16 * tables.len();
    for (name, bytes) in &tables {
        file.extend(name);
        file.extend(
            [sum(bytes), at as u32, bytes.len() as u32]
                .into_iter()
                .flat_map(u32::to_be_bytes),
        );
        at += bytes.len().next_multiple_of(4);
    }
    let mut head = 0;
    for (name, bytes) in tables {
        if name == *b"head" {
            head = file.len();
        }
        file.extend(&bytes);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    let adjusted = 0xb1b0_afba_u32.wrapping_sub(sum(&file));
    file[head + 8..head + 12].copy_from_slice(&adjusted.to_be_bytes());
    file
}
