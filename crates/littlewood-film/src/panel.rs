//! The words around the motion: mode, clock, values, the line of phases, and what the signs mean.

use littlewood::si::Units;
use littlewood::tables::{Dimension, Quantity, SampleColumn, Setup};
use littlewood::{Hoop, Mode, Outcome, OutcomeKind, SlipDirection, Start, Trajectory, Transition};
use littlewood_draw::marked;

use crate::body::{Shape, WEIGHT, draw_mass_centre};
use crate::canvas::{Canvas, Place};
use crate::colour::{
    FRICTION_FORCE, IMPULSE, INK, NORMAL_FORCE, PAPER, SLIP, SOFT, of_mode, on_mode,
};
use crate::letters::Style;
use crate::pane::unit_sign;
use crate::scene::Scene;
use crate::schedule::Schedule;
use crate::size::FrameSize;
use littlewood_style::Rgb;

/// Distance from the edges.
const MARGIN: f64 = 12.0;

/// Width of the clock.
const CLOCK: f64 = 122.0;

/// Height of what stands above and below the motion.
pub(crate) const HEAD: f64 = 58.0;
pub(crate) const FOOT: f64 = 58.0;

/// The name of a lane, and its colour.
#[derive(Debug)]
pub(crate) struct Name {
    pub(crate) words: String,
    pub(crate) colour: Rgb,
}

/// Writes the words around the motion.
#[derive(Debug)]
pub(crate) struct Panel {
    width: f64,
    height: f64,
    unit: f64,
    units: Option<Units>,
    /// Decimals of the clock.
    time_decimals: usize,
}

/// What a word of the row of signs stands beside.
enum Sign {
    Particle,
    MassCentre,
    Centre,
    Arrow(Shape, Rgb),
}

/// A sign and what it stands for.
struct SignEntry {
    sign: Sign,
    words: String,
}

impl SignEntry {
    fn new(sign: Sign, words: &str) -> Self {
        let words = words.to_owned();
        Self { sign, words }
    }

    /// An arrow, and the letter of a quantity behind the words.
    fn arrow(shape: Shape, colour: Rgb, words: &str, column: SampleColumn) -> Self {
        let words = format!("{words} {}", marked(column.sign()));
        Self {
            sign: Sign::Arrow(shape, colour),
            words,
        }
    }

    /// Where its words begin, if it begins at x; lengths in units of lettering of u pixels.
    fn words_at(&self, x: f64, u: f64) -> f64 {
        let room = match self.sign {
            Sign::Particle | Sign::MassCentre => 9.0,
            Sign::Centre => 6.0,
            Sign::Arrow(..) => 20.0,
        };
        x + room * u + 4.0 * u
    }

    /// Where the next one begins.
    fn end(&self, x: f64, u: f64) -> f64 {
        self.words_at(x, u) + style_of_signs(u).width(&self.words) + 11.0 * u
    }

    fn draw(&self, canvas: &mut Canvas, x: f64, base: f64, u: f64) {
        let middle = base - 3.6 * u;
        let words_at = Place::new(self.words_at(x, u), base);
        canvas.words(&self.words, words_at, style_of_signs(u), SOFT);
        match self.sign {
            Sign::Particle => canvas.disc(Place::new(x + 4.5 * u, middle), 4.0 * u, INK),
            Sign::MassCentre => draw_mass_centre(canvas, Place::new(x + 4.5 * u, middle), 4.2 * u),
            Sign::Centre => {
                canvas.disc(Place::new(x + 3.0 * u, middle), 3.0 * u, SOFT);
                canvas.disc(Place::new(x + 3.0 * u, middle), 1.6 * u, PAPER);
            }
            Sign::Arrow(shape, colour) => {
                let tail = Place::new(x, middle);
                shape.draw(canvas, tail, tail.shifted(19.0 * u, 0.0), colour, 0.8 * u);
            }
        }
    }
}

const fn style_of_signs(u: f64) -> Style {
    Style {
        size: 10.0 * u,
        is_bold: false,
        anchor: 0.0,
    }
}

/// The signs in the picture of a hoop.
fn signs(hoop: &Hoop) -> Vec<SignEntry> {
    let mut signs = if hoop.mass_ratio() > 0.0 {
        vec![
            SignEntry::new(Sign::Particle, "particle"),
            SignEntry::new(Sign::MassCentre, "mass centre"),
        ]
    } else {
        vec![SignEntry::new(Sign::Particle, "particle = mass centre")]
    };
    let normal = SampleColumn::Normal;
    let weight = Sign::Arrow(Shape::Open, SOFT);
    signs.extend([
        SignEntry::new(Sign::Centre, "centre *C*"),
        SignEntry::arrow(Shape::Solid, NORMAL_FORCE, normal.long_name(), normal),
        SignEntry::arrow(
            Shape::Hollow,
            FRICTION_FORCE,
            "friction",
            SampleColumn::Friction,
        ),
        SignEntry::new(weight, &format!("weight {WEIGHT}")),
        SignEntry::arrow(Shape::Thin, SLIP, "slip velocity", SampleColumn::Slip),
    ]);
    if hoop.restitution().is_some() {
        let impulse = Sign::Arrow(Shape::Solid, IMPULSE);
        signs.push(SignEntry::new(impulse, "impulse (*J*, *P*)"));
    }
    signs
}

impl Panel {
    pub(crate) fn new(size: FrameSize, units: Option<Units>) -> Self {
        let time_decimals = decimals(units.map_or(1.0, |units| units.time_s), 3);
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        Self {
            width,
            height,
            unit: size.unit(),
            units,
            time_decimals,
        }
    }

    const fn style(&self, size: f64, is_bold: bool, anchor: f64) -> Style {
        Style {
            size: size * self.unit,
            is_bold,
            anchor,
        }
    }

    /// What does not change: the line of phases, the parameters, the signs.
    pub(crate) fn draw_still(
        &self,
        canvas: &mut Canvas,
        trajectory: &Trajectory,
        schedule: &Schedule,
        note: &str,
    ) {
        let u = self.unit;
        let (top, tall) = (self.height - 52.0 * u, 15.0 * u);
        let mut last = None;
        let left = MARGIN * u;
        for phase in trajectory.phases() {
            let mode = phase.mode();
            let [begin, to] =
                [phase.start().time, phase.end_time()].map(|time| self.place_of(time, schedule));
            let from = if last.is_none() { left } else { begin };
            canvas.rectangle(Place::new(from, top), to - from, tall, of_mode(mode));
            let (words, style) = (
                mode.with_arrow(phase.direction()),
                self.style(10.5, true, 0.5),
            );
            if style.width(&words) + 6.0 * u < to - from {
                canvas.words(
                    &words,
                    Place::new(0.5 * (from + to), top + 11.2 * u),
                    style,
                    on_mode(mode),
                );
            }
            // Between bounces that are shorter than can be seen there is nothing to set off.
            let is_dense = last == Some(mode) && to - from < 4.0 * u;
            last = Some(mode);
            if from > left + 0.5 && !is_dense {
                canvas.rectangle(Place::new(from - 0.5 * u, top), u, tall, PAPER);
            }
            // Beyond thousands of phases there is nothing to tell apart.
            if to >= left + (self.width - 2.0 * left) {
                break;
            }
        }
        self.draw_impacts(canvas, trajectory, schedule);
        let style = self.style(10.0, false, 0.0);
        if let Some(part) = schedule.part.label() {
            canvas.words(part, Place::new(MARGIN * u, 66.0 * u), style, SOFT);
        }
        let base = self.height - 9.0 * u;
        canvas.words(
            &parameters(trajectory.hoop()),
            Place::new(MARGIN * u, base),
            style,
            SOFT,
        );
        let end = Style {
            anchor: 1.0,
            ..style
        };
        canvas.words(note, Place::new(self.width - MARGIN * u, base), end, SOFT);
        self.draw_signs(canvas, trajectory.hoop());
    }

    /// The name of the lane on a ground of its colour, to the left of the clock.
    pub(crate) fn draw_name(&self, canvas: &mut Canvas, name: &Name) {
        let u = self.unit;
        let style = self.style(12.0, true, 0.5);
        let (wide, tall) = (style.width(&name.words) + 16.0 * u, 18.0 * u);
        let corner = Place::new(self.width - (MARGIN + CLOCK) * u - wide, 11.0 * u);
        canvas.pill(corner, wide, tall, name.colour);
        let letters = name.colour.more_legible(INK, PAPER);
        let middle = corner.shifted(0.5 * wide, 13.2 * u);
        canvas.words(&name.words, middle, style, letters);
    }

    /// A mark over the line of phases for each impact.
    fn draw_impacts(&self, canvas: &mut Canvas, trajectory: &Trajectory, schedule: &Schedule) {
        let u = self.unit;
        let top = self.height - 52.0 * u;
        let impacts = trajectory
            .transitions()
            .iter()
            .filter(|transition| transition.impact.is_some());
        for time in impacts
            .map(Transition::time)
            .take_while(|time| *time <= schedule.end)
        {
            let place = self.place_of(time, schedule);
            canvas.rectangle(
                Place::new(place - 0.8 * u, top - 4.0 * u),
                1.6 * u,
                4.0 * u,
                IMPULSE,
            );
        }
    }

    /// Where a time stands on the line of phases.
    fn place_of(&self, time: f64, schedule: &Schedule) -> f64 {
        let left = MARGIN * self.unit;
        let span = schedule.line_end - schedule.start;
        let part = if span > 0.0 {
            (time - schedule.start) / span
        } else {
            1.0
        };
        left + (self.width - 2.0 * left) * part.clamp(0.0, 1.0)
    }

    /// The signs and what they stand for, in a row, as large as there is room.
    fn draw_signs(&self, canvas: &mut Canvas, hoop: &Hoop) {
        let left = MARGIN * self.unit;
        let base = self.height - 23.0 * self.unit;
        let entries = signs(hoop);
        let room = self.width - 2.0 * left;
        let end = entries
            .iter()
            .fold(left, |x, entry| entry.end(x, self.unit));
        let wide = end - left;
        let u = if wide > room {
            self.unit * (room / wide)
        } else {
            self.unit
        };
        let mut x = left;
        for entry in &entries {
            entry.draw(canvas, x, base, u);
            x = entry.end(x, u);
        }
    }

    /// What changes from frame to frame.
    pub(crate) fn draw_moving(
        &self,
        canvas: &mut Canvas,
        scene: &Scene,
        schedule: &Schedule,
        outcome: Option<Outcome>,
    ) {
        let end_of_mode = self.draw_mode(canvas, scene);
        let impact = || {
            scene
                .impulse
                .map(|impulse| format!("impact: {}", impulse.case.label()))
        };
        let u = self.unit;
        let left = MARGIN * u;
        if let Some(note) = outcome.as_ref().and_then(note_of).or_else(impact) {
            let place = Place::new(end_of_mode + 10.0 * u, 25.0 * u);
            canvas.words(&note, place, self.style(13.0, true, 0.0), INK);
        }
        canvas.words(
            &self.clock(scene.time()),
            Place::new(self.width - left, 26.5 * u),
            self.style(18.0, false, 1.0),
            INK,
        );
        self.draw_values(canvas, scene);
        // The time, on the line of phases.
        let x = self.place_of(scene.time(), schedule);
        let top = self.height - 52.0 * u;
        canvas.rectangle(
            Place::new(x - 2.2 * u, top - 2.5 * u),
            4.4 * u,
            20.0 * u,
            PAPER,
        );
        canvas.rectangle(
            Place::new(x - 1.2 * u, top - 2.5 * u),
            2.4 * u,
            20.0 * u,
            INK,
        );
    }

    /// The mode on a ground of its colour; returns where that ends.
    fn draw_mode(&self, canvas: &mut Canvas, scene: &Scene) -> f64 {
        let u = self.unit;
        let left = MARGIN * u;
        let words = scene.sample.mode.with_arrow(scene.sample.direction);
        let style = self.style(14.0, true, 0.5);
        // Wide enough for the longest, so that it does not change its size.
        let widest = Mode::ALL
            .into_iter()
            .map(|mode| style.width(&mode.with_arrow(Some(SlipDirection::Positive))))
            .fold(0.0, f64::max);
        let wide = widest + 22.0 * u;
        canvas.pill(
            Place::new(left, 9.0 * u),
            wide,
            22.0 * u,
            of_mode(scene.mode()),
        );
        let middle = Place::new(left + 0.5 * wide, 25.2 * u);
        canvas.words(&words, middle, style, on_mode(scene.mode()));
        left + wide
    }

    /// The values in a row, which ends where the inset begins.
    fn draw_values(&self, canvas: &mut Canvas, scene: &Scene) {
        let u = self.unit;
        let bold = self.style(12.0, true, 0.0);
        let plain = self.style(12.0, false, 0.0);
        for (at, (name, value, colour)) in [0.0, 98.0, 202.0, 324.0]
            .into_iter()
            .zip(self.values(scene))
        {
            let x = MARGIN * u + at * u;
            canvas.words(&name, Place::new(x, 49.0 * u), bold, colour);
            canvas.words(
                &value,
                Place::new(x + bold.width(&name), 49.0 * u),
                plain,
                INK,
            );
        }
    }

    /// The normal and the friction impulse that the scene shows.
    pub(crate) fn impulse(&self, scene: &Scene) -> Vec<String> {
        let of = |sign: &str, value: f64| {
            format!("*{sign}* = {}", self.value(value, Dimension::Impulse, 2))
        };
        scene.impulse.map_or_else(Vec::new, |drawn| {
            vec![
                of("P", drawn.impulse.normal),
                of("J", drawn.impulse.friction),
            ]
        })
    }

    fn clock(&self, time: f64) -> String {
        let decimals = self.time_decimals;
        match self.units {
            Some(units) => format!("*t* = {} s", number(time * units.time_s, decimals)),
            None => format!("*τ* = {}", number(time, decimals)),
        }
    }

    fn values(&self, scene: &Scene) -> [(String, String, Rgb); 4] {
        let sample = &scene.sample;
        let force = |value| format!(" = {}", self.value(value, Dimension::Force, 2));
        // In flight that of the lowest point of the rim, as in figures and tables.
        let slip = format!(
            " = {}",
            self.value(sample.state.slip, Dimension::Velocity, 2)
        );
        [
            (
                marked(SampleColumn::Normal.sign()),
                force(sample.normal),
                NORMAL_FORCE,
            ),
            (
                marked(SampleColumn::Friction.sign()),
                force(sample.friction),
                FRICTION_FORCE,
            ),
            (marked(SampleColumn::Slip.sign()), slip, SLIP),
            (
                SampleColumn::Gap.sign().to_owned(),
                format!(" = {}", self.gap(scene)),
                INK,
            ),
        ]
    }

    /// The gap in words.
    pub(crate) fn gap(&self, scene: &Scene) -> String {
        self.value(scene.sample.gap, Dimension::Length, 3)
    }

    /// A value to so many decimals of the unit of (2.9).
    fn value(&self, value: f64, dimension: Dimension, usual: i32) -> String {
        let unit = self.units.map_or(1.0, |units| units.unit(dimension));
        let sign = unit_sign(self.units.as_ref(), dimension);
        format!("{} {sign}", number(value * unit, decimals(unit, usual)))
    }
}

/// How the motion ended, where the film ends with it.
fn note_of(outcome: &Outcome) -> Option<String> {
    let rate = outcome.state().theta_rate;
    let infinite = if rate.is_infinite() {
        format!(", {} → ∞", marked(Quantity::ThetaRate.sign()))
    } else {
        String::new()
    };
    // A film that ends with the rest of the hoop stops there.
    (outcome.is_final() || outcome.kind() == OutcomeKind::Rests)
        .then(|| format!("{}{infinite}", outcome.kind().label()))
}

/// The numbers that define the hoop.
fn parameters(hoop: &Hoop) -> String {
    let setup = Setup::new(hoop.parameters(), Start::default());
    let words: Vec<String> = Quantity::HOOP
        .into_iter()
        .filter_map(|quantity| {
            Some(format!(
                "{} = {}",
                marked(quantity.sign()),
                short(setup.said(quantity)?)
            ))
        })
        .chain(
            hoop.restitution()
                .map(|restitution| format!("({})", restitution.law())),
        )
        .collect();
    words.join("   ")
}

/// A parameter with at most four decimals.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if value != 0.0 && text == "0" {
        format!("{value:.1e}").replace('-', "−")
    } else {
        text.to_owned()
    }
}

/// A number with these decimals, with a minus sign and without a negative zero.
fn number(value: f64, decimals: usize) -> String {
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    let text = format!("{:.decimals$}", value.abs());
    let is_zero = text.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    if value < 0.0 && !is_zero {
        format!("−{text}")
    } else {
        text
    }
}

/// Decimals that show a quantity of this size to `usual` decimals of it.
fn decimals(size: f64, usual: i32) -> usize {
    let digits = f64::from(usual) - libm::floor(libm::log10(size));
    digits.clamp(0.0, 9.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{ArrowScale, Direction};

    #[test]
    fn the_slip_velocity_in_flight_is_that_of_the_lowest_point() {
        let motion = littlewood::cases::find_case("figure-3")
            .expect("a case")
            .simulate()
            .expect("a motion");
        let place = |time: f64| motion.at(time).expect("an instant of the motion").centre.x;
        let scale = ArrowScale {
            force: 1.0,
            weight: 1.0,
            down: Direction { x: 0.0, y: -1.0 },
            velocity: 1.0,
            impulse: 1.0,
        };
        let scene = Scene::of(motion.at(2.5).expect("it flies"), scale);
        let [.., (sign, text, _), _] = Panel::new(FrameSize::default(), None).values(&scene);
        // The velocity of the centre by differences; θ′ turns the lowest point forwards.
        let step = 1e-6;
        let wanted =
            (place(2.5 + step) - place(2.5 - step)) / (2.0 * step) + scene.sample.state.theta_rate;
        assert_eq!(
            text,
            format!(
                " = {} {}",
                number(wanted, 2),
                marked(Dimension::Velocity.scale_sign())
            ),
            "{sign}"
        );
    }

    #[test]
    fn numbers_are_set_as_in_print() {
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(number(-1.236, 2), "−1.24");
        assert_eq!(number(f64::NEG_INFINITY, 2), "−∞");
        assert_eq!(short(0.5), "0.5");
        assert_eq!(short(2.0), "2");
        assert_eq!(short(0.0), "0");
        assert_eq!(short(1e-7), "1.0e−7");
        assert_eq!(
            [decimals(1.0, 2), decimals(0.03, 2), decimals(250.0, 2)],
            [2, 4, 0]
        );
    }
}
