//! Problems in either system of units, and what is refused.

use littlewood::tables::SampleColumn;
use littlewood_web::{Motion, Problem};

/// m1, m2, R, ℓ, Izz, g, μs, μk, α, θ, dθ/dt, dη/dt, rate of the gap, x, t.
const SI: [f64; 15] = [
    1.5, 0.5, 2.0, 1.0, 3.0, 8.0, 0.5, 0.4, 0.125, 0.25, 6.0, 1.0, 2.0, 4.0, 3.0,
];

const POINT_MASS: [f64; 12] = [1.0, 0.0, 0.0, 0.5, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

#[test]
fn a_problem_in_si_units_has_the_quotients_of_2_9() {
    // m2 = 0.5, R = 2, g = 8: the unit of time is 1/2, that of velocity 4, that of inertia 2, that
    // of impulse 2.
    let problem = Problem::si(&SI, Some(0.25), Some("newton".to_owned()), Some(5.0)).unwrap();
    assert_eq!(
        problem.to_dimensionless(),
        [
            3.0, 0.5, 1.5, 0.5, 0.4, 0.125, 0.25, 3.0, 0.25, 0.5, 2.0, 6.0
        ]
    );
    assert_eq!(problem.to_si(0.5, 2.0, 8.0).unwrap(), SI);
    assert_eq!(Motion::new(&problem, None).unwrap().horizon(), 10.0);
    assert_eq!(
        (problem.restitution(), problem.restitution_law().as_deref()),
        (Some(0.25), Some("newton"))
    );
    assert_eq!(problem.impulse_unit(), 2.0);
    let units = problem.column_units();
    let unit = |column: SampleColumn| units[usize::from(column.code())];
    assert_eq!(
        [SampleColumn::Time, SampleColumn::Slip, SampleColumn::Mode].map(unit),
        [0.5, 4.0, 1.0]
    );
}

#[test]
fn a_refusal_names_the_quantity_that_was_given() {
    let refused =
        |numbers: &[f64], until: Option<f64>| Problem::si(numbers, None, None, until).unwrap_err();
    let mut numbers = SI;
    assert_eq!(refused(&numbers, Some(2.0)).quantity, "until_s");
    assert_eq!(refused(&numbers[..14], None).quantity, "time_s");
    numbers[3] = 2.5;
    assert_eq!(refused(&numbers, None).quantity, "offset_m");
    assert_eq!(
        Problem::dimensionless(&POINT_MASS, None, None, None)
            .unwrap_err()
            .quantity,
        "offset"
    );
}

#[test]
fn a_restitution_that_means_nothing_is_refused_and_never_taken_as_none() {
    let refused = |restitution: Option<f64>, law: Option<&str>| {
        Problem::si(&SI, restitution, law.map(str::to_owned), None).unwrap_err()
    };
    for (restitution, law, message) in [
        (
            Some(f64::NAN),
            None,
            "restitution = NaN must be a finite number",
        ),
        (
            Some(1.5),
            Some("newton"),
            "restitution = 1.5 must not exceed 1",
        ),
        (Some(-0.1), None, "restitution = -0.1 must not be negative"),
        (
            None,
            Some("poisson"),
            "restitution_law = poisson without restitution",
        ),
        (
            Some(0.5),
            Some("hooke"),
            "there is no law of restitution named 'hooke'",
        ),
    ] {
        let refusal = refused(restitution, law);
        assert_eq!(refusal.quantity, "restitution");
        assert!(refusal.message.starts_with(message), "{}", refusal.message);
        assert!(!refusal.hint.is_empty());
    }
    let massless = [0.0, 1.0, 0.0, 0.5, 0.4, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0];
    let refusal = Problem::dimensionless(&massless, Some(0.5), None, None).unwrap_err();
    assert!(refusal.message.contains("massless"), "{}", refusal.message);
}
