//! The class of one motion.

use littlewood::tables::Class;
use littlewood::{Limits, Mode, Proof};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::Problem;

/// Largest number of transitions that are followed.
const TRANSITIONS: usize = 200;

/// The class of the motion of a problem ([`Class`]), followed until it leaves the plane or is
/// proved not to.
#[wasm_bindgen(js_name = classOf)]
pub fn class_of(problem: &Problem) -> u8 {
    let limits = Limits::default()
        .with_transitions(TRANSITIONS)
        .with_proof(Proof::Contact);
    let class = problem
        .hoop
        .simulate(problem.start, limits)
        .map_or(Class::Invalid, |motion| {
            let flight = motion
                .phases()
                .iter()
                .position(|phase| phase.mode() == Mode::Flight);
            match flight {
                Some(0) => Class::LeavesAtOnce,
                Some(_) => Class::LiftsOffLater,
                None => Class::of_end(motion.outcome().kind()),
            }
        });
    class.code()
}
