//! `littlewood animate`: a film of a motion.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::sync::atomic::Ordering;

use littlewood::Trajectory;
use littlewood::si::Units;
use littlewood::tables::{Dimension, Quantity};
use littlewood_film::{Encoder, FfmpegFilm, Film, FilmError, FrameSize, GifFilm, Pace, Video};

use crate::args::AnimateArgs;
use crate::error::Error;
use crate::interrupt;
use crate::output::{Output, by_ending};
use crate::problem::Problem;
use crate::progress::{Bar as Progress, Count};
use crate::request::Request;

/// Seconds of film for a unit of time, and how many times slower than real a film in SI units is.
const SLOW: f64 = 3.0;
const SLOW_SI: f64 = 10.0;

/// Runs the command.
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
        with,
    } = args;
    // None for a GIF, which needs no other program.
    let video = by_ending(
        &out,
        "the film",
        &[
            ("gif", None),
            ("mp4", Some(Video::Mp4)),
            ("webm", Some(Video::WebM)),
        ],
    )?;
    let size = FrameSize::new(width, height).map_err(|error| Error::Film(error.into()))?;
    let problem = Problem::resolve(Request::new(&problem, Some(&run))?)?;
    let units = problem.units;
    let slow = slow.unwrap_or(if units.is_some() { SLOW_SI } else { SLOW });
    let trajectory = problem.simulate()?;
    let pace = Pace {
        fps,
        slow,
        units,
        hold_s: hold,
    };
    let film = Film::new(&trajectory, &pace, size, camera).map_err(Error::Film)?;
    let film = match with {
        None => film,
        Some(pane) => film.with_pane(pane),
    };
    let output = Output::open(Some(&out))?;
    let made = match video {
        None => write(output, |writer| {
            let mut encoder = GifFilm::new(writer, &film)?;
            play(&film, &mut encoder, &Progress::new())?;
            encoder.finish().map(drop)
        }),
        Some(video) => write_with_ffmpeg(output, &film, video),
    };
    made.and_then(|()| say_what_is_shown(&film, &trajectory, units.as_ref()))
}

/// Says up to when a motion without end is shown.
fn say_what_is_shown(
    film: &Film<'_>,
    trajectory: &Trajectory,
    units: Option<&Units>,
) -> Result<(), Error> {
    let schedule = film.schedule();
    let Some(part) = schedule.part.label() else {
        return Ok(());
    };
    let until = match units {
        Some(units) => format!("t = {:.4} s", units.to_si(Dimension::Time, schedule.end)),
        None => format!("{} = {:.4}", Quantity::Until.sign(), schedule.end),
    };
    let outcome = trajectory.outcome().kind().label();
    Output::Stdout.write(|writer| {
        writeln!(
            writer,
            "The film shows {part} ({outcome}), to {until}; --until says otherwise."
        )
    })
}

/// What a bar says while ffmpeg ends its file.
const AT_THE_END: &str = "frames are drawn; ffmpeg finishes the film";

/// Draws the film until it is finished or Ctrl-C comes.
fn play(film: &Film<'_>, encoder: &mut impl Encoder, bar: &Progress) -> Result<(), FilmError> {
    let stop = interrupt::asked();
    let total = film.schedule().frames;
    film.play(encoder, |done| {
        bar.show("frames", Count { done, total });
        !stop.load(Ordering::Relaxed)
    })
}

fn write(
    output: Output,
    body: impl FnOnce(&mut dyn Write) -> Result<(), FilmError>,
) -> Result<(), Error> {
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
fn write_with_ffmpeg(output: Output, film: &Film<'_>, video: Video) -> Result<(), Error> {
    let Output::File { temporary, .. } = &output else {
        return Err(Error::Film(FilmError::Write(
            io::ErrorKind::NotSeekable.into(),
        )));
    };
    let mut encoder = FfmpegFilm::start(OsStr::new("ffmpeg"), temporary.path(), film, video)
        .map_err(Error::Film)?;
    let bar = Progress::new();
    play(film, &mut encoder, &bar).map_err(Error::Film)?;
    // It has frames in hand still, and says nothing of them.
    let done = film.schedule().frames;
    bar.show(AT_THE_END, Count { done, total: 0 });
    encoder.finish().map_err(Error::Film)?;
    drop(bar);
    output.write(|_| Ok(()))
}
