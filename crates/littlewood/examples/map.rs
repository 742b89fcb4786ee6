//! A map of outcomes in the terminal: 72 × 24 starts of a hoop, each followed to its end.

use littlewood::{Engine, Hoop, HoopParameters, Limits, OutcomeKind, Start};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let hoop = Hoop::new(HoopParameters::thin(1.0).with_friction(0.5, 0.4))?;
    let (columns, rows) = (72, 24);

    // An engine keeps what the motions of one hoop share; its results are those of `simulate`.
    let engine = Engine::builder(&hoop)
        .expected_starts(columns * rows)
        .build();
    let start = |row: u64, column: u64| {
        let theta = -std::f64::consts::PI + std::f64::consts::TAU * column as f64 / columns as f64;
        Start::at(theta, 4.0 - 8.0 * row as f64 / (rows - 1) as f64)
    };

    let mut endless = 0;
    for row in 0..rows {
        let starts = (0..columns).map(|column| start(row, column));
        let mut line = String::new();
        for summary in engine.summaries(starts, Limits::default()) {
            line.push(match summary?.outcome {
                OutcomeKind::RollsForever => {
                    endless += 1;
                    '·'
                }
                OutcomeKind::Landing => '#',
                _ => '?',
            });
        }
        println!("{line}");
    }
    println!(
        "# jumps and lands   · rolls for ever ({endless} of {})",
        columns * rows
    );
    assert!(endless > 0 && endless < columns * rows);
    Ok(())
}
