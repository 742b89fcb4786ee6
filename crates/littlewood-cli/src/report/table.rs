//! Tables and sentences for a person.

use std::io::{self, Write};

use littlewood::{
    CASES, Cause, Classification, Direction, Findings, Hoop, Limit, Mode, Motion, Outcome, Phase, Quantity,
    Recurrence, RollingType, SiParameters, StartRegion, State, Trajectory,
};
use littlewood_report::number::{brief, column};
use littlewood_report::scale::{Scale, Symbols};

use super::Sampling;
use super::sheet::Sheet;
use crate::problem::Problem;

/// Phases shown at most; of longer motions the first and the last ones.
const FIRST_PHASES: usize = 30;
const LAST_PHASES: usize = 10;

/// A motion.
pub(crate) fn motion(
    writer: &mut dyn Write,
    problem: &Problem,
    trajectory: &Trajectory,
    sampling: Option<Sampling>,
    colour: bool,
) -> io::Result<()> {
    let mut sheet = Sheet::new(writer, colour);
    let scale = Scale::new(problem.units.as_ref());
    heading(&mut sheet, problem, scale)?;
    if !trajectory.phases().is_empty() {
        sheet.gap()?;
        phases(&mut sheet, trajectory, scale)?;
    }
    sheet.gap()?;
    sheet.fact("Outcome", &outcome(trajectory, scale))?;
    let jump = jumps(trajectory, scale);
    sheet.fact("Jump", &jump)?;
    let lost = trajectory.energy_lost();
    if lost != 0.0 {
        sheet.fact("Energy", &[format!("{} lost to friction", scale.show_energy(lost))])?;
    }
    if let Some(sampling) = sampling {
        sheet.gap()?;
        samples(&mut sheet, trajectory, sampling, scale)?;
    }
    notes(&mut sheet, problem, trajectory)
}

fn heading(sheet: &mut Sheet<'_>, problem: &Problem, scale: Scale<'_>) -> io::Result<()> {
    if let Some(case) = problem.case {
        let changed: Vec<&str> = problem.changed.iter().map(|quantity| Quantity::name(*quantity)).collect();
        if changed.is_empty() {
            sheet.title(&format!("{}: {}", case.name, case.title))?;
            sheet.fact("Paper", &[case.source.to_owned()])?;
        } else {
            sheet.title(&format!("{} with another {}", case.name, changed.join(", ")))?;
        }
    }
    let hoop = &problem.hoop;
    let numbers = format!(
        "m1/m2 = {}   ℓ/R = {}   Izz/(m2 R²) = {}   μs = {}   μk = {}",
        brief(hoop.mass_ratio()),
        brief(hoop.offset()),
        brief(hoop.inertia()),
        brief(hoop.mu_s()),
        brief(hoop.mu_k()),
    );
    let mut lines = vec![numbers];
    if let Some(units) = &problem.units {
        let si = SiParameters::from_hoop(hoop, units);
        lines.push(format!(
            "m1 = {} kg   m2 = {} kg   R = {} m   ℓ = {} m",
            brief(si.disc_mass_kg),
            brief(si.particle_mass_kg),
            brief(si.radius_m),
            brief(si.offset_m),
        ));
        lines.push(format!(
            "Izz = {} kg m²   g = {} m/s²   √(R/g) = {} s",
            brief(si.inertia_kg_m2),
            brief(si.gravity_m_per_s2),
            brief(units.time_s),
        ));
    }
    sheet.fact("Hoop", &lines)?;
    let start = problem.start;
    let state = State {
        time: start.time,
        theta: start.theta,
        theta_rate: start.theta_rate,
        slip: start.slip,
        x: start.x,
    };
    let mut line = format!("{} = {}  ", scale.symbols().time, scale.show_time(state.time));
    line.push_str(&scale.show_motion(&state));
    if state.x != 0.0 {
        line.push_str(&format!("  x = {}", scale.show_length(state.x)));
    }
    sheet.fact("Start", &[line])
}

fn phases(sheet: &mut Sheet<'_>, trajectory: &Trajectory, scale: Scale<'_>) -> io::Result<()> {
    let [from, duration, theta, rate, slip, lost] = scale.columns();
    let header = ["#", "motion", from, duration, theta, rate, slip, lost, "ends by"];
    let all = trajectory.phases();
    let hidden = FIRST_PHASES..all.len().saturating_sub(LAST_PHASES);
    let mut rows = Vec::new();
    for (index, phase) in all.iter().enumerate() {
        if hidden.contains(&index) {
            if index == hidden.start {
                let cell = format!("… {} more", hidden.len());
                rows.push(vec!["…".to_owned(), cell]);
            }
            continue;
        }
        let start = phase.start();
        let ends_by = match trajectory.transitions().get(index) {
            Some(transition) => event(transition.cause),
            None if phase.end().is_some() => "time limit",
            None => "never",
        };
        rows.push(vec![
            (index + 1).to_string(),
            motion_of(phase),
            column(scale.time(start.time)),
            column(scale.time(phase.duration())),
            column(start.theta),
            column(scale.rate(start.theta_rate)),
            column(scale.velocity(start.slip)),
            column(scale.energy(phase.energy_lost())),
            ends_by.to_owned(),
        ]);
    }
    sheet.table(&header, rows, &[0, 2, 3, 4, 5, 6, 7], None)
}

/// The mode of a phase, the direction of slip, and the mark of the footnote.
fn motion_of(phase: &Phase) -> String {
    let mark = if phase.is_outside_small_inertia_limit() { "*" } else { "" };
    format!("{}{mark}", mode(phase.mode(), phase.direction()))
}

fn mode(mode: Mode, direction: Option<Direction>) -> String {
    match direction {
        Some(Direction::Negative) => format!("{mode} ←"),
        Some(Direction::Positive) => format!("{mode} →"),
        None => mode.to_string(),
    }
}

const fn event(cause: Cause) -> &'static str {
    match cause {
        Cause::LiftOff => "lift-off",
        Cause::NormalForceZero => "N = 0",
        Cause::ParticleAtPlane => "θ = ±π",
        Cause::ParticleAtBottom => "lowest θ",
        Cause::ParticleAtTop => "θ = 0",
        other => other.name(),
    }
}

/// How the motion ended, in a few lines.
fn outcome(trajectory: &Trajectory, scale: Scale<'_>) -> Vec<String> {
    let outcome = trajectory.outcome();
    let state = outcome.state();
    let Symbols { time, .. } = scale.symbols();
    let at = format!("{time} = {}", scale.show_time(state.time));
    let there = scale.show_motion(&state);
    let place = format!("x = {}", scale.show_length(state.x));
    match outcome {
        Outcome::Landing { gap_rate, .. } => vec![
            format!("lands at {at}; the instant before the impact:"),
            there,
            format!("{place}  velocity of the gap {}", scale.show_velocity(gap_rate)),
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
        Outcome::ParticleAtPlane { .. } => {
            vec![format!("the particle reaches the plane at {at} (3.20)"), there, place]
        }
        Outcome::ParticleAtBottom { .. } => {
            vec![format!("the particle reaches its lowest place at {at} (3.20)"), there, place]
        }
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
        Outcome::Inconsistent { findings, .. } => {
            let mut lines = vec![format!("no motion is consistent at {at} (Painlevé)"), there, place];
            lines.extend(examined(&findings));
            lines
        }
        Outcome::Ambiguous { findings, .. } => {
            let several: Vec<String> = findings.consistent().map(|(it, slip)| mode(it, slip)).collect();
            let mut lines =
                vec![format!("several motions are consistent at {at}: {}", several.join(", ")), there, place];
            lines.extend(examined(&findings));
            lines
        }
        Outcome::Singular { solvability, .. } => vec![
            format!(
                "the slide has no solution with N > 0 beyond {at} (Painlevé): P = {}",
                brief(solvability)
            ),
            there,
            place,
        ],
        other => vec![format!("{} at {at}", other.kind()), there, place],
    }
}

fn forever(trajectory: &Trajectory, scale: Scale<'_>, first: String, recurrence: &Recurrence) -> Vec<String> {
    let mut lines = vec![first, returns(recurrence, scale)];
    let end = trajectory.end_time();
    if end.is_finite() {
        lines.push(format!("followed until {} = {}", scale.symbols().time, scale.show_time(end)));
    }
    lines
}

/// How a motion without an end comes back.
fn returns(recurrence: &Recurrence, scale: Scale<'_>) -> String {
    match *recurrence {
        Recurrence::Rest => "at rest, in equilibrium".to_owned(),
        Recurrence::Libration { period, theta_min, theta_max } => format!(
            "back and forth between θ = {} and {} with the period {}",
            brief(theta_min),
            brief(theta_max),
            scale.show_time(period),
        ),
        Recurrence::Rotation { period } => {
            format!("over the top, always the same way, one turn in {}", scale.show_time(period))
        }
        Recurrence::Asymptotic { theta } => {
            format!("towards the unstable equilibrium θ = {}, never reached", brief(theta))
        }
    }
}

/// What was examined where the motion that follows is not unique.
fn examined(findings: &Findings) -> Vec<String> {
    let [negative, positive] = findings.solvability.map(brief);
    vec![
        format!(
            "rolling would need N = {}, F = {}   1 − h cos θ θ′² = {}",
            brief(findings.rolling_forces.normal),
            brief(findings.rolling_forces.friction),
            brief(findings.contact),
        ),
        format!("sliding has P = {negative} for σ = −1 and {positive} for σ = +1, and needs P > 0"),
    ]
}

/// The highest point of every flight.
fn jumps(trajectory: &Trajectory, scale: Scale<'_>) -> Vec<String> {
    let line = |phase: &Phase| {
        let Motion::Flight(flight) = phase.motion() else {
            return None;
        };
        let (elapsed, height) = flight.apex();
        // A time limit may come before the highest point.
        (elapsed <= phase.duration()).then(|| {
            format!(
                "rim at most {} above the plane, at {} = {}",
                scale.show_length(height),
                scale.symbols().time,
                scale.show_time(phase.start().time + elapsed),
            )
        })
    };
    trajectory.phases().iter().filter_map(line).collect()
}

fn samples(
    sheet: &mut Sheet<'_>,
    trajectory: &Trajectory,
    sampling: Sampling,
    scale: Scale<'_>,
) -> io::Result<()> {
    let [_, _, theta, rate, slip, _] = scale.columns();
    let time = scale.symbols().time;
    let header = [time, "motion", theta, rate, slip, "x/R", "N/(m2 g)", "F/(m2 g)", "gap/R"];
    let rows = trajectory
        .sample_evenly(sampling.count, sampling.until)
        .map(|sample| {
            vec![
                column(scale.time(sample.state.time)),
                mode(sample.mode, sample.direction),
                column(sample.state.theta),
                column(scale.rate(sample.state.theta_rate)),
                column(scale.velocity(sample.state.slip)),
                column(sample.state.x),
                column(sample.normal),
                column(sample.friction),
                column(sample.gap),
            ]
        })
        .collect();
    sheet.table(&header, rows, &[0, 2, 3, 4, 5, 6, 7, 8], None)
}

fn notes(sheet: &mut Sheet<'_>, problem: &Problem, trajectory: &Trajectory) -> io::Result<()> {
    let mut notes = Vec::new();
    if trajectory.phases().iter().any(|phase| phase.direction().is_some()) {
        notes.push("← → direction of slip, the sign of η′");
    }
    if trajectory.phases().iter().any(Phase::is_outside_small_inertia_limit) {
        notes.push(
            "* gliding as the paper has it (3.17), but not the limit of any slide as the inertia vanishes:",
        );
        notes.push("  there P = I + m h sin θ q would not be positive (Painlevé)");
    }
    if problem.units.is_none() {
        notes.push("units (2.9): time √(R/g), length R, velocity √(g R), energy m2 g R");
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
    sheet.fact("Region", &[region(found.region).to_owned()])?;
    let begins = match (found.mode, &found.findings) {
        (Some(it), _) => vec![mode(it, found.direction)],
        (None, Some(findings)) => {
            let several: Vec<String> = findings.consistent().map(|(it, slip)| mode(it, slip)).collect();
            let first = if several.is_empty() {
                "nothing that is consistent".to_owned()
            } else {
                several.join(", or ")
            };
            let mut lines = vec![first];
            lines.extend(examined(findings));
            lines
        }
        (None, None) => vec!["nothing that is known".to_owned()],
    };
    sheet.fact("Begins", &begins)?;
    sheet.fact("Rolling", &rolling(&problem.hoop, found, scale))?;
    sheet.fact("Contact", &[format!("1 − h cos θ θ′² = {}", brief(found.contact))])?;
    sheet.fact("Energy", &[scale.show_energy(found.energy)])?;
    sheet.gap()?;
    sheet.note("N > 0 upwards, F > 0 along E1; equations of Bronars and O'Reilly, 2019")
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
        other => other.name(),
    }
}

/// The friction that rolling needs, and what becomes of it.
fn rolling(hoop: &Hoop, found: &Classification, scale: Scale<'_>) -> Vec<String> {
    let forces = found.rolling_forces;
    let mut needs =
        format!("needs N = {}, F = {}", scale.show_force(forces.normal), scale.show_force(forces.friction));
    if forces.normal > 0.0 {
        needs.push_str(&format!(": |F|/N = {}, μs = {}", brief(forces.demand()), brief(hoop.mu_s())));
    }
    let mut lines = vec![needs];
    if let Some(end) = &found.rolling_end {
        let gives_way = match end.limit {
            Limit::Friction(Direction::Negative) => "slips ←",
            Limit::Friction(Direction::Positive) => "slips →",
            Limit::NormalForce => "loses its normal force",
        };
        lines.push(format!(
            "{gives_way} after {}, at {}   {} = {}",
            scale.show_time(end.elapsed),
            scale.show_angle(end.theta),
            scale.symbols().theta_rate,
            scale.show_rate(end.theta_rate),
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
