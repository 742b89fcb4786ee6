//! `littlewood figures`: the figures of the paper, of its hoops or of any other.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use littlewood_figures::{
    FIGURES, Figure, FigureEntry, FigureError, FigureInput, check_scale, find_figure,
};

use crate::args::{FigureFormat, FiguresArgs};
use crate::error::Error;
use crate::nearest;
use crate::output::{Output, check_folder};
use crate::problem::Problem;
use crate::progress::{Bar, Count};
use crate::request::{Overrides, Request};
use crate::work::STARTS;

/// Runs the command.
pub(crate) fn run(args: &FiguresArgs) -> Result<(), Error> {
    if args.list {
        return list();
    }
    let entries = chosen(&args.names)?;
    check_scale(args.scale).map_err(Error::Drawing)?;
    let Some(folder) = &args.out else {
        return Ok(());
    };
    prepare(folder)?;

    // All is drawn before anything is written: a figure that cannot be made leaves no others
    // behind.
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    let mut left_out = LeftOut::default();
    let bar = Bar::new();
    let total = entries.len() as u64;
    for (done, entry) in (0..).zip(entries) {
        bar.show("figures", Count { done, total });
        let mut watch = |done, total| bar.show(STARTS, Count { done, total });
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
        match entry.figure_with(&input, &mut watch) {
            Ok(figure) => {
                for format in &args.format {
                    let (ending, bytes) = file(&figure, *format, args)?;
                    files.push((folder.join(format!("{}.{ending}", entry.name)), bytes));
                }
            }
            // Without names all figures are meant that this hoop has.
            Err(error) if args.names.is_empty() && is_about_the_hoop(&error) => {
                let text = error.to_string();
                let reason = text
                    .strip_prefix(entry.name)
                    .unwrap_or(&text)
                    .trim_start()
                    .to_owned();
                left_out.add(entry, reason, Error::of_figure(error));
            }
            Err(error) => return Err(Error::of_figure(error)),
        }
    }
    drop(bar);
    if files.is_empty()
        && let Some(error) = left_out.last.take()
    {
        return Err(error);
    }
    for (path, bytes) in &files {
        Output::open(Some(path))?.write(|writer| writer.write_all(bytes))?;
    }
    Output::Stdout.write(|writer| {
        for (path, _) in &files {
            writeln!(writer, "{}", path.display())?;
        }
        match left_out.line() {
            Some(line) => writeln!(writer, "{line}"),
            None => Ok(()),
        }
    })
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
    let width = FIGURES
        .iter()
        .map(|entry| entry.name.len())
        .max()
        .unwrap_or(0);
    let case = FIGURES
        .iter()
        .map(|entry| entry.case.len())
        .max()
        .unwrap_or(0);
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

/// Makes the folder in one that is there, unless it is there itself.
fn prepare(folder: &Path) -> Result<(), Error> {
    let unwritable = |source: io::Error| Error::Unwritable {
        path: folder.to_owned(),
        source,
    };
    if folder.exists() && !folder.is_dir() {
        return Err(unwritable(io::Error::new(
            io::ErrorKind::NotADirectory,
            "it is not a folder",
        )));
    }
    check_folder(folder)?;
    match fs::create_dir(folder) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => Err(unwritable(error)),
        _ => Ok(()),
    }
}

/// The hoop and the start of a figure: those of its own case, as far as nothing else is asked for.
fn subject(args: &FiguresArgs, entry: &FigureEntry) -> Result<FigureInput, Error> {
    let is_si = args.along.is_some_and(|along| along.is_si());
    let request = Request {
        overrides: Overrides {
            given: Vec::new(),
            si: is_si,
        },
        ..Request::new(&args.problem(entry.case), Some(&args.run))?
    };
    let problem = Problem::resolve(request)?;
    let input = FigureInput::new(problem.hoop, problem.start, problem.limits);
    let along = args
        .along
        .map(|along| along.resolve(problem.units.as_ref()))
        .transpose()?;
    Ok(FigureInput {
        impact: args.impact,
        along,
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
            | FigureError::NeedsLevel { .. }
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
        FigureFormat::Md => ("md", figure.caption_md().into_bytes()),
        FigureFormat::Tex => ("tex", figure.caption_tex().into_bytes()),
    })
}
