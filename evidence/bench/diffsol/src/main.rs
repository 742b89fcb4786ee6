//! diffsol: the explicit Runge–Kutta method `tsit45` with root finding, one problem for each mode.
//! Answers each line `trajectory …` with one line of JSON.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::time::Instant;

use diffsol::{
    Context, NalgebraContext, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations, OdeSolverMethod,
    OdeSolverProblem, OdeSolverStopReason,
};

type Matrix = NalgebraMat<f64>;
/// θ, θ′, η′, x.
type State = [f64; 4];

const MASS: f64 = 2.0;
const OFFSET: f64 = 0.5;
const INERTIA: f64 = 1.5;
const ARM: f64 = 1.0;
const MU_S: f64 = 0.5;
const MU_K: f64 = 0.4;
const TOLERANCE: f64 = 1e-12;
const FIRST_STEP: f64 = 1e-4;
/// Slip at the start of a slide, so that the event function does not start at 0.
const SEED: f64 = 1e-300;

/// Angular acceleration, normal force and friction.
fn rolling(y: &[f64]) -> (f64, f64, f64) {
    let (s, c) = y[0].sin_cos();
    let u = y[1] * y[1];
    let acceleration = ARM * s * (u + 1.0) / (INERTIA + MASS * (1.0 + OFFSET * OFFSET + 2.0 * OFFSET * c));
    let normal = MASS - ARM * (s * acceleration + c * u);
    (acceleration, normal, ARM * s * u - MASS * (1.0 + OFFSET * c) * acceleration)
}

/// Angular acceleration and slip acceleration.
fn sliding(y: &[f64], sign: f64) -> (f64, f64) {
    let (s, c) = y[0].sin_cos();
    let u = y[1] * y[1];
    let q = OFFSET * s - MU_K * sign * (1.0 + OFFSET * c);
    let normal = INERTIA * MASS * (1.0 - OFFSET * c * u) / (INERTIA + MASS * OFFSET * s * q);
    let acceleration = normal * q / INERTIA;
    (acceleration, -MU_K * sign * normal / MASS + (1.0 + OFFSET * c) * acceleration - OFFSET * s * u)
}

/// A problem whose parameters are the state it starts from and the sign of the slip.
macro_rules! problem {
    ($rates:expr, $margins:expr) => {
        OdeBuilder::<Matrix>::new()
            .rtol(TOLERANCE)
            .atol([TOLERANCE])
            .h0(FIRST_STEP)
            .p([FRAC_PI_2, 2.0, 0.0, 0.0, 1.0])
            .rhs(|y: &[f64], p: &[f64], _t: f64, dy: &mut [f64]| {
                let (acceleration, slip) = $rates(y, p[4]);
                dy.copy_from_slice(&[y[1], acceleration, slip, y[2] - y[1]]);
            })
            .init(|p: &[f64], _t: f64, y: &mut [f64]| y.copy_from_slice(&p[..4]), 4)
            .root(|y: &[f64], p: &[f64], _t: f64, g: &mut [f64]| g.copy_from_slice(&$margins(y, p[4])), 2)
            .build()
    };
}

/// One phase: its duration, the event that ends it and the state there.
fn phase<E>(
    problem: &mut OdeSolverProblem<E>,
    y: State,
    sign: f64,
) -> Result<(f64, usize, State), Box<dyn Error>>
where
    E: OdeEquations<M = Matrix, V = NalgebraVec<f64>, T = f64, C = NalgebraContext>,
{
    let parameters = problem.context().vector_from_vec(vec![y[0], y[1], y[2], y[3], sign]);
    problem.eqn_mut().set_params(&parameters);
    let mut solver = problem.tsit45()?;
    loop {
        if let OdeSolverStopReason::RootFound(time, event) = solver.step()? {
            let y = solver.interpolate(time)?;
            return Ok((time, event, [y[0], y[1], y[2], y[3]]));
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut roll = problem!(|y: &[f64], _sign: f64| (rolling(y).0, 0.0), |y: &[f64], _sign: f64| {
        let (_, normal, friction) = rolling(y);
        [MU_S * normal - friction, MU_S * normal + friction]
    })?;
    let mut slide =
        problem!(sliding, |y: &[f64], sign: f64| [1.0 - OFFSET * y[0].cos() * y[1] * y[1], y[2] * sign])?;
    let mut trajectory = || -> Result<[f64; 3], Box<dyn Error>> {
        let (stick, _, [theta, rate, _, x]) = phase(&mut slide, [FRAC_PI_2, 2.0, -SEED, 0.0], -1.0)?;
        let (held, event, [theta, rate, _, x]) = phase(&mut roll, [theta, rate, 0.0, x], 1.0)?;
        let sign = if event == 0 { -1.0 } else { 1.0 };
        let (slid, _, _) = phase(&mut slide, [theta, rate, SEED * sign, x], sign)?;
        Ok([stick, stick + held, stick + held + slid])
    };
    for line in std::io::stdin().lines() {
        if !line?.starts_with("trajectory") {
            continue;
        }
        let mut seconds = Vec::new();
        let start = Instant::now();
        while start.elapsed().as_secs_f64() < 0.5 {
            let start = Instant::now();
            std::hint::black_box(trajectory()?);
            seconds.push(start.elapsed().as_secs_f64());
        }
        seconds.sort_by(f64::total_cmp);
        let (times, median) = (trajectory()?, seconds[seconds.len() / 2]);
        println!(r#"[{{"name": "diffsol tsit45, 1e-12", "seconds": {median:e}, "times": {times:?}}}]"#);
    }
    Ok(())
}
