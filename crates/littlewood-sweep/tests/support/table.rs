//! Parquet files, written and read row by row.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::data_type::DoubleType;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::SerializedFileWriter;
use parquet::record::{Field, Row};
use parquet::schema::parser::parse_message_type;

/// Writes a table of one number, with an entry in the footer.
pub(crate) fn write_table(path: &Path, key: &str, value: String) {
    let schema = parse_message_type("message table { required double theta; }").unwrap();
    let entry = Some(vec![KeyValue::new(key.to_owned(), value)]);
    let properties = WriterProperties::builder()
        .set_key_value_metadata(entry)
        .build();
    let file = File::create(path).unwrap();
    let mut writer =
        SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties)).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    column
        .typed::<DoubleType>()
        .write_batch(&[0.5], None, None)
        .unwrap();
    column.close().unwrap();
    group.close().unwrap();
    writer.close().unwrap();
}

/// A table that has been read.
pub(crate) struct Table {
    rows: Vec<Row>,
    /// Number of row groups.
    pub(crate) groups: usize,
    /// What the footer says, by its keys.
    pub(crate) entries: Vec<KeyValue>,
}

impl Table {
    pub(crate) fn read(path: &Path) -> Self {
        let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
        let entries = reader
            .metadata()
            .file_metadata()
            .key_value_metadata()
            .cloned()
            .unwrap_or_default();
        let groups = reader.num_row_groups();
        Self {
            rows: reader
                .get_row_iter(None)
                .unwrap()
                .map(Result::unwrap)
                .collect(),
            groups,
            entries,
        }
    }

    /// An entry of the footer.
    pub(crate) fn entry(&self, key: &str) -> &str {
        let entry = self.entries.iter().find(|entry| entry.key == key).unwrap();
        entry.value.as_deref().unwrap()
    }

    /// The values of a column.
    pub(crate) fn column(&self, name: &str) -> Vec<&Field> {
        let find = |row: &Row| {
            row.get_column_iter()
                .position(|(column, _)| column == name)
                .unwrap()
        };
        let Some(place) = self.rows.first().map(find) else {
            return Vec::new();
        };
        self.rows
            .iter()
            .map(|row| row.get_column_iter().nth(place).unwrap().1)
            .collect()
    }

    /// Those of a column of real numbers, NaN where it is null.
    pub(crate) fn reals(&self, name: &str) -> Vec<f64> {
        let real = |field: &Field| match field {
            Field::Double(value) => {
                assert!(!value.is_nan(), "{name} has NaN where null is meant");
                *value
            }
            Field::Null => f64::NAN,
            other => panic!("{name} has {other}"),
        };
        self.column(name).into_iter().map(real).collect()
    }

    pub(crate) fn words(&self, name: &str) -> Vec<String> {
        let word = |field: &Field| match field {
            Field::Str(text) => text.clone(),
            other => panic!("{name} has {other}"),
        };
        self.column(name).into_iter().map(word).collect()
    }
}
