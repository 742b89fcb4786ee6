//! The files of the page: in the program itself, or in a folder.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

use littlewood_sweep::read_file;

mod embedded {
    include!(concat!(env!("OUT_DIR"), "/page.rs"));
}

const FIRST: &str = "index.html";

#[derive(Clone, Debug)]
pub(super) struct Asset {
    pub(super) content: Cow<'static, [u8]>,
    pub(super) kind: &'static str,
}

#[derive(Debug)]
pub(super) struct Page(BTreeMap<String, Cow<'static, [u8]>>);

impl Page {
    /// The page that is part of this program, if it was built before the program was.
    pub(super) fn embedded() -> Option<Self> {
        let files = embedded::FILES
            .iter()
            .map(|&(name, content)| (name.to_owned(), Cow::Borrowed(content)));
        Self(files.collect()).if_whole()
    }

    /// The page in a folder, read at once, so that nothing else is ever served; none if there is no
    /// page in it.
    pub(super) fn read(folder: &Path) -> io::Result<Option<Self>> {
        let mut files = BTreeMap::new();
        if folder.join(FIRST).is_file() {
            read_folder(folder, "", &mut files)?;
        }
        Ok(Self(files).if_whole())
    }

    fn if_whole(self) -> Option<Self> {
        self.0.contains_key(FIRST).then_some(self)
    }

    pub(super) fn find(&self, name: &str) -> Option<Asset> {
        let content = self.0.get(name)?.clone();
        Some(Asset {
            content,
            kind: media_type(name),
        })
    }
}

fn read_folder(
    folder: &Path,
    prefix: &str,
    files: &mut BTreeMap<String, Cow<'static, [u8]>>,
) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            continue;
        };
        let name = format!("{prefix}{name}");
        if path.is_dir() {
            read_folder(&path, &format!("{name}/"), files)?;
        } else {
            files.insert(name, read_file(&path, u64::MAX)?.into());
        }
    }
    Ok(())
}

fn media_type(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "svg" => "image/svg+xml",
        "wasm" => "application/wasm",
        "webmanifest" => "application/manifest+json",
        _ => "application/octet-stream",
    }
}
