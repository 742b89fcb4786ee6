//! The schema of a table as Arrow's own description of it, which readers find in the footer under
//! `ARROW:schema`.
//!
//! Parquet has no place for the attributes of a column. Arrow's readers (pyarrow, and what stands
//! on it) keep the schema of a table beside that of the file: a message of Arrow's IPC format, a
//! flatbuffer, in base 64. With it `schema.field(name)` has the attributes, and the columns of
//! words are dictionaries.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::column::{Column, Kind};
use super::flatbuffer::{Buffer, Slot};

/// The key of the description in the footer.
pub(super) const SCHEMA_KEY: &str = "ARROW:schema";

/// Metadata version 5 of the IPC format.
const VERSION: i16 = 4;
/// A message that holds a schema.
const SCHEMA: u8 = 1;
/// What stands before a message.
const CONTINUATION: [u8; 4] = [0xff; 4];

pub(super) fn schema(columns: &[Column]) -> String {
    let mut buffer = Buffer::default();
    let message = buffer.root(&[Slot::I16(VERSION), Slot::U8(SCHEMA), Slot::Child]);
    // The byte order is little-endian, as is not said.
    let schema = buffer.child(message[2], &[Slot::Absent, Slot::Child]);
    let fields = buffer.vector(schema[1], columns.len());
    let mut dictionaries = 0;
    for (place, column) in fields.into_iter().zip(columns) {
        field(&mut buffer, place, column, &mut dictionaries);
    }
    let mut bytes = CONTINUATION.to_vec();
    let message = buffer.into_bytes();
    bytes.extend(
        u32::try_from(message.len())
            .unwrap_or(u32::MAX)
            .to_le_bytes(),
    );
    bytes.extend(message);
    STANDARD.encode(bytes)
}

/// A column that is never null; `place` is where it is referred to.
fn field(buffer: &mut Buffer, place: usize, column: &Column, dictionaries: &mut i64) {
    let (number, slots): (u8, &[Slot]) = match column.kind {
        Kind::U8 => (INT, &[Slot::I32(8)]),
        Kind::U32 => (INT, &[Slot::I32(32)]),
        Kind::U64 => (INT, &[Slot::I32(64)]),
        Kind::F64 => (FLOATING_POINT, &[Slot::I16(DOUBLE)]),
        Kind::Words => (UTF8, &[]),
        Kind::Flag => (BOOL, &[]),
    };
    let dictionary = if column.kind == Kind::Words {
        Slot::Child
    } else {
        Slot::Absent
    };
    let places = buffer.child(
        place,
        &[
            Slot::Child,
            Slot::Absent,
            Slot::U8(number),
            Slot::Child,
            dictionary,
            Slot::Child,
            Slot::Child,
        ],
    );
    buffer.text(places[0], &column.name);
    buffer.child(places[3], slots);
    if column.kind == Kind::Words {
        let dictionary = buffer.child(places[4], &[Slot::I64(*dictionaries), Slot::Child]);
        buffer.child(dictionary[1], &[Slot::I32(32), Slot::U8(1)]);
        *dictionaries += 1;
    }
    buffer.vector(places[5], 0);
    let attributes = buffer.vector(places[6], column.attributes.len());
    for (place, (key, value)) in attributes.into_iter().zip(&column.attributes) {
        let entry = buffer.child(place, &[Slot::Child, Slot::Child]);
        buffer.text(entry[0], key);
        buffer.text(entry[1], value);
    }
}

/// The types of columns, of which `INT` has a width and a sign (none, if it is not said), and
/// `FLOATING_POINT` a precision.
const INT: u8 = 2;
const FLOATING_POINT: u8 = 3;
const UTF8: u8 = 5;
const BOOL: u8 = 6;
const DOUBLE: i16 = 2;
