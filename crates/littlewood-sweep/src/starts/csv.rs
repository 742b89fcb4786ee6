//! The rows of a CSV file.

use std::fs::File;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::Path;

use littlewood::tables::{Quantity, Setup};

use super::error::{ListError, unreadable};
use super::header::columns_of;

/// Longest line of a CSV file, in bytes. Ten numbers need less than three hundred.
const LONGEST_LINE: u64 = 65_536;

/// The lines of a CSV file. Numbers and their names hold neither commas nor ends of lines, so cells need no quotes; they
/// may have them.
pub(super) struct CsvRows {
    reader: BufReader<File>,
    text: Vec<u8>,
    /// Number of the line that was read last, from 1.
    number: u64,
}

impl CsvRows {
    /// Reads the header.
    pub(super) fn open(path: &Path, file: File) -> Result<(Vec<Quantity>, Self), ListError> {
        let mut lines = Self { reader: BufReader::new(file), text: Vec::new(), number: 0 };
        let columns = match lines.next_line(path)? {
            Some(header) => columns_of(path, cells_of(header))?,
            None => Vec::new(),
        };
        Ok((columns, lines))
    }

    /// The next row with its line, its values set in a base setup.
    pub(super) fn next_row(
        &mut self,
        path: &Path,
        base: Setup,
        columns: &[Quantity],
    ) -> Result<Option<(u64, Setup)>, ListError> {
        let Some(text) = self.next_line(path)? else { return Ok(None) };
        let mut point = base;
        let mut found = 0;
        let mut bad = None;
        for cell in cells_of(text) {
            if let Some(&column) = columns.get(found) {
                match cell.parse().ok().filter(|value: &f64| value.is_finite()) {
                    Some(value) => point.set(column, value),
                    None => bad = bad.or_else(|| Some((column, cell.to_owned()))),
                }
            }
            found += 1;
        }
        let (path, line) = (path.to_owned(), self.number);
        if found != columns.len() {
            let reason = format!("{found} cells where the header has {}", columns.len());
            return Err(ListError::BadLine { path, line, reason });
        }
        match bad {
            Some((column, cell)) => Err(ListError::BadCell { path, line, column, cell }),
            None => Ok(Some((line, point))),
        }
    }

    /// The next line that is not blank.
    fn next_line(&mut self, path: &Path) -> Result<Option<&str>, ListError> {
        loop {
            self.text.clear();
            let limit = LONGEST_LINE + 1;
            let length =
                (&mut self.reader).take(limit).read_until(b'\n', &mut self.text).map_err(unreadable(path))?;
            if length == 0 {
                return Ok(None);
            }
            self.number += 1;
            let bad = |reason: &str| ListError::BadLine {
                path: path.to_owned(),
                line: self.number,
                reason: reason.to_owned(),
            };
            if length as u64 == limit {
                return Err(bad("longer than a line of numbers can be"));
            }
            if self.text.iter().all(u8::is_ascii_whitespace) {
                continue;
            }
            if core::str::from_utf8(&self.text).is_err() {
                return Err(bad("not UTF-8 text"));
            }
            break;
        }
        Ok(core::str::from_utf8(&self.text).ok())
    }
}

fn cells_of(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|cell| {
        let cell = cell.trim();
        cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).unwrap_or(cell).trim()
    })
}
