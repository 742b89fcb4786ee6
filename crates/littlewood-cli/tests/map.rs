//! `littlewood map` and `sweep`.

use std::f64::consts::FRAC_PI_2;
use std::fs;
use std::path::Path;

use crate::support::csv::Csv;
use crate::support::table::Table;
use crate::support::{
    FIGURE_3_EVENTS, assert_close, complaint, json, littlewood, number, text, tree,
};

/// The hoop of Figure 2.
const FIGURE_2: [&str; 10] = [
    "--mass-ratio",
    "1",
    "--offset",
    "1",
    "--inertia",
    "1",
    "--mu-s",
    "0.5",
    "--mu-k",
    "0.4",
];

const PLANE: [&str; 4] = ["--x", "theta=-pi:pi:200", "--y", "theta_rate=-4:4:200"];

const SMALL: [&str; 4] = ["--x", "theta=-pi:pi:21", "--y", "theta_rate=-4:4:31"];

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn path(folder: &tempfile::TempDir, name: &str) -> String {
    folder.path().join(name).to_string_lossy().into_owned()
}

#[test]
fn the_plane_of_figure_2_has_the_known_counts() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    let found = json(
        &[
            &["map"],
            &FIGURE_2[..],
            &PLANE,
            &["--until", "50", "--out", &out],
        ]
        .concat(),
    );
    let counts = found["counts"].as_object().expect("counts");
    let count = |name: &str| {
        counts
            .get(name)
            .map_or(0, |count| count.as_u64().expect("a count"))
    };
    assert_eq!(count("leaves_at_once"), 9_784);
    assert_eq!(count("lifts_off_later"), 12_690);
    let contact = [
        "rolls_forever",
        "repeats_forever",
        "slips_forever",
        "in_contact",
    ];
    assert_eq!(contact.map(count).iter().sum::<u64>(), 17_526);
    assert_eq!(number(&found["points"]), 40_000.0);
    assert_eq!(found["complete"], true);
    assert!(folder.path().join("plane.zarr/zarr.json").exists());
}

#[test]
fn the_rows_of_a_text_stand_in_the_order_of_the_axes_whatever_the_chunks() {
    let folder = folder();
    let [whole, cut] = ["50000", "100"].map(|points| {
        let out = path(&folder, &format!("{points}.csv"));
        let more = ["--until", "5", "--chunk", points, "--out", &out];
        text(&[&["map", "figure-3"], &SMALL[..], &more].concat());
        fs::read_to_string(out).expect("a text")
    });
    assert!(whole == cut);
    let place = |line: &str| {
        let cells: Vec<f64> = line
            .split(',')
            .take(2)
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        [cells[0], cells[1]]
    };
    let places: Vec<[f64; 2]> = cut.lines().skip(1).map(place).collect();
    assert!(places.len() == 21 * 31 && places.is_sorted());
}

/// With restitution a class is that of the first lift-off, and `outcome` the end: both are columns,
/// and the counts are those of the classes.
#[test]
fn the_classes_that_are_counted_are_a_column() {
    let folder = folder();
    let [csv, png] = ["plane.csv", "plane.svg"].map(|name| path(&folder, name));
    let limits = ["--until", "20", "--restitution", "0.5", "--out", &csv];
    let found = json(&[&["map", "figure-3"], &SMALL[..], &limits].concat());
    let table = Csv::read(&fs::read_to_string(&csv).expect("a text"));
    let mut counts = std::collections::BTreeMap::<String, u64>::new();
    let mut ends = std::collections::BTreeSet::new();
    for row in &table.rows {
        *counts.entry(row["class"].clone()).or_default() += 1;
        if row["class"] == "lifts_off_later" {
            ends.insert(row["outcome"].clone());
        }
    }
    assert_eq!(serde_json::json!(counts), found["counts"]);
    assert!(
        ends.contains("rolls_forever") && !ends.contains("landing"),
        "{ends:?}"
    );
    if cfg!(feature = "figures") {
        let title = |more: &[&str]| {
            text(
                &[
                    &["map", "figure-3"],
                    &SMALL[..],
                    &["--until", "5", "--out", &png],
                    more,
                ]
                .concat(),
            );
            fs::read_to_string(&png)
                .expect("a picture")
                .contains("First lift-off")
        };
        assert!(title(&["--restitution", "0.5"]) && !title(&[]));
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let folder = folder();
    for (name, command, axes) in [
        ("a.zarr", "map", SMALL),
        (
            "b.parquet",
            "sweep",
            ["--axis", "theta=-pi:pi:21", "--axis", "theta_rate=-4:4:31"],
        ),
    ] {
        let [one, two] = ["1", "2"].map(|threads| {
            let out = path(&folder, &format!("{threads}-{name}"));
            let work = ["--threads", threads, "--chunk", "100", "--out", &out];
            text(&[&[command], &FIGURE_2[..], &axes, &work].concat());
            if name.ends_with("parquet") {
                [("table".to_owned(), fs::read(out).expect("a table"))].into()
            } else {
                tree(Path::new(&out))
            }
        });
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
        let place = words
            .iter()
            .position(|word| word == "--out")
            .expect("--out");
        words.insert(place + 1, out.clone());
        words
    };
    littlewood()
        .args(run(&["--chunk", "100"]))
        .assert()
        .success();
    let before = tree(Path::new(&out));

    let refused = |more: &[&'static str]| {
        let words = run(more);
        complaint(&words.iter().map(String::as_str).collect::<Vec<_>>(), 2)
    };
    assert!(refused(&["--chunk", "100"]).contains("hint: it is finished"));
    let message = refused(&["--chunk", "100", "--mu-k", "0.3", "--resume"]);
    assert!(
        message.contains("other parameters") && message.contains("0.3"),
        "{message}"
    );
    assert!(message.contains("hint:"), "{message}");
    assert!(tree(Path::new(&out)) == before);

    // What has been lost is made again.
    let lost = before
        .keys()
        .find(|name| name.contains("outcome/c/"))
        .expect("a chunk");
    fs::remove_file(Path::new(&out).join(lost)).expect("removed");
    littlewood()
        .args(run(&["--chunk", "100", "--resume"]))
        .assert()
        .success();
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
        ("theta-rat=0:1:3", "did you mean 'theta_rate'"),
        ("until=0:1:3", "there is no axis 'until'"),
        ("theta=1:1:3", "all the same"),
        ("theta_rate=0:1:3", "twice"),
        ("mu_s=-1:1:3", "-1"),
        ("mu_s=0.1:1:3", "0.1"),
        // The first value that is too large, of many.
        ("mu_k=0:1:1000001", "mu_k: at 0.500001:"),
        ("theta=0:1e300:3", "theta: at 1e300:"),
        ("offset=0:2:3", "2"),
    ] {
        let y = "theta_rate=-4:4:31";
        let message = complaint(
            &["map", "figure-3", "--x", axis, "--y", y, "--out", &out],
            2,
        );
        assert!(
            message.contains(said) && message.contains("hint:"),
            "{axis}: {message}"
        );
        assert!(!Path::new(&out).exists());
    }
}

/// Runs the program with so many kilobytes of memory.
#[cfg(target_os = "linux")]
fn with_little_memory(kilobytes: u32, arguments: &[&str]) -> std::process::Output {
    std::process::Command::new("sh")
        .args([
            "-c",
            &format!("ulimit -v {kilobytes}; exec \"$@\""),
            "sh",
            env!("CARGO_BIN_EXE_littlewood"),
        ])
        .args(arguments)
        .output()
        .expect("it runs")
}

#[cfg(target_os = "linux")]
#[test]
fn a_grid_that_is_too_large_is_refused_before_anything_is_made_for_it() {
    let folder = folder();
    let outs = ["a.zarr", "a.parquet", "a.png"].map(|name| path(&folder, name));
    for ((x, y), out, said) in [
        (
            ("theta=-3:3:1000000000", "theta_rate=-4:4:1000000000"),
            &outs[..],
            "1000000000000000000 starts in chunks of 65536",
        ),
        // The friction of each value is checked, too.
        (
            ("mu_s=0.4:1:1000000000", "theta_rate=-4:4:1000000000"),
            &outs[2..],
            "at most 262144",
        ),
        (
            (
                "theta=-3:3:9000000000000000000",
                "theta_rate=-4:4:9000000000000000000",
            ),
            &outs[2..],
            "81000000000000000000000000000000000000 points; at most 9223372036854775807",
        ),
        (
            ("theta=-3:3:5000000", "theta_rate=-4:4:2"),
            &outs[..1],
            "axis theta: 5000000 points; an axis of a Zarr store has at most 4194304",
        ),
    ] {
        let mut words = vec!["map", "figure-3", "--threads", "2", "--x", x, "--y", y];
        out.iter()
            .for_each(|out| words.extend(["--out", out.as_str()]));
        let output = with_little_memory(1_000_000, &words);
        let message = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(2), "{words:?}: {message}");
        assert!(
            message.contains(said) && message.contains("hint:"),
            "{message}"
        );
        assert!(
            fs::read_dir(folder.path())
                .expect("a folder")
                .next()
                .is_none(),
            "{words:?}"
        );
    }
}

#[test]
fn more_threads_than_can_be_started_at_once_are_refused() {
    let folder = folder();
    let plane = [&["map", "figure-3"], &SMALL[..], &["--out"]].concat();
    for threads in ["1025", "10000", "1000000000"] {
        let png = path(&folder, "map.png");
        let message = complaint(&[&plane[..], &[&png, "--threads", threads]].concat(), 2);
        assert!(
            message.contains(&format!("{threads} threads: at most 1024")),
            "{message}"
        );
        assert!(message.contains("hint:"), "{message}");
        assert!(
            fs::read_dir(folder.path())
                .expect("a folder")
                .next()
                .is_none()
        );
    }
    text(
        &[
            &plane[..],
            &[&path(&folder, "map.png"), "--threads", "1024"],
        ]
        .concat(),
    );
}

#[test]
fn a_place_is_taken_once_however_it_is_written() {
    let folder = folder();
    fs::create_dir(folder.path().join("a")).expect("a folder");
    let refused = |first: &str, second: &str| {
        let words = [
            "map",
            "figure-3",
            "--x",
            "theta=0:1:3",
            "--y",
            "theta_rate=0:1:3",
            "--out",
            first,
            "--out",
            second,
        ];
        let output = littlewood()
            .current_dir(folder.path())
            .args(words)
            .assert()
            .code(2)
            .get_output()
            .stderr
            .clone();
        let message = String::from_utf8(output).expect("UTF-8");
        assert!(
            message.contains("this place is given twice"),
            "{first} {second}: {message}"
        );
    };
    refused("m.png", "./m.png");
    refused("m.zarr", "a/../m.zarr/");
    refused("m.parquet", &path(&folder, "m.parquet"));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("a", folder.path().join("b")).expect("a link");
        refused("a/m.png", "b/m.png");
    }
}

#[test]
fn a_partial_picture_of_an_earlier_run_goes_unless_it_is_an_output() {
    let folder = folder();
    let names =
        ["m.png", "m.partial.png", "n.csv", "n.partial.csv"].map(|name| path(&folder, name));
    for name in &names {
        fs::write(name, "left").expect("written");
    }
    let plane = [&["map", "figure-3"], &SMALL[..]].concat();
    text(
        &[
            &plane[..],
            &["--out", &names[0], "--out", &names[1], "--out", &names[2]],
        ]
        .concat(),
    );
    assert!(
        fs::read(&names[1])
            .expect("a picture")
            .starts_with(b"\x89PNG")
    );
    assert!(!Path::new(&names[3]).exists());
    text(&[&plane[..], &["--out", &names[0]]].concat());
    assert!(!Path::new(&names[1]).exists());
}

#[test]
fn other_bad_input_is_refused() {
    let folder = folder();
    let out = path(&folder, "plane.zarr");
    let refused = |more: &[&str]| complaint(&[&["map"], &SMALL[..], more].concat(), 2);
    assert!(refused(&["--out", &out]).contains("missing: mass_ratio"));
    assert!(refused(&["figure-3", "--mu-s", "nan", "--out", &out]).contains("NaN"));
    assert!(
        refused(&["figure-3", "--out", &path(&folder, "plane.nc")]).contains(".zarr or .parquet")
    );
    let png = path(&folder, "plane.png");
    assert!(refused(&["figure-3", "--out", &png, "--shade", "beauty"]).contains("jump_length"));
    assert!(
        refused(&["figure-3", "--out", &png, "--shade", "jump"]).contains("did you mean 'jump_")
    );
    assert!(refused(&["figure-3", "--out", &png, "--size", "10x10"]).contains("10 x 10"));
    assert!(refused(&["figure-3", "--out", &png, "--threads", "0"]).contains("--threads"));
    assert!(refused(&["figure-3", "--out", &png, "--until", "-1"]).contains("hint:"));
    assert!(
        fs::read_dir(folder.path())
            .expect("a folder")
            .next()
            .is_none()
    );
}

#[cfg(feature = "figures")]
#[test]
fn a_map_in_vectors_does_not_depend_on_threads_and_has_the_width_that_is_asked_for() {
    let folder = folder();
    let [one, two] = ["1", "2"].map(|threads| {
        let [svg, pdf] = ["svg", "pdf"].map(|ending| path(&folder, &format!("{threads}.{ending}")));
        let work = [
            "--threads",
            threads,
            "--width-mm",
            "84",
            "--out",
            &svg,
            "--out",
            &pdf,
        ];
        text(&[&["map", "figure-3"], &SMALL[..], &work].concat());
        [svg, pdf].map(|file| fs::read(file).expect("a file"))
    });
    assert!(one == two);
    let svg = String::from_utf8(one[0].clone()).expect("UTF-8");
    assert!(
        svg.contains("width=\"84mm\"") && !svg.contains("<image"),
        "{svg:.300}"
    );
    assert!(one[1].starts_with(b"%PDF"));
    // The colours of a scale are an image.
    let out = path(&folder, "time.svg");
    text(
        &[
            &["map", "figure-3"],
            &SMALL[..],
            &["--shade", "lift_off_time", "--out", &out],
        ]
        .concat(),
    );
    assert!(
        fs::read_to_string(&out)
            .expect("a drawing")
            .contains("<image")
    );
    // 84 mm with 300 pixels to the inch, which the file says.
    let out = path(&folder, "map.png");
    text(
        &[
            &["map", "figure-3"],
            &SMALL[..],
            &["--width-mm", "84", "--out", &out],
        ]
        .concat(),
    );
    let bytes = fs::read(&out).expect("a picture");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    let density = bytes
        .windows(4)
        .position(|name| name == b"pHYs")
        .expect("its pixels to a metre")
        + 4;
    assert_eq!(
        (number(16), number(density), bytes[density + 8]),
        (993, 11811, 1)
    );
    for (name, width, reason) in [
        ("narrow.svg", "9", "from 60 to 420 mm"),
        ("map.csv", "84", "of a picture"),
    ] {
        let out = path(&folder, name);
        let asked = [
            &["map", "figure-3"],
            &SMALL[..],
            &["--width-mm", width, "--out", &out],
        ]
        .concat();
        assert!(complaint(&asked, 2).contains(reason));
        assert!(fs::metadata(&out).is_err());
    }
}

#[test]
fn a_picture_has_the_size_that_is_asked_for() {
    let folder = folder();
    let out = path(&folder, "plane.png");
    for shade in ["outcome", "landings", "lift_off_time"] {
        let found = json(
            &[
                &["map", "figure-3"],
                &SMALL[..],
                &["--out", &out, "--size", "600x400", "--shade", shade],
            ]
            .concat(),
        );
        assert_eq!(number(&found["computed"]), 651.0);
        let bytes = fs::read(&out).expect("a picture");
        assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
        let side =
            |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
        assert_eq!((side(16), side(20)), (600, 400));
    }
    // Drawn from a store beside it, it is the same.
    let (zarr, again) = (path(&folder, "plane.zarr"), path(&folder, "again.png"));
    let more = [
        "--out",
        &again,
        "--out",
        &zarr,
        "--size",
        "600x400",
        "--shade",
        "lift_off_time",
    ];
    text(&[&["map", "figure-3"], &SMALL[..], &more].concat());
    assert!(fs::read(&out).expect("a picture") == fs::read(&again).expect("a picture"));
}

#[test]
fn a_list_of_starts_is_followed() {
    let folder = folder();
    let starts = path(&folder, "starts.csv");
    fs::write(
        &starts,
        "theta,theta_rate\n1.5707963267948966,2\n0,1\n0,3\n",
    )
    .expect("written");
    let out = path(&folder, "starts.parquet");
    let sweep = |starts: &str, out: &str| {
        [
            &["sweep"],
            &FIGURE_2[..],
            &["--starts", starts, "--out", out],
        ]
        .concat()
        .join("\n")
    };
    let words = sweep(&starts, &out);
    let found = json(&words.split('\n').collect::<Vec<_>>());
    assert_eq!(number(&found["done"]), 3.0);
    assert_eq!(found["counts"]["leaves_at_once"], 1);
    assert_eq!(found["out"][0], out.as_str());
    let file = fs::read(&out).expect("a table");
    assert_eq!(file[..4], *b"PAR1");

    // A bad cell is named by its line.
    fs::write(&starts, "theta,theta_rate\n1,2\n0,fast\n").expect("written");
    let words = sweep(&starts, &path(&folder, "other.parquet"));
    let message = complaint(&words.split('\n').collect::<Vec<_>>(), 2);
    assert!(
        message.contains("line 3") && message.contains("fast") && message.contains("hint:"),
        "{message}"
    );
    let words = sweep(&starts, &path(&folder, "other.zarr"));
    assert!(complaint(&words.split('\n').collect::<Vec<_>>(), 2).contains(".parquet"));
}

#[test]
fn two_axes_that_contradict_each_other_leave_gaps() {
    let folder = folder();
    let out = path(&folder, "friction.zarr");
    let axes = ["--x", "mu_k=0:1:11", "--y", "mu_s=0.5:1:6"];
    let found = json(&[&["map", "figure-3"], &axes[..], &["--out", &out]].concat());
    assert_eq!(number(&found["counts"]["invalid"]), 15.0);
}

#[test]
fn several_outputs_are_of_one_run() {
    let folder = folder();
    let [zarr, table, png] = ["a.zarr", "a.parquet", "a.png"].map(|name| path(&folder, name));
    let run = |out: &[&str]| {
        let out: Vec<&str> = out.iter().flat_map(|out| ["--out", out]).collect();
        json(&[&["map", "figure-3"], &SMALL[..], &["--until", "9"], &out].concat())
    };
    let found = run(&[&png, &table, &zarr]);
    assert_eq!(number(&found["computed"]), 651.0);
    let total: f64 = found["counts"]
        .as_object()
        .expect("counts")
        .values()
        .map(number)
        .sum();
    assert_eq!(total, 651.0);
    let again = ["b.zarr", "b.parquet", "b.png"].map(|name| path(&folder, name));
    for out in &again {
        assert_eq!(run(&[out])["counts"], found["counts"]);
    }
    assert!(tree(Path::new(&zarr)) == tree(Path::new(&again[0])));
    for (a, b) in [(&table, &again[1]), (&png, &again[2])] {
        assert!(fs::read(a).expect("a file") == fs::read(b).expect("a file"));
    }
    let twice = [
        &["map", "figure-3"],
        &SMALL[..],
        &["--out", &again[0], "--out", &again[0]],
    ]
    .concat();
    assert!(complaint(&twice, 2).contains("given twice"));
}

#[test]
fn a_list_may_say_where_and_when_and_is_csv() {
    let folder = folder();
    let [starts, out, other] =
        ["starts.csv", "motions.parquet", "b.parquet"].map(|name| path(&folder, name));
    let rows = format!("theta,theta_rate,time,x\n{FRAC_PI_2},2,0,0\n{FRAC_PI_2},2,10,1\n");
    fs::write(&starts, rows).expect("written");
    let found = json(
        &[
            &["sweep"],
            &FIGURE_2[..],
            &["--starts", &starts, "--out", &out],
        ]
        .concat(),
    );
    assert_eq!(found["counts"]["lifts_off_later"], 2);
    let table = Table::read(&out);
    let values = |name: &str| table.reals(name);
    let lift_off = FIGURE_3_EVENTS[2][0];
    assert_close(values("lift_off_time")[0], lift_off, 1e-13);
    assert_close(values("lift_off_time")[1], 10.0 + lift_off, 1e-13);
    assert_close(values("end_x")[1] - values("end_x")[0], 1.0, 1e-13);
    let message = complaint(&["sweep", "figure-3", "--starts", &out, "--out", &other], 2);
    assert!(
        message.contains("a list of starts ends in .csv") && message.contains("to_csv"),
        "{message}"
    );
}

/// The hoop of Figure 2 made of 2 kg with a radius of 0.5 m where g = 8 m/s²: the unit of time is
/// 0.25 s.
const SI: [&str; 16] = [
    "--disc-mass-kg",
    "2",
    "--particle-mass-kg",
    "2",
    "--radius-m",
    "0.5",
    "--offset-m",
    "0.5",
    "--inertia-kg-m2",
    "0.5",
    "--gravity-m-per-s2",
    "8",
    "--mu-s",
    "0.5",
    "--mu-k",
    "0.4",
];

#[test]
fn axes_in_si_units_are_those_without_dimension() {
    let folder = folder();
    let run = |name: &str, hoop: &[&str], y: &str, until: &[&str]| {
        let out = path(&folder, name);
        text(
            &[
                &["map"],
                hoop,
                &["--x", "theta=-pi:pi:21", "--y", y, "--out", &out],
                until,
            ]
            .concat(),
        );
        tree(Path::new(&out))
    };
    let plain = run(
        "plain.zarr",
        &FIGURE_2,
        "theta_rate=-4:4:31",
        &["--until", "20"],
    );
    let si = run(
        "si.zarr",
        &SI,
        "theta_rate_rad_per_s=-16:16:31",
        &["--until-s", "5"],
    );
    let mixed = run("mixed.zarr", &SI, "theta_rate=-4:4:31", &["--until-s", "5"]);
    assert!(plain == si && plain == mixed);
    // A case says nothing of its size.
    let out = path(&folder, "case.zarr");
    let case = [
        "map",
        "figure-3",
        "--x",
        "theta=-pi:pi:21",
        "--y",
        "theta_rate_rad_per_s=-16:16:31",
        "--out",
        &out,
    ];
    let message = complaint(&case, 2);
    assert!(
        message.contains("--particle-mass-kg") && message.contains("--radius-m"),
        "{message}"
    );
    let sized = [
        &case[..],
        &[
            "--particle-mass-kg",
            "2",
            "--radius-m",
            "0.5",
            "--gravity-m-per-s2",
            "8",
        ],
    ]
    .concat();
    let until = [&sized[..], &["--until-s", "5"]].concat();
    text(&until);
    assert!(tree(Path::new(&out)) == plain);
}

#[test]
fn friction_is_an_axis_of_its_own_and_axes_may_be_logarithmic() {
    let folder = folder();
    let out = path(&folder, "friction.csv");
    let axes = ["--x", "mu=0.01:1:3:log", "--y", "theta_rate=1:2:2"];
    // The case has friction of its own, which the axis takes the place of.
    text(
        &[
            &["map", "figure-3"],
            &axes[..],
            &["--until", "5", "--out", &out],
        ]
        .concat(),
    );
    let table = Csv::read(&fs::read_to_string(&out).expect("a text"));
    assert_eq!(table.columns[0], "mu");
    assert_eq!(
        table.column("mu"),
        ["0.01", "0.01", "0.1", "0.1", "1.0", "1.0"]
    );
    let one = json(&[
        "simulate",
        "figure-3",
        "--mu-s",
        "0.1",
        "--mu-k",
        "0.1",
        "--theta-rate",
        "2",
        "--until",
        "5",
    ]);
    assert_close(
        table.number(3, "end_theta"),
        number(&one["outcome"]["theta"]),
        1e-12,
    );

    let refused =
        |x: &str, y: &str| complaint(&["map", "figure-3", "--x", x, "--y", y, "--out", &out], 2);
    assert!(refused("mu=0:1:3:log", SMALL[3]).contains("equal factors cannot lead from 0 to 1"));
    assert!(refused("mu=0.1:1:3:cubic", SMALL[3]).contains("NAME=FROM:TO:COUNT:log"));
    assert!(refused("mu=0.1:1:3", "mu_k=0:0.1:3").contains("mu_k is given twice"));
}

#[test]
fn a_picture_may_show_phases_energy_and_curves() {
    let folder = folder();
    let out = path(&folder, "plane.png");
    let map = |more: &[&'static str]| {
        let all = [
            &["map", "figure-3"],
            &SMALL[..],
            &["--size", "600x400", "--out", &out],
            more,
        ]
        .concat();
        text(&all);
        fs::read(&out).expect("a picture")
    };
    let plain = map(&[]);
    for more in [
        &["--shade", "sequence"][..],
        &["--shade", "energy_lost"],
        &["--curves"],
    ] {
        assert!(map(more) != plain, "{more:?}");
    }
    let refused =
        |more: &[&'static str]| complaint(&[&["map", "figure-3", "--out", &out], more].concat(), 2);
    let plane = |more: &[&'static str]| refused(&[&SMALL[..], more].concat());
    assert!(plane(&["--curves", "--slip", "0.1"]).contains("its starts have slip"));
    assert!(
        refused(&["--x", "theta=-1:1:3", "--y", "mu=0:1:3", "--curves"])
            .contains("its axes are others")
    );
    // In SI units the picture has them, and so is another.
    let si = map(&["--particle-mass-kg", "2", "--radius-m", "0.5"]);
    assert!(si != plain);
}

#[test]
fn derivatives_are_columns_and_may_be_shown() {
    let folder = folder();
    let [csv, png] = ["plane.csv", "plane.png"].map(|name| path(&folder, name));
    let names = "jump_length_by_mu_k,end_theta_by_theta_rate";
    let axes = ["--x", "theta=0:pi/2:2", "--y", "theta_rate=1:2:2"];
    let more = [
        "--derivatives",
        names,
        "--shade",
        "end_x_by_mu_k",
        "--out",
        &csv,
        "--out",
        &png,
    ];
    text(&[&["map", "figure-3"], &axes[..], &more].concat());
    let table = Csv::read(&fs::read_to_string(&csv).expect("a text"));
    assert_eq!(
        table.columns[table.columns.len() - 3..],
        [
            "jump_length_by_mu_k",
            "end_theta_by_theta_rate",
            "end_x_by_mu_k"
        ]
    );
    // The last row is the start of Figure 3, whose landing is the last transition.
    let cell = |name: &str| table.number(table.rows.len() - 1, name);
    let motion = json(&["simulate", "figure-3", "--derivatives", "mu_k,theta_rate"]);
    let landing = &motion["transitions"][3]["derivatives"];
    assert_eq!(cell("end_x_by_mu_k"), number(&landing["mu_k"]["x"]));
    assert_eq!(
        cell("end_theta_by_theta_rate"),
        number(&landing["theta_rate"]["theta"])
    );
    let lift_off = number(&motion["transitions"][2]["derivatives"]["mu_k"]["x"]);
    let travel = number(&landing["mu_k"]["x"]) - lift_off;
    assert_close(cell("jump_length_by_mu_k").abs(), travel.abs(), 1e-14);
    assert_eq!(fs::read(&png).expect("a picture")[1..4], *b"PNG");

    let refused = |more: &[&str]| {
        complaint(
            &[&["map", "figure-3"], &axes[..], &["--out", &csv], more].concat(),
            2,
        )
    };
    assert!(refused(&["--derivatives", "outcome_by_theta"]).contains("NUMBER_by_QUANTITY"));
    assert!(refused(&["--shade", "end_x_by_me"]).contains("derivatives such as end_x_by_mu_k"));
    assert!(refused(&["--shade", "end_x_by_restitution"]).contains("hint: give --restitution"));
}
