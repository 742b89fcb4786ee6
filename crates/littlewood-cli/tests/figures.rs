//! `littlewood figures`: what it writes, what it leaves out, what it refuses.

use std::fs;
use std::path::Path;

use littlewood::cases::CASES;
use littlewood_figures::FIGURES;

use crate::support::{littlewood, text};

/// Names of the files in a folder.
fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("a folder")
        .map(|file| {
            file.expect("a file")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}

/// What a run prints that leaves figures out, and what it says of them.
fn printed_and_left_out(arguments: &[&str]) -> [String; 2] {
    let assert = littlewood().args(arguments).assert().success();
    let output = assert.get_output();
    [&output.stdout, &output.stderr]
        .map(|bytes| String::from_utf8(bytes.clone()).expect("the output is UTF-8"))
}

/// The complaint of a run that is refused, with exit code 2.
fn refusal(arguments: &[&str]) -> String {
    let output = littlewood()
        .args(arguments)
        .assert()
        .code(2)
        .stdout("")
        .get_output()
        .stderr
        .clone();
    String::from_utf8(output).expect("the output is UTF-8")
}

#[test]
fn a_figure_is_written_as_drawing_picture_data_and_caption() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("figures");
    let printed = text(&[
        "figures",
        "figure-3b",
        "figure-1",
        "--out",
        out.to_str().expect("UTF-8"),
    ]);
    let wanted: Vec<String> = ["figure-1", "figure-3b"]
        .iter()
        .flat_map(|name| {
            ["csv", "pdf", "png", "svg", "txt"].map(|ending| format!("{name}.{ending}"))
        })
        .collect();
    assert_eq!(files(&out), wanted);
    for name in &wanted {
        assert!(printed.contains(name.as_str()), "{printed}");
    }
    let drawn = fs::read(out.join("figure-3b.svg")).expect("a drawing");
    let gallery = [
        env!("CARGO_MANIFEST_DIR"),
        "..",
        "..",
        "docs",
        "gallery",
        "figure-3b.svg",
    ];
    let committed = fs::read(gallery.iter().collect::<std::path::PathBuf>()).expect("the gallery");
    assert!(drawn == committed, "the drawing of the gallery");
    let caption = fs::read_to_string(out.join("figure-3b.txt")).expect("a caption");
    assert!(
        caption.starts_with("Figure 3(b)") && caption.contains("μₛ = 0.5"),
        "{caption}"
    );
    let data = fs::read_to_string(out.join("figure-3b.csv")).expect("data");
    assert!(data.starts_with("panel,series,piece,"));
}

#[test]
fn without_names_a_hoop_has_all_figures_that_can_show_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let [printed, left_out] = printed_and_left_out(&[
        "figures",
        "--out",
        out,
        "--format",
        "txt",
        "--mass-ratio",
        "2",
    ]);
    let massless = "left out figure-4, figure-5a, figure-5b, figure-6a, figure-6b, figure-7a, figure-7b (shows the massless hoop";
    assert!(left_out.contains(massless), "{left_out}");
    let found = files(folder.path());
    assert_eq!(printed.lines().count(), found.len());
    assert!(
        found.contains(&"figure-2a.txt".to_owned()) && found.contains(&"forces.txt".to_owned())
    );
    assert!(!found.iter().any(|name| name.starts_with("figure-4")));
    let caption = fs::read_to_string(folder.path().join("figure-2b.txt")).expect("a caption");
    assert!(caption.contains("m₁/m₂ = 2,"), "{caption}");
}

#[test]
fn a_figure_that_cannot_show_the_hoop_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let message = refusal(&[
        "figures",
        "figure-1",
        "figure-4",
        "--mass-ratio",
        "2",
        "--out",
        out,
    ]);
    assert!(
        message.contains("mass ratio 2") && message.contains("--mass-ratio 0"),
        "{message}"
    );
    assert_eq!(files(folder.path()), Vec::<String>::new());
}

#[test]
fn bad_input_for_a_figure_that_takes_long_is_known_before_any_is_written() {
    for words in [
        "energy outcomes --offset 0",
        "figure-1 outcomes --width-mm 10",
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().join("figures");
        let mut arguments = vec!["figures", "--out", out.to_str().expect("UTF-8")];
        arguments.extend(words.split(' '));
        refusal(&arguments);
        assert!(!out.exists(), "{words}");
    }
}

#[test]
fn on_a_slope_the_figures_of_a_level_plane_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let figures = ["figures", "--slope", "0.1", "--out", out, "--format", "txt"];
    let [_, left_out] = printed_and_left_out(&figures);
    assert!(
        left_out.starts_with("left out ") && left_out.contains("shows a level plane"),
        "{left_out}"
    );
    let found = files(folder.path());
    assert!(
        found.contains(&"energy.txt".to_owned()) && !found.contains(&"figure-4.txt".to_owned())
    );
    // By its name it is refused.
    let message = refusal(&[&["figures", "figure-4"], &figures[1..]].concat());
    assert!(message.contains("shows a level plane"), "{message}");
}

#[test]
fn names_are_listed_and_unknown_ones_refused() {
    let list = text(&["figures", "--list"]);
    for name in [
        "figure-1",
        "figure-2a",
        "figure-7b",
        "forces",
        "energy",
        "outcomes",
    ] {
        assert!(list.lines().any(|line| line.starts_with(name)), "{list}");
    }
    let message = refusal(&["figures", "3b", "--out", "unused"]);
    assert!(message.contains("did you mean 'figure-3b'"), "{message}");
    assert!(!Path::new("unused").exists());
}

#[test]
fn figures_that_were_removed_are_named_with_what_serves_instead() {
    for (words, name, instead) in [
        ("wall figure-1", "wall", "figure-3a"),
        ("cases", "cases", "littlewood cases"),
        ("atlas", "atlas", "stroboscope"),
        ("friction-demand", "friction-demand", "forces"),
        ("hodograph", "hodograph", "forces"),
        ("inertia", "inertia", "figure-7a"),
        ("paper", "paper", "figure-6a"),
        ("bifurcation", "bifurcation", "littlewood sweep"),
        ("--along mu=0.1:1", "bifurcation", "littlewood sweep"),
    ] {
        let mut arguments = vec!["figures", "--out", "unused"];
        arguments.extend(words.split(' '));
        let message = refusal(&arguments);
        let wanted = format!("the figure '{name}' was removed");
        assert!(
            message.contains(&wanted) && message.contains(instead),
            "{message}"
        );
        assert!(!Path::new("unused").exists());
    }
}

#[test]
fn bad_values_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "kept").expect("a file");
    let out = folder.path().to_str().expect("UTF-8");
    for (arguments, words) in [
        (
            vec!["figures", "figure-1", "--scale", "nan", "--out", out],
            "scale is NaN",
        ),
        (
            vec!["figures", "figure-1", "--scale", "100", "--out", out],
            "from 0.25 to 16",
        ),
        (
            vec!["figures", "figure-2a", "--mu-k", "0.9", "--out", out],
            "0.9",
        ),
        (
            vec!["figures", "figure-2a", "--case", "figure-33", "--out", out],
            "figure-33",
        ),
        (
            vec![
                "figures",
                "figure-1",
                "--out",
                file.to_str().expect("UTF-8"),
            ],
            "not a folder",
        ),
        (vec!["figures", "figure-1"], "--out"),
    ] {
        let message = refusal(&arguments);
        assert!(message.contains(words), "{message}");
    }
    assert_eq!(fs::read_to_string(&file).expect("a file"), "kept");
    assert_eq!(files(folder.path()), ["file"]);
}

#[test]
fn the_figure_of_an_impact_shows_the_one_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let caption = |flags: &[&str]| {
        text(
            &[
                &["figures", "impact", "--out", out, "--format", "txt"],
                flags,
            ]
            .concat(),
        );
        fs::read_to_string(folder.path().join("impact.txt")).expect("a caption")
    };
    assert!(caption(&[]).contains("Impact 1 of the motion, at τ = 3.8474"));
    assert!(caption(&["--impact", "2"]).contains("Impact 2 of the motion, at τ = 5.4208"));
    let newton = [
        "--case",
        "figure-3",
        "--restitution",
        "0.7",
        "--restitution-law",
        "newton",
    ];
    assert!(caption(&newton).contains("velocities (Newton)"));
    for (flags, words) in [
        (&["--impact", "0"][..], "the first impact is 1"),
        (&["--impact", "1.5"], "not a whole number"),
        (&["--impact", "99"], "1 to 26"),
        (&["--case", "figure-3"], "--restitution from 0 to 1"),
        (
            &["--case", "figure-3", "--restitution", "0.5", "--until", "3"],
            "the motion has none",
        ),
    ] {
        let message = refusal(&[&["figures", "impact", "--out", out], flags].concat());
        assert!(message.contains(words), "{flags:?}: {message}");
    }
}

#[test]
fn without_restitution_the_figures_of_impacts_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let [_, printed] = printed_and_left_out(&[
        "figures", "--case", "figure-3", "--out", out, "--format", "txt",
    ]);
    // The one of each also says what else it lacks.
    assert!(
        printed.contains(", impact, bounces (shows what follows a landing"),
        "{printed}"
    );
}

#[test]
#[ignore = "thorough"]
fn every_named_motion_has_figures_and_a_line_tells_what_is_left_out() {
    let names = CASES.iter().map(|case| case.name).chain(["libration"]);
    for name in names {
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().to_str().expect("UTF-8");
        let [written, printed] = printed_and_left_out(&[
            "figures", "--case", name, "--until", "20", "--out", out, "--format", "txt",
        ]);
        let written: Vec<&str> = written.lines().collect();
        let left_out: Vec<&str> = printed.lines().collect();
        assert_eq!(written.len(), files(folder.path()).len(), "{name}");
        assert!(written.len() > 4, "{name}: {printed}");
        assert_eq!(left_out.len(), 1, "{name}: {printed}");
        // Names, and reasons in brackets.
        let names = left_out[0]
            .trim_start_matches("left out ")
            .split('(')
            .map(|part| part.rsplit(')').next());
        let missing: Vec<&str> = names
            .flatten()
            .flat_map(|part| part.split(", "))
            .map(str::trim)
            .collect();
        let about_all = FIGURES.iter().all(|entry| {
            folder.path().join(format!("{}.txt", entry.name)).exists()
                != missing.contains(&entry.name)
        });
        assert!(about_all, "{name}: {printed}");
    }
}

#[test]
fn a_short_name_means_the_same_motion_everywhere() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let energy = |case: &str| {
        text(&[
            "figures", "energy", "--case", case, "--out", out, "--format", "csv",
        ]);
        fs::read(folder.path().join("energy.csv")).expect("data")
    };
    assert_eq!(energy("libration"), energy("figure-2-libration"));
    assert_eq!(
        text(&["simulate", "libration"]),
        text(&["simulate", "figure-2-libration"])
    );
}

#[test]
fn a_balanced_hoop_has_the_figures_that_do_not_need_its_angle() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let [_, printed] =
        printed_and_left_out(&["figures", "--offset", "0", "--out", out, "--format", "txt"]);
    // Without mass the particle has to be off the centre: no hoop of these figures can have the
    // offset 0.
    assert!(
        printed.contains("figure-4, ")
            && printed.contains("its own hoop, of the case figure-7, cannot have this"),
        "{printed}"
    );
    assert!(
        files(folder.path()).contains(&"forces.txt".to_owned()),
        "{printed}"
    );
}
