//! Maps of the plane.

use core::f64::consts::PI;

use littlewood::cases::find_case;
use littlewood::tables::{Class, Quantity, Setup};
use littlewood::{Cause, Engine, Hoop, HoopParameters, Limits, Mode, Start};
use littlewood_web::hops::CLASSES;
use littlewood_web::{MapSubject, OutcomeMap, Problem, class_of};

/// Figure 2, with another friction, slip and coefficient of restitution.
fn figure_2(friction: [f64; 2], start: Start, restitution: Option<f64>) -> Problem {
    of_setup(
        HoopParameters::thin(1.0).with_friction(friction[0], friction[1]),
        start,
        restitution,
    )
}

fn of_setup(hoop: HoopParameters, start: Start, restitution: Option<f64>) -> Problem {
    let setup = Setup::new(hoop, start);
    let quantities = Quantity::HOOP.into_iter().chain(Quantity::START);
    let numbers: Vec<f64> = quantities
        .filter(|it| *it != Quantity::Restitution)
        .filter_map(|it| setup.get(it))
        .collect();
    Problem::dimensionless(&numbers, restitution, None, None).unwrap()
}

fn plain() -> Problem {
    figure_2([0.5, 0.4], Start::default(), None)
}

/// All codes of a map.
fn codes(problem: &Problem, rate: f64, side: usize, subject: MapSubject) -> Vec<u8> {
    let mut map = OutcomeMap::new(problem, rate, side, subject);
    map.compute(1, 0, map.rows(1));
    map.classes(1)
}

fn class(code: u8) -> Class {
    Class::try_from(code).unwrap()
}

/// The start of a cell of a map of rates below 4.
fn start_of(cell: usize, side: usize) -> Start {
    let centre = |i: usize| ((2 * i + 1) as f64 - side as f64) / side as f64;
    Start::at(PI * centre(cell % side), -4.0 * centre(cell / side))
}

#[test]
fn levels_end_with_every_start_and_the_folded_half_is_right() {
    let mut map = OutcomeMap::new(&plain(), 4.0, 64, MapSubject::Outcome);
    assert_eq!(map.rows(1), 32);
    for stride in [8, 4, 2, 1] {
        map.compute(stride, 0, map.rows(stride));
    }
    let engine = Engine::new(&Hoop::figure_2(0.5, 0.4).unwrap());
    for (cell, code) in map.classes(1).into_iter().enumerate() {
        let summary = engine
            .summary(start_of(cell, 64), Limits::default().with_transitions(200))
            .unwrap();
        assert_eq!(class(code), Class::of(&summary), "{cell}");
    }
}

/// Who jumps is the same whether a motion is followed to its end or to the proof that it never
/// will.
#[test]
fn long_motions_are_followed_until_they_cannot_lift_off() {
    let thin = HoopParameters::thin(1.0);
    let light = HoopParameters::thin(0.0)
        .with_inertia(0.03)
        .with_friction(0.5, 0.4);
    for (parameters, is_long) in [
        (thin.with_friction(0.5, 0.4), false),
        (thin.with_friction(0.05, 0.04), true),
        (light, true),
    ] {
        let hoop = Hoop::new(parameters).unwrap();
        let mut in_contact = 0;
        let problem = of_setup(parameters, Start::default(), None);
        for (cell, code) in codes(&problem, 4.0, 24, MapSubject::Outcome)
            .into_iter()
            .enumerate()
        {
            let motion = hoop
                .simulate(start_of(cell, 24), Limits::default())
                .unwrap();
            let lifts_off = motion
                .phases()
                .iter()
                .any(|phase| phase.mode() == Mode::Flight);
            assert_eq!(
                class(code).stays_in_contact(),
                !lifts_off,
                "{:?} {cell}",
                class(code)
            );
            in_contact += usize::from(class(code) == Class::InContact);
        }
        assert_eq!(in_contact > 0, is_long, "{parameters:?}");
    }
}

#[test]
fn a_coarse_level_fills_the_map() {
    for slip in [0.0, 0.5] {
        let problem = figure_2([0.5, 0.4], Start::default().with_slip(slip), None);
        let mut map = OutcomeMap::new(&problem, 4.0, 32, MapSubject::Outcome);
        map.compute(8, 0, map.rows(8));
        assert!(!map.classes(8).contains(&Class::NotComputed.code()));
    }
}

#[test]
fn footnote_3_leaves_at_once_and_the_bottom_rolls_for_ever() {
    let classes = codes(&plain(), 4.2, 101, MapSubject::Outcome);
    assert_eq!(classes[2 * 101 + 50], Class::LeavesAtOnce.code());
    assert_eq!(classes[50 * 101], Class::RollsForever.code());
}

#[test]
fn one_motion_has_the_class_of_its_cell() {
    for (cell, code) in codes(&plain(), 4.0, 24, MapSubject::Outcome)
        .into_iter()
        .enumerate()
    {
        let alone = class(class_of(&figure_2([0.5, 0.4], start_of(cell, 24), None)));
        let mapped = class(code);
        assert!(
            mapped == alone || mapped.stays_in_contact() && alone.stays_in_contact(),
            "{cell}"
        );
    }
}

#[test]
fn hops_are_the_landings_of_each_motion() {
    let parameters = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let hoop =
        Hoop::new(parameters.with_restitution(0.3, littlewood::RestitutionLaw::Energetic)).unwrap();
    let problem = figure_2([0.5, 0.4], Start::default(), Some(0.3));
    for (cell, code) in codes(&problem, 4.0, 16, MapSubject::Hops)
        .into_iter()
        .enumerate()
    {
        let motion = hoop
            .simulate(start_of(cell, 16), Limits::default())
            .unwrap();
        let count = motion
            .transitions()
            .iter()
            .filter(|it| it.cause == Cause::Landing)
            .count();
        assert_eq!(usize::from(code), count.min(254), "{cell}");
    }
}

#[test]
fn without_restitution_no_motion_lands_twice() {
    assert!(
        codes(&plain(), 4.0, 32, MapSubject::Hops)
            .into_iter()
            .all(|code| code <= 1)
    );
}

#[test]
fn restitution_changes_the_outcome_only_where_it_jams() {
    let outcomes = |problem: &Problem| codes(problem, 4.0, 32, MapSubject::Outcome);
    let bouncing = figure_2([0.5, 0.4], Start::default(), Some(0.5));
    assert_eq!(outcomes(&bouncing), outcomes(&plain()));
    let Setup { hoop, start } = find_case("jam").unwrap().setup;
    let with = outcomes(&of_setup(hoop, start, hoop.restitution));
    let without = outcomes(&of_setup(hoop, start, None));
    let jams = with
        .iter()
        .zip(&without)
        .filter(|(with, without)| with != without);
    assert!(jams.clone().count() > 0);
    assert!(
        jams.map(|(_, without)| *without)
            .all(|without| without == Class::Painleve.code())
    );
}

/// The classes of so many hops, by how often each occurs.
fn classes(counts: impl IntoIterator<Item = (u8, usize)>) -> Vec<[u8; 2]> {
    let codes: Vec<u8> = counts
        .into_iter()
        .flat_map(|(count, often)| vec![count; often])
        .collect();
    OutcomeMap::hop_classes(&codes)
        .chunks_exact(2)
        .map(|pair| [pair[0], pair[1]])
        .collect()
}

#[test]
fn few_counts_are_a_class_each() {
    let few = classes([(0, 900), (1, 5), (4, 1), (30, 7), (u8::MAX, 3)]);
    assert_eq!(few, [[0, 0], [1, 1], [4, 4], [30, 30]]);
    assert!(classes([]).is_empty());
}

#[test]
fn many_counts_are_in_classes_of_about_equal_size() {
    let even = classes((0..=80).map(|count| (count, if count == 0 { 5000 } else { 10 })));
    assert_eq!(even.len(), CLASSES);
    assert_eq!(even[0], [0, 0]);
    for (i, class) in even[1..].iter().enumerate() {
        let least = 1 + 10 * i as u8;
        assert_eq!(*class, [least, least + 9]);
    }
    // A count that most starts have gets a class of its own; classes do not overlap.
    let uneven = classes((1..=40).map(|count| (count, if count == 26 { 90_000 } else { 11 })));
    assert_eq!(uneven.len(), CLASSES);
    assert!(
        uneven
            .windows(2)
            .all(|pair| pair[0][0] <= pair[0][1] && pair[0][1] + 1 == pair[1][0])
    );
    assert_eq!((uneven[0][0], uneven[CLASSES - 1][1]), (1, 40));
}
