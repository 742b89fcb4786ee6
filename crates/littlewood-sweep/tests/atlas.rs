//! Which sequences of phases occur.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use crate::support::{map, mixed, workers};
use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, HoopParameters, Limits, Start};
use littlewood_sweep::{Atlas, Axis, FirstTurn, Grid, Options, Stop};

#[test]
fn the_counts_are_those_of_the_simulations_and_examples_have_their_sequence() {
    let (grid, limits) = (mixed(), Limits::until(30.0));
    let options = Options {
        chunk_points: 100,
        ..Options::default()
    };
    let atlas = Atlas::of_motions(&grid, limits, &workers(2), &options).unwrap();
    let mut expected: BTreeMap<String, (u64, u64)> = BTreeMap::new();
    let mut invalid = 0;
    for number in 0..grid.len() {
        let point = grid.point(number);
        match Hoop::new(point.hoop) {
            Ok(hoop) => {
                let sequence = hoop
                    .simulate(point.start, limits)
                    .unwrap()
                    .summary()
                    .sequence;
                expected
                    .entry(sequence.to_string())
                    .or_insert((0, number))
                    .0 += 1;
            }
            Err(_) => invalid += 1,
        }
    }
    assert_eq!((atlas.points, atlas.invalid), (grid.len(), invalid));
    let found: BTreeMap<String, (u64, u64)> = atlas
        .entries
        .iter()
        .map(|entry| (entry.sequence.to_string(), (entry.count, entry.number)))
        .collect();
    assert_eq!(found, expected);
    assert!(
        atlas
            .entries
            .windows(2)
            .all(|pair| pair[0].count >= pair[1].count)
    );
    assert!(
        atlas
            .entries
            .iter()
            .all(|entry| grid.point(entry.number) == entry.example && entry.stop.is_none())
    );
}

#[test]
fn the_size_of_chunks_and_the_threads_do_not_matter() {
    let atlas = |threads, chunk_points| {
        let options = Options {
            chunk_points,
            ..Options::default()
        };
        Atlas::of_motions(&map(30), Limits::until(50.0), &workers(threads), &options).unwrap()
    };
    assert_eq!(atlas(1, 7), atlas(3, 1000));
}

/// The hoop of Theron and Maritz with their particle of mass 3, and one friction.
fn hoop(offset: f64, mu: f64) -> Hoop {
    let third = 1.0 / 3.0;
    Hoop::new(
        HoopParameters::thin(third)
            .with_offset(offset)
            .with_friction(mu, mu),
    )
    .unwrap()
}

#[test]
fn first_turns_end_where_they_must() {
    // Rough and slow: it rolls round, and takes the time that the orbit says.
    let turn = FirstTurn::new(&hoop(0.3, 5.0), Start::at(0.0, 0.3)).unwrap();
    assert_eq!(
        (turn.sequence.to_string(), turn.stop),
        ("R".to_owned(), Stop::Revolution)
    );
    let motion = hoop(0.3, 5.0)
        .simulate(Start::at(0.0, 0.3), Limits::until(turn.time))
        .unwrap();
    assert!((motion.outcome().state().theta.abs() - 0.0).abs() < TAU); // the outcome is where rolling begins
    let end = motion.at(turn.time).unwrap().state;
    assert!((end.theta - TAU).abs() < 1e-9, "{}", end.theta);
    // So fast that 1 < h θ′²: off at once.
    let turn = FirstTurn::new(&hoop(1.0, 0.5), Start::at(0.0, 1.5)).unwrap();
    assert_eq!(
        (turn.sequence.to_string(), turn.stop, turn.time),
        ("F".to_owned(), Stop::LiftsOff, 0.0)
    );
    // At rest on the top nothing happens.
    let turn = FirstTurn::new(&hoop(0.5, 0.5), Start::at(0.0, 0.0)).unwrap();
    assert_eq!(turn.stop, Stop::Never);
    // Started below the top it rocks: θ′ changes sign where the energy of the start is used up, cos
    // θ as at the start.
    let start = Start::at(2.5, 1e-9);
    let turn = FirstTurn::new(&hoop(0.3, 5.0), start).unwrap();
    assert_eq!(
        (turn.sequence.to_string(), turn.stop),
        ("R".to_owned(), Stop::TurnsBack)
    );
    let end = hoop(0.3, 5.0)
        .simulate(start, Limits::until(turn.time))
        .unwrap()
        .at(turn.time)
        .unwrap()
        .state;
    assert!(
        (end.theta - (TAU - 2.5)).abs() < 1e-6 && end.theta_rate.abs() < 1e-6,
        "{end:?}"
    );
}

#[test]
fn mirrored_starts_have_mirrored_first_turns() {
    let mirrored = |text: &str| -> String {
        text.chars()
            .map(|c| match c {
                '+' => '-',
                '-' => '+',
                c => c,
            })
            .collect()
    };
    for i in 1..40 {
        let hoop = hoop(0.025 * f64::from(i), 0.05 + 0.01 * f64::from(i % 7));
        for rate in [0.1, 0.4, 0.9, 1.2] {
            let right = FirstTurn::new(&hoop, Start::at(0.0, rate)).unwrap();
            let left = FirstTurn::new(&hoop, Start::at(0.0, -rate)).unwrap();
            assert_eq!(
                mirrored(&right.sequence.to_string()),
                left.sequence.to_string()
            );
            assert_eq!(
                (right.stop, right.time.to_bits()),
                (left.stop, left.time.to_bits())
            );
        }
    }
}

#[test]
fn the_set_up_of_theron_and_maritz_has_dozens_of_sequences() {
    let base = Setup::new(hoop(0.5, 0.0).parameters(), Start::at(0.0, 0.0));
    let grid = Grid::new(
        base,
        vec![
            Axis::new(Quantity::Offset, 0.05, 1.0, 12).unwrap(),
            Axis::new(Quantity::MuS, 0.02, 0.5, 12).unwrap(),
            Axis::new(Quantity::ThetaRate, 0.05, 1.9, 12).unwrap(),
        ],
    )
    .unwrap();
    let atlas = Atlas::of_first_turns(&grid, &workers(2), &Options::default()).unwrap();
    assert_eq!(
        atlas.entries.iter().map(|entry| entry.count).sum::<u64>(),
        1728
    );
    for entry in &atlas.entries {
        assert_eq!(entry.example.hoop.mu_s, entry.example.hoop.mu_k);
        let hoop = Hoop::new(entry.example.hoop).unwrap();
        let turn = FirstTurn::new(&hoop, entry.example.start).unwrap();
        assert_eq!(
            (turn.sequence, Some(turn.stop)),
            (entry.sequence, entry.stop)
        );
        // From the top nothing but rolling or flight can begin, and with one friction rolling gives
        // way to sliding.
        let text = entry.sequence.to_string();
        assert!(text == "F" || text.starts_with('R'), "{text}");
        assert!(!text.contains("RR") && !text.contains("RF"), "{text}");
    }
    assert!(atlas.entries.len() > 15, "{}", atlas.entries.len());
}
