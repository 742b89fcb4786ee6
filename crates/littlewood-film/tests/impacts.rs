//! Impacts in films: the energy adds up, and impulses are to scale.

use crate::filmed;
use littlewood::cases::find_case;
use littlewood::energy::{EnergyLedger, EnergyParts};
use littlewood::tables::Setup;
use littlewood::{
    Hoop, HoopParameters, Limits, Mode, OutcomeKind, RestitutionLaw, Start, Trajectory,
};
use littlewood_film::{Film, FrameSize, Framing, GifFilm, Pace, Schedule, With};
use littlewood_random::jam_after_a_stick;

const PACE: Pace = Pace {
    fps: 25,
    slow: 3.0,
    units: None,
    hold_s: None,
};

fn motion(name: &str) -> Trajectory {
    find_case(name)
        .expect("a named case")
        .simulate()
        .expect("it can be simulated")
}

fn film<'a>(motion: &'a Trajectory, pace: &Pace) -> Film<'a> {
    let size = FrameSize::new(320, 180).expect("a size");
    Film::new(motion, pace, size, Framing::Auto).expect("it can be made")
}

/// What the energy of the start has become at each frame.
fn energies(motion: &Trajectory, film: &Film<'_>) -> Vec<EnergyParts> {
    let ledger = EnergyLedger::new(motion).expect("a motion");
    (0..film.schedule().frames)
        .filter_map(|index| {
            let sample = film.scene(index).expect("it can be made").sample;
            ledger.parts(&sample)
        })
        .collect()
}

/// The mass centre's and the rotation's part, from positions by finite differences: an independent
/// kinetic energy.
fn kinetic(motion: &Trajectory, time: f64, step: f64) -> Option<f64> {
    let [before, now, after] = [time - step, time, time + step].map(|time| motion.at(time));
    let (before, now, after) = (before?, now?, after?);
    let is_smooth = motion
        .transitions()
        .iter()
        .all(|transition| (transition.time() - time).abs() > step);
    let rate = |f: fn(&littlewood::Sample) -> f64| (f(&after) - f(&before)) / (2.0 * step);
    let hoop = motion.hoop();
    let (vx, vy) = (rate(|s| s.mass_centre.x), rate(|s| s.mass_centre.y));
    let about = hoop.inertia() + hoop.mass_ratio() * hoop.offset() * hoop.offset() / hoop.mass();
    let spin = now.state.theta_rate;
    is_smooth.then(|| 0.5 * hoop.mass() * (vx * vx + vy * vy) + 0.5 * about * spin * spin)
}

#[test]
fn the_parts_add_up_to_the_energy_at_the_start() {
    for (case, motion) in filmed() {
        let film = film(&motion, &PACE);
        let mut checked = 0;
        for (index, parts) in energies(&motion, &film).into_iter().enumerate() {
            let EnergyParts {
                kinetic: moving,
                potential,
                friction,
                rolling_resistance,
                impacts,
                start,
            } = parts;
            let sum = moving + potential + friction + rolling_resistance + impacts;
            assert!(
                (sum - start).abs() < 1e-11 * start.max(1.0),
                "{case} {index}: {sum} and {start}"
            );
            assert!(moving >= 0.0 && friction >= 0.0, "{case} {index}");
            let time = film.schedule().time(index as u64);
            if let Some(wanted) = kinetic(&motion, time, 1e-5).filter(|wanted| *wanted < 1e3) {
                assert!(
                    (moving - wanted).abs() < 1e-6 * wanted.max(1.0),
                    "{case} {index}: {moving}"
                );
                checked += 1;
            }
        }
        assert!(checked > 20, "{case}: {checked}");
    }
}

#[test]
fn impacts_take_what_the_notes_say() {
    // Figure 3 lands with 7.822…; e = 0 takes 4.27572946865290831 of it, e = 0.5 takes
    // 3.36244341922728.
    for (e, lost) in [(0.0, 4.275_729_468_652_908), (0.5, 3.362_443_419_227_28)] {
        let case = find_case("figure-3").unwrap();
        let hoop = Hoop::new(
            case.setup
                .hoop
                .with_restitution(e, RestitutionLaw::Energetic),
        )
        .unwrap();
        let motion = hoop.simulate(case.setup.start, Limits::until(4.5)).unwrap();
        let film = film(&motion, &PACE);
        let last = energies(&motion, &film).pop().unwrap();
        assert!((last.impacts - lost).abs() < 1e-11, "{e}: {}", last.impacts);
        assert!((last.start - 8.0).abs() < 1e-13, "E (2.8) of Figure 3");
        let first = energies(&motion, &film)[0];
        assert_eq!((first.friction, first.impacts), (0.0, 0.0));
    }
}

#[test]
fn an_impulse_is_an_arrow_at_the_instant_and_to_scale() {
    let motion = motion("figure-3-bounces");
    let film = film(&motion, &PACE);
    let landing = motion
        .transitions()
        .iter()
        .find(|transition| transition.impact.is_some())
        .unwrap();
    let impact = landing.impact.unwrap();
    let mut frames = 0;
    for index in 0..film.schedule().frames {
        let (time, scene) = (film.schedule().time(index), film.scene(index).unwrap());
        assert!(
            scene.impulse.is_none() || time >= landing.time(),
            "not before the impact"
        );
        if let Some(drawn) = scene
            .impulse
            .filter(|drawn| drawn.impulse == impact.impulse)
        {
            frames += 1;
            assert_eq!(drawn.tail.y, 0.0);
            assert!(
                (drawn.tail.x - landing.before.x).abs() < 1e-14,
                "at the point of contact"
            );
            let scale = film.scale().impulse;
            let extent = (drawn.head.x - drawn.tail.x, drawn.head.y - drawn.tail.y);
            assert!((extent.0 - scale * impact.impulse.friction).abs() < 1e-13);
            assert!((extent.1 - scale * impact.impulse.normal).abs() < 1e-13);
            assert_eq!(drawn.case, impact.case);
            // 3 s of film for a unit of time.
            assert!(time - landing.time() < 0.8 / 3.0 + 1e-9, "{time}");
        }
    }
    assert!(
        (19..=21).contains(&frames),
        "0.8 s at 25 frames a second: {frames}"
    );
}

/// A stick leads to a jam, which ends no phase.
#[test]
fn the_impulse_of_a_jam_to_which_a_stick_leads_is_seen() {
    let Setup { hoop, start } = jam_after_a_stick();
    let motion = Hoop::new(hoop)
        .unwrap()
        .simulate(start, Limits::until(20.0))
        .unwrap();
    let jam = motion.transitions().last().unwrap();
    assert!(jam.from.is_none(), "{jam:?}");
    let film = film(&motion, &PACE);
    let drawn = (0..film.schedule().frames).find_map(|index| film.scene(index).unwrap().impulse);
    assert_eq!(drawn.unwrap().impulse, jam.impact.unwrap().impulse);
}

/// Films of hoops that bounce in every way, in which nothing may go wrong.
#[test]
#[ignore = "thorough"]
fn every_hoop_has_a_film() {
    let e = |parameters: HoopParameters, e: f64| {
        parameters.with_restitution(e, RestitutionLaw::Energetic)
    };
    let thin = |m1: f64| HoopParameters::thin(m1).with_friction(0.5, 0.4);
    let balanced = HoopParameters::thin(1.0)
        .with_offset(0.0)
        .with_friction(0.5, 0.4);
    let rest = std::f64::consts::PI;
    let newton = HoopParameters::thin(0.5)
        .with_friction(1.5, 1.5)
        .with_restitution(0.9, RestitutionLaw::Newton);
    for (what, parameters, start, until) in [
        (
            "balanced, thrown",
            e(balanced, 0.6),
            Start::at(0.0, 1.0).with_gap_rate(1.0),
            None,
        ),
        (
            "balanced, for ever",
            e(balanced, 1.0),
            Start::at(0.0, 0.0).with_gap_rate(1.0),
            None,
        ),
        ("light", e(thin(1e-3), 0.5), Start::at(1.0, 2.0), Some(10.0)),
        ("at rest", e(thin(1.0), 0.5), Start::at(rest, 0.0), None),
        (
            "at rest, tiny throw",
            e(thin(1.0), 0.5),
            Start::at(rest, 0.0).with_gap_rate(1e-9),
            Some(3.0),
        ),
        (
            "spinning",
            e(thin(1.0), 0.5),
            Start::at(0.0, 6.0),
            Some(8.0),
        ),
        (
            "Newton",
            newton,
            Start::at(0.3, 1.0).with_slip(1.5).with_gap_rate(0.8),
            Some(6.0),
        ),
        (
            "slow",
            e(thin(1.0), 0.9),
            Start::at(2.0, 1e-3).with_gap_rate(1e-3),
            Some(2.0),
        ),
        (
            "without friction",
            e(thin(1.0).with_friction(0.0, 0.0), 0.5),
            Start::at(1.0, 4.0),
            Some(8.0),
        ),
    ] {
        let motion = Hoop::new(parameters)
            .unwrap()
            .simulate(start, Limits::default().with_until(until))
            .unwrap_or_else(|error| panic!("{what}: {error}"));
        for with in [None, Some(With::Energy)] {
            let pace = Pace {
                fps: 5,
                slow: 1.0,
                ..PACE
            };
            let plain = film(&motion, &pace);
            let film = match with {
                None => plain,
                Some(with) => plain.with_pane(with),
            };
            let mut encoder = GifFilm::new(Vec::new(), &film).unwrap();
            film.play(&mut encoder, |_| true)
                .unwrap_or_else(|error| panic!("{what}: {error}"));
            for parts in energies(&motion, &film) {
                let sum = parts.kinetic + parts.potential + parts.friction + parts.impacts;
                assert!(
                    (sum - parts.start).abs() < 1e-10 * parts.start.max(1.0),
                    "{what}: {parts:?}"
                );
            }
        }
    }
}

#[test]
fn a_motion_that_bounces_for_ever_is_shown_for_some_bounces() {
    let motion = motion("bounces-forever");
    assert_eq!(motion.outcome().kind(), OutcomeKind::TransitionLimit);
    let schedule = Schedule::new(&motion, &PACE).unwrap();
    let landings = motion
        .transitions()
        .iter()
        .filter(|landing| landing.time() <= schedule.end)
        .count();
    assert!((4..=16).contains(&landings), "{landings}");
    assert!(
        motion
            .phases()
            .iter()
            .all(|phase| phase.mode() == Mode::Flight)
    );
}
