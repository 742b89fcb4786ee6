//! Against numbers computed elsewhere: the 40-digit table of Figure 3, the closed form of Figure 7,
//! and the motions and rolling times of `evidence/reference/`, integrated with mpmath from the full
//! Newton–Euler equations.
#![allow(clippy::disallowed_methods, clippy::panic, clippy::excessive_precision)] // expected values may come from the platform's mathematics

use std::f64::consts::PI;

use littlewood::cases::find_case;
use littlewood::modes::{Recurrence, RollingOrbit};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Sample, Start, State, Trajectory,
};
use serde_json::Value;

const MOTIONS: &str = include_str!("../../../evidence/reference/motions.json");
const SLIDES: &str = include_str!("../../../evidence/reference/slides.json");
const ROLLING: &str = include_str!("../../../evidence/reference/rolling.json");

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

fn hoop(value: &Value) -> Hoop {
    let get = |name: &str| value.get(name).map_or(0.0, number);
    Hoop::new(
        HoopParameters::thin(get("mass_ratio"))
            .with_offset(get("offset"))
            .with_inertia(get("inertia"))
            .with_friction(get("mu_s"), get("mu_k"))
            .with_slope(get("slope")),
    )
    .expect("a valid hoop")
}

#[track_caller]
fn close(name: &str, ours: f64, theirs: f64, tolerance: f64) {
    let error = (ours - theirs).abs();
    assert!(
        error <= tolerance * theirs.abs().max(1.0),
        "{name}: {ours} is not {theirs}, error {error:e}"
    );
}

fn case(name: &str) -> Trajectory {
    find_case(name)
        .expect("a named case")
        .simulate()
        .expect("a valid case")
}

#[test]
fn figure_3_has_the_times_of_the_40_digit_table() {
    // τ, θ, θ′, η′, x − x0 of stick, slip, lift-off, landing; the computation is described in
    // evidence/reference/README.md.
    #[rustfmt::skip]
    let table = [
        (Cause::Stick, [0.564107553101996750, 2.91722565678924913, 2.93644326144529653, 0.0, -1.42267101158774882]),
        (Cause::Slip, [0.973223074772405405, 4.06633287423929561, 2.46087950463497717, 0.0, -2.57177822903779530]),
        (Cause::LiftOff, [1.51867021381943700, 5.23673577087816789, 1.99870593711413988, 0.607696268534750732, -3.60928484639080078]),
    ];
    let motion = case("figure-3");
    for ((cause, expected), found) in table.iter().zip(motion.transitions()) {
        assert_eq!(*cause, found.cause);
        let s = found.before;
        for (ours, theirs) in [s.time, s.theta, s.theta_rate, s.slip, s.x]
            .into_iter()
            .zip(expected)
        {
            close(cause.name(), ours, *theirs, 2e-15);
        }
    }
    let Outcome::Landing { state, .. } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    close("landing", state.time, 3.847_395_556_686_894, 2e-15);
    close("landing", state.theta, 9.891_172_939_575_515, 2e-15);
    close("landing", state.theta_rate, 1.998_705_937_114_139_8, 2e-15);
}

#[test]
fn figure_7_has_its_closed_form() {
    let motion = case("figure-7");
    let slip = motion.transitions()[0];
    assert_eq!((slip.cause, slip.to), (Cause::Slip, Some(Mode::Gliding)));
    close("tau_s", slip.before.time, 5.0_f64.ln(), 1e-15);
    close("rate", slip.before.theta_rate, 0.75, 1e-15);
    close("cos theta_s", slip.before.theta.cos(), 0.6, 1e-15);
    let Outcome::ParticleAtPlane { state } = motion.outcome() else {
        panic!("{:?}", motion.outcome())
    };
    close(
        "tau_g",
        state.time,
        5.0_f64.ln() + (89.0_f64.sqrt() - 3.0) / 5.0,
        1e-15,
    );
}

#[test]
fn a_massless_hoop_from_the_top_unloads_when_the_notebook_says() {
    // A public notebook on m = r = 1 kg, m, g = 9.8 m/s², ω0 = 0.1 rad/s stops at N = 0:
    // arccosh(980)/√9.8 s.
    let rate = 0.1 / 9.8_f64.sqrt();
    let hoop = Hoop::littlewood(1e6, 0.0).expect("a valid hoop");
    let motion = hoop
        .simulate(Start::at(0.0, rate), Limits::default())
        .expect("a valid start");
    let first = motion.transitions()[0];
    assert_eq!(first.cause, Cause::NormalForceZero);
    let seconds = first.time() / 9.8_f64.sqrt();
    close("t", seconds, 2.421_57, 3e-6);
    close("t", seconds, 980.0_f64.acosh() / 9.8_f64.sqrt(), 1e-14);
}

/// 1e-12, and for a light hoop what rounding becomes where its particle passes the bottom: θ″ is of
/// the order of θ′² m/Î there.
fn tolerance(hoop: &Hoop) -> f64 {
    (1e-14 * hoop.mass() / hoop.body().inertia_about_mass_centre()).max(1e-12)
}

fn compare_sample(name: &str, ours: &Sample, theirs: &Value, tolerance: f64) {
    let get = |key: &str| number(&theirs[key]);
    for (key, value) in [
        ("theta", ours.state.theta),
        ("theta_rate", ours.state.theta_rate),
        ("slip", ours.state.slip),
        ("x", ours.state.x),
        ("normal", ours.normal),
        ("friction", ours.friction),
        ("energy", ours.energy),
    ] {
        close(&format!("{name} {key}"), value, get(key), tolerance);
    }
    for (key, value) in [("gap", ours.gap), ("gap_rate", ours.gap_rate)] {
        if !theirs[key].is_null() {
            close(&format!("{name} {key}"), value, get(key), tolerance);
        }
    }
}

#[test]
fn motions_agree_with_newton_euler_at_40_digits() {
    let data: Value = serde_json::from_str(MOTIONS).expect("evidence/reference/motions.json");
    let motions = data["motions"].as_array().expect("a list of motions");
    assert!(motions.len() >= 16);
    for reference in motions {
        let name = reference["name"].as_str().expect("a name");
        let start = &reference["start"];
        let start = Start::at(number(&start["theta"]), number(&start["theta_rate"]))
            .with_slip(number(&start["slip"]));
        let limits = Limits::until(number(&reference["until"]));
        let hoop = hoop(&reference["hoop"]);
        let tolerance = tolerance(&hoop);
        let motion = hoop.simulate(start, limits).expect("a valid start");

        let theirs = reference["transitions"]
            .as_array()
            .expect("a list of transitions");
        assert_eq!(
            motion.transitions().len(),
            theirs.len(),
            "{name}: {:?}",
            motion.transitions()
        );
        for (ours, theirs) in motion.transitions().iter().zip(theirs) {
            assert_eq!(
                ours.cause.name(),
                theirs["cause"].as_str().expect("a cause"),
                "{name}"
            );
            assert_eq!(ours.to.map(Mode::name), theirs["to"].as_str(), "{name}");
            let direction = ours.direction.map_or(0.0, littlewood::SlipDirection::sign);
            assert_eq!(
                direction,
                theirs["direction"].as_f64().unwrap_or(0.0),
                "{name}"
            );
            for (key, value) in [
                ("time", ours.before.time),
                ("theta", ours.before.theta),
                ("theta_rate", ours.before.theta_rate),
                ("slip", ours.before.slip),
                ("x", ours.before.x),
            ] {
                close(
                    &format!("{name} {} {key}", ours.cause),
                    value,
                    number(&theirs[key]),
                    tolerance,
                );
            }
        }
        for (phase, theirs) in motion
            .phases()
            .iter()
            .zip(reference["phases"].as_array().expect("a list of phases"))
        {
            assert_eq!(
                phase.mode().name(),
                theirs["mode"].as_str().expect("a mode"),
                "{name}"
            );
            for sample in theirs["samples"].as_array().expect("a list of samples") {
                let ours = motion
                    .at(number(&sample["time"]))
                    .expect("a time within the motion");
                compare_sample(name, &ours, sample, tolerance);
            }
        }
    }
}

/// Near the separatrix the time depends on the logarithm of the energy over the top, E − ℓ̂, of
/// which rounding leaves a relative error of a few ε/|E − ℓ̂| over.
fn near_separatrix(hoop: &Hoop, theta: f64, theta_rate: f64) -> f64 {
    let law = littlewood::theory::RollingLaw::new(hoop);
    4e-15 + 2.0 * f64::EPSILON / (law.energy(theta, theta_rate) - law.separatrix_energy()).abs()
}

#[test]
fn rolling_times_agree_with_quadrature() {
    let data: Value = serde_json::from_str(ROLLING).expect("evidence/reference/rolling.json");
    let arcs = data["arcs"].as_array().expect("a list of arcs");
    assert!(arcs.len() >= 20);
    for arc in arcs {
        let name = arc["name"].as_str().expect("a name");
        let (theta, rate) = (number(&arc["theta0"]), number(&arc["theta_rate0"]));
        let orbit = RollingOrbit::new(&hoop(arc), theta, rate).expect("no resistance");
        let (target, time) = (number(&arc["theta1"]), number(&arc["time"]));
        let tolerance = near_separatrix(&hoop(arc), theta, rate);
        let (reached, rate) = orbit.position(time);
        let moved = 4.0 * f64::EPSILON * target.abs() + rate.abs() * tolerance * (1.0 + time);
        assert!(
            (reached - target).abs() <= moved,
            "{name}: {reached} instead of {target}"
        );
    }
    for item in data["periods"].as_array().expect("a list of periods") {
        let name = item["name"].as_str().expect("a name");
        let (theta, rate) = (number(&item["theta0"]), number(&item["theta_rate0"]));
        let orbit = RollingOrbit::new(&hoop(item), theta, rate).expect("no resistance");
        let (kind, period) = match orbit.recurrence() {
            Recurrence::Rotation { period } => ("rotation", period),
            Recurrence::Libration { period, .. } => ("libration", period),
            other => panic!("{name}: {other:?}"),
        };
        assert_eq!(Some(kind), item["kind"].as_str(), "{name}");
        close(
            name,
            period,
            number(&item["period"]),
            near_separatrix(&hoop(item), theta, rate),
        );
    }
}

/// Slides of up to millions of turns, to the last digits: their ends and states on the way are
/// wrong by no more than a few units in the last place, and, as in the tests of the engine, by four
/// times what they move by when a number of the start moves by four. An angle has the last place of
/// a whole turn, which is rounded in each step.
#[test]
fn long_slides_agree_with_their_reference() {
    let slides: Value = serde_json::from_str(SLIDES).expect("valid JSON");
    let slides = slides["slides"].as_array().expect("slides");
    assert!(slides.len() >= 12);
    for slide in slides {
        let name = slide["name"].as_str().expect("a name");
        let get = |of: &str, key: &str| number(&slide[of][key]);
        let mu = get("hoop", "mu");
        let hoop = Hoop::new(
            HoopParameters::thin(get("hoop", "mass_ratio"))
                .with_offset(get("hoop", "offset"))
                .with_inertia(get("hoop", "inertia"))
                .with_friction(mu, mu),
        )
        .expect("a valid hoop");
        let start = ["theta", "theta_rate", "slip"].map(|key| get("start", key));
        let follow = |[theta, rate, slip]: [f64; 3]| {
            let start = Start::at(theta, rate).with_slip(slip);
            hoop.simulate(start, Limits::default().with_transitions(1))
                .expect("a valid start")
        };
        let nudged: Vec<Trajectory> = (0..3)
            .flat_map(|i| [-4.0, 4.0].map(|units| (i, units)))
            .map(|(i, units)| {
                let mut other = start;
                let size = if i == 0 {
                    other[i].abs().max(2.0 * PI)
                } else {
                    other[i].abs()
                };
                other[i] += units * 0.5 * f64::EPSILON * size;
                follow(other)
            })
            .collect();
        let motion = follow(start);
        assert!(number(&slide["passed"]) > 20.0, "{name}: not a long slide");
        let end = motion.transitions()[0];
        let expected_cause = slide["cause"].as_str();
        let cause = if end.before.slip == 0.0 {
            "stick"
        } else {
            end.cause.name()
        };
        assert_eq!(Some(cause), expected_cause, "{name}");
        let check = |what: &str, place: &Value, state_of: &dyn Fn(&Trajectory) -> State| {
            let ours = state_of(&motion);
            let keys = ["time", "theta", "theta_rate", "slip"];
            let parts = |s: State| [s.time, s.theta, s.theta_rate, s.slip];
            for (i, key) in keys.into_iter().enumerate() {
                let theirs = number(&place[key]);
                let moves = nudged
                    .iter()
                    .map(|other| 4.0 * (parts(state_of(other))[i] - parts(ours)[i]).abs());
                // The time of the reference is no double: states on the way are those at the
                // nearest one.
                let late = ours.time * f64::EPSILON * (1.0 + ours.theta_rate * ours.theta_rate);
                let tolerance = moves.fold(
                    8.0 * f64::EPSILON * (1.0 + theirs.abs()) + 4.0 * late,
                    f64::max,
                );
                let error = (parts(ours)[i] - theirs).abs();
                assert!(
                    error <= tolerance,
                    "{name}, {what}: {key} {} is not {theirs}, error {error:e}, allowed {tolerance:e}",
                    parts(ours)[i]
                );
            }
        };
        check("end", &slide["end"], &|motion| {
            motion.transitions()[0].before
        });
        for place in slide["places"].as_array().expect("places") {
            let time = number(&place["time"]);
            check("on the way", place, &|motion| {
                motion.phases()[0].sample(time).state
            });
        }
    }
}
