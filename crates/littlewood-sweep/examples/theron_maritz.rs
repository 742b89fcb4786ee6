//! The sequences of phases of the first turn, in the set-up of Theron and Maritz: from the top, rolling, μs = μk, over
//! eccentricity, friction and angular velocity, for a hoop with g = R = m1 = Izz = 1 and a particle of mass 3.

use littlewood::{HoopParameters, Start};
use littlewood_sweep::{Atlas, Axis, Coordinate, Grid, Options, Point, Workers};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args().nth(1).map_or(Ok(60), |count| count.parse())?;
    let third = 1.0 / 3.0;
    let hoop = HoopParameters { mass_ratio: third, offset: 0.5, inertia: third, mu_s: 0.5, mu_k: 0.0 };
    let grid = Grid::new(
        Point { hoop, start: Start::at(0.0, 0.0) },
        vec![
            Axis::new(Coordinate::Offset, 0.02, 1.0, count)?,
            Axis::new(Coordinate::MuS, 0.02, 1.5, count)?,
            Axis::new(Coordinate::ThetaRate, 0.02, 2.0, count)?,
        ],
    )?;
    let atlas = Atlas::of_first_turns(&grid, &Workers::new(None)?, &Options::default())?;
    let mut sequences: Vec<_> = atlas.entries.iter().map(|entry| entry.sequence).collect();
    sequences.sort_unstable();
    sequences.dedup();
    println!(
        "{} points, {} sequences, {} with their ends",
        atlas.points,
        sequences.len(),
        atlas.entries.len()
    );
    for entry in &atlas.entries {
        println!(
            "{:>9}  {:<22} {:<10}  offset {:.4}  mu {:.4}  rate {:.4}",
            entry.count,
            entry.sequence,
            entry.stop.map_or("", littlewood_sweep::Stop::name),
            entry.example.hoop.offset,
            entry.example.hoop.mu_s,
            entry.example.start.theta_rate,
        );
    }
    Ok(())
}
