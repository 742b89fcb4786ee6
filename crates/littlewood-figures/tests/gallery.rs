//! The committed gallery is what the program makes today. To make it again:
//! `cargo run -p littlewood-figures --example gallery -- docs`.

use std::fs;
use std::path::PathBuf;

use littlewood_figures::{FIGURES, GALLERY_SCALE, gallery_page};

fn docs() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "..", "docs"]
        .iter()
        .collect()
}

#[test]
fn images_are_those_that_the_program_makes() {
    for entry in FIGURES {
        let figure = entry.of_the_paper().expect("the figure can be made");
        let stem = docs().join("gallery").join(entry.name);
        let drawing = fs::read_to_string(stem.with_extension("svg")).expect("a committed drawing");
        assert!(drawing == figure.svg(), "{}.svg differs", entry.name);
        let picture = fs::read(stem.with_extension("png")).expect("a committed picture");
        assert!(
            picture == figure.png(GALLERY_SCALE).expect("a picture"),
            "{}.png differs",
            entry.name
        );
    }
}

#[test]
fn nothing_else_is_in_the_gallery() {
    let mut found: Vec<String> = fs::read_dir(docs().join("gallery"))
        .expect("the gallery")
        .map(|file| {
            file.expect("a file")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    let mut wanted: Vec<String> = FIGURES
        .iter()
        .flat_map(|entry| ["png", "svg"].map(|ending| format!("{}.{ending}", entry.name)))
        .collect();
    found.sort();
    wanted.sort();
    assert_eq!(found, wanted);
}

#[test]
fn the_page_has_all_captions() {
    let page = fs::read_to_string(docs().join("gallery.md")).expect("the page");
    assert!(
        page == gallery_page().expect("captions"),
        "docs/gallery.md differs"
    );
}

#[test]
fn every_drawing_of_the_documentation_has_a_title() {
    let mut folders = vec![docs()];
    let mut drawings = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "svg") {
                let text = fs::read_to_string(&path).expect("a drawing");
                assert!(text.contains("<title>"), "{}", path.display());
                drawings += 1;
            }
        }
    }
    assert!(drawings > FIGURES.len(), "{drawings}");
}
