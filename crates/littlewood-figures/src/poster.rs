//! A poster: the story of one hoop on a page, of figures of the catalogue, with equations and plain
//! sentences.

use littlewood::Trajectory;
use littlewood::tables::{Dimension, Quantity, Setup};
use littlewood_draw::{
    Figure, GRID, Label, Panel, PanelFrame, Piece, PlotAxis, SOFT, Series, Sheet, Stroke, angle,
    lift_off_condition, marked, plain, short,
};

use crate::catalogue::{Watch, find_figure};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::paper::stroboscope;

/// Sides of a poster in millimetres: A3.
pub const POSTER_MM: [f64; 2] = [297.0, 420.0];

/// Lengths of the page, in pixels of the drawing.
const NARROWEST: f64 = 1600.0;
const MARGIN: f64 = 40.0;
const BETWEEN: f64 = 24.0;
const GAP: f64 = 20.0;
const HEADING: f64 = 21.0;
const LINE: f64 = 19.0;

/// Widest figure of a column, in pixels.
const WIDEST: f64 = 760.0;

/// Letters of the usual size for a pixel, such that they fit whatever they are.
const DENSITY: f64 = 0.146;

/// Lines of a caption.
const LINES: usize = 3;

/// A part of the page: the figures that may stand there, the first that the hoop has is taken.
type Slot = &'static [&'static str];

/// The figures of a poster in rows, from top to bottom.
const ROWS: [[Slot; 2]; 2] = [
    [&["outcomes", "figure-2a"], &["figure-1", "figure-7b"]],
    [
        &["figure-2b", "figure-4", "figure-2a"],
        &["forces", "figure-6b", "figure-5b"],
    ],
];

/// Beside the equations, at the bottom.
const LAST: Slot = &["bounces", "energy", "figure-7b", "figure-5b"];

/// What may stand where nothing else does.
const OTHERS: Slot = &["energy", "figure-3a", "figure-2a", "impact", "bounces"];

/// A poster of a hoop and a motion: the hoop at equal intervals of time, the map of outcomes, body,
/// path, phase portrait, forces, energy, equations. What does not apply to the hoop is replaced by another figure, or by the reason in
/// words.
///
/// # Errors
/// A start that is out of bounds; none is known otherwise.
pub fn poster(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    let motion = input.hoop.simulate(input.start, input.limits)?;
    let mut taken: Vec<&'static str> = Vec::new();
    let rows = ROWS.map(|row| row.map(|slot| choose(slot, input, &mut taken, watch)));
    let last = choose(LAST, input, &mut taken, watch);
    let hero = stroboscope::wide(input, NARROWEST - 2.0 * MARGIN)
        .ok()
        .map(Figure::fitted);
    let content = Content {
        input,
        motion,
        hero,
        rows,
        last,
    };
    // The page has the proportions of A3. A full one is larger, and all on it smaller in print.
    let height = content.on_page(NARROWEST).1;
    let width = NARROWEST.max(height * POSTER_MM[0] / POSTER_MM[1]);
    let (page, height) = content.on_page(width);
    Ok(page.finish(width, width * POSTER_MM[1] / POSTER_MM[0], height))
}

/// Columns of the places on a page.
const COLUMNS: [&str; 2] = ["right", "up"];

/// What stands on a page.
struct Content<'a> {
    input: &'a FigureInput,
    motion: Trajectory,
    /// The stroboscope, from side to side; none where there is no motion.
    hero: Option<Figure>,
    rows: [[Result<Figure, String>; 2]; 2],
    last: Result<Figure, String>,
}

impl Content<'_> {
    /// The page of a width, and how high it is.
    fn on_page(&self, width: f64) -> (Page, f64) {
        let mut page = Page {
            width,
            panels: Vec::new(),
            labels: Vec::new(),
            lines: Vec::new(),
        };
        let mut top = page.head(self.input, &self.motion);
        if let Some(hero) = &self.hero {
            top = page.block(hero, MARGIN, top, width - 2.0 * MARGIN) + GAP;
        }
        // Each part goes where there is more room, so that no place stays blank for a figure that
        // this hoop has not.
        let mut ends = [top; 2];
        let next = |ends: &[f64; 2]| usize::from(ends[1] < ends[0]);
        let all = || self.rows.iter().flatten().chain([&self.last]);
        for figure in all().filter_map(|figure| figure.as_ref().ok()) {
            let column = next(&ends);
            let left = page.left(column);
            ends[column] = page.block(figure, left, ends[column], page.column()) + GAP;
        }
        let column = next(&ends);
        ends[column] = page.equations(self.input, page.left(column), ends[column]);
        let figures = self.rows.iter().flatten();
        for reason in figures.filter_map(|figure| figure.as_ref().err()) {
            let (left, top) = (page.left(column), ends[column] + 0.5 * LINE);
            ends[column] = page.note(reason, left, top, page.letters());
        }
        (page, f64::max(ends[0] - GAP, ends[1]) + MARGIN)
    }
}

/// A figure of a slot, or why there is none.
fn choose(
    slot: Slot,
    input: &FigureInput,
    taken: &mut Vec<&'static str>,
    watch: &mut Watch<'_>,
) -> Result<Figure, String> {
    let mut reason = None;
    let entries = slot
        .iter()
        .chain(OTHERS)
        .filter_map(|name| find_figure(name));
    for entry in entries {
        if taken.contains(&entry.name) {
            continue;
        }
        match entry.figure_with(input, watch) {
            Ok(figure) if figure.width <= WIDEST => {
                taken.push(entry.name);
                return Ok(figure);
            }
            Ok(_) => {}
            Err(error) => {
                reason.get_or_insert(format!("No figure of {}: {error}.", entry.title));
            }
        }
    }
    Err(reason.unwrap_or_else(|| "No other figure applies to this hoop.".to_owned()))
}

struct Page {
    width: f64,
    panels: Vec<Panel>,
    labels: Vec<Label>,
    lines: Vec<Piece>,
}

impl Page {
    /// Width of a column.
    fn column(&self) -> f64 {
        0.5 * (self.width - 2.0 * MARGIN - BETWEEN)
    }

    /// Letters of a caption in a line of a column.
    fn letters(&self) -> usize {
        (DENSITY * self.column()) as usize
    }

    fn text(&mut self, text: impl Into<String>, x: f64, y: f64, size: f64) {
        self.labels
            .push(Label::new(text, &[x, -y]).left().sized(size));
    }

    /// Title, the numbers of the hoop, and what happens; returns where the rest begins.
    fn head(&mut self, input: &FigureInput, motion: &Trajectory) -> f64 {
        self.text("Littlewood's hoop", MARGIN, 58.0, 54.0);
        let subtitle = if motion.phases().is_empty() {
            "A hoop with a particle on it, on a rough plane, and a start from which no motion is determined."
        } else if input.is_massless() {
            "A hoop without mass, and a particle on it, on a rough plane: it rolls, then glides without any force."
        } else if input.hoop.offset() == 0.0 {
            "A hoop with a particle at its centre, on a rough plane: balanced, it never jumps by itself."
        } else {
            "A hoop with a particle on it, on a rough plane: it rolls, slides, and jumps by itself."
        };
        self.text(subtitle, MARGIN, 108.0, 24.0);
        let hoop = format!("This hoop: {}.", numbers(input, &Quantity::HOOP));
        self.text(hoop, MARGIN, 142.0, 18.0);
        let story = format!(
            "It starts with {}. {}",
            numbers(input, &START),
            story(motion)
        );
        let mut y = 168.0;
        for line in wrapped(&story, (1.5 * self.letters() as f64) as usize, 2) {
            self.text(line, MARGIN, y, 18.0);
            y += 24.0;
        }
        self.lines
            .push(vec![vec![MARGIN, -y], vec![self.width - MARGIN, -y]]);
        y + 16.0
    }

    /// The left end of a column, 0 or 1.
    fn left(&self, column: usize) -> f64 {
        MARGIN + (self.column() + BETWEEN) * column as f64
    }

    /// A few lines of so many letters; returns their lower end.
    fn note(&mut self, text: &str, left: f64, mut y: f64, letters: usize) -> f64 {
        for line in wrapped(text, letters, LINES) {
            self.labels
                .push(Label::new(line, &[left, -y]).left().coloured(SOFT));
            y += LINE;
        }
        y
    }

    /// A figure with its title above and its caption below; returns its lower end.
    fn block(&mut self, figure: &Figure, left: f64, top: f64, wide: f64) -> f64 {
        let heading = figure
            .title
            .split_once(": ")
            .map_or(&*figure.title, |(_, title)| title);
        self.text(capitalised(heading), left, top + 0.5 * HEADING, 20.0);
        let (right, down) = (
            left + 0.5 * (wide - figure.width).max(0.0),
            top + HEADING + 6.0,
        );
        for panel in &figure.panels {
            let mut panel = panel.clone();
            shift(&mut panel, right, down);
            self.panels.push(panel);
        }
        let below = down + figure.height + 16.0;
        self.note(&figure.caption, left, below, (DENSITY * wide) as usize)
    }

    /// The laws of motion; returns their lower end.
    fn equations(&mut self, input: &FigureInput, left: f64, top: f64) -> f64 {
        self.text("The laws", left, top + 0.5 * HEADING, 20.0);
        let mut y = top + HEADING + 22.0;
        for (name, equation) in laws(input) {
            self.labels.push(
                Label::new(name, &[left, -y])
                    .left()
                    .coloured(SOFT)
                    .sized(16.0),
            );
            for line in equation {
                self.text(line, left + 120.0, y, 17.0);
                y += 27.0;
            }
            y += 9.0;
        }
        let units = "Lengths in radii *R*, times in √(*R*/*g*), masses in that of the particle; ′ is the rate; *m*, *h*: mass \
                     and distance of the mass centre; *I\u{302}*: moment of inertia about it; *σ* = ±1: direction of the slip.";
        let y = self.note(units, left, y, self.letters());
        let source = "After A. Bronars and O. M. O'Reilly, Proc. R. Soc. A 475 (2019), computed by littlewood.";
        self.labels.push(
            Label::new(source, &[left, -(y + 8.0)])
                .left()
                .coloured(SOFT),
        );
        y + 8.0 + LINE
    }

    /// The figure of a page of these sides of which so much is used.
    fn finish(self, width: f64, height: f64, used: f64) -> Figure {
        let Self {
            mut panels,
            labels,
            lines,
            ..
        } = self;
        let down = (0.1 * (height - used)).max(0.0);
        panels.iter_mut().for_each(|panel| shift(panel, 0.0, down));
        let x = PlotAxis::silent(COLUMNS[0], [0.0, width].into());
        let y = PlotAxis::silent(COLUMNS[1], [down - height, down].into());
        let layers = vec![Series::new("rule", &COLUMNS, lines).drawn(Stroke::solid(GRID, 1.6))];
        let content = littlewood_draw::Content {
            name: "page",
            x,
            y,
            layers,
            labels,
        };
        panels.push(Sheet::bare(
            PanelFrame::from_corner(width, height),
            content,
            0.0,
        ));
        Figure {
            name: "poster",
            title: "Littlewood's hoop".to_owned(),
            caption: "A hoop with a particle on it, on a rough plane: its motion in equal times, the map of outcomes, the body, its \
                      path, phase portrait, forces, energy and laws."
                .to_owned(),
            width,
            print_mm: Some(POSTER_MM[0]),
            height,
            panels,
            notes: Vec::new(),
        }
    }
}

/// Moves a panel on the page.
fn shift(panel: &mut Panel, right: f64, down: f64) {
    panel.frame.left += right;
    panel.frame.top += down;
    for key in &mut panel.keys {
        key.at = [key.at[0] + right, key.at[1] + down];
    }
}

/// What a motion starts with.
const START: [Quantity; 3] = [Quantity::Theta, Quantity::ThetaRate, Quantity::Slip];

/// Some numbers of a hoop or a start, those that it has.
fn numbers(input: &FigureInput, quantities: &[Quantity]) -> String {
    let setup = Setup::new(input.hoop.parameters(), input.start);
    let words: Vec<String> = quantities
        .iter()
        .filter_map(|quantity| {
            let value = setup.said(*quantity)?;
            let is_angle = quantity.dimension() == Dimension::Angle;
            let number = if is_angle { angle(value) } else { short(value) };
            Some(format!("{} = {number}", marked(quantity.sign())))
        })
        .collect();
    words.join(", ")
}

/// What happens, in a sentence.
fn story(motion: &Trajectory) -> String {
    let phases = motion.phases();
    let mut modes: Vec<String> = phases
        .iter()
        .take(6)
        .map(|phase| phase.mode().name().to_owned())
        .collect();
    let label = motion.outcome().kind().label();
    if modes.is_empty() {
        return format!("No motion follows: {label}.");
    }
    if phases.len() > 6 {
        modes.push(format!("{} phases more", phases.len() - 6));
    }
    format!("Then: {}; in the end: {label}.", modes.join(", "))
}

/// The laws that a hoop obeys, each in lines.
fn laws(input: &FigureInput) -> Vec<(&'static str, Vec<String>)> {
    let slope = input.hoop.slope();
    let lines = |lines: &[&str]| lines.iter().map(|line| (*line).to_owned()).collect();
    let holds = ("holds while", lines(&["|*F*| ≤ *μ*_{s} *N*,  *N* > 0"]));
    let inertia = if input.is_massless() {
        "*D* = 1 + *ℓ*^{2} + 2*ℓ* cos *θ*"
    } else {
        "*D* = *I\u{302}* + *m*(1 + *h*^{2}) + 2*mh* cos *θ*"
    };
    let rolling = if slope == 0.0 {
        vec![format!("*D* (*θ*′^{{2}} + 1) = constant,  {inertia}")]
    } else {
        let energy =
            "½*D* *θ*′^{2} + *mh* cos *α* cos *θ* − *m* sin *α* (*θ* + *h* sin *θ*) = constant,";
        vec![energy.to_owned(), inertia.to_owned()]
    };
    let mut laws = vec![("Rolling", rolling), holds];
    if input.is_massless() {
        laws.push((
            "Gliding",
            lines(&[
                "*N* = *F* = 0: the particle falls freely,",
                "and the hoop without mass follows it",
            ]),
        ));
        if slope == 0.0 {
            laws.push((
                "On the rim",
                lines(&["the slip begins where tan |*θ*/2| = *μ*_{s}"]),
            ));
        }
    } else {
        let weight = if slope == 0.0 { "1" } else { "cos *α*" };
        let friction = "*F* = −*μ*_{k} *σN*,  *I\u{302} θ*″ = *qN*,  *q* = *h* sin *θ* − *μ*_{k} *σ*(1 + *h* cos *θ*)";
        let normal = format!(
            "*N* = *I\u{302} m* ({weight} − *h* cos *θ* *θ*′^{{2}})/(*I\u{302}* + *mh* sin *θ* *q*)"
        );
        laws.push(("Sliding", vec![friction.to_owned(), normal]));
        let lift_off = format!("where {}, whatever the friction", lift_off_condition(slope));
        laws.push(("Lift-off", vec![lift_off]));
        laws.push((
            "Flight",
            lines(&["*θ*″ = 0, and the mass centre falls freely"]),
        ));
    }
    laws
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// A text in lines of so many letters; what does not fit in them ends with its last whole sentence.
fn wrapped(text: &str, letters: usize, lines: usize) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut begins = 0;
    // Sentences are taken as long as they fit.
    let mut ends: Vec<usize> = text.match_indices(". ").map(|(at, _)| at + 1).collect();
    ends.push(text.len());
    for end in ends {
        let all = fill(&text[..end], letters);
        if all.len() > lines && begins > 0 {
            break;
        }
        found = all;
        begins = end;
    }
    found.truncate(lines);
    found
}

fn fill(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line)
                if plain(line).chars().count() + 1 + plain(word).chars().count() <= letters =>
            {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
