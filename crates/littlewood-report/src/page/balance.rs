//! What a motion has come to: its jumps, its landings, and the energy that it has lost.

use littlewood::tables::{Dimension, Quantity};
use littlewood::{Phase, Trajectory};

use crate::scale::Scale;

/// Jumps told one by one.
const FIRST_JUMPS: usize = 4;

/// The highest point of every flight; of many, unless `all` are asked for, the first ones.
pub(super) fn jumps(trajectory: &Trajectory, scale: Scale<'_>, all: bool) -> Vec<String> {
    let apexes: Vec<(f64, f64)> = trajectory.phases().iter().filter_map(apex).collect();
    let shown = if all || apexes.len() <= FIRST_JUMPS + 1 {
        apexes.len()
    } else {
        FIRST_JUMPS
    };
    let height = |height| scale.show_with_unit(Dimension::Length, height);
    let (first, more) = apexes.split_at(shown);
    let mut lines: Vec<String> = first
        .iter()
        .map(|(time, highest)| {
            let time = scale.show(Dimension::Time, *time);
            let highest = height(*highest);
            format!(
                "rim at most {highest} above the plane, at {} = {time}",
                scale.sign(Quantity::Time)
            )
        })
        .collect();
    if let Some(highest) = more.iter().map(|(_, highest)| *highest).reduce(f64::max) {
        lines.push(format!(
            "in {} more, at most {}",
            more.len(),
            height(highest)
        ));
    }
    lines
}

/// Time and height of the highest point of a flight, if it comes to it.
fn apex(phase: &Phase) -> Option<(f64, f64)> {
    let (elapsed, height) = phase.apex()?;
    // A time limit may come before the highest point.
    (elapsed <= phase.duration()).then_some((phase.start().time + elapsed, height))
}

/// How often a hoop with restitution has landed, and since when the rim stays at the plane.
pub(super) fn landings(trajectory: &Trajectory, scale: Scale<'_>) -> Option<String> {
    trajectory.hoop().restitution()?;
    let summary = trajectory.summary();
    let stays = || {
        let since = scale.show(Dimension::Time, summary.settle_time);
        format!(
            "; the rim stays at the plane from {} = {since} on",
            scale.sign(Quantity::Time)
        )
    };
    let stays = if summary.settle_time.is_nan() {
        String::new()
    } else {
        stays()
    };
    Some(format!("{}{stays}", summary.landings))
}

/// Rounding of what is lost in all: each phase and each impact adds a difference of two energies,
/// which have terms of this size.
fn rounding(trajectory: &Trajectory) -> f64 {
    let phases = trajectory.phases();
    let size = phases
        .iter()
        .map(|phase| phase.first().energy.abs() + 2.0 * trajectory.hoop().offset())
        .fold(0.0, f64::max);
    4.0 * f64::EPSILON * (2 * phases.len()) as f64 * size
}

/// The energy lost, and to what, by parts.
pub(super) fn energy(trajectory: &Trajectory, scale: Scale<'_>) -> Vec<String> {
    let hoop = trajectory.hoop();
    let lost = trajectory.energy_lost();
    let show = |energy| scale.show_with_unit(Dimension::Energy, energy);
    if hoop.restitution().is_none() && hoop.rolling_resistance() == 0.0 {
        let to_friction = (lost != 0.0).then(|| format!("{} lost to friction", show(lost)));
        return Vec::from_iter(to_friction);
    }
    let in_impacts = trajectory.impact_energy_lost();
    let to_resistance = trajectory.rolling_resistance_energy_lost();
    let in_sliding = lost - in_impacts - to_resistance;
    let part = |energy: f64, place: &str| {
        (energy.abs() > rounding(trajectory)).then(|| {
            let change = if energy > 0.0 { "lost" } else { "gained" };
            format!("{} {change} {place}", show(energy.abs()))
        })
    };
    let law = if in_impacts < 0.0 {
        "in impacts, as Newton's law allows"
    } else {
        "in impacts"
    };
    let mut parts: Vec<String> = [
        (to_resistance, "to rolling resistance"),
        (in_sliding, "in sliding"),
        (in_impacts, law),
    ]
    .into_iter()
    .filter_map(|(energy, place)| part(energy, place))
    .collect();
    let Some((_, all_but_last)) = parts.split_last_mut() else {
        return vec!["none lost".to_owned()];
    };
    for part in all_but_last {
        part.push(',');
    }
    parts
}
