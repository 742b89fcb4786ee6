//! No call hangs: random hoops, starts and limits over the whole ranges of the quantities, each in
//! bounded time, and each with a motion that keeps its laws and that the engine sums up alike.
//!
//! `LITTLEWOOD_CALLS=100000 cargo test --release -p littlewood bounded:: -- --nocapture` follows so
//! many and prints how long they took; `LITTLEWOOD_FIRST_CALL` is the number of the first.
#![allow(clippy::panic)] // a failed expectation

use std::collections::BTreeMap;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use crate::invariants::check_laws;
use littlewood::tables::Setup;
use littlewood::theory::Body;
use littlewood::{Engine, Hoop, Limits};
use littlewood_random::{Draw, command};

/// Seconds of a processor that a call may take; builds for tests are slower than those for use.
const LONGEST: f64 = if cfg!(debug_assertions) { 10.0 } else { 1.0 };

/// The laws of longer motions are not checked.
const MOST_PHASES: usize = 60;

/// Seed of all calls.
const SEED: u64 = 2019;

/// After so long without an answer on a machine with other work to do, a call is said to hang.
const PATIENCE: Duration = Duration::from_secs(120);

/// A call: a hoop, a start and limits.
struct Call {
    setup: Setup,
    limits: Limits,
}

impl Call {
    fn new(seed: u64) -> Self {
        let mut draw = Draw::of_case(SEED, 0, seed);
        let setup = draw.setup();
        Self {
            setup,
            limits: draw.limits(setup.start),
        }
    }

    /// How it ended, or that the hoop was refused, and the seconds of a processor that it took.
    fn answer(&self) -> (String, f64) {
        let Ok(hoop) = Hoop::new(self.setup.hoop) else {
            return ("refused".to_owned(), 0.0);
        };
        let begin = clock();
        let Ok(motion) = hoop.simulate(self.setup.start, self.limits) else {
            return ("refused".to_owned(), clock() - begin);
        };
        let seconds = clock() - begin;
        if motion.phases().len() <= MOST_PHASES && matches!(hoop.body(), Body::Heavy(_)) {
            check_laws(&motion).expect("a motion that keeps its laws");
        }
        let engine = Engine::builder(&hoop)
            .expected_starts(1)
            .build()
            .summary(self.setup.start, self.limits)
            .expect("a valid start");
        let kind = motion.outcome().kind();
        assert_eq!(
            (engine.outcome, engine.transitions as usize),
            (kind, motion.transitions().len())
        );
        (kind.to_string(), seconds)
    }

    fn words(&self) -> String {
        command(&self.setup, self.limits)
    }
}

/// Seconds that this thread has had of a processor, to some milliseconds, where the system tells;
/// else those that have passed.
fn clock() -> f64 {
    static BEGIN: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    std::fs::read_to_string("/proc/thread-self/schedstat")
        .ok()
        .and_then(|text| text.split(' ').next()?.parse().ok())
        .map_or_else(
            || BEGIN.get_or_init(Instant::now).elapsed().as_secs_f64(),
            |nanoseconds: f64| 1e-9 * nanoseconds,
        )
}

fn number(name: &str, default: u64) -> u64 {
    std::env::var(name)
        .ok()
        .map_or(default, |text| text.parse().expect("a number"))
}

#[test]
fn every_call_comes_back() {
    let (first, calls) = (
        number("LITTLEWOOD_FIRST_CALL", 1),
        number("LITTLEWOOD_CALLS", 400),
    );
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || {
        for seed in first..first + calls {
            if sender.send(Call::new(seed).answer()).is_err() {
                return;
            }
        }
    });
    let mut times = Vec::new();
    let mut outcomes = BTreeMap::new();
    for seed in first..first + calls {
        let (outcome, seconds) = match receiver.recv_timeout(PATIENCE) {
            Ok(answer) => answer,
            Err(RecvTimeoutError::Timeout) => {
                panic!("call {seed} hangs: {}", Call::new(seed).words())
            }
            Err(RecvTimeoutError::Disconnected) => {
                panic!("call {seed} panics: {}", Call::new(seed).words())
            }
        };
        assert!(
            seconds < LONGEST,
            "call {seed} takes {seconds} s, {outcome}: {}",
            Call::new(seed).words()
        );
        *outcomes.entry(outcome).or_insert(0) += 1;
        times.push(seconds);
    }
    times.sort_by(f64::total_cmp);
    let quantile = |part: f64| times[((times.len() - 1) as f64 * part) as usize];
    println!(
        "{calls} calls: half below {:.1e} s, 90 % {:.1e}, 99 % {:.1e}, 99.9 % {:.1e}, longest {:.2}; {outcomes:?}",
        quantile(0.5),
        quantile(0.9),
        quantile(0.99),
        quantile(0.999),
        quantile(1.0),
    );
}
