//! No call hangs: random hoops, starts and limits over the whole ranges of the quantities, each in bounded time.
//!
//! `LITTLEWOOD_CALLS=100000 cargo test --release -p littlewood bounded:: -- --nocapture` follows so many and prints how
//! long they took; `LITTLEWOOD_FIRST_CALL` is the number of the first.
#![allow(clippy::panic)] // a failed expectation

use std::collections::BTreeMap;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, Start};

/// Seconds of a processor that a call may take; builds for tests are slower than those for use.
const LONGEST: f64 = if cfg!(debug_assertions) { 10.0 } else { 1.0 };

/// After so long without an answer on a machine with other work to do, a call is said to hang.
const PATIENCE: Duration = Duration::from_secs(120);

/// Numbers from xorshift64*.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..8 {
            random.unit();
        }
        random
    }

    /// From 0 to 1.
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From 10^low to 10^high, each size as likely as the others.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        libm::pow(10.0, low + (high - low) * self.unit())
    }

    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    /// A parameter: none, of any size up to 10^`most`, of moderate size, or one.
    fn parameter(&mut self, most: f64) -> f64 {
        match self.below(5) {
            0 => 0.0,
            1 => self.size(-12.0, most),
            2 => self.size(-3.0, most.min(1.0)),
            3 => self.unit() * self.size(0.0, most.min(0.5)).min(3.0),
            _ => 1.0,
        }
    }

    /// A number of a start: none, of any size and sign up to 10^`most`, or of at most `usual`.
    fn signed(&mut self, most: f64, usual: f64) -> f64 {
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        match self.below(4) {
            0 => 0.0,
            1 => sign * self.size(-12.0, most),
            _ => sign * usual * self.unit(),
        }
    }
}

/// A call, with what it was asked.
struct Call {
    hoop: HoopParameters,
    start: Start,
    limits: Limits,
}

impl Call {
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let rough = if random.below(5) == 0 { 9.0 } else { 0.2 };
        let mut hoop =
            HoopParameters::new(random.parameter(9.0), random.parameter(0.0), random.parameter(9.0));
        let mu_s = random.parameter(rough);
        let mu_k = match random.below(4) {
            0 => mu_s,
            1 => 0.0,
            2 => mu_s * random.unit(),
            _ => mu_s * random.size(-9.0, 0.0),
        };
        hoop = hoop.with_friction(mu_s, mu_k);
        if random.below(2) == 0 {
            let coefficient = match random.below(4) {
                0 => 0.0,
                1 => 1.0,
                2 => 1.0 - random.size(-12.0, 0.0),
                _ => random.unit(),
            };
            hoop = hoop.with_restitution(coefficient, RestitutionLaw::ALL[random.below(3)]);
        }
        let (theta, rate) = (random.signed(9.0, 7.0), random.signed(6.0, 5.0));
        let mut start = Start::at(theta, rate).with_slip(random.signed(6.0, 3.0));
        if random.below(5) == 0 && hoop.mass_ratio + hoop.inertia > 0.0 {
            start = start.with_gap_rate(random.size(-9.0, 6.0));
        }
        let until = match random.below(3) {
            0 => None,
            1 => Some(50.0),
            _ => Some(random.size(-3.0, 12.0)),
        };
        Self { hoop, start, limits: Limits::default().with_until(until) }
    }

    /// How it ended, or that the hoop was refused, and the seconds of a processor that it took.
    fn answer(&self) -> (String, f64) {
        let Ok(hoop) = Hoop::new(self.hoop) else { return ("refused".to_owned(), 0.0) };
        let begin = clock();
        let name = match hoop.simulate(self.start, self.limits) {
            Ok(motion) => motion.outcome().kind().to_string(),
            Err(_) => "refused".to_owned(),
        };
        (name, clock() - begin)
    }

    fn words(&self) -> String {
        format!("{:?} {:?} {:?}", self.hoop, self.start, self.limits)
    }
}

/// Seconds that this thread has had of a processor, to some milliseconds, where the system tells; else those that have passed.
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
    std::env::var(name).ok().map_or(default, |text| text.parse().expect("a number"))
}

#[test]
fn every_call_comes_back() {
    let (first, calls) = (number("LITTLEWOOD_FIRST_CALL", 1), number("LITTLEWOOD_CALLS", 400));
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
            Err(RecvTimeoutError::Timeout) => panic!("call {seed} hangs: {}", Call::new(seed).words()),
            Err(RecvTimeoutError::Disconnected) => panic!("call {seed} panics: {}", Call::new(seed).words()),
        };
        assert!(seconds < LONGEST, "call {seed} takes {seconds} s, {outcome}: {}", Call::new(seed).words());
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
