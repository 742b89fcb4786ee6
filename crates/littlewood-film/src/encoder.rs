//! What takes the frames of a film.

use crate::error::FilmError;
use crate::schedule::Shown;

/// Takes frames in order. Each has the size of the film: red, green, blue and 255 for each pixel,
/// row by row.
pub trait Encoder {
    /// Takes a frame.
    ///
    /// # Errors
    /// It cannot be written.
    fn frame(&mut self, pixels: &[u8], shown: Shown) -> Result<(), FilmError>;
}

/// The rectangle in which two pictures differ: left, top, width, height. None if they are equal.
pub(crate) fn difference<P: PartialEq>(
    before: &[P],
    after: &[P],
    width: usize,
) -> Option<[usize; 4]> {
    let rows = || before.chunks_exact(width).zip(after.chunks_exact(width));
    let top = rows().position(|(a, b)| a != b)?;
    let bottom = rows().rposition(|(a, b)| a != b)?;
    let (mut left, mut right) = (width, 0);
    for (a, b) in rows().skip(top).take(bottom + 1 - top) {
        let columns = || a.iter().zip(b);
        if let Some(first) = columns().position(|(a, b)| a != b) {
            left = left.min(first);
            right = right.max(columns().rposition(|(a, b)| a != b).unwrap_or(first));
        }
    }
    Some([left, top, right + 1 - left, bottom + 1 - top])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_difference_is_the_smallest_rectangle() {
        let before = [0_u8; 20];
        assert_eq!(difference(&before, &before, 5), None);
        let mut after = before;
        after[7] = 1;
        assert_eq!(difference(&before, &after, 5), Some([2, 1, 1, 1]));
        after[16] = 1;
        assert_eq!(difference(&before, &after, 5), Some([1, 1, 2, 3]));
    }
}
