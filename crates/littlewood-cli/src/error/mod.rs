//! Failures of the command line, as messages and as exit codes.

mod hint;

use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

use anstyle::{AnsiColor, Style};
use littlewood::{ParameterError, Quantity};
use littlewood_figures::FigureError;
use littlewood_film::FilmError;
use littlewood_sweep::{AxisError, PictureError, StoreError, SweepError};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use thiserror::Error;

use crate::BAD_INPUT;
use crate::interrupt::STOPPED;

use hint::{of_axis, of_figure, of_sweep};

/// A failure of the command line. No physical outcome is a failure.
#[derive(Debug, Error, Diagnostic)]
pub(crate) enum Error {
    /// A value has no physical meaning.
    #[error("{error}")]
    #[diagnostic(help("{}", error.hint()))]
    Value {
        /// The value and its bound.
        error: ParameterError,
    },
    /// A value in a scenario file has no physical meaning.
    #[error("{error}")]
    #[diagnostic(help("{}", error.hint()))]
    ScenarioValue {
        /// The value and its bound.
        error: ParameterError,
        /// The file.
        #[source_code]
        source_code: Arc<NamedSource<String>>,
        /// The value in the file.
        #[label("out of bounds")]
        span: SourceSpan,
    },
    /// A scenario file that is malformed.
    #[error("{message}")]
    #[diagnostic(help("{help}"))]
    Scenario {
        /// What is wrong.
        message: String,
        /// What to do.
        help: String,
        /// The file.
        #[source_code]
        source_code: Arc<NamedSource<String>>,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },
    /// No case has this name.
    #[error("there is no case named '{name}'")]
    #[diagnostic(help("{hint}"))]
    UnknownCase {
        /// The name that was given.
        name: String,
        /// The nearest names.
        hint: String,
    },
    /// Values that have no default.
    #[error("missing: {}", names.join(", "))]
    #[diagnostic(help(
        "give {}, or start from a case (`littlewood cases` lists them) or a scenario file (--scenario)",
        flags.join(", ")
    ))]
    Missing {
        /// The names of the quantities.
        names: Vec<String>,
        /// Their flags.
        flags: Vec<String>,
    },
    /// SI and dimensionless values side by side.
    #[error("{plain} has no dimension, {si} is in SI units: the two do not go together")]
    #[diagnostic(help("{hint}"))]
    Mixed {
        /// The dimensionless quantity.
        plain: String,
        /// The SI quantity, or the switch that asks for SI units.
        si: String,
        /// What to do.
        hint: String,
    },
    /// A scenario file that cannot be read.
    #[error("cannot read the scenario {}: {source}", path.display())]
    #[diagnostic(help("--scenario takes the path of a TOML file in UTF-8"))]
    Unreadable {
        /// Its path.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file for the output that cannot be written to.
    #[error("cannot write to {}: {source}", path.display())]
    #[diagnostic(help("--out takes the path of a file in a folder that exists and can be written to"))]
    Unwritable {
        /// Its path.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Writing has failed on the way.
    #[error("writing to {target} failed: {source}")]
    #[diagnostic(help("what stood there before has not been touched"))]
    WriteFile {
        /// The file.
        target: String,
        /// Why.
        source: io::Error,
    },
    /// Writing to the standard output, or to a device, has failed on the way.
    #[error("writing to {target} failed: {source}")]
    Write {
        /// Where to.
        target: String,
        /// Why.
        source: io::Error,
    },
    /// A sweep that cannot be done, or not be written.
    #[error("{0}")]
    #[diagnostic(help("{}", of_sweep(.0)))]
    Sweep(Box<SweepError>),
    /// A row of a list of hoops whose parameters, together with the axes, are invalid.
    #[error("{}, line {line}: {source}", path.display())]
    #[diagnostic(help("{}", of_axis(.source)))]
    Hoop {
        /// The list.
        path: PathBuf,
        /// Line, from 1.
        line: u64,
        /// What is wrong.
        source: Box<AxisError>,
    },
    /// A column that a list of hoops cannot have.
    #[error("{}: column {column} {reason}", path.display())]
    #[diagnostic(help(
        "columns of --hoops are those of {} that no --axis varies",
        Quantity::HOOP.map(Quantity::name).join(", ")
    ))]
    HoopColumn {
        /// The list.
        path: PathBuf,
        /// The column.
        column: Quantity,
        /// What is wrong with it.
        reason: String,
    },
    /// An `--out` that the command does not know what to do with.
    #[error("--out {}: {reason}", path.display())]
    #[diagnostic(help("{hint}"))]
    Out {
        /// The path.
        path: PathBuf,
        /// Why.
        reason: String,
        /// What to do.
        hint: String,
    },
    /// A column that a picture cannot show.
    #[error("--shade {name}: there is no such column")]
    #[diagnostic(help("{hint}"))]
    UnknownShade {
        /// The name that was given.
        name: String,
        /// The nearest names, and all.
        hint: String,
    },
    /// No figure has this name.
    #[error("there is no figure named '{name}'")]
    #[diagnostic(help("{hint}"))]
    UnknownFigure {
        /// The name that was given.
        name: String,
        /// The nearest names.
        hint: String,
    },
    /// A figure that cannot be made.
    #[error("{0}")]
    #[diagnostic(help("{}", of_figure(.0)))]
    Figure(FigureError),
    /// Ctrl-C.
    #[error("stopped after {done} of {total} starts")]
    #[diagnostic(help("{hint}"))]
    Interrupted {
        /// Starts that are done.
        done: u64,
        /// All starts.
        total: u64,
        /// How to go on.
        hint: String,
    },
    /// Ctrl-C, or another signal that asks the program to end, in work that cannot be gone on with.
    #[error("stopped")]
    #[diagnostic(help("files that were not finished are removed; what had been finished before is kept"))]
    Stopped,
    /// The program was built without the laboratory.
    #[error("this program was built without the laboratory")]
    #[diagnostic(help(
        "in the sources, `web/build.sh` makes the page (it needs node); build the program again after it"
    ))]
    NoLab,
    /// A port that cannot be listened on.
    #[error("cannot listen on port {port} of 127.0.0.1: {source}")]
    #[diagnostic(help("give another --port, or leave the flag out for a free one"))]
    Port {
        /// The port that was asked for.
        port: u16,
        /// Why.
        source: io::Error,
    },
    /// A film that cannot be made, or not be written.
    #[error("{0}")]
    #[diagnostic(help("{}", .0.hint()))]
    Film(FilmError),
    /// The reader of the output has closed the pipe.
    #[error("the reader has closed the pipe")]
    ClosedPipe,
}

impl Error {
    /// 2 for bad input, 1 for a failure to write, 0 where a reader has left.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::ClosedPipe => 0,
            Self::Write { .. }
            | Self::WriteFile { .. }
            | Self::NoLab
            | Self::Port { .. }
            | Self::Figure(FigureError::Drawing(_))
            | Self::Film(
                FilmError::Write(_)
                | FilmError::Encoding { .. }
                | FilmError::NoFfmpeg { .. }
                | FilmError::Ffmpeg { .. },
            ) => 1,
            Self::Interrupted { .. } | Self::Stopped | Self::Film(FilmError::Stopped { .. }) => STOPPED,
            Self::Sweep(error) if is_of_the_system(error) => 1,
            Self::Value { .. }
            | Self::ScenarioValue { .. }
            | Self::Scenario { .. }
            | Self::UnknownCase { .. }
            | Self::Missing { .. }
            | Self::Mixed { .. }
            | Self::Unreadable { .. }
            | Self::Unwritable { .. }
            | Self::Sweep(_)
            | Self::Hoop { .. }
            | Self::HoopColumn { .. }
            | Self::Out { .. }
            | Self::UnknownShade { .. }
            | Self::UnknownFigure { .. }
            | Self::Figure(_)
            | Self::Film(_) => BAD_INPUT,
        }
    }

    /// Writes the message and the hint to the standard error, with the place in the file if there is one.
    pub(crate) fn print(&self) {
        if matches!(self, Self::ClosedPipe) {
            return;
        }
        // Nothing is left to be done if the standard error is closed as well.
        let _ = anstream::stderr().write_all(self.render().as_bytes());
    }

    fn render(&self) -> String {
        if self.source_code().is_some() {
            let mut text = String::new();
            let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode()).with_links(false);
            if handler.render_report(&mut text, self).is_ok() {
                return text;
            }
        }
        let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
        let cyan = Style::new().bold().fg_color(Some(AnsiColor::Cyan.into()));
        let mut text = format!("{red}error:{red:#} {self}\n");
        if let Some(hint) = self.help() {
            text.push_str(&format!("\n{cyan}hint:{cyan:#} {hint}\n"));
        }
        text
    }
}

impl Error {
    /// Of a figure.
    pub(crate) fn of_figure(error: FigureError) -> Self {
        match error {
            FigureError::Parameter(error) => Self::Value { error },
            other => Self::Figure(other),
        }
    }
}

impl<E: Into<SweepError>> From<E> for Error {
    fn from(error: E) -> Self {
        Self::Sweep(Box::new(error.into()))
    }
}

/// Whether the system is to blame, and not what was asked for.
const fn is_of_the_system(error: &SweepError) -> bool {
    matches!(
        error,
        SweepError::Store(StoreError::Unwritable { .. } | StoreError::Encoding { .. })
            | SweepError::Picture(PictureError::Drawing(_))
            | SweepError::Threads { .. }
    )
}
