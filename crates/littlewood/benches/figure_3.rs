//! Figure 3 of the paper to lift-off and landing.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use littlewood::{Hoop, Limits, Start};

fn figure_3(criterion: &mut Criterion) {
    let hoop = Hoop::figure_2(0.5, 0.4).expect("the hoop of Figure 2");
    let start = Start::at(std::f64::consts::FRAC_PI_2, 2.0);
    criterion.bench_function("figure-3, start to landing", |bencher| {
        bencher.iter(|| black_box(&hoop).simulate(black_box(start), Limits::default()));
    });
}

criterion_group!(benches, figure_3);
criterion_main!(benches);
