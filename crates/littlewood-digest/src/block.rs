//! A block of motions, and its digests.

use littlewood::impact::Impact;
use littlewood::tables::{SampleColumn, Setup, SummaryColumn, SummaryValue};
use littlewood::{
    Engine, Hoop, Limits, Mode, OutcomeKind, ParameterError, Phase, Sample, SlipDirection, Start,
    State, Summary, Trajectory,
};

use crate::hash::Hash;
use crate::starts::setups;

/// Instants at which a phase is looked at, in parts of its duration.
const INSTANTS: [f64; 4] = [0.0, 0.3125, 0.75, 1.0];

/// Duration of the part that is looked at of a phase that lasts for ever.
const WINDOW: f64 = 8.0;

/// Starts of the hoop of a block that the engine prepares.
const STARTS: usize = 256;

/// The digests of a block of motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// Which block.
    pub index: u32,
    /// Of the simulated motions: phases, transitions, impacts, outcomes, and samples of all phases.
    pub trajectories: u64,
    /// Of the summaries of engines for few starts, and of one for many starts of one of the hoops.
    pub summaries: u64,
}

impl Block {
    /// Follows the motions.
    #[must_use]
    pub fn compute(index: u32) -> Self {
        let (mut trajectories, mut summaries) = (Hash::new(), Hash::new());
        for (setup, limits) in setups(index) {
            if motion(&mut trajectories, &setup, limits).is_err() {
                trajectories.word(u64::MAX);
            }
            if summary(&mut summaries, &setup, limits).is_err() {
                summaries.word(u64::MAX);
            }
        }
        tabulated(&mut summaries, index);
        Self {
            index,
            trajectories: trajectories.finish(),
            summaries: summaries.finish(),
        }
    }

    /// The block as a line of `crates/littlewood-digest/digest.txt`.
    pub fn line(&self) -> String {
        format!(
            "{:2} {:016x} {:016x}",
            self.index, self.trajectories, self.summaries
        )
    }
}

fn motion(hash: &mut Hash, setup: &Setup, limits: Limits) -> Result<(), ParameterError> {
    let motion = Hoop::new(setup.hoop)?.simulate(setup.start, limits)?;
    trajectory(hash, &motion);
    Ok(())
}

fn trajectory(hash: &mut Hash, motion: &Trajectory) {
    for phase in motion.phases() {
        samples(hash, phase);
    }
    for transition in motion.transitions() {
        hash.word(u64::from(transition.cause.code()));
        hash.word(
            transition
                .to
                .map_or(u64::MAX, |mode| u64::from(Mode::code(mode))),
        );
        hash.word(u64::from(
            SlipDirection::code(transition.direction).cast_unsigned(),
        ));
        state(hash, &transition.before);
        state(hash, &transition.after);
        if let Some(it) = &transition.impact {
            impact(hash, it);
        }
    }
    let outcome = motion.outcome();
    hash.word(u64::from(OutcomeKind::code(outcome.kind())));
    state(hash, &outcome.state());
}

fn samples(hash: &mut Hash, phase: &Phase) {
    let duration = phase.duration();
    let duration = if duration.is_finite() {
        duration
    } else {
        WINDOW
    };
    for part in INSTANTS {
        sample(hash, &phase.sample(part * duration));
    }
}

fn sample(hash: &mut Hash, sample: &Sample) {
    // No motion of a block has rolling resistance.
    let columns = SampleColumn::ALL.into_iter();
    for column in columns.filter(|column| *column != SampleColumn::Couple) {
        hash.number(column.of(sample).number());
    }
}

fn state(hash: &mut Hash, state: &State) {
    for number in state.numbers() {
        hash.number(number);
    }
}

fn impact(hash: &mut Hash, impact: &Impact) {
    hash.word(u64::from(impact.case.code()));
    let Impact { before, after, .. } = impact;
    for number in [
        before.gap_rate,
        after.theta_rate,
        after.slip,
        after.gap_rate,
    ] {
        hash.number(number);
    }
    for number in [impact.normal_work, impact.friction_work] {
        hash.number(number);
    }
}

fn summary(hash: &mut Hash, setup: &Setup, limits: Limits) -> Result<(), ParameterError> {
    let engine = Engine::builder(&Hoop::new(setup.hoop)?)
        .expected_starts(1)
        .build();
    add(hash, &engine.summary(setup.start, limits)?);
    Ok(())
}

/// Summaries of one hoop with its tables, a usual one in even blocks and one of the whole range in
/// odd ones, with the starts of other setups.
fn tabulated(hash: &mut Hash, index: u32) {
    let place = if index.is_multiple_of(2) { 1 } else { 7 };
    let Some((setup, limits)) = setups(index).nth(place) else {
        return;
    };
    let Ok(hoop) = Hoop::new(setup.hoop) else {
        return;
    };
    let engine = Engine::builder(&hoop).interpolate_slips().build();
    for (other, _) in setups(index).take(STARTS) {
        let start = Start::at(other.start.theta, other.start.theta_rate);
        if let Ok(it) = engine.summary(start.with_slip(other.start.slip), limits) {
            add(hash, &it);
        }
    }
}

fn add(hash: &mut Hash, summary: &Summary) {
    for column in SummaryColumn::ALL {
        // Only rolling resistance makes any: without it the digests are those of before.
        if column == SummaryColumn::HalfSwings && summary.half_swings == 0 {
            continue;
        }
        match column.of(summary) {
            SummaryValue::U8(value) => hash.word(u64::from(value)),
            SummaryValue::U32(value) => hash.word(u64::from(value)),
            SummaryValue::U64(value) => hash.word(value),
            SummaryValue::F64(value) => hash.number(value),
        }
    }
}
