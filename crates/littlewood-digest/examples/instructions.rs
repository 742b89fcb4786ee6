//! How many instructions a motion costs, counted by valgrind: the same number each time, so that it
//! tells what a change costs where seconds would tell of the machine. `check` counts, and compares
//! with evidence/bench/instructions.txt; `write` writes that anew; `run WORK PASSES` is what is
//! counted.

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;
use std::hint::black_box;
use std::process::{Command, ExitCode};
use std::thread;

use littlewood::{Engine, Hoop, HoopParameters, Limits, Restitution, RestitutionLaw, Start};

type Failure = Box<dyn std::error::Error + Send + Sync>;

const TABLE: &str = "evidence/bench/instructions.txt";

/// By what part of itself a count may differ from the table.
const TOLERANCE: f64 = 0.02;

/// How a work computes its motions.
#[derive(Clone, Copy)]
enum Method {
    /// [`Hoop::simulate`], one by one.
    Simulation,
    /// An engine that is prepared before the first pass is counted.
    Prepared,
    /// The same, which interpolates chains of slips.
    Interpolated,
    /// An engine made in each pass, for as many starts as there are.
    List,
    /// The same, which interpolates, as sweeps do.
    InterpolatedList,
}

/// Motions that are computed in each pass.
struct Work {
    name: &'static str,
    method: Method,
    hoop: fn() -> Result<Hoop, littlewood::ParameterError>,
    starts: fn() -> Vec<Start>,
    limits: fn() -> Limits,
}

const WORKS: [Work; 18] = [
    Work {
        name: "figure-3",
        method: Method::Prepared,
        hoop: figure_2,
        starts: || vec![Start::at(FRAC_PI_2, 2.0); 1_000],
        limits: Limits::default,
    },
    Work {
        name: "figure-3-simulated",
        method: Method::Simulation,
        hoop: figure_2,
        starts: || vec![Start::at(FRAC_PI_2, 2.0); 50],
        limits: Limits::default,
    },
    Work {
        name: "map",
        method: Method::Prepared,
        hoop: figure_2,
        starts: || plane(60),
        limits: || Limits::until(50.0),
    },
    Work {
        name: "map-interpolated",
        method: Method::Interpolated,
        hoop: figure_2,
        starts: || plane(60),
        limits: || Limits::until(50.0),
    },
    Work {
        name: "list-of-256",
        method: Method::List,
        hoop: figure_2,
        starts: || plane(16),
        limits: Limits::default,
    },
    Work {
        name: "list-of-256-interpolated",
        method: Method::InterpolatedList,
        hoop: figure_2,
        starts: || plane(16),
        limits: Limits::default,
    },
    Work {
        name: "bounces",
        method: Method::Prepared,
        hoop: || figure_2()?.with_restitution(Restitution::new(0.5, RestitutionLaw::Energetic)?),
        starts: || plane(16),
        limits: Limits::default,
    },
    Work {
        name: "light",
        method: Method::Prepared,
        hoop: || {
            Hoop::new(
                HoopParameters::thin(0.0)
                    .with_inertia(1e-3)
                    .with_friction(0.5, 0.4),
            )
        },
        starts: || plane(6),
        limits: Limits::default,
    },
    Work {
        name: "little-friction",
        method: Method::Prepared,
        hoop: || Hoop::equal_masses(1e-3, 1e-3),
        starts: || {
            plane(8)
                .into_iter()
                .map(|start| start.with_slip(1.0))
                .collect()
        },
        limits: Limits::default,
    },
    Work {
        name: "little-friction-map",
        method: Method::Prepared,
        hoop: || Hoop::equal_masses(1e-3, 1e-3),
        starts: || cells(30).map(|start| start.with_slip(1.0)).collect(),
        limits: || Limits::until(50.0),
    },
    Work {
        name: "no-friction",
        method: Method::Prepared,
        hoop: || Hoop::equal_masses(0.0, 0.0),
        starts: || plane(16),
        limits: Limits::default,
    },
    Work {
        name: "no-friction-map",
        method: Method::Prepared,
        hoop: || Hoop::equal_masses(0.0, 0.0),
        starts: || cells(30).collect(),
        limits: || Limits::until(50.0),
    },
    Work {
        name: "fast-map",
        method: Method::Prepared,
        hoop: figure_2,
        starts: || {
            let fast = |start: Start| Start::at(start.theta, 25.0 * start.theta_rate);
            cells(60).map(fast).collect()
        },
        limits: || Limits::until(50.0),
    },
    Work {
        name: "gentle-slope",
        method: Method::Prepared,
        hoop: || sloping(0.001),
        starts: || plane(6),
        limits: Limits::default,
    },
    Work {
        name: "gentle-slope-map",
        method: Method::Interpolated,
        hoop: || sloping(0.001),
        starts: || plane(40),
        limits: || Limits::until(50.0),
    },
    Work {
        name: "slope",
        method: Method::Prepared,
        hoop: || sloping(0.3),
        starts: || plane(16),
        limits: Limits::default,
    },
    Work {
        name: "resistance",
        method: Method::Prepared,
        hoop: resisted,
        starts: || vec![Start::at(FRAC_PI_2, 2.0); 1_000],
        limits: Limits::default,
    },
    Work {
        name: "resistance-map",
        method: Method::Prepared,
        hoop: resisted,
        starts: || plane(60),
        limits: || Limits::until(50.0),
    },
];

fn figure_2() -> Result<Hoop, littlewood::ParameterError> {
    Hoop::equal_masses(0.5, 0.4)
}

fn resisted() -> Result<Hoop, littlewood::ParameterError> {
    Hoop::new(figure_2()?.parameters().with_rolling_resistance(0.05))
}

fn sloping(slope: f64) -> Result<Hoop, littlewood::ParameterError> {
    Hoop::new(figure_2()?.parameters().with_slope(slope))
}

/// A square of starts, from −π to π and from −4 to 4.
fn plane(side: u32) -> Vec<Start> {
    let along = |i: u32, from: f64| from * (2.0 * f64::from(i) / f64::from(side - 1) - 1.0);
    (0..side * side)
        .map(|k| Start::at(along(k % side, PI), along(k / side, 4.0)))
        .collect()
}

/// The middles of the cells of such a square: at ±π some motions are special, and in a larger map
/// few.
fn cells(side: u32) -> impl Iterator<Item = Start> {
    let part = 1.0 - 1.0 / f64::from(side);
    let inside = move |start: Start| Start::at(part * start.theta, part * start.theta_rate);
    plane(side).into_iter().map(inside)
}

impl Work {
    fn find(name: &str) -> Result<&'static Self, Failure> {
        let named = WORKS.iter().find(|work| work.name == name);
        named.ok_or_else(|| format!("no work '{name}'").into())
    }

    fn run(&self, passes: usize) -> Result<(), Failure> {
        let (hoop, starts, limits) = ((self.hoop)()?, (self.starts)(), (self.limits)());
        let summaries = |engine: &Engine| -> Result<(), Failure> {
            for start in &starts {
                black_box(engine.summary(*start, limits)?);
            }
            Ok(())
        };
        let builder = Engine::builder(&hoop);
        let prepared = match self.method {
            Method::Interpolated => builder.interpolate_slips().build(),
            Method::Prepared | Method::Simulation | Method::List | Method::InterpolatedList => {
                builder.build()
            }
        };
        let of_list = builder.expected_starts(starts.len() as u64);
        for _ in 0..passes {
            match self.method {
                Method::Simulation => {
                    for start in &starts {
                        black_box(hoop.simulate(*start, limits)?);
                    }
                }
                Method::Prepared | Method::Interpolated => summaries(&prepared)?,
                Method::List => summaries(&of_list.build())?,
                Method::InterpolatedList => summaries(&of_list.interpolate_slips().build())?,
            }
        }
        Ok(())
    }

    /// The instructions of a run with so many passes.
    fn count(&self, passes: usize) -> Result<u64, Failure> {
        // Processors differ in how std copies memory: by the instructions that all have.
        let output = Command::new("valgrind")
            .args(["--tool=cachegrind", "--cache-sim=no", "--branch-sim=no"])
            .arg("--cachegrind-out-file=/dev/null")
            .arg(std::env::current_exe()?)
            .args(["run", self.name, &passes.to_string()])
            .env("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX,-AVX2,-ERMS,-FSRM")
            .output()
            .map_err(|error| format!("valgrind: {error}"))?;
        let text = String::from_utf8_lossy(&output.stderr);
        let count = text
            .lines()
            .find_map(|line| line.split_once("refs:"))
            .and_then(|(_, count)| count.trim().replace(',', "").parse().ok());
        match count {
            Some(count) if output.status.success() => Ok(count),
            _ => Err(format!("{}: {text}", self.name).into()),
        }
    }

    /// The rows of the table: of a start, by what the second pass adds to the first; and of a map
    /// the preparation, by what the first takes longer.
    fn rows(&self) -> Result<Vec<Row>, Failure> {
        let (first, both) = (self.count(1)?, self.count(2)?);
        let pass = both - first;
        let mut rows = vec![Row {
            name: self.name.to_owned(),
            count: pass / (self.starts)().len() as u64,
        }];
        if self.name.starts_with("map") {
            rows.push(Row {
                name: format!("{}-preparation", self.name),
                count: first - pass - self.count(0)?,
            });
        }
        Ok(rows)
    }
}

/// A line of the table.
struct Row {
    name: String,
    count: u64,
}

/// Counts all works, side by side.
fn measured() -> Result<Vec<Row>, Failure> {
    let rows = thread::scope(|scope| {
        let works = WORKS.each_ref().map(|work| scope.spawn(|| work.rows()));
        works.map(|work| {
            work.join()
                .unwrap_or_else(|_| Err("a count has panicked".into()))
        })
    });
    let mut all = Vec::new();
    for rows in rows {
        all.extend(rows?);
    }
    Ok(all)
}

/// The compiler: another makes other instructions.
fn compiler() -> Result<String, Failure> {
    let output = Command::new("rustc").arg("--version").output()?;
    Ok(String::from_utf8(output.stdout)?.trim().to_owned())
}

/// The table, its first line the compiler.
fn table(compiler: &str, rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = format!("# {compiler}\n");
    for Row { name, count } in rows {
        writeln!(text, "{name:<30}{count:>12}")?;
    }
    Ok(text)
}

/// The rows of the committed table.
fn committed(text: &str) -> Result<Vec<Row>, Failure> {
    let row = |line: &str| {
        let (name, count) = line.split_once(' ')?;
        Some(Row {
            name: name.to_owned(),
            count: count.trim().parse().ok()?,
        })
    };
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| row(line).ok_or_else(|| format!("{TABLE}: {line}").into()))
        .collect()
}

/// Compares with the committed table; says by how much each count differs.
fn check() -> Result<ExitCode, Failure> {
    let text = std::fs::read_to_string(TABLE)?;
    let (committed, measured) = (committed(&text)?, measured()?);
    let mut differing = 0;
    for Row { name, count } in &measured {
        let before = committed.iter().find(|row| row.name == *name);
        let change = before.map(|before| *count as f64 / before.count as f64 - 1.0);
        let is_same = change.is_some_and(|change| change.abs() <= TOLERANCE);
        let told = change.map_or("new".to_owned(), |change| {
            format!("{:+.2} %", 100.0 * change)
        });
        let mark = if is_same { "" } else { "  ← differs" };
        println!("{name:<30}{count:>12}{told:>12}{mark}");
        differing += usize::from(!is_same);
    }
    let is_measured = |row: &Row| measured.iter().any(|ours| ours.name == row.name);
    let gone = committed.iter().filter(|row| !is_measured(row));
    for Row { name, .. } in gone {
        println!("{name:<30}{:>24}  ← differs", "gone");
        differing += 1;
    }
    if differing == 0 {
        return Ok(ExitCode::SUCCESS);
    }
    let compiler = compiler()?;
    println!(
        "{differing} counts differ from {TABLE} by more than {} %. If the change is worth what it \
         costs, or saves, run `./test.sh instructions write`, and say why in the message of the \
         commit.",
        100.0 * TOLERANCE
    );
    if !text.starts_with(&format!("# {compiler}\n")) {
        println!("The table was made by another compiler; this is {compiler}.");
    }
    Ok(ExitCode::FAILURE)
}

fn main() -> Result<ExitCode, Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["check"] => return check(),
        ["write"] => {
            let text = table(&compiler()?, &measured()?)?;
            print!("{text}");
            std::fs::write(TABLE, text)?;
        }
        ["run", name, passes] => Work::find(name)?.run(passes.parse()?)?,
        _ => {
            eprintln!("usage: instructions check|write|run WORK PASSES");
            return Ok(ExitCode::from(2));
        }
    }
    Ok(ExitCode::SUCCESS)
}
