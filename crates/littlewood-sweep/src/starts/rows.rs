//! The rows of a CSV file.

use std::fs::File;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};

use littlewood::tables::{Quantity, Setup};

use super::error::{ListError, unreadable};
use crate::file::open_file;
use crate::setup::quantities;

/// Longest line of a CSV file, in bytes. Ten numbers need less than three hundred.
const LONGEST_LINE: u64 = 65_536;

/// The lines of a CSV file. Numbers and their names hold neither commas nor ends of lines, so cells
/// need no quotes; they may have them.
pub(crate) struct Rows {
    path: PathBuf,
    base: Setup,
    /// The quantities that the file has, in its order.
    pub(crate) columns: Vec<Quantity>,
    reader: BufReader<File>,
    text: Vec<u8>,
    /// Number of the line that was read last, from 1.
    number: u64,
}

impl Rows {
    pub(super) fn open(path: &Path, base: Setup) -> Result<Self, ListError> {
        if !path
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
        {
            return Err(ListError::UnknownFormat {
                path: path.to_owned(),
            });
        }
        let reader = BufReader::new(open_file(path).map_err(unreadable(path))?);
        let columns = Vec::new();
        let mut rows = Self {
            path: path.to_owned(),
            base,
            columns,
            reader,
            text: Vec::new(),
            number: 0,
        };
        if let Some(header) = rows.next_line()? {
            rows.columns = columns_of(path, header)?;
        }
        Ok(rows)
    }

    /// The next row with its line, its values set in the base setup.
    pub(crate) fn next_row(&mut self) -> Result<Option<(u64, Setup)>, ListError> {
        let mut point = self.base;
        let Some(text) = self.next_line()?.map(str::to_owned) else {
            return Ok(None);
        };
        let (path, line) = (|| self.path.clone(), self.number);
        let found = cells_of(&text).count();
        if found != self.columns.len() {
            let reason = format!("{found} cells where the header has {}", self.columns.len());
            return Err(ListError::BadLine {
                path: path(),
                line,
                reason,
            });
        }
        for (&column, cell) in self.columns.iter().zip(cells_of(&text)) {
            match cell.parse().ok().filter(|value: &f64| value.is_finite()) {
                Some(value) => point.set(column, value),
                None => {
                    return Err(ListError::BadCell {
                        path: path(),
                        line,
                        column,
                        cell: cell.to_owned(),
                    });
                }
            }
        }
        Ok(Some((line, point)))
    }

    /// The next line that is not blank.
    fn next_line(&mut self) -> Result<Option<&str>, ListError> {
        loop {
            self.text.clear();
            let limit = LONGEST_LINE + 1;
            let length = (&mut self.reader)
                .take(limit)
                .read_until(b'\n', &mut self.text);
            let length = length.map_err(unreadable(&self.path))?;
            if length == 0 {
                return Ok(None);
            }
            self.number += 1;
            let bad = |reason: &str| ListError::BadLine {
                path: self.path.clone(),
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

/// The quantities that the names in a header stand for.
fn columns_of(path: &Path, header: &str) -> Result<Vec<Quantity>, ListError> {
    let mut columns = Vec::new();
    for name in cells_of(header) {
        let name = name.trim_start_matches('\u{feff}').trim_matches('"');
        let column = quantities()
            .find(|column| column.name() == name)
            .ok_or_else(|| ListError::UnknownColumn {
                path: path.to_owned(),
                column: name.to_owned(),
            })?;
        if columns.contains(&column) {
            return Err(ListError::DuplicateColumn {
                path: path.to_owned(),
                column,
            });
        }
        columns.push(column);
    }
    Ok(columns)
}

fn cells_of(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|cell| {
        let cell = cell.trim();
        cell.strip_prefix('"')
            .and_then(|cell| cell.strip_suffix('"'))
            .unwrap_or(cell)
            .trim()
    })
}
