//! Stills of a named case.
use std::io::Write as _;
use littlewood::find_case;
use littlewood_film::{Film, Framing, GifFilm, Pace, Size};
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().collect();
    let motion = find_case(&args[1]).expect("case").simulate()?;
    let slow: f64 = args[2].parse()?;
    let pace = Pace { fps: 25, slow, units: None, hold_s: None };
    let size = Size::new(args[3].parse()?, args[4].parse()?)?;
    let film = Film::new(&motion, &pace, size, Framing::Auto)?;
    println!("{} frames, end {}", film.schedule().frames(), film.schedule().end());
    for tag in args[5..].iter() {
        if tag == "gif" {
            let mut out = GifFilm::new(Vec::new(), &film)?;
            film.play(&mut out, |_| true)?;
            let bytes = out.finish()?;
            println!("gif {} bytes", bytes.len());
            std::fs::File::create(format!("/tmp/film-{}.gif", args[1]))?.write_all(&bytes)?;
            continue;
        }
        let index: u64 = ((film.schedule().frames() - 1) as f64 * tag.parse::<f64>()?) as u64;
        let data = film.still(index)?;
        let file = std::fs::File::create(format!("/tmp/still-{}-{tag}.png", args[1]))?;
        let mut e = png::Encoder::new(file, size.width(), size.height());
        e.set_color(png::ColorType::Rgba);
        e.set_depth(png::BitDepth::Eight);
        e.write_header()?.write_image_data(&data)?;
    }
    Ok(())
}
