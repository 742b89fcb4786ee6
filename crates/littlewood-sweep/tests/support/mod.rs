//! What the tests share: the hoop of Figure 2, grids of it, trees of files, a disk that fills up.

#![allow(dead_code, reason = "each test file uses some of it")]
#![allow(clippy::unwrap_used, reason = "helpers of tests stand outside of test functions")]

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use littlewood::{HoopParameters, Start};
use littlewood_sweep::{Axis, Coordinate, Disk, FileSystem, Grid, Point, Workers};

pub(crate) fn figure_2() -> Point {
    Point {
        hoop: HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s: 0.5, mu_k: 0.4 },
        start: Start::at(0.0, 0.0),
    }
}

/// The map of the benchmarks: θ from −π to π, θ′ from −4 to 4.
pub(crate) fn map(count: usize) -> Grid {
    let theta = Axis::new(Coordinate::Theta, -PI, PI, count).unwrap();
    let rate = Axis::new(Coordinate::ThetaRate, -4.0, 4.0, count).unwrap();
    Grid::new(figure_2(), vec![theta, rate]).unwrap()
}

/// A grid in which starts and hoops vary, and some hoops contradict themselves (μk > μs).
pub(crate) fn mixed() -> Grid {
    let axis = |coordinate, from, to, count| Axis::new(coordinate, from, to, count).unwrap();
    let axes = vec![
        axis(Coordinate::MuS, 0.1, 0.7, 4),
        axis(Coordinate::Theta, -3.0, 3.0, 7),
        axis(Coordinate::MuK, 0.0, 0.6, 3),
        axis(Coordinate::ThetaRate, 3.5, -3.5, 11),
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
    let differing: Vec<_> =
        a.iter().filter(|(path, bytes)| b[*path] != **bytes).map(|(path, _)| path).collect();
    assert!(differing.is_empty(), "{differing:?}");
}

/// A disk with room for so many bytes. A file that does not fit is written in part, as by a kill.
pub(crate) struct SmallDisk {
    pub(crate) room: AtomicUsize,
}

impl SmallDisk {
    pub(crate) fn new(room: usize) -> Self {
        Self { room: AtomicUsize::new(room) }
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
