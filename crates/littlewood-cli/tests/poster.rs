//! `littlewood poster`: files, and what is refused.

use std::fs;

use tempfile::TempDir;

use crate::support::{complaint, text};

#[test]
fn a_poster_is_a_drawing_or_a_picture() {
    let folder = TempDir::new().expect("a folder");
    for (name, magic) in [
        ("a.svg", &b"<svg"[..]),
        ("a.pdf", b"%PDF"),
        ("a.png", b"\x89PNG"),
    ] {
        let path = folder.path().join(name);
        let out = path.to_str().expect("UTF-8");
        text(&["poster", "figure-3", "--out", out, "--scale", "0.5"]);
        assert!(
            fs::read(&path).expect("a poster").starts_with(magic),
            "{name}"
        );
    }
}

#[test]
fn the_chart_is_of_the_paper_alone() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("a.svg");
    let out = path.to_str().expect("UTF-8");
    for more in [
        &["figure-3"][..],
        &["--mu-s", "1"],
        &["--si"],
        &["--max-transitions", "3"],
    ] {
        let words = [&["poster", "--chart", "--out", out], more].concat();
        let message = complaint(&words, 2);
        assert!(message.contains("no other"), "{message}");
    }
    assert!(!path.exists());
    text(&["poster", "--chart", "--out", out]);
    let svg = fs::read_to_string(&path).expect("a chart");
    assert!(
        svg[..600].contains("width=\"594mm\" height=\"420mm\""),
        "{}",
        &svg[..600]
    );
}

#[test]
fn another_ending_and_a_scale_out_of_bounds_are_refused() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("a.doc");
    let message = complaint(
        &["poster", "figure-3", "--out", path.to_str().expect("UTF-8")],
        2,
    );
    assert!(
        message.contains("hint: names end in .pdf or .svg or .png"),
        "{message}"
    );
    let path = folder.path().join("a.png");
    let message = complaint(
        &[
            "poster",
            "figure-3",
            "--scale",
            "1000",
            "--out",
            path.to_str().expect("UTF-8"),
        ],
        2,
    );
    assert!(
        message.contains("1000") && message.contains("hint:"),
        "{message}"
    );
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
