//! A poster: the story of one hoop on a page, of figures of the catalogue, with equations and plain
//! sentences.

use littlewood::{Cause, Mode, Phase, Trajectory};
use littlewood_draw::Figure;

use crate::catalogue::{Watch, find_figure, finished};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::page::{Page, Paper, STORY, SUBTITLE, TITLE};
use crate::paper::stroboscope;

/// Sides of a poster in millimetres: A3.
pub const POSTER_MM: [f64; 2] = [420.0, 297.0];

const PAPER: Paper = Paper {
    name: "poster",
    title: "Littlewood's hoop",
    caption: "A hoop with a particle on it, on a rough plane: its motion in equal times, the map of outcomes, the phase portrait, \
              the body, forces, energy and laws.",
    sides_mm: POSTER_MM,
    columns: 4,
};

/// Columns that the hoop in equal times takes.
const OF_HERO: usize = 3;

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
    let column = Page::input_of_column(input);
    let mut taken: Vec<&'static str> = Vec::new();
    let mut choose = |slot: Slot| choose(slot, &column, &mut taken, watch);
    let (beside, below) = (BESIDE.map(&mut choose), BELOW.map(&mut choose));
    Ok(Page::written(PAPER, |page| {
        let all = page.all_columns(0.0);
        page.lines(PAPER.title, &all, 58.0, TITLE);
        page.lines(&subtitle(input, &motion), &all, 108.0, SUBTITLE);
        let story = format!("This hoop: {}. {}", input.in_words(), story(&motion));
        let y = page.lines(&story, &all, 142.0, STORY);
        page.rule(&all, y);
        let top = y + 16.0;
        let mut left = page.columns(0, OF_HERO, top);
        let mut right = page.columns(OF_HERO, PAPER.columns - OF_HERO, top);
        // None where there is no motion.
        if let Ok(hero) = stroboscope::bolder(&left.input_across(input)) {
            page.across(&finished(hero, input), &mut left);
        }
        for (figures, columns) in [(&beside[..], &mut right), (&below, &mut left)] {
            for figure in figures {
                match figure {
                    Ok(figure) => page.stack(figure, columns),
                    Err(reason) => page.remark(reason, columns),
                }
            }
        }
        let all = page.all_columns(f64::max(left.end(), right.end()));
        let end = page.laws(input, &all);
        page.colophon(&all, end)
    }))
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
    // Flights one after another, and glides either way, are said once, with how many they are.
    let runs: Vec<&[Phase]> = phases.chunk_by(|a, b| a.mode() == b.mode()).collect();
    let mut modes: Vec<String> = runs
        .iter()
        .take(6)
        .map(|run| {
            let name = run[0].mode().name();
            if run.len() > 1 {
                format!("{name} ({} times)", run.len())
            } else {
                name.to_owned()
            }
        })
        .collect();
    let label = motion.outcome().kind().label();
    if modes.is_empty() {
        return format!("No motion follows: {label}.");
    }
    let more: usize = runs.iter().skip(6).map(|run| run.len()).sum();
    if more > 0 {
        modes.push(format!("{more} phases more"));
    }
    format!("Then: {}; in the end: {label}.", modes.join(", "))
}
