//! The engine: one motion, a plane of starts of the Figure 2 hoop, and one benchmark for each
//! regime of docs/engine.md.

use std::f64::consts::PI;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use littlewood::{Engine, Hoop, HoopParameters, Limits, Restitution, RestitutionLaw, Start};

fn engine(criterion: &mut Criterion) {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    criterion.bench_function("preparation of the Figure 2 hoop", |bencher| {
        bencher.iter(|| Engine::new(black_box(&hoop)));
    });
    let engine = Engine::new(&hoop);
    let start = Start::at(PI / 2.0, 2.0);
    criterion.bench_function("figure-3, prepared, start to landing", |bencher| {
        bencher.iter(|| black_box(&engine).summary(black_box(start), Limits::default()));
    });
    let rolls = Start::at(0.0, 0.5);
    for until in [10.0, 1e6] {
        criterion.bench_function(&format!("state of a rolling hoop at {until}"), |bencher| {
            let motion = hoop
                .simulate(rolls, Limits::default())
                .expect("a valid start");
            bencher.iter(|| black_box(&motion).at(black_box(until)));
        });
    }

    const SIDE: u32 = 200;
    let along = |i: u32, from: f64| from * (2.0 * f64::from(i) / f64::from(SIDE - 1) - 1.0);
    let starts: Vec<Start> = (0..SIDE * SIDE)
        .map(|k| Start::at(along(k % SIDE, PI), along(k / SIDE, 4.0)))
        .collect();
    let mut group = criterion.benchmark_group("plane of Figure 2 to the final outcome");
    group
        .throughput(Throughput::Elements(starts.len() as u64))
        .sample_size(20);
    group.bench_function("engine", |bencher| {
        bencher.iter(|| {
            starts
                .iter()
                .filter_map(|s| engine.summary(*s, Limits::default()).ok())
                .count()
        });
    });
    for (e, name) in [(0.0, "engine, e = 0"), (0.5, "engine, e = 0.5, to rest")] {
        let restitution = Restitution::new(e, RestitutionLaw::Energetic).expect("a coefficient");
        let engine = Engine::new(&hoop.with_restitution(restitution).expect("heavy"));
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                starts
                    .iter()
                    .filter_map(|s| engine.summary(*s, Limits::default()).ok())
                    .count()
            });
        });
    }
    group.finish();
}

/// Starts over the plane of (θ, θ′), or of (θ, η′) at a rate, in an order that does not favour a
/// part of it.
fn scattered(count: u32, start: impl Fn(f64, f64) -> Start) -> Vec<Start> {
    let part = |x: f64| 2.0 * (x - x.floor()) - 1.0;
    (0..count)
        .map(|k| {
            start(
                PI * part(0.618_034 * f64::from(k)),
                4.0 * part(0.754_877_7 * f64::from(k) + 0.3),
            )
        })
        .collect()
}

/// One benchmark a regime: starts of one hoop, and hoops with one start each.
fn regimes(criterion: &mut Criterion) {
    const COUNT: u32 = 256;
    let mut group = criterion.benchmark_group("regimes");
    group
        .throughput(Throughput::Elements(u64::from(COUNT)))
        .sample_size(10);
    let thin = |mass_ratio: f64, mu_s: f64, mu_k: f64| {
        HoopParameters::thin(mass_ratio).with_friction(mu_s, mu_k)
    };
    let light = |inertia: f64| {
        HoopParameters::thin(0.0)
            .with_inertia(inertia)
            .with_friction(0.5, 0.4)
    };
    for (name, parameters) in [
        ("figure 2", thin(1.0, 0.5, 0.4)),
        (
            "massless",
            HoopParameters::thin(0.0).with_friction(0.5, 0.4),
        ),
        ("no friction", thin(1.0, 0.0, 0.0)),
        ("mu_k = 0", thin(1.0, 0.5, 0.0)),
        ("equal coefficients", thin(1.0, 0.5, 0.5)),
        ("nearly equal coefficients", thin(1.0, 0.5, 0.49)),
        (
            "P ≤ 0 somewhere",
            HoopParameters::thin(0.2)
                .with_inertia(0.1)
                .with_friction(1.5, 1.4),
        ),
        ("P ≤ 0 and equal coefficients", thin(1.0 / 3.0, 1.0, 1.0)),
        ("thin", thin(0.05, 0.5, 0.4)),
        ("light, 1e-2", light(1e-2)),
        ("light, 1e-3", light(1e-3)),
    ] {
        let engine = Engine::new(&Hoop::new(parameters).expect("a hoop"));
        let starts = scattered(COUNT, Start::at);
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                starts
                    .iter()
                    .filter_map(|s| engine.summary(*s, Limits::default()).ok())
                    .count()
            });
        });
    }
    for mu in [0.05, 1e-2, 1e-3] {
        let engine = Engine::new(&Hoop::equal_masses(mu, mu).expect("a hoop"));
        let starts = scattered(COUNT, |theta, theta_rate| {
            Start::at(theta, theta_rate).with_slip(1.0)
        });
        group.bench_function(format!("little friction, {mu}"), |bencher| {
            bencher.iter(|| {
                starts
                    .iter()
                    .filter_map(|s| engine.summary(*s, Limits::default()).ok())
                    .count()
            });
        });
    }
    let engine = Engine::new(&Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2"));
    let starts = scattered(COUNT, |theta, slip| Start::at(theta, 0.0).with_slip(slip));
    group.bench_function("angle against slip", |bencher| {
        bencher.iter(|| {
            starts
                .iter()
                .filter_map(|s| engine.summary(*s, Limits::default()).ok())
                .count()
        });
    });
    let part = |x: f64| x - x.floor();
    let hoops = |make: &dyn Fn(f64, f64) -> HoopParameters| -> Vec<Hoop> {
        (0..COUNT)
            .filter_map(|k| {
                Hoop::new(make(
                    part(0.618_034 * f64::from(k)),
                    part(0.754_877_7 * f64::from(k)),
                ))
                .ok()
            })
            .collect()
    };
    for (name, hoops) in [
        (
            "mu_s against mass ratio",
            hoops(&|x, y| thin(0.01 + 3.0 * x, 0.41 + 1.5 * y, 0.4)),
        ),
        (
            "offset against inertia",
            hoops(&|x, y| {
                HoopParameters::thin(1.0)
                    .with_offset(0.01 + 0.99 * x)
                    .with_inertia(0.1 + 2.0 * y)
                    .with_friction(0.5, 0.4)
            }),
        ),
    ] {
        let start = Start::at(PI / 2.0, 2.0);
        let summary = |hoop: &Hoop| {
            Engine::builder(hoop)
                .expected_starts(1)
                .build()
                .summary(start, Limits::default())
                .ok()
        };
        group.bench_function(name, |bencher| {
            bencher.iter(|| hoops.iter().filter_map(summary).count());
        });
    }
    group.finish();
}

criterion_group!(benches, engine, regimes);
criterion_main!(benches);
