//! The transitions of many motions, with all digits, for programs that compare.
//!
//! Reads a motion a line, ten numbers: mass ratio, offset, inertia, μs, μk, θ, θ′, η′, rate of the gap, time limit (`inf` for none).
//! Writes a line for each, its parts separated by ` | `: the mode that begins and its direction of slip; of every transition the cause,
//! the mode that follows, its direction, and τ, θ, θ′, η′ and x just before; the outcome, with its state.
//!
//! ```sh
//! echo "1 1 1 0.5 0.4 1.5707963267948966 2 0 0 inf" | cargo run --release -p littlewood --example transitions
//! ```

use std::error::Error;
use std::io::{BufWriter, Write, stdin, stdout};

use littlewood::{Direction, Hoop, HoopParameters, Limits, Mode, Phase, Proof, Start, State};

/// Largest number of transitions of a motion.
const TRANSITIONS: usize = 100;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = BufWriter::new(stdout().lock());
    for line in stdin().lines() {
        let line = line?;
        let numbers = line.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [mass_ratio, offset, inertia, mu_s, mu_k, theta, rate, slip, gap_rate, until] = numbers[..]
        else {
            return Err(format!("ten numbers are needed: {line}").into());
        };
        let hoop = Hoop::new(
            HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_k),
        )?;
        let start = Start::at(theta, rate).with_slip(slip).with_gap_rate(gap_rate);
        let limits = Limits::default()
            .with_until(until.is_finite().then_some(until))
            .with_transitions(TRANSITIONS)
            .with_proof(Proof::None);
        let motion = hoop.simulate(start, limits)?;
        let first = motion.phases().first();
        write!(
            out,
            "{} {}",
            first.map_or("none", |phase| phase.mode().name()),
            Direction::code(first.and_then(Phase::direction))
        )?;
        for event in motion.transitions() {
            let to = event.to.map_or("none", Mode::name);
            write!(
                out,
                " | {} {to} {} {}",
                event.cause,
                Direction::code(event.direction),
                digits(&event.before)
            )?;
        }
        writeln!(out, " | {} {}", motion.outcome().kind(), digits(&motion.outcome().state()))?;
    }
    Ok(out.flush()?)
}

fn digits(state: &State) -> String {
    let State { time, theta, theta_rate, slip, x } = *state;
    format!("{time:?} {theta:?} {theta_rate:?} {slip:?} {x:?}")
}
