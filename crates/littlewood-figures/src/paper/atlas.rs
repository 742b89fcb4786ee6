//! An atlas of fates: the outcome of each start in the phase plane, and around it the motions of
//! some.

use littlewood::tables::{PhaseCode, Setup};
use littlewood::theory::Window;
use littlewood::{Engine, Start, Summary};
use littlewood_draw::{
    Content, Figure, INK, Key, Label, Mark, PAPER, Panel, PanelFrame, PlotAxis, START, Series,
    Sheet, Stroke, TRANSITION,
};
use littlewood_style::ticks::minus;
use littlewood_style::width::FINE;
use littlewood_sweep::Workers;

use super::outcomes;
use crate::catalogue::Watch;
use crate::effort::Effort;
use crate::error::FigureError;
use crate::fate::{Fates, meanings};
use crate::input::FigureInput;
use crate::miniature::picture;
use crate::motion::Shown;

const NAME: &str = "atlas";
/// Width of the sheet on a screen, and least width of a motion.
const WIDTH: f64 = 1160.0;
const EACH: f64 = 180.0;
/// Motions of a row.
const ROW: [f64; 2] = [2.0, 6.0];
/// Height of a motion to its width, radii from side to side, distance of two.
const FLAT: f64 = 0.56;
const RADII: f64 = 8.0;
const BESIDE: f64 = 10.0;
/// Room for the leaders, and height of the plane to the width of the sheet.
const LEADERS: f64 = 34.0;
const PLANE: f64 = 0.34;
/// Starts among which those of the atlas are chosen, to the right and upwards.
const COLUMNS: usize = 61;
const ROWS: usize = 31;
/// Phases that are named of a motion.
const LETTERS: usize = 5;
/// Rows on either side of the middle, where motions are slow, that have no start of the atlas.
const SLOW: usize = 2;
/// Columns of places on the sheet.
const PAGE: [&str; 2] = ["right", "up"];

/// A start of the atlas, and its phases and outcome in words.
struct Chosen {
    start: Start,
    words: String,
}

/// The phases and the outcome of a motion, in words.
fn words(fates: Fates, summary: &Summary) -> String {
    let class = fates.class(summary);
    let codes = summary.sequence.codes().filter_map(Result::ok);
    let letters: Vec<&str> = codes.map(PhaseCode::name).collect();
    let shown = &letters[..letters.len().min(LETTERS)];
    let goes_on = class.stays_in_contact() && !summary.outcome.is_forever();
    let more = if goes_on || shown.len() < letters.len() {
        "…"
    } else {
        ""
    };
    format!("{}{more}: {}", minus(&shown.concat()), fates.label(class))
}

/// A start of the lattice, its column and row counted from the lower left.
#[derive(Clone, Copy)]
struct Place {
    column: usize,
    row: usize,
}

impl Place {
    fn all() -> impl Iterator<Item = Self> {
        (0..ROWS).flat_map(|row| (0..COLUMNS).map(move |column| Self { column, row }))
    }

    fn start(self, window: Window) -> Start {
        let along = |[from, to]: [f64; 2], i: usize, count: usize| {
            from + (to - from) * (i as f64 + 0.5) / count as f64
        };
        Start::at(
            along(window.x, self.column, COLUMNS),
            along(window.y, self.row, ROWS),
        )
    }

    /// The square of the distance to another.
    fn far(self, other: Self) -> usize {
        self.column.abs_diff(other.column).pow(2) + self.row.abs_diff(other.row).pow(2)
    }

    /// The square of the distance to beyond the nearest edge of the plane.
    fn to_the_edge(self) -> usize {
        let (across, upwards) = (COLUMNS - self.column, ROWS - self.row);
        let nearest = (self.column + 1).min(across).min(self.row + 1).min(upwards);
        nearest * nearest
    }

    /// 0 in the upper half of the plane, 1 in the lower.
    fn half(self) -> usize {
        usize::from(self.row < ROWS / 2)
    }
}

/// The places of the lattice, each with its fate in words; none where no motion begins.
fn fates_of(
    input: &FigureInput,
    window: Window,
) -> Result<Vec<(Place, Option<String>)>, FigureError> {
    let engine = Engine::builder(&input.hoop).interpolate_slips().build();
    let limits = Effort::of(&input.hoop, input.limits, &engine).cut(input.limits, &engine);
    let parameters = input.hoop.parameters();
    let places: Vec<Place> = Place::all().collect();
    let points = places
        .iter()
        .map(|place| Setup::new(parameters, place.start(window)));
    let found = Workers::new(None)?.compute(points, limits)?;
    let fates = Fates::of(&input.hoop);
    let key = |summary: Summary| (!summary.sequence.is_empty()).then(|| words(fates, &summary));
    let keys = found.summaries().map(key);
    Ok(places.into_iter().zip(keys).collect())
}

/// The fates, the most frequent first.
fn ranked(places: &[(Place, Option<String>)]) -> Vec<&String> {
    let mut ranked: Vec<(&String, usize)> = Vec::new();
    for key in places.iter().filter_map(|(_, key)| key.as_ref()) {
        match ranked.iter_mut().find(|(known, _)| *known == key) {
            Some((_, count)) => *count += 1,
            None => ranked.push((key, 1)),
        }
    }
    ranked.sort_by(|(a, m), (b, n)| n.cmp(m).then(a.cmp(b)));
    ranked.into_iter().map(|(key, _)| key).collect()
}

/// The starts with the most frequent fates, each as far as can be from those with another one: of
/// the upper half of the plane, and of the lower.
fn choose(
    input: &FigureInput,
    window: Window,
    count: usize,
) -> Result<[Vec<Chosen>; 2], FigureError> {
    let places = fates_of(input, window)?;
    // The edges of the plane are as foreign as another fate.
    let depth = |place: Place, key: &String| {
        let others = places
            .iter()
            .filter(|(_, other)| other.as_ref() != Some(key));
        let others = others.map(|(other, _)| place.far(*other));
        others.min().unwrap_or(usize::MAX).min(place.to_the_edge())
    };
    let mut halves: [Vec<Chosen>; 2] = Default::default();
    for key in ranked(&places) {
        let own = places.iter().filter(|(place, other)| {
            other.as_ref() == Some(key) && place.row.abs_diff(ROWS / 2) > SLOW
        });
        let best = |half: usize| {
            own.clone()
                .map(|(place, _)| *place)
                .filter(|place| place.half() == half)
                .max_by_key(|place| depth(*place, key))
        };
        // Where there is more room; a fate that half of the plane has not is taken from the other.
        let first = usize::from(halves[1].len() < halves[0].len());
        let here = [first, 1 - first]
            .into_iter()
            .filter(|half| halves[*half].len() < count);
        if let Some((half, place)) = here.filter_map(|half| Some((half, best(half)?))).next() {
            halves[half].push(Chosen {
                start: place.start(window),
                words: key.clone(),
            });
        }
    }
    Ok(halves)
}

/// Puts starts in an order in which leaders from them to the places of a row do not cross: that of
/// the least length.
fn in_order(chosen: &mut [Chosen], length: &dyn Fn(&Chosen, usize) -> f64) {
    let mut improves = true;
    while improves {
        improves = false;
        for i in 0..chosen.len() {
            for j in i + 1..chosen.len() {
                let now = length(&chosen[i], i) + length(&chosen[j], j);
                if length(&chosen[j], i) + length(&chosen[i], j) < now - 1e-9 {
                    chosen.swap(i, j);
                    improves = true;
                }
            }
        }
    }
}

/// Refuses what cannot be drawn, before any motion is followed.
pub(crate) fn check(input: &FigureInput) -> Result<(), FigureError> {
    input.loaded(NAME)?;
    input.sheet(WIDTH).map(drop)
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    wide(input, WIDTH, watch)
}

/// Where the plane and the motions above and below it stand.
struct Layout {
    left: f64,
    /// Motions of a row, and the width and the height of each.
    count: usize,
    each: f64,
    high: f64,
    /// The plane, and the upper ends of the two rows.
    plane: PanelFrame,
    tops: [f64; 2],
}

impl Layout {
    /// With so much room for keys.
    fn new(sheet: &Sheet, room: f64) -> Self {
        let [left, inner] = sheet.span();
        let count = libm::floor(inner / EACH).clamp(ROW[0], ROW[1]) as usize;
        let each = (inner - BESIDE * (count - 1) as f64) / count as f64;
        let high = FLAT * each;
        let top = 12.0 + room;
        let plane_top = top + high + LEADERS;
        let plane_high = f64::max(PLANE * sheet.width, 260.0);
        Self {
            left,
            count,
            each,
            high,
            plane: PanelFrame {
                left,
                top: plane_top,
                width: inner,
                height: plane_high,
            },
            tops: [top, plane_top + plane_high + LEADERS],
        }
    }

    /// Where the leaders to a row end.
    fn end(&self, half: usize) -> f64 {
        [self.tops[0] + self.high, self.tops[1]][half]
    }

    /// The left end of a motion of a row of so many: fewer than there is room for stand in the
    /// middle.
    fn left_of(&self, i: usize, of: usize) -> f64 {
        let before = 0.5 * (self.count - of) as f64 * (self.each + BESIDE);
        self.left + before + (self.each + BESIDE) * i as f64
    }

    fn height(&self) -> f64 {
        self.tops[1] + self.high + 8.0
    }
}

/// The motions beside the plane, and leaders to them from their starts, in pixels upwards.
#[derive(Default)]
struct Motions {
    pictures: Vec<Panel>,
    leaders: Vec<[[f64; 2]; 2]>,
    starts: Vec<[f64; 2]>,
}

impl Motions {
    fn add_row(
        &mut self,
        input: &FigureInput,
        layout: &Layout,
        plane: &Panel,
        half: usize,
        chosen: &mut [Chosen],
    ) -> Result<(), FigureError> {
        let (count, end) = (chosen.len(), layout.end(half));
        let middle = |i: usize| layout.left_of(i, count) + 0.5 * layout.each;
        let here = |chosen: &Chosen| plane.place([chosen.start.theta, chosen.start.theta_rate]);
        in_order(chosen, &|chosen, i| {
            here(chosen).map_or(0.0, |[x, y]| {
                libm::hypot(x - layout.left_of(i, count) - 0.5 * layout.each, y - end)
            })
        });
        for (i, own) in chosen.iter().enumerate() {
            let motion = input.hoop.simulate(own.start, input.limits)?;
            let motion = Shown::new(motion, input.wording());
            let left = layout.left_of(i, count);
            let frame = PanelFrame {
                left,
                top: layout.tops[half],
                width: layout.each,
                height: layout.high,
            };
            let unit = layout.each / RADII;
            self.pictures
                .push(picture(&motion, frame, unit, &own.words));
            if let Some([x, y]) = here(own) {
                self.leaders.push([[x, -y], [middle(i), -end]]);
                self.starts.push([x, -y]);
            }
        }
        Ok(())
    }

    /// The leaders and the starts, that of the other figures among them, over the whole sheet.
    fn page(&self, own: Option<[f64; 2]>, width: f64, height: f64) -> Panel {
        let line = |colour, width| Mark::Line(Stroke::solid(colour, width));
        let leaders = |name| Series::new(name, &PAGE, self.leaders.clone());
        let starts = |name| Series::of_rows(name, &PAGE, self.starts.clone());
        let layers = vec![
            Series::of_rows("own start", &PAGE, own).drawn(TRANSITION),
            // Edged with paper, to be seen on every colour.
            leaders("edge of a leader").drawn(line(PAPER, 2.6)),
            leaders("leader").drawn(line(INK, FINE)),
            starts("edge of a start").drawn(Mark::Dot(PAPER, 6.0)),
            starts("start").drawn(START),
        ];
        let label = own.map(|at| Label::new("start", &at).left().shifted(9.0, -9.0));
        let content = Content {
            name: "leaders",
            x: PlotAxis::silent(PAGE[0], [0.0, width]),
            y: PlotAxis::silent(PAGE[1], [-height, 0.0]),
            layers,
            labels: Vec::from_iter(label),
        };
        Sheet::bare(PanelFrame::from_corner(width, height), content, 0.0)
    }
}

fn caption(input: &FigureInput, halves: &[Vec<Chosen>; 2]) -> String {
    // Of each kind of phase that is named.
    let is_named = |code: &PhaseCode| {
        let words = halves.iter().flatten().map(|own| &own.words);
        let mut letters = words.filter_map(|words| words.split(':').next());
        letters.any(|letters| letters.contains(&minus(code.name())))
    };
    format!(
        "The outcome of each start with *η*′ = 0, and the motions of some (crosses; diamond: the start of the other figures): the path of the mass centre, and the hoop at \
         some instants, all on one scale{}. Above each motion its sequence of phases: {}. {}.",
        if input.hoop.slope() == 0.0 {
            ""
        } else {
            ", along the plane"
        },
        meanings(is_named),
        input.wording().hoop(&input.hoop)
    )
}

/// The same, so wide on a screen.
pub(crate) fn wide(
    input: &FigureInput,
    width: f64,
    watch: &mut Watch<'_>,
) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let on_screen = FigureInput {
        width_mm: None,
        ..*input
    };
    let outcomes = outcomes::figure(&on_screen, watch)?;
    let sheet = input.sheet(width)?;
    let Some(mut plane) = outcomes.panels.into_iter().next() else {
        return Err(FigureError::NeedsOffset { figure: NAME });
    };
    let entries = plane
        .keys
        .into_iter()
        .map(|Key { mark, text, .. }| (mark, text));
    let (keys, room) = sheet.keys(entries.collect(), 6.0);
    let layout = Layout::new(&sheet, room);
    plane.keys = keys;
    plane.frame = layout.plane;
    let [x, y] = [0, 1].map(|axis| plane.axes()[axis].range);
    let mut halves = choose(input, Window { x, y }, layout.count)?;
    let mut motions = Motions::default();
    for (half, chosen) in halves.iter_mut().enumerate() {
        motions.add_row(input, &layout, &plane, half, chosen)?;
    }
    let [[left, top], [right, bottom]] = plane.axes_frame();
    let is_seen = |[x, y]: &[f64; 2]| (left..=right).contains(x) && (top..=bottom).contains(y);
    let own = plane.place([input.start.theta, input.start.theta_rate]);
    let own = own.filter(is_seen).map(|[x, y]| [x, -y]);
    let page = motions.page(own, sheet.width, layout.height());
    let panels = [plane].into_iter().chain(motions.pictures).chain([page]);
    let (caption, height) = (caption(input, &halves), layout.height());
    Ok(sheet.figure(NAME, "Atlas of fates", caption, height, panels.collect()))
}
