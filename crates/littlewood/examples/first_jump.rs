//! A hoop that jumps by itself: its motion, event by event, and the height of the jump.

use littlewood::{Cause, Hoop, HoopParameters, Limits, ParameterError, Start};

fn main() -> Result<(), ParameterError> {
    // A thin hoop of the mass of its particle, with μs = 0.5 and μk = 0.4.
    let hoop = Hoop::new(HoopParameters::thin(1.0).with_friction(0.5, 0.4))?;

    // The particle is level with the centre, and the hoop turns counterclockwise.
    let start = Start::at(std::f64::consts::FRAC_PI_2, 2.0);
    let motion = hoop.simulate(start, Limits::default())?;

    for transition in motion.transitions() {
        let (time, state) = (transition.time(), transition.before);
        println!(
            "τ = {time:.6}  θ = {:.6}  {}",
            state.theta, transition.cause
        );
    }
    println!("{}", motion.outcome().kind());

    let jumps = motion
        .transitions()
        .iter()
        .any(|transition| transition.cause == Cause::LiftOff);
    assert!(jumps, "the hoop leaves the plane without an impact");
    let height = motion.summary().jump_height;
    println!("the rim rises to {height:.6} R");
    assert!(height > 0.0);
    Ok(())
}
