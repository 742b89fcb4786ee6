//! Failures of the command line, as messages and as exit codes.

mod excerpt;
mod hint;

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;

use anstyle::{AnsiColor, Style};
use littlewood::ParameterError;
use littlewood::derivatives::NotDifferentiable;
use littlewood::tables::Quantity;
use littlewood_draw::DrawError;
#[cfg(feature = "figures")]
use littlewood_figures::FigureError;
#[cfg(feature = "film")]
use littlewood_film::FilmError;
use littlewood_sweep::{StoreError, SweepError, ThreadsError};
use thiserror::Error;

use crate::{BAD_INPUT, FAILURE};

pub(crate) use excerpt::Excerpt;

/// Exit code of a program that was asked to end, by whatever signal: that of Ctrl-C, 128 + SIGINT.
const STOPPED: u8 = 130;

/// A failure of the command line. No physical outcome is a failure.
#[derive(Debug, Error)]
pub(crate) enum Error {
    #[error("{error}")]
    Value { error: ParameterError },
    #[error("{error}")]
    ScenarioValue {
        error: ParameterError,
        excerpt: Excerpt,
    },
    #[error("{message}")]
    Scenario {
        message: String,
        help: String,
        excerpt: Excerpt,
    },
    #[error("--uncertainty has two errors of {quantity}")]
    TwoErrors { quantity: Quantity },
    #[error(transparent)]
    NotDifferentiable(NotDifferentiable),
    #[error("there is no case named '{name}'")]
    UnknownCase { name: String, hint: String },
    #[error("missing: {}", names.join(", "))]
    Missing {
        names: Vec<String>,
        flags: Vec<String>,
    },
    #[error("{}", mixed(plain, si))]
    Mixed {
        plain: String,
        si: String,
        hint: String,
    },
    #[error("cannot read the scenario {}: {source}", path.display())]
    Unreadable { path: PathBuf, source: io::Error },
    #[error("cannot write to {}: {source}", path.display())]
    Unwritable { path: PathBuf, source: io::Error },
    /// Writing has failed on the way.
    #[error("writing to {target} failed: {source}")]
    WriteFile { target: String, source: io::Error },
    /// Writing to the standard output, or to a device, has failed on the way.
    #[error("writing to {target} failed: {source}")]
    Write { target: String, source: io::Error },
    #[error("{0}")]
    Sweep(Box<SweepError>),
    #[error("--out {}: {reason}", path.display())]
    Out {
        path: PathBuf,
        reason: String,
        hint: String,
    },
    #[error("{count} samples: a table has at most {most}")]
    LongTable { count: u64, most: u64 },
    #[error("--shade {name}: no such column")]
    UnknownShade { name: String, hint: String },
    #[cfg(feature = "figures")]
    #[error("there is no figure named '{name}'")]
    UnknownFigure { name: String, hint: String },
    #[cfg(feature = "figures")]
    #[error("the figure '{name}' was removed")]
    FigureRemoved { name: String, instead: &'static str },
    #[cfg(feature = "figures")]
    #[error("the chart shows the hoops of the paper, and no other")]
    ChartOfAHoop,
    #[cfg(feature = "figures")]
    #[error("{0}")]
    Figure(FigureError),
    #[error("{0}")]
    Drawing(DrawError),
    #[error("stopped after {done} of {total} starts")]
    Interrupted { done: u64, total: u64, hint: String },
    /// Ctrl-C, or another signal that asks the program to end, in work that cannot be gone on with.
    #[error("stopped")]
    Stopped,
    #[error("{what} requires the feature `{feature}`, which is not compiled in")]
    NotBuilt { what: String, feature: &'static str },
    #[error("`littlewood {command}` is part of the Python package")]
    InPackage { command: &'static str },
    #[error("`littlewood atlas` was removed")]
    AtlasRemoved,
    #[cfg(feature = "lab")]
    #[error("{reason}")]
    NoPage { reason: String, hint: String },
    #[cfg(feature = "lab")]
    #[error("cannot listen on port {port} of 127.0.0.1: {source}")]
    Port { port: u16, source: io::Error },
    #[cfg(feature = "film")]
    #[error("{0}")]
    Film(FilmError),
    #[error("the reader has closed the pipe")]
    ClosedPipe,
}

pub(crate) fn mixed(plain: impl Display, si: impl Display) -> String {
    format!("{plain} is dimensionless and {si} is in SI units: they cannot be combined")
}

impl Error {
    #[allow(clippy::match_same_arms, reason = "an attribute holds for a whole arm")]
    /// 2 for bad input, which a place is where nothing can be written; 1 for another failure; 0
    /// where a reader has left.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::ClosedPipe => 0,
            Self::Write { source, .. }
            | Self::WriteFile { source, .. }
            | Self::Unwritable { source, .. } => of_writing(source),
            #[cfg(feature = "lab")]
            Self::NoPage { .. } | Self::Port { .. } => FAILURE,
            Self::Drawing(DrawError::NoRoom { .. }) => FAILURE,
            #[cfg(feature = "film")]
            Self::Film(FilmError::Write(source)) => of_writing(source),
            #[cfg(feature = "film")]
            Self::Film(
                FilmError::Encoding { .. } | FilmError::NoFfmpeg { .. } | FilmError::Ffmpeg { .. },
            ) => FAILURE,
            Self::Interrupted { .. } | Self::Stopped => STOPPED,
            #[cfg(feature = "film")]
            Self::Film(FilmError::Stopped { .. }) => STOPPED,
            Self::Sweep(error) => of_sweep(error),
            _ => BAD_INPUT,
        }
    }

    /// The place in a file that it is about.
    const fn excerpt(&self) -> Option<&Excerpt> {
        match self {
            Self::ScenarioValue { excerpt, .. } | Self::Scenario { excerpt, .. } => Some(excerpt),
            _ => None,
        }
    }

    /// Writes the message and the hint to the standard error, with the place in the file if there
    /// is one.
    pub(crate) fn print(&self) {
        if matches!(self, Self::ClosedPipe) {
            return;
        }
        // Nothing is left to be done if the standard error is closed as well.
        let _ = anstream::stderr().write_all(self.render().as_bytes());
    }

    fn render(&self) -> String {
        let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
        let cyan = Style::new().bold().fg_color(Some(AnsiColor::Cyan.into()));
        let mut text = format!("{red}error:{red:#} {self}\n");
        if let Some(excerpt) = self.excerpt() {
            text.push_str(&excerpt.render());
        }
        if let Some(hint) = hint::of(self) {
            text.push_str(&format!("\n{cyan}hint:{cyan:#} {hint}\n"));
        }
        text
    }
}

#[cfg(feature = "figures")]
impl Error {
    pub(crate) fn of_figure(error: FigureError) -> Self {
        match error {
            FigureError::Parameter(error) => Self::Value { error },
            FigureError::Axis(error) => error.into(),
            FigureError::Threads(error) => error.into(),
            FigureError::Draw(error) => Self::Drawing(error),
            other => Self::Figure(other),
        }
    }
}

impl<E: Into<SweepError>> From<E> for Error {
    fn from(error: E) -> Self {
        Self::Sweep(Box::new(error.into()))
    }
}

/// The exit code of a failure to write: bad input where the place is to blame, and not the medium.
fn of_writing(source: &io::Error) -> u8 {
    match source.kind() {
        ErrorKind::NotFound
        | ErrorKind::PermissionDenied
        | ErrorKind::AlreadyExists
        | ErrorKind::NotADirectory
        | ErrorKind::IsADirectory
        | ErrorKind::ReadOnlyFilesystem
        | ErrorKind::InvalidInput
        | ErrorKind::InvalidFilename
        | ErrorKind::NotSeekable => BAD_INPUT,
        _ => FAILURE,
    }
}

/// The exit code of a sweep: bad input, unless the system is to blame.
fn of_sweep(error: &SweepError) -> u8 {
    match error {
        SweepError::Store(StoreError::Unwritable { source, .. }) => of_writing(source),
        SweepError::Store(StoreError::Encoding { .. })
        | SweepError::Threads(ThreadsError::NotStarted { .. }) => FAILURE,
        _ => BAD_INPUT,
    }
}
