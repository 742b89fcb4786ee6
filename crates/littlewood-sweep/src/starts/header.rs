//! The columns of a list, by their names.

use std::path::Path;

use littlewood::tables::Quantity;

use super::error::ListError;
use crate::setup::quantities;

/// The quantities that the names of columns stand for.
pub(super) fn columns_of<'a>(
    path: &Path,
    names: impl Iterator<Item = &'a str>,
) -> Result<Vec<Quantity>, ListError> {
    let mut columns = Vec::new();
    for name in names {
        let name = name.trim_start_matches('\u{feff}').trim_matches('"');
        let column = quantities()
            .find(|column| column.name() == name)
            .ok_or_else(|| ListError::UnknownColumn { path: path.to_owned(), column: name.to_owned() })?;
        if columns.contains(&column) {
            return Err(ListError::DuplicateColumn { path: path.to_owned(), column });
        }
        columns.push(column);
    }
    Ok(columns)
}
