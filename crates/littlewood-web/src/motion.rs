//! A simulated motion.

use littlewood::cases::{NamedCase, find_case};
use littlewood::energy::EnergyLedger;
use littlewood::impact::{ContactVelocities, Impulse};
use littlewood::tables::SampleColumn;
use littlewood::{Mode, OutcomeKind, Sample, Trajectory, Transition};
use littlewood_report::scale::Scale;
use littlewood_report::sheet::Table;
use littlewood_report::{Sampling, ShownImpact, Subject, csv, json as documents, page, sentence};
use littlewood_style::EnergyPart;
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::Problem;
use crate::refusal::Refusal;
use crate::routh::Routh;

/// Instants at which the energies of a motion are examined.
const EXAMINED: usize = 1000;

/// Transitions that are shown of bounces without end.
const SHOWN: usize = 20;

/// A motion from its start to its end, or to a limit.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Motion {
    problem: Problem,
    case: Option<&'static NamedCase>,
    trajectory: Trajectory,
}

#[wasm_bindgen]
impl Motion {
    /// Simulates a problem. `case` names the case that it is, if it is one.
    ///
    /// # Errors
    /// A time limit before the start.
    #[wasm_bindgen(constructor)]
    pub fn new(problem: &Problem, case: Option<String>) -> Result<Self, Refusal> {
        let trajectory = problem.hoop.simulate(problem.start, problem.limits)?;
        let case = case.as_deref().and_then(find_case);
        Ok(Self {
            problem: problem.clone(),
            case,
            trajectory,
        })
    }

    /// Time at which the motion ends, or up to which it is shown if it has no end. Of bounces that
    /// only a limit has stopped the first are shown.
    pub fn horizon(&self) -> f64 {
        let until = Sampling::of(&self.trajectory, 2).until;
        let bounces = self.trajectory.hoop().restitution().is_some();
        let is_stopped = self.trajectory.outcome().kind() == OutcomeKind::TransitionLimit;
        let shown = self
            .trajectory
            .transitions()
            .get(SHOWN)
            .filter(|_| bounces && is_stopped);
        shown.map_or(until, Transition::time)
    }

    /// `count` instants evenly spaced in time up to `until`, and every transition twice: the
    /// columns of
    /// [`SampleColumn::ALL`] one after the other.
    pub fn samples(&self, count: usize, until: f64) -> Vec<f64> {
        let samples: Vec<Sample> = self.trajectory.sample_evenly(count, until).collect();
        SampleColumn::ALL
            .into_iter()
            .flat_map(|column| samples.iter().map(move |sample| column.of(sample).number()))
            .collect()
    }

    /// One instant, in the columns of [`SampleColumn::ALL`]; empty outside the motion.
    pub fn at(&self, time: f64) -> Vec<f64> {
        self.trajectory.at(time).map_or_else(Vec::new, |sample| {
            SampleColumn::ALL
                .into_iter()
                .map(|column| column.of(&sample).number())
                .collect()
        })
    }

    /// What happens at the start.
    #[wasm_bindgen(js_name = startSentence)]
    pub fn start_sentence(&self) -> String {
        sentence::start(&self.trajectory, self.scale())
    }

    /// What happens at each transition.
    #[wasm_bindgen(js_name = transitionSentences)]
    pub fn transition_sentences(&self) -> Vec<String> {
        (0..self.trajectory.transitions().len())
            .map(|index| {
                sentence::transition(&self.trajectory, index, self.scale()).unwrap_or_default()
            })
            .collect()
    }

    /// The friction that rolling needs at a time, in words; none in another mode.
    pub fn friction(&self, time: f64) -> Option<String> {
        sentence::friction(self.trajectory.hoop(), &self.trajectory.at(time)?)
    }

    /// The impact of a transition as it is shown: θ′, η′ and the rate of the gap before and after,
    /// P, J, and the energy lost; none without an impact.
    pub fn impact(&self, transition: usize) -> Option<Vec<f64>> {
        let event = self.trajectory.transitions().get(transition)?;
        let shown = ShownImpact::of(self.trajectory.hoop(), transition, event)?;
        let velocities = |it: ContactVelocities| [it.theta_rate, it.slip, it.gap_rate];
        let Impulse { normal, friction } = shown.impulse;
        let numbers = [velocities(shown.before), velocities(shown.after)].concat();
        Some([&numbers[..], &[normal, friction, shown.energy_lost]].concat())
    }

    /// The scale on which the parts of the energy have room, as far as the motion is shown: its
    /// lower and its upper end, over m2 g R; empty where nothing moves.
    #[wasm_bindgen(js_name = energyScale)]
    pub fn energy_scale(&self) -> Vec<f64> {
        let samples: Vec<Sample> = self
            .trajectory
            .sample_evenly(EXAMINED, self.horizon())
            .collect();
        let scale = |ledger: EnergyLedger<'_>| ledger.scale(&samples).to_vec();
        EnergyLedger::new(&self.trajectory).map_or_else(Vec::new, scale)
    }

    /// The parts of the energy at a time, over m2 g R, in the order of `EnergyPart` of the style
    /// crate. They add up to the energy of the start; empty outside the motion.
    pub fn energies(&self, time: f64) -> Vec<f64> {
        let parts = || EnergyLedger::new(&self.trajectory)?.parts(&self.trajectory.at(time)?);
        parts().map_or_else(Vec::new, |it| {
            EnergyPart::ALL.map(|part| part.of(&it)).to_vec()
        })
    }

    /// Routh's diagram of the impact at a transition, if there is one.
    pub fn routh(&self, transition: usize) -> Option<Routh> {
        Routh::of(
            self.trajectory.hoop(),
            self.trajectory.transitions().get(transition)?,
        )
    }

    /// The table of the phases as the command line prints it, as JSON; with `all` nothing is folded
    /// or left out.
    pub fn table(&self, all: bool) -> String {
        let Table {
            head,
            rows,
            numbers,
        } = page::phases(&self.trajectory, self.scale(), all);
        let rows: Vec<Value> = rows
            .iter()
            .map(|it| json!({ "mode": it.mode.map(Mode::name), "time": it.time, "folds": it.folds, "cells": it.cells }))
            .collect();
        json!({ "head": head, "rows": rows, "numbers": numbers }).to_string()
    }

    /// How the motion ends, or does not.
    #[wasm_bindgen(js_name = outcomeSentence)]
    pub fn outcome_sentence(&self) -> String {
        sentence::outcome(&self.trajectory, self.scale())
    }

    /// The motion as `littlewood simulate --format json` prints it, with `--samples` if a number is
    /// given.
    pub fn json(&self, samples: Option<usize>) -> String {
        self.text(|text| {
            documents::motion(
                text,
                &self.subject(),
                &self.trajectory,
                self.sampling(samples),
            )
        })
    }

    /// The motion as `littlewood simulate --format csv` prints it, with `--samples` if a number is
    /// given.
    pub fn csv(&self, samples: Option<usize>) -> String {
        self.text(|text| {
            csv::motion(
                text,
                &self.subject(),
                &self.trajectory,
                self.sampling(samples),
            )
        })
    }
}

impl Motion {
    const fn scale(&self) -> Scale<'_> {
        Scale::new(self.problem.units.as_ref())
    }

    const fn subject(&self) -> Subject<'_> {
        let Problem { start, units, .. } = &self.problem;
        Subject {
            case: self.case,
            units: units.as_ref(),
            ..Subject::of_start(*start)
        }
    }

    fn sampling(&self, samples: Option<usize>) -> Option<Sampling> {
        samples.map(|count| Sampling::of(&self.trajectory, count))
    }

    fn text(&self, write: impl Fn(&mut Vec<u8>) -> std::io::Result<()>) -> String {
        let mut text = Vec::new();
        // Writing to memory does not fail.
        let _ = write(&mut text);
        String::from_utf8(text).unwrap_or_default()
    }
}
