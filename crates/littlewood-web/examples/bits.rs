//! What a native program makes of the named cases and of a thousand random starts, for the tests of the page: WebAssembly has
//! to make the same of them, bit for bit.
//!
//! A line has the name of a case or `-`; the dimensionless numbers of a problem as the bits of doubles; the coefficient of
//! restitution as bits and the name of its law, or `-` and `-`; the bits of its limit of time, or `-`; and hashes (FNV-1a, 64 bits)
//! of the JSON with 20 samples, of the CSV of its transitions, and of the bits of the ways of its impacts and of where its energy
//! is at the end.

use std::io::{self, BufWriter, Write};

use littlewood::{CASES, Hoop, HoopParameters, RestitutionLaw, Setup, Start};
use littlewood_web::{Motion, Problem, dimensionless_quantities};

const STARTS: u32 = 1000;
const SAMPLES: usize = 20;

/// Limit of the motions that bounce: some do without end.
const UNTIL: f64 = 60.0;

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
    let start = Start::at(theta, rate).with_slip(slip);
    if inertia > 0.0 && index.is_multiple_of(5) {
        let law = RestitutionLaw::ALL[index as usize / 5 % RestitutionLaw::ALL.len()];
        let hoop = hoop.with_restitution(random.between(0.0, 0.95), law);
        return Setup::new(hoop, start.with_gap_rate(random.between(-1.0, 1.0).max(0.0)));
    }
    Setup::new(hoop, start)
}

fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes
        .into_iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The bits of what only the page shows.
fn pictures(motion: &Motion, until: f64) -> Vec<u8> {
    let ways = (0..motion.transition_sentences().len()).filter_map(|index| motion.routh(index));
    let numbers = ways.flat_map(|routh| routh.way()).chain(motion.energies(until));
    // There is one NaN: which bits arithmetic gives one is not specified.
    let bits = |number: f64| if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() };
    numbers.flat_map(|number| bits(number).to_be_bytes()).collect()
}

fn word(number: Option<f64>) -> String {
    number.map_or_else(|| "-".to_owned(), |number| format!("{:016x}", number.to_bits()))
}

fn line(out: &mut impl Write, case: Option<&str>, setup: &Setup) -> io::Result<()> {
    let numbers: Vec<f64> = dimensionless_quantities().filter_map(|quantity| setup.get(quantity)).collect();
    // The motion is checked where its parameters are; here it is enough that there is one.
    let restitution = Hoop::new(setup.hoop).ok().and_then(|hoop| hoop.restitution());
    let law = restitution.map(|it| it.law().name().to_owned());
    let coefficient = restitution.map(|it| it.coefficient());
    let until = restitution.map(|_| UNTIL);
    let motion = Problem::dimensionless(&numbers, coefficient, law.clone(), until)
        .and_then(|problem| Motion::new(&problem, case.map(str::to_owned)))
        .map_err(|refusal| io::Error::other(refusal.message()))?;
    write!(out, "{} ", case.unwrap_or("-"))?;
    for number in numbers {
        write!(out, "{:016x} ", number.to_bits())?;
    }
    write!(out, "{} {} {} ", word(coefficient), law.as_deref().unwrap_or("-"), word(until))?;
    let hashes = [
        hash(motion.json(Some(SAMPLES)).bytes()),
        hash(motion.csv(None).bytes()),
        hash(pictures(&motion, motion.horizon())),
    ];
    writeln!(out, "{}", hashes.map(|hash| format!("{hash:016x}")).join(" "))
}

fn main() -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    for case in CASES {
        line(&mut out, Some(case.name), &case.setup)?;
    }
    let mut random = Random(2019);
    for index in 0..STARTS {
        line(&mut out, None, &setup(&mut random, index))?;
    }
    out.flush()
}
