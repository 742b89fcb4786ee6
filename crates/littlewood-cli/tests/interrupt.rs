//! Runs that do not reach their end: Ctrl-C, kill -9, a file that cannot grow, places where nothing
//! can be written.

#![cfg(unix)]

use crate::support;
use std::fs;
use std::io::Read as _;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::Mutex;
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::support::{complaint, tree};
use littlewood_sweep::ZarrStore;

/// A plane of 180 chunks.
const PLANE: [&str; 8] = [
    "figure-3",
    "--x",
    "theta=-pi:pi:600",
    "--y",
    "theta_rate=-4:4:600",
    "--until=50",
    "--chunk=2000",
    "--threads=2",
];

fn littlewood(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_littlewood"));
    command
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn map(outs: &[&Path], more: &[&str]) -> Command {
    let mut command = littlewood(&[&["map"], &PLANE[..], more].concat());
    for out in outs {
        command.arg("--out").arg(out);
    }
    command
}

/// Waits for something that a run does; a run that does not is given up.
fn wait_until(mut come: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !come() {
        assert!(
            begun.elapsed() < Duration::from_secs(120),
            "it does not come"
        );
        sleep(Duration::from_millis(2));
    }
}

/// Waits until a store has some chunks.
fn wait_for_chunks(manifest: &Path) {
    wait_until(|| fs::read_to_string(manifest).is_ok_and(|text| text.lines().count() > 4));
}

fn signal(child: &Child, name: &str) {
    let status = Command::new("kill")
        .args([name, &child.id().to_string()])
        .status()
        .expect("kill runs");
    assert!(status.success());
}

fn parts(path: &Path) -> PathBuf {
    path.with_extension("parquet.parts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

fn succeed(command: &mut Command) -> Output {
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{}", text(&output.stderr));
    output
}

#[test]
fn ctrl_c_leaves_what_is_finished_and_resume_ends_as_if_nothing_had_been() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = |name: &str| folder.path().join(name);
    let (zarr, table, png) = (name("a.zarr"), name("a.parquet"), name("a.png"));
    let child = map(&[&zarr, &table, &png], &[]).spawn().expect("it runs");
    wait_for_chunks(&zarr.join("outcome/_chunks.txt"));
    signal(&child, "-INT");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    let message = text(&output.stderr);
    assert!(
        message.contains("of 360000 starts") && message.contains("--resume goes on"),
        "{message}"
    );
    assert!(
        text(&output.stdout).contains("not computed"),
        "{}",
        text(&output.stdout)
    );

    // What there is can be read.
    let store = ZarrStore::open(&zarr).expect("a store");
    assert!(!store.is_complete());
    let broken = store.broken_chunks().expect("a list").len();
    assert!(0 < broken && broken < store.chunks().count());
    let there =
        (0..store.chunks().count()).filter(|&i| store.columns(i).expect("readable").is_some());
    assert_eq!(there.count(), store.chunks().count() - broken);
    assert!(parts(&table).join("part-00000.parquet").exists() && !table.exists());
    assert!(name("a.partial.png").exists() && !png.exists());

    succeed(&mut map(&[&zarr, &table, &png], &["--resume"]));
    assert_eq!(names(folder.path()), ["a.parquet", "a.png", "a.zarr"]);
    let whole = [name("b.zarr"), name("b.parquet"), name("b.png")];
    succeed(&mut map(&[&whole[0], &whole[1], &whole[2]], &[]));
    assert!(tree(&zarr) == tree(&whole[0]), "the store differs");
    assert!(
        fs::read(table).expect("a table") == fs::read(&whole[1]).expect("a table"),
        "the table differs"
    );
    assert!(fs::read(png).expect("a picture") == fs::read(&whole[2]).expect("a picture"));
}

#[test]
fn kill_9_is_survived() {
    let folder = tempfile::tempdir().expect("a folder");
    let (killed, whole) = (
        folder.path().join("a.parquet"),
        folder.path().join("b.parquet"),
    );
    for _ in 0..3 {
        let mut child = map(&[&killed], &["--resume"]).spawn().expect("it runs");
        let before = fs::read_to_string(parts(&killed).join("_chunks.txt"))
            .unwrap_or_default()
            .len();
        wait_until(|| {
            let text = fs::read_to_string(parts(&killed).join("_chunks.txt")).unwrap_or_default();
            text.len() > before + 200
        });
        signal(&child, "-KILL");
        assert_eq!(child.wait().expect("it ends").signal(), Some(9));
    }
    let output = succeed(&mut map(&[&killed], &["--resume", "--format", "json"]));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(support::number(&report["reused"]) > 0.0, "{report}");
    succeed(&mut map(&[&whole], &[]));
    assert!(fs::read(killed).expect("a table") == fs::read(whole).expect("a table"));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2);
}

#[test]
fn a_picture_that_is_not_complete_does_not_replace_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let png = folder.path().join("map.png");
    fs::write(&png, "an older picture").expect("written");
    // So many starts that it cannot be over before the signal.
    let axes = [
        "map",
        "figure-3",
        "--x",
        "theta=-pi:pi:20000",
        "--y",
        "theta_rate=-4:4:20000",
    ];
    let axes = [&axes[..], &["--chunk=2000", "--out"]].concat();
    let partial = folder.path().join("map.partial.png");
    // There is nothing to keep before the first starts are followed, which takes as long as the
    // machine likes.
    let mut patience = Duration::from_millis(300);
    let message = loop {
        let child = littlewood(&axes).arg(&png).spawn().expect("it runs");
        // The new picture is begun beside the old one before the work begins.
        wait_until(|| fs::read_dir(folder.path()).expect("a folder").count() > 1);
        sleep(patience);
        signal(&child, "-INT");
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
        assert_eq!(
            fs::read_to_string(&png).expect("a file"),
            "an older picture"
        );
        if partial.exists() {
            break text(&output.stderr);
        }
        patience *= 2;
        assert!(
            patience < Duration::from_secs(60),
            "{}",
            text(&output.stderr)
        );
    };
    assert_eq!(
        fs::read(&partial).expect("a picture")[..8],
        *b"\x89PNG\r\n\x1a\n"
    );
    assert!(message.contains("map.partial.png"), "{message}");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2);
}

#[test]
fn a_picture_alone_is_not_resumed() {
    let folder = tempfile::tempdir().expect("a folder");
    let png = folder.path().join("map.png");
    let words = [
        &["map"],
        &PLANE[..],
        &["--resume", "--out", png.to_str().expect("a path")],
    ]
    .concat();
    let message = complaint(&words, 2);
    assert!(
        message.contains("nothing to resume") && message.contains(".zarr"),
        "{message}"
    );
    assert!(!png.exists());
}

#[test]
fn a_second_writer_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let zarr = folder.path().join("a.zarr");
    let first = map(&[&zarr], &[]).spawn().expect("it runs");
    wait_for_chunks(&zarr.join("outcome/_chunks.txt"));
    let second = map(&[&zarr], &["--resume"]).output().expect("it runs");
    signal(&first, "-INT");
    first.wait_with_output().expect("it ends");
    assert_eq!(second.status.code(), Some(2));
    let message = text(&second.stderr);
    assert!(
        message.contains("another process is writing") && message.contains("hint:"),
        "{message}"
    );
    succeed(&mut map(&[&zarr], &["--resume"]));
}

/// Runs the program where no file can grow beyond so many bytes.
#[cfg(target_os = "linux")]
fn with_small_files(bytes: u32, arguments: &[&str]) -> Output {
    Command::new("sh")
        .arg("-c")
        .arg(format!("exec prlimit --fsize={bytes} \"$@\""))
        .args(["sh", env!("CARGO_BIN_EXE_littlewood")])
        .args(arguments)
        .output()
        .expect("it runs")
}

#[cfg(target_os = "linux")]
#[test]
fn a_write_that_fails_keeps_what_is_finished() {
    let folder = tempfile::tempdir().expect("a folder");
    // The list of finished chunks is the file that grows in a store, and the joined table is larger
    // than its parts.
    for (name, count, bytes) in [
        ("a.zarr", "theta=-3:3:65", 24_000),
        ("a.parquet", "theta=-3:3:4", 65_536),
    ] {
        let out = folder.path().join(name);
        let whole = folder.path().join(format!("whole-{name}"));
        let words = |path: &Path, more: &[&'static str]| -> Vec<String> {
            let chunk = if name == "a.zarr" {
                "--chunk=10"
            } else {
                "--chunk=20"
            };
            let mut words = vec![
                "sweep",
                "figure-3",
                "--axis",
                count,
                "--axis",
                "theta_rate=-2:2:100",
                chunk,
                "--until=5",
                "--out",
            ];
            let path = path.to_str().expect("a path").to_owned();
            words.extend(more);
            let place = words
                .iter()
                .position(|word| *word == "--out")
                .expect("--out")
                + 1;
            let mut words: Vec<String> = words.into_iter().map(str::to_owned).collect();
            words.insert(place, path);
            words
        };
        let out_words = words(&out, &[]);
        let output = with_small_files(
            bytes,
            &out_words.iter().map(String::as_str).collect::<Vec<_>>(),
        );
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(
            message.contains("cannot write") && message.contains("stay readable"),
            "{message}"
        );
        assert!(message.contains("--resume"), "{message}");
        if name == "a.zarr" {
            let store = ZarrStore::open(&out).expect("a store");
            let there = store.chunks().count() - store.broken_chunks().expect("a list").len();
            assert!(
                message.contains(&format!("the {} points", there * 10)),
                "{there}: {message}"
            );
        } else {
            assert!(message.contains("the 400 points"), "{message}");
            assert!(!out.exists() && parts(&out).join("part-00019.parquet").exists());
        }
        succeed(&mut littlewood(
            &words(&out, &["--resume"])
                .iter()
                .map(String::as_str)
                .collect::<Vec<_>>(),
        ));
        succeed(&mut littlewood(
            &words(&whole, &[])
                .iter()
                .map(String::as_str)
                .collect::<Vec<_>>(),
        ));
        if name == "a.zarr" {
            assert!(tree(&out) == tree(&whole));
        } else {
            assert!(fs::read(&out).expect("a table") == fs::read(&whole).expect("a table"));
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn nothing_is_said_to_be_readable_where_nothing_was_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("a.zarr");
    let words = [
        "sweep",
        "figure-3",
        "--axis",
        "theta=-3:3:9",
        "--out",
        out.to_str().expect("a path"),
    ];
    let output = with_small_files(512, &words);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("cannot write") && !message.contains("readable"),
        "{message}"
    );
    assert!(!message.contains("--resume"), "{message}");
}

#[test]
fn a_place_where_nothing_can_be_written_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "").expect("written");
    for ending in ["zarr", "parquet"] {
        let below = file.join(format!("plane.{ending}"));
        let below = below.to_str().expect("a path");
        let message = complaint(
            &["sweep", "figure-3", "--axis", "theta=0:1:3", "--out", below],
            2,
        );
        assert!(
            message.contains(&format!("cannot write to {below}")),
            "{message}"
        );
        assert!(
            message.contains("hint:") && !message.contains("readable"),
            "{message}"
        );
    }
    #[cfg(target_os = "linux")]
    {
        let sweep = |out: &str| {
            complaint(
                &["sweep", "figure-3", "--axis", "theta=0:1:3", "--out", out],
                2,
            )
        };
        assert!(sweep("/proc/plane.zarr").contains("cannot write /proc/plane.zarr"));
        assert!(sweep("/proc/plane.parquet").contains("cannot write /proc/plane.parquet"));
        // A device that is always full.
        let png = folder.path().join("full.png");
        std::os::unix::fs::symlink("/dev/full", &png).expect("a link");
        let plane = [
            "map",
            "figure-3",
            "--x",
            "theta=0:1:3",
            "--y",
            "theta_rate=0:1:3",
            "--out",
        ];
        let message = complaint(&[&plane[..], &[png.to_str().expect("a path")]].concat(), 1);
        assert!(message.contains("No space left"), "{message}");
    }
}

/// Work that would take minutes, and what it leaves in its folder when it is ended.
const LONG: [(&str, &str, &[&str]); 4] = [
    (
        "simulate",
        "figure-3 --samples 10000000 --format csv --out OUT/motion.csv",
        &[],
    ),
    ("figures", "--scale 16 --format png --out OUT", &[]),
    (
        "animate",
        "figure-3 --size 4096x4096 --out OUT/film.gif",
        &[],
    ),
    (
        "map",
        "figure-3 --x theta=-3:3:4000 --y theta_rate=-4:4:4000 --chunk 1000000 --threads 1 --out OUT/a.zarr \
         --out OUT/a.parquet --out OUT/a.png",
        &["a.parquet.parts", "a.zarr"],
    ),
];

/// How long a program may take to end: five seconds, and what a machine with other work adds.
const SOON: Duration = Duration::from_millis(9500);

/// Tests that keep a core busy for seconds wait for one another: the others watch the clock, too.
static BUSY: Mutex<()> = Mutex::new(());

#[test]
fn every_command_ends_soon_with_either_signal_and_leaves_nothing_unfinished() {
    let _alone = BUSY.lock();
    for (n, (command, words, left)) in LONG.into_iter().enumerate() {
        let folder = tempfile::tempdir().expect("a folder");
        let words = words.replace("OUT", folder.path().to_str().expect("a path"));
        let words: Vec<&str> = [command]
            .into_iter()
            .chain(words.split_whitespace())
            .collect();
        let mut child = littlewood(&words).spawn().expect("it runs");
        sleep(Duration::from_millis(700));
        assert!(
            child.try_wait().expect("a state").is_none(),
            "{command} is over before the signal"
        );
        let begun = Instant::now();
        signal(&child, if n % 2 == 0 { "-TERM" } else { "-INT" });
        let output = child.wait_with_output().expect("it ends");
        let took = begun.elapsed();
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{command}: {message}");
        assert!(took < SOON, "{command} took {took:?}");
        assert!(
            message.contains("stopped") && message.contains("hint:"),
            "{command}: {message}"
        );
        let mut found = names(folder.path());
        if command == "figures" {
            // Those that were done before stay, whole.
            for name in found.drain(..) {
                let bytes = fs::read(folder.path().join(&name)).expect("a picture");
                assert!(
                    name.ends_with(".png") && bytes.ends_with(b"IEND\xaeB`\x82"),
                    "{name}"
                );
            }
        }
        assert_eq!(found, left, "{command}");
        assert!(
            !tree(folder.path())
                .keys()
                .any(|name| name.ends_with("unfinished")),
            "{command}"
        );
    }
}

#[test]
fn figures_that_are_done_stay_when_the_rest_is_stopped() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("a path");
    // The second takes minutes.
    let words = format!("figures energy outcomes --case jam --format svg,csv --out {path}");
    let child = littlewood(&words.split(' ').collect::<Vec<_>>())
        .spawn()
        .expect("it runs");
    wait_until(|| folder.path().join("energy.csv").exists());
    signal(&child, "-INT");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    assert_eq!(names(folder.path()), ["energy.csv", "energy.svg"]);
    let drawing = fs::read_to_string(folder.path().join("energy.svg")).expect("a drawing");
    assert!(drawing.trim_end().ends_with("</svg>"));
}

/// The names in a folder, in their order.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> = entries
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}

#[test]
fn work_that_does_not_look_is_ended_all_the_same() {
    // A reader that does not read: the program waits for it for ever.
    for (signals, soonest) in [(1, 4900), (2, 0)] {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("pipe.png");
        assert!(
            Command::new("mkfifo")
                .arg(&pipe)
                .status()
                .expect("mkfifo runs")
                .success()
        );
        // More than a pipe holds.
        let plane = "map figure-3 --x theta=-3:3:300 --y theta_rate=-4:4:300 --shade lift_off_time --size 2000x2000";
        let mut child = littlewood(&plane.split_whitespace().collect::<Vec<_>>())
            .arg("--out")
            .arg(&pipe)
            .spawn()
            .expect("it runs");
        let mut reader = fs::File::open(&pipe).expect("a pipe");
        reader.read_exact(&mut [0]).expect("the picture begins");
        sleep(Duration::from_millis(100));
        assert!(child.try_wait().expect("a state").is_none());
        let begun = Instant::now();
        for _ in 0..signals {
            signal(&child, "-TERM");
            sleep(Duration::from_millis(50));
        }
        let output = child.wait_with_output().expect("it ends");
        let took = begun.elapsed();
        drop(reader);
        assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
        assert!(
            text(&output.stderr).contains("stopped"),
            "{}",
            text(&output.stderr)
        );
        assert!(
            Duration::from_millis(soonest) < took && took < SOON,
            "{signals}: {took:?}"
        );
    }
}

/// Runs the program on a terminal of its own, until Ctrl-C comes after some seconds.
#[cfg(target_os = "linux")]
fn on_a_terminal(seconds: &str, words: &str) -> String {
    let path = std::env::var("PATH").expect("programs");
    on_a_terminal_with(&path, seconds, words)
}

/// The same, with programs from these folders.
#[cfg(target_os = "linux")]
fn on_a_terminal_with(path: &str, seconds: &str, words: &str) -> String {
    let program = env!("CARGO_BIN_EXE_littlewood");
    let command = format!("stty cols 120; timeout --foreground -s INT {seconds} {program} {words}");
    let mut script = Command::new("script");
    let script = script
        .args(["-qec", &command, "/dev/null"])
        .env("TERM", "xterm")
        .env("PATH", path)
        .stdin(Stdio::null());
    text(&script.output().expect("it runs").stdout)
}

#[cfg(target_os = "linux")]
#[test]
fn progress_is_shown_on_a_terminal() {
    let _alone = BUSY.lock();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("a path");
    // Motions of a second and more, told of before the first of them is in a finished chunk.
    let plane =
        "map figure-3 --x theta=-3:3:4000 --y theta_rate=-4:4:4000 --chunk 1000000 --threads 1";
    for (words, unit, name) in [
        (
            format!("{plane} --out {path}/a.png"),
            "of 16,000,000 starts",
            "",
        ),
        (
            format!("figures --scale 16 --format png --out {path}"),
            "figures",
            "figure-",
        ),
        (
            format!("animate figure-3 --size 4096x4096 --out {path}/film.gif"),
            "frames",
            "",
        ),
    ] {
        let shown = on_a_terminal("3", &words);
        for word in ["%", unit, "/s", " left", "stopped", name] {
            assert!(shown.contains(word), "no {word:?} in {shown}");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_has_no_known_end_moves_all_the_same() {
    use std::os::unix::fs::PermissionsExt as _;
    let _alone = BUSY.lock();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("a path");
    // The end of a film that another program writes.
    let slow = folder.path().join("ffmpeg");
    fs::write(&slow, "#!/bin/sh\ncat >/dev/null\nsleep 4\n").expect("a program");
    fs::set_permissions(&slow, fs::Permissions::from_mode(0o755)).expect("it is ours");
    let others = std::env::var("PATH").expect("programs");
    let film = format!("animate figure-3 --size 160x160 --out {path}/film.mp4");
    let shown = on_a_terminal_with(&format!("{path}:{others}"), "60", &film);
    assert!(shown.contains("ffmpeg finishes the film"), "{shown}");
    // The boundaries of a picture, from a grid that is computed at once.
    let map = "map figure-3 --x theta=-3:3:15 --y theta_rate=-4:4:15 --mu-s 1e-4 --mu-k 1e-4";
    let shown = on_a_terminal("8", &format!("{map} --threads 1 --out {path}/map.svg"));
    assert!(shown.contains("starts along the boundaries"), "{shown}");
}

#[cfg(target_os = "linux")]
#[test]
fn short_work_and_pipes_have_no_bar() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("a path");
    let plane = "map figure-3 --x theta=-3:3:40 --y theta_rate=-4:4:40 --out";
    let shown = on_a_terminal("60", &format!("{plane} {path}/a.zarr"));
    assert!(
        shown.contains("Written") && !shown.contains(" left"),
        "{shown}"
    );
    // Into a pipe nothing but the result is written, however long it takes.
    let out = folder.path().join("b.zarr");
    assert_eq!(text(&succeed(&mut map(&[&out], &[])).stderr), "");
}
