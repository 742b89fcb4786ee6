//! The files of the page that are written from the tables of the core and of the style crate:
//! types, names, labels, units and colours. A test fails where a file differs from the tables by a
//! byte; this writes the files:
//!
//! ```sh
//! LITTLEWOOD_WRITE=1 cargo test -p littlewood-web generated::
//! ```

mod look;
mod source;
mod tables;

use std::path::Path;
use std::{env, fs};

fn assert_current(file: &str, wanted: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../web")
        .join(file);
    if env::var_os("LITTLEWOOD_WRITE").is_some() {
        fs::write(&path, wanted).expect("the folder can be written to");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == wanted,
        "{file} differs from the tables. {}",
        source::WRITTEN
    );
}

#[test]
fn the_tables_of_the_page_are_those_of_the_core() {
    assert_current("src/generated/tables.ts", &tables::typescript());
}

#[test]
fn the_colours_of_the_page_are_those_of_the_style_crate() {
    assert_current("src/generated/palette.ts", &look::typescript());
    assert_current("src/generated/palette.css", &look::css());
    assert_current("public/icon.svg", &look::icon());
}
