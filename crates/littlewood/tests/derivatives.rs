//! Derivatives of motions: against central differences with 40 digits
//! (evidence/reference/derivatives.py), conservation laws, symmetries, and the reasons why some do
//! not exist.
#![allow(clippy::panic)] // a failed comparison
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use std::f64::consts::PI;

use crate::common::{heavy_hoop, moderate_hoop, start};
use littlewood::cases::find_case;
use littlewood::derivatives::{Derivatives, EventDerivative, NoDerivative, differentiable};
use littlewood::modes::{GrazingOrbit, Recurrence};
use littlewood::tables::{Quantity, Setup, SummaryColumn, SummaryValue};
use littlewood::theory::{Body, RollingLaw};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Phase, Restitution, RestitutionLaw, Sample,
    Start, State, Summary, Trajectory,
};
use proptest::prelude::*;
use serde_json::Value;

fn numbers(state: &State) -> [f64; 5] {
    [
        state.time,
        state.theta,
        state.theta_rate,
        state.slip,
        state.x,
    ]
}

const fn before(event: EventDerivative) -> State {
    event.before
}

const fn after(event: EventDerivative) -> State {
    event.after
}

fn size(numbers: [f64; 5]) -> f64 {
    numbers
        .into_iter()
        .fold(1.0, |size, number| size.max(number.abs()))
}

/// A light hoop amplifies rounding by the square of the frequency at which it swings, once it
/// passes the bottom.
fn amplification(hoop: &Hoop) -> f64 {
    1.0 + match hoop.body() {
        Body::Heavy(heavy) => heavy.offset / heavy.inertia,
        Body::Massless(_) => 0.0,
    }
}

#[test]
fn derivatives_are_those_of_differences_with_40_digits() {
    let text = include_str!("../../../evidence/reference/derivatives.json");
    let file: Value = serde_json::from_str(text).expect("JSON");
    let motions = file["motions"].as_array().expect("a list");
    let mut compared = 0;
    for (index, row) in motions.iter().enumerate() {
        let mut setup = Setup::new(HoopParameters::thin(1.0), Start::default());
        for (quantities, table) in [
            (&Quantity::HOOP[..], &row["hoop"]),
            (&Quantity::START, &row["start"]),
        ] {
            for quantity in quantities {
                if let Some(value) = table[quantity.name()].as_f64() {
                    setup.set(*quantity, value);
                }
            }
        }
        let law = row["hoop"]["restitution_law"].as_str();
        setup.hoop.restitution_law = law.map(|name| name.parse().expect("a law"));
        let events = row["events"].as_array().expect("a list");
        let limits = Limits::default().with_transitions(events.len());
        let motion = Hoop::new(setup.hoop)
            .expect("a hoop")
            .simulate(setup.start, limits)
            .expect("a start");
        let named = events[0]["before"].as_object().expect("a table");
        let quantities: Vec<Quantity> = named
            .keys()
            .map(|name| name.parse().expect("a quantity"))
            .collect();
        let derivatives = motion.derivatives(&quantities).expect("quantities");
        for (i, event) in events.iter().enumerate() {
            assert_eq!(
                motion.transitions()[i].cause.name(),
                event["cause"].as_str().expect("a cause")
            );
            for (k, quantity) in quantities.iter().enumerate() {
                let ours = derivatives.transitions()[i][k];
                for (when, of) in [
                    ("before", before as fn(EventDerivative) -> State),
                    ("after", after),
                ] {
                    let theirs = event[when][quantity.name()].as_array().expect("numbers");
                    let theirs: [f64; 5] =
                        core::array::from_fn(|n| theirs[n].as_f64().expect("a number"));
                    let ours = numbers(&of(ours.expect("a regular event")));
                    for (ours, theirs_n) in ours.into_iter().zip(theirs) {
                        let error = (ours - theirs_n).abs() / size(theirs);
                        compared += 1;
                        assert!(
                            error < 1e-11 * amplification(motion.hoop()),
                            "{index} {} {i} {} {quantity} {when}: {ours} {theirs_n} {error:e}",
                            row["kind"],
                            event["cause"]
                        );
                    }
                }
            }
        }
    }
    assert!(compared > 20_000, "{compared}");
}

/// The derivatives with respect to all quantities of a motion, and the place of each in the lists.
fn all(motion: &Trajectory) -> (Vec<Quantity>, Derivatives) {
    let bounces = motion.hoop().restitution().is_some();
    let quantities: Vec<Quantity> = differentiable(bounces).collect();
    let derivatives = motion
        .derivatives(&quantities)
        .expect("quantities of the motion");
    (quantities, derivatives)
}

/// The transition that precedes a phase.
fn before_phase(motion: &Trajectory, phase: &Phase) -> Option<usize> {
    motion
        .transitions()
        .iter()
        .position(|it| it.time() == phase.start().time)
}

/// The change of the energy in contact with a state, and the size of its terms.
fn energy_change(hoop: &Hoop, (state, by): (State, State)) -> (f64, f64) {
    let (m, h, inertia) = (
        hoop.mass(),
        hoop.h(),
        hoop.body().inertia_about_mass_centre(),
    );
    let (sin, cos) = state.theta.sin_cos();
    let rate = state.theta_rate;
    let (vx, vy) = (state.slip - (1.0 + h * cos) * rate, -h * sin * rate);
    let dvx = by.slip - (1.0 + h * cos) * by.theta_rate + h * sin * rate * by.theta;
    let dvy = -h * sin * by.theta_rate - h * cos * rate * by.theta;
    let terms = [
        m * vx * dvx,
        m * vy * dvy,
        inertia * rate * by.theta_rate,
        -hoop.offset() * sin * by.theta,
    ];
    (
        terms.into_iter().sum(),
        terms.into_iter().map(f64::abs).sum(),
    )
}

/// A motion of such a hoop, half of them with bounces, and half of them with rolling resistance.
fn motions(hoops: impl Strategy<Value = Hoop>) -> impl Strategy<Value = Trajectory> {
    let resistance = prop_oneof![Just(0.0), 0.01..0.3_f64];
    let restitution = (
        0.1..0.95_f64,
        prop::sample::select(RestitutionLaw::ALL.to_vec()),
    );
    let given = (hoops, start(), restitution, any::<bool>(), resistance);
    given.prop_map(|(hoop, start, (e, law), bounces, chi)| {
        let restitution = Restitution::new(e, law).expect("a coefficient");
        let hoop = Hoop::new(hoop.parameters().with_rolling_resistance(chi)).expect("a hoop");
        let hoop = if bounces {
            hoop.with_restitution(restitution).expect("heavy")
        } else {
            hoop
        };
        let limits = Limits::default()
            .with_transitions(12)
            .with_until(Some(start.time + 50.0));
        hoop.simulate(start, limits).expect("a valid start")
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Time and place of the start shift the motion; a phase conserves what it conserves; and at a
    /// fixed time the state changes by what the event moves.
    #[test]
    fn derivatives_obey_the_laws_of_the_motion(motion in motions(heavy_hoop())) {
        let (quantities, derivatives) = all(&motion);
        let hoop = motion.hoop();
        for (i, transition) in motion.transitions().iter().enumerate() {
            for (k, (quantity, derivative)) in quantities.iter().zip(&derivatives.transitions()[i]).enumerate() {
                let Ok(EventDerivative { before, after, .. }) = *derivative else { continue };
                if *quantity == Quantity::Time {
                    prop_assert_eq!(numbers(&before), [1.0, 0.0, 0.0, 0.0, 0.0]);
                }
                if *quantity == Quantity::X {
                    prop_assert_eq!(numbers(&before), [0.0, 0.0, 0.0, 0.0, 1.0]);
                }
                prop_assert_eq!((before.time, before.theta, before.x), (after.time, after.theta, after.x));
                if matches!(transition.cause, Cause::Stick | Cause::Reversal) {
                    prop_assert_eq!(before.slip, 0.0);
                }
                if transition.cause == Cause::TurningPoint {
                    prop_assert_eq!(before.theta_rate, 0.0);
                }
                if transition.cause == Cause::LiftOff && Quantity::START.contains(quantity) {
                    // 1 = h cos θ θ′² stays 1.
                    let State { theta, theta_rate, .. } = transition.before;
                    let (one, other) = (theta.sin() * theta_rate * before.theta, 2.0 * theta.cos() * before.theta_rate);
                    // What has been rounded at an earlier event was of the size of its derivatives.
                    let earlier = derivatives.transitions()[..=i].iter().filter_map(|row| row[k].ok());
                    let largest = earlier.map(|event| size(numbers(&event.before))).fold(1.0, f64::max);
                    let scale = 1e-11 * amplification(hoop) * (largest + one.abs() + other.abs());
                    prop_assert!((one - other).abs() <= scale, "{quantity} {one} {other}");
                }
                if transition.cause == Cause::Slip && Quantity::START.contains(quantity) {
                    prop_assert_eq!(before.slip, 0.0);
                }
            }
        }
        // Rolling without resistance conserves the energy, and so its derivatives with respect to the
        // start.
        for phase in motion.phases().iter().filter(|_| hoop.rolling_resistance() == 0.0) {
            let (Some(first), Some(last)) = (before_phase(&motion, phase), motion.end_of(phase)) else { continue };
            if phase.mode() != Mode::Rolling {
                continue;
            }
            let index = motion.transitions().iter().position(|it| it == last).expect("its own");
            for (k, quantity) in quantities.iter().enumerate().filter(|(_, quantity)| Quantity::START.contains(quantity)) {
                let pair = (&derivatives.transitions()[first][k], &derivatives.transitions()[index][k]);
                let (Ok(from), Ok(to)) = pair else { continue };
                let ends = [(phase.start(), from.after), (last.before, to.before)];
                let [(one, a), (other, b)] = ends.map(|end| energy_change(hoop, end));
                // Large derivatives have large derivatives of their own, by which the last digits
                // of a state show.
                if size(numbers(&to.before)).max(size(numbers(&from.after))) > 100.0 {
                    continue;
                }
                prop_assert!(
                    (one - other).abs() < 1e-11 * amplification(hoop) * (1.0 + a + b), "{quantity}: {one} {other}");
            }
        }
    }

    /// The derivatives of a summary are those of its differences, as far as two steps agree on
    /// them.
    #[test]
    fn derivatives_of_a_summary_are_those_of_its_differences(motion in motions(moderate_hoop()), slope in prop_oneof![Just(0.0), -0.3..0.3]) {
        let mut setup = Setup::new(motion.hoop().parameters(), Start::default());
        setup.set(Quantity::Slope, slope);
        let limits = Limits::default().with_transitions(8).with_until(Some(motion.start().time + 20.0));
        let rise = motion.phases().first().map_or(0.0, Phase::take_off_rate);
        setup.set(Quantity::GapRate, rise);
        let State { theta, theta_rate, slip, x, time } = motion.start();
        for (quantity, value) in [
            (Quantity::Time, time), (Quantity::X, x), (Quantity::Theta, theta), (Quantity::ThetaRate, theta_rate), (Quantity::Slip, slip),
        ] {
            setup.set(quantity, value);
        }
        let follow = |setup: &Setup| Hoop::new(setup.hoop)?.simulate(setup.start, limits);
        let motion = follow(&setup).expect("a motion");
        let quantities = [
            Quantity::Theta, Quantity::ThetaRate, Quantity::MuK, Quantity::MuS, Quantity::Inertia, Quantity::Slope, Quantity::X, Quantity::Time,
            Quantity::RollingResistance,
        ];
        let derivatives = motion.derivatives(&quantities).expect("quantities");
        let like = motion.summary();
        // An impact of another case is a kink.
        let cases = |motion: &Trajectory| motion.transitions().iter().map(|it| (it.cause, it.impact.map(|it| it.case))).collect::<Vec<_>>();
        let its_cases = cases(&motion);
        for (k, quantity) in quantities.into_iter().enumerate() {
            let at = |change: f64| {
                let mut changed = setup;
                changed.set(quantity, setup.get(quantity)? + change);
                let motion = follow(&changed).ok()?;
                let summary = motion.summary();
                (summary.sequence == like.sequence && summary.outcome == like.outcome && cases(&motion) == its_cases).then_some(summary)
            };
            let steps = [1e-3, 5e-4, 2.5e-4].map(|h| Some((h, [at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?])));
            let Some(steps) = steps.into_iter().collect::<Option<Vec<_>>>() else { continue };
            for (column, row) in SummaryColumn::reals().zip(derivatives.summary()) {
                let Ok(ours) = row[k] else { continue };
                let real = |summary: &Summary| match column.of(summary) {
                    SummaryValue::F64(value) => value,
                    _ => f64::NAN,
                };
                let differences = [0, 1, 2].map(|step| {
                    let (h, points) = &steps[step];
                    let [a, b, c, d] = points.each_ref().map(real);
                    (8.0 * (c - b) - (d - a)) / (12.0 * h)
                });
                let [_, coarse, fine] = differences;
                prop_assert_eq!(ours.is_nan(), real(&like).is_nan(), "{} {}", column, quantity);
                // A difference of fourth order: halving the step divides its error, and with it the
                // change, by 16 where the number is smooth over the step. Where it changes by less
                // only now, the terms of its error happen to cancel.
                let (change, next) = ((differences[0] - coarse).abs(), (coarse - fine).abs());
                if ours.is_nan() || next > change / 8.0 + 1e-7 || change > 1e-2 * (1.0 + fine.abs()) {
                    continue;
                }
                let error = next.max(change / 16.0) + 1e-8 * (1.0 + fine.abs());
                prop_assert!((ours - fine).abs() <= 4.0 * error, "{} {} {} {:?}", column, quantity, ours, differences);
            }
        }
    }

    /// The derivative at a fixed time, in the middle of each phase and at its end.
    #[test]
    fn derivatives_at_a_time_are_those_along_the_event_less_what_it_moves(motion in motions(moderate_hoop())) {
        let quantities = [Quantity::Theta, Quantity::ThetaRate, Quantity::MuK, Quantity::Offset, Quantity::RollingResistance];
        let derivatives = motion.derivatives(&quantities).expect("quantities");
        for (phase, next) in motion.phases().iter().zip(motion.phases().iter().skip(1)) {
            let (Some(last), Some(transition)) = (phase.last(), motion.end_of(phase)) else { continue };
            if transition.cause == Cause::Settle || next.start().time != transition.time() {
                continue;
            }
            let index = motion.transitions().iter().position(|it| it == transition).expect("its own");
            // The time of the event belongs to the next phase: the last double before it to this
            // one.
            let at = motion.derivatives_at(&[transition.time().next_down()], &quantities).expect("quantities");
            for (k, at) in at[0].clone().expect("within the motion").into_iter().enumerate() {
                let (Ok(along), Ok(at)) = (derivatives.transitions()[index][k], at) else { continue };
                let Sample { state, theta_acceleration, slip_acceleration, .. } = last;
                let rates = [1.0, state.theta_rate, theta_acceleration, slip_acceleration, state.slip - state.theta_rate];
                let moves = along.before.time;
                if transition.cause == Cause::Landing {
                    // Along the landing the gap remains closed.
                    let closes = last.gap_rate * moves;
                    prop_assert!((at.gap + closes).abs() < 1e-9 * closes.abs().max(1.0), "{k} {} {closes}", at.gap);
                } else {
                    prop_assert_eq!(at.gap, 0.0);
                }
                let along = numbers(&along.before);
                let scale = along.iter().zip(rates).map(|(along, rate)| along.abs() + (rate * moves).abs()).fold(1.0, f64::max);
                for ((along, at), rate) in along.into_iter().zip(numbers(&at.state)).zip(rates).skip(1) {
                    // One unit in the last place of the time changes the state by its rates.
                    prop_assert!(
                        (along - rate * moves - at).abs() < 1e-9 * scale,
                        "{:?} {k} {along} {at} {rate} {moves}",
                        transition.cause
                    );
                }
            }
        }
    }

    /// Left and right: each derivative is that of the mirror image.
    #[test]
    #[ignore = "thorough"]
    fn the_mirror_image_has_the_mirrored_derivatives(motion in motions(heavy_hoop())) {
        let start = motion.start();
        let mirrored = Start::from(State { theta: -start.theta, theta_rate: -start.theta_rate, slip: -start.slip, x: -start.x, ..start });
        let limits = Limits::default().with_transitions(motion.transitions().len().max(1));
        let mirrored = motion.hoop().simulate(mirrored, limits).expect("a start");
        let (quantities, ours) = all(&motion);
        let (_, theirs) = all(&mirrored);
        let odd = [Quantity::Theta, Quantity::ThetaRate, Quantity::Slip, Quantity::X, Quantity::Slope];
        for (ours, theirs) in ours.transitions().iter().zip(theirs.transitions()) {
            for ((ours, theirs), quantity) in ours.iter().zip(theirs).zip(&quantities) {
                let (Ok(ours), Ok(theirs)) = (ours, theirs) else { continue };
                let sign = if odd.contains(quantity) { -1.0 } else { 1.0 };
                let signs = [sign, -sign, -sign, -sign, -sign];
                let (ours, theirs) = (numbers(&ours.after), numbers(&theirs.after));
                let scale = 1e-11 * amplification(motion.hoop()) * size(ours);
                for ((a, b), sign) in ours.into_iter().zip(theirs).zip(signs) {
                    prop_assert!((a - sign * b).abs() <= scale, "{}: {} {}", quantity, a, b);
                }
            }
        }
    }
}

#[test]
fn a_disc_that_rolling_resistance_stops_has_the_derivatives_of_its_closed_form() {
    let (mass, inertia, chi, rate) = (1.5, 0.75, 0.05, 0.8);
    let hoop = HoopParameters::thin(mass)
        .with_offset(0.0)
        .with_inertia(inertia)
        .with_friction(1.0, 1.0)
        .with_rolling_resistance(chi);
    let motion = Hoop::new(hoop)
        .expect("a hoop")
        .simulate(Start::at(0.3, rate), Limits::default())
        .expect("a start");
    assert!(matches!(motion.outcome(), Outcome::Rests { .. }));
    let derivatives = motion
        .derivatives(&[Quantity::RollingResistance, Quantity::ThetaRate])
        .expect("quantities");
    // It brakes with θ″ = −χ m/(m + Î), and stops after the angle θ′²/2|θ″|.
    let total = 1.0 + mass;
    let braking = chi * total / (total + motion.hoop().body().inertia_about_mass_centre());
    let expected = [
        [
            -rate / (braking * chi),
            -0.5 * rate * rate / (braking * chi),
        ],
        [1.0 / braking, rate / braking],
    ];
    for (k, [time, theta]) in expected.into_iter().enumerate() {
        let at = derivatives.transitions()[0][k].expect("a turning point");
        let rests = derivatives.outcome()[k].expect("it rests").state;
        for (ours, theirs) in numbers(&at.before)
            .into_iter()
            .zip([time, theta, 0.0, 0.0, -theta])
        {
            assert!(
                (ours - theirs).abs() < 1e-12 * size([time, theta, 0.0, 0.0, 0.0]),
                "{ours} {theirs}"
            );
        }
        assert_eq!(rests, at.after);
    }
}

#[test]
fn a_derivative_that_does_not_exist_says_why() {
    let of = |motion: &Trajectory, quantity| motion.derivatives(&[quantity]).expect("a quantity");
    let reason = |motion: &Trajectory, quantity| of(motion, quantity).transitions()[0][0].err();
    // Without slip a start rolls, or takes a slip of either sign.
    let rolls = find_case("slip-then-jump")
        .expect("a case")
        .simulate()
        .expect("a motion");
    assert_eq!(reason(&rolls, Quantity::Slip), Some(NoDerivative::OneSided));
    assert_eq!(
        reason(&rolls, Quantity::GapRate),
        Some(NoDerivative::OneSided)
    );
    assert_eq!(reason(&rolls, Quantity::MuS), None);
    // With the least rolling resistance it rests, but for a motion that ends: this one then slips
    // at another time. A hoop that does not turn begins to turn to the one side or to the other.
    let chi = Quantity::RollingResistance;
    assert_eq!(reason(&rolls, chi), None);
    let swing = |chi: f64| {
        let parameters = HoopParameters::thin(1.0)
            .with_friction(1.0, 1.0)
            .with_rolling_resistance(chi);
        let hoop = Hoop::new(parameters).expect("a hoop");
        hoop.simulate(Start::at(PI - 0.5, 0.0), Limits::default())
            .expect("a motion")
    };
    let endless = of(&swing(0.0), chi);
    assert_eq!(endless.outcome()[0].err(), Some(NoDerivative::OneSided));
    assert!(of(&swing(0.0), Quantity::ThetaRate).outcome()[0].is_ok());
    let rests = swing(0.01);
    assert!(matches!(rests.outcome(), Outcome::Rests { .. }));
    assert!(of(&rests, chi).outcome()[0].is_ok());
    assert_eq!(
        reason(&rests, Quantity::ThetaRate),
        Some(NoDerivative::OneSided)
    );
    // At an instant, too; instants come in any order, and outside the motion there is no state.
    let times = [0.5, -1.0, 0.25, 0.5];
    let found = rolls
        .derivatives_at(&times, &[Quantity::Slip, Quantity::Theta])
        .expect("quantities");
    assert_eq!(
        found[0].as_ref().map(|row| row[0]),
        Some(Err(NoDerivative::OneSided))
    );
    assert_eq!(found[1], None);
    assert_eq!(found[0], found[3]);
    let alone = rolls
        .derivatives_at(&times[2..3], &[Quantity::Slip, Quantity::Theta])
        .expect("quantities");
    assert_eq!(found[2], alone[0]);
    assert!(found[2].as_ref().is_some_and(|row| row[1].is_ok()));
    // A massless hoop with inertia is another body; the particle reaches the plane with an infinite
    // rate.
    let massless = find_case("type-1")
        .expect("a case")
        .simulate()
        .expect("a motion");
    assert_eq!(
        reason(&massless, Quantity::Inertia),
        Some(NoDerivative::OneSided)
    );
    assert_eq!(
        of(&massless, Quantity::Theta).outcome()[0].err(),
        Some(NoDerivative::Singular)
    );
    // A slide of 1e5 turns.
    let hoop = HoopParameters::thin(1.0).with_friction(1e-9, 1e-9);
    let start = Start::at(0.0, 0.5).with_slip(1e-3);
    let long = Hoop::new(hoop)
        .expect("a hoop")
        .simulate(start, Limits::default())
        .expect("a motion");
    assert_eq!(
        reason(&long, Quantity::MuK),
        Some(NoDerivative::TooLong),
        "{:?}",
        long.outcome()
    );
    // The orbit that touches the limit of friction.
    let hoop = Hoop::equal_masses(0.5, 0.5).expect("a hoop");
    let law = RollingLaw::new(&hoop);
    let orbit = GrazingOrbit::below(&hoop, 10.0).expect("an orbit");
    let (mut grazes, mut slips) = (0, 0);
    for step in 0..60 {
        let above = orbit.energy * (1.0 + f64::from(step) * f64::EPSILON) - law.energy(PI, 0.0);
        let start = Start::at(PI, (2.0 * above / law.denominator(PI)).sqrt());
        let motion = hoop
            .simulate(start, Limits::default().with_transitions(1))
            .expect("a motion");
        if motion
            .transitions()
            .first()
            .is_some_and(|first| first.cause == Cause::Slip)
        {
            slips += 1;
            grazes += usize::from(reason(&motion, Quantity::MuS) == Some(NoDerivative::Grazing));
        }
    }
    assert!(slips > 30 && grazes == slips, "{grazes} of {slips}");
    let start = Start::at(
        PI,
        (2.0 * (orbit.energy + 1e-6 - law.energy(PI, 0.0)) / law.denominator(PI)).sqrt(),
    );
    let crosses = hoop.simulate(start, Limits::default()).expect("a motion");
    assert_eq!(reason(&crosses, Quantity::MuS), None);
    // What is no quantity of a motion.
    let refused = rolls
        .derivatives(&[Quantity::Until])
        .expect_err("no quantity of hoop or start");
    assert_eq!(refused.quantity, Quantity::Until);
    assert!(rolls.derivatives(&[Quantity::Restitution]).is_err());
}

/// The period of a libration by its closed form, at both sides of each quantity.
#[test]
fn periods_and_amplitudes_have_the_derivatives_of_their_closed_forms() {
    let case = find_case("figure-2-libration").expect("a case");
    for (theta, rate) in [(2.5, 0.0), (2.0, 0.3), (-2.0, 0.3), (PI, -0.4)] {
        let motion = |theta: f64, rate: f64, mass: f64| {
            let mut setup = case.setup;
            (
                setup.start.theta,
                setup.start.theta_rate,
                setup.hoop.mass_ratio,
            ) = (theta, rate, mass);
            Hoop::new(setup.hoop)
                .expect("a hoop")
                .simulate(setup.start, Limits::default())
                .expect("a motion")
        };
        let numbers = |motion: &Trajectory| match motion.outcome() {
            Outcome::RollsForever {
                recurrence:
                    Recurrence::Libration {
                        period,
                        theta_min,
                        theta_max,
                    },
                ..
            } => [period, theta_min, theta_max],
            other => panic!("{other:?}"),
        };
        let here = motion(theta, rate, 1.0);
        let quantities = [Quantity::Theta, Quantity::ThetaRate, Quantity::MassRatio];
        let derivatives = here.derivatives(&quantities).expect("quantities");
        for (k, direction) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .into_iter()
            .enumerate()
        {
            let ours = derivatives.outcome()[k]
                .expect("regular")
                .recurrence
                .expect("a libration");
            let Recurrence::Libration {
                period,
                theta_min,
                theta_max,
            } = ours
            else {
                panic!("{ours:?}")
            };
            let at = |by: f64| {
                let [a, b, c] = direction.map(|part| part * by);
                numbers(&motion(theta + a, rate + b, 1.0 + c))
            };
            // Differences of fourth order.
            let step = 1e-3;
            let [near, far] = [step, 2.0 * step].map(|step| [at(step), at(-step)]);
            for (n, ours) in [period, theta_min, theta_max].into_iter().enumerate() {
                let [one, two] = [near, far].map(|[plus, minus]| plus[n] - minus[n]);
                let theirs = (8.0 * one - two) / (12.0 * step);
                // At rest the amplitude grows with the square of the rate.
                assert!(
                    (ours - theirs).abs() < 1e-8 * (1.0 + theirs.abs()),
                    "{theta} {rate} {k} {n}: {ours} {theirs}"
                );
            }
        }
    }
}

/// θ after many periods of rolling: the derivative by the rate of the start grows with the time, as
/// that of the period says.
#[test]
fn rolling_through_many_periods_has_the_derivatives_of_its_differences() {
    // Rotation without friction's limits, a libration, and a well of a slope.
    for (theta, rate, slope, offset) in [
        (0.0, 0.5, 0.0, 0.2),
        (2.5, 0.0, 0.0, 1.0),
        (2.9, 0.1, 0.1, 1.0),
    ] {
        let motion = |change: f64| {
            let hoop = HoopParameters::thin(1.0)
                .with_friction(9.0, 9.0)
                .with_offset(offset);
            let mut setup = Setup::new(hoop, Start::at(theta, rate + change));
            setup.set(Quantity::Slope, slope);
            let limits = Limits::default().with_until(Some(2000.0));
            Hoop::new(setup.hoop)
                .expect("a hoop")
                .simulate(setup.start, limits)
                .expect("a motion")
        };
        let here = motion(0.0);
        let times = [0.5, 400.0, 1999.0];
        let found = here
            .derivatives_at(&times, &[Quantity::ThetaRate])
            .expect("a quantity");
        for (time, found) in times.into_iter().zip(found) {
            let ours = found.expect("within the motion")[0].expect("regular");
            let step = 1e-6;
            let [plus, minus] =
                [step, -step].map(|step| motion(step).at(time).expect("within").state);
            for (ours, (plus, minus)) in numbers(&ours.state)
                .into_iter()
                .zip(numbers(&plus).into_iter().zip(numbers(&minus)))
            {
                let theirs = (plus - minus) / (2.0 * step);
                // A central difference: rounding 1e-13 of the angle over the step, and the third
                // derivative, which grows with the time cubed.
                let bound = 1e-6 + 1e-12 * time * time * time + 1e-7 * theirs.abs();
                assert!(
                    (ours - theirs).abs() < bound,
                    "{theta} {rate} {slope} {time}: {ours} {theirs}"
                );
            }
        }
    }
}
