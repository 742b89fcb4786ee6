//! Where labels stand: inside their panel, beside each other, off the curves.

use crate::figure::{Label, Layer, Mark, Panel, PlotAxis, View};
use crate::item::{ASCENT, DESCENT, Frame, Item, STEPS};
use crate::letters::width;
use crate::marks::{Canvas, MIDDLE};
use crate::primitives::{Anchor, Point};
use crate::space::Space;
use crate::stroke::Stroke;

/// Least distance of a label from others and from the edge of what it stands in.
const EDGE: f64 = 3.0;
/// What rounding to the steps of the sheet may move a label by, twice.
const STEP: f64 = 2.0 / STEPS;
/// Distances at which there may be room beside a place, and directions, in pixels.
const DISTANCES: [f64; 4] = [5.0, 11.0, 20.0, 32.0];
const DIRECTIONS: [[f64; 2]; 8] = [
    [1.0, -1.0],
    [-1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [1.0, 0.0],
    [-1.0, 0.0],
];
/// A pixel from where it was asked for is worth so much of a curve below a label.
const NEARNESS: f64 = 0.1;
/// Side of the cells in which curves are looked for.
const CELL: f64 = 4.0;

/// What is drawn in a panel: how dark each cell is, row by row.
struct Drawn {
    columns: usize,
    cells: Vec<f32>,
}

impl Drawn {
    fn new(panel: &Panel, sheet: Frame, at: &dyn Fn(&[f64]) -> Option<Point>) -> Self {
        let cells = |side: f64| libm::ceil(side / CELL) as usize + 1;
        let (columns, rows) = (cells(sheet.right), cells(sheet.bottom));
        let mut drawn = Self {
            columns,
            cells: vec![0.0; columns * rows],
        };
        for layer in &panel.layers {
            drawn.add(layer, &panel.axes(), at);
        }
        drawn
    }

    /// Adds the lines and the marks of a layer.
    fn add(&mut self, layer: &Layer, axes: &[&PlotAxis], at: &dyn Fn(&[f64]) -> Option<Point>) {
        let (Mark::Line(Stroke { colour, .. })
        | Mark::Arrow(Stroke { colour, .. })
        | Mark::Head(colour)
        | Mark::Dot(colour, _)
        | Mark::Ring(colour, _)
        | Mark::Diamond(colour, _)
        | Mark::Cross(colour, _)) = layer.mark
        else {
            return;
        };
        let dark = (1.0 - colour.lightness() / 100.0) as f32;
        let names = axes.iter().map(|axis| layer.series.column(&axis.column));
        let Some(columns) = names.collect::<Option<Vec<usize>>>() else {
            return;
        };
        let place = |row: &Vec<f64>| {
            let values: Vec<f64> = columns.iter().map(|column| row[*column]).collect();
            at(&values)
        };
        let is_line = matches!(layer.mark, Mark::Line(_) | Mark::Arrow(_));
        for piece in &layer.series.pieces {
            let places: Vec<Point> = piece.iter().filter_map(place).collect();
            if !is_line || places.len() == 1 {
                places.iter().for_each(|place| self.darken(*place, dark));
            }
            for pair in places.windows(2).filter(|_| is_line) {
                let (from, to) = (pair[0], pair[1]);
                let (dx, dy) = (to.x - from.x, to.y - from.y);
                let count = libm::ceil(libm::hypot(dx, dy) / CELL).min(4096.0);
                for i in 0..=count as u32 {
                    let share = f64::from(i) / count.max(1.0);
                    self.darken(Point::new(from.x + share * dx, from.y + share * dy), dark);
                }
            }
        }
    }

    fn darken(&mut self, place: Point, dark: f32) {
        let [column, row] = place.row().map(|pixels| pixels / CELL);
        if column >= 0.0 && row >= 0.0 && (column as usize) < self.columns {
            let at = row as usize * self.columns + column as usize;
            if let Some(cell) = self.cells.get_mut(at) {
                *cell = cell.max(dark);
            }
        }
    }

    /// How much of it lies below a box.
    fn below(&self, frame: Frame) -> f64 {
        let [left, top, right, bottom] = frame.sides().map(|side| (side / CELL).max(0.0) as usize);
        let columns = left..=right.min(self.columns - 1);
        let cells = (top..=bottom).flat_map(|row| columns.clone().map(move |column| (row, column)));
        let cells = cells.filter_map(|(row, column)| self.cells.get(row * self.columns + column));
        cells.map(|dark| f64::from(*dark)).sum()
    }
}

/// The box of a label whose place is known.
fn frame(label: &Label, Point { x, y }: Point) -> Frame {
    let wide = width(&label.text, label.size);
    let left = x + label.shift[0] - label.anchor.share() * wide;
    let middle = y + label.shift[1];
    let base = middle + MIDDLE * label.size;
    Frame {
        left,
        top: base - ASCENT * label.size,
        right: left + wide,
        bottom: base + DESCENT * label.size,
    }
}

/// Whether two boxes are closer than they may be.
fn overlap(a: Frame, b: Frame) -> bool {
    a.left < b.right + EDGE
        && b.left < a.right + EDGE
        && a.top < b.bottom + STEP
        && b.top < a.bottom + STEP
}

/// A label as it may stand: as it was asked for, then beside its place.
fn choices(label: &Label) -> Vec<Label> {
    let mut choices = vec![label.clone()];
    for distance in DISTANCES {
        for [right, down] in DIRECTIONS {
            let anchor = match right {
                1.0 => Anchor::Left,
                -1.0 => Anchor::Right,
                _ => Anchor::Middle,
            };
            let slant = if right != 0.0 && down != 0.0 {
                core::f64::consts::FRAC_1_SQRT_2
            } else {
                1.0
            };
            let beyond = if down == 0.0 { 0.0 } else { 0.45 * label.size };
            let shift = [slant * distance * right, down * (slant * distance + beyond)];
            choices.push(Label {
                shift,
                anchor,
                ..label.clone()
            });
        }
    }
    choices
}

/// Where the labels of a panel may stand.
struct Places<'a> {
    at: &'a dyn Fn(&[f64]) -> Option<Point>,
    /// What they should not hide, and what they must not.
    drawn: Drawn,
    taken: Vec<Frame>,
    /// Where labels may stand, and those for which the figure has made room.
    room: Frame,
    sheet: Frame,
    has_axes: bool,
}

impl Places<'_> {
    /// Where a label stands; none out of sight.
    fn seen(&self, label: &Label) -> Option<Point> {
        let here = (self.at)(&label.at)?;
        let Point { x, y } = here;
        let point = Frame {
            left: x,
            top: y,
            right: x,
            bottom: y,
        };
        (!self.has_axes || self.room.grown(1.0).holds(point)).then_some(here)
    }

    /// The best place of a label, which is taken from then on, if there is any.
    fn take(&mut self, label: &Label, here: Point) -> Option<Label> {
        let (room, choices) = if label.is_fixed {
            (self.sheet, vec![label.clone()])
        } else {
            (self.room, choices(label))
        };
        let wanted = frame(label, here);
        let cost = |choice: &Label| {
            let own = frame(choice, here);
            let moved = libm::hypot(own.left - wanted.left, own.top - wanted.top);
            self.drawn.below(own) + NEARNESS * moved
        };
        let is_free = |choice: &Label| {
            let own = frame(choice, here);
            room.holds(own.grown(STEP)) && self.taken.iter().all(|other| !overlap(own, *other))
        };
        let choices = choices.into_iter();
        let free = choices
            .map(|choice| inwards(choice, here, room))
            .filter(is_free);
        let best = free.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        self.taken.push(frame(&best, here));
        Some(best)
    }
}

/// Places the labels of a panel on a sheet; those are taken off whose place is out of sight, and
/// those for which there is no room, which are returned.
pub(crate) fn place(panel: &mut Panel, width: f64, height: f64) -> Vec<Label> {
    if panel.labels.is_empty() {
        return Vec::new();
    }
    let labels = core::mem::take(&mut panel.labels);
    let sheet = Frame::sheet(width, height);
    let [[left, top], [right, bottom]] = panel.axes_frame();
    let axes = Frame {
        left,
        top,
        right,
        bottom,
    };
    let has_axes = matches!(panel.view, View::Plane { axes: true, .. });
    let space = Space::of(panel);
    let at = |place: &[f64]| match &space {
        Some(space) => Some(space.place(place).pixels()),
        None => panel.place(Point::new(place[0], place[1])),
    };
    let mut places = Places {
        at: &at,
        drawn: Drawn::new(panel, sheet, &at),
        taken: Vec::new(),
        room: if has_axes { axes } else { sheet },
        sheet,
        has_axes,
    };
    if let Some(space) = &space {
        // The numbers of three axes stand among what is drawn.
        let mut canvas = Canvas::default();
        space.axes(&mut canvas);
        places
            .taken
            .extend(canvas.0.iter().filter_map(|item| match item {
                Item::Words(words) => Some(words.frame()),
                Item::Path { .. } | Item::Image { .. } | Item::Circle { .. } => None,
            }));
    }
    let (mut kept, mut left_out): (Vec<Label>, Vec<Label>) = Default::default();
    for label in labels {
        let Some(here) = places.seen(&label) else {
            continue;
        };
        match places.take(&label, here) {
            Some(best) => kept.push(best),
            None => left_out.push(label),
        }
    }
    panel.labels = kept;
    left_out
}

/// Moved to the right or left such that it does not reach out of its room there.
fn inwards(label: Label, here: Point, room: Frame) -> Label {
    let own = frame(&label, here);
    let (left, right) = (room.left + EDGE, room.right - EDGE);
    let by = (left - own.left).max(0.0) - (own.right - right).max(0.0);
    Label {
        shift: [label.shift[0] + by, label.shift[1]],
        ..label
    }
}
