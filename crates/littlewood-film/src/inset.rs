//! The whole path in small, where the camera goes with the hoop.

use littlewood::modes::Position;
use littlewood::{Mode, Trajectory};

use crate::camera::EXAMINED;
use crate::canvas::{Canvas, Place};
use crate::colour::{INK, LINE, PAPER, SOFT, of_mode};
use crate::letters::Style;
use crate::schedule::Schedule;

/// Size in units of lettering.
pub(crate) const WIDTH: f64 = 188.0;
pub(crate) const HEIGHT: f64 = 52.0;

/// The path of the mass centre, and where it is drawn.
pub(crate) struct Inset {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    unit: f64,
    scale: f64,
    origin: (f64, f64),
    steps: Vec<(f64, Mode, Position)>,
}

impl Inset {
    pub(crate) fn new(
        trajectory: &Trajectory,
        schedule: &Schedule,
        [left, top, width, height]: [f64; 4],
        unit: f64,
    ) -> Self {
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY, 2.0];
        let mut steps = Vec::with_capacity(EXAMINED);
        for sample in trajectory.sample_evenly(EXAMINED, schedule.end()) {
            bounds = [
                bounds[0].min(sample.centre.x - 1.0),
                bounds[1].max(sample.centre.x + 1.0),
                bounds[2].max(sample.centre.y + 1.0),
            ];
            steps.push((sample.state.time, sample.mode, sample.mass_centre));
        }
        let [from, to, high] = bounds;
        let (wide, tall) = (width - 12.0 * unit, height - 14.0 * unit);
        let scale = (wide / (to - from)).min(tall / high);
        let origin = (left + 0.5 * width - 0.5 * (from + to) * scale, top + height - 6.0 * unit);
        Self { left, top, width, height, unit, scale, origin, steps }
    }

    fn place(&self, point: Position) -> Place {
        (self.origin.0 + self.scale * point.x, self.origin.1 - self.scale * point.y)
    }

    pub(crate) fn draw_still(&self, canvas: &mut Canvas) {
        let u = self.unit;
        let line = 0.8 * u;
        canvas.rectangle((self.left, self.top), self.width, self.height, LINE);
        let inner = (self.left + line, self.top + line);
        canvas.rectangle(inner, self.width - 2.0 * line, self.height - 2.0 * line, PAPER);
        let plane = (self.left + 3.0 * u, self.origin.1);
        canvas.rectangle(plane, self.width - 6.0 * u, (0.8 * u).max(1.0), SOFT);
        let points: Vec<Place> = self.steps.iter().map(|(_, _, point)| self.place(*point)).collect();
        canvas.line(&points, 1.2 * u, LINE);
    }

    /// The path up to a time, and the hoop on it.
    pub(crate) fn draw_moving(
        &self,
        canvas: &mut Canvas,
        time: f64,
        centre: Position,
        mass_centre: Position,
    ) {
        let u = self.unit;
        let mut piece: Vec<Place> = Vec::new();
        let mut mode = None;
        for (_, now, point) in self.steps.iter().take_while(|(at, _, _)| *at <= time) {
            if mode.is_some_and(|mode| mode != *now) {
                let last = piece.last().copied();
                self.flush(canvas, &mut piece, mode);
                piece.extend(last);
            }
            mode = Some(*now);
            piece.push(self.place(*point));
        }
        piece.push(self.place(mass_centre));
        self.flush(canvas, &mut piece, mode);
        let radius = self.scale.max(2.0 * u);
        let (x, y) = self.place(centre);
        canvas.ring((x, y.min(self.origin.1 - radius)), radius - 0.5 * u, 1.2 * u, INK);
        let style = Style { size: 8.5 * u, is_bold: false, anchor: 0.0 };
        canvas.label("whole path", (self.left + 5.0 * u, self.top + 10.5 * u), style, SOFT);
    }

    fn flush(&self, canvas: &mut Canvas, piece: &mut Vec<Place>, mode: Option<Mode>) {
        if let Some(mode) = mode.filter(|_| piece.len() > 1) {
            canvas.line(piece, 1.8 * self.unit, of_mode(mode));
        }
        piece.clear();
    }
}
