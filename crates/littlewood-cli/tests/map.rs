//! `littlewood map`, `sweep` and `atlas`.

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use support::{complaint, json, littlewood, number, text};

/// The hoop of Figure 2.
const FIGURE_2: [&str; 10] =
    ["--mass-ratio", "1", "--offset", "1", "--inertia", "1", "--mu-s", "0.5", "--mu-k", "0.4"];

const PLANE: [&str; 4] = ["--x", "theta=-pi:pi:200", "--y", "theta_rate=-4:4:200"];

const SMALL: [&str; 4] = ["--x", "theta=-pi:pi:21", "--y", "theta_rate=-4:4:31"];

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn path(folder: &tempfile::TempDir, name: &str) -> String {
    folder.path().join(name).to_string_lossy().into_owned()
}

/// Every file under a folder with its bytes.
fn tree(root: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(root).expect("inside").to_string_lossy().into_owned();
                files.insert(name, fs::read(&path).expect("a file"));
            }
        }
    }
    files
}

#[test]
fn the_plane_of_figure_2_has_the_known_counts() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    let found = json(&[&["map"], &FIGURE_2[..], &PLANE, &["--until", "50", "--out", &out]].concat());
    let counts = found["counts"].as_object().expect("counts");
    let count = |name: &str| counts.get(name).map_or(0, |count| count.as_u64().expect("a count"));
    assert_eq!(count("leaves_at_once"), 9_784);
    assert_eq!(count("lifts_off_later"), 12_690);
    let contact = ["rolls_for_ever", "slides_for_ever", "in_contact_at_the_limit"];
    assert_eq!(contact.map(count).iter().sum::<u64>(), 17_526);
    assert_eq!(number(&found["points"]), 40_000.0);
    assert_eq!(found["complete"], true);
    assert!(folder.path().join("plane.zarr/zarr.json").exists());
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let folder = folder();
    for (name, command, axes) in [
        ("a.zarr", "map", SMALL),
        ("b.parquet", "sweep", ["--axis", "theta=-pi:pi:21", "--axis", "theta_rate=-4:4:31"]),
    ] {
        let [one, two] = ["1", "2"].map(|threads| {
            let out = path(&folder, &format!("{threads}-{name}"));
            let work = ["--threads", threads, "--chunk", "100", "--out", &out];
            text(&[&[command], &FIGURE_2[..], &axes, &work].concat());
            tree(Path::new(&out))
        });
        assert!(one.len() > 7);
        assert!(one == two, "{name} differs");
    }
}

#[test]
fn only_the_same_run_is_resumed() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    let arguments = |more: &[&'static str]| -> Vec<String> {
        let all = [&["map", "figure-3"], &SMALL[..], &["--out"], more].concat();
        all.iter().map(|&word| word.to_owned()).collect()
    };
    let run = |more: &[&'static str]| {
        let mut words = arguments(more);
        let place = words.iter().position(|word| word == "--out").expect("--out");
        words.insert(place + 1, out.clone());
        words
    };
    littlewood().args(run(&["--chunk", "100"])).assert().success();
    let before = tree(Path::new(&out));

    let refused = |more: &[&'static str]| {
        let words = run(more);
        complaint(&words.iter().map(String::as_str).collect::<Vec<_>>(), 2)
    };
    assert!(refused(&["--chunk", "100"]).contains("hint: it is finished"));
    let message = refused(&["--chunk", "100", "--mu-k", "0.3", "--resume"]);
    assert!(message.contains("other parameters") && message.contains("0.3"), "{message}");
    assert!(message.contains("hint:"), "{message}");
    assert!(tree(Path::new(&out)) == before);

    // What has been lost is made again.
    let lost = before.keys().find(|name| name.contains("outcome/c/")).expect("a chunk");
    fs::remove_file(Path::new(&out).join(lost)).expect("removed");
    littlewood().args(run(&["--chunk", "100", "--resume"])).assert().success();
    assert!(tree(Path::new(&out)) == before);
}

#[test]
fn bad_axes_are_refused_with_value_and_hint() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    for (axis, said) in [
        ("theta=-pi:pi:0", "0 points"),
        ("theta=-pi:pi", "NAME=FROM:TO:COUNT"),
        ("theta=left:pi:3", "left"),
        ("theta=nan:1:3", "NaN"),
        ("theta=0:inf:3", "inf"),
        ("phi=0:1:3", "phi"),
        ("theta=1:1:3", "all the same"),
        ("theta_rate=0:1:3", "twice"),
        ("mu_s=-1:1:3", "-1"),
        ("mu_s=0.1:1:3", "0.1"),
        ("offset=0:2:3", "2"),
    ] {
        let y = "theta_rate=-4:4:31";
        let message = complaint(&["map", "figure-3", "--x", axis, "--y", y, "--out", &out], 2);
        assert!(message.contains(said) && message.contains("hint:"), "{axis}: {message}");
        assert!(!Path::new(&out).exists());
    }
}

#[test]
fn other_bad_input_is_refused() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    let refused = |more: &[&str]| complaint(&[&["map"], &SMALL[..], more].concat(), 2);
    assert!(refused(&["--out", &out]).contains("missing: mass_ratio"));
    assert!(refused(&["figure-3", "--mu-s", "nan", "--out", &out]).contains("NaN"));
    assert!(refused(&["figure-3", "--out", &path(&folder, "plane.nc")]).contains(".zarr or .parquet"));
    let png = path(&folder, "plane.png");
    assert!(refused(&["figure-3", "--out", &png, "--shade", "beauty"]).contains("jump_length"));
    assert!(refused(&["figure-3", "--out", &png, "--size", "10x10"]).contains("10 x 10"));
    assert!(refused(&["figure-3", "--out", &png, "--threads", "0"]).contains("--threads"));
    assert!(refused(&["figure-3", "--out", &png, "--until", "-1"]).contains("hint:"));
    assert!(fs::read_dir(folder.path()).expect("a folder").next().is_none());
}

#[test]
fn a_place_without_room_for_a_store_is_named() {
    let folder = folder();
    let file = path(&folder, "file");
    fs::write(&file, "").expect("written");
    let sweep =
        |out: &str, code| complaint(&["sweep", "figure-3", "--axis", "theta=0:1:3", "--out", out], code);
    let below = format!("{file}/plane.parquet");
    assert!(sweep(&below, 2).contains(&below));
    #[cfg(target_os = "linux")]
    assert!(sweep("/proc/plane.zarr", 1).contains("cannot write /proc/plane.zarr"));
}

#[test]
fn a_picture_has_the_size_that_is_asked_for() {
    let folder = folder();
    let out = path(&folder, "plane.png");
    for shade in ["outcome", "lift_off_time"] {
        let found = json(
            &[&["map", "figure-3"], &SMALL[..], &["--out", &out, "--size", "600x400", "--shade", shade]]
                .concat(),
        );
        assert_eq!(number(&found["computed"]), 651.0);
        let bytes = fs::read(&out).expect("a picture");
        assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
        let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
        assert_eq!((side(16), side(20)), (600, 400));
    }
    // Drawn from a store beside it, it is the same.
    let (zarr, again) = (path(&folder, "plane.zarr"), path(&folder, "again.png"));
    let more = ["--out", &again, "--out", &zarr, "--size", "600x400", "--shade", "lift_off_time"];
    text(&[&["map", "figure-3"], &SMALL[..], &more].concat());
    assert!(fs::read(&out).expect("a picture") == fs::read(&again).expect("a picture"));
}

#[test]
fn a_list_of_starts_is_followed() {
    let folder = folder();
    let starts = path(&folder, "starts.csv");
    fs::write(&starts, "theta,theta_rate\n1.5707963267948966,2\n0,1\n0,3\n").expect("written");
    let out = path(&folder, "starts.parquet");
    let sweep = |starts: &str, out: &str| {
        [&["sweep"], &FIGURE_2[..], &["--starts", starts, "--out", out]].concat().join("\n")
    };
    let words = sweep(&starts, &out);
    let found = json(&words.split('\n').collect::<Vec<_>>());
    assert_eq!(number(&found["done"]), 3.0);
    let first = fs::read(Path::new(&out).join("part-00000.parquet")).expect("a table");
    assert_eq!(first[..4], *b"PAR1");

    // A bad cell is named by its line.
    fs::write(&starts, "theta,theta_rate\n1,2\n0,fast\n").expect("written");
    let words = sweep(&starts, &path(&folder, "other.parquet"));
    let message = complaint(&words.split('\n').collect::<Vec<_>>(), 2);
    assert!(message.contains("line 3") && message.contains("fast") && message.contains("hint:"), "{message}");
    let words = sweep(&starts, &path(&folder, "other.zarr"));
    assert!(complaint(&words.split('\n').collect::<Vec<_>>(), 2).contains(".parquet"));
}

#[test]
fn two_axes_that_contradict_each_other_leave_gaps() {
    let folder = folder();
    let out = path(&folder, "friction.zarr");
    let axes = ["--x", "mu_k=0:1:11", "--y", "mu_s=0.5:1:6"];
    let found = json(&[&["map", "figure-3"], &axes[..], &["--out", &out]].concat());
    assert_eq!(number(&found["counts"]["not_a_hoop"]), 15.0);
}

#[test]
fn an_atlas_counts_every_point_once() {
    let total = |found: &serde_json::Value| {
        let sequences = found["sequences"].as_array().expect("sequences");
        sequences.iter().map(|entry| number(&entry["count"])).sum::<f64>() + number(&found["invalid"])
    };
    let axes = ["--axis", "theta=-pi:pi:40", "--axis", "theta_rate=-4:4:30"];
    let found = json(&[&["atlas", "figure-3"], &axes[..]].concat());
    assert_eq!((total(&found), number(&found["points"])), (1200.0, 1200.0));
    let turns = ["--first-turn", "--axis", "theta_rate=0.1:2:20", "--axis", "mu_s=0.1:2:20"];
    let found = json(&[&["atlas", "figure-3"], &turns[..]].concat());
    assert_eq!(total(&found), 400.0);
    let first = &found["sequences"][0];
    assert!(first["stop"].is_string());
    assert_eq!(first["example"]["theta"], 0.0);
    assert_eq!(first["example"]["mu_s"], first["example"]["mu_k"]);
    assert!(text(&[&["atlas", "figure-3"], &axes[..]].concat()).contains("kinds on 1,200 starts"));
}
