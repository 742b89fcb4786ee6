//! `littlewood figures`: the figures of the paper, of its hoops or of any other.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use littlewood_figures::{
    FIGURES, Figure, FigureEntry, FigureError, FigureInput, check_scale, find_figure, instead_of,
};

use crate::args::{FigureFormat, FiguresArgs};
use crate::error::Error;
use crate::nearest;
use crate::output::{Output, check_folder};
use crate::problem::Problem;
use crate::progress::{Bar, Count};
use crate::request::Request;
use crate::work::STARTS;

/// Runs the command.
pub(crate) fn run(args: &FiguresArgs) -> Result<(), Error> {
    if args.list {
        return list();
    }
    // Only the figure that was removed took a line.
    let line = args.along.is_some().then(|| "bifurcation".to_owned());
    let names: Vec<String> = args.names.iter().cloned().chain(line).collect();
    let entries = chosen(&names)?;
    check_scale(args.scale).map_err(Error::Drawing)?;
    let Some(folder) = &args.out else {
        return Ok(());
    };
    check(folder)?;

    // Before anything is written, all that is quick is drawn and the rest is checked: bad input
    // leaves no files behind.
    let mut left_out = LeftOut::default();
    let mut begun: Vec<Begun> = Vec::new();
    for entry in entries {
        let input = match subject(args, entry) {
            Ok(input) => input,
            // The hoop of the figure's own case does not bear what was asked for.
            Err(error) if args.names.is_empty() && args.takes_own_cases() => {
                let reason = format!(
                    "its own hoop, of the case {}, cannot have this: {error}",
                    entry.case
                );
                left_out.add(entry, reason, error);
                continue;
            }
            Err(error) => return Err(error),
        };
        match entry.figure_if_quick(&input) {
            Ok(figure) => begun.push(Begun {
                entry,
                input,
                figure,
            }),
            Err(error) => left_out.take(args, entry, error)?,
        }
    }
    let mut written: Vec<PathBuf> = Vec::new();
    let mut result = Ok(());
    if !begun.is_empty() {
        make(folder)?;
        // Each figure is written once it is drawn: what comes later does not undo it.
        result = begun_to_files(args, folder, begun, &mut left_out, &mut written);
    }
    // Where the standard error is closed nobody reads it.
    if let Some(line) = left_out.line() {
        let _ = writeln!(anstream::stderr(), "{line}");
    }
    if written.is_empty() && result.is_ok() {
        result = left_out.last.take().map_or(Ok(()), Err);
    }
    Output::Stdout.write(|writer| {
        written
            .iter()
            .try_for_each(|path| writeln!(writer, "{}", path.display()))
    })?;
    result
}

/// A figure that can be drawn, or is drawn already.
struct Begun {
    entry: &'static FigureEntry,
    input: FigureInput,
    figure: Option<Figure>,
}

/// Draws what is not drawn yet, and writes figure after figure.
fn begun_to_files(
    args: &FiguresArgs,
    folder: &Path,
    begun: Vec<Begun>,
    left_out: &mut LeftOut,
    written: &mut Vec<PathBuf>,
) -> Result<(), Error> {
    let bar = Bar::new();
    let total = begun.len() as u64;
    for (done, begun) in (0..).zip(begun) {
        let Begun {
            entry,
            input,
            figure,
        } = begun;
        bar.show_of(entry.name, "figures", Count { done, total });
        let mut watch = |done, total| bar.show_of(entry.name, STARTS, Count { done, total });
        let drawn = match figure {
            Some(figure) => Ok(figure),
            None => entry.figure_with(&input, &mut watch),
        };
        let figure = match drawn {
            Ok(figure) => figure,
            Err(error) => {
                left_out.take(args, entry, error)?;
                continue;
            }
        };
        for format in &args.format {
            let (ending, bytes) = file(&figure, *format, args)?;
            let path = folder.join(format!("{}.{ending}", entry.name));
            Output::open(Some(&path))?.write(|writer| writer.write_all(&bytes))?;
            written.push(path);
        }
    }
    Ok(())
}

/// Figures that cannot be made of a hoop.
#[derive(Debug, Default)]
struct LeftOut {
    /// Each reason once, with the names of the figures.
    reasons: Vec<(String, Vec<&'static str>)>,
    last: Option<Error>,
}

impl LeftOut {
    fn add(&mut self, entry: &FigureEntry, reason: String, error: Error) {
        self.last = Some(error);
        match self.reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, names)) => names.push(entry.name),
            None => self.reasons.push((reason, vec![entry.name])),
        }
    }

    /// Leaves out a figure that this hoop does not have, unless it was asked for by its name.
    fn take(
        &mut self,
        args: &FiguresArgs,
        entry: &FigureEntry,
        error: FigureError,
    ) -> Result<(), Error> {
        if !args.names.is_empty() || !is_about_the_hoop(&error) {
            return Err(Error::of_figure(error));
        }
        let text = error.to_string();
        let reason = text.strip_prefix(entry.name).unwrap_or(&text).trim_start();
        self.add(entry, reason.to_owned(), Error::of_figure(error));
        Ok(())
    }

    /// All of it in a line.
    fn line(&self) -> Option<String> {
        let parts: Vec<String> = self
            .reasons
            .iter()
            .map(|(reason, names)| format!("{} ({reason})", names.join(", ")))
            .collect();
        (!parts.is_empty()).then(|| format!("left out {}", parts.join(", ")))
    }
}

fn list() -> Result<(), Error> {
    let widest = |of: fn(&FigureEntry) -> &str| FIGURES.iter().map(|it| of(it).len()).max();
    let width = widest(|entry| entry.name).unwrap_or(0);
    let case = widest(|entry| entry.case).unwrap_or(0);
    Output::Stdout.write(|writer| {
        for entry in FIGURES {
            writeln!(
                writer,
                "{:width$}  {:case$}  {}",
                entry.name, entry.case, entry.title
            )?;
        }
        Ok(())
    })
}

/// The figures of these names in the order of the catalogue, each once; all if there are no names.
fn chosen(names: &[String]) -> Result<Vec<&'static FigureEntry>, Error> {
    for name in names {
        if let Some(instead) = instead_of(name) {
            return Err(Error::FigureRemoved {
                name: name.clone(),
                instead,
            });
        }
        if find_figure(name).is_none() {
            let known = FIGURES.iter().map(|entry| entry.name);
            let hint = nearest::hint(name, known, "`littlewood figures --list` lists the names");
            return Err(Error::UnknownFigure {
                name: name.clone(),
                hint,
            });
        }
    }
    let is_chosen =
        |entry: &&FigureEntry| names.is_empty() || names.iter().any(|name| name == entry.name);
    Ok(FIGURES.iter().filter(is_chosen).collect())
}

fn unwritable(folder: &Path, source: io::Error) -> Error {
    Error::Unwritable {
        path: folder.to_owned(),
        source,
    }
}

/// Refuses what cannot be the folder.
fn check(folder: &Path) -> Result<(), Error> {
    if folder.exists() && !folder.is_dir() {
        let error = io::Error::new(io::ErrorKind::NotADirectory, "it is not a folder");
        return Err(unwritable(folder, error));
    }
    check_folder(folder)
}

/// Makes the folder in one that is there, unless it is there itself.
fn make(folder: &Path) -> Result<(), Error> {
    match fs::create_dir(folder) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
            Err(unwritable(folder, error))
        }
        _ => Ok(()),
    }
}

/// The hoop and the start of a figure: those of its own case, as far as nothing else is asked for.
fn subject(args: &FiguresArgs, entry: &FigureEntry) -> Result<FigureInput, Error> {
    let request = Request::new(&args.problem(entry.case), Some(&args.run))?;
    let problem = Problem::resolve(request)?;
    let input = FigureInput::new(problem.hoop, problem.start, problem.limits);
    Ok(FigureInput {
        impact: args.impact,
        units: problem.units,
        width_mm: args.width_mm,
        ..input
    })
}

const fn is_about_the_hoop(error: &FigureError) -> bool {
    !matches!(
        error,
        FigureError::Parameter(_)
            | FigureError::UnknownCase { .. }
            | FigureError::ImpactNumber { .. }
            | FigureError::Draw(_)
            | FigureError::Threads(_)
            | FigureError::Axis(_)
    )
}

/// The ending of a file in this format, and what is in it.
fn file(
    figure: &Figure,
    format: FigureFormat,
    args: &FiguresArgs,
) -> Result<(&'static str, Vec<u8>), Error> {
    Ok(match format {
        FigureFormat::Svg => ("svg", figure.svg().into_bytes()),
        FigureFormat::Png => ("png", figure.png(args.scale).map_err(Error::Drawing)?),
        FigureFormat::Pdf => ("pdf", figure.pdf()),
        FigureFormat::Csv => ("csv", figure.csv().into_bytes()),
        FigureFormat::Txt => ("txt", figure.caption_txt().into_bytes()),
    })
}
