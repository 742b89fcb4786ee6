//! Writes figures into a folder: `cargo run -p littlewood-figures --example gallery -- DIR [NAME…]`.

use std::error::Error;
use std::fs;
use std::path::Path;

use littlewood_figures::FIGURES;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("a folder is wanted")?;
    let names: Vec<String> = arguments.collect();
    for entry in FIGURES.iter().filter(|entry| names.is_empty() || names.iter().any(|name| name == entry.name)) {
        let figure = entry.of_the_paper()?;
        let stem = Path::new(&folder).join(entry.name);
        fs::write(stem.with_extension("svg"), figure.svg()?)?;
        fs::write(stem.with_extension("png"), figure.png(2.0)?)?;
        fs::write(stem.with_extension("csv"), figure.csv())?;
    }
    Ok(())
}
