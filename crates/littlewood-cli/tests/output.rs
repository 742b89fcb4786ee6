//! Where the output goes: files that are replaced at the end only, closed pipes, and failures to
//! write.
#![allow(clippy::panic)] // a failed expectation

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::support::{complaint, littlewood, text};
use tempfile::TempDir;

const PRECIOUS: &str = "years of work";

/// A folder with a file in it.
fn folder() -> (TempDir, String) {
    let folder = TempDir::new().expect("a folder for the test");
    let path = folder.path().join("motion.json");
    fs::write(&path, PRECIOUS).expect("a file for the test");
    let path = path.to_str().expect("a path in UTF-8").to_owned();
    (folder, path)
}

fn entries(folder: &Path) -> usize {
    fs::read_dir(folder).expect("the folder").count()
}

#[test]
fn a_file_is_written_whole_and_nothing_else_is_left() {
    let (folder, path) = folder();
    assert_eq!(
        text(&["simulate", "figure-3", "--format", "json", "--out", &path]),
        ""
    );
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        text(&["simulate", "figure-3", "--format", "json"])
    );
    assert_eq!(entries(folder.path()), 1);
}

#[test]
fn the_format_follows_the_ending_unless_it_is_given() {
    let folder = TempDir::new().unwrap();
    let write = |name: &str, more: &[&str]| {
        let path = folder.path().join(name);
        text(
            &[
                &["simulate", "figure-3", "--out", path.to_str().unwrap()],
                more,
            ]
            .concat(),
        );
        fs::read_to_string(path).unwrap()
    };
    assert!(write("a.json", &[]).starts_with('{'));
    assert!(write("a.csv", &[]).starts_with("time,theta,"));
    assert!(write("a.txt", &[]).starts_with("figure-3: "));
    assert!(write("a", &[]).starts_with("figure-3: "));
    assert!(write("A.JSON", &[]).starts_with('{'));
    assert!(write("b.json", &["--format", "csv"]).starts_with("time,theta,"));
    assert!(write("b.dat", &["--format", "csv"]).starts_with("time,theta,"));
    assert_eq!(entries(folder.path()), 7);
    for name in ["c.parquet", "c.zarr", "c.md"] {
        let path = folder.path().join(name);
        let message = complaint(
            &["simulate", "figure-3", "--out", path.to_str().unwrap()],
            2,
        );
        assert!(
            message.contains("hint: names end in .txt, .csv or .json"),
            "{message}"
        );
    }
    assert_eq!(entries(folder.path()), 7);
}

/// Every command that writes treats a folder that is not there alike.
#[test]
fn a_folder_that_is_not_there_is_not_made() {
    let folder = TempDir::new().unwrap();
    let out = |name: &str| {
        folder
            .path()
            .join("nowhere")
            .join(name)
            .to_str()
            .unwrap()
            .to_owned()
    };
    let axes = ["--x", "theta=0:1:3", "--y", "theta_rate=0:1:3"];
    for (command, more, name) in [
        ("simulate", &[][..], "motion.csv"),
        ("animate", &[], "film.gif"),
        ("poster", &[], "poster.pdf"),
        ("figures", &["figure-1", "--case"], "figures"),
        ("map", &axes, "map.png"),
        ("map", &axes, "map.csv"),
        ("map", &axes, "map.zarr"),
        ("map", &axes, "map.parquet"),
        ("sweep", &["--axis", "theta=0:1:3"], "sweep.zarr"),
        ("sweep", &["--axis", "theta=0:1:3"], "sweep.parquet"),
    ] {
        let out = out(name);
        let mut words = vec![command];
        words.extend(more);
        words.extend(["figure-3", "--out", &out]);
        let message = complaint(&words, 2);
        assert!(
            message.contains(&format!("cannot write to {out}")),
            "{command} {name}: {message}"
        );
        assert!(
            message.contains("hint: outputs need an existing folder"),
            "{message}"
        );
        assert_eq!(entries(folder.path()), 0, "{command} {name}");
    }
}

/// A run that writes for a long time, and the name of its unfinished file.
#[cfg(unix)]
fn begun(path: &str, folder: &Path) -> (std::process::Child, String) {
    let program = littlewood().get_program().to_owned();
    let mut run = Command::new(program)
        .args([
            "simulate",
            "figure-3",
            "--samples",
            "10000000",
            "--out",
            path,
            "--format",
            "csv",
        ])
        .spawn()
        .expect("it runs");
    for _ in 0..3000 {
        let mut names = fs::read_dir(folder)
            .expect("a folder")
            .flatten()
            .map(|entry| entry.file_name());
        if let Some(name) = names.find(|name| name.to_string_lossy().ends_with(".part")) {
            return (run, name.into_string().expect("UTF-8"));
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let _ = run.kill().and_then(|()| run.wait());
    panic!("it does not begin");
}

#[cfg(unix)]
#[test]
fn what_a_killed_run_has_left_is_removed_and_what_a_running_one_writes_is_not() {
    let (folder, path) = folder();
    let (mut run, left) = begun(&path, folder.path());
    let other = folder.path().join("other.json");
    let simulate = |path: &str| text(&["simulate", "figure-3", "--out", path]);
    simulate(&path);
    assert!(
        folder.path().join(&left).exists(),
        "{left} belongs to a run"
    );
    run.kill().unwrap();
    run.wait().unwrap();
    // Not those of other names, of other programs, or that are no files.
    let strangers = [
        ".littlewood-motion.json-.part",
        ".littlewood-motion.json-abcdefg.part",
        "motion.json.part",
    ];
    for stranger in strangers {
        fs::write(folder.path().join(stranger), "").unwrap();
    }
    fs::create_dir(folder.path().join(".littlewood-motion.json-abcdef.part")).unwrap();
    simulate(other.to_str().unwrap());
    assert!(
        folder.path().join(&left).exists(),
        "{left} is of another name"
    );
    simulate(&path);
    assert!(!folder.path().join(&left).exists(), "{left} is still there");
    assert_eq!(entries(folder.path()), 2 + strangers.len() + 1);
}

#[test]
fn a_name_as_long_as_names_can_be_is_written() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(format!("{}.json", "ä".repeat(125)));
    text(&["simulate", "figure-3", "--out", path.to_str().unwrap()]);
    assert!(fs::read_to_string(path).unwrap().starts_with('{'));
    assert_eq!(entries(folder.path()), 1);
}

#[test]
fn bad_input_does_not_touch_the_file() {
    let (folder, path) = folder();
    complaint(
        &["simulate", "figure-3", "--mu-k", "0.9", "--out", &path],
        2,
    );
    complaint(
        &["simulate", "figure-3", "--until", "-1", "--out", &path],
        2,
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), PRECIOUS);
    assert_eq!(entries(folder.path()), 1);
}

#[test]
fn a_file_that_cannot_be_written_is_bad_input() {
    let folder = TempDir::new().unwrap();
    let inside = folder.path().join("nowhere/motion.json");
    for path in [inside.as_path(), folder.path()] {
        let path = path.to_str().unwrap();
        let message = complaint(&["simulate", "figure-3", "--out", path], 2);
        assert!(
            message.contains(&format!("cannot write to {path}")),
            "{message}"
        );
        assert!(message.contains("hint: "), "{message}");
    }
    complaint(&["simulate", "figure-3", "--out", ""], 2);
}

#[test]
fn a_read_only_file_is_not_replaced() {
    let (_folder, path) = folder();
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let message = complaint(&["simulate", "figure-3", "--out", &path], 2);
    assert!(message.contains("read-only"), "{message}");
    assert_eq!(fs::read_to_string(&path).unwrap(), PRECIOUS);
}

/// A limit on the size of files stands for the full disk.
#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing() {
    let (folder, path) = folder();
    let program = littlewood().get_program().to_owned();
    let output = Command::new("sh")
        .args([
            "-c",
            "ulimit -f 1; exec \"$0\" simulate figure-3 --samples 1000 --out \"$1\"",
        ])
        .arg(program)
        .arg(&path)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.contains("failed") && message.contains("the existing file is unchanged"),
        "{message}"
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), PRECIOUS);
    assert_eq!(entries(folder.path()), 1);
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_permissions_are_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let (folder, path) = folder();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.path().join("link.json");
    symlink(&path, &link).unwrap();
    text(&["simulate", "figure-3", "--out", link.to_str().unwrap()]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&path).unwrap().starts_with('{'));
    assert_eq!(
        fs::metadata(&path).unwrap().permissions().mode() & 0o777,
        0o640
    );
    let fresh = folder.path().join("fresh.json");
    text(&["simulate", "figure-3", "--out", fresh.to_str().unwrap()]);
    let ordinary = folder.path().join("ordinary");
    File::create(&ordinary).unwrap();
    assert_eq!(
        fs::metadata(fresh).unwrap().permissions(),
        fs::metadata(ordinary).unwrap().permissions()
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_failure_to_write_has_exit_code_1() {
    let full = || File::options().write(true).open("/dev/full").unwrap();
    for arguments in [
        &["simulate", "figure-3"][..],
        &["cases"],
        &["classify", "figure-3", "--format", "json"],
    ] {
        let output = Command::new(littlewood().get_program())
            .args(arguments)
            .stdout(full())
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1));
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(
            message.contains("writing to the standard output failed"),
            "{message}"
        );
    }
    // A device is written to, never replaced.
    let message = complaint(&["simulate", "figure-3", "--out", "/dev/full"], 1);
    assert!(message.contains("writing to /dev/full failed"), "{message}");
    text(&["simulate", "figure-3", "--out", "/dev/null"]);
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn a_closed_pipe_is_no_error() {
    for format in ["csv", "json", "table"] {
        let mut child = Command::new(littlewood().get_program())
            .args([
                "simulate",
                "figure-3",
                "--samples",
                "20000",
                "--format",
                format,
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        // Reads one line of far more than a pipe holds, and leaves.
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut line)
            .unwrap();
        assert!(!line.is_empty());
        let mut message = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut message)
            .unwrap();
        assert_eq!(message, "");
        assert_eq!(child.wait().unwrap().code(), Some(0));
    }
}
