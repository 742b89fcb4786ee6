//! Puts the page of the laboratory into the program, where it has been built: `page`, which packages have, or `web/dist` in the
//! sources. The page needs node, the program does not: without a page it says how to make it.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let folder = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let page =
        ["page", "../../web/dist"].map(|path| folder.join(path)).into_iter().find(|path| path.is_dir());
    // A path that does not exist would build the program anew each time; its folder shows when it comes.
    let watched = page.clone().unwrap_or_else(|| folder.join("../../web"));
    if watched.exists() {
        println!("cargo:rerun-if-changed={}", watched.display());
    }
    let mut names = Vec::new();
    if let Some(page) = &page {
        list(page, "", &mut names)?;
        names.sort();
    }
    let mut table = String::from("[\n");
    for name in &names {
        let path = page.as_deref().unwrap_or(&folder).join(name).canonicalize()?;
        writeln!(table, "    ({name:?}, include_bytes!({path:?})),")?;
    }
    table.push_str("]\n");
    fs::write(PathBuf::from(env::var("OUT_DIR")?).join("page.rs"), table)?;
    Ok(())
}

/// The files below a folder, by their names with slashes.
fn list(folder: &Path, prefix: &str, names: &mut Vec<String>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_str().ok_or("a name that is not UTF-8")?);
        if entry.file_type()?.is_dir() {
            list(&entry.path(), &format!("{name}/"), names)?;
        } else {
            names.push(name);
        }
    }
    Ok(())
}
