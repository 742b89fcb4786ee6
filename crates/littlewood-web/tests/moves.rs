//! What moves an event.

use std::collections::BTreeMap;

use littlewood::cases::find_case;
use littlewood::derivatives::NoDerivative;
use littlewood::si::{SiParameters, SiSetup, SiState};
use littlewood::tables::Quantity;
use littlewood_web::{Motion, Moves, Problem};
use serde_json::Value;

use crate::support::{problem_of, si_numbers};

const TIME: usize = 0;
const THETA: usize = 1;
const X: usize = 4;

/// By how much a column of the event moves with each quantity; none without a derivative.
fn moved(moves: &Moves, column: usize) -> BTreeMap<Quantity, Option<f64>> {
    let rows: Vec<Value> = serde_json::from_str(&moves.rows(column)).unwrap();
    let row = |row: &Value| {
        (
            row["quantity"].as_str().unwrap().parse().unwrap(),
            row["moved"].as_f64(),
        )
    };
    rows.iter().map(row).collect()
}

fn of(problem: &Problem, transition: usize) -> Moves {
    Moves::of(problem, transition).unwrap()
}

#[test]
fn a_uniform_hoop_that_is_thrown_has_the_moves_of_a_stone() {
    // The mass centre is the centre.
    let (gravity, slope, rate, lift): (f64, f64, f64, f64) = (8.0, 0.25, 3.0, 2.0);
    let si = si_numbers(&SiSetup {
        hoop: SiParameters {
            disc_mass_kg: 1.5,
            particle_mass_kg: 0.5,
            radius_m: 2.0,
            inertia_kg_m2: 3.0,
            gravity_m_per_s2: gravity,
            mu_s: 0.5,
            mu_k: 0.4,
            slope,
            ..SiParameters::default()
        },
        start: SiState {
            theta_rad: 0.5,
            theta_rate_rad_per_s: rate,
            slip_m_per_s: 1.0,
            gap_rate_m_per_s: lift,
            x_m: 4.0,
            ..SiState::default()
        },
    });
    let moves = of(&Problem::si(&si, None, None, None).unwrap(), 0);
    let (sin, cos) = (libm::sin(slope), libm::cos(slope));
    // t = 2 v/(g cos α), θ = θ₀ + θ̇ t.
    let time = 2.0 * lift / (gravity * cos);
    let expected = |quantity| match quantity {
        Quantity::GapRateMPerS => (0.01 * time, 0.01 * rate * time),
        Quantity::GravityMPerS2 => (-0.01 * time, -0.01 * rate * time),
        Quantity::Slope => (
            0.01 * slope * time * sin / cos,
            0.01 * slope * rate * time * sin / cos,
        ),
        Quantity::ThetaRateRadPerS => (0.0, 0.01 * rate * time),
        Quantity::Theta => (0.0, 0.01 * 0.5),
        _ => (0.0, 0.0),
    };
    let [times, angles] = [TIME, THETA].map(|column| moved(&moves, column));
    assert_eq!(times.len(), 14);
    for ((quantity, in_time), (_, in_angle)) in times.into_iter().zip(angles) {
        // With an offset the mass centre is elsewhere.
        if quantity == Quantity::OffsetM {
            continue;
        }
        let (expected_time, expected_angle) = expected(quantity);
        // A few roundings of numbers of this size.
        assert!(
            (in_time.unwrap() - expected_time).abs() <= 8.0 * f64::EPSILON * time,
            "{quantity}: {in_time:?}"
        );
        assert!(
            (in_angle.unwrap() - expected_angle).abs() <= 8.0 * f64::EPSILON * rate * time,
            "{quantity}"
        );
    }
}

#[test]
fn masses_that_grow_together_move_nothing() {
    // Only their ratios are in the equations.
    let si = si_numbers(&SiSetup {
        hoop: SiParameters {
            disc_mass_kg: 0.4,
            particle_mass_kg: 0.14,
            radius_m: 0.45,
            offset_m: 0.45,
            inertia_kg_m2: 0.081,
            gravity_m_per_s2: 9.8,
            mu_s: 0.5,
            mu_k: 0.4,
            slope: 0.1,
            ..SiParameters::default()
        },
        start: SiState {
            theta_rad: 1.2,
            theta_rate_rad_per_s: 6.0,
            ..SiState::default()
        },
    });
    let problem = Problem::si(&si, None, None, None).unwrap();
    let motion = Motion::new(&problem, None).unwrap();
    let moves = of(&problem, motion.transition_sentences().len() - 1);
    for column in [TIME, THETA, X] {
        let masses: Vec<f64> = moved(&moves, column)
            .into_iter()
            .filter(|(quantity, _)| {
                [
                    Quantity::DiscMassKg,
                    Quantity::ParticleMassKg,
                    Quantity::InertiaKgM2,
                ]
                .contains(quantity)
            })
            .map(|(_, moved)| moved.unwrap())
            .collect();
        let size: f64 = masses.iter().map(|it| it.abs()).sum();
        assert!(size > 1e-6);
        // The move by m2 is the sum of the other two, rounded a few times.
        assert!(
            masses.iter().sum::<f64>().abs() <= 8.0 * f64::EPSILON * size,
            "{masses:?}"
        );
    }
}

#[test]
fn what_has_no_derivative_is_last_and_says_why() {
    let setup = find_case("figure-3").unwrap().setup;
    let moves = of(&problem_of(&setup, None), 3);
    let rows: Value = serde_json::from_str(&moves.rows(X)).unwrap();
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 11);
    for row in &rows[9..] {
        assert!(row["moved"].is_null());
        assert_eq!(row["reason"], NoDerivative::OneSided.label());
        assert!(["slip", "gap_rate"].contains(&row["quantity"].as_str().unwrap()));
    }
    let sizes: Vec<f64> = rows[..9]
        .iter()
        .map(|row| row["moved"].as_f64().unwrap().abs())
        .collect();
    assert!(sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
    // α = 0 and χ = 0 are changed by a part of their usual range.
    for (quantity, change) in [("slope", 0.02), ("rolling_resistance", 0.002)] {
        let row = rows.iter().find(|row| row["quantity"] == quantity).unwrap();
        assert_eq!(row["change"], change);
    }
    let first = rows[0]["quantity"]
        .as_str()
        .unwrap()
        .parse::<Quantity>()
        .unwrap();
    let sentence = moves.sentence(X);
    assert!(
        sentence.starts_with(&format!(
            "This event (landing) moves most with {}, the ",
            first.sign()
        )) && sentence.ends_with(" R."),
        "{sentence}"
    );
}
