//! CSV by the names of its columns.

use std::collections::BTreeMap;

/// A table that has been read.
pub(crate) struct Csv {
    /// Names in the order of the file.
    pub(crate) columns: Vec<String>,
    /// The cells of each row by the name of their column; no column that is not there can be asked.
    pub(crate) rows: Vec<BTreeMap<String, String>>,
}

impl Csv {
    /// The table of a text.
    pub(crate) fn read(text: &str) -> Self {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names = reader.headers().expect("a header");
        Self {
            columns: names.iter().map(str::to_owned).collect(),
            rows: reader
                .deserialize()
                .map(|row| row.expect("a row"))
                .collect(),
        }
    }

    /// The cells of a column.
    pub(crate) fn column(&self, name: &str) -> Vec<&str> {
        self.rows.iter().map(|row| row[name].as_str()).collect()
    }

    /// A number of a row.
    pub(crate) fn number(&self, row: usize, name: &str) -> f64 {
        self.rows[row][name].parse().expect("a number")
    }
}
