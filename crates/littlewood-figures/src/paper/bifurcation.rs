//! How a motion changes along a line of starts or of parameters: its sequence, and the times of its
//! transitions.

use core::f64::consts::PI;

use littlewood::tables::{Class, PhaseCode, Quantity, Setup};
use littlewood::{Engine, Hoop, Limits, Mode, Summary};
use littlewood_draw::{
    BOUNDARY, Content, Entries, Figure, HATCH, Label, Layer, Mark, Panel, Piece, PlotAxis, ROOM,
    SMALL, Scale, Series, Sheet, THEME, width,
};
use littlewood_style::ticks::minus;
use littlewood_style::{of_class, of_mode};
use littlewood_sweep::{Axis, Band, Grid, Workers};

use crate::axes::plane_window;
use crate::catalogue::Watch;
use crate::columns::TIME;
use crate::effort::Effort;
use crate::error::FigureError;
use crate::fate::{Fate, Fates, meanings};
use crate::input::FigureInput;
use crate::timeline::CLOSE;
use crate::wording::Wording;

const NAME: &str = "bifurcation";
/// Width of the sheet on a screen, in pixels.
const SHEET: f64 = 640.0;
/// Motions along the line that are compared first.
const MOTIONS: usize = 401;
/// How closely a boundary is located, in parts of the line.
const WIDTH: f64 = 1e-10;
/// Motions whose transitions are drawn, along the whole line, and in the narrowest band.
const DRAWN: f64 = 240.0;
const FEWEST: usize = 12;
/// Bands that are drawn at most: beyond that they cannot be told apart.
const MOST_BANDS: usize = 400;
/// Width of a band in pixels, from which on its lines can be told apart.
const NARROW: f64 = 3.0;
/// Boundaries whose places the caption says.
const SAID: usize = 8;
/// Part of the bands whose transitions are all within the picture.
const SHOWN: f64 = 0.95;
/// Room beside the first and the last boundary, in parts of what is between them, and the least
/// part of a line.
const BESIDE: f64 = 0.2;
const LEAST_PART: f64 = 0.05;
/// Greatest rate that is shown of a massless hoop.
const MASSLESS: f64 = 2.0;
/// The time goes so far beyond the last transition.
const BEYOND: f64 = 1.1;

/// How far a time may be from the chord between its neighbours, in parts of the picture, and how
/// often they are halved for it.
const FLAT: f64 = 1e-3;
const HALVINGS: u32 = 7;

/// An end of a phase that moves by so much of the picture from one place to the next more often
/// than this is no curve.
const LEAP: f64 = 0.02;
const LEAPS: usize = 8;

/// The line along which a motion changes.
struct Line {
    grid: Grid,
    axis: Axis,
}

impl Line {
    /// The line that is asked for, or rates up to that of the figure of outcomes.
    fn new(input: &FigureInput) -> Result<Self, FigureError> {
        let asked = match input.along {
            Some(axis) => axis,
            None => {
                let most = if input.is_massless() {
                    MASSLESS
                } else {
                    plane_window(&input.hoop).y[1]
                };
                Axis::new(Quantity::ThetaRate, 0.0, most, MOTIONS)?
            }
        };
        let axis = Axis::new(asked.varies(), asked.from(), asked.to(), MOTIONS)?;
        let grid = Grid::new(Setup::new(input.hoop.parameters(), input.start), vec![axis])?;
        Ok(Self { grid, axis })
    }

    /// The part between two fractions, as far as there is such.
    fn part(&self, ends: [f64; 2]) -> Result<Self, FigureError> {
        let [from, to] = ends.map(|end| self.axis.between(end.clamp(0.0, 1.0)));
        let axis = Axis::new(self.axis.varies(), from, to, MOTIONS)?;
        Ok(Self {
            grid: Grid::new(*self.grid.base(), vec![axis])?,
            axis,
        })
    }

    fn setup(&self, fraction: f64) -> Setup {
        let mut setup = *self.grid.base();
        let value = self.axis.between(fraction);
        self.axis
            .varies()
            .quantities()
            .for_each(|quantity| setup.set(quantity, value));
        setup
    }

    /// Its ends, the lower one first.
    fn range(&self) -> [f64; 2] {
        let (from, to) = (self.axis.from(), self.axis.to());
        [from.min(to), from.max(to)]
    }
}

/// When the phases of a motion end that a band tells of; infinite for one without end.
fn ends(setup: &Setup, band: &Band, limits: Limits) -> Option<Vec<f64>> {
    let hoop = Hoop::new(setup.hoop).ok()?;
    // The jam of a start is a transition that ends no phase.
    let transitions = limits.transitions.min(Band::PHASES + 1);
    let motion = hoop
        .simulate(setup.start, limits.with_transitions(transitions))
        .ok()?;
    let phases = motion.phases();
    let codes: Vec<PhaseCode> = band.phases.codes().filter_map(Result::ok).collect();
    let own = phases
        .iter()
        .map(|phase| PhaseCode::new(phase.mode(), phase.direction()));
    let agrees = phases.len() >= codes.len() && own.zip(&codes).all(|(own, code)| own == *code);
    let from = motion.start().time;
    let is_over = motion.outcome().kind().last_event().is_some();
    let end = if is_over {
        motion.end_time() - from
    } else {
        f64::INFINITY
    };
    let told = phases
        .iter()
        .take(codes.len())
        .map(|phase| phase.end_time() - from);
    agrees.then(|| told.chain([end]).collect())
}

/// How many of the motions half-way between those that were followed are of another kind than their
/// band: bands between two of them that are of one kind are not found.
fn amiss(
    (line, bands): (&Line, &[Band]),
    kind: &dyn Fn(&Summary) -> u16,
    limits: Limits,
    workers: &mut Workers,
) -> Result<usize, FigureError> {
    let places: Vec<f64> = (1..MOTIONS)
        .map(|i| (i as f64 - 0.5) / (MOTIONS - 1) as f64)
        .collect();
    let found = workers.compute(places.iter().map(|&place| line.setup(place)), limits)?;
    let is_amiss = |(place, summary): &(&f64, Summary)| {
        let is_here = |band: &&Band| (band.range[0]..=band.range[1]).contains(*place);
        !bands
            .iter()
            .filter(is_here)
            .any(|band| band.kind == kind(summary))
    };
    Ok(places
        .iter()
        .zip(found.summaries())
        .filter(is_amiss)
        .count())
}

/// A place along the line, the ends of the phases of its band there, and the end of the motion,
/// infinite if no event ends it.
type Times = (f64, Vec<f64>);

/// Places between others where times bend.
fn refined(mut places: Vec<Times>, at: &dyn Fn(f64) -> Option<Times>) -> Vec<Times> {
    let until = places
        .iter()
        .flat_map(|(_, ends)| ends)
        .copied()
        .filter(|time| time.is_finite())
        .fold(0.0, f64::max);
    let bends = |a: &Times, m: &Times, b: &Times| {
        (0..m.1.len()).any(|i| (0.5 * (a.1[i] + b.1[i]) - m.1[i]).abs() > FLAT * until)
    };
    let mut open = vec![true; places.len()];
    for _ in 0..HALVINGS {
        let (mut next, mut still) = (Vec::new(), Vec::new());
        for (i, place) in places.iter().enumerate() {
            next.push(place.clone());
            still.push(false);
            let Some(after) = places.get(i + 1).filter(|_| open[i]) else {
                continue;
            };
            let Some(middle) = at(0.5 * (place.0 + after.0)) else {
                continue;
            };
            if bends(place, &middle, after) {
                still.pop();
                next.push(middle);
                still.extend([true, true]);
            }
        }
        (places, open) = (next, still);
        if !open.contains(&true) {
            break;
        }
    }
    places
}

/// A band, and the ends of its phases at some places.
struct Drawn {
    band: Band,
    places: Vec<Times>,
    /// Phases whose ends are curves: later ones may change faster than can be drawn.
    told: usize,
}

impl Drawn {
    fn new(line: &Line, band: Band, limits: Limits) -> Self {
        let [from, to] = band.range;
        let count = FEWEST.max((DRAWN * (to - from)) as usize);
        let inner = |end: f64, inwards: f64| {
            if end == 0.0 || end == 1.0 {
                end
            } else {
                end + inwards
            }
        };
        let (from, to) = (inner(from, WIDTH), inner(to, -WIDTH));
        // Closer together at the ends, where a time may change like a square root.
        let places = (0..=count).map(|i| {
            let share = 0.5 * (1.0 - libm::cos(PI * i as f64 / count as f64));
            if i == count {
                to
            } else {
                from + (to - from) * share
            }
        });
        let at = |at: f64| Some((at, ends(&line.setup(at), &band, limits)?));
        let places = places.filter_map(at).collect();
        let places = refined(places, &at);
        let last = |ends: &[f64]| {
            ends.iter()
                .copied()
                .filter(|time| time.is_finite())
                .fold(0.0, f64::max)
        };
        let until = places
            .iter()
            .map(|(_, ends)| last(ends))
            .fold(0.0, f64::max);
        let all = band.phases.len() as usize;
        let leaps = |number: &usize| {
            let pairs = places
                .windows(2)
                .map(|pair| pair[0].1[*number] - pair[1].1[*number]);
            pairs.filter(|by| by.abs() > LEAP * until).count() > LEAPS
        };
        let told = (0..all).find(leaps).unwrap_or(all);
        Self { band, places, told }
    }

    /// The ends of the phases that are told of.
    fn ends_told<'a>(&self, ends: &'a [f64]) -> &'a [f64] {
        &ends[..if self.is_cut() { self.told } else { ends.len() }]
    }

    fn is_cut(&self) -> bool {
        self.told < self.band.phases.len() as usize
    }

    /// Whether it has a transition.
    fn has_times(&self) -> bool {
        self.places
            .iter()
            .flat_map(|(_, ends)| self.ends_told(ends))
            .any(|time| time.is_finite())
    }

    /// Areas of its phases up to a time, each with its mode.
    fn areas(&self, line: &Line, until: f64) -> Vec<(Mode, Piece)> {
        let codes = self.band.phases.codes().filter_map(Result::ok);
        let value = |at: f64| line.axis.between(at);
        codes
            .take(self.told)
            .enumerate()
            .filter_map(|(number, code)| {
                let begin = |ends: &[f64]| {
                    if number == 0 {
                        0.0
                    } else {
                        ends[number - 1].min(until)
                    }
                };
                let above = self
                    .places
                    .iter()
                    .map(|(at, ends)| vec![value(*at), ends[number].min(until)]);
                let below = self
                    .places
                    .iter()
                    .rev()
                    .map(|(at, ends)| vec![value(*at), begin(ends)]);
                let is_seen = self
                    .places
                    .iter()
                    .any(|(_, ends)| begin(ends) < until.min(ends[number]));
                is_seen.then(|| (code.mode().0, above.chain(below).collect()))
            })
            .collect()
    }

    /// The area of the phases that the band does not tell of.
    fn beyond(&self, line: &Line, until: f64) -> Option<Piece> {
        let begin = |ends: &[f64]| {
            self.told
                .checked_sub(1)
                .map_or(0.0, |number| ends[number].min(until))
        };
        let end = |ends: &[f64]| ends.last().map_or(until, |end| end.min(until));
        let is_seen = (goes_on(&self.band) || self.is_cut())
            && self.places.iter().any(|(_, ends)| begin(ends) < end(ends));
        let below = self
            .places
            .iter()
            .map(|(at, ends)| vec![line.axis.between(*at), begin(ends)]);
        let above = self
            .places
            .iter()
            .rev()
            .map(|(at, ends)| vec![line.axis.between(*at), end(ends)]);
        is_seen.then(|| below.chain(above).collect())
    }

    /// Lines of its transitions up to a time.
    fn lines(&self, line: &Line, until: f64) -> Vec<Piece> {
        (0..self.told)
            .flat_map(|number| {
                let rows: Piece = self
                    .places
                    .iter()
                    .map(|(at, ends)| vec![line.axis.between(*at), ends[number]])
                    .collect();
                let is_drawn = |row: &Vec<f64>| row[1] <= until;
                rows.split(|row| !is_drawn(row))
                    .filter(|part| part.len() > 1)
                    .map(<[Vec<f64>]>::to_vec)
                    .collect::<Vec<_>>()
            })
            .collect()
    }
}

/// Whether the motions of a band go on after the phases that it tells of: to others, or in the same
/// way for ever.
fn goes_on(band: &Band) -> bool {
    band.has_more || Fate::of(band.kind).goes_on
}

fn class(band: &Band) -> Class {
    Fate::of(band.kind).class
}

/// The phases of a band as they are printed, or why there are none.
fn sequence(band: &Band) -> String {
    if let Some(outcome) = Fate::of(band.kind).no_phase {
        return outcome.label().to_owned();
    }
    minus(&band.phases.to_string()) + if goes_on(band) { "…" } else { "" }
}

/// Until which time the transitions of nearly all bands are seen.
fn horizon(bands: &[Drawn], limits: Limits, start: f64) -> Option<f64> {
    // Places count by their parts of the line.
    let mut last: Vec<(f64, f64)> = Vec::new();
    for drawn in bands {
        let places = &drawn.places;
        for (i, (_, ends)) in places.iter().enumerate() {
            let at = |i: usize| places[i.min(places.len() - 1)].0;
            let part = 0.5 * (at(i + 1) - at(i.saturating_sub(1)));
            let own = drawn.ends_told(ends);
            last.extend(
                own.iter()
                    .rev()
                    .find(|time| time.is_finite())
                    .map(|time| (*time, part)),
            );
        }
    }
    last.sort_by(|a, b| a.0.total_cmp(&b.0));
    let all: f64 = last.iter().map(|(_, part)| part).sum();
    let mut sum = 0.0;
    let longest = last.iter().find(|(_, part)| {
        sum += part;
        sum >= SHOWN * all
    });
    let shown = BEYOND * longest?.0;
    let until = limits.until.map_or(shown, |until| shown.min(until - start));
    (until > 0.0).then_some(until)
}

/// What the caption says of the boundaries.
fn said(line: &Line, bands: &[Band], fates: Fates, say: Wording) -> String {
    let sequences: Vec<String> = bands
        .iter()
        .map(|band| format!("{} ({})", sequence(band), fates.label(class(band))))
        .collect();
    let [from, to] = line.range();
    let varies = line.axis.varies();
    let boundaries: Vec<String> = bands[1..]
        .iter()
        .map(|band| {
            say.located(
                varies,
                line.axis.between(band.range[0]),
                WIDTH * (to - from),
            )
        })
        .collect();
    let unit = match say.unit_of(varies) {
        unit if unit.is_empty() => unit,
        unit => format!(" {unit}"),
    };
    if boundaries.is_empty() {
        return format!("All have the same sequence: {}.", sequences[0]);
    }
    if boundaries.len() > SAID {
        let first = boundaries[..SAID].join(", ");
        return format!(
            "{} boundaries, the first at {} = {first}{unit}; the CSV file has all.",
            boundaries.len(),
            say.sign_of(varies)
        );
    }
    let last = sequences.len() - 1;
    format!(
        "From left to right: {} and {}. Boundaries at {} = {}{unit}.",
        sequences[..last].join(", "),
        sequences[last],
        say.sign_of(varies),
        boundaries.join(", ")
    )
}

/// Areas of bands from side to side of a panel, in the colours of their classes.
fn areas_of_classes<'a>(
    line: &Line,
    bands: impl Iterator<Item = &'a Band> + Clone,
    columns: [&'static str; 2],
    top: f64,
    name: impl Fn(Class) -> &'static str,
) -> Vec<Layer> {
    let areas = |own: Class| {
        let bands = bands.clone().filter(move |band| class(band) == own);
        let area = |band: &Band| {
            let [from, to] = band.range.map(|fraction| line.axis.between(fraction));
            vec![
                vec![from, 0.0],
                vec![to, 0.0],
                vec![to, top],
                vec![from, top],
            ]
        };
        let pieces: Vec<Piece> = bands.map(area).collect();
        (!pieces.is_empty()).then(|| {
            Series::new(name(own), &columns, pieces).drawn(Mark::Fill(of_class(own, THEME)))
        })
    };
    Class::ALL.into_iter().filter_map(areas).collect()
}

/// The boundaries that are seen, over a panel.
fn boundaries(
    line: &Line,
    bands: &[Band],
    pixels: f64,
    columns: [&'static str; 2],
    top: f64,
) -> Layer {
    let lines = seen(bands, pixels).map(|fraction| {
        let at = line.axis.between(fraction);
        vec![vec![at, 0.0], vec![at, top]]
    });
    Series::new("boundary", &columns, lines.collect()).drawn(BOUNDARY)
}

/// The panel of sequences and classes.
fn panel_of_bands(line: &Line, bands: &[Band], x: PlotAxis, pixels: f64) -> Content {
    let columns = [line.axis.varies().name(), "share"];
    let place = |fraction: f64| line.axis.between(fraction);
    let mut layers = areas_of_classes(line, bands.iter(), columns, 1.0, Class::name);
    layers.push(boundaries(line, bands, pixels, columns, 1.0));
    let labels = bands.iter().filter_map(|band| {
        let text = sequence(band);
        let [from, to] = band.range;
        let fits = width(&text, SMALL) + 2.0 * MARGIN < (to - from) * pixels;
        let at = 0.5 * (place(from) + place(to));
        fits.then(|| Label::new(text, &[at, 0.5]).sized(SMALL))
    });
    let labels = labels.collect();
    let x = PlotAxis {
        title: String::new(),
        scale: Scale::Nothing,
        ..x
    };
    let y = PlotAxis::silent("share", [0.0, 1.0]);
    Content {
        name: "bands",
        x,
        y,
        layers,
        labels,
    }
}

/// Room beside the text of a band, in pixels.
const MARGIN: f64 = 3.0;

/// Whether the lines of a band can be told apart in a panel so wide.
fn is_wide(band: &Band, pixels: f64) -> bool {
    (band.range[1] - band.range[0]) * pixels > NARROW
}

/// The boundaries beside bands whose lines can be told apart.
fn seen(bands: &[Band], pixels: f64) -> impl Iterator<Item = f64> + '_ {
    let pairs = bands
        .windows(2)
        .filter(move |pair| pair.iter().any(|band| is_wide(band, pixels)));
    pairs.map(|pair| pair[1].range[0])
}

/// The panel of transitions.
fn panel_of_times(
    line: &Line,
    (drawn, pixels): (&[Drawn], f64),
    x: PlotAxis,
    until: f64,
    say: Wording,
) -> (Content, Entries) {
    let columns = [line.axis.varies().name(), TIME];
    let areas: Vec<(Mode, Piece)> = drawn
        .iter()
        .flat_map(|drawn| drawn.areas(line, until))
        .collect();
    let mut layers: Vec<Layer> = Vec::new();
    let mut entries = Vec::new();
    for mode in Mode::ALL {
        let pieces: Vec<Piece> = areas
            .iter()
            .filter(|(own, _)| *own == mode)
            .map(|(_, area)| area.clone())
            .collect();
        if !pieces.is_empty() {
            let mark = Mark::Fill(of_mode(mode, THEME));
            entries.push((mark, mode.to_string()));
            layers.push(Series::new(mode.name(), &columns, pieces).drawn(mark));
        }
    }
    let beyond: Vec<Piece> = drawn
        .iter()
        .filter_map(|drawn| drawn.beyond(line, until))
        .collect();
    if !beyond.is_empty() {
        entries.push((Mark::Hatch(HATCH), "further phases".to_owned()));
        layers.push(Series::new("further phases", &columns, beyond).drawn(Mark::Hatch(HATCH)));
    }
    let undone = drawn
        .iter()
        .map(|drawn| &drawn.band)
        .filter(|band| Fate::of(band.kind).no_phase.is_some());
    layers.extend(areas_of_classes(
        line,
        undone,
        columns,
        until,
        |_| "no phase",
    ));
    let wide = drawn.iter().filter(|drawn| is_wide(&drawn.band, pixels));
    let lines = wide.flat_map(|drawn| drawn.lines(line, until)).collect();
    layers.push(Series::new("transition", &columns, lines).drawn(BOUNDARY));
    let bands: Vec<Band> = drawn.iter().map(|drawn| drawn.band).collect();
    layers.push(boundaries(line, &bands, pixels, columns, until));
    (
        Content {
            name: "times",
            x,
            y: say.clock([0.0, until]),
            layers,
            labels: Vec::new(),
        },
        entries,
    )
}

/// Refuses what cannot be drawn, before any motion is followed.
pub(crate) fn check(input: &FigureInput) -> Result<(), FigureError> {
    input.loaded(NAME)?;
    Line::new(input)?;
    input.sheet(SHEET).map(drop)
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    let mut line = Line::new(input)?;
    let total = 2 * MOTIONS as u64;
    let mut workers = Workers::new(None)?;
    let mut told = |followed: u64| watch(followed.min(total), total);
    // Every transition of a motion is drawn, and each may have a hoop of its own: no chain is
    // passed at once.
    let engine = Engine::builder(&input.hoop).expected_starts(1).build();
    let limits = Effort::of(&input.hoop, input.limits, &engine).cut(input.limits, &engine);
    let fates = Fates::of(&input.hoop);
    let kind = |summary: &Summary| Fate::new(fates, summary).kind();
    let mut bands = Band::along(&line.grid, &kind, limits, WIDTH, &workers, &mut told)?;
    // Of the line that nobody has asked for the part in which motions change.
    if let (None, [_, second, ..], Some(last)) = (input.along, &bands[..], bands.last()) {
        let [from, to] = [second.range[0], last.range[0]];
        let beside = BESIDE * f64::max(to - from, LEAST_PART);
        line = line.part([from - beside, to + beside])?;
        bands = Band::along(&line.grid, &kind, limits, WIDTH, &workers, &mut told)?;
    }
    let [from, to] = line.range();
    let varies = line.axis.varies();
    if bands.len() > MOST_BANDS {
        return Err(FigureError::TooManyBands {
            figure: NAME,
            along: varies,
            from,
            to,
            most: MOST_BANDS,
        });
    }
    let amiss = amiss((&line, &bands), &kind, limits, &mut workers)?;
    let drawn: Vec<Drawn> = bands
        .iter()
        .map(|band| Drawn::new(&line, *band, limits))
        .collect();
    let until = horizon(&drawn, input.limits, input.start.time);
    let Some(until) = until.filter(|_| drawn.iter().any(Drawn::has_times)) else {
        return Err(FigureError::NoTransition {
            figure: NAME,
            along: varies,
            from,
            to,
        });
    };

    let say = input.wording();
    let sheet = input.sheet(SHEET)?;
    let [left, inner] = sheet.span();
    let x = say.varied(varies, [from, to]);
    let upper = panel_of_bands(&line, &bands, x.clone(), inner - ROOM[0]);
    let (lower, phases) = panel_of_times(&line, (&drawn, inner - ROOM[0]), x, until, say);
    let classes = Class::ALL
        .into_iter()
        .filter(|own| bands.iter().any(|band| class(band) == *own));
    let cut = limits.transitions < input.limits.transitions
        && bands.iter().any(|band| class(band) == Class::InContact);
    let entries = classes
        .map(|own| {
            let after = if cut && own == Class::InContact {
                format!(" after {} transitions", limits.transitions)
            } else {
                String::new()
            };
            (
                Mark::Fill(of_class(own, THEME)),
                fates.label(own).to_owned() + &after,
            )
        })
        .chain(phases)
        .collect();
    let (keys, room) = sheet.keys(entries, 6.0);
    let top = room + 14.0;
    let (band_height, height) = (34.0, sheet.height(360.0));
    let mut panels: Vec<Panel> = vec![
        Sheet::panel([left + ROOM[0], top, inner - ROOM[0], band_height], upper),
        Sheet::panel([left, top + band_height + CLOSE, inner, height], lower),
    ];
    panels[0].keys = keys;
    let is_named = |code: &PhaseCode| {
        bands
            .iter()
            .any(|band| band.phases.codes().any(|own| own == Ok(*code)))
    };
    let except: Vec<Quantity> = varies.quantities().collect();
    let others = MOTIONS - 1;
    let finer = format!(
        "Outcomes vary more finely than drawn: of {others} other motions {amiss} have another outcome."
    );
    let cut_short = "Phases whose ends change faster than can be drawn are among the further ones.";
    let cut_short = drawn
        .iter()
        .any(Drawn::is_cut)
        .then(|| cut_short.to_owned());
    let caption = format!(
        "Motions{} that differ in {}. Above: the sequence of phases ({}) and the outcome. Below: the mode at each time, white where the motion has ended, in the \
         colour of its outcome where none begins; where two transitions meet the sequence changes. {} {}.",
        if cut {
            format!(", followed to {} transitions,", limits.transitions)
        } else {
            String::new()
        },
        say.varied_in_words(varies),
        meanings(is_named),
        said(&line, &bands, fates, say),
        say.setup_except(&input.hoop, &input.start, &except)
    );
    let bottom = top + band_height + CLOSE + height + 6.0;
    let title = "Transitions along a line of starts or parameters";
    let figure = sheet.figure(NAME, title, caption, bottom, panels);
    Ok(figure.noted(cut_short).noted((amiss > 0).then_some(finer)))
}
