//! What can go wrong, for the person who typed it, and the exit code that a program sees.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use anstyle::{AnsiColor, Style};
use littlewood::ParameterError;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use thiserror::Error;

/// A failure of the command line. Physical outcomes, whatever they are, are not failures.
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
    /// A scenario file that is not one.
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
    /// The reader of the output has seen enough.
    #[error("the reader has closed the pipe")]
    ClosedPipe,
}

impl Error {
    /// 2 for bad input, 1 for a failure to write, 0 where a reader has left.
    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::ClosedPipe => ExitCode::SUCCESS,
            Self::Write { .. } | Self::WriteFile { .. } => ExitCode::from(1),
            _ => ExitCode::from(2),
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
