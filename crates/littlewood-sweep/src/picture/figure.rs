//! A map as a figure: the same drawing as PNG, SVG and PDF.

use littlewood::tables::PhaseSequence;
use littlewood_draw::{
    BOUNDARY, Content, DrawError, Figure, Image, LETTER, Label, Layer, Mark, PAPER, Panel,
    PanelFrame, PlotAxis, ROOM, Range, SMALL, SOFT, Scale as Ticks, Series, Sheet, Stroke, Tick,
    View, width,
};
use littlewood_style::width::FINE;
use littlewood_style::{Curve, Rgb};

use super::cells::class_of;
use super::legend::of_curves;
use super::map::{OTHERS, Picture, PictureSize};
use super::names::{along, axis_name, is_flipped, ticks_of, title, unit_of};
use super::scale::{Kind, Scale};
use crate::regions::{MIXED, Place};

/// Width of the drawing on a screen of which print takes its proportions, and height of the map
/// there.
const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 430.0;
/// Height of a row of notes, of the bar of the scale, and room for its ticks; room above the map,
/// and below.
const ROW: f64 = 17.0;
const ABOVE_BAR: f64 = 6.0;
const BAR: f64 = 12.0;
const BELOW_BAR: f64 = 24.0;
const ABOVE: f64 = 8.0;
const BELOW: f64 = 6.0;
/// Fractions of the axes.
const COLUMNS: [&str; 2] = ["right", "up"];
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;
/// What is said where motions take long.
const CUT: &str = "boundaries located less closely, as motions take long";
/// Colours of a continuous scale.
const COLOURS: usize = 128;
/// Pixels of an image to one of a drawing for print.
const FINENESS: f64 = 2.5;

impl PictureSize {
    /// Pixels to one of the drawing: letters grow with the picture.
    fn scale(self) -> f64 {
        (f64::from(self.width) / 62.0).min(f64::from(self.height) / 40.0) / SMALL
    }
}

fn lines<'a>(name: &str, lines: impl IntoIterator<Item = &'a Vec<Place>>, stroke: Stroke) -> Layer {
    Series::new(name, &COLUMNS, lines.into_iter().cloned()).drawn(Mark::Line(stroke))
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

fn axis(column: &'static str, title: &str, ticks: Option<Vec<Tick>>) -> PlotAxis {
    PlotAxis {
        scale: ticks.map_or(Ticks::Nothing, Ticks::Given),
        ..PlotAxis::new(column, title, Range { from: 0.0, to: 1.0 })
    }
}

/// A panel without axes.
fn bare(name: &'static str, frame: PanelFrame, labels: Vec<Label>, image: Option<Image>) -> Panel {
    let [x, y] = COLUMNS.map(|column| axis(column, "", None));
    let view = View::Plane {
        x,
        y,
        axes: false,
        tilt: 0.0,
    };
    Panel {
        name,
        frame,
        view,
        image,
        layers: Vec::new(),
        labels,
        keys: Vec::new(),
    }
}

/// The title and the notes under it, and where they end.
fn heading(sheet: &Sheet, is_print: bool, title: &str, notes: &[Vec<String>]) -> (Panel, f64) {
    let [left, inner] = sheet.span();
    // On a screen titles and keys begin where the map does; print is too narrow for that.
    let begin = if is_print { left + 4.0 } else { left + ROOM[0] };
    let wide = sheet.width - left - 4.0 - begin;
    let rows = notes.iter().flat_map(|notes| in_rows(notes, wide));
    let mut top = BELOW;
    let mut label = |text: String| {
        let label = Label::new(text, &[0.0, 1.0])
            .left()
            .shifted(0.0, top + 0.3 * ROW);
        top += ROW;
        label
    };
    let mut labels = vec![label(title.to_owned()).sized(LETTER)];
    labels.extend(rows.map(|row| label(row).sized(SMALL).coloured(SOFT)));
    let panel = bare(
        "title",
        PanelFrame {
            left: begin,
            top: 4.0,
            width: inner,
            height: top,
        },
        labels,
        None,
    );
    (panel, top)
}

impl Picture {
    /// The picture as a PNG file of its size.
    ///
    /// # Errors
    /// [`DrawError::NoRoom`].
    pub fn png(&self) -> Result<Vec<u8>, DrawError> {
        let PictureSize { width, height } = self.size;
        Ok(self
            .figure(None)?
            .pixels(width, height, self.size.scale())?
            .png())
    }

    /// The map as a figure of a width in print, or of the proportions of its size. Its numbers are
    /// fractions of the axes.
    ///
    /// # Errors
    /// A width out of bounds.
    pub fn figure(&self, width_mm: Option<f64>) -> Result<Figure, DrawError> {
        let is_print = width_mm.is_some();
        let pixels = self.size.scale();
        let [wide, high] = [self.size.width, self.size.height].map(|side| f64::from(side) / pixels);
        let sheet = Sheet::new(width_mm, if is_print { WIDTH } else { wide })?;
        let scale = if self.shade.is_on_a_scale() {
            Scale::of(&self.cells)
        } else {
            None
        };
        let title = title(self.shade, self.goes_on(), self.units.as_ref());
        let note = scale.as_ref().and_then(|scale| self.note_of_scale(scale));
        let is_cut = self.is_cut.then(|| CUT.to_owned());
        let limits = note.into_iter().chain(is_cut).collect();
        let notes = [self.fixed(), self.meanings(), limits];

        let (heading, mut top) = heading(&sheet, is_print, &title, &notes);
        let mut panels = vec![heading];
        if let Some(scale) = &scale {
            panels.push(self.bar_panel(&sheet, scale, top + ABOVE_BAR));
            top += ABOVE_BAR + BAR + BELOW_BAR;
        }
        let curves = self.curves();
        let shown: Vec<Curve> = curves.iter().map(|(curve, _)| *curve).collect();
        let slope = self.grid.base().hoop.slope;
        let entries = self
            .entries(scale.as_ref())
            .into_iter()
            .chain(of_curves(&shown, slope))
            .collect();
        let (keys, room) = sheet.keys(entries, top);
        let top = top + room + ABOVE;
        let height = if is_print {
            sheet.height(HEIGHT)
        } else {
            (high - top - BELOW).max(2.0 * ROOM[1])
        };
        let [left, inner] = sheet.span();
        let content = self.content(&curves, scale.is_some());
        let mut panel = Sheet::panel(
            PanelFrame {
                left,
                top,
                width: inner,
                height,
            },
            content,
        );
        if scale.is_some() || self.regions.regions.is_empty() {
            let [[left, top], [right, bottom]] = panel.axes_frame();
            let fineness = if is_print { FINENESS } else { pixels };
            let pixels = |side: f64| libm::ceil(side * fineness).max(1.0) as usize;
            let (width, height) = (pixels(right - left), pixels(bottom - top));
            panel.image = Some(self.image(width, height, scale.as_ref()));
        }
        panel.keys = keys;
        panels.push(panel);
        let caption = core::iter::once(title.clone())
            .chain(notes.into_iter().flatten())
            .collect::<Vec<_>>()
            .join(". ")
            + ".";
        Ok(sheet
            .figure("map", &title, caption, top + height + BELOW, panels)
            .fitted())
    }

    /// The bar of a scale, with its ticks under it.
    fn bar_panel(&self, sheet: &Sheet, scale: &Scale, top: f64) -> Panel {
        let [left, inner] = sheet.span();
        let (colours, ticks) = self.bar(scale);
        let label = |tick: &Tick| {
            Label::new(tick.label.clone(), &[tick.value, 0.0])
                .sized(SMALL)
                .shifted(0.0, 10.0)
        };
        let image = Image {
            size: [colours.len(), 1],
            pixels: colours.into_iter().flat_map(|colour| colour.0).collect(),
        };
        bare(
            "scale",
            PanelFrame {
                left: left + ROOM[0],
                top,
                width: inner - ROOM[0],
                height: BAR,
            },
            ticks.iter().map(label).collect(),
            Some(image),
        )
    }

    /// The axes, and what is drawn over them.
    fn content(&self, curves: &[(Curve, Vec<Place>)], has_scale: bool) -> Content {
        let units = self.units.as_ref();
        let axes = self.grid.axes();
        let [x, y] = [0, 1].map(|k| {
            let ticks = ticks_of(&axes[k], units, 10).into_iter();
            let ticks = ticks.map(|tick| Tick {
                value: along(&axes[k], tick.value),
                label: tick.label,
            });
            let title = axis_name(&axes[k], units);
            axis(COLUMNS[k], &title, Some(ticks.collect()))
        });
        Content {
            name: "plane",
            x,
            y,
            layers: self.layers(curves, has_scale),
            labels: Vec::new(),
        }
    }

    /// All that is drawn over the axes.
    fn layers(&self, curves: &[(Curve, Vec<Place>)], has_scale: bool) -> Vec<Layer> {
        let turned = |line: &Vec<Place>| {
            line.iter()
                .map(|place| self.upright(*place))
                .collect::<Vec<_>>()
        };
        let mut layers: Vec<Layer> = Vec::new();
        if !has_scale {
            for region in &self.regions.regions {
                let outlines = region.outlines.iter().map(turned);
                let series = Series::new(self.name_of(region.key), &COLUMNS, outlines);
                layers.push(series.drawn(Mark::Region(self.colour_of(region.key))));
            }
        }
        let stroke = if has_scale {
            Stroke::solid(PAPER, FINE)
        } else {
            BOUNDARY
        };
        let boundaries: Vec<Vec<Place>> = self
            .regions
            .boundaries
            .iter()
            .map(|boundary| turned(&boundary.points))
            .collect();
        layers.push(lines("boundary", &boundaries, stroke));
        for curve in Curve::ALL {
            let own: Vec<Vec<Place>> = curves
                .iter()
                .filter(|(other, _)| *other == curve)
                .map(|(_, line)| line.clone())
                .collect();
            if !own.is_empty() {
                let stroke = Stroke::of_curve(curve);
                layers.push(lines(
                    curve.name(),
                    &own,
                    Stroke::solid(PAPER, stroke.width + 2.0 * MARGIN),
                ));
                layers.push(lines(curve.name(), &own, stroke));
            }
        }
        layers
    }

    fn name_of(&self, key: u64) -> String {
        match class_of(key) {
            Some(class) => class.name().to_owned(),
            None if key == MIXED => "mixed".to_owned(),
            None if key == OTHERS => "others".to_owned(),
            None => PhaseSequence::from_bits(key).to_string(),
        }
    }

    /// A place with the larger values of the axes to the right and above.
    pub(super) fn upright(&self, place: Place) -> Place {
        [0, 1].map(|k| {
            if is_flipped(&self.grid.axes()[k]) {
                1.0 - place[k]
            } else {
                place[k]
            }
        })
    }

    fn bar(&self, scale: &Scale) -> (Vec<Rgb>, Vec<Tick>) {
        let count = match scale.kind {
            Kind::Counts => libm::round(scale.high - scale.low) as usize,
            Kind::Linear | Kind::Log => COLOURS,
        };
        let colours = (0..count)
            .map(|i| scale.at((i as f64 + 0.5) / count as f64))
            .collect();
        let ticks = scale
            .ticks(unit_of(self.shade, self.units.as_ref()), 10)
            .into_iter();
        let ticks = ticks.map(|tick| Tick {
            value: scale.fraction(tick.value),
            label: tick.label,
        });
        (colours, ticks.collect())
    }
}
