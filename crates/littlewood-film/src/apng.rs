//! APNG: exact durations, few colours, and only what has changed since the frame before.
//!
//! The file is written here, chunk by chunk, and not by the crate `png`: that deflates either badly or with a library whose
//! bytes depend on the processor.

use std::io::Write;

use miniz_oxide::deflate::compress_to_vec_zlib;

use crate::encoder::{Encoder, difference};
use crate::error::FilmError;
use crate::film::Film;
use crate::quantise::{Quantiser, TRANSPARENT};
use crate::schedule::Shown;
use littlewood_style::Rgb;

/// How hard the deflation tries, from 0 to 10.
const LEVEL: u8 = 8;

/// Writes an endless APNG.
pub struct ApngFilm<W: Write> {
    writer: W,
    size: [usize; 2],
    quantiser: Quantiser,
    before: Vec<u8>,
    now: Vec<u8>,
    /// Number of the next chunk of the animation.
    next: u32,
}

impl<W: Write> ApngFilm<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// A failure to write.
    pub fn new(writer: W, film: &Film<'_>) -> Result<Self, FilmError> {
        let (size, frames) = (film.size(), film.schedule().frames());
        let count = u32::try_from(frames)
            .map_err(|_| FilmError::TooLong { frames: frames as f64, most: u64::from(u32::MAX) })?;
        let mut film = Self {
            writer,
            size: [size.width() as usize, size.height() as usize],
            quantiser: Quantiser::new(film.has_energies()),
            before: Vec::new(),
            now: Vec::with_capacity(size.area()),
            next: 0,
        };
        film.writer.write_all(b"\x89PNG\r\n\x1a\n")?;
        // Eight bits, a palette, no interlacing.
        let header =
            [&size.width().to_be_bytes()[..], &size.height().to_be_bytes(), &[8, 3, 0, 0, 0]].concat();
        film.chunk(*b"IHDR", &header)?;
        // No number of repetitions: for ever.
        film.chunk(*b"acTL", &[count.to_be_bytes(), [0; 4]].concat())?;
        let palette = film.quantiser.table();
        film.chunk(*b"PLTE", &palette)?;
        // The first colour, and no other, is transparent.
        film.chunk(*b"tRNS", &[0])?;
        Ok(film)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// A failure to write.
    pub fn finish(mut self) -> Result<(), FilmError> {
        self.chunk(*b"IEND", &[])?;
        Ok(self.writer.flush()?)
    }

    fn chunk(&mut self, kind: [u8; 4], data: &[u8]) -> Result<(), FilmError> {
        let length = u32::try_from(data.len()).map_err(|_| FilmError::Encoding {
            format: "APNG",
            message: "a frame has more than 4 GiB".to_owned(),
        })?;
        let mut checked = crc32fast::Hasher::new();
        checked.update(&kind);
        checked.update(data);
        for part in [&length.to_be_bytes()[..], &kind, data, &checked.finalize().to_be_bytes()] {
            self.writer.write_all(part)?;
        }
        Ok(())
    }

    const fn number(&mut self) -> [u8; 4] {
        let number = self.next;
        self.next += 1;
        number.to_be_bytes()
    }
}

impl<W: Write> Encoder for ApngFilm<W> {
    fn frame(&mut self, pixels: &[u8], shown: Shown) -> Result<(), FilmError> {
        self.now.clear();
        for [red, green, blue, _] in pixels.as_chunks::<4>().0 {
            self.now.push(self.quantiser.index(Rgb([*red, *green, *blue])));
        }
        let is_first = self.before.is_empty();
        let [wide, tall] = self.size;
        let [left, top, width, height] = if is_first {
            [0, 0, wide, tall]
        } else {
            difference(&self.before, &self.now, wide).unwrap_or([0, 0, 1, 1])
        };
        let mut data = Vec::with_capacity((width + 1) * height);
        for row in top..top + height {
            // No filter: what is drawn is flat.
            data.push(0);
            let range = row * wide + left..row * wide + left + width;
            if is_first {
                data.extend_from_slice(&self.now[range]);
            } else {
                let pairs = self.before[range.clone()].iter().zip(&self.now[range]);
                data.extend(pairs.map(|(before, now)| if before == now { TRANSPARENT } else { *now }));
            }
        }
        let (numerator, denominator) = shown.fraction();
        let side = |length: usize| (length as u32).to_be_bytes();
        let mut control = self.number().to_vec();
        for length in [width, height, left, top] {
            control.extend(side(length));
        }
        control.extend(numerator.to_be_bytes());
        control.extend(denominator.to_be_bytes());
        // The frame stays, and the next is laid over it.
        control.extend([0, u8::from(!is_first)]);
        self.chunk(*b"fcTL", &control)?;
        let deflated = compress_to_vec_zlib(&data, LEVEL);
        if is_first {
            self.chunk(*b"IDAT", &deflated)?;
        } else {
            let mut numbered = self.number().to_vec();
            numbered.extend(deflated);
            self.chunk(*b"fdAT", &numbered)?;
        }
        std::mem::swap(&mut self.before, &mut self.now);
        Ok(())
    }
}

impl<W: Write> std::fmt::Debug for ApngFilm<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ApngFilm").field("size", &self.size).finish_non_exhaustive()
    }
}
