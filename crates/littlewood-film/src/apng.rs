//! APNG: all colours, exact durations, and only what has changed since the frame before.

use std::io::{self, Write};

use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, EncodingError, Filter, Writer};

use crate::encoder::{Encoder, difference};
use crate::error::FilmError;
use crate::film::Film;
use crate::schedule::Shown;

/// Writes an endless APNG.
pub struct ApngFilm<W: Write> {
    writer: Writer<W>,
    width: usize,
    before: Vec<[u8; 4]>,
    now: Vec<[u8; 4]>,
}

impl<W: Write> ApngFilm<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// A failure to write.
    pub fn new(writer: W, film: &Film<'_>) -> Result<Self, FilmError> {
        let size = film.size();
        let frames = film.schedule().frames();
        let count = u32::try_from(frames)
            .map_err(|_| FilmError::TooLong { frames: frames as f64, most: u64::from(u32::MAX) })?;
        let mut encoder = png::Encoder::new(writer, size.width(), size.height());
        encoder.set_color(ColorType::Rgba);
        encoder.set_depth(BitDepth::Eight);
        // This method has one implementation for all processors, others may not.
        encoder.set_compression(Compression::Fast);
        encoder.set_filter(Filter::Up);
        encoder.set_animated(count, 0).map_err(error)?;
        let writer = encoder.write_header().map_err(error)?;
        Ok(Self {
            writer,
            width: size.width() as usize,
            before: Vec::new(),
            now: Vec::with_capacity(size.area()),
        })
    }

    /// Ends the file.
    ///
    /// # Errors
    /// A failure to write.
    pub fn finish(self) -> Result<(), FilmError> {
        self.writer.finish().map_err(error)
    }
}

impl<W: Write> Encoder for ApngFilm<W> {
    fn frame(&mut self, pixels: &[u8], shown: Shown) -> Result<(), FilmError> {
        self.now.clear();
        self.now.extend(pixels.as_chunks::<4>().0);
        let is_first = self.before.is_empty();
        let [left, top, width, height] = if is_first {
            [0, 0, self.width, self.now.len() / self.width]
        } else {
            difference(&self.before, &self.now, self.width).unwrap_or([0, 0, 1, 1])
        };
        let mut data = Vec::with_capacity(4 * width * height);
        for row in top..top + height {
            let from = row * self.width + left;
            for at in from..from + width {
                // What has not changed is transparent.
                let is_same = !is_first && self.before[at] == self.now[at];
                data.extend(if is_same { [0; 4] } else { self.now[at] });
            }
        }
        let short = |length: usize| length.min(u32::MAX as usize) as u32;
        let (numerator, denominator) = shown.fraction();
        let writer = &mut self.writer;
        let place = |writer: &mut Writer<W>| {
            if !is_first {
                writer.reset_frame_position()?;
                writer.set_frame_dimension(short(width), short(height))?;
                writer.set_frame_position(short(left), short(top))?;
            }
            writer.set_blend_op(if is_first { BlendOp::Source } else { BlendOp::Over })?;
            writer.set_dispose_op(DisposeOp::None)?;
            writer.set_frame_delay(numerator, denominator)?;
            writer.write_image_data(&data)
        };
        place(writer).map_err(error)?;
        std::mem::swap(&mut self.before, &mut self.now);
        Ok(())
    }
}

impl<W: Write> std::fmt::Debug for ApngFilm<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ApngFilm").field("width", &self.width).finish_non_exhaustive()
    }
}

fn error(error: EncodingError) -> FilmError {
    match error {
        EncodingError::IoError(error) => FilmError::Write(error),
        EncodingError::LimitsExceeded => FilmError::Write(io::ErrorKind::OutOfMemory.into()),
        other => FilmError::Encoding { format: "APNG", message: other.to_string() },
    }
}
