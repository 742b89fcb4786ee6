//! A record of one's own: the work of friction, computed from samples of each slide, beside the
//! library's ledger of energy.

use littlewood::{Hoop, HoopParameters, Limits, Mode, ParameterError, Phase, Start};

/// What we record of a phase.
struct Record {
    mode: Mode,
    duration: f64,
    /// ∫ F η′ dτ, the work of friction (negative).
    work: f64,
    /// The largest |F|/N.
    friction_needed: f64,
}

impl Record {
    /// Samples a phase at equal times; Simpson's rule gives the integral.
    fn of(phase: &Phase) -> Self {
        let count = 200;
        let step = phase.duration() / f64::from(count);
        let (mut work, mut friction_needed) = (0.0, 0.0_f64);
        for i in 0..=count {
            let sample = phase.sample(step * f64::from(i));
            let weight = match i {
                0 => 1.0,
                i if i == count => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            work += weight * step / 3.0 * sample.friction * sample.state.slip;
            if sample.normal > 0.0 {
                friction_needed = friction_needed.max(sample.friction.abs() / sample.normal);
            }
        }
        Self {
            mode: phase.mode(),
            duration: phase.duration(),
            work,
            friction_needed,
        }
    }
}

fn main() -> Result<(), ParameterError> {
    let hoop = Hoop::new(HoopParameters::thin(1.0).with_friction(0.5, 0.4))?;
    let motion = hoop.simulate(
        Start::at(std::f64::consts::FRAC_PI_2, 2.0),
        Limits::default(),
    )?;

    let records: Vec<Record> = motion.phases().iter().map(Record::of).collect();
    for record in &records {
        println!(
            "{:8} for {:.4}: work of friction {:+.6}, |F|/N up to {:.4}",
            record.mode.name(),
            record.duration,
            record.work,
            record.friction_needed
        );
    }
    let lost: f64 = records.iter().map(|record| -record.work).sum();
    println!("lost {lost:.9}; by the library {:.9}", motion.energy_lost());
    assert!((lost - motion.energy_lost()).abs() < 1e-8);
    Ok(())
}
