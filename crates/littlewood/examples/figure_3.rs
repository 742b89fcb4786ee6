//! The motion of Figure 3: slides, rolls, slides, jumps. `cargo run --example figure_3`
use littlewood::{Hoop, Limits, ParameterError, Start};

fn main() -> Result<(), ParameterError> {
    let hoop = Hoop::figure_2(0.5, 0.4)?;
    let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
    for phase in motion.phases() {
        println!("{:<8} from {:.17} for {:.17}", phase.mode(), phase.start().time, phase.duration());
    }
    for t in motion.transitions() {
        println!("{t:?}");
    }
    println!("{:?}", motion.outcome());
    Ok(())
}
