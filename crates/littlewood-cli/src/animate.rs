//! `littlewood animate`: a film of a motion.

use std::ffi::OsStr;
use std::io::{self, IsTerminal as _, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use littlewood_film::{ApngFilm, Encoder, Film, FilmError, Framing, GifFilm, Mp4Film, Pace, Size};

use crate::args::{ProblemArgs, RunArgs, number, size};
use crate::error::Error;
use crate::interrupt;
use crate::output::Output;
use crate::problem::{Above, Problem};
use crate::scenario::Scenario;

pub(crate) const ABOUT: &str = "\
Make a film of a motion: hoop, particle, contact point, gap, forces, slip velocity, mode and clock.

The motion is given as in `simulate`; `libration` is short for figure-2-libration. A motion that lasts for ever is shown \
for one oscillation, two turns, or 10 units of time, unless --until says otherwise.

The ending of --out says what the film is: .gif, .png or .apng, or .mp4, which needs ffmpeg. A GIF or an APNG has the \
same bytes on every machine.";

pub(crate) const EXAMPLES: &str = "\
Examples:
  littlewood animate figure-3 --out figure-3.gif
  littlewood animate figure-7 --slow 6 --fps 50 --size 1280x720 --out figure-7.png
  littlewood animate libration --fps 60 --size 1920x1080 --out libration.mp4
  littlewood animate figure-3 --particle-mass-kg 0.14 --radius-m 0.45 --slow 10 --out hula-hoop.gif";

/// Seconds of film for a unit of time, and how many times slower than real a film in SI units is.
const SLOW: f64 = 3.0;
const SLOW_SI: f64 = 10.0;

/// The name of the third film of the paper, and of its case.
const LIBRATION: [&str; 2] = ["libration", "figure-2-libration"];

const TEMPLATE: &str = "{bar:32} {percent:>3}%  {human_pos} of {human_len} frames  {eta} left";

/// Arguments of `littlewood animate`.
#[derive(Debug, Args)]
pub(crate) struct AnimateArgs {
    #[command(flatten)]
    problem: ProblemArgs,
    #[command(flatten)]
    run: RunArgs,
    /// File of the film, .gif, .png, .apng or .mp4; it is replaced only once everything has been written
    #[arg(long, value_name = "FILE", help_heading = "Film")]
    out: PathBuf,
    /// Seconds of film for a unit of time sqrt(R/g) [default: 3]; in SI units, how many times slower than real the
    /// film is [default: 10]
    #[arg(long, value_name = "FACTOR", value_parser = number, help_heading = "Film")]
    slow: Option<f64>,
    /// Frames per second; a GIF can have 50
    #[arg(long, value_name = "N", default_value_t = 25, help_heading = "Film")]
    fps: u32,
    /// Size in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "640x360", value_parser = size, help_heading = "Film")]
    size: (u32, u32),
    /// What the picture shows of the path
    #[arg(long, value_enum, default_value_t = Camera::Auto, help_heading = "Film")]
    camera: Camera,
    /// Seconds for which the last picture stays [default: 1.5, and 0 for an oscillation, which goes on where it began]
    #[arg(long, value_name = "S", value_parser = number, help_heading = "Film")]
    hold: Option<f64>,
}

/// What the picture shows of the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Camera {
    /// The whole path if the hoop is large enough then, else the camera goes with the hoop
    Auto,
    /// The whole path, however small the hoop is
    Whole,
    /// The camera goes with the mass centre
    Follow,
}

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
    let AnimateArgs { mut problem, run, out, slow, fps, size: (width, height), camera, hold } = args;
    let kind = kind_of(&out)?;
    let size = Size::new(width, height).map_err(Error::Film)?;
    if problem.case.as_deref() == Some(LIBRATION[0]) {
        problem.case = Some(LIBRATION[1].to_owned());
    }
    let scenario = problem.scenario.as_deref().map(Scenario::read).transpose()?;
    let problem = Problem::resolve(&problem, run.given(), Above::default(), run.max_transitions, scenario)?;
    let units = problem.units;
    let slow = slow.unwrap_or(if units.is_some() { SLOW_SI } else { SLOW });
    let framing = match camera {
        Camera::Auto => Framing::Auto,
        Camera::Whole => Framing::Whole,
        Camera::Follow => Framing::Follow,
    };
    let trajectory = problem.simulate()?;
    let pace = Pace { fps, slow, units, hold_s: hold };
    let film = Film::new(&trajectory, &pace, size, framing).map_err(Error::Film)?;
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

/// Draws the film with a bar on the standard error, if that is a terminal, until it is finished or Ctrl-C comes.
fn play(film: &Film<'_>, encoder: &mut impl Encoder) -> Result<(), FilmError> {
    let stop = interrupt::listen();
    let bar = if io::stderr().is_terminal() {
        ProgressBar::new(film.schedule().frames())
    } else {
        ProgressBar::hidden()
    };
    if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
        bar.set_style(style);
    }
    let result = film.play(encoder, |done| {
        bar.set_position(done);
        !stop.load(Ordering::Relaxed)
    });
    bar.finish_and_clear();
    result
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
