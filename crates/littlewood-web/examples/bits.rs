//! What a native program makes of the named cases and of a thousand random starts, for the tests of
//! the page: WebAssembly has to make the same of them, bit for bit.
//!
//! A line has the name of a case or `-`; the dimensionless numbers of a problem as the bits of
//! doubles; the coefficient of restitution as bits and the name of its law, or `-` and `-`; the
//! bits of its limit of time, or `-`; and hashes (FNV-1a, 64 bits) of the JSON with 20 samples, of
//! the CSV of its transitions, and of the bits of the ways of its impacts and of where its energy
//! is at the end.

use std::io::{self, BufWriter, Write};

use littlewood::Hoop;
use littlewood::cases::CASES;
use littlewood::tables::Setup;
use littlewood_digest::{UNTIL, setups};
use littlewood_web::{Motion, Problem, dimensionless_quantities};

const SAMPLES: usize = 20;

fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The bits of what only the page shows.
fn pictures(motion: &Motion, until: f64) -> Vec<u8> {
    let ways = (0..motion.transition_sentences().len()).filter_map(|index| motion.routh(index));
    let numbers = ways
        .flat_map(|routh| routh.way())
        .chain(motion.energies(until));
    // There is one NaN: which bits arithmetic gives one is not specified.
    let bits = |number: f64| {
        if number.is_nan() {
            f64::NAN.to_bits()
        } else {
            number.to_bits()
        }
    };
    numbers
        .flat_map(|number| bits(number).to_be_bytes())
        .collect()
}

fn word(number: Option<f64>) -> String {
    number.map_or_else(
        || "-".to_owned(),
        |number| format!("{:016x}", number.to_bits()),
    )
}

fn line(
    out: &mut impl Write,
    case: Option<&str>,
    (setup, until): (&Setup, Option<f64>),
) -> io::Result<()> {
    let numbers: Vec<f64> = dimensionless_quantities()
        .filter_map(|quantity| setup.get(quantity))
        .collect();
    // The motion is checked where its parameters are; here it is enough that there is one.
    let restitution = Hoop::new(setup.hoop)
        .ok()
        .and_then(|hoop| hoop.restitution());
    let law = restitution.map(|it| it.law().name().to_owned());
    let coefficient = restitution.map(|it| it.coefficient());
    let motion = Problem::dimensionless(&numbers, coefficient, law.clone(), until)
        .and_then(|problem| Motion::new(&problem, case.map(str::to_owned)))
        .map_err(|refusal| io::Error::other(refusal.message))?;
    write!(out, "{} ", case.unwrap_or("-"))?;
    for number in numbers {
        write!(out, "{:016x} ", number.to_bits())?;
    }
    write!(
        out,
        "{} {} {} ",
        word(coefficient),
        law.as_deref().unwrap_or("-"),
        word(until)
    )?;
    let hashes = [
        hash(motion.json(Some(SAMPLES)).bytes()),
        hash(motion.csv(None).bytes()),
        hash(pictures(&motion, motion.horizon())),
    ];
    writeln!(
        out,
        "{}",
        hashes.map(|hash| format!("{hash:016x}")).join(" ")
    )
}

fn main() -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    for case in CASES {
        let until = case.setup.hoop.restitution.map(|_| UNTIL);
        line(&mut out, Some(case.name), (&case.setup, until))?;
    }
    for (setup, limits) in setups(0) {
        line(&mut out, None, (&setup, limits.until))?;
    }
    out.flush()
}
