//! Where labels stand: inside their panel, beside each other, off the curves.

use crate::clip;
use crate::figure::{Label, Layer, Mark, Panel, PlotAxis, View};
use crate::item::{ASCENT, DESCENT, Frame, Item, STEPS};
use crate::letters::width;
use crate::marks::{Canvas, MIDDLE, winding};
use crate::primitives::{Anchor, Point};
use crate::space::Space;
use crate::stroke::{LETTER, Stroke};

/// Least distance of a label from others and from the edge of what it stands in.
const EDGE: f64 = 3.0;
/// What rounding to the steps of the sheet may move a label by, twice.
const STEP: f64 = 2.0 / STEPS;
/// Distances at which there may be room beside a place, those at which a line has to lead to it, and
/// directions, in pixels.
const DISTANCES: [f64; 4] = [5.0, 11.0, 20.0, 32.0];
const FARTHER: [f64; 4] = [44.0, 58.0, 76.0, 100.0];
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
const NEARNESS: f64 = 0.2;
/// Side of the cells in which curves are looked for.
const CELL: f64 = 2.0;
/// Lines up to this width may run below a label.
const THIN: f64 = 1.0;
/// A label that is farther than this from its place has a line to it.
const NEAR: f64 = 24.0;

/// What is drawn in a panel, in cells, row by row.
struct Drawn {
    columns: usize,
    cells: Vec<Cell>,
}

/// What is drawn in a cell.
#[derive(Clone, Copy, Default)]
struct Cell {
    /// How dark it is.
    dark: f32,
    /// Whether no label may hide it: a curve that is data.
    is_kept: bool,
}

impl Drawn {
    fn new(panel: &Panel, sheet: Frame, at: &dyn Fn(&[f64]) -> Option<Point>) -> Self {
        let cells = |side: f64| libm::ceil(side / CELL) as usize + 1;
        let (columns, rows) = (cells(sheet.right), cells(sheet.bottom));
        let mut drawn = Self {
            columns,
            cells: vec![Cell::default(); columns * rows],
        };
        for layer in &panel.layers {
            drawn.add(layer, &panel.axes(), at);
        }
        drawn
    }

    /// Adds the lines and the marks of a layer.
    fn add(&mut self, layer: &Layer, axes: &[&PlotAxis], at: &dyn Fn(&[f64]) -> Option<Point>) {
        // How far a mark reaches around its place, and whether it is data.
        let (colour, reach, is_kept) = match layer.mark {
            Mark::Line(Stroke { colour, width, .. })
            | Mark::Arrow(Stroke { colour, width, .. }) => (colour, 0.0, width > THIN),
            Mark::Head(colour) => (colour, 0.0, false),
            Mark::Dot(colour, radius)
            | Mark::Ring(colour, radius)
            | Mark::Diamond(colour, radius)
            | Mark::Cross(colour, radius) => (colour, radius, true),
            Mark::Fill(_)
            | Mark::Region(_)
            | Mark::Hatch(_)
            | Mark::HatchedRegion(_)
            | Mark::Beyond(_)
            | Mark::Hoop(_) => return,
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
        let cell = Cell { dark, is_kept };
        for piece in &layer.series.pieces {
            let places: Vec<Point> = piece.iter().filter_map(place).collect();
            if !is_line || places.len() == 1 {
                places
                    .iter()
                    .for_each(|place| self.dot(*place, reach, cell));
            }
            let line: Vec<[f64; 2]> = places.into_iter().map(Point::row).collect();
            // What is far off the sheet has no cells.
            let seen = clip::line(&line, self.corners());
            for pair in seen
                .iter()
                .flat_map(|line| line.windows(2))
                .filter(|_| is_line)
            {
                let ([x, y], [to_x, to_y]) = (pair[0], pair[1]);
                let (dx, dy) = (to_x - x, to_y - y);
                let count = libm::ceil(libm::hypot(dx, dy) / CELL) as u32;
                for i in 0..=count {
                    let share = f64::from(i) / f64::from(count.max(1));
                    self.darken(Point::new(x + share * dx, y + share * dy), cell);
                }
            }
        }
    }

    /// A mark that reaches so far around its place.
    fn dot(&mut self, Point { x, y }: Point, reach: f64, cell: Cell) {
        let count = libm::ceil(2.0 * reach / CELL) as u32;
        let along = |i: u32| f64::from(i) * CELL - reach;
        for right in 0..=count {
            for down in 0..=count {
                self.darken(Point::new(x + along(right), y + along(down)), cell);
            }
        }
    }

    /// The left upper and the right lower corner of all cells.
    fn corners(&self) -> [[f64; 2]; 2] {
        let rows = self.cells.len() / self.columns;
        [
            [0.0; 2],
            [self.columns, rows].map(|count| CELL * count as f64),
        ]
    }

    fn darken(&mut self, place: Point, Cell { dark, is_kept }: Cell) {
        let [column, row] = place.row().map(|pixels| pixels / CELL);
        if column >= 0.0 && row >= 0.0 && (column as usize) < self.columns {
            let at = row as usize * self.columns + column as usize;
            if let Some(cell) = self.cells.get_mut(at) {
                cell.dark = cell.dark.max(dark);
                cell.is_kept |= is_kept;
            }
        }
    }

    /// What lies below a box.
    fn below(&self, frame: Frame) -> impl Iterator<Item = Cell> {
        let [left, top, right, bottom] = frame.sides().map(|side| (side / CELL).max(0.0) as usize);
        let columns = left..=right.min(self.columns - 1);
        let cells =
            (top..=bottom).flat_map(move |row| columns.clone().map(move |column| (row, column)));
        cells.filter_map(|(row, column)| self.cells.get(row * self.columns + column).copied())
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

/// A line from a place to the name that stands far from it.
#[derive(Clone, Copy)]
pub(crate) struct Lead {
    pub(crate) from: Point,
    pub(crate) to: Point,
}

impl Lead {
    /// Whether it passes a box.
    fn passes(self, frame: Frame) -> bool {
        let corners = [[frame.left, frame.top], [frame.right, frame.bottom]];
        !clip::line(&[self.from.row(), self.to.row()], corners).is_empty()
    }
}

/// The line from a place to its label, if the label is far.
pub(crate) fn lead(label: &Label, here: Point) -> Option<Lead> {
    let own = frame(label, here);
    let to = Point::new(
        here.x.clamp(own.left, own.right),
        here.y.clamp(own.top, own.bottom),
    );
    let is_far = libm::hypot(to.x - here.x, to.y - here.y) > NEAR;
    (label.is_led && is_far).then_some(Lead { from: here, to })
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
    let farther = FARTHER.into_iter().filter(|_| label.is_led);
    for distance in DISTANCES.into_iter().chain(farther) {
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

/// Steps between the places of a label in its area, in pixels.
const GRID: f64 = 8.0;

/// The same anywhere in a room, for the name of an area.
fn everywhere(label: &Label, here: Point, room: Frame) -> Vec<Label> {
    let count = |from: f64, to: f64| libm::floor((to - from) / GRID).max(0.0) as u32;
    let (columns, rows) = (count(room.left, room.right), count(room.top, room.bottom));
    let shift = |column: u32, row: u32| {
        [
            room.left + GRID * f64::from(column) - here.x,
            room.top + GRID * f64::from(row) - here.y,
        ]
    };
    let places = (0..=rows).flat_map(|row| (0..=columns).map(move |column| (column, row)));
    let moved = places.map(|(column, row)| Label {
        shift: shift(column, row),
        anchor: Anchor::Middle,
        ..label.clone()
    });
    core::iter::once(label.clone()).chain(moved).collect()
}

/// The lines around an area, in pixels.
type Outlines = Vec<Vec<[f64; 2]>>;

/// Which areas a place is in.
fn holding(areas: &[Outlines], place: Point) -> Vec<bool> {
    let is_in = |lines: &Outlines| winding(lines, place.row(), |point| point) != 0;
    areas.iter().map(is_in).collect()
}

/// The areas of a panel.
fn areas(panel: &Panel, at: &dyn Fn(&[f64]) -> Option<Point>) -> Vec<Outlines> {
    let axes = panel.axes();
    let areas = panel.layers.iter().filter(|layer| layer.mark.is_area());
    let outlines = areas.filter_map(|Layer { series, .. }| {
        let columns = axes.iter().map(|axis| series.column(&axis.column));
        let columns: Vec<usize> = columns.collect::<Option<_>>()?;
        let place = |row: &Vec<f64>| {
            let values: Vec<f64> = columns.iter().map(|column| row[*column]).collect();
            at(&values).map(Point::row)
        };
        let pieces = series.pieces.iter();
        Some(
            pieces
                .map(|piece| piece.iter().filter_map(place).collect())
                .collect(),
        )
    });
    outlines.collect()
}

/// Where the labels of a panel may stand.
struct Places<'a> {
    at: &'a dyn Fn(&[f64]) -> Option<Point>,
    /// What they should not hide, and what they must not.
    drawn: Drawn,
    taken: Vec<Frame>,
    leads: Vec<Lead>,
    areas: Vec<Outlines>,
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
        let own_areas = holding(&self.areas, here);
        let is_of_area = label.is_of_area && own_areas.contains(&true);
        let (room, choices) = if label.is_fixed {
            (self.sheet, vec![label.clone()])
        } else if is_of_area {
            (self.room, everywhere(label, here, self.room))
        } else {
            (self.room, choices(label))
        };
        let wanted = frame(label, here);
        let cost = |choice: &Label| {
            let own = frame(choice, here);
            let moved = libm::hypot(own.left - wanted.left, own.top - wanted.top);
            let dark = self.drawn.below(own).map(|cell| f64::from(cell.dark));
            dark.sum::<f64>() + NEARNESS * moved
        };
        let is_inside = |Frame {
                             left,
                             top,
                             right,
                             bottom,
                         }: Frame| {
            let corners = [left, right]
                .into_iter()
                .flat_map(|x| [top, bottom].map(|y| [x, y]));
            let mut corners = corners.map(Point::from);
            !is_of_area || corners.all(|corner| holding(&self.areas, corner) == own_areas)
        };
        let is_free = |choice: &Label| {
            let own = frame(choice, here);
            let lead = lead(choice, here);
            let mut leads = self.leads.iter();
            room.holds(own.grown(STEP))
                && self.taken.iter().all(|other| {
                    !overlap(own, *other) && lead.is_none_or(|lead| !lead.passes(*other))
                })
                && !leads.any(|other| other.passes(own))
                && (label.is_fixed || !self.drawn.below(own).any(|cell| cell.is_kept))
                && is_inside(own)
        };
        let choices = choices.into_iter();
        let free = choices
            .map(|choice| inwards(choice, here, room))
            .filter(is_free);
        let best = free.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        self.taken.push(frame(&best, here));
        self.leads.extend(lead(&best, here));
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
        leads: Vec::new(),
        areas: areas(panel, &at),
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
        // The name of an area that is too small for it has smaller letters.
        let smaller =
            (label.is_of_area && label.size > LETTER).then(|| label.clone().sized(LETTER));
        let sizes = core::iter::once(&label).chain(&smaller);
        let best = sizes.into_iter().find_map(|label| places.take(label, here));
        match best {
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
