//! Bounces on and on: with a coefficient of restitution the hoop goes on after it has landed, and
//! infinitely many bounces end after a finite time.

use littlewood::{Cause, Hoop, HoopParameters, Limits, ParameterError, RestitutionLaw, Start};

fn main() -> Result<(), ParameterError> {
    // The energetic law never gains energy, whatever the friction (Stronge 1990).
    let hoop = Hoop::new(
        HoopParameters::thin(1.0)
            .with_friction(0.5, 0.4)
            .with_restitution(0.5, RestitutionLaw::Energetic),
    )?;
    let motion = hoop.simulate(
        Start::at(std::f64::consts::FRAC_PI_2, 2.0),
        Limits::default(),
    )?;

    for transition in motion.transitions() {
        if let Some(impact) = &transition.impact {
            println!(
                "τ = {:.6}  impact: normal impulse {:.4}, energy lost {:.4}",
                transition.time(),
                impact.impulse.normal,
                impact.energy_lost()
            );
        }
    }
    // The sum of all bounces that follow is one phase.
    let settles = |cause: Cause| cause == Cause::Settle;
    if let Some(end) = motion
        .transitions()
        .iter()
        .find(|transition| settles(transition.cause))
    {
        println!("τ = {:.6}  the bounces have settled", end.time());
    }
    println!("{}", motion.outcome().kind());

    assert!(motion.impact_energy_lost() > 0.0);
    Ok(())
}
