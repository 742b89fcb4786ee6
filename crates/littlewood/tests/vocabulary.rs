//! The tables that every front end reads: names and codes lead back to their items, labels tell
//! them apart, and the values behind columns and quantities are those of the structures.

use std::collections::HashSet;
use std::fmt::Debug;
use std::hash::Hash;
use std::str::FromStr;

use littlewood::cases::find_case;
use littlewood::impact::ImpactCase;
use littlewood::modes::RecurrenceKind;
use littlewood::si::{SiParameters, SiSetup};
use littlewood::tables::{
    Class, Detail, Dimension, Group, PhaseCode, PhaseSequence, Quantity, SampleColumn, SampleValue,
    Setup, SummaryColumn, SummaryValue,
};
use littlewood::theory::{BodyClass, EDGES, StartRegion};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, OutcomeKind, Proof, RestitutionLaw, SlipDirection,
    Start,
};

/// Each name and each code leads back to its item, and no other does.
fn check<T>(all: &[T], names: &[&str], name: impl Fn(T) -> &'static str, code: impl Fn(T) -> u8)
where
    T: Copy + Debug + ToString + PartialEq + FromStr + TryFrom<u8>,
    <T as FromStr>::Err: Debug + ToString,
    <T as TryFrom<u8>>::Error: Debug + ToString,
{
    assert_eq!(all.len(), names.len());
    let mut codes = HashSet::new();
    for (&item, &listed) in all.iter().zip(names) {
        assert_eq!((name(item), item.to_string().as_str()), (listed, listed));
        assert_eq!(listed.parse::<T>().expect("a name"), item);
        assert_eq!(T::try_from(code(item)).expect("a code"), item);
        assert!(codes.insert(code(item)), "{item:?} has the code of another");
    }
    let free = (0..=u8::MAX)
        .find(|code| !codes.contains(code))
        .expect("fewer than 256 items");
    let message = T::try_from(free).expect_err("no code").to_string();
    assert!(message.contains(&free.to_string()), "{message}");
    let message = "nonsense".parse::<T>().expect_err("no name").to_string();
    assert!(message.contains("nonsense"), "{message}");
}

#[test]
fn names_and_codes_lead_back_to_their_items() {
    check(
        &BodyClass::ALL,
        &BodyClass::NAMES,
        BodyClass::name,
        BodyClass::code,
    );
    check(&Cause::ALL, &Cause::NAMES, Cause::name, Cause::code);
    check(&Class::ALL, &Class::NAMES, Class::name, Class::code);
    check(
        &ImpactCase::ALL,
        &ImpactCase::NAMES,
        ImpactCase::name,
        ImpactCase::code,
    );
    check(&Mode::ALL, &Mode::NAMES, Mode::name, Mode::code);
    check(
        &OutcomeKind::ALL,
        &OutcomeKind::NAMES,
        OutcomeKind::name,
        OutcomeKind::code,
    );
    check(
        &PhaseCode::ALL,
        &PhaseCode::NAMES,
        PhaseCode::name,
        PhaseCode::code,
    );
    check(&Proof::ALL, &Proof::NAMES, Proof::name, Proof::code);
    check(
        &Quantity::ALL,
        &Quantity::NAMES,
        Quantity::name,
        Quantity::code,
    );
    check(
        &RecurrenceKind::ALL,
        &RecurrenceKind::NAMES,
        RecurrenceKind::name,
        RecurrenceKind::code,
    );
    check(
        &RestitutionLaw::ALL,
        &RestitutionLaw::NAMES,
        RestitutionLaw::name,
        RestitutionLaw::code,
    );
    check(
        &SampleColumn::ALL,
        &SampleColumn::NAMES,
        SampleColumn::name,
        SampleColumn::code,
    );
    check(
        &StartRegion::ALL,
        &StartRegion::NAMES,
        StartRegion::name,
        StartRegion::code,
    );
    check(
        &SummaryColumn::ALL,
        &SummaryColumn::NAMES,
        SummaryColumn::name,
        SummaryColumn::code,
    );
}

/// All differ, and none is empty.
fn distinct<T: Copy + Eq + Hash + Debug>(all: &[T], label: impl Fn(T) -> &'static str) {
    let labels: HashSet<&str> = all.iter().map(|&item| label(item)).collect();
    assert_eq!(labels.len(), all.len(), "{all:?}");
    assert!(!labels.contains(""));
}

#[test]
fn labels_tell_items_apart() {
    distinct(&Cause::ALL, Cause::label);
    distinct(&Class::ALL, Class::label);
    distinct(&ImpactCase::ALL, ImpactCase::label);
    distinct(&OutcomeKind::ALL, OutcomeKind::label);
    distinct(&Proof::ALL, Proof::label);
    distinct(&RestitutionLaw::ALL, RestitutionLaw::label);
    distinct(&PhaseCode::ALL, PhaseCode::meaning);
    distinct(&SampleColumn::ALL, SampleColumn::long_name);
    distinct(&SummaryColumn::ALL, SummaryColumn::long_name);
}

#[test]
fn a_mode_with_its_direction_is_one_code_and_back() {
    for code in PhaseCode::ALL {
        let (mode, direction) = code.mode();
        assert_eq!(PhaseCode::new(mode, direction), code);
        let arrow = mode.with_arrow(direction);
        assert_eq!(
            arrow.contains('→'),
            direction == Some(SlipDirection::Positive),
            "{arrow}"
        );
        assert_eq!(
            arrow.contains('←'),
            direction == Some(SlipDirection::Negative),
            "{arrow}"
        );
        assert!(arrow.starts_with(mode.name()));
        // Beside other phases, so that a bit of one cannot reach the next.
        let sequence = |turn: fn(SlipDirection) -> SlipDirection| {
            let mut phases = PhaseSequence::default();
            for other in PhaseCode::ALL {
                for (mode, direction) in [other.mode(), (mode, direction)] {
                    phases.push(mode, direction.map(turn));
                }
            }
            phases
        };
        assert_eq!(
            sequence(|same| same).mirrored(),
            sequence(SlipDirection::reversed),
            "{code}"
        );
    }
    for direction in SlipDirection::ALL {
        assert_eq!(SlipDirection::of_sign(direction.sign()), Some(direction));
        assert_eq!(direction.reversed().sign(), -direction.sign());
        assert_eq!(
            f64::from(SlipDirection::code(Some(direction))),
            direction.sign()
        );
    }
    assert_eq!(
        (
            SlipDirection::of_sign(0.0),
            SlipDirection::of_sign(f64::NAN),
            SlipDirection::code(None)
        ),
        (None, None, 0)
    );
    let pressed: Vec<Mode> = Mode::ALL
        .into_iter()
        .filter(|mode| mode.has_normal_force())
        .collect();
    assert_eq!(
        pressed,
        [Mode::Rolling, Mode::Sliding, Mode::Rest, Mode::Skidding]
    );
    assert!(
        Mode::ALL
            .into_iter()
            .all(|mode| mode.touches_plane() != (mode == Mode::Flight))
    );
}

#[test]
fn an_outcome_that_is_an_event_ends_the_simulation_in_the_automaton() {
    for outcome in OutcomeKind::ALL {
        if let Some(cause) = outcome.last_event() {
            assert!(outcome.is_final(), "{outcome}");
            assert!(
                EDGES
                    .iter()
                    .any(|edge| edge.cause == cause && edge.to.is_none()),
                "{outcome}"
            );
        }
        assert!(!outcome.is_forever() || outcome.is_final());
        assert!(!outcome.is_painleve() || outcome.is_final());
    }
}

#[test]
fn a_motion_is_of_the_class_of_its_outcome() {
    let classes = [
        ("figure-3", Class::LiftsOffLater),
        ("footnote-3", Class::LeavesAtOnce),
        ("rolls-forever", Class::RollsForever),
        ("figure-7", Class::ParticleAtPlane),
        ("painleve", Class::Painleve),
    ];
    for (name, class) in classes {
        let motion = find_case(name)
            .expect("a case")
            .simulate()
            .expect("a motion");
        assert_eq!(Class::of(&motion.summary()), class, "{name}");
        assert_eq!(
            class.stays_in_contact(),
            class == Class::RollsForever,
            "{name}"
        );
    }
}

#[test]
fn columns_of_a_sample_are_its_fields() {
    let motion = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a motion");
    let sample = motion.at(1.2).expect("in the motion");
    let value = |column: SampleColumn| column.of(&sample).number();
    assert_eq!(
        SampleColumn::Mode.of(&sample),
        SampleValue::Mode(Mode::Sliding)
    );
    assert_eq!(
        SampleColumn::Direction.of(&sample),
        SampleValue::Direction(Some(SlipDirection::Positive))
    );
    assert_eq!(value(SampleColumn::Direction), 1.0);
    assert_eq!(value(SampleColumn::Mode), f64::from(Mode::Sliding.code()));
    assert_eq!(
        sample.state.numbers(),
        littlewood::State::COLUMNS.map(value)
    );
    // The geometry of the body: R = 1, ℓ̂ = 1, h = 1/2; the rim touches the plane.
    let (sin, cos) = (libm::sin(sample.state.theta), libm::cos(sample.state.theta));
    assert_eq!(
        (
            value(SampleColumn::Gap),
            value(SampleColumn::GapRate),
            value(SampleColumn::CentreY)
        ),
        (0.0, 0.0, 1.0)
    );
    for (column, expected) in [
        (SampleColumn::ParticleX, sample.state.x - sin),
        (SampleColumn::ParticleY, 1.0 + cos),
        (SampleColumn::MassCentreX, sample.state.x - 0.5 * sin),
        (SampleColumn::MassCentreY, 1.0 + 0.5 * cos),
    ] {
        assert!(
            (value(column) - expected).abs() < 1e-14,
            "{column}: {} and {expected}",
            value(column)
        );
    }
    // Coulomb's law, and Newton's for the whole body: m x̄″ = F.
    assert!((value(SampleColumn::Friction) + 0.4 * value(SampleColumn::Normal)).abs() < 1e-15);
    assert_eq!(value(SampleColumn::Normal), sample.normal);
    assert_eq!(
        value(SampleColumn::ThetaAcceleration),
        sample.theta_acceleration
    );
    assert_eq!(
        value(SampleColumn::SlipAcceleration),
        sample.slip_acceleration
    );
    assert_eq!(value(SampleColumn::Energy), sample.energy);
    for column in SampleColumn::ALL {
        assert_eq!(
            column.dimension().is_some(),
            column.si_name().is_some(),
            "{column}"
        );
        assert!(
            column
                .si_name()
                .is_none_or(|name| name.starts_with(column.name()))
        );
        assert!(!column.sign().is_empty() || column == SampleColumn::Mode);
    }
}

#[test]
fn columns_of_a_summary_can_be_read_and_set() {
    let summary = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a motion")
        .summary();
    let mut copy = find_case("jam")
        .expect("a case")
        .simulate()
        .expect("a motion")
        .summary();
    for column in SummaryColumn::ALL {
        assert!(column.set(&mut copy, column.of(&summary)), "{column}");
        assert!(
            !column.set(&mut copy, SummaryValue::U32(1))
                || matches!(column.of(&summary), SummaryValue::U32(_))
        );
        assert!(column.set(&mut copy, column.of(&summary)), "{column}");
        let (ours, theirs) = (column.of(&copy), column.of(&summary));
        assert!(
            ours == theirs || matches!(ours, SummaryValue::F64(it) if it.is_nan()),
            "{column}"
        );
        assert_eq!(
            format!("{:?}", summary.values()[usize::from(column.code())]),
            format!("{theirs:?}"),
            "{column}"
        );
    }
    assert_eq!(
        format!("{copy:?}"),
        format!("{summary:?}"),
        "no column but has a place of its own"
    );
    assert!(!SummaryColumn::Outcome.set(&mut copy, SummaryValue::U8(77)));
    assert!(!SummaryColumn::Energy.set(&mut copy, SummaryValue::U8(1)));
    let numbers: Vec<SummaryColumn> = SummaryColumn::numbers().collect();
    let reals: Vec<SummaryColumn> = SummaryColumn::reals().collect();
    assert!(reals.iter().all(|column| numbers.contains(column)));
    for column in SummaryColumn::ALL {
        let value = column.of(&summary);
        assert_eq!(
            reals.contains(&column),
            matches!(value, SummaryValue::F64(_)),
            "{column}"
        );
        assert!(
            reals.contains(&column) || column.dimension() == Dimension::Ratio,
            "{column}"
        );
    }
}

/// A hula hoop of 0.4 kg and 0.45 m with 0.14 kg on its rim.
fn hula_hoop(quantity: Quantity) -> Option<f64> {
    Some(match quantity {
        Quantity::DiscMassKg | Quantity::MuK => 0.4,
        Quantity::ParticleMassKg => 0.14,
        Quantity::RadiusM | Quantity::OffsetM => 0.45,
        Quantity::InertiaKgM2 => 0.081,
        Quantity::GravityMPerS2 => 9.8,
        Quantity::MuS => 0.5,
        Quantity::RollingResistanceM => 0.0,
        Quantity::Slope => 0.2,
        Quantity::Theta => 1.2,
        Quantity::ThetaRateRadPerS => 6.0,
        Quantity::TimeS => -0.7,
        Quantity::SlipMPerS => -1.5,
        Quantity::GapRateMPerS => 0.3,
        Quantity::XM => 0.9,
        _ => return None,
    })
}

#[test]
fn a_setup_in_si_units_is_converted_by_the_units_of_the_paper() {
    let si = SiSetup::from_values(hula_hoop, None);
    for quantity in Quantity::ALL {
        assert_eq!(si.get(quantity), hula_hoop(quantity), "{quantity}");
    }
    let (setup, units) = si.to_setup().expect("a hoop and a start");
    let time: f64 = (0.45 / 9.8_f64).sqrt();
    let close =
        |found: f64, expected: f64| (found - expected).abs() <= 1e-15 * expected.abs().max(1.0);
    assert!(close(setup.hoop.mass_ratio, 0.4 / 0.14));
    assert!(close(setup.hoop.offset, 1.0));
    assert!(close(setup.hoop.inertia, 0.081 / (0.14 * 0.45 * 0.45)));
    assert!(close(setup.start.theta_rate, 6.0 * time));
    assert!(close(setup.start.x, 2.0));
    assert!(close(setup.start.time, -0.7 / time));
    assert!(close(setup.start.slip, -1.5 * time / 0.45));
    assert!(close(setup.start.gap_rate, 0.3 * time / 0.45));
    let back = SiSetup::new(&setup, &units);
    for quantity in Quantity::ALL {
        if let (Some(found), Some(given)) = (back.get(quantity), si.get(quantity)) {
            assert!(close(found, given), "{quantity}: {found} and {given}");
        }
    }
    let outside = |quantity| {
        if quantity == Quantity::OffsetM {
            Some(0.6)
        } else {
            hula_hoop(quantity)
        }
    };
    let refused = SiSetup::from_values(outside, None)
        .to_setup()
        .expect_err("outside of the rim")
        .to_string();
    assert_eq!(
        refused,
        "offset_m = 0.6 m must not exceed radius_m = 0.45 m"
    );
    // A limit in seconds: said in seconds where it lies before the start.
    let late = setup.start.with_time(2.0);
    assert!(close(
        units.until(4.0 * time, &late).expect("after the start"),
        4.0
    ));
    let refused = units
        .until(time, &late)
        .expect_err("before the start")
        .to_string();
    assert!(
        refused.contains("until_s") && refused.contains('s'),
        "{refused}"
    );
    assert!(SiSetup::from_values(|_| None, None).to_setup().is_err());
}

#[test]
fn every_quantity_has_its_unit_and_its_twin() {
    for quantity in Quantity::ALL {
        assert!(
            !quantity.symbol().is_empty()
                && !quantity.sign().is_empty()
                && !quantity.long_name().is_empty()
        );
        assert!(!quantity.row().help.is_empty(), "{quantity}");
        assert_eq!(
            quantity.unit().is_empty(),
            quantity.unit_sign().is_empty(),
            "{quantity}"
        );
        assert!(
            !quantity.dimensionless().is_si() || quantity.group() == Group::Units,
            "{quantity}"
        );
        if let Some(twin) = quantity.si_twin() {
            assert!(
                twin.is_si() && twin.dimensionless() == quantity,
                "{quantity}"
            );
        }
        if let Some(twin) = quantity.row().twin {
            assert_eq!(
                (twin.row().twin, twin.dimension()),
                (Some(quantity), quantity.dimension())
            );
            assert_ne!(twin.is_si(), quantity.is_si());
        }
        // Names of quantities in SI units end in the unit.
        let suffix = quantity.dimension().si_suffix();
        let ends_in_unit = !suffix.is_empty() && quantity.name().ends_with(suffix);
        assert_eq!(quantity.is_si(), ends_in_unit, "{quantity}");
        let [least, most] = quantity.row().usual;
        assert!(least < most && quantity.check(least).is_ok());
        assert!(quantity.check(most).is_ok());
    }
    assert_eq!(
        (
            Quantity::MassRatio.unit(),
            Quantity::Theta.unit(),
            Quantity::RadiusM.unit()
        ),
        ("", "rad", "m")
    );
    assert_eq!(
        Quantity::ThetaRate.unit_sign(),
        Dimension::AngularRate.scale_sign()
    );
    assert_eq!(
        (Dimension::Angle.cf_unit(), Dimension::Time.cf_unit()),
        ("rad", "1")
    );
}

/// The hint and the quantity of each refusal.
#[test]
fn refusals_name_what_would_have_to_change() {
    let hoop = |parameters: HoopParameters| Hoop::new(parameters).expect_err("refused");
    let thin = HoopParameters::thin(1.0);
    let mut law_alone = thin;
    law_alone.restitution_law = Some(RestitutionLaw::Newton);
    let cases = [
        (hoop(thin.with_friction(0.5, 0.6)), Quantity::MuK, true),
        (hoop(thin.with_friction(-0.5, 0.0)), Quantity::MuS, false),
        (
            hoop(thin.with_friction(f64::NAN, 0.0)),
            Quantity::MuS,
            false,
        ),
        (
            hoop(HoopParameters::thin(1.0).with_offset(1.5)),
            Quantity::Offset,
            false,
        ),
        (
            hoop(HoopParameters::thin(-1.0).with_inertia(1.0)),
            Quantity::MassRatio,
            false,
        ),
        (
            hoop(HoopParameters::thin(1.0).with_offset(0.0).with_inertia(0.0)),
            Quantity::Offset,
            true,
        ),
        (
            hoop(HoopParameters::thin(0.0).with_restitution(0.5, RestitutionLaw::Newton)),
            Quantity::Restitution,
            true,
        ),
        (hoop(law_alone), Quantity::Restitution, false),
    ];
    let mut hints = HashSet::new();
    for (error, quantity, contradiction) in cases {
        assert_eq!(
            (error.quantity(), error.is_contradiction()),
            (quantity, contradiction),
            "{error}"
        );
        hints.insert(error.hint());
    }
    assert_eq!(hints.len(), 8);
    let figure_2 = Hoop::equal_masses(0.5, 0.4).expect("a hoop");
    let error = figure_2
        .simulate(Start::at(1e300, 0.0), Limits::default())
        .expect_err("refused");
    assert_eq!(
        (error.quantity(), error.hint()),
        (
            Quantity::Theta,
            "beyond this bound a double no longer resolves the motion"
        )
    );
    let massless = Hoop::littlewood(0.5, 0.4).expect("a hoop");
    let error = massless
        .simulate(Start::at(1.0, 0.0).with_gap_rate(1.0), Limits::default())
        .expect_err("refused");
    assert_eq!(
        (error.quantity(), error.is_contradiction()),
        (Quantity::GapRate, true)
    );
}

#[test]
fn recurrences_come_back_after_their_period() {
    let hoop = Hoop::equal_masses(2.0, 1.0).expect("a hoop");
    let kinds = [
        (Start::at(std::f64::consts::PI, 0.0), RecurrenceKind::Rest),
        (Start::at(3.0, 0.1), RecurrenceKind::Libration),
        (
            Start::at(std::f64::consts::PI, 2.0),
            RecurrenceKind::Rotation,
        ),
    ];
    for (start, kind) in kinds {
        let motion = hoop.simulate(start, Limits::default()).expect("a motion");
        let recurrence = motion.outcome().recurrence().expect("it rolls for ever");
        assert_eq!(recurrence.kind(), kind);
        let details = recurrence.details();
        assert_eq!(details[0], ("recurrence", Detail::Word(kind.name())));
        assert_eq!(motion.outcome().details(), details);
        let Some(period) = recurrence.period() else {
            continue;
        };
        assert!(details.contains(&("period", Detail::Real(period, Dimension::Time))));
        let (first, later) = (
            motion.at(0.0).expect("an instant"),
            motion.at(period).expect("an instant"),
        );
        let turned = (later.state.theta - first.state.theta) / std::f64::consts::TAU;
        assert!(
            (turned.abs() - f64::from(kind == RecurrenceKind::Rotation)).abs() < 1e-13,
            "{turned}"
        );
        assert!((later.state.theta_rate - first.state.theta_rate).abs() < 1e-13);
    }
}

#[test]
fn outcomes_say_what_is_known_of_them() {
    let details = |name: &str| -> Vec<&'static str> {
        let outcome = find_case(name)
            .expect("a case")
            .simulate()
            .expect("a motion")
            .outcome();
        if let Some(candidates) = outcome.candidates() {
            assert_eq!(candidates.consistent().count(), candidates.count());
            let names = Vec::from_iter(candidates.details().map(|(name, _)| name));
            assert_eq!((names[0], names.len()), ("rolling_normal", 5));
        }
        outcome
            .details()
            .into_iter()
            .map(|(name, _)| name)
            .collect()
    };
    assert_eq!(details("figure-3"), ["gap_rate"]);
    assert_eq!(
        details("figure-2-libration"),
        ["recurrence", "period", "theta_min", "theta_max"]
    );
    assert_eq!(details("figure-7"), [""; 0]);
    assert_eq!(details("painleve"), [""; 0]);
    let hoop = Hoop::equal_masses(0.5, 0.4).expect("a hoop");
    let limits = Limits::default().with_transitions(2);
    let motion = hoop
        .simulate(Start::at(1.5, 2.0), limits)
        .expect("a motion");
    assert_eq!(
        motion.outcome().details(),
        [("transitions", Detail::Count(2))]
    );
}

#[test]
fn the_course_of_an_impact_ends_with_its_impulse() {
    let motion = find_case("figure-3-bounces")
        .expect("a case")
        .simulate()
        .expect("a motion");
    let hoop = motion.hoop();
    let mut seen = 0;
    for transition in motion
        .transitions()
        .iter()
        .filter(|it| it.cause == Cause::Landing)
    {
        let impact = transition.impact.expect("an impact");
        let course = hoop.impact_course(transition.before.theta, &impact);
        assert_eq!(
            (course[0].impulse.normal, course[0].impulse.friction),
            (0.0, 0.0)
        );
        let end = course.last().expect("an end");
        assert_eq!(
            (end.impulse, end.velocities),
            (impact.impulse, impact.after)
        );
        assert!(
            course
                .windows(2)
                .all(|pair| pair[0].impulse.normal < pair[1].impulse.normal)
        );
        // The compliances tell what the impulse does to the rim: Δw = B J + C P, Δu = A J + B P.
        let littlewood::impact::Compliance { a, b, c, .. } = hoop
            .compliance(transition.before.theta)
            .expect("a heavy hoop");
        for vertex in &course {
            let (j, p) = (vertex.impulse.friction, vertex.impulse.normal);
            let change = vertex.velocities.gap_rate - impact.before.gap_rate;
            assert!((b * j + c * p - change).abs() < 1e-12, "{change}");
            let change = vertex.velocities.slip - impact.before.slip;
            assert!((a * j + b * p - change).abs() < 1e-12, "{change}");
        }
        assert_eq!(impact.gains_energy(), impact.energy_lost() < 0.0);
        seen += 1;
    }
    assert!(seen > 3);
    let massless = Hoop::littlewood(0.5, 0.4).expect("a hoop");
    assert!(massless.compliance(1.0).is_none());
}

#[test]
fn instants_outside_a_motion_have_no_sample() {
    let motion = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a motion");
    let times = [-1.0, 0.0, 0.7, 1.5, 3.8, 9.0];
    let is_within = times.map(|time| motion.at(time).is_some());
    assert_eq!(is_within, [false, true, true, true, true, false]);
    let setup = Setup::new(motion.hoop().parameters(), Start::at(0.0, 0.0));
    assert_eq!(setup.get(Quantity::MuK), Some(0.4));
}

#[test]
fn the_lists_have_every_quantity_of_their_groups() {
    let sorted = |quantities: &[Quantity]| {
        let mut quantities = quantities.to_vec();
        quantities.sort_unstable();
        quantities
    };
    let those = |groups: &[Group], is_listed: fn(Quantity) -> bool| -> Vec<Quantity> {
        let in_groups =
            |quantity: &Quantity| groups.contains(&quantity.group()) && is_listed(*quantity);
        Quantity::ALL.into_iter().filter(in_groups).collect()
    };
    let is_plain = |quantity: Quantity| !quantity.is_si();
    let in_si = |quantity: Quantity| quantity.is_si() || quantity.si_twin().is_none();
    assert_eq!(sorted(&Quantity::HOOP), those(&[Group::Hoop], is_plain));
    assert_eq!(
        sorted(&Quantity::START),
        those(&[Group::Start, Group::Place], is_plain)
    );
    assert_eq!(
        sorted(&Quantity::AXES),
        those(&[Group::Hoop, Group::Start], is_plain)
    );
    assert_eq!(
        sorted(&Quantity::SI_HOOP),
        those(&[Group::Hoop, Group::Units], in_si)
    );
    assert_eq!(
        sorted(&Quantity::SI_START),
        those(&[Group::Start, Group::Place], in_si)
    );
}

#[test]
fn a_setup_has_every_quantity_of_a_hoop_and_a_start() {
    let mut setup = Setup::new(HoopParameters::default(), Start::default());
    for (value, quantity) in (1_u8..).zip(Quantity::HOOP.into_iter().chain(Quantity::START)) {
        setup.set(quantity, f64::from(value));
    }
    for (value, quantity) in (1_u8..).zip(Quantity::HOOP.into_iter().chain(Quantity::START)) {
        assert_eq!(setup.get(quantity), Some(f64::from(value)));
        assert_eq!(
            setup.get(quantity.si_twin().unwrap_or(Quantity::Until)),
            None
        );
    }
    assert!(Quantity::AXES.iter().all(|axis| setup.get(*axis).is_some()));
    let bare = Setup::new(HoopParameters::default(), Start::default());
    assert_eq!(bare.get(Quantity::Restitution), None);
    assert!(bare.values([Quantity::Restitution])[0].is_nan());
}

#[test]
fn units_are_the_powers_of_mass_length_and_gravity() {
    let (m, r, g) = (0.14_f64, 0.45_f64, 9.81_f64);
    let si = SiParameters {
        particle_mass_kg: m,
        radius_m: r,
        gravity_m_per_s2: g,
        ..SiParameters::default()
    };
    let units = si.units().expect("three positive numbers");
    for (dimension, expected) in [
        (Dimension::Ratio, 1.0),
        (Dimension::Angle, 1.0),
        (Dimension::Mass, m),
        (Dimension::Length, r),
        (Dimension::Time, (r / g).sqrt()),
        (Dimension::AngularRate, (g / r).sqrt()),
        (Dimension::AngularAcceleration, g / r),
        (Dimension::Velocity, (g * r).sqrt()),
        (Dimension::Acceleration, g),
        (Dimension::Force, m * g),
        (Dimension::Energy, m * g * r),
        (Dimension::Impulse, m * (g * r).sqrt()),
        (Dimension::Inertia, m * r * r),
    ] {
        assert!(
            (units.unit(dimension) / expected - 1.0).abs() < 1e-15,
            "{dimension:?}"
        );
        assert!((units.from_si(dimension, units.to_si(dimension, 0.7)) - 0.7).abs() < 1e-15);
        assert!(
            (units.to_si(dimension, 0.7) / (0.7 * expected) - 1.0).abs() < 1e-15,
            "{dimension:?}"
        );
    }
}
