//! The three films of the paper, as the documentation shows them. Writes them into the folder that is named as the
//! first argument.

use std::fs;
use std::path::PathBuf;

use littlewood::find_case;
use littlewood_film::{Film, FrameSize, Framing, GifFilm, Pace};

/// File, case, seconds of film for a unit of time.
const FILMS: [(&str, &str, f64); 3] = [
    ("figure-3.gif", "figure-3", 3.0),
    ("figure-7.gif", "figure-7", 4.0),
    ("libration.gif", "figure-2-libration", 1.25),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder")?);
    for (file, case, slow) in FILMS {
        let motion = find_case(case).ok_or("no such case")?.simulate()?;
        let pace = Pace { fps: 25, slow, units: None, hold_s: None, slow_impacts: None };
        let film = Film::new(&motion, &pace, FrameSize::default(), Framing::Auto)?;
        let mut encoder = GifFilm::new(Vec::new(), &film)?;
        film.play(&mut encoder, |_| true)?;
        fs::write(folder.join(file), encoder.finish()?)?;
    }
    Ok(())
}
