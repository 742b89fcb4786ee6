//! SI units: the same motion as without dimensions, and every value in both.

use crate::support::csv::Csv;
use crate::support::{FIGURE_3_EVENTS, FIGURE_3_LANDING, assert_close, json, number, text};
use serde_json::Value;

/// Figure 3 with m2 = 2 kg, R = 1 m and g = 4 m/s²: the unit of time is ½ s, and no conversion
/// rounds.
const FIGURE_3_SI: &str = "--si --disc-mass-kg 2 --particle-mass-kg 2 --radius-m 1 --offset-m 1 --inertia-kg-m2 2 \
                           --gravity-m-per-s2 4 --mu-s 0.5 --mu-k 0.4 --theta 1.5707963267948966 \
                           --theta-rate-rad-per-s 4";

fn with(command: &'static str, more: &[&'static str]) -> Vec<&'static str> {
    [
        &[command],
        &FIGURE_3_SI.split_whitespace().collect::<Vec<_>>()[..],
        more,
    ]
    .concat()
}

#[test]
fn the_motion_is_that_without_dimensions() {
    let mut si = json(&with("simulate", &[]));
    let mut plain = json(&["simulate", "figure-3"]);
    remove_si(&mut si);
    plain.as_object_mut().unwrap().remove("case");
    assert_eq!(si, plain);
}

fn remove_si(value: &mut Value) {
    match value {
        Value::Object(map) => {
            map.remove("si");
            map.values_mut().for_each(remove_si);
        }
        Value::Array(list) => list.iter_mut().for_each(remove_si),
        _ => (),
    }
}

#[test]
fn every_value_is_there_in_si_units() {
    let document = json(&with("simulate", &["--samples", "3"]));
    let hoop = &document["si"]["hoop"];
    assert_eq!(hoop["disc_mass_kg"], 2.0);
    assert_eq!(hoop["radius_m"], 1.0);
    assert_eq!(hoop["gravity_m_per_s2"], 4.0);
    assert_eq!(document["si"]["units"]["time_s"], 0.5);
    assert_eq!(document["si"]["units"]["energy_j"], 8.0);
    assert_eq!(document["start"]["si"]["theta_rate_rad_per_s"], 4.0);
    for (transition, [time, theta, rate, slip, x]) in document["transitions"]
        .as_array()
        .unwrap()
        .iter()
        .zip(FIGURE_3_EVENTS)
    {
        let si = &transition["si"];
        assert_close(number(&si["time_s"]), 0.5 * time, 1e-12);
        assert_close(number(&si["theta_rad"]), theta, 1e-12);
        assert_close(number(&si["theta_rate_rad_per_s"]), 2.0 * rate, 1e-12);
        assert_close(number(&si["slip_m_per_s"]), 2.0 * slip, 1e-12);
        assert_close(number(&si["x_m"]), x, 1e-12);
    }
    assert_close(
        number(&document["outcome"]["si"]["time_s"]),
        0.5 * FIGURE_3_LANDING[0],
        1e-12,
    );
    let lost = number(&document["energy_lost"]);
    assert_close(number(&document["si"]["energy_lost_j"]), 8.0 * lost, 1e-14);
    let phase = &document["phases"][1];
    assert_close(
        number(&phase["si"]["duration_s"]),
        0.5 * number(&phase["duration"]),
        1e-15,
    );
    for sample in document["samples"].as_array().unwrap() {
        let si = &sample["si"];
        // Weight m2 g = 8 N; acceleration of the slip in units of g = 4 m/s².
        assert_close(
            number(&si["normal_n"]),
            8.0 * number(&sample["normal"]),
            1e-14,
        );
        assert_close(
            number(&si["slip_acceleration_m_per_s2"]),
            4.0 * number(&sample["slip_acceleration"]),
            1e-14,
        );
        assert_close(
            number(&si["theta_acceleration_rad_per_s2"]),
            4.0 * number(&sample["theta_acceleration"]),
            1e-14,
        );
        assert_close(
            number(&si["particle_y_m"]),
            number(&sample["particle_y"]),
            1e-14,
        );
    }
}

#[test]
fn the_couple_of_rolling_resistance_is_in_newton_metres() {
    let document = json(&with(
        "simulate",
        &["--rolling-resistance-m", "0.05", "--samples", "40"],
    ));
    let mut turning = 0;
    for sample in document["samples"].as_array().unwrap() {
        let [couple, normal, rate] =
            ["couple", "normal", "theta_rate"].map(|name| number(&sample[name]));
        if rate != 0.0 {
            assert_close(couple, -rate.signum() * 0.05 * normal, 1e-14);
            turning += usize::from(normal > 0.0);
        }
        // Weight m2 g = 8 N, radius 1 m.
        assert_close(number(&sample["si"]["couple_n_m"]), 8.0 * couple, 1e-14);
    }
    assert!(turning > 10, "{turning}");
}

#[test]
fn a_time_limit_in_seconds_stops_the_motion_there() {
    let document = json(&with(
        "simulate",
        &["--until-s", "0.5", "--time-s", "-0.25"],
    ));
    assert_eq!(document["start"]["time"], -0.5);
    assert_eq!(document["outcome"]["kind"], "time_limit");
    assert_eq!(document["outcome"]["time"], 1.0);
    assert_eq!(document["outcome"]["si"]["time_s"], 0.5);
}

#[test]
fn any_si_flag_implies_the_switch_and_a_case_can_be_given_a_size() {
    let flags = with("simulate", &[]);
    let without: Vec<&str> = flags
        .iter()
        .copied()
        .filter(|flag| *flag != "--si")
        .collect();
    assert_eq!(json(&flags), json(&without));
    let size = ["--radius-m", "0.45", "--particle-mass-kg", "0.14"];
    let document = json(&[&["simulate", "figure-3"], &size[..]].concat());
    // The case itself is not rounded by the way through SI units.
    assert_eq!(
        document["transitions"][2]["time"],
        json(&["simulate", "figure-3"])["transitions"][2]["time"]
    );
    let second = (0.45_f64 / 9.806_65).sqrt();
    assert_close(
        number(&document["transitions"][2]["si"]["time_s"]),
        FIGURE_3_EVENTS[2][0] * second,
        1e-12,
    );
    let faster = json(
        &[
            &["simulate", "figure-3", "--theta-rate-rad-per-s", "-3"],
            &size[..],
        ]
        .concat(),
    );
    assert_close(number(&faster["start"]["theta_rate"]), -3.0 * second, 1e-15);
    assert_eq!(faster["hoop"]["inertia"], 1.0);
}

#[test]
fn the_page_and_the_rows_show_si_units() {
    let page = text(&with("simulate", &[]));
    for part in [
        "[rad/s]",
        "m₁ = 2 kg",
        "Izz = 2 kg m²",
        "√(R/g) = 0.5 s",
        "         t = 1.9237 s",
        "J lost to friction",
    ] {
        assert!(page.contains(part), "{part} is not in\n{page}");
    }
    // The lift-off, at half of τ = 1.51867.
    assert!(page.contains("0.75934"), "{page}");
    assert!(
        page.lines().all(|line| line.chars().count() <= 80),
        "{page}"
    );
    let rows = text(&with("simulate", &["--format", "csv"]));
    assert!(
        rows.lines()
            .next()
            .unwrap()
            .ends_with("cause,time_s,theta_rad,theta_rate_rad_per_s,slip_m_per_s,x_m")
    );
    // After the event, the last of the columns without units, are those with units.
    let samples = ["--format", "csv", "--samples", "3"];
    let plain = Csv::read(&text(&[&["simulate", "figure-3"], &samples[..]].concat())).columns;
    let mut table = Csv::read(&text(&with("simulate", &samples)));
    let si = table.columns.split_off(plain.len());
    assert_eq!(table.columns, plain);
    assert_eq!((si.len(), si[0].as_str()), (18, "time_s"));
}

#[test]
fn classify_takes_si_units() {
    let mut si = json(&with("classify", &[]));
    assert_eq!(si["si"]["units"]["force_n"], 8.0);
    let mut plain = json(&["classify", "figure-3"]);
    remove_si(&mut si);
    plain.as_object_mut().unwrap().remove("case");
    assert_eq!(si, plain);
}
