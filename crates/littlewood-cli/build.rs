//! Puts the page of the laboratory into the program, if it was built before the program was.

use std::env;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let mut table = String::from("pub(super) const FILES: &[(&str, &[u8])] = &[\n");
    if env::var_os("CARGO_FEATURE_LAB").is_some() {
        let package = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
        // A package has the page in itself; in the sources web/build.sh makes it. A path that does
        // not exist would build the program anew each time; its folder shows when it comes.
        let (ours, web) = (package.join("page"), package.join("../../web"));
        let built = web.join("dist");
        if let Some(path) = [&ours, &built, &web, &package.join("src")]
            .into_iter()
            .find(|path| path.exists())
        {
            println!("cargo:rerun-if-changed={}", path.display());
        }
        if let Some(page) = [ours, built].into_iter().find(|page| page.exists()) {
            list(&page, "", &mut table)?;
        }
    }
    table.push_str("];\n");
    fs::write(PathBuf::from(env::var("OUT_DIR")?).join("page.rs"), table)?;
    Ok(())
}

/// The files of a folder in the order of their names.
fn list(folder: &Path, prefix: &str, table: &mut String) -> Result<(), Box<dyn Error>> {
    let mut entries = fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            list(&entry.path(), &format!("{name}/"), table)?;
        } else {
            writeln!(
                table,
                "    ({name:?}, include_bytes!({:?})),",
                entry.path().canonicalize()?
            )?;
        }
    }
    Ok(())
}
