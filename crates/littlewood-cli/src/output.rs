//! Where the output goes: the standard output, or a file that is replaced only once everything has
//! been written.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use littlewood_report::sheet::Sheet;

use crate::args::ShortFormat;
use crate::error::Error;
use crate::unfinished::{Temporary, folder_of};

#[derive(Debug)]
pub(crate) enum Output {
    Stdout,
    /// A regular file of this path, written under another name in the same folder.
    File {
        temporary: Temporary,
        path: PathBuf,
    },
    /// A pipe or a device, which cannot be replaced.
    Device {
        file: File,
        path: PathBuf,
    },
}

impl Output {
    /// Opens the output before the work begins, so that a wrong path is known at once.
    pub(crate) fn open(path: Option<&Path>) -> Result<Self, Error> {
        let Some(path) = path else {
            return Ok(Self::Stdout);
        };
        open_file(path).map_err(|source| Error::Unwritable {
            path: path.to_owned(),
            source,
        })
    }

    pub(crate) fn has_colour(&self) -> bool {
        match self {
            Self::Stdout => {
                anstream::AutoStream::choice(&io::stdout()) != anstream::ColorChoice::Never
            }
            Self::File { .. } | Self::Device { .. } => false,
        }
    }

    /// Writes everything, and puts a file in its place at the end.
    pub(crate) fn write(
        self,
        body: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Error> {
        let (result, target, replaces) = match self {
            Self::Stdout => (
                fill(io::stdout().lock(), body),
                "the standard output".to_owned(),
                false,
            ),
            Self::Device { file, path } => (fill(file, body), path.display().to_string(), false),
            Self::File {
                mut temporary,
                path,
            } => {
                let result = fill(temporary.file(), body)
                    .and_then(|()| temporary.file().sync_all())
                    .and_then(|()| temporary.persist(&path));
                (result, path.display().to_string(), true)
            }
        };
        result.map_err(|source| match source.kind() {
            ErrorKind::BrokenPipe => Error::ClosedPipe,
            _ if replaces => Error::WriteFile { target, source },
            _ => Error::Write { target, source },
        })
    }
}

/// Prints a result for a person, tables within a width if there is one, or for a program.
pub(crate) fn print(
    format: ShortFormat,
    width: Option<usize>,
    page: impl FnOnce() -> Sheet,
    json: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Error> {
    let colour = Output::Stdout.has_colour();
    Output::Stdout.write(|writer| match format {
        ShortFormat::Table => page().write(writer, colour, width),
        ShortFormat::Json => json(writer),
    })
}

fn fill(target: impl Write, body: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut writer = BufWriter::new(target);
    body(&mut writer)?;
    writer.flush()
}

fn open_file(path: &Path) -> io::Result<Output> {
    // A link is followed, so that the file it points to is replaced and not the link.
    let path = match fs::canonicalize(path) {
        Ok(path) => path,
        Err(error) if error.kind() == ErrorKind::NotFound => path.to_owned(),
        Err(error) => return Err(error),
    };
    let existing = fs::metadata(&path).ok();
    if let Some(existing) = &existing {
        if existing.is_dir() {
            return Err(io::Error::new(ErrorKind::IsADirectory, "it is a folder"));
        }
        if !existing.is_file() {
            let file = OpenOptions::new().write(true).open(&path)?;
            return Ok(Output::Device { file, path });
        }
        if existing.permissions().readonly() {
            return Err(io::Error::new(
                ErrorKind::PermissionDenied,
                "it is there already, and read-only",
            ));
        }
    }
    if path.file_name().is_none() {
        return Err(io::Error::new(
            ErrorKind::InvalidInput,
            "this is not the name of a file",
        ));
    }
    #[cfg(unix)]
    let permissions = {
        use std::os::unix::fs::PermissionsExt;
        // The process's mask is applied to this, as for any new file.
        Some(existing.map_or_else(
            || fs::Permissions::from_mode(0o666),
            |existing| existing.permissions(),
        ))
    };
    #[cfg(not(unix))]
    let permissions = None;
    let temporary = Temporary::new(&path, permissions).map_err(without_path)?;
    Ok(Output::File { temporary, path })
}

/// What an output is to be, by the ending of its name.
pub(crate) fn by_ending<T: Copy>(
    path: &Path,
    what: &str,
    endings: &[(&str, T)],
) -> Result<T, Error> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    let known = endings.iter().find(|(known, _)| ending == *known);
    known.map(|(_, kind)| *kind).ok_or_else(|| {
        let all: Vec<String> = endings
            .iter()
            .map(|(known, _)| format!(".{known}"))
            .collect();
        Error::Out {
            path: path.to_owned(),
            reason: format!("the ending does not say what {what} is to be"),
            hint: format!("names end in {}", all.join(" or ")),
        }
    })
}

/// The place that a path names, however it is written.
pub(crate) fn place_of(path: &Path) -> PathBuf {
    let in_folder = || {
        Ok::<_, io::Error>(
            fs::canonicalize(folder_of(path))?.join(path.file_name().unwrap_or_default()),
        )
    };
    fs::canonicalize(path)
        .or_else(|_| in_folder())
        .unwrap_or_else(|_| path.to_owned())
}

/// Refuses an output whose folder is not there: no command makes it, for it may be a mistake.
pub(crate) fn check_folder(path: &Path) -> Result<(), Error> {
    let refused = |source| Error::Unwritable {
        path: path.to_owned(),
        source,
    };
    let folder = fs::metadata(folder_of(path)).map_err(refused)?;
    if folder.is_dir() {
        Ok(())
    } else {
        Err(refused(ErrorKind::NotADirectory.into()))
    }
}

/// The message of the system alone: it leaves out the name of the temporary file.
fn without_path(error: io::Error) -> io::Error {
    error.kind().into()
}
