//! Tables and sentences for a person.

use std::f64::consts::TAU;
use std::io::{self, Write};

use littlewood::cases::CASES;
use littlewood::impact::Impact;
use littlewood::modes::{Recurrence, RollingLimit, SlideLimit};
use littlewood::si::SiSetup;
use littlewood::tables::{Dimension, Quantity, SampleColumn, SampleValue, Setup};
use littlewood::theory::{Candidates, Classification, RollingType, StartRegion};
use littlewood::{Digits, Hoop, Outcome, Phase, Start, State, Trajectory};
use littlewood_report::number::{brief, column};
use littlewood_report::scale::Scale;
use littlewood_report::sentence::NO_IMPACT;
use littlewood_report::{Instant, instants, jam_of};

use super::Sampling;
use super::balance::{energy, jumps, landings};
use super::phases::phases;
use super::sheet::Sheet;
use crate::problem::{Changes, Problem};

/// What stands between the quantities of a line, and how many letters a line of them has at most.
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
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look<'a> {
    /// Which instants, if any.
    pub(crate) sampling: Option<Sampling>,
    /// Whether every bounce and every phase has a row of its own.
    pub(crate) all_bounces: bool,
    /// How many digits of each transition can be trusted, if that is wanted.
    pub(crate) digits: Option<&'a [Option<Digits>]>,
    /// Whether it has emphasis.
    pub(crate) colour: bool,
}

/// A motion.
pub(crate) fn motion(
    writer: &mut dyn Write,
    problem: &Problem,
    trajectory: &Trajectory,
    look: Look<'_>,
) -> io::Result<()> {
    let mut sheet = Sheet::new(writer, look.colour);
    let scale = Scale::new(problem.units.as_ref());
    heading(&mut sheet, problem, scale)?;
    if !trajectory.phases().is_empty() {
        sheet.gap()?;
        phases(&mut sheet, trajectory, scale, look.all_bounces)?;
    }
    sheet.gap()?;
    sheet.fact("Outcome", &outcome(trajectory, scale))?;
    sheet.fact("Jump", &jumps(trajectory, scale, look.all_bounces))?;
    sheet.fact("Landings", &Vec::from_iter(landings(trajectory, scale)))?;
    sheet.fact("Energy", &Vec::from_iter(energy(trajectory, scale)))?;
    if let Some(digits) = look.digits {
        sheet.fact("Digits", &trusted(trajectory, digits, scale))?;
    }
    if let Some(sampling) = look.sampling {
        sheet.gap()?;
        samples(&mut sheet, trajectory, sampling, scale)?;
    }
    notes(&mut sheet, problem, trajectory)
}

/// Digits from which on an estimate needs no word.
const MOST_DIGITS: u8 = 13;

/// Transitions of which some number has lost digits, at most so many, and the first that the start does not decide.
fn trusted(trajectory: &Trajectory, digits: &[Option<Digits>], scale: Scale<'_>) -> Vec<String> {
    const MOST_LINES: usize = 12;
    let decided = digits.iter().take_while(|at| at.is_some()).count();
    let all = decided == digits.len();
    let at = |index: usize| {
        trajectory.transitions().get(index).map_or_else(String::new, |it| {
            let time = scale.show(Dimension::Time, it.time());
            format!("{} at {} = {time}", it.cause.label(), scale.sign(Quantity::Time))
        })
    };
    let poor = digits.iter().enumerate().filter_map(|(index, digits)| {
        let digits = digits.filter(|digits| digits.least() < MOST_DIGITS)?;
        let numbers = [
            (Quantity::Time, digits.time),
            (Quantity::Theta, digits.theta),
            (Quantity::ThetaRate, digits.theta_rate),
            (Quantity::Slip, digits.slip),
            (Quantity::X, digits.x),
        ];
        let numbers = numbers.map(|(quantity, digits)| format!("{} {digits}", scale.sign(quantity)));
        Some(format!("{}: {}", at(index), numbers.join("  ")))
    });
    let mut lines = Vec::from_iter(poor);
    let hidden = lines.len().saturating_sub(MOST_LINES);
    lines.truncate(MOST_LINES);
    if hidden > 0 {
        lines.push(format!("… {hidden} more"));
    }
    if lines.is_empty() && decided > 0 {
        lines.push(format!("at least {MOST_DIGITS} of every number of {decided} transitions"));
    }
    if !all {
        lines.push(format!("not decided by the last digits of the start from here on: {}", at(decided)));
    }
    lines
}

fn heading(sheet: &mut Sheet<'_>, problem: &Problem, scale: Scale<'_>) -> io::Result<()> {
    if let Some(case) = problem.case {
        let Changes { replaced, added } = &problem.changes;
        let another = (!replaced.is_empty()).then(|| format!("with another {}", replaced.join(", ")));
        let new = (!added.is_empty()).then(|| format!("with {}", added.join(", ")));
        let changes: Vec<String> = another.into_iter().chain(new).collect();
        if changes.is_empty() {
            sheet.title(&format!("{}: {}", case.name, case.title))?;
            sheet.fact("Paper", &[case.source.to_owned()])?;
        } else {
            sheet.title(&format!("{} {}", case.name, changes.join(" and ")))?;
        }
    }
    sheet.fact("Hoop", &hoop_lines(problem))?;
    let state = State::from(problem.start);
    let mut line = format!("{} = {}  ", scale.sign(Quantity::Time), scale.show(Dimension::Time, state.time));
    line.push_str(&scale.show_motion(&state));
    let gap_rate = problem.start.gap_rate;
    if gap_rate != 0.0 {
        let rate = scale.show(Dimension::Velocity, gap_rate);
        line.push_str(&format!("  {} = {rate}", scale.sign(Quantity::GapRate)));
    }
    if state.x != 0.0 {
        line.push_str(&format!("  {}", place(&state, scale)));
    }
    sheet.fact("Start", &[line])
}

/// The parameters of the hoop, and in SI units its measures and the unit of time.
fn hoop_lines(problem: &Problem) -> Vec<String> {
    let law = problem.hoop.restitution().map(|restitution| restitution.law());
    let item = |(quantity, value): (Quantity, f64)| {
        let unit = match law {
            Some(law) if quantity == Quantity::Restitution => format!("({law})"),
            Some(_) | None => quantity.unit_sign().to_owned(),
        };
        format!("{} = {} {unit}", quantity.sign(), brief(value)).trim_end().to_owned()
    };
    let setup = Setup::new(problem.hoop.parameters(), Start::default());
    let parameters = Quantity::HOOP.into_iter().filter_map(|quantity| Some((quantity, setup.get(quantity)?)));
    let mut lines = filled(parameters.map(item));
    if let Some(units) = &problem.units {
        let si = SiSetup::new(&setup, units);
        let measures = Quantity::SI_HOOP
            .into_iter()
            .filter(|quantity| quantity.is_si())
            .filter_map(|quantity| Some((quantity, si.get(quantity)?)));
        let second = Dimension::Time;
        let time = format!("{} = {} {}", second.scale_sign(), brief(units.time_s), second.si_sign());
        lines.extend(filled(measures.map(item).chain([time])));
    }
    lines
}

/// As many items in a line as there is room for.
fn filled(items: impl Iterator<Item = String>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for item in items {
        match lines.last_mut() {
            Some(line) if (line.chars().count() + GAP.len() + item.chars().count()) <= LINE => {
                line.push_str(GAP);
                line.push_str(&item);
            }
            Some(_) | None => lines.push(item),
        }
    }
    lines
}

/// x of a state.
fn place(state: &State, scale: Scale<'_>) -> String {
    format!("{} = {}", scale.sign(Quantity::X), scale.show_with_unit(Dimension::Length, state.x))
}

/// Several motions, with the word between them.
fn several(candidates: &Candidates, between: &str) -> String {
    let motions: Vec<String> =
        candidates.consistent().map(|(mode, direction)| mode.with_arrow(direction)).collect();
    motions.join(between)
}

/// How the motion ended, in a few lines.
fn outcome(trajectory: &Trajectory, scale: Scale<'_>) -> Vec<String> {
    let outcome = trajectory.outcome();
    let state = outcome.state();
    let at = format!("{} = {}", scale.sign(Quantity::Time), scale.show(Dimension::Time, state.time));
    let there = scale.show_motion(&state);
    let place = place(&state, scale);
    match outcome {
        Outcome::Landing { gap_rate, .. } => vec![
            format!("lands at {at}; the instant before the impact:"),
            there,
            format!("{place}  velocity of the gap {}", scale.show(Dimension::Velocity, gap_rate)),
        ],
        Outcome::RollsForever { recurrence, .. } => forever(
            trajectory,
            scale,
            format!("rolls for ever from {at}: static friction holds on the whole orbit ahead"),
            &recurrence,
        ),
        Outcome::SlidesForever { recurrence, .. } => forever(
            trajectory,
            scale,
            format!("slides for ever from {at}: no friction, and no event in a whole period"),
            &recurrence,
        ),
        Outcome::SlipsForever { orbit, slips_to_halve, .. } => vec![
            format!("slips for ever from {at}, ever less"),
            format!(
                "towards the orbit that grazes the limit of static friction at θ = ±{}",
                brief(orbit.theta)
            ),
            format!(
                "with the energy {}; the distance from it halves in about {slips_to_halve:.0} slips",
                scale.show_with_unit(Dimension::Energy, orbit.energy),
            ),
            there,
            place,
        ],
        Outcome::RepeatsForever { period, theta_gained, transitions, .. } => vec![
            format!("repeats itself for ever from {at}: no energy is lost"),
            format!(
                "with the period {}, in which there are {transitions} transitions and {:.0} turns",
                scale.show_with_unit(Dimension::Time, period),
                (theta_gained / TAU).abs(),
            ),
            there,
            place,
        ],
        Outcome::StaysInContact { .. } => vec![
            format!(
                "stays in contact for ever: from {at} on its energy and momentum do not suffice for a lift-off"
            ),
            there,
            place,
        ],
        Outcome::ParticleAtPlane { .. } => end_of_glide("the plane", &at, there, place),
        Outcome::ParticleAtBottom { .. } => end_of_glide("its lowest place", &at, there, place),
        Outcome::ParticleAtTop { .. } => vec![
            format!("the particle reaches its highest place at {at} with velocity to spare"),
            there,
            place,
        ],
        Outcome::TimeLimit { .. } => vec![format!("followed until the time limit {at}"), there, place],
        Outcome::TransitionLimit { transitions, .. } => vec![
            format!("stopped after {transitions} transitions at {at}; --max-transitions allows more"),
            there,
            place,
        ],
        Outcome::Inconsistent { candidates, .. } => {
            let first = format!("no motion is consistent at {at} (Painlevé)");
            [first, there, place].into_iter().chain(examined(&candidates)).collect()
        }
        Outcome::Ambiguous { candidates, .. } => {
            let first = format!("several motions are consistent at {at}: {}", several(&candidates, ", "));
            [first, there, place].into_iter().chain(examined(&candidates)).collect()
        }
        Outcome::Singular { solvability, .. } => vec![
            format!(
                "the slide has no solution with N > 0 beyond {at} (Painlevé): P = {}",
                brief(solvability)
            ),
            there,
            place,
        ],
        Outcome::StepLimit { limit: SlideLimit::All { slides }, .. } => vec![
            format!(
                "stopped at {at} after slides of the length {slides}, all together; --max-slides allows more"
            ),
            there,
            place,
        ],
        Outcome::StepLimit { limit: SlideLimit::One { steps, time_left }, .. } => {
            let left = scale.show_with_unit(Dimension::Time, time_left);
            vec![
                format!("stopped at {at} after {steps} steps of a slide: it is too long to be followed"),
                format!("at its pace this slide would stick after another {left}"),
                there,
                place,
            ]
        }
        Outcome::Unresolved { .. } => {
            vec![format!("from {at} the motion changes faster than its numbers resolve"), there, place]
        }
    }
}

/// Where the particle of a massless hoop strikes, and why nothing follows.
fn end_of_glide(reached: &str, at: &str, there: String, place: String) -> Vec<String> {
    vec![format!("the particle reaches {reached} at {at} (3.20)"), there, place, NO_IMPACT.to_owned()]
}

fn forever(trajectory: &Trajectory, scale: Scale<'_>, first: String, recurrence: &Recurrence) -> Vec<String> {
    let mut lines = vec![first, returns(recurrence, scale)];
    let end = trajectory.end_time();
    if end.is_finite() {
        let end = scale.show(Dimension::Time, end);
        lines.push(format!("followed until {} = {end}", scale.sign(Quantity::Time)));
    }
    lines
}

/// How a motion without an end recurs.
fn returns(recurrence: &Recurrence, scale: Scale<'_>) -> String {
    match *recurrence {
        Recurrence::Rest => "at rest, in equilibrium".to_owned(),
        Recurrence::Libration { period, theta_min, theta_max } => format!(
            "back and forth between θ = {} and {} with the period {}",
            brief(theta_min),
            brief(theta_max),
            scale.show(Dimension::Time, period),
        ),
        Recurrence::Rotation { period } => {
            format!("over the top, always the same way, one turn in {}", scale.show(Dimension::Time, period))
        }
        Recurrence::Asymptotic { theta } => {
            format!("towards the unstable equilibrium θ = {}, never reached", brief(theta))
        }
    }
}

/// What was examined where the motion that follows is not unique.
fn examined(candidates: &Candidates) -> Vec<String> {
    let [negative, positive] = candidates.solvability.map(brief);
    vec![
        format!(
            "rolling would need N = {}, F = {}   1 − h cos θ θ′² = {}",
            brief(candidates.rolling_forces.normal),
            brief(candidates.rolling_forces.friction),
            brief(candidates.contact),
        ),
        format!("sliding has P = {negative} for σ = −1 and {positive} for σ = +1, and needs P > 0"),
    ]
}

fn samples(
    sheet: &mut Sheet<'_>,
    trajectory: &Trajectory,
    sampling: Sampling,
    scale: Scale<'_>,
) -> io::Result<()> {
    let headings = COLUMNS.map(|column| match column.dimension() {
        Some(dimension) => scale.heading(scale.column_sign(column), dimension),
        None => column.name().to_owned(),
    });
    let cell = |at: &Instant, it: SampleColumn| match (it.of(&at.sample), it.dimension()) {
        (SampleValue::Real(value), Some(dimension)) => column(scale.value(dimension, value)),
        (SampleValue::Real(value), None) => column(value),
        (SampleValue::Mode(_), _) => {
            at.mode.map(|mode| mode.with_arrow(at.sample.direction)).unwrap_or_default()
        }
        (SampleValue::Direction(direction), _) => {
            direction.map(|direction| direction.arrow().to_string()).unwrap_or_default()
        }
    };
    let rows = instants(trajectory, sampling).map(|at| COLUMNS.map(|it| cell(&at, it)).to_vec()).collect();
    let numbers: Vec<usize> =
        (0..COLUMNS.len()).filter(|index| COLUMNS[*index].dimension().is_some()).collect();
    sheet.table(&headings, rows, &numbers, None)
}

fn notes(sheet: &mut Sheet<'_>, problem: &Problem, trajectory: &Trajectory) -> io::Result<()> {
    let mut notes = Vec::new();
    if trajectory.phases().iter().any(|phase| phase.direction().is_some()) {
        notes.push("← → direction of slip, the sign of η′");
    }
    if trajectory.transitions().iter().any(|transition| transition.impact.is_some()) {
        notes.push("impacts and jams: the state just before; that just after is in the next row");
    }
    if trajectory.phases().iter().any(Phase::is_outside_small_inertia_limit) {
        notes.push(
            "* gliding as the paper has it (3.17), but not the limit of any slide as the inertia vanishes:",
        );
        notes.push("  there P = I + m h sin θ q would not be positive (Painlevé)");
    }
    let units = format!(
        "units (2.9): time {}, length {}, velocity {}, force {}, energy {}",
        Dimension::Time.scale_sign(),
        Dimension::Length.scale_sign(),
        Dimension::Velocity.scale_sign(),
        Dimension::Force.scale_sign(),
        Dimension::Energy.scale_sign(),
    );
    if problem.units.is_none() {
        notes.push(&units);
    }
    if !notes.is_empty() {
        sheet.gap()?;
    }
    notes.into_iter().try_for_each(|note| sheet.note(note))
}

/// What is known of a start.
pub(crate) fn classification(
    writer: &mut dyn Write,
    problem: &Problem,
    found: &Classification,
    colour: bool,
) -> io::Result<()> {
    let mut sheet = Sheet::new(writer, colour);
    let scale = Scale::new(problem.units.as_ref());
    heading(&mut sheet, problem, scale)?;
    sheet.gap()?;
    let region = match scale.show_with_unit(Dimension::Velocity, problem.start.gap_rate) {
        rate if problem.start.gap_rate > 0.0 => format!("thrown: the rim leaves the plane at {rate}"),
        _ => region(found.region).to_owned(),
    };
    sheet.fact("Region", &[region])?;
    let begins = match (found.mode, &found.candidates) {
        (Some(mode), _) => vec![mode.with_arrow(found.direction)],
        (None, Some(candidates)) => {
            let first = if candidates.count() == 0 {
                "nothing that is consistent".to_owned()
            } else {
                several(candidates, ", or ")
            };
            let mut lines = vec![first];
            lines.extend(examined(candidates));
            lines.extend(jam_of(&problem.hoop, problem.start, found).map(|impact| jam(&impact, scale)));
            lines
        }
        (None, None) => vec!["nothing that is known".to_owned()],
    };
    sheet.fact("Begins", &begins)?;
    sheet.fact("Rolling", &rolling(&problem.hoop, found, scale))?;
    sheet.fact("Contact", &[format!("1 − h cos θ θ′² = {}", brief(found.contact))])?;
    sheet.fact("Energy", &[scale.show_with_unit(Dimension::Energy, found.energy)])?;
    sheet.gap()?;
    sheet.note("N > 0 upwards, F > 0 along E1; equations of Bronars and O'Reilly, 2019")
}

/// How a start goes on where no motion is consistent.
fn jam(impact: &Impact, scale: Scale<'_>) -> String {
    let sign = |quantity| scale.sign(quantity);
    format!(
        "jams: an impact without a collision leaves {} = {}, {} = {}, {} = {}",
        sign(Quantity::ThetaRate),
        scale.show(Dimension::AngularRate, impact.after.theta_rate),
        sign(Quantity::Slip),
        scale.show(Dimension::Velocity, impact.after.slip),
        sign(Quantity::GapRate),
        scale.show(Dimension::Velocity, impact.after.gap_rate),
    )
}

const fn region(region: StartRegion) -> &'static str {
    match region {
        StartRegion::Rolling => "inside the rolling region R (2.14): static friction suffices",
        StartRegion::BeyondFriction => "inside N but outside R (2.14): static friction does not suffice",
        StartRegion::SlidingBand => "rolling would need N <= 0, yet the hoop stays in contact and slides",
        StartRegion::LossOfContact => "1 − h cos θ θ′² < 0, or about to be: the hoop leaves the plane",
        StartRegion::Slipping => "in contact with slip, η′ ≠ 0",
        StartRegion::Gliding => "massless, outside R (3.10) or with slip: in contact without a force",
        StartRegion::Inconsistent => "no motion is consistent (Painlevé)",
        StartRegion::Ambiguous => "several motions are consistent (Painlevé)",
    }
}

/// The friction that rolling needs, and whether static friction supplies it.
fn rolling(hoop: &Hoop, found: &Classification, scale: Scale<'_>) -> Vec<String> {
    let forces = found.rolling_forces;
    let force = |value| scale.show_with_unit(Dimension::Force, value);
    let mut needs = format!("needs N = {}, F = {}", force(forces.normal), force(forces.friction));
    if forces.normal > 0.0 {
        let limit = Quantity::MuS.sign();
        needs.push_str(&format!(": |F|/N = {}, {limit} = {}", brief(forces.demand()), brief(hoop.mu_s())));
    }
    let mut lines = vec![needs];
    if let Some(end) = &found.rolling_end {
        let gives_way = match end.limit {
            RollingLimit::Friction(direction) => format!("slips {}", direction.arrow()),
            RollingLimit::NormalForce => "loses its normal force".to_owned(),
        };
        lines.push(format!(
            "{gives_way} after {}, at {}   {} = {}",
            scale.show(Dimension::Time, end.elapsed),
            scale.show_angle(end.theta),
            scale.sign(Quantity::ThetaRate),
            scale.show(Dimension::AngularRate, end.theta_rate),
        ));
    }
    if let Some(recurrence) = &found.recurrence {
        lines.push(format!("for ever: {}", returns(recurrence, scale)));
    }
    if let Some(rolling_type) = found.rolling_type {
        let what = match rolling_type {
            RollingType::I => "the normal force vanishes before static friction gives way",
            RollingType::II => "the normal force vanishes and static friction gives way together",
            RollingType::III => "static friction gives way while N > 0",
        };
        lines.push(format!("Type {} (3a): {what}", rolling_type.name()));
    }
    lines
}

/// Width of the terminal, within reason; 100 where there is none.
fn width() -> u16 {
    terminal_size::terminal_size().map_or(100, |(width, _)| width.0.clamp(60, 100))
}

/// The named cases.
pub(crate) fn cases(writer: &mut dyn Write, colour: bool) -> io::Result<()> {
    let mut sheet = Sheet::new(writer, colour);
    let rows = CASES
        .iter()
        .map(|case| vec![case.name.to_owned(), case.title.to_owned(), case.source.to_owned()])
        .collect();
    sheet.table(&["name", "motion", "in the paper"], rows, &[], Some(width()))?;
    sheet.gap()?;
    sheet.note("littlewood simulate NAME follows one of them; --format json lists their numbers")
}
