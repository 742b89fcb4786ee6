//! Results do not depend on the τ, the x and the whole turns of the start, over the whole range
//! that is accepted.

#![allow(clippy::panic)] // a failed expectation

use std::f64::consts::TAU;

use littlewood::tables::Quantity;
use littlewood::{
    Engine, Hoop, Limits, OutcomeKind, Phase, Sample, Start, State, Summary, Trajectory,
};
use littlewood_random::Draw;

const SEED: u64 = 5;

/// Motions with a τ and an x; each comes in two.
const MOVED: u64 = 600;

const TURNED: u64 = 600;

/// The motion of a case from τ = 0 and x = 0.
fn motion(draw: &mut Draw) -> (Hoop, Start) {
    let (hoop, start) = draw.motion();
    (hoop, start.with_time(0.0).with_x(0.0))
}

/// Where a motion is seen from: its τ and x are those of the start, here the rounded sums of these
/// and what the motion has from there.
#[derive(Clone, Copy)]
struct Shift {
    time: f64,
    x: f64,
    /// The limit of time without the shift, and with it.
    until: Option<[f64; 2]>,
}

impl Shift {
    fn time(&self, time: f64) -> f64 {
        self.until
            .filter(|[plain, _]| *plain == time)
            .map_or(self.time + time, |[_, shifted]| shifted)
    }

    fn state(&self, state: State) -> State {
        State {
            time: self.time(state.time),
            x: self.x + state.x,
            ..state
        }
    }

    fn sample(&self, mut sample: Sample) -> Sample {
        sample.state = self.state(sample.state);
        for place in [
            &mut sample.centre,
            &mut sample.mass_centre,
            &mut sample.particle,
        ] {
            place.x += self.x;
        }
        sample
    }

    fn summary(&self, mut summary: Summary) -> Summary {
        summary.end = self.state(summary.end);
        for time in [
            &mut summary.first_slip_time,
            &mut summary.lift_off_time,
            &mut summary.settle_time,
        ] {
            *time = self.time(*time);
        }
        summary
    }
}

/// All numbers, bit for bit but for the sign of zero; what is no number is as good as another that
/// is none.
fn shown(value: &impl std::fmt::Debug) -> String {
    format!("{value:?}")
        .replace("-0.0,", "0.0,")
        .replace("-0.0 ", "0.0 ")
        .replace("-0.0)", "0.0)")
}

fn outcome(motion: &Trajectory, state: impl Fn(State) -> State) -> (OutcomeKind, String, String) {
    let outcome = motion.outcome();
    (
        outcome.kind(),
        shown(&state(outcome.state())),
        shown(&outcome.details()),
    )
}

fn modes(motion: &Trajectory) -> Vec<String> {
    motion
        .transitions()
        .iter()
        .map(|it| format!("{:?}", (it.cause, it.from, it.to, it.direction)))
        .collect()
}

#[test]
fn time_and_place_of_the_start_are_added_to_the_motion() {
    for case in 0..MOVED {
        let mut draw = Draw::of_case(SEED, 0, case);
        let (hoop, start) = motion(&mut draw);
        let (time, x) = (draw.allowed(Quantity::Time), draw.allowed(Quantity::X));
        let limit = draw
            .comes(0.5)
            .then(|| draw.of_any_size([-3.0, 3.0]))
            .filter(|limit| time + limit <= 1e9);
        // A limit that is as far from both starts to the last bit.
        let until = limit.map(|until| [(time + until) - time, time + until]);
        let shift = Shift { time, x, until };
        let limits = |which: usize| {
            Limits::default()
                .with_transitions(60)
                .with_until(until.map(|until| until[which]))
        };
        let moved_start = start.with_time(time).with_x(x);
        let plain = hoop.simulate(start, limits(0)).expect("a valid start");
        let moved = hoop
            .simulate(moved_start, limits(1))
            .expect("a valid start");
        assert_eq!(modes(&plain), modes(&moved), "{case}");
        for (plain, moved) in plain.transitions().iter().zip(moved.transitions()) {
            let mut there = *plain;
            (there.before, there.after) = (shift.state(plain.before), shift.state(plain.after));
            assert_eq!(shown(&there), shown(moved), "{case}");
        }
        assert_eq!(plain.phases().len(), moved.phases().len(), "{case}");
        for (plain, moved) in plain.phases().iter().zip(moved.phases()) {
            assert_eq!(shown(&plain.duration()), shown(&moved.duration()), "{case}");
            assert_eq!(
                shown(&plain.energy_lost()),
                shown(&moved.energy_lost()),
                "{case}"
            );
            let duration = if plain.duration().is_finite() {
                plain.duration()
            } else {
                3.0
            };
            for part in [0.0, 0.3, 1.0] {
                let [plain, moved] = [plain, moved].map(|phase| phase.sample(part * duration));
                assert_eq!(shown(&shift.sample(plain)), shown(&moved), "{case}");
            }
            assert_eq!(
                shown(&plain.end().map(|end| shift.state(end))),
                shown(&moved.end()),
                "{case}"
            );
        }
        assert_eq!(
            outcome(&plain, |state| shift.state(state)),
            outcome(&moved, |state| state),
            "{case}"
        );
        assert_eq!(
            shown(&shift.summary(plain.summary())),
            shown(&moved.summary()),
            "{case}"
        );
        let engines = [
            Some(Engine::builder(&hoop).expected_starts(1).build()),
            (case % 8 == 0).then(|| Engine::new(&hoop)),
        ];
        for engine in engines.into_iter().flatten() {
            let [plain, moved] = [(start, 0), (moved_start, 1)]
                .map(|(start, which)| engine.summary(start, limits(which)).expect("a valid start"));
            assert_eq!(shown(&shift.summary(plain)), shown(&moved), "{case}");
        }
        if limit.is_none() {
            is_found_at_its_transitions(&moved);
        }
    }
}

fn is_found_at_its_transitions(motion: &Trajectory) {
    let phases = motion.phases();
    for phase in phases {
        // Far from τ = 0 more than one phase may begin at a time.
        let last = phases
            .iter()
            .rfind(|other| other.start().time == phase.start().time);
        let found = motion.at(phase.start().time);
        assert_eq!(shown(&found), shown(&last.map(Phase::first)));
    }
    if let Some((begin, end)) = phases
        .last()
        .and_then(|last| Some((last.first(), last.last()?)))
    {
        // Far from τ = 0 the last phase may end at the time at which it begins.
        let found = motion.at(motion.end_time());
        assert!(
            [begin, end]
                .iter()
                .any(|ends| shown(&Some(ends)) == shown(&found)),
            "{found:?}"
        );
        let samples: Vec<Sample> = motion.sample_evenly(5, f64::INFINITY).collect();
        assert!(samples.is_sorted_by(|a, b| a.state.time <= b.state.time));
        assert_eq!(
            samples.last().map(|sample| shown(&sample.state)),
            Some(shown(&end.state))
        );
    }
}

/// From a start that is k turns on the motion is that from the angle that remains, and θ the
/// rounded sum.
#[test]
fn whole_turns_of_the_start_are_added_to_the_motion() {
    for case in 0..TURNED {
        let mut draw = Draw::of_case(SEED, 1, case);
        let (hoop, start) = motion(&mut draw);
        let theta = draw.of_any_size([0.7, 9.0]) * if draw.comes(0.5) { 1.0 } else { -1.0 };
        let reduced = reduced(theta);
        let turns = theta - reduced;
        let limits = Limits::default().with_transitions(60);
        let [far, near] = [theta, reduced].map(|theta| {
            let mut start = start;
            start.theta = theta;
            let motion = hoop.simulate(start, limits).expect("a valid start");
            (
                motion,
                Engine::builder(&hoop)
                    .expected_starts(1)
                    .build()
                    .summary(start, limits)
                    .expect("a valid start"),
            )
        });
        let compare = |far: State, near: State| {
            // Of the angles both, and of the sum.
            let rounding = f64::EPSILON * (theta.abs() + far.theta.abs());
            let numbers = |state: State| {
                shown(&State {
                    theta: 0.0,
                    ..state
                })
            };
            let apart = (far.theta - (turns + near.theta)).abs();
            assert!(
                numbers(far) == numbers(near) && apart <= rounding,
                "{case}: {far:?} {near:?}"
            );
        };
        assert_eq!(modes(&far.0), modes(&near.0), "{case}");
        for (far, near) in far.0.transitions().iter().zip(near.0.transitions()) {
            compare(far.before, near.before);
            compare(far.after, near.after);
        }
        compare(far.0.outcome().state(), near.0.outcome().state());
        compare(far.1.end, near.1.end);
        let mut far = far.1;
        far.end = near.1.end;
        assert_eq!(shown(&far), shown(&near.1), "{case}");
    }
}

/// 2π in units of 2⁻⁹⁶, and what remains in units of 2⁻¹²⁴ (mpmath).
const TURN: [i128; 2] = [0x0006_487E_D511_0B46_11A6_2633_145C, 0x006E_0E68];

/// θ − 2πk in integers, rounded once.
fn reduced(theta: f64) -> f64 {
    let turns = (theta / TAU).round() as i128;
    // Four is the least angle, so that its last place is 2⁻⁵⁰.
    let rest = ((theta * libm::exp2(50.0)) as i128 * (1 << 46)) - turns * TURN[0];
    (rest * (1 << 28) - turns * TURN[1]) as f64 * libm::exp2(-124.0)
}
