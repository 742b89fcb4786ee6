//! What each part of the solvers earns: the time for the starts of a regime without it, over that
//! with everything.
//!
//! `cargo bench --features ablation --bench ablation` prints a table in Markdown, that of
//! docs/engine.md. A number is the median over rounds of the ratio of times, the two taken one
//! after the other on one thread.

use std::f64::consts::PI;
use std::time::Instant;

use littlewood::ablation::{Part, switch_off};
use littlewood::{Engine, Hoop, HoopParameters, Limits, Restitution, RestitutionLaw, Start};

const ROUNDS: usize = 5;

/// Starts that tell whether a part earns much.
const FEW: usize = 16;

/// One hoop, and starts of it.
struct Regime {
    name: &'static str,
    hoop: HoopParameters,
    slip: f64,
    rate: f64,
    restitution: Option<f64>,
    limits: Limits,
}

impl Regime {
    fn new(name: &'static str, hoop: HoopParameters) -> Self {
        Self {
            name,
            hoop,
            slip: 0.0,
            rate: 4.0,
            restitution: None,
            limits: Limits::default(),
        }
    }

    fn engine(&self) -> Engine {
        let hoop = Hoop::new(self.hoop).expect("a hoop");
        Engine::builder(&match self.restitution {
            Some(e) => {
                let restitution =
                    Restitution::new(e, RestitutionLaw::Energetic).expect("a coefficient");
                hoop.with_restitution(restitution).expect("a heavy hoop")
            }
            None => hoop,
        })
        .interpolate_slips()
        .build()
    }

    /// A grid that is as dense over the plane however many starts there are.
    fn starts(&self, count: usize) -> Vec<Start> {
        let part = |x: f64| 2.0 * (x - x.floor()) - 1.0;
        (0..count)
            .map(|k| {
                let (x, y) = (
                    part(0.618_034 * k as f64),
                    part(0.754_877_7 * k as f64 + 0.3),
                );
                Start::at(PI * x, self.rate * y).with_slip(self.slip)
            })
            .collect()
    }
}

fn regimes() -> Vec<Regime> {
    let thin = |mass_ratio: f64, mu_s: f64, mu_k: f64| {
        HoopParameters::thin(mass_ratio).with_friction(mu_s, mu_k)
    };
    let of = |mass_ratio: f64, offset: f64, inertia: f64, mu_s: f64, mu_k: f64| {
        HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k)
    };
    let figure_2 = || thin(1.0, 0.5, 0.4);
    let until = |time: f64| Limits::default().with_until(Some(time));
    vec![
        Regime::new("Figure 2", figure_2()),
        Regime {
            limits: until(50.0),
            ..Regime::new("Figure 2, to τ = 50", figure_2())
        },
        Regime {
            rate: 100.0,
            ..Regime::new("fast, to θ′ = 100", figure_2())
        },
        Regime {
            restitution: Some(0.0),
            ..Regime::new("e = 0", figure_2())
        },
        Regime {
            restitution: Some(0.5),
            ..Regime::new("e = 0.5", figure_2())
        },
        Regime::new("μk = 0.499", thin(1.0, 0.5, 0.499)),
        Regime::new("μk = 0.4999", thin(1.0, 0.5, 0.4999)),
        Regime::new("μk = 0.1999, slow", of(2.0, 1.0, 0.5, 0.2, 0.1999)),
        Regime::new("μs = μk = 0.5", thin(1.0, 0.5, 0.5)),
        Regime::new("μs = μk = 1, m1 = 1/3", thin(1.0 / 3.0, 1.0, 1.0)),
        Regime::new("P ≤ 0 somewhere", of(0.2, 1.0, 0.1, 1.5, 1.4)),
        Regime::new("rough, μ = 100", thin(1.0, 100.0, 100.0)),
        Regime::new("μk = 0", thin(1.0, 0.5, 0.0)),
        Regime {
            limits: until(50.0),
            ..Regime::new("μk = 0, to τ = 50", thin(1.0, 0.5, 0.0))
        },
        Regime::new("no friction", thin(1.0, 0.0, 0.0)),
        Regime {
            slip: 1.0,
            ..Regime::new("μ = 1e-3, slip 1", thin(1.0, 1e-3, 1e-3))
        },
        Regime {
            slip: 1.0,
            ..Regime::new("μ = 1e-6, slip 1", thin(1.0, 1e-6, 1e-6))
        },
        Regime::new("m1 = 0.01", of(0.01, 1.0, 0.01, 0.5, 0.4)),
        Regime::new("Î = 1e-3", of(0.0, 1.0, 1e-3, 0.5, 0.4)),
        Regime::new("Î = 3e-4", of(0.0, 1.0, 3e-4, 0.5, 0.4)),
    ]
}

/// Seconds that the starts take.
fn time(engine: &Engine, starts: &[Start], limits: Limits) -> f64 {
    let begin = Instant::now();
    let count = starts
        .iter()
        .filter(|start| engine.summary(**start, limits).is_ok())
        .count();
    assert_eq!(count, starts.len());
    begin.elapsed().as_secs_f64()
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn main() {
    let names = Part::ALL.map(|part| format!("{part:?}"));
    println!("| regime | starts/s | {} |", names.join(" | "));
    println!("|---|---:|{}", "---:|".repeat(names.len()));
    for regime in regimes() {
        switch_off(&[]);
        let engine = regime.engine();
        let mut count = FEW;
        while count < 1 << 16 && time(&engine, &regime.starts(count), regime.limits) < 0.05 {
            count *= 2;
        }
        let starts = regime.starts(count);
        let mut rates = Vec::new();
        let ratios = Part::ALL.map(|part| {
            // Where a part earns much, a few starts tell.
            let ratio = |starts: &[Start]| {
                switch_off(&[]);
                let with = time(&engine, starts, regime.limits);
                switch_off(&[part]);
                time(&engine, starts, regime.limits) / with
            };
            let coarse = ratio(&starts[..FEW]);
            if coarse > 8.0 {
                return coarse;
            }
            median(Vec::from_iter((0..ROUNDS).map(|_| {
                switch_off(&[]);
                let with = time(&engine, &starts, regime.limits);
                rates.push(starts.len() as f64 / with);
                switch_off(&[part]);
                time(&engine, &starts, regime.limits) / with
            })))
        });
        let ratios = ratios.map(|ratio| format!("{ratio:.2}"));
        println!(
            "| {} | {:.0} | {} |",
            regime.name,
            median(rates),
            ratios.join(" | ")
        );
    }
}
