//! Stores, complete and partial, with damage: what is read from them, and what becomes of them when
//! they are resumed.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use littlewood::tables::{Quantity, Setup};
use littlewood::{HoopParameters, Limits, Start};
use littlewood_sweep::{
    Axis, Chunk, ChunkView, Columns, Grid, Options, Picture, PictureSize, Progress, Report, Shade,
    SweepError, Target, Workers, ZarrStore, sweep_grid,
};

use crate::fuzz::damage::{Tree, damage, plant, tree};
use crate::fuzz::program::{judge, run as run_program};
use crate::fuzz::{Case, Verdict};
use littlewood_random::Draw;

/// Which part of the runs goes through the program.
const THROUGH_THE_PROGRAM: f64 = 0.05;

const CHUNK: usize = 100;

/// Name of the results in their folder; a table that is not complete is in a folder of another
/// name.
const NAMES: [&str; 3] = ["a.zarr", "a.parquet", "parts"];

/// What is damaged.
struct Whole {
    /// Which of the names.
    kind: usize,
    is_complete: bool,
    files: Tree,
}

fn grid() -> Grid {
    let base = Setup::new(
        HoopParameters::thin(1.0).with_friction(0.5, 0.4),
        Start::at(0.0, 0.0),
    );
    let axis = |quantity, from, to, count| Axis::new(quantity, from, to, count).expect("an axis");
    let axes = vec![
        axis(Quantity::Theta, -3.0, 3.0, 13),
        axis(Quantity::ThetaRate, -3.5, 3.5, 17),
    ];
    Grid::new(base, axes).expect("a grid")
}

fn limits() -> Limits {
    Limits::until(20.0)
}

/// The same run as by the program.
fn words(kind: usize) -> Vec<String> {
    let words = format!(
        "sweep --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 --slip 0 --until 20 --axis theta=-3:3:13 \
         --axis theta_rate=-3.5:3.5:17 --chunk {CHUNK} --resume --out {}",
        NAMES[kind]
    );
    words.split_whitespace().map(str::to_owned).collect()
}

fn workers() -> &'static Workers {
    static WORKERS: OnceLock<Workers> = OnceLock::new();
    WORKERS.get_or_init(|| Workers::new(NonZeroUsize::new(2)).expect("threads"))
}

fn target(kind: usize, path: &Path) -> Target<'_> {
    match kind {
        0 => Target::Zarr(path),
        1 => Target::Parquet(path),
        _ => Target::ParquetFolder(path),
    }
}

fn sweep(
    kind: usize,
    folder: &Path,
    resume: bool,
    cancel_at: Option<u64>,
    view: bool,
) -> Result<Report, SweepError> {
    let cancel = AtomicBool::new(false);
    let watch = |progress: Progress| {
        if cancel_at.is_some_and(|points| progress.done >= points) {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let options = Options {
        resume,
        chunk_points: CHUNK,
        cancel: Some(&cancel),
        progress: Some(&watch),
        ..Options::default()
    };
    let path = folder.join(NAMES[kind]);
    let mut nothing = |_: &Chunk, _: &Columns| {};
    let view: Option<&mut ChunkView<'_>> = if view { Some(&mut nothing) } else { None };
    sweep_grid(
        &grid(),
        limits(),
        &[target(kind, &path)],
        view,
        workers(),
        &options,
    )
}

/// A complete and a partial run of each kind.
fn wholes() -> &'static [Whole] {
    static WHOLES: OnceLock<Vec<Whole>> = OnceLock::new();
    WHOLES.get_or_init(|| {
        let mut wholes = Vec::new();
        for kind in 0..NAMES.len() {
            for cancel_at in [None, Some(CHUNK as u64)] {
                let folder = tempfile::tempdir().expect("a folder");
                let report = sweep(kind, folder.path(), false, cancel_at, false).expect("a run");
                let files = tree(folder.path());
                wholes.push(Whole {
                    kind,
                    is_complete: report.complete,
                    files,
                });
            }
        }
        wholes
    })
}

pub(crate) fn run(case: &mut Case) -> Verdict {
    let draw = &mut case.draw;
    let whole = &wholes()[draw.below(wholes().len())];
    let mut files = whole.files.clone();
    let harm = harm(draw, &mut files);
    let damaged = case.folder.join("damaged");
    let state = if whole.is_complete {
        "complete"
    } else {
        "partial"
    };
    case.told.tell(format!(
        "cd {} && littlewood {}  {state}{harm}",
        damaged.display(),
        words(whole.kind).join(" ")
    ));
    let folder = case.folder.join("resumed");
    plant(&files, &folder);
    let verdict = resume(draw, whole.kind, &folder);
    if verdict.is_err() {
        plant(&files, &damaged);
    }
    verdict
}

/// Reads what is in the folder, and goes on with it.
fn resume(draw: &mut Draw, kind: usize, folder: &Path) -> Verdict {
    if draw.comes(THROUGH_THE_PROGRAM) {
        let verdict = judge_system(&run_program(&words(kind), folder))?;
        return same(kind, verdict, folder);
    }
    if kind == 0 {
        read_all(&folder.join(NAMES[0]));
    }
    match sweep(kind, folder, true, None, draw.comes(0.5)) {
        Ok(report) if !report.complete => Err("it ended without being cancelled".to_owned()),
        Ok(_) => same(kind, "completed", folder),
        Err(error) if error.to_string().is_empty() => Err("a refusal that says nothing".to_owned()),
        Err(_) => Ok("refused"),
    }
}

/// A damaged store can also end in a failure to write, where a file stands in the place of a
/// folder.
fn judge_system(ran: &crate::fuzz::program::Ran) -> Verdict {
    if ran.code == Some(1) && ran.stdout.is_empty() && ran.stderr.contains("hint:") {
        return Ok("failed");
    }
    judge(ran)
}

/// Does something to the files.
fn harm(draw: &mut Draw, files: &mut Tree) -> String {
    let names: Vec<PathBuf> = files.keys().cloned().collect();
    let mut told = String::new();
    loop {
        let name = &names[draw.below(names.len())];
        told += &format!(", {}: ", name.display());
        match draw.below(8) {
            0 => {
                files.remove(name);
                told += "removed";
            }
            1 => {
                let other = &names[draw.below(names.len())];
                if let (Some(bytes), true) = (files.get(name).cloned(), files.contains_key(other)) {
                    files.insert(other.clone(), bytes);
                }
                told += &format!("copied to {}", other.display());
            }
            2 => {
                if files.remove(name).is_some() {
                    files.insert(name.join("inside"), Vec::new());
                }
                told += "a folder";
            }
            _ => {
                if let Some(bytes) = files.get_mut(name) {
                    told += &damage(draw, bytes);
                }
            }
        }
        if draw.comes(0.6) {
            return told;
        }
    }
}

/// Reads all that can be read of a store. Each of these may be refused; none may panic.
fn read_all(path: &Path) {
    let Ok(store) = ZarrStore::open(path) else {
        return;
    };
    let _ = store.broken_chunks();
    if store.chunks().count() > 100 {
        return;
    }
    for number in 0..store.chunks().count() {
        let _ = store.columns(number);
    }
    let _ = Picture::of_store(
        &store,
        Shade::Class,
        PictureSize {
            width: 300,
            height: 200,
        },
    );
}

/// A run that says it is complete has the bytes of one that nothing happened to.
fn same(kind: usize, verdict: &'static str, folder: &Path) -> Verdict {
    if verdict != "done" && verdict != "completed" {
        return Ok(verdict);
    }
    let whole = wholes()
        .iter()
        .find(|whole| whole.kind == kind && whole.is_complete)
        .expect("a whole one");
    let found = tree(folder);
    // The lock is a file without content; a table that is complete has no checksums, so that it is
    // not known to be damaged.
    let is_checked = |path: &Path| !path.ends_with("_lock") && path != Path::new(NAMES[1]);
    for (path, bytes) in whole.files.iter().filter(|(path, _)| is_checked(path)) {
        match found.get(path) {
            None => return Err(format!("{} is missing", path.display())),
            Some(found) if found != bytes => return Err(format!("{} differs", path.display())),
            Some(_) => {}
        }
    }
    Ok(verdict)
}
