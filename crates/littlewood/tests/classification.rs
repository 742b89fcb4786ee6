//! What `classify` says begins is what the simulation begins with.

use crate::common::{heavy_motion, massless_hoop, start};
use littlewood::{Hoop, Limits, Mode, OutcomeKind, Proof, Start, StartRegion};
use proptest::prelude::*;

/// Compares what is said of a start with the first phase of its motion.
fn check(hoop: &Hoop, start: Start) -> Result<(), TestCaseError> {
    let said = hoop.classify(start).expect("a valid start");
    let limits = Limits::default().with_transitions(1).with_proof(Proof::None);
    let motion = hoop.simulate(start, limits).expect("a valid start");
    let Some(first) = motion.phases().first() else {
        prop_assert_eq!(said.mode, None);
        let region = match motion.outcome().kind() {
            OutcomeKind::Inconsistent => StartRegion::Inconsistent,
            OutcomeKind::Ambiguous => StartRegion::Ambiguous,
            other => return Err(TestCaseError::fail(format!("no phase, but {other}"))),
        };
        prop_assert_eq!(said.region, region);
        prop_assert!(said.candidates.is_some());
        return Ok(());
    };
    prop_assert_eq!(said.mode, Some(first.mode()));
    prop_assert!(said.candidates.is_none());
    if said.direction.is_some() || first.mode() != Mode::Gliding {
        prop_assert_eq!(said.direction, first.direction());
    }
    if first.mode() == Mode::Rolling {
        match said.rolling_end {
            Some(end) => {
                let last = first.end().expect("an end");
                prop_assert_eq!(last.time, start.time + end.elapsed);
                prop_assert_eq!((last.theta, last.theta_rate), (end.theta, end.theta_rate));
                prop_assert!(said.recurrence.is_none());
            }
            None => {
                prop_assert_eq!(first.end(), None);
                prop_assert_eq!(said.recurrence, motion.outcome().recurrence());
            }
        }
    } else {
        prop_assert_eq!((said.rolling_end, said.recurrence, said.rolling_type), (None, None, None));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_heavy_hoop_begins_as_it_is_classified((hoop, start) in heavy_motion()) {
        check(&hoop, start)?;
    }

    #[test]
    fn a_massless_hoop_begins_as_it_is_classified(hoop in massless_hoop(), start in start()) {
        check(&hoop, start)?;
    }

    #[test]
    fn a_thrown_hoop_flies((hoop, start) in heavy_motion(), gap_rate in 1e-9..2.0_f64) {
        check(&hoop, start.with_gap_rate(gap_rate))?;
    }
}
