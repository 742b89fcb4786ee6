//! How often each outcome occurs among random hoops and starts, and which of them are not proved
//! ends.
//!
//! ```sh
//! cargo run --release -p littlewood-cli --example census -- 1000000 2019 all
//! ```
//!
//! takes the number of motions, the seed, and whether they are drawn from `all` that is allowed,
//! biased to the bounds, or from the `usual` ranges. Every motion is followed without a time limit.
//! The same numbers draw the same motions.

use std::collections::BTreeMap;
use std::env;
use std::error::Error;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use littlewood::tables::Setup;
use littlewood::{Engine, Hoop, Limits, OutcomeKind};
use littlewood_random::{Draw, command};

/// Examples of each outcome that is no end.
const EXAMPLES: usize = 12;

/// Motions that a thread takes at a time.
const SOME: u64 = 64;

/// A motion that takes longer is told of.
const SLOW: Duration = Duration::from_secs(1);

#[derive(Default)]
struct Census {
    counts: BTreeMap<&'static str, u64>,
    /// Number and setup of motions that did not come to an end.
    open: BTreeMap<&'static str, Vec<(u64, Setup)>>,
    slow: Vec<(Duration, u64, Setup)>,
}

impl Census {
    fn add(&mut self, number: u64, setup: Setup) {
        let begun = Instant::now();
        let summary = Hoop::new(setup.hoop).and_then(|hoop| {
            Engine::builder(&hoop)
                .expected_starts(1)
                .build()
                .summary(setup.start, Limits::default())
        });
        let took = begun.elapsed();
        let Ok(outcome) = summary.map(|summary| summary.outcome) else {
            *self.counts.entry("contradicts itself").or_default() += 1;
            return;
        };
        *self.counts.entry(outcome.name()).or_default() += 1;
        if took > SLOW {
            self.slow.push((took, number, setup));
        }
        if matches!(
            outcome,
            OutcomeKind::TransitionLimit | OutcomeKind::StepLimit | OutcomeKind::Unresolved
        ) {
            self.open
                .entry(outcome.name())
                .or_default()
                .push((number, setup));
        }
    }

    fn absorb(&mut self, other: Self) {
        for (name, count) in other.counts {
            *self.counts.entry(name).or_default() += count;
        }
        for (name, setups) in other.open {
            self.open.entry(name).or_default().extend(setups);
        }
        self.slow.extend(other.slow);
    }
}

/// The motions whose turn it is, until there are no more.
fn follow(next: &AtomicU64, total: u64, seed: u64, is_usual: bool) -> Census {
    let mut census = Census::default();
    loop {
        let first = next.fetch_add(SOME, Ordering::Relaxed);
        if first >= total {
            return census;
        }
        for number in first..total.min(first + SOME) {
            let mut draw = Draw::of_case(seed, 0, number);
            let setup = if is_usual { draw.usual() } else { draw.setup() };
            census.add(number, setup);
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let [total, seed, range] = &words[..] else {
        return Err("give a number, a seed, and all or usual".into());
    };
    let (total, seed, is_usual) = (total.parse()?, seed.parse()?, range == "usual");
    let begun = Instant::now();
    let next = AtomicU64::new(0);
    let threads = thread::available_parallelism()?.get();
    let mut census = Census::default();
    let parts: Vec<_> = thread::scope(|scope| {
        let threads: Vec<_> = (0..threads)
            .map(|_| scope.spawn(|| follow(&next, total, seed, is_usual)))
            .collect();
        threads
            .into_iter()
            .map(thread::ScopedJoinHandle::join)
            .collect()
    });
    for part in parts {
        census.absorb(part.map_err(|_| "a thread panicked")?);
    }
    println!(
        "{total} motions, seed {seed}, {range}: {:.0?} on {threads} threads",
        begun.elapsed()
    );
    let mut counts: Vec<_> = census.counts.into_iter().collect();
    counts.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
    for (name, count) in counts {
        println!(
            "{name:20} {count:9} {:8.4} %",
            100.0 * count as f64 / total as f64
        );
    }
    for (name, mut setups) in census.open {
        setups.sort_by_key(|&(number, _)| number);
        println!("\n{name}, the first of {}:", setups.len());
        for (number, setup) in setups.iter().take(EXAMPLES) {
            println!("{number}: {}", command(setup, Limits::default()));
        }
    }
    census
        .slow
        .sort_by_key(|&(took, _, _)| std::cmp::Reverse(took));
    println!("\nlonger than {SLOW:?}: {}", census.slow.len());
    for (took, number, setup) in census.slow.iter().take(EXAMPLES) {
        println!(
            "{took:.1?}  {number}: {}",
            command(setup, Limits::default())
        );
    }
    Ok(())
}
