//! `littlewood animate`: a film of a motion.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;
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

/// What is written.
#[derive(Clone, Copy)]
enum Format {
    /// Needs no other program.
    Gif,
    Video(Video),
    /// One frame.
    Still,
}

/// Sizes of a film of a motion, and of two.
const SIZE: (u32, u32) = (640, 360);
const SIZE_OF_TWO: (u32, u32) = (640, 600);

/// Runs the command.
pub(crate) fn run(args: AnimateArgs) -> Result<(), Error> {
    let format = by_ending(
        &args.out,
        "the film",
        &[
            ("gif", Format::Gif),
            ("mp4", Format::Video(Video::Mp4)),
            ("webm", Format::Video(Video::WebM)),
            ("png", Format::Still),
        ],
    )?;
    let usual = if args.beside.is_some() {
        SIZE_OF_TWO
    } else {
        SIZE
    };
    let (width, height) = args.size.unwrap_or(usual);
    let size = FrameSize::new(width, height).map_err(|error| Error::Film(error.into()))?;
    let problem = Problem::resolve(Request::new(&args.problem, Some(&args.run))?)?;
    let units = problem.units;
    let trajectory = problem.simulate()?;
    let other = args
        .beside
        .as_deref()
        .map(|name| beside(name, &args))
        .transpose()?;
    let usual = if units.is_some() { SLOW_SI } else { SLOW };
    let pace = |units| Pace {
        fps: args.fps,
        slow: args.slow.unwrap_or(usual),
        units,
        hold_s: args.hold,
    };
    let film_of = |motion, units| Film::new(motion, &pace(units), size, args.camera);
    let film = film_of(&trajectory, units).and_then(|film| match &other {
        None => Ok(film),
        // A motion without units has those of the first.
        Some(other) => film.over(
            film_of(&other.trajectory, other.units.or(units))?,
            [
                &name_of(&problem, args.problem.scenario.as_deref()),
                &other.name,
            ],
        ),
    });
    let film = film.map_err(Error::Film)?;
    let film = match args.with {
        None => film,
        Some(pane) => film.with_pane(pane),
    };
    let output = Output::open(Some(&args.out))?;
    write_as(format, output, &film)?;
    match format {
        Format::Gif | Format::Video(_) => say_what_is_shown(&film, &trajectory, units.as_ref()),
        Format::Still => Ok(()),
    }
}

fn write_as(format: Format, output: Output, film: &Film<'_>) -> Result<(), Error> {
    match format {
        Format::Gif => write(output, |writer| {
            let mut encoder = GifFilm::new(writer, film)?;
            play(film, &mut encoder, &Progress::new())?;
            encoder.finish().map(drop)
        }),
        Format::Video(video) => write_with_ffmpeg(output, film, video),
        Format::Still => write(output, |writer| {
            Ok(writer.write_all(&film.png(film.telling())?)?)
        }),
    }
}

/// A motion that runs beside another.
struct Other {
    name: String,
    trajectory: Trajectory,
    units: Option<Units>,
}

fn beside(name: &str, args: &AnimateArgs) -> Result<Other, Error> {
    let problem = Problem::resolve(Request::named(name, &args.run)?)?;
    Ok(Other {
        name: name_of(&problem, Some(Path::new(name))),
        trajectory: problem.simulate()?,
        units: problem.units,
    })
}

/// What a motion is called: by its case, and whether it differs from that, or by its file.
fn name_of(problem: &Problem, file: Option<&Path>) -> String {
    let changes = &problem.changes;
    match (problem.case, file.and_then(Path::file_stem)) {
        (Some(case), _) if changes.replaced.is_empty() && changes.added.is_empty() => {
            case.name.to_owned()
        }
        (Some(case), _) => format!("{}, changed", case.name),
        (None, Some(stem)) => stem.to_string_lossy().into_owned(),
        (None, None) => "as given".to_owned(),
    }
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
