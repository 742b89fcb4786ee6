//! Runs the program and reads what it says.

#![allow(
    clippy::excessive_precision,
    reason = "the reference has more digits than a double"
)]

pub(crate) mod csv;
pub(crate) mod table;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

/// Figure 3 of the paper as it is typed.
pub(crate) const FIGURE_3: [&str; 14] = [
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
    "--theta",
    "1.5707963267948966",
    "--theta-rate",
    "2",
];

/// Figure 3 from a computation of its own with 40 digits: time, θ, θ′, η′, x of stick, slip and
/// lift-off.
pub(crate) const FIGURE_3_EVENTS: [[f64; 5]; 3] = [
    [
        0.564_107_553_101_996_75,
        2.917_225_656_789_249,
        2.936_443_261_445_296_5,
        0.0,
        -1.422_671_011_587_748_8,
    ],
    [
        0.973_223_074_772_405_4,
        4.066_332_874_239_296,
        2.460_879_504_634_977_2,
        0.0,
        -2.571_778_229_037_795_3,
    ],
    [
        1.518_670_213_819_437,
        5.236_735_770_878_168,
        1.998_705_937_114_139_9,
        0.607_696_268_534_750_7,
        -3.609_284_846_390_800_8,
    ],
];

/// Time and angle of the landing of Figure 3.
pub(crate) const FIGURE_3_LANDING: [f64; 2] = [3.847_395_556_686_894, 9.891_172_939_575_516];

/// The program.
pub(crate) fn littlewood() -> Command {
    let mut command = Command::cargo_bin("littlewood").expect("the binary is built with the tests");
    command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
    command
}

/// What a successful run prints.
pub(crate) fn text(arguments: &[&str]) -> String {
    let output = littlewood()
        .args(arguments)
        .assert()
        .success()
        .stderr("")
        .get_output()
        .stdout
        .clone();
    String::from_utf8(output).expect("the output is UTF-8")
}

/// What a successful run prints in JSON.
pub(crate) fn json(arguments: &[&str]) -> Value {
    let text = text(&[arguments, &["--format", "json"]].concat());
    serde_json::from_str(&text).expect("the output is JSON")
}

/// Standard error of a run that ends with this exit code and prints nothing else.
pub(crate) fn complaint(arguments: &[&str], code: i32) -> String {
    let output = littlewood()
        .args(arguments)
        .assert()
        .code(code)
        .stdout("")
        .get_output()
        .stderr
        .clone();
    String::from_utf8(output).expect("the message is UTF-8")
}

/// A number in a document.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Two numbers agree to this part of their size, or of one.
#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(
        difference <= tolerance * expected.abs().max(1.0),
        "{found} is not {expected}"
    );
}

/// Path of an example scenario.
pub(crate) fn example(name: &str) -> String {
    format!("{}/examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Every file under a folder with its bytes.
pub(crate) fn tree(root: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path
                    .strip_prefix(root)
                    .expect("inside")
                    .to_string_lossy()
                    .into_owned();
                files.insert(name, fs::read(&path).expect("a file"));
            }
        }
    }
    files
}
