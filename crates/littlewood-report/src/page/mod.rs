//! A motion as a page for a person: hoop and start, the table of the phases, how it ends, and what
//! it has come to.

mod balance;
mod derivatives;
mod digits;
mod parts;
mod phases;
mod uncertainty;

use littlewood::si::SiSetup;
use littlewood::tables::{Dimension, Quantity, SampleColumn, SampleValue, Setup};
use littlewood::{Hoop, Outcome, Phase, Start, State, Trajectory};

use crate::number::{brief, column};
use crate::sampling::Sampling;
use crate::scale::Scale;
use crate::sentence;
use crate::sheet::{Sheet, Table, filled};
use crate::subject::Subject;
use crate::{Instant, instants};

/// What stands between the quantities of a line, and how many letters a line has at most.
const GAP: &str = "   ";
const LINE: usize = 71;

/// The columns of a table of samples.
const COLUMNS: [SampleColumn; 9] = [
    SampleColumn::Time,
    SampleColumn::Mode,
    SampleColumn::Theta,
    SampleColumn::ThetaRate,
    SampleColumn::Slip,
    SampleColumn::X,
    SampleColumn::Normal,
    SampleColumn::Friction,
    SampleColumn::Gap,
];

/// What the page of a motion shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Look<'a> {
    /// Which instants, if any.
    pub sampling: Option<Sampling>,
    /// Print a row for every bounce and phase.
    pub all: bool,
    /// What could be changed to follow a motion further that a limit has stopped.
    pub advice: Option<&'a str>,
}

/// Adds hoop and start.
pub fn setup(sheet: &mut Sheet, hoop: &Hoop, subject: &Subject<'_>) {
    let scale = Scale::new(subject.units);
    sheet.fact("Hoop", hoop_lines(hoop, subject));
    sheet.fact(
        "Start",
        state_lines(&State::from(subject.start), subject.start.gap_rate, scale),
    );
}

/// The table of the phases of a motion; with `all`, a row for every bounce and phase.
pub fn phases(trajectory: &Trajectory, scale: Scale<'_>, all: bool) -> Table {
    phases::phases(trajectory, scale, all)
}

/// Adds a motion from its hoop to the notes.
pub fn motion(sheet: &mut Sheet, subject: &Subject<'_>, trajectory: &Trajectory, look: Look<'_>) {
    let scale = Scale::new(subject.units);
    setup(sheet, trajectory.hoop(), subject);
    if !trajectory.phases().is_empty() {
        sheet.gap();
        sheet.add(phases(trajectory, scale, look.all));
    }
    sheet.gap();
    sheet.fact("Outcome", outcome(trajectory, scale, look.advice));
    sheet.fact("Jump", balance::jumps(trajectory, scale, look.all));
    sheet.fact(
        "Landings",
        Vec::from_iter(balance::landings(trajectory, scale)),
    );
    let energy = balance::energy(trajectory, scale);
    sheet.fact("Energy", filled(energy.into_iter(), " ", LINE));
    if let Some(digits) = subject.digits {
        sheet.fact("Digits", digits::trusted(trajectory, digits, scale));
    }
    if let Some(derivatives) = subject.derivatives {
        derivatives::derivatives(sheet, trajectory, derivatives);
    }
    if let Some(uncertainty) = subject.uncertainty {
        uncertainty::uncertainty(sheet, trajectory, uncertainty);
    }
    if let Some(sampling) = look.sampling {
        sheet.gap();
        samples(sheet, trajectory, sampling, scale);
    }
    notes(sheet, subject, trajectory);
}

/// Adds a table of something of each transition and of the outcome, with the columns of a state.
fn states(sheet: &mut Sheet, kind: &str, mark: char, rows: Vec<Vec<String>>) {
    let head = ["#", "event", kind].map(str::to_owned).into_iter();
    let head = head.chain(State::COLUMNS.map(|column| format!("{mark}{}", column.sign())));
    sheet.gap();
    sheet.table(head.collect(), rows, &[0, 3, 4, 5, 6, 7]);
    sheet.gap();
}

/// The parameters of the hoop, and in SI units its measures and the unit of time.
fn hoop_lines(hoop: &Hoop, subject: &Subject<'_>) -> Vec<String> {
    let law = hoop.restitution().map(|restitution| restitution.law());
    let item = |(quantity, value): (Quantity, f64)| {
        let unit = match law {
            Some(law) if quantity == Quantity::Restitution => format!("({law})"),
            Some(_) | None => quantity.unit_sign().to_owned(),
        };
        format!("{} = {} {unit}", quantity.sign(), brief(value))
            .trim_end()
            .to_owned()
    };
    let setup = Setup::new(hoop.parameters(), Start::default());
    let parameters = Quantity::HOOP
        .into_iter()
        .filter_map(|quantity| Some((quantity, setup.said(quantity)?)));
    let mut lines = filled(parameters.map(item), GAP, LINE);
    if let Some(units) = subject.units {
        let si = SiSetup::new(&setup, units);
        let measures = Quantity::SI_HOOP
            .into_iter()
            .filter(|quantity| quantity.is_si())
            .filter_map(|quantity| Some((quantity, si.said(quantity)?)));
        let second = Dimension::Time;
        let time = format!(
            "{} = {} {}",
            second.scale_sign(),
            brief(units.time_s),
            second.si_sign()
        );
        lines.extend(filled(measures.map(item).chain([time]), GAP, LINE));
    }
    lines
}

/// Time, θ, θ′ and η′ of a state; the rate of the gap and x where they are not zero.
fn state_lines(state: &State, gap_rate: f64, scale: Scale<'_>) -> Vec<String> {
    let item = |quantity, text: String| format!("{} = {text}", scale.sign(quantity));
    let velocity = |value| scale.show(Dimension::Velocity, value);
    let rate = (gap_rate != 0.0).then(|| item(Quantity::GapRate, velocity(gap_rate)));
    let place = scale.show_with_unit(Dimension::Length, state.x);
    let place = (state.x != 0.0).then(|| item(Quantity::X, place));
    let always = [
        item(Quantity::Time, scale.show(Dimension::Time, state.time)),
        scale.show_angle(state.theta),
        item(
            Quantity::ThetaRate,
            scale.show(Dimension::AngularRate, state.theta_rate),
        ),
        item(Quantity::Slip, velocity(state.slip)),
    ];
    filled(always.into_iter().chain(rate).chain(place), "  ", LINE)
}

/// How the motion ends, and the state there or where the phase begins that has no end.
fn outcome(trajectory: &Trajectory, scale: Scale<'_>, advice: Option<&str>) -> Vec<String> {
    let outcome = trajectory.outcome();
    let mut lines = broken(&sentence::outcome(trajectory, scale));
    lines.extend(advice.map(str::to_owned));
    let gap_rate = if let Outcome::Landing { gap_rate, .. } = outcome {
        gap_rate
    } else {
        0.0
    };
    lines.extend(state_lines(&outcome.state(), gap_rate, scale));
    if outcome.kind().is_forever() && trajectory.end_time().is_finite() {
        let end = scale.show(Dimension::Time, trajectory.end_time());
        lines.push(format!(
            "followed until {} = {end}",
            scale.sign(Quantity::Time)
        ));
    }
    lines
}

/// A sentence in lines, which do not end within an equation.
fn broken(sentence: &str) -> Vec<String> {
    const RELATIONS: [&str; 3] = ["=", ">", "<"];
    let mut words: Vec<String> = Vec::new();
    let mut joins = false;
    for word in sentence.split(' ') {
        let relation = RELATIONS.contains(&word);
        match words.last_mut() {
            Some(last) if relation || joins => last.extend([" ", word]),
            Some(_) | None => words.push(word.to_owned()),
        }
        joins = relation;
    }
    filled(words.into_iter(), " ", LINE)
}

fn samples(sheet: &mut Sheet, trajectory: &Trajectory, sampling: Sampling, scale: Scale<'_>) {
    let headings = COLUMNS.map(|column| match column.dimension() {
        Some(dimension) => scale.heading(scale.column_sign(column), dimension),
        None => column.name().to_owned(),
    });
    let cell = |at: &Instant, it: SampleColumn| match (it.of(&at.sample), it.dimension()) {
        (SampleValue::Real(value), Some(dimension)) => column(scale.value(dimension, value)),
        (SampleValue::Real(value), None) => column(value),
        (SampleValue::Mode(_), _) => at
            .mode
            .map(|mode| mode.with_arrow(at.sample.direction))
            .unwrap_or_default(),
        (SampleValue::Direction(direction), _) => direction
            .map(|direction| direction.arrow().to_string())
            .unwrap_or_default(),
    };
    let rows = instants(trajectory, sampling)
        .map(|at| COLUMNS.map(|it| cell(&at, it)).to_vec())
        .collect();
    let numbers: Vec<usize> = (0..COLUMNS.len())
        .filter(|index| {
            COLUMNS
                .get(*index)
                .is_some_and(|it| it.dimension().is_some())
        })
        .collect();
    sheet.table(headings.to_vec(), rows, &numbers);
}

fn notes(sheet: &mut Sheet, subject: &Subject<'_>, trajectory: &Trajectory) {
    let mut notes = Vec::new();
    if trajectory
        .phases()
        .iter()
        .any(|phase| phase.direction().is_some())
    {
        notes.push("← → direction of slip, the sign of η′".to_owned());
    }
    if trajectory
        .transitions()
        .iter()
        .any(|transition| transition.impact.is_some())
    {
        notes.push(
            "impacts and jams: the state just before; that just after is in the next row"
                .to_owned(),
        );
    }
    if trajectory
        .phases()
        .iter()
        .any(Phase::is_outside_small_inertia_limit)
    {
        notes.push(
            "* gliding as the paper has it (3.17), but not the limit of any slide as the inertia vanishes:"
                .to_owned(),
        );
        notes.push("  there P = I + m h sin θ q would not be positive (Painlevé)".to_owned());
    }
    if subject.units.is_none() {
        notes.push(format!(
            "units (2.9): time {}, length {}, velocity {}, force {}, energy {}",
            Dimension::Time.scale_sign(),
            Dimension::Length.scale_sign(),
            Dimension::Velocity.scale_sign(),
            Dimension::Force.scale_sign(),
            Dimension::Energy.scale_sign(),
        ));
    }
    if !notes.is_empty() {
        sheet.gap();
    }
    notes.iter().for_each(|note| sheet.note(note));
}
