//! Outcomes of the starts in the phase plane: regions bounded by curves.

use core::cell::Cell;
use core::f64::consts::PI;

use littlewood::tables::{Class, Dimension, Quantity, Setup};
use littlewood::theory::Window;
use littlewood::{Engine, Limits, OutcomeKind, Start, Summary};
use littlewood_draw::{
    BOUNDARY, Content, Entries, Figure, Layer, MIXED_OUTCOMES, Mark, PAPER, SOFT, Series, Stroke,
    THEME, key_of_curve, lift_off_condition, marked, short,
};
use littlewood_style::{Curve, RestingPlace, of_class};
use littlewood_sweep::{Axis, FOR_A_POINT, Grid, MIXED, Place, Region, Regions, Workers};

use crate::axes::plane_window;
use crate::catalogue::Watch;
use crate::columns::PLANE;
use crate::effort::Effort;
use crate::error::FigureError;
use crate::fate::Fates;
use crate::input::FigureInput;
use crate::plane::Portrait;

const NAME: &str = "outcomes";
/// Width of the sheet on a screen, in pixels.
const SHEET: f64 = 620.0;
/// How closely boundaries are located, in parts of the plane, and where motions take long: to a
/// tenth of a pixel.
const WIDTH: f64 = 1e-6;
const COARSE: f64 = 2e-4;
/// Part of the plane that can be seen.
const LEAST: f64 = 1e-7;
/// Of a region of motions that go on after a landing: whether they have lifted off. Its class is in
/// the bits below.
const LIFTS: u64 = 1 << 8;
/// Of a region of motions that come to rest: from this bit on, where.
const PLACES: u32 = 9;
/// Starts by which a figure is checked, the part of them that may end otherwise than is drawn
/// without a word, and the multiples modulo 1 that spread them evenly: of the inverse of ρ and its
/// square, ρ³ = ρ + 1.
const CHECKED: usize = 500;
const UNSAID: usize = CHECKED / 100;
const SPREAD: Place = [0.754_877_666_246_693, 0.569_840_290_998_053];
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;

/// How far and how finely the starts of a hoop are followed.
struct Plan {
    limits: Limits,
    /// Starts to the right and upwards at which regions are looked for.
    starts: [usize; 2],
    /// How closely boundaries are located.
    width: f64,
    /// Whether the starts are fewer than usual, as motions take long.
    is_coarse: bool,
}

/// What all motions of the figure may take, about in microseconds, the starts to either side by which
/// that is estimated, and the fewest with which regions are seen.
const WORK: f64 = 2e6;
const PROBED: [usize; 2] = [16, 12];
const FEWEST: [f64; 2] = [61.0, 45.0];
/// Fewest transitions to which motions are followed that take too long.
const SHORTEST: usize = 50;

impl Plan {
    fn new(input: &FigureInput, window: Window) -> Result<Self, FigureError> {
        let engine = Engine::builder(&input.hoop).interpolate_slips().build();
        let effort = Effort::of(&input.hoop, input.limits, &engine);
        let limits = effort.cut(input.limits, &engine);
        let (starts, width) = match effort {
            Effort::Tables => ([401, 301], WIDTH),
            Effort::Direct => ([201, 151], COARSE),
            Effort::Chains | Effort::Bounces | Effort::Simulated | Effort::Long => {
                ([109, 81], COARSE)
            }
            Effort::Resisted { .. } | Effort::Slow => ([61, 45], COARSE),
        };
        let plan = Self {
            limits,
            starts,
            width,
            is_coarse: false,
        };
        let work = effort.of_a_transition() * plan.transitions(input, window)?;
        if work <= WORK {
            return Ok(plan);
        }
        let share = (WORK / work).sqrt();
        let fewer =
            |k: usize| (share * starts[k] as f64).max(FEWEST[k].min(starts[k] as f64)) as usize;
        let starts = [fewer(0), fewer(1)];
        // Where the fewest starts take too long, too, motions are followed less far.
        let points = |[columns, rows]: [usize; 2]| (columns * rows) as f64;
        let left = WORK / (work * points(starts) / points(plan.starts));
        let transitions = (left * limits.transitions as f64) as usize;
        let transitions = transitions.max(SHORTEST).min(limits.transitions);
        Ok(Self {
            starts,
            limits: limits.with_transitions(transitions),
            is_coarse: true,
            ..plan
        })
    }

    /// Transitions of the motions of all starts, estimated by those of some.
    fn transitions(&self, input: &FigureInput, window: Window) -> Result<f64, FigureError> {
        let [columns, rows] = PROBED;
        let share = |i: usize, count: usize| (i as f64 + 0.5) / count as f64;
        let along = |[from, to]: [f64; 2], share: f64| from + (to - from) * share;
        let starts = (0..rows).flat_map(|j| (0..columns).map(move |i| [i, j]));
        let points = starts.map(|[i, j]| {
            let start = Start::at(
                along(window.x, share(i, columns)),
                along(window.y, share(j, rows)),
            );
            Setup::new(input.hoop.parameters(), start)
        });
        let found = Workers::new(None)?.compute(points, self.limits)?;
        let transitions: f64 = found
            .summaries()
            .map(|summary| f64::from(summary.transitions) + 1.0)
            .sum();
        let of_all = self.starts[0] * self.starts[1] * FOR_A_POINT;
        Ok(transitions * of_all as f64 / (columns * rows) as f64)
    }
}

/// The regions of the classes in a window; of motions that go on after a landing each in two parts.
/// And whether any has come to the limit of transitions.
fn regions_of(
    input: &FigureInput,
    plan: &Plan,
    window: Window,
    watch: &mut Watch<'_>,
) -> Result<(Regions, bool), FigureError> {
    let [columns, rows] = plan.starts;
    let axes = vec![
        Axis::new(Quantity::Theta, window.x[0], window.x[1], columns)?,
        Axis::new(Quantity::ThetaRate, window.y[0], window.y[1], rows)?,
    ];
    let grid = Grid::new(
        Setup::new(input.hoop.parameters(), Start::at(0.0, 0.0)),
        axes,
    )?;
    let total = FOR_A_POINT as u64 * grid.len();
    let mut told = |followed: u64| watch(followed.min(total), total);
    let fates = Fates::of(&input.hoop);
    let is_cut = Cell::new(false);
    let key = |summary: &Summary| {
        is_cut.set(is_cut.get() || summary.outcome == OutcomeKind::TransitionLimit);
        key_of(fates, summary)
    };
    let found = Regions::of_grid(
        &grid,
        &key,
        plan.limits,
        plan.width,
        &Workers::new(None)?,
        &mut told,
    )?;
    Ok((found, is_cut.get()))
}

fn key_of(fates: Fates, summary: &Summary) -> u64 {
    let lifts = matches!(
        Class::of(summary),
        Class::LeavesAtOnce | Class::LiftsOffLater
    );
    let class = fates.class(summary);
    let place = if class == Class::Rests {
        (RestingPlace::of(summary.end.theta) as u64) << PLACES
    } else {
        0
    };
    u64::from(class.code()) | place | if fates.go_on && lifts { LIFTS } else { 0 }
}

/// Whether a region is of a class, and of a place of rest, if one is asked for.
fn is_of(key: u64, class: Class, place: Option<RestingPlace>) -> bool {
    let code = u64::from(class.code());
    let is_there = place.is_none_or(|place| key >> PLACES == place as u64);
    key & (LIFTS - 1) == code && is_there
}

/// How many of some starts, spread evenly, end otherwise than is drawn: after many landings ends
/// may change more finely than any curve can show.
fn amiss(
    input: &FigureInput,
    plan: &Plan,
    window: Window,
    regions: &[Region],
) -> Result<usize, FigureError> {
    let places: Vec<Place> = (0..CHECKED)
        .map(|i| SPREAD.map(|share| (share * (i + 1) as f64).fract()))
        .collect();
    let along = |[from, to]: [f64; 2], fraction: f64| from + (to - from) * fraction;
    let start = |&[x, y]: &Place| Start::at(along(window.x, x), along(window.y, y));
    let points = places
        .iter()
        .map(|place| Setup::new(input.hoop.parameters(), start(place)));
    let found = Workers::new(None)?.compute(points, plan.limits)?;
    let fates = Fates::of(&input.hoop);
    let is_amiss = |(place, summary): &(&Place, Summary)| {
        let key = key_of(fates, summary);
        !regions.iter().any(|region| {
            [key, MIXED].contains(&region.key) && is_inside(&region.outlines, **place)
        })
    };
    Ok(places
        .iter()
        .zip(found.summaries())
        .filter(is_amiss)
        .count())
}

/// Whether a place is within closed curves: those around holes go the other way.
fn is_inside(outlines: &[Vec<Place>], [x, y]: Place) -> bool {
    let edges = outlines
        .iter()
        .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    let crossed = edges.filter(|(a, b)| {
        (a[1] <= y) != (b[1] <= y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

/// A window with no lattice on its edges and its axes, where motions may be what they are nowhere
/// else. That it is narrower is not seen.
fn within(window: Window) -> Window {
    let side = |[from, to]: [f64; 2]| [from + 0.37e-5 * (to - from), to - 0.53e-5 * (to - from)];
    Window {
        x: side(window.x),
        y: side(window.y),
    }
}

/// Rows of places of a window.
fn rows_of(
    window: Window,
    lines: impl IntoIterator<Item = Vec<Place>>,
) -> impl Iterator<Item = impl Iterator<Item = Place>> {
    let along = |[from, to]: [f64; 2], fraction: f64| {
        if fraction == 1.0 {
            to
        } else {
            from + (to - from) * fraction
        }
    };
    let row = move |[x, y]: Place| [along(window.x, x), along(window.y, y)];
    lines.into_iter().map(move |line| line.into_iter().map(row))
}

fn at_time(input: &FigureInput, time: f64) -> String {
    let say = input.wording();
    format!("at {} = {}", say.time(), say.value(time, Dimension::Time))
}

/// How long the motions are followed, some of which are `cut` before they end.
fn followed(input: &FigureInput, limits: Limits, cut: bool) -> String {
    let say = input.wording();
    let until = |until| format!("to {} = {}", say.time(), say.value(until, Dimension::Time));
    let end = limits.until.map_or_else(|| "to its end".to_owned(), until);
    if cut {
        format!("{end}, or to {} transitions", limits.transitions)
    } else {
        end
    }
}

/// Refuses what cannot be drawn, before any motion is followed.
pub(crate) fn check(input: &FigureInput) -> Result<(), FigureError> {
    input.loaded(NAME)?;
    input.sheet(SHEET).map(drop)
}

/// What is drawn so far.
struct Drawing<'a> {
    input: &'a FigureInput,
    window: Window,
    regions: Vec<Region>,
    layers: Vec<Layer>,
    keys: Entries,
}

impl Drawing<'_> {
    /// Adds the regions whose keys are part of something, with the share of the plane that they
    /// have; whether there are any.
    fn add(&mut self, name: &str, label: &str, mark: Mark, is_part: impl Fn(u64) -> bool) -> bool {
        let parts: Vec<&Region> = self
            .regions
            .iter()
            .filter(|region| region.area > LEAST && is_part(region.key))
            .collect();
        let area: f64 = parts.iter().map(|region| region.area).sum();
        if area <= 0.0 {
            return false;
        }
        let outlines = parts.into_iter().flat_map(|it| it.outlines.clone());
        let series = Series::new(name, &PLANE, rows_of(within(self.window), outlines));
        self.layers.push(series.drawn(mark));
        let share = libm::round(1000.0 * area) / 10.0;
        let share = if share > 0.0 {
            short(share)
        } else {
            "< 0.1".to_owned()
        };
        self.keys.push((mark, format!("{label}, {share}%")));
        true
    }

    /// Adds the regions of all classes; whether motions are there that go on when they are no
    /// longer followed, as `limits` say in words.
    fn add_classes(&mut self, limits: &str) -> bool {
        let fates = Fates::of(&self.input.hoop);
        let mut goes_on = false;
        for class in Class::ALL {
            if class == Class::Rests {
                for place in RestingPlace::ALL {
                    let mark = Mark::Region(place.colour(THEME));
                    let label = marked(place.label());
                    self.add(place.name(), &label, mark, |key| {
                        is_of(key, class, Some(place))
                    });
                }
                continue;
            }
            let mark = Mark::Region(of_class(class, THEME));
            let is_limited = class == Class::InContact && !limits.is_empty();
            let label = if is_limited {
                format!("{} {limits}", fates.label(class))
            } else {
                fates.label(class).to_owned()
            };
            let is_there = self.add(class.name(), &label, mark, |key| is_of(key, class, None));
            goes_on |= is_there && class == Class::InContact;
        }
        if fates.go_on {
            let mark = Mark::HatchedRegion(SOFT);
            let lifts = |key: u64| key & LIFTS != 0 && key != MIXED;
            self.add("lifts_off", "lifts off before", mark, lifts);
        }
        let mark = Mark::Region(MIXED_OUTCOMES);
        self.add("mixed", "mixed more finely than drawn", mark, |key| {
            key == MIXED
        });
        goes_on
    }

    /// Adds the curves of rolling; a massless hoop does not leave the plane.
    fn add_curves(&mut self) {
        let hoop = &self.input.hoop;
        let portrait = Portrait::new(hoop, self.window);
        let first = match portrait.massless_limit() {
            Some((_, limit)) => Some((Curve::SlipLimit, limit)),
            None if self.input.is_massless() => None,
            None => Some((Curve::LiftOff, portrait.lift_off_locus())),
        };
        let last = (Curve::NormalForceZero, portrait.unloading_locus());
        for (curve, series) in first.into_iter().chain([last]) {
            if !series.pieces.is_empty() {
                let stroke = Stroke::of_curve(curve);
                let under = Stroke::solid(PAPER, stroke.width + 2.0 * MARGIN);
                self.layers.push(series.clone().drawn(under));
                self.layers.push(series.drawn(stroke));
                self.keys.push(key_of_curve(curve, hoop.slope()));
            }
        }
        if let Some(band) = portrait.band_of_rest() {
            let under =
                Stroke::of_curve(Curve::BandOfRest).wide(Curve::BandOfRest.width() + 2.0 * MARGIN);
            self.layers.push(band.series.clone().drawn(Stroke {
                colour: PAPER,
                ..under
            }));
            self.layers.push(band);
            self.keys
                .push(key_of_curve(Curve::BandOfRest, hoop.slope()));
        }
    }
}

fn caption(input: &FigureInput, followed: &str) -> String {
    let remark = if input.is_massless() {
        String::new()
    } else {
        format!(
            " The body leaves the plane at once only beyond {}; between *n* and this curve, where the paper lets it \
             leave, it slides first.",
            lift_off_condition(input.hoop.slope())
        )
    };
    let (landings, hatched) = if Fates::of(&input.hoop).go_on {
        (
            "through all landings ",
            "; hatched: the body lifts off before",
        )
    } else {
        ("", "")
    };
    let rests = if input.hoop.rolling_resistance() > 0.0 {
        " Where it rests is said by the turn between two tops in which its angle *θ* then is."
    } else {
        ""
    };
    format!(
        "Outcome of each start with *η*′ = 0, followed {landings}{followed}{hatched}.{rests} Each point of a boundary lies between two starts with \
         different outcomes.{remark} {}.",
        input.wording().hoop(&input.hoop)
    )
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    let hoop = &input.hoop;
    let window = if input.is_massless() {
        Window {
            x: [-PI, PI],
            y: [-2.0, 2.0],
        }
    } else {
        plane_window(hoop)
    };
    let plan = Plan::new(input, within(window))?;
    let (found, is_cut) = regions_of(input, &plan, within(window), watch)?;
    let amiss = if Fates::of(hoop).go_on {
        amiss(input, &plan, within(window), &found.regions)?
    } else {
        0
    };
    let mut drawing = Drawing {
        input,
        window,
        regions: found.regions,
        layers: Vec::new(),
        keys: Vec::new(),
    };
    let limits = [
        is_cut.then(|| format!("after {} transitions", plan.limits.transitions)),
        plan.limits.until.map(|until| at_time(input, until)),
    ];
    let limits = limits
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(" or ");
    let goes_on = drawing.add_classes(&limits);
    let lines = found.boundaries.into_iter().map(|boundary| boundary.points);
    let boundary = Series::new("boundary", &PLANE, rows_of(within(window), lines));
    drawing.layers.push(boundary.drawn(BOUNDARY));
    drawing.add_curves();
    let say = input.wording();
    let content = Content {
        name: "plane",
        x: say.angle(window.x.into()),
        y: say.rate(window.y.into()),
        layers: drawing.layers,
        labels: Vec::new(),
    };
    let caption = caption(input, &followed(input, plan.limits, is_cut && goes_on));
    let sheet = input.sheet(SHEET)?;
    let figure = sheet.plot(NAME, "Outcome", caption, 430.0, content, drawing.keys);
    let finer = format!(
        "Outcomes vary more finely than drawn: of {CHECKED} other starts {amiss} have another outcome."
    );
    let [columns, rows] = plan.starts;
    let coarse = format!("Motions take long: regions are looked for at {columns} × {rows} starts.");
    let figure = figure.noted(plan.is_coarse.then_some(coarse));
    Ok(figure.noted((amiss > UNSAID).then_some(finer)))
}
