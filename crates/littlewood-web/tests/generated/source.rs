//! Pieces of TypeScript.

use core::fmt::Write;

/// How the files are made.
pub(crate) const WRITTEN: &str =
    "Written by `LITTLEWOOD_WRITE=1 cargo test -p littlewood-web generated::`; do not edit.";

/// A file that grows.
pub(crate) struct Source(String);

impl Source {
    /// Begins with what the file is, and that it is written.
    pub(crate) fn new(subject: &str) -> Self {
        Self(format!("// {subject} {WRITTEN}\n"))
    }

    /// The names of an enumeration in order, and the type of a name.
    pub(crate) fn names<'a>(
        &mut self,
        list: &str,
        kind: &str,
        doc: &str,
        names: impl IntoIterator<Item = &'a str>,
    ) {
        let _ = write!(self.0, "\n/** {doc} */\nexport const {list} = [");
        for name in names {
            let _ = write!(self.0, "\n  {},", quoted(name));
        }
        let _ = write!(
            self.0,
            "\n] as const;\nexport type {kind} = (typeof {list})[number];\n"
        );
    }

    /// A value for each name.
    pub(crate) fn record<'a>(
        &mut self,
        record: &str,
        (key, value): (&str, &str),
        doc: &str,
        rows: impl IntoIterator<Item = (&'a str, String)>,
    ) {
        let _ = write!(self.0, "\n/** {doc} */\nexport const {record} = {{");
        for (name, row) in rows {
            let _ = write!(self.0, "\n  {name}: {row},");
        }
        let _ = write!(self.0, "\n}} as const satisfies Record<{key}, {value}>;\n");
    }

    /// Lines as they are.
    pub(crate) fn lines(&mut self, lines: &str) {
        self.0.push('\n');
        self.0.push_str(lines);
        self.0.push('\n');
    }

    /// The whole file.
    pub(crate) fn text(self) -> String {
        self.0
    }
}

/// A text as TypeScript writes it.
pub(crate) fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\\', "\\\\").replace('\'', "\\'"))
}

/// A text, or null.
pub(crate) fn quoted_or_null(text: Option<&str>) -> String {
    text.map_or_else(|| "null".to_owned(), quoted)
}

/// The fields of an object.
pub(crate) fn object(fields: &[(&str, String)]) -> String {
    let fields: Vec<String> = fields
        .iter()
        .map(|(name, value)| format!("{name}: {value}"))
        .collect();
    format!("{{ {} }}", fields.join(", "))
}
