//! Problems in either system of units, and what is refused.

use littlewood::si::{SiParameters, SiSetup, SiState};
use littlewood::tables::{SampleColumn, Setup};
use littlewood::{HoopParameters, Start};
use littlewood_web::{Motion, Problem};

use crate::support::{numbers, si_numbers};

fn si() -> SiSetup {
    SiSetup {
        hoop: SiParameters {
            disc_mass_kg: 1.5,
            particle_mass_kg: 0.5,
            radius_m: 2.0,
            offset_m: 1.0,
            inertia_kg_m2: 3.0,
            gravity_m_per_s2: 8.0,
            mu_s: 0.5,
            mu_k: 0.4,
            slope: 0.125,
            ..SiParameters::default()
        },
        start: SiState {
            theta_rad: 0.25,
            theta_rate_rad_per_s: 6.0,
            slip_m_per_s: 1.0,
            gap_rate_m_per_s: 2.0,
            x_m: 4.0,
            time_s: 3.0,
        },
    }
}

#[test]
fn a_problem_in_si_units_has_the_quotients_of_2_9() {
    // m2 = 0.5, R = 2, g = 8: the unit of time is 1/2, that of velocity 4, that of inertia 2, that
    // of impulse 2.
    let problem = Problem::si(
        &si_numbers(&si()),
        Some(0.25),
        Some("newton".to_owned()),
        Some(5.0),
    )
    .unwrap();
    let hoop = HoopParameters::thin(3.0)
        .with_offset(0.5)
        .with_inertia(1.5)
        .with_friction(0.5, 0.4)
        .with_slope(0.125);
    let start = Start::at(0.25, 3.0)
        .with_slip(0.25)
        .with_gap_rate(0.5)
        .with_x(2.0)
        .with_time(6.0);
    assert_eq!(
        problem.to_dimensionless(),
        numbers(&Setup::new(hoop, start))
    );
    assert_eq!(problem.to_si(0.5, 2.0, 8.0).unwrap(), si_numbers(&si()));
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
    let mut given = si();
    let right = si_numbers(&given);
    assert_eq!(refused(&right, Some(2.0)).quantity, "until_s");
    assert_eq!(refused(&right[..right.len() - 1], None).quantity, "time_s");
    given.hoop.offset_m = 2.5;
    assert_eq!(refused(&si_numbers(&given), None).quantity, "offset_m");
    let point_mass = HoopParameters::thin(1.0)
        .with_offset(0.0)
        .with_inertia(0.0)
        .with_friction(0.5, 0.4);
    let point_mass = numbers(&Setup::new(point_mass, Start::default()));
    assert_eq!(
        Problem::dimensionless(&point_mass, None, None, None)
            .unwrap_err()
            .quantity,
        "offset"
    );
}

#[test]
fn a_restitution_that_means_nothing_is_refused_and_never_taken_as_none() {
    let refused = |restitution: Option<f64>, law: Option<&str>| {
        Problem::si(
            &si_numbers(&si()),
            restitution,
            law.map(str::to_owned),
            None,
        )
        .unwrap_err()
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
    let massless = HoopParameters::thin(0.0).with_friction(0.5, 0.4);
    let massless = numbers(&Setup::new(massless, Start::at(0.5, 0.0)));
    let refusal = Problem::dimensionless(&massless, Some(0.5), None, None).unwrap_err();
    assert!(refusal.message.contains("massless"), "{}", refusal.message);
}
