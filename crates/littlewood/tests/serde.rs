//! Parameters, starts, limits, states, summaries and transitions as JSON and back, with the names
//! of the tables.
#![cfg(feature = "serde")]

use littlewood::cases::find_case;
use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, HoopParameters, Limits, Start, Summary, Transition};

#[test]
fn a_problem_and_its_result_come_back_from_json() {
    let setup = Setup::new(
        HoopParameters::thin(1.0).with_friction(0.5, 0.4),
        Start::at(0.25, 2.0).with_slip(0.1),
    );
    let text = serde_json::to_string(&setup).expect("numbers");
    assert_eq!(
        serde_json::from_str::<Setup>(&text).expect("the same text"),
        setup
    );
    let document: serde_json::Value = serde_json::from_str(&text).expect("the same text");
    for (group, quantities) in [("hoop", &Quantity::HOOP[..]), ("start", &Quantity::START)] {
        for quantity in quantities {
            assert_eq!(
                document[group][quantity.name()].as_f64(),
                setup.get(*quantity),
                "{quantity}"
            );
        }
    }

    // A start that was written without a rate of the gap does not leave the plane.
    let start: Start =
        serde_json::from_str(r#"{"time":0,"theta":1,"theta_rate":2,"slip":0,"x":0}"#)
            .expect("a start");
    assert_eq!(start, Start::at(1.0, 2.0));

    let limits = Limits::until(5.0).with_transitions(7);
    let text = serde_json::to_string(&limits).expect("numbers");
    assert_eq!(
        serde_json::from_str::<Limits>(&text).expect("the same text"),
        limits
    );

    let hoop = Hoop::new(setup.hoop).expect("a valid hoop");
    let motion = hoop
        .simulate(setup.start, Limits::default())
        .expect("a valid start");
    let bouncing = find_case("figure-3-bounces")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    assert!(bouncing.transitions().iter().any(|it| it.impact.is_some()));
    for transition in motion.transitions().iter().chain(bouncing.transitions()) {
        let text = serde_json::to_string(transition).expect("finite numbers");
        assert!(
            text.contains(&format!("\"cause\":\"{}\"", transition.cause)),
            "{text}"
        );
        assert_eq!(
            serde_json::from_str::<Transition>(&text).expect("the same text"),
            *transition
        );
    }
    let summary = motion.summary();
    let document = serde_json::to_value(summary).expect("numbers");
    assert_eq!(document["outcome"], summary.outcome.name());
    // Of what did not happen JSON has null, which is no number: only a summary without gaps comes
    // back.
    let mut whole = summary;
    for time in [
        &mut whole.first_slip_time,
        &mut whole.lift_off_time,
        &mut whole.jump_length,
        &mut whole.jump_height,
        &mut whole.settle_time,
    ] {
        if time.is_nan() {
            *time = 0.0;
        }
    }
    let text = serde_json::to_string(&whole).expect("numbers");
    assert_eq!(
        serde_json::from_str::<Summary>(&text).expect("the same text"),
        whole
    );
}
