//! Writes the gallery, images and page: `cargo run -p littlewood-figures --example gallery --
//! docs`.

use std::error::Error;
use std::fs;
use std::path::Path;

use littlewood_figures::{FIGURES, GALLERY_SCALE, gallery_page};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments
        .next()
        .ok_or("the folder of the documentation is wanted")?;
    let images = Path::new(&folder).join("gallery");
    fs::create_dir_all(&images)?;
    for entry in FIGURES {
        let figure = entry.of_the_paper()?;
        let stem = images.join(entry.name);
        fs::write(stem.with_extension("svg"), figure.svg())?;
        fs::write(stem.with_extension("png"), figure.png(GALLERY_SCALE)?)?;
    }
    fs::write(Path::new(&folder).join("gallery.md"), gallery_page()?)?;
    Ok(())
}
