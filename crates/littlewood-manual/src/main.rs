//! `littlewood-manual PREFIX` writes completions and manual pages below a prefix such as `/usr/local`.

use std::io;
use std::path::Path;
use std::process::ExitCode;

fn main() -> io::Result<ExitCode> {
    let mut arguments = std::env::args_os().skip(1);
    let (Some(prefix), None) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: littlewood-manual PREFIX");
        return Ok(ExitCode::from(2));
    };
    littlewood_manual::write(Path::new(&prefix))?;
    Ok(ExitCode::SUCCESS)
}
