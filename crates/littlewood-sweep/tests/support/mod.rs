//! What the tests share: the hoop of Figure 2, grids of it, trees of files, a disk that fills up.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests stand outside of test functions"
)]

pub(crate) mod table;
pub(crate) mod zarr;

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use littlewood::tables::{Quantity, Setup, SummaryColumn, SummaryValue};
use littlewood::{HoopParameters, Start};
use littlewood_sweep::{Axis, Columns, Disk, FileSystem, Grid, Workers};

pub(crate) fn figure_2() -> Setup {
    Setup::new(
        HoopParameters::thin(1.0).with_friction(0.5, 0.4),
        Start::at(0.0, 0.0),
    )
}

/// A column of real numbers.
pub(crate) fn reals(columns: &Columns, column: SummaryColumn) -> &[f64] {
    columns.reals(column).unwrap()
}

/// Bits of all columns: NaN equals NaN.
pub(crate) fn bits(columns: &Columns) -> Vec<Vec<u64>> {
    let bits = |value| match value {
        SummaryValue::U8(value) => value.into(),
        SummaryValue::U32(value) => value.into(),
        SummaryValue::U64(value) => value,
        SummaryValue::F64(value) => value.to_bits(),
    };
    columns
        .columns()
        .map(|(_, values)| values.iter().map(bits).collect())
        .collect()
}

/// The map of the benchmarks: θ from −π to π, θ′ from −4 to 4.
pub(crate) fn map(count: usize) -> Grid {
    let theta = Axis::new(Quantity::Theta, -PI, PI, count).unwrap();
    let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, count).unwrap();
    Grid::new(figure_2(), vec![theta, rate]).unwrap()
}

/// A grid in which starts and hoops vary, and some hoops contradict themselves (μk > μs).
pub(crate) fn mixed() -> Grid {
    let axis = |quantity, from, to, count| Axis::new(quantity, from, to, count).unwrap();
    let axes = vec![
        axis(Quantity::MuS, 0.1, 0.7, 4),
        axis(Quantity::Theta, -3.0, 3.0, 7),
        axis(Quantity::MuK, 0.0, 0.6, 3),
        axis(Quantity::ThetaRate, 3.5, -3.5, 11),
    ];
    Grid::new(figure_2(), axes).unwrap()
}

pub(crate) fn workers(threads: usize) -> Workers {
    Workers::new(std::num::NonZeroUsize::new(threads)).unwrap()
}

/// All files under a folder with their bytes; or a file, and what is in the folder of its parts.
pub(crate) fn tree(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![root.to_owned()];
    let parts = parts(root);
    let root = root.parent().unwrap();
    if folders[0].is_file() {
        let file = folders.remove(0);
        files.insert(PathBuf::from("."), fs::read(file).unwrap());
    }
    if parts.is_dir() {
        folders.push(parts);
        folders.retain(|folder| folder.is_dir());
    }
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let inside: PathBuf = path.strip_prefix(root).unwrap().iter().skip(1).collect();
                files.insert(inside, fs::read(&path).unwrap());
            }
        }
    }
    files
}

/// The folder of the parts of a file.
pub(crate) fn parts(file: &Path) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(".parts");
    PathBuf::from(name)
}

/// Says which files differ, not what is in them.
pub(crate) fn assert_same_tree(a: &Path, b: &Path) {
    let (a, b) = (tree(a), tree(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    let differing: Vec<_> = a
        .iter()
        .filter(|(path, bytes)| b[*path] != **bytes)
        .map(|(path, _)| path)
        .collect();
    assert!(differing.is_empty(), "{differing:?}");
}

/// A disk with room for so many bytes. A file that does not fit is written in part, as by a kill.
pub(crate) struct SmallDisk {
    pub(crate) room: AtomicUsize,
}

impl SmallDisk {
    pub(crate) fn new(room: usize) -> Self {
        Self {
            room: AtomicUsize::new(room),
        }
    }

    fn take(&self, bytes: &[u8]) -> (usize, io::Result<()>) {
        let room = self.room.load(Ordering::SeqCst);
        if bytes.len() <= room {
            self.room.store(room - bytes.len(), Ordering::SeqCst);
            (bytes.len(), Ok(()))
        } else {
            self.room.store(0, Ordering::SeqCst);
            (room, Err(io::ErrorKind::StorageFull.into()))
        }
    }
}

impl Disk for SmallDisk {
    fn create_folder(&self, path: &Path) -> io::Result<()> {
        FileSystem.create_folder(path)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let (fits, result) = self.take(bytes);
        match result {
            Ok(()) => FileSystem.write(path, bytes),
            Err(error) => {
                let mut torn = path.as_os_str().to_owned();
                torn.push(".unfinished");
                fs::write(torn, &bytes[..fits])?;
                Err(error)
            }
        }
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let (fits, result) = self.take(bytes);
        FileSystem.append(path, &bytes[..fits])?;
        result
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        FileSystem.rename(from, to)
    }
}
