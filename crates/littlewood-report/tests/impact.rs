//! What is said of impacts, against numbers worked out from the notes and from the equations.

#![allow(
    clippy::excessive_precision,
    reason = "the reference has more digits than a double"
)]

use littlewood::cases::find_case;
use littlewood::impact::Impact;
use littlewood::{Cause, Hoop, HoopParameters, Limits, RestitutionLaw, Start, Trajectory};
use littlewood_report::scale::Scale;
use littlewood_report::{Sampling, ShownImpact, instants, kinetic_energy, sentence};

const PLAIN: Scale<'_> = Scale::new(None);

fn bouncing(case: &str, restitution: f64, law: RestitutionLaw) -> Trajectory {
    let setup = find_case(case).expect("a named case").setup;
    let hoop = Hoop::new(setup.hoop.with_restitution(restitution, law)).expect("a hoop");
    hoop.simulate(setup.start, Limits::until(40.0))
        .expect("a motion")
}

fn told(motion: &Trajectory) -> Vec<String> {
    let tell = |index| sentence::transition(motion, index, PLAIN).expect("a transition");
    (0..motion.transitions().len()).map(tell).collect()
}

/// The kinetic energy of Figure 3 just before its landing, from the numbers of the notes: m = 2,
/// h = 1/2, I = 3/2.
fn before_the_landing() -> f64 {
    let (theta, rate) = (9.891_172_939_575_516, 1.998_705_937_114_139_9);
    let (slip, gap_rate) = (-0.785_244_687_128_996_169, -1.913_012_569_038_374_656);
    let (sin, cos) = libm::sincos(theta);
    let (vx, vy) = (slip - (1.0 + 0.5 * cos) * rate, gap_rate - 0.5 * sin * rate);
    vx * vx + vy * vy + 0.75 * rate * rate
}

#[test]
fn an_impact_is_told_with_the_part_of_the_energy_that_is_gone() {
    for (restitution, lost, words) in [
        (
            0.5,
            3.362_443_419_227_28,
            "Lands: slips, then sticks while it springs back; ",
        ),
        (0.0, 4.275_729_468_652_908_31, "Lands: slips throughout; "),
    ] {
        let motion = bouncing("figure-3", restitution, RestitutionLaw::Energetic);
        let landing = motion
            .transitions()
            .iter()
            .position(|it| it.cause == Cause::Landing)
            .unwrap();
        let percent = 100.0 * lost / before_the_landing();
        assert!((10.0..99.0).contains(&percent));
        let sentence = sentence::transition(&motion, landing, PLAIN).unwrap();
        let expected =
            format!("{words}{percent:.0} % of its kinetic energy before the impact is lost, and ");
        assert!(sentence.starts_with(&expected), "{sentence}");
        // w after it, of the notes; or the slide that goes on.
        let end = if restitution > 0.0 {
            "the rim leaves the plane at 0.979 √(gR)."
        } else {
            "it slides to the left."
        };
        assert!(sentence.ends_with(end), "{sentence}");
        let impact = motion.transitions()[landing].impact.unwrap();
        let theta = motion.transitions()[landing].before.theta;
        let kinetic = kinetic_energy(motion.hoop(), theta, &impact.before).unwrap();
        assert!((kinetic - before_the_landing()).abs() < 1e-12);
    }
}

fn shown(motion: &Trajectory) -> impl Iterator<Item = (ShownImpact, Impact)> {
    let events = motion.transitions().iter().enumerate();
    events.filter_map(|(index, event)| {
        let shown = ShownImpact::of(motion.hoop(), index, event)?;
        Some((shown, event.impact?))
    })
}

/// Without friction and with e = 1 nothing is lost, there is no J, and the slip is kept.
#[test]
fn what_is_rounding_is_shown_as_nothing() {
    let mut impacts = 0;
    for (i, law) in (0..120).zip(RestitutionLaw::ALL.into_iter().cycle()) {
        let part = |k: i32| f64::from(i * k % 97) / 97.0;
        let hoop = HoopParameters::thin(4.0 * part(31))
            .with_offset(0.1 + 0.9 * part(57))
            .with_inertia(0.2 + part(83))
            .with_restitution(1.0, law);
        let start = Start::at(6.0 * part(19), 4.0 - 8.0 * part(43)).with_gap_rate(part(71));
        let limits = Limits::until(30.0).with_transitions(60);
        let motion = Hoop::new(hoop).unwrap().simulate(start, limits).unwrap();
        for (it, _) in shown(&motion) {
            assert_eq!((it.energy_lost, it.impulse.friction), (0.0, 0.0), "{it:?}");
            assert!(it.impulse.normal > 0.0);
            impacts += 1;
        }
    }
    assert!(impacts > 1000, "{impacts}");
    let forever = find_case("bounces-forever").unwrap().simulate().unwrap();
    for (it, _) in shown(&forever).take(100) {
        assert_eq!(
            (it.before.slip, it.after.slip, it.energy_lost),
            (0.0, 0.0, 0.0)
        );
    }
}

/// The last of ever smaller bounces lose less than the energy is rounded by, which is about 1e-15
/// of it; their impulses are small, but known.
#[test]
fn what_is_more_than_rounding_is_shown_as_it_is() {
    let motion = bouncing("figure-3", 0.5, RestitutionLaw::Energetic);
    let all: Vec<_> = shown(&motion).collect();
    for (it, impact) in &all {
        assert_eq!(it.impulse, impact.impulse);
        assert_eq!((it.before, it.after), (impact.before, impact.after));
        let lost = impact.energy_lost();
        if lost > 1e-13 {
            assert_eq!(it.energy_lost, lost);
        } else if lost < 1e-15 {
            assert_eq!(it.energy_lost, 0.0);
        }
    }
    let (last, _) = all.last().unwrap();
    assert!((1e-8..1e-6).contains(&last.impulse.normal) && last.energy_lost == 0.0);
}

#[test]
fn the_end_of_bounces_is_told_with_their_number() {
    let motion = bouncing("figure-3", 0.5, RestitutionLaw::Energetic);
    let landings = motion
        .transitions()
        .iter()
        .filter(|it| it.cause == Cause::Landing)
        .count();
    let last = told(&motion).pop().unwrap();
    let expected = format!(
        "Settles: after {landings} bounces and infinitely many smaller ones, the rim stays at the plane, and it rolls."
    );
    assert_eq!(last, expected);
    // Two sequences of bounces are counted each by itself.
    let motion = bouncing("two-hops", 0.1, RestitutionLaw::Energetic);
    let mut since = 0;
    for (event, sentence) in motion.transitions().iter().zip(told(&motion)) {
        if event.cause == Cause::Landing {
            since += 1;
        } else if event.cause == Cause::Settle {
            assert!(
                sentence.starts_with(&format!("Settles: after {since} bounce")),
                "{sentence}"
            );
            since = 0;
        } else {
            assert_eq!(since, 0);
        }
    }
}

#[test]
fn a_jam_is_told_at_the_start_and_behind_every_transition_its_own_end() {
    let motion = find_case("jam").unwrap().simulate().unwrap();
    assert_eq!(
        sentence::start(&motion, PLAIN),
        "Jams at once: no motion is consistent with the start (Painlevé)."
    );
    let told = told(&motion);
    // From θ′ = −1/2, η′ = 1 to θ′ = −1, η′ = 0: m = 9/8, h = 8/9, I = 1/8 + 1/9.
    let (h, (sin, cos)) = (8.0 / 9.0, libm::sincos(0.5));
    let kinetic = |rate: f64, slip: f64| {
        let (vx, vy) = (slip - (1.0 + h * cos) * rate, -h * sin * rate);
        0.5 * (1.125 * (vx * vx + vy * vy) + (1.0 / 8.0 + 1.0 / 9.0) * rate * rate)
    };
    let percent = 100.0 * (1.0 - kinetic(-1.0, 0.0) / kinetic(-0.5, 1.0));
    let begin = "Jams: no motion is consistent here, and the plane ends the slip in an impact without a collision \
                 (Painlevé); ";
    let (number, end) = told[0]
        .strip_prefix(begin)
        .and_then(|rest| rest.split_once(" % "))
        .unwrap();
    assert!(
        (number.parse::<f64>().unwrap() - percent).abs() <= 0.05,
        "{} is not {percent}",
        told[0]
    );
    assert_eq!(
        end,
        "of its kinetic energy before the impact is lost, and it rolls."
    );
    for (text, begin) in told[1..].iter().zip([
        "Slips",
        "Sticks",
        "Slips",
        "Jumps",
        "Lands: slips, then sticks",
    ]) {
        assert!(text.starts_with(begin), "{text}");
    }
}

#[test]
fn a_gain_of_energy_is_told_and_no_loss_too() {
    let hoop = HoopParameters::thin(0.1)
        .with_inertia(0.0)
        .with_friction(1.0, 0.5)
        .with_restitution(1.0, RestitutionLaw::Newton);
    let start = Start::at(3.5, 1.0).with_slip(0.4).with_gap_rate(1.0);
    let motion = Hoop::new(hoop)
        .unwrap()
        .simulate(start, Limits::until(1.5))
        .unwrap();
    assert_eq!(
        sentence::start(&motion, PLAIN),
        "Is thrown: the rim leaves the plane at 1 √(gR)."
    );
    let text = &told(&motion)[0];
    assert!(
        text.contains("its kinetic energy grows by ") && text.contains("as Newton's law allows"),
        "{text}"
    );
    let forever = bouncing("bounces-forever", 1.0, RestitutionLaw::Energetic);
    assert!(
        told(&forever)
            .iter()
            .all(|text| text.contains("none of its kinetic energy is lost"))
    );
}

#[test]
fn a_landing_without_restitution_is_told_as_before_also_after_a_throw() {
    let setup = find_case("figure-3").unwrap().setup;
    let start = setup.start.with_gap_rate(0.25);
    let motion = Hoop::new(setup.hoop)
        .unwrap()
        .simulate(start, Limits::default())
        .unwrap();
    let text = sentence::outcome(&motion, PLAIN);
    assert!(
        text.starts_with("Lands ") && text.contains(" in the air, at most "),
        "{text}"
    );
}

#[test]
fn instants_name_every_event_once_and_lose_no_side() {
    for (case, restitution) in [
        ("figure-3", 0.0),
        ("figure-3", 0.5),
        ("two-hops", 0.0),
        ("two-hops", 0.7),
        ("jam", 0.0),
        ("jam", 0.5),
    ] {
        for law in RestitutionLaw::ALL {
            let motion = bouncing(case, restitution, law);
            let seen: Vec<_> = instants(&motion, Sampling::of(&motion, 50)).collect();
            let events: Vec<&str> = seen.iter().filter_map(|instant| instant.event).collect();
            let causes = motion.transitions().iter().map(|it| it.cause.name());
            assert_eq!(
                events,
                core::iter::once("start").chain(causes).collect::<Vec<_>>(),
                "{case}, {law}"
            );
            assert_eq!(seen[0].sample.state, motion.start());
            assert!(
                seen.windows(2)
                    .all(|pair| pair[0].sample.state.time <= pair[1].sample.state.time)
            );
            // Every jump is between two neighbours that are its sides.
            for event in motion.transitions() {
                let sides = seen.windows(2).filter(|pair| {
                    pair[0].sample.state == event.before && pair[1].sample.state == event.after
                });
                assert_eq!(
                    sides.count(),
                    1,
                    "{case}, {law}: {} at {}",
                    event.cause,
                    event.time()
                );
            }
        }
    }
}
