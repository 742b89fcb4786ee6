//! Three axes, seen from a direction: the three sides at the back with their grids, and ticks along
//! the edges in front.

use crate::figure::{Panel, PanelFrame, PlotAxis, View};
use crate::item::{Paint, Step, steps};
use crate::marks::{Canvas, HAIR};
use crate::primitives::{Anchor, Point};
use crate::stroke::{GRID, INK, PAPER, SMALL, Stroke, TICK};

/// Room around the axes in pixels, and the length of an axis in parts of the shorter side.
const MARGIN: f64 = 16.0;
const LENGTH: f64 = 0.624;

/// Length of an axis across the view, in a frame of these sides.
pub(crate) fn length_of(width: f64, height: f64) -> f64 {
    LENGTH * (width.min(height) - 2.0 * MARGIN)
}

/// A corner of the box: which end of each axis.
type Corner = [f64; 3];

/// The projection.
pub(crate) struct Space<'a> {
    axes: [&'a PlotAxis; 3],
    centre: [f64; 2],
    length: f64,
    /// Sine and cosine of the two angles.
    yaw: (f64, f64),
    pitch: (f64, f64),
}

impl<'a> Space<'a> {
    /// That of a panel; none of a plane.
    pub(crate) fn of(panel: &'a Panel) -> Option<Self> {
        let View::Space {
            x,
            y,
            z,
            yaw,
            pitch,
        } = &panel.view
        else {
            return None;
        };
        let PanelFrame {
            left,
            top,
            width,
            height,
        } = panel.frame;
        Some(Self {
            axes: [x, y, z],
            centre: [left + 0.5 * width, top + 0.5 * height],
            length: length_of(width, height),
            yaw: libm::sincos(*yaw),
            pitch: libm::sincos(*pitch),
        })
    }

    /// Where a place is seen.
    pub(crate) fn place(&self, at: &[f64]) -> Step {
        self.step(core::array::from_fn(|k| self.axes[k].share(at[k])))
    }

    /// To the right, downwards and to the back, by shares of the axes.
    fn seen(&self, share: Corner) -> [f64; 3] {
        let [x, y, z] = share.map(|share| share - 0.5);
        let ((sin, cos), (down, level)) = (self.yaw, self.pitch);
        let (right, depth) = (x * cos - z * sin, -x * sin - z * cos);
        [
            self.centre[0] + self.length * right,
            self.centre[1] - self.length * (level * y + down * depth),
            level * depth - down * y,
        ]
    }

    fn step(&self, corner: Corner) -> Step {
        let [x, y, _] = self.seen(corner);
        Step::of_pixels(Point { x, y })
    }

    /// Draws sides, grids, edges and ticks.
    pub(crate) fn axes(&self, canvas: &mut Canvas) {
        // The end of each axis at which the side across it lies at the back.
        let back: Corner = core::array::from_fn(|k| {
            let depth = |end: f64| {
                let mut corner = [0.5; 3];
                corner[k] = end;
                self.seen(corner)[2]
            };
            if depth(0.0) >= depth(1.0) { 0.0 } else { 1.0 }
        });
        let grid = Stroke::solid(GRID, HAIR);
        for across in 0..3 {
            let [a, b] = [(across + 1) % 3, (across + 2) % 3];
            let corner = |on_a: f64, on_b: f64| {
                let mut corner = back;
                (corner[a], corner[b]) = (on_a, on_b);
                self.step(corner)
            };
            let side = [
                corner(0.0, 0.0),
                corner(1.0, 0.0),
                corner(1.0, 1.0),
                corner(0.0, 1.0),
                corner(0.0, 0.0),
            ];
            canvas.polygon(&side, Paint::Fill(PAPER));
            canvas.line(&side, grid);
            for tick in &self.axes[a].ticks {
                let share = self.axes[a].share(tick.value);
                canvas.line(&[corner(share, 0.0), corner(share, 1.0)], grid);
            }
            for tick in &self.axes[b].ticks {
                let share = self.axes[b].share(tick.value);
                canvas.line(&[corner(0.0, share), corner(1.0, share)], grid);
            }
        }
        for axis in 0..3 {
            self.edge(canvas, axis, back);
        }
    }

    /// The edge along an axis that lies in front of the others of the sides at the back, with its
    /// ticks.
    fn edge(&self, canvas: &mut Canvas, axis: usize, back: Corner) {
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
        let edges =
            [(a, back[a], 1.0 - back[b]), (b, 1.0 - back[a], back[b])].map(|(_, on_a, on_b)| {
                let mut corner = [0.5; 3];
                (corner[a], corner[b]) = (on_a, on_b);
                corner
            });
        let depth = |corner: &Corner| self.seen(*corner)[2];
        let [first, second] = edges;
        let front = if depth(&first) <= depth(&second) {
            first
        } else {
            second
        };
        let at = |share: f64| {
            let mut corner = front;
            corner[axis] = share;
            self.step(corner)
        };
        let line = Stroke::solid(INK, HAIR);
        let [begin, end] = [at(0.0), at(1.0)];
        canvas.line(&[begin, end], line);
        let size = steps(TICK);
        let is_flat = (end.x - begin.x).abs() > (end.y - begin.y).abs();
        let outwards = |value: i32, middle: f64| if value < steps(middle) { -size } else { size };
        let (right, down) = if is_flat {
            (0, outwards(begin.y, self.centre[1]))
        } else {
            (outwards(begin.x, self.centre[0]), 0)
        };
        let anchor = match right {
            0 => Anchor::Middle,
            1.. => Anchor::Left,
            _ => Anchor::Right,
        };
        for tick in &self.axes[axis].ticks {
            let here = at(self.axes[axis].share(tick.value));
            canvas.line(&[here, here.by(right, down)], line);
            let lower = down.signum() * steps(0.43 * SMALL);
            let below = here.by(2 * right, 2 * down + lower);
            canvas.text(&tick.label, below, anchor, SMALL, INK);
        }
    }
}
