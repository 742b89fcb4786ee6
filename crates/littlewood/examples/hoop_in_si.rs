//! A hoop on a desk in kilograms, metres and seconds: where it lands, and how fast.

use littlewood::si::SiParameters;
use littlewood::tables::Dimension;
use littlewood::{Limits, Outcome, ParameterError, Start};

fn main() -> Result<(), ParameterError> {
    // A hula hoop of 0.4 kg with a battery of 0.14 kg on its rim.
    let (hoop, units) = SiParameters {
        disc_mass_kg: 0.4,
        particle_mass_kg: 0.14,
        radius_m: 0.45,
        offset_m: 0.45,
        inertia_kg_m2: 0.4 * 0.45 * 0.45,
        mu_s: 0.5,
        mu_k: 0.4,
        ..SiParameters::default()
    }
    .to_hoop()?;

    // 12 rad/s; inside the library everything is dimensionless, so the rate is converted.
    let rate = units.from_si(Dimension::AngularRate, 12.0);
    let motion = hoop.simulate(Start::at(1.0, rate), Limits::default())?;

    for transition in motion.transitions() {
        let seconds = units.to_si(Dimension::Time, transition.time());
        println!("{seconds:.4} s  {}", transition.cause);
    }
    let Outcome::Landing { state, gap_rate } = motion.outcome() else {
        println!("{}", motion.outcome().kind());
        return Ok(());
    };
    let metres = units.to_si(Dimension::Length, state.x);
    let speed = units.to_si(Dimension::Velocity, -gap_rate);
    println!("lands at x = {metres:.3} m, the rim falling at {speed:.3} m/s");
    Ok(())
}
