//! Where the derivatives of a motion predict a landing of another one.

use littlewood::derivatives::{Derivative, NoDerivative};
use littlewood::tables::{Quantity, Setup};
use littlewood::{Cause, State};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::partials::{Change, Partials};
use crate::problem::Problem;

/// Parts of a path.
const PARTS: u32 = 32;

/// What the derivatives of a motion say of a landing, and of the flight before it, when its numbers
/// change.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Prediction {
    setup: Setup,
    landing: (Change, Partials),
    /// The transition that the flight begins with; none if it begins with the motion.
    take_off: Option<(Change, Partials)>,
}

/// A landing that is predicted to first order, or the reason why it cannot be.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Ghost(Derivative<Predicted>);

#[derive(Clone, Debug)]
struct Predicted {
    landing: Change,
    path: Vec<f64>,
}

#[wasm_bindgen]
impl Prediction {
    /// For a landing of the motion of a problem, a transition; none for another one.
    #[wasm_bindgen(js_name = ofLanding)]
    pub fn of_landing(problem: &Problem, transition: usize) -> Option<Self> {
        let event = |index: usize| {
            let (motion, partials) = Partials::of(problem, index)?;
            let event = motion.transitions().get(index)?;
            Some((event.cause, event.after.numbers(), partials))
        };
        let (cause, landing, partials) = event(transition)?;
        let take_off = || {
            let (_, numbers, partials) = event(transition.checked_sub(1)?)?;
            Some((numbers, partials))
        };
        (cause == Cause::Landing).then(|| Self {
            setup: problem.setup(),
            landing: (landing, partials),
            take_off: take_off(),
        })
    }

    /// For the motion of another problem.
    pub fn of(&self, problem: &Problem) -> Ghost {
        let setup = problem.setup();
        let change = |quantity: Quantity| match (self.setup.get(quantity), setup.get(quantity)) {
            (Some(before), Some(now)) => now - before,
            _ => 0.0,
        };
        let moved = |(numbers, partials): &(Change, Partials)| {
            let moved = partials.move_of(change)?;
            Ok(core::array::from_fn(|place| numbers[place] + moved[place]))
        };
        Ghost((|| {
            let landing = moved(&self.landing)?;
            let take_off = match &self.take_off {
                Some(event) => moved(event)?,
                None => State::from(problem.start).numbers(),
            };
            Ok(Predicted {
                landing,
                path: path(problem, take_off, landing),
            })
        })())
    }
}

#[wasm_bindgen]
impl Ghost {
    /// Why there is no prediction.
    pub fn reason(&self) -> Option<String> {
        self.0
            .as_ref()
            .err()
            .map(|reason| NoDerivative::label(*reason).to_owned())
    }

    /// The landing, in the columns of [`State::COLUMNS`]; empty where there is a reason.
    pub fn landing(&self) -> Vec<f64> {
        self.0
            .as_ref()
            .map_or_else(|_| Vec::new(), |it| it.landing.to_vec())
    }

    /// The path of the mass centre in the flight before it: x along the plane and the height over
    /// it, in turn.
    pub fn path(&self) -> Vec<f64> {
        self.0
            .as_ref()
            .map_or_else(|_| Vec::new(), |it| it.path.clone())
    }
}

/// The path of the mass centre between two instants at which the rim is at the plane: the parabola
/// with the acceleration of gravity.
fn path(problem: &Problem, from: Change, to: Change) -> Vec<f64> {
    let h = problem.hoop.h();
    let slope = problem.hoop.slope();
    let mass_centre =
        |[_, theta, _, _, x]: Change| [x - h * libm::sin(theta), 1.0 + h * libm::cos(theta)];
    let (begin, end) = (mass_centre(from), mass_centre(to));
    let duration = to[0] - from[0];
    let fall = [libm::sin(slope), libm::cos(slope)].map(|it| 0.5 * it * duration * duration);
    let point = |number: u32| {
        let part = f64::from(number) / f64::from(PARTS);
        let rest = 1.0 - part;
        core::array::from_fn::<f64, 2, _>(|i| {
            rest * begin[i] + part * end[i] + part * rest * fall[i]
        })
    };
    (0..=PARTS).flat_map(point).collect()
}
