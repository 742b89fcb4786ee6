//! Parquet files, read row by row.

use std::fs::File;

use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::record::{Field, Row};

/// A table that has been read.
pub(crate) struct Table(Vec<Row>);

impl Table {
    pub(crate) fn read(path: &str) -> Self {
        let reader = SerializedFileReader::new(File::open(path).expect("a file")).expect("a table");
        Self(
            reader
                .get_row_iter(None)
                .expect("rows")
                .map(|row| row.expect("a row"))
                .collect(),
        )
    }

    fn column<T>(&self, name: &str, value: impl Fn(&Field) -> Option<T>) -> Vec<T> {
        let field = |row: &Row| {
            let (_, field) = row.get_column_iter().find(|(column, _)| *column == name)?;
            value(field)
        };
        self.0.iter().map(|row| field(row).expect(name)).collect()
    }

    /// Those of a column of real numbers, NaN where it is null.
    pub(crate) fn reals(&self, name: &str) -> Vec<f64> {
        self.column(name, |field| match field {
            Field::Double(value) => Some(*value),
            Field::Null => Some(f64::NAN),
            _ => None,
        })
    }

    pub(crate) fn counts(&self, name: &str) -> Vec<u32> {
        self.column(name, |field| {
            if let Field::UInt(value) = field {
                Some(*value)
            } else {
                None
            }
        })
    }
}
