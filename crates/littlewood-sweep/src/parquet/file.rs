//! One Parquet file: the files of a folder, one after the other.

use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::column::writer::ColumnCloseResult;
use parquet::file::metadata::{
    FileMetaData, KeyValue, PageIndexPolicy, ParquetMetaData, ParquetMetaDataReader,
};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use serde_json::{Map, Value};

use super::read::read_row_group;
use super::table::{CHUNK_KEY, RUN_KEY, Table};
use crate::columns::Columns;
use crate::disk::{Disk, PARTS, UNFINISHED, with_ending};
use crate::file::open_file;
use crate::store::{Format as _, Header, StoreError};
use crate::tally::Tally;

const COUNTS_KEY: &str = "littlewood_counts";

const BUFFER: usize = 1 << 20;

/// A file that a run writes, and the folder of its parts.
pub(crate) struct OneFile {
    path: PathBuf,
    parts: PathBuf,
    table: Table,
}

impl OneFile {
    pub(crate) fn new(path: &Path, table: Table) -> Self {
        Self {
            path: path.to_owned(),
            parts: with_ending(path, PARTS),
            table,
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    pub(crate) fn parts(&self) -> &Path {
        &self.parts
    }

    pub(crate) const fn table(&self) -> &Table {
        &self.table
    }

    /// The points of a file of the same run; none where there is no file.
    pub(crate) fn inspect(&self) -> Result<Option<Tally>, StoreError> {
        let not_a_store = || StoreError::NotAStore {
            path: self.path.clone(),
        };
        let file = match fs::metadata(&self.path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(StoreError::unwritable(&self.path, source)),
            Ok(metadata) if !metadata.is_file() => return Err(not_a_store()),
            Ok(_) => File::open(&self.path)
                .map_err(|source| StoreError::unreadable(&self.path, source))?,
        };
        let metadata = footer(&file).map_err(|_| not_a_store())?;
        let find = |key: &str| {
            let entries = metadata.file_metadata().key_value_metadata()?;
            entries
                .iter()
                .find(|entry| entry.key == key)?
                .value
                .as_deref()
        };
        let run: Value = find(RUN_KEY)
            .and_then(|run| serde_json::from_str(run).ok())
            .ok_or_else(not_a_store)?;
        let header = Header {
            format: run.get("format").cloned(),
            run,
            complete: true,
        };
        header.check_versions(&self.path)?;
        let differences = self.table.description().differences(&header.run);
        if !differences.is_empty() {
            return Err(StoreError::OtherParameters {
                path: self.path.clone(),
                differences,
            });
        }
        find(COUNTS_KEY)
            .and_then(parse_counts)
            .map(Some)
            .ok_or_else(not_a_store)
    }

    pub(crate) fn read(&self, chunk: usize) -> Result<Option<Columns>, StoreError> {
        read_row_group(&self.path, chunk, &self.table.derivatives).map(Some)
    }

    /// Puts the parts together. Encoded columns are copied; nothing is decoded, and memory stays
    /// flat.
    pub(crate) fn join(
        &self,
        count: usize,
        tally: Tally,
        disk: &dyn Disk,
    ) -> Result<(), StoreError> {
        let unfinished = with_ending(&self.path, UNFINISHED);
        // An earlier attempt may have been killed.
        match fs::remove_file(&unfinished) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(StoreError::unwritable(&unfinished, error));
            }
            _ => {}
        }
        let mut failure = None;
        let appender = Appender {
            disk,
            path: &unfinished,
            failure: &mut failure,
        };
        let joined = self.copy(count, tally, BufWriter::with_capacity(BUFFER, appender));
        if let Some(source) = failure {
            // The first error is the one to report; this only frees the room that the unfinished
            // file takes.
            let _ = fs::remove_file(&unfinished);
            return Err(StoreError::unwritable(&self.path, source));
        }
        joined?;
        disk.rename(&unfinished, &self.path)
            .map_err(|source| StoreError::unwritable(&self.path, source))
    }

    fn copy(
        &self,
        count: usize,
        tally: Tally,
        target: impl Write + Send,
    ) -> Result<(), StoreError> {
        let name = self.path.display().to_string();
        let failed = StoreError::encoding(&name);
        let (_, first) = self.open_part(0)?;
        let schema = first.file_metadata().schema_descr().root_schema_ptr();
        let properties = Arc::new(properties(first.file_metadata(), tally));
        let mut writer = SerializedFileWriter::new(target, schema, properties).map_err(&failed)?;
        for chunk in 0..count {
            let (file, metadata) = self.open_part(chunk)?;
            for (i, group) in metadata.row_groups().iter().enumerate() {
                let mut copy = writer.next_row_group().map_err(&failed)?;
                let column_index = metadata.column_index().and_then(|index| index.get(i));
                let offset_index = metadata.offset_index().and_then(|index| index.get(i));
                for (j, column) in group.columns().iter().enumerate() {
                    let close = ColumnCloseResult {
                        bytes_written: u64::try_from(column.compressed_size()).unwrap_or_default(),
                        rows_written: u64::try_from(group.num_rows()).unwrap_or_default(),
                        metadata: column.clone(),
                        bloom_filter: None,
                        column_index: column_index.and_then(|index| index.get(j)).cloned(),
                        offset_index: offset_index.and_then(|index| index.get(j)).cloned(),
                    };
                    copy.append_column(&file, close).map_err(&failed)?;
                }
                copy.close().map_err(&failed)?;
            }
        }
        // The footer is written here, and what is left in the buffer.
        let mut target = writer.into_inner().map_err(&failed)?;
        target.flush().map_err(StoreError::encoding(&name))
    }

    /// The file of a chunk, and what its footer says.
    fn open_part(&self, chunk: usize) -> Result<(File, ParquetMetaData), StoreError> {
        let path = self.parts.join(self.table.path(chunk));
        let file = open_file(&path).map_err(|source| StoreError::unreadable(&path, source))?;
        let metadata = footer(&file).map_err(|error| StoreError::DamagedChunk {
            path,
            reason: error.to_string(),
        })?;
        Ok((file, metadata))
    }

    /// Removes the folder of the parts, if there is one. Files of others stay.
    pub(crate) fn remove_parts(&self) -> Result<(), StoreError> {
        let parts = match fs::read_dir(&self.parts) {
            Ok(parts) => parts,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
            Err(source) => return Err(StoreError::unwritable(&self.parts, source)),
        };
        let mut has_other_files = false;
        for part in parts {
            let part = part.map_err(|source| StoreError::unwritable(&self.parts, source))?;
            if self.table.makes_file(&part.file_name().to_string_lossy()) {
                unless_gone(fs::remove_file(part.path()), &part.path())?;
            } else {
                has_other_files = true;
            }
        }
        if has_other_files {
            Ok(())
        } else {
            unless_gone(fs::remove_dir(&self.parts), &self.parts)
        }
    }
}

/// The result of removing something. It may be gone already: another process may complete the same
/// file.
fn unless_gone(result: io::Result<()>, path: &Path) -> Result<(), StoreError> {
    match result {
        Err(source) if source.kind() != ErrorKind::NotFound => {
            Err(StoreError::unwritable(path, source))
        }
        _ => Ok(()),
    }
}

/// The metadata of the whole file: that of a part, with the counts of the whole run.
fn properties(part: &FileMetaData, tally: Tally) -> WriterProperties {
    let entries = part.key_value_metadata().into_iter().flatten();
    let mut entries: Vec<KeyValue> = entries
        .filter(|entry| entry.key != CHUNK_KEY)
        .cloned()
        .collect();
    entries.push(KeyValue::new(COUNTS_KEY.to_owned(), counts(tally)));
    WriterProperties::builder()
        .set_created_by(part.created_by().unwrap_or_default().to_owned())
        .set_key_value_metadata(Some(entries))
        .build()
}

fn footer(file: &File) -> parquet::errors::Result<ParquetMetaData> {
    ParquetMetaDataReader::new()
        .with_page_index_policy(PageIndexPolicy::Optional)
        .parse_and_finish(file)
}

fn counts(tally: Tally) -> String {
    let counts: Map<String, Value> = tally
        .iter()
        .map(|(class, count)| (class.to_string(), count.into()))
        .collect();
    Value::Object(counts).to_string()
}

fn parse_counts(text: &str) -> Option<Tally> {
    let mut tally = Tally::default();
    for (class, count) in serde_json::from_str::<Map<String, Value>>(text).ok()? {
        tally.add(class.parse().ok()?, count.as_u64()?);
    }
    Some(tally)
}

/// A file on the disk of the run, to write to. The Parquet writer wraps errors in texts; the first
/// one is kept here.
struct Appender<'a> {
    disk: &'a dyn Disk,
    path: &'a Path,
    failure: &'a mut Option<io::Error>,
}

impl Write for Appender<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.disk.append(self.path, bytes) {
            Ok(()) => Ok(bytes.len()),
            Err(error) => {
                let kind = error.kind();
                self.failure.get_or_insert(error);
                Err(kind.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
