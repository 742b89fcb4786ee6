//! Sweeps of motions that go on after a landing.

use std::f64::consts::FRAC_PI_2;

use littlewood::tables::{Quantity, Setup, SummaryColumn, SummaryValue};
use littlewood::{Engine, Hoop, HoopParameters, Limits, OutcomeKind, RestitutionLaw, Start};
use littlewood_sweep::{Axis, AxisError, Grid, Workers};

const HOOP: HoopParameters = HoopParameters::thin(1.0).with_friction(0.5, 0.4);

fn start() -> Start {
    Start::at(FRAC_PI_2, 2.0)
}

fn bouncing(e: f64, law: RestitutionLaw) -> Setup {
    Setup::new(HOOP.with_restitution(e, law), start())
}

#[test]
fn an_axis_of_restitution_has_the_motions_of_its_hoops() {
    let axis = Axis::new(Quantity::Restitution, 0.0, 0.5, 6).expect("an axis");
    let grid = Grid::new(Setup::new(HOOP, start()), vec![axis]).expect("a grid");
    let points: Vec<Setup> = grid.points(0..grid.len()).collect();
    let columns = Workers::new(None)
        .expect("workers")
        .compute(points.iter().copied(), Limits::default())
        .expect("computes");
    for (index, point) in points.iter().enumerate() {
        let e = point.get(Quantity::Restitution).expect("a coefficient");
        assert!((e - 0.1 * index as f64).abs() < 1e-15);
        let hoop = Hoop::new(point.hoop).expect("a valid hoop");
        let summary = Engine::builder(&hoop)
            .expected_starts(1)
            .build()
            .summary(point.start, Limits::default())
            .expect("a valid start");
        assert!(summary.landings >= 1 && summary.outcome == OutcomeKind::RollsForever);
        for column in [
            SummaryColumn::Landings,
            SummaryColumn::ImpactEnergyLost,
            SummaryColumn::SettleTime,
        ] {
            assert_eq!(
                column.of(&columns.summary(index)),
                column.of(&summary),
                "{column}"
            );
        }
    }
}

#[test]
fn hoops_with_different_laws_are_different_hoops() {
    let points = RestitutionLaw::ALL.map(|law| bouncing(0.5, law));
    let columns = Workers::new(None)
        .expect("workers")
        .compute(points, Limits::default())
        .expect("computes");
    let lost = [0, 1, 2].map(|index| SummaryColumn::ImpactEnergyLost.of(&columns.summary(index)));
    let [
        SummaryValue::F64(a),
        SummaryValue::F64(b),
        SummaryValue::F64(c),
    ] = lost
    else {
        unreachable!()
    };
    assert!(a != b && b != c && a != c, "{a} {b} {c}");
}

#[test]
fn a_massless_hoop_has_no_restitution_in_a_grid_either() {
    let massless = Setup::new(
        HoopParameters::thin(0.0).with_friction(0.5, 0.4),
        Start::at(0.0, 0.5),
    );
    let axis = Axis::new(Quantity::Restitution, 0.0, 1.0, 3).expect("an axis");
    let refused = Grid::new(massless, vec![axis]).expect_err("must be refused");
    assert!(
        matches!(
            refused,
            AxisError::Value {
                quantity: Quantity::Restitution,
                ..
            }
        ),
        "{refused}"
    );

    // Where both vary, a massless hoop among the others is a point without motion; so is one that
    // is thrown.
    let inertia = || Axis::new(Quantity::Inertia, 0.0, 1.0, 2).expect("an axis");
    let offset = Setup::new(
        HoopParameters::thin(0.0).with_friction(0.5, 0.4),
        Start::at(0.0, 0.5),
    );
    for axis in [Quantity::Restitution, Quantity::GapRate] {
        let axis = Axis::new(axis, 0.25, 0.5, 2).expect("an axis");
        let grid = Grid::new(offset, vec![inertia(), axis]).expect("a grid");
        let points: Vec<Setup> = grid.points(0..grid.len()).collect();
        let columns = Workers::new(None)
            .expect("workers")
            .compute(points.iter().copied(), Limits::until(20.0));
        let columns = columns.expect("computes");
        for (index, point) in points.iter().enumerate() {
            let is_invalid = columns.summary(index).outcome == OutcomeKind::Invalid;
            assert_eq!(is_invalid, point.hoop.inertia == 0.0, "{point:?}");
        }
    }
}
