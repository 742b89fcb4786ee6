//! Writing a flatbuffer: tables whose fields have a number, vectors and texts, each referred to by
//! its distance.

/// A flatbuffer that grows. What is referred to stands behind what refers to it.
#[derive(Default)]
pub(super) struct Buffer {
    bytes: Vec<u8>,
}

/// A field of a table, in the order of its schema.
#[derive(Clone, Copy)]
pub(super) enum Slot {
    /// Left out: it has its default value.
    Absent,
    U8(u8),
    I16(i16),
    I32(i32),
    I64(i64),
    /// A reference to what is written later.
    Child,
}

impl Slot {
    /// Its bytes, whose number is its alignment too.
    fn bytes(self) -> Vec<u8> {
        match self {
            Self::Absent => Vec::new(),
            Self::U8(value) => vec![value],
            Self::I16(value) => value.to_le_bytes().to_vec(),
            Self::I32(value) => value.to_le_bytes().to_vec(),
            Self::I64(value) => value.to_le_bytes().to_vec(),
            Self::Child => vec![0; REFERENCE],
        }
    }
}

/// Bytes of a reference, and of a length.
const REFERENCE: usize = 4;
/// The widest alignment of a field.
const WIDEST: usize = 8;

impl Buffer {
    /// The table that all begins with; the places of its fields.
    pub(super) fn root(&mut self, slots: &[Slot]) -> Vec<usize> {
        self.bytes.extend([0; REFERENCE]);
        self.child(0, slots)
    }

    /// A table that is referred to at a place; the places of its fields.
    pub(super) fn child(&mut self, place: usize, slots: &[Slot]) -> Vec<usize> {
        // Before the table stands its list of fields: the size of the list, that of the table, and
        // where each field is.
        let list = self.align(WIDEST);
        let size = 2 * (slots.len() + 2);
        self.bytes.resize(list + size, 0);
        let table = self.align(WIDEST);
        self.refer(place, table);
        self.bytes.extend(number(table - list).to_le_bytes());
        let mut places = Vec::with_capacity(slots.len());
        for (i, slot) in slots.iter().enumerate() {
            let bytes = slot.bytes();
            let field = self.align(bytes.len().max(1));
            places.push(field);
            if !bytes.is_empty() {
                self.bytes.extend(bytes);
                self.short(list + 2 * (i + 2), field - table);
            }
        }
        self.short(list, size);
        self.short(list + 2, self.bytes.len() - table);
        places
    }

    /// A vector of references that is referred to at a place; the places of its items.
    pub(super) fn vector(&mut self, place: usize, len: usize) -> Vec<usize> {
        let start = self.align(REFERENCE);
        self.refer(place, start);
        self.bytes.extend(number(len).to_le_bytes());
        let first = self.bytes.len();
        self.bytes.resize(first + len * REFERENCE, 0);
        (0..len).map(|i| first + i * REFERENCE).collect()
    }

    /// A text that is referred to at a place.
    pub(super) fn text(&mut self, place: usize, text: &str) {
        let start = self.align(REFERENCE);
        self.refer(place, start);
        self.bytes.extend(number(text.len()).to_le_bytes());
        self.bytes.extend(text.as_bytes());
        self.bytes.push(0);
    }

    /// The whole, padded as a message is.
    pub(super) fn into_bytes(mut self) -> Vec<u8> {
        self.align(WIDEST);
        self.bytes
    }

    fn align(&mut self, to: usize) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(to), 0);
        self.bytes.len()
    }

    fn refer(&mut self, place: usize, target: usize) {
        self.bytes[place..place + REFERENCE].copy_from_slice(&number(target - place).to_le_bytes());
    }

    fn short(&mut self, place: usize, value: usize) {
        let value = u16::try_from(value).unwrap_or(u16::MAX);
        self.bytes[place..place + 2].copy_from_slice(&value.to_le_bytes());
    }
}

fn number(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}
