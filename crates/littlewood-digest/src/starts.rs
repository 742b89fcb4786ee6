//! The motions: hoops of all kinds with random starts.

use littlewood::Limits;
use littlewood::tables::Setup;
use littlewood_random::Draw;

/// Motions of a block.
pub const MOTIONS: u32 = 1000;

/// Seed of all blocks.
const SEED: u64 = 2019;

/// Time that motions are followed that bounce or come from the whole range: some never end.
pub const UNTIL: f64 = 60.0;

/// Limit of transitions of all motions: a few slip thousands of times and would take most of the
/// time.
const TRANSITIONS: usize = 100;

/// The hoops and starts of a block, as a person sets them, and each eighth from the whole accepted
/// range; with how far each motion is followed.
pub fn setups(block: u32) -> impl Iterator<Item = (Setup, Limits)> {
    (0..MOTIONS).map(move |index| {
        let mut draw = Draw::of_case(SEED, u64::from(block), u64::from(index));
        let is_usual = index % 8 < 7;
        let setup = if is_usual {
            draw.usual()
        } else {
            let (hoop, start) = draw.motion();
            Setup::new(hoop.parameters(), start)
        };
        let may_last = !is_usual || setup.hoop.restitution.is_some();
        let until = may_last.then_some(setup.start.time + UNTIL);
        (
            setup,
            Limits::default()
                .with_until(until)
                .with_transitions(TRANSITIONS),
        )
    })
}
