//! This project's library: answers each line, a benchmark and a whole number, with one line of
//! JSON.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::hint::black_box;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use littlewood::{Engine, Hoop, Limits, Outcome, OutcomeKind, ParameterError, Start, Summary};

fn main() -> Result<(), Box<dyn Error>> {
    let hoop = Hoop::equal_masses(0.5, 0.4)?;
    let engine = Engine::new(&hoop);
    for line in std::io::stdin().lines() {
        let line = line?;
        let (name, number) = line.split_once(' ').ok_or("a name and a number")?;
        let number: u32 = number.parse()?;
        let rows = match name {
            "trajectory" => trajectory(&hoop, &engine)?,
            "map" => map(&hoop, &engine, number),
            "final" => {
                let summary = |start| engine.summary(start, Limits::default());
                vec![timed_map(&summary, "Engine", number).0]
            }
            "rolling" => rolling(&hoop, f64::from(number))?,
            "threads" => [1, 2].map(|threads| threaded(&engine, number, threads)).to_vec(),
            other => return Err(format!("no benchmark {other}").into()),
        };
        println!("[{}]", rows.join(", "));
    }
    Ok(())
}

/// Median processor time of a call in batches, for about half a second.
fn median_seconds<T>(mut call: impl FnMut() -> T, batch: u32) -> f64 {
    let mut samples = Vec::new();
    let begin = ProcessTime::now();
    while begin.elapsed().as_secs_f64() < 0.5 {
        let start = ProcessTime::now();
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
    let (slip, lift) = (summary.first_slip_time, summary.lift_off_time);
    Ok(vec![
        format!(
            r#"{{"name": "Engine", "seconds": {engine_seconds:e}, "times": [null, {slip:?}, {lift:?}]}}"#
        ),
        format!(r#"{{"name": "Hoop::simulate", "seconds": {simulate_seconds:e}, "times": {events:?}}}"#),
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

/// What finds the summary of a start.
type Summarise<'a> = &'a (dyn Fn(Start) -> Result<Summary, ParameterError> + Sync);

/// The outcomes of the grid of starts. Each thread takes the next row that none has taken.
fn grid(summary: Summarise<'_>, cells: usize, threads: usize) -> Vec<u8> {
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
                summary(start).map_or(b'9', |summary| digit(&summary))
            });
            rows.push((row, outcomes.collect::<Vec<u8>>()));
        }
    };
    let mut rows: Vec<(usize, Vec<u8>)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("no row panics")).collect()
    });
    rows.sort_unstable();
    rows.into_iter().flat_map(|(_, outcomes)| outcomes).collect()
}

fn record(name: &str, time: Duration, outcomes: &[u8]) -> String {
    let counts =
        [b'0', b'1', b'2', b'9'].map(|code| outcomes.iter().filter(|&&outcome| outcome == code).count());
    format!(r#"{{"name": "{name}", "seconds": {:e}, "counts": {counts:?}}}"#, time.as_secs_f64())
}

/// The processor time of the map, and its outcomes.
fn timed_map(summary: Summarise<'_>, name: &str, cells: u32) -> (String, Vec<u8>) {
    let begin = ProcessTime::now();
    let outcomes = grid(summary, cells as usize, 1);
    (record(name, begin.elapsed(), &outcomes), outcomes)
}

/// Cells across a map that is simulated, too, at most: it takes as long as all other rounds.
const SIMULATED: u32 = 200;

/// The map to τ = 50.
fn map(hoop: &Hoop, engine: &Engine, cells: u32) -> Vec<String> {
    let limits = Limits::until(50.0);
    let measured = |summary: Summarise<'_>, name: &str| {
        let (mut row, outcomes) = timed_map(summary, name, cells);
        row.pop();
        format!(r#"{row}, "outcomes": "{}"}}"#, String::from_utf8_lossy(&outcomes))
    };
    let mut rows = vec![measured(&|start| engine.summary(start, limits), "Engine")];
    if cells <= SIMULATED {
        let simulated = |start| hoop.simulate(start, limits).map(|motion| motion.summary());
        rows.push(measured(&simulated, "Hoop::simulate"));
    }
    rows
}

/// What the map takes of the clock on the wall.
fn threaded(engine: &Engine, cells: u32, threads: usize) -> String {
    let summary = |start| engine.summary(start, Limits::default());
    let begin = Instant::now();
    let outcomes = grid(&summary, cells as usize, threads);
    record(&format!("{threads}"), begin.elapsed(), &outcomes)
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
