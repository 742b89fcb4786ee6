//! MP4 (H.264) and WebM (VP9), which ffmpeg writes: frames go to it through a pipe.

use std::ffi::OsStr;
use std::io::{BufRead as _, BufReader, ErrorKind, Write as _};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, Command, Stdio};
use std::thread::JoinHandle;

use crate::encoder::Encoder;
use crate::error::FilmError;
use crate::film::Film;
use crate::schedule::Shown;

/// Lines of ffmpeg's messages that are kept.
const KEPT: usize = 4;

/// Colours are coded by BT.709, and the file says so: of one that does not, players assume BT.709
/// or BT.601 by the number of lines.
const COLOURS: &str = "-vf scale=out_color_matrix=bt709:out_range=tv,format=yuv420p,\
    setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709 \
    -color_range tv -color_primaries bt709 -color_trc bt709 -colorspace bt709";

/// What ffmpeg writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Video {
    /// H.264 in MP4, which everything plays.
    Mp4,
    /// VP9 in WebM, for browsers and what has no licence for H.264.
    WebM,
}

impl Video {
    /// Codec, quality and container, as ffmpeg takes them.
    const fn arguments(self) -> &'static str {
        match self {
            Self::Mp4 => {
                "-c:v libx264 -preset medium -tune animation -crf 20 -movflags +faststart -f mp4"
            }
            Self::WebM => {
                "-c:v libvpx-vp9 -deadline good -cpu-used 2 -crf 30 -b:v 0 -row-mt 0 -f webm"
            }
        }
    }
}

/// The call of ffmpeg that reads frames from its standard input and writes them to a file.
fn command(program: &OsStr, path: &Path, film: &Film<'_>, video: Video) -> Command {
    let size = film.size().to_string();
    let fps = film.schedule().fps.to_string();
    let mut command = Command::new(program);
    command
        .args("-hide_banner -loglevel error -nostats -y".split(' '))
        .args("-f rawvideo -pixel_format rgb0 -video_size".split(' '))
        .arg(size)
        .arg("-framerate")
        .arg(fps)
        .args("-i pipe:0 -an".split(' '))
        .args(COLOURS.split(' '))
        // The same bytes from one version of ffmpeg, whatever the number of cores.
        .args("-threads 2 -fflags +bitexact -flags:v +bitexact -map_metadata -1".split(' '))
        .args(video.arguments().split(' '))
        .arg(path)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    command
}

/// The last lines that ffmpeg writes before it ends. All have to be read, for it waits while the
/// pipe is full.
fn last_lines(stderr: ChildStderr) -> Vec<String> {
    let mut kept = Vec::new();
    for line in BufReader::new(stderr).lines().map_while(Result::ok) {
        kept.push(line);
        if kept.len() > KEPT {
            kept.remove(0);
        }
    }
    kept
}

/// Writes a video by way of ffmpeg.
#[derive(Debug)]
pub struct FfmpegFilm {
    ffmpeg: Child,
    frames: Option<ChildStdin>,
    messages: Option<JoinHandle<Vec<String>>>,
}

impl FfmpegFilm {
    /// Starts ffmpeg, which writes to a file that may be there already. `program` is its name or
    /// path.
    ///
    /// # Errors
    /// A side that is odd, or ffmpeg cannot be started.
    pub fn start(
        program: &OsStr,
        path: &Path,
        film: &Film<'_>,
        video: Video,
    ) -> Result<Self, FilmError> {
        let size = film.size();
        if size.width() % 2 + size.height() % 2 != 0 {
            return Err(FilmError::OddSize { size });
        }
        let mut ffmpeg = command(program, path, film, video)
            .spawn()
            .map_err(|source| FilmError::NoFfmpeg {
                program: program.to_string_lossy().into_owned(),
                source,
            })?;
        let frames = ffmpeg.stdin.take();
        let messages = ffmpeg
            .stderr
            .take()
            .map(|stderr| std::thread::spawn(move || last_lines(stderr)));
        Ok(Self {
            ffmpeg,
            frames,
            messages,
        })
    }

    /// Waits until ffmpeg has written the file.
    ///
    /// # Errors
    /// It has failed; the message is its own.
    pub fn finish(mut self) -> Result<(), FilmError> {
        self.frames = None;
        self.wait()
    }

    fn wait(&mut self) -> Result<(), FilmError> {
        let status = self.ffmpeg.wait()?;
        let messages = self
            .messages
            .take()
            .and_then(|thread| thread.join().ok())
            .unwrap_or_default();
        if status.success() {
            return Ok(());
        }
        let message = if messages.is_empty() {
            "it gave no reason".to_owned()
        } else {
            messages.join("; ")
        };
        Err(FilmError::Ffmpeg {
            status: status.to_string(),
            message,
        })
    }
}

impl Encoder for FfmpegFilm {
    fn frame(&mut self, pixels: &[u8], shown: Shown) -> Result<(), FilmError> {
        for _ in 0..shown.copies() {
            let Some(frames) = &mut self.frames else {
                return Ok(());
            };
            match frames.write_all(pixels) {
                // It has ended before all frames were there: its own message says why.
                Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                    self.frames = None;
                    self.wait()?;
                    return Err(FilmError::Write(error));
                }
                other => other?,
            }
        }
        Ok(())
    }
}

impl Drop for FfmpegFilm {
    fn drop(&mut self) {
        // Nobody waits for the rest of a film that is given up. Of one that is finished nothing is
        // left to end.
        self.frames = None;
        let _ = self.ffmpeg.kill();
        let _ = self.ffmpeg.wait();
    }
}
