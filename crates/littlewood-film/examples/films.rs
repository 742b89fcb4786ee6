//! The three films of the paper, one of what comes after the landing and one on a ramp, as the
//! documentation shows them. Writes them into the folder that is named as the first argument.

use std::fs;
use std::path::PathBuf;

use littlewood::cases::find_case;
use littlewood::tables::Setup;
use littlewood::{Hoop, Limits};
use littlewood_film::{Film, FrameSize, Framing, GifFilm, Pace};

/// File, case, seconds of film for a unit of time, time limit.
const FILMS: [(&str, &str, f64, Option<f64>); 5] = [
    ("figure-3.gif", "figure-3", 3.0, None),
    ("figure-7.gif", "figure-7", 4.0, None),
    ("libration.gif", "figure-2-libration", 1.25, None),
    ("bounces.gif", "figure-3-bounces", 1.5, Some(8.0)),
    ("ramp-jump.gif", "ramp-jump", 0.8, None),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder")?);
    for (file, case, slow, until) in FILMS {
        let Setup { hoop, start, .. } = find_case(case).ok_or("no such case")?.setup;
        let limits = Limits::default().with_until(until);
        let motion = Hoop::new(hoop)?.simulate(start, limits)?;
        let pace = Pace {
            fps: 20,
            slow,
            units: None,
            hold_s: None,
        };
        let film = Film::new(&motion, &pace, FrameSize::default(), Framing::Auto)?;
        let mut encoder = GifFilm::new(Vec::new(), &film)?;
        film.play(&mut encoder, |_| true)?;
        fs::write(folder.join(file), encoder.finish()?)?;
    }
    Ok(())
}
