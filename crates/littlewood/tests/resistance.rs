//! Rolling resistance, against `evidence/reference/resistance.json`: motions by Newton's and Euler's
//! equations alone, with 30 digits.

use littlewood::energy::EnergyLedger;
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Sample, SlipDirection, Start, State, Trajectory,
    Transition,
};
use serde_json::Value;

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
            ("energy", ours.energy),
        ] {
            self.close(&format!("{what} {key}"), value, &theirs[key]);
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
fn compare(belongs: impl Fn(&Value) -> bool) -> usize {
    let data: Value = serde_json::from_str(REFERENCE).expect("evidence/reference/resistance.json");
    let motions = list(&data["motions"])
        .iter()
        .filter(|motion| belongs(motion));
    let mut count = 0;
    for (place, reference) in motions.enumerate() {
        let (hoop, start) = setup(reference);
        let comparison = Comparison {
            name: format!("{} {place}", name(&reference["family"])),
            tolerance: 1e-12,
        };
        let limits = Limits::until(number(&reference["until"]));
        let motion = hoop.simulate(start, limits).expect("a valid start");
        comparison.transitions(&motion, list(&reference["transitions"]));
        comparison.losses(&motion, list(&reference["transitions"]));
        for theirs in list(&reference["phases"]) {
            let sample = &theirs["sample"];
            let time = number(&sample["time"]);
            let ours = motion.at(time).expect("an instant of the motion");
            let mode = ours.mode.name();
            assert_eq!(mode, name(&theirs["mode"]), "{}", comparison.name);
            comparison.sample(mode, &ours, sample);
        }
        let ended = motion.outcome().kind().name();
        match name(&reference["ended"]) {
            "none" => assert_eq!(ended, "inconsistent", "{}", comparison.name),
            // The library may know that a motion goes on as it does for ever.
            "time_limit" => {
                assert!(["time_limit", "rolls_forever", "slides_forever"].contains(&ended))
            }
            theirs => assert_eq!(ended, theirs, "{}", comparison.name),
        }
        count += 1;
    }
    count
}

fn is_heavy(reference: &Value) -> bool {
    let hoop = &reference["hoop"];
    number(&hoop["inertia"]) > 0.0 || number(&hoop["mass_ratio"]) > 0.0
}

#[test]
fn motions_agree_with_newton_euler_at_30_digits() {
    let count = compare(is_heavy);
    assert_eq!(count, 154);
}
