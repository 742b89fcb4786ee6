//! Random motions, followed in this process and written down in every format.

use littlewood::si::SiParameters;
use littlewood::{Engine, Hoop, Limits, Outcome, OutcomeKind, ParameterError, Trajectory};
use littlewood_report::scale::Scale;
use littlewood_report::{Sampling, Subject, csv, json, sentence};
use serde_json::Value;

use crate::fuzz::{Case, Verdict};
use littlewood_random::command;

/// Offset of a massless hoop below which rates leave the range of doubles.
const LEVER: f64 = 1e-100;

/// Most samples that are asked for.
const SAMPLES: usize = 40;

pub(crate) fn run(case: &mut Case) -> Verdict {
    let setup = case.draw.setup();
    let limits = case.draw.limits(setup.start);
    case.told.tell(command(&setup, limits));
    let hoop = match Hoop::new(setup.hoop) {
        Ok(hoop) => hoop,
        Err(error) => return refused(&error),
    };
    let motion = match hoop.simulate(setup.start, limits) {
        Ok(motion) => motion,
        Err(error) => return refused(&error),
    };
    in_order(&motion, limits)?;
    let subject = Subject {
        case: None,
        start: setup.start,
        units: None,
        digits: None,
        derivatives: None,
        uncertainty: None,
    };
    let sampling = case
        .draw
        .comes(0.3)
        .then(|| Sampling::of(&motion, 2 + case.draw.below(SAMPLES)));
    readable(&motion, &subject, sampling)?;
    spoken(&motion)?;
    let kind = motion.outcome().kind();
    let engine = if case.draw.comes(0.02) {
        Engine::new(&hoop)
    } else {
        Engine::builder(&hoop).expected_starts(1).build()
    };
    let summary = engine
        .summary(setup.start, limits)
        .map_err(|error| format!("the engine refuses: {error}"))?;
    if matches!(
        summary.outcome,
        OutcomeKind::NotComputed | OutcomeKind::Invalid
    ) {
        return Err(format!("the engine says {}", summary.outcome));
    }
    Ok(kind.name())
}

fn refused(error: &ParameterError) -> Verdict {
    if error.to_string().is_empty() || error.hint().is_empty() {
        return Err(format!("a refusal that says nothing: {error:?}"));
    }
    Ok("refused")
}

/// Transitions one after the other, numbers that are numbers, and no state after the limit.
fn in_order(motion: &Trajectory, limits: Limits) -> Result<(), String> {
    let mut time = motion.start().time;
    let outcome = motion.outcome();
    let is_at_particle = matches!(
        outcome.kind(),
        OutcomeKind::ParticleAtPlane | OutcomeKind::ParticleAtBottom | OutcomeKind::ParticleAtTop
    );
    for (number, transition) in motion.transitions().iter().enumerate() {
        for state in [transition.before, transition.after] {
            let numbers = [state.time, state.theta, state.x];
            let rates = [state.theta_rate, state.slip];
            // The particle of a massless hoop comes to the plane, the bottom or the top with an
            // infinite rate. So does any that has next to no lever: its rate is beyond the largest
            // double.
            let may_be_infinite = is_at_particle
                && (number + 1 == motion.transitions().len() || motion.hoop().offset() < LEVER);
            if !numbers.iter().all(|number| number.is_finite())
                || !rates
                    .iter()
                    .all(|rate| rate.is_finite() || may_be_infinite && !rate.is_nan())
            {
                return Err(format!("transition {number} has {state:?}"));
            }
            if state.time < time {
                return Err(format!(
                    "transition {number} comes at {} after {time}",
                    state.time
                ));
            }
            time = state.time;
        }
    }
    // A motion that slides or repeats itself for ever is followed for a period to prove it; its
    // state is that before.
    let end = outcome.state().time;
    let is_before = matches!(
        outcome.kind(),
        OutcomeKind::SlidesForever | OutcomeKind::RepeatsForever
    );
    if end.is_nan() || end < time && !is_before {
        return Err(format!("the end is at {end} after {time}"));
    }
    if let Some(until) = limits.until
        && time > until
    {
        return Err(format!("a transition at {time}, after the limit {until}"));
    }
    if motion.transitions().len() > limits.transitions {
        return Err(format!(
            "{} transitions, {} allowed",
            motion.transitions().len(),
            limits.transitions
        ));
    }
    if matches!(outcome, Outcome::TimeLimit { .. }) && limits.until.is_none() {
        return Err("a time limit that was not given".to_owned());
    }
    Ok(())
}

/// JSON that parses and has the outcome; CSV whose rows have the same length, and no text for a
/// number.
fn readable(
    motion: &Trajectory,
    subject: &Subject<'_>,
    sampling: Option<Sampling>,
) -> Result<(), String> {
    let mut text = Vec::new();
    json::motion(&mut text, subject, motion, sampling).map_err(|error| format!("JSON: {error}"))?;
    let document: Value =
        serde_json::from_slice(&text).map_err(|error| format!("JSON: {error}"))?;
    let kind = document
        .pointer("/outcome/kind")
        .or_else(|| document.pointer("/outcome"))
        .cloned();
    if kind.is_none() {
        return Err("JSON without an outcome".to_owned());
    }
    let mut text = Vec::new();
    csv::motion(&mut text, subject, motion, sampling).map_err(|error| format!("CSV: {error}"))?;
    let mut rows = ::csv::Reader::from_reader(&text[..]);
    let header = rows
        .headers()
        .map_err(|error| format!("CSV: {error}"))?
        .clone();
    let place = |name: &str| {
        header
            .iter()
            .position(|column| column == name)
            .ok_or(format!("CSV without {name}"))
    };
    let always = [place("time")?, place("theta")?, place("x")?];
    let mode = header.iter().position(|column| column == "mode");
    for row in rows.records() {
        let row = row.map_err(|error| format!("CSV: {error}"))?;
        let number = |i: usize| row[i].parse::<f64>().unwrap_or(f64::NAN);
        let has = |word: &str| {
            row.iter()
                .any(|field| field.trim_start_matches('-') == word)
        };
        // Nothing is known before a jam, and of energies at an infinite rate.
        let may_lack = has("inf") || mode.is_some_and(|mode| row[mode].is_empty());
        if always.iter().any(|&i| !number(i).is_finite()) || has("NaN") && !may_lack {
            return Err(format!("CSV: {row:?}"));
        }
    }
    Ok(())
}

/// Sentences that end, without dimension and in SI units.
fn spoken(motion: &Trajectory) -> Result<(), String> {
    let units = SiParameters {
        particle_mass_kg: 0.14,
        radius_m: 0.45,
        ..SiParameters::default()
    }
    .units()
    .map_err(|error| error.to_string())?;
    for scale in [Scale::new(None), Scale::new(Some(&units))] {
        let first = (0..motion.transitions().len().min(5))
            .filter_map(|i| sentence::transition(motion, i, scale));
        for text in first.chain([
            sentence::start(motion, scale),
            sentence::outcome(motion, scale),
        ]) {
            if !text.ends_with('.') || text.contains("NaN") {
                return Err(format!("a sentence: {text}"));
            }
        }
    }
    Ok(())
}
