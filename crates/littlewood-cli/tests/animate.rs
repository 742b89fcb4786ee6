//! `littlewood animate`: files, bad values, and what is left where a film is not finished.

use crate::support;
use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::process::{Command, Stdio};

use crate::support::{complaint, littlewood, text};
use tempfile::TempDir;

const PRECIOUS: &str = "years of work";

const SMALL: [&str; 6] = ["--size", "160x160", "--fps", "5", "--slow", "1"];

fn path(folder: &TempDir, name: &str) -> String {
    folder
        .path()
        .join(name)
        .to_str()
        .expect("it works in a folder for tests")
        .to_owned()
}

fn animate(motion: &[&str], out: &str) {
    let said = text(&[&["animate"], motion, &SMALL, &["--out", out]].concat());
    // A motion without end is shown in part.
    assert!(
        said.is_empty() || said.starts_with("The film shows "),
        "{said}"
    );
}

fn refused(flags: &[&str], code: i32) -> String {
    let folder = TempDir::new().expect("it works in a folder for tests");
    let out = path(&folder, "film.gif");
    let message = complaint(
        &[&["animate", "figure-3", "--out", &out], flags].concat(),
        code,
    );
    assert_eq!(
        fs::read_dir(folder.path())
            .expect("it works in a folder for tests")
            .count(),
        0,
        "{message}"
    );
    message
}

#[test]
fn the_three_films_of_the_paper_are_made_by_name_and_are_the_same_every_time() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.gif");
    for name in ["figure-3", "figure-7", "libration"] {
        animate(&[name], &out);
        let first = fs::read(&out).unwrap();
        assert!(first.starts_with(b"GIF89a") && first.ends_with(b";"));
        animate(&[name], &out);
        assert!(fs::read(&out).unwrap() == first);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn the_ending_says_what_the_film_is() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "a.GIF");
    animate(&["figure-3", "--until", "1"], &out);
    assert!(fs::read(&out).unwrap().starts_with(b"GIF89a"));
    let out = path(&folder, "a.png");
    animate(&["figure-3", "--until", "1"], &out);
    assert!(fs::read(&out).unwrap().starts_with(b"\x89PNG"));
    for name in ["film", "film.avi", "film.APNG"] {
        let out = path(&folder, name);
        let message = complaint(&["animate", "figure-3", "--out", &out], 2);
        assert!(
            message.contains("hint: names end in .gif or .mp4 or .webm or .png"),
            "{message}"
        );
    }
}

#[test]
fn two_motions_run_beside_each_other() {
    let folder = TempDir::new().unwrap();
    let scenario = path(&folder, "second.toml");
    fs::write(&scenario, "case = 'figure-3'\n[hoop]\nmu_k = 0.3\n").unwrap();
    let out = path(&folder, "film.gif");
    for other in ["figure-7", &scenario] {
        let flags = [
            "--beside", other, "--fps", "5", "--slow", "1", "--out", &out,
        ];
        text(&[&["animate", "figure-3"][..], &flags].concat());
        // Width and height of a GIF.
        assert_eq!(fs::read(&out).unwrap()[6..10], [0x80, 0x02, 0x58, 0x02]);
    }
    assert!(refused(&["--beside", "figure-33"], 2).contains("did you mean 'figure-3'"));
    let message = refused(&["--beside", "figure-7", "--size", "640x300"], 2);
    assert!(
        message.contains("two hoops need a height of 320"),
        "{message}"
    );
    // In SI units both, or none.
    let si = "[si.hoop]\nparticle_mass_kg = 0.1\nradius_m = 0.4\n";
    fs::write(&scenario, format!("case = 'figure-3'\n{si}")).unwrap();
    let message = refused(&["--beside", &scenario], 2);
    assert!(
        message.contains("one of the motions is in SI units"),
        "{message}"
    );
    let flags = [
        "--particle-mass-kg",
        "0.2",
        "--radius-m",
        "0.3",
        "--fps",
        "5",
        "--slow",
        "1",
    ];
    for other in ["figure-7", &scenario] {
        text(
            &[
                &["animate", "figure-3", "--beside", other, "--out", &out],
                &flags[..],
            ]
            .concat(),
        );
    }
}

#[test]
fn parameters_and_si_units_work_as_in_simulate() {
    let folder = TempDir::new().unwrap();
    let [a, b, c] = ["a.gif", "b.gif", "c.gif"].map(|name| path(&folder, name));
    animate(&["figure-3"], &a);
    animate(&support::FIGURE_3, &b);
    assert!(fs::read(&a).unwrap() == fs::read(&b).unwrap());
    // The time unit is ½ s: two seconds of film for one of the motion, and values in SI units.
    let si = [
        "figure-3",
        "--particle-mass-kg",
        "2",
        "--radius-m",
        "1",
        "--gravity-m-per-s2",
        "4",
        "--slow",
        "2",
    ];
    text(&[&["animate"], &si[..], &SMALL[..4], &["--out", &c]].concat());
    assert!(
        fs::read(&c).unwrap().starts_with(b"GIF89a")
            && fs::read(&a).unwrap() != fs::read(&c).unwrap()
    );
}

#[test]
fn bad_values_are_refused_with_a_bound_and_a_hint() {
    for (flags, message) in [
        (&["--fps", "0"][..], "fps = 0 must be between 1 and 240"),
        (
            &["--fps", "60"],
            "fps = 60 must be between 1 and 50 frames per second in GIF",
        ),
        (
            &["--size", "0x0"],
            "size = 0x0 px: both sides must be between 160 and 4096 px",
        ),
        (&["--size", "100000x100000"], "size = 100000x100000 px"),
        (
            &["--slow", "nan"],
            "slow = NaN must be a finite number greater than 0",
        ),
        (
            &["--slow", "0"],
            "slow = 0 must be a finite number greater than 0",
        ),
        (&["--slow", "-1"], "slow = -1 must be"),
        (&["--slow", "1e9"], "the most is 100000"),
        (
            &["--hold", "100"],
            "hold = 100 s must be between 0 and 60 s",
        ),
        (&["--until", "nan"], "until = NaN"),
        (&["--mu-k", "0.9"], "mu_k = 0.9 must not exceed mu_s"),
    ] {
        let found = refused(flags, 2);
        assert!(
            found.contains(message) && found.contains("hint: "),
            "{message} is not in\n{found}"
        );
    }
    assert!(refused(&["--size", "big"], 2).contains("WIDTHxHEIGHT"));
    let folder = TempDir::new().unwrap();
    let message = complaint(
        &["animate", "painleve", "--out", &path(&folder, "film.gif")],
        2,
    );
    assert!(
        message.contains("there is no motion to show: no motion is consistent"),
        "{message}"
    );
    let message = complaint(
        &["animate", "figure-33", "--out", &path(&folder, "film.gif")],
        2,
    );
    assert!(message.contains("did you mean 'figure-3'"), "{message}");
}

#[test]
fn a_folder_that_is_not_there_is_refused() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "nowhere/film.gif");
    let message = complaint(&["animate", "figure-3", "--out", &out], 2);
    assert!(message.starts_with("error: cannot write to "), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_of_the_system() {
    let folder = TempDir::new().unwrap();
    let link = folder.path().join("film.gif");
    std::os::unix::fs::symlink("/dev/full", &link).unwrap();
    let message = complaint(
        &[
            &["animate", "figure-3"],
            &SMALL[..],
            &["--out", link.to_str().unwrap()],
        ]
        .concat(),
        1,
    );
    assert!(message.contains("failed"), "{message}");
}

#[test]
fn an_mp4_without_ffmpeg_says_what_to_install_and_touches_nothing() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.mp4");
    fs::write(&out, PRECIOUS).unwrap();
    let mut program = littlewood();
    let output = program
        .env("PATH", folder.path())
        .args(["animate", "figure-3", "--out", &out])
        .assert()
        .code(1);
    let message = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(
        message.contains("needs ffmpeg") && message.contains("hint: install ffmpeg"),
        "{message}"
    );
    assert_eq!(fs::read_to_string(&out).unwrap(), PRECIOUS);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
fn stand_in(folder: &Path, script: &str) -> std::ffi::OsString {
    use std::os::unix::fs::PermissionsExt as _;
    let bin = folder.join("bin");
    fs::create_dir(&bin).expect("it works in a folder for tests");
    fs::write(bin.join("ffmpeg"), format!("#!/bin/sh\n{script}\n"))
        .expect("it works in a folder for tests");
    fs::set_permissions(bin.join("ffmpeg"), fs::Permissions::from_mode(0o755))
        .expect("it works in a folder for tests");
    let mut path = bin.into_os_string();
    path.push(":");
    path.push(std::env::var_os("PATH").unwrap_or_default());
    path
}

#[cfg(unix)]
#[test]
fn an_mp4_is_what_ffmpeg_has_written_or_nothing() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.mp4");
    let found = stand_in(folder.path(), "for last; do :; done; wc -c > \"$last\"");
    littlewood()
        .env("PATH", found)
        .args([&["animate", "figure-3", "--out", &out], &SMALL[..]].concat())
        .assert()
        .success();
    // ⌈3.847 × 5⌉ + 1 frames, the last repeated for 1.5 s.
    let bytes: usize = fs::read_to_string(&out).unwrap().trim().parse().unwrap();
    assert_eq!(bytes, 160 * 160 * 4 * (21 + 8));

    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.mp4");
    let found = stand_in(
        folder.path(),
        "cat > /dev/null; echo 'No space left on device' >&2; exit 1",
    );
    let output = littlewood()
        .env("PATH", found)
        .args([&["animate", "figure-3", "--out", &out], &SMALL[..]].concat())
        .assert()
        .code(1);
    let message = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(message.contains("No space left on device"), "{message}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_no_half_a_film() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.gif");
    let mut child = Command::new(env!("CARGO_BIN_EXE_littlewood"))
        .args(["animate", "figure-3", "--slow", "500", "--out", &out])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Until the film has begun.
    while fs::read_dir(folder.path())
        .unwrap()
        .flatten()
        .all(|file| file.metadata().map_or(0, |it| it.len()) == 0)
    {
        assert!(
            child.try_wait().unwrap().is_none(),
            "it has ended by itself"
        );
        std::thread::yield_now();
    }
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(killed.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    assert!(
        String::from_utf8(output.stderr)
            .unwrap()
            .starts_with("error: stopped after ")
    );
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_second_picture_runs_along_and_a_motion_without_end_is_cut() {
    let folder = TempDir::new().unwrap();
    let out = path(&folder, "film.gif");
    let mut films = Vec::new();
    for with in [
        &[][..],
        &["--with", "plane"],
        &["--with", "friction"],
        &["--with", "energy"],
    ] {
        animate(&[&["figure-3"], with].concat(), &out);
        films.push(fs::read(&out).unwrap());
        assert!(
            films[..films.len() - 1]
                .iter()
                .all(|other| other != &films[films.len() - 1]),
            "{with:?}"
        );
    }
    assert!(refused(&["--with", "beauty"], 2).contains("plane"));
    let said = text(&[&["animate", "libration"], &SMALL[..], &["--out", &out]].concat());
    assert!(
        said.contains("one period of a motion without end (rolls for ever)"),
        "{said}"
    );
}
