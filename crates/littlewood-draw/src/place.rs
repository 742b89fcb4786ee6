//! Where labels stand: inside their panel, beside each other, off the curves.

use crate::figure::{Label, Mark, Panel, View};
use crate::item::{ASCENT, DESCENT, Item, STEPS};
use crate::letters::width;
use crate::marks::{Canvas, MIDDLE};
use crate::primitives::Anchor;
use crate::space::Space;
use crate::stroke::Stroke;

/// Left, top, right and bottom in pixels.
pub(crate) type Frame = [f64; 4];

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
    fn new(panel: &Panel, sheet: [f64; 2], at: &dyn Fn(&[f64]) -> Option<[f64; 2]>) -> Self {
        let [columns, rows] = sheet.map(|side| libm::ceil(side / CELL) as usize + 1);
        let mut drawn = Self {
            columns,
            cells: vec![0.0; columns * rows],
        };
        for layer in &panel.layers {
            let (Mark::Line(Stroke { colour, .. })
            | Mark::Arrow(Stroke { colour, .. })
            | Mark::Head(colour)
            | Mark::Dot(colour, _)
            | Mark::Ring(colour, _)
            | Mark::Diamond(colour, _)
            | Mark::Cross(colour, _)) = layer.mark
            else {
                continue;
            };
            let dark = (1.0 - colour.lightness() / 100.0) as f32;
            let names = panel
                .axes()
                .into_iter()
                .map(|axis| layer.series.column(&axis.column));
            let Some(columns) = names.collect::<Option<Vec<usize>>>() else {
                continue;
            };
            let place = |row: &Vec<f64>| {
                at(&columns
                    .iter()
                    .map(|column| row[*column])
                    .collect::<Vec<_>>())
            };
            for piece in &layer.series.pieces {
                let places: Vec<[f64; 2]> = piece.iter().filter_map(place).collect();
                let is_line = matches!(layer.mark, Mark::Line(_) | Mark::Arrow(_));
                if !is_line || places.len() == 1 {
                    places.iter().for_each(|place| drawn.darken(*place, dark));
                }
                for pair in places.windows(2).filter(|_| is_line) {
                    let [dx, dy] = [0, 1].map(|k| pair[1][k] - pair[0][k]);
                    let count = libm::ceil(libm::hypot(dx, dy) / CELL).min(4096.0);
                    for i in 0..=count as u32 {
                        let share = f64::from(i) / count.max(1.0);
                        drawn.darken([pair[0][0] + share * dx, pair[0][1] + share * dy], dark);
                    }
                }
            }
        }
        drawn
    }

    fn darken(&mut self, place: [f64; 2], dark: f32) {
        let [column, row] = place.map(|pixels| pixels / CELL);
        if column >= 0.0 && row >= 0.0 && (column as usize) < self.columns {
            let at = row as usize * self.columns + column as usize;
            if let Some(cell) = self.cells.get_mut(at) {
                *cell = cell.max(dark);
            }
        }
    }

    /// How much of it lies below a box.
    fn below(&self, [left, top, right, bottom]: Frame) -> f64 {
        let [left, top, right, bottom] =
            [left, top, right, bottom].map(|side| (side / CELL).max(0.0) as usize);
        let columns = left..=right.min(self.columns - 1);
        let cells = (top..=bottom).flat_map(|row| columns.clone().map(move |column| (row, column)));
        let cells = cells.filter_map(|(row, column)| self.cells.get(row * self.columns + column));
        cells.map(|dark| f64::from(*dark)).sum()
    }
}

/// The box of a label whose place is known.
fn frame(label: &Label, [x, y]: [f64; 2]) -> Frame {
    let wide = width(&label.text, label.size);
    let left = x + label.shift[0] - label.anchor.share() * wide;
    let middle = y + label.shift[1];
    let base = middle + MIDDLE * label.size;
    [
        left,
        base - ASCENT * label.size,
        left + wide,
        base + DESCENT * label.size,
    ]
}

/// Whether two boxes are closer than they may be.
fn overlap(a: Frame, b: Frame) -> bool {
    a[0] < b[2] + EDGE && b[0] < a[2] + EDGE && a[1] < b[3] + STEP && b[1] < a[3] + STEP
}

fn is_within(inner: Frame, outer: Frame) -> bool {
    inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3]
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

/// Places the labels of a panel; those are taken off whose place is out of sight, and those for
/// which there is no room, which are returned.
pub(crate) fn place(panel: &mut Panel, sheet: [f64; 2]) -> Vec<Label> {
    if panel.labels.is_empty() {
        return Vec::new();
    }
    let all = [0.0, 0.0, sheet[0], sheet[1]];
    let [[left, top], [right, bottom]] = panel.axes_frame();
    let has_axes = matches!(panel.view, View::Plane { axes: true, .. });
    let room = if has_axes {
        [left, top, right, bottom]
    } else {
        all
    };
    let space = match &panel.view {
        View::Plane { .. } => None,
        View::Space {
            x,
            y,
            z,
            yaw,
            pitch,
        } => Some(Space::new(panel.frame, [x, y, z], [*yaw, *pitch])),
    };
    let at = |place: &[f64]| match &space {
        Some(space) => {
            let (x, y) = space.place(place);
            Some([f64::from(x) / STEPS, f64::from(y) / STEPS])
        }
        None => panel.place([place[0], place[1]]),
    };
    let drawn = Drawn::new(panel, sheet, &at);
    let (mut kept, mut left_out, mut taken): (Vec<Label>, Vec<Label>, Vec<Frame>) =
        Default::default();
    if let Some(space) = &space {
        // The numbers of three axes stand among what is drawn.
        let mut canvas = Canvas::default();
        space.axes(&mut canvas);
        taken.extend(canvas.0.iter().filter_map(|item| match item {
            Item::Words(words) => Some(words.frame()),
            Item::Path { .. } | Item::Image { .. } | Item::Circle { .. } => None,
        }));
    }
    for label in &panel.labels {
        let Some(here) = at(&label.at) else { continue };
        if has_axes && !is_within([here[0], here[1], here[0], here[1]], grown(room, 1.0)) {
            continue;
        }
        let room = if label.is_fixed { all } else { room };
        let cost = |choice: &Label| {
            let own = frame(choice, here);
            let moved = libm::hypot(
                own[0] - frame(label, here)[0],
                own[1] - frame(label, here)[1],
            );
            drawn.below(own) + NEARNESS * moved
        };
        let is_free = |choice: &Label| {
            let own = frame(choice, here);
            is_within(grown(own, STEP), room) && taken.iter().all(|other| !overlap(own, *other))
        };
        // The figure has made room for it.
        let choices = if label.is_fixed {
            vec![label.clone()]
        } else {
            choices(label)
        };
        let free = choices
            .into_iter()
            .map(|choice| inwards(choice, here, room))
            .filter(is_free);
        match free.min_by(|a, b| cost(a).total_cmp(&cost(b))) {
            Some(best) => {
                taken.push(frame(&best, here));
                kept.push(best);
            }
            None => left_out.push(label.clone()),
        }
    }
    panel.labels = kept;
    left_out
}

fn grown([left, top, right, bottom]: Frame, by: f64) -> Frame {
    [left - by, top - by, right + by, bottom + by]
}

/// Moved to the right or left such that it does not reach out of its room there.
fn inwards(label: Label, here: [f64; 2], room: Frame) -> Label {
    let own = frame(&label, here);
    let [left, right] = [room[0] + EDGE, room[2] - EDGE];
    let by = (left - own[0]).max(0.0) - (own[2] - right).max(0.0);
    Label {
        shift: [label.shift[0] + by, label.shift[1]],
        ..label
    }
}
