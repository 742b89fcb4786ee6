//! Random commands: every subcommand, flags with numbers that are allowed, hardly allowed, not
//! allowed, and no numbers.

use littlewood::cases::CASES;
use littlewood::tables::{Quantity, Setup, SummaryColumn};
use littlewood::{Limits, RestitutionLaw};
use littlewood_figures::FIGURES;
use serde_json::Value;

use crate::fuzz::program::{judge, run as run_program, typed};
use crate::fuzz::{Case, Verdict};
use littlewood_random::Draw;

/// What is no number, or one that only some programs read.
const NO_NUMBERS: [&str; 11] = [
    "",
    "nan",
    "-inf",
    "infinity",
    "1e400",
    "0x10",
    "1_000",
    "1,5",
    "--",
    "½",
    "9e9999999999",
];

/// Words that may stand anywhere.
const STRAY: [&str; 8] = [
    "--",
    "-",
    "",
    "--si",
    "--no-such-flag",
    "figure-3",
    "--format",
    "--help",
];

pub(crate) fn run(case: &mut Case) -> Verdict {
    let words = words(&mut case.draw);
    case.told.tell(typed(&words));
    let ran = run_program(&words, &case.folder);
    let verdict = judge(&ran)?;
    let is_json = words.windows(2).any(|pair| pair == ["--format", "json"]);
    if verdict == "done" && is_json && !words.iter().any(|word| word == "--help" || word == "--out")
    {
        serde_json::from_slice::<Value>(&ran.stdout).map_err(|error| format!("JSON: {error}"))?;
    }
    Ok(verdict)
}

fn words(draw: &mut Draw) -> Vec<String> {
    let setup = draw.setup();
    let limits = draw.limits(setup.start);
    let mut words = match draw.below(10) {
        0..=3 => simulate(draw, &setup, limits),
        4 => [
            vec!["classify".to_owned()],
            problem(draw, &setup, true),
            format(draw, &["table", "json"]),
        ]
        .concat(),
        5..=7 => plane(draw, &setup, limits),
        8 => figures(draw, &setup, limits),
        _ => animate(draw, &setup, limits),
    };
    // Most commands are as they should be; of the others some have one thing wrong, some several.
    while draw.comes(0.15) {
        let at = 1 + draw.below(words.len() - 1);
        match draw.below(4) {
            0 => {
                words.remove(at);
            }
            1 => words.insert(at, draw.one_of(&STRAY).to_owned()),
            2 => words.insert(at, words[at].clone()),
            _ => words[at] = number(draw, Quantity::Theta),
        }
        if words.len() < 2 {
            break;
        }
    }
    words
}

/// A number as it may be typed for a quantity.
fn number(draw: &mut Draw, quantity: Quantity) -> String {
    let value = match draw.below(40) {
        0 => draw.any(quantity),
        1..20 => draw.allowed(quantity),
        _ => draw.between(quantity.row().usual),
    };
    if draw.comes(0.02) {
        draw.one_of(&NO_NUMBERS).to_owned()
    } else {
        shown(draw, value)
    }
}

fn shown(draw: &mut Draw, value: f64) -> String {
    if draw.comes(0.5) {
        format!("{value:e}")
    } else {
        format!("{value}")
    }
}

fn flag(quantity: Quantity) -> String {
    format!("--{}", quantity.name().replace('_', "-"))
}

/// A hoop and a start: a case with some numbers of its own, or all numbers, in either system of
/// units.
fn problem(draw: &mut Draw, setup: &Setup, has_place: bool) -> Vec<String> {
    let mut words = Vec::new();
    let place =
        |quantity: &Quantity| has_place || !matches!(quantity, Quantity::X | Quantity::Time);
    if draw.comes(0.2) {
        words.push(draw.one_of(CASES).name.to_owned());
    } else if draw.comes(0.2) {
        for quantity in Quantity::SI_HOOP
            .into_iter()
            .chain(Quantity::SI_START)
            .filter(place)
        {
            let is_place = matches!(quantity, Quantity::XM | Quantity::TimeS) && !has_place;
            if !is_place && draw.comes(0.95) {
                words.extend([flag(quantity), number(draw, quantity)]);
            }
        }
        return words;
    }
    let every = words.is_empty();
    for quantity in Quantity::HOOP
        .into_iter()
        .chain(Quantity::START)
        .filter(place)
    {
        if let Some(value) = setup.get(quantity)
            && (if every {
                draw.comes(0.99)
            } else {
                draw.comes(0.3)
            })
        {
            let text = if draw.comes(0.03) {
                number(draw, quantity)
            } else {
                shown(draw, value)
            };
            words.extend([flag(quantity), text]);
        }
    }
    if setup.hoop.restitution.is_some() && draw.comes(0.5) {
        words.extend([
            "--restitution-law".to_owned(),
            draw.one_of(&RestitutionLaw::ALL).name().to_owned(),
        ]);
    }
    words
}

fn limit_words(limits: Limits) -> Vec<String> {
    let mut words = Vec::new();
    if let Some(until) = limits.until {
        words.extend([flag(Quantity::Until), format!("{until:e}")]);
    }
    if limits != Limits::default().with_until(limits.until) {
        words.extend([
            "--max-transitions".to_owned(),
            limits.transitions.to_string(),
        ]);
    }
    words
}

fn format(draw: &mut Draw, formats: &[&str]) -> Vec<String> {
    vec!["--format".to_owned(), draw.one_of(formats).to_owned()]
}

fn simulate(draw: &mut Draw, setup: &Setup, limits: Limits) -> Vec<String> {
    let mut words = vec!["simulate".to_owned()];
    words.extend(problem(draw, setup, true));
    words.extend(limit_words(limits));
    words.extend(format(draw, &["table", "json", "csv"]));
    if draw.comes(0.3) {
        let samples = draw.one_of(&["2", "3", "100", "1", "0", "-1", "10000001", "2.5"]);
        words.extend(["--samples".to_owned(), samples.to_owned()]);
    }
    if draw.comes(0.1) {
        words.push("--all-bounces".to_owned());
    }
    words
}

fn axis(draw: &mut Draw) -> String {
    let quantity = draw.one_of(&Quantity::AXES);
    let mut end = || {
        if draw.comes(0.2) {
            draw.one_of(&[
                "-pi", "pi", "pi/2", "2pi", "-pi/4", "0", "0.5", "1", "pi/0", "pipi", "1e-320",
            ])
            .to_owned()
        } else {
            number(draw, quantity)
        }
    };
    let (from, to) = (end(), end());
    let count = match draw.below(20) {
        0 => draw.one_of(&["0", "-2", "2.5", "99999999999999999999"]),
        _ => draw.one_of(&["1", "2", "3", "4"]),
    };
    let name = if draw.comes(0.95) {
        quantity.name()
    } else {
        "no_such_axis"
    };
    format!("{name}={from}:{to}:{count}")
}

/// `map` or `sweep`.
fn plane(draw: &mut Draw, setup: &Setup, limits: Limits) -> Vec<String> {
    let is_map = draw.comes(0.5);
    let mut words = vec![(if is_map { "map" } else { "sweep" }).to_owned()];
    words.extend(problem(draw, setup, false));
    words.extend(limit_words(limits));
    for name in if is_map {
        ["--x", "--y"]
    } else {
        ["--axis", "--axis"]
    } {
        words.extend([name.to_owned(), axis(draw)]);
    }
    let outs = if is_map {
        ["a.zarr", "a.parquet", "a.png", "a.txt"]
    } else {
        ["a.zarr", "a.parquet", "b.parquet", "a.png"]
    };
    for _ in 0..1 + draw.below(2) {
        words.extend(["--out".to_owned(), draw.one_of(&outs).to_owned()]);
    }
    if draw.comes(0.3) {
        words.extend([
            "--chunk".to_owned(),
            draw.one_of(&["1", "2", "5", "7", "11", "100", "0", "99999999999"])
                .to_owned(),
        ]);
    }
    if is_map && draw.comes(0.3) {
        let shade = draw.one_of(&SummaryColumn::ALL).name();
        words.extend(["--shade".to_owned(), shade.to_owned()]);
    }
    if is_map {
        let size = match draw.below(10) {
            0 => draw.one_of(&["1x1", "0x0", "200x4000", "99999999x9", "300"]),
            _ => "400x300",
        };
        words.extend(["--size".to_owned(), size.to_owned()]);
    }
    words.extend(format(draw, &["table", "json"]));
    words
}

fn figures(draw: &mut Draw, setup: &Setup, limits: Limits) -> Vec<String> {
    // The figure of thousands of motions takes longer than all others together.
    let names: Vec<&str> = FIGURES
        .iter()
        .map(|entry| entry.name)
        .filter(|name| *name != "outcomes")
        .collect();
    let mut words = vec!["figures".to_owned(), draw.one_of(&names).to_owned()];
    words.extend(
        problem(draw, setup, false)
            .into_iter()
            .filter(|word| !word.starts_with("figure") || word.starts_with("--")),
    );
    words.extend(limit_words(limits));
    words.extend(["--out".to_owned(), "figures".to_owned()]);
    let formats = draw.one_of(&[
        "svg",
        "csv",
        "txt",
        "svg,csv,txt",
        "svg,csv",
        "png",
        "png,txt",
        "pdf,txt",
        "dvi",
    ]);
    words.extend(["--format".to_owned(), formats.to_owned()]);
    words.extend([
        "--scale".to_owned(),
        draw.one_of(&["0.5", "1", "0.7", "1.5", "2", "1", "0", "nan", "1e9"])
            .to_owned(),
    ]);
    if draw.comes(0.2) {
        words.extend([
            "--impact".to_owned(),
            draw.one_of(&["1", "2", "0", "99999"]).to_owned(),
        ]);
    }
    words
}

fn animate(draw: &mut Draw, setup: &Setup, limits: Limits) -> Vec<String> {
    let mut words = vec!["animate".to_owned()];
    words.extend(problem(draw, setup, true));
    words.extend(limit_words(limits));
    words.extend([
        "--out".to_owned(),
        draw.one_of(&["a.gif", "b.gif", "a.png", "a.apng", "a.txt", "none/a.gif"])
            .to_owned(),
    ]);
    // Few frames, small ones.
    words.extend([
        "--fps".to_owned(),
        draw.one_of(&["1", "2", "3", "4", "5", "0", "101"])
            .to_owned(),
    ]);
    words.extend([
        "--size".to_owned(),
        draw.one_of(&[
            "160x160", "160x161", "170x160", "160x200", "180x180", "159x160", "9999x160",
        ])
        .to_owned(),
    ]);
    words.extend([
        "--slow".to_owned(),
        draw.one_of(&["0.1", "0.3", "0.2", "0.5", "1", "1e-9", "0", "nan"])
            .to_owned(),
    ]);
    if draw.comes(0.3) {
        words.extend([
            "--camera".to_owned(),
            draw.one_of(&["auto", "whole", "follow"]).to_owned(),
        ]);
    }
    if draw.comes(0.3) {
        words.extend([
            "--with".to_owned(),
            draw.one_of(&["plane", "friction", "energy"]).to_owned(),
        ]);
    }
    words
}
