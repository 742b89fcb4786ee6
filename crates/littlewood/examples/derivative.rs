//! How much does the jump depend on friction? Derivatives of events, without difference quotients.

use littlewood::tables::Quantity;
use littlewood::{Hoop, HoopParameters, Limits, Start};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let parameters = |mu_k: f64| HoopParameters::thin(1.0).with_friction(0.5, mu_k);
    let start = Start::at(std::f64::consts::FRAC_PI_2, 2.0);
    let motion = Hoop::new(parameters(0.4))?.simulate(start, Limits::default())?;

    let derivatives = motion.derivatives(&[Quantity::MuK])?;
    for (transition, by_quantity) in motion.transitions().iter().zip(derivatives.transitions()) {
        match by_quantity[0] {
            Ok(event) => println!(
                "{}: τ = {:.6}, ∂τ/∂μk = {:.6}",
                transition.cause,
                transition.time(),
                event.before.time
            ),
            Err(reason) => println!("{}: no derivative, {reason}", transition.cause),
        }
    }

    // A difference quotient agrees to its own accuracy.
    let last = derivatives.transitions().len() - 1;
    let exact = derivatives.transitions()[last][0]
        .map_err(littlewood::derivatives::NoDerivative::label)?
        .before
        .time;
    let step = 1e-6;
    let time = |mu_k: f64| -> Result<f64, littlewood::ParameterError> {
        let motion = Hoop::new(parameters(mu_k))?.simulate(start, Limits::default())?;
        Ok(motion.transitions()[last].time())
    };
    let quotient = (time(0.4 + step)? - time(0.4 - step)?) / (2.0 * step);
    println!("landing: {exact:.9} against the quotient {quotient:.9}");
    assert!((exact - quotient).abs() < 1e-6 * exact.abs().max(1.0));
    Ok(())
}
