//! The files of the page, in the program itself.

use std::borrow::Cow;

use rust_embed::RustEmbed;

/// What `web/build.sh` has made, from the folder of this crate; nothing where it was not run before the program was built.
#[derive(RustEmbed)]
#[folder = "../../web/dist"]
#[allow_missing = true]
struct Files;

/// A file of the page.
#[derive(Clone, Debug)]
pub(super) struct Asset {
    pub(super) content: Cow<'static, [u8]>,
    /// Media type.
    pub(super) kind: String,
}

/// The file of this name.
pub(super) fn find(name: &str) -> Option<Asset> {
    let file = Files::get(name)?;
    let kind = file.metadata.mimetype();
    let kind = if kind.starts_with("text/") { format!("{kind}; charset=utf-8") } else { kind.to_owned() };
    Some(Asset { content: file.data, kind })
}
