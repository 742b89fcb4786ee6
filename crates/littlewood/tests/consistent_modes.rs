//! The modes that are consistent at a state: the decision of the library against Newton's and
//! Euler's equations.

use std::collections::{BTreeMap, BTreeSet};

use crate::common::engines;
use crate::common::newton::{Sizes, agrees, modes, said};
use littlewood::theory::{Body, StartRegion};
use littlewood::{Hoop, Limits, Mode, Outcome, OutcomeKind, Proof, Start};
use littlewood_random::Draw;

/// The page with the table of the sets of modes that may be consistent at once.
const PAGE: &str = include_str!("../../../docs/theory/contact.md");

/// What the sets of modes depend on: the words of the table.
fn situation(hoop: &Hoop, start: &Start) -> [&'static str; 3] {
    [
        if matches!(hoop.body(), Body::Massless(_)) {
            "massless"
        } else {
            "heavy"
        },
        if hoop.slope() == 0.0 {
            "level"
        } else {
            "slope"
        },
        if start.slip == 0.0 { "rest" } else { "slip" },
    ]
}

/// Compares states, and counts the sets of modes where no rounding decides.
fn compare(count: u64) -> (BTreeMap<([&'static str; 3], String), u64>, u64) {
    let mut sets = BTreeMap::new();
    let (mut uncertain, mut wrong) = (0, Vec::new());
    let mut disagreements = 0;
    for case in 0..count {
        let (hoop, start) = Draw::of_case(41, 0, case).in_contact();
        let modes = modes(&hoop, &start);
        let found = hoop.classify(start).expect("a start");
        let theirs = said(&found);
        if !agrees(&modes, &theirs) {
            disagreements += 1;
            if wrong.len() < 5 {
                wrong.push(format!(
                    "{case}: {modes:?}, but {theirs:?}: {hoop:?} {start:?}"
                ));
            }
        }
        if modes.are_certain() {
            *sets
                .entry((situation(&hoop, &start), modes.set()))
                .or_insert(0) += 1;
        } else {
            uncertain += 1;
        }
    }
    println!("{count} states, {uncertain} where rounding may decide, {disagreements} disagree");
    println!("{sets:#?}");
    assert!(wrong.is_empty(), "{disagreements} of {count}: {wrong:#?}");
    (sets, uncertain)
}

/// The rows of the table: body, plane, slip, and the modes.
fn documented() -> BTreeSet<([String; 3], String)> {
    let (_, table) = PAGE
        .split_once("## The modes that are consistent at once")
        .expect("the heading");
    table
        .lines()
        .skip_while(|line| !line.starts_with("|--"))
        .skip(1)
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<_> = line.split('|').map(|cell| cell.trim().to_owned()).collect();
            (
                [1, 2, 3].map(|column| cells[column].clone()),
                cells[4].clone(),
            )
        })
        .collect()
}

fn check(count: u64) {
    let (sets, uncertain) = compare(count);
    assert!(uncertain < count / 8, "{uncertain}");
    let found: BTreeSet<_> = sets
        .into_keys()
        .map(|(situation, modes)| (situation.map(str::to_owned), modes))
        .collect();
    assert_eq!(found, documented());
}

#[test]
fn the_modes_are_those_of_newtons_equations() {
    check(100_000);
}

#[test]
#[ignore = "thorough"]
fn the_modes_of_two_million_states_are_those_of_newtons_equations() {
    check(2_000_000);
}

/// The words and numbers of `classify` are those of the motion.
#[test]
fn what_is_said_of_a_state_is_what_its_motion_does() {
    for case in 0..20_000 {
        let (hoop, start) = Draw::of_case(43, 0, case).in_contact();
        let sizes = Sizes::of(&hoop, &start);
        let said = hoop.classify(start).expect("a start");
        let limits = Limits::until(start.time + 1e-3)
            .with_transitions(1)
            .with_proof(Proof::None);
        let motion = hoop.simulate(start, limits).expect("a start");
        let forces = said.rolling_forces;
        let slack = sizes.friction_excess();
        let margin = hoop.mu_s() * forces.normal - forces.friction.abs();
        let context = || format!("{case}: {said:?} {hoop:?} {start:?}");
        let modes = motion
            .phases()
            .first()
            .map(|phase| (phase.mode(), phase.first()));
        assert_eq!(said.mode, modes.map(|(mode, _)| mode), "{}", context());
        match modes {
            Some((Mode::Rolling, first)) => {
                assert!(
                    (first.normal - forces.normal).abs() <= 2.0 * sizes.normal,
                    "{}",
                    context()
                );
                assert!(
                    (first.friction - forces.friction).abs() <= 2.0 * sizes.friction,
                    "{}",
                    context()
                );
                assert!(
                    forces.normal >= -sizes.normal && margin >= -slack,
                    "{}",
                    context()
                );
                assert_eq!(said.region, StartRegion::Rolling, "{}", context());
            }
            Some((mode, first)) => {
                let holds = start.slip == 0.0 && forces.normal > sizes.normal && margin > slack;
                assert!(!holds, "{}", context());
                let leaves = mode == Mode::Flight;
                assert_eq!(
                    leaves,
                    said.region == StartRegion::LossOfContact,
                    "{}",
                    context()
                );
                assert!(
                    !leaves || said.contact <= sizes.contact / libm::cos(hoop.slope()),
                    "{}",
                    context()
                );
                // Next to w = 0, and to P = 0, it has the sign of rounding.
                let is_rounding = said.contact.abs() <= sizes.contact / libm::cos(hoop.slope())
                    || motion.outcome().kind() == OutcomeKind::Unresolved;
                assert!(first.normal >= 0.0 || is_rounding, "{}", context());
            }
            None => {
                let kind = match motion.outcome() {
                    Outcome::Ambiguous { candidates, .. } => {
                        assert_eq!(Some(candidates), said.candidates, "{}", context());
                        StartRegion::Ambiguous
                    }
                    Outcome::Inconsistent { candidates, .. } => {
                        assert_eq!(Some(candidates), said.candidates, "{}", context());
                        StartRegion::Inconsistent
                    }
                    other => panic!("{other:?}: {}", context()),
                };
                assert_eq!(said.region, kind, "{}", context());
            }
        }
    }
}

/// The engine decides by the same rule.
#[test]
fn an_engine_finds_the_same_modes() {
    let mut ambiguous = 0;
    for case in 0..20_000 {
        let (hoop, start) = Draw::of_case(44, 0, case).in_contact();
        let limits = Limits::until(start.time + 1e-3).with_transitions(1);
        let motion = hoop.simulate(start, limits).expect("a start");
        for engine in engines(&hoop) {
            let summary = engine.summary(start, limits).expect("a start");
            assert_eq!(
                summary.outcome,
                motion.outcome().kind(),
                "{case}: {hoop:?} {start:?}"
            );
        }
        ambiguous += u32::from(motion.outcome().kind() == OutcomeKind::Ambiguous);
    }
    assert!(ambiguous > 100, "{ambiguous}");
}
