//! This project's library: answers each line, a benchmark and a whole number, with one line of
//! JSON.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::hint::black_box;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

use littlewood::{Engine, Hoop, Limits, Outcome, OutcomeKind, Start, Summary};

fn main() -> Result<(), Box<dyn Error>> {
    let hoop = Hoop::equal_masses(0.5, 0.4)?;
    let engine = Engine::new(&hoop);
    for line in std::io::stdin().lines() {
        let line = line?;
        let (name, number) = line.split_once(' ').ok_or("a name and a number")?;
        let number: u32 = number.parse()?;
        let rows = match name {
            "trajectory" => trajectory(&hoop, &engine)?,
            "map" => map(&engine, number),
            "final" => vec![timed_map(&engine, "Engine", number, Limits::default(), 1).0],
            "rolling" => rolling(&hoop, f64::from(number))?,
            "threads" => [1, 2].map(|threads| threaded(&engine, number, threads)).to_vec(),
            other => return Err(format!("no benchmark {other}").into()),
        };
        println!("[{}]", rows.join(", "));
    }
    Ok(())
}

/// Median time of a call in batches of a thousand, for about half a second.
fn median_seconds<T>(mut call: impl FnMut() -> T, batch: u32) -> f64 {
    let mut samples = Vec::new();
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.5 {
        let start = Instant::now();
        for _ in 0..batch {
            black_box(call());
        }
        samples.push(start.elapsed().as_secs_f64() / f64::from(batch));
    }
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}

fn trajectory(hoop: &Hoop, engine: &Engine) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Start::at(FRAC_PI_2, 2.0);
    let limits = Limits::default();
    let summary = engine.summary(start, limits)?;
    let motion = hoop.simulate(start, limits)?;
    let events: Vec<f64> =
        motion.transitions().iter().take(3).map(|transition| transition.time()).collect();
    let engine_seconds = median_seconds(|| engine.summary(black_box(start), limits), 1000);
    let simulate_seconds = median_seconds(|| hoop.simulate(black_box(start), limits), 10);
    let prepare_seconds = median_seconds(|| Engine::new(black_box(hoop)), 1);
    let (slip, lift) = (summary.first_slip_time, summary.lift_off_time);
    Ok(vec![
        format!(
            r#"{{"name": "Engine", "seconds": {engine_seconds:e}, "times": [null, {slip:?}, {lift:?}]}}"#
        ),
        format!(r#"{{"name": "Hoop::simulate", "seconds": {simulate_seconds:e}, "times": {events:?}}}"#),
        format!(r#"{{"name": "Engine::new", "seconds": {prepare_seconds:e}, "times": []}}"#),
    ])
}

/// When the hoop leaves the plane: `0` at once, `1` later, `2` not; `9` where the motion has not
/// one continuation.
fn digit(summary: &Summary) -> u8 {
    match summary.outcome {
        OutcomeKind::Landing | OutcomeKind::RollsForever | OutcomeKind::TimeLimit => {
            let lift = summary.lift_off_time;
            if lift.is_nan() {
                b'2'
            } else if lift > 0.0 {
                b'1'
            } else {
                b'0'
            }
        }
        _ => b'9',
    }
}

/// The `index`th of `count` values from `-end` to `end`.
fn value(index: usize, count: usize, end: f64) -> f64 {
    if index + 1 == count { end } else { index as f64 * (2.0 * end / (count - 1) as f64) - end }
}

/// Wall time and outcomes of the grid of starts. Each thread takes the next row that none has
/// taken.
fn grid(engine: &Engine, cells: usize, limits: Limits, threads: usize) -> (f64, Vec<u8>) {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut rows = Vec::new();
        loop {
            let row = next.fetch_add(1, Ordering::Relaxed);
            if row >= cells {
                return rows;
            }
            let rate = value(row, cells, 4.0);
            let outcomes = (0..cells).map(|column| {
                let start = Start::at(value(column, cells, PI), rate);
                engine.summary(start, limits).map_or(b'9', |summary| digit(&summary))
            });
            rows.push((row, outcomes.collect::<Vec<u8>>()));
        }
    };
    let begin = Instant::now();
    let mut rows: Vec<(usize, Vec<u8>)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("no row panics")).collect()
    });
    rows.sort_unstable();
    (begin.elapsed().as_secs_f64(), rows.into_iter().flat_map(|(_, outcomes)| outcomes).collect())
}

/// A measurement of the map, and its outcomes.
fn timed_map(engine: &Engine, name: &str, cells: u32, limits: Limits, threads: usize) -> (String, Vec<u8>) {
    let (seconds, outcomes) = grid(engine, cells as usize, limits, threads);
    let counts =
        [b'0', b'1', b'2', b'9'].map(|code| outcomes.iter().filter(|&&outcome| outcome == code).count());
    (format!(r#"{{"name": "{name}", "seconds": {seconds:e}, "counts": {counts:?}}}"#), outcomes)
}

/// The map to τ = 50.
fn map(engine: &Engine, cells: u32) -> Vec<String> {
    let (mut row, outcomes) = timed_map(engine, "Engine", cells, Limits::until(50.0), 1);
    row.pop();
    vec![format!(r#"{row}, "outcomes": "{}"}}"#, String::from_utf8_lossy(&outcomes))]
}

fn threaded(engine: &Engine, cells: u32, threads: usize) -> String {
    timed_map(engine, &format!("{threads}"), cells, Limits::default(), threads).0
}

/// From the start to the state at a time, of a motion that rolls for ever.
fn rolling(hoop: &Hoop, until: f64) -> Result<Vec<String>, Box<dyn Error>> {
    let run = || {
        let motion = hoop.simulate(black_box(Start::at(0.0, 0.5)), Limits::default()).ok()?;
        let for_ever = matches!(motion.outcome(), Outcome::RollsForever { .. });
        motion.at(black_box(until)).filter(|_| for_ever)
    };
    let theta = run().ok_or("the hoop does not roll for ever")?.state.theta;
    let seconds = median_seconds(run, 10);
    Ok(vec![format!(
        r#"{{"name": "Hoop::simulate, Trajectory::at", "seconds": {seconds:e}, "theta": {theta:?}}}"#
    )])
}
