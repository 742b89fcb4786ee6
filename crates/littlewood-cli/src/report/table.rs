//! The pages of a motion, of a start and of the named cases.

use littlewood::cases::CASES;
use littlewood::impact::Impact;
use littlewood::modes::{RollingLimit, SlideLimit};
use littlewood::tables::{Dimension, Quantity};
use littlewood::theory::{Classification, RollingType, StartRegion};
use littlewood::thresholds::{Searched, Threshold};
use littlewood::{Hoop, Outcome, Trajectory};
use littlewood_report::number::brief;
use littlewood_report::page::{self, Look};
use littlewood_report::scale::Scale;
use littlewood_report::sentence::{
    consistent, contact_margin, examined, no_threshold, returns, threshold as threshold_words,
    unresolved,
};
use littlewood_report::sheet::Sheet;
use littlewood_report::{Subject, jam_of};

use crate::problem::{Changes, Problem};

pub(crate) fn motion(
    problem: &Problem,
    subject: &Subject<'_>,
    trajectory: &Trajectory,
    look: Look<'_>,
) -> Sheet {
    let mut sheet = Sheet::default();
    title(&mut sheet, problem);
    page::motion(
        &mut sheet,
        subject,
        trajectory,
        Look {
            advice: advice(trajectory),
            ..look
        },
    );
    sheet
}

/// What allows a motion to be followed further that a limit has stopped.
fn advice(trajectory: &Trajectory) -> Option<&'static str> {
    match trajectory.outcome() {
        Outcome::TransitionLimit { .. } => Some("--max-transitions allows more"),
        Outcome::StepLimit {
            limit: SlideLimit::All { .. },
            ..
        } => Some("--max-slides allows more"),
        _ => None,
    }
}

/// The case, and what has been changed.
fn title(sheet: &mut Sheet, problem: &Problem) {
    let Some(case) = problem.case else { return };
    let Changes { replaced, added } = &problem.changes;
    let another = (!replaced.is_empty()).then(|| format!("with another {}", replaced.join(", ")));
    let new = (!added.is_empty()).then(|| format!("with {}", added.join(", ")));
    let changes: Vec<String> = another.into_iter().chain(new).collect();
    if changes.is_empty() {
        sheet.title(format!("{}: {}", case.name, case.title));
        sheet.fact("Paper", vec![case.source.to_owned()]);
    } else {
        sheet.title(format!("{} {}", case.name, changes.join(" and ")));
    }
}

/// What is known of a start.
pub(crate) fn classification(problem: &Problem, found: &Classification) -> Sheet {
    let mut sheet = Sheet::default();
    let scale = Scale::new(problem.units.as_ref());
    title(&mut sheet, problem);
    page::setup(&mut sheet, &problem.hoop, &problem.subject());
    sheet.gap();
    let region = match scale.show_with_unit(Dimension::Velocity, problem.start.gap_rate) {
        rate if problem.start.gap_rate > 0.0 => {
            format!("thrown: the rim leaves the plane at {rate}")
        }
        _ => region(&problem.hoop, found.region),
    };
    sheet.fact("Region", vec![region]);
    let begins = match (found.mode, &found.candidates, &found.undecided) {
        (Some(mode), _, _) => vec![mode.with_arrow(found.direction)],
        (None, Some(candidates), _) => {
            let first = if candidates.count() == 0 {
                "nothing that is consistent".to_owned()
            } else {
                consistent(candidates, ", or ")
            };
            let mut lines = vec![first];
            lines.extend(examined(&problem.hoop, candidates));
            lines.extend(
                jam_of(&problem.hoop, problem.start, found).map(|impact| jam(&impact, scale)),
            );
            lines
        }
        (None, None, Some(undecided)) => vec![unresolved(undecided, scale)],
        (None, None, None) => vec!["nothing that is known".to_owned()],
    };
    sheet.fact("Begins", begins);
    // At rest these are the forces that hold the hoop.
    let label = if found.region == StartRegion::BandOfRest {
        "Rest"
    } else {
        "Rolling"
    };
    sheet.fact(label, rolling(&problem.hoop, found, scale));
    let margin = contact_margin(&problem.hoop);
    sheet.fact(
        "Contact",
        vec![format!("{margin} = {}", brief(found.contact))],
    );
    sheet.fact(
        "Energy",
        vec![scale.show_with_unit(Dimension::Energy, found.energy)],
    );
    sheet.gap();
    sheet.note("N > 0 upwards, F > 0 along E1; equations of Bronars and O'Reilly, 2019");
    sheet
}

/// Where the outcome of a motion changes, or that it does not.
pub(crate) fn threshold(
    problem: &Problem,
    quantity: Quantity,
    found: Result<Threshold, Searched>,
) -> Sheet {
    let mut sheet = Sheet::default();
    title(&mut sheet, problem);
    page::setup(&mut sheet, &problem.hoop, &problem.subject());
    sheet.gap();
    let lines = match found {
        Ok(threshold) => threshold_words(quantity, &threshold),
        Err(searched) => vec![no_threshold(quantity, &searched)],
    };
    sheet.fact("Outcome", lines);
    sheet
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

fn region(hoop: &Hoop, region: StartRegion) -> String {
    let words = match region {
        StartRegion::Rolling => "inside the rolling region R (2.14): static friction suffices",
        StartRegion::BeyondFriction => {
            "inside N but outside R (2.14): static friction does not suffice"
        }
        StartRegion::SlidingBand => {
            "rolling would need N <= 0, yet the hoop stays in contact and slides"
        }
        StartRegion::LossOfContact => {
            let margin = contact_margin(hoop);
            return format!("{margin} < 0, or about to be: the hoop leaves the plane");
        }
        StartRegion::Slipping => "in contact with slip, η′ ≠ 0",
        StartRegion::Gliding => {
            "massless, outside R (3.10) or with slip: in contact without a force"
        }
        StartRegion::Inconsistent => "no motion is consistent (Painlevé)",
        StartRegion::Ambiguous => "several motions are consistent (Painlevé)",
        StartRegion::BandOfRest => {
            "in the band of rest: rolling resistance holds the angle, and static friction the rim"
        }
        StartRegion::Unresolved => "on a border: rounding decides which motion begins",
    };
    words.to_owned()
}

/// The friction that rolling needs, and whether static friction supplies it.
fn rolling(hoop: &Hoop, found: &Classification, scale: Scale<'_>) -> Vec<String> {
    let forces = found.rolling_forces;
    let force = |value| scale.show_with_unit(Dimension::Force, value);
    let mut needs = format!(
        "needs N = {}, F = {}",
        force(forces.normal),
        force(forces.friction)
    );
    if forces.normal > 0.0 {
        let limit = Quantity::MuS.sign();
        needs.push_str(&format!(
            ": |F|/N = {}, {limit} = {}",
            brief(forces.demand()),
            brief(hoop.mu_s())
        ));
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
    if let Some(ratio) = found.reverse_chatter {
        lines.push(format!(
            "is not the only motion: bounces can grow out of it, each {} times as fast as the one before (reverse chatter)",
            brief(ratio)
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

pub(crate) fn cases() -> Sheet {
    let mut sheet = Sheet::default();
    let rows = CASES
        .iter()
        .map(|case| {
            vec![
                case.name.to_owned(),
                case.title.to_owned(),
                case.source.to_owned(),
            ]
        })
        .collect();
    sheet.table(
        ["name", "motion", "in the paper"]
            .map(str::to_owned)
            .to_vec(),
        rows,
        &[],
    );
    sheet.gap();
    sheet.note("littlewood simulate NAME follows one of them; --format json lists their numbers");
    sheet
}
