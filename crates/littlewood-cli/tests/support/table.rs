//! Parquet files of numbers, written and read.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::data_type::DoubleType;
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::SerializedFileWriter;
use parquet::record::{Field, Row};
use parquet::schema::parser::parse_message_type;

/// Writes columns of numbers.
pub(crate) fn write_table<'a>(path: &Path, columns: impl Iterator<Item = (&'a str, &'a [f64])>) {
    let columns: Vec<(&str, &[f64])> = columns.collect();
    let lines: String = columns.iter().map(|(name, _)| format!("required double {name};")).collect();
    let schema = parse_message_type(&format!("message table {{ {lines} }}")).expect("a schema");
    let file = File::create(path).expect("a file");
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::default()).expect("a writer");
    let mut group = writer.next_row_group().expect("a row group");
    for (_, values) in columns {
        let mut column = group.next_column().expect("a column").expect("as many as there are");
        column.typed::<DoubleType>().write_batch(values, None, None).expect("written");
        column.close().expect("closed");
    }
    group.close().expect("closed");
    writer.close().expect("closed");
}

/// A table that has been read.
pub(crate) struct Table(Vec<Row>);

impl Table {
    pub(crate) fn read(path: &str) -> Self {
        let reader = SerializedFileReader::new(File::open(path).expect("a file")).expect("a table");
        Self(reader.get_row_iter(None).expect("rows").map(|row| row.expect("a row")).collect())
    }

    fn column<T>(&self, name: &str, value: impl Fn(&Field) -> Option<T>) -> Vec<T> {
        let field = |row: &Row| {
            let (_, field) = row.get_column_iter().find(|(column, _)| *column == name)?;
            value(field)
        };
        self.0.iter().map(|row| field(row).expect(name)).collect()
    }

    pub(crate) fn reals(&self, name: &str) -> Vec<f64> {
        self.column(name, |field| if let Field::Double(value) = field { Some(*value) } else { None })
    }

    pub(crate) fn counts(&self, name: &str) -> Vec<u32> {
        self.column(name, |field| if let Field::UInt(value) = field { Some(*value) } else { None })
    }
}
