//! `littlewood animate`: a film of a motion.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::Ordering;

use littlewood_film::{
    ApngFilm, Encoder, EnergyBar, Film, FilmError, FrameSize, Framing, GifFilm, Mp4Film, Pace,
};

use crate::args::{AnimateArgs, Bar, Camera};
use crate::error::Error;
use crate::interrupt;
use crate::output::Output;
use crate::problem::Problem;
use crate::progress::{Bar as Progress, Count};
use crate::request::Request;

/// Seconds of film for a unit of time, and how many times slower than real a film in SI units is.
const SLOW: f64 = 3.0;
const SLOW_SI: f64 = 10.0;

/// The name of the third film of the paper, and of its case.
const LIBRATION: [&str; 2] = ["libration", "figure-2-libration"];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Gif,
    Apng,
    Mp4,
}

/// Runs the command.
///
/// # Errors
/// Bad input, a failure to write, or Ctrl-C.
pub(crate) fn run(args: AnimateArgs) -> Result<(), Error> {
    let AnimateArgs {
        problem,
        run,
        out,
        slow,
        fps,
        size: (width, height),
        camera,
        hold,
        slow_impacts,
        energy_bar,
    } = args;
    let kind = kind_of(&out)?;
    let size = FrameSize::new(width, height).map_err(|error| Error::Film(error.into()))?;
    let mut request = Request::new(&problem, Some(&run))?;
    if request.case.as_deref() == Some(LIBRATION[0]) {
        request.case = Some(LIBRATION[1].to_owned());
    }
    let problem = Problem::resolve(request)?;
    let units = problem.units;
    let slow = slow.unwrap_or(if units.is_some() { SLOW_SI } else { SLOW });
    let framing = match camera {
        Camera::Auto => Framing::Auto,
        Camera::Whole => Framing::Whole,
        Camera::Follow => Framing::Follow,
    };
    let trajectory = problem.simulate()?;
    let pace = Pace { fps, slow, units, hold_s: hold, slow_impacts };
    let bar = match energy_bar {
        Bar::Auto => EnergyBar::Auto,
        Bar::Always => EnergyBar::Always,
        Bar::Never => EnergyBar::Never,
    };
    let film = Film::new(&trajectory, &pace, size, framing).map_err(Error::Film)?.with_energy_bar(bar);
    let output = Output::open(Some(&out))?;
    match kind {
        Kind::Gif => write(output, |writer| {
            let mut encoder = GifFilm::new(writer, &film)?;
            play(&film, &mut encoder)?;
            encoder.finish().map(drop)
        }),
        Kind::Apng => write(output, |writer| {
            let mut encoder = ApngFilm::new(writer, &film)?;
            play(&film, &mut encoder)?;
            encoder.finish()
        }),
        Kind::Mp4 => write_with_ffmpeg(output, &film),
    }
}

fn kind_of(out: &Path) -> Result<Kind, Error> {
    let ending = out.extension().and_then(OsStr::to_str).map(str::to_lowercase);
    match ending.as_deref() {
        Some("gif") => Ok(Kind::Gif),
        Some("png" | "apng") => Ok(Kind::Apng),
        Some("mp4") => Ok(Kind::Mp4),
        _ => Err(Error::Out {
            path: out.to_owned(),
            reason: "its ending does not say what the film is to be".to_owned(),
            hint: "the endings are .gif, .png or .apng, and .mp4".to_owned(),
        }),
    }
}

/// Draws the film until it is finished or Ctrl-C comes.
fn play(film: &Film<'_>, encoder: &mut impl Encoder) -> Result<(), FilmError> {
    let stop = interrupt::asked();
    let (bar, total) = (Progress::new(), film.schedule().frames());
    film.play(encoder, |done| {
        bar.show("frames", Count { done, total });
        !stop.load(Ordering::Relaxed)
    })
}

fn write(output: Output, body: impl FnOnce(&mut dyn Write) -> Result<(), FilmError>) -> Result<(), Error> {
    let mut failure = None;
    let result = output.write(|writer| {
        body(writer).map_err(|error| match error {
            FilmError::Write(error) => error,
            other => {
                failure = Some(other);
                io::ErrorKind::Other.into()
            }
        })
    });
    failure.map_or(result, |error| Err(Error::Film(error)))
}

/// ffmpeg writes the file itself, under the name that it has until it is finished.
fn write_with_ffmpeg(output: Output, film: &Film<'_>) -> Result<(), Error> {
    let Output::File { temporary, .. } = &output else {
        return Err(Error::Film(FilmError::Write(io::ErrorKind::NotSeekable.into())));
    };
    let mut encoder = Mp4Film::start(OsStr::new("ffmpeg"), temporary.path(), film).map_err(Error::Film)?;
    play(film, &mut encoder).and_then(|()| encoder.finish()).map_err(Error::Film)?;
    output.write(|_| Ok(()))
}
