//! GIF: few colours, hundredths of a second, and only what has changed since the frame before.

use std::borrow::Cow;
use std::io::Write;

use gif::{DisposalMethod, Encoder as GifEncoder, EncodingError, Frame, Repeat};
use littlewood_style::Rgb;

use crate::encoder::{Encoder, difference};
use crate::error::FilmError;
use crate::film::Film;
use crate::quantise::{Quantiser, TRANSPARENT};
use crate::schedule::Shown;
use crate::size::SizeError;

/// Most frames per second: programs slow down what is shown for less than two hundredths of a
/// second.
const MOST_FPS: u32 = 50;

/// Writes an endless GIF.
pub struct GifFilm<W: Write> {
    encoder: GifEncoder<W>,
    quantiser: Quantiser,
    width: usize,
    /// The frame before as it was drawn, and in the colours of the file.
    drawn: Vec<u8>,
    before: Vec<u8>,
    now: Vec<u8>,
}

impl<W: Write> GifFilm<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// More frames per second than a GIF can have, or a failure to write.
    pub fn new(writer: W, film: &Film<'_>) -> Result<Self, FilmError> {
        let (fps, size) = (film.schedule().fps, film.size());
        if fps > MOST_FPS {
            return Err(FilmError::FrameRate {
                fps,
                most: MOST_FPS,
                format: "GIF",
            });
        }
        let quantiser = Quantiser::new(film.has_energies(), film.has_lanes());
        let side =
            |pixels: u32| u16::try_from(pixels).map_err(|_| FilmError::from(SizeError { size }));
        let (width, height) = (side(size.width())?, side(size.height())?);
        let mut encoder =
            GifEncoder::new(writer, width, height, &quantiser.table()).map_err(error)?;
        encoder.set_repeat(Repeat::Infinite).map_err(error)?;
        Ok(Self {
            encoder,
            quantiser,
            width: usize::from(width),
            drawn: Vec::new(),
            before: Vec::new(),
            now: Vec::with_capacity(size.area()),
        })
    }

    /// Ends the file.
    ///
    /// # Errors
    /// A failure to write.
    pub fn finish(self) -> Result<W, FilmError> {
        let mut writer = self.encoder.into_inner().map_err(error)?;
        writer.flush()?;
        Ok(writer)
    }
}

impl<W: Write> Encoder for GifFilm<W> {
    fn frame(&mut self, pixels: &[u8], shown: Shown) -> Result<(), FilmError> {
        let is_first = self.before.is_empty();
        self.now.clone_from(&self.before);
        self.now.resize(pixels.len() / 4, TRANSPARENT);
        self.drawn.resize(pixels.len(), 0);
        let changes = pixels
            .as_chunks::<4>()
            .0
            .iter()
            .zip(self.drawn.as_chunks_mut::<4>().0);
        for ((pixel, before), index) in changes.zip(&mut self.now) {
            // Most pixels are as they were, and looking up a colour takes longer than seeing that.
            if pixel != before {
                *index = self.quantiser.index(Rgb([pixel[0], pixel[1], pixel[2]]));
                *before = *pixel;
            }
        }
        let [left, top, width, height] = if is_first {
            [0, 0, self.width, self.now.len() / self.width]
        } else {
            difference(&self.before, &self.now, self.width).unwrap_or([0, 0, 1, 1])
        };
        let mut buffer = Vec::with_capacity(width * height);
        for row in top..top + height {
            let from = row * self.width + left;
            for at in from..from + width {
                let is_same = !is_first && self.before[at] == self.now[at];
                buffer.push(if is_same { TRANSPARENT } else { self.now[at] });
            }
        }
        let short = |length: usize| length.min(usize::from(u16::MAX)) as u16;
        self.encoder
            .write_frame(&Frame {
                delay: u16::try_from(shown.centiseconds()).unwrap_or(u16::MAX),
                dispose: DisposalMethod::Keep,
                transparent: (!is_first).then_some(TRANSPARENT),
                left: short(left),
                top: short(top),
                width: short(width),
                height: short(height),
                buffer: Cow::Owned(buffer),
                ..Frame::default()
            })
            .map_err(error)?;
        std::mem::swap(&mut self.before, &mut self.now);
        Ok(())
    }
}

impl<W: Write> std::fmt::Debug for GifFilm<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GifFilm")
            .field("width", &self.width)
            .finish_non_exhaustive()
    }
}

fn error(error: EncodingError) -> FilmError {
    match error {
        EncodingError::Io(error) => FilmError::Write(error),
        other => FilmError::Encoding {
            format: "GIF",
            message: other.to_string(),
        },
    }
}
