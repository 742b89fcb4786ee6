//! An event of a motion in one sentence.

mod impact;
mod threshold;

use core::f64::consts::TAU;

use littlewood::modes::{PhaseSolution, Recurrence, SlideLimit, Undecided};
use littlewood::tables::Dimension;
use littlewood::theory::{Candidates, ContactForces, PhasePlane};
use littlewood::{Cause, Hoop, Mode, Outcome, Phase, Sample, Trajectory, Transition};

use crate::number::{brief, three};
use crate::scale::Scale;
use impact::Struck;

pub use threshold::{no_threshold, threshold};

/// Why the motion of a massless hoop ends at the plane.
const NO_IMPACT: &str = "the model ends here. A rim without mass cannot be struck";

/// A demand for friction that is rounding: an angle up to 2π is rounded by two units of ε, and F,
/// which is of the size of its sine beside the weight, by two more.
const FRICTIONLESS: f64 = 4.0 * f64::EPSILON;

/// Where the laws have no motion, or several.
const NO_ANSWER: &str = "Rigid bodies have no answer here (Painlevé's paradox)";

/// The first phase, and why it begins.
pub fn start(trajectory: &Trajectory, scale: Scale<'_>) -> String {
    let state = trajectory.start();
    let hoop = trajectory.hoop();
    let forces = PhasePlane::new(hoop).forces(state.theta, state.theta_rate);
    if trajectory
        .transitions()
        .first()
        .is_some_and(|first| first.from.is_none())
    {
        return "Jams at once: no motion is consistent with the start (Painlevé).".to_owned();
    }
    let Some(phase) = trajectory.phases().first() else {
        return outcome(trajectory, scale);
    };
    if let PhaseSolution::Flight(flight) = phase.solution() {
        if flight.settles() {
            return "Is thrown so gently that its bounces are summed as one.".to_owned();
        }
        if phase.take_off_rate() > 0.0 {
            let rate = scale.show_with_unit(Dimension::Velocity, three(phase.take_off_rate()));
            return format!("Is thrown: the rim leaves the plane at {rate}.");
        }
    }
    match phase.mode() {
        Mode::Rolling => format!("Rolls: {HOLDS}."),
        Mode::Sliding if state.slip != 0.0 => {
            format!("Slides: the contact point moves {}.", to_the(state.slip))
        }
        Mode::Sliding => format!("Slips: {}.", gives_way(hoop, &forces)),
        Mode::Gliding if state.slip != 0.0 => {
            "Glides: a hoop without inertia feels no force from the plane while it slips."
                .to_owned()
        }
        Mode::Gliding => {
            format!(
                "Slips, and glides without any force from the plane: {}.",
                gives_way(hoop, &forces)
            )
        }
        Mode::Rest => format!("Rests: {RESISTANCE_HOLDS}."),
        Mode::Skidding => format!(
            "Skids {}: it slips, and {RESISTANCE_HOLDS}.",
            to_the(state.slip)
        ),
        Mode::Flight => {
            let weight = if hoop.slope() == 0.0 { "1" } else { "cos α" };
            format!(
                "Leaves at once: only a pull from the ground could hold it down, h cos θ θ′² > {weight}."
            )
        }
    }
}

/// Transition `index` and its reason; none if there is no such transition.
pub fn transition(trajectory: &Trajectory, index: usize, scale: Scale<'_>) -> Option<String> {
    let event = trajectory.transitions().get(index)?;
    let hoop = trajectory.hoop();
    let forces = PhasePlane::new(hoop).forces(event.before.theta, event.before.theta_rate);
    let mu_s = hoop.mu_s();
    let struck = |impact| Struck {
        hoop,
        index,
        event,
        impact,
        scale,
    };
    Some(match event.cause {
        Cause::Slip => slip(event, mu_s),
        Cause::Stick if event.to == Some(Mode::Rest) => {
            format!("Comes to rest: the slip has died away, and {RESISTANCE_HOLDS}.")
        }
        Cause::Stick => format!("Sticks and rolls: the slip has died away, and {HOLDS}."),
        Cause::TurningPoint => turning_point(hoop, event, &forces),
        Cause::Reversal if event.from == Some(Mode::Gliding) => {
            "The slip of the glide reverses: outside 𝓡 nothing holds the contact point.".to_owned()
        }
        Cause::Reversal => {
            format!("The slip reverses: {}.", gives_way(hoop, &forces))
        }
        Cause::Graze => "The slip touches zero and continues in the same direction.".to_owned(),
        Cause::NormalForceZero => {
            "Glides: the normal force has vanished before friction gave way.".to_owned()
        }
        Cause::LiftOff => lift_off(hoop, event, scale),
        Cause::Landing => match &event.impact {
            Some(impact) => struck(impact).landing(),
            None => landing(ended_by(trajectory, index), scale),
        },
        Cause::ParticleAtPlane => {
            format!("The particle reaches the ground; {NO_IMPACT}.")
        }
        Cause::ParticleAtBottom => {
            format!("The particle reaches its lowest place; {NO_IMPACT}.")
        }
        Cause::ParticleAtTop => {
            "The particle reaches its highest place with velocity to spare: it would lift the hoop."
                .to_owned()
        }
        Cause::Settle => impact::settling(trajectory, index, event, scale),
        Cause::Jam => match &event.impact {
            Some(impact) => struck(impact).jam(),
            None => "Jams.".to_owned(),
        },
        Cause::Singularity => {
            "The slide jams: beyond P = 0 no sliding motion presses on the plane (Painlevé)."
                .to_owned()
        }
    })
}

/// The rotation has come to a stop.
fn turning_point(hoop: &Hoop, event: &Transition, forces: &ContactForces) -> String {
    match event.to {
        Some(Mode::Rest) => format!("Comes to rest: it has stopped, and {RESISTANCE_HOLDS}."),
        Some(Mode::Skidding) => {
            format!("Skids: it has stopped turning, and {RESISTANCE_HOLDS} while it slips.")
        }
        Some(Mode::Sliding) if event.from == Some(Mode::Rolling) => {
            format!("Stops turning, and slips: {}.", gives_way(hoop, forces))
        }
        Some(Mode::Rolling | Mode::Sliding | Mode::Gliding | Mode::Flight) | None => {
            "Turns back: it has stopped, and its weight outdoes the rolling resistance.".to_owned()
        }
    }
}

fn lift_off(hoop: &Hoop, event: &Transition, scale: Scale<'_>) -> String {
    let rise = -hoop.h() * libm::sin(event.before.theta) * event.before.theta_rate;
    let rises = if hoop.slope() == 0.0 {
        "rises"
    } else {
        "rises from the plane"
    };
    format!(
        "Jumps. The ground no longer pushes (N = 0), and the mass centre still {rises} at {}.",
        scale.show_with_unit(Dimension::Velocity, three(rise))
    )
}

/// The end of the motion, or that it has none.
pub fn outcome(trajectory: &Trajectory, scale: Scale<'_>) -> String {
    let hoop = trajectory.hoop();
    match trajectory.outcome() {
        Outcome::RollsForever { recurrence, .. } => {
            let returns = returns(&recurrence, scale);
            format!("Rolls for ever, {returns}: static friction holds on the whole orbit.")
        }
        Outcome::SlidesForever { recurrence, .. } => {
            let returns = returns(&recurrence, scale);
            format!("Slides for ever without friction, {returns}.")
        }
        Outcome::SlipsForever {
            orbit,
            slips_to_halve,
            ..
        } => format!(
            "Slips for ever, with decaying amplitude: towards the orbit that grazes the static \
             limit at θ = ±{}, {}; the distance from it halves in about {slips_to_halve:.0} slips.",
            brief(orbit.theta),
            returns(&orbit.recurrence, scale)
        ),
        Outcome::RepeatsForever {
            period,
            theta_gained,
            transitions,
            ..
        } => format!(
            "Repeats itself for ever, with the period {}, {transitions} transitions and {:.0} \
             turns: no energy is lost.",
            scale.show_with_unit(Dimension::Time, period),
            (theta_gained / TAU).abs(),
        ),
        Outcome::Rests { half_swings, .. } => {
            let after = match half_swings {
                0 => String::new(),
                1 => ", after a half swing".to_owned(),
                many => format!(", after {many} half swings"),
            };
            format!("Rests for ever{after}: {RESISTANCE_HOLDS}.")
        }
        Outcome::StaysInContact { .. } => {
            "Stays in contact for ever: energy and momentum do not suffice for a lift-off."
                .to_owned()
        }
        Outcome::TimeLimit { .. } => "The time limit ends the motion here.".to_owned(),
        Outcome::TransitionLimit { transitions, .. } => {
            stopped_after_transitions(transitions, trajectory)
        }
        Outcome::StepLimit {
            limit: SlideLimit::One { steps, .. },
            ..
        } if ends_in(trajectory, Mode::Rolling) => {
            format!("Stopped after {steps} steps of rolling: its end is not known.")
        }
        Outcome::StepLimit { limit, .. } => stopped_slide(&limit, scale),
        Outcome::Inconsistent { candidates, .. } => {
            let examined = examined(hoop, &candidates).join("; ");
            format!("{NO_ANSWER}: no motion is consistent; {examined}.")
        }
        Outcome::Ambiguous { candidates, .. } => {
            let [rolling, sliding] = examined(hoop, &candidates);
            let found = consistent(&candidates, ", ");
            format!("{NO_ANSWER}: several motions are consistent, {found}; {rolling}; {sliding}.")
        }
        Outcome::Unresolved { undecided, .. } => unresolved(&undecided, scale),
        event @ (Outcome::Landing { .. }
        | Outcome::ParticleAtPlane { .. }
        | Outcome::ParticleAtBottom { .. }
        | Outcome::ParticleAtTop { .. }
        | Outcome::Singular { .. }) => ends_by_event(&event, trajectory, scale),
    }
}

/// The sentence of the last event.
fn ends_by_event(outcome: &Outcome, trajectory: &Trajectory, scale: Scale<'_>) -> String {
    let last = trajectory.transitions().len().checked_sub(1);
    last.and_then(|index| transition(trajectory, index, scale))
        .unwrap_or_else(|| format!("Ends: {}.", outcome.kind().label()))
}

fn stopped_after_transitions(transitions: usize, trajectory: &Trajectory) -> String {
    let endless = match trajectory.transitions().last() {
        Some(last) if last.is_bounce() => "bounces may never end",
        Some(last) if last.cause == Cause::TurningPoint => "it swings on, less each time",
        _ => "slips may continue with decaying amplitude",
    };
    format!("Stopped after {transitions} transitions: {endless}.")
}

fn ends_in(trajectory: &Trajectory, mode: Mode) -> bool {
    let last = trajectory.phases().last();
    last.is_some_and(|phase| phase.mode() == mode)
}

fn stopped_slide(limit: &SlideLimit, scale: Scale<'_>) -> String {
    match limit {
        SlideLimit::All { slides } => format!(
            "Stopped after slides of total length {slides}: slips may continue with decaying \
             amplitude."
        ),
        SlideLimit::One { steps, time_left } => format!(
            "Stopped after {steps} steps of a slide: at its pace it would stick after another {}.",
            scale.show_with_unit(Dimension::Time, three(*time_left))
        ),
    }
}

/// Why a motion is unresolved.
pub fn unresolved(undecided: &Undecided, scale: Scale<'_>) -> String {
    let (_, name) = undecided.names();
    let [value, bound] = undecided
        .compared()
        .map(|number| scale.show_with_unit(undecided.dimension(), three(number)));
    match undecided {
        Undecided::Rounding { .. } => format!(
            "From here doubles do not resolve the motion: it depends on {name}, which is {value}, \
             with rounding up to {bound}."
        ),
        Undecided::Range { .. } => format!(
            "From here doubles do not resolve the motion: {name} would be {value}, with a bound of \
             {bound}."
        ),
    }
}

/// Why a hoop rolls, in the sentence of the event that begins it: what it needs changes while it
/// rolls ([`friction`]).
const HOLDS: &str = "static friction holds the contact point";

/// Why a hoop does not begin to turn.
const RESISTANCE_HOLDS: &str = "rolling resistance holds it against its weight";

/// The friction that rolling needs at an instant, and that there is; none in another mode.
pub fn friction(hoop: &Hoop, sample: &Sample) -> Option<String> {
    if sample.mode != Mode::Rolling {
        return None;
    }
    let demand = sample.friction.abs() / sample.normal;
    Some(if demand < FRICTIONLESS {
        "Rolling needs no friction here.".to_owned()
    } else {
        let [demand, mu_s] = [three(demand), hoop.mu_s()].map(brief);
        format!("Rolling needs |F|/N = {demand} here; μₛ = {mu_s}.")
    })
}

/// Static friction did not suffice.
fn gives_way(hoop: &Hoop, forces: &ContactForces) -> String {
    let there_is = brief(hoop.mu_s());
    if forces.normal > 0.0 {
        format!(
            "rolling would have needed a friction coefficient of {}; there is {there_is}",
            brief(short(forces.demand())),
        )
    } else {
        "to roll, the ground would have to pull it down, and it can only push".to_owned()
    }
}

fn slip(event: &Transition, mu_s: f64) -> String {
    let beyond = format!(
        "it needs more friction than the ground has (μₛ = {})",
        brief(mu_s)
    );
    match event.to {
        Some(Mode::Gliding) => {
            format!("Slips and glides: {beyond}; without inertia a slip bears no force.")
        }
        // With w < 0 friction alone has held it down.
        Some(Mode::Flight) => format!("Leaves, for it was wedged and gives way: {beyond}."),
        Some(Mode::Rolling | Mode::Sliding | Mode::Rest | Mode::Skidding) | None => {
            format!("Slips: {beyond}.")
        }
    }
}

/// The phase that a transition ends. Every transition but a few jams ends one, so that it is not
/// far from the same index.
fn ended_by(trajectory: &Trajectory, index: usize) -> Option<&Phase> {
    let event = trajectory
        .transitions()
        .get(index)
        .filter(|event| event.from.is_some())?;
    let is_end = |phase: &&Phase| {
        trajectory
            .end_of(phase)
            .is_some_and(|end| core::ptr::eq(end, event))
    };
    let phases = trajectory.phases();
    phases
        .get(..=index)
        .unwrap_or(phases)
        .iter()
        .rev()
        .find(is_end)
}

/// A landing that ends the motion.
fn landing(flight: Option<&Phase>, scale: Scale<'_>) -> String {
    let Some((phase, end, PhaseSolution::Flight(flight))) =
        flight.and_then(|phase| Some((phase, phase.end()?, phase.solution())))
    else {
        return "Lands.".to_owned();
    };
    let start = phase.start();
    let direction = if end.x < start.x {
        "to the left"
    } else {
        "to the right"
    };
    format!(
        "Lands {} {direction} after {} in the air, at most {} above the plane.",
        scale.show_with_unit(Dimension::Length, three((end.x - start.x).abs())),
        scale.show_with_unit(Dimension::Time, three(phase.duration())),
        scale.show_with_unit(Dimension::Length, three(flight.apex().1)),
    )
}

/// How a motion without an end recurs.
pub fn returns(recurrence: &Recurrence, scale: Scale<'_>) -> String {
    let show = |period| scale.show_with_unit(Dimension::Time, period);
    match *recurrence {
        Recurrence::Rest => "at rest in equilibrium".to_owned(),
        Recurrence::Libration {
            period,
            theta_min,
            theta_max,
        } => format!(
            "back and forth between θ = {} and {} with the period {}",
            brief(theta_min),
            brief(theta_max),
            show(period)
        ),
        Recurrence::Rotation { period } => format!("one turn in {}", show(period)),
        Recurrence::Downhill { acceleration } => format!(
            "down the slope with the acceleration {}",
            scale.show_with_unit(Dimension::Acceleration, acceleration)
        ),
        Recurrence::Asymptotic { theta } => {
            format!(
                "towards the unstable equilibrium θ = {}, never reached",
                brief(theta)
            )
        }
    }
}

/// The motions that are consistent, with the word between them.
pub fn consistent(candidates: &Candidates, between: &str) -> String {
    let modes = candidates.consistent();
    let motions = modes.map(|(mode, direction)| mode.with_arrow(direction));
    let jam = candidates.jam.map(|_| "a jam".to_owned());
    Vec::from_iter(motions.chain(jam)).join(between)
}

/// The margin by which gravity and inertia press the hoop to the plane, in parts of its weight.
pub const fn contact_margin(hoop: &Hoop) -> &'static str {
    if hoop.slope() == 0.0 {
        "1 − h cos θ θ′²"
    } else {
        "1 − h cos θ θ′²/cos α"
    }
}

/// What rolling and sliding would need where the motion that follows is not unique.
pub fn examined(hoop: &Hoop, candidates: &Candidates) -> [String; 2] {
    let [negative, positive] = candidates.solvability.map(brief);
    let closes = candidates.jam.map_or(String::new(), |denominator| {
        let denominator = brief(denominator);
        format!(", and D_χ = {denominator} < 0, so that pressing closes the gap")
    });
    [
        format!(
            "rolling would need N = {}, F = {}, and has {} = {}{closes}",
            brief(candidates.rolling_forces.normal),
            brief(candidates.rolling_forces.friction),
            contact_margin(hoop),
            brief(candidates.contact),
        ),
        format!("sliding would need P > 0, and P is {negative} for σ = −1, {positive} for σ = +1"),
    ]
}

fn to_the(slip: f64) -> &'static str {
    if slip < 0.0 {
        "to the left"
    } else {
        "to the right"
    }
}

/// Two digits say enough about a coefficient of friction.
fn short(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
