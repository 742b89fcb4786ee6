//! Rolling resistance, against `evidence/reference/resistance.json`: motions by Newton's and Euler's
//! equations alone, with 30 digits; and against the closed forms of docs/theory/rolling-resistance.md.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use littlewood::energy::EnergyLedger;
use littlewood::modes::Recurrence;
use littlewood::theory::{ContactForces, PhasePlane, RollingLaw, SlidingLaw};
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, Phase, RestitutionLaw,
    RotationDirection, Sample, SlipDirection, Start, State, Trajectory, Transition,
};
use littlewood_random::Draw;
use serde_json::Value;
use std::f64::consts::{PI, TAU};

/// Gap rate of a slow bounce.
const SLOW: f64 = -1e-3;

const REFERENCE: &str = include_str!("../../../evidence/reference/resistance.json");

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
}

fn name(value: &Value) -> &str {
    value.as_str().expect("a name")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

/// The hoop and the start of a motion of the reference.
fn setup(reference: &Value) -> (Hoop, Start) {
    let get = |name: &str| number(&reference["hoop"][name]);
    let mut parameters = HoopParameters::thin(get("mass_ratio"))
        .with_offset(get("offset"))
        .with_inertia(get("inertia"))
        .with_friction(get("mu_s"), get("mu_k"))
        .with_rolling_resistance(get("rolling_resistance"))
        .with_slope(get("slope"));
    if let Some(law) = reference["law"].as_str() {
        let law = law.parse().expect("a law");
        parameters = parameters.with_restitution(number(&reference["restitution"]), law);
    }
    let get = |name: &str| number(&reference["start"][name]);
    let start = Start::at(get("theta"), get("theta_rate"))
        .with_slip(get("slip"))
        .with_gap_rate(get("gap_rate"));
    (Hoop::new(parameters).expect("a valid hoop"), start)
}

/// What a motion is called in the comparison, and how far it may be from the reference.
struct Comparison {
    name: String,
    tolerance: f64,
}

impl Comparison {
    #[track_caller]
    fn close(&self, what: &str, ours: f64, theirs: &Value) {
        let theirs = number(theirs);
        let error = (ours - theirs).abs();
        assert!(
            error <= self.tolerance * theirs.abs().max(1.0),
            "{} {what}: {ours} is not {theirs}, error {error:e}",
            self.name
        );
    }

    fn state(&self, what: &str, ours: &State, theirs: &Value) {
        for (key, value) in [
            ("time", ours.time),
            ("theta", ours.theta),
            ("theta_rate", ours.theta_rate),
            ("slip", ours.slip),
            ("x", ours.x),
        ] {
            self.close(&format!("{what} {key}"), value, &theirs[key]);
        }
    }

    fn sample(&self, what: &str, ours: &Sample, theirs: &Value) {
        self.state(what, &ours.state, theirs);
        for (key, value) in [
            ("normal", ours.normal),
            ("friction", ours.friction),
            ("couple", ours.couple),
            ("energy", ours.energy),
        ] {
            self.close(&format!("{what} {key}"), value, &theirs[key]);
        }
    }

    /// The public laws of rolling and of sliding, and the phase plane.
    fn laws(&self, hoop: &Hoop, ours: &Sample, theirs: &Value) {
        let (theta, rate) = (ours.state.theta, ours.state.theta_rate);
        let close = |law: &str, forces: ContactForces, theta_acceleration: Option<f64>| {
            self.close(law, forces.normal, &theirs["normal"]);
            self.close(law, forces.friction, &theirs["friction"]);
            // The reference has no accelerations; ours obeys Euler's equation.
            let [normal, friction, couple] =
                ["normal", "friction", "couple"].map(|name| number(&theirs[name]));
            let (sin, cos) = theta.sin_cos();
            let moment = hoop.h() * sin * normal + (1.0 + hoop.h() * cos) * friction + couple;
            for value in theta_acceleration
                .into_iter()
                .chain([ours.theta_acceleration])
            {
                let error = (hoop.body().inertia_about_mass_centre() * value - moment).abs();
                assert!(
                    error <= self.tolerance * normal.abs().max(1.0),
                    "{law} {}",
                    self.name
                );
            }
        };
        match ours.mode {
            Mode::Rolling | Mode::Rest => {
                let law = RollingLaw::new(hoop);
                let forces = law.forces(theta, rate);
                close(
                    "RollingLaw",
                    forces,
                    Some(law.theta_acceleration(theta, rate)),
                );
                close(
                    "PhasePlane",
                    PhasePlane::new(hoop).forces(theta, rate),
                    None,
                );
            }
            Mode::Sliding => {
                let slip = ours.direction.expect("slips");
                let rotation = RotationDirection::of_sign(rate).expect("turns");
                let law = SlidingLaw::new(hoop, slip, rotation).expect("heavy");
                let found = law.accelerations(theta, rate);
                close("SlidingLaw", law.forces(theta, rate), Some(found.theta));
            }
            Mode::Skidding | Mode::Flight | Mode::Gliding => {}
        }
    }

    /// The energy lost, and where there is no impact what rolling resistance has taken.
    fn energies(&self, ours: &Trajectory, reference: &Value) {
        let Some(first) = ours.phases().first() else {
            return;
        };
        let lost =
            ["resistance", "sliding", "restitution"].map(|cause| number(&reference["lost"][cause]));
        let total: f64 = lost.iter().sum();
        // The energy at the start is that before a jam at the start.
        let jammed = ours.transitions().first().filter(|it| it.from.is_none());
        let jammed = jammed.map_or(0.0, |it| it.impact.expect("a jam").energy_lost());
        let start = first.first().energy + jammed;
        let last = ours.phases().last().and_then(Phase::last);
        let Some(last) = last.map(|sample| sample.energy) else {
            return;
        };
        let differs =
            |ours: f64, theirs: f64| (ours - theirs).abs() > self.tolerance * (1.0 + start.abs());
        assert!(
            !differs(start - last, total),
            "{}: {} {total}",
            self.name,
            start - last
        );
        assert!(
            !differs(ours.energy_lost(), total),
            "{}: {} {total}",
            self.name,
            ours.energy_lost()
        );
        if reference["law"].is_null() && ours.outcome().kind() != OutcomeKind::Landing {
            let resisted = ours
                .phases()
                .iter()
                .map(Phase::rolling_resistance_energy_lost);
            let resisted: f64 = resisted.sum();
            assert!(
                !differs(resisted, lost[0]),
                "{}: {resisted} {}",
                self.name,
                lost[0]
            );
        }
    }

    fn transitions(&self, ours: &Trajectory, theirs: &[Value]) {
        // The reference counts slow bounces, and lists none.
        let is_slow = |it: &&Transition| {
            let impact = it.impact.filter(|_| it.is_bounce());
            impact.is_some_and(|impact| impact.before.gap_rate > SLOW)
        };
        let found = ours.transitions().iter().filter(|it| !is_slow(it));
        let found: Vec<&Transition> = found.collect();
        assert_eq!(found.len(), theirs.len(), "{}: {found:?}", self.name);
        for (ours, theirs) in found.into_iter().zip(theirs) {
            let cause = match name(&theirs["cause"]) {
                "turning" => "turning_point",
                cause => cause,
            };
            assert_eq!(ours.cause.name(), cause, "{}", self.name);
            let to = theirs["to"]["mode"].as_str();
            assert_eq!(ours.to.map(Mode::name), to, "{}", self.name);
            let direction = f64::from(SlipDirection::code(ours.direction));
            let expected = theirs["to"]["direction"].as_f64().unwrap_or(0.0);
            assert_eq!(direction, expected, "{}", self.name);
            if ours.cause == Cause::Settle {
                // The state before is that before all bounces that the library sums.
                self.close("settle time", ours.before.time, &theirs["time"]);
                self.close("settle theta", ours.before.theta, &theirs["theta"]);
            } else {
                self.state(cause, &ours.before, theirs);
            }
            if let Some(after) = theirs.get("after").filter(|after| !after.is_null()) {
                self.close(
                    "theta_rate after",
                    ours.after.theta_rate,
                    &after["theta_rate"],
                );
                self.close("slip after", ours.after.slip, &after["slip"]);
            }
        }
    }

    /// What each kind of friction has taken up to each transition.
    fn losses(&self, ours: &Trajectory, theirs: &[Value]) {
        let Some(ledger) = EnergyLedger::new(ours) else {
            return;
        };
        for (transition, theirs) in ours.transitions().iter().zip(theirs) {
            // The last one may end the motion: there is no instant after it.
            let time = transition.time().min(ours.end_time());
            let sample = ours.at(time).expect("an instant of the motion");
            let parts = ledger.parts(&sample).expect("an instant of the motion");
            for (key, part) in [
                ("resistance", parts.rolling_resistance),
                ("sliding", parts.friction),
            ] {
                self.close(&format!("{time} {key}"), part, &theirs["lost"][key]);
            }
        }
    }
}

/// The motions of the reference that the library follows, compared with it.
fn compare() -> usize {
    let data: Value = serde_json::from_str(REFERENCE).expect("evidence/reference/resistance.json");
    let mut count = 0;
    for (place, reference) in list(&data["motions"]).iter().enumerate() {
        let (hoop, start) = setup(reference);
        let comparison = Comparison {
            name: format!("{} {place}", name(&reference["family"])),
            tolerance: 1e-12,
        };
        let limits = Limits::until(number(&reference["until"]));
        let motion = hoop.simulate(start, limits).expect("a valid start");
        comparison.transitions(&motion, list(&reference["transitions"]));
        for theirs in list(&reference["phases"]) {
            let sample = &theirs["sample"];
            let time = number(&sample["time"]);
            let ours = motion.at(time).expect("an instant of the motion");
            let mode = ours.mode.name();
            assert_eq!(mode, name(&theirs["mode"]), "{}", comparison.name);
            comparison.sample(mode, &ours, sample);
            comparison.laws(&hoop, &ours, sample);
        }
        comparison.energies(&motion, reference);
        if reference["law"].is_null() {
            comparison.losses(&motion, list(&reference["transitions"]));
            let swings = half_swings(reference);
            let summary = motion.summary();
            assert_eq!(summary.half_swings, swings, "{}", comparison.name);
            if let Outcome::Rests { half_swings, .. } = motion.outcome() {
                assert_eq!(half_swings, swings as usize, "{}", comparison.name);
            }
        }
        let ended = motion.outcome().kind().name();
        match name(&reference["ended"]) {
            "none" => assert_eq!(ended, "inconsistent", "{}", comparison.name),
            // The library may know that a motion goes on as it does for ever.
            "time_limit" => {
                assert!(["time_limit", "rolls_forever", "slides_forever"].contains(&ended));
            }
            theirs => assert_eq!(ended, theirs, "{}", comparison.name),
        }
        count += 1;
    }
    count
}

/// Rolls of a motion of the reference from one turning point to the next.
fn half_swings(reference: &Value) -> u32 {
    let transitions = list(&reference["transitions"]);
    let starts = [&reference["start"]].into_iter().chain(transitions);
    let swings = starts
        .zip(list(&reference["phases"]))
        .zip(transitions)
        .filter(|((start, phase), end)| {
            number(&start["theta_rate"]) == 0.0
                && name(&phase["mode"]) == "rolling"
                && name(&end["cause"]) == "turning"
        });
    u32::try_from(swings.count()).expect("a count")
}

#[test]
fn motions_agree_with_newton_euler_at_30_digits() {
    assert_eq!(compare(), 164);
}

/// m̂1 = 1, ℓ̂ = ½, Îzz = 0.8.
fn usual(mu: f64, chi: f64, slope: f64) -> Hoop {
    let parameters = HoopParameters::thin(1.0)
        .with_offset(0.5)
        .with_inertia(0.8)
        .with_friction(mu, mu)
        .with_rolling_resistance(chi)
        .with_slope(slope);
    Hoop::new(parameters).expect("a valid hoop")
}

fn simulate(hoop: &Hoop, start: Start, limits: Limits) -> Trajectory {
    hoop.simulate(start, limits).expect("a valid start")
}

fn close(ours: f64, theirs: f64, tolerance: f64) {
    assert!((ours - theirs).abs() <= tolerance, "{ours} is not {theirs}");
}

#[test]
fn a_small_half_swing_loses_twice_the_resistance_over_h() {
    let (hoop, turned) = (usual(1.0, 1e-6, 0.0), 3e-3);
    let motion = simulate(&hoop, Start::at(PI - turned, 0.0), Limits::default());
    let amplitudes = motion
        .transitions()
        .iter()
        .map(|it| (it.before.theta - PI).abs());
    let amplitudes: Vec<f64> = std::iter::once(turned).chain(amplitudes).collect();
    let lost = 2e-6 / hoop.h();
    assert!(amplitudes.len() > 300);
    for pair in amplitudes.windows(2) {
        // The next terms are smaller by a² and by χ; the last one may stay on its side.
        close(
            pair[1],
            (pair[0] - lost).abs(),
            lost * (pair[0] * pair[0] + 1e-5),
        );
    }
    let Outcome::Rests { half_swings, since } = motion.outcome() else {
        unreachable!("{:?}", motion.outcome())
    };
    assert_eq!(half_swings + 1, amplitudes.len());
    assert!((since.theta - PI).abs() <= 1.000_001e-6 / hoop.h());
    assert_eq!(motion.summary().sequence.to_string(), "R0");
    // For ever.
    let later = motion.at(1e9).expect("rest has no end");
    assert_eq!((later.mode, later.state.theta), (Mode::Rest, since.theta));
}

/// {eq}`eq-half-swing` of docs/theory/rolling-resistance.md, by Simpson's rule.
#[test]
fn a_large_half_swing_loses_what_the_theory_says_to_first_order() {
    let (chi, start) = (1e-5, 1.0_f64);
    let hoop = usual(1.0, chi, 0.0);
    let HoopParameters {
        offset,
        inertia,
        mass_ratio,
        ..
    } = hoop.parameters();
    let (mass, h) = (hoop.mass(), hoop.h());
    let mean = 1.0 + mass_ratio + inertia + offset * offset;
    let level = mean - 2.0 * offset * start.cos();
    let integrand = |angle: f64| angle.cos() / (mean - 2.0 * offset * angle.cos());
    let count = 1000;
    let width = 2.0 * start / f64::from(count);
    let weight = |k: i32| {
        if k == 0 || k == count {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let sum: f64 = (0..=count)
        .map(|k| weight(k) * integrand(width * f64::from(k) - start))
        .sum();
    let bracket = 2.0 * start - h * start.sin() + 0.5 * h * level * (width / 3.0 * sum);
    let expected = chi * mass * bracket / (offset * start.sin());
    let motion = simulate(&hoop, Start::at(PI - start, 0.0), Limits::default());
    let turned = motion.transitions()[0].before.theta - PI;
    close(start - turned, expected, 5.0 * chi * expected);
}

/// It rolls with θ″ = m (gt − ς χ gn)/(Î + m), and on the level it can slip by its own resistance.
#[test]
fn a_disc_has_its_closed_forms() {
    let disc = |mu_s: f64, mu_k: f64, chi: f64, slope: f64| {
        let parameters = HoopParameters::thin(1.0)
            .with_offset(0.0)
            .with_inertia(0.5)
            .with_friction(mu_s, mu_k)
            .with_rolling_resistance(chi)
            .with_slope(slope);
        Hoop::new(parameters).expect("a valid hoop")
    };
    let (mass, inertia) = (2.0, 0.5);
    for slope in [0.0, 0.05, -0.2] {
        let hoop = disc(0.6, 0.5, 0.1, slope);
        let (along, normal) = slope.sin_cos();
        let braking = mass * (along - 0.1 * normal) / (inertia + mass);
        let motion = simulate(&hoop, Start::at(0.3, 1.0), Limits::default());
        let first = motion.phases()[0].first();
        close(first.theta_acceleration, braking, 1e-15);
        if braking < 0.0 {
            close(motion.transitions()[0].time(), -1.0 / braking, 1e-13);
        }
    }
    // χ m > μs (Î + m).
    let slips = simulate(
        &disc(0.2, 0.2, 0.3, 0.0),
        Start::at(0.0, 1.0),
        Limits::default(),
    );
    assert_eq!(slips.phases()[0].mode(), Mode::Sliding);
    // It skids if and only if μk ≤ χ, equality included.
    for (mu_k, mode) in [(0.3, Mode::Skidding), (0.31, Mode::Sliding)] {
        let motion = simulate(
            &disc(0.4, mu_k, 0.3, 0.0),
            Start::at(0.0, 0.0).with_slip(1.0),
            Limits::default(),
        );
        assert_eq!(motion.phases()[0].mode(), mode);
    }
}

#[test]
fn a_level_hoop_with_more_resistance_than_h_rests_anywhere() {
    for theta in [0.3, PI / 2.0, 2.0, -1.0] {
        let hoop = usual(0.3, 0.25, 0.0);
        let motion = simulate(&hoop, Start::at(theta, 0.0), Limits::default());
        assert_eq!(motion.outcome().kind(), OutcomeKind::Rests, "{theta}");
    }
}

/// Where the reference has the rate of a rotation.
const SECTION: f64 = 0.0;

/// The rotations of the reference: the square of the rate over the bottom of the turn, the period
/// and the contraction of the periodic rotation down a slope.
/// With so much static friction the slip begins where N is next to nothing beside its terms: without
/// kinetic friction the momentum along the plane stays what it is all the same.
#[test]
fn a_slip_at_huge_static_friction_without_kinetic_keeps_the_momentum() {
    for resistance in [8.6e-11, 1e-3, 0.1] {
        let hoop = HoopParameters::thin(4.9)
            .with_offset(0.51)
            .with_inertia(2.0)
            .with_friction(2.4e8, 0.0)
            .with_rolling_resistance(resistance);
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let motion = simulate(&hoop, Start::at(2.9, 1e6), Limits::until(1e-5));
        let [slip, next, ..] = motion.transitions() else {
            panic!("{motion:?}");
        };
        assert_eq!(slip.cause, Cause::Slip);
        let along =
            |state: State| state.slip - (1.0 + hoop.h() * state.theta.cos()) * state.theta_rate;
        let (before, after) = (along(slip.before), along(next.before));
        assert!((after / before - 1.0).abs() < 1e-14, "{before} {after}");
    }
}

#[test]
fn rotations_downhill_approach_the_periodic_one() {
    let data: Value = serde_json::from_str(REFERENCE).expect("evidence/reference/resistance.json");
    for rotation in list(&data["rotations"]) {
        let get = |k: usize| number(&rotation["hoop"][k]);
        let parameters = HoopParameters::thin(get(0))
            .with_offset(get(1))
            .with_inertia(get(2))
            .with_friction(get(3), get(4))
            .with_rolling_resistance(get(5))
            .with_slope(get(6));
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let [contraction, square_rate, period] =
            ["contraction", "square_rate", "period"].map(|key| number(&rotation[key]));
        for factor in [0.95, 1.0, 1.1] {
            let rate = (factor * square_rate).sqrt().copysign(get(6));
            let start = Start::at(SECTION, rate);
            let motion = simulate(&hoop, start, Limits::default());
            let outcome = motion.outcome();
            let Outcome::RollsForever {
                recurrence: Recurrence::Rotation { period: found },
                ..
            } = outcome
            else {
                unreachable!("{rotation} {factor}: {outcome:?}")
            };
            // Rounding of a turn adds up over the turns that remember it.
            close(found, period, 4e-14 / (1.0 - contraction));
            // After many periods it is the periodic rotation to rounding.
            let at = |time: f64| motion.at(time).expect("no end").state;
            let [now, later] = [1e6, 1e6 + 5.0 * period].map(at);
            close((later.theta - now.theta).abs(), 5.0 * TAU, 1e-8);
            close(later.theta_rate, now.theta_rate, 1e-8);
        }
    }
}

#[test]
fn what_all_but_lasts_for_ever_is_a_limit() {
    let disc = |mu: f64, chi: f64| {
        let parameters = HoopParameters::thin(1.0)
            .with_offset(0.0)
            .with_inertia(0.5)
            .with_friction(mu, mu)
            .with_rolling_resistance(chi);
        Hoop::new(parameters).expect("a valid hoop")
    };
    let skids = simulate(
        &disc(1e-300, 0.1),
        Start::at(0.0, 0.0).with_slip(1.0),
        Limits::default(),
    );
    let rolls = simulate(&disc(0.5, 1e-300), Start::at(0.0, 1.0), Limits::default());
    for motion in [skids, rolls] {
        assert_eq!(motion.outcome().kind(), OutcomeKind::StepLimit);
    }
}

/// The signs of η′ and θ′ in a mode of contact.
type Signs = [f64; 2];

/// θ″, η″, N, F and M of a mode, by elimination with pivots from the balances of the mass centre and
/// the two laws of friction; none where they hardly determine them.
fn solved(hoop: &Hoop, start: &Start, [slips, turns]: Signs) -> Option<[f64; 5]> {
    let (m, h) = (hoop.mass(), hoop.h());
    let inertia = hoop.body().inertia_about_mass_centre();
    let (sin, cos) = start.theta.sin_cos();
    let (along, down) = hoop.slope().sin_cos();
    let (u, d) = (start.theta_rate * start.theta_rate, 1.0 + h * cos);
    let mut rows = [
        [-m * d, m, 0.0, -1.0, 0.0, -m * (h * sin * u + along)],
        [-m * h * sin, 0.0, -1.0, 0.0, 0.0, m * (h * cos * u - down)],
        [inertia, 0.0, -h * sin, -d, -1.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ];
    if slips != 0.0 {
        rows[3] = [0.0, 0.0, slips * hoop.mu_k(), 1.0, 0.0, 0.0];
    }
    if turns != 0.0 {
        rows[4] = [0.0, 0.0, turns * hoop.rolling_resistance(), 0.0, 1.0, 0.0];
    }
    for k in 0..5 {
        let best = (k..5).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
        rows.swap(k, best);
        let pivot = rows[k];
        if pivot[k].abs() < NEGLIGIBLE {
            return None;
        }
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            for (number, more) in row.iter_mut().zip(pivot) {
                *number -= factor * more;
            }
        }
    }
    Some(std::array::from_fn(|k| rows[k][5] / rows[k][k]))
}

/// Margins that are less tell nothing in numbers of the order of one.
const NEGLIGIBLE: f64 = 1e-6;

/// Whether a mode is consistent: its forces obey their laws, and a velocity that is zero leaves zero
/// with its sign. None where a margin is negligible.
fn is_consistent(hoop: &Hoop, start: &Start, signs: Signs) -> Option<bool> {
    let [turn, slip, normal, friction, couple] = solved(hoop, start, signs)?;
    let [slips, turns] = signs;
    let mut margins = vec![normal];
    match (slips, start.slip) {
        (0.0, _) => margins.push(hoop.mu_s() * normal - friction.abs()),
        (sign, 0.0) => margins.push(sign * slip),
        _ => {}
    }
    match (turns, start.theta_rate) {
        (0.0, _) => margins.push(hoop.rolling_resistance() * normal - couple.abs()),
        (sign, 0.0) => margins.push(sign * turn),
        _ => {}
    }
    let is_told = margins.iter().all(|margin| margin.abs() > NEGLIGIBLE);
    is_told.then(|| margins.iter().all(|margin| *margin > 0.0))
}

/// The modes that may follow, flight as none: of those that are consistent the ones that no other
/// excludes by keeping at zero all that they keep, and more.
fn possible(hoop: &Hoop, start: &Start) -> Option<Vec<Option<Signs>>> {
    let signs = |velocity: f64| {
        if velocity == 0.0 {
            vec![0.0, 1.0, -1.0]
        } else {
            vec![velocity.signum()]
        }
    };
    let mut modes: Vec<Signs> = Vec::new();
    for slips in signs(start.slip) {
        for turns in signs(start.theta_rate) {
            if is_consistent(hoop, start, [slips, turns])? {
                modes.push([slips, turns]);
            }
        }
    }
    let kept = |mode: &Signs| mode.map(|sign| sign == 0.0);
    let exceeds = |a: &Signs, b: &Signs| {
        let (a, b) = (kept(a), kept(b));
        a != b && (0..2).all(|k| a[k] || !b[k])
    };
    let rests = |mode: &&Signs| !modes.iter().any(|other| exceeds(other, mode));
    let mut left: Vec<Option<Signs>> = modes.iter().filter(rests).copied().map(Some).collect();
    let (cos, rate) = (start.theta.cos(), start.theta_rate);
    let rises = hoop.h() * cos * rate * rate - hoop.slope().cos();
    if rises.abs() < NEGLIGIBLE {
        return None;
    }
    if rises > 0.0 {
        left.push(None);
    }
    Some(left)
}

/// A hoop and a state in contact, with sizes about one; velocities are often zero.
fn random_state(draw: &mut Draw) -> (Hoop, Start) {
    let mu = libm::exp10(draw.between([-1.5, 0.5]));
    let parameters = HoopParameters::thin(libm::exp10(draw.between([-3.0, 0.5])))
        .with_offset(draw.between([0.05, 1.0]))
        .with_inertia(libm::exp10(draw.between([-3.0, 0.5])))
        .with_friction(mu, mu * draw.share())
        .with_rolling_resistance(libm::exp10(draw.between([-2.0, 0.7])))
        .with_slope(draw.between([-1.2, 1.2]) * draw.below(2) as f64);
    let [rate, slip] = [3.0, 1.5].map(|size| {
        if draw.comes(0.4) {
            0.0
        } else {
            draw.between([-size, size])
        }
    });
    let start = Start::at(draw.between([-PI, PI]), rate).with_slip(slip);
    (Hoop::new(parameters).expect("a valid hoop"), start)
}

/// Whether a mode is one of several motions that the outcome names.
fn is_one_of_several(motion: &Trajectory, mode: Mode) -> bool {
    let Outcome::Ambiguous { candidates, .. } = motion.outcome() else {
        return false;
    };
    candidates.count() > 1 && candidates.consistent().any(|(found, _)| found == mode)
}

/// Whether a motion begins in a mode, with its accelerations and forces.
fn begins_as(motion: &Trajectory, start: &Start, [slips, turns]: Signs) -> bool {
    let mode = match (slips == 0.0, turns == 0.0) {
        (true, true) => Mode::Rest,
        (true, false) => Mode::Rolling,
        (false, true) => Mode::Skidding,
        (false, false) => Mode::Sliding,
    };
    let Some(first) = motion.phases().first() else {
        // Rolling that presses where pressing closes the gap is not the only motion: the hoop may
        // jam, or slip after all.
        return mode == Mode::Rolling && is_one_of_several(motion, mode);
    };
    let law = solved(motion.hoop(), start, [slips, turns]).expect("regular");
    let size: f64 = law.iter().map(|number| number.abs()).sum();
    let sample = first.first();
    let ours = [
        sample.theta_acceleration,
        sample.slip_acceleration,
        sample.normal,
        sample.friction,
    ];
    let is_close = |(ours, theirs): (f64, &f64)| (ours - theirs).abs() <= 1e-9 * size;
    first.mode() == mode && ours.into_iter().zip(&law).all(is_close)
}

#[test]
fn the_motion_that_follows_a_state_is_that_of_the_balances() {
    let mut counts = [0; 3];
    for case in 0..20_000 {
        let (hoop, start) = random_state(&mut Draw::of_case(54, 0, case));
        let Some(modes) = possible(&hoop, &start) else {
            continue;
        };
        let motion = simulate(&hoop, start, Limits::until(1e-9).with_transitions(1));
        counts[modes.len().min(2)] += 1;
        let outcome = motion.outcome().kind();
        let agrees = match modes[..] {
            [] => outcome == OutcomeKind::Inconsistent,
            [None] => motion.phases()[0].mode() == Mode::Flight,
            [Some(signs)] => begins_as(&motion, &start, signs),
            _ => {
                is_one_of_several(&motion, Mode::Rolling)
                    || is_one_of_several(&motion, Mode::Sliding)
            }
        };
        assert!(agrees, "{case}: {modes:?}, {outcome} {hoop:?} {start:?}");
    }
    assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
}

/// Rolling with D_χ < 0 is no more stable than a slide with P < 0: the outcome names what else there
/// is.
#[test]
fn rolling_where_pressing_closes_the_gap_is_one_of_several_motions() {
    // A massless hoop glides without a force, through zero slip, too.
    let hoop = HoopParameters::thin(0.0)
        .with_friction(0.5, 0.4)
        .with_rolling_resistance(0.1);
    let hoop = Hoop::new(hoop).expect("a massless hoop");
    let start = Start::at(-2.953_097_094_374_405_7, -0.52);
    let motion = simulate(&hoop, start, Limits::default());
    let [stick] = motion.transitions() else {
        panic!("{motion:?}");
    };
    assert_eq!(stick.cause, Cause::Stick);
    // d/cos²θ/2 is 2, so that D_χ/2 cos²θ/2 is 1 − χ ς tan(θ/2)/2.
    assert!(0.05 * (0.5 * stick.after.theta).tan() * stick.after.theta_rate.signum() > 1.0);
    let candidates = motion.outcome().candidates().expect("several");
    let modes: Vec<_> = candidates.consistent().collect();
    assert_eq!(modes, [(Mode::Rolling, None), (Mode::Gliding, None)]);

    // A heavy hoop may jam.
    let mut jams = 0;
    for case in 0..20_000 {
        let (hoop, start) = random_state(&mut Draw::of_case(54, 0, case));
        // It takes a fast hoop.
        let start = Start::at(start.theta, 5.0 * start.theta_rate);
        let motion = simulate(&hoop, start, Limits::until(1e-9));
        let Outcome::Ambiguous { state, candidates } = motion.outcome() else {
            continue;
        };
        let Some(denominator) = candidates.jam else {
            continue;
        };
        jams += 1;
        assert!(
            denominator < 0.0 && candidates.rolling && candidates.count() > 1,
            "{case}: {candidates:?}"
        );
        let parameters = hoop
            .parameters()
            .with_restitution(0.0, RestitutionLaw::Energetic);
        let hoop = Hoop::new(parameters).expect("a heavy hoop");
        let jam = hoop.jam(&state).expect("pressing closes the gap");
        assert_eq!((jam.after.theta_rate, jam.after.slip), (0.0, 0.0), "{case}");
    }
    assert!(jams > 3, "{jams}");
}

/// Turns that are passed at once are those in steps: a time limit that comes before some sixty turns
/// leaves no leap.
#[test]
fn a_leap_over_turns_agrees_with_their_steps() {
    let turning = |chi: f64, slope: f64| {
        let hoop = HoopParameters::thin(2.0)
            .with_offset(0.5)
            .with_inertia(1.8)
            .with_friction(0.9, 0.8)
            .with_rolling_resistance(chi)
            .with_slope(slope);
        Hoop::new(hoop).expect("a valid hoop")
    };
    // Some thirty steps a turn round the rate, and change the angle by that times the time.
    let rounding = |at: &State| {
        let steps = 30.0 * at.theta.abs() / TAU;
        4.0 * f64::EPSILON * steps.sqrt() * (1.0 + at.time)
    };
    // Down to the last turn, and, on slopes, up to a time.
    for (chi, slope, until) in [(1e-3, 0.0, 1e9), (1e-3, 4e-4, 1e9), (1e-3, 1.05e-3, 1500.0)] {
        let hoop = turning(chi, slope);
        let start = Start::at(0.3, 1.5);
        let leaping = simulate(&hoop, start, Limits::until(until).with_transitions(1));
        let mut here = start;
        let last = loop {
            let piece = Limits::until((here.time + 100.0).min(until)).with_transitions(1);
            let motion = simulate(&hoop, here, piece);
            let end = motion.phases()[0].end().expect("an end");
            if motion.outcome().kind() != OutcomeKind::TimeLimit || end.time >= until {
                break end;
            }
            // At the ends of the pieces, within the leap.
            let between = leaping.at(end.time).expect("a state").state;
            close(between.theta, end.theta, rounding(&end));
            close(between.theta_rate, end.theta_rate, rounding(&end));
            here = Start::from(end);
        };
        let end = leaping.phases()[0].end().expect("an end");
        assert!((end.theta - start.theta).abs() > 64.0 * TAU, "{end:?}");
        // Where the hoop turns back its time tells as little as it is slow there.
        close(end.theta, last.theta, rounding(&last));
        close(end.time, last.time, 100.0 * rounding(&last));
        close(end.theta_rate, last.theta_rate, rounding(&last));
    }
}

/// With next to no lever the series of a turn converge beyond where the hoop turns back, 118 million
/// turns uphill: it rolls as a disc, θ″ = sin α + χ cos α.
#[test]
fn a_rotation_with_next_to_no_lever_stops_as_a_disc() {
    let (chi, slope, rate) = (1.239_362_674_555_797e-6, 0.3, 2.098_450_041_597_921e4);
    let hoop = HoopParameters::thin(0.0)
        .with_offset(1.109_501_812_704_549e-55)
        .with_friction(5.9, 0.8)
        .with_rolling_resistance(chi)
        .with_slope(slope);
    let motion = Hoop::new(hoop)
        .expect("a valid hoop")
        .simulate(
            Start::at(0.225_836_815_101_306_15, -rate),
            Limits::default().with_transitions(1),
        )
        .expect("a valid start");
    let turn = &motion.transitions()[0];
    let time = rate / (libm::sin(slope) + chi * libm::cos(slope));
    assert_eq!(turn.cause, Cause::TurningPoint);
    assert!((turn.time() / time - 1.0).abs() < 1e-13, "{}", turn.time());
}

/// To first order a turn takes 2 χ ∮N dθ from K = D (1 + u) (eq. normal-of-a-turn): the hoop turns over
/// the top until K is that of rest there.
#[test]
fn a_rotation_of_millions_of_turns_ends_where_the_theory_says() {
    let (mass_ratio, offset, inertia) = (2.0_f64, 0.5_f64, 1.8_f64);
    let (mass, mean) = (
        1.0 + mass_ratio,
        1.0 + mass_ratio + inertia + offset * offset,
    );
    let kappa = mean / (mean * mean - 4.0 * offset * offset).sqrt() - 1.0;
    let (theta, rate) = (0.3_f64, 1.5_f64);
    let [first, last] = [
        (mean + 2.0 * offset * theta.cos()) * (1.0 + rate * rate),
        mean + 2.0 * offset,
    ];
    for chi in [1e-5, 1e-7, 1e-9] {
        let hoop = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(0.9, 0.8)
            .with_rolling_resistance(chi);
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let limits = Limits::default().with_transitions(1);
        let motion = simulate(&hoop, Start::at(theta, rate), limits);
        let [end] = motion.transitions() else {
            panic!("{:?}", motion.outcome());
        };
        assert_eq!(end.cause, Cause::TurningPoint);
        let sums = [first, last].map(|k| 4.0 * mass + kappa * k);
        let turns = (sums[0] / sums[1]).ln() / (chi * PI * kappa);
        let turned = (end.before.theta - theta) / TAU;
        assert!((turned - turns).abs() < 2.0, "{chi}: {turned} {turns}");
    }
}
