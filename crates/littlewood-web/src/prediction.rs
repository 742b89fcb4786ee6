//! Where the derivatives of a motion predict a landing of another one.

use littlewood::derivatives::{Derivative, NoDerivative};
use littlewood::tables::{Quantity, Setup};
use littlewood::{State, Trajectory};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::partials::{Change, Partials};
use crate::problem::Problem;

/// Parts of a path.
const PARTS: u32 = 32;

/// What the derivatives of a motion say of a landing, and of the flight before it, when its numbers change.
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
            Ok(Predicted { landing, path: path(problem, take_off, landing) })
        })())
    }
}

#[wasm_bindgen]
impl Ghost {
    /// Why there is no prediction.
    pub fn reason(&self) -> Option<String> {
        self.0.as_ref().err().map(|reason| NoDerivative::label(*reason).to_owned())
    }

    /// The landing, in the columns of [`State::COLUMNS`]; empty where there is a reason.
    pub fn landing(&self) -> Vec<f64> {
        self.0.as_ref().map_or_else(|_| Vec::new(), |it| it.landing.to_vec())
    }

    /// The path of the mass centre in the flight before it: x along the plane and the height over it, in turn.
    pub fn path(&self) -> Vec<f64> {
        self.0.as_ref().map_or_else(|_| Vec::new(), |it| it.path.clone())
    }
}

impl Prediction {
    /// For a landing of the motion of a problem; none for another transition.
    pub(crate) fn new(problem: &Problem, trajectory: &Trajectory, transition: usize) -> Option<Self> {
        let event = |index: usize| {
            let after = trajectory.transitions().get(index)?.after.numbers();
            Some((after, Partials::of(problem, trajectory, index)?))
        };
        Some(Self {
            setup: problem.setup(),
            landing: event(transition)?,
            take_off: transition.checked_sub(1).and_then(event),
        })
    }
}

/// The path of the mass centre between two instants at which the rim is at the plane: the parabola with the acceleration of gravity.
fn path(problem: &Problem, from: Change, to: Change) -> Vec<f64> {
    let h = problem.hoop.h();
    let slope = problem.hoop.slope();
    let mass_centre = |[_, theta, _, _, x]: Change| [x - h * libm::sin(theta), 1.0 + h * libm::cos(theta)];
    let (begin, end) = (mass_centre(from), mass_centre(to));
    let duration = to[0] - from[0];
    let fall = [libm::sin(slope), libm::cos(slope)].map(|it| 0.5 * it * duration * duration);
    let point = |number: u32| {
        let part = f64::from(number) / f64::from(PARTS);
        let rest = 1.0 - part;
        core::array::from_fn::<f64, 2, _>(|i| rest * begin[i] + part * end[i] + part * rest * fall[i])
    };
    (0..=PARTS).flat_map(point).collect()
}

#[cfg(test)]
mod tests {
    use littlewood::cases::find_case;

    use super::*;
    use crate::motion::Motion;

    /// m1/m2, ℓ/R, Izz, μs, μk, α, θ, θ′, η′, gap′, x, τ.
    fn problem(numbers: [f64; 12]) -> Problem {
        Problem::dimensionless(&numbers, None, None, None).unwrap()
    }

    fn of_figure_3(mu_k: f64) -> Problem {
        let mut setup = find_case("figure-3").unwrap().setup;
        setup.hoop.mu_k = mu_k;
        problem(setup.values([
            Quantity::MassRatio,
            Quantity::Offset,
            Quantity::Inertia,
            Quantity::MuS,
            Quantity::MuK,
            Quantity::Slope,
            Quantity::Theta,
            Quantity::ThetaRate,
            Quantity::Slip,
            Quantity::GapRate,
            Quantity::X,
            Quantity::Time,
        ]))
    }

    #[test]
    fn the_flight_of_a_stone_is_predicted_exactly() {
        // Without an offset the landing is at τ = 2 gap′, and linear in the rate; the mass centre rises by gap′²/2.
        let thrown = |gap_rate| problem([1.0, 0.0, 1.0, 0.5, 0.4, 0.0, 0.25, 1.5, 0.5, gap_rate, 0.0, 0.0]);
        let prediction = Motion::new(&thrown(1.0), None).unwrap().prediction(0).unwrap();
        let ghost = prediction.of(&thrown(1.5));
        let [time, theta, ..] = ghost.landing()[..] else { panic!("{ghost:?}") };
        assert!(
            (time - 3.0).abs() <= 8.0 * f64::EPSILON * 3.0
                && (theta - 4.75).abs() <= 8.0 * f64::EPSILON * 4.75
        );
        let top = ghost.path().chunks(2).map(|point| point[1]).fold(0.0, f64::max);
        assert!((top - (1.0 + 0.5 * 1.5 * 1.5)).abs() < 16.0 * f64::EPSILON * 2.0, "{top}");
    }

    #[test]
    fn what_a_prediction_misses_is_of_second_order() {
        let landing = 3;
        let prediction = Motion::new(&of_figure_3(0.4), None).unwrap().prediction(landing).unwrap();
        let missed = |change: f64| {
            let exact = of_figure_3(0.4 + change);
            let motion = exact.hoop.simulate(exact.start, exact.limits).unwrap();
            prediction.of(&exact).landing()[0] - motion.transitions()[landing].time()
        };
        // Of an even change the even orders are left: a second difference, quartered by halves but for the fourth order.
        let even = |change: f64| missed(change) + missed(-change);
        let ratio = even(2e-3) / even(1e-3);
        assert!((ratio - 4.0).abs() < 1e-2, "{ratio}");
        // Without the term of first order it would be halved: what is odd is of third order.
        let odd = |change: f64| missed(change) - missed(-change);
        let ratio = odd(2e-2) / odd(1e-2);
        assert!((ratio - 8.0).abs() < 0.5, "{ratio}");
    }

    #[test]
    fn only_landings_are_predicted_and_what_has_no_derivative_has_a_reason() {
        let motion = Motion::new(&of_figure_3(0.4), None).unwrap();
        assert!(motion.prediction(2).is_none() && motion.prediction(9).is_none());
        let mut other = of_figure_3(0.4);
        other.start.slip = 0.1;
        let ghost = motion.prediction(3).unwrap().of(&other);
        assert_eq!(ghost.reason().as_deref(), Some(NoDerivative::OneSided.label()));
        assert!(ghost.landing().is_empty() && ghost.path().is_empty());
    }

    #[test]
    fn the_path_is_that_of_the_motion_where_nothing_changes() {
        let same = of_figure_3(0.4);
        let motion = same.hoop.simulate(same.start, same.limits).unwrap();
        let path = Motion::new(&same, None).unwrap().prediction(3).unwrap().of(&same).path();
        let [from, to] = [2, 3].map(|index| motion.transitions()[index].time());
        for (number, point) in path.chunks(2).enumerate() {
            let sample = motion.at(from + (to - from) * number as f64 / f64::from(PARTS)).unwrap();
            let away = libm::hypot(point[0] - sample.mass_centre.x, point[1] - sample.mass_centre.y);
            assert!(away < 1e-12, "{number}: {away}");
        }
    }
}
