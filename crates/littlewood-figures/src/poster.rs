//! A poster: the story of one hoop on a page, of figures of the catalogue, with equations and plain
//! sentences.

use littlewood::{Cause, Mode, Trajectory};
use littlewood_draw::{
    Figure, GRID, LETTER, Label, POINTS_TO_A_MM, PRINT_POINTS, Panel, PanelFrame, Piece, PlotAxis,
    SOFT, Series, Sheet, Stroke, lift_off_condition, width, wrapped,
};

use crate::catalogue::{Watch, find_figure, finished};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::paper::stroboscope;

/// Sides of a poster in millimetres: A3.
pub const POSTER_MM: [f64; 2] = [420.0, 297.0];

/// Columns of the page, and how many of them the hoop in equal times takes.
const COLUMNS: usize = 4;
const OF_HERO: usize = COLUMNS - 1;

/// Lengths of the page, in pixels of the drawing.
const COLUMN: f64 = 400.0;
const MARGIN: f64 = 40.0;
const BETWEEN: f64 = 30.0;
const GAP: f64 = 20.0;
const HEADING: f64 = 21.0;
const LINE: f64 = 19.0;
/// Sizes of letters: of the title, what stands below it, the story, a heading, a law.
const TITLE: f64 = 54.0;
const SUBTITLE: f64 = 24.0;
const STORY: f64 = 18.0;
const HEADING_LETTER: f64 = 20.0;
const LAW: f64 = 17.0;

/// Lines of a caption.
const LINES: usize = 3;

/// A part of the page: the figures that may stand there, the first that the hoop has is taken.
type Slot = &'static [&'static str];

/// Beside the hoop in equal times, from top to bottom.
const BESIDE: [Slot; 2] = [
    &["outcomes", "figure-2a"],
    &["figure-2b", "figure-4", "figure-2a"],
];

/// Below it.
const BELOW: [Slot; 3] = [
    &["figure-1", "figure-7b"],
    &["forces", "figure-6b", "figure-5b"],
    &["bounces", "energy", "figure-7b", "figure-5b"],
];

/// What may stand where nothing else does.
const OTHERS: Slot = &["energy", "figure-3a", "figure-2a", "impact", "bounces"];

/// A poster of a hoop and a motion: large the hoop at equal intervals of time with its forces, beside
/// it the map of outcomes and the phase portrait, below the body, forces, energy and equations. What
/// does not apply to the hoop is replaced by another figure, or by the reason in words.
///
/// # Errors
/// A start that is out of bounds; none is known otherwise.
pub fn poster(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    let motion = input.hoop.simulate(input.start, input.limits)?;
    let column = of_width(input, COLUMN);
    let mut taken: Vec<&'static str> = Vec::new();
    let mut choose = |slot: Slot| choose(slot, &column, &mut taken, watch);
    let content = Content {
        input,
        motion,
        beside: BESIDE.map(&mut choose),
        below: BELOW.map(&mut choose),
    };
    // A page that is too low is larger, and all on it smaller in print.
    let mut width = 2.0 * MARGIN + COLUMNS as f64 * (COLUMN + BETWEEN) - BETWEEN;
    loop {
        let (page, height) = content.on_page(width);
        let room = width * POSTER_MM[1] / POSTER_MM[0];
        if height <= room {
            return Ok(page.finish(room, height));
        }
        width = f64::max(height * POSTER_MM[0] / POSTER_MM[1], 1.01 * width);
    }
}

/// The input of a figure of so many pixels.
fn of_width(input: &FigureInput, pixels: f64) -> FigureInput {
    FigureInput {
        width_mm: Some(pixels * PRINT_POINTS / POINTS_TO_A_MM),
        ..*input
    }
}

/// Columns of the places on a page.
const PLACE: [&str; 2] = ["right", "up"];

/// What stands on a page.
struct Content<'a> {
    input: &'a FigureInput,
    motion: Trajectory,
    beside: [Result<Figure, String>; 2],
    below: [Result<Figure, String>; 3],
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
        let top = page.head(self.input, &self.motion);
        let mut ends = [top; COLUMNS];
        // None where there is no motion.
        let wide = page.left(OF_HERO) - BETWEEN - MARGIN;
        let hero = of_width(self.input, wide);
        if let Ok(hero) = stroboscope::bolder(&hero) {
            let hero = finished(hero, self.input);
            ends[..OF_HERO].fill(page.block(&hero, MARGIN, top, wide) + GAP);
        }
        let mut reasons: Vec<&str> = Vec::new();
        let beside = self.beside.iter().map(|figure| (figure, Some(OF_HERO)));
        for (figure, own) in beside.chain(self.below.iter().map(|figure| (figure, None))) {
            // Each goes where there is more room, so that no place stays blank for a figure that
            // this hoop has not.
            let column = own.unwrap_or_else(|| highest(&ends));
            match figure {
                Ok(figure) => {
                    let left = page.left(column);
                    ends[column] = page.block(figure, left, ends[column], page.column()) + GAP;
                }
                Err(reason) => reasons.push(reason),
            }
        }
        for reason in reasons {
            let column = highest(&ends);
            let (left, top) = (page.left(column), ends[column] + 0.5 * LINE);
            ends[column] = page.note(reason, left, top, page.column());
        }
        let end = page.laws(self.input, ends.into_iter().fold(top, f64::max));
        (page, end + 0.5 * MARGIN)
    }
}

/// The column with the most room.
fn highest(ends: &[f64; COLUMNS]) -> usize {
    let by_end = |a: &usize, b: &usize| ends[*a].total_cmp(&ends[*b]);
    (0..COLUMNS).min_by(by_end).unwrap_or(0)
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
            Ok(figure) => {
                taken.push(entry.name);
                return Ok(figure);
            }
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
        (self.width - 2.0 * MARGIN + BETWEEN) / COLUMNS as f64 - BETWEEN
    }

    /// The left end of a column.
    fn left(&self, column: usize) -> f64 {
        MARGIN + (self.column() + BETWEEN) * column as f64
    }

    fn text(&mut self, text: impl Into<String>, x: f64, y: f64, size: f64) {
        self.labels
            .push(Label::new(text, &[x, -y]).left().sized(size));
    }

    /// A line from side to side.
    fn rule(&mut self, y: f64) {
        let ends = [MARGIN, self.width - MARGIN];
        self.lines.push(ends.map(|x| vec![x, -y]).to_vec());
    }

    /// Title, the numbers of the hoop, and what happens; returns where the rest begins.
    fn head(&mut self, input: &FigureInput, motion: &Trajectory) -> f64 {
        self.text("Littlewood's hoop", MARGIN, 58.0, TITLE);
        self.text(subtitle(input, motion), MARGIN, 108.0, SUBTITLE);
        let story = format!("This hoop: {}. {}", input.in_words(), story(motion));
        let mut y = 142.0;
        for line in wrapped(&story, STORY, self.width - 2.0 * MARGIN) {
            self.text(line, MARGIN, y, STORY);
            y += 24.0;
        }
        self.rule(y);
        y + 16.0
    }

    /// A few lines of a width; returns their lower end.
    fn note(&mut self, text: &str, left: f64, mut y: f64, wide: f64) -> f64 {
        for line in beginning(text, wide) {
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
        self.text(
            capitalised(heading),
            left,
            top + 0.5 * HEADING,
            HEADING_LETTER,
        );
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
        self.note(&figure.caption, left, below, wide)
    }

    /// The laws of motion beside each other, below a line; returns their lower end.
    fn laws(&mut self, input: &FigureInput, top: f64) -> f64 {
        self.rule(top);
        let (mut left, mut row, mut end) = (MARGIN, top + 22.0, top);
        for (name, equation) in laws(input) {
            let widths = equation.iter().map(|line| width(line, LAW));
            let wide = widths.fold(0.0, f64::max);
            if left + wide > self.width - MARGIN && left > MARGIN {
                (left, row) = (MARGIN, end + 10.0);
            }
            let name = Label::new(name, &[left, -row]).left().coloured(SOFT);
            self.labels.push(name.sized(16.0));
            let mut y = row;
            for line in equation {
                y += 27.0;
                self.text(line, left, y, LAW);
            }
            end = end.max(y + 18.0);
            left += wide + 2.0 * BETWEEN;
        }
        let units = "In the laws lengths are in radii *R*, times in √(*R*/*g*), masses in that of the particle; ′ is the rate; *m*, *h*: mass \
                     and distance of the mass centre; *I\u{302}*: moment of inertia about it; *σ* = ±1: direction of the slip. \
                     After A. Bronars and O. M. O'Reilly, Proc. R. Soc. A 475 (2019), computed by littlewood.";
        self.note(units, MARGIN, end + 10.0, self.width - 2.0 * MARGIN)
    }

    /// The figure of a page of this height of which so much is used.
    fn finish(self, height: f64, used: f64) -> Figure {
        let Self {
            width,
            mut panels,
            labels,
            lines,
        } = self;
        let down = 0.1 * (height - used);
        panels.iter_mut().for_each(|panel| shift(panel, 0.0, down));
        let x = PlotAxis::silent(PLACE[0], [0.0, width].into());
        let y = PlotAxis::silent(PLACE[1], [down - height, down].into());
        let layers = vec![Series::new("rule", &PLACE, lines).drawn(Stroke::solid(GRID, 1.6))];
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
            caption: "A hoop with a particle on it, on a rough plane: its motion in equal times, the map of outcomes, the phase \
                      portrait, the body, forces, energy and laws."
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

/// The hoop, and what it does, each thing once.
fn subtitle(input: &FigureInput, motion: &Trajectory) -> String {
    let hoop = if input.is_massless() {
        "A hoop without mass, and a particle on it"
    } else if input.hoop.offset() == 0.0 {
        "A hoop with a particle at its centre, balanced"
    } else {
        "A hoop with a particle on it"
    };
    let leaves = motion
        .transitions()
        .iter()
        .any(|it| it.cause == Cause::LiftOff);
    let mut verbs: Vec<&str> = Vec::new();
    for phase in motion.phases() {
        let verb = match phase.mode() {
            Mode::Rolling => "rolls",
            Mode::Sliding => "slides",
            Mode::Gliding => "glides without any force",
            Mode::Flight if leaves => "jumps by itself",
            Mode::Flight => "flies",
            Mode::Rest => "rests",
            Mode::Skidding => "slides without turning",
        };
        if !verbs.contains(&verb) {
            verbs.push(verb);
        }
    }
    let does = match &verbs[..] {
        [] => return format!("{hoop}, on a rough plane: no motion is determined from this start."),
        [verb] => (*verb).to_owned(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    };
    format!("{hoop}, on a rough plane: it {does}.")
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

/// The beginning of a text in a few lines of a width: as many whole sentences as fit.
fn beginning(text: &str, wide: f64) -> Vec<String> {
    let mut ends: Vec<usize> = text.match_indices(". ").map(|(at, _)| at + 1).collect();
    ends.push(text.len());
    let mut found: Vec<String> = Vec::new();
    for end in ends {
        let lines = wrapped(&text[..end], LETTER, wide);
        if lines.len() > LINES && !found.is_empty() {
            break;
        }
        found = lines;
    }
    found.truncate(LINES);
    found
}
