//! A simulated motion.

use core::fmt;

use littlewood::{Direction, Mode, NamedCase, Sample, Trajectory, find_case};
use littlewood_report::scale::Scale;
use littlewood_report::{Sampling, Subject, csv, json, sentence};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::Problem;
use crate::refusal::Refusal;

/// Names of the columns of a sample, in order.
const COLUMNS: [&str; 19] = [
    "time",
    "mode",
    "direction",
    "theta",
    "theta_rate",
    "slip",
    "x",
    "theta_acceleration",
    "slip_acceleration",
    "normal",
    "friction",
    "gap",
    "gap_rate",
    "energy",
    "centre_y",
    "mass_centre_x",
    "mass_centre_y",
    "particle_x",
    "particle_y",
];

/// Names of the columns of a sample, in order. The mode is a number: rolling 0, sliding 1, gliding 2, flight 3.
#[wasm_bindgen(js_name = sampleColumns)]
#[must_use]
pub fn sample_columns() -> Vec<String> {
    COLUMNS.map(str::to_owned).to_vec()
}

/// A motion from its start to its end, or to a limit.
#[wasm_bindgen]
pub struct Motion {
    problem: Problem,
    case: Option<&'static NamedCase>,
    trajectory: Trajectory,
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion").field("problem", &self.problem).finish_non_exhaustive()
    }
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
        Ok(Self { problem: problem.clone(), case, trajectory })
    }

    /// Time at which the motion ends, or until which it is worth showing if it never does.
    #[must_use]
    pub fn horizon(&self) -> f64 {
        Sampling::of(&self.trajectory, 2).until
    }

    /// `count` instants evenly spaced in time up to `until`, and every transition twice, column after column.
    #[must_use]
    pub fn samples(&self, count: usize, until: f64) -> Vec<f64> {
        let rows: Vec<[f64; COLUMNS.len()]> =
            self.trajectory.sample_evenly(count, until).map(|sample| self.row(&sample)).collect();
        (0..COLUMNS.len()).flat_map(|column| rows.iter().map(move |row| row[column])).collect()
    }

    /// One instant; empty outside the motion.
    #[must_use]
    pub fn at(&self, time: f64) -> Vec<f64> {
        self.trajectory.at(time).map_or_else(Vec::new, |sample| self.row(&sample).to_vec())
    }

    /// What happens at the start.
    #[wasm_bindgen(js_name = startSentence)]
    #[must_use]
    pub fn start_sentence(&self) -> String {
        sentence::start(&self.trajectory, self.scale())
    }

    /// What happens at each transition.
    #[wasm_bindgen(js_name = transitionSentences)]
    #[must_use]
    pub fn transition_sentences(&self) -> Vec<String> {
        (0..self.trajectory.transitions().len())
            .filter_map(|index| sentence::transition(&self.trajectory, index, self.scale()))
            .collect()
    }

    /// How the motion ends, or does not.
    #[wasm_bindgen(js_name = outcomeSentence)]
    #[must_use]
    pub fn outcome_sentence(&self) -> String {
        sentence::outcome(&self.trajectory, self.scale())
    }

    /// The motion as `littlewood simulate --format json` prints it, with `--samples` if a number is given.
    #[must_use]
    pub fn json(&self, samples: Option<usize>) -> String {
        self.text(|text| json::motion(text, &self.subject(), &self.trajectory, self.sampling(samples)))
    }

    /// The motion as `littlewood simulate --format csv` prints it, with `--samples` if a number is given.
    #[must_use]
    pub fn csv(&self, samples: Option<usize>) -> String {
        self.text(|text| csv::motion(text, &self.subject(), &self.trajectory, self.sampling(samples)))
    }
}

impl Motion {
    fn row(&self, sample: &Sample) -> [f64; COLUMNS.len()] {
        let hoop = self.trajectory.hoop();
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        let mode = match sample.mode {
            Mode::Rolling => 0.0,
            Mode::Sliding => 1.0,
            Mode::Gliding => 2.0,
            Mode::Flight => 3.0,
        };
        [
            sample.state.time,
            mode,
            sample.direction.map_or(0.0, Direction::sign),
            sample.state.theta,
            sample.state.theta_rate,
            sample.state.slip,
            sample.state.x,
            sample.theta_acceleration,
            sample.slip_acceleration,
            sample.normal,
            sample.friction,
            sample.gap,
            sample.gap_rate,
            sample.energy,
            sample.centre().y,
            mass_centre.x,
            mass_centre.y,
            particle.x,
            particle.y,
        ]
    }

    const fn scale(&self) -> Scale<'_> {
        Scale::new(self.problem.units.as_ref())
    }

    const fn subject(&self) -> Subject<'_> {
        Subject { case: self.case, start: self.problem.start, units: self.problem.units.as_ref() }
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
