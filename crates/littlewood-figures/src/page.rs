//! A page: titles, figures of the catalogue in columns with their captions, the laws of motion.

use littlewood_draw::{
    Figure, GRID, LETTER, Label, POINTS_TO_A_MM, PRINT_POINTS, Panel, PanelFrame, Piece, PlotAxis,
    SOFT, Series, Sheet, Stroke, lift_off_condition, width, wrapped,
};

use crate::input::FigureInput;

/// Lengths, in pixels of the drawing.
const COLUMN: f64 = 400.0;
const MARGIN: f64 = 40.0;
const BETWEEN: f64 = 30.0;
const GAP: f64 = 20.0;
const HEADING: f64 = 21.0;
const LINE: f64 = 19.0;
/// Sizes of letters: of the title, what stands below it, the story, a heading, a law.
pub(crate) const TITLE: f64 = 54.0;
pub(crate) const SUBTITLE: f64 = 24.0;
pub(crate) const STORY: f64 = 18.0;
const HEADING_LETTER: f64 = 20.0;
const LAW: f64 = 17.0;

/// Lines of a caption.
const LINES: usize = 3;

const COLOPHON: &str = "In the laws lengths are in radii *R*, times in √(*R*/*g*), masses in that of the particle; ′ is the rate; \
                        *m*, *h*: mass and distance of the mass centre; *I\u{302}*: moment of inertia about it; *σ* = ±1: direction of the \
                        slip. After A. Bronars and O. M. O'Reilly, Proc. R. Soc. A 475 (2019), computed by littlewood.";

/// Coordinates of the places on a page.
const PLACE: [&str; 2] = ["right", "up"];

/// What a page is: its name and its words, its sides in print and its columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paper {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) caption: &'static str,
    pub(crate) sides_mm: [f64; 2],
    pub(crate) columns: usize,
}

/// A page that is written on.
pub(crate) struct Page {
    paper: Paper,
    width: f64,
    panels: Vec<Panel>,
    labels: Vec<Label>,
    lines: Vec<Piece>,
}

impl Page {
    /// The figure of a page on which `write` writes, which returns where it has ended. One that is
    /// too low is larger, and all on it smaller in print.
    pub(crate) fn written(paper: Paper, write: impl Fn(&mut Self) -> f64) -> Figure {
        let [across, upwards] = paper.sides_mm;
        let mut width = 2.0 * MARGIN + paper.columns as f64 * (COLUMN + BETWEEN) - BETWEEN;
        loop {
            let mut page = Self {
                paper,
                width,
                panels: Vec::new(),
                labels: Vec::new(),
                lines: Vec::new(),
            };
            let used = write(&mut page) + 0.5 * MARGIN;
            let height = width * upwards / across;
            if used <= height {
                return page.finish(height, used);
            }
            width = f64::max(used * across / upwards, 1.01 * width);
        }
    }

    /// The input of a figure that is as wide as a column, before the page grows.
    pub(crate) fn input_of_column(input: &FigureInput) -> FigureInput {
        of_width(input, COLUMN)
    }

    /// Some columns below a height, the first of them with this number.
    pub(crate) fn columns(&self, first: usize, count: usize, top: f64) -> Columns {
        let each = (self.width - 2.0 * MARGIN + BETWEEN) / self.paper.columns as f64;
        Columns {
            left: MARGIN + each * first as f64,
            each,
            ends: vec![top; count],
        }
    }

    /// All columns.
    pub(crate) fn all_columns(&self, top: f64) -> Columns {
        self.columns(0, self.paper.columns, top)
    }

    fn text(&mut self, text: impl Into<String>, x: f64, y: f64, size: f64) {
        self.labels
            .push(Label::new(text, &[x, -y]).left().sized(size));
    }

    /// Lines of text of a size below each other; returns where the next would be.
    pub(crate) fn lines(&mut self, text: &str, columns: &Columns, mut y: f64, size: f64) -> f64 {
        for line in wrapped(text, size, columns.wide()) {
            self.text(line, columns.left, y, size);
            y += libm::round(1.35 * size);
        }
        y
    }

    /// A line from side to side of some columns.
    pub(crate) fn rule(&mut self, columns: &Columns, y: f64) {
        let ends = [columns.left, columns.left + columns.wide()];
        self.lines.push(ends.map(|x| vec![x, -y]).to_vec());
    }

    /// A figure from side to side of some columns.
    pub(crate) fn across(&mut self, figure: &Figure, columns: &mut Columns) {
        let end = self.block(figure, columns.left, columns.end(), columns.wide());
        columns.ends.fill(end + GAP);
    }

    /// A figure in that of some columns that has most room.
    pub(crate) fn stack(&mut self, figure: &Figure, columns: &mut Columns) {
        let column = columns.highest();
        let (left, top) = (columns.left_of(column), columns.ends[column]);
        columns.ends[column] = self.block(figure, left, top, columns.column()) + GAP;
    }

    /// A few lines in that of some columns that has most room.
    pub(crate) fn remark(&mut self, text: &str, columns: &mut Columns) {
        let column = columns.highest();
        let (left, top) = (columns.left_of(column), columns.ends[column] + 0.5 * LINE);
        columns.ends[column] = self.note(text, left, top, columns.column());
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

    /// The laws of motion beside each other, below some columns and a line; returns their lower
    /// end.
    pub(crate) fn laws(&mut self, input: &FigureInput, columns: &Columns) -> f64 {
        let (begin, top) = (columns.left, columns.end());
        self.rule(columns, top);
        let (mut left, mut row, mut end) = (begin, top + 22.0, top);
        for (name, equation) in laws(input) {
            let widths = equation.iter().map(|line| width(line, LAW));
            let wide = widths.fold(0.0, f64::max);
            if left + wide > begin + columns.wide() && left > begin {
                (left, row) = (begin, end + 10.0);
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
        end + 10.0
    }

    /// What letters of the laws mean, and where all is from; returns its lower end.
    pub(crate) fn colophon(&mut self, columns: &Columns, top: f64) -> f64 {
        self.note(COLOPHON, columns.left, top, columns.wide())
    }

    /// The figure of a page of this height of which so much is used.
    fn finish(self, height: f64, used: f64) -> Figure {
        let Self {
            paper,
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
            name: paper.name,
            title: paper.title.to_owned(),
            caption: paper.caption.to_owned(),
            width,
            print_mm: Some(paper.sides_mm[0]),
            height,
            panels,
            notes: Vec::new(),
        }
    }
}

/// Columns beside each other, each written on down to its end.
pub(crate) struct Columns {
    left: f64,
    /// From one to the next.
    each: f64,
    ends: Vec<f64>,
}

impl Columns {
    /// From side to side of all.
    pub(crate) fn wide(&self) -> f64 {
        self.each * self.ends.len() as f64 - BETWEEN
    }

    /// Where all have ended.
    pub(crate) fn end(&self) -> f64 {
        self.ends.iter().copied().fold(0.0, f64::max)
    }

    /// The input of a figure from side to side of all.
    pub(crate) fn input_across(&self, input: &FigureInput) -> FigureInput {
        of_width(input, self.wide())
    }

    fn column(&self) -> f64 {
        self.each - BETWEEN
    }

    fn left_of(&self, column: usize) -> f64 {
        self.left + self.each * column as f64
    }

    /// That with the most room.
    fn highest(&self) -> usize {
        let by_end = |a: &usize, b: &usize| self.ends[*a].total_cmp(&self.ends[*b]);
        (0..self.ends.len()).min_by(by_end).unwrap_or(0)
    }
}

/// The input of a figure of so many pixels.
fn of_width(input: &FigureInput, pixels: f64) -> FigureInput {
    FigureInput {
        width_mm: Some(pixels * PRINT_POINTS / POINTS_TO_A_MM),
        ..*input
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
