//! What a native program makes of a thousand random starts, for the tests of the page: WebAssembly has to make the same
//! of them, bit for bit.
//!
//! A line has the dimensionless numbers of a problem as the bits of doubles, and hashes (FNV-1a, 64 bits) of the JSON
//! with 20 samples and of the CSV of its transitions.

use std::io::{self, BufWriter, Write};

use littlewood::{HoopParameters, Quantity, Setup, Start};
use littlewood_web::{Motion, Problem};

const STARTS: u32 = 1000;
const SAMPLES: usize = 20;

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

/// Hoops of all kinds: that of Figure 2, Littlewood's, and any other.
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
    Setup::new(hoop, Start::at(theta, rate).with_slip(slip))
}

fn hash(text: &str) -> u64 {
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn main() -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let mut random = Random(2019);
    for index in 0..STARTS {
        let setup = setup(&mut random, index);
        let numbers = [&setup.values(Quantity::HOOP)[..], &setup.values(Quantity::START)].concat();
        let motion = Problem::dimensionless(&numbers, None).and_then(|problem| Motion::new(&problem, None));
        let motion = motion.map_err(|refusal| io::Error::other(refusal.message()))?;
        for number in numbers {
            write!(out, "{:016x} ", number.to_bits())?;
        }
        writeln!(out, "{:016x} {:016x}", hash(&motion.json(Some(SAMPLES))), hash(&motion.csv(None)))?;
    }
    out.flush()
}
