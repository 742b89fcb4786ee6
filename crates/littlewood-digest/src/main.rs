//! Computes the digests of all blocks. `print` writes them: the content of
//! `crates/littlewood-digest/digest.txt`. `check` compares them with that, and tells which differ.

use std::io::{self, Write};
use std::process::ExitCode;

use littlewood_digest::{BLOCKS, Block, COMMITTED};

fn main() -> io::Result<ExitCode> {
    let lines = (0..BLOCKS).map(|index| Block::compute(index).line());
    let mut out = io::stdout().lock();
    match std::env::args().nth(1).as_deref() {
        Some("print") => {
            for line in lines {
                writeln!(out, "{line}")?;
            }
        }
        Some("check") => {
            let mut differing = 0;
            for (committed, computed) in COMMITTED.lines().zip(lines) {
                if committed != computed {
                    writeln!(out, "committed {committed}\ncomputed  {computed}")?;
                    differing += 1;
                }
            }
            writeln!(out, "{differing} of {BLOCKS} blocks differ")?;
            return Ok(if differing == 0 {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            });
        }
        _ => {
            eprintln!("usage: littlewood-digest print|check");
            return Ok(ExitCode::from(2));
        }
    }
    Ok(ExitCode::SUCCESS)
}
