//! Where the points of a run come from: a grid or a list, chunk by chunk.

use littlewood::ParameterError;
use littlewood::tables::{DerivativeColumn, Quantity, Setup};

use crate::chunk::Chunks;
use crate::compute::Refused;
use crate::error::SweepError;
use crate::grid::Grid;
use crate::starts::{ListError, Rows, StartList};

/// Points in chunks.
pub(crate) trait Source {
    fn total(&self) -> u64;
    fn derivatives(&self) -> &[DerivativeColumn];
    /// Starts of each hoop, where that is known before all points have been read.
    fn starts_of_a_hoop(&self) -> Option<u64>;
    fn count(&self) -> usize;
    fn points_of(&self, chunk: usize) -> u64;
    /// The points of a chunk; chunks are asked for in rising order, some left out.
    fn points(&mut self, chunk: usize) -> Result<Vec<Setup>, SweepError>;
    /// Turns the refusal of a point of a chunk into an error that says where it stands.
    fn refused(&self, chunk: usize, refused: Refused) -> SweepError;
}

pub(crate) struct GridSource<'a> {
    pub(crate) grid: &'a Grid,
    pub(crate) chunks: Chunks,
}

impl Source for GridSource<'_> {
    fn total(&self) -> u64 {
        self.grid.len()
    }

    fn derivatives(&self) -> &[DerivativeColumn] {
        self.grid.derivatives()
    }

    fn starts_of_a_hoop(&self) -> Option<u64> {
        Some(self.grid.starts_of_a_hoop())
    }

    fn count(&self) -> usize {
        self.chunks.count()
    }

    fn points_of(&self, chunk: usize) -> u64 {
        self.chunks.chunk(chunk).len() as u64
    }

    fn points(&mut self, chunk: usize) -> Result<Vec<Setup>, SweepError> {
        Ok(self.chunks.chunk(chunk).points(self.grid).collect())
    }

    fn refused(&self, _: usize, refused: Refused) -> SweepError {
        refused.error.into()
    }
}

pub(crate) struct ListSource<'a> {
    list: &'a StartList,
    chunk_points: usize,
    rows: Option<Rows>,
    /// Row that is read next, from 0.
    next: u64,
    /// The lines of the points of the last chunks, by the number of the chunk.
    lines: Vec<(usize, Vec<u64>)>,
}

impl<'a> ListSource<'a> {
    pub(crate) const fn new(list: &'a StartList, chunk_points: usize) -> Self {
        Self {
            list,
            chunk_points,
            rows: None,
            next: 0,
            lines: Vec::new(),
        }
    }

    fn first_row(&self, chunk: usize) -> u64 {
        chunk as u64 * self.chunk_points as u64
    }
}

/// Chunks whose lines are kept for messages: as many as are computed at once.
const CHUNKS_WITH_LINES: usize = 2;

impl Source for ListSource<'_> {
    fn total(&self) -> u64 {
        self.list.rows()
    }

    fn derivatives(&self) -> &[DerivativeColumn] {
        self.list.derivatives()
    }

    fn starts_of_a_hoop(&self) -> Option<u64> {
        None
    }

    fn count(&self) -> usize {
        usize::try_from(self.list.rows().div_ceil(self.chunk_points as u64)).unwrap_or(usize::MAX)
    }

    fn points_of(&self, chunk: usize) -> u64 {
        (self.list.rows() - self.first_row(chunk)).min(self.chunk_points as u64)
    }

    fn points(&mut self, chunk: usize) -> Result<Vec<Setup>, SweepError> {
        let first = self.first_row(chunk);
        let len = self.points_of(chunk);
        let mut rows = match self.rows.take() {
            Some(rows) => rows,
            None => self.list.read()?,
        };
        let mut points = Vec::new();
        let mut lines = Vec::new();
        while self.next < first + len {
            let (line, point) = rows.next_row()?.ok_or_else(|| self.list.changed())?;
            if self.next >= first {
                points.push(point);
                lines.push(line);
            }
            self.next += 1;
        }
        self.rows = Some(rows);
        if self.lines.len() >= CHUNKS_WITH_LINES {
            self.lines.remove(0);
        }
        self.lines.push((chunk, lines));
        Ok(points)
    }

    fn refused(&self, chunk: usize, refused: Refused) -> SweepError {
        let line = self
            .lines
            .iter()
            .find(|(number, _)| *number == chunk)
            .and_then(|(_, lines)| lines.get(refused.index).copied());
        let column = match refused.error {
            // A time limit before the start: the list may have the time of the start, never the
            // limit.
            ParameterError::OutOfBounds {
                quantity: Quantity::Until,
                ..
            } => Quantity::Time,
            error => error.quantity(),
        };
        match line {
            Some(line) if self.list.columns().contains(&column) => {
                let path = self.list.path().to_owned();
                ListError::BadValue {
                    path,
                    line,
                    column,
                    source: refused.error,
                }
                .into()
            }
            Some(_) | None => refused.error.into(),
        }
    }
}
