//! What becomes of the starts of the plane, by the engine.

use core::f64::consts::PI;

use littlewood::{Class, Dimension, Engine, Start};
use littlewood_style::{Curve, of_class};

use crate::axes::outcome_window;
use crate::catalogue::Watch;
use crate::columns::PLANE;
use crate::error::FigureError;
use crate::figure::{Figure, Mark, Series};
use crate::input::FigureInput;
use crate::plane::Portrait;
use crate::sheet::Content;
use crate::style::{PAPER, Stroke, THEME};
use crate::trace::Window;
use crate::words::short;

const NAME: &str = "outcomes";
/// Cells to the right and upwards.
const CELLS: [usize; 2] = [272, 200];
/// The same for hoops whose motions are simulated one by one, some hundred times as slowly.
const EXACT_CELLS: [usize; 2] = [88, 64];
/// Cells of a block to the right and upwards: where its corners and its middle have one class, so has the block.
const BLOCK: usize = 4;
/// Transitions within which most motions that bounce have lifted off for the first time.
const FIRST: usize = 16;
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;

/// The classes of the cells of a plane.
struct Cells<'a> {
    input: &'a FigureInput,
    engine: Engine,
    window: Window,
    /// Cells to the right and upwards.
    count: [usize; 2],
    /// Row by row; none that has not been followed.
    classes: Vec<Option<Class>>,
}

impl<'a> Cells<'a> {
    fn new(input: &'a FigureInput, window: Window) -> Self {
        let engine = Engine::new(&input.hoop);
        let count = if engine.is_exact() && !input.is_massless() { EXACT_CELLS } else { CELLS };
        Self { input, engine, window, count, classes: vec![None; count[0] * count[1]] }
    }

    /// Width and height of a cell.
    fn size(&self) -> [f64; 2] {
        let side = |range: [f64; 2], cells: usize| (range[1] - range[0]) / cells as f64;
        [side(self.window.x, self.count[0]), side(self.window.y, self.count[1])]
    }

    /// The start in the middle of a cell.
    fn start(&self, [i, j]: [usize; 2]) -> Start {
        let [width, height] = self.size();
        Start::at(self.window.x[0] + width * (i as f64 + 0.5), self.window.y[0] + height * (j as f64 + 0.5))
    }

    /// The class of a cell, which is followed once.
    fn class(&mut self, cell: [usize; 2]) -> Result<Class, FigureError> {
        let place = cell[1] * self.count[0] + cell[0];
        if let Some(class) = self.classes[place] {
            return Ok(class);
        }
        let class = class_of(&self.engine, self.input, self.start(cell))?;
        self.classes[place] = Some(class);
        Ok(class)
    }

    /// Finds the classes of all cells. Blocks of one class are not followed cell by cell.
    fn fill(&mut self, watch: &mut Watch<'_>) -> Result<(), FigureError> {
        let total = (self.count[0] * self.count[1]) as u64;
        for j in (0..self.count[1]).step_by(BLOCK) {
            for i in (0..self.count[0]).step_by(BLOCK) {
                let within = |from: usize, count: usize| (from + BLOCK).min(count - 1);
                let [right, top] = [within(i, self.count[0]), within(j, self.count[1])];
                let class = self.class([i, j])?;
                let mut is_one = true;
                for cell in
                    [[right, j], [i, top], [right, top], [usize::midpoint(i, right), usize::midpoint(j, top)]]
                {
                    is_one = is_one && self.class(cell)? == class;
                }
                for y in j..(j + BLOCK).min(self.count[1]) {
                    for x in i..(i + BLOCK).min(self.count[0]) {
                        if is_one {
                            self.classes[y * self.count[0] + x].get_or_insert(class);
                        } else {
                            self.class([x, y])?;
                        }
                    }
                }
                watch((j * self.count[0] + BLOCK * (i + 1)).min(self.count[0] * self.count[1]) as u64, total);
            }
        }
        Ok(())
    }

    /// The middles of the cells of each class, by its code.
    fn by_class(&self) -> [Vec<Vec<f64>>; Class::ALL.len()] {
        let mut rows: [Vec<Vec<f64>>; Class::ALL.len()] = Default::default();
        for (place, class) in self.classes.iter().enumerate() {
            if let Some(class) = class {
                let Start { theta, theta_rate, .. } =
                    self.start([place % self.count[0], place / self.count[0]]);
                rows[usize::from(class.code())].push(vec![theta, theta_rate]);
            }
        }
        rows
    }
}

/// The class of a start. It is settled with the first lift-off, so that bounces need not be followed to their end.
fn class_of(engine: &Engine, input: &FigureInput, start: Start) -> Result<Class, FigureError> {
    let limits = input.limits;
    if input.hoop.restitution().is_some() && limits.transitions > FIRST {
        let class = Class::of(&engine.summary(start, limits.with_transitions(FIRST))?);
        if class != Class::InContact {
            return Ok(class);
        }
    }
    Ok(Class::of(&engine.summary(start, limits)?))
}

/// How long the motions are followed.
fn followed(input: &FigureInput) -> String {
    let say = input.wording();
    let until = |until| format!("to {} = {}", say.time(), say.value(until, Dimension::Time));
    input.limits.until.map_or_else(|| "to its end".to_owned(), until)
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let window =
        if input.is_massless() { Window { x: [-PI, PI], y: [-2.0, 2.0] } } else { outcome_window(hoop) };
    let mut cells = Cells::new(input, window);
    cells.fill(watch)?;
    let ([columns, rows], cell) = (cells.count, cells.size());
    let total = (columns * rows) as f64;
    let mut layers = Vec::new();
    let mut legend: Vec<(Mark, String)> = Vec::new();
    for (class, rows) in Class::ALL.into_iter().zip(cells.by_class()).filter(|(_, rows)| !rows.is_empty()) {
        let colour = of_class(class, THEME);
        let share = libm::round(1000.0 * rows.len() as f64 / total) / 10.0;
        legend.push((Mark::Fill(colour), format!("{}, {}%", class.label(), short(share))));
        layers.push(Series::of_rows(class.name(), &PLANE, rows).drawn(Mark::Cell(colour, cell)));
    }
    // A massless hoop does not leave the plane.
    let mut remark = "";
    if !input.is_massless() {
        let portrait = Portrait::new(hoop, window);
        for (curve, series, words) in [
            (Curve::LiftOff, portrait.lift_off_locus(), "*h* cos *θ* *θ*′^{2} = 1: *N* = 0 in sliding"),
            (Curve::NormalForceZero, portrait.unloading_locus(), "*n*: *N* = 0 in rolling"),
        ] {
            let stroke = Stroke::of_curve(curve);
            let under = Stroke::solid(PAPER, stroke.width + 2.0 * MARGIN);
            layers.push(series.clone().drawn(Mark::Line(under)));
            layers.push(series.drawn(Mark::Line(stroke)));
            legend.push((Mark::Line(stroke), words.to_owned()));
        }
        remark = " The body leaves the plane at once only beyond *h* cos *θ* *θ*′^{2} = 1, not, as the paper has it, \
                  beyond *n*: between the two it slides first.";
    }
    let say = input.wording();
    Ok(input.sheet(620.0)?.plot(
        NAME,
        "What becomes of the motion",
        format!(
            "What becomes of a start in the plane of rolling with *η*′ = 0, followed {}: {} by {} starts.{remark} {}.",
            followed(input),
            columns,
            rows,
            say.hoop(hoop)
        ),
        430.0,
        Content { name: "plane", x: say.angle(window.x), y: say.rate(window.y), layers, labels: Vec::new() },
        legend,
    ))
}

#[cfg(test)]
mod tests {
    use littlewood::{Hoop, HoopParameters, Limits};

    use super::*;

    /// Blocks that are not followed cell by cell have the classes of their cells.
    #[test]
    fn every_cell_has_its_own_class() {
        for (mass_ratio, mu_s, mu_k) in [(1.0, 0.5, 0.4), (0.0, 0.5, 0.4), (0.3, 1.0, 0.7), (1.0, 0.2, 0.15)]
        {
            let hoop = Hoop::new(HoopParameters::thin(mass_ratio).with_friction(mu_s, mu_k)).unwrap();
            let input = FigureInput::new(hoop, Start::at(0.0, 0.0), Limits::default());
            let mut cells = Cells::new(&input, Window { x: [-PI, PI], y: [-4.0, 4.0] });
            cells.fill(&mut |_, _| {}).unwrap();
            for place in (0..cells.classes.len()).step_by(7) {
                let cell = [place % cells.count[0], place / cells.count[0]];
                let class = class_of(&cells.engine, &input, cells.start(cell)).unwrap();
                assert_eq!(cells.classes[place], Some(class), "{mass_ratio} {mu_s}: {:?}", cells.start(cell));
            }
        }
    }
}
