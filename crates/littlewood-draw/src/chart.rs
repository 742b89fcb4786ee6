//! A figure on a sheet: frames, ticks, marks, labels, keys.

use littlewood_style::width::FINE;

use crate::figure::{Figure, Mark, Panel, PlotAxis, View, tilted};
use crate::item::{Item, STEPS, Step, Words, holds, outline, steps};
use crate::letters::width;
use crate::marks::{Canvas, MIDDLE, edge};
use crate::primitives::Anchor;
use crate::space::Space;
use crate::stroke::{INK, LETTER, PAPER, SMALL, SOFT, Stroke, TICK};

/// The shapes and texts of a figure, the lowest first.
pub(crate) fn items(figure: &Figure) -> Vec<Item> {
    let mut canvas = Canvas::default();
    figure.panels.iter().for_each(|panel| canvas.panel(panel));
    let lines = note_lines(figure);
    let top = figure.height - NOTE_ROW * lines.len() as f64 - NOTES_BELOW;
    for (line, row) in lines.iter().zip(0_u8..) {
        let middle = top + NOTE_ROW * (f64::from(row) + 0.5);
        let place = (steps(NOTES_LEFT), steps(middle));
        canvas.text(line, place, Anchor::Left, SMALL, SOFT);
    }
    canvas.0
}

/// The notes in lines as wide as the sheet.
fn note_lines(figure: &Figure) -> Vec<String> {
    let room = figure.width - 2.0 * NOTES_LEFT;
    let mut lines: Vec<String> = Vec::new();
    // A line does not end within an equation.
    let notes = figure.notes.iter().map(|note| note.replace(" = ", EQUALS));
    let notes: Vec<String> = notes.collect();
    for word in notes.iter().flat_map(|note| note.split(' ')) {
        let word = &word.replace(EQUALS, " = ");
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), SMALL) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Room that the notes take below the panels.
pub(crate) fn room_for_notes(figure: &Figure) -> f64 {
    match note_lines(figure).len() {
        0 => 0.0,
        lines => NOTE_ROW * lines as f64 + NOTES_BELOW,
    }
}

/// Stands for an equals sign with its room, as a part of a word.
const EQUALS: &str = "\u{a0}=\u{a0}";

/// Where notes begin, the height of a line of them, and the room below them, in pixels.
const NOTES_LEFT: f64 = 10.0;
const NOTE_ROW: f64 = 17.0;
const NOTES_BELOW: f64 = 4.0;

impl Canvas {
    fn panel(&mut self, panel: &Panel) {
        match &panel.view {
            View::Plane { x, y, axes, tilt } => self.plane(panel, [x, y], *axes, *tilt),
            View::Space {
                x,
                y,
                z,
                yaw,
                pitch,
            } => {
                let space = Space::new(panel.frame, [x, y, z], [*yaw, *pitch]);
                space.axes(self);
                self.layers(panel, &[x, y, z], |at| space.place(at), (1.0, 0.0), None);
                self.labels(panel, |at| space.place(at));
            }
        }
        for key in &panel.keys {
            let (x, y) = (steps(key.at[0]), steps(key.at[1]));
            if key.mark.is_area() {
                let corners = outline([(x, y - steps(6.0)), (x + steps(20.0), y + steps(6.0))]);
                self.mark(key.mark, core::slice::from_ref(&corners), 1.0);
                self.polygon(&corners, edge(Stroke::solid(INK, 0.6)));
            } else if let Mark::Line(_) = key.mark {
                self.mark(key.mark, &[vec![(x, y), (x + steps(26.0), y)]], 1.0);
            } else {
                self.mark(key.mark, &[vec![(x + steps(13.0), y)]], 1.0);
            }
            self.text(&key.text, (x + steps(32.0), y), Anchor::Left, SMALL, INK);
        }
    }

    fn plane(&mut self, panel: &Panel, [x, y]: [&PlotAxis; 2], axes: bool, tilt: f64) {
        let corners = panel
            .axes_frame()
            .map(|[right, down]| (steps(right), steps(down)));
        let [(left, top), (right, bottom)] = corners;
        let (wide, tall) = (f64::from(right - left), f64::from(bottom - top));
        let place = |at: &[f64]| {
            let [right, up] = tilted(tilt, [at[0], at[1]]);
            (
                left + libm::round(wide * x.share(right)) as i32,
                bottom - libm::round(tall * y.share(up)) as i32,
            )
        };
        if let Some(image) = &panel.image {
            self.0.push(Item::Image {
                corners,
                image: image.clone(),
            });
        }
        // Hoops are drawn only where both axes have one scale.
        let unit = wide / (x.range[1] - x.range[0]);
        self.layers(panel, &[x, y], place, (unit, tilt), axes.then_some(corners));
        self.labels(panel, place);
        if !axes {
            return;
        }
        let line = Stroke::solid(INK, FINE);
        self.polygon(&outline(corners), edge(line));
        let (mark, apart) = (steps(TICK), 2.0 * TICK);
        for tick in &x.ticks {
            let at = left + libm::round(wide * x.share(tick.value)) as i32;
            self.line(&[(at, bottom), (at, bottom + mark)], line);
            self.text(
                &tick.label,
                (at, bottom + steps(apart + (TOP - MIDDLE) * SMALL)),
                Anchor::Middle,
                SMALL,
                INK,
            );
        }
        for value in x.small_ticks() {
            let at = left + libm::round(wide * x.share(value)) as i32;
            self.line(&[(at, bottom), (at, bottom + mark / 2)], line);
        }
        for value in y.small_ticks() {
            let at = bottom - libm::round(tall * y.share(value)) as i32;
            self.line(&[(left - mark / 2, at), (left, at)], line);
        }
        for tick in &y.ticks {
            let at = bottom - libm::round(tall * y.share(tick.value)) as i32;
            self.line(&[(left - mark, at), (left, at)], line);
            self.text(
                &tick.label,
                (left - steps(apart), at),
                Anchor::Right,
                SMALL,
                INK,
            );
        }
        let pixels = |step: i32| f64::from(step) / STEPS;
        let [outer, above, _, tall] = panel.frame;
        let name = |text: &str, at, upwards| Words {
            text: text.to_owned(),
            at,
            anchor: Anchor::Middle,
            size: LETTER,
            colour: INK,
            upwards,
            ground: None,
        };
        self.words(name(
            &x.title,
            [0.5 * pixels(left + right), above + tall - BELOW * LETTER],
            false,
        ));
        self.words(name(
            &y.title,
            [outer + TOP * LETTER, 0.5 * pixels(top + bottom)],
            true,
        ));
    }

    /// Draws what panels show; within bounds, where there are any: marks whose place is there, and
    /// parts of lines and areas.
    fn layers(
        &mut self,
        panel: &Panel,
        axes: &[&PlotAxis],
        place: impl Fn(&[f64]) -> Step,
        (unit, tilt): (f64, f64),
        bounds: Option<[Step; 2]>,
    ) {
        let is_seen = |place: &Step| bounds.is_none_or(|bounds| holds(bounds, *place));
        for layer in &panel.layers {
            let columns: Option<Vec<usize>> = axes
                .iter()
                .map(|axis| layer.series.column(&axis.column))
                .collect();
            let Some(columns) = columns else { continue };
            let at = |row: &Vec<f64>| {
                place(
                    &columns
                        .iter()
                        .map(|column| row[*column])
                        .collect::<Vec<_>>(),
                )
            };
            if let Mark::Hoop {
                offset,
                h,
                radius,
                rim,
            } = layer.mark
            {
                for row in layer
                    .series
                    .pieces
                    .iter()
                    .flatten()
                    .filter(|row| is_seen(&at(row)))
                {
                    self.hoop(
                        at(row),
                        row[row.len() - 1] + tilt,
                        radius * unit,
                        [offset, h],
                        rim,
                    );
                }
                continue;
            }
            if let (Mark::Beyond(colour), Some([(_, top), (_, bottom)])) = (layer.mark, bounds) {
                for (x, y) in layer.series.pieces.iter().flatten().map(at) {
                    self.beyond((x, y.clamp(top, bottom)), colour, y <= top);
                }
                continue;
            }
            let mut pieces: Vec<Vec<Step>> = layer
                .series
                .pieces
                .iter()
                .map(|piece| piece.iter().map(at).collect())
                .collect();
            let is_whole =
                layer.mark.is_area() || matches!(layer.mark, Mark::Line(_) | Mark::Arrow(_));
            if let Mark::Head(_) = layer.mark {
                pieces.retain(|piece| piece.first().is_some_and(is_seen));
            } else if !is_whole {
                pieces.iter_mut().for_each(|piece| piece.retain(is_seen));
            }
            let first = self.0.len();
            self.mark(layer.mark, &pieces, unit);
            if let Some(bounds) = bounds.filter(|_| is_whole) {
                let drawn = self.0.split_off(first);
                self.0
                    .extend(drawn.into_iter().filter_map(|item| item.clipped(bounds)));
            }
        }
    }

    fn labels(&mut self, panel: &Panel, place: impl Fn(&[f64]) -> Step) {
        for label in &panel.labels {
            let (x, y) = place(&label.at);
            let [right, down] = label.shift.map(steps);
            let at = [
                f64::from(x + right) / STEPS,
                f64::from(y + down) / STEPS + MIDDLE * label.size,
            ];
            let (text, anchor, size) = (label.text.clone(), label.anchor, label.size);
            let words = Words {
                text,
                at,
                anchor,
                size,
                colour: label.colour,
                upwards: false,
                ground: None,
            };
            let ground = self.below(words.frame());
            let is_seen = (ground.lightness() - label.colour.lightness()).abs() > LEAST_CONTRAST;
            let colour = if is_seen { label.colour } else { PAPER };
            self.words(Words {
                ground: Some(ground),
                colour,
                ..words
            });
        }
    }
}

/// Least difference in CIE lightness of letters from what is below them; on what is darker they are
/// paper.
const LEAST_CONTRAST: f64 = 30.0;

/// Where the base line of a text stands below its top, and above its bottom, in parts of its size.
const TOP: f64 = 0.76;
const BELOW: f64 = 0.24;
