//! Figures for print: letters and lines of one size at any width, texts beside each other, and the
//! same drawing in every format.

use crate::support;
use littlewood_figures::{
    DrawError, FIGURES, Figure, FigureError, FigureInput, LEAST_WIDTH_MM, MOST_WIDTH_MM, plain,
};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

fn printed(name: &str, width_mm: f64) -> Result<Figure, FigureError> {
    let entry = littlewood_figures::find_figure(name).expect("a figure");
    let input = FigureInput::of_case(entry.case).expect("a case");
    entry.figure(&FigureInput {
        width_mm: Some(width_mm),
        ..input
    })
}

/// Numbers after each place of a text in a drawing.
fn numbers(svg: &str, before: &str) -> Vec<f64> {
    svg.split(before)
        .skip(1)
        .filter_map(|rest| rest.split('"').next()?.parse().ok())
        .collect()
}

#[test]
fn letters_are_seven_to_eight_points_and_lines_the_same_at_any_width() {
    for entry in FIGURES {
        let mut seen: Vec<Vec<f64>> = Vec::new();
        for mm in [84.0, 178.0] {
            let figure = printed(entry.name, mm).expect("it can be drawn");
            let svg = figure.svg();
            assert!(svg.contains(&format!("width=\"{mm}mm\"")), "{}", entry.name);
            let points = mm / 25.4 * 72.0 / figure.width;
            // All letters but those of indices and the one large 𝓡.
            let sizes: Vec<f64> = svg
                .split("<g aria-label")
                .skip(1)
                .map(|letters| {
                    letters
                        .split("matrix(")
                        .skip(1)
                        .filter_map(|unit| unit.split(' ').next()?.parse().ok())
                })
                .map(|units| 1000.0 * points * units.fold(0.0, f64::max))
                .collect();
            assert!(sizes.len() > 3, "{}", entry.name);
            assert!(
                sizes
                    .iter()
                    .all(|size| (6.99..8.0).contains(size) || *size > 11.0),
                "{}: {sizes:?}",
                entry.name
            );
            let lines = svg
                .lines()
                .filter(|line| line.starts_with("<path d") || line.starts_with("<circle"));
            let mut widths: Vec<f64> = lines
                .flat_map(|line| numbers(line, "stroke-width=\""))
                .map(|width| width * points)
                .collect();
            widths.sort_by(f64::total_cmp);
            widths.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
            assert!(widths[0] >= 0.25, "{}: {widths:?}", entry.name);
            seen.push(widths);
        }
        assert_eq!(seen[0].len(), seen[1].len(), "{}: {seen:?}", entry.name);
        for (narrow, wide) in seen[0].iter().zip(&seen[1]) {
            assert!(
                (narrow - wide).abs() < 1e-2,
                "{}: {narrow} and {wide} points",
                entry.name
            );
        }
    }
}

#[test]
fn no_text_hides_another_or_leaves_the_sheet() {
    for entry in FIGURES {
        for mm in [None, Some(84.0), Some(178.0)] {
            let input = FigureInput {
                width_mm: mm,
                ..FigureInput::of_case(entry.case).expect("a case")
            };
            let figure = entry.figure(&input).expect("it can be drawn");
            let texts = figure.texts();
            for (i, (text, [left, top, right, bottom])) in texts.iter().enumerate() {
                let name = entry.name;
                assert!(
                    *left >= 0.0
                        && *top >= 0.0
                        && *right <= figure.width
                        && *bottom <= figure.height,
                    "{name}, {mm:?} mm: '{text}' leaves the sheet"
                );
                for (other, [l, t, r, b]) in &texts[..i] {
                    let apart = right <= l || r <= left || bottom <= t || b <= top;
                    assert!(apart, "{name}, {mm:?} mm: '{text}' and '{other}'");
                }
            }
        }
    }
}

#[test]
fn a_width_out_of_bounds_is_refused() {
    for mm in [LEAST_WIDTH_MM - 1.0, MOST_WIDTH_MM + 1.0, f64::NAN, -84.0] {
        let error = printed("figure-2b", mm).expect_err("out of bounds");
        assert!(
            matches!(error, FigureError::Draw(DrawError::Width { .. }))
                && error.to_string().contains("60 to 420 mm")
        );
    }
}

/// Bytes of the pixels of a PNG, as red, green and blue.
fn pixels(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let pixmap = Pixmap::decode_png(png).expect("a picture");
    let colours = pixmap
        .pixels()
        .iter()
        .flat_map(|p| [p.red(), p.green(), p.blue()])
        .collect();
    (pixmap.width(), pixmap.height(), colours)
}

#[test]
fn another_program_shows_the_drawing_as_the_picture_has_it() {
    // resvg reads the SVG; without any face, so that letters must be outlines.
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("it can be drawn");
        let (width, height, ours) = pixels(&figure.png(1.0).expect("a picture"));
        let tree = Tree::from_str(&figure.svg(), &Options::default()).expect("an SVG");
        let mut theirs = Pixmap::new(width, height).expect("room");
        // The last row of pixels may be outside of the drawing.
        theirs.fill(Color::WHITE);
        resvg::render(&tree, Transform::identity(), &mut theirs.as_mut());
        let (_, _, theirs) = pixels(&theirs.encode_png().expect("a picture"));
        let differences = ours
            .iter()
            .zip(&theirs)
            .map(|(a, b)| f64::from(a.abs_diff(*b)));
        let mean = differences.sum::<f64>() / ours.len() as f64;
        // A wrong letter or a missing line makes more.
        assert!(mean < 0.3, "{}: {mean} of 255 in the mean", entry.name);
    }
}

/// A compressed stream of a PDF, by its number from 0.
fn stream(pdf: &[u8], number: usize) -> Vec<u8> {
    let (begin, end) = (&b"\nstream\n"[..], &b"\nendstream"[..]);
    let find = |wanted: &[u8]| {
        let places = pdf
            .windows(wanted.len())
            .enumerate()
            .filter(|(_, part)| *part == wanted);
        places.map(|(at, _)| at).nth(number).expect("a stream")
    };
    let bytes = &pdf[find(begin) + begin.len()..find(end)];
    miniz_oxide::inflate::decompress_to_vec_zlib(bytes).expect("a compressed stream")
}

#[test]
fn a_pdf_has_the_size_of_the_print_and_all_that_is_drawn() {
    let figure = printed("figure-2b", 84.0).expect("it can be drawn");
    let pdf = figure.pdf();
    assert!(pdf.starts_with(b"%PDF-1.") && pdf.ends_with(b"%%EOF"));
    let text = String::from_utf8_lossy(&pdf);
    // 84 mm are 238.11 points.
    assert!(text.contains("/MediaBox [0 0 238.11"), "{text}");
    let drawn = String::from_utf8_lossy(&stream(&pdf, 0)).into_owned();
    let ends = |operator: &str| {
        drawn
            .lines()
            .filter(|line| line.trim_end().ends_with(operator))
            .count()
    };
    assert_eq!(ends("BT"), figure.texts().len());
    assert!(ends("S") > figure.panels[0].layers.len(), "{}", ends("S"));
    assert!(pdf == figure.pdf(), "the same bytes again");
}

/// What another program reads in a PDF, if it is installed.
fn read_by(program: &str, pdf: &[u8]) -> Option<String> {
    let file =
        std::env::temp_dir().join(format!("littlewood-{program}-{}.pdf", std::process::id()));
    std::fs::write(&file, pdf).expect("a file");
    let mut command = std::process::Command::new(program);
    let read = command
        .arg(&file)
        .args((program == "pdftotext").then_some("-"))
        .output();
    std::fs::remove_file(&file).expect("it is there");
    let read = read.ok()?;
    assert!(
        read.status.success() && read.stderr.is_empty(),
        "{}",
        String::from_utf8_lossy(&read.stderr)
    );
    Some(String::from_utf8(read.stdout).expect("text"))
}

#[test]
fn a_pdf_can_be_searched_and_has_its_font() {
    let figure = printed("figure-2a", 84.0).expect("it can be drawn");
    let pdf = figure.pdf();
    let text = String::from_utf8_lossy(&pdf);
    for part in [
        "/Subtype /Type0",
        "/Subtype /CIDFontType2",
        "/FontFile2",
        "/ToUnicode",
        "/Identity-H",
    ] {
        assert!(text.contains(part), "{part}");
    }
    // The font file is TrueType with as many letters as it has widths, and the blank.
    let font = stream(&pdf, 1);
    let word = |at: usize| u16::from_be_bytes([font[at], font[at + 1]]);
    let table = |name: &[u8; 4]| {
        let entry = (0..usize::from(word(4)))
            .map(|i| 12 + 16 * i)
            .find(|at| font[*at..at + 4] == name[..]);
        let number = |at: usize| {
            u32::from_be_bytes(font[at..at + 4].try_into().expect("four bytes")) as usize
        };
        entry
            .map(|at| (number(at + 8), number(at + 12)))
            .expect("a table")
    };
    let letters: std::collections::BTreeSet<char> = figure
        .texts()
        .iter()
        .flat_map(|(text, _)| text.chars().collect::<Vec<_>>())
        .collect();
    let count = usize::from(word(table(b"maxp").0 + 4));
    assert!(
        count > letters.len() && table(b"hmtx").1 == 4 * count,
        "{count}"
    );
    // The sum of the words of a font file is a constant of the format.
    let sum = font.chunks(4).fold(0_u32, |sum, it| {
        sum.wrapping_add(u32::from_be_bytes(it.try_into().expect("words")))
    });
    assert_eq!(sum, 0xb1b0_afba);
    if let Some(read) = read_by("pdftotext", &pdf) {
        for words in ["μs = 0.25", "θ (rad)", "N<0", "2π"] {
            assert!(
                read.replace(' ', "").contains(&words.replace(' ', "")),
                "{words}: {read}"
            );
        }
    }
    if let Some(read) = read_by("pdffonts", &pdf) {
        // Embedded, a subset, with signs.
        assert!(
            read.contains("CID TrueType") && read.contains("yes yes yes"),
            "{read}"
        );
    }
}

#[test]
fn a_png_of_a_width_in_print_says_its_pixels_to_a_metre() {
    let density = |png: &[u8]| {
        let at = png.windows(4).position(|name| name == b"pHYs")? + 4;
        Some(u32::from_be_bytes(
            png[at..at + 4].try_into().expect("four bytes"),
        ))
    };
    // 300 to the inch are 11811 to the metre.
    let print = printed("figure-2b", 84.0)
        .expect("it can be drawn")
        .png(3.125)
        .expect("a picture");
    assert_eq!(density(&print), Some(11811));
    assert_eq!(
        density(&support::figure("figure-2b").png(1.0).expect("a picture")),
        None
    );
}

#[test]
fn letters_of_an_svg_are_outlines_and_are_read_aloud_all_the_same() {
    let figure = support::figure("figure-2b");
    let svg = figure.svg();
    assert!(!svg.contains("<text") && !svg.contains("font"));
    assert!(
        svg.contains("aria-label=\"N &lt; 0\"")
            && svg.contains("<desc>")
            && svg.contains("role=\"img\"")
    );
}

#[test]
fn a_caption_is_a_file_of_text() {
    let figure = printed("figure-2b", 84.0).expect("it can be drawn");
    let text = figure.caption_txt();
    assert!(text.starts_with(&plain(&figure.title)) && text.contains(&plain(&figure.caption)));
}
