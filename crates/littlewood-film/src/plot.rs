//! A small diagram: a frame, a curve within it, ticks.

use littlewood_style::ticks::Tick;
use littlewood_style::{Dash, Rgb};

use crate::canvas::{Canvas, Place};
use crate::colour::{INK, LINE, SOFT};
use crate::letters::Style;

/// A rectangle with a range of values to the right and upwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plot {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) x: [f64; 2],
    pub(crate) y: [f64; 2],
    pub(crate) unit: f64,
}

impl Plot {
    pub(crate) fn place(&self, [x, y]: [f64; 2]) -> Place {
        let part = |[low, high]: [f64; 2], value: f64| (value - low) / (high - low);
        (self.left + self.width * part(self.x, x), self.top + self.height * (1.0 - part(self.y, y)))
    }

    /// A line, cut at the frame and where its values are not finite.
    pub(crate) fn line(&self, canvas: &mut Canvas, points: &[[f64; 2]], width: f64, colour: Rgb, dash: Dash) {
        for run in self.runs(points) {
            let pattern: Vec<f64> = dash.pattern().iter().map(|part| part * width).collect();
            canvas.pattern(&run, width, &pattern, colour);
        }
    }

    /// The area between two lines that have the same abscissas.
    pub(crate) fn band(&self, canvas: &mut Canvas, lower: &[[f64; 2]], upper: &[[f64; 2]], colour: Rgb) {
        let within = |point: &[f64; 2]| {
            let [low, high] = self.y;
            self.place([point[0], point[1].clamp(low, high)])
        };
        let corners: Vec<Place> = lower.iter().chain(upper.iter().rev()).map(within).collect();
        canvas.polygon(&corners, colour);
    }

    fn runs(&self, points: &[[f64; 2]]) -> Vec<Vec<Place>> {
        let mut runs: Vec<Vec<Place>> = Vec::new();
        let mut end = None;
        for pair in points.windows(2) {
            let Some([a, b]) = self.clip(pair[0], pair[1]) else {
                end = None;
                continue;
            };
            match runs.last_mut() {
                Some(run) if end == Some(a) => run.push(self.place(b)),
                _ => runs.push(vec![self.place(a), self.place(b)]),
            }
            end = Some(b);
        }
        runs
    }

    /// The part of a segment within the frame.
    fn clip(&self, a: [f64; 2], b: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        if a.iter().chain(&b).any(|value| !value.is_finite()) {
            return None;
        }
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (k, [low, high]) in [self.x, self.y].into_iter().enumerate() {
            let step = b[k] - a[k];
            for (distance, slope) in [(a[k] - low, -step), (high - a[k], step)] {
                if slope == 0.0 {
                    if distance < 0.0 {
                        return None;
                    }
                } else if slope > 0.0 {
                    to = to.min(distance / slope);
                } else {
                    from = from.max(distance / slope);
                }
            }
        }
        let at = |t: f64| {
            if t == 0.0 {
                a
            } else if t == 1.0 {
                b
            } else {
                [0, 1].map(|k| a[k] + t * (b[k] - a[k]))
            }
        };
        (from <= to).then(|| [at(from), at(to)])
    }

    /// The frame with ticks and the names of its axes.
    pub(crate) fn draw_frame(
        &self,
        canvas: &mut Canvas,
        [x_ticks, y_ticks]: [&[Tick]; 2],
        [x_name, y_name]: [&str; 2],
    ) {
        let u = self.unit;
        let style = Style { size: 9.0 * u, is_bold: false, anchor: 0.5 };
        let bottom = self.top + self.height;
        for tick in x_ticks {
            let (x, _) = self.place([tick.value, self.y[0]]);
            canvas.line(&[(x, bottom), (x, bottom + 3.0 * u)], u, INK);
            canvas.words(&tick.label, (x, bottom + 12.0 * u), style, SOFT);
        }
        let right = Style { anchor: 1.0, ..style };
        for tick in y_ticks {
            let (_, y) = self.place([self.x[0], tick.value]);
            canvas.line(&[(self.left - 3.0 * u, y), (self.left, y)], u, INK);
            canvas.words(&tick.label, (self.left - 5.0 * u, y + 3.2 * u), right, SOFT);
        }
        let name = Style { size: 10.0 * u, is_bold: false, anchor: 0.0 };
        canvas.words(y_name, (self.left, self.top - 4.5 * u), name, INK);
        let end = Style { anchor: 1.0, ..name };
        canvas.words(x_name, (self.left + self.width, bottom + 23.0 * u), end, INK);
        let (l, t, w, h) = (self.left, self.top, self.width, self.height);
        for (place, width, height) in [
            ((l, t), w, 0.8 * u),
            ((l, bottom - 0.8 * u), w, 0.8 * u),
            ((l, t), 0.8 * u, h),
            ((l + w - 0.8 * u, t), 0.8 * u, h),
        ] {
            canvas.rectangle(place, width, height, LINE);
        }
    }
}
