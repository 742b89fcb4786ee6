//! Maps of the plane.

use core::f64::consts::PI;

use littlewood::cases::{CASES, find_case};
use littlewood::tables::{Class, Setup};
use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, Proof, RestitutionLaw, Start};
use littlewood_sweep::Workers;
use littlewood_web::{HOP_CLASSES, MapSubject, OutcomeMap, Problem, class_of, hop_classes};

use crate::support::problem_of;

/// Figure 2, with another friction, slip and coefficient of restitution.
fn figure_2(friction: [f64; 2], start: Start, restitution: Option<f64>) -> Problem {
    let hoop = HoopParameters::thin(1.0).with_friction(friction[0], friction[1]);
    let bouncing = restitution.map(|e| hoop.with_restitution(e, RestitutionLaw::Energetic));
    of_setup(bouncing.unwrap_or(hoop), start)
}

fn of_setup(hoop: HoopParameters, start: Start) -> Problem {
    problem_of(&Setup::new(hoop, start), None)
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

/// Named cases, and what has no mirror image, no end, or no mass.
fn planes() -> Vec<(String, Setup)> {
    let named = CASES
        .iter()
        .map(|case| (case.name.to_owned(), case.setup))
        .collect::<Vec<_>>();
    let thin = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let massless = HoopParameters::thin(0.0).with_friction(0.5, 0.4);
    let bouncing = |e, law| thin.with_restitution(e, law);
    let [at, slips] = [Start::default(), Start::default().with_slip(0.5)];
    let others = [
        ("the slope of a defect", thin.with_slope(0.348), at),
        ("downhill the other way", thin.with_slope(-0.348), at),
        ("a slope that holds nothing", thin.with_slope(0.7), at),
        ("a massless hoop on a slope", massless.with_slope(0.2), at),
        (
            "bounces on a slope",
            bouncing(0.5, RestitutionLaw::Newton).with_slope(-0.2),
            at,
        ),
        (
            "Poisson's bounces",
            bouncing(0.8, RestitutionLaw::Poisson),
            at,
        ),
        ("slip", thin, slips),
        ("slip the other way", thin, at.with_slip(-0.5)),
        ("slip on a slope", thin.with_slope(0.1), slips),
        ("slip of a massless hoop", massless, slips),
        (
            "bounces with slip",
            bouncing(0.3, RestitutionLaw::Energetic),
            slips,
        ),
        (
            "thrown",
            bouncing(0.3, RestitutionLaw::Energetic),
            at.with_gap_rate(0.5),
        ),
        (
            "P <= 0",
            HoopParameters::thin(0.125).with_friction(0.75, 0.75),
            at,
        ),
        ("little friction", thin.with_friction(0.05, 0.04), at),
    ];
    let others = others.map(|(name, hoop, start)| (name.to_owned(), Setup::new(hoop, start)));
    [named, others.to_vec()].concat()
}

/// Classes of the page's map of a plane, level by level, that are not those that the program
/// computes for the start that is shown, and how many cells were compared.
fn compared_with_the_program(name: &str, setup: Setup, side: usize) -> (usize, Vec<String>) {
    let problem = of_setup(setup.hoop, setup.start);
    let points = (0..side * side).map(|cell| {
        let mut setup = setup;
        let Start {
            theta, theta_rate, ..
        } = start_of(cell, side);
        (setup.start.theta, setup.start.theta_rate) = (theta, theta_rate);
        setup
    });
    // The class of bounces is known when the first one lands; downhill they may go on for ever.
    let limits = match setup.hoop.restitution {
        Some(_) => Limits::default().with_transitions(200),
        None => Limits::default(),
    };
    let program = Workers::new(None).unwrap().compute(points, limits).unwrap();
    let program: Vec<Class> = program
        .summaries()
        .map(|summary| Class::of(&summary))
        .collect();

    let mut map = OutcomeMap::new(&problem, 4.0, side, MapSubject::Outcome);
    let is_folded = map.rows(1) < side;
    let (mut compared, mut wrong) = (0, Vec::new());
    for stride in [16, 8, 4, 2, 1] {
        map.compute(stride, 0, map.rows(stride));
        for (cell, code) in map.classes(stride).into_iter().enumerate() {
            let (x, y) = (cell % side, cell / side);
            // A level has every so-manieth start, counted from the corner of its half.
            let shown = |i: usize, is_opposite: bool| match is_opposite {
                true => side - 1 - (side - 1 - i) / stride * stride,
                false => i / stride * stride,
            };
            let is_opposite = is_folded && y >= side / 2;
            let of_program = program[shown(y, is_opposite) * side + shown(x, is_opposite)];
            compared += 1;
            // A motion that is followed only until it is known to stay in contact.
            let is_in_contact = class(code) == Class::InContact && of_program.stays_in_contact();
            if class(code) != of_program && !is_in_contact {
                wrong.push(format!(
                    "{name}, level {stride}, {:?}: {:?}, and {of_program:?} in the program",
                    start_of(cell, side),
                    class(code),
                ));
            }
        }
    }
    (compared, wrong)
}

/// The page shows what `littlewood map` does.
fn check_maps(side: usize) {
    let mut all = Vec::new();
    let mut cells = 0;
    for (name, setup) in planes() {
        let (compared, wrong) = compared_with_the_program(&name, setup, side);
        println!("{name}: {} of {compared} cells differ", wrong.len());
        cells += compared;
        all.extend(wrong);
    }
    assert!(
        all.is_empty(),
        "{} of {cells} cells: {:#?}",
        all.len(),
        &all[..all.len().min(10)]
    );
}

#[test]
fn maps_are_those_of_the_program_cell_by_cell() {
    check_maps(32);
}

#[test]
#[ignore = "thorough"]
fn finer_maps_are_those_of_the_program_cell_by_cell() {
    check_maps(128);
}

#[test]
fn half_a_map_is_computed_only_where_the_other_half_is_its_mirror_image() {
    for (name, setup) in planes() {
        let map = OutcomeMap::new(
            &of_setup(setup.hoop, setup.start),
            4.0,
            32,
            MapSubject::Outcome,
        );
        let is_level_without_slip = setup.hoop.slope == 0.0 && setup.start.slip == 0.0;
        assert_eq!(map.rows(1) == 16, is_level_without_slip, "{name}");
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
        let problem = of_setup(parameters, Start::default());
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
    let with = outcomes(&of_setup(hoop, start));
    let mut free = hoop;
    (free.restitution, free.restitution_law) = (None, None);
    let without = outcomes(&of_setup(free, start));
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
    hop_classes(&codes)
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
    assert_eq!(even.len(), HOP_CLASSES);
    assert_eq!(even[0], [0, 0]);
    for (i, class) in even[1..].iter().enumerate() {
        let least = 1 + 10 * i as u8;
        assert_eq!(*class, [least, least + 9]);
    }
    // A count that most starts have gets a class of its own; classes do not overlap.
    let uneven = classes((1..=40).map(|count| (count, if count == 26 { 90_000 } else { 11 })));
    assert_eq!(uneven.len(), HOP_CLASSES);
    assert!(
        uneven
            .windows(2)
            .all(|pair| pair[0][0] <= pair[0][1] && pair[0][1] + 1 == pair[1][0])
    );
    assert_eq!((uneven[0][0], uneven[HOP_CLASSES - 1][1]), (1, 40));
}

#[test]
fn the_events_of_a_map_are_those_of_its_motions() {
    const SIDE: usize = 12;
    let parameters = HoopParameters::thin(0.25).with_friction(0.5, 0.4);
    for e in [None, Some(0.5)] {
        let bouncing = e.map(|e| parameters.with_restitution(e, RestitutionLaw::Energetic));
        let problem = of_setup(bouncing.unwrap_or(parameters), Start::default());
        let map = OutcomeMap::new(&problem, 4.0, SIDE, MapSubject::Outcome);
        let events: Vec<f64> = (0..SIDE).flat_map(|row| map.events(row, row + 1)).collect();
        let classes = codes(&problem, 4.0, SIDE, MapSubject::Outcome);
        let hoop = Hoop::new(parameters).unwrap();
        let near = |a: f64, b: f64| a.is_nan() && b.is_nan() || (a - b).abs() < 1e-8;
        for (cell, code) in classes.iter().enumerate() {
            let [found, slip, lift_off, end] = events[4 * cell..4 * cell + 4] else {
                panic!("four numbers of each start");
            };
            assert_eq!(found, f64::from(*code), "cell {cell}");
            // Where motions of a map are long they are followed until the proof that they stay.
            let proof = match class(*code) {
                Class::InContact => Proof::Contact,
                _ => Proof::default(),
            };
            let limits = Limits::default().with_transitions(200).with_proof(proof);
            let motion = hoop.simulate(start_of(cell, SIDE), limits).unwrap();
            let first = |mode| {
                let mut phases = motion.phases().iter();
                let phase = phases.find(|phase| phase.mode() == mode);
                phase.map_or(f64::NAN, |phase| phase.start().time)
            };
            assert!(near(slip, first(Mode::Sliding)), "cell {cell}");
            assert!(near(lift_off, first(Mode::Flight)), "cell {cell}");
            let last = motion.outcome().state().time;
            assert!(near(end, last), "cell {cell}: {end}, {last}");
        }
    }
}
