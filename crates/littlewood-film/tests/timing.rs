//! Number and timing of frames.

use littlewood::cases::find_case;
use littlewood::si::SiParameters;
use littlewood::{Hoop, Limits, OutcomeKind, Trajectory};
use littlewood_film::{FilmError, Pace, Part, Schedule, Shown};
use proptest::prelude::*;

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

#[test]
fn the_film_of_figure_3_runs_to_the_landing() {
    let schedule = Schedule::new(&motion("figure-3"), &PACE).unwrap();
    // 3.847395556686894 × 3 s × 25/s = 288.55 intervals: 289, and the frame at the start.
    assert_eq!(schedule.frames, 290);
    assert_eq!(schedule.time(0), 0.0);
    assert!((schedule.time(75) - 1.0).abs() < 1e-15);
    assert!((schedule.time(289) - 3.847_395_556_686_894).abs() < 1e-13);
    assert_eq!(schedule.shown(288).hold_ms, 0);
    assert_eq!(schedule.shown(289).hold_ms, 1500);
}

#[test]
fn an_oscillation_closes() {
    let schedule = Schedule::new(&motion("figure-2-libration"), &PACE).unwrap();
    assert!(schedule.closes());
    let period = schedule.end;
    let last = schedule.time(schedule.frames - 1);
    assert!(last < period && period - last <= schedule.step * (1.0 + 1e-9));
    assert_eq!(schedule.shown(schedule.frames - 1).hold_ms, 0);
    let motion = motion("figure-2-libration");
    let (start, end) = (
        motion.at(0.0).unwrap().state,
        motion.at(period).unwrap().state,
    );
    assert!((start.theta - end.theta).abs() < 1e-12 && (start.x - end.x).abs() < 1e-12);
}

#[test]
fn slow_counts_seconds_of_the_motion_in_si_units() {
    // √(R/g) = ½ s.
    let units = SiParameters {
        particle_mass_kg: 1.0,
        radius_m: 1.0,
        gravity_m_per_s2: 4.0,
        ..SiParameters::default()
    }
    .units()
    .unwrap();
    let motion = motion("figure-3");
    let schedule = Schedule::new(
        &motion,
        &Pace {
            slow: 8.0,
            units: Some(units),
            ..PACE
        },
    )
    .unwrap();
    let plain = Schedule::new(&motion, &Pace { slow: 4.0, ..PACE }).unwrap();
    assert_eq!(schedule, plain);
}

#[test]
fn a_rotation_is_shown_for_two_turns_and_a_limit_is_kept() {
    let case = find_case("rolls-forever").unwrap();
    let endless = case.simulate().unwrap();
    let schedule = Schedule::new(&endless, &PACE).unwrap();
    let turned = endless.at(schedule.end).unwrap().state.theta - endless.start().theta;
    assert!(
        (turned.abs() - 4.0 * std::f64::consts::PI).abs() < 1e-12,
        "{turned}"
    );
    let limited = littlewood::Hoop::new(case.setup.hoop)
        .unwrap()
        .simulate(case.setup.start, Limits::until(1.0))
        .unwrap();
    assert_eq!(Schedule::new(&limited, &PACE).unwrap().end, 1.0);
}

#[test]
fn bad_values_are_refused() {
    let motion = motion("figure-3");
    let refused = |pace: Pace| Schedule::new(&motion, &pace).unwrap_err();
    for fps in [0, 241, u32::MAX] {
        assert!(matches!(
            refused(Pace { fps, ..PACE }),
            FilmError::FrameRate { .. }
        ));
    }
    for slow in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            refused(Pace { slow, ..PACE }),
            FilmError::Slow { .. }
        ));
    }
    for hold in [-1.0, 61.0, f64::NAN] {
        assert!(matches!(
            refused(Pace {
                hold_s: Some(hold),
                ..PACE
            }),
            FilmError::Hold { .. }
        ));
    }
    for slow in [1e9, 1e308] {
        assert!(matches!(
            refused(Pace { slow, ..PACE }),
            FilmError::TooLong { .. }
        ));
    }
    let still = find_case("painleve").unwrap().simulate().unwrap();
    assert!(matches!(
        Schedule::new(&still, &PACE),
        Err(FilmError::NoMotion {
            outcome: OutcomeKind::Inconsistent
        })
    ));
    // Faster than a frame: the start and the end.
    assert_eq!(
        Schedule::new(&motion, &Pace { slow: 1e-9, ..PACE })
            .unwrap()
            .frames,
        2
    );
}

proptest! {
    #[test]
    fn hundredths_of_a_second_do_not_drift(fps in 1_u32..=50, frames in 1_u64..5000) {
        let mut total = 0;
        for index in 0..frames {
            let delay = Shown { index, fps, hold_ms: 0 }.centiseconds();
            prop_assert!(delay >= 2);
            total += delay;
        }
        let exact = 100.0 * frames as f64 / f64::from(fps);
        prop_assert!((total as f64 - exact).abs() <= 0.5);
    }
}

#[test]
fn a_film_of_a_hoop_that_rests_stops_shortly_after() {
    let case = find_case("figure-2-libration").expect("a named case").setup;
    let schedule = |chi: f64| {
        let hoop = Hoop::new(case.hoop.with_rolling_resistance(chi)).expect("a hoop");
        let motion = hoop
            .simulate(case.start, Limits::default())
            .expect("a motion");
        assert_eq!(motion.outcome().kind(), OutcomeKind::Rests);
        let schedule = Schedule::new(&motion, &PACE).expect("a film");
        (motion.outcome().state().time, schedule)
    };
    let (since, film) = schedule(0.05);
    assert_eq!((film.end, film.part), (since + 0.1 * since, Part::Whole));
    assert_eq!(film.shown(film.frames - 1).hold_ms, 1500);
    // 155 half swings are not waited for.
    let (since, film) = schedule(1e-3);
    assert!(since > 500.0 && film.end == 30.0);
    let says = film
        .part
        .label()
        .is_some_and(|label| label.contains("comes to rest"));
    assert!(says, "{:?}", film.part);
}
