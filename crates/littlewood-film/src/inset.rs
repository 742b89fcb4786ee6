//! The whole path in small, where the camera goes with the hoop.

use littlewood::modes::Position;
use littlewood::{Mode, Sample, Trajectory};

use crate::camera::{EXAMINED, Tilt, View, Window};
use crate::canvas::{Canvas, Place};
use crate::colour::{INK, LINE, PAPER, SOFT, of_mode};
use crate::letters::Style;
use crate::scene::Scene;
use crate::schedule::Schedule;

/// Size in units of lettering.
pub(crate) const WIDTH: f64 = 188.0;
pub(crate) const HEIGHT: f64 = 52.0;

/// The path of the mass centre, and where it is drawn.
pub(crate) struct Inset {
    window: Window,
    unit: f64,
    view: View,
    steps: Vec<(f64, Mode, Position)>,
}

impl Inset {
    pub(crate) fn new(
        trajectory: &Trajectory,
        schedule: &Schedule,
        window: Window,
        unit: f64,
    ) -> Self {
        let tilt = Tilt::of(trajectory.hoop());
        let [mut from, mut to] = [f64::INFINITY, f64::NEG_INFINITY];
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        let mut steps = Vec::with_capacity(EXAMINED);
        for sample in trajectory.sample_evenly(EXAMINED, schedule.end) {
            let centre = tilt.level(sample.centre);
            let foot = tilt.level(Position {
                y: 0.0,
                ..sample.centre
            });
            (from, to) = (from.min(centre.x - 1.0), to.max(centre.x + 1.0));
            (low, high) = (
                low.min(foot.y.min(centre.y - 1.0)),
                high.max(centre.y + 1.0),
            );
            steps.push((sample.state.time, sample.mode, sample.mass_centre));
        }
        let (wide, tall) = (window.width - 12.0 * unit, window.height - 14.0 * unit);
        let scale = (wide / (to - from)).min(tall / (high - low));
        let origin = Place::new(
            window.left + 0.5 * window.width - 0.5 * (from + to) * scale,
            window.top + window.height - 6.0 * unit + scale * low,
        );
        Self {
            window,
            unit,
            view: View {
                scale,
                tilt,
                origin,
            },
            steps,
        }
    }

    pub(crate) fn draw_still(&self, canvas: &mut Canvas) {
        let u = self.unit;
        let Window {
            left,
            top,
            width,
            height,
        } = self.window;
        let line = 0.8 * u;
        canvas.rectangle(Place::new(left, top), width, height, LINE);
        canvas.rectangle(
            Place::new(left + line, top + line),
            width - 2.0 * line,
            height - 2.0 * line,
            PAPER,
        );
        let thickness = (0.8 * u).max(1.0);
        if self.view.tilt.sin == 0.0 {
            canvas.rectangle(
                Place::new(left + 3.0 * u, self.view.origin.y),
                width - 6.0 * u,
                thickness,
                SOFT,
            );
        } else {
            let within = Window {
                left: left + 3.0 * u,
                top: top + 3.0 * u,
                width: width - 6.0 * u,
                height: height - 6.0 * u,
            };
            let ends = self
                .view
                .seen(within)
                .map(|x| self.view.place(Position { x, y: 0.0 }));
            canvas.line(
                &ends.map(|end| self.view.moved(end, 0.0, 0.5 * thickness)),
                thickness,
                SOFT,
            );
        }
        let points: Vec<Place> = self
            .steps
            .iter()
            .map(|(_, _, point)| self.view.place(*point))
            .collect();
        canvas.line(&points, 1.2 * u, LINE);
    }

    /// The path up to a time, and the hoop on it.
    pub(crate) fn draw_moving(&self, canvas: &mut Canvas, scene: &Scene) {
        let (
            u,
            Sample {
                centre,
                mass_centre,
                ..
            },
        ) = (self.unit, scene.sample);
        let seen = &self.steps[..self.steps.partition_point(|(at, ..)| *at <= scene.time())];
        let mut pieces = seen.chunk_by(|(_, a, _), (_, b, _)| a == b).peekable();
        let mut last = None;
        while let Some(piece) = pieces.next() {
            let own = piece.iter().map(|(.., point)| *point);
            let here = pieces.peek().is_none().then_some(mass_centre);
            let points = last
                .into_iter()
                .chain(own)
                .chain(here)
                .map(|point| self.view.place(point));
            canvas.line(
                &points.collect::<Vec<Place>>(),
                1.8 * u,
                of_mode(piece[0].1),
            );
            last = piece.last().map(|(.., point)| *point);
        }
        let radius = self.view.scale.max(2.0 * u);
        let foot = self.view.place(Position { y: 0.0, ..centre });
        let above = (self.view.scale * centre.y).max(radius);
        canvas.ring(
            self.view.moved(foot, 0.0, -above),
            radius - 0.5 * u,
            1.2 * u,
            INK,
        );
        let style = Style {
            size: 8.5 * u,
            is_bold: false,
            anchor: 0.0,
        };
        canvas.label(
            "whole path",
            Place::new(self.window.left + 5.0 * u, self.window.top + 10.5 * u),
            style,
            SOFT,
        );
    }
}
