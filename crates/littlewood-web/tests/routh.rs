//! Routh's diagrams.

use littlewood::cases::find_case;
use littlewood::impact::{Compliance, ImpactCase};
use littlewood::tables::Setup;
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, RestitutionLaw, Start, Trajectory, Transition,
};
use littlewood_web::{Motion, Routh};

use crate::support::problem_of;

/// A motion and the diagrams of its transitions.
fn diagrams(hoop: Hoop, start: Start, limits: Limits) -> (Trajectory, Vec<Option<Routh>>) {
    let motion = hoop.simulate(start, limits).unwrap();
    let problem = problem_of(&Setup::new(hoop.parameters(), start), limits.until);
    let ours = Motion::new(&problem, None).unwrap();
    let found = (0..motion.transitions().len())
        .map(|index| ours.routh(index))
        .collect();
    (motion, found)
}

fn of_case(name: &str) -> (Trajectory, Vec<Option<Routh>>) {
    let setup = find_case(name).unwrap().setup;
    diagrams(
        Hoop::new(setup.hoop).unwrap(),
        setup.start,
        Limits::default(),
    )
}

#[test]
fn the_first_impact_of_figure_3_has_the_corners_of_the_notes() {
    let (motion, found) = of_case("figure-3-bounces");
    let first = found.iter().position(Option::is_some).unwrap();
    let (impact, routh) = (
        motion.transitions()[first].impact.unwrap(),
        found[first].as_ref().unwrap(),
    );
    assert_eq!(impact.case, ImpactCase::SticksInRestitution);
    // A, B, C, the slip and the gap rate of the notes; σ = −1.
    let (a, b, c) = (
        0.704_169_493_845_475_1,
        -0.082_949_346_429_552_6,
        0.533_700_402_266_253_8,
    );
    let (slip, gap_rate) = (-0.785_244_687_128_996_2_f64, -1.913_012_569_038_374_6);
    let normal = slip.abs() / (0.4 * a + b);
    let way = routh.way();
    assert_eq!(way.len(), 6);
    assert!((way[2] - normal).abs() < 1e-12 && (way[3] - 0.4 * normal).abs() < 1e-12);
    // Slip ends in restitution: the greatest compression is on the first part, J = 0.4 P.
    let [p, j] = routh.greatest_compression()[..] else {
        unreachable!()
    };
    assert!((p + gap_rate / (0.4 * b + c)).abs() < 1e-12 && (j - 0.4 * p).abs() < 1e-12);
    assert_eq!(way[4..], [impact.impulse.normal, impact.impulse.friction]);
}

#[test]
fn every_way_is_that_of_its_impact() {
    let parameters = HoopParameters::thin(0.125).with_friction(0.75, 0.75);
    let mut seen = 0;
    for (e, law) in [
        (0.0, RestitutionLaw::Energetic),
        (0.6, RestitutionLaw::Poisson),
        (0.9, RestitutionLaw::Newton),
    ] {
        let hoop = Hoop::new(parameters.with_restitution(e, law)).unwrap();
        for i in 0..60 {
            let start = Start::at(-3.0 + 0.1 * f64::from(i), 0.3 * f64::from(i % 7) - 1.0)
                .with_gap_rate(0.8)
                .with_slip(0.2);
            seen += check_all(&diagrams(hoop, start, Limits::until(6.0)));
        }
    }
    assert!(seen > 500, "{seen}");
    for name in ["jam", "lands-and-rolls", "two-hops"] {
        assert!(check_all(&of_case(name)) > 0, "{name}");
    }
}

fn check_all((motion, found): &(Trajectory, Vec<Option<Routh>>)) -> usize {
    let pairs = motion.transitions().iter().zip(found);
    let found = pairs.filter_map(|(it, routh)| Some((it, routh.as_ref()?)));
    found
        .inspect(|(it, routh)| check(motion.hoop(), it, routh))
        .count()
}

fn check(hoop: &Hoop, transition: &Transition, routh: &Routh) {
    let impact = transition.impact.unwrap();
    let Compliance { a, b, c, .. } = hoop.compliance(transition.before.theta).unwrap();
    let slip = |p: f64, j: f64| impact.before.slip + a * j + b * p;
    let gap_rate = |p: f64, j: f64| impact.before.gap_rate + b * j + c * p;
    let (way, frame) = (routh.way(), routh.frame());
    let &[.., p, j] = way.as_slice() else {
        unreachable!()
    };
    assert_eq!([p, j], [impact.impulse.normal, impact.impulse.friction]);
    let scale = 1.0 + p.abs() * 10.0;
    assert!((slip(p, j) - impact.after.slip).abs() < 1e-12 * scale);
    assert!((gap_rate(p, j) - impact.after.gap_rate).abs() < 1e-12 * scale);
    if let [_, _, p, j, _, _] = way[..] {
        assert!(slip(p, j).abs() < 1e-12 * scale);
        assert!((j.abs() - hoop.mu_k() * p).abs() < 1e-12 * scale);
    }
    if let [p, j] = routh.greatest_compression()[..] {
        assert!(gap_rate(p, j).abs() < 1e-12 * scale);
    }
    for point in way.chunks_exact(2) {
        assert!(
            (frame[0]..=frame[1]).contains(&point[0]) && (frame[2]..=frame[3]).contains(&point[1])
        );
    }
    if impact.before.gap_rate < 0.0 {
        assert_eq!(routh.line_of_compression().len(), 4);
    }
    // The lines are those of the jumps of the velocities, from one side of the picture to another.
    for (p, j) in ends(&routh.line_of_sticking()) {
        assert!(slip(p, j).abs() < 1e-12 * scale, "{p} {j}");
    }
    for (p, j) in ends(&routh.line_of_compression()) {
        assert!(gap_rate(p, j).abs() < 1e-12 * scale, "{p} {j}");
    }
}

fn ends(line: &[f64]) -> Vec<(f64, f64)> {
    assert!(line.is_empty() || line.len() == 4, "{line:?}");
    line.chunks_exact(2)
        .map(|point| (point[0], point[1]))
        .collect()
}

#[test]
fn bounces_that_settle_have_no_diagram() {
    let (motion, found) = of_case("figure-3-bounces");
    let settle = motion
        .transitions()
        .iter()
        .position(|it| it.cause == Cause::Settle)
        .unwrap();
    assert!(found[settle].is_none());
}

/// The couple bends the lines on which slip and gap rate vanish.
#[test]
fn with_rolling_resistance_a_diagram_has_its_way_alone() {
    let parameters = HoopParameters::thin(1.0)
        .with_friction(0.5, 0.4)
        .with_rolling_resistance(0.2)
        .with_restitution(0.5, RestitutionLaw::Energetic);
    let start = Start::at(1.0, 0.5).with_slip(0.2).with_gap_rate(1.0);
    let hoop = Hoop::new(parameters).unwrap();
    let (motion, found) = diagrams(hoop, start, Limits::until(6.0));
    let mut seen = 0;
    for (transition, routh) in motion.transitions().iter().zip(&found) {
        let Some(routh) = routh else { continue };
        assert!(routh.line_of_sticking().is_empty() && routh.line_of_compression().is_empty());
        let impact = transition.impact.unwrap();
        let way = routh.way();
        assert_eq!(way[..2], [0.0, 0.0]);
        let end = [impact.impulse.normal, impact.impulse.friction];
        assert_eq!(way[way.len() - 2..], end);
        // It springs back with less impulse than it was pressed with.
        let [p, _] = routh.greatest_compression()[..] else {
            unreachable!()
        };
        assert!(0.5 * end[0] < p && p < end[0]);
        seen += 1;
    }
    assert!(seen > 1);
}
