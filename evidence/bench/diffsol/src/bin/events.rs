//! The systems of events/problems.py by diffsol: each line `setting system parameter until y…` is
//! answered by one line, the first root at which a margin falls: `time index y…`, or `none`.

use std::error::Error;
use std::io::{self, BufRead};

use diffsol::{
    NalgebraContext, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquationsImplicit, OdeSolverMethod,
    OdeSolverProblem, OdeSolverStopReason, Vector,
};

type Matrix = NalgebraMat<f64>;

/// Where a solver stops, and which margin it names.
struct Stop {
    time: f64,
    index: usize,
    state: Vec<f64>,
}

fn swing(y: &[f64], dy: &mut [f64]) {
    dy.copy_from_slice(&[y[1], -y[0]]);
}

fn balls(y: &[f64], dy: &mut [f64]) {
    for (rates, one) in dy.chunks_exact_mut(2).zip(y.chunks_exact(2)) {
        rates.copy_from_slice(&[one[1], -1.0]);
    }
}

/// A problem with a margin for each pair of coordinate and speed.
macro_rules! problem {
    ($rates:expr, $jacobian:expr, $margin:expr, $start:expr, $parameter:expr, $tolerance:expr) => {{
        let start: Vec<f64> = $start.to_vec();
        let size = start.len();
        let builder = OdeBuilder::<Matrix>::new().p([$parameter]);
        let builder = match $tolerance {
            Some(tolerance) => builder.rtol(tolerance).atol([tolerance]),
            None => builder,
        };
        builder
            .rhs_implicit(
                |y: &[f64], _p: &[f64], _t: f64, dy: &mut [f64]| $rates(y, dy),
                |_y: &[f64], _p: &[f64], _t: f64, v: &[f64], jv: &mut [f64]| $jacobian(v, jv),
            )
            .init(move |_p: &[f64], _t: f64, y: &mut [f64]| y.copy_from_slice(&start), size)
            .root(
                |y: &[f64], p: &[f64], _t: f64, g: &mut [f64]| {
                    for (margin, one) in g.iter_mut().zip(y.chunks_exact(2)) {
                        *margin = $margin(one[0], p[0]);
                    }
                },
                size / 2,
            )
            .build()
    }};
}

/// The first root at which a margin falls; `falls` is its sign of the speed then.
fn first<E>(problem: &OdeSolverProblem<E>, implicit: bool, until: f64, falls: f64) -> Result<Option<Stop>, Box<dyn Error>>
where
    E: OdeEquationsImplicit<M = Matrix, V = NalgebraVec<f64>, T = f64, C = NalgebraContext>,
{
    macro_rules! search {
        ($solver:expr) => {{
            let mut solver = $solver;
            solver.set_stop_time(until)?;
            loop {
                match solver.step()? {
                    OdeSolverStopReason::RootFound(time, index) => {
                        let state = solver.interpolate(time)?;
                        if state[2 * index + 1] * falls > 0.0 {
                            let state = (0..state.len()).map(|i| state[i]).collect();
                            return Ok(Some(Stop { time, index, state }));
                        }
                    }
                    OdeSolverStopReason::TstopReached => return Ok(None),
                    _ => {}
                }
            }
        }};
    }
    if implicit {
        search!(problem.bdf::<diffsol::NalgebraLU<f64>>()?)
    } else {
        search!(problem.tsit45()?)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    for line in io::stdin().lock().lines() {
        let line = line?;
        let mut words = line.split_whitespace();
        let (setting, system) = (words.next().unwrap_or(""), words.next().unwrap_or(""));
        let numbers = words.map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let (parameter, until, start) = (numbers[0], numbers[1], &numbers[2..]);
        let (implicit, tolerance) = (setting.starts_with("bdf"), setting.ends_with("1e-12").then_some(1e-12));
        let found = if system == "swing" {
            let problem = problem!(swing, swing, |y: f64, top: f64| top - y, start, parameter, tolerance)?;
            first(&problem, implicit, until, 1.0)
        } else {
            let gradient = |v: &[f64], jv: &mut [f64]| {
                for (rates, one) in jv.chunks_exact_mut(2).zip(v.chunks_exact(2)) {
                    rates.copy_from_slice(&[one[1], 0.0]);
                }
            };
            let problem = problem!(balls, gradient, |y: f64, _: f64| y, start, parameter, tolerance)?;
            first(&problem, implicit, until, -1.0)
        };
        match found {
            Ok(None) => println!("none"),
            Ok(Some(Stop { time, index, state })) => {
                let state: Vec<String> = state.iter().map(|y| format!("{y:e}")).collect();
                println!("{time:e} {index} {}", state.join(" "));
            }
            Err(error) => println!("error {}", error.to_string().replace('\n', " ")),
        }
    }
    Ok(())
}
