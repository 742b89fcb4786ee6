//! The motion of Figure 3: slides, rolls, slides, jumps. `cargo run --example figure_3`

use littlewood::{Hoop, Limits, ParameterError, Start};

fn main() -> Result<(), ParameterError> {
    let hoop = Hoop::figure_2(0.5, 0.4)?;
    let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
    for phase in motion.phases() {
        println!("{:<8} from {:.15} for {:.15}", phase.mode(), phase.start().time, phase.duration());
    }
    Ok(())
}
