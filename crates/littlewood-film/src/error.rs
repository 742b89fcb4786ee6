//! Why a film cannot be made.

use std::io;

use littlewood::OutcomeKind;
use littlewood_draw::DrawError;
use thiserror::Error;

use crate::size::{FrameSize, SIDES, SizeError};

/// A film that cannot be made, or not be written.
#[derive(Debug, Error)]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum FilmError {
    /// A side that is too short to read, or too long.
    #[error(transparent)]
    Size(#[from] SizeError),
    /// A pane that has no room.
    #[error(transparent)]
    Pane(#[from] DrawError),
    /// H.264 halves the resolution of colour.
    #[error("size = {size} px: both sides of an MP4 must be even")]
    OddSize { size: FrameSize },
    /// Two lanes in a picture that is too low.
    #[error("size = {size} px: two hoops need a height of {} to {} px", 2 * SIDES.start(), SIDES.end())]
    NoRoomForTwo { size: FrameSize },
    /// Two clocks that do not count the same.
    #[error("one of the motions is in SI units, and the other is not")]
    TwoClocks,
    /// A rate of frames outside the bounds.
    #[error("fps = {fps} must be between 1 and {most} frames per second in {format}")]
    FrameRate {
        fps: u32,
        most: u32,
        format: &'static str,
    },
    /// A slowness that is no duration.
    #[error("slow = {slow} must be a finite number greater than 0")]
    Slow { slow: f64 },
    /// A last picture that is shown for no possible time.
    #[error("hold = {hold_s} s must be between 0 and {most_s} s")]
    Hold { hold_s: f64, most_s: f64 },
    /// No motion begins at the start.
    #[error("there is no motion to show: {}", outcome.label())]
    NoMotion { outcome: OutcomeKind },
    /// More frames than anyone will look at.
    #[error("the film would have {frames:.0} frames, the most is {most}")]
    TooLong { frames: f64, most: u64 },
    /// The caller has asked to stop.
    #[error("stopped after {done} of {total} frames")]
    Stopped { done: u64, total: u64 },
    /// The film cannot be written.
    #[error("writing failed: {0}")]
    Write(#[from] io::Error),
    /// An encoder has refused a frame.
    #[error("encoding the {format} failed: {message}")]
    Encoding {
        format: &'static str,
        message: String,
    },
    /// ffmpeg cannot be started.
    #[error("a video needs ffmpeg, and '{program}' cannot be started: {source}")]
    NoFfmpeg { program: String, source: io::Error },
    /// ffmpeg has failed.
    #[error("ffmpeg failed ({status}): {message}")]
    Ffmpeg { status: String, message: String },
}

impl FilmError {
    /// What to do about it.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::Size { .. } | Self::Pane(_) => {
                "a size is WIDTHxHEIGHT in pixels, such as 640x360 or 1920x1080"
            }
            Self::NoRoomForTwo { .. } => {
                "each has half of the height; 640x600 or 1280x720 is usual"
            }
            Self::TwoClocks => "give both in SI units, or none",
            Self::OddSize { .. } => "add a pixel, or write a GIF",
            Self::FrameRate { format: "GIF", .. } => {
                "a GIF counts hundredths of a second, and programs slow down what is shown for less than two; take \
                 fewer frames, or write an MP4"
            }
            Self::FrameRate { .. } => "25 or 30 is usual, 60 is smooth",
            Self::Slow { .. } => {
                "it is the number of seconds of film for a unit of time sqrt(R/g), or in SI units for a second"
            }
            Self::Hold { .. } => "it is the time for which the last picture stays",
            Self::NoMotion { .. } => "`littlewood classify` tells what was examined",
            Self::TooLong { .. } => {
                "take fewer frames per second, a smaller factor for --slow, or an earlier --until"
            }
            Self::Stopped { .. } => "no film has been written",
            Self::Write(_) | Self::Encoding { .. } => {
                "make room, or choose a folder that can be written to"
            }
            Self::NoFfmpeg { .. } => {
                "install ffmpeg (apt install ffmpeg, brew install ffmpeg, winget install ffmpeg), or write a .gif, \
                 which needs no other program"
            }
            Self::Ffmpeg { .. } => {
                "it must be able to write H.264 (libx264), or VP9 (libvpx-vp9); or write a .gif"
            }
        }
    }
}
