//! The fuzzer: random motions, commands, scenario files, lists and damaged stores. Nothing may
//! panic, hang, end with a wrong exit code or write what cannot be read.
//!
//! Among the tests it runs the same few cases every time. By hand it runs for as long as it is told
//! to:
//!
//! ```sh
//! LITTLEWOOD_FUZZ_SECONDS=3600 LITTLEWOOD_FUZZ_SEED=$RANDOM cargo test -p littlewood-cli --all-features fuzz:: -- --nocapture
//! ```
//!
//! A case that fails is told with what reproduces it; `LITTLEWOOD_FUZZ_CASE=stores:17` (with the
//! same seed) runs it alone.

mod commands;
mod damage;
mod lists;
mod motions;
mod program;
mod scenarios;
mod stores;

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use littlewood_random::Draw;

/// The seed without `LITTLEWOOD_FUZZ_SEED`.
const SEED: u64 = 2019;

/// A case that takes longer hangs, on the slowest machine.
const HANGS: Duration = Duration::from_secs(300);

/// Motions and commands that take longer are told of.
const SLOW: Duration = Duration::from_secs(1);

/// Failures after which it is over.
const ENOUGH: usize = 10;

/// What came of a case: a word for the statistics, or what is wrong.
type Verdict = Result<&'static str, String>;

/// A case, with what it leaves behind for a person who wants to see it again.
struct Case {
    draw: Draw,
    /// A folder of its own.
    folder: PathBuf,
    /// What reproduces it: a command, or the name of a file.
    told: Told,
}

/// What a case has told of itself, kept where it outlives a hang.
#[derive(Clone, Default)]
struct Told(std::sync::Arc<std::sync::Mutex<String>>);

impl Told {
    fn tell(&self, text: impl Into<String>) {
        *self.0.lock().expect("no case panics here") = text.into();
    }

    fn text(&self) -> String {
        self.0.lock().expect("no case panics here").clone()
    }
}

#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    run: fn(&mut Case) -> Verdict,
    /// Cases without `LITTLEWOOD_FUZZ_SECONDS`.
    cases: u64,
}

const KINDS: [Kind; 5] = [
    Kind {
        name: "motions",
        run: motions::run,
        cases: 300,
    },
    Kind {
        name: "commands",
        run: commands::run,
        cases: 200,
    },
    Kind {
        name: "scenarios",
        run: scenarios::run,
        cases: 100,
    },
    Kind {
        name: "lists",
        run: lists::run,
        cases: 500,
    },
    Kind {
        name: "stores",
        run: stores::run,
        cases: 50,
    },
];

#[derive(Default)]
struct Statistics {
    cases: u64,
    time: Duration,
    slowest: Duration,
    /// How often each verdict came.
    verdicts: BTreeMap<&'static str, u64>,
}

fn variable<T: FromStr>(name: &str) -> Option<T> {
    Some(env::var(name).ok()?.parse().ok().expect(name))
}

/// Runs a case with an eye on the clock.
fn run(
    kind: Kind,
    seed: u64,
    number: u64,
    folder: &Path,
) -> (Result<&'static str, Failure>, Duration, Told) {
    let stream = kind
        .name
        .bytes()
        .fold(0, |sum, byte| sum * 31 + u64::from(byte));
    let folder = folder.join(format!("{}-{number}", kind.name));
    fs::create_dir_all(&folder).expect("a folder");
    let told = Told::default();
    let mut case = Case {
        draw: Draw::of_case(seed, stream, number),
        folder: folder.clone(),
        told: told.clone(),
    };
    let (sender, receiver) = channel();
    let begun = Instant::now();
    thread::spawn(move || {
        let verdict = catch_unwind(AssertUnwindSafe(|| (kind.run)(&mut case)));
        // Nobody listens any more to a case that has hung.
        let _ = sender.send(verdict);
    });
    let verdict = match receiver.recv_timeout(HANGS) {
        Ok(Ok(Ok(word))) => Ok(word),
        Ok(Ok(Err(message))) => Err(Failure {
            message,
            hangs: false,
        }),
        Ok(Err(_)) => Err(Failure {
            message: "it panicked; see above".to_owned(),
            hangs: false,
        }),
        Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => Err(Failure {
            message: format!("it hangs: {HANGS:?} are over"),
            hangs: true,
        }),
    };
    if verdict.is_ok() {
        fs::remove_dir_all(&folder).expect("its folder");
    }
    (verdict, begun.elapsed(), told)
}

struct Failure {
    message: String,
    hangs: bool,
}

#[test]
#[ignore = "thorough"]
fn nothing_panics_hangs_or_lies() {
    let seed = variable("LITTLEWOOD_FUZZ_SEED").unwrap_or(SEED);
    let budget = variable("LITTLEWOOD_FUZZ_SECONDS").map(Duration::from_secs_f64);
    // What fails stays there.
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{seed}"));
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("an old folder");
    }
    if let Some(case) = variable::<String>("LITTLEWOOD_FUZZ_CASE") {
        let (name, number) = case.split_once(':').expect("KIND:NUMBER");
        let kind = KINDS
            .into_iter()
            .find(|kind| kind.name == name)
            .expect("a kind");
        let (verdict, took, told) = run(kind, seed, number.parse().expect("a number"), &folder);
        println!("{}\n{took:?}", told.text());
        assert!(
            verdict.is_ok(),
            "{}",
            verdict
                .err()
                .map(|failure| failure.message)
                .unwrap_or_default()
        );
        return;
    }
    let begun = Instant::now();
    let mut statistics = KINDS.map(|_| Statistics::default());
    let (mut failures, mut slow) = (Vec::new(), Vec::new());
    while failures.len() < ENOUGH {
        // Each kind gets its number of cases, or the same share of the time.
        let next = match budget {
            Some(budget) if begun.elapsed() > budget => None,
            Some(_) => (0..KINDS.len()).min_by_key(|&i| statistics[i].time),
            None => (0..KINDS.len()).find(|&i| statistics[i].cases < KINDS[i].cases),
        };
        let Some(next) = next else { break };
        let (kind, of_kind) = (KINDS[next], &mut statistics[next]);
        let number = of_kind.cases;
        let (verdict, took, told) = run(kind, seed, number, &folder);
        of_kind.cases += 1;
        of_kind.time += took;
        of_kind.slowest = of_kind.slowest.max(took);
        let name = format!("{}:{number}", kind.name);
        match verdict {
            Ok(word) => *of_kind.verdicts.entry(word).or_default() += 1,
            Err(Failure { message, hangs }) => {
                failures.push(format!("{name}: {message}\n    {}", told.text()));
                if hangs {
                    // What hangs would slow down all that follows.
                    break;
                }
            }
        }
        if took > SLOW && matches!(kind.name, "motions" | "commands") {
            slow.push(format!("{name}: {took:.1?}  {}", told.text()));
        }
    }
    println!("seed {seed}, {:.0?}", begun.elapsed());
    for (kind, of_kind) in KINDS.iter().zip(&statistics) {
        let verdicts: Vec<String> = of_kind
            .verdicts
            .iter()
            .map(|(word, count)| format!("{count} {word}"))
            .collect();
        println!(
            "{:9}  {:7} cases  slowest {:>8.1?}  {}",
            kind.name,
            of_kind.cases,
            of_kind.slowest,
            verdicts.join(", ")
        );
    }
    for line in &slow {
        println!("slow: {line}");
    }
    assert!(
        failures.is_empty(),
        "LITTLEWOOD_FUZZ_SEED={seed}; files stay in {}\n{}",
        folder.display(),
        failures.join("\n")
    );
    fs::remove_dir_all(&folder).expect("its folder");
}
