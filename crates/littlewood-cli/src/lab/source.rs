//! Where the page comes from: the folder that was asked for, the program, or the sources, in which
//! it is built if it is not there.

use std::env;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::assets::Page;
use crate::error::Error;

/// The ways to a page for a program that has none.
const WAYS: &str = "a released program has the page in it; `--page FOLDER` serves a page that was built elsewhere; in the \
                    sources `web/build.sh` builds it, with node 20 and Rust for WebAssembly (`rustup target add \
                    wasm32-unknown-unknown`)";

pub(super) fn page(folder: Option<&Path>) -> Result<Page, Error> {
    if let Some(folder) = folder {
        return read(folder)?
            .ok_or_else(|| no_page(format!("there is no page in {}", folder.display())));
    }
    if let Some(page) = Page::embedded() {
        return Ok(page);
    }
    let Some(web) = sources() else {
        return Err(no_page(
            "this program was built without the page of the laboratory".to_owned(),
        ));
    };
    let built = web.join("dist");
    if let Some(page) = read(&built)? {
        return Ok(page);
    }
    build(&web)?;
    read(&built)?.ok_or_else(|| no_page("the page was built, but it is not there".to_owned()))
}

fn read(folder: &Path) -> Result<Option<Page>, Error> {
    Page::read(folder).map_err(|error| {
        no_page(format!(
            "cannot read the page in {}: {error}",
            folder.display()
        ))
    })
}

fn no_page(reason: String) -> Error {
    Error::NoPage {
        reason,
        hint: WAYS.to_owned(),
    }
}

/// The folder of the page's sources, if the program is called from somewhere in a copy of the
/// project.
fn sources() -> Option<PathBuf> {
    let here = env::current_dir().ok()?;
    here.ancestors()
        .map(|folder| folder.join("web"))
        .find(|web| web.join("build.sh").is_file())
}

/// Builds the page; its output goes to the standard error.
fn build(web: &Path) -> Result<(), Error> {
    let has_npm = Command::new("npm")
        .arg("--version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if !has_npm {
        return Err(no_page(
            "the page of the laboratory is not built yet, and there is no npm to build it"
                .to_owned(),
        ));
    }
    let script = web.join("build.sh");
    anstream::eprintln!(
        "The page of the laboratory is not built yet: {} builds it, once. It takes a minute or two.",
        script.display()
    );
    let status = Command::new("bash")
        .arg(&script)
        .stdout(io::stderr())
        .status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(no_page(format!("{} has failed", script.display()))),
        Err(error) => Err(no_page(format!(
            "{} cannot be run: {error}",
            script.display()
        ))),
    }
}
