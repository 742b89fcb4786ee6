//! The engine: one motion, and a plane of starts of the Figure 2 hoop.

use std::f64::consts::PI;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use littlewood::{Engine, Hoop, Limits, Restitution, RestitutionLaw, Start};

fn engine(criterion: &mut Criterion) {
    let hoop = Hoop::figure_2(0.5, 0.4).expect("the hoop of Figure 2");
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
            let motion = hoop.simulate(rolls, Limits::default()).expect("a valid start");
            bencher.iter(|| black_box(&motion).at(black_box(until)));
        });
    }

    const SIDE: u32 = 200;
    let along = |i: u32, from: f64| from * (2.0 * f64::from(i) / f64::from(SIDE - 1) - 1.0);
    let starts: Vec<Start> =
        (0..SIDE * SIDE).map(|k| Start::at(along(k % SIDE, PI), along(k / SIDE, 4.0))).collect();
    let mut group = criterion.benchmark_group("plane of Figure 2 to the final outcome");
    group.throughput(Throughput::Elements(starts.len() as u64)).sample_size(20);
    group.bench_function("engine", |bencher| {
        bencher.iter(|| starts.iter().filter_map(|s| engine.summary(*s, Limits::default()).ok()).count());
    });
    for (e, name) in [(0.0, "engine, e = 0"), (0.5, "engine, e = 0.5, to rest")] {
        let restitution = Restitution::new(e, RestitutionLaw::Energetic).expect("a coefficient");
        let engine = Engine::new(&hoop.with_restitution(restitution).expect("heavy"));
        group.bench_function(name, |bencher| {
            bencher.iter(|| starts.iter().filter_map(|s| engine.summary(*s, Limits::default()).ok()).count());
        });
    }
    group.finish();
}

criterion_group!(benches, engine);
criterion_main!(benches);
