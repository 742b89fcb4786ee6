//! An atlas of fates: the outcome of each start in the phase plane, and around it the motions of
//! some.

use littlewood::tables::{PhaseCode, Setup};
use littlewood::theory::Window;
use littlewood::{Engine, Start, Summary};
use littlewood_draw::{
    Content, Figure, INK, Key, Label, Mark, PAPER, Panel, Piece, PlotAxis, START, Series, Sheet,
    Stroke, TRANSITION, View,
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
const LATTICE: [usize; 2] = [61, 31];
/// Phases that are named of a motion.
const LETTERS: usize = 5;
/// Rows on either side of the middle, where motions are slow, that have no start of the atlas.
const SLOW: usize = 2;
/// Columns of places on the sheet.
const COLUMNS: [&str; 2] = ["right", "up"];

/// A start of the atlas, and its phases and outcome in words.
struct Chosen {
    start: Start,
    words: String,
}

/// The phases and the outcome of a motion, in words.
fn words(fates: Fates, summary: &Summary) -> String {
    let class = fates.class(summary);
    let letters: Vec<&str> = summary
        .sequence
        .codes()
        .filter_map(Result::ok)
        .map(PhaseCode::name)
        .collect();
    let shown = &letters[..letters.len().min(LETTERS)];
    let goes_on = class.stays_in_contact() && !summary.outcome.is_forever();
    let more = if goes_on || shown.len() < letters.len() {
        "…"
    } else {
        ""
    };
    format!("{}{more}: {}", minus(&shown.concat()), fates.label(class))
}

/// The starts with the most frequent fates, each as far as can be from those with another one: of
/// the upper half of the plane, and of the lower.
fn choose(
    input: &FigureInput,
    window: Window,
    count: usize,
) -> Result<[Vec<Chosen>; 2], FigureError> {
    let [columns, rows] = LATTICE;
    let along = |[from, to]: [f64; 2], i: usize, count: usize| {
        from + (to - from) * (i as f64 + 0.5) / count as f64
    };
    let places: Vec<[usize; 2]> = (0..rows)
        .flat_map(|j| (0..columns).map(move |i| [i, j]))
        .collect();
    let start =
        |&[i, j]: &[usize; 2]| Start::at(along(window.x, i, columns), along(window.y, j, rows));
    let engine = Engine::builder(&input.hoop).interpolate_slips().build();
    let limits = Effort::of(&input.hoop, input.limits, &engine).cut(input.limits, &engine);
    let points = places
        .iter()
        .map(|place| Setup::new(input.hoop.parameters(), start(place)));
    let found = Workers::new(None)?.compute(points, limits)?;
    let fates = Fates::of(&input.hoop);
    let keys: Vec<Option<String>> = found
        .summaries()
        .map(|summary| (!summary.sequence.is_empty()).then(|| words(fates, &summary)))
        .collect();
    let mut ranked: Vec<(&String, usize)> = Vec::new();
    for key in keys.iter().flatten() {
        match ranked.iter_mut().find(|(known, _)| *known == key) {
            Some((_, count)) => *count += 1,
            None => ranked.push((key, 1)),
        }
    }
    ranked.sort_by(|(a, m), (b, n)| n.cmp(m).then(a.cmp(b)));
    let depth = |place: &[usize; 2], key: &String| {
        let far = |other: &[usize; 2]| {
            [0, 1]
                .map(|k| place[k].abs_diff(other[k]).pow(2))
                .iter()
                .sum::<usize>()
        };
        let others = places
            .iter()
            .zip(&keys)
            .filter(|(_, other)| other.as_ref() != Some(key));
        // The edges of the plane are as foreign.
        let edge = [
            place[0] + 1,
            columns - place[0],
            place[1] + 1,
            rows - place[1],
        ]
        .map(|it| it * it);
        others
            .map(|(other, _)| far(other))
            .chain(edge)
            .min()
            .unwrap_or(0)
    };
    let mut halves: [Vec<Chosen>; 2] = Default::default();
    for (key, _) in ranked {
        let is_fast = |place: &&[usize; 2]| place[1].abs_diff(rows / 2) > SLOW;
        let own = places
            .iter()
            .zip(&keys)
            .filter(|(_, other)| other.as_ref() == Some(key));
        let own = own.map(|(place, _)| place).filter(is_fast);
        let in_half = |half: usize| move |place: &&[usize; 2]| (place[1] < rows / 2) == (half == 1);
        let best = |half: usize| {
            own.clone()
                .filter(in_half(half))
                .max_by_key(|place| depth(place, key))
        };
        // Where there is more room; a fate that half of the plane has not is taken from the other.
        let first = usize::from(halves[1].len() < halves[0].len());
        let here = [first, 1 - first]
            .into_iter()
            .filter(|half| halves[*half].len() < count);
        if let Some((half, place)) = here.filter_map(|half| Some((half, best(half)?))).next() {
            halves[half].push(Chosen {
                start: start(place),
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

/// The same, so wide on a screen.
pub(crate) fn wide(
    input: &FigureInput,
    width: f64,
    watch: &mut Watch<'_>,
) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let outcomes = outcomes::figure(
        &FigureInput {
            width_mm: None,
            ..*input
        },
        watch,
    )?;
    let sheet = input.sheet(width)?;
    let [left, inner] = sheet.span();
    let Some(Panel {
        view: View::Plane { x, y, .. },
        layers,
        keys,
        ..
    }) = outcomes.panels.into_iter().next()
    else {
        return Err(FigureError::NeedsOffset { figure: NAME });
    };
    let window = Window {
        x: x.range,
        y: y.range,
    };
    let entries = keys
        .into_iter()
        .map(|Key { mark, text, .. }| (mark, text))
        .collect();
    let (keys, room) = sheet.keys(entries, 6.0);
    let count = libm::floor(inner / EACH).clamp(ROW[0], ROW[1]) as usize;
    let mut halves = choose(input, window, count)?;
    let each = (inner - BESIDE * (count - 1) as f64) / count as f64;
    let high = FLAT * each;
    let top = 12.0 + room;
    let plane_top = top + high + LEADERS;
    let plane_high = f64::max(PLANE * sheet.width, 260.0);
    let tops = [top, plane_top + plane_high + LEADERS];
    let content = Content {
        name: "plane",
        x,
        y,
        layers,
        labels: Vec::new(),
    };
    let mut plane = Sheet::panel([left, plane_top, inner, plane_high], content);
    plane.keys = keys;
    let (mut leaders, mut starts, mut pictures) = (Vec::new(), Vec::new(), Vec::new());
    for (half, chosen) in halves.iter_mut().enumerate() {
        // Fewer than there is room for stand in the middle.
        let before = 0.5 * (count - chosen.len()) as f64 * (each + BESIDE);
        let left_of = |i: usize| left + before + (each + BESIDE) * i as f64;
        let end = [tops[0] + high, tops[1]][half];
        let here = |chosen: &Chosen| plane.place([chosen.start.theta, chosen.start.theta_rate]);
        let length = |chosen: &Chosen, i: usize| {
            here(chosen).map_or(0.0, |[x, y]| {
                libm::hypot(x - left_of(i) - 0.5 * each, y - end)
            })
        };
        in_order(chosen, &length);
        for (i, own) in chosen.iter().enumerate() {
            let motion = input.hoop.simulate(own.start, input.limits)?;
            let frame = [left_of(i), tops[half], each, high];
            pictures.push(picture(
                &motion,
                frame,
                each / RADII,
                Some(own.words.clone()),
            ));
            if let Some([x, y]) = here(own) {
                leaders.push(vec![vec![x, -y], vec![left_of(i) + 0.5 * each, -end]]);
                starts.push(vec![x, -y]);
            }
        }
    }
    let height = tops[1] + high + 8.0;
    let line = |colour, width| Mark::Line(Stroke::solid(colour, width));
    let start = plane
        .place([input.start.theta, input.start.theta_rate])
        .filter(|[x, y]| {
            let [[left, top], [right, bottom]] = plane.axes_frame();
            (left..=right).contains(x) && (top..=bottom).contains(y)
        });
    let own: Piece = start.iter().map(|[x, y]| vec![*x, -y]).collect();
    let labels = own
        .iter()
        .map(|at| Label::new("start", at).left().shifted(9.0, -9.0))
        .collect();
    let marks = vec![
        Series::of_rows("own start", &COLUMNS, own).drawn(TRANSITION),
        // Edged with paper, to be seen on every colour.
        Series::new("edge of a leader", &COLUMNS, leaders.clone()).drawn(line(PAPER, 2.6)),
        Series::new("leader", &COLUMNS, leaders).drawn(line(INK, FINE)),
        Series::of_rows("edge of a start", &COLUMNS, starts.clone()).drawn(Mark::Dot(PAPER, 6.0)),
        Series::of_rows("start", &COLUMNS, starts).drawn(START),
    ];
    let x = PlotAxis::silent(COLUMNS[0], [0.0, sheet.width]);
    let y = PlotAxis::silent(COLUMNS[1], [-height, 0.0]);
    let content = Content {
        name: "leaders",
        x,
        y,
        layers: marks,
        labels,
    };
    let page = Sheet::bare([0.0, 0.0, sheet.width, height], content, 0.0);
    let say = input.wording();
    // Of each kind of phase that is named.
    let is_named = |code: &PhaseCode| {
        let words = halves
            .iter()
            .flatten()
            .filter_map(|own| own.words.split(':').next());
        words
            .into_iter()
            .any(|letters| letters.contains(&minus(code.name())))
    };
    let caption = format!(
        "The outcome of each start with *η*′ = 0, and the motions of some (crosses; diamond: the start of the other figures): the path of the mass centre, and the hoop at \
         some instants, all on one scale{}. Above each motion its sequence of phases: {}. {}.",
        if input.hoop.slope() == 0.0 {
            ""
        } else {
            ", along the plane"
        },
        meanings(is_named),
        say.hoop(&input.hoop)
    );
    let panels = core::iter::once(plane)
        .chain(pictures)
        .chain([page])
        .collect();
    Ok(sheet.figure(NAME, "Atlas of fates", caption, height, panels))
}
