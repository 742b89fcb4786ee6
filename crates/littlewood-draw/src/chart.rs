//! A figure on a sheet: frames, ticks, marks, labels, keys.

use littlewood_style::width::FINE;

use crate::figure::{Figure, Key, Mark, Panel, PlotAxis, Series, View, tilted};
use crate::item::{Corners, Item, STEPS, Step, Words, steps};
use crate::letters::wrapped;
use crate::marks::{Canvas, MIDDLE, edge};
use crate::place::{Lead, lead};
use crate::primitives::{Anchor, Point};
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
        let place = Step::of_pixels(Point::new(NOTES_LEFT, middle));
        canvas.text(line, place, Anchor::Left, SMALL, SOFT);
    }
    canvas.0
}

/// The notes in lines as wide as the sheet.
fn note_lines(figure: &Figure) -> Vec<String> {
    wrapped(
        &figure.notes.join(" "),
        SMALL,
        figure.width - 2.0 * NOTES_LEFT,
    )
}

/// Room that the notes take below the panels.
pub(crate) fn room_for_notes(figure: &Figure) -> f64 {
    match note_lines(figure).len() {
        0 => 0.0,
        lines => NOTE_ROW * lines as f64 + NOTES_BELOW,
    }
}

/// Where notes begin, the height of a line of them, and the room below them, in pixels.
const NOTES_LEFT: f64 = 10.0;
const NOTE_ROW: f64 = 17.0;
const NOTES_BELOW: f64 = 4.0;

/// The lines of axes.
const LINE: Stroke = Stroke::solid(INK, FINE);

/// The axes of a plane on the sheet.
struct Plane<'a> {
    x: &'a PlotAxis,
    y: &'a PlotAxis,
    corners: Corners,
    /// Angle by which the data are turned.
    tilt: f64,
}

impl Plane<'_> {
    /// Of a value, from the left.
    fn across(&self, value: f64) -> i32 {
        let Corners { low, high } = self.corners;
        low.x + libm::round(f64::from(high.x - low.x) * self.x.share(value)) as i32
    }

    /// Of a value, from the top.
    fn down(&self, value: f64) -> i32 {
        let Corners { low, high } = self.corners;
        high.y - libm::round(f64::from(high.y - low.y) * self.y.share(value)) as i32
    }

    fn place(&self, at: &[f64]) -> Step {
        let turned = tilted(self.tilt, Point::new(at[0], at[1]));
        Step::new(self.across(turned.x), self.down(turned.y))
    }

    /// Steps to a unit of the axes; hoops are drawn only where both have one scale.
    fn unit(&self) -> f64 {
        let Corners { low, high } = self.corners;
        f64::from(high.x - low.x) / self.x.range.length()
    }
}

/// How what panels show is placed.
struct Ground<'a> {
    axes: Vec<&'a PlotAxis>,
    place: &'a dyn Fn(&[f64]) -> Step,
    /// Steps to a unit of the axes.
    unit: f64,
    /// Angle by which hoops are turned.
    tilt: f64,
    /// Within which marks have their place, and lines and areas end, if there are any.
    bounds: Option<Corners>,
}

impl Ground<'_> {
    fn is_seen(&self, place: &Step) -> bool {
        self.bounds.is_none_or(|bounds| bounds.holds(*place))
    }

    /// The places of a series, piece by piece; none of one without the columns of the axes.
    fn pieces(&self, series: &Series) -> Option<Vec<Vec<Step>>> {
        let columns = self.axes.iter().map(|axis| series.column(&axis.column));
        let columns: Vec<usize> = columns.collect::<Option<_>>()?;
        let at = |row: &Vec<f64>| {
            let values: Vec<f64> = columns.iter().map(|column| row[*column]).collect();
            (self.place)(&values)
        };
        let pieces = series.pieces.iter();
        Some(pieces.map(|it| it.iter().map(at).collect()).collect())
    }
}

impl Canvas {
    fn panel(&mut self, panel: &Panel) {
        match &panel.view {
            View::Plane { x, y, axes, tilt } => {
                let [low, high] = panel
                    .axes_frame()
                    .map(|corner| Step::of_pixels(corner.into()));
                let plane = Plane {
                    x,
                    y,
                    corners: Corners { low, high },
                    tilt: *tilt,
                };
                self.plane(panel, &plane, *axes);
            }
            View::Space { .. } => {
                if let Some(space) = Space::of(panel) {
                    space.axes(self);
                    let place = |at: &[f64]| space.place(at);
                    let ground = Ground {
                        axes: panel.axes(),
                        place: &place,
                        unit: 1.0,
                        tilt: 0.0,
                        bounds: None,
                    };
                    self.layers(panel, &ground);
                    self.labels(panel, place);
                }
            }
        }
        panel.keys.iter().for_each(|key| self.key(key));
    }

    fn key(&mut self, key: &Key) {
        let at = Step::of_pixels(key.at.into());
        if key.mark.is_area() {
            let corners = Corners {
                low: at.by(0, -steps(6.0)),
                high: at.by(steps(20.0), steps(6.0)),
            };
            let outline = corners.outline();
            self.mark(key.mark, &[outline.to_vec()], 1.0);
            self.polygon(&outline, edge(Stroke::solid(INK, 0.6)));
        } else if let Mark::Line(_) = key.mark {
            self.mark(key.mark, &[vec![at, at.by(steps(26.0), 0)]], 1.0);
        } else {
            self.mark(key.mark, &[vec![at.by(steps(13.0), 0)]], 1.0);
        }
        let beside = at.by(steps(32.0), 0);
        self.text(&key.text, beside, Anchor::Left, SMALL, INK);
    }

    fn plane(&mut self, panel: &Panel, plane: &Plane<'_>, axes: bool) {
        let corners = plane.corners;
        if let Some(image) = panel.image.clone() {
            self.0.push(Item::Image { corners, image });
        }
        let place = |at: &[f64]| plane.place(at);
        let ground = Ground {
            axes: vec![plane.x, plane.y],
            place: &place,
            unit: plane.unit(),
            tilt: plane.tilt,
            bounds: axes.then_some(corners),
        };
        self.layers(panel, &ground);
        self.labels(panel, place);
        if axes {
            self.polygon(&corners.outline(), edge(LINE));
            self.ticks(plane);
            self.titles(panel, plane);
        }
    }

    fn ticks(&mut self, plane: &Plane<'_>) {
        let Corners { low, high } = plane.corners;
        let (mark, apart) = (steps(TICK), 2.0 * TICK);
        let lower = steps(apart + (TOP - MIDDLE) * SMALL);
        for tick in &plane.x.ticks {
            let at = Step::new(plane.across(tick.value), high.y);
            self.line(&[at, at.by(0, mark)], LINE);
            self.text(&tick.label, at.by(0, lower), Anchor::Middle, SMALL, INK);
        }
        for value in plane.x.small_ticks() {
            let at = Step::new(plane.across(value), high.y);
            self.line(&[at, at.by(0, mark / 2)], LINE);
        }
        for value in plane.y.small_ticks() {
            let at = Step::new(low.x, plane.down(value));
            self.line(&[at.by(-mark / 2, 0), at], LINE);
        }
        for tick in &plane.y.ticks {
            let at = Step::new(low.x, plane.down(tick.value));
            self.line(&[at.by(-mark, 0), at], LINE);
            let beside = at.by(-steps(apart), 0);
            self.text(&tick.label, beside, Anchor::Right, SMALL, INK);
        }
    }

    fn titles(&mut self, panel: &Panel, plane: &Plane<'_>) {
        let Corners { low, high } = plane.corners;
        let middle = |a: i32, b: i32| 0.5 * (f64::from(a + b) / STEPS);
        let frame = panel.frame;
        let below = [
            middle(low.x, high.x),
            frame.top + frame.height - BELOW * LETTER,
        ];
        let beside = [frame.left + TOP * LETTER, middle(low.y, high.y)];
        for (axis, at, upwards) in [(plane.x, below, false), (plane.y, beside, true)] {
            self.words(Words {
                text: axis.title.clone(),
                at,
                anchor: Anchor::Middle,
                size: LETTER,
                colour: INK,
                upwards,
                ground: None,
            });
        }
    }

    /// Draws what panels show.
    fn layers(&mut self, panel: &Panel, ground: &Ground<'_>) {
        for layer in &panel.layers {
            let Some(mut pieces) = ground.pieces(&layer.series) else {
                continue;
            };
            if let Mark::Hoop(hoop) = layer.mark {
                let rows = pieces.iter().flatten().zip(layer.series.rows());
                for (at, row) in rows.filter(|(at, _)| ground.is_seen(at)) {
                    let theta = row[row.len() - 1] + ground.tilt;
                    self.hoop(*at, theta, ground.unit, hoop);
                }
                continue;
            }
            if let (Mark::Beyond(colour), Some(Corners { low, high })) = (layer.mark, ground.bounds)
            {
                for Step { x, y } in pieces.into_iter().flatten() {
                    self.beyond(Step::new(x, y.clamp(low.y, high.y)), colour, y <= low.y);
                }
                continue;
            }
            let is_whole =
                layer.mark.is_area() || matches!(layer.mark, Mark::Line(_) | Mark::Arrow(_));
            let is_seen = |place: &Step| ground.is_seen(place);
            if let Mark::Head(_) = layer.mark {
                pieces.retain(|piece| piece.first().is_some_and(is_seen));
            } else if !is_whole {
                pieces.iter_mut().for_each(|piece| piece.retain(is_seen));
            }
            let first = self.0.len();
            self.mark(layer.mark, &pieces, ground.unit);
            if let Some(bounds) = ground.bounds.filter(|_| is_whole) {
                let drawn = self.0.split_off(first);
                self.0
                    .extend(drawn.into_iter().filter_map(|item| item.clipped(bounds)));
            }
        }
    }

    fn labels(&mut self, panel: &Panel, place: impl Fn(&[f64]) -> Step) {
        for label in &panel.labels {
            let here = place(&label.at);
            if let Some(Lead { from, to }) = lead(label, here.pixels()) {
                let ends = [from, to].map(Step::of_pixels);
                self.line(&ends, Stroke::solid(label.colour, FINE));
            }
            let [right, down] = label.shift.map(steps);
            let Point { x, y } = here.by(right, down).pixels();
            let at = [x, y + MIDDLE * label.size];
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
