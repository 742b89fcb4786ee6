//! A map of a plane of two quantities as a figure.

use littlewood_style::Curve;
use littlewood_style::ticks::Tick;
use littlewood_style::width::FINE;
use littlewood_sweep::{Drawing, Place};

use crate::draw::{ROOM, width};
use crate::error::FigureError;
use crate::figure::{Figure, Image, Label, Layer, Mark, Panel, PlotAxis, Scale, Series, View};
use crate::sheet::{Content, Sheet};
use crate::style::{BOUNDARY, PAPER, SMALL, SOFT, Stroke};
use crate::words::marked;

const NAME: &str = "map";
const WIDTH: f64 = 620.0;
/// Height of the map, and of a row of notes.
const HEIGHT: f64 = 430.0;
const ROW: f64 = 17.0;
/// Height of the bar of the scale, and room for its ticks.
const BAR: f64 = 12.0;
const BELOW_BAR: f64 = 24.0;
/// Fractions of the axes.
const COLUMNS: [&str; 2] = ["right", "up"];
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;

fn lines<'a>(name: &str, lines: impl IntoIterator<Item = &'a [Place]>, stroke: Stroke) -> Layer {
    let rows = |line: &[Place]| line.iter().map(|place| place.to_vec()).collect();
    Series::new(name, &COLUMNS, lines.into_iter().map(rows).collect()).drawn(Mark::Line(stroke))
}

/// A unit, with marks.
fn unit(text: &str, is_si: bool) -> String {
    if is_si || text == "rad" { text.replace('²', "^{2}") } else { marked(text) }
}

/// A text before its unit, which stands in parentheses.
fn with_unit(text: &str, is_si: bool, name: impl Fn(&str) -> String) -> String {
    match text.strip_suffix(')').and_then(|text| text.split_once("  (")) {
        Some((before, own)) => format!("{}  ({})", name(before), unit(own, is_si)),
        None => name(text),
    }
}

/// What is fixed: a sign and its value.
fn note(text: &str) -> String {
    for equals in [" = ", " ≈ "] {
        if let Some((sign, value)) = text.split_once(equals) {
            // The last word before it is the sign.
            let (words, sign) = sign.rsplit_once(' ').map_or(("", sign), |(words, sign)| (words, sign));
            let space = if words.is_empty() { "" } else { " " };
            return format!("{words}{space}{}{equals}{}", marked(sign), unit(value, true));
        }
    }
    text.to_owned()
}

/// Notes in rows, none wider than this.
fn in_rows(notes: &[String], room: f64) -> Vec<String> {
    let mut rows: Vec<String> = Vec::new();
    for note in notes {
        match rows.last_mut() {
            Some(row) if width(&format!("{row},  {note}"), SMALL) <= room => {
                row.push_str(",  ");
                row.push_str(note);
            }
            _ => rows.push(note.clone()),
        }
    }
    rows
}

fn axis(column: &'static str, title: String, ticks: &[Tick]) -> PlotAxis {
    let scale = Scale::Given(ticks.to_vec());
    PlotAxis { column: column.into(), title, range: [0.0, 1.0], scale, ticks: Vec::new() }
}

/// A panel without axes.
fn bare(name: &'static str, frame: [f64; 4], labels: Vec<Label>, image: Option<Image>) -> Panel {
    let [x, y] = COLUMNS.map(|column| PlotAxis { scale: Scale::Nothing, ..axis(column, String::new(), &[]) });
    let view = View::Plane { x, y, axes: false };
    Panel { name, frame, view, image, layers: Vec::new(), labels, keys: Vec::new() }
}

/// Of a curve, with marks.
fn label_of(curve: Curve) -> String {
    match curve {
        Curve::SlipLimit => "*f*: |*F*| = *μ*_{s}*N* in rolling".to_owned(),
        Curve::NormalForceZero => "*n*: *N* = 0 in rolling".to_owned(),
        Curve::LiftOff => "*h* cos *θ* *θ*′^{2} = 1: *N* = 0 in sliding".to_owned(),
        Curve::Separatrix | Curve::Level => curve.label().to_owned(),
    }
}

/// All that is drawn over the axes.
fn layers(drawing: &Drawing) -> Vec<Layer> {
    let mut layers: Vec<Layer> = Vec::new();
    for area in &drawing.areas {
        let rows = |line: &Vec<Place>| line.iter().map(|place| place.to_vec()).collect();
        let series = Series::new(area.name.clone(), &COLUMNS, area.outlines.iter().map(rows).collect());
        layers.push(series.drawn(Mark::Region(area.colour)));
    }
    let stroke = if drawing.areas.is_empty() { Stroke::solid(PAPER, FINE) } else { BOUNDARY };
    layers.push(lines("boundary", drawing.boundaries.iter().map(Vec::as_slice), stroke));
    if !drawing.contours.is_empty() {
        let contours = drawing.contours.iter().map(<[Place; 2]>::as_slice);
        layers.push(lines("contour", contours, Stroke::solid(PAPER, FINE)));
    }
    for curve in Curve::ALL {
        let own =
            || drawing.curves.iter().filter(|(other, _)| *other == curve).map(|(_, line)| line.as_slice());
        if own().next().is_some() {
            let stroke = Stroke::of_curve(curve);
            layers.push(lines(curve.name(), own(), Stroke::solid(PAPER, stroke.width + 2.0 * MARGIN)));
            layers.push(lines(curve.name(), own(), stroke));
        }
    }
    layers
}

/// A map as a figure of a width in print, or for a screen. Its numbers are fractions of the axes.
///
/// # Errors
/// A width out of bounds.
pub fn map(drawing: &Drawing, width_mm: Option<f64>) -> Result<Figure, FigureError> {
    let sheet = Sheet::new(width_mm, WIDTH)?;
    let [left, inner] = sheet.span();
    let mut notes: Vec<String> = drawing.notes.iter().map(|text| note(text)).collect();
    let mut entries: Vec<(Mark, String)> = Vec::new();
    for entry in &drawing.legend {
        let share = if entry.share.is_empty() { String::new() } else { format!(", {}", entry.share) };
        match (entry.colour, entry.curve) {
            (Some(colour), _) => entries.push((Mark::Fill(colour), format!("{}{share}", entry.label))),
            (None, Some(curve)) => entries.push((Mark::Line(Stroke::of_curve(curve)), label_of(curve))),
            (None, None) => notes.push(entry.label.clone()),
        }
    }
    let title = with_unit(&drawing.title, drawing.is_si, str::to_owned);
    let texts: Vec<String> =
        core::iter::once(title.clone()).chain(in_rows(&notes, sheet.width - 2.0 * (left + 4.0))).collect();
    let labels = texts.iter().zip(0_u32..).map(|(text, i)| {
        let label = Label::new(text.clone(), &[0.0, 1.0]).left().shifted(0.0, ROW * (f64::from(i) + 0.6));
        if i == 0 { label } else { label.sized(SMALL).coloured(SOFT) }
    });
    let mut top = 6.0 + ROW * texts.len() as f64;
    let mut panels = vec![bare("title", [left + 4.0, 4.0, inner, top], labels.collect(), None)];
    if let Some((colours, ticks)) = &drawing.scale {
        let labels = ticks
            .iter()
            .map(|tick| Label::new(tick.label.clone(), &[tick.value, 0.0]).sized(SMALL).shifted(0.0, 10.0));
        let pixels = colours.iter().flat_map(|colour| colour.0).collect();
        let frame = [left + ROOM[0], top + 6.0, inner - ROOM[0], BAR];
        let image = Image { size: [colours.len(), 1], pixels };
        panels.push(bare("scale", frame, labels.collect(), Some(image)));
        top += 6.0 + BAR + BELOW_BAR;
    }
    let (keys, room) = sheet.keys(entries, top);
    let height = sheet.height(HEIGHT);
    let [x, y] = [0, 1].map(|k| {
        let (name, ticks) = &drawing.axes[k];
        axis(COLUMNS[k], with_unit(name, drawing.is_si, marked), ticks)
    });
    let content = Content { name: "plane", x, y, layers: layers(drawing), labels: Vec::new() };
    let top = top + room + 8.0;
    let image = drawing.image.as_ref();
    let image = image.map(|image| Image { size: image.size, pixels: image.pixels.clone() });
    panels.push(Panel { keys, image, ..Sheet::panel([left, top, inner, height], content) });
    let caption = format!("{}.", texts.join(". "));
    Ok(sheet.figure(NAME, &title, caption, top + height + 6.0, panels).finished(None))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_have_marks_and_words_have_none() {
        assert_eq!(with_unit("θ′  (√(g/R))", false, marked), "*θ*′  (√(*g*/*R*))");
        assert_eq!(with_unit("Energy lost  (m₂gR)", false, str::to_owned), "Energy lost  (*m*_{2}*gR*)");
        assert_eq!(with_unit("Energy lost  (J)", true, str::to_owned), "Energy lost  (J)");
        assert_eq!(with_unit("Izz/(m₂R²)", false, marked), "*I*_{zz}/(*m*_{2}*R*^{2})");
        assert_eq!(note("μₛ = 0.5"), "*μ*_{s} = 0.5");
        assert_eq!(note("followed to τ = 50"), "followed to *τ* = 50");
        assert_eq!(note("− sliding with negative slip velocity"), "− sliding with negative slip velocity");
    }
}
