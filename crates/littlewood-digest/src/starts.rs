//! The motions: hoops of all kinds with random starts.

use littlewood::{HoopParameters, Limits, RestitutionLaw, Setup, Start};

/// Motions of a block.
pub const MOTIONS: u32 = 1000;

/// Seed of the first block; those of the others follow.
const SEED: u64 = 2019;

/// Limit of the motions that bounce: some do without end.
const UNTIL: f64 = 60.0;

/// Limit of all motions: a few slip thousands of times, and would take most of the time.
const TRANSITIONS: usize = 100;

/// `SplitMix64` (Steele, Lea and Flood, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * ((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// The hoops and starts of a block.
pub fn setups(block: u32) -> impl Iterator<Item = Setup> {
    let mut random = Random(SEED + u64::from(block));
    (0..MOTIONS).map(move |index| setup(&mut random, index))
}

/// Hoops of all kinds: that of Figure 2, Littlewood's, and any other, some of them with a coefficient of restitution.
fn setup(random: &mut Random, index: u32) -> Setup {
    let [mass_ratio, offset, inertia] = match index % 4 {
        0 | 1 => [1.0, 1.0, 1.0],
        2 => [0.0, 1.0, 0.0],
        _ => [random.between(0.0, 4.0), random.between(0.05, 1.0), random.between(0.02, 4.0)],
    };
    let mu_s = random.between(0.05, 1.2);
    let mu_k = mu_s * random.between(0.0, 1.0);
    let slip = if index.is_multiple_of(3) { random.between(-2.0, 2.0) } else { 0.0 };
    let (theta, rate) = (random.between(-4.0, 7.0), random.between(-4.0, 4.0));
    let hoop = HoopParameters::new(mass_ratio, offset, inertia).with_friction(mu_s, mu_k);
    let start = Start::at(theta, rate).with_slip(slip);
    if inertia > 0.0 && index.is_multiple_of(5) {
        let law = RestitutionLaw::ALL[index as usize / 5 % RestitutionLaw::ALL.len()];
        let hoop = hoop.with_restitution(random.between(0.0, 0.95), law);
        return Setup::new(hoop, start.with_gap_rate(random.between(-1.0, 1.0).max(0.0)));
    }
    Setup::new(hoop, start)
}

/// How far the motion of a setup is followed.
#[must_use]
pub fn limits(setup: &Setup) -> Limits {
    let bounces = setup.hoop.restitution.is_some();
    Limits::default().with_until(bounces.then_some(UNTIL)).with_transitions(TRANSITIONS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of the generator from 1234567, as published with the reference implementation.
    #[test]
    fn the_generator_is_split_mix_64() {
        let mut random = Random(1_234_567);
        assert_eq!(
            [random.next(), random.next(), random.next()],
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]
        );
    }

    #[test]
    fn blocks_differ() {
        let first = |block| setups(block).next().map(|setup| setup.start.theta.to_bits());
        assert_ne!(first(0), first(1));
    }
}
