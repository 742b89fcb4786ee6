//! A figure on a sheet: axes and projection are the plotting library's, the marks are placed by its coordinates.

use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::coord::ranged1d::ValueFormatter as _;
use plotters::coord::ranged3d::ProjectionMatrixBuilder;
use plotters::drawing::IntoDrawingArea as _;
use plotters::element::{Rectangle, Text};
use plotters::style::Color as _;
use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Ink, PLAIN, steps};
use super::item::Item;
use super::library::{Area, letters, line, rgb};
use super::marks::Pen;
use super::markup::plain;
use super::raster::POINTS;
use super::ruler::Ruler;
use super::svg::Letters;
use super::{eps, pdf, raster, svg};
use crate::error::FigureError;
use crate::figure::{Anchor, Figure, Mark, Panel, PlotAxis, View};
use crate::sheet::{POINTS_TO_A_MM, PRINT_POINTS};
use crate::style::{GRID, INK, LETTER, PAPER, SMALL, Stroke};
use littlewood_style::width::FINE;

impl Figure {
    /// The figure as SVG, its letters as outlines.
    ///
    /// # Errors
    /// None is known; the plotting library may have its reasons.
    pub fn svg(&self) -> Result<String, FigureError> {
        self.svg_with(Letters::Paths)
    }

    /// The figure as SVG.
    ///
    /// # Errors
    /// As [`Figure::svg`].
    pub fn svg_with(&self, letters: Letters) -> Result<String, FigureError> {
        Ok(svg::document(self, &self.items()?, letters))
    }

    /// The figure as PDF of one page, its letters as outlines.
    ///
    /// # Errors
    /// As [`Figure::svg`].
    pub fn pdf(&self) -> Result<Vec<u8>, FigureError> {
        Ok(pdf::document(self, &self.items()?))
    }

    /// The figure as Encapsulated PostScript, its letters as outlines.
    ///
    /// # Errors
    /// As [`Figure::svg`].
    pub fn eps(&self) -> Result<String, FigureError> {
        Ok(eps::document(self, &self.items()?))
    }

    /// The figure as PNG, with `scale` pixels to 1/96 inch: 2 for a screen, 3.125 for 300 dpi in print.
    ///
    /// # Errors
    /// A scale out of bounds.
    pub fn png(&self, scale: f64) -> Result<Vec<u8>, FigureError> {
        raster::picture(self, &self.items()?, scale)
    }

    /// All texts, with the boxes of their letters: left, top, right and bottom in pixels.
    ///
    /// # Errors
    /// As [`Figure::svg`].
    pub fn texts(&self) -> Result<Vec<(String, [f64; 4])>, FigureError> {
        let texts = self.items()?.into_iter().filter_map(|item| match item {
            Item::Words(words) => Some((plain(&words.text), words.frame())),
            Item::Path { .. }
            | Item::Area { .. }
            | Item::Image { .. }
            | Item::Rectangle { .. }
            | Item::Circle { .. } => None,
        });
        Ok(texts.collect())
    }

    /// Points of print to a pixel.
    pub(crate) fn points(&self) -> f64 {
        let Some(mm) = self.print_mm else { return POINTS };
        // A poster is drawn larger than it is printed.
        let own = mm * POINTS_TO_A_MM / self.width;
        if (own - PRINT_POINTS).abs() < 1e-9 { PRINT_POINTS } else { own }
    }

    fn items(&self) -> Result<Vec<Item>, FigureError> {
        let canvas = Canvas::new(self.width, self.height);
        let root = canvas.clone().into_drawing_area();
        for panel in &self.panels {
            draw_panel(&root, &canvas, panel)?;
        }
        Ok(canvas.finish())
    }
}

fn draw_panel(root: &Area, canvas: &Canvas, panel: &Panel) -> Result<(), FigureError> {
    let [left, top, width, height] = panel.frame.map(steps);
    let area = root.clone().shrink((left, top), (width, height));
    match &panel.view {
        View::Plane { x, y, axes } => draw_plane(root, &area, canvas, panel, [x, y], *axes)?,
        View::Space { x, y, z, yaw, pitch } => {
            draw_space(root, &area, canvas, panel, [x, y, z], [*yaw, *pitch])?;
        }
    }
    for key in &panel.keys {
        let [x, y] = key.at.map(steps);
        let pen = Pen::new(root, canvas);
        let end = (x + steps(26.0), y);
        match key.mark {
            Mark::Fill(colour) | Mark::Region(colour) | Mark::Hatch(colour) | Mark::HatchedRegion(colour) => {
                let corners = [(x, y - steps(6.0)), (x + steps(20.0), y + steps(6.0))];
                canvas.take(Ink {
                    hatch: matches!(key.mark, Mark::Hatch(_) | Mark::HatchedRegion(_)),
                    ..PLAIN
                });
                root.draw(&Rectangle::new(corners, rgb(colour).filled()))?;
                canvas.take(PLAIN);
                root.draw(&Rectangle::new(corners, line(Stroke::solid(INK, 0.6))))?;
            }
            Mark::Line(_) => pen.mark(key.mark, &[vec![(x, y), end]], 1.0)?,
            Mark::Arrow(_)
            | Mark::Head(_)
            | Mark::Dot(..)
            | Mark::Ring(..)
            | Mark::Diamond(..)
            | Mark::Cross(..)
            | Mark::Hoop { .. } => pen.mark(key.mark, &[vec![(x + steps(13.0), y)]], 1.0)?,
        }
        root.draw(&Text::new(key.text.clone(), (x + steps(32.0), y), letters(SMALL, INK, HPos::Left)))?;
    }
    Ok(())
}

/// Room for the labels of the two axes, in pixels.
pub(crate) const ROOM: [f64; 2] = [62.0, 46.0];

fn draw_plane(
    root: &Area,
    area: &Area,
    canvas: &Canvas,
    panel: &Panel,
    [x, y]: [&PlotAxis; 2],
    axes: bool,
) -> Result<(), FigureError> {
    let [room_y, room_x] = if axes { ROOM.map(steps) } else { [0, 0] };
    let mut chart = ChartBuilder::on(area)
        .set_label_area_size(LabelAreaPosition::Left, room_y)
        .set_label_area_size(LabelAreaPosition::Bottom, room_x)
        .build_cartesian_2d(Ruler::from(x), Ruler::from(y))?;

    let place = |at: &[f64]| chart.backend_coord(&(at[0], at[1]));
    // How many steps a unit is: hoops are drawn only where both axes have one scale.
    let unit = f64::from(place(&[x.range[1], y.range[0]]).0 - place(&[x.range[0], y.range[0]]).0)
        / (x.range[1] - x.range[0]);
    let pen = Pen::new(root, canvas);
    if let Some(image) = &panel.image {
        let corners = [place(&[x.range[0], y.range[1]]), place(&[x.range[1], y.range[0]])];
        canvas.image(corners, image.clone());
    }
    for layer in &panel.layers {
        let columns = [&x.column, &y.column].map(|name| layer.series.column(name));
        let [Some(a), Some(b)] = columns else { continue };
        if let Mark::Hoop { offset, h, radius, rim } = layer.mark {
            for row in layer.series.rows() {
                pen.hoop(place(&[row[a], row[b]]), row[row.len() - 1], radius * unit, [offset, h], rim)?;
            }
            continue;
        }
        let pieces: Vec<Vec<(i32, i32)>> = layer
            .series
            .pieces
            .iter()
            .map(|piece| piece.iter().map(|row| place(&[row[a], row[b]])).collect())
            .collect();
        pen.mark(layer.mark, &pieces, unit)?;
    }
    draw_labels(root, canvas, panel, place)?;
    canvas.take(PLAIN);
    if axes {
        let (pixels_x, pixels_y) = chart.plotting_area().get_pixel_range();
        let corners = [(pixels_x.start, pixels_y.start), (pixels_x.end, pixels_y.end)];
        root.draw(&Rectangle::new(corners, line(Stroke::solid(INK, FINE))))?;
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(line(Stroke::solid(INK, FINE)))
            .set_all_tick_mark_size(steps(4.0))
            .label_style(letters(SMALL, INK, HPos::Center))
            .axis_desc_style(letters(LETTER, INK, HPos::Center))
            .x_labels(x.ticks.len())
            .y_labels(y.ticks.len())
            .x_desc(x.title.clone())
            .y_desc(y.title.clone())
            .draw()?;
    }
    Ok(())
}

fn draw_labels(
    root: &Area,
    canvas: &Canvas,
    panel: &Panel,
    place: impl Fn(&[f64]) -> (i32, i32),
) -> Result<(), FigureError> {
    canvas.take(Ink { halo: true, ..PLAIN });
    for label in &panel.labels {
        let (x, y) = place(&label.at);
        let [right, down] = label.shift.map(steps);
        let across = match label.anchor {
            Anchor::Left => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::Right => HPos::Right,
        };
        let style = letters(label.size, label.colour, across);
        root.draw(&Text::new(label.text.clone(), (x + right, y + down), style))?;
    }
    canvas.take(PLAIN);
    Ok(())
}

fn draw_space(
    root: &Area,
    area: &Area,
    canvas: &Canvas,
    panel: &Panel,
    [x, y, z]: [&PlotAxis; 3],
    [yaw, pitch]: [f64; 2],
) -> Result<(), FigureError> {
    let rulers = [x, y, z].map(Ruler::from);
    let mut chart = ChartBuilder::on(area).margin(steps(16.0)).build_cartesian_3d(
        rulers[0].clone(),
        rulers[1].clone(),
        rulers[2].clone(),
    )?;
    chart.with_projection(|mut builder: ProjectionMatrixBuilder| {
        builder.yaw = yaw;
        builder.pitch = pitch;
        builder.scale = 0.78;
        builder.into_matrix()
    });
    chart
        .configure_axes()
        .tick_size(steps(4.0))
        .axis_panel_style(rgb(PAPER))
        .bold_grid_style(line(Stroke::solid(GRID, 0.6)))
        .light_grid_style(plotters::style::TRANSPARENT)
        .label_style(letters(SMALL, INK, HPos::Center))
        .x_formatter(&|value: &f64| rulers[0].format_ext(value))
        .y_formatter(&|value: &f64| rulers[1].format_ext(value))
        .z_formatter(&|value: &f64| rulers[2].format_ext(value))
        .draw()?;
    let place = |at: &[f64]| chart.plotting_area().map_coordinate(&(at[0], at[1], at[2]));
    let pen = Pen::new(root, canvas);
    for layer in &panel.layers {
        let columns = [&x.column, &y.column, &z.column].map(|name| layer.series.column(name));
        let [Some(a), Some(b), Some(c)] = columns else { continue };
        let pieces: Vec<Vec<(i32, i32)>> = layer
            .series
            .pieces
            .iter()
            .map(|piece| piece.iter().map(|row| place(&[row[a], row[b], row[c]])).collect())
            .collect();
        pen.mark(layer.mark, &pieces, 1.0)?;
    }
    draw_labels(root, canvas, panel, place)?;
    Ok(())
}
