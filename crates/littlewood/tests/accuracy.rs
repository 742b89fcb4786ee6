//! Random motions of the whole accepted range, against 60 digits (`evidence/reference/accuracy`).
//! The errors of those that the file keeps are those that it has measured, or at least as small as
//! of ordinary motions.
#![allow(clippy::panic)]

use littlewood::{Hoop, HoopParameters, Limits, Proof, RestitutionLaw, Start};
use serde_json::Value;

use crate::coincidences::{number, numbers, of_state};

const REFERENCE: &str = include_str!("../../../evidence/reference/accuracy.json");

#[test]
fn errors_on_the_whole_accepted_range_are_those_of_the_page() {
    let data: Value = serde_json::from_str(REFERENCE).expect("evidence/reference/accuracy.json");
    let ordinary = number(&data["parts"]["ordinary"]["lost"][2]);
    let mut compared = 0;
    for motion in data["kept"].as_array().expect("a list of motions") {
        let [mass_ratio, offset, inertia, mu_s, mu_k] = numbers(&motion["hoop"]);
        let [theta, theta_rate, slip, gap_rate, x, time] = numbers(&motion["start"]);
        let mut parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k);
        if let Some([coefficient, law]) = motion["restitution"].as_array().map(Vec::as_slice) {
            let law: RestitutionLaw = law.as_str().expect("a word").parse().expect("a law");
            parameters = parameters.with_restitution(number(coefficient), law);
        }
        let hoop = Hoop::new(parameters).expect("a valid hoop");
        let start = Start::at(theta, theta_rate)
            .with_slip(slip)
            .with_gap_rate(gap_rate)
            .with_x(x)
            .with_time(time);
        let limits = Limits::default()
            .with_transitions(100)
            .with_proof(Proof::None);
        let ours = hoop.simulate(start, limits).expect("a valid start");
        let hoop = &motion["hoop"];
        let largest = ordinary.max(1.01 * number(&motion["lost"]));
        let theirs = motion["events"].as_array().expect("a list of events");
        for (k, theirs) in theirs.iter().enumerate() {
            let ours = &ours.transitions()[k];
            assert_eq!(theirs["cause"], ours.cause.name(), "{hoop} {k}");
            for (name, value) in of_state(&ours.before) {
                let Some(exact) = theirs.get(name) else {
                    continue;
                };
                let [exact, conditioning] = numbers(exact);
                let size: f64 = match name {
                    "x" => exact.abs().max(1.0),
                    "slip" => exact.abs().max(ours.before.theta_rate.abs()),
                    _ => exact.abs(),
                };
                let error = if value == exact {
                    0.0
                } else {
                    (value - exact).abs() / (f64::EPSILON * size)
                };
                assert!(
                    error <= largest * conditioning,
                    "{hoop} {k} {name}: {value} {exact}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}
