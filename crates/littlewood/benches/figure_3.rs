//! Figure 3 of the paper to lift-off and landing; derivatives of motions.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use littlewood::cases::find_case;
use littlewood::tables::Quantity;
use littlewood::{Hoop, Limits, Start};

fn figure_3(criterion: &mut Criterion) {
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("the hoop of Figure 2");
    let start = Start::at(std::f64::consts::FRAC_PI_2, 2.0);
    criterion.bench_function("figure-3, start to landing", |bencher| {
        bencher.iter(|| black_box(&hoop).simulate(black_box(start), Limits::default()));
    });
}

/// A motion, and its derivatives with respect to one quantity and to two.
fn derivatives(criterion: &mut Criterion) {
    for name in [
        "figure-3",
        "figure-3-bounces",
        "stick-slip-no-jump",
        "rolls-forever",
        "ramp-libration",
    ] {
        let case = find_case(name).expect("a named case");
        let mut group = criterion.benchmark_group(format!("derivatives of {name}"));
        group.bench_function("motion", |bencher| {
            bencher.iter(|| black_box(case).simulate());
        });
        let motion = case.simulate().expect("a motion");
        for quantities in [&[Quantity::MuK][..], &[Quantity::MuK, Quantity::Theta]] {
            group.bench_function(format!("{} of them", quantities.len()), |bencher| {
                bencher.iter(|| black_box(&motion).derivatives(quantities));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, figure_3, derivatives);
criterion_main!(benches);
