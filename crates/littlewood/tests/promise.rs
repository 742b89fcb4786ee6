//! What the engine promises of a summary against the simulation (docs/engine.md), and the comparison
//! of two summaries by it.

use std::f64::consts::TAU;

use crate::common::engines;
use littlewood::tables::{ColumnType, SummaryColumn, SummaryValue};
use littlewood::{Hoop, Limits, OutcomeKind, Phase, Sample, Start, Summary, Trajectory};
use proptest::prelude::*;

/// What the engine promises of a column against the simulation: the table of docs/engine.md.
#[derive(Clone, Copy, PartialEq)]
enum Promise {
    /// The same.
    Same,
    /// The same to rounding.
    Rounding,
    /// And the time in which θ changes by its last digit.
    RoundingOfTime,
    /// That of a time, times the largest |θ″|.
    RoundingOfThetaRate,
    /// That of a time, times the largest |η″|.
    RoundingOfSlip,
}

const fn promise(column: SummaryColumn) -> Promise {
    use SummaryColumn as C;
    match column {
        C::Outcome | C::Sequence | C::Transitions | C::Painleve | C::Landings | C::HalfSwings => {
            Promise::Same
        }
        C::EndTheta | C::EndX | C::Energy | C::JumpLength | C::JumpHeight | C::ImpactEnergyLost => {
            Promise::Rounding
        }
        C::EndTime | C::FirstSlipTime | C::LiftOffTime | C::SettleTime => Promise::RoundingOfTime,
        C::EndThetaRate => Promise::RoundingOfThetaRate,
        C::EndSlip => Promise::RoundingOfSlip,
    }
}

#[test]
fn the_documents_promise_what_is_tested() {
    let rows = [
        (Promise::Same, "the same"),
        (Promise::Rounding, "to rounding"),
        (
            Promise::RoundingOfTime,
            "to rounding, and the longest time in which θ changes by its last digit at the end of a phase",
        ),
        (
            Promise::RoundingOfThetaRate,
            r"to rounding, times the largest \|θ″\| where that is above one",
        ),
        (
            Promise::RoundingOfSlip,
            r"to rounding, times the largest \|η″\| where that is above one",
        ),
    ];
    for (promised, words) in rows {
        let columns: Vec<String> = SummaryColumn::ALL
            .into_iter()
            .filter(|column| promise(*column) == promised)
            .map(|column| format!("`{column}`"))
            .collect();
        let row = format!("\n| {} | {words} |\n", columns.join(", "));
        assert!(
            include_str!("../../../docs/engine.md").contains(&row),
            "docs/engine.md lacks{row}"
        );
    }
    // Codes and counts are the same, and no real number is promised to be.
    for column in SummaryColumn::ALL {
        let is_real = column.column_type() == ColumnType::Real;
        assert_eq!(promise(column) != Promise::Same, is_real, "{column}");
    }
}

/// The real numbers of a summary.
fn numbers(summary: &Summary) -> Vec<(SummaryColumn, f64)> {
    let number = |column: SummaryColumn| match column.of(summary) {
        SummaryValue::F64(value) => Some((column, value)),
        SummaryValue::U8(_) | SummaryValue::U32(_) | SummaryValue::U64(_) => None,
    };
    SummaryColumn::ALL.into_iter().filter_map(number).collect()
}

/// The codes and counts of a summary.
pub(crate) fn codes(summary: &Summary) -> Vec<SummaryValue> {
    SummaryColumn::ALL
        .into_iter()
        .filter(|column| promise(*column) == Promise::Same)
        .map(|column| column.of(summary))
        .collect()
}

/// Two numbers that are both missing, or not further apart than this.
fn is_close(a: f64, b: f64, most: f64) -> bool {
    (a.is_nan() && b.is_nan()) || a == b || (a - b).abs() <= most
}

/// Checks that codes and counts are equal, and that every real number differs by at most `tolerance`,
/// absolutely or relatively, plus what `more` allows for that number.
fn check_with(
    ours: &Summary,
    theirs: &Summary,
    tolerance: f64,
    more: &[f64],
) -> Result<(), String> {
    if codes(ours) != codes(theirs) {
        return Err(format!("{ours:?}\n{theirs:?}"));
    }
    for (((column, a), (_, b)), more) in numbers(ours).into_iter().zip(numbers(theirs)).zip(more) {
        if !is_close(a, b, tolerance * (1.0 + b.abs()) + more) {
            return Err(format!(
                "{column}: {a} {b}, {more:e} more\n{ours:?}\n{theirs:?}"
            ));
        }
    }
    Ok(())
}

pub(crate) fn check(ours: &Summary, theirs: &Summary, tolerance: f64) -> Result<(), String> {
    check_with(
        ours,
        theirs,
        tolerance,
        &vec![0.0; SummaryColumn::reals().count()],
    )
}

/// What a motion determines in double precision: how its summary changes where one of its phases
/// begins a few units in the last place elsewhere. No method can be asked to do better.
struct Sway {
    /// The changes of the numbers in motions with the same codes and counts, for all phases: four
    /// times the root of the sum of their squares, since the phases round independently.
    same: Vec<f64>,
    /// The same in all motions; infinite where a number is there in one and missing in another.
    all: Vec<f64>,
    /// Whether a code or count is the same in all.
    steady: Vec<bool>,
}

impl Sway {
    fn of(motion: &Trajectory, limits: Limits) -> Self {
        // A phase may begin where no start is accepted, or next to it.
        let summary = |start| Some(motion.hoop().simulate(start, limits).ok()?.summary());
        let nothing = vec![0.0_f64; SummaryColumn::reals().count()];
        let mut sway = Self {
            same: nothing.clone(),
            all: nothing,
            steady: vec![true; codes(&motion.summary()).len()],
        };
        for ((start, moved), phase) in moved_phases(motion).zip(motion.phases()) {
            // A phase of many turns rounds in each of them, in the same way where they pass the
            // same series.
            let turned = phase
                .end()
                .map_or(0.0, |end| (end.theta - start.theta).abs() / TAU);
            let Some(here) = summary(start) else { continue };
            let mut of_phase = [
                vec![0.0_f64; sway.same.len()],
                vec![0.0_f64; sway.all.len()],
            ];
            for there in moved.into_iter().filter_map(summary) {
                let pairs = || {
                    codes(&here)
                        .into_iter()
                        .zip(codes(&there))
                        .map(|(here, there)| here == there)
                };
                let is_same = pairs().all(|same| same);
                sway.steady
                    .iter_mut()
                    .zip(pairs())
                    .for_each(|(steady, same)| *steady &= same);
                let changes = numbers(&here).into_iter().zip(numbers(&there));
                for (place, ((_, a), (_, b))) in changes.enumerate() {
                    let change = if is_close(a, b, 0.0) {
                        0.0
                    } else {
                        4.0 * (a - b).abs()
                    };
                    // A number that is not there in one of the two makes this infinite.
                    let change = if change.is_nan() {
                        f64::INFINITY
                    } else {
                        change
                    };
                    for (largest, counts) in of_phase.iter_mut().zip([is_same, true]) {
                        largest[place] = if counts {
                            largest[place].max(change)
                        } else {
                            largest[place]
                        };
                    }
                }
            }
            for (sums, of_phase) in [&mut sway.same, &mut sway.all].into_iter().zip(of_phase) {
                let times = 1.0 + turned;
                sums.iter_mut()
                    .zip(of_phase)
                    .for_each(|(sum, change)| *sum = libm::hypot(*sum, times * change));
            }
        }
        sway
    }

    /// Whether rounding decides on codes or counts of the motion.
    fn is_tie(&self) -> bool {
        self.steady.contains(&false)
    }

    /// The codes, counts and numbers of a tie that the motion determines all the same.
    fn check_tie(&self, ours: &Summary, theirs: &Summary, tolerance: f64) -> Result<(), String> {
        let mut pairs = codes(ours).into_iter().zip(codes(theirs)).zip(&self.steady);
        if pairs.any(|((a, b), steady)| *steady && a != b) {
            return Err(format!("codes of a tie\n{ours:?}\n{theirs:?}"));
        }
        // Where a motion repeats itself the end is the first state that has been recognised, one of
        // several.
        let repeats = matches!(
            theirs.outcome,
            OutcomeKind::SlidesForever | OutcomeKind::RepeatsForever
        );
        for (((column, a), (_, b)), all) in numbers(ours)
            .into_iter()
            .zip(numbers(theirs))
            .zip(&self.all)
        {
            if repeats && ours.transitions != theirs.transitions && is_of_end(column) {
                continue;
            }
            if all.is_finite() && !is_close(a, b, tolerance * (1.0 + b.abs()) + all) {
                return Err(format!(
                    "{column} of a tie: {a} {b}, {all:e} more\n{ours:?}\n{theirs:?}"
                ));
            }
        }
        Ok(())
    }
}

/// Whether a number is one of the state at the end.
const fn is_of_end(column: SummaryColumn) -> bool {
    use SummaryColumn as C;
    matches!(
        column,
        C::EndTime | C::EndTheta | C::EndThetaRate | C::EndSlip | C::EndX
    )
}

/// The engine tells of the same motion as the simulation: codes and counts are the same, and every
/// number within the tolerance or what the motion determines. With `ties`, motions may have other
/// codes and counts where rounding decides on them.
pub(crate) fn compare(
    ours: &Summary,
    motion: &Trajectory,
    limits: Limits,
    tolerance: f64,
    ties: bool,
) -> Result<(), String> {
    let theirs = motion.summary();
    let plain = check(ours, &theirs, tolerance);
    // No change of a number makes up for another code, and of a long motion it takes minutes.
    if plain.is_ok() || (!ties && codes(ours) != codes(&theirs)) {
        return plain;
    }
    let sway = Sway::of(motion, limits);
    if ties && sway.is_tie() {
        return sway.check_tie(ours, &theirs, tolerance);
    }
    // What is known of a time is known of a rate times its acceleration, which is large in light
    // hoops and in fast flights.
    let [of_rate, of_slip] = accelerates(motion).map(|largest| tolerance * largest);
    let of_time = slowest(motion);
    let more = SummaryColumn::reals()
        .zip(&sway.same)
        .map(|(column, same)| {
            same + match promise(column) {
                Promise::RoundingOfThetaRate => of_rate,
                Promise::RoundingOfSlip => of_slip,
                Promise::RoundingOfTime => of_time,
                Promise::Same | Promise::Rounding => 0.0,
            }
        });
    check_with(ours, &theirs, tolerance, &more.collect::<Vec<_>>())
}

/// The longest time in which θ changes by its last digit at the end of a phase, by θ′ or by θ″ if
/// that is sooner.
fn slowest(motion: &Trajectory) -> f64 {
    let ends = motion
        .phases()
        .iter()
        .filter(|phase| motion.end_of(phase).is_some())
        .filter_map(Phase::last);
    let time = |sample: Sample| {
        let digit = f64::EPSILON * sample.state.theta.abs();
        let by_rate = digit / sample.state.theta_rate.abs();
        by_rate.min((2.0 * digit / sample.theta_acceleration.abs()).sqrt())
    };
    ends.map(time)
        .filter(|time| time.is_finite())
        .fold(0.0, f64::max)
}

/// The largest |θ″| and |η″| at the ends of phases.
fn accelerates(motion: &Trajectory) -> [f64; 2] {
    let ends = motion
        .phases()
        .iter()
        .flat_map(|phase| [Some(phase.first()), phase.last()])
        .flatten();
    ends.fold([0.0, 0.0], |[theta, slip], sample| {
        [
            theta.max(sample.theta_acceleration.abs()),
            slip.max(sample.slip_acceleration.abs()),
        ]
    })
}

/// Whether the start is further from the top than an angle whose energy is no number.
pub(crate) fn is_resolved(start: &Start) -> bool {
    start.theta == 0.0 || start.theta * start.theta > 0.0
}

/// Whether the numbers of a hoop are compared, and not its codes and counts alone. With huge
/// kinetic friction the engine knows η′ to ε μk θ′, the size of the terms of the first integral
/// that it takes it from.
fn compares_numbers(hoop: &Hoop) -> bool {
    hoop.mu_k() <= 1e3
}

/// Errors of a long chain of phases grow with every one of them.
pub(crate) fn tolerance(summary: &Summary) -> f64 {
    1e-12 * f64::from(1 + summary.transitions)
}

/// The starts of all phases of a motion, each moved by a few units in the last place: rounding
/// errors arise at each of them.
fn moved_phases(motion: &Trajectory) -> impl Iterator<Item = (Start, [Start; 6])> + '_ {
    motion.phases().iter().enumerate().map(|(index, phase)| {
        let state = phase.start();
        let before = index
            .checked_sub(1)
            .and_then(|last| motion.end_of(&motion.phases()[last]));
        let gap_rate = before
            .and_then(|event| event.impact)
            .map_or(0.0, |impact| impact.after.gap_rate);
        let start = Start::from(state).with_gap_rate(gap_rate);
        let moved = |steps: f64| {
            let by = |value: f64| value + steps * f64::EPSILON * (1.0 + value.abs());
            let slip = if start.slip == 0.0 {
                0.0
            } else {
                by(start.slip)
            };
            let turned = Start::at(by(start.theta), start.theta_rate).with_slip(start.slip);
            let faster = Start::at(start.theta, by(start.theta_rate)).with_slip(start.slip);
            [turned, faster, start.with_slip(slip)]
                .map(|it| it.with_time(start.time).with_gap_rate(gap_rate))
        };
        let ([a, b, c], [d, e, f]) = (moved(4.0), moved(-4.0));
        (start, [a, b, c, d, e, f])
    })
}

/// Engines for many starts and for few have the motions of the simulation.
pub(crate) fn agree(hoop: &Hoop, starts: &[Start]) -> Result<(), TestCaseError> {
    agree_within(20.0, hoop, starts)
}

/// The same for so long.
pub(crate) fn agree_within(time: f64, hoop: &Hoop, starts: &[Start]) -> Result<(), TestCaseError> {
    agree_to(
        |start| Limits::until(start.time + time).with_transitions(300),
        hoop,
        starts,
    )
}

/// The same to limits of each start.
pub(crate) fn agree_to(
    limits: impl Fn(&Start) -> Limits,
    hoop: &Hoop,
    starts: &[Start],
) -> Result<(), TestCaseError> {
    for engine in engines(hoop) {
        for start in starts {
            let limits = limits(start);
            let ours = engine.summary(*start, limits).expect("a valid start");
            let motion = hoop.simulate(*start, limits).expect("a valid start");
            let checked = if engine.is_exact() {
                check(&ours, &motion.summary(), 0.0)
            } else if compares_numbers(hoop) {
                // Where friction is less than the rounding of N, η′ may touch zero at each passage
                // of the bottom, and rounding decides on two reversals.
                compare(
                    &ours,
                    &motion,
                    limits,
                    tolerance(&ours),
                    hoop.mu_k() < f64::EPSILON,
                )
            } else {
                check(&ours, &motion.summary(), f64::INFINITY)
            };
            if let Err(difference) = checked {
                return Err(TestCaseError::fail(format!(
                    "{hoop:?}\n{start:?}\n{difference}"
                )));
            }
        }
    }
    Ok(())
}
