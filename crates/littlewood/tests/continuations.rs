//! A simulation that starts from a state of a motion must give the rest of that motion.

use std::f64::consts::TAU;

use crate::common::newton::Sizes;
use crate::common::{instants, none_differ};
use littlewood::modes::PhaseSolution;
use littlewood::theory::{Body, ContactForces, RollingLaw, SlidingLaw};
use littlewood::{
    Cause, Hoop, Limits, Mode, OutcomeKind, Phase, Restitution, RestitutionLaw, RotationDirection,
    Sample, SlipDirection, Start, State, Trajectory,
};
use littlewood_random::Draw;

/// The time limit of the motions that are continued.
const UNTIL: f64 = 10.0;

/// The rounding of the numbers of a state in a phase, from the sizes of their terms.
///
/// A number is a value at the start of the phase and a change, which each step rounds once more; an
/// angle is whole turns and a rest. In a slide and a glide η′ and x are integrals to which θ′, what
/// friction does to it, and the impulse of friction add up. In rolling θ′² is a difference of
/// energies, and time that to an angle. A clock that reads τ resolves what changes with τ, and an
/// angle θ′ to the frequency at which a light hoop swings.
fn rounding(hoop: &Hoop, phase: &Phase, now: &Sample) -> State {
    let (slips, steps) = match phase.solution() {
        PhaseSolution::Sliding(slide) => (1.0, slide.steps() as f64),
        // The particle, and what follows from it for the hoop.
        PhaseSolution::Gliding(_) => (1.0, 2.0),
        PhaseSolution::ResistedRolling(rolling) => (0.0, rolling.steps() as f64),
        PhaseSolution::Skidding(_) => (1.0, 1.0),
        PhaseSolution::Rolling(_) | PhaseSolution::Flight(_) | PhaseSolution::Rest(_) => (0.0, 1.0),
    };
    let unit = steps * f64::EPSILON;
    let (h, mu) = (slips * hoop.h(), slips * hoop.mu_k());
    let from = phase.start();
    let time = now.state.time.abs();
    let duration = now.state.time - from.time;
    let way: Vec<_> = instants(duration, 8)
        .map(|elapsed| phase.sample(elapsed))
        .collect();
    // The particle reaches the plane with an infinite rate.
    let largest = |of: fn(&Sample) -> f64| {
        way.iter()
            .chain([now])
            .map(of)
            .filter(|it| it.is_finite())
            .fold(0.0, |most, it| it.abs().max(most))
    };
    let rate = largest(|it| it.state.theta_rate);
    let turned = TAU + from.theta.abs() + rate * duration;
    let pull = libm::sin(hoop.slope()).abs();
    let slip =
        largest(|it| it.state.slip) + rate * (1.0 + h + mu * h) + slips * (mu + pull) * duration;
    let mut by = State {
        time: unit * (from.time.abs() + duration),
        theta: unit * (turned + rate * time),
        theta_rate: unit * (rate + largest(|it| it.theta_acceleration) * time),
        slip: unit * slips * (slip + largest(|it| it.slip_acceleration) * time),
        x: unit * (from.x.abs() + h + mu * h + turned + slip * (duration + time)),
    };
    if let Body::Heavy(body) = hoop.body() {
        let swing = (body.mass * body.h * (1.0 + rate * rate) / body.inertia).sqrt();
        by.theta_rate += swing * by.theta;
        by.slip += slips * (1.0 + h + mu * h) * swing * by.theta;
    }
    if phase.mode() == Mode::Rolling {
        let d = Sizes::of(hoop, &Start::from(now.state)).effective_inertia;
        let energies = 2.0 * (hoop.offset() + hoop.mass() * pull * turned) / d;
        let last = now.state.theta_rate.abs();
        by.theta_rate += (last * last + f64::EPSILON * energies).sqrt() - last;
        by.time += (by.theta / last).min(duration);
    }
    by
}

fn sum(a: State, b: State) -> State {
    State {
        time: a.time + b.time,
        theta: a.theta + b.theta,
        theta_rate: a.theta_rate + b.theta_rate,
        slip: a.slip + b.slip,
        x: a.x + b.x,
    }
}

/// A motion from a state to its next event.
struct Leg {
    begins: Option<(Mode, Option<SlipDirection>)>,
    event: Option<(Cause, Option<Mode>)>,
    /// Whether there is no event until the time limit.
    lasts: bool,
    end: Option<State>,
}

impl Leg {
    fn of(motion: &Trajectory, index: usize) -> Self {
        let phase = motion.phases().get(index);
        let event = phase.and_then(|phase| motion.end_of(phase));
        Self {
            begins: phase.map(|phase| (phase.mode(), phase.direction())),
            event: event.map(|event| (event.cause, event.to)),
            lasts: phase.is_some_and(|phase| phase.end_time() >= UNTIL),
            end: event.map(|event| event.before),
        }
    }

    fn is_like(&self, other: &Self) -> bool {
        (self.begins, self.event, self.lasts) == (other.begins, other.event, other.lasts)
    }

    /// How far the ends are apart.
    fn apart(&self, other: &Self) -> [f64; 5] {
        match (self.end, other.end) {
            (Some(ours), Some(theirs)) => {
                let (ours, theirs) = (numbers(ours), numbers(theirs));
                // Rates may be infinite.
                std::array::from_fn(|k| {
                    if ours[k] == theirs[k] {
                        0.0
                    } else {
                        (ours[k] - theirs[k]).abs()
                    }
                })
            }
            _ => [0.0; 5],
        }
    }
}

const fn numbers(state: State) -> [f64; 5] {
    [
        state.time,
        state.theta,
        state.theta_rate,
        state.slip,
        state.x,
    ]
}

/// The motion from a state; none where the start is refused.
fn follow(hoop: &Hoop, state: State) -> Option<Trajectory> {
    let limits = Limits::until(UNTIL).with_transitions(1);
    hoop.simulate(Start::from(state), limits).ok()
}

/// What rounding does to the next event of a motion that starts again.
struct Effect {
    apart: [f64; 5],
    /// Whether another event may be the next one.
    decides: bool,
}

/// What rounding does at a state of a phase, and on the way from it, to the next event: each number
/// is moved by its rounding there and at three instants between. x and τ are added up.
fn effect(motion: &Trajectory, index: usize, stop: &Sample, again: &Trajectory) -> Effect {
    let (hoop, phase) = (motion.hoop(), &motion.phases()[index]);
    let expected = Leg::of(again, 0);
    let at_stop = numbers(rounding(hoop, phase, stop));
    let at_end = phase
        .last()
        .map_or([0.0; 5], |last| numbers(rounding(hoop, phase, &last)));
    let mut apart = [
        at_stop[0] + at_end[0],
        at_end[1],
        at_end[2],
        at_end[3],
        at_stop[4] + at_end[4],
    ];
    let mut decides = false;
    for part in [0.0, 0.25, 0.5, 0.75] {
        let there = match again.phases().first() {
            Some(phase) if part > 0.0 => phase.sample(part * phase.duration().min(UNTIL)),
            _ => *stop,
        };
        let mut by = rounding(hoop, phase, &there);
        let there = there.state;
        if there == phase.start() && index > 0 {
            let before = &motion.phases()[index - 1];
            if let Some(last) = before.last() {
                by = sum(by, rounding(hoop, before, &last));
            }
        }
        let at = |theta: f64, theta_rate: f64, slip: f64| {
            [1.0, -1.0].map(|sign| State {
                theta: there.theta + sign * theta,
                theta_rate: there.theta_rate + sign * theta_rate,
                slip: there.slip + sign * slip,
                ..there
            })
        };
        let slip = if there.slip == 0.0 { 0.0 } else { by.slip };
        for pair in [
            at(by.theta, 0.0, 0.0),
            at(0.0, by.theta_rate, 0.0),
            at(0.0, 0.0, slip),
        ] {
            let changes = pair.map(|near| {
                let near = Leg::of(&follow(hoop, near)?, 0);
                near.is_like(&expected).then(|| near.apart(&expected))
            });
            decides |= changes.contains(&None);
            let [up, down] = changes.map(|change| change.unwrap_or([0.0; 5]));
            apart = std::array::from_fn(|k| apart[k] + up[k].max(down[k]));
        }
    }
    // No digit of the end is left: of θ, or of θ′ where P vanishes.
    let end = expected.end.unwrap_or(stop.state);
    let rate = stop.state.theta_rate.abs().max(end.theta_rate.abs());
    decides |= apart[1] > TAU || apart[2] > rate;
    Effect { apart, decides }
}

/// Starts a motion again from a state of one of its phases in contact: it has the same mode there
/// and the same next event, as far apart as rounding on the way moves it. `None` where the start is
/// refused, its outcome says that rolling is not the only motion, or rounding decides what it does.
fn goes_on(motion: &Trajectory, index: usize, stop: &Sample) -> Option<bool> {
    let (hoop, phase) = (motion.hoop(), &motion.phases()[index]);
    let state = stop.state;
    let again = follow(hoop, state)?;
    let resists = hoop.rolling_resistance() > 0.0;
    if again.outcome().kind() == OutcomeKind::Ambiguous && again.phases().is_empty() {
        if resists {
            // A motion goes on holding what it held, where a start may also skid, or fly.
            return None;
        }
        let law = SlidingLaw::new(hoop, SlipDirection::Positive, RotationDirection::Positive)
            .expect("heavy");
        let w = law.contact(state.theta, state.theta_rate);
        let sizes = Sizes::of(hoop, &Start::from(state));
        assert!(
            phase.mode() == Mode::Rolling && hoop.slope() != 0.0 && w <= sizes.contact,
            "{w}: {hoop:?} {state:?}"
        );
        return None;
    }
    let [ours, theirs] = [Leg::of(motion, index), Leg::of(&again, 0)];
    let apart = ours.apart(&theirs);
    if ours.is_like(&theirs) && apart == [0.0; 5] {
        return Some(true);
    }
    let effect = effect(motion, index, stop, &again);
    let is_same = ours.is_like(&theirs) && (0..5).all(|k| apart[k] <= effect.apart[k]);
    // Without friction a motion remembers where it was at rest, and tells a slip that touches zero
    // from one that crosses it for an instant.
    let grazes = |leg: &Leg| matches!(leg.event, Some((Cause::Graze, _)));
    let is_unresolved = |it: &Trajectory, index: usize| {
        it.outcome().kind() == OutcomeKind::Unresolved && index + 1 == it.phases().len()
    };
    // On the limit of static friction, but for rounding, its change decides: whether the state is
    // there is what rounding tells.
    let forces = if resists {
        let (normal, friction) = (stop.normal, stop.friction);
        ContactForces { normal, friction }
    } else {
        RollingLaw::new(hoop).forces(state.theta, state.theta_rate)
    };
    let sizes = Sizes::of(hoop, &Start::from(state));
    let is_on_limit = phase.mode() == Mode::Rolling
        && (forces.normal <= sizes.normal
            || forces.friction.abs() - hoop.mu_s() * forces.normal >= -sizes.friction_excess());
    let is_open = effect.decides
        || is_on_limit
        || grazes(&ours) != grazes(&theirs)
        || is_unresolved(motion, index)
        || is_unresolved(&again, 0);
    (is_same || !is_open).then_some(is_same)
}

fn check_continuations(count: u64, draw_start: impl Fn(&mut Draw) -> (Hoop, Start)) {
    let (mut same, mut open, mut wrong) = (0, 0, Vec::new());
    for case in 0..count {
        let mut draw = Draw::of_case(42, 0, case);
        let (hoop, start) = draw_start(&mut draw);
        if start.theta != 0.0 && start.theta.abs() < f64::MIN_POSITIVE {
            continue;
        }
        let law = draw.one_of(RestitutionLaw::ALL.as_slice());
        let restitution = Restitution::new(draw.share() * draw.below(2) as f64, law);
        let hoop = match (hoop.body(), draw.comes(0.3), restitution) {
            (Body::Heavy(_), true, Ok(restitution)) => {
                hoop.with_restitution(restitution).expect("heavy")
            }
            _ => hoop,
        };
        let limits = Limits::until(UNTIL).with_transitions(12);
        let motion = hoop.simulate(start, limits).expect("a start");
        for (index, phase) in motion.phases().iter().enumerate() {
            let elapsed = draw.share() * phase.duration().min(UNTIL);
            // A flight is continued from its take-off.
            if phase.mode() == Mode::Flight {
                continue;
            }
            for stop in [phase.first(), phase.sample(elapsed)] {
                match goes_on(&motion, index, &stop) {
                    Some(true) => same += 1,
                    Some(false) => {
                        let (mode, state) = (phase.mode(), stop.state);
                        wrong.push(format!("{case}: {mode} at {state:?} of {hoop:?}"));
                    }
                    None => open += 1,
                }
            }
        }
    }
    none_differ(
        &wrong,
        &format!("{same} go on, {open} say why not or are not determined"),
    );
    assert!(open < same / 50, "{open} of {same}");
}

#[test]
fn a_motion_goes_on_from_its_own_states() {
    check_continuations(2_000, Draw::in_contact);
}

#[test]
fn a_motion_with_rolling_resistance_goes_on_from_its_own_states() {
    check_continuations(2_000, resisted_in_contact);
}

/// A hoop with rolling resistance, and a start.
fn resisted_in_contact(draw: &mut Draw) -> (Hoop, Start) {
    loop {
        let (hoop, start) = draw.resisted_in_contact();
        if hoop.rolling_resistance() > 0.0 {
            return (hoop, start);
        }
    }
}

#[test]
#[ignore = "thorough"]
fn many_motions_go_on_from_their_own_states() {
    check_continuations(40_000, Draw::in_contact);
    check_continuations(20_000, resisted_in_contact);
}
