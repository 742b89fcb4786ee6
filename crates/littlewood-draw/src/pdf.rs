//! A sheet as PDF of one page, with a font of its letters, in which they can be searched.

use littlewood_style::{Dash, Rgb};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{
    CidFontType, FontFlags, LineCapStyle, LineJoinStyle, SystemInfo, TextRenderingMode, UnicodeCmap,
};
use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect, Ref, Str, TextStr};

use crate::figure::Figure;
use crate::font::Font;
use crate::item::{Frame, Item, Words};
use crate::letters::glyphs;
use crate::markup::plain;
use crate::pencil::{Pencil, draw};
use crate::primitives::{Image, Path, Point, Segment};
use crate::stroke::Stroke;

/// Level of compression.
const LEVEL: u8 = 8;

/// What is drawn, with its images and letters.
struct Page(Content, Vec<Image>, Font);

/// The number of its first object of the font, of five.
const FONT_OBJECT: i32 = 6;

/// The font on the page, and its name in the file: six letters for a part of a font.
const FACE: Name<'static> = Name(b"F0");
const FONT: Name<'static> = Name(b"LWHOOP+STIXTwoMath-Regular");
const SYSTEM: SystemInfo<'static> = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

/// To a thousandth of a pixel, which keeps the file small.
fn fine(point: Point) -> [f32; 2] {
    point
        .row()
        .map(|value| (libm::round(1e3 * value) / 1e3) as f32)
}

/// A colour as PDF takes it.
fn shares(Rgb(colour): Rgb) -> [f32; 3] {
    colour.map(|value| (libm::round(f64::from(value) / 255.0 * 1e4) / 1e4) as f32)
}

/// Where a segment ends.
const fn end(segment: Segment) -> Option<Point> {
    match segment {
        Segment::Move(to) | Segment::Line(to) | Segment::Quad(_, to) | Segment::Curve(_, _, to) => {
            Some(to)
        }
        Segment::Close => None,
    }
}

/// The handles of a curve as a cubic one, from where it begins.
fn handles(from: Point, segment: Segment) -> [Point; 2] {
    // Two thirds of the way: where a cubic curve has its handle for that of a quadratic one.
    let part = |from: f64, to: f64| from + 2.0 / 3.0 * (to - from);
    let towards = |from: Point, to: Point| Point::new(part(from.x, to.x), part(from.y, to.y));
    match segment {
        Segment::Quad(handle, to) => [from, to].map(|end| towards(end, handle)),
        Segment::Curve(a, b, _) => [a, b],
        Segment::Move(to) | Segment::Line(to) => [from, to],
        Segment::Close => [from; 2],
    }
}

impl Page {
    fn path(&mut self, path: &Path) {
        let mut here = Point::default();
        for segment in path {
            match *segment {
                Segment::Move(to) => {
                    let [x, y] = fine(to);
                    self.0.move_to(x, y);
                }
                Segment::Line(to) => {
                    let [x, y] = fine(to);
                    self.0.line_to(x, y);
                }
                Segment::Quad(_, to) | Segment::Curve(_, _, to) => {
                    let [a, b] = handles(here, *segment);
                    let [[a, b], [c, d], [x, y]] = [a, b, to].map(fine);
                    self.0.cubic_to(a, b, c, d, x, y);
                }
                Segment::Close => {
                    self.0.close_path();
                }
            }
            here = end(*segment).unwrap_or(here);
        }
    }
}

impl Pencil for Page {
    fn fill(&mut self, path: &Path, colour: Rgb) {
        let [r, g, b] = shares(colour);
        self.0.set_fill_rgb(r, g, b);
        self.path(path);
        self.0.fill_nonzero();
    }

    fn stroke(&mut self, path: &Path, edge: Stroke) {
        let [r, g, b] = shares(edge.colour);
        let cap = if edge.dash == Dash::Solid {
            LineCapStyle::RoundCap
        } else {
            LineCapStyle::ButtCap
        };
        self.0
            .set_stroke_rgb(r, g, b)
            .set_line_width(edge.width as f32)
            .set_line_cap(cap);
        self.0
            .set_dash_pattern(edge.pattern().map(|part| part as f32), 0.0);
        self.path(path);
        self.0.stroke();
    }

    fn image(&mut self, frame: Frame, image: &Image) {
        let [left, top] = fine(Point::new(frame.left, frame.top));
        let [right, bottom] = fine(Point::new(frame.right, frame.bottom));
        self.0.save_state();
        // The unit square of an image has its first row at the top.
        self.0
            .transform([right - left, 0.0, 0.0, top - bottom, left, bottom]);
        self.0.x_object(Name(name_of(self.1.len()).as_bytes()));
        self.0.restore_state();
        self.1.push(image.clone());
    }

    /// Letters of the font, by lines of one size.
    fn words(&mut self, words: &Words) {
        let glyphs = glyphs(&words.text, words.size);
        let (back, [x, y]) = (words.back(), words.at);
        let [r, g, b] = shares(words.colour);
        self.0
            .begin_text()
            .set_fill_rgb(r, g, b)
            .set_stroke_rgb(r, g, b);
        for line in glyphs.chunk_by(|a, b| (a.at[1], a.unit, a.bold) == (b.at[1], b.unit, b.bold)) {
            let [right, down] = line[0].at;
            let (right, size) = (right - back, (1000.0 * line[0].unit) as f32);
            let at = if words.upwards {
                Point::new(x + down, y - right)
            } else {
                Point::new(x + right, y + down)
            };
            let [a, b] = fine(at);
            self.0.set_font(FACE, size);
            // The page grows downwards, letters upwards.
            self.0.set_text_matrix(if words.upwards {
                [0.0, -1.0, -1.0, 0.0, a, b]
            } else {
                [1.0, 0.0, 0.0, -1.0, a, b]
            });
            let bold = line[0].bold as f32;
            let mode = if bold > 0.0 {
                TextRenderingMode::FillStroke
            } else {
                TextRenderingMode::Fill
            };
            self.0.set_line_width(bold).set_text_rendering_mode(mode);
            let codes: Vec<u8> = line
                .iter()
                .flat_map(|glyph| self.2.number(glyph.letter).to_be_bytes())
                .collect();
            self.0.show(Str(&codes));
        }
        self.0.end_text();
    }
}

/// Writes a font as objects from a number on.
fn font(pdf: &mut Pdf, font: &Font, first: i32) {
    let [face, letters, about, file, signs] = core::array::from_fn(|i| Ref::new(first + i as i32));
    pdf.type0_font(face)
        .base_font(FONT)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(letters)
        .to_unicode(signs);
    let mut cid = pdf.cid_font(letters);
    cid.subtype(CidFontType::Type2)
        .base_font(FONT)
        .system_info(SYSTEM)
        .font_descriptor(about);
    cid.cid_to_gid_map_predefined(Name(b"Identity"));
    cid.widths()
        .consecutive(1, font.letters().iter().map(|letter| letter.advance as f32));
    cid.finish();
    pdf.font_descriptor(about)
        .name(FONT)
        .flags(FontFlags::SYMBOLIC | FontFlags::SERIF)
        .bbox(Rect::new(-1000.0, -500.0, 2000.0, 1500.0))
        .italic_angle(0.0)
        .ascent(762.0)
        .descent(-238.0)
        .cap_height(656.0)
        .stem_v(80.0)
        .font_file2(file);
    let bytes = font.file();
    let packed = compress_to_vec_zlib(&bytes, LEVEL);
    let mut stream = pdf.stream(file, &packed);
    stream
        .filter(Filter::FlateDecode)
        .pair(Name(b"Length1"), bytes.len() as i32);
    stream.finish();
    let mut map = UnicodeCmap::new(Name(b"letters"), SYSTEM);
    for (number, letter) in (1_u16..).zip(font.letters()) {
        map.pair(number, letter.sign);
    }
    pdf.cmap(signs, &map.finish());
}

/// The name of an image.
fn name_of(number: usize) -> String {
    format!("Im{number}")
}

/// A document of one page, with so many points of print to a pixel.
pub(crate) fn document(figure: &Figure, items: &[Item], scale: f64) -> Vec<u8> {
    let [width, height] = [figure.width, figure.height].map(|side| (side * scale) as f32);
    let mut page = Page(Content::new(), Vec::new(), Font::default());
    page.0
        .transform([scale as f32, 0.0, 0.0, -scale as f32, 0.0, height]);
    page.0.set_line_join(LineJoinStyle::RoundJoin);
    draw(items, figure.width, figure.height, &mut page);

    let [catalog, pages, sheet, content, about] = [1, 2, 3, 4, 5].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([sheet]).count(1);
    let mut described = pdf.page(sheet);
    described
        .parent(pages)
        .media_box(Rect::new(0.0, 0.0, width, height))
        .contents(content);
    let images: Vec<(Ref, Image)> = page
        .1
        .into_iter()
        .zip(11..)
        .map(|(image, at)| (Ref::new(at), image))
        .collect();
    let mut resources = described.resources();
    resources.fonts().pair(FACE, Ref::new(FONT_OBJECT));
    if !images.is_empty() {
        let mut objects = resources.x_objects();
        for (number, (at, _)) in images.iter().enumerate() {
            objects.pair(Name(name_of(number).as_bytes()), *at);
        }
    }
    resources.finish();
    described.finish();
    for (at, image) in &images {
        let bytes = compress_to_vec_zlib(&image.pixels, LEVEL);
        let [width, height] = image
            .size
            .map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        let mut object = pdf.image_xobject(*at, &bytes);
        object.filter(Filter::FlateDecode);
        object.width(width).height(height).bits_per_component(8);
        object.color_space().device_rgb();
    }
    pdf.stream(content, &compress_to_vec_zlib(&page.0.finish(), LEVEL))
        .filter(Filter::FlateDecode);
    font(&mut pdf, &page.2, FONT_OBJECT);
    pdf.document_info(about)
        .title(TextStr(&plain(&figure.title)))
        .subject(TextStr(&plain(&figure.caption)))
        .creator(TextStr("littlewood"));
    pdf.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quadratic_curve_has_its_handles_at_two_thirds() {
        let curve = Segment::Quad(Point::new(3.0, 6.0), Point::new(6.0, 0.0));
        let expected = [Point::new(2.0, 4.0), Point::new(4.0, 4.0)];
        assert_eq!(handles(Point::default(), curve), expected);
    }
}
