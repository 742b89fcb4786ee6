//! `littlewood figures`: the figures of the paper, of its hoops or of any other.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use littlewood_figures::{
    Entry, FIGURES, Figure, FigureError, LEAST_SCALE, MOST_SCALE, Subject, find_figure, plain,
};

use crate::args::{FigureFormat, FiguresArgs};
use crate::error::Error;
use crate::output::Output;
use crate::problem::{Above, Problem};
use crate::scenario::Scenario;

/// Runs the command.
///
/// # Errors
/// Bad input, a hoop that a figure cannot show, or a failure to write.
pub(crate) fn run(args: &FiguresArgs) -> Result<(), Error> {
    if args.list {
        return list();
    }
    let entries = chosen(&args.names)?;
    check_scale(args.scale)?;
    let Some(folder) = &args.out else { return Ok(()) };
    prepare(folder)?;

    // All is drawn before anything is written: a figure that cannot be made leaves no others behind.
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    let mut left_out: Vec<(&Entry, FigureError)> = Vec::new();
    for entry in entries {
        match entry.figure(&subject(args, entry)?) {
            Ok(figure) => {
                for format in &args.format {
                    files.push((
                        folder.join(file_name(entry, *format)),
                        content(&figure, *format, args.scale)?,
                    ));
                }
            }
            // Without names all figures are meant that this hoop has.
            Err(error) if args.names.is_empty() && is_about_the_hoop(&error) => left_out.push((entry, error)),
            Err(error) => return Err(Error::of_figure(error)),
        }
    }
    if files.is_empty()
        && let Some((_, error)) = left_out.pop()
    {
        return Err(Error::of_figure(error));
    }
    for (path, bytes) in &files {
        Output::open(Some(path))?.write(|writer| writer.write_all(bytes))?;
    }
    Output::Stdout.write(|writer| {
        for (path, _) in &files {
            writeln!(writer, "{}", path.display())?;
        }
        for (entry, error) in &left_out {
            writeln!(writer, "left out {}: {error}", entry.name)?;
        }
        Ok(())
    })
}

fn list() -> Result<(), Error> {
    let width = FIGURES.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
    let case = FIGURES.iter().map(|entry| entry.case.len()).max().unwrap_or(0);
    Output::Stdout.write(|writer| {
        for entry in FIGURES {
            writeln!(writer, "{:width$}  {:case$}  {}", entry.name, entry.case, entry.title)?;
        }
        Ok(())
    })
}

/// The figures of these names in the order of the catalogue, each once; all if there are no names.
fn chosen(names: &[String]) -> Result<Vec<&'static Entry>, Error> {
    for name in names {
        if find_figure(name).is_none() {
            return Err(Error::UnknownFigure { name: name.clone(), hint: nearest(name) });
        }
    }
    let is_chosen = |entry: &&Entry| names.is_empty() || names.iter().any(|name| name == entry.name);
    Ok(FIGURES.iter().filter(is_chosen).collect())
}

/// The names that look most like this one.
fn nearest(name: &str) -> String {
    let wanted = name.to_lowercase().replace([' ', '_'], "-");
    let likeness = |entry: &Entry| {
        let whole = strsim::jaro_winkler(&wanted, entry.name);
        // "3b" is figure-3b.
        if entry.name.ends_with(&wanted) && !wanted.is_empty() { 1.0 } else { whole }
    };
    let mut ranked: Vec<(f64, &str)> = FIGURES
        .iter()
        .map(|entry| (likeness(entry), entry.name))
        .filter(|(likeness, _)| *likeness > 0.75)
        .collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let names: Vec<String> = ranked.iter().take(3).map(|(_, name)| format!("'{name}'")).collect();
    if names.is_empty() {
        "`littlewood figures --list` lists the names".to_owned()
    } else {
        format!("did you mean {}? `littlewood figures --list` lists the names", names.join(" or "))
    }
}

fn check_scale(scale: f64) -> Result<(), Error> {
    if (LEAST_SCALE..=MOST_SCALE).contains(&scale) {
        Ok(())
    } else {
        Err(Error::of_figure(FigureError::Scale { scale, least: LEAST_SCALE, most: MOST_SCALE }))
    }
}

/// Makes the folder, if it is not there.
fn prepare(folder: &Path) -> Result<(), Error> {
    let unwritable = |source: io::Error| Error::Unwritable { path: folder.to_owned(), source };
    if folder.exists() && !folder.is_dir() {
        return Err(unwritable(io::Error::new(io::ErrorKind::NotADirectory, "it is not a folder")));
    }
    fs::create_dir_all(folder).map_err(unwritable)
}

/// The hoop and the start of a figure: those of its own case, as far as nothing else is asked for.
fn subject(args: &FiguresArgs, entry: &Entry) -> Result<Subject, Error> {
    let problem = args.to_problem(entry.case);
    let scenario = problem.scenario.as_deref().map(Scenario::read).transpose()?;
    let problem =
        Problem::resolve(&problem, args.run.given(), Above::default(), args.run.max_transitions, scenario)?;
    Ok(Subject { hoop: problem.hoop, start: problem.start, limits: problem.limits })
}

const fn is_about_the_hoop(error: &FigureError) -> bool {
    matches!(
        error,
        FigureError::NeedsInertia { .. }
            | FigureError::NeedsMassless { .. }
            | FigureError::NeedsRim { .. }
            | FigureError::NeedsOffset { .. }
            | FigureError::NoMotion { .. }
    )
}

fn file_name(entry: &Entry, format: FigureFormat) -> String {
    let ending = match format {
        FigureFormat::Svg => "svg",
        FigureFormat::Png => "png",
        FigureFormat::Csv => "csv",
        FigureFormat::Txt => "txt",
    };
    format!("{}.{ending}", entry.name)
}

fn content(figure: &Figure, format: FigureFormat, scale: f64) -> Result<Vec<u8>, Error> {
    Ok(match format {
        FigureFormat::Svg => figure.svg().map_err(Error::of_figure)?.into_bytes(),
        FigureFormat::Png => figure.png(scale).map_err(Error::of_figure)?,
        FigureFormat::Csv => figure.csv().into_bytes(),
        FigureFormat::Txt => format!("{}\n\n{}\n", plain(&figure.title), plain(&figure.caption)).into_bytes(),
    })
}
